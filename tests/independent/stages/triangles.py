"""Drawing: facets to samples, and their shading (section 21).

A vertex is ten numbers: X, Y, Z, W, its object place (object words times 2^6) and its normal.  A
corner is the same with x, y, z in raster units instead of X, Y, Z.
"""
from . import notation
from .blocks import screen_words
from .notation import dot, half_up
from .perspective import divide_corners
from .shading import unit14


def guard_band(affine, s):
    """Its six planes in their order, as factors of X, Y, Z and W."""
    if affine:
        xy, z = 1 << 27, (s.depth_offset + (1 << max(0, s.depth_fraction))) << s.depth_guard
    else:
        xy, z = 1 << 14, s.half_px + (1 << max(0, -s.depth_fraction))
    return ((0, 0, 1, z), (0, 0, -1, z), (1, 0, 0, xy), (-1, 0, 0, xy), (0, 1, 0, xy),
            (0, -1, 0, xy))


def between(within, outside, d, beyond):
    """The new vertex between two, from their distances."""
    return tuple(n + half_up((m - n) * d, d - beyond) for n, m in zip(within, outside))


def cut(polygon, plane):
    """A polygon's part with d >= 0."""
    left = []
    for p, q in zip(polygon, polygon[1:] + polygon[:1]):
        d, e = dot(plane, p), dot(plane, q)
        if d >= 0:
            left.append(p)
        if d >= 0 > e:
            left.append(between(p, q, d, e))
        elif e >= 0 > d:
            left.append(between(q, p, e, d))
    return left


def within_guard_band(polygon, affine, s):
    """The vertices that are left of a facet's three."""
    planes = guard_band(affine, s)
    if any(all(dot(plane, vertex) < 0 for vertex in polygon) for plane in planes):
        return []
    for plane in planes:
        polygon = cut(polygon, plane)
    return polygon


def vertices(points, normals, loaded, s):
    """Those of a facet, from object words, and from normals or None."""
    screen = screen_words(points, loaded, s) + ([[1] * 3] if loaded.affine else [])
    return [(*place, *(word << 6 for word in point), *normal)
            for place, point, normal in zip(zip(*screen), points, normals or [(0, 0, 0)] * 3)]


def triangles(facet, affine, s, facing):
    """A facet's triangles of three corners, clockwise, or None if it has to be dropped."""
    left = within_guard_band(facet, affine, s)
    if len(left) < 3:
        return []
    if not affine:
        divided = divide_corners(*([axis] for axis in list(zip(*left))[:4]), s)
        if divided is None:
            return None
        xyz = zip(*(grid[0] for grid in divided))
        left = [(*corner, *vertex[3:]) for corner, vertex in zip(xyz, left)]
    fan = (clockwise(left[0], b, c, facing) for b, c in zip(left[1:], left[2:]))
    return [triangle for triangle in fan if triangle]


def cross(p, q, r):
    return (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1])


def clockwise(a, b, c, facing="both"):
    """The corners, b and c exchanged if the area is negative; None if nothing is drawn."""
    area = cross(a, b, c)
    side = "back" if area > 0 else "front"  # section 22
    if area == 0 or facing not in ("both", side):
        return None
    return (a, b, c) if area > 0 else (a, c, b)


def weights(triangle, c0):
    """e_a, e_b, e_c of a clockwise triangle; of its corners b and c these are Depth's weights.

    What has been exchanged is exchanged in the shading, too: t_b and t_c are made in the same way,
    and t_a is what they leave.
    """
    a, b, c = triangle
    return cross(b, c, c0), cross(c, a, c0), cross(a, b, c0)


def top_left(p, q):
    """Whether a centre on the edge is covered."""
    return q[1] < p[1] or (q[1] == p[1] and q[0] > p[0])


def pixels(values, s):
    """The pixels of one axis whose centres lie between the corners' values."""
    to_index = s.half_px * 8192 - 4096
    return range(max(0, -(-(min(values) + to_index) >> 13)),
                 min(s.size_px - 1, (max(values) + to_index) >> 13) + 1)


def triangle_samples(triangle, s):
    """(px, py, x, y, Z, e_a, e_b, e_c) of a clockwise triangle's samples, line by line"""
    a, b, c = triangle
    area = cross(a, b, c)
    # Whole numbers: > 0, or >= 0 on an edge whose centres are covered, is >= 1 or 0.
    least = [0 if top_left(p, q) else 1 for p, q in ((b, c), (c, a), (a, b))]
    xs, ys = (pixels([corner[k] for corner in triangle], s) for k in (0, 1))
    for py in ys:
        for px in xs:
            c0 = (2 * (px - s.half_px) + 1) * 4096, (2 * (py - s.half_px) + 1) * 4096
            e = weights(triangle, c0)
            if e[0] >= least[0] and e[1] >= least[1] and e[2] >= least[2]:
                rise = e[1] * (b[2] - a[2]) + e[2] * (c[2] - a[2])
                yield (px, py, *c0, a[2] + half_up(rise, area), *e)


def less_bits(words, bits):
    """The words without as many low bits as bring the largest of them to `bits` bits."""
    down = max(0, max(words).bit_length() - bits)
    return [word >> down for word in words]


def of_1024(e, w):
    """t_a, t_b, t_c from the corners' weights and W."""
    e_a, e_b, e_c = less_bits(e, 24)
    w_a, w_b, w_c = (max(1, word) for word in less_bits(w, 14))
    s = e_a * w_b * w_c, e_b * w_c * w_a, e_c * w_a * w_b
    t_b, t_c = (half_up(1024 * part, sum(s)) for part in s[1:])
    return 1024 - t_b - t_c, t_b, t_c


def own_normal(facet):
    """g, of the three vertices as the mesh gives them."""
    a, b, c = (vertex[4:7] for vertex in facet)
    return unit14(notation.cross([q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)]))


def facet_levels(shading, facet, smooth, triangle):
    """The levels at weights, as a function, and after them N if it is kept."""
    rows, own = list(zip(*triangle)), own_normal(facet)
    kept = shading.kept(own, shading.viewer.at([1024 * word for word in facet[0][4:7]])) \
        if shading.keeps_normals else ()

    def levels(e_a, e_b, e_c, shadowed=()):
        t = of_1024((e_a, e_b, e_c), rows[3])
        place, normal = ([dot(t, row) for row in part] for part in (rows[4:7], rows[7:]))
        if not smooth:
            normal = own
        to_lights = [to.at(place) for to in shading.towards]
        to_viewer = shading.viewer.at(place)
        if (dot(normal, own) < 0) != (dot(own, to_viewer) < 0):
            normal = [-n for n in normal]
        return (*shading.levels(normal, to_lights, to_viewer, shadowed, turn=False), *kept)
    return levels
