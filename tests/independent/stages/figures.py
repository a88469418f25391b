"""The figures' scene, the variants and their frames (section 15), and several lights (23, 25)."""
import math
import re

from .ap120b import array_mask
from .dicing import diced, tolerance
from .filters import composite, dequantize, low_pass, ramp
from .ground import ellipse, ellipse_patches, ground_masks
from .noise import dither_words, noise_bits
from .notation import half_up
from .places import Places
from .receiver import Scale, light_axes, scale_words
from .sectors import SectorLights, sector_mask, sector_views
from .settings import Settings, table
from .shading import Shading
from .shadow_test import correct_record, plain_record, post_process
from .store import draw
from .views import View, axes_from_angles, axes_from_points, shadow_matrix
from .words import object_place, object_words, plane, sphere

SPHERES = ((-68813, 39322, 0), (62259, 77332, 19661), (-49152, -73400, 13107),
           (68813, -27525, 29491))
FLOOR = ((-196608, -127795, 196608), (393216, 0, 0), (0, 0, -393216))
MATERIAL = ((215,), (90,), 5)
COLOURED = ((215, 140, 60), (90, 90, 90), 5)
CHANNELS = ("_red", "_green", "_blue")
AMBIENT, UNIT = 90, 65536
SIX = [tuple(sign * (axis == k) for k in range(3)) for axis in range(3) for sign in (1, -1)]
VERTICES = ((-196608, -127795, 196608), (196608, -127795, 196608), (196608, -127795, -196608),
            (-196608, -127795, -196608),
            *(tuple(c + 70000 * k for c, k in zip((62259, 20000, 19661), way)) for way in SIX),
            (-150000, 110000, -90000), (170000, 130000, -120000), (-20000, 122000, 100000))


def scene(name):
    """A scene's patches"""
    spheres = SPHERES[:1] if name == "mesh" else SPHERES
    patches = [patch for centre in spheres for patch in sphere(centre, 47186)]
    return patches + ([plane(*FLOOR)] if name == "floor" else [])


def mesh(name):
    """A scene's vertices, and its facets: three vertices, and three normals or None"""
    if name != "mesh":
        return (), []
    normals = [tuple(16384 * k for k in way) for way in SIX]
    ways = [(x, 2 + y, 4 + z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    return VERTICES, [((0, 1, 2), None), ((0, 2, 3), None), ((10, 11, 12), None),
                      *(([4 + k for k in three], [normals[k] for k in three]) for three in ways)]


def angles(azimuth, elevation):
    return axes_from_angles(azimuth * UNIT, elevation * UNIT)


# Sources that are more than a view of level 256: the view, levels, and of an area size and side.
SOURCES = {"dim": ("right", (128,), None), "red": ("sun", (256, 64, 32), None),
           "panel": ("lamp", (256,), (131072, 2, None)),
           "scatter": ("lamp", (256,), (131072, 2, 78))}
# Sectored: the place, the distance, near and far.
SECTORED = {"bulb": ((10000, 60000, 20000), 65536, (2048, 524288))}
PLACES = {"lamp": (-327680, 262144, 131072)}


def view_words(name):
    return {
        "front": (angles(0, 0), 131072, 0, (-131072, 131072)),
        "left": (angles(-100, 0), 131072, 0, (-131072, 131072)),
        "right": (angles(100, 0), 131072, 0, (-131072, 131072)),
        "oblique": (angles(30, 20), 131072, 393216, None),
        "sun": (angles(-100, 30), 262144, 0, None),
        "lamp": (axes_from_points((-327680, 262144, 131072), (0, 0, 0)), 262144, 439629, None),
        "near_eye": (angles(30, 20), 131072, 98304, (4096, 524288)),
        "clipped": (angles(-100, 0), 65536, 0, (-32768, 32768)),
        "spot": (angles(-100, 30), 65536, 0, (-196608, 196608)),
        "inside": (axes_from_points((10000, 60000, 20000), (0, 0, 0)), 131072, 64031,
                   (2048, 524288)),
    }[name]


def view(name, patches):
    axes, extent, distance, depths = view_words(name)
    return View(axes, extent, distance, depths, patches=patches)


def area(name, size, n, seed, patches):
    """The views of the lights on a square source at a view's place."""
    (right, up, _), extent, _, depths = view_words(name)
    views = []
    for j in range(n):
        for i in range(n):
            a, b, over = 2 * i + 1 - n, 2 * j + 1 - n, 2 * n
            if seed:
                bits = noise_bits(seed, 16 * n * n) >> 16 * (j * n + i)
                byte_u, byte_v = bits & 255, bits >> 8 & 255
                a, b = 512 * i - 256 * n + 2 * byte_u + 1, 512 * j - 256 * n + 2 * byte_v + 1
                over = 512 * n
            place = [p + half_up((a * r + b * u) * size, over << 30)
                     for p, r, u in zip(PLACES[name], right, up)]
            square = sum(p * p for p in place)
            root = math.isqrt(square)
            views.append(View(axes_from_points(place, (0, 0, 0)), extent,
                              root + (square - root * root > root), depths, patches=patches))
    return views


class Source:
    """Its place's view, the views of its lights, and its levels by channel."""

    def __init__(self, name, patches):
        name, _, self.ramp = name.partition(" ramp ")
        self.sectored = name in SECTORED
        if self.sectored:
            self.views, self.levels = [*sector_views(*SECTORED[name], patches)], (256,)
            self.place = self.views[0]
            return
        view_name, self.levels, square = SOURCES.get(name, (name, (256,), None))
        self.place = view(view_name, patches)
        self.views = area(view_name, *square, patches) if square else [self.place]


class Frame:
    """A frame's buffers, each made when it is asked for: mask of the first light, mask2, ...

    Light maps and masks are numbered by lights, direct, darkness, edges and filtered by sources;
    in a coloured frame intensity, direct and picture end in a channel.
    """

    def __init__(self, scene_name, observer, lights, s):
        vertices, facets = mesh(scene_name)
        world = [*scene(scene_name), vertices]  # lists of places
        self.s, self.blobs = s, []
        if s.form == "blob":  # one beneath each sphere
            self.blobs = [patch for k in range(0, 128, 32) for patch in ellipse_patches(
                *ellipse(world[128], [p for patch in world[k:k + 32] for p in patch]))]
        (*_, vertices), self.fraction = object_words(world, self.blobs)
        self.facets = [([vertices[k] for k in three], normals) for three, normals in facets]
        self.observer = view(observer, world)
        self.sources = [Source(name, world) for name in lights.split(" + ")]
        self.lights = [v for source in self.sources for v in source.views]
        self.coloured = any(len(source.levels) > 1 for source in self.sources)
        self.world = world[:-1]
        self.mesh_facets, self.vertices = self.facets, world[-1]
        self.patches, self.facets = self.as_drawn(self.world, self.facets)
        self.made, self.counts = {}, {}

    def as_drawn(self, patches, facets=()):
        """Patches in world words as draw() takes them, and the facets."""
        if self.s.surface != "diced":
            return [[object_place(p, self.fraction) for p in patch] for patch in patches], facets
        word = tolerance(self.observer.extent_word, self.s)
        return [], [*(([object_place(p, self.fraction) for p in points], normals)
                      for patch in patches for points, normals in diced(patch, word, self.s)),
                    *facets]

    def __getattr__(self, buffer):
        if buffer not in self.made:
            name, number, channel = re.fullmatch(
                r"(\w+?)(\d*)(_red|_green|_blue|)", buffer).groups()
            getattr(self, "make_" + name)(int(number or 1) - 1, number, channel)
        return self.made[buffer]

    def make_light_z(self, light, number, _):
        self.made["light_z" + number], _, counts = draw(
            self.patches, self.facets, self.fraction, self.lights[light], self.s)
        self.counts["light" + number] = counts

    def matrix(self, light):
        return shadow_matrix(self.observer, self.lights[light], self.s)

    def of_light(self, buffer, light):
        return getattr(self, buffer + (str(light + 1) if light else ""))

    def shading(self):
        channels = 3 if self.coloured else 1
        sources = [(source.place, source.levels * (channels // len(source.levels)))
                   for source in self.sources]
        return Shading(self.observer, sources, self.fraction, self.s.ambient,
                       COLOURED if self.coloured else MATERIAL, self.s.shading,
                       self.keeps_normals())

    def keeps_normals(self):
        return self.s.receiver != "point" and self.s.slope_source == "normals"

    def make_observer_z(self, *_):
        s, correct = self.s, self.s.form == "correct"
        record = plain_record
        if correct:
            record = correct_record([(self.of_light("light_z", k), self.matrix(k))
                                     for k in range(len(self.lights))], s, dither_words(s))
        planes, rest, self.counts["observer"] = draw(
            self.patches, self.facets, self.fraction, self.observer, s, record, self.shading())
        self.made["observer_z"] = planes
        rest = iter(rest)
        for channel in CHANNELS if self.coloured else ("",):
            self.made["intensity" + channel] = next(rest)
            for k in range(len(self.sources)):
                self.made["direct" + (str(k + 1) if k else "") + channel] = next(rest)
        for axis in "xyz" if self.keeps_normals() else "":
            self.made["normal_" + axis] = [n + 32768 for n in next(rest)]
        for k in range(len(self.lights) if correct else 0):
            self.made["mask" + (str(k + 1) if k else "")] = next(rest)
    make_intensity = make_direct = make_observer_z
    make_normal_x = make_normal_y = make_normal_z = make_observer_z

    def make_mask(self, light, number, _):
        s = self.s
        for source in self.sources:
            first = self.lights.index(source.views[0])
            if source.sectored and first == light:
                self.made["mask" + number] = self.mask_of_sectors(source.views, first)
                return
        if s.form == "correct":
            self.make_observer_z()
            return
        if s.form in ("ground", "blob"):
            self.make_ground_masks()
            return
        if s.form == "irregular_map":
            places = Places(self.observer_z, self.matrix(light), s)
            self.made["mask" + number] = places.mask(draw(
                self.patches, self.facets, self.fraction, self.lights[light], s,
                places=places)[0])
            return
        given = (self.observer_z, self.of_light("light_z", light), self.matrix(light), s,
                 dither_words(s))
        if s.arithmetic == "ap120b":
            self.made["mask" + number] = array_mask(*given)
            return
        self.made["mask" + number] = post_process(*given, self.receiver_words(light))

    def receiver_words(self, light):
        s, view = self.s, self.lights[light]
        limit = view.bias_quanta(s.bias_clamp, s.bias_unit, s) >> 16 if s.bias_clamp else None
        scale = Scale(scale_words(view, s, view.bias_quanta(s.bias, s.bias_unit, s)),
                      s.fraction_bits)
        normals = None
        if self.keeps_normals():
            normals = self.normal_x, self.normal_y, self.normal_z
        return limit, scale, light_axes(view), normals

    def mask_of_sectors(self, views, first):
        numbers = range(first, first + 6)
        return sector_mask(self.observer_z, [self.of_light("light_z", k) for k in numbers],
                           SectorLights(self.observer, views, self.s), self.s,
                           dither_words(self.s), [self.receiver_words(k) for k in numbers])

    def make_ground_masks(self):
        """The ground is the floor, the last patch."""
        others, ground = self.world[:-1], self.world[-1]
        places = [p for patch in (*others, self.vertices) for p in patch]
        masks = ground_masks(self.as_drawn([ground]), self.as_drawn(others, self.mesh_facets),
                             ground, places, self.fraction, self.observer, self.lights, self.s,
                             plain_record, self.shading(), self.as_drawn(self.blobs))
        for k, mask in enumerate(masks):
            self.made["mask" + (str(k + 1) if k else "")] = mask

    def visible(self):
        return [code != self.s.background_code for code in self.observer_z]

    def make_darkness(self, source, number, _):
        first = sum(len(other.views) for other in self.sources[:source])
        n = 1 if self.sources[source].sectored else len(self.sources[source].views)
        masks = [self.of_light("mask", first + k) for k in range(n)]
        if self.sources[source].ramp:
            width = int(self.sources[source].ramp)
            masks[0] = ramp(masks[0], self.visible(), width, self.s.size_px)
        self.made["darkness" + number] = masks[0] if n == 1 else [
            (2 * sum(pixel) + n) // (2 * n) for pixel in zip(*masks)]

    def make_edges(self, source, number, _):
        darkness, passes = self.of_light("darkness", source), self.s.dequantize
        of = self.sources[source]
        graded = self.s.lookup == "percentage" or of.ramp or (len(of.views) > 1 and not of.sectored)
        if passes and not graded:
            darkness = dequantize(darkness, self.visible(), passes, self.s.size_px)
        self.made["edges" + number] = darkness

    def make_filtered(self, source, number, _):
        result = self.of_light("edges", source)
        for _ in range(self.s.low_pass):
            result = low_pass(result, self.visible(), self.s.size_px)
        self.made["filtered" + number] = result

    def make_picture(self, _, __, channel):
        result = getattr(self, "intensity" + channel)
        for k in range(len(self.sources) if self.s.form != "correct" else 0):
            direct = getattr(self, "direct" + (str(k + 1) if k else "") + channel)
            result = composite(result, direct, self.of_light("filtered", k), self.s)
        self.made["picture" + channel] = result

    def block_counts(self, name):
        """Section 6's rows of what has been drawn"""
        for which, c in self.counts.items():
            yield (f"| {name}, {which} | {len(self.patches)} | {c.tested} | {c.splits} | "
                   f"{c.drawn} | {c.samples} |")

    def bytes_a_value(self, buffer):
        if buffer.startswith("normal"):
            return 2
        return self.s.z_bytes if buffer.startswith(("observer_z", "light_z")) else 1


def figure_frames():
    """(name, frame, buffer) of the figures' buffers, and of masks by other arithmetic."""
    def frame(written, like=None):
        f = Frame("spheres", "front", "left", Settings(written, ambient=AMBIENT))
        if like:  # the two views are the same
            f.made.update((k, like.made[k]) for k in ("observer_z", "intensity", "direct",
                                                      "light_z"))
        return f
    three = frame("")
    for buffer in ("intensity", "direct", "observer_z", "light_z"):
        yield buffer, three, buffer
    yield "mask3", three, "mask"
    four = "lookup bilinear, bias 192, dither normal"
    six = frame(four + ", dequantize 1, low_pass 2", three)
    six.s.density = 218
    for name, buffer in (("mask4", "mask"), ("edges5", "edges"), ("filtered5", "filtered"),
                         ("picture6", "picture")):
        yield name, six, buffer
    for name, written in (("mask3_short", "accumulator_bits 22"),
                          ("mask3_shorter",
                           "accumulator_bits 16, product_rounding half_up, bias 100"),
                          ("mask3_ap120b", "arithmetic ap120b"),
                          ("mask4_ap120b", four + ", arithmetic ap120b")):
        yield name, frame(written, three), "mask"


def variants(text):
    """name, frame maker, buffers, and how many pixels it has, of each row of the table"""
    for name, patches, observer, light, written, buffers in table(
            text, "| variant | scene | observer |"):
        s = Settings(written, ambient=AMBIENT)
        yield name, (patches, observer, light, s), buffers.split(", "), s.size_px ** 2
