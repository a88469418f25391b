// How the watch reads one cycle from the machine before and after its tick.
#include "tools/watch/machine_watch.hpp"

namespace umbra78::tools {

// The points already in the stages are the last ones that the reader released, the newest in front.
template <class Depth>
MachineWatch<Depth>::MachineWatch(Machine& machine) : machine_(machine) {
    std::uint64_t point = machine.counts().visible;
    for (int k = 0; k < machine.chain().stages(); ++k)
        if (const int slot = machine.chain().slot(k); slot >= 0)
            point_[static_cast<std::size_t>(slot)] = point--;
}

template <class Depth>
void MachineWatch<Depth>::before(int k) {
    const auto& chain = machine_.chain();
    StageCycle& s = stage_[static_cast<std::size_t>(k)];
    s = {};
    s.slot = static_cast<std::int8_t>(chain.slot(k));
    if (s.slot < 0) return;
    s.point = point_[static_cast<std::size_t>(s.slot)];
    // Every point stays for the same number of cycles, so the stage's count gives the step.
    s.step = static_cast<int>(chain.time(k).work % static_cast<std::uint64_t>(chain.stay(k)));
}

template <class Depth>
void MachineWatch<Depth>::after(int k, const hw::StageTime& old) {
    const auto& chain = machine_.chain();
    StageCycle& s = stage_[static_cast<std::size_t>(k)];
    const hw::StageTime& now = chain.time(k);
    if (now.work != old.work) s.activity = Activity::work;
    if (now.blocked != old.blocked) s.activity = Activity::blocked;
    if (now.held != old.held) s.activity = Activity::held;
    s.valid = s.activity == Activity::blocked ||
              (s.activity == Activity::work && s.step == chain.stay(k) - 1);
}

template <class Depth>
void MachineWatch<Depth>::watch_reader(const typename Machine::ReaderTime& old,
                                       std::uint64_t visible) {
    const typename Machine::ReaderTime& now = machine_.reader();
    const auto cycles = static_cast<std::uint64_t>(machine_.plan().read_cycles);
    reader_ = {};
    if (now.read != old.read) reader_.activity = ReaderActivity::read;
    if (now.slot != old.slot) reader_.activity = ReaderActivity::slot;
    if (now.blocked != old.blocked) reader_.activity = ReaderActivity::blocked;
    if (now.held != old.held) reader_.activity = ReaderActivity::held;
    if (now.read > 0) reader_.pixel = static_cast<std::size_t>((now.read - 1) / cycles);
    reader_.known = now.read > 0 && now.read % cycles == 0;
    if (reader_.known) reader_.code = machine_.read_code();
    if (machine_.counts().visible == visible) return;
    reader_.released = machine_.counts().visible;
    point_[static_cast<std::size_t>(machine_.chain().slot(0))] = reader_.released;
}

template <class Depth>
void MachineWatch<Depth>::tick(hw::StageMask held) {
    const auto& chain = machine_.chain();
    std::array<hw::StageTime, hw::max_stages> old;
    for (int k = 0; k < chain.stages(); ++k) {
        before(k);
        old[static_cast<std::size_t>(k)] = chain.time(k);
    }
    const auto reader = machine_.reader();
    const std::uint64_t visible = machine_.counts().visible;
    machine_.tick(held);
    for (int k = 0; k < chain.stages(); ++k) {
        after(k, old[static_cast<std::size_t>(k)]);
        StageCycle& s = stage_[static_cast<std::size_t>(k)];
        // Slots are assigned in turn, so two successive points never have the same slot.
        const bool left = s.slot >= 0 && chain.slot(k) != s.slot;
        s.ready = (held >> k & 1) == 0 && (s.slot < 0 || left);
    }
    watch_reader(reader, visible);
}

template class MachineWatch<hw::Depth16>;
template class MachineWatch<hw::Depth32>;

}  // namespace umbra78::tools
