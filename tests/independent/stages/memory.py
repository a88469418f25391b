"""Memory of the time (section 17): chips, stolen cycles, the replay."""
import heapq

from .shadow_test import pixel_words

CLOCK = 200
ACCESS, CYCLE, COLUMN, PAGE, LONGEST = 200, 375, 135, 225, 10_000
RECOVERY, GAP = CYCLE - ACCESS, PAGE - COLUMN
N = 512
WORD_PX = max(16, N * N >> 14)


def video():
    """The moments at which a shown store is asked for a word; 0 sorts before the refresh's 1."""
    line = 0
    while True:
        for k in range(N // WORD_PX):
            yield line * 63_500 + k * 52_000 // (N // WORD_PX), 0
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
            return 0, (y * N + x) // WORD_PX // 128
        return 2 * (y % 2) + x % 2, (y // 2 * (N // 2) + x // 2) // (WORD_PX // 4) // 128

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


def tokens(observer_z, light_map, unit, dither):
    """(x, y, visible, texels read) of every pixel in scan order"""
    s = light_map.s
    four = s.lookup == "bilinear"
    edge, back = s.half_px * s.one_texel, s.one_texel // 2 if four else 0
    for p, code in enumerate(observer_z):
        px, py = p % s.size_px, p // s.size_px
        if code == s.background_code:
            yield px, py, False, []
            continue
        x, y, depth = unit(*pixel_words(px, py, code, s))
        if dither:
            x, y = x + dither[p][0], y + dither[p][1]
        texels = []
        if (-edge <= x < edge and -edge <= y < edge
                and 0 <= depth + s.depth_offset <= s.deepest_drawn):
            tx, ty = (((v - back) >> s.fraction_bits) + s.half_px for v in (x, y))
            texels = [(tx + i, ty + j) for j in range(1 + four) for i in range(1 + four)
                      if 0 <= tx + i < s.size_px and 0 <= ty + j < s.size_px]
        yield px, py, True, texels


def frame(frame_tokens, s, banks, ideal):
    """The stores, and when the last token has left the last stage."""
    observer, light, mask = Chips(shown=True), Chips(banks), Chips()
    left = [0] * 6  # left[k]: when the last token left stage k; left[5] stays 0
    for x, y, visible, texels in frame_tokens:
        def read(at):
            if x % WORD_PX != 0 or ideal:
                return CLOCK
            return up(observer.request([(x, y)], at) - at)

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
            if x % WORD_PX != WORD_PX - 1 or ideal:
                return CLOCK
            return up(mask.request([(x, y)], at) - at)

        entry = left[1]
        for k, service in enumerate((read, transform, look_up, write), 1):
            left[k] = entry = max(entry + service(entry), left[k + 1])
    return (observer, light, mask), left[4]
