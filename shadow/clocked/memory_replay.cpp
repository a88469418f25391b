// The recurrence of the memory replay, walked pixel by pixel in scan order.
#include "shadow/clocked/memory_replay.hpp"

#include "fixed/trap.hpp"
#include "hw/noise_source.hpp"
#include "shadow/post_process.hpp"
#include "shadow/window.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace umbra78::shadow {
namespace {

// A time, and the services it is the sum of.
struct Moment {
    std::uint64_t ns = 0;
    PathTime path{};

    Moment after(std::uint64_t service_ns, std::uint64_t PathTime::* stage) const {
        Moment m = *this;
        m.ns += service_ns;
        m.path.*stage += service_ns;
        return m;
    }
};

const Moment& later(const Moment& own, const Moment& next) {
    return own.ns >= next.ns ? own : next;
}

// Four stages with a register each. A service is given the time at which its stage is entered, and
// returns the time that it takes.
class Pipeline {
public:
    template <class Read, class Light, class Write>
    void token(Read read, std::uint64_t unit_ns, Light light, Write write) {
        const Moment r = read_.after(read(read_.ns), &PathTime::read_ns);
        read_ = later(r, unit_);
        unit_ = later(read_.after(unit_ns, &PathTime::unit_ns), light_);
        light_ = later(unit_.after(light(unit_.ns), &PathTime::light_ns), write_);
        write_ = light_.after(write(light_.ns), &PathTime::write_ns);
    }
    const Moment& end() const { return write_; }

private:
    Moment read_, unit_, light_, write_;  // when the last token left each stage
};

// Calls visit(first, count) for the texels of each request.
template <class Visit>
void for_requests(const Texels& t, Visit visit) {
    for (std::size_t k = 0, end; k < t.count; k = end) {
        end = k + 1;
        while (end < t.count && t.cycle[end] == t.cycle[k]) ++end;
        visit(k, end - k);
    }
}

// A store on a machine with a clock: the time from a request to the first clock edge at which the
// data is there.
class ClockedStore {
public:
    ClockedStore(const hw::Timing& timing, const hw::DramMap& map, bool shown)
        : map_(map), dram_(timing.dram, map, shown),
          clock_ns_(static_cast<std::uint64_t>(timing.clock_ns)) {}

    std::uint64_t word_ns(std::uint64_t at_ns, int x, int y) {
        const hw::DramPlace p = map_.place(x, y);
        return clocks(dram_.access({&p, 1}, at_ns) - at_ns);
    }

    // Texels of one token: those of a cycle of fetch in one request, and the requests one after the
    // other, at most one a clock.
    std::uint64_t texels_ns(std::uint64_t at_ns, const Texels& t) {
        std::array<hw::DramPlace, hw::max_taps> places{};
        for (std::size_t k = 0; k < t.count; ++k) places[k] = map_.place(t.at[k].x, t.at[k].y);
        std::uint64_t done = at_ns, earliest = at_ns;
        for_requests(t, [&](std::size_t first, std::size_t count) {
            done = dram_.access(std::span(places).subspan(first, count),
                                std::max(done, earliest));
            earliest += clock_ns_;
        });
        return clocks(done - at_ns);
    }

    const hw::DramCounts& counts() const { return dram_.counts(); }

private:
    std::uint64_t clocks(std::uint64_t ns) const {
        return std::max<std::uint64_t>(1, (ns + clock_ns_ - 1) / clock_ns_) * clock_ns_;
    }

    hw::DramMap map_;
    hw::Dram dram_;
    std::uint64_t clock_ns_;
};

// The two frames walked side by side: with the stores, and with ideal ones.
class Replay {
public:
    Replay(const TimedTest& s, std::uint64_t issue_cycles)
        : clock_(static_cast<std::uint64_t>(s.timing.clock_ns)), issue_ns_(issue_cycles * clock_),
          map_{s.machine.xy_bits, 1, s.timing.dram.rows},
          observer_(s.timing, map_, s.timing.dram.video != hw::Video::off),
          light_(s.timing, {s.machine.xy_bits, s.timing.light_banks, s.timing.dram.rows},
                 s.timing.dram.video == hw::Video::all),
          mask_(s.timing, map_, s.timing.dram.video == hw::Video::all) {}

    void token(int x, int y, bool visible, const Texels& texels) {
        const int word_px = map_.word_px();
        const bool first = x % word_px == 0, last = x % word_px == word_px - 1;
        const std::uint64_t unit_ns = visible ? issue_ns_ : clock_;
        const bool none = texels.count == 0;
        real_.token([&](std::uint64_t t) { return first ? observer_.word_ns(t, x, y) : clock_; },
                    unit_ns,
                    [&](std::uint64_t t) { return none ? clock_ : light_.texels_ns(t, texels); },
                    [&](std::uint64_t t) { return last ? mask_.word_ns(t, x, y) : clock_; });
        std::uint64_t requests = none ? 1 : 0;
        for_requests(texels, [&](std::size_t, std::size_t) { ++requests; });
        const auto a_clock = [&](std::uint64_t) { return clock_; };
        ideal_.token(a_clock, unit_ns, [&](std::uint64_t) { return requests * clock_; }, a_clock);
        ++ledger_.pixels;
        ledger_.visible += visible;
        ledger_.looked_up += !none;
    }

    MemoryLedger ledger() const {
        MemoryLedger l = ledger_;
        l.observer = observer_.counts();
        l.light = light_.counts();
        l.mask = mask_.counts();
        l.total_ns = real_.end().ns;
        l.ideal_ns = ideal_.end().ns;
        l.path = real_.end().path;
        l.ideal_path = ideal_.end().path;
        return l;
    }

private:
    std::uint64_t clock_, issue_ns_;
    hw::DramMap map_;
    ClockedStore observer_, light_, mask_;
    Pipeline real_, ideal_;
    MemoryLedger ledger_;
};

template <class Depth>
MemoryLedger replay(const hw::FrameStore<const Depth>& observer, const hw::MatrixWords& matrix,
                    const TimedTest& settings, std::uint64_t issue_cycles) {
    fixed::require(issue_cycles > 0, "memory replay: a visible pixel takes a clock or more");
    const hw::MachineSpec& spec = checked(settings).machine;
    check_observer(observer, spec);
    fixed::require(settings.receiver != Receiver::normal,
                   "memory replay: it moves no point along its normal");
    fixed::require(!reads_normals(settings), "memory replay: it has no store of normals");
    const hw::TransformUnit unit(spec, matrix);
    const bool dithered = !hw::silent(settings.dither, spec);
    fixed::require(window_in_range(settings), "lookup: a window has 2 to 5 taps a side");
    const int noisy_taps = window_of(settings).noisy_taps();
    Replay memory(settings, issue_cycles);
    for (int y = 0; y < spec.size_px(); ++y) {
        hw::NoiseSource noise(drawn_dither(settings), spec, 0, y);
        hw::TapNoise tap_noise(settings.dither.seed, noisy_taps, spec, 0, y);
        for (int x = 0; x < spec.size_px(); ++x) {
            const hw::TapBytes taps = noisy_taps > 0 ? tap_noise.next() : hw::TapBytes{};
            const hw::DitherWords d = dithered ? noise.next() : hw::DitherWords{0, 0};
            const std::uint32_t code = observer.depth[observer.address(x, y)];
            const bool visible = code != spec.background();
            Texels texels;
            if (visible)
                texels = lookup_texels(settings, settings.timing.light_banks,
                                       unit(pixel_words(x, y, code, settings)), d, taps);
            memory.token(x, y, visible, texels);
        }
    }
    return memory.ledger();
}

}  // namespace

MemoryLedger replay_memory(const hw::FrameStore<const hw::Depth16>& observer,
                           const hw::MatrixWords& matrix, const TimedTest& settings,
                           std::uint64_t issue_cycles) {
    return replay(observer, matrix, settings, issue_cycles);
}
MemoryLedger replay_memory(const hw::FrameStore<const hw::Depth32>& observer,
                           const hw::MatrixWords& matrix, const TimedTest& settings,
                           std::uint64_t issue_cycles) {
    return replay(observer, matrix, settings, issue_cycles);
}

}  // namespace umbra78::shadow
