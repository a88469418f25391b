"""Bias that follows the surface (section 24)."""
from .float_store import kept
from .samples import z_code
from .triangles import cross


def leaf_triangles(corners, i, j, k):
    """A leaf's triangle k, or for None both."""
    p00, p10, p11, p01 = (tuple(grid[k][m] for grid in corners) for k, m in (
        (i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
    both = (p00, p10, p11), (p00, p11, p01)
    return both if k is None else both[k:k + 1]


def slope(a, b, c):
    """Of a triangle, in raster units a texel."""
    area = abs(cross(a, b, c))
    if area == 0:
        return 0
    rise_x = (b[2] - a[2]) * (c[1] - a[1]) - (c[2] - a[2]) * (b[1] - a[1])
    rise_y = (c[2] - a[2]) * (b[0] - a[0]) - (b[2] - a[2]) * (c[0] - a[0])
    return min(2**31 - 1, -(-8192 * max(abs(rise_x), abs(rise_y)) // area))


def offset(slopes, factor, limit):
    """How far samples of these slopes are moved; no limit is None."""
    moved = -(-max(slopes) * factor // 256)
    return moved if limit is None else min(moved, limit)


def moved_code(depth, more, s):
    """The code of a depth that is moved away from the light, or None for no sample."""
    code = z_code(depth, s)
    if code is None or more == 0:
        return code
    moved = z_code(depth + more, s)
    return kept(s.deepest_drawn, s) if moved is None else moved


class Casters:
    """What is drawn into the light's map, and how much deeper."""

    def __init__(self, light, s):
        self.s = s
        self.facing = "back" if s.map_depth == "back" else s.facing
        clamp = light.bias_quanta(s.bias_clamp, s.bias_unit, s)
        self.limit = (clamp << s.depth_guard) >> 16 if s.bias_clamp else None

    def leaf(self, corners, samples):
        """A block's samples and how far each is moved."""
        for sample, k in samples:
            of = leaf_triangles(corners, *sample[5:7], k)
            if self.s.map_depth != "back" or sum(cross(*triangle) for triangle in of) > 0:
                yield sample, self.offset(of)

    def facet(self, triangle, samples):
        more = self.offset([[corner[:3] for corner in triangle]])
        for sample in samples:
            yield sample, more

    def offset(self, triangles):
        s = self.s
        if s.bias_slope == 0:
            return 0
        return offset([slope(*triangle) for triangle in triangles], s.bias_slope, self.limit)


class Layers:
    """The two least different codes of each texel, and what the map makes of them."""

    def __init__(self, s):
        self.s = s
        self.found = [set() for _ in range(s.size_px * s.size_px)]

    def add(self, p, code):
        two = self.found[p] | {code}
        self.found[p] = set(sorted(two)[:2])

    def midpoints(self):
        background = self.s.background_code
        two = [(sorted(codes) + [background] * 2)[:2] for codes in self.found]
        return [background if z1 + z2 >> 1 == background else kept(z1 + z2 >> 1, self.s)
                for z1, z2 in two]
