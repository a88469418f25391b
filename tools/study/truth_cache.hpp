// The truth of a scene and what studies measure with it, traced once for all cases that share it.
#pragma once

#include "tools/truth/scene_truth.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace umbra78::tools::study {

struct Traced {
    SceneTruth truth;
    Band band;  // one light texel mapped back to the observer, no filter's reach
    // |zu| + |zv|: the surface's slopes in the light's space, along its X and its Y, in light-view
    // depth ranges a texel; times 2^z_bits it is quanta a texel. 0 where the pixel is in shadow or
    // not seen, infinite where the light sees the surface edge on.
    std::vector<double> slope;
};

// The bytes that a truth occupies, as the cache counts them.
std::size_t bytes_of(const Traced&);

// Safe to call from several threads: the first to ask for a truth traces it, the others wait.
//
// The cache holds at most `budget_bytes`. When a new truth exceeds them, those that have not been
// asked for the longest are dropped, but never the new one; a case that still uses a dropped truth
// keeps it until it is done. A truth takes 88 bytes a pixel: 23 MB at 512 x 512.
class TruthCache {
public:
    static constexpr std::size_t default_budget_bytes = std::size_t{1} << 30;
    explicit TruthCache(std::size_t budget_bytes = default_budget_bytes)
        : budget_bytes_(budget_bytes) {}

    // Found by surfaces, views and resolution: nothing else of a case changes the truth. Null for
    // a scene with free patches if the program is built without Embree.
    std::shared_ptr<const Traced> of(const LoadedScene&) const;
    // The same; throws SceneError in place of null.
    std::shared_ptr<const Traced> needed(const LoadedScene&) const;

    std::size_t bytes() const;  // of the truths that are held

private:
    struct Slot {
        std::once_flag once;
        std::shared_ptr<const Traced> traced;
        std::size_t bytes = 0;         // 0 until it is traced
        std::uint64_t last_asked = 0;  // the number of the latest question for it
    };
    void count(const std::shared_ptr<Slot>&) const;

    std::size_t budget_bytes_;
    mutable std::mutex mutex_;  // of all below, and of the slots' last two members
    mutable std::map<std::string, std::shared_ptr<Slot>> slots_;
    mutable std::size_t bytes_ = 0;
    mutable std::uint64_t questions_ = 0;
};

// Equal for scenes of equal surfaces, views and resolution.
std::string truth_key(const LoadedScene&);

}  // namespace umbra78::tools::study
