// The truth of a scene with its bands, traced once for all cases that share it. Thread safe.
#pragma once

#include "tools/buffers.hpp"
#include "tools/scene_truth.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace umbra78::tools::study {

class TruthCache {
public:
    struct Entry {
        std::optional<SceneTruth> truth;  // none: free patches without Embree
        Band band;                        // one light texel mapped back, no filter's reach
    };
    // By surfaces, views and resolution: nothing else of a case changes the truth.
    std::shared_ptr<const Entry> of(const LoadedScene&) const;

private:
    struct Slot {
        std::once_flag once;
        std::shared_ptr<const Entry> entry;
    };
    mutable std::mutex mutex_;
    mutable std::map<std::string, std::shared_ptr<Slot>> slots_;
};

// Equal where surfaces, views and resolution are.
std::string truth_key(const LoadedScene&);

// Observer's Z less truth's, in quanta, where both see the same surface and so do the four
// neighbours in truth: at a silhouette another surface may be meant.
struct DepthError {
    std::int64_t pixels = 0;
    double least = 0, mean = 0, greatest = 0, rms = 0;
};
DepthError depth_error(const LoadedScene&, const Truth&, const Buffer& observer_z);

}  // namespace umbra78::tools::study
