// The answer of a scene, by the machine: the study's searches (tools/study/bias/search.hpp), for
// each kind of bias.
#include "tools/bias/answer.hpp"
#include "tools/study/bias/search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace umbra78::tools::bias {
namespace {

using namespace study;

// Slope factors and normal offsets are searched from 0 to 4 texels, in 16ths of one.
constexpr int parts = 16, coarse = 4, max_amount = 4 * parts;

struct Measured {
    std::optional<double> amount;    // of what was searched
    std::optional<double> detaches;  // world units
};

// A bias of one quantum beside, for the rounding of both depths.
LoadedScene with(const LoadedScene& scene, std::string_view key, std::int64_t word) {
    LoadedScene made = scene;
    shadow::Settings& s = made.settings;
    s.bias_unit = shadow::BiasUnit::quanta;
    s.bias_q16 = 1 << 16;
    s.bias_clamp_q16 = 0;
    s.bias_slope_q8 = 0;
    s.receiver = shadow::Receiver::point;
    s.map_depth = shadow::MapDepth::first;
    if (key.empty()) return made;
    shadow::find_setting(key)->set(s, word);
    if (key == "normal_offset") {
        s.receiver = shadow::Receiver::normal;
        s.slope_source = shadow::SlopeSource::normals;
    }
    return made;
}

Measured search_constant(const LoadedScene& scene, const Traced& traced, const LightUnits& units) {
    const LoadedScene plain = with(scene, "", 0);
    BiasedFrames frames(plain, traced);
    const LeastBias least = min_bias(frames);
    if (std::isnan(least.outside)) return {};
    return {units.world(least.outside), detachment_gap(traced, frames.draw(least.outside))};
}

// A larger amount is not always better: a point that is moved far enough along its normal comes to
// lie behind another surface. So the search goes up, and then looks closer at the last step.
template <class Enough>
std::optional<int> first_enough(Enough&& enough) {
    int amount = 0;
    while (!enough(amount)) {
        amount += coarse;
        if (amount > max_amount) return {};
    }
    for (int less = amount - 1; less > std::max(amount - coarse, 0) && enough(less); --less)
        amount = less;
    return amount;
}

// In texels of a setting of 8 fraction bits.
Measured search_setting(const LoadedScene& scene, const Traced& traced, std::string_view key) {
    const shadow::Setting& setting = *shadow::find_setting(key);
    const std::int64_t step = (std::int64_t{1} << setting.fraction) / parts;
    const auto drawn = [&](int amount, auto&& look) {
        const LoadedScene biased = with(scene, key, amount * step);
        BiasedFrames frames(biased, traced);
        return look(frames, frames.draw());
    };
    const std::optional<int> least = first_enough([&](int amount) {
        return drawn(amount, [](BiasedFrames& frames, const MachineMask& mask) {
            return frames.false_shadow(mask).outside < tolerated_false_shadow;
        });
    });
    if (!least) return {};
    return {static_cast<double>(*least) / parts,
            drawn(*least, [&](BiasedFrames&, const MachineMask& mask) {
                return detachment_gap(traced, mask);
            })};
}

// The slope that the bound is of, |zx| + |zy|; nothing where the bound does not depend on one.
double slope_of(double bound_quanta, const LightUnits& units, const shadow::Settings& s) {
    shadow::Settings plain = s;
    const double of_one = bias_bound(std::ldexp(1, -s.machine.z_bits), plain) - 1;  // a quantum
    if (!(of_one > 0)) return 0;
    const double quanta_a_texel = (bound_quanta - 1) / of_one;
    return units.world(quanta_a_texel) * units.texels_per_world;
}

// Of a slope along one axis of the map: the bound knows the sum of its parts alone.
Amount amount_in_scene(const LoadedScene& scene, const LightUnits& units, double world,
                       double slope) {
    const hw::MachineSpec& machine = scene.settings.machine;
    const double range = std::ldexp(1, machine.z_bits) / units.quanta_per_world;
    const double taps = shadow::has_window(scene.settings.lookup) ? scene.settings.taps : 1;
    return {world, 1 / units.texels_per_world, range, slope, slope, machine.z_bits,
            -1, false, machine.size_px(), taps};
}

}  // namespace

Answer answer(const LoadedScene& scene) {
    require_one_light(scene, "umbra78 bias");
    const TruthCache truths;
    const auto traced = truths.needed(scene);
    const LightUnits units = light_units(scene);
    const LoadedScene plain = with(scene, "", 0);
    const double bound = BiasedFrames(plain, *traced).bound(traced->band);
    const double slope = slope_of(bound, units, scene.settings);
    const double cosine = 1 / std::sqrt(1 + slope * slope);
    const double geometry = units.world(bound - 1);

    Answer a;
    a.name = fmt::format("{}: a map of {} x {} texels, {} bits of Z; outside the edge band under "
                         "{} % false shadow", scene.name, scene.settings.machine.size_px(),
                         scene.settings.machine.size_px(), scene.settings.machine.z_bits,
                         100 * tolerated_false_shadow);
    a.texel = 1 / units.texels_per_world;
    a.pixel = 2 * std::ldexp(static_cast<double>(scene.observer.extent), -16) /
              scene.settings.machine.size_px();
    a.constant = amount_in_scene(scene, units, units.world(bound), slope);
    a.geometry = amount_in_scene(scene, units, geometry, slope);
    const Measured constant = search_constant(scene, *traced, units);
    a.least.push_back({Kind::constant, units.world(bound), constant.amount, constant.detaches, {}});
    const Measured by_slope = search_setting(scene, *traced, "bias_slope");
    std::optional<double> slope_world, offset_world;
    if (by_slope.amount) slope_world = *by_slope.amount * slope * a.texel + units.world(1);
    a.least.push_back({Kind::slope, units.world(bound), slope_world, by_slope.detaches, {}});
    const Measured offset = search_setting(scene, *traced, "normal_offset");
    if (offset.amount) offset_world = *offset.amount * a.texel;
    a.least.push_back({Kind::normal, geometry * cosine, offset_world, offset.detaches, {}});
    a.remarks.push_back(fmt::format(
        "The bound is that of all but {} % of the lit pixels outside the edge band; their steepest "
        "surface has a slope of {:.3g} ({:.3g} degrees), taken along an axis of the map.",
        100 * tolerated_false_shadow, slope, std::atan(slope) * 180 / std::numbers::pi));
    const auto text = [](const Measured& m) {
        return m.amount ? fmt::format("{:.6g}", *m.amount) : "none up to 4";
    };
    a.remarks.push_back(fmt::format(
        "By experiment, on this machine: bias = {} world units, bias_slope = {}, normal_offset = "
        "{} texels; the latter two beside a bias of 1 quantum.",
        constant.amount ? fmt::format("{:.6g}", *constant.amount) : "none", text(by_slope),
        text(offset)));
    return a;
}

}  // namespace umbra78::tools::bias
