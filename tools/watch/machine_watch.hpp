// The watch: what the reader and each stage of the clocked post-process did in the last cycle.
//
// It reads the machine's state before and after a tick; the machine does not know about it. A point
// is a visible pixel on its way; points are numbered from 1 in the order in which the reader
// releases them.
#pragma once

#include "shadow/clocked/post_process.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace umbra78::tools {

enum class Activity : std::uint8_t { nothing, work, blocked, held };

struct StageCycle {
    Activity activity = Activity::nothing;
    std::int8_t slot = hw::Chain<>::none;  // of the point in the stage
    std::uint64_t point = 0;
    int step = 0;        // which cycle of its stay this was, if it worked
    bool valid = false;  // its work is done: it moves on if the next stage is ready
    bool ready = false;  // the stage can take a point at the end of this cycle
};

enum class ReaderActivity : std::uint8_t { done, read, slot, blocked, held };

struct ReaderCycle {
    ReaderActivity activity = ReaderActivity::done;
    std::size_t pixel = 0;    // it reads or holds, in scan order
    bool known = false;       // its code has been read
    std::uint32_t code = 0;
    std::uint64_t released = 0;  // the point that left at the end of this cycle; 0: none
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
