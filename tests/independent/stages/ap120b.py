"""The post-process on the AP-120B, in its floating point (section 18)."""
import functools
import math
from fractions import Fraction

# A word is (m, e), any integers, for m 2^e: of values this is all that counts.
GREATEST = ((1 << 27) - 1, 511 - 27)


def fl(m, e=0):
    drop = m.bit_length() - 27
    if drop > 0:
        m, e = half_even_shift(m, drop), e + drop
    size = m.bit_length() + e  # 2^(size-1) <= |m 2^e| < 2^size
    if m and size > 511:
        return (GREATEST[0] if m > 0 else -GREATEST[0]), GREATEST[1]
    return (m, e) if size > -513 else (0, 0)


def half_even_shift(m, n):
    q, rest = m >> n, m & ((1 << n) - 1)
    return q + (2 * rest + (q & 1) > 1 << n)


def fl_fraction(a):
    # 40 bits more than needed and one that says whether there is a rest.
    if not a:
        return 0, 0
    e = a.numerator.bit_length() - a.denominator.bit_length() - 68
    scaled = a / Fraction(2) ** e
    return fl(2 * math.floor(scaled) + (scaled.denominator != 1), e - 1)


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


def over(a, b):
    if not b[0]:
        return (0, 0) if not a[0] else (GREATEST[0] if a[0] > 0 else -GREATEST[0], GREATEST[1])
    return fl_fraction(Fraction(a[0], b[0]) * Fraction(2) ** (a[1] - b[1]))


def above(a, b):
    x, y, _ = aligned(a, b)
    return x > y


def fixt(a):
    m, e = a
    assert m >= 0  # what is fixed here has passed the test of the volume
    return m << e if e >= 0 else m >> -e


def array_matrix(exact, s):
    o = (Fraction(1, 2) if s.registration == "centre" else 0) - s.half_px
    affine = not any(exact[3][:3])
    rows = [[a / exact[3][3] for a in row] if affine else row for row in exact]
    rows = [[row[0], row[1], row[2] * s.quantum_px(), row[3] + (row[0] + row[1]) * o]
            for row in rows]
    scales, offsets = (1, 1, 1 / s.quantum_px(), 1), (s.half_px, s.half_px, s.depth_offset, 0)
    return affine, [[fl_fraction(Fraction(k * a + t * w)) for a, w in zip(row, rows[3])]
                    for row, k, t in zip(rows, scales, offsets)]


def array_bilinear(texel, x, y, k, s):
    half = (1, -1)
    u, v = plus(x, half), plus(y, half)
    i, j = fixt(u), fixt(v)
    four = [[texel(a, b) for a in (i - 1, i)] for b in (j - 1, j)]
    if s.background == "fall_back" and any(s.background_code in row for row in four):
        return above(k, (texel(fixt(x), fixt(y)), 0))
    f, g = minus(u, (i, 0)), minus(v, (j, 0))

    def lerp(a, b, t):
        return plus(a, times(t, minus(b, a)))
    return above(k, lerp(*(lerp((a, 0), (b, 0), f) for a, b in four), g))


def array_mask(observer_z, light_z, exact, s, dither):
    n = s.size_px

    def texel(a, b):
        return light_z[b * n + a] if 0 <= a < n and 0 <= b < n else s.background_code
    affine, matrix = array_matrix(exact, s)
    mask = [0] * (n * n)
    for p, code in enumerate(observer_z):
        if code == s.background_code:
            continue
        point = [(p % n, 0), (p // n, 0), (code - s.depth_offset, 0), (1, 0)]
        x, y, k, *w = (functools.reduce(plus, map(times, row, point))
                       for row in matrix[:3 if affine else 4])
        if w:
            if w[0][0] <= 0:
                continue
            x, y, k = (over(q, w[0]) for q in (x, y, k))
        if dither:
            x, y = (plus(q, (d, -s.fraction_bits)) for q, d in zip((x, y), dither[p]))
        inside = all(q[0] >= 0 and above((n, 0), q) for q in (x, y))
        if inside and k[0] >= 0 and not above(k, (s.deepest_drawn, 0)):
            if s.lookup == "bilinear":
                mask[p] = 255 * array_bilinear(texel, x, y, k, s)
            else:
                mask[p] = 255 * above(k, (texel(fixt(x), fixt(y)), 0))
    return mask
