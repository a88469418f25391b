"""Shadows on one plane (section 26)."""
import copy
from fractions import Fraction

from .notation import dot, half_even
from .store import draw
from .words import arc


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


class Ground:
    """The plane of a patch in world words, and heights over it on a light's side."""

    def __init__(self, control, light):
        corners = [[Fraction(x, 1 << 16) for x in control[k]] for k in (0, 3, 12)]
        self.o, u, v = corners[0], *([a - b for a, b in zip(c, corners[0])] for c in corners[1:])
        self.n = cross(u, v)
        self.light = light
        if self.rise() < 0:
            self.n = [-x for x in self.n]

    def height(self, p):
        return dot(self.n, [a - b for a, b in zip(p, self.o)])

    def rise(self):
        light = self.light
        return self.height(light.origin) if light.perspective else dot(self.n, light.back)

    def flat(self):
        """The rows of flat(p) on (p, 1)"""
        lamp, rise = self.light.perspective, self.rise()
        place = self.light.origin if lamp else self.light.back
        height = [*self.n, -dot(self.n, self.o)]
        rows = [[(rise if j == k else 0) - height[j] * place[k] for j in range(4)]
                for k in range(3)]
        last = [0, 0, 0, rise]
        rows.append([a - b for a, b in zip(last, height)] if lamp else last)
        return [[x / rise for x in row] for row in rows], height


class ShadowView:
    """The shadow matrix in the place of a view's world to screen."""

    def __init__(self, observer, ground, places):
        self.observer, self.ground, self.places = observer, ground, places

    def world_to_screen(self, s):
        flat, height = self.ground.flat()
        x, y, _, w = ([sum(row[k] * flat[k][j] for k in range(4)) for j in range(4)]
                      for row in self.observer.world_to_screen(s))
        if self.ground.light.perspective:
            reach = 64 * self.ground.rise()
        else:
            highest = max((self.ground.height([Fraction(c, 1 << 16) for c in p])
                           for p in self.places), default=0)
            reach = 2 * (highest if highest > 0 else dot(self.ground.n, self.ground.n))
        near = self.observer.near if self.observer.perspective else 1
        z = [2 * s.half_px * near / reach * h - s.half_px * k for h, k in zip(height, w)]
        return [x, y, z, w]

    def bias_quanta(self, *_):
        return 0


def ellipse(control, points):
    """centre, a and b of an object's blob, all in world words"""
    o, u, v = control[0], *([c - b for c, b in zip(control[k], control[0])] for k in (3, 12))
    uu, vv, uv = dot(u, u), dot(v, v), dot(u, v)
    places = []
    for p in points:
        w = [a - b for a, b in zip(p, o)]
        wu, wv = dot(w, u), dot(w, v)
        places.append((Fraction(wu * vv - wv * uv, uu * vv - uv * uv),
                       Fraction(wv * uu - wu * uv, uu * vv - uv * uv)))
    (s0, s1), (t0, t1) = ((min(k), max(k)) for k in zip(*places))
    return ([half_even(c + (s0 + s1) / 2 * a + (t0 + t1) / 2 * b) for c, a, b in zip(o, u, v)],
            [half_even((s1 - s0) / 2 * a) for a in u], [half_even((t1 - t0) / 2 * b) for b in v])


def ellipse_patches(centre, a, b):
    patches = []
    for m in range(8):
        patches.append([tuple(c + half_even((x * cos + y * sin) * j, 3 << 30)
                              for c, x, y in zip(centre, a, b))
                        for j in range(4) for sin, cos in arc(m)])
    return patches


def ground_masks(ground, others, control, places, fraction, observer, lights, s, record, shading,
                 blobs):
    """Each light's mask: of the ground and of the others, (patches, facets) as draw() takes them.

    `control` is the ground's patch in world words, `places` those of the others.  `blobs`: with
    form = blob what is drawn for every light, as draw() takes it.
    """
    own = draw(*ground, fraction, observer, s, record, shading)
    before = draw(*others, fraction, observer, s, record, shading)

    def records(drawn):
        return list(zip(drawn[0], *drawn[1])) if drawn[1] else [(code,) for code in drawn[0]]
    of_ground = [mine[0] != s.background_code and (rest[0] == s.background_code or mine <= rest)
                 for mine, rest in zip(records(own), records(before))]
    flat = copy.copy(s)
    flat.map_depth, flat.bias_slope, flat.facing = "first", 0, "both"
    masks = []
    for light in lights:
        if s.form == "blob":
            covered = draw(*blobs, fraction, observer, flat)[0]
        else:
            view = ShadowView(observer, Ground(control, light), places)
            covered = draw(*others, fraction, view, flat)[0]
        masks.append([255 * (seen and code != s.background_code)
                      for seen, code in zip(of_ground, covered)])
    return masks
