"""The receiver's own slope (section 24)."""
from .notation import fits, half_up


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


class Receivers:
    """The planes of an observer's pixels."""

    def __init__(self, codes, unit_at, limit, s):
        """unit_at(px, py, code) are the unit's results, or None."""
        self.codes, self.unit_at, self.limit, self.s = codes, unit_at, limit, s

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

    def plane(self, px, py, point):
        """Of a pixel with these results; None if there is none."""
        beside, below = self.neighbour(px, py, 1, 0), self.neighbour(px, py, 0, 1)
        if point is None or beside is None or below is None:
            return None
        results = [self.unit_at(*beside), self.unit_at(*below)]
        if None in results:
            return None
        u, v = ([a - b for a, b in zip(result, point)] for result in results)
        slopes = gradient(u, v)
        return slopes and Plane(point, slopes, self.limit)
