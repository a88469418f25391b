"""A light inside the view, in sectors (section 25)."""
from fractions import Fraction

from .noise import tap_bytes
from .receiver import Receivers
from .shadow_test import LightMap, pixel_words
from .transform_unit import ScreenUnit, load_row
from .views import View, axes_from_points, shadow_matrix

# The directions in which a sector looks, and those to its right and down: an axis and a sign.
SECTORS = (((0, 1), (2, 1), (1, -1)), ((0, -1), (2, -1), (1, -1)), ((1, 1), (0, 1), (2, -1)),
           ((1, -1), (0, 1), (2, 1)), ((2, 1), (0, -1), (1, -1)), ((2, -1), (0, 1), (1, -1)))


def sector_views(place, d, depths, patches):
    """The views of the six lights."""
    for (axis, sign), _, _ in SECTORS:
        target = [p + sign * d * (k == axis) for k, p in enumerate(place)]
        yield View(axes_from_points(place, target), d, d, depths, target, patches)


class SectorLights(ScreenUnit):
    """The rows of all sectors, as one unit holds them: the directions, and then each row Z."""

    def __init__(self, observer, views, s):
        exact = [shadow_matrix(observer, view, s) for view in views]
        rows = [[*row[:3], row[3] / Fraction(s.one_word, 1 << s.input_fraction)]
                for row in [exact[k][3] for k in (0, 2, 4)] + [matrix[2] for matrix in exact]]
        bits, rounding = s.coefficient_bits, s.rounding("coefficient")
        common = max(load_row(row, bits, rounding)[1] for row in rows[:3])
        loaded = [load_row(row, bits, rounding, start=common) for row in rows[:3]]
        loaded += [load_row(row, bits, rounding) for row in rows[3:]]
        if any(abs(e - common) > 42 for _, e in loaded):
            raise ValueError("a row Z is too far from the directions")
        self.s, self.transform = s, s.rounding("transform")
        self.product, self.place = s.rounding("product"), 1 << s.dropped_bits
        self.loaded, self.common = loaded, common

    def sum(self, row, x, y, z):
        words = self.loaded[row][0]
        return sum(self.cut(a * b) for a, b in zip(words, (x, y, z, self.s.one_word)))

    def directions(self, words):
        return [self.sum(k, *words) for k in range(3)]

    def sector(self, words):
        d = self.directions(words)
        size = max(map(abs, d))
        axis = [abs(v) for v in d].index(size)
        return None if size == 0 else 2 * axis + (d[axis] < 0)

    def point(self, sector, words):
        """X, Y, Z in a sector, or None for a status."""
        s, d = self.s, self.directions(words)
        w, x, y = (sign * d[axis] for axis, sign in SECTORS[sector])
        acc = [x, y, self.sum(3 + sector, *words), w]
        if s.divide_order == "round_first":
            acc = [self.transform(a, 1 << (s.coefficient_bits - 2)) for a in acc]
        if acc[3] <= 0:
            return None
        shifts = (s.fraction_bits + s.xy_bits - 1,) * 2 + (
            s.depth_fraction + self.loaded[3 + sector][1] - self.common,)
        bits = (s.xy_bits + s.fraction_bits + 1,) * 2 + (s.z_bits + 1,)
        results = [self.transform(a << max(k, 0), acc[3] << max(-k, 0))
                   for a, k in zip(acc, shifts)]
        return results if all(-(1 << b - 1) <= q < 1 << b - 1
                              for q, b in zip(results, bits)) else None


class FaceMap(LightMap):
    """A map whose edge is read beyond it."""

    def texel(self, a, b):
        last = self.s.size_px - 1
        return super().texel(min(max(a, 0), last), min(max(b, 0), last))

    def darkness(self, point, dither, noise=None, plane=None):
        if point is None:
            return 0
        edge = self.s.half_px * self.s.one_texel
        moved = [min(max(v + d, -edge), edge - 1) for v, d in zip(point, dither)]
        return super().darkness([*moved, point[2]], (0, 0), noise, plane)


def sector_mask(observer_z, maps, lights, s, dither, words):
    """`words` are what Receivers takes of each sector."""
    faces, mask, noise = [FaceMap(codes, s) for codes in maps], [0] * len(observer_z), tap_bytes(s)
    for p, code in enumerate(observer_z):
        px, py = p % s.size_px, p // s.size_px
        pixel = pixel_words(px, py, code, s)
        sector = lights.sector(pixel) if code != s.background_code else None
        if sector is None:
            continue

        def unit_at(x, y, z, k=sector):
            return lights.point(k, pixel_words(x, y, z, s))
        point, plane = Receivers(observer_z, unit_at, words[sector], s).compared(
            px, py, unit_at(px, py, code))
        mask[p] = faces[sector].darkness(point, dither[p] if dither else (0, 0),
                                         noise[p] if noise else None, plane)
    return mask
