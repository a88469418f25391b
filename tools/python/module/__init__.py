"""The shadow machine of Lance Williams' "Casting Curved Shadows on Curved Surfaces" (SIGGRAPH 78),
in fixed point and bit for bit: the program umbra78 as a module.

    >>> import umbra78
    >>> frame = umbra78.render(umbra78.Scene.figures(), **umbra78.figure_settings(3))
    >>> frame.hashes["mask"]
    'u8:512x512:fnv1a64:d03c69f141bc1cec'
    >>> frame["mask"].shape, frame["mask"].dtype
    ((512, 512), dtype('uint8'))

Scenes, settings, messages and numbers are those of the program: `umbra78 settings --scene` lists
the keys. Numbers are read as decimals, exactly as they are printed; give a str or a Decimal for
more digits than a float has.
"""
import json as _json
import os as _os
import pathlib as _pathlib
from collections.abc import Mapping as _Mapping

import numpy as _np

from . import _core
from ._core import Error

__version__ = _core.version
__all__ = ["Error", "Frame", "Scene", "bias", "bias_of_map", "figure_settings", "plan", "render",
           "Shadow", "scenes", "settings", "shadow", "studies", "study", "trace"]


def _toml(value):
    """A value as TOML: numbers as they are printed, so that they are read exactly."""
    if isinstance(value, bool):
        raise TypeError("a scene has no true and false; write 'on' or 'off'")
    if isinstance(value, str):
        return _json.dumps(value)
    if isinstance(value, (list, tuple, _np.ndarray)):
        return "[" + ", ".join(_toml(each) for each in value) + "]"
    return str(value)


def _sets(settings, also):
    pairs = {**settings, **(also or {})}
    return [f"{key}={_override(value)}" for key, value in pairs.items()]


def _override(value):
    return value if isinstance(value, str) else _toml(value)


class Scene:
    """A scene: a scene file's text, which `text` holds.

    Scene(text)         from the text of a scene file
    Scene.file(path)    from a file
    Scene.figures()     the paper's four spheres
    Scene()             without anything; add() gives it tables
    """

    def __init__(self, text="", path="scene.toml"):
        """`path` names the scene in messages; its models count from the folder of `path`."""
        self._text, self.path = text, path

    @classmethod
    def file(cls, path):
        """The scene file at `path`. Raises Error if it is wrong."""
        read = _core.read_file(_os.fspath(path))
        return cls(read.text, read.path)

    @classmethod
    def figures(cls):
        """The scene of figures 1 to 6, with the settings of figure 6."""
        paper = _core.paper_scene()
        return cls(paper.text, paper.path)

    @property
    def text(self):
        """The scene file's text."""
        return self._text

    def add(self, table, **keys):
        """Adds a table, and returns the scene: add("sphere", centre=[0, 0, 0], radius=1).

        "observer" and "settings" stand once in a scene; all others are listed, lights among them.
        """
        once = table in ("observer", "settings")
        head = f"[{table}]" if once else f"[[{table}]]"
        lines = [f"{key} = {_toml(value)}" for key, value in keys.items()]
        self._text += "\n".join(["", head, *lines, ""])
        return self

    def _core(self):
        return _core.SceneText(self._text, self.path)

    def __repr__(self):
        return f"<umbra78.Scene {self.path!r}, {len(self._text.splitlines())} lines>"


class Frame(_Mapping):
    """A drawn frame: a mapping from a buffer's name to its array.

    The arrays are read-only views of the machine's own memory, and keep it alive: observer_z,
    light_z, intensity, direct, mask, edges, filtered, picture. Of a second light the name is
    "mask2", of a channel "picture_red".
    """

    def __init__(self, drawn):
        self._drawn = drawn
        self._buffers = _core.buffers(drawn)
        self._scaling = _core.scalings(drawn)
        self._report = None

    def __getitem__(self, name):
        return self._buffers[name]

    def __iter__(self):
        return iter(self._buffers)

    def __len__(self):
        return len(self._buffers)

    @property
    def scaling(self):
        """What each buffer's words mean: "unit", "max"; of Z codes "near", "far", "perspective"."""
        return self._scaling

    def depth(self, name="observer_z"):
        """A buffer of Z codes in world units, as near and far are measured; NaN: nothing drawn."""
        scale = self._scaling[name]
        if "near" not in scale:
            raise Error(f"{name} holds no Z codes; give observer_z, or light_z")
        codes = self[name]
        part = codes / (scale["max"] + 1.0)
        near, far = scale["near"], scale["far"]
        depth = near + part * (far - near)
        if scale["perspective"]:
            depth = near * far / (far - part * (far - near))
        return _np.where(codes == scale["max"], _np.nan, depth)

    @property
    def report(self):
        """All figures of `umbra78 render --json`, as a dict."""
        if self._report is None:
            self._report = _json.loads(_core.report(self._drawn))
        return self._report

    @property
    def hashes(self):
        """Each buffer's hash, as the goldens have it."""
        return self.report["hashes"]

    @property
    def error(self):
        """How far the mask is from exact geometry; None where there is no truth."""
        return self.report["error"]

    @property
    def cycles(self):
        """The whole frame's cycles on the machine, its units side by side."""
        of_lights = self.report.get("lights")
        if of_lights:
            return of_lights["frame_cycles"]
        return self.report["machine"]["frame_cycles"]["side_by_side"]

    @property
    def warnings(self):
        """What the frame lacks, a line each."""
        return [warning["line"] for warning in self.report["warnings"]]

    def truth(self, light=0):
        """Exact geometry: arrays "visible", "lit", "depth" and "unlit_side"; None without truth."""
        return _core.truth(self._drawn, light)

    def __repr__(self):
        size = self.report["size_px"]
        return f"<umbra78.Frame, {size} x {size} pixels: {', '.join(self)}>"


def render(scene, *, truth=True, threads=1, set=None, **settings):
    """Draws a scene and returns its Frame.

    Settings are keyword arguments: render(scene, lookup="nearest", bias=64). Keys with a point go
    into `set`: set={"light.azimuth": 30}. Without `truth` no errors are computed. `threads` draw
    the frame, 0: one for each processor; it is the same with any number. Raises Error.
    """
    if not 0 <= threads <= 64:
        raise ValueError(f"threads={threads}: give 1 to 64, or 0 for one for each processor")
    return Frame(_core.draw(scene._core(), _sets(settings, set), truth, threads))


def plan(scene, *, set=None, **settings):
    """What the frame needs and what is left out, why, and the cycles saved: a dict."""
    return _json.loads(_core.plan(scene._core(), _sets(settings, set)))


def trace(scene, x, y, *, set=None, **settings):
    """A pixel's whole way through the machine: a dict, whose "lines" hold a word each."""
    return _json.loads(_core.trace(scene._core(), _sets(settings, set), x, y))


def bias(scene, *, set=None, **settings):
    """The least bias of a scene, its detachment, and its value for interfaces and engines: a dict.

    As `umbra78 bias SCENE --json`: "least" by kind, "units" with a row a parameter.
    """
    return _json.loads(_core.bias(scene._core(), _sets(settings, set)))


def bias_of_map(map, extent, range, slope, *, reversed=False, **options):
    """The same of a depth map of `map` texels a side, as `umbra78 bias --map ...` takes it.

    `options`: depth ("d16", "d24", "d32f"), filter ("nearest", "bilinear", "pcf3", "pcf5"),
    azimuth, z, pixel.
    """
    known = {"depth", "filter", "azimuth", "z", "pixel"}
    for name in options:
        if name not in known:
            raise TypeError(f"bias_of_map has no {name!r}; known here: {', '.join(sorted(known))}")
    given = {"extent": extent, "range": range, "slope": slope, **options}
    return _json.loads(_core.bias_of_map(map, {k: _override(v) for k, v in given.items()},
                                         reversed))


class Shadow:
    """The answer of shadow(): arrays of the observer's buffer, row 0 at the top.

    mask      uint8, 255 in shadow
    error     1 false shadow, -1 false light, else 0; against truth, or an estimate of it
    spectrum  of the false shadow where there is most of it, in the order of numpy.fft.fft2; empty
              if there is too little
    report    all of `umbra78 shadow --json`: "error", "spectrum", "least_bias", "trace", ...
    """

    def __init__(self, report, mask, error, spectrum):
        self.report = _json.loads(report)
        self.mask, self.error, self.spectrum = mask, error, spectrum

    def __repr__(self):
        rate = self.report["error"]["false_shadow"]
        return f"<umbra78.Shadow, {self.mask.shape[1]} x {self.mask.shape[0]}: {rate:.2%} false>"


_KINDS = {"u1": 0, "u2": 1, "u4": 2, "f4": 3, "f8": 4}


def shadow(observer_depth, light_depth, matrix, *, depth_format="d32f", convention="d3d",
           truth=None, truth_bright=False, pixel=None, least_bias=False, y_up=None,
           z_from_minus_one=None, first_row_on_top=None, row_vectors=None, **settings):
    """Runs the shadow test on two captured depth buffers and returns a Shadow.

    `matrix` (16 numbers or 4 x 4) takes (x, y, z, 1) in the observer's device coordinates, z being
    the depth as it is stored, to the light's clip coordinates, as M @ p: the light's
    view-projection times the inverse of the observer's. depth_format: "codes", "d16", "d24",
    "d32f", or one of the last three with "_reversed". convention: "d3d" (y up, z 0 .. 1, row 0 at
    the top), "vulkan" (y down) or "opengl" (y up, z -1 .. 1, row 0 at the bottom); y_up,
    z_from_minus_one, first_row_on_top and row_vectors (p @ M) change a part of it. pixel=(x, y)
    adds that pixel's trace, least_bias the search. Raises Error.
    """
    asked = _core.Captured()
    for name, given in ("observer_depth", observer_depth), ("light_depth", light_depth), \
                       ("truth", truth):
        if given is None:
            continue
        array = _np.asarray(given)
        kind = "u1" if array.dtype == bool else array.dtype.str[1:]
        if array.ndim != 2 or array.size == 0 or kind not in _KINDS:
            raise Error(f"{name} is an array of {array.ndim} dimensions of {array.dtype}; give "
                        "two, height and width, of uint8, uint16, uint32, float32 or float64")
        asked.take(name, array * 255 if array.dtype == bool else array, _KINDS[kind])
    also = {"y_up": y_up, "z_from_minus_one": z_from_minus_one,
            "first_row_on_top": first_row_on_top, "row_vectors": row_vectors}
    numbers = [float(each) for each in _np.asarray(matrix, dtype=float).ravel()]
    if len(numbers) != 16:
        raise Error(f"matrix has {len(numbers)} numbers; give 16, row by row")
    asked.means(numbers, depth_format, convention,
                {name: bool(value) for name, value in also.items() if value is not None})
    asked.use(_sets(settings, None))
    asked.truth_bright, asked.least_bias = truth_bright, least_bias
    if pixel is not None:
        asked.trace(*pixel)
    return Shadow(*_core.shadow(asked))


def study(name, scene=None, *, vary=None, quick=False, automatic=False, jobs=0):
    """Runs a study and returns its rows, a dict each.

    `vary` maps keys to their values, a list, or a text "first:last:step". Without a scene it is the
    paper's. `jobs` cases are drawn at a time; 0: as many as there are cores.
    """
    texts = [f"{key}={values if isinstance(values, str) else ','.join(map(_override, values))}"
             for key, values in (vary or {}).items()]
    rows = _core.study(name, scene._core() if scene else None, texts, quick, automatic, jobs)
    return _json.loads(rows)


def studies():
    """The studies: "study" and "meaning" of each."""
    return _json.loads(_core.studies())


def settings():
    """The table of settings and profiles, as `umbra78 settings --json` prints it."""
    return _json.loads(_core.settings())


def figure_settings(figure):
    """The settings of the paper's figure 1 to 6, for render() and the others."""
    return _json.loads(_core.figure_settings(figure))


def scenes():
    """The folder of the scenes that came with umbra78."""
    for above in _pathlib.Path(__file__).absolute().parents:
        folder = above / "share" / "umbra78" / "scenes"
        if folder.is_dir():
            return folder
    raise Error("cannot find the scenes that came with umbra78; install the whole package")
