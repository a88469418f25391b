"""The machine's numbers: widths, world words, views, the transform unit (sections 1 to 5)."""
import math
from fractions import Fraction

# -- 1. Notation ----------------------------------------------------------------------------------


def half_up(a, b):
    return (2 * a + b) // (2 * b)


def half_even(a, b=1):
    return round(Fraction(a, b))


def fits(word, bits):
    return -(1 << (bits - 1)) <= word < 1 << (bits - 1)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def to_bytes(values, size):
    return b"".join(value.to_bytes(size, "big") for value in values)


def published_hash(values, size):
    fnv = 0xCBF29CE484222325
    for byte in to_bytes(values, size):
        fnv = (fnv ^ byte) * 0x100000001B3 & 0xFFFFFFFFFFFFFFFF
    return f"{ {1: 'u8', 2: 'u16be'}[size] }:{N}x{N}:fnv1a64:{fnv:016x}"


# -- 2. Widths ------------------------------------------------------------------------------------

XY_BITS, Z_BITS, C, F = 9, 16, 16, 7
N, H = 1 << XY_BITS, 1 << (XY_BITS - 1)
Z = Z_BITS - XY_BITS  # section 2's z: a pixel has 2^z quanta
I = max(1, Z)
ONE = 1 << (XY_BITS + I - 2)
BACKGROUND = (1 << Z_BITS) - 1
MIDDLE = 1 << (Z_BITS - 1)  # the code of Z = 0


# -- 3. From decimals to world words --------------------------------------------------------------


def sine(degrees):
    # A double is exact enough for the few angles used here.
    return round(math.sin(math.radians(degrees)) * 2**30)


def cosine(degrees):
    return sine(degrees + 90)


def mul30(a, b):
    return half_even(a * b, 1 << 30)


def arc(k):
    """The four points (sine, cosine) of the arc from 45 k to 45 (k + 1) degrees."""
    h = 284774038
    s0, c0, s1, c1 = sine(45 * k), cosine(45 * k), sine(45 * (k + 1)), cosine(45 * (k + 1))
    return [(s0, c0), (s0 + mul30(h, c0), c0 - mul30(h, s0)),
            (s1 + mul30(-h, c1), c1 - mul30(-h, s1)), (s1, c1)]


def sphere(centre, r):
    """32 patches of 16 control points, world words; point (i, j) has index 4 j + i."""
    cx, cy, cz = centre
    return [[(cx + mul30(r, mul30(su, cv)), cy + mul30(r, sv), cz + mul30(r, mul30(cu, cv)))
             for sv, cv in arc(q - 2) for su, cu in arc(m)]
            for q in range(4) for m in range(8)]


def object_words(patches):
    """All patches in one 16-bit format, and its fraction."""
    largest = max(abs(word) for patch in patches for point in patch for word in point)
    # Of the readings of "the number of bits of (...) + 1", this one gives section 15's f = 14.
    f = min(15 - (max(largest, 1) + 1).bit_length() + 16, 14)
    return [[tuple(half_up(word, 1 << (16 - f)) for word in point) for point in patch]
            for patch in patches], f


# -- 4. Views -------------------------------------------------------------------------------------


class View:
    """An orthographic view; target, extent, near and far are Q15.16, angles whole degrees."""

    def __init__(self, azimuth, elevation, target, extent, near, far):
        sa, ca, se, ce = sine(azimuth), cosine(azimuth), sine(elevation), cosine(elevation)
        self.back = (mul30(sa, ce), se, mul30(ca, ce))
        self.frame = [[Fraction(x, 2**30) for x in vector] for vector in (
            (ca, 0, -sa), (-mul30(sa, se), ce, -mul30(ca, se)), self.back)]
        self.target = [Fraction(x, 2**16) for x in target]
        self.extent, self.near, self.far = (Fraction(x, 2**16) for x in (extent, near, far))

    def world_to_screen(self):
        right, up, back = self.frame
        depth = self.far - self.near
        rows = []
        for vector, scale, offset in ((right, H / self.extent, 0), (up, -H / self.extent, 0),
                                      (back, -2 * H / depth, -2 * H * self.near / depth - H)):
            row = [scale * x for x in vector]
            rows.append(row + [offset - dot(row, self.target)])
        return rows + [[0, 0, 0, Fraction(1)]]

    def screen_to_world(self):
        pixel, quantum = self.extent / H, (self.far - self.near) / (2 * H)
        middle = (self.far + self.near) / 2
        return [[r * pixel, -u * pixel, -b * quantum, t - b * middle]
                for r, u, b, t in zip(*self.frame, self.target)] + [[0, 0, 0, Fraction(1)]]


def observer_to_light(observer, light, bias):
    columns = list(zip(*observer.screen_to_world()))
    matrix = [[dot(row, column) for column in columns] for row in light.world_to_screen()]
    matrix[2] = [a - Fraction(bias, 1 << Z) * w for a, w in zip(matrix[2], matrix[3])]
    return matrix


# -- 5. The transform unit ------------------------------------------------------------------------


class TransformUnit:
    """An affine matrix as words, for input words with fraction f and the given `one`."""

    def __init__(self, matrix, f, one, dropped=0, nearest=False):
        *rows, (wx, wy, wz, m) = matrix
        assert wx == wy == wz == 0  # m is row W's entry before its division by v1
        scale = (1 / m, 1 / m, 1 / m, Fraction(1 << f, one) / m)
        self.f, self.one, self.place = f, one, 1 << dropped
        self.up = self.place // 2 if nearest else 0  # half up, or the floor
        self.rows = [self.load([a * b for a, b in zip(row, scale)]) for row in rows]

    @staticmethod
    def load(row):
        if not any(row):
            return [0] * 4, 0
        for e in range(-31, 32):
            words = [half_even(a * Fraction(2) ** (C - 2 - e)) for a in row]
            if all(fits(word, C) for word in words):
                return words, e
        raise ValueError("no exponent fits")

    def __call__(self, point, out):
        """The results X, Y, Z, with out[r] fraction bits."""
        results = []
        for (words, e), bits in zip(self.rows, out):
            acc = sum((a * b + self.up) // self.place * self.place
                      for a, b in zip(words, (*point, self.one)))
            s = C - 2 + self.f - bits - e
            results.append(half_up(acc, 1 << s) if s >= 0 else acc << -s)
        return results
