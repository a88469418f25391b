"""A view sampled at places, not at its pixels' centres (shadow/rivals/scan_out.md, section 5)."""
from .notation import half_up
from .samples import triangle_depth
from .shadow_test import ScreenUnit, pixel_words
from .triangles import top_left, weights


class Places:
    """The points of the observer's store in a light's view, by the light's pixels."""

    def __init__(self, observer_z, matrix, s):
        self.codes, self.lists, self.s = {}, {}, s
        unit, edge = ScreenUnit(matrix, s), s.half_px * s.one_texel
        up = 8192 // s.one_texel
        for p, code in enumerate(observer_z):
            if code == s.background_code:
                continue
            px, py = p % s.size_px, p // s.size_px
            point = unit(*pixel_words(px, py, code, s))
            if point is None:
                continue
            x, y, own = point[0], point[1], point[2] + s.depth_offset
            if -edge <= x < edge and -edge <= y < edge and 0 <= own <= s.deepest_drawn:
                self.codes[p] = own
                self.lists.setdefault((x * up >> 13, y * up >> 13), []).append(
                    (px, py, x * up, y * up))

    def within(self, corners, grown):
        """Those in the box of the corners, grown on each side."""
        (x0, x1), (y0, y1) = ((min(v) - grown, max(v) + grown) for v in list(zip(*corners))[:2])
        half = self.s.half_px
        for row in range(max(y0 >> 13, -half), min(y1 >> 13, half - 1) + 1):
            for column in range(max(x0 >> 13, -half), min(x1 >> 13, half - 1) + 1):
                for place in self.lists.get((column, row), ()):
                    if x0 <= place[2] <= x1 and y0 <= place[3] <= y1:
                        yield place

    def of_block(self, grids):
        """As centre_samples."""
        for j in range(16):
            for i in range(16):
                p00, p10, p11, p01 = (tuple(g[k][m] for g in grids) for k, m in (
                    (i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
                for place in self.within((p00, p10, p11, p01), 128):
                    for k, triangle in enumerate(((p00, p10, p11), (p00, p11, p01))):
                        depth = triangle_depth(*triangle, *place[2:])
                        if depth is not None:
                            yield (*place, depth, i, j), k

    def of_triangle(self, triangle):
        """As triangle_samples."""
        a, b, c = triangle
        least = [0 if top_left(p, q) else 1 for p, q in ((b, c), (c, a), (a, b))]
        for place in self.within(triangle, 0):
            e = weights(triangle, place[2:])
            if all(map(int.__ge__, e, least)):
                rise = e[1] * (b[2] - a[2]) + e[2] * (c[2] - a[2])
                yield (*place, a[2] + half_up(rise, sum(e)), *e)

    def mask(self, least):
        """In shadow is a point whose own code is greater than the least at its place."""
        return [255 if self.codes.get(p, -1) > z else 0 for p, z in enumerate(least)]
