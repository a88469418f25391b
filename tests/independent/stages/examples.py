"""The worked examples of the text: each is computed, and has to be in the text word for word."""
import re

from . import blocks, models, perspective
from .figures import scene, view
from .filters import darken, dequantize, shadow_chains
from .noise import taps_of_pixel
from .notation import fnv, half_up, to_bytes
from .receiver import (Scale, cut_normal, gradient, in_light, leaning, light_axes, moved,
                       moved_along, normal, scale_words)
from .samples import leaf_corners
from .settings import Settings, table
from .shadow_test import LightMap, pixel_words
from .transform_unit import Loaded, ScreenUnit
from .views import shadow_matrix
from .words import object_words


def words(values):
    return " ".join(str(v) for v in values)


def hashes(text):
    size = {"": 1, "u8": 1, "u16be": 2, "u32be": 4}
    for values, kind, _ in table(text, "| values | as | hash |"):
        numbers = [] if values == "none" else [int(v) for v in values.split(" ")]
        yield f"| {values} | {kind} | {fnv(to_bytes(numbers, size[kind])):016x} |".replace(
            "|  |", "| |")


def biases():
    figures, lamp = view("left", scene("spheres")), view("lamp", scene("floor"))
    s = Settings()
    yield (f"{1311 * 16384 / 65536} quanta, the word "
           f"{figures.bias_quanta(1311, 'world', s)}")
    word = lamp.bias_quanta(1311, "world", s)
    yield f"near {lamp.depths[0]}, far {lamp.depths[1]}) makes {word / 65536:.6f} quanta of it"
    yield f"the word {word}"
    word = lamp.bias_quanta(98304, "texels", s)
    yield f"192 quanta ({figures.bias_quanta(98304, 'texels', s)}) of the figures' light"
    yield f"{word / 65536:.6f} ({word})"


def round_first():
    world = scene("floor")
    s = Settings("coefficient_bits 24, bias 192")
    exact = ScreenUnit(shadow_matrix(view("oblique", world), view("lamp", world), s), s)
    point = pixel_words(256, 256, 40000, s)
    acc = exact.accumulators(*point)
    yield f"the input words are ({', '.join(map(str, point))})"
    yield f"acc = {', '.join(map(str, acc))} exponents {', '.join(map(str, exact.m.exponents))}"
    x, y, z = exact(*point)
    yield f"/ {acc[3]}) = {x} Y = {y} Z = {z}"
    rounded = [half_up(a, 1 << 22) for a in acc]
    s.divide_order = "round_first"
    x, y, z = exact(*point)
    yield (f"round_first: acc = {', '.join(map(str, rounded))}, and X = half_up({rounded[0]} x "
           f"2^14 / {rounded[3]}) = {x}, Y = {y}, Z = {z}")


def edges():
    def frame(pixels, passes):
        mask = [255 * ((p % 16, p // 16) in pixels) for p in range(256)]
        chains = [len(chain) for chain in shadow_chains(mask, 16)]
        return chains, dequantize(mask, [True] * 256, passes, 16)

    def two(pixels, passes):
        a = frame(pixels, passes)[1]
        return f"{words(a[85:87])} / {words(a[101:103])}"
    for name, pixels in (("(5, 5), (6, 5), (6, 6) |", {(5, 5), (6, 5), (6, 6)}),
                         ("diagonal: (5, 5), (6, 6) |", {(5, 5), (6, 6)}),
                         ("diagonal: (6, 5), (5, 6) |", {(6, 5), (5, 6)})):
        chains = frame(pixels, 1)[0]
        yield name + (f" one of {chains[0]} steps |" if len(chains) == 1 else
                      f" two of {chains[0]} steps each |")
        yield f"{two(pixels, 1)} | {two(pixels, 4)} |"
    ring = {(5, 4), (6, 4), (7, 4), (5, 5), (7, 5), (6, 6), (7, 6)}
    assert frame(ring, 1)[0] == [16]
    one, four = (frame(ring, passes)[1] for passes in (1, 4))
    for y in (4, 5, 6):
        p = 16 * y + 5
        yield f"{words(one[p:p + 3])} {words(four[p:p + 3])}"


def windows():
    nine = ((502, 500, 500), (501, 12, 11), (13, 14, 12))
    s = Settings(xy_bits=4, taps=3, lookup="percentage")
    codes = [s.background_code] * 256
    for j, row in enumerate(nine):
        codes[16 * (4 + j) + 6:16 * (4 + j) + 9] = row
    middle = (-64, -320, 498 - s.depth_offset)  # of texel (7, 5)
    share = LightMap(codes, s).darkness(middle, (0, 0))
    yield f"{' / '.join(map(words, nine))} and a point of code 498, k = 3."
    yield f"the mask is half_up(255 x 5 / 9) = {share}."
    s.lookup = "filtered_depth"
    total = sum(map(sum, nine))
    yield (f"Their sum {total} (a mean of {total / 9:.1f}) is less than 9 x 498 = {9 * 498}: in "
           f"shadow, {LightMap(codes, s).darkness(middle, (0, 0))}.")
    for x, y in ((0, 0), (80, 180)):
        four = taps_of_pixel(s.dither_seed, 2, 512 * y + x)
        yield f"{' '.join(map(str, four))} at pixel ({x}, {y})"


def normals():
    world, places = scene("floor"), []
    for name, s in (("left", Settings()), ("lamp", Settings("coefficient_bits 24"))):
        light = view(name, world)
        bias = light.bias_quanta(192 << 16, "quanta", s)
        scale = Scale(scale_words(light, s, bias), 7)
        point, u, v = (14764, -9664, -17672), (20, 0, 120), (-4, 126, 40)
        yield ("quanta_a_texel = " + str(scale.quanta) if name == "left" else
               f"reach = {scale.reach} and focal = {scale.focal}")
        if name == "lamp":
            yield f"scale = {scale.at(point)[0]}, tilt = {', '.join(map(str, scale.at(point)[1:]))}"
        a, b, n, length = normal(point, u, v, scale)
        yield (f"u' = ({words(a)}), v' = ({words(b)}), n' = ({words(n)}), length = {length}")
        yield f"({words(point)}) goes to ({words(moved(point, u, v, 1, 256, scale))})"


def plane_of_normals():
    world, n = scene("floor"), (-5440, -1363, 15394)
    point = (14764, -9664, -17672)
    yield f"N = ({', '.join(map(str, n))}): words {words(a + 32768 for a in n)}"
    for name, s in (("left", Settings()), ("lamp", Settings("coefficient_bits 24"))):
        light = view(name, world)
        scale = Scale(scale_words(light, s, light.bias_quanta(192 << 16, "quanta", s)), 7)
        axes = light_axes(light)
        if name == "left":
            for axis, sign, letter in zip(axes, (1, -1, -1), "rub"):
                yield f"{letter} = ({', '.join(str(sign * a) for a in axis)})"
        m = in_light(n, axes)
        yield (f"m = ({words(m)}), slope_X = {leaning(point, m, scale)[0]}, slope_Y = "
               f"{leaning(point, m, scale)[1]}")
        yield (f"({words(point)}) goes to "
               f"({words(moved_along(point, *cut_normal(m), -1, 256, scale))})")
    a, b = gradient((20, 0, 120), (-4, 126, 40))
    yield f"differences have {a} and {b}"


def composites():
    yield (f"direct {darken(194, 118, 255, 218)}; whole {darken(194, 194, 255, 218)}. "
           f"With density 256: {darken(194, 118, 255, 256)} and {darken(194, 194, 255, 256)}.")


def perspective_block():
    world = scene("floor")
    s = Settings("coefficient_bits 24, bias 192")
    observer, lights = view("oblique", world), [view("sun", world), view("lamp", world)]
    yield from (f"{name} ({', '.join(map(str, axis))})" for v in (observer, *lights)
                for name, axis in zip(("right", "up", "back"), v.axes))
    yield from (f"near {v.depths[0]}, far {v.depths[1]}" for v in (observer, *lights))
    patches, f = object_words(world)
    to_screen = [Loaded(v.world_to_screen(s), f, 1 << 14, s) for v in (observer, *lights)]
    shadow = [ScreenUnit(shadow_matrix(observer, v, s), s).m for v in lights]
    yield from (f"({', '.join(map(str, row))}) {e}" for m in to_screen + shadow
                for row, e in m.rows)
    block = blocks.screen_components(patches[17], to_screen[0], s)
    for way in "uvuvuv":
        assert blocks.action(block, (0, 0), False, s) == way
        block = [blocks.split(c, "uv".index(way) + 1)[0] for c in block]
    assert blocks.action(block, (0, 0), False, s) == "draw"
    for name, c in zip("XYZW", block):
        yield f"{name} f {words(c[0])} gu {words(c[1])} gv {words(c[2])} guv {words(c[3])}"
    for name, b in [("W", blocks.bounds(block[3])),
                    *zip(("X/W", "Y/W", "Z/W"), perspective.bounds(block, s))]:
        yield f"{name} min {b[0]} max {b[1]} slopes {words(b[2])} bends {words(b[3])}"
    grids = [leaf_corners(c) for c in block]
    divided = perspective.divide_corners(*grids, s)
    for i, j in ((0, 0), (5, 9), (16, 16)):
        x, y, z, w = (g[i][j] for g in grids)
        yield (f"corner ({i}, {j}) X {x} Y {y} Z {z} W {w} "
               f"divided: {words(g[i][j] for g in divided)}")


def placed():
    for what, values in models.examples():
        yield f"| {what} | {words(values)} |"


def check(text):
    """How many examples there are, and those that the text lacks."""
    found = [*hashes(text), *biases(), *round_first(), *edges(), *windows(), *normals(),
             *plane_of_normals(),
             *composites(),
             *perspective_block(), *placed()]
    text = re.sub(r"\s+", " ", text)
    return len(found), [example for example in found if example not in text]
