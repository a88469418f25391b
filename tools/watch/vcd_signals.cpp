// The signals of each kind of stage, with their widths.
#include "tools/watch/vcd_signals.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace umbra78::tools {
namespace {

using shadow::PointRegisters;
using shadow::StageKind;

constexpr const char* axes[] = {"x", "y", "z", "w"};

}  // namespace

StageSignals::StageSignals(VcdText& vcd, const std::string& scope, StageKind kind, bool first,
                           const shadow::PostProcessPipeline& plan)
    : vcd_(vcd), scope_(scope), state_(vcd.add(scope, "state", 2)),
      valid_(vcd.add(scope, "valid", 1)), ready_(vcd.add(scope, "ready", 1)),
      point_(vcd.add(scope, "point", 32)),
      px_(vcd.add(scope, "px", plan.lookup.spec.xy_bits)),
      py_(vcd.add(scope, "py", plan.lookup.spec.xy_bits)) {
    add_ports(kind, first, plan);
}

template <class Read>
void StageSignals::port(const std::string& name, int bits, Read read) {
    ports_.push_back({vcd_.add(scope_, name, bits), read});
}

void StageSignals::add_ports(StageKind kind, bool first, const shadow::PostProcessPipeline& plan) {
    const hw::MachineSpec& m = plan.lookup.spec;
    switch (kind) {
        case StageKind::transform: return transform_ports(first, plan.transform);
        case StageKind::divide: return divider_ports(plan);
        case StageKind::place: return place_ports(plan);
        case StageKind::fetch: return fetch_ports(plan.lookup);
        case StageKind::interpolate: return interpolate_ports(m);
        case StageKind::sum:
            return port("sum", m.z_bits + 5, [](const PointRegisters& f) { return f.lookup.sum; });
        case StageKind::compare:
            return compare_ports(plan.lookup);
        case StageKind::write: break;
    }
    port("address", 2 * m.xy_bits, [n = m.xy_bits](const PointRegisters& f) {
        return (std::int64_t{f.py} << n) + f.px;
    });
    port("mask", 8, [](const PointRegisters& f) { return f.lookup.darkness; });
}

// A point's registers move with it, so every stage of the unit has its accumulators.
void StageSignals::transform_ports(bool first, const hw::TransformPipeline& t) {
    const hw::MachineSpec& m = t.spec();
    const auto rows = static_cast<std::size_t>(t.rows());
    if (first) {
        port("word_x", m.word_bits(), [](const PointRegisters& f) { return f.transform.words.x; });
        port("word_y", m.word_bits(), [](const PointRegisters& f) { return f.transform.words.y; });
        port("word_z", m.word_bits(), [](const PointRegisters& f) { return f.transform.words.z; });
        for (std::size_t r = 0; r < rows; ++r)
            for (std::size_t c = 0; c < static_cast<std::size_t>(t.columns()); ++c)
                port(fmt::format("product_{}{}", axes[r], c), m.word_bits() + m.coefficient_bits,
                     [r, c](const PointRegisters& f) { return f.transform.product[r][c]; });
    }
    for (std::size_t r = 0; r < rows; ++r)
        port(fmt::format("accumulator_{}", axes[r]), m.accumulator_bits(),
             [r](const PointRegisters& f) { return f.transform.accumulator[r]; });
    for (std::size_t r = 0; t.rounds() && r < rows; ++r)
        port(fmt::format("result_{}", axes[r]), t.result_bits(static_cast<int>(r)),
             [r](const PointRegisters& f) { return f.transform.result[r]; });
}

void StageSignals::divider_ports(const shadow::PostProcessPipeline& plan) {
    const int bits = plan.lookup.spec.accumulator_bits();
    port("divisor", bits, [](const PointRegisters& f) { return f.divider.dividend[3]; });
    for (std::size_t r = 0; r < 3; ++r) {
        const int quotient_bits = plan.divide.bits(static_cast<int>(r)) + 1;
        port(fmt::format("dividend_{}", axes[r]), bits,
             [r](const PointRegisters& f) { return f.divider.dividend[r]; });
        port(fmt::format("remainder_{}", axes[r]), bits, [r](const PointRegisters& f) {
            return static_cast<std::int64_t>(f.divider.row[r].remainder);
        });
        port(fmt::format("quotient_{}", axes[r]), quotient_bits, [r](const PointRegisters& f) {
            return static_cast<std::int64_t>(f.divider.row[r].quotient);
        });
    }
}

// X and Y include their dither, Z an offset of half the range: one bit more than the results.
void StageSignals::place_ports(const shadow::PostProcessPipeline& plan) {
    const hw::MachineSpec& m = plan.lookup.spec;
    const auto bits = [&](int row) {
        const int nominal = row == 2 ? m.z_bits + 1 : m.xy_bits + m.fraction_bits + 1;
        return 1 + (plan.divides ? nominal : std::max(nominal, plan.transform.result_bits(row)));
    };
    port("x", bits(0), [](const PointRegisters& f) { return f.lookup.x; });
    port("y", bits(1), [](const PointRegisters& f) { return f.lookup.y; });
    port("code", bits(2), [](const PointRegisters& f) { return f.lookup.code; });
    port("outside", 1, [](const PointRegisters& f) { return f.lookup.outside; });
    port("tx", m.xy_bits + 1, [](const PointRegisters& f) { return f.lookup.tx; });
    port("ty", m.xy_bits + 1, [](const PointRegisters& f) { return f.lookup.ty; });
    if (m.fraction_bits == 0) return;
    port("fx", m.fraction_bits, [](const PointRegisters& f) { return f.lookup.fx; });
    port("fy", m.fraction_bits, [](const PointRegisters& f) { return f.lookup.fy; });
}

void StageSignals::fetch_ports(const shadow::LookupPipeline& plan) {
    const auto side = static_cast<std::size_t>(plan.window.side);
    for (std::size_t k = 0; k < side * side; ++k)
        port(fmt::format("texel_{}{}", k % side, k / side), plan.spec.z_bits,
             [k](const PointRegisters& f) { return f.lookup.texel[k]; });
}

void StageSignals::compare_ports(const shadow::LookupPipeline& plan) {
    if (!plan.counts())
        return port("shadow", 1, [](const PointRegisters& f) {
            return f.lookup.darkness == shadow::mask_shadow;
        });
    port("count", 5, [](const PointRegisters& f) { return f.lookup.count; });
    port("darkness", 8, [](const PointRegisters& f) { return f.lookup.darkness; });
}

void StageSignals::interpolate_ports(const hw::MachineSpec& m) {
    const int along_x = m.z_bits + m.fraction_bits;
    port("upper", along_x, [](const PointRegisters& f) { return f.lookup.upper; });
    port("lower", along_x, [](const PointRegisters& f) { return f.lookup.lower; });
    port("blend", along_x + m.fraction_bits,
         [](const PointRegisters& f) { return f.lookup.blend; });
}

void StageSignals::set(VcdText& vcd, const StageCycle& s, const PointRegisters* in_it) const {
    vcd.set(state_, static_cast<std::int64_t>(s.activity));
    vcd.set(valid_, s.valid);
    vcd.set(ready_, s.ready);
    vcd.set(point_, static_cast<std::int64_t>(s.point));
    if (!in_it) return;
    vcd.set(px_, in_it->px);
    vcd.set(py_, in_it->py);
    for (const Port& p : ports_) vcd.set(p.signal, p.read(*in_it));
}

}  // namespace umbra78::tools
