"""Drawing: patches to blocks, blocks to samples, the frame store, shading (sections 6 to 9)."""
import functools
import math

from words import BACKGROUND, H, MIDDLE, N, TransformUnit, Z, Z_BITS, dot, half_up

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
