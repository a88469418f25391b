// The post-process, clocked end to end.
//
//   reader --> transform --> (divide) --> place --> fetch --> (interpolate) --> compare --> write
//   a pixel      hw/clocked/transform,       shadow/clocked/lookup                        mask
//   a cycle      hw/clocked/divider
//
// The reader scans the observer's Z, a pixel a cycle (longer only where the noise source is
// slower), and lets a visible pixel go every S cycles, where S is the longest stay of a stage; so
// no stage blocks unless a clock is held. Background pixels end in the reader. Without holds a
// frame takes
//
//   T = 1 + I + max(L, p g),    I = p (g_0 + 1) - 1 + sum over the later visible pixels of
//                                   max(S, p (g_j + 1))
//
// with g_j the background pixels before visible pixel j, g those after the last, p the reader's
// cycles a pixel and L the stages' cycles of one point. With holds there are added the cycles that
// the reader was held or blocked until the last point left it, and those that the last point then
// waited on its way. CycleAccount has each part, and their sum is the number of cycles ticked.
// Widths or times out of their ranges, and stores or a mask of other sizes than the machine, trap.
#pragma once

#include "hw/clocked/divider.hpp"
#include "hw/clocked/noise.hpp"
#include "hw/clocked/transform.hpp"
#include "hw/frame_store.hpp"
#include "shadow/clocked/lookup.hpp"
#include "shadow/post_process.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace umbra78::shadow {

// The units of the post-process; a unit's stages follow each other in the chain.
enum class PostProcessUnit : std::uint8_t { reader, transform, divider, lookup, writer };

enum class StageKind : std::uint8_t {
    transform,
    divide,
    place,
    fetch,
    interpolate,
    sum,
    compare,
    write
};

// What the frame's cycles are made of: total() is exactly the cycles ticked.
struct CycleAccount {
    std::uint64_t closed_form = 0;
    std::uint64_t reader_held = 0, reader_blocked = 0;  // until the last point left the reader
    // After that: how much later the frame ends because the last point waited on its way, or
    // because the reader was held in the background pixels that follow it.
    std::uint64_t after_last = 0;
    std::uint64_t total() const { return closed_form + reader_held + reader_blocked + after_last; }
};

// A point on its way through the machine: its registers in every unit.
struct PointRegisters {
    std::int32_t px = 0, py = 0;
    std::uint32_t code = 0;
    hw::DitherWords dither{0, 0};
    hw::TapBytes taps{};
    hw::TransformRegisters transform;
    hw::DividerRegisters divider;
    hw::Point point{};
    LookupRegisters lookup;
};

// What a schedule needs to know of the stages.
struct PostProcessPipeline {
    hw::TransformPipeline transform;
    hw::DividePipeline divide;
    LookupPipeline lookup;
    bool divides, dithers;
    int read_cycles;  // p
    int slot_cycles;  // S
    int latency;      // L

    PostProcessPipeline(const TimedTest& settings, const hw::MatrixWords& matrix);
};

// How the visible pixels lie in the scan: the closed form of a frame.
struct Schedule {
    std::uint64_t visible = 0, pixels = 0;
    std::uint64_t last_issue = 0;  // the cycle in which the last visible pixel leaves the reader
    std::uint64_t trailing = 0;    // reader cycles after it
    std::uint64_t cycles(int latency) const {
        if (visible == 0) return trailing;
        const auto flight = static_cast<std::uint64_t>(latency);
        return 1 + last_issue + (flight > trailing ? flight : trailing);
    }
};
template <class Depth>
Schedule schedule(std::span<const Depth> depth, std::uint32_t background, int read_cycles,
                  int slot_cycles);

template <class Depth, class Rule = hw::ValidReady>
class ClockedPostProcess {
public:
    // The stores and the mask stay the caller's. The mask is cleared; `tick` writes it.
    ClockedPostProcess(const DepthMaps<Depth>& maps, const hw::MatrixWords& matrix,
                       const TimedTest& settings, std::span<std::uint8_t> mask);

    // The reader's bit of a hold mask; stage k of the chain has bit k.
    static constexpr hw::StageMask reader_bit = hw::StageMask{1} << 63;

    bool done() const { return pixel_ == pixels_ && !found_ && chain_.empty(); }
    void tick(hw::StageMask held = 0);
    // Until it is done, no clock held: the same cycles, with nobody between two of them.
    void run();

    std::uint64_t cycles() const { return cycles_; }
    std::size_t pixels() const { return pixels_; }
    const hw::Chain<Rule>& chain() const { return chain_; }
    StageKind kind(int stage) const { return stage_[static_cast<std::size_t>(stage)].kind; }
    const PointRegisters& flight(int slot) const { return flight_[static_cast<std::size_t>(slot)]; }
    const PostProcessPipeline& plan() const { return plan_; }
    const PostProcessCounts& counts() const { return counts_; }

    // The reader's cycles: reading, waiting for the next slot, blocked, held; the rest it is done.
    struct ReaderTime {
        std::uint64_t read = 0, slot = 0, blocked = 0, held = 0;
    };
    const ReaderTime& reader() const { return reader_; }
    std::uint32_t read_code() const { return found_code_; }  // of the pixel read last
    // Cycles the reader was blocked by a stage.
    std::uint64_t reader_blocked_by(int stage) const {
        return reader_blame_[static_cast<std::size_t>(stage)];
    }

    CycleAccount account() const;  // when done

private:
    // The stages from `from` on are steps of one unit; name_stage names a stage by itself.
    void name_steps(StageKind kind, int from);
    void name_stage(int stage, StageKind kind) {
        stage_[static_cast<std::size_t>(stage)].kind = kind;
    }
    void work(int stage, int cycle, PointRegisters& f);
    void step_transform(int step, PointRegisters& f);
    void finish_transform(PointRegisters& f);
    void finish_divide(PointRegisters& f);
    void tick_once(hw::StageMask held);
    void tick_reader(hw::StageMask held);
    bool let_go(hw::StageMask held);
    void read_cycle();
    void issue();

    PostProcessPipeline plan_;
    hw::FrameStore<const Depth> observer_;
    LightMap<Depth> map_;
    TimedTest settings_;
    std::span<std::uint8_t> mask_;
    hw::Chain<Rule> chain_;
    struct Stage {
        StageKind kind;
        int first_cycle;  // of a unit's steps
    };
    std::array<Stage, hw::max_stages> stage_{};
    int transform_stages_ = 0;  // the first ones
    std::array<PointRegisters, hw::max_stages + 1> flight_{};  // one more than there are stages
    hw::ClockedNoise noise_;

    std::size_t pixel_ = 0, pixels_;      // the next one to be read
    int read_step_ = 0;                   // cycles spent on it
    int since_issue_;                     // up to S
    bool found_ = false;                  // a visible pixel waits in the reader
    bool late_ = false;                   // its slot has come, but stage 0 was not ready
    int culprit_ = 0;                     // the stage that kept it
    std::uint32_t found_code_ = 0;
    std::int8_t next_slot_ = 0;
    std::int8_t last_slot_ = 0;           // of the point let go last
    std::uint64_t cycles_ = 0;
    ReaderTime reader_{}, reader_at_issue_{};
    std::array<std::uint64_t, hw::max_stages> reader_blame_{};
    PostProcessCounts counts_{};
};

}  // namespace umbra78::shadow
