#include "tools/models/place_model.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace umbra78::tools {
namespace {

using raster::Facet;
using raster::UnitVector;
using raster::Vector;
using raster::Wide;
using raster::World;

Vector<Wide> upright(const ModelPoint& point, bool z_up) {
    const auto& [x, y, z] = point.word;
    return z_up ? Vector<Wide>{x, z, -y} : Vector<Wide>{x, y, z};
}

class Placer {
public:
    Placer(const ModelData& model, const ModelPlacing& how, const std::string& remedy,
           FirstError& error)
        : model_(model), how_(how), remedy_(remedy), error_(error) {}

    World world(const ModelPoint& point) {
        Vector<Wide> local = upright(point, how_.z_up);
        for (Wide& word : local) word = word * how_.scale;
        const raster::WideVector words =
            raster::placed(how_.placing, local, model_fraction + scale_fraction);
        if (raster::in_world(words)) return raster::world_of(words);
        error_.report(fmt::format("{}: this point lies at {} in the world, which ends at -32767 "
                                  "and 32767; {}", place_in(model_, point.line), print(words),
                                  remedy_));
        return {};
    }

    // Unit vector along rotation . direction: cut to 62 bits by floor, then unit14.
    UnitVector unit(const Vector<Wide>& direction) const {
        const Vector<Wide> turned = raster::rotated(how_.placing.rotation, direction);
        int bits = 0;
        for (const Wide& w : turned) bits = std::max(bits, w.bit_length());
        raster::WideVector cut{};
        for (std::size_t k = 0; k < 3; ++k)
            cut[k] = (turned[k] >> std::max(0, bits - 62)).to_int64();
        return raster::unit_vector(cut);
    }

private:
    static std::string print(const raster::WideVector& words) {
        const auto units = [](std::int64_t w) {
            return static_cast<double>(w) / (1 << raster::world_fraction);
        };
        return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", units(words[0]), units(words[1]),
                           units(words[2]));
    }

    const ModelData& model_;
    const ModelPlacing& how_;
    const std::string& remedy_;
    FirstError& error_;
};

bool is_flat(const Facet& facet) { return facet.normal[0] == Facet::flat; }

// The sum of the facets' normals at each vertex.
std::vector<Vector<Wide>> vertex_normals(const ModelData& model, bool z_up) {
    std::vector<Vector<Wide>> sums(model.vertices.size());
    for (const Facet& facet : model.facets) {
        std::array<Vector<Wide>, 3> p;
        for (std::size_t k = 0; k < 3; ++k)
            p[k] = upright(model.vertices[facet.vertex[k]], z_up);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            p[1][axis] -= p[0][axis];
            p[2][axis] -= p[0][axis];
        }
        const Vector<Wide> normal = raster::cross(p[1], p[2]);
        for (const std::uint32_t v : facet.vertex)
            for (std::size_t axis = 0; axis < 3; ++axis) sums[v][axis] += normal[axis];
    }
    return sums;
}

void place_normals(const ModelData& model, const ModelPlacing& how, const Placer& placer,
                   PlacedModel& out) {
    if (!how.smooth) {
        for (Facet& facet : out.facets) facet.normal.fill(Facet::flat);
        return;
    }
    for (const ModelPoint& normal : model.normals)
        out.normals.push_back(placer.unit(upright(normal, how.z_up)));
    if (std::none_of(model.facets.begin(), model.facets.end(), is_flat)) return;
    const std::vector<Vector<Wide>> sums = vertex_normals(model, how.z_up);
    const auto first = static_cast<std::uint32_t>(out.normals.size());
    for (const Vector<Wide>& sum : sums) out.normals.push_back(placer.unit(sum));
    for (Facet& facet : out.facets)
        if (is_flat(facet))
            for (std::size_t k = 0; k < 3; ++k) facet.normal[k] = first + facet.vertex[k];
}

}  // namespace

PlacedModel place_model(const ModelData& model, const ModelPlacing& how, const std::string& remedy,
                        FirstError& error) {
    Placer placer(model, how, remedy, error);
    PlacedModel out;
    for (const ModelPatch& patch : model.patches) {
        out.patches.emplace_back();
        for (std::size_t k = 0; k < patch.size(); ++k)
            out.patches.back().control[k] = placer.world(patch[k]);
    }
    for (const ModelPoint& vertex : model.vertices) out.vertices.push_back(placer.world(vertex));
    out.facets = model.facets;
    place_normals(model, how, placer, out);
    for (Facet& facet : out.facets)
        for (const std::uint32_t n : facet.normal)
            if (n != Facet::flat && out.normals[n] == UnitVector{}) {
                facet.normal.fill(Facet::flat);
                break;
            }
    return out;
}

}  // namespace umbra78::tools
