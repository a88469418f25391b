"""Shading (sections 9 and 23)."""
import functools
import math

from .blocks import ALONG
from .notation import cross, dot, half_up, shift_down


def cut_to(v, bits):
    w = max(map(abs, v)).bit_length()
    return [half_up(x, 1 << (w - bits)) for x in v] if w > bits else list(v)


def cut30(v):
    return cut_to(v, 30)


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
    """Sources are (view, levels); a material is (diffuse, specular, shininess), by channel the
    first two; the frame has as many channels as the levels that are given."""

    rule, keeps_normals = "phong", False

    def __init__(self, observer, sources, object_fraction, ambient, material, rule="phong",
                 keeps_normals=False):
        self.rule, self.keeps_normals = rule, keeps_normals
        self.viewer = Toward(observer, object_fraction)
        self.towards = [Toward(view, object_fraction) for view, _ in sources]
        self.source_levels = [levels for _, levels in sources]
        self.ambient, (self.diffuse, self.specular, self.shininess) = ambient, material

    def highlight(self, n_dot_l, n_dot_v, l_dot_v, n_dot_h):
        if self.rule in ("lambert", "none"):
            return 0
        blinn = self.rule == "blinn"
        result = n_dot_h if blinn else ((2 * n_dot_l * n_dot_v) >> 14) - l_dot_v
        result = min(max(result, 0), 1 << 14)
        for _ in range(self.shininess + 2 * blinn):
            result = half_up(result * result, 1 << 14)
        return result

    def levels(self, normal, to_lights, to_viewer, shadowed=(), turn=True):
        """For each channel in turn intensity and direct shares; `shadowed` are the numbers of the
        sources in whose shadow the leaf is.  A facet's normal has been turned before."""
        length = max(1, math.isqrt(dot(normal, normal)))
        n_dot_v = dot(normal, to_viewer) // length
        sign = -1 if turn and n_dot_v < 0 else 1
        lit = []  # n_dot_l and highlight of each source, or none
        for number, to_light in enumerate(to_lights):
            n_dot_l = sign * (dot(normal, to_light) // length)
            if self.rule == "none":
                n_dot_l = 1 << 14
            halfway = unit14([a + b for a, b in zip(to_light, to_viewer)])
            n_dot_h = sign * (dot(normal, halfway) // length)
            lit.append((n_dot_l, self.highlight(n_dot_l, sign * n_dot_v,
                                                dot(to_light, to_viewer) >> 14, n_dot_h))
                       if n_dot_l > 0 and number not in shadowed else None)
        result = []
        for channel in range(len(self.source_levels[0])):
            diffuse, specular = self.diffuse[channel], self.specular[channel]
            total = diffuse * self.ambient << 22
            shares = [min(255, half_up(total, 1 << 30))]
            for source, terms in zip(self.source_levels, lit):
                if terms:
                    total += source[channel] * (diffuse * (256 - self.ambient) * terms[0]
                                                + 256 * specular * terms[1])
                shares.append(min(255, half_up(total, 1 << 30)))
            result += [shares[-1], *(b - a for a, b in zip(shares, shares[1:]))]
        return tuple(result)

    def kept(self, normal, to_viewer):
        """The words N of section 27 for a normal of its words."""
        return tuple(-n for n in normal) if dot(normal, to_viewer) < 0 else tuple(normal)

    def block(self, places):
        """The levels of leaf (i, j) of a block, as a function, and after them N if it is kept."""
        normals = corner_normals(places)
        corners = list(zip(*(comp[0] for comp in places)))

        @functools.lru_cache(None)
        def levels(i, j, shadowed=()):
            place, normal = at_leaf(corners, i, j), at_leaf(normals, i, j)
            to_viewer = self.viewer.at(place)
            return (*self.levels(normal, [to.at(place) for to in self.towards], to_viewer,
                                 shadowed),
                    *(self.kept(cut_to(normal, 14), to_viewer) if self.keeps_normals else ()))
        return levels
