"""The figures' scene, the variants and their frames (section 15)."""
from .ap120b import array_mask
from .dicing import diced, tolerance
from .filters import composite, dequantize, low_pass
from .noise import dither_words
from .settings import Settings, table
from .shading import Shading
from .shadow_test import correct_record, plain_record, post_process
from .store import draw
from .views import View, axes_from_angles, axes_from_points, shadow_matrix
from .words import object_place, object_words, plane, sphere

SPHERES = ((-68813, 39322, 0), (62259, 77332, 19661), (-49152, -73400, 13107),
           (68813, -27525, 29491))
FLOOR = ((-196608, -127795, 196608), (393216, 0, 0), (0, 0, -393216))
MATERIAL = (215, 90, 5)
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


def view(name, patches):
    axes, extent, distance, depths = {
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
    return View(axes, extent, distance, depths, patches=patches)


class Frame:
    """A frame's buffers, each made when it is asked for."""

    def __init__(self, scene_name, observer, light, s):
        vertices, facets = mesh(scene_name)
        world = [*scene(scene_name), vertices]  # lists of places
        self.s, ((*self.patches, vertices), self.fraction) = s, object_words(world)
        self.facets = [([vertices[k] for k in three], normals) for three, normals in facets]
        self.observer, self.light = view(observer, world), view(light, world)
        if s.surface == "diced":
            word, self.patches = tolerance(self.observer.extent_word, s), []
            self.facets = [([object_place(p, self.fraction) for p in points], normals)
                           for patch in world[:-1] for points, normals in diced(patch, word, s)
                           ] + self.facets
        self.made, self.counts = {}, {}

    def __getattr__(self, buffer):
        if buffer not in self.made:
            getattr(self, "make_" + buffer)()
        return self.made[buffer]

    def make_light_z(self):
        self.made["light_z"], _, self.counts["light"] = draw(
            self.patches, self.facets, self.fraction, self.light, self.s)

    def matrix(self):
        return shadow_matrix(self.observer, self.light, self.s)

    def make_observer_z(self):
        s, correct = self.s, self.s.form == "correct"
        record = (correct_record(self.light_z, self.matrix(), s, dither_words(s)) if correct
                  else plain_record)
        shading = Shading(self.observer, self.light, self.fraction, s.ambient, MATERIAL)
        planes, rest, self.counts["observer"] = draw(
            self.patches, self.facets, self.fraction, self.observer, s, record, shading)
        self.made["observer_z"] = planes
        self.made["intensity"], self.made["direct"], *mask = rest
        if correct:
            self.made["mask"] = mask[0]
    make_intensity = make_direct = make_observer_z

    def make_mask(self):
        s = self.s
        if s.form == "correct":
            self.make_observer_z()
            return
        given = self.observer_z, self.light_z, self.matrix(), s, dither_words(s)
        if s.arithmetic == "ap120b":
            self.made["mask"] = array_mask(*given)
            return
        clamp = self.light.bias_quanta(s.bias_clamp, s.bias_unit, s)
        self.made["mask"] = post_process(*given, clamp >> 16 if s.bias_clamp else None)

    def visible(self):
        return [code != self.s.background_code for code in self.observer_z]

    def make_edges(self):
        self.made["edges"] = (dequantize(self.mask, self.visible(), self.s.dequantize,
                                         self.s.size_px) if self.s.dequantize else self.mask)

    def make_filtered(self):
        result = self.edges
        for _ in range(self.s.low_pass):
            result = low_pass(result, self.visible(), self.s.size_px)
        self.made["filtered"] = result

    def make_picture(self):
        self.made["picture"] = (self.intensity if self.s.form == "correct" else
                                composite(self.intensity, self.direct, self.filtered, self.s))

    def block_counts(self, name):
        """Section 6's rows of what has been drawn"""
        for which, c in self.counts.items():
            yield (f"| {name}, {which} | {len(self.patches)} | {c.tested} | {c.splits} | "
                   f"{c.drawn} | {c.samples} |")

    def bytes_a_value(self, buffer):
        return self.s.z_bytes if buffer in ("observer_z", "light_z") else 1


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
