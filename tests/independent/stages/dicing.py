"""Dicing: patches as facets (section 22).

A patch is 16 places in world words, point (i, j) with index 4 j + i.  Vertices and cells are
numbered (i, j), too.
"""
from .notation import cross, half_even
from .shading import cut30, unit14

# The points along the edges j = 0, j = k, i = 0 and i = k
EDGES = (range(0, 4), range(12, 16), range(0, 16, 4), range(3, 16, 4))


def tolerance(extent_word, s):
    return extent_word >> (s.xy_bits + 1)


def second(p, a, b, c, d):
    """The greatest component of p(a) - p(b) - p(c) + p(d)."""
    return max(abs(w - x - y + z) for w, x, y, z in zip(p[a], p[b], p[c], p[d]))


def least_level(sum_of_seconds, tolerance_word, s):
    """The least that is fine enough, or dice_levels."""
    return next((level for level in range(s.dice_levels)
                 if sum_of_seconds <= 8 * tolerance_word << 2 * level), s.dice_levels)


def patch_level(p, tolerance_word, s):
    uu = max(second(p, a, a + 1, a + 1, a + 2) for j in range(4) for a in (4 * j, 4 * j + 1))
    vv = max(second(p, a, a + 4, a + 4, a + 8) for j in range(2) for a in range(4 * j, 4 * j + 4))
    uv = max(second(p, a, a + 1, a + 4, a + 5) for j in range(3) for a in range(4 * j, 4 * j + 3))
    return least_level(6 * uu + 18 * uv + 6 * vv, tolerance_word, s)


def edge_level(p, edge, tolerance_word, s):
    a, b, c, d = edge
    return least_level(6 * max(second(p, a, b, b, c), second(p, b, c, c, d)), tolerance_word, s)


def cubic(n, k):
    """B_0(n) to B_3(n)"""
    return (k - n) ** 3, 3 * n * (k - n) ** 2, 3 * n * n * (k - n), n ** 3


def quadratic(n, k):
    """C_0(n) to C_2(n)"""
    return (k - n) ** 2, 2 * n * (k - n), n * n


def weighted(along_u, along_v, places):
    """The sum over places of a row's weight times a column's; the place in u changes fastest."""
    weights = [u * v for v in along_v for u in along_u]
    return [sum(w * x for w, x in zip(weights, axis)) for axis in zip(*places)]


def vertex(p, i, j, k):
    return tuple(half_even(x, k ** 6) for x in weighted(cubic(i, k), cubic(j, k), p))


def differences(p, count_u, count_v, step):
    """Of the first points of each row and column, to the one a step on."""
    return [[y - x for x, y in zip(p[a], p[a + step])]
            for j in range(count_v) for a in range(4 * j, 4 * j + count_u)]


def normal(p, i, j, k):
    def tangent_u(n):
        return weighted(quadratic(i, k), cubic(n, k), differences(p, 3, 4, 1))

    def tangent_v(n):
        return weighted(cubic(n, k), quadratic(j, k), differences(p, 4, 3, 4))

    def unless_zero(tangent, n):
        here = tangent(n)
        return cut30(here if any(here) else tangent(1 if n == 0 else k - 1))
    return tuple(unit14(cross(unless_zero(tangent_u, j), unless_zero(tangent_v, i))))


def used(i, j, k, steps):
    """The vertex that stands for (i, j), with an edge's step from one used vertex to the next."""
    below, above, left, right = steps
    if j in (0, k):
        i -= i % (above if j else below)
    if i in (0, k):
        j -= j % (right if i else left)
    return i, j


def numbers(k, steps):
    """The facets as triples of vertices, cell by cell."""
    for j in range(k):
        for i in range(k):
            a, b, c, d = (used(i + u, j + v, k, steps)
                          for u, v in ((0, 0), (1, 0), (1, 1), (0, 1)))
            for three in ((a, b, c), (a, c, d)):
                if len(set(three)) == 3:
                    yield three


def diced(p, tolerance_word, s):
    """A patch's facets: three places in world words, and three normals."""
    k = 1 << patch_level(p, tolerance_word, s)
    steps = [k >> edge_level(p, edge, tolerance_word, s) for edge in EDGES]
    facets = list(numbers(k, steps))
    made = {ij: (vertex(p, *ij, k), normal(p, *ij, k)) for ij in {ij for f in facets for ij in f}}
    return [tuple(zip(*(made[ij] for ij in three))) for three in facets]
