"""The post-process and the correct form (sections 11 and 12)."""
from .float_store import kept
from .noise import tap_bytes
from .notation import half_up, shift_down
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

    def taps(self, x, y, noise):
        """The codes of the window's texels."""
        s, k, q = self.s, self.s.taps, self.s.one_texel
        if noise is None:
            first_x, first_y = (((2 * v - (k - 1) * q) >> (s.fraction_bits + 1)) + s.half_px
                                for v in (x, y))
            places = [(first_x + i, first_y + j) for j in range(k) for i in range(k)]
        else:
            def texel(v, i, byte):
                return (512 * v + (512 * i - 256 * k + 2 * byte + 1) * q) // (512 * q) + s.half_px
            places = [(texel(x, t % k, u), texel(y, t // k, v)) for t, (u, v) in enumerate(noise)]
        return [self.texel(*place) for place in places]

    def darkness(self, point, dither, noise=None, plane=None):
        """Steps 1 to 8 for the unit's results (None: a status), a pixel's dither words and its
        taps' bytes (None: a grid)."""
        s = self.s
        if point is None:
            return 0
        x, y, code = point[0] + dither[0], point[1] + dither[1], point[2] + s.depth_offset
        edge = s.half_px * s.one_texel
        if not (-edge <= x < edge and -edge <= y < edge and 0 <= code <= s.deepest_drawn):
            return 0
        code = kept(code, s)
        if s.lookup in ("percentage", "filtered_depth"):
            codes = self.taps(x, y, noise)
            if s.lookup == "percentage":
                return half_up(255 * sum(code > z for z in codes), len(codes))
            return 255 * (code * len(codes) > sum(codes))
        if s.lookup == "bilinear" and s.fraction_bits > 0:
            return 255 * self.bilinear(x, y, code, plane)
        return 255 * self.nearest(x, y, code, plane)


def post_process(observer_z, light_z, matrix, s, dither, words=None):
    """`words` are what Receivers takes of the light."""
    unit, light_map, mask = ScreenUnit(matrix, s), LightMap(light_z, s), [0] * len(observer_z)
    noise = tap_bytes(s)

    def unit_at(px, py, code):
        return unit(*pixel_words(px, py, code, s))
    receivers = Receivers(observer_z, unit_at, words, s)
    for p, code in enumerate(observer_z):
        if code != s.background_code:
            px, py = p % s.size_px, p // s.size_px
            point, plane = receivers.compared(px, py, unit_at(px, py, code))
            mask[p] = light_map.darkness(point, dither[p] if dither else (0, 0),
                                         noise[p] if noise else None, plane)
    return mask


def correct_record(lights, s, dither):
    """What the store compares after the code: the levels, and each light's mask.

    A light is its map and the matrix from the observer to it."""
    units = [(ScreenUnit(matrix, s), LightMap(light_z, s)) for light_z, matrix in lights]
    noise = tap_bytes(s)
    off = 4096 if s.registration == "index" else 0

    def of_block(levels):
        def record(sample, code):
            px, py, x, y, _, *where = sample
            words = [shift_down(v - off, 13 - s.input_fraction) for v in (x, y)]
            words.append(pixel_words(px, py, code, s)[2])
            p = py * s.size_px + px
            around = (dither[p] if dither else (0, 0), noise[p] if noise else None)
            masks = [light_map.darkness(unit(*words), *around) for unit, light_map in units]
            shadowed = tuple(k for k, mask in enumerate(masks) if mask == 255)
            return (*levels(*where, shadowed), *masks)
        return record
    return of_block


def plain_record(levels):
    """Of the post-process: the levels, with nothing in shadow."""
    return lambda sample, code: levels(*sample[5:])
