"""Models and solids (section 20)."""
from .notation import cross, dot, half_even
from .shading import unit14
from .words import arc, cosine, decimal, mul30, sine

ONE = 1 << 16


class Placing:
    def __init__(self, place, turn):
        self.place = place
        (sx, sy, sz), (cx, cy, cz) = map(sine, turn), map(cosine, turn)
        sysx, sycx = mul30(sy, sx), mul30(sy, cx)
        self.rows = (
            (mul30(cz, cy), mul30(cz, sysx) - mul30(sz, cx), mul30(cz, sycx) + mul30(sz, sx)),
            (mul30(sz, cy), mul30(sz, sysx) + mul30(cz, cx), mul30(sz, sycx) - mul30(cz, sx)),
            (-sy, mul30(cy, sx), mul30(cy, cx)))

    def world(self, local, n):
        return tuple(p + half_even(dot(row, local), 1 << (n + 14))
                     for p, row in zip(self.place, self.rows))

    def normal(self, v):
        turned = [dot(row, v) for row in self.rows]
        down = max(0, max(abs(t).bit_length() for t in turned) - 62)
        return unit14([t >> down for t in turned])


def model_word(text):
    return decimal(text, 32)


def upright(point):
    x, y, z = point
    return x, z, -y


def facet_normal(a, b, c):
    return cross([q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)])


def triangles(points):
    """A polygon as triples of its corners' numbers."""
    n = len(points)
    normal = [0, 0, 0]
    for k in range(n):
        p, q = points[k], points[(k + 1) % n]
        for axis in range(3):
            u, v = (axis + 1) % 3, (axis + 2) % 3
            normal[axis] += (p[u] - q[u]) * (p[v] + q[v])
    axis = max(range(3), key=lambda a: abs(normal[a]))
    u, v = (axis + 1) % 3, (axis + 2) % 3
    if normal[axis] < 0:
        u, v = v, u
    flat = [(p[u], p[v]) for p in points]
    left, present, found = list(range(n)), 0, []
    while len(left) >= 3:
        def around(k):
            return [left[(k + d) % len(left)] for d in (-1, 0, 1)]

        def ear(k):
            a, b, c = (flat[m] for m in around(k))
            return turn(a, b, c) > 0 and not any(
                turn(a, b, p) >= 0 and turn(b, c, p) >= 0 and turn(c, a, p) >= 0
                for p in (flat[m] for m in left) if p not in (a, b, c))
        order = [(present + k) % len(left) for k in range(len(left))]
        cut = next((k for k in order if ear(k)), present)
        found.append(around(cut))
        del left[cut]
        present = cut % len(left)
    return found


def turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def line_profile(r0, h0, r1, h1):
    return [tuple(half_even((a * (3 - j) + b * j) << 30, 3) for a, b in ((r0, r1), (h0, h1)))
            for j in range(4)]


def tube_profile(r, t, q):
    return [((r << 30) + t * c, t * s) for s, c in arc(q)]


def revolved(placing, profile, k):
    """Patch k of 16 control points; point (i, j) has index 4 j + i."""
    return [placing.world((radius * s, height << 30, radius * c), 76)
            for radius, height in profile for s, c in arc(k)]


def box_point(placing, size, face, i, j):
    def step(axis, m):
        return half_even(size[axis] * (2 * m - 3) << 30, 6)
    a, b = divmod(face, 2)
    local = [0, 0, 0]
    for axis, m in ((a, 3 * b), ((a + 1) % 3, i), ((a + 2) % 3, j)):
        local[axis] = step(axis, m)
    return placing.world(local, 46)


def examples():
    placing = Placing((ONE, 2 * ONE, 3 * ONE), (30 * ONE, 45 * ONE, 60 * ONE))
    for name, row in zip("xyz", placing.rows):
        yield f"rotation, row {name}", row
    scale = decimal("0.375", 48)
    facet = [upright([model_word(c) for c in p])
             for p in (("1.4", "-0.784", "2.4"), ("0", "0", "0"), ("0.1", "0", "0"))]
    yield ("point (1.4, -0.784, 2.4) of a model, z up, scale 0.375",
           placing.world([scale * c for c in facet[0]], 80))
    yield ("normal at the facet of it, (0, 0, 0), (0.1, 0, 0)",
           placing.normal(facet_normal(*facet)))
    star = [(0, 0, 0), (0, 9, 1), (0, 4, 4), (0, 5, 9), (0, 3, 5), (0, 0, 6), (0, 2, 3)]
    yield ("triangles of " + ", ".join(str(p) for p in star),
           [number for triangle in triangles(star) for number in triangle])
    yield ("torus r = 2, t = 1/2, patch 8 x 1 + 3, point (1, 2)",
           revolved(placing, tube_profile(2 * ONE, ONE // 2, 1), 3)[4 * 2 + 1])
    yield ("cone r = 1, top = 1/4, h = 2, patch 5, point (2, 1)",
           revolved(placing, line_profile(ONE, 0, ONE // 4, 2 * ONE), 5)[4 * 1 + 2])
    yield ("box (1, 2, 3), face 3, point (1, 2)",
           box_point(placing, (ONE, 2 * ONE, 3 * ONE), 3, 1, 2))
