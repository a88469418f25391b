#include "shadow/rivals/dicing.hpp"

namespace umbra78::shadow::rivals {

MeshSize diced_size(const raster::Surfaces& surfaces, int levels) {
    const std::size_t cells = std::size_t{1} << levels, patches = surfaces.patches.size();
    return {surfaces.mesh.vertices.size() + patches * (cells + 1) * (cells + 1),
            surfaces.mesh.facets.size() + patches * 2 * cells * cells};
}

void add_diced(const raster::Surfaces& surfaces, int levels, const ToWords& to,
               raster::DiceMemory& memory, MeshBuilder& out) {
    const raster::DiceLevels all{levels, {levels, levels, levels, levels}};
    for (const raster::Patch& patch : surfaces.patches)
        out.add(raster::dice(patch, all, false, memory), to);
    out.add(surfaces.mesh, to);
}

}  // namespace umbra78::shadow::rivals
