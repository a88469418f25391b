"""From decimals to world words and object words (section 3)."""
from fractions import Fraction

from .notation import half_even, half_up

SCALE = 160  # fraction bits of the sines' series: far more than a nearest integer needs


def _arctan_inverse(n):
    total, term, k = 0, (1 << SCALE) // n, 1
    while term:
        total += term // k if k % 4 == 1 else -(term // k)
        term, k = term // (n * n), k + 2
    return total


PI = 4 * (4 * _arctan_inverse(5) - _arctan_inverse(239))  # Machin


def decimal(text, fraction):
    return half_even(Fraction(text) * (1 << fraction))


def sine(angle):
    """2^30 times the sine of an angle in Q15.16 degrees, to the nearest integer."""
    quarter = 90 << 16
    angle %= 4 * quarter
    if angle >= 2 * quarter:
        return -sine(angle - 2 * quarter)
    angle = min(angle, 2 * quarter - angle)
    if angle == quarter:
        return 1 << 30
    x = PI * angle // (180 << 16)
    total, term, k = 0, x, 1
    while term:
        total += term
        term = -(term * x >> SCALE) * x // (1 << SCALE) // ((k + 1) * (k + 2))
        if term == -1:
            break
        k += 2
    return half_up(total, 1 << (SCALE - 30))


def cosine(angle):
    return sine(angle + (90 << 16))


def mul30(a, b):
    return half_even(a * b, 1 << 30)


def arc(k):
    """The four points (sine, cosine) of the arc from 45 k to 45 (k + 1) degrees."""
    handle, step = 284774038, 45 << 16
    s0, c0, s1, c1 = (sine(k * step), cosine(k * step),
                      sine((k + 1) * step), cosine((k + 1) * step))
    return [(s0, c0), (s0 + mul30(handle, c0), c0 - mul30(handle, s0)),
            (s1 + mul30(-handle, c1), c1 - mul30(-handle, s1)), (s1, c1)]


def sphere(centre, r):
    """32 patches of 16 control points, world words; point (i, j) has index 4 j + i."""
    cx, cy, cz = centre
    arcs = [arc(k) for k in range(-2, 8)]
    return [[(cx + mul30(r, mul30(su, cv)), cy + mul30(r, mul30(1 << 30, sv)),
              cz + mul30(r, mul30(cu, cv)))
             for sv, cv in arcs[q] for su, cu in arcs[m + 2]]
            for q in range(4) for m in range(8)]


def plane(origin, u, v):
    return [tuple(o + half_even(du * i, 3) + half_even(dv * j, 3)
                  for o, du, dv in zip(origin, u, v)) for j in range(4) for i in range(4)]


def object_fraction(patches):
    largest = max(abs(word) for patch in patches for point in patch for word in point)
    return max(f for f in range(15) if f == 0 or half_up(largest, 1 << (16 - f)) <= 32767)


def object_place(point, f):
    return tuple(half_up(word, 1 << (16 - f)) for word in point)


def object_words(patches, others=()):
    """All patches in one 16-bit format, which holds the others, too; and its fraction."""
    f = object_fraction([*patches, *others])
    return [[object_place(point, f) for point in patch] for patch in patches], f
