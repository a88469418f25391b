"""Shading (section 9)."""
import functools
import math

from .blocks import ALONG
from .notation import cross, dot, half_up, shift_down


def cut30(v):
    w = max(map(abs, v)).bit_length()
    return [half_up(x, 1 << (w - 30)) for x in v] if w > 30 else list(v)


def unit14(v):
    v = cut30(v)
    length = math.isqrt(dot(v, v))
    return [half_up(x << 14, length) if length else 0 for x in v]


def tangents(places, way):
    """At each corner, the tangent in u (way 1) or v (way 2)."""
    result, chords = [None] * 4, [None] * 4
    for a, b in ALONG[way]:
        chords[a] = chords[b] = [3 * (comp[0][b] - comp[0][a]) for comp in places]
        ends = [(3 * (f[b] - f[a]), g[a], g[b])
                for f, g in ((comp[0], comp[way]) for comp in places)]
        result[a] = [df - 8 * ga - 4 * gb for df, ga, gb in ends]
        result[b] = [df + 4 * ga + 8 * gb for df, ga, gb in ends]
    # A zero tangent: that of the opposite edge, the same end of it (the corner across it); if that
    # is zero, too, the chord of the corner's own edge, and at last the opposite edge's.
    across = 3 - way
    choices = [(t, result[k ^ across], chords[k], chords[k ^ across])
               for k, t in enumerate(result)]
    return [cut30(next((t for t in choice if any(t)), choice[0])) for choice in choices]


def corner_normals(places):
    return [unit14(cross(t, u)) for t, u in zip(tangents(places, 1), tangents(places, 2))]


def at_leaf(corners, i, j):
    u, v = 2 * i + 1, 2 * j + 1
    weights = ((32 - v) * (32 - u), (32 - v) * u, v * (32 - u), v * u)
    return [dot(weights, values) for values in zip(*corners)]


class Toward:
    """The direction toward a view's eye, at a leaf."""

    def __init__(self, view, object_fraction):
        back = view.axes[2]
        self.direction = [half_up(x, 1 << 16) for x in back]
        self.eye = None
        if view.perspective:
            eye = [t + half_up(view.distance_word * b, 1 << 30)
                   for t, b in zip(view.target_words, back)]
            self.eye = [shift_down(x, 16 - object_fraction - 6) for x in eye]

    def at(self, place):
        if self.eye is None:
            return self.direction
        return unit14([1024 * e - p for e, p in zip(self.eye, place)])


class Shading:
    def __init__(self, observer, light, object_fraction, ambient, material):
        self.light, self.viewer = (Toward(v, object_fraction) for v in (light, observer))
        self.ambient, (self.diffuse, self.specular, self.shininess) = ambient, material

    def levels(self, normal, to_light, to_viewer, in_shadow, turn=True):
        """(intensity, direct) of a leaf; a facet's normal has been turned before."""
        length = max(1, math.isqrt(dot(normal, normal)))
        n_dot_l, n_dot_v = dot(normal, to_light) // length, dot(normal, to_viewer) // length
        if turn and n_dot_v < 0:
            n_dot_l, n_dot_v = -n_dot_l, -n_dot_v
        total = self.diffuse * self.ambient << 14
        ambient_level = min(255, half_up(total, 1 << 22))
        if n_dot_l > 0 and not in_shadow:
            l_dot_v = dot(to_light, to_viewer) >> 14
            highlight = min(max(((2 * n_dot_l * n_dot_v) >> 14) - l_dot_v, 0), 1 << 14)
            for _ in range(self.shininess):
                highlight = half_up(highlight * highlight, 1 << 14)
            total += (self.diffuse * (256 - self.ambient) * n_dot_l
                      + 256 * self.specular * highlight)
        intensity = min(255, half_up(total, 1 << 22))
        return intensity, intensity - ambient_level

    def block(self, places):
        """(intensity, direct) of leaf (i, j) of a block, lit or in shadow, as a function."""
        normals = corner_normals(places)
        corners = list(zip(*(comp[0] for comp in places)))

        @functools.lru_cache(None)
        def levels(i, j, in_shadow=False):
            place = at_leaf(corners, i, j)
            return self.levels(at_leaf(normals, i, j), self.light.at(place),
                               self.viewer.at(place), in_shadow)
        return levels
