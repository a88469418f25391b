"""The post-process and the correct form (sections 11 and 12)."""
from .notation import shift_down
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

    def nearest(self, x, y, code):
        s = self.s
        return code > self.texel((x >> s.fraction_bits) + s.half_px,
                                 (y >> s.fraction_bits) + s.half_px)

    def bilinear(self, x, y, code):
        s, q = self.s, self.s.one_texel
        cx, cy = x - q // 2, y - q // 2
        tx, ty = (cx >> s.fraction_bits) + s.half_px, (cy >> s.fraction_bits) + s.half_px
        fx, fy = cx & (q - 1), cy & (q - 1)
        four = (self.texel(tx, ty), self.texel(tx + 1, ty),
                self.texel(tx, ty + 1), self.texel(tx + 1, ty + 1))
        if s.background == "fall_back" and s.background_code in four:
            return self.nearest(x, y, code)
        return code * q * q > ((q - fy) * ((q - fx) * four[0] + fx * four[1])
                               + fy * ((q - fx) * four[2] + fx * four[3]))

    def in_shadow(self, point, dither):
        """Steps 1 to 6 for the unit's results (None: a status) and a pixel's dither words."""
        s = self.s
        if point is None:
            return False
        x, y, code = point[0] + dither[0], point[1] + dither[1], point[2] + s.depth_offset
        edge = s.half_px * s.one_texel
        if not (-edge <= x < edge and -edge <= y < edge and 0 <= code <= s.deepest_drawn):
            return False
        if s.lookup == "bilinear" and s.fraction_bits > 0:
            return self.bilinear(x, y, code)
        return self.nearest(x, y, code)


def post_process(observer_z, light_z, matrix, s, dither):
    unit, light_map, mask = ScreenUnit(matrix, s), LightMap(light_z, s), [0] * len(observer_z)
    for p, code in enumerate(observer_z):
        if code != s.background_code:
            point = unit(*pixel_words(p % s.size_px, p // s.size_px, code, s))
            if light_map.in_shadow(point, dither[p] if dither else (0, 0)):
                mask[p] = 255
    return mask


def correct_record(lights, s, dither):
    """What the store compares after the code: the levels, and each light's mask.

    A light is its map and the matrix from the observer to it."""
    units = [(ScreenUnit(matrix, s), LightMap(light_z, s)) for light_z, matrix in lights]
    off = 4096 if s.registration == "index" else 0

    def of_block(levels):
        def record(sample, code):
            px, py, x, y, _, *where = sample
            words = [shift_down(v - off, 13 - s.input_fraction) for v in (x, y)]
            words.append(pixel_words(px, py, code, s)[2])
            noise = dither[py * s.size_px + px] if dither else (0, 0)
            shadows = [light_map.in_shadow(unit(*words), noise) for unit, light_map in units]
            shadowed = tuple(k for k, shadow in enumerate(shadows) if shadow)
            return (*levels(*where, shadowed), *(255 if shadow else 0 for shadow in shadows))
        return record
    return of_block


def plain_record(levels):
    """Of the post-process: the levels, with nothing in shadow."""
    return lambda sample, code: levels(*sample[5:])
