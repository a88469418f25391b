// The truth of a scene with what studies measure by, traced once for all cases that share it.
#pragma once

#include "tools/truth/scene_truth.hpp"

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace umbra78::tools::study {

struct Traced {
    SceneTruth truth;
    Band band;  // one light texel mapped back to the observer, no filter's reach
    // |zu| + |zv|: how steep the surface is in the light's space, in light-view depth ranges a
    // texel along its X and its Y; 2^z_bits times that is quanta a texel. 0 where the pixel is
    // in shadow or not seen, infinite where the surface is seen edge on.
    std::vector<double> slope;
};

// Safe to call from several threads: the first to ask traces, the others wait.
class TruthCache {
public:
    // By surfaces, views and resolution: nothing else of a case changes the truth. Null for a
    // scene with free patches without Embree.
    std::shared_ptr<const Traced> of(const LoadedScene&) const;
    // The same; throws SceneError in place of null.
    std::shared_ptr<const Traced> needed(const LoadedScene&) const;

private:
    struct Slot {
        std::once_flag once;
        std::shared_ptr<const Traced> traced;
    };
    mutable std::mutex mutex_;
    mutable std::map<std::string, std::shared_ptr<Slot>> slots_;
};

// Equal where surfaces, views and resolution are.
std::string truth_key(const LoadedScene&);

}  // namespace umbra78::tools::study
