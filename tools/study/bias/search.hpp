// A scene under one bias after another: drawn once, its shadows cast anew; and the least bias that
// leaves under 0.1 % of false shadow.
#pragma once

#include "tools/study/bias/bias_bound.hpp"
#include "tools/study/measures.hpp"

#include <algorithm>
#include <functional>
#include <optional>

namespace umbra78::tools::study {

inline constexpr double tolerated_false_shadow = 0.001;
// Where a search gives up: an eighth of the depth range, 8192 quanta of 1978's.
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
    double bias_quanta() const;  // of the settings
    // With the bias in quanta, or the settings' own.
    MachineMask draw(std::optional<double> bias_quanta = std::nullopt);
    ShadowReport errors(const MachineMask& mask) const {
        return report(traced_.truth, mask, traced_.band);
    }
    FalseShadow false_shadow(const MachineMask&) const;  // errors' two, and no others
    // The bias at which the bound holds for all lit pixels outside the band but those tolerated.
    double bound(const Band& leave_out) const;
    // Pixels outside the band in false shadow though the bias is at least their bound.
    int beyond_bound(const MachineMask&, double bias_quanta) const;

private:
    const LoadedScene& scene_;
    const Traced& traced_;
    RenderJob job_;
    std::vector<std::uint8_t> visible_;
};

// In whole quanta; NaN where most_bias_quanta do not suffice.
struct LeastBias {
    double overall, outside;  // outside the edge band
};
LeastBias min_bias(BiasedFrames&);

// The least of 0 .. most for which `enough` is true, where it stays true from there on; nothing
// if it is not true of `most`.
std::optional<int> bisect(int max, const std::function<bool(int)>& enough);

}  // namespace umbra78::tools::study
