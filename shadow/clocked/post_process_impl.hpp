// The members of ClockedPostProcess. Included where it is instantiated: by
// shadow/clocked/post_process.cpp and by tests that plant a fault in the handshake.
#pragma once

#include "shadow/clocked/post_process.hpp"

#include <algorithm>

namespace umbra78::shadow {

template <class Depth, class Rule>
ClockedPostProcess<Depth, Rule>::ClockedPostProcess(const DepthMaps<Depth>& maps,
                                                    const hw::MatrixWords& matrix,
                                                    const TimedTest& settings,
                                                    std::span<std::uint8_t> mask)
    : plan_(settings, matrix), observer_(maps.observer), map_(light_map(maps.light, settings)),
      settings_(settings), mask_(mask),
      noise_(settings.dither, settings.machine, settings.timing),
      pixels_(maps.observer.depth.size()), since_issue_(plan_.slot_cycles) {
    check(maps, settings.machine, mask);
    fixed::require(settings.receiver == Receiver::point,
                   "clocked post-process: it has no stage for the receiver's plane or normal");
    std::fill(mask_.begin(), mask_.end(), mask_lit);
    plan_.transform.add_stages(chain_);
    name_steps(StageKind::transform, 0);
    transform_stages_ = chain_.stages();
    if (plan_.divides) {
        const int from = chain_.stages();
        plan_.divide.add_stages(chain_);
        name_steps(StageKind::divide, from);
    }
    const int place = chain_.stages();
    add_lookup_stages(chain_, plan_.lookup);
    int next = place;
    name_stage(next++, StageKind::place);
    name_stage(next++, StageKind::fetch);
    if (plan_.lookup.blends) name_stage(next++, StageKind::interpolate);
    if (plan_.lookup.sums()) name_stage(next++, StageKind::sum);
    name_stage(next, StageKind::compare);
    name_stage(chain_.add("write"), StageKind::write);
}

template <class Depth, class Rule>
void ClockedPostProcess<Depth, Rule>::name_steps(StageKind kind, int from) {
    int cycle = 0;
    for (int k = from; k < chain_.stages(); ++k) {
        stage_[static_cast<std::size_t>(k)] = {kind, cycle};
        cycle += chain_.stay(k);
    }
}

template <class Depth, class Rule>
void ClockedPostProcess<Depth, Rule>::finish_transform(PointRegisters& f) {
    const auto& t = f.transform;
    f.point = {t.result[0], t.result[1], t.result[2], hw::DivideStatus::ok};
    if (!plan_.divides) return;
    const bool rounded = settings_.machine.divide_order == hw::DivideOrder::round_first;
    f.divider.load(rounded ? hw::Accumulators(t.result) : t.accumulator);
}

template <class Depth, class Rule>
void ClockedPostProcess<Depth, Rule>::finish_divide(PointRegisters& f) {
    const auto& row = f.divider.row;
    f.point = {row[0].result.value, row[1].result.value, row[2].result.value,
               hw::DivideStatus::ok};
    for (const auto& r : row)
        if (r.result.status != hw::DivideStatus::ok) f.point.status = r.result.status;
}

template <class Depth, class Rule>
[[gnu::always_inline]] inline void ClockedPostProcess<Depth, Rule>::step_transform(
    int step, PointRegisters& f) {
    f.transform.step(plan_.transform, step);
    if (step == plan_.transform.latency() - 1) finish_transform(f);
}

// The units that follow the transform.
template <class Depth, class Rule>
void ClockedPostProcess<Depth, Rule>::work(int stage, int cycle, PointRegisters& f) {
    const Stage& s = stage_[static_cast<std::size_t>(stage)];
    const int step = s.first_cycle + cycle;
    switch (s.kind) {
        case StageKind::transform: step_transform(step, f); break;
        case StageKind::divide:
            f.divider.step(plan_.divide, step);
            if (step == plan_.divide.latency() - 1) finish_divide(f);
            break;
        case StageKind::place: 
            f.lookup.place(plan_.lookup, f.point, f.dither, f.taps);
            break;
        case StageKind::fetch: f.lookup.fetch(plan_.lookup, map_, cycle); break;
        case StageKind::interpolate: f.lookup.interpolate(plan_.lookup, cycle); break;
        case StageKind::sum: f.lookup.add(plan_.lookup, cycle); break;
        case StageKind::compare: f.lookup.compare(plan_.lookup, cycle); break;
        case StageKind::write:
            mask_[observer_.address(f.px, f.py)] = f.lookup.darkness;
            counts_.shadowed += f.lookup.darkness != mask_lit;
            break;
    }
}

template <class Depth, class Rule>
void ClockedPostProcess<Depth, Rule>::run() {
    while (!done()) tick_once(0);
}

template <class Depth, class Rule>
void ClockedPostProcess<Depth, Rule>::tick(hw::StageMask held) {
    tick_once(held);
}

template <class Depth, class Rule>
[[gnu::always_inline]] inline void ClockedPostProcess<Depth, Rule>::tick_once(
    hw::StageMask held) {
    // Most of what works in a cycle is a transform's stage.
    chain_.tick(held, [this](int stage, int cycle, std::int8_t slot) {
        PointRegisters& f = flight_[static_cast<std::size_t>(slot)];
        if (stage < transform_stages_)
            step_transform(stage_[static_cast<std::size_t>(stage)].first_cycle + cycle, f);
        else
            work(stage, cycle, f);
    });
    tick_reader(held);
    ++cycles_;
}

// A cycle of the scan: read on until a visible pixel is found, and let it go when its slot has
// come and the first stage is ready.
template <class Depth, class Rule>
[[gnu::always_inline]] inline void ClockedPostProcess<Depth, Rule>::tick_reader(
    hw::StageMask held) {
    if (pixel_ == pixels_ && !found_) return;
    if ((held & reader_bit) != 0) {
        ++reader_.held;
        return;
    }
    if (since_issue_ < plan_.slot_cycles) ++since_issue_;
    if (late_) {
        ++reader_.blocked;
        ++reader_blame_[static_cast<std::size_t>(culprit_)];
    } else if (found_) {
        ++reader_.slot;
    } else {
        ++reader_.read;
        read_cycle();
    }
    late_ = found_ && since_issue_ >= plan_.slot_cycles && !let_go(held);
}

// False where stage 0 takes nothing in this cycle.
template <class Depth, class Rule>
bool ClockedPostProcess<Depth, Rule>::let_go(hw::StageMask held) {
    const bool first_held = (held & 1) != 0;
    if (chain_.ready(0) && !first_held) {
        issue();
        return true;
    }
    culprit_ = first_held ? 0 : chain_.culprit(0);
    return false;
}

template <class Depth, class Rule>
[[gnu::always_inline]] inline void ClockedPostProcess<Depth, Rule>::read_cycle() {
    if (plan_.dithers) noise_.step(read_step_);
    if (++read_step_ < plan_.read_cycles) return;
    read_step_ = 0;
    found_code_ = observer_.depth[pixel_++];
    found_ = found_code_ != settings_.machine.background();
}

template <class Depth, class Rule>
void ClockedPostProcess<Depth, Rule>::issue() {
    PointRegisters& f = flight_[static_cast<std::size_t>(next_slot_)];
    const std::size_t address = pixel_ - 1;
    f.px = static_cast<std::int32_t>(address & ((std::size_t{1} << observer_.xy_bits) - 1));
    f.py = static_cast<std::int32_t>(address >> observer_.xy_bits);
    f.code = found_code_;
    f.dither = plan_.dithers ? noise_.words() : hw::DitherWords{0, 0};
    // The taps' register is not stepped cycle by cycle: its bits are the place's.
    const int taps = plan_.lookup.window.noisy_taps();
    f.taps = taps == 0 ? hw::TapBytes{}
                       : hw::TapNoise(settings_.dither.seed, taps, settings_.machine, f.px, f.py)
                             .next();
    f.transform.load(plan_.transform, pixel_words(f.px, f.py, f.code, settings_));
    chain_.enter(next_slot_);
    last_slot_ = next_slot_;
    next_slot_ = static_cast<std::int8_t>(next_slot_ == chain_.stages() ? 0 : next_slot_ + 1);
    found_ = false;
    since_issue_ = 0;
    ++counts_.visible;
    reader_at_issue_ = reader_;
}

template <class Depth, class Rule>
CycleAccount ClockedPostProcess<Depth, Rule>::account() const {
    const Schedule plain = schedule<Depth>(observer_.depth, settings_.machine.background(),
                                           plan_.read_cycles, plan_.slot_cycles);
    CycleAccount a;
    a.closed_form = plain.cycles(plan_.latency);
    if (plain.visible == 0) {
        a.reader_held = reader_.held;
        return a;
    }
    a.reader_held = reader_at_issue_.held;
    a.reader_blocked = reader_at_issue_.blocked;
    const auto latency = static_cast<std::uint64_t>(plan_.latency);
    const std::uint64_t flight = latency + chain_.waited(last_slot_);
    const std::uint64_t scan = plain.trailing + reader_.held - reader_at_issue_.held;
    a.after_last = std::max(flight, scan) - std::max(latency, plain.trailing);
    return a;
}

}  // namespace umbra78::shadow
