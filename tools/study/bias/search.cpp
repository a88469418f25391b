#include "tools/study/bias/search.hpp"

#include "shadow/bias.hpp"

#include <cmath>
#include <limits>
#include <map>

namespace umbra78::tools::study {

BiasedFrames::BiasedFrames(const LoadedScene& scene, const Traced& traced)
    : scene_(scene), traced_(traced), job_(scene.view(), scene.settings) {
    job_.draw_light();
    job_.draw_observer();
    visible_ = job_.visible();
}

double BiasedFrames::bias_quanta() const {
    std::int64_t q16 = 0;
    const auto units = shadow::bias_units(scene_.light(), settings().machine);
    if (!bias_in_quanta(settings().bias_q16, settings().bias_unit, units, q16))
        throw SceneError("the bias does not fit");
    return std::ldexp(static_cast<double>(q16), -16);
}

MachineMask BiasedFrames::draw(std::optional<double> quanta) {
    shadow::Settings settings = scene_.settings;
    if (quanta) {
        settings.bias_unit = shadow::BiasUnit::quanta;
        settings.bias_q16 = std::llround(std::ldexp(*quanta, 16));
    }
    job_.use(settings);
    job_.cast_shadows();
    return {job_.bytes(Plane::mask), visible_};
}

FalseShadow BiasedFrames::false_shadow(const MachineMask& mask) const {
    const Truth& truth = traced_.truth.truth;
    return {shadow_error(truth, mask, traced_.truth.unlit_side).false_shadow_rate(),
            shadow_error(truth, mask, traced_.band).false_shadow_rate()};
}

double BiasedFrames::bound(const Band& leave_out) const {
    return bias_bound_for(tolerated_false_shadow, traced_.slope, traced_.truth.truth.lit,
                          leave_out, scene_.settings);
}

int BiasedFrames::beyond_bound(const MachineMask& mask, double quanta) const {
    const auto error = error_image(traced_.truth.truth, mask, traced_.band);
    int beyond = 0;
    for (std::size_t at = 0; at < error.size(); ++at)
        beyond += error[at] > 0 && bias_bound(traced_.slope[at], scene_.settings) <= quanta;
    return beyond;
}

std::optional<int> bisect(int max, const std::function<bool(int)>& enough) {
    if (!enough(max)) return std::nullopt;
    int too_little = -1;
    while (max - too_little > 1) {
        const int middle = too_little + (max - too_little) / 2;
        (enough(middle) ? max : too_little) = middle;
    }
    return max;
}

LeastBias min_bias(BiasedFrames& frames) {
    const int max = max_bias_quanta(frames.settings().machine);
    std::map<int, FalseShadow> seen;
    const auto at = [&](int quanta) -> const FalseShadow& {
        const auto found = seen.find(quanta);
        if (found != seen.end()) return found->second;
        return seen[quanta] = frames.false_shadow(frames.draw(quanta));
    };
    const auto min = [&](double FalseShadow::* which) {
        const auto found = bisect(
            max, [&](int quanta) { return at(quanta).*which < tolerated_false_shadow; });
        return found ? *found : std::numeric_limits<double>::quiet_NaN();
    };
    return {min(&FalseShadow::overall), min(&FalseShadow::outside)};
}

}  // namespace umbra78::tools::study
