"""Drawing: patches to blocks (section 6); in perspective with section 14's bounds."""
from . import perspective
from .notation import half_up, shift_down

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
    """min, max, (slope_u, slope_v), (bend_u, bend_v)"""
    f, gu, gv, guv = comp
    mu, mv, muv = (max(max(g), -min(g)) for g in (gu, gv, guv))
    reach = mu + mv + muv

    def step(q, way):
        (a, b), (c, d) = ALONG[way]
        return max(abs(q[b] - q[a]), abs(q[d] - q[c]))
    slopes = (step(f, 1) + 4 * mu + step(gv, 1) + 4 * muv,
              step(f, 2) + 4 * mv + step(gu, 2) + 4 * muv)
    return min(f) - reach, max(f) + reach, slopes, (mu + muv, mv + muv)


def rule(xyz, s):
    """outside, draw, u or v, from the bounds of X, Y and Z."""
    edge = s.half_px * 8192 + 128
    limits = (edge, edge, (s.depth_offset + 1) << s.depth_guard)
    if any(b[1] < -limit or b[0] > limit for b, limit in zip(xyz, limits)):
        return "outside"
    if (all(max(abs(b[0]), abs(b[1])) < 1 << 29 and max(b[3]) <= 8192 for b in xyz)
            and all(sum(b[2]) <= 126976 for b in xyz[:2])):
        return "draw"
    urge = [max([16 * b[3][way] for b in xyz] + [b[2][way] for b in xyz[:2]])
            for way in (0, 1)]
    return "u" if urge[0] >= urge[1] else "v"


def action(block, count, affine, s):
    if affine:
        return rule([bounds(comp) for comp in block[:3]], s)
    return perspective.action(block, count, s)


class Counts:
    def __init__(self):
        self.tested = self.splits = self.drawn = self.samples = self.unresolved = 0


def blocks(patch, affine, s, counts):
    """The blocks to draw of a patch, given as its screen components and any others."""
    todo, splits = [(patch, (0, 0))], 0
    while todo:
        block, count = todo.pop()
        counts.tested += 1
        decided = action(block, count, affine, s)
        if decided == "draw":
            yield block
        elif decided != "outside":
            way = "uv".index(decided)
            if count[way] == 24:
                way = 1 - way
            if count[way] == 24 or splits == 1 << 20:
                counts.unresolved += 1
                continue
            splits += 1
            counts.splits += 1
            count = (count[0] + (way == 0), count[1] + (way == 1))
            todo += [(half, count) for half in zip(*(split(comp, way + 1) for comp in block))]


def screen_words(points, loaded, s):
    """X, Y, Z of places in object words, or in perspective X, Y, Z, W: a list each."""
    rounding = s.rounding("transform")
    if loaded.affine:
        shifts = [loaded.shift(r, out, s)
                  for r, out in enumerate((13, 13, s.depth_fraction + s.depth_guard))]
    else:
        shifts = perspective.shifts(loaded, s)
    return [[shift_down(a * x + b * y + c * z + d * loaded.one, n, rounding)
             for x, y, z in points]
            for (a, b, c, d), n in zip(loaded.words, shifts)]


def screen_components(points, loaded, s):
    """X, Y, Z of a patch's object words, or in perspective X, Y, Z, W."""
    return [component(p) for p in screen_words(points, loaded, s)]
