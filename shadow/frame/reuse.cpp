#include "shadow/frame/reuse.hpp"

#include "shadow/frame/drawing.hpp"
#include "shadow/frame/methods.hpp"

#include <algorithm>

namespace umbra78::shadow {
namespace {

bool same(const raster::Toward& a, const raster::Toward& b) {
    return a.to_point == b.to_point && a.direction == b.direction && a.point == b.point;
}

bool same_places(const raster::Mesh& a, const raster::Mesh& b) {
    return std::ranges::equal(a.vertices, b.vertices) &&
           std::ranges::equal(a.facets, b.facets,
                              [](const auto& p, const auto& q) { return p.vertex == q.vertex; });
}

// How patches become facets, and which facets are drawn.
bool same_facets(const FrameInputs& a, const FrameInputs& b) {
    const Settings &s = a.settings, &t = b.settings;
    const bool facets = s.surface == raster::PatchForm::diced || !a.scene.mesh.facets.empty();
    if (s.surface != t.surface || (facets && s.facing != t.facing)) return false;
    return s.surface == raster::PatchForm::catmull ||
           (s.dice_levels == t.dice_levels && dice_tolerance(a) == dice_tolerance(b));
}

// What both views' Z is drawn from, but for the view's own matrix.
bool same_drawing(const FrameInputs& a, const FrameInputs& b) {
    const hw::MachineSpec &m = a.settings.machine, &n = b.settings.machine;
    const hw::WordFormat &f = a.matrices.object, &g = b.matrices.object;
    return a.scene.ground == b.scene.ground && std::ranges::equal(a.scene.blobs, b.scene.blobs) &&
           m.xy_bits == n.xy_bits && m.z_bits == n.z_bits &&
           m.coefficient_bits == n.coefficient_bits &&
           m.transform_rounding == n.transform_rounding && m.depth_rounding == n.depth_rounding &&
           m.depth_store == n.depth_store &&
           a.settings.sampling == b.settings.sampling && same_facets(a, b) && f.bits == g.bits &&
           f.fraction == g.fraction &&
           std::equal(a.scene.patches.begin(), a.scene.patches.end(), b.scene.patches.begin(),
                      b.scene.patches.end(),
                      [](const auto& p, const auto& q) { return p.control == q.control; }) &&
           same_places(a.scene.mesh, b.scene.mesh);
}

// What the light's map keeps of its drawing.
bool same_map(const FrameInputs& a, const FrameInputs& b, std::size_t l) {
    if (method_of(a).has_map() != method_of(b).has_map()) return false;
    if (!method_of(b).has_map()) return true;  // a shadow keeps no depth
    const raster::Casters c = casters_of(a, l), d = casters_of(b, l);
    return a.settings.map_depth == b.settings.map_depth && c.slope_q8 == d.slope_q8 &&
           (c.slope_q8 == 0 || c.limit == d.limit);
}

bool same_surfaces(const FrameInputs& a, const FrameInputs& b) {
    const auto equal = [](const auto& p, const auto& q, auto&& alike) {
        return std::equal(p.begin(), p.end(), q.begin(), q.end(), alike);
    };
    const auto alike = [](const auto& p, const auto& q) { return p.material == q.material; };
    return equal(a.scene.patches, b.scene.patches, alike) &&
           equal(a.scene.mesh.facets, b.scene.mesh.facets,
                 [&](const auto& p, const auto& q) {
                     return alike(p, q) && p.normal == q.normal;
                 }) &&
           std::ranges::equal(a.scene.mesh.normals, b.scene.mesh.normals) &&
           std::ranges::equal(a.scene.materials, b.scene.materials);
}

bool same_shading(const FrameInputs& a, const FrameInputs& b) {
    const auto viewer = [](const FrameInputs& f) {
        return raster::toward_eye(f.scene.observer, f.matrices.object);
    };
    bool alike = same_surfaces(a, b) && a.settings.ambient_q8 == b.settings.ambient_q8 &&
                 a.settings.shading == b.settings.shading &&
                 same(viewer(a), viewer(b));
    for (std::size_t s = 0; s < b.scene.sources_used(); ++s) {
        const Source was = a.scene.source(s), is = b.scene.source(s);
        alike = alike && was.level_q8 == is.level_q8 &&
                same(raster::toward_eye(was.place, a.matrices.object),
                     raster::toward_eye(is.place, b.matrices.object));
    }
    return alike;
}

bool same_dither(const Settings& a, const Settings& b) {
    const bool silent_a = hw::silent(a.dither, a.machine);
    const bool silent_b = hw::silent(b.dither, b.machine);
    if (silent_a || silent_b) return silent_a == silent_b;
    return a.dither.shape == b.dither.shape && a.dither.size_q8 == b.dither.size_q8 &&
           a.dither.seed == b.dither.seed;
}

bool same_window(const Settings& a, const Settings& b) {
    if (!has_window(a.lookup)) return true;
    return a.taps == b.taps && a.tap_places == b.tap_places &&
           (a.tap_places == TapPlaces::grid || a.dither.seed == b.dither.seed);
}

bool same_receiver(const FrameInputs& a, const FrameInputs& b, std::size_t l) {
    const Settings &s = a.settings, &t = b.settings;
    const LightMatrices &m = a.matrices.lights[l], &n = b.matrices.lights[l];
    if (s.receiver != t.receiver || reads_normals(s) != reads_normals(t)) return false;
    if (s.receiver == Receiver::point) return true;
    if (reads_normals(s) && (m.axes != n.axes || m.scale != n.scale)) return false;
    if (s.receiver == Receiver::plane) return plane_limit(a, l) == plane_limit(b, l);
    return s.normal_offset_q8 == t.normal_offset_q8 && m.scale == n.scale;
}

bool same_place(const raster::View& a, const raster::View& b) {
    return a.projection == b.projection && a.axes == b.axes && a.target == b.target &&
           a.distance == b.distance;
}

// A rival's words come from the views themselves, and their fraction from all lights.
bool same_rival(const FrameInputs& a, const FrameInputs& b) {
    const auto lights = [](const FrameInputs& f) {
        return std::span(f.scene.lights).first(f.scene.light_count);
    };
    return a.settings.dice_levels == b.settings.dice_levels &&
           same_place(a.scene.observer, b.scene.observer) &&
           a.scene.observer.extent == b.scene.observer.extent &&
           std::ranges::equal(lights(a), lights(b), same_place);
}

// How a point is tested against light l, given both Z planes; the bias is in the matrix.
bool same_test(const FrameInputs& a, const FrameInputs& b, std::size_t l) {
    if (method_of(b).on_ground()) return true;  // nothing is tested
    if (is_rival(b.settings.form)) return same_rival(a, b);
    const Settings &s = a.settings, &t = b.settings;
    const LightMatrices &m = a.matrices.lights[l], &n = b.matrices.lights[l];
    const bool bilinear = s.lookup == Lookup::bilinear;
    return m.observer_to_light == n.observer_to_light && m.array == n.array &&
           s.machine.fraction_bits == t.machine.fraction_bits &&
           hw::product_cut(s.machine) == hw::product_cut(t.machine) &&
           (m.observer_to_light.affine || s.machine.divide_order == t.machine.divide_order) &&
           s.registration == t.registration && s.lookup == t.lookup &&
           (!bilinear || s.background == t.background) && same_window(s, t) &&
           same_dither(s, t) && same_receiver(a, b, l);
}

bool same_filters(const Settings& a, const Settings& b, bool shadow_in_shading) {
    return a.dequantize_passes == b.dequantize_passes &&
           a.low_pass_passes == b.low_pass_passes &&
           (shadow_in_shading || (a.density_q8 == b.density_q8 && a.composite == b.composite));
}

}  // namespace

Reuse find_reuse(const FrameInputs& before, const FrameInputs& now) {
    Reuse r;
    if (FrameShape(before.scene) != FrameShape(now.scene)) return r;  // other planes
    if (before.scene.streamed || now.scene.streamed) return r;  // surfaces that nobody holds
    const bool drawing = same_drawing(before, now);
    const bool method = &method_of(before) == &method_of(now);
    const bool when_drawn = method_of(now).tests_when_drawn();
    const bool in_shading = method_of(now).in_shading;
    r.depth = drawing && before.matrices.world_to_observer == now.matrices.world_to_observer;
    const bool by_normals = keeps_normals(now);
    r.observer = r.depth && same_shading(before, now) && (!by_normals || keeps_normals(before)) &&
                 when_drawn == method_of(before).tests_when_drawn();
    bool masks = true;
    for (std::size_t l = 0; l < now.scene.light_count; ++l) {
        r.light_map[l] = drawing && same_map(before, now, l) &&
                         before.matrices.lights[l].world_to_light ==
                             now.matrices.lights[l].world_to_light;
        r.mask[l] = method && (by_normals ? r.observer : r.depth) && r.light_map[l] &&
                    same_test(before, now, l);
        masks = masks && r.mask[l];
    }
    // Sectors have one mask.
    for (std::size_t s = 0; s < now.scene.sources_used(); ++s) {
        const Source source = now.scene.source(s);
        if (!source.sectored) continue;
        const auto of_source = std::span(r.mask).subspan(source.first_light, source.lights);
        const bool all = std::ranges::find(of_source, false) == of_source.end();
        std::ranges::fill(of_source, all);
    }
    // Tested when drawn, intensities and masks are made together: all are kept or none is.
    if (when_drawn && !(r.observer && masks)) {
        r.observer = masks = false;
        r.mask = {};
        if (!method_of(now).has_map()) r.light_map = {};  // the shadow has been drawn over
    }
    bool ramps = true;
    for (std::size_t s = 0; s < now.scene.sources_used(); ++s)
        ramps = ramps && before.scene.source(s).ramp_px == now.scene.source(s).ramp_px;
    r.picture = r.observer && masks && ramps &&
                same_filters(before.settings, now.settings, in_shading);
    return r;
}

}  // namespace umbra78::shadow
