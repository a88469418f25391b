"""The receiver's own slope (section 24)."""
import math
from fractions import Fraction

from .notation import dot, fits, half_even, half_up


def clamped(value, limit):
    return value if limit is None else min(max(value, -limit), limit)


def gradient(u, v):
    """slope_X and slope_Y of the plane that two differences (X, Y, Z) span, or None."""
    d = u[0] * v[1] - v[0] * u[1]
    if d == 0 or not all(fits(word, 31) for word in (*u, *v)):
        return None
    sign = 1 if d > 0 else -1
    rises = u[2] * v[1] - v[2] * u[1], v[2] * u[0] - u[2] * v[0]
    return [min(max(half_up(4096 * sign * rise, abs(d)), -2**39), 2**39 - 1) for rise in rises]


class Plane:
    """A pixel's plane in the light's view: its results, and the slopes there."""

    def __init__(self, point, slopes, limit):
        self.point, self.slopes, self.limit = point, slopes, limit

    def change(self, x2, y2):
        """From the pixel's depth to that at (x2 / 2, y2 / 2)."""
        moved = [s * (to - 2 * at) for s, to, at in zip(self.slopes, (x2, y2), self.point)]
        return clamped(half_up(sum(moved), 8192), self.limit)


def between(low, value, high):
    return min(max(value, low), high)


def word(value, bits):
    return between(-2**(bits - 1), value, 2**(bits - 1) - 1)


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def scale_words(view, s, bias_quanta):
    """A light's words for its texels and the Z that they are worth: one, or in perspective two.
    bias_quanta is Q.16."""
    depths = view.far - view.near
    if not view.perspective:
        quanta = (1 << s.z_bits) / depths / (s.half_px / view.extent)
        return [between(1, half_even(quanta * 65536), 2**40 - 1)]
    reach = (1 << s.z_bits) * view.far / depths - s.depth_offset - Fraction(bias_quanta, 1 << 16)
    return [between(-2**53, half_even(256 * reach), 2**53),
            between(1, half_even(256 * s.half_px * view.distance / view.extent), 2**53)]


class Scale:
    """A light's measures at a pixel, of these words."""

    def __init__(self, words, fraction_bits):
        self.f, self.perspective = fraction_bits, len(words) == 2
        if self.perspective:
            self.reach, self.focal = words
        else:
            self.quanta, = words

    def at(self, point):
        """scale, tilt_X, tilt_Y at a pixel's results."""
        if not self.perspective:
            return self.quanta, 0, 0
        scale = half_up((self.reach - 256 * point[2]) << 16, self.focal)
        tilts = [word(half_up(v << (24 - self.f), self.focal), 26) for v in point[:2]]
        return between(1, scale, 2**40 - 1), *tilts


def normal(point, u, v, light):
    """u', v', n' and its length of two differences, or None."""
    scale, *tilts = light.at(point)

    def upright(step):
        w = half_up(step[2] << 28, scale)
        return [(a << (12 - light.f)) + half_up(t * w, 65536) for a, t in zip(step, tilts)] + [w]
    if not all(fits(a, 31) for a in (*u, *v)):
        return None
    u, v = upright(u), upright(v)
    n = cross(u, v)
    if not all(fits(a, 26) for a in (*u, *v)) or not any(n):
        return None
    return u, v, *cut_normal(n)


def cut_normal(n):
    """n' and its length."""
    up = 24 - max(map(abs, n)).bit_length()
    n = [a << up if up >= 0 else half_up(a, 1 << -up) for a in n]
    return n, math.isqrt(dot(n, n))


def light_axes(view):
    """The light's X, Y and Z in the world (section 27), Q1.14."""
    r, u, b = ([half_up(a, 1 << 16) for a in axis] for axis in view.axes)
    return r, [-a for a in u], [-a for a in b]


def in_light(n, axes):
    """m of a pixel's N."""
    return [half_up(dot(n, axis), 64) for axis in axes]


def leaning(point, m, light):
    """slope_X and slope_Y of a plane with the normal m, or None."""
    scale, *tilts = light.at(point)
    d = m[2] + half_up(dot(tilts, m[:2]), 65536)
    if d == 0:
        return None
    sign = 1 if d > 0 else -1
    return [word(half_up(-sign * scale * a, abs(d) << (4 + light.f)), 40) for a in m[:2]]


def moved(point, u, v, turn, offset, light):
    """A pixel's results moved along its normal; u and v are the neighbours' less these."""
    surface = normal(point, u, v, light)
    if surface is None:
        return point
    return moved_along(point, *surface[2:], turn, offset, light)


def moved_along(point, n, length, turn, offset, light):
    scale, *tilts = light.at(point)
    *aside, away = (half_up(-turn * 16 * offset * a, length) for a in n)
    return [*(at + half_up((m << 16) - t * away, 1 << (28 - light.f))
              for at, m, t in zip(point, aside, tilts)),
            point[2] + half_up(scale * away, 1 << 28)]


class Receivers:
    """The surfaces of an observer's pixels."""

    def __init__(self, codes, unit_at, words, s):
        """unit_at(px, py, code) are the unit's results, or None; words are the limit of a plane,
        the light's Scale and axes, and the planes of normals or None."""
        self.codes, self.unit_at, self.s = codes, unit_at, s
        self.limit, self.light, self.axes, self.normals = words or (None,) * 4

    def neighbour(self, px, py, dx, dy):
        """The one of two opposite neighbours that is taken, or None."""
        size, own = self.s.size_px, self.codes[py * self.s.size_px + px]
        found = []
        for x, y in ((px - dx, py - dy), (px + dx, py + dy)):
            if 0 <= x < size and 0 <= y < size:
                code = self.codes[y * size + x]
                if code != self.s.background_code:
                    found.append((abs(code - own), (x, y, code)))
        return min(found, key=lambda one: one[0])[1] if found else None

    def compared(self, px, py, point):
        """The results that are compared for a pixel's, and its plane or None."""
        if self.s.receiver != "point" and self.s.slope_source == "normals":
            return self.by_normal(py * self.s.size_px + px, point)
        beside, below = self.neighbour(px, py, 1, 0), self.neighbour(px, py, 0, 1)
        if self.s.receiver == "point" or point is None or beside is None or below is None:
            return point, None
        results = [self.unit_at(*beside), self.unit_at(*below)]
        if None in results:
            return point, None
        u, v = ([a - b for a, b in zip(result, point)] for result in results)
        if self.s.receiver == "normal":
            turn = (beside[0] - px) * (below[1] - py)
            return moved(point, u, v, turn, self.s.normal_offset, self.light), None
        slopes = gradient(u, v)
        return point, slopes and Plane(point, slopes, self.limit)

    def by_normal(self, p, point):
        """The same with the plane of normals (section 27)."""
        n = [plane[p] - 32768 for plane in self.normals]
        m = in_light(n, self.axes)
        if point is None or not any(n):
            return point, None
        if self.s.receiver == "normal":
            if any(m):
                point = moved_along(point, *cut_normal(m), -1, self.s.normal_offset, self.light)
            return point, None
        slopes = leaning(point, m, self.light)
        return point, slopes and Plane(point, slopes, self.limit)
