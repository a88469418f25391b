#include "tools/watch/machine_watch.hpp"

namespace umbra78::tools {

// The points already under way are the last ones let go, the newest in the first stage.
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
    // Every point works as many cycles here, so their count says how far this one is.
    s.step = static_cast<int>(chain.time(k).work % static_cast<std::uint64_t>(chain.stay(k)));
}

template <class Depth>
void MachineWatch<Depth>::after(int k, const hw::StageTime& old) {
    const auto& chain = machine_.chain();
    StageCycle& s = stage_[static_cast<std::size_t>(k)];
    const hw::StageTime& now = chain.time(k);
    if (now.work != old.work) s.did = Did::work;
    if (now.blocked != old.blocked) s.did = Did::blocked;
    if (now.held != old.held) s.did = Did::held;
    s.valid = s.did == Did::blocked || (s.did == Did::work && s.step == chain.stay(k) - 1);
}

template <class Depth>
void MachineWatch<Depth>::watch_reader(const typename Machine::ReaderTime& old,
                                       std::uint64_t visible) {
    const typename Machine::ReaderTime& now = machine_.reader();
    const auto cycles = static_cast<std::uint64_t>(machine_.plan().read_cycles);
    reader_ = {};
    if (now.read != old.read) reader_.did = ReaderDid::read;
    if (now.slot != old.slot) reader_.did = ReaderDid::slot;
    if (now.blocked != old.blocked) reader_.did = ReaderDid::blocked;
    if (now.held != old.held) reader_.did = ReaderDid::held;
    if (now.read > 0) reader_.pixel = static_cast<std::size_t>((now.read - 1) / cycles);
    reader_.known = now.read > 0 && now.read % cycles == 0;
    if (reader_.known) reader_.code = machine_.read_code();
    if (machine_.counts().visible == visible) return;
    reader_.let_go = machine_.counts().visible;
    point_[static_cast<std::size_t>(machine_.chain().slot(0))] = reader_.let_go;
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
        // Slots are handed out in turn, so two points in a row never have the same.
        const bool left = s.slot >= 0 && chain.slot(k) != s.slot;
        s.ready = (held >> k & 1) == 0 && (s.slot < 0 || left);
    }
    watch_reader(reader, visible);
}

template class MachineWatch<hw::Depth16>;
template class MachineWatch<hw::Depth32>;

}  // namespace umbra78::tools
