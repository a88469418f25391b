"""The post-process and the correct form (sections 11 and 12)."""
from .notation import shift_down
from .receiver import Receivers
from .transform_unit import ScreenUnit


def pixel_words(px, py, code, s):
    centre = 1 if s.registration == "centre" else 0
    half_word = s.input_fraction - 1
    return ((2 * (px - s.half_px) + centre) << half_word,
            (2 * (py - s.half_px) + centre) << half_word,
            (code - s.depth_offset) << (s.input_fraction - s.depth_fraction))


class LightMap:
    def __init__(self, codes, s):
        self.codes, self.s = codes, s

    def texel(self, a, b):
        if 0 <= a < self.s.size_px and 0 <= b < self.s.size_px:
            return self.codes[b * self.s.size_px + a]
        return self.s.background_code

    def nearest(self, x, y, code, plane):
        s = self.s
        tx, ty = (x >> s.fraction_bits) + s.half_px, (y >> s.fraction_bits) + s.half_px
        if plane:
            code += plane.change(*(2 * s.one_texel * (t - s.half_px) + s.one_texel
                                   for t in (tx, ty)))
        return code > self.texel(tx, ty)

    def bilinear(self, x, y, code, plane):
        s, q = self.s, self.s.one_texel
        cx, cy = x - q // 2, y - q // 2
        tx, ty = (cx >> s.fraction_bits) + s.half_px, (cy >> s.fraction_bits) + s.half_px
        fx, fy = cx & (q - 1), cy & (q - 1)
        four = (self.texel(tx, ty), self.texel(tx + 1, ty),
                self.texel(tx, ty + 1), self.texel(tx + 1, ty + 1))
        if s.background == "fall_back" and s.background_code in four:
            return self.nearest(x, y, code, plane)
        if plane:
            code += plane.change(2 * x, 2 * y)
        return code * q * q > ((q - fy) * ((q - fx) * four[0] + fx * four[1])
                               + fy * ((q - fx) * four[2] + fx * four[3]))

    def in_shadow(self, point, dither, plane=None):
        """Steps 1 to 6 for the unit's results (None: a status) and a pixel's dither words."""
        s = self.s
        if point is None:
            return False
        x, y, code = point[0] + dither[0], point[1] + dither[1], point[2] + s.depth_offset
        edge = s.half_px * s.one_texel
        if not (-edge <= x < edge and -edge <= y < edge and 0 <= code <= s.deepest_drawn):
            return False
        if s.lookup == "bilinear" and s.fraction_bits > 0:
            return self.bilinear(x, y, code, plane)
        return self.nearest(x, y, code, plane)


def post_process(observer_z, light_z, matrix, s, dither, limit=None):
    """`limit` is the receiver's plane's, None for none."""
    unit, light_map, mask = ScreenUnit(matrix, s), LightMap(light_z, s), [0] * len(observer_z)

    def unit_at(px, py, code):
        return unit(*pixel_words(px, py, code, s))
    planes = Receivers(observer_z, unit_at, limit, s)
    for p, code in enumerate(observer_z):
        if code != s.background_code:
            px, py = p % s.size_px, p // s.size_px
            point = unit_at(px, py, code)
            plane = planes.plane(px, py, point) if s.receiver == "plane" else None
            if light_map.in_shadow(point, dither[p] if dither else (0, 0), plane):
                mask[p] = 255
    return mask


def correct_record(light_z, matrix, s, dither):
    """What the store compares after the code: (intensity, direct, mask)."""
    unit, light_map = ScreenUnit(matrix, s), LightMap(light_z, s)
    off = 4096 if s.registration == "index" else 0

    def of_block(levels):
        def record(sample, code):
            px, py, x, y, _, *where = sample
            words = [shift_down(v - off, 13 - s.input_fraction) for v in (x, y)]
            point = unit(*words, pixel_words(px, py, code, s)[2])
            shadow = light_map.in_shadow(point,
                                         dither[py * s.size_px + px] if dither else (0, 0))
            return (*levels(*where, shadow), 255 if shadow else 0)
        return record
    return of_block


def plain_record(levels):
    """Of the post-process: (intensity, direct), with nothing in shadow."""
    return lambda sample, code: levels(*sample[5:])
