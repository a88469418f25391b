#include "shadow/frame/inputs.hpp"

#include "hw/sectors.hpp"
#include "raster/extent.hpp"
#include "raster/planar.hpp"
#include "shadow/filters/ramp.hpp"
#include "shadow/frame/features.hpp"
#include "shadow/frame/methods.hpp"
#include "shadow/frame/rivals.hpp"

namespace umbra78::shadow {
namespace {

// The rows that all sectors of a source share are the rows W of those that look along +x, +y, +z.
hw::LoadStatus load_sector(const Scene& scene, const Source& source,
                           const hw::RationalMatrix& exact, const hw::MachineSpec& spec,
                           hw::MatrixWords& out) {
    std::array<hw::ExactRow, 3> directions;
    for (std::size_t a = 0; a < 3; ++a)
        directions[a] = raster::observer_to_light(scene.observer,
                                                  scene.lights[source.first_light + 2 * a], spec,
                                                  0)[3];
    return hw::load_sector(directions, exact[2], spec, hw::screen_words(spec), out);
}

FrameStatus load_light(const Scene& scene, std::size_t l, const Settings& settings,
                       FrameMatrices& out) {
    using enum FrameStatus;
    const hw::MachineSpec& spec = settings.machine;
    const raster::View& light = scene.lights[l];
    LightMatrices& m = out.lights[l];
    m.array = {};
    if (raster::load_view(light, spec, out.object, m.world_to_light) != hw::LoadStatus::ok)
        return light_matrix;
    if (!bias_in_quanta(settings.bias_q16, settings.bias_unit, bias_units(light, spec),
                        m.bias_quanta_q16) ||
        !bias_in_quanta(settings.bias_clamp_q16, settings.bias_unit, bias_units(light, spec),
                        m.clamp_quanta_q16))
        return bias_out_of_range;
    m.scale = light_scale(light, spec, m.bias_quanta_q16);
    m.axes = light_axes(light);
    const hw::RationalMatrix exact =
        raster::observer_to_light(scene.observer, light, spec, m.bias_quanta_q16);
    const hw::LoadStatus loaded =
        scene.source_of(l).sectored
            ? load_sector(scene, scene.source_of(l), exact, spec, m.observer_to_light)
            : hw::load_matrix(exact, spec, hw::screen_words(spec), m.observer_to_light);
    if (loaded != hw::LoadStatus::ok) return shadow_matrix;
    const Method& method = *method_of(settings);
    if (method.load != nullptr) method.load(exact, settings, m);
    return ok;
}

// What draws the light's shadow on the ground. The light's own view serves its place or direction
// alone, and blobs do not ask for a light.
FrameStatus load_on_ground(const Scene& scene, std::size_t l, const Settings& settings,
                           FrameMatrices& out) {
    const hw::MachineSpec& spec = settings.machine;
    out.lights[l] = {};
    if (settings.form == Form::blob) {
        out.lights[l].world_to_light = out.world_to_observer;
        return FrameStatus::ok;
    }
    if constexpr (hw::built(hw::Feature::ground)) {
        hw::RationalMatrix exact;
        if (!raster::planar_shadow(scene.observer, scene.lights[l], scene.surfaces(), scene.ground,
                                   spec, exact))
            return FrameStatus::light_in_ground;
        if (raster::load_view(exact, spec, out.object, out.lights[l].world_to_light) !=
            hw::LoadStatus::ok)
            return FrameStatus::light_matrix;
    }
    return FrameStatus::ok;
}

hw::WordFormat format_of(const Scene& scene, Form form) {
    if (scene.streamed) return raster::object_format(scene.largest_streamed);
    if (!hw::built(hw::Feature::ground) || form != Form::blob)
        return raster::object_format(scene.surfaces());
    raster::Box box;
    const auto add = [&](const raster::World& p) { box.add(p); };
    scene.surfaces().for_points(add);
    for (const raster::Ellipse& blob : scene.blobs) {
        std::array<raster::Patch, raster::patches_per_ellipse> patches;
        raster::ellipse_patches(blob, patches);
        raster::Surfaces(patches).for_points(add);
    }
    return raster::object_format(box.largest());
}

}  // namespace

bool Scene::in_order() const {
    if (light_count > max_lights || sources_used() > max_sources) return false;
    std::size_t next = 0;
    for (std::size_t s = 0; s < source_count; ++s) {
        if (sources[s].first_light != next || sources[s].lights == 0) return false;
        if (sources[s].sectored && sources[s].lights != hw::sector_count) return false;
        const int ramp_px = sources[s].ramp_px;
        if (ramp_px < 0 || ramp_px > max_ramp_px || (ramp_px > 0 && sources[s].has_area()))
            return false;
        next += sources[s].lights;
    }
    return source_count == 0 || next == light_count;
}

FrameStatus load_matrices(const Scene& scene, const Settings& settings, FrameMatrices& out) {
    using enum FrameStatus;
    const hw::MachineSpec& spec = settings.machine;
    fixed::require(scene.in_order(), "scene with too many lights, or lights that no source has");
    if (!missing_feature(scene, settings).empty()) return not_built;
    if (hw::check(spec) != hw::SpecStatus::ok || !method_can(settings)) return spec_out_of_range;
    const Method& method = *method_of(settings);
    for (std::size_t s = 0; s < scene.sources_used(); ++s) {
        if (method.in_shading && scene.source(s).is_graded()) return area_when_drawn;
        if (scene.source(s).sectored && !method.takes_sectors) return sectors_refused;
    }
    const bool on_ground = method.on_ground();
    if (on_ground && (scene.streamed || scene.ground >= scene.patches.size())) return no_ground;
    out.object = format_of(scene, settings.form);
    if (raster::load_view(scene.observer, spec, out.object, out.world_to_observer) !=
        hw::LoadStatus::ok)
        return observer_matrix;
    if constexpr (hw::built(hw::Feature::rivals)) {
        if (is_rival(settings.form)) {  // which has no light's view
            for (std::size_t l = 0; l < scene.light_count; ++l) {
                out.lights[l] = {};
                out.lights[l].world_to_light = out.world_to_observer;
            }
            return check_rival(scene, settings);
        }
    }
    if (scene.streamed && !method.has_map()) return rival_of_stream;
    for (std::size_t l = 0; l < scene.light_count; ++l) {
        const FrameStatus status =
            on_ground ? load_on_ground(scene, l, settings, out)
                      : load_light(scene, l, settings, out);
        if (status != ok) return status;
    }
    return ok;
}

}  // namespace umbra78::shadow
