"""The frame store and a whole drawing (section 8)."""
from .bias import Casters, Layers, moved_code
from .blocks import Counts, blocks, component, screen_components
from .samples import block_corners, samples
from .transform_unit import Loaded
from .triangles import facet_levels, triangle_samples, triangles, vertices


def draw(patches, facets, object_fraction, view, s, record=None, shading=None, places=None):
    """The planes of a view of the object words, and counts of patches.

    A facet is three places in object words, and three normals or None.  Without `record` the store
    keeps codes only, as the light's does, by section 24.  Else record(levels)(sample, code) is what
    is compared after the code: intensity, direct and any others.  `places` are where the view is
    sampled in place of its pixels' centres; the planes are then those of the places' own pixels.
    """
    planes = [s.background_code] * (s.size_px * s.size_px)
    stored = {}
    counts = Counts()

    def store(found, shaded):
        """Puts the samples into the store, and returns how many have a code."""
        number = 0
        for sample, more in found:
            px, py = sample[:2]
            code, p = moved_code(sample[4], more, s), py * s.size_px + px
            if code is None:
                continue
            number += 1
            if layers:
                layers.add(p, code)
            if code > planes[p]:
                continue
            if not record:
                planes[p] = code
                continue
            values = shaded(sample, code)
            if code < planes[p] or p not in stored or values < stored[p]:
                planes[p], stored[p] = code, values
        return number

    casters = None if record else Casters(view, s)
    layers = None if record or s.map_depth != "midpoint" else Layers(s)
    facing = s.facing if record else casters.facing

    def of_leaf(grids, found):
        return casters.leaf(grids, found) if casters else ((sample, 0) for sample, _ in found)

    def of_facet(triangle, found):
        return casters.facet(triangle, found) if casters else ((sample, 0) for sample in found)
    loaded = Loaded(view.world_to_screen(s), object_fraction, 1 << 14, s)
    screen = 3 if loaded.affine else 4
    for patch in patches:
        components = screen_components(patch, loaded, s)
        if record:
            components += [component([word << 6 for word in words]) for words in zip(*patch)]
        for block in blocks(components, loaded.affine, s, counts):
            grids = block_corners(block, loaded.affine, s)
            if grids is None:
                counts.unresolved += 1
                continue
            counts.drawn += 1
            shaded = record and record(shading.block(block[screen:]))
            counts.samples += store(
                of_leaf(grids, places.of_block(grids) if places else samples(grids, s)), shaded)
    for points, normals in facets:
        facet = vertices(points, normals, loaded, s)
        for triangle in triangles(facet, loaded.affine, s, facing) or ():
            shaded = record and record(facet_levels(shading, facet, normals is not None,
                                                    triangle))
            found = places.of_triangle(triangle) if places else triangle_samples(triangle, s)
            store(of_facet(triangle, found), shaded)
    width = len(next(iter(stored.values()), (0, 0)))
    rest = [[stored[p][k] if p in stored else 0 for p in range(len(planes))]
            for k in range(width)]
    return layers.midpoints() if layers else planes, rest, counts
