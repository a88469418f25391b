"""The module for Python, against the goldens, the program and the keys of its own stubs."""
import ast
import gc
import inspect
import json
import os
import pathlib
import subprocess
import sys
import threading
import time
from decimal import Decimal

import numpy as np
import pytest
import umbra78

ROOT = pathlib.Path(__file__).resolve().parents[3]
PROGRAM = os.environ["UMBRA78_PROGRAM"]
GOLDENS = dict(line.split() for line in (ROOT / "tests/goldens/hashes.txt").open())


def program(*arguments, fails=False):
    ran = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True)
    assert (ran.returncode != 0) == fails, ran.stderr
    return ran.stderr if fails else ran.stdout


def fnv(array):
    """FNV-1a-64 over the words, high byte first: the goldens' hash, from the array itself."""
    value = 0xcbf29ce484222325
    for byte in array.astype(array.dtype.newbyteorder(">")).tobytes():
        value = (value ^ byte) * 0x100000001b3 & 0xffffffffffffffff
    return f"{value:016x}"


@pytest.fixture(scope="module")
def figure3():
    return umbra78.render(umbra78.Scene.figures(), **umbra78.figure_settings(3))


@pytest.fixture(scope="module")
def figure6():
    return umbra78.render(umbra78.Scene.figures(), **umbra78.figure_settings(6))


def test_figures_are_the_goldens(figure3, figure6):
    figure4 = umbra78.render(umbra78.Scene.figures(), truth=False, **umbra78.figure_settings(4))
    assert figure4.hashes["mask"] == GOLDENS["mask4"]
    assert figure3.hashes["mask"] == GOLDENS["mask3"]
    for frame in figure3, figure6:
        for name in "observer_z", "light_z", "intensity":
            assert frame.hashes[name] == GOLDENS[name]
    for name in "edges", "filtered":
        assert figure6.hashes[name] == GOLDENS[name + "5"]
    assert figure6.hashes["picture"] == GOLDENS["picture6"]


def test_the_arrays_are_what_is_hashed(figure3):
    for name in "mask", "light_z":
        assert figure3.hashes[name].endswith(fnv(figure3[name]))
    assert figure3["light_z"].dtype == np.uint16
    assert figure3["mask"].shape == (512, 512)


@pytest.mark.parametrize("file, golden", [("smile.toml", "fig7b"), ("robot.toml", "fig8")])
def test_figures_7_and_8(file, golden):
    frame = umbra78.render(umbra78.Scene.file(umbra78.scenes() / file), truth=False)
    assert frame.hashes["picture"] == GOLDENS[golden]


def test_arrays_are_views_that_outlive_the_frame():
    frame = umbra78.render(umbra78.Scene.figures(), truth=False, xy_bits=7)
    mask, picture = frame["mask"], frame["picture"]
    assert not mask.flags.owndata and not mask.flags.writeable and mask.base is not None
    assert frame["mask"] is mask
    before = picture.copy()
    del frame
    gc.collect()
    umbra78.render(umbra78.Scene.figures(), truth=False, xy_bits=7, bias=0)
    assert (picture == before).all()
    with pytest.raises(ValueError):
        mask[0, 0] = 1


def test_depths_are_in_world_units(figure3):
    for name in "observer_z", "light_z":
        codes, depth = figure3[name], figure3.depth(name)
        assert (np.isnan(depth) == (codes == 65535)).all()
        assert np.nanmin(depth) > -2 and np.nanmax(depth) < 2
    truth = figure3.truth()
    both = (truth["visible"] == 1) & ~np.isnan(figure3.depth())
    quantum = 4 / 65536
    assert np.median(np.abs(figure3.depth() - truth["depth"])[both]) < quantum
    with pytest.raises(umbra78.Error, match="mask holds no Z codes; give observer_z"):
        figure3.depth("mask")


def test_depths_of_a_lamp_in_perspective():
    frame = umbra78.render(umbra78.Scene.file(umbra78.scenes() / "lamp.toml"))
    assert frame.scaling["light_z"]["perspective"]
    truth, depth = frame.truth(), frame.depth("observer_z")
    both = (truth["visible"] == 1) & ~np.isnan(depth)
    assert np.median(np.abs(depth - truth["depth"])[both]) < 1e-3


def test_the_report_is_the_programs(figure6, tmp_path):
    printed = json.loads(program("render", str(umbra78.scenes() / "figures.toml"), "--json",
                                 "--out", str(tmp_path / "a.png")))
    for key in printed.keys() - {"scene", "picture", "host_ms", "peak_bytes"}:
        assert figure6.report[key] == printed[key], key
    assert figure6.error == printed["error"]
    assert figure6.cycles == printed["machine"]["frame_cycles"]["side_by_side"]


def test_a_scene_built_in_python_is_that_of_its_text():
    built = umbra78.Scene()
    built.add("observer", extent=2, recentre="off", target=[0, 0, 0])
    built.add("light", azimuth=-100, extent=2, target=(0, 0, 0))
    built.add("material", name="clay", diffuse=215, specular=90, shininess=5)
    for centre in ["-1.05", "0.60", "0.00"], [0.95, 1.18, 0.30], (-0.75, -1.12, 0.2), \
            np.array([1.05, -0.42, 0.45]):
        built.add("sphere", centre=[Decimal(str(each)) for each in centre],
                  radius=Decimal("0.72"), material="clay")
    frame = umbra78.render(built, truth=False, **umbra78.figure_settings(6))
    assert frame.hashes["picture"] == GOLDENS["picture6"]


def test_several_lights_and_colour():
    frame = umbra78.render(umbra78.Scene.file(umbra78.scenes() / "three_lights.toml"), truth=False)
    for colour in "red", "green", "blue":
        assert frame.hashes[f"picture_{colour}"] == GOLDENS[f"three_lights_{colour}"]
    assert frame["mask3"].shape == (512, 512)
    assert frame.cycles == frame.report["lights"]["frame_cycles"]


@pytest.mark.parametrize("arguments, command", [
    ({"xy_bits": 64}, ["--set", "xy_bits=64"]),
    ({"lookup": "linear"}, ["--set", "lookup=linear"]),
    ({"look": "nearest"}, ["--set", "look=nearest"]),
    ({"set": {"light.azimut": 3}}, ["--set", "light.azimut=3"]),
])
def test_errors_are_the_programs(arguments, command, tmp_path):
    path = str(umbra78.scenes() / "figures.toml")
    said = program("render", path, *command, "--out", str(tmp_path / "a.png"), fails=True)
    with pytest.raises(umbra78.Error) as error:
        umbra78.render(umbra78.Scene.file(path), **arguments)
    assert f"umbra78: {error.value}\n" == said


def test_errors_of_scenes():
    with pytest.raises(umbra78.Error, match="none.toml': No such file"):
        umbra78.Scene.file("none.toml")
    wrong = umbra78.Scene("[light]\nazimuth = -100\n[[sphere]]\ncentre = [0,0,0]\nradios = 1\n",
                          "mine.toml")
    with pytest.raises(umbra78.Error, match="mine.toml:5: unknown key 'radios'.*did you mean"):
        umbra78.render(wrong)
    with pytest.raises(umbra78.Error, match=r"hills.toml:\d+: a scene with a \[stream\] is drawn "
                                            "by umbra78 render alone"):
        umbra78.Scene.file(umbra78.scenes() / "hills.toml")
    with pytest.raises(umbra78.Error, match="no figure 7"):
        umbra78.figure_settings(7)
    with pytest.raises(TypeError, match="no true and false"):
        umbra78.Scene().add("plane", ground=True)


def test_trace_and_plan_are_the_programs():
    path = str(umbra78.scenes() / "figures.toml")
    traced = umbra78.trace(umbra78.Scene.file(path), 80, 180, lookup="nearest")
    printed = json.loads(program("trace", path, "--pixel", "80,180", "--set", "lookup=nearest",
                                 "--json"))
    del printed["scene"], printed["settings"]
    assert traced == printed
    planned = umbra78.plan(umbra78.Scene.file(path), dither="none")
    printed = json.loads(program("plan", path, "--set", "dither=none", "--json"))
    assert {"scene": path, **planned} == printed
    rival = umbra78.trace(umbra78.Scene.figures(), 320, 250, form="volumes")
    assert rival["state"] in ("lit", "cast shadow", "attached shadow")
    with pytest.raises(umbra78.Error, match="600"):
        umbra78.trace(umbra78.Scene.figures(), 600, 0)


def test_bias_is_the_programs():
    path = str(umbra78.scenes() / "figures.toml")
    of_scene = umbra78.bias(umbra78.Scene.file(path), lookup="nearest", xy_bits=7)
    assert of_scene == json.loads(program("bias", path, "--set", "lookup=nearest", "--set",
                                          "xy_bits=7", "--json"))
    of_map = umbra78.bias_of_map(2048, 20, 50, 60, filter="pcf3", azimuth=0, depth="d24")
    assert of_map == json.loads(program(*"bias --map 2048 --extent 20 --range 50 --slope 60 "
                                         "--filter pcf3 --azimuth 0 --depth d24 --json".split()))
    with pytest.raises(umbra78.Error, match="'d15' is no depth format; give d16, d24 or d32f"):
        umbra78.bias_of_map(2048, 20, 50, 60, depth="d15")
    with pytest.raises(TypeError, match="no 'dept'"):
        umbra78.bias_of_map(2048, 20, 50, 60, dept="d16")


def test_study_rows(tmp_path):
    vary = {"bias": "0.5:1:0.5", "bias_unit": ["texels"], "xy_bits": [7]}
    rows = umbra78.study("error-time", quick=True, vary=vary, jobs=2)
    texts = [f"{key}={value if isinstance(value, str) else ','.join(map(str, value))}"
             for key, value in vary.items()]
    program("study", "error-time", "--quick", "--out", str(tmp_path / "s"),
            *[word for text in texts for word in ("--vary", text)])
    lines = (tmp_path / "s/error-time.csv").read_text().splitlines()
    assert len(rows) == len(lines) - 1 and len(rows) >= 2
    assert {row["status"] for row in rows} == {"ok"}
    assert list(rows[0]) == lines[0].split(",")
    with pytest.raises(RuntimeError, match="bia"):
        umbra78.study("bia")
    assert "bias" in [each["study"] for each in umbra78.studies()]


def test_other_threads_run_while_a_frame_is_drawn():
    switches, done = 0, threading.Event()

    def draw():
        umbra78.render(umbra78.Scene.figures())
        done.set()

    thread = threading.Thread(target=draw)
    longest, last = 0.0, time.perf_counter()
    thread.start()
    while not done.is_set():
        switches += 1
        now = time.perf_counter()
        longest, last = max(longest, now - last), now
        time.sleep(0.001)
    thread.join()
    assert switches > 20, "the interpreter's lock is held while a frame is drawn"


def test_threads_draw_the_same():
    hashes = [None] * 4

    def draw(k):
        hashes[k] = umbra78.render(umbra78.Scene.figures(), truth=False).hashes["picture"]

    threads = [threading.Thread(target=draw, args=(k,)) for k in range(4)]
    for each in threads:
        each.start()
    for each in threads:
        each.join()
    assert set(hashes) == {GOLDENS["picture6"]}


def test_settings_are_the_programs():
    assert umbra78.settings() == json.loads(program("settings", "--json"))
    assert umbra78.__version__ == program("--version").split()[1]


def test_stubs_and_docstrings_cover_the_module():
    stub = ast.parse((ROOT / "tools/python/module/__init__.pyi").read_text())
    stubbed = {node.name: node for node in stub.body
               if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
    for name in umbra78.__all__:
        assert name in stubbed, name
        thing = getattr(umbra78, name)
        assert name == "Error" or inspect.getdoc(thing), name
        if inspect.isfunction(thing):
            arguments = stubbed[name].args
            names = [a.arg for a in arguments.args + arguments.kwonlyargs]
            names += [arguments.kwarg.arg] if arguments.kwarg else []
            assert sorted(names) == sorted(inspect.signature(thing).parameters), name
        elif name != "Error":
            methods = {n.name for n in stubbed[name].body if isinstance(n, ast.FunctionDef)}
            own = {k for k in vars(thing) if not k.startswith("_")}
            assert own <= methods, own - methods
            for method in own:
                assert inspect.getdoc(getattr(thing, method)), f"{name}.{method}"


def test_the_example_draws_the_moire():
    example = ROOT / "tools/python/figures.py"
    ran = subprocess.run([sys.executable, str(example)], capture_output=True, text=True)
    assert ran.returncode == 0, ran.stderr
    assert GOLDENS["mask3"] in ran.stdout
    flatness = float(ran.stdout.split("flatness ")[1].split(";")[0])
    assert flatness < 0.3, ran.stdout  # white noise has 0.56
    assert pathlib.Path("spectrum3.pgm").read_bytes().startswith(b"P5 32 32 255")


# The figures' light about the vertical axis, between device coordinates with z 0 .. 1.
FIGURE_MATRIX = [[-0.17364817764610052, 0, -1.9696155060082674, 0.98480775300413370],
                 [0, 1, 0, 0],
                 [0.49240387650206685, 0, -0.17364817764610052, 0.58682408882305026],
                 [0, 0, 0, 1]]


def test_captured_arrays_give_the_figures_mask(figure3):
    given = dict(depth_format="codes", bias=64, coefficient_bits=16)
    found = umbra78.shadow(figure3["observer_z"], figure3["light_z"], FIGURE_MATRIX, **given,
                           pixel=(115, 180), least_bias=True)
    assert np.array_equal(found.mask, figure3["mask"])
    assert found.report["hashes"]["mask"] == GOLDENS["mask3"]
    assert found.report["trace"]["mask"] == found.mask[180, 115]
    assert 64 < found.report["least_bias"]["quanta"] < 2000
    lit = figure3.truth()["lit"]
    judged = umbra78.shadow(figure3["observer_z"], figure3["light_z"],
                            np.array(FIGURE_MATRIX).T, row_vectors=True, **given, truth=lit == 0)
    assert not judged.report["error"]["estimated"]
    assert judged.report["error"]["false_shadow"] == pytest.approx(0.2387, abs=0.002)
    assert (judged.error == 1).sum() == judged.report["error"]["false_shadow_pixels"]


def test_captured_arrays_are_refused_in_one_line():
    depth = np.full((8, 8), 0.5, np.float32)
    for wrong, message in [
            (dict(depth_format="d15"), "'d15' is no depth format"),
            (dict(convention="glide"), "'glide' is no convention"),
            (dict(low_pass=1), "low_pass is no setting of the shadow test"),
            (dict(truth=depth[:4]), "truth has 8 x 4 numbers")]:
        with pytest.raises(umbra78.Error, match=message):
            umbra78.shadow(depth, depth, np.eye(4), **wrong)
    with pytest.raises(umbra78.Error, match="observer_depth: x 0, y 0 is nan"):
        umbra78.shadow(depth * np.nan, depth, np.eye(4))
    with pytest.raises(umbra78.Error, match="matrix has 9 numbers"):
        umbra78.shadow(depth, depth, np.eye(3))
    with pytest.raises(umbra78.Error, match="light_depth is an array of 1 dimensions of int64"):
        umbra78.shadow(depth, np.arange(3), np.eye(4))
