"""The post-process on the AP-120B, in its floating point (section 18)."""
import functools
import math
from fractions import Fraction

from words import BACKGROUND, F, H, MIDDLE, N, Z

# -- 18. The AP-120B -------------------------------------------------------------------------------
# A word is (m, e), any integers, for m 2^e: of values this is all that counts.  The figures come
# nowhere near the ends of the exponent's range, so those are left out.


def fl(m, e=0):
    drop = m.bit_length() - 27
    return (half_even_shift(m, drop), e + drop) if drop > 0 else (m, e)


def half_even_shift(m, n):
    q, rest = m >> n, m & ((1 << n) - 1)
    return q + (2 * rest + (q & 1) > 1 << n)


def fl_fraction(a):
    # 40 bits more than needed and one that tells of a rest.
    e = a.numerator.bit_length() - a.denominator.bit_length() - 68
    scaled = a / Fraction(2) ** e
    return fl(2 * math.floor(scaled) + (scaled.denominator != 1), e - 1) if a else (0, 0)


def aligned(a, b):
    e = min(a[1], b[1])
    return a[0] << a[1] - e, b[0] << b[1] - e, e


def plus(a, b):
    x, y, e = aligned(a, b)
    return fl(x + y, e)


def minus(a, b):
    return plus(a, (-b[0], b[1]))


def times(a, b):
    return fl(a[0] * b[0], a[1] + b[1])


def above(a, b):
    x, y, _ = aligned(a, b)
    return x > y


def fixt(a):
    m, e = a
    assert m >= 0  # what is fixed here has passed the test of the volume
    return m << e if e >= 0 else m >> -e


def array_matrix(exact):
    o = Fraction(1, 2) - H
    rows = [[row[0], row[1], row[2] / (1 << Z), row[3] + (row[0] + row[1]) * o] for row in exact]
    rows = [[a / exact[3][3] for a in row] for row in rows]
    scales = (1, 1, 1 << Z, 1)
    offsets = (H, H, MIDDLE, 0)
    return [[fl_fraction(s * a + t * w) for a, w in zip(row, rows[3])]
            for row, s, t in zip(rows, scales, offsets)]


def array_nearest(texel, x, y, k):
    return above(k, (texel(fixt(x), fixt(y)), 0))


def array_bilinear(texel, x, y, k):
    half = (1, -1)
    u, v = plus(x, half), plus(y, half)
    i, j = fixt(u), fixt(v)
    f, g = minus(u, (i, 0)), minus(v, (j, 0))

    def lerp(a, b, t):
        return plus(a, times(t, minus(b, a)))
    rows = [lerp((texel(i - 1, r), 0), (texel(i, r), 0), f) for r in (j - 1, j)]
    return above(k, lerp(*rows, g))


def array_mask(observer_z, light_z, exact, lookup, dither=None):
    def texel(a, b):
        return light_z[b * N + a] if 0 <= a < N and 0 <= b < N else BACKGROUND
    matrix = array_matrix(exact)
    mask = [0] * (N * N)
    for p, c in enumerate(observer_z):
        if c == BACKGROUND:
            continue
        point = [(p % N, 0), (p // N, 0), (c - MIDDLE, 0), (1, 0)]
        x, y, k = (functools.reduce(plus, map(times, row, point)) for row in matrix[:3])
        if dither:
            x, y = plus(x, (dither[p][0], -F)), plus(y, (dither[p][1], -F))
        inside = all(q[0] >= 0 and above((N, 0), q) for q in (x, y))
        if inside and k[0] >= 0 and not above(k, (BACKGROUND - 1, 0)):
            mask[p] = 255 * lookup(texel, x, y, k)
    return mask
