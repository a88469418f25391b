"""Drawing: blocks to samples (section 7)."""
from operator import add

from .float_store import kept
from .notation import half_up
from .perspective import divide_corners


def between(a, b):
    """a[0], b[0], a[1], b[1], ..., a[-1]"""
    result = [0] * (len(a) + len(b))
    result[::2], result[1::2] = a, b
    return result


def halve(f, g):
    """The 17 values that halving the interval f[0] .. f[1] four times gives."""
    for level in range(4):
        both = list(map(add, g, g[1:]))
        f = between(f, [(a + b - c + 1) >> 1 for a, b, c in zip(f, f[1:], both)])
        if level < 3:
            g = between([(c + 2) >> 2 for c in g], [(c + 4) >> 3 for c in both])
    return f


def leaf_corners(comp):
    """corner[i][j] of a component, 17 x 17"""
    f, gu, gv, guv = comp
    ends = [(halve(f[a:a + 2], gu[a:a + 2]), halve(gv[a:a + 2], guv[a:a + 2])) for a in (0, 2)]
    (f0, g0), (f1, g1) = ends
    return [halve(values[:2], values[2:]) for values in zip(f0, f1, g0, g1)]


def block_corners(block, affine, s):
    """The grids X, Y and Z of a block in raster units, or None if it has to be dropped."""
    grids = [leaf_corners(comp) for comp in block[:3 if affine else 4]]
    return grids if affine else divide_corners(*grids, s)


def triangle_depth(a, b, c, x, y):
    """The depth of a triangle of (x, y, z) corners at a place, or None."""
    ax, ay, az = a
    bx, by, bz = b
    cx, cy, cz = c
    if not (min(ax, bx, cx) - 128 <= x <= max(ax, bx, cx) + 128
            and min(ay, by, cy) - 128 <= y <= max(ay, by, cy) + 128):
        return None
    abx, aby, bcx, bcy, cax, cay = bx - ax, by - ay, cx - bx, cy - by, ax - cx, ay - cy
    area = abx * (cy - ay) - (cx - ax) * aby
    if area == 0:
        return None
    wc = abx * (y - ay) - (x - ax) * aby
    wa = bcx * (y - by) - (x - bx) * bcy
    wb = cax * (y - cy) - (x - cx) * cay
    if area < 0:
        area, wa, wb, wc = -area, -wa, -wb, -wc
    if (wc < -128 * (abs(abx) + abs(aby)) or wa < -128 * (abs(bcx) + abs(bcy))
            or wb < -128 * (abs(cax) + abs(cay))):
        return None
    depth = az + half_up(wb * (bz - az) + wc * (cz - az), area)
    return min(max(depth, min(az, bz, cz)), max(az, bz, cz))


def first_and_last(grid, s):
    """For each leaf the first and the last pixel of one axis whose centre it may hold."""
    low = [list(map(min, c, c[1:])) for c in grid]
    high = [list(map(max, c, c[1:])) for c in grid]
    up = s.half_px * 8192 - 4096 - 128 + 8191
    down = s.half_px * 8192 - 4096 + 128
    last = s.size_px - 1
    return ([[max(0, (v + up) >> 13) for v in map(min, a, b)] for a, b in zip(low, low[1:])],
            [[min(last, (v + down) >> 13) for v in map(max, a, b)]
             for a, b in zip(high, high[1:])])


def centre_samples(grids, s):
    """(px, py, x, y, Z, i, j) of a block's samples, and of which triangle; leaf by leaf"""
    x, y, z = grids
    (x0, x1), (y0, y1) = first_and_last(x, s), first_and_last(y, s)
    for j in range(16):
        for i in range(16):
            if x0[i][j] > x1[i][j] or y0[i][j] > y1[i][j]:
                continue
            p00, p10, p11, p01 = ((x[k][m], y[k][m], z[k][m]) for k, m in (
                (i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
            for py in range(y0[i][j], y1[i][j] + 1):
                cy = (2 * (py - s.half_px) + 1) * 4096
                for px in range(x0[i][j], x1[i][j] + 1):
                    cx = (2 * (px - s.half_px) + 1) * 4096
                    for k, triangle in enumerate(((p00, p10, p11), (p00, p11, p01))):
                        depth = triangle_depth(*triangle, cx, cy)
                        if depth is not None:
                            yield (px, py, cx, cy, depth, i, j), k


def leaf_samples(grids, s):
    half = s.half_px * 8192
    for j in range(16):
        for i in range(16):
            x, y, z = (half_up(g[i][j] + g[i + 1][j] + g[i][j + 1] + g[i + 1][j + 1], 4)
                       for g in grids)
            px, py = (x + half) >> 13, (y + half) >> 13
            if 0 <= px < s.size_px and 0 <= py < s.size_px:
                yield (px, py, x, y, z, i, j), None


def samples(grids, s):
    return centre_samples(grids, s) if s.sampling == "centre" else leaf_samples(grids, s)


def z_code(depth, s):
    """The code of a depth, or None for no sample."""
    code = s.round_depth(depth, 1 << s.depth_guard) + s.depth_offset
    return kept(min(code, s.deepest_drawn), s) if 0 <= code <= s.background_code else None
