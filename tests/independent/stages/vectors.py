"""The vectors of ../vectors: for each stage lines "input words -> output words"."""
import pathlib

from . import blocks, perspective
from .bias import Layers, moved_code, offset, slope
from .dicing import EDGES, edge_level, normal, patch_level, vertex
from .filters import darken, dequantize, low_pass
from .float_store import float_bits, kept
from .ground import Ground, ShadowView, ellipse, ellipse_patches
from .noise import BYTES_A_WORD, amplitude, dither_word, noise_bits, taps_of_pixel
from .receiver import (Plane, Receivers, Scale, cut_normal, gradient, in_light, leaning,
                       light_axes, moved, moved_along)
from .samples import leaf_corners, triangle_depth, z_code
from .settings import Settings
from .shading import Shading, Toward, at_leaf, corner_normals, cut_to, unit14
from .shadow_test import LightMap, pixel_words
from .transform_unit import Loaded, ScreenUnit
from .triangles import (clockwise, facet_levels, own_normal, triangle_samples, weights,
                        within_guard_band)
from .views import View, axes_from_angles, axes_from_points, observer_to_light
from .words import cosine, decimal, object_words, plane, sine, sphere

FOLDER = pathlib.Path(__file__).parent / "../vectors"


def take(words, count):
    """The next `count` of a list of words, as numbers."""
    taken = [int(w) for w in words[:count]]
    del words[:count]
    return taken


def triples(words):
    return [tuple(words[k:k + 3]) for k in range(0, len(words), 3)]


def take_component(words):
    values = take(words, 16)
    return [values[k:k + 4] for k in range(0, 16, 4)]


def flat(nested):
    return [v for item in nested for v in (flat(item) if isinstance(item, (list, tuple))
                                           else [item])]


def decimals(w):
    return [decimal(w[0], int(w[1]))]


def sines(w):
    return [sine(int(w[0])), cosine(int(w[0]))]


def patches(w):
    kind = w.pop(0)
    numbers = take(w, len(w))
    if kind == "sphere":
        return sphere(numbers[:3], numbers[3])[numbers[4]][numbers[5]]
    if kind == "plane":
        return plane(*triples(numbers[:9]))[numbers[9]]
    words, fraction = object_words([[tuple(numbers)]])
    return [fraction, *words[0][0]]


def take_view(w, fitted=None):
    n = take(w, 16)
    return View(triples(n[:9]), n[12], n[13], None if fitted else n[14:], n[9:12],
                [fitted(n)] if fitted else ())


def views(w):
    kind = w.pop(0)
    if kind == "fit":
        points = triples([int(x) for x in w[16:]])
        view = take_view(w, lambda n: [points[0], points[1]] + [tuple(n[9:12])] * 14)
        return view.depths
    numbers = take(w, len(w))
    if kind == "angles":
        return flat(axes_from_angles(*numbers))
    return flat(axes_from_points(numbers[:3], numbers[3:]))


def matrices(w):
    kind = w.pop(0)
    if kind == "bias":
        bias, unit = int(w.pop(0)), w.pop(0)
        return [take_view(w).bias_quanta(bias, unit, Settings())]
    xy_bits, z_bits, coefficient_bits, number = take(w, 4)
    s = Settings(xy_bits=xy_bits, z_bits=z_bits, coefficient_bits=coefficient_bits)
    try:
        if kind == "screen":
            m = Loaded(take_view(w).world_to_screen(s), number, 1 << 14, s)
        else:
            observer, light = take_view(w), take_view(w)
            m = Loaded(observer_to_light(observer, light, s, number), s.input_fraction,
                       s.one_word, s)
    except ValueError:
        return ["refused"]
    return flat([m.words, m.exponents])


def ground(w):
    if w.pop(0) == "blob":
        number, *numbers = take(w, len(w))
        control = plane(*triples(numbers[:9]))
        blob = ellipse(control, triples(numbers[9:]))
        return flat([*blob, ellipse_patches(*blob)[number]])
    xy_bits, z_bits, coefficient_bits, fraction = take(w, 4)
    s = Settings(xy_bits=xy_bits, z_bits=z_bits, coefficient_bits=coefficient_bits)
    control, places = plane(*triples(take(w, 9))), triples(take(w, 3))
    observer, light = take_view(w), take_view(w)
    try:
        m = Loaded(ShadowView(observer, Ground(control, light), places).world_to_screen(s),
                   fraction, 1 << 14, s)
    except ValueError:
        return ["refused"]
    return flat([m.words, m.exponents])


class Given(Loaded):
    """A loaded matrix from its words."""

    def __init__(self, affine, words, exponents, s):
        self.affine, self.words, self.exponents = affine, words, exponents
        self.fraction, self.one = s.input_fraction, s.one_word


def transform_unit(w):
    keys = ("xy_bits", "z_bits", "coefficient_bits", "fraction_bits", "accumulator_bits")
    s = Settings(**dict(zip(keys, take(w, 5))), product_rounding=w.pop(0),
                 transform_rounding=w.pop(0), divide_order=w.pop(0))
    affine = w.pop(0) == "affine"
    words, exponents = take(w, 16), take(w, 4)
    m = Given(affine, [words[k:k + 4] for k in range(0, 16, 4)], exponents, s)
    status, results = ScreenUnit(m, s).status_and_results(*take(w, 3))
    return [status, *(results or [])]


def corrections(w):
    c = blocks.component(take(w, 16))
    return flat([c, "bounds", blocks.bounds(c)])


def splits(w):
    way = "uv".index(w.pop(0)) + 1
    return flat(blocks.split(take_component(w), way))


def block_rule(w):
    kind = w.pop(0)
    xy_bits, z_bits = take(w, 2)
    s = Settings(xy_bits=xy_bits, z_bits=z_bits)
    if kind == "affine":
        return [blocks.rule([blocks.bounds(take_component(w)) for _ in range(3)], s)]
    b = perspective.bounds([take_component(w) for _ in range(4)], s)
    if isinstance(b, str):
        return [b]
    huge = all(any(max(q[2][k], q[3][k]) >= perspective.HUGE for q in b) for k in (0, 1))
    return flat(["bounds", b, blocks.rule(b, s), "huge" if huge else "finite"])


def samples(w):
    kind = w.pop(0)
    if kind == "corners":
        grid = leaf_corners(take_component(w))
        places = (0, 0), (1, 0), (0, 1), (7, 3), (8, 8), (15, 9), (16, 15), (16, 16)
        return [grid[i][j] for i, j in places]
    if kind == "triangle":
        corners = triples(take(w, 9))
        found = triangle_depth(*corners, *take(w, 2))
    else:
        xy_bits, z_bits, depth = take(w, 3)
        found = z_code(depth, Settings(xy_bits=xy_bits, z_bits=z_bits))
    return ["none" if found is None else found]


def dicing(w):
    if w.pop(0) == "vertex":
        level, i, j, *numbers = take(w, len(w))
        points, k = triples(numbers), 1 << level
        return [*vertex(points, i, j, k), *normal(points, i, j, k)]
    most, tolerance, *numbers = take(w, len(w))
    points, s = triples(numbers), Settings(dice_levels=most)
    return [patch_level(points, tolerance, s),
            *(edge_level(points, edge, tolerance, s) for edge in EDGES)]


def plain_shading(ambient, material):
    """Of one channel and one source of level 256; whoever calls gives the directions."""
    shade = Shading.__new__(Shading)
    diffuse, specular, shade.shininess = material
    shade.ambient, shade.diffuse, shade.specular = ambient, (diffuse,), (specular,)
    shade.source_levels, shade.rule = [(256,)], "phong"
    return shade


def shading(w):
    places = [take_component(w) for _ in range(3)]
    kind, light, viewer = w.pop(0), take(w, 3), take(w, 3)
    ambient, *material = take(w, 4)
    i, j = take(w, 2)
    if kind == "point":
        corners = list(zip(*(comp[0] for comp in places)))
        light = unit14([1024 * e - p for e, p in zip(light, at_leaf(corners, i, j))])
    shade = plain_shading(ambient, material)
    normal = at_leaf(corner_normals(places), i, j)
    return shade.levels(normal, [light], viewer, (0,) if w[0] == "shadow" else ())


def triangles(w):
    kind = w.pop(0)
    if kind == "triangle":
        triangle = clockwise(*triples(take(w, 9)))
        found = list(triangle_samples(triangle, Settings(xy_bits=4))) if triangle else []
        ends = [(px, py, z) for px, py, _, _, z, *_ in (found[0], found[-1])] if found else []
        return flat([len(found), [sum(sample[4] for sample in found)] if found else [], ends])
    if kind == "polygon":
        s = Settings(xy_bits=int(w.pop(0)), z_bits=int(w.pop(0)))
        affine = w.pop(0) == "affine"
        left = within_guard_band([tuple(take(w, 10)) for _ in range(3)], affine, s)
        return flat([len(left), left])
    given = w.pop(0)
    facet = [tuple(take(w, 10)) for _ in range(3)]
    light, viewer = Toward.__new__(Toward), Toward.__new__(Toward)
    for toward in (light, viewer):
        words = take(w, 3)
        toward.direction, toward.eye = words, words if given == "points" else None
    ambient, *material = take(w, 4)
    shade = plain_shading(ambient, material)
    shade.towards, shade.viewer = [light], viewer
    triangle = clockwise(*facet)
    levels = facet_levels(shade, facet, kind == "smooth", triangle)
    e = weights(triangle, take(w, 2))
    return [*levels(*e), *levels(*e, (0,))]


def noise(w):
    xy_bits, fraction_bits, shape = int(w[0]), int(w[1]), w[2]
    size, seed, px, py = (int(x) for x in w[3:])
    k = BYTES_A_WORD[shape]
    first = 16 * k * ((py << xy_bits) + px)
    own = noise_bits(seed, first + 16 * k) >> first & ((1 << 16 * k) - 1)
    data, scale = own.to_bytes(2 * k, "little"), amplitude(k, size, fraction_bits)
    return [dither_word(sum(data[:k]), k, scale), dither_word(sum(data[k:]), k, scale)]


def map_codes(s):
    return [s.background_code if (a + 2 * b) % 11 == 0
            else (7919 * a + 104729 * b + 613 * a * b) % (1 << s.z_bits)
            for b in range(16) for a in range(16)]


def shadow_test(w):
    if w.pop(0) == "words":
        s = Settings(xy_bits=int(w[0]), z_bits=int(w[1]), registration=w[2])
        return pixel_words(*(int(x) for x in w[3:]), s)
    z_bits, fraction_bits = take(w, 2)
    s = Settings(xy_bits=4, z_bits=z_bits, fraction_bits=fraction_bits, lookup=w.pop(0),
                 background=w.pop(0))
    x, y, z, *dither = take(w, 5)
    return [LightMap(map_codes(s), s).darkness((x, y, z), dither)]


def windows(w):
    z_bits, fraction_bits = take(w, 2)
    s = Settings(xy_bits=4, z_bits=z_bits, fraction_bits=fraction_bits, lookup=w.pop(0),
                 taps=int(w.pop(0)), tap_places=w.pop(0))
    x, y, z, *dither, seed, px, py = take(w, 8)
    noise = taps_of_pixel(seed, s.taps, 16 * py + px) if s.tap_places == "jittered" else None
    return [LightMap(map_codes(s), s).darkness((x, y, z), dither, noise)]


def bits(digits):
    return [digit == "1" for digit in f"{int(digits, 16):0{4 * len(digits)}b}"]


def dequantized(w):
    mask = [255 * shadow for shadow in bits(w[1])]
    return [bytes(dequantize(mask, bits(w[2]), int(w[0]), 16)).hex()]


def low_passed(w):
    return [bytes(low_pass(bytes.fromhex(w[0]), bits(w[1]), 16)).hex()]


def composite(w):
    return [darken(*(int(x) for x in w))]


def bias(w):
    kind = w.pop(0)
    if kind == "offset":
        factor, limit = int(w.pop(0)), w.pop(0)
        of = slope(*triples(take(w, 9)))
        return [of, offset([of], factor, None if limit == "none" else int(limit))]
    if kind == "moved":
        z_bits, depth, more = take(w, 3)
        code = moved_code(depth, more, Settings(z_bits=z_bits))
        return ["none" if code is None else code]
    if kind == "plane":
        limit, numbers = w.pop(0), take(w, 11)
        at, beside, below = triples(numbers[:9])
        steps = [[b - a for a, b in zip(at, p)] for p in (beside, below)]
        slopes = gradient(*steps) or (0, 0)
        plane = Plane(at, slopes, None if limit == "none" else int(limit))
        return [*slopes, plane.change(*numbers[9:])]
    if kind == "neighbour":
        s = Settings(xy_bits=4)
        codes = [s.background_code] * 256
        px, py, dx, dy, left, own, right = take(w, 7)
        for k, code in ((-1, left), (0, own), (1, right)):
            x, y = px + k * dx, py + k * dy
            if 0 <= x < 16 and 0 <= y < 16 and code >= 0:
                codes[16 * y + x] = code
        found = Receivers(codes, None, None, s).neighbour(px, py, dx, dy)
        return found[:2] if found else ["none"]
    if kind == "normal":
        fraction_bits = int(w.pop(0))
        count, numbers = 1 + (w[0] == "lamp"), [int(v) for v in w if v != "lamp"]
        c, way, *places = numbers[count:]
        light, (at, *others) = Scale(numbers[:count], fraction_bits), triples(places)
        return moved(at, *([b - a for a, b in zip(at, p)] for p in others), way, c, light)
    z_bits, *codes = take(w, len(w))
    layers = Layers(Settings(xy_bits=4, z_bits=z_bits))
    for code in codes:
        layers.add(0, code)
    return layers.midpoints()[:1]


def take_viewer(w):
    kind, viewer = w.pop(0), Toward.__new__(Toward)
    words = take(w, 3)
    viewer.direction, viewer.eye = words, words if kind == "point" else None
    return viewer


def normals(w):
    kind, shade = w.pop(0), Shading.__new__(Shading)
    if kind == "leaf":
        places = [take_component(w) for _ in range(3)]
        viewer, (i, j) = take_viewer(w), take(w, 2)
        corners = list(zip(*(comp[0] for comp in places)))
        return shade.kept(cut_to(at_leaf(corner_normals(places), i, j), 14),
                          viewer.at(at_leaf(corners, i, j)))
    if kind == "facet":
        facet = [(0, 0, 0, 1, *place) for place in triples(take(w, 9))]
        viewer = take_viewer(w)
        return shade.kept(own_normal(facet), viewer.at([1024 * v for v in facet[0][4:]]))
    if kind == "light":
        *axes, n = triples(take(w, 12))
        view = View.__new__(View)
        view.axes = axes
        return in_light(n, light_axes(view))
    f = int(w.pop(0))
    count = 1 + (w[0] == "lamp")
    numbers = [int(v) for v in w if v != "lamp"]
    light, m, point = Scale(numbers[:count], f), numbers[count:count + 3], numbers[count + 3:]
    at, more = point[:3], point[3:]
    if kind == "moved":
        return moved_along(at, *cut_normal(m), -1, more[0], light) if any(m) else at
    slopes = leaning(at, m, light) or (0, 0)
    return [*slopes, Plane(at, slopes, None).change(*more)]


def float_store(w):
    n, store, code = int(w[0]), w[1], int(w[2])
    found = kept(code, Settings(xy_bits=6, z_bits=n, depth_store=store))
    return [found, float_bits((1 << n) - found if store == "float_reversed" else found, n)]


STAGES = {"decimals": decimals, "sines": sines, "patches": patches, "views": views,
          "matrices": matrices, "ground": ground,
          "transform_unit": transform_unit, "corrections": corrections,
          "splits": splits, "block_rule": block_rule, "samples": samples, "shading": shading,
          "triangles": triangles, "dicing": dicing, "bias": bias,
          "normals": normals, "float_store": float_store, "noise": noise,
          "shadow_test": shadow_test, "windows": windows,
          "dequantize": dequantized, "low_pass": low_passed, "composite": composite}


def check(stage):
    """How many lines a stage's file has, and the first that differs as a message, or None."""
    path, count = FOLDER / f"{stage}.txt", 0
    for number, line in enumerate(path.read_text(encoding="ascii").split("\n"), 1):
        if not line or line.startswith("#"):
            continue
        words, _, wanted = line.partition(" -> ")
        found = " ".join(str(v) for v in STAGES[stage](words.split(" ")))
        if found != wanted:
            return count, f"{path.name}:{number}: {found} for {wanted}"
        count += 1
    return count, None if count else f"{path.name} has no vectors"
