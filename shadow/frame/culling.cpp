#include "shadow/frame/culling.hpp"

#include "hw/sectors.hpp"
#include "shadow/frame/methods.hpp"
#include "shadow/post_process.hpp"

#include <algorithm>

namespace umbra78::shadow {
namespace {

using raster::Footprint;

// Whether a surface may have samples in a view: false of what the drawing leaves out as outside;
// else the footprint holds all of them.
class PatchView {
public:
    PatchView(const FrameInputs& in, const hw::MatrixWords& matrix) : in_(in), matrix_(matrix) {}

    bool seen(const raster::Patch& patch, Footprint& footprint) const {
        const hw::MachineSpec& spec = in_.settings.machine;
        const hw::WordFormat object = in_.matrices.object;
        if constexpr (hw::built(hw::Feature::dicing)) {
            if (in_.settings.surface == raster::PatchForm::diced)
                return raster::DicedView(spec, matrix_, object).footprint(patch, footprint) !=
                       raster::Visibility::outside;
        }
        return raster::patch_footprint(patch, matrix_, spec, object, footprint) !=
               raster::Visibility::outside;
    }

private:
    const FrameInputs& in_;
    const hw::MatrixWords& matrix_;
};

class FacetView {
public:
    FacetView(const FrameInputs& in, const hw::MatrixWords& matrix)
        : all_(raster::whole_frame(in.settings.machine)),
          walk_(in.settings.machine, matrix, in.matrices.object, hw::UnitWork{}, false) {
        walk_.begin(in.scene.mesh);
    }

    // A facet of which a corner has no quotient is not drawn, but that is for the drawing to say.
    bool seen(const raster::Facet& facet, Footprint& footprint) {
        const auto outcome = walk_.project(facet);
        footprint = all_;
        return outcome == raster::FacetWalk::Outcome::unresolved ||
               (outcome != raster::FacetWalk::Outcome::outside && walk_.footprint(footprint));
    }

    // Whether all of the mesh is seen: its vertices are fewer than its facets' corners.
    bool sees_all(const raster::Mesh& mesh) {
        std::array<raster::SeenVertex, raster::FacetWalk::run> seen;
        for (std::size_t k = 0; k < mesh.vertices.size(); k += seen.size()) {
            walk_.see_run(static_cast<std::uint32_t>(k), seen.data());
            std::uint32_t any = 0;
            for (std::size_t n = 0; n < std::min(seen.size(), mesh.vertices.size() - k); ++n)
                any |= seen[n].outside;
            if (any != 0) return false;
        }
        return true;
    }

private:
    Footprint all_;
    raster::FacetWalk walk_;
};

// Input words of the unit, both ends inclusive.
struct WordBox {
    std::array<std::int32_t, 2> x, y, z;
};

// Pixels by their outer edges and one more all round, so that a pixel's centre, its index and any
// point of it, half a pixel off or not, lie within.
WordBox word_box(const Footprint& f, const Settings& s) {
    Settings index = s;
    index.registration = Registration::index;  // a pixel's left and upper edge
    const hw::Words low = pixel_words(f.x0 - 1, f.y0 - 1, f.nearest, index);
    const hw::Words high = pixel_words(f.x1 + 2, f.y1 + 2, f.farthest, index);
    return {{low.x, high.x}, {low.y, high.y}, {low.z, high.z}};
}

// The largest dither word's magnitude.
std::int64_t max_dither(const Settings& s) {
    const int k = hw::uniforms(s.dither.shape);
    if (k == 0) return 0;
    const std::int64_t a = fixed::dither_amplitude(k, s.dither.size_q8, s.machine.fraction_bits);
    return fixed::floor_shift(255 * k * a, 16) + 1;
}

struct Extremes {
    std::int64_t min = INT64_MAX, max = INT64_MIN;
    void add(std::int64_t v) {
        min = std::min(min, v);
        max = std::max(max, v);
    }
    bool beyond(std::int64_t low, std::int64_t high) const {
        return max < low || min > high;
    }
};

// The eight corners of a box, in the order of `box.x[k & 1]`, y by the next bit, z by the third.
template <class Visit>
void for_corners(const WordBox& box, Visit&& visit) {
    for (std::size_t corner = 0; corner < 8; ++corner)
        visit(hw::Words{box.x[corner & 1], box.y[corner >> 1 & 1], box.z[corner >> 2]});
}

// Whether a point of the box, dithered, may lie in the light's volume.
bool may_reach(const WordBox& box, const FrameInputs& in, const hw::MatrixWords& matrix) {
    const Settings& s = in.settings;
    if (s.receiver == Receiver::normal) return true;  // points are moved, nobody says how far
    if (!matrix.affine && s.machine.divide_order == hw::DivideOrder::round_first) return true;
    const hw::TransformUnit unit(s.machine, matrix);
    Extremes x, y, z;
    bool decided = true;
    for_corners(box, [&](const hw::Words& words) {
        const hw::Point p = unit(words);
        // Overflow saturates, which keeps the order; without a quotient there is none.
        decided = decided && p.status != hw::DivideStatus::divisor_not_positive;
        x.add(p.x);
        y.add(p.y);
        z.add(p.z + s.machine.depth_offset());
    });
    if (!decided) return true;
    const std::int64_t noise = max_dither(s);
    const std::int64_t edge = std::int64_t{s.machine.half_px()} << s.machine.fraction_bits;
    return !x.beyond(-edge - noise, edge - 1 + noise) &&
           !y.beyond(-edge - noise, edge - 1 + noise) &&
           !z.beyond(0, s.machine.deepest_drawn());
}

// Whether a point of the box may lie in a sector's cone: a row's sum takes its min and max at
// corners, too.
bool may_lie_in(int sector, const WordBox& box, const FrameInputs& in,
                const hw::MatrixWords& matrix) {
    const hw::SectorUnit unit(in.settings.machine, matrix, sector);
    std::array<Extremes, 3> d;
    for_corners(box, [&](const hw::Words& words) {
        const hw::Direction at = unit.direction(words);
        for (std::size_t a = 0; a < 3; ++a) d[a].add(at[a]);
    });
    const Extremes& ahead = d[hw::axis_of(sector)];
    const std::int64_t w_max = hw::looks_back(sector) ? -ahead.min : ahead.max;
    return w_max > 0 && std::ranges::all_of(d, [&](const Extremes& e) {
               return &e == &ahead || !e.beyond(-w_max, w_max);
           });
}

// Whether something in the box may come into the light's volume.
bool may_reach_light(const WordBox& box, const FrameInputs& in, std::size_t light) {
    const hw::MatrixWords& matrix = in.matrices.lights[light].observer_to_light;
    const Source source = in.scene.source_of(light);
    if (!source.sectored) return may_reach(box, in, matrix);
    return may_lie_in(static_cast<int>(light - source.first_light), box, in, matrix);
}

}  // namespace

Reach cull(const FrameInputs& in, std::size_t light) {
    const LightMatrices& m = in.matrices.lights[light];
    Reach reach;
    const auto count = [&](bool light_sees, bool observer_sees, const Footprint& footprint) {
        if (!light_sees) ++reach.outside_light;
        if (!observer_sees) {
            ++reach.outside_observer;
        } else if (!reach.into_light) {
            reach.into_light = may_reach_light(word_box(footprint, in.settings), in, light);
        }
    };
    const bool has_map = method_of(in).has_map();
    // A blob has a place of its own; a rival's light has no view.
    const bool all_cast = method_of(in).form == Form::blob || !method_of(in).draws_light();
    reach.into_light = !has_map;  // no pixel is moved there
    const auto count_all = [&](const auto& surfaces, auto light_view, auto observer_view,
                               std::size_t ground) {
        Footprint of_light{}, of_observer{};
        for (std::size_t k = 0; k < surfaces.size(); ++k)
            count(k == ground || all_cast || light_view.seen(surfaces[k], of_light),
                  observer_view.seen(surfaces[k], of_observer), of_observer);
    };
    count_all(in.scene.patches, PatchView(in, m.world_to_light),
              PatchView(in, in.matrices.world_to_observer),
              has_map ? Scene::no_ground : in.scene.ground);
    if constexpr (hw::built(hw::Feature::triangles)) {
        const raster::Mesh& mesh = in.scene.mesh;
        FacetView light_view(in, m.world_to_light);
        FacetView observer_view(in, in.matrices.world_to_observer);
        if (light_view.sees_all(mesh) && observer_view.sees_all(mesh)) {
            Footprint footprint{};
            for (std::size_t k = 0; k < mesh.facets.size() && !reach.into_light; ++k)
                count(true, observer_view.seen(mesh.facets[k], footprint), footprint);
        } else {
            count_all(mesh.facets, light_view, observer_view, Scene::no_ground);
        }
    }
    return reach;
}

}  // namespace umbra78::shadow
