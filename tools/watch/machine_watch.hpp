// The clocked post-process, watched: what the reader and each stage did in the cycle just ticked.
//
// It looks at the machine from outside, before and after a tick; the machine knows nothing of it.
// Points are numbered from 1 in the order in which the reader lets them go.
#pragma once

#include "shadow/clocked/post_process.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace umbra78::tools {

enum class Did : std::uint8_t { nothing, work, blocked, held };

struct StageCycle {
    Did did = Did::nothing;
    std::int8_t slot = hw::Chain<>::none;  // of the point that was in it
    std::uint64_t point = 0;
    int step = 0;        // the cycle of its stay, where it worked
    bool valid = false;  // its work is done: it moves on if the next stage is ready
    bool ready = false;  // it takes a point at the end of this cycle
};

enum class ReaderDid : std::uint8_t { done, read, slot, blocked, held };

struct ReaderCycle {
    ReaderDid did = ReaderDid::done;
    std::size_t pixel = 0;    // it reads or holds, in scan order
    bool known = false;       // its code has been read
    std::uint32_t code = 0;
    std::uint64_t let_go = 0; // the point that left it at the end of this cycle; 0: none
};

template <class Depth>
class MachineWatch {
public:
    using Machine = shadow::ClockedPostProcess<Depth>;

    explicit MachineWatch(Machine& machine);
    void tick(hw::StageMask held = 0);

    std::uint64_t cycle() const { return machine_.cycles() - 1; }
    const StageCycle& stage(int k) const { return stage_[static_cast<std::size_t>(k)]; }
    const ReaderCycle& reader() const { return reader_; }
    const Machine& machine() const { return machine_; }

private:
    void before(int k);
    void after(int k, const hw::StageTime& old);
    void watch_reader(const typename Machine::ReaderTime& old, std::uint64_t visible);

    Machine& machine_;
    std::array<StageCycle, hw::max_stages> stage_{};
    std::array<std::uint64_t, hw::max_stages + 1> point_{};  // by slot
    ReaderCycle reader_{};
};

}  // namespace umbra78::tools
