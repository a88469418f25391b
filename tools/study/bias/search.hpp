// A scene drawn once and its shadows cast with one bias after another; and the least bias that
// leaves under 0.1 % false shadow.
#pragma once

#include "tools/study/bias/bias_bound.hpp"
#include "tools/study/measures.hpp"

#include <algorithm>
#include <functional>
#include <optional>

namespace umbra78::tools::study {

inline constexpr double tolerated_false_shadow = 0.001;
// Where a search ends: an eighth of the depth range, 8192 quanta with 16 bits of Z.
inline int max_bias_quanta(const hw::MachineSpec& m) {
    return static_cast<int>(std::max(m.background() / 8, 1u));
}

struct FalseShadow {
    double overall, outside;  // rates; outside the edge band
};

class BiasedFrames {
public:
    BiasedFrames(const LoadedScene&, const Traced&);  // both must live

    const shadow::Settings& settings() const { return scene_.settings; }
    const RenderJob& job() const { return job_; }
    double bias_quanta() const;  // the settings' own bias
    // With this bias in quanta, or with the settings' own.
    MachineMask draw(std::optional<double> bias_quanta = std::nullopt);
    ShadowReport errors(const MachineMask& mask) const {
        const Buffer depths = job_.buffer(Plane::observer_z);
        return report(traced_.truth, mask, traced_.band, &depths);
    }
    FalseShadow false_shadow(const MachineMask&) const;  // two of errors(), computed faster
    // The bias that is at least the bound of all lit pixels that are not left out, except the
    // tolerated share.
    double bound(const Band& leave_out) const;
    // The number of pixels outside the band in false shadow although the bias is at least their
    // bound.
    int beyond_bound(const MachineMask&, double bias_quanta) const;

private:
    const LoadedScene& scene_;
    const Traced& traced_;
    RenderJob job_;
    std::vector<std::uint8_t> visible_;
};

// In whole quanta; NaN if max_bias_quanta is not enough.
struct LeastBias {
    double overall, outside;  // outside the edge band
};
LeastBias min_bias(BiasedFrames&);

// The least number 0 .. max for which `enough` is true; nothing if it is false for `max`. Requires
// that it stays true for all larger numbers.
std::optional<int> bisect(int max, const std::function<bool(int)>& enough);

}  // namespace umbra78::tools::study
