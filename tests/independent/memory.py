#!/usr/bin/env python3
"""Section 17 of hw/MACHINE.md once more, in Python: the figures' ledgers of memory accesses.

The frame is the published one (tests/goldens/observer_z.pgm, held by its hash); what memory does
with it is stages/memory.py.

    python3 memory.py [--machine PATH]

prints the ledgers' rows and exits with 1 if one is not in the document.  It takes some ten seconds.
"""
import argparse
import pathlib
import re
import sys

from stages.figures import scene, view
from stages.memory import N, frame, tokens
from stages.noise import dither_words
from stages.notation import published_hash
from stages.settings import HW, Settings, document
from stages.shadow_test import LightMap
from stages.transform_unit import ScreenUnit
from stages.views import shadow_matrix


def main():
    here = pathlib.Path(__file__).parent
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--machine", type=pathlib.Path, help="hw/MACHINE.md",
                        default=HW / "MACHINE.md")
    text = document(parser.parse_args().machine)
    data = (here / "../goldens/observer_z.pgm").read_bytes()[-2 * N * N:]
    observer_z = [data[k] << 8 | data[k + 1] for k in range(0, len(data), 2)]
    if published_hash(observer_z, 2, N) not in text:
        print("observer_z.pgm is not the published buffer")
        return 1
    good = True
    patches = scene("spheres")
    for figure, banks, longest_stay, written in (
            (3, 1, 3, ""), (4, 1, 4, "lookup bilinear, bias 192, dither normal"),
            (4, 4, 3, "lookup bilinear, bias 192, dither normal")):
        s = Settings(written)
        matrix = shadow_matrix(view("front", patches), view("left", patches), s)
        seen = list(tokens(observer_z, LightMap([], s), ScreenUnit(matrix, s), dither_words(s)))
        stores, total = frame(seen, longest_stay, banks, False)
        _, ideal = frame(seen, longest_stay, banks, True)
        row = "| {} | {} | {} | {} | {} | {} | {} | {} |".format(
            figure, banks, longest_stay, ", ".join(str(c.misses) for c in stores),
            ", ".join(str(c.changes) for c in stores), sum(c.latency for c in stores), total, ideal)
        same = re.search("^" + re.escape(row) + "$", text, re.MULTILINE) is not None
        good = good and same
        print(row + ("" if same else "  DIFFERS"), flush=True)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
