"""Perspective drawing (section 14)."""
from . import blocks
from .notation import fits, half_up

HUGE = 1 << 58


def shifts(loaded, s):
    """By how much each row's accumulator shifts right."""
    up = 44 - (16 + s.coefficient_bits + 2)
    return [max(loaded.exponents) - e - up for e in loaded.exponents]


def minus_multiple(x, c, w):
    """The component X - c W."""
    return [[a - c * b for a, b in zip(p, q)] for p, q in zip(x, w)]


def ceiling_shift(v, n):
    return v << n if n >= 0 else -(-v >> -n)


def quotient_bounds(x, w, out):
    bw = blocks.bounds(w)
    down = max(0, bw[0].bit_length() - 24)
    w_min = bw[0] >> down
    centre = min(max(x[0][0] // w[0][0], -4096), 4096)
    about = blocks.bounds(minus_multiple(x, centre, w))

    def scaled(v):
        return (v >> down) + 1

    def over(v):
        return min(HUGE, ceiling_shift(scaled(v), out)) // w_min + 1
    reach = over(max(-about[0], about[1]))

    def times(v):
        if reach >= 1 << 26 or scaled(v) >= 1 << 31:
            return HUGE
        return reach * scaled(v) // w_min + 1

    def mixed(slope, w_slope):
        if slope >= 1 << 28 or scaled(w_slope) >= 1 << 30:
            return HUGE
        return slope * scaled(w_slope) // (4 * w_min) + 1
    slopes = [over(about[2][k]) + times(bw[2][k]) for k in (0, 1)]
    bends = [over(about[3][k]) + times(bw[3][k]) + mixed(slopes[k], bw[2][k]) for k in (0, 1)]
    lower = centre << out if out >= 0 else centre >> -out
    return lower - reach, ceiling_shift(centre, out) + reach, slopes, bends


def beyond_a_side(block, s):
    side = s.half_px + 1
    return any(blocks.bounds(minus_multiple(x, side, block[3]))[0] > 0
               or blocks.bounds(minus_multiple(x, -side, block[3]))[1] < 0 for x in block[:3])


def bounds(block, s):
    """outside, crosses, or the bounds of the quotients X, Y and Z."""
    w = blocks.bounds(block[3])
    if w[1] <= 0:
        return "outside"
    crosses = w[0] <= 0
    far_out = not crosses and any(abs(x[0][0] // block[3][0][0]) > 4096 for x in block[:3])
    if (crosses or far_out) and beyond_a_side(block, s):
        return "outside"
    if crosses:
        return "crosses"
    return [quotient_bounds(x, block[3], out)
            for x, out in zip(block, (13, 13, s.depth_fraction + s.depth_guard))]


def action(block, count, s):
    seldom = "u" if count[0] <= count[1] else "v"
    xyz = bounds(block, s)
    if xyz == "outside":
        return xyz
    if xyz == "crosses":
        return seldom
    decided = blocks.rule(xyz, s)
    huge = [any(b[2][way] >= HUGE or b[3][way] >= HUGE for b in xyz) for way in (0, 1)]
    return seldom if decided == "u" and all(huge) else decided


def divide_corners(x, y, z, w, s):
    """The corners' quotients as three grids, or None if one does not exist."""
    outs = (13, 13, s.depth_fraction + s.depth_guard)
    if any(v <= 0 for column in w for v in column):
        return None
    grids = [[[half_up(a << max(out, 0), v << max(-out, 0)) for a, v in zip(column, w_column)]
              for column, w_column in zip(grid, w)] for grid, out in zip((x, y, z), outs)]
    if not all(fits(q, 31) for grid in grids for column in grid for q in column):
        return None
    return grids
