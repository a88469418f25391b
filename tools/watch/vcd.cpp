// How the reader's and the stages' signals become a value change dump.
#include "tools/watch/vcd.hpp"

#include "tools/watch/machine_watch.hpp"
#include "tools/watch/vcd_signals.hpp"
#include "tools/watch/watched_frame.hpp"

#include <fmt/format.h>

#include <deque>
#include <span>

namespace umbra78::tools {
namespace {

class ReaderSignals {
public:
    ReaderSignals(VcdText& vcd, const std::string& scope, const hw::MachineSpec& m)
        : xy_bits_(m.xy_bits), state_(vcd.add(scope, "state", 3)), go_(vcd.add(scope, "go", 1)),
          px_(vcd.add(scope, "px", m.xy_bits)), py_(vcd.add(scope, "py", m.xy_bits)),
          code_(vcd.add(scope, "code", m.z_bits)) {}

    void set(VcdText& vcd, const ReaderCycle& r) const {
        vcd.set(state_, static_cast<std::int64_t>(r.activity));
        vcd.set(go_, r.released != 0);
        if (r.activity == ReaderActivity::done) return;
        const auto pixel = static_cast<std::int64_t>(r.pixel);
        vcd.set(px_, pixel & ((std::int64_t{1} << xy_bits_) - 1));
        vcd.set(py_, pixel >> xy_bits_);
        if (r.known) vcd.set(code_, r.code);
    }

private:
    int xy_bits_;
    VcdText::Signal state_, go_, px_, py_, code_;
};

template <class Depth>
class VcdWriter {
public:
    using Machine = shadow::ClockedPostProcess<Depth>;

    VcdWriter(Machine& machine, const VcdOptions& options)
        : machine_(machine), options_(options), watch_(machine),
          vcd_("umbra78, the clocked post-process: at time cycle x clock what that cycle does"),
          clock_(vcd_.add("umbra78", "clock", 1)), cycle_(vcd_.add("umbra78", "cycle", 32)),
          reader_(vcd_, "umbra78.reader", machine.plan().lookup.spec) {
        for (int k = 0; k < machine.chain().stages(); ++k) {
            const bool first = k == 0 || machine.kind(k - 1) != machine.kind(k);
            stages_.emplace_back(vcd_, fmt::format("umbra78.s{}_{}", k, machine.chain().name(k)),
                                 machine.kind(k), first, machine.plan());
        }
    }

    std::string operator()() {
        bool pending = skip();
        for (std::uint64_t n = 0; n < options_.cycles && (pending || !machine_.done()); ++n) {
            if (!pending) tick();
            pending = false;
            write();
        }
        if (machine_.cycles() > 0) vcd_.time(ns(machine_.cycles()));
        vcd_.set(clock_, 1);  // the edge that ends the last cycle
        return vcd_.text();
    }

private:
    std::uint64_t ns(std::uint64_t cycle) const {
        return cycle * static_cast<std::uint64_t>(options_.clock_ns);
    }
    void tick() { watch_.tick(options_.holds ? options_.holds(machine_.cycles()) : 0); }

    // Returns whether the last cycle ticked is the first to be written.
    bool skip() {
        if (options_.from) {
            while (!machine_.done() && machine_.cycles() < *options_.from) tick();
            return false;
        }
        while (!machine_.done() && machine_.counts().visible == 0) tick();
        return machine_.counts().visible == 1 && watch_.reader().released == 1;
    }

    void write() {
        const std::uint64_t cycle = watch_.cycle();
        vcd_.time(ns(cycle));
        vcd_.set(clock_, 1);
        vcd_.set(cycle_, static_cast<std::int64_t>(cycle));
        reader_.set(vcd_, watch_.reader());
        for (int k = 0; k < machine_.chain().stages(); ++k) {
            const StageCycle& s = watch_.stage(k);
            stages_[static_cast<std::size_t>(k)].set(
                vcd_, s, s.slot < 0 ? nullptr : &machine_.flight(s.slot));
        }
        vcd_.time(ns(cycle) + static_cast<std::uint64_t>(options_.clock_ns) / 2);
        vcd_.set(clock_, 0);
    }

    Machine& machine_;
    const VcdOptions& options_;
    MachineWatch<Depth> watch_;
    VcdText vcd_;
    VcdText::Signal clock_, cycle_;
    ReaderSignals reader_;
    std::deque<StageSignals> stages_;
};

}  // namespace

template <class Depth>
std::string vcd_of(shadow::ClockedPostProcess<Depth>& machine, const VcdOptions& options) {
    return VcdWriter<Depth>(machine, options)();
}

template <class Depth>
void write_vcd(const Path& path, shadow::ClockedPostProcess<Depth>& machine,
               const VcdOptions& options, FileSet* set) {
    const std::string text = vcd_of(machine, options);
    write_file(path, std::as_bytes(std::span(text)), set);
}

#define UMBRA78_VCD(Depth)                                                                     \
    template std::string vcd_of(shadow::ClockedPostProcess<Depth>&, const VcdOptions&);        \
    template void write_vcd(const Path&, shadow::ClockedPostProcess<Depth>&, const VcdOptions&, \
                            FileSet*);
UMBRA78_VCD(hw::Depth16)
UMBRA78_VCD(hw::Depth32)
#undef UMBRA78_VCD

void write_vcd(const Path& path, const RenderJob& job, VcdOptions options, FileSet* set) {
    WatchedFrame frame(job);
    options.clock_ns = job.settings().timing.clock_ns;
    write_vcd(path, *frame.machine(), options, set);
}

}  // namespace umbra78::tools
