#!/usr/bin/env python3
"""A second, independent implementation of the machine, for the figures only.

It was written from MACHINE.md alone, by someone who had not seen the project's code (except for
section 18, whose author had), to find out whether that document suffices.  It draws the observer's
and the light's view of section 15's scene, computes the buffers of the figures and compares their
hashes with those MACHINE.md lists.
Only what the figures use is here: orthographic views, the machine of 1978, the default settings.
Its sections are the document's, beside which it should be read.  It takes about half a minute.

    python3 machine.py [--buffers DIR] [--machine PATH]

prints the name and hash of each buffer and exits with 1 if one differs.
"""
import argparse
import functools
import math
import pathlib
import re
import sys
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


# -- 6. Drawing: patches to blocks ----------------------------------------------------------------

G = 6 if Z_BITS <= 20 else 26 - Z_BITS
ALONG = {1: ((0, 1), (2, 3)), 2: ((0, 2), (1, 3))}  # corners a, b along u (1), v (2)


def component(p):
    """(f, gu, gv, guv), each for the corners 2 v + u, of a coordinate's 16 control values."""
    def second(a, step):
        return p[a] - 2 * p[a + step] + p[a + 2 * step]
    f, gu, gv, guv = [], [], [], []
    for v in (0, 1):
        for u in (0, 1):
            f.append(p[12 * v + 3 * u])
            gu.append(half_up(3 * second(12 * v + u, 1), 4))
            gv.append(half_up(3 * second(4 * v + 3 * u, 4), 4))
            mixed = [second(4 * j + u, 1) for j in (v, v + 1, v + 2)]
            guv.append(half_up(9 * (mixed[0] - 2 * mixed[1] + mixed[2]), 16))
    return f, gu, gv, guv


def split(comp, way):
    """The lower and the upper half of a component; way is 1 (in u) or 2 (in v)."""
    lower, upper = [list(q) for q in comp], [list(q) for q in comp]
    for f, g in ((0, way), (3 - way, 3)):
        for a, b in ALONG[way]:
            ga, gb = comp[g][a], comp[g][b]
            lower[f][b] = upper[f][a] = (comp[f][a] + comp[f][b] - ga - gb + 1) >> 1
            lower[g][b] = upper[g][a] = (ga + gb + 4) >> 3
            lower[g][a], upper[g][b] = (ga + 2) >> 2, (gb + 2) >> 2
    return lower, upper


def bounds(comp):
    """least, greatest, (slope_u, slope_v), (bend_u, bend_v)"""
    f, gu, gv, guv = comp
    mu, mv, muv = (max(max(g), -min(g)) for g in (gu, gv, guv))
    reach = mu + mv + muv

    def step(q, way):
        (a, b), (c, d) = ALONG[way]
        return max(abs(q[b] - q[a]), abs(q[d] - q[c]))
    slopes = (step(f, 1) + 4 * mu + step(gv, 1) + 4 * muv,
              step(f, 2) + 4 * mv + step(gu, 2) + 4 * muv)
    return min(f) - reach, max(f) + reach, slopes, (mu + muv, mv + muv)


def blocks(patch):
    """The blocks to draw of a patch, given as its components X, Y, Z and any others."""
    limits = (H * 8192 + 128, H * 8192 + 128, (MIDDLE + 1) << G)
    todo = [(patch, [0, 0])]
    while todo:
        block, count = todo.pop()
        all_bounds = [bounds(comp) for comp in block[:3]]
        if any(b[1] < -limit or b[0] > limit for b, limit in zip(all_bounds, limits)):
            continue
        if (all(max(abs(b[0]), abs(b[1])) < 1 << 29 and max(b[3]) <= 8192 for b in all_bounds)
                and all(sum(b[2]) <= 126976 for b in all_bounds[:2])):
            yield block
            continue
        urge = [max([16 * b[3][way] for b in all_bounds] + [b[2][way] for b in all_bounds[:2]])
                for way in (0, 1)]
        way = 0 if urge[0] >= urge[1] else 1
        if count[way] == 24:
            way = 1 - way
        if count[way] < 24:
            count = [count[0] + (way == 0), count[1] + (way == 1)]
            todo += [(half, count) for half in zip(*(split(comp, way + 1) for comp in block))]


# -- 7. Drawing: blocks to samples ----------------------------------------------------------------


def halve(f, g):
    """The 17 values that halving the interval f[0] .. f[1] four times gives."""
    for _ in range(4):
        fine_f, fine_g = [f[0]], [(g[0] + 2) >> 2]
        for a in range(len(f) - 1):
            both = g[a] + g[a + 1]
            fine_f += (f[a] + f[a + 1] - both + 1) >> 1, f[a + 1]
            fine_g += (both + 4) >> 3, (g[a + 1] + 2) >> 2
        f, g = fine_f, fine_g
    return f


def leaf_corners(comp):
    """corner[i][j] of a component, 17 x 17"""
    f, gu, gv, guv = comp
    ends = [(halve(f[a:a + 2], gu[a:a + 2]), halve(gv[a:a + 2], guv[a:a + 2])) for a in (0, 2)]
    (f0, g0), (f1, g1) = ends
    return [halve(values[:2], values[2:]) for values in zip(f0, f1, g0, g1)]


def pixels(values):
    """The pixels, by row or column, whose centres are between the least and greatest value."""
    return range(max(0, (min(values) - 128 - 4096 + H * 8192 + 8191) >> 13),
                 min(N, ((max(values) + 128 - 4096 + H * 8192) >> 13) + 1))


def triangle_samples(a, b, c):
    def e(p, q, r):
        return (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1])

    def slack(p, q):
        return -128 * (abs(q[0] - p[0]) + abs(q[1] - p[1]))
    area = e(a, b, c)
    if area == 0:
        return
    sign = 1 if area > 0 else -1
    least, greatest = min(a[2], b[2], c[2]), max(a[2], b[2], c[2])
    for py in pixels((a[1], b[1], c[1])):
        for px in pixels((a[0], b[0], c[0])):
            centre = ((2 * (px - H) + 1) * 4096, (2 * (py - H) + 1) * 4096)
            wc, wa, wb = sign * e(a, b, centre), sign * e(b, c, centre), sign * e(c, a, centre)
            if wc >= slack(a, b) and wa >= slack(b, c) and wb >= slack(c, a):
                depth = a[2] + half_up(wb * (b[2] - a[2]) + wc * (c[2] - a[2]), abs(area))
                yield px, py, min(max(depth, least), greatest)


def samples(block):
    """(px, py, Z, i, j) of a block's samples, leaf by leaf, by centre sampling"""
    x, y, z = (leaf_corners(comp) for comp in block[:3])
    for j in range(16):
        for i in range(16):
            x0, x1, y0, y1 = x[i], x[i + 1], y[i], y[i + 1]
            if (pixels((x0[j], x0[j + 1], x1[j], x1[j + 1]))
                    and pixels((y0[j], y0[j + 1], y1[j], y1[j + 1]))):
                p00, p10, p11, p01 = ((x[k][m], y[k][m], z[k][m]) for k, m in (
                    (i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
                for triangle in ((p00, p10, p11), (p00, p11, p01)):
                    for px, py, depth in triangle_samples(*triangle):
                        yield px, py, depth, i, j


def z_code(depth):
    """The code of a depth, or None for no sample."""
    c = half_up(depth, 1 << G) + MIDDLE
    return min(c, BACKGROUND - 1) if 0 <= c <= BACKGROUND else None


# -- 8. The frame store ---------------------------------------------------------------------------


def draw(patches, f, view, shading=None):
    """The Z plane and the intensity plane (zero without shading) of a view of the object words."""
    codes, intensities = [BACKGROUND] * (N * N), [0] * (N * N)
    unit = TransformUnit(view.world_to_screen(), f, 1 << 14)
    for patch in patches:
        points = [unit(point, (13, 13, Z + G)) for point in patch]
        if shading:
            points = [(*p, *(word << 6 for word in o)) for p, o in zip(points, patch)]
        for block in blocks([component(values) for values in zip(*points)]):
            intensity = shading.leaf_intensity(block[3:]) if shading else lambda i, j: 0
            for px, py, depth, i, j in samples(block):
                c, p = z_code(depth), py * N + px
                if c is not None and c <= codes[p]:
                    codes[p], intensities[p] = min((codes[p], intensities[p]),
                                                   (c, intensity(i, j)))
    return codes, intensities


# -- 9. Shading -----------------------------------------------------------------------------------


def cut30(v):
    w = max(abs(x) for x in v).bit_length()
    return [half_up(x, 1 << (w - 30)) for x in v] if w > 30 else v


def unit14(v):
    v = cut30(v)
    length = math.isqrt(dot(v, v))
    return [half_up(x << 14, length) if length else 0 for x in v]


def tangents(objects, way):
    """At each corner, the tangent in u (way 1) or v (way 2)."""
    result = [None] * 4
    for a, b in ALONG[way]:
        ends = [(3 * (f[b] - f[a]), g[a], g[b])
                for f, g in ((comp[0], comp[way]) for comp in objects)]
        result[a] = [df - 8 * ga - 4 * gb for df, ga, gb in ends]
        result[b] = [df + 4 * ga + 8 * gb for df, ga, gb in ends]
    # A zero tangent: that of the opposite edge, the same end of it (the corner across it).
    return [cut30(t if any(t) else result[corner ^ (3 - way)]) for corner, t in enumerate(result)]


class Shading:
    def __init__(self, observer, light, ambient, diffuse, specular, shininess):
        self.l, self.v = ([half_up(x, 1 << 16) for x in view.back] for view in (light, observer))
        self.ambient, self.diffuse = ambient, diffuse
        self.specular, self.shininess = specular, shininess

    def leaf_intensity(self, objects):
        """The intensity of leaf (i, j) of a block, as a function."""
        normals = [unit14((t[1] * s[2] - t[2] * s[1], t[2] * s[0] - t[0] * s[2],
                           t[0] * s[1] - t[1] * s[0]))
                   for t, s in zip(tangents(objects, 1), tangents(objects, 2))]

        @functools.lru_cache(None)
        def intensity(i, j):
            u, v = 2 * i + 1, 2 * j + 1
            weights = ((32 - v) * (32 - u), (32 - v) * u, v * (32 - u), v * u)
            normal = [dot(weights, values) for values in zip(*normals)]
            length = max(1, math.isqrt(dot(normal, normal)))
            nl, nv = dot(normal, self.l) // length, dot(normal, self.v) // length
            if nv < 0:
                nl, nv = -nl, -nv
            total = self.diffuse * self.ambient << 14
            if nl > 0:
                r = ((2 * nl * nv) >> 14) - (dot(self.l, self.v) >> 14)
                r = min(max(r, 0), 1 << 14)
                for _ in range(self.shininess):
                    r = half_up(r * r, 1 << 14)
                total += self.diffuse * (256 - self.ambient) * nl + 256 * self.specular * r
            return min(255, half_up(total, 1 << 22))
        return intensity


# -- 10. The noise --------------------------------------------------------------------------------


def noise_bits(seed, count):
    """At least `count` bits of the stream as one integer, first bit least significant.

    With b[n] = b[n-31] xor b[n-28] also b[n] = b[n-31 s] xor b[n-28 s] for any power of two s
    (squaring modulo 2), so 28 s bits are made at once.
    """
    bits, n, s = seed, 31, 1
    while n < count:
        while 62 * s <= n:
            s *= 2
        more = ((bits >> (n - 31 * s)) ^ (bits >> (n - 28 * s))) & ((1 << 28 * s) - 1)
        bits |= more << n
        n += 28 * s
    return bits


def dither_words(seed, k, size):
    """The (X, Y) dither words of all pixels; k bytes a word."""
    count = 16 * k * N * N
    stream = (noise_bits(seed, count) & ((1 << count) - 1)).to_bytes(count // 8, "little")
    scale = half_up(size << (F + 16), 512 * k << 8)
    words = [half_up((2 * sum(stream[a:a + k]) - 255 * k) * scale, 1 << 16)
             for a in range(0, len(stream), k)]
    return list(zip(words[::2], words[1::2]))


# -- 11. The post-process -------------------------------------------------------------------------


def nearest(light_z, x, y, k):
    return k > light_z[((y >> F) + H) * N + (x >> F) + H]


def bilinear(light_z, x, y, k):
    def texel(a, b):
        return light_z[b * N + a] if 0 <= a < N and 0 <= b < N else BACKGROUND
    q = 1 << F
    x, y = x - q // 2, y - q // 2
    tx, ty, fx, fy = (x >> F) + H, (y >> F) + H, x & (q - 1), y & (q - 1)
    return k * q * q > ((q - fy) * ((q - fx) * texel(tx, ty) + fx * texel(tx + 1, ty))
                        + fy * ((q - fx) * texel(tx, ty + 1) + fx * texel(tx + 1, ty + 1)))


def shadow_mask(observer_z, light_z, matrix, lookup, dither=None, accumulator=64, near=False):
    unit = TransformUnit(matrix, I, ONE, max(0, XY_BITS + I + C + 3 - accumulator), near)
    mask = [0] * (N * N)
    for p, c in enumerate(observer_z):
        if c == BACKGROUND:
            continue
        py, px = divmod(p, N)
        words = [(2 * (q - H) + 1) << (I - 1) for q in (px, py)] + [(c - MIDDLE) << (I - Z)]
        x, y, depth = unit(words, (F, F, Z))
        if dither:
            x, y = x + dither[p][0], y + dither[p][1]
        k = depth + MIDDLE
        if -H << F <= x < H << F and -H << F <= y < H << F and 0 <= k < BACKGROUND:
            mask[p] = 255 * lookup(light_z, x, y, k)
    return mask


# -- 13. Filters and composite --------------------------------------------------------------------


def shadow_chains(mask):
    """The boundaries of the shadow, as closed lists of pixel corners, shadow on the right."""
    def shadow(x, y):
        return 0 <= x < N and 0 <= y < N and mask[y * N + x] >= 128

    def beside(x, y, dx, dy, side):
        """The pixel ahead of corner (x, y) on the right (side 1) or on the left (-1)."""
        return shadow(x + (dx - side * dy - 1) // 2, y + (dy + side * dx - 1) // 2)
    seen = set()  # the starts of the steps east above a shadow pixel
    for start in ((x, y) for y in range(N) for x in range(N)):
        if start in seen or not shadow(*start) or shadow(start[0], start[1] - 1):
            continue
        (x, y), (dx, dy), chain = start, (1, 0), []
        while not chain or (x, y, dx, dy) != (*start, 1, 0):
            chain.append((x, y))
            if dx == 1:
                seen.add((x, y))
            x, y = x + dx, y + dy
            if not beside(x, y, dx, dy, 1):
                dx, dy = -dy, dx
            elif beside(x, y, dx, dy, -1):
                dx, dy = dy, -dx
        yield chain


def dequantize(mask, observer_z, passes):
    def drawn(x, y):
        return 0 <= x < N and 0 <= y < N and observer_z[y * N + x] != BACKGROUND
    cells = [[0] * (N + 1) for _ in range(N)]
    for chain in shadow_chains(mask):
        free = [all(drawn(x - a, y - b) for a in (0, 1) for b in (0, 1)) for x, y in chain]
        nodes = [(x << 12, y << 12) for x, y in chain]
        for _ in range(passes):
            nodes = [tuple((a + 2 * b + c) >> 2 for a, b, c in zip(nodes[i - 1], nodes[i], after))
                     if free[i] else nodes[i]
                     for i, after in enumerate(nodes[1:] + nodes[:1])]
        for (x0, y0), (x1, y1) in zip(nodes, nodes[1:] + nodes[:1]):
            sign = 1 if y1 < y0 else -1
            (yt, xt), (ye, xe) = sorted(((y0, x0), (y1, x1)))
            for r in range((yt + 127) >> 8, (ye + 127) >> 8):  # yt <= 256 r + 128 < ye
                x = xt + (256 * r + 128 - yt) * (xe - xt) // (ye - yt)
                s = (x + 128) >> 8
                cells[r >> 4][s >> 4] += sign * (16 - s % 16)
                cells[r >> 4][(s >> 4) + 1] += sign * (s % 16)
    result = []
    for row in cells:
        area = 0
        for cell in row[:N]:
            area += cell
            result.append((255 * min(max(area, 0), 256) + 128) >> 8)
    return [0 if c == BACKGROUND else m for m, c in zip(result, observer_z)]


def low_pass(mask, observer_z):
    result = [0] * (N * N)
    weights = [(dx, dy, (2 - abs(dx)) * (2 - abs(dy))) for dy in (-1, 0, 1) for dx in (-1, 0, 1)]
    for p, c in enumerate(observer_z):
        if c != BACKGROUND:
            y, x = divmod(p, N)
            total = 8
            for dx, dy, weight in weights:
                inside = 0 <= x + dx < N and 0 <= y + dy < N
                near = p + dy * N + dx
                total += weight * mask[near if inside and observer_z[near] != BACKGROUND else p]
            result[p] = total >> 4
    return result


def composite(intensity, mask, density):
    return [(i * (65280 - m * density) + 32640) // 65280 for i, m in zip(intensity, mask)]


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
    yield "picture6", 1, composite(intensity, filtered, 141)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--buffers", type=pathlib.Path, help="write the buffers into this folder")
    parser.add_argument("--machine", type=pathlib.Path, help="MACHINE.md",
                        default=pathlib.Path(__file__).parent / "../../hw/MACHINE.md")
    options = parser.parse_args()
    # The figures' rows have three columns before the buffer's name, the variants' one.
    row = r"^\|[^|]*\|[^|]*\|[^|]*\| (\w+) \| `(\w+:\d+x\d+:fnv1a64:[0-9a-f]{16})` \|"
    text = options.machine.read_text(encoding="utf-8")
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
