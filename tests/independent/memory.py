#!/usr/bin/env python3
"""Section 17 of MACHINE.md once more, in Python: the figures' ledgers of memory accesses.

The frame is the published one (tests/goldens/observer_z.pgm, held by its hash), the transform and
the dither are those of words.py and shadows.py; chips, stolen cycles and the recurrence are
written here from the text.

    python3 memory.py [--machine PATH]

prints the ledgers' rows and exits with 1 if one is not in MACHINE.md.  It takes some ten seconds.
"""
import argparse
import heapq
import pathlib
import re
import sys

from shadows import dither_words
from words import (BACKGROUND, F, H, I, MIDDLE, N, ONE, TransformUnit, View, Z, observer_to_light,
                   published_hash)

CLOCK = 200
ACCESS, CYCLE, COLUMN, PAGE, LONGEST = 200, 375, 135, 225, 10_000
RECOVERY, GAP = CYCLE - ACCESS, PAGE - COLUMN
P = max(16, N * N >> 14)


def video():
    """The moments at which a shown store is asked for a word; 0 sorts before the refresh's 1."""
    line = 0
    while True:
        for k in range(N // P):
            yield line * 63_500 + k * 52_000 // (N // P), 0
        line += 1


def refresh():
    k = 0
    while True:
        k += 1
        yield k * 2_000_000 // 128, 1


class Chips:
    """A store: banks of [open row or None, opened at, ready at]."""

    def __init__(self, banks=1, shown=False):
        self.banks = [[None, 0, 0] for _ in range(banks)]
        self.stolen = heapq.merge(*([video()] if shown else []), refresh())
        self.due = next(self.stolen)[0]
        self.misses = self.changes = self.latency = self.accesses = 0

    def place(self, x, y):
        if len(self.banks) == 1:
            return 0, (y * N + x) // P // 128
        return 2 * (y % 2) + x % 2, (y // 2 * (N // 2) + x // 2) // (P // 4) // 128

    def start(self, places, at):
        first = at
        for b, row in places:
            held, opened, ready = self.banks[b]
            column = max(at, ready + GAP)
            hit = held == row and column + COLUMN <= opened + LONGEST
            first = max(first, column if hit else ready)
        return first

    def request(self, texels, at):
        places = [self.place(*t) for t in texels]
        while self.due <= (s := self.start(places, at)):
            begin = max([self.due] + [ready for _, _, ready in self.banks])
            if any(row is not None for row, _, _ in self.banks):
                begin += RECOVERY
            self.banks = [[None, 0, begin + CYCLE] for _ in self.banks]
            self.due = next(self.stolen)[0]
        done = s
        for b, row in places:
            held, opened, ready = self.banks[b]
            self.accesses += 1
            if held == row and s >= ready + GAP and s + COLUMN <= opened + LONGEST:
                data = s + COLUMN
            else:
                self.misses += 1
                self.changes += held is not None
                opened = s + (RECOVERY if held is not None else 0)
                data = opened + ACCESS
            self.banks[b] = [row, opened, data]
            done = max(done, data)
        self.latency += done - at
        return done


def up(ns):
    return max(1, -(-ns // CLOCK)) * CLOCK


def tokens(observer_z, bias, four, dither):
    """(x, y, visible, texels) of every pixel in scan order."""
    view, light = (View(a, 0, (0, 0, 0), 131072, -131072, 131072) for a in (0, -100))
    unit = TransformUnit(observer_to_light(view, light, bias), I, ONE)
    for p, c in enumerate(observer_z):
        py, px = divmod(p, N)
        if c == BACKGROUND:
            yield px, py, False, []
            continue
        words = [(2 * (q - H) + 1) << (I - 1) for q in (px, py)] + [(c - MIDDLE) << (I - Z)]
        x, y, depth = unit(words, (F, F, Z))
        if dither:
            x, y = x + dither[p][0], y + dither[p][1]
        texels = []
        if -H << F <= x < H << F and -H << F <= y < H << F and 0 <= depth + MIDDLE < BACKGROUND:
            back = 1 << (F - 1) if four else 0
            tx, ty = ((x - back) >> F) + H, ((y - back) >> F) + H
            texels = [(tx + i, ty + j) for j in range(1 + four) for i in range(1 + four)
                      if 0 <= tx + i < N and 0 <= ty + j < N]
        yield px, py, True, texels


def frame(frame_tokens, s, banks, ideal):
    """The stores, and when the last token has left the last stage."""
    observer, light, mask = Chips(shown=True), Chips(banks), Chips()
    left = [0] * 6  # left[k]: when the last token left stage k; left[5] stays 0
    for x, y, visible, texels in frame_tokens:
        def read(at):
            return up(observer.request([(x, y)], at) - at) if x % P == 0 and not ideal else CLOCK

        def transform(_):
            return s * CLOCK if visible else CLOCK

        def look_up(at):
            requests = [texels] if banks == 4 else [[t] for t in texels]
            if ideal or not texels:
                return max(1, len(requests)) * CLOCK
            done = at
            for k, places in enumerate(requests):
                done = light.request(places, max(done, at + k * CLOCK))
            return up(done - at)

        def write(at):
            return up(mask.request([(x, y)], at) - at) if x % P == P - 1 and not ideal else CLOCK

        entry = left[1]
        for k, service in enumerate((read, transform, look_up, write), 1):
            left[k] = entry = max(entry + service(entry), left[k + 1])
    return (observer, light, mask), left[4]


def main():
    here = pathlib.Path(__file__).parent
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--machine", type=pathlib.Path, help="MACHINE.md",
                        default=here / "../../hw/MACHINE.md")
    machine = parser.parse_args().machine
    files = [machine, *(machine.parent / "machine").glob("*.md")]
    text = "".join(file.read_text(encoding="utf-8") for file in files)
    data = (here / "../goldens/observer_z.pgm").read_bytes()[-2 * N * N:]
    observer_z = [data[k] << 8 | data[k + 1] for k in range(0, len(data), 2)]
    if published_hash(observer_z, 2) not in text:
        print("observer_z.pgm is not the published buffer")
        return 1
    good = True
    noise = dither_words(0x12345678, 12, 256)
    for figure, banks, s in ((3, 1, 3), (4, 1, 4), (4, 4, 3)):
        seen = list(tokens(observer_z, 192 if figure == 4 else 64, figure == 4,
                           noise if figure == 4 else None))
        stores, total = frame(seen, s, banks, False)
        _, ideal = frame(seen, s, banks, True)
        row = "| {} | {} | {} | {} | {} | {} | {} | {} |".format(
            figure, banks, s, ", ".join(str(c.misses) for c in stores),
            ", ".join(str(c.changes) for c in stores), sum(c.latency for c in stores), total, ideal)
        same = re.search("^" + re.escape(row) + "$", text, re.MULTILINE) is not None
        good = good and same
        print(row + ("" if same else "  DIFFERS"), flush=True)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
