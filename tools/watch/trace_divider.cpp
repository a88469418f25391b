// The divider's words: dividend, divisor, quotient, and the certificate.
//
// The certificate is a check of the quotient that needs no division (hw/MACHINE.md, section 5).
#include "tools/watch/trace_units.hpp"

#include <fmt/format.h>

namespace umbra78::tools {
namespace {

using fixed::DivideStatus;

void trace_start(TraceLog& log, const TracedPoint& p, int r) {
    const auto& d = p.flight.divider;
    const auto row = static_cast<std::size_t>(r);
    const int bits = p.spec().accumulator_bits();
    const char* name = row_names[r];
    log.word(fmt::format("dividend_{}", name), signed_word(d.dividend[row], bits), "x");
    log.word(fmt::format("divisor_{}", name), signed_word(d.dividend[3], bits), "w");
    log.word(fmt::format("shift_{}", name), signed_word(p.plan.divide.shift(r), 8),
             fmt::format("k: q = x 2^k / w, of {} bits", p.plan.divide.bits(r)));
    if (d.row[row].result.status != DivideStatus::ok) return;
    log.word(fmt::format("remainder_{}", name),
             unsigned_word(static_cast<std::int64_t>(d.row[row].remainder), bits),
             "the bits of |x| above the quotient's");
}

// 2 |q w - x 2^k| <= w. For negative k both sides are multiplied by 2^-k, so that they are whole.
void trace_certificate(TraceLog& log, const TracedPoint& p, int r) {
    const auto& d = p.flight.divider;
    const auto row = static_cast<std::size_t>(r);
    const int shift = p.plan.divide.shift(r);
    const int up = shift > 0 ? shift : 0, down = shift < 0 ? -shift : 0;
    const WideWord divisor = WideWord(d.dividend[3]) << down;
    const WideWord left =
        (WideWord(d.row[row].result.value) * divisor - (WideWord(d.dividend[row]) << up)).abs()
        << 1;
    log.number(fmt::format("2|q w - x 2^k|_{}", row_names[r]), left,
               down == 0 ? "the certificate's left side"
                         : fmt::format("the certificate's left side, times 2^{}", down));
    const bool holds = left <= divisor;
    log.number(fmt::format("w_{}", row_names[r]), divisor,
               holds ? "its right side: it holds"
                     : "its right side: it fails, because this rounding is not to the nearest");
}

void trace_end(TraceLog& log, const TracedPoint& p, int r) {
    const auto& d = p.flight.divider.row[static_cast<std::size_t>(r)];
    const hw::MachineSpec& m = p.spec();
    const char* name = row_names[r];
    if (d.result.status == DivideStatus::divisor_not_positive)
        return log.say(fmt::format("row {}: divisor_not_positive, no quotient", name));
    if (d.result.status == DivideStatus::overflow)
        return log.say(fmt::format("row {}: overflow, the quotient does not fit {} bits", name,
                                   p.plan.divide.bits(r)));
    log.word(fmt::format("quotient_{}", name),
             unsigned_word(static_cast<std::int64_t>(d.quotient), p.plan.divide.bits(r) + 1),
             "floor(2 |q|): the last bit is a half");
    log.word(fmt::format("remainder_{}", name),
             unsigned_word(static_cast<std::int64_t>(d.remainder), m.accumulator_bits()),
             "the remainder after the last bit");
    log.word(fmt::format("R_{}", name),
             signed_word(d.result.value, p.plan.divide.bits(r),
                         r == 2 ? m.depth_fraction() : m.fraction_bits),
             "q, rounded, with its sign");
    trace_certificate(log, p, r);
}

}  // namespace

void trace_divide(TraceLog& log, const TracedPoint& p, int step, std::uint64_t cycle) {
    log.at("divide", cycle);
    for (int r = 0; r < 3; ++r) {
        if (step == p.plan.divide.first_step(r)) trace_start(log, p, r);
        if (step == p.plan.divide.last_step(r)) trace_end(log, p, r);
    }
}

}  // namespace umbra78::tools
