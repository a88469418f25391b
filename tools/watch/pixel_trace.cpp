// How one pixel is followed: unwatched up to its read, then stage by stage.
#include "tools/watch/pixel_trace.hpp"

#include "tools/scene/scene_error.hpp"
#include "tools/watch/machine_watch.hpp"
#include "tools/watch/trace_units.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <stdexcept>

namespace umbra78::tools {
namespace {

using shadow::StageKind;

class PixelTracer {
public:
    PixelTracer(WatchedFrame& frame, Pixel pixel)
        : frame_(frame), pixel_(pixel), machine_(frame.machine()),
          index_(frame.observer().address(pixel.x, pixel.y)) {}

    PixelTrace trace();

private:
    void read();
    void leave_reader();
    void work();  // until the mask word is written
    void stage_work(int stage, int step);
    PixelOutcome outcome() const;
    TracedPoint point() const {
        return {frame_.settings(), machine_->plan(), machine_->flight(slot_)};
    }

    WatchedFrame& frame_;
    Pixel pixel_;
    std::unique_ptr<WatchedFrame::Machine> machine_;
    std::size_t index_;  // of the pixel, in scan order
    TraceLog log_;
    std::vector<std::uint64_t> read_cycles_;
    int slot_ = 0, unit_step_ = 0;
    StageKind unit_ = StageKind::transform;
    TransformTrace transform_;
    std::uint64_t last_cycle_ = 0;
};

// Runs the machine, unwatched, until it has read the pixel.
void PixelTracer::read() {
    const auto each = static_cast<std::uint64_t>(machine_->plan().read_cycles);
    while (machine_->reader().read < index_ * each) machine_->tick();
    while (machine_->reader().read < (index_ + 1) * each) {
        const std::uint64_t before = machine_->reader().read, cycle = machine_->cycles();
        machine_->tick();
        if (machine_->reader().read != before) read_cycles_.push_back(cycle);
    }
    last_cycle_ = read_cycles_.back();
    log_.at("read", last_cycle_);
    const hw::MachineSpec& m = frame_.settings().machine;
    log_.word("code", unsigned_word(frame_.observer().depth[index_], m.z_bits),
              fmt::format("the observer's Z plane, word {}", index_));
    log_.word("intensity", unsigned_word(frame_.observer().intensity[index_], 8),
              "the observer's intensity plane");
}

// The pixel may leave the reader in its last read cycle; otherwise it waits for its slot.
void PixelTracer::leave_reader() {
    std::uint64_t cycle = last_cycle_;
    const auto newest = [&] {
        const int slot = machine_->chain().slot(0);
        return slot >= 0 && machine_->flight(slot).px == pixel_.x &&
               machine_->flight(slot).py == pixel_.y;
    };
    while (!newest()) {
        cycle = machine_->cycles();
        machine_->tick();
    }
    slot_ = machine_->chain().slot(0);
    trace_noise(log_, point(), read_cycles_, cycle);
    trace_words(log_, point(), cycle);
}

void PixelTracer::stage_work(int stage, int step) {
    const StageKind kind = machine_->kind(stage);
    unit_step_ = kind == unit_ ? unit_step_ : 0;
    unit_ = kind;
    log_.at(machine_->chain().name(stage), last_cycle_);
    switch (kind) {
        case StageKind::transform:
            transform_.step(log_, point(), unit_step_, last_cycle_);
            break;
        case StageKind::divide: trace_divide(log_, point(), unit_step_, last_cycle_); break;
        case StageKind::place: trace_place(log_, point()); break;
        case StageKind::fetch: trace_fetch(log_, point(), step); break;
        case StageKind::interpolate: trace_interpolate(log_, point(), step); break;
        case StageKind::sum: trace_sum(log_, point(), step); break;
        case StageKind::compare: trace_compare(log_, point(), step); break;
        case StageKind::write: trace_write(log_, point(), frame_.mask()[index_]); break;
    }
    ++unit_step_;
}

void PixelTracer::work() {
    MachineWatch<hw::Depth32> watch(*machine_);
    const int last = machine_->chain().stages() - 1;
    for (bool written = false; !written;) {
        watch.tick();
        last_cycle_ = watch.cycle();
        for (int k = 0; k <= last; ++k) {
            const StageCycle& s = watch.stage(k);
            if (s.slot != slot_ || s.activity != Activity::work) continue;
            stage_work(k, s.step);
            written = k == last;
        }
    }
}

PixelOutcome PixelTracer::outcome() const {
    if (frame_.observer().depth[index_] == frame_.settings().machine.background())
        return PixelOutcome::background;
    const shadow::PointRegisters& f = machine_->flight(slot_);
    if (f.point.status != hw::DivideStatus::ok) return PixelOutcome::no_quotient;
    return f.lookup.outside ? PixelOutcome::outside : PixelOutcome::compared;
}

PixelTrace PixelTracer::trace() {
    trace_matrix(log_, frame_.settings(), frame_.matrix());
    read();
    if (outcome() == PixelOutcome::background) {
        log_.say("background: the reader drops it, and its mask word stays 0");
    } else {
        leave_reader();
        work();
    }
    return {pixel_,      outcome(),       frame_.mask()[index_], read_cycles_.front(),
            last_cycle_, log_.lines()};
}

const char* name_of(PixelOutcome outcome) {
    constexpr const char* names[] = {"background", "no_quotient", "outside", "compared"};
    return names[static_cast<std::size_t>(outcome)];
}

}  // namespace

std::string summary(const PixelTrace& t) {
    const char* how = t.outcome == PixelOutcome::background    ? "background: the reader drops it"
                      : t.outcome == PixelOutcome::no_quotient ? "no quotient: lit"
                      : t.outcome == PixelOutcome::outside     ? "outside the light's volume: lit"
                      : t.mask == shadow::mask_lit    ? "lit"
                      : t.mask == shadow::mask_shadow ? "in shadow"
                                                      : "in shadow in part";
    return fmt::format("{}, cycles {} to {}", how, t.first_cycle, t.last_cycle);
}

PixelTrace trace_post_process(WatchedFrame& frame, Pixel pixel) {
    const int size = frame.settings().machine.size_px();
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size || pixel.y >= size)
        throw SceneError(fmt::format("pixel {},{} is not in the frame of {} x {} pixels; give x "
                                     "and y of 0 .. {}",
                                     pixel.x, pixel.y, size, size, size - 1));
    return PixelTracer(frame, pixel).trace();
}

PixelTrace trace_pixel(const RenderJob& job, Pixel pixel) {
    WatchedFrame frame(job);
    PixelTrace trace = trace_post_process(frame, pixel);
    const std::uint8_t mask =
        job.bytes(Plane::mask)[frame.observer().address(pixel.x, pixel.y)];
    if (trace.mask != mask)
        throw std::logic_error(fmt::format("pixel ({}, {}): the clocked machine's mask is {}, the "
                                           "frame's {}", pixel.x, pixel.y, trace.mask, mask));
    TraceLog log;
    log.at("check");
    log.say(fmt::format("the frame's own mask word is also {}", mask));
    trace_filters(log, frame, job, pixel.x, pixel.y);
    trace.lines.insert(trace.lines.end(), log.lines().begin(), log.lines().end());
    return trace;
}

nlohmann::ordered_json to_json(const PixelTrace& t) {
    return {{"pixel", {t.pixel.x, t.pixel.y}},
            {"outcome", name_of(t.outcome)},
            {"mask", t.mask},
            {"first_cycle", t.first_cycle},
            {"last_cycle", t.last_cycle},
            {"words", to_json(t.lines)}};
}

}  // namespace umbra78::tools
