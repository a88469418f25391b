#include "shadow/frame/inputs.hpp"

#include "shadow/ap120b/post_process.hpp"

namespace umbra78::shadow {

FrameStatus load_matrices(const Scene& scene, const Settings& settings, FrameMatrices& out) {
    using enum FrameStatus;
    const hw::MachineSpec& spec = settings.machine;
    if (hw::check(spec) != hw::SpecStatus::ok || !array_can(settings)) return spec_out_of_range;
    out.object = raster::object_format(scene.patches);
    const auto load = [&](const raster::View& view, hw::MatrixWords& words) {
        return raster::load_view(view, spec, out.object, words) == hw::LoadStatus::ok;
    };
    if (!load(scene.observer, out.world_to_observer)) return observer_matrix;
    if (!load(scene.light, out.world_to_light)) return light_matrix;
    if (!bias_in_quanta(settings.bias_q16, settings.bias_unit, bias_units(scene.light, spec),
                        out.bias_quanta_q16))
        return bias_out_of_range;
    const hw::RationalMatrix exact = raster::observer_to_light(scene.observer, scene.light, spec,
                                                               out.bias_quanta_q16);
    if (hw::load_matrix(exact, spec, hw::screen_words(spec), out.observer_to_light) !=
        hw::LoadStatus::ok)
        return shadow_matrix;
    if (settings.arithmetic == Arithmetic::ap120b) out.array = array_matrix(exact, settings);
    return ok;
}

}  // namespace umbra78::shadow
