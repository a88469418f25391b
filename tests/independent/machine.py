#!/usr/bin/env python3
"""A second, independent implementation of the machine, for the figures only.

It was written from MACHINE.md alone, by someone who had not seen the project's code (except for
section 18, whose author had), to find out whether that document suffices.  It draws the observer's
and the light's view of section 15's scene, computes the buffers of the figures and compares their
hashes with those MACHINE.md lists.
Only what the figures use is here: orthographic views, the machine of 1978, the default settings.
Its sections are the document's, beside which it should be read: words.py, drawing.py, shadows.py,
ap120b.py, and the figures here.  It takes about half a minute.

    python3 machine.py [--buffers DIR] [--machine PATH]

prints the name and hash of each buffer and exits with 1 if one differs.
"""
import argparse
import pathlib
import re
import sys

from words import (BACKGROUND, View, half_up, object_words, observer_to_light, published_hash,
                   sphere, to_bytes)
from drawing import Shading, draw
from shadows import bilinear, composite, dequantize, dither_words, low_pass, nearest, shadow_mask
from ap120b import array_bilinear, array_mask, array_nearest

# -- 15. The figures ------------------------------------------------------------------------------

SPHERES = ((-68813, 39322, 0), (62259, 77332, 19661), (-49152, -73400, 13107),
           (68813, -27525, 29491))


def scene():
    return object_words([patch for centre in SPHERES for patch in sphere(centre, 47186)])


def figures():
    """(name, bytes a value, values) of each buffer"""
    patches, f = scene()
    observer, light = (View(azimuth, 0, (0, 0, 0), 131072, -131072, 131072)
                       for azimuth in (0, -100))
    observer_z, intensity = draw(patches, f, observer, Shading(observer, light, 90, 215, 90, 5))
    yield "intensity", 1, intensity
    yield "observer_z", 2, observer_z
    light_z, _ = draw(patches, f, light)
    yield "light_z", 2, light_z
    mask3 = shadow_mask(observer_z, light_z, observer_to_light(observer, light, 64), nearest)
    yield "mask3", 1, mask3
    yield "mask3_short", 1, shadow_mask(observer_z, light_z,
                                        observer_to_light(observer, light, 64), nearest,
                                        accumulator=22)
    yield "mask3_shorter", 1, shadow_mask(observer_z, light_z,
                                          observer_to_light(observer, light, 100), nearest,
                                          accumulator=16, near=True)
    yield "mask3_ap120b", 1, array_mask(observer_z, light_z,
                                        observer_to_light(observer, light, 64), array_nearest)
    noise = dither_words(0x12345678, 12, 256)
    mask4 = shadow_mask(observer_z, light_z, observer_to_light(observer, light, 192), bilinear,
                        noise)
    yield "mask4", 1, mask4
    yield "mask4_ap120b", 1, array_mask(observer_z, light_z,
                                        observer_to_light(observer, light, 192), array_bilinear,
                                        noise)
    edges = dequantize(mask4, observer_z, 4)
    yield "edges5", 1, edges
    filtered = low_pass(edges, observer_z)
    yield "filtered5", 1, filtered
    # Where something is drawn the figures' ambient share is the same everywhere.
    ambient = half_up(215 * 90 << 14, 1 << 22)
    direct = [i - ambient if c != BACKGROUND else 0 for i, c in zip(intensity, observer_z)]
    yield "direct", 1, direct
    yield "picture6", 1, composite(intensity, direct, filtered, 218)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--buffers", type=pathlib.Path, help="write the buffers into this folder")
    parser.add_argument("--machine", type=pathlib.Path, help="MACHINE.md",
                        default=pathlib.Path(__file__).parent / "../../hw/MACHINE.md")
    options = parser.parse_args()
    # The figures' rows have three columns before the buffer's name, the variants' one.
    row = r"^\|[^|]*\|[^|]*\|[^|]*\| (\w+) \| `(\w+:\d+x\d+:fnv1a64:[0-9a-f]{16})` \|"
    files = [options.machine, *(options.machine.parent / "machine").glob("*.md")]
    text = "".join(file.read_text(encoding="utf-8") for file in files)
    published = dict(re.findall(row, text, re.MULTILINE))
    good = True
    for name, size, values in figures():
        found = published_hash(values, size)
        same = found == published.pop(name, None)
        good = good and same
        print(f"{name:12} {found}{'' if same else '  DIFFERS'}", flush=True)
        if options.buffers:
            options.buffers.mkdir(parents=True, exist_ok=True)
            (options.buffers / f"{name}.{found.split(':')[0]}").write_bytes(to_bytes(values, size))
    for name in published:
        print(f"{name:12} is not computed here")
    return 0 if good and not published else 1


if __name__ == "__main__":
    sys.exit(main())
