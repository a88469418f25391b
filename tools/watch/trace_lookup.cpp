// The lookup's words: the place, the texels, the blend, both sides of the comparison, the mask.
#include "tools/watch/trace_units.hpp"

#include "shadow/post_process.hpp"

#include <fmt/format.h>

namespace umbra78::tools {
namespace {

// Bits of a code times 2^(2F), the scale of both sides of the bilinear comparison.
int blend_bits(const hw::MachineSpec& m) { return m.z_bits + 2 * m.fraction_bits; }

void say_outside(TraceLog& log, const TracedPoint& p) {
    const hw::MachineSpec& m = p.spec();
    const shadow::LookupRegisters& l = p.flight.lookup;
    if (p.flight.point.status != hw::DivideStatus::ok)
        return log.say("there is no quotient: lit, and nothing is read");
    if (!shadow::inside_width(m, l.x))
        log.say("X is outside the light's volume: lit, and nothing is read");
    if (!shadow::inside_width(m, l.y))
        log.say("Y is outside the light's volume: lit, and nothing is read");
    if (!shadow::inside_depth(m, l.code))
        log.say("k is outside the light's volume: lit, and nothing is read");
}

// The first texel of a grid.
void trace_first(TraceLog& log, const TracedPoint& p) {
    const hw::MachineSpec& m = p.spec();
    const int f = m.fraction_bits, k = p.plan.lookup.window.side;
    const auto how = [&](const char* axis) {
        return fmt::format("((2 {} - {}) >> {}) + {}: the first of {}", axis,
                           std::int64_t{k - 1} << f, f + 1, m.half_px(), k);
    };
    log.word("tx", signed_word(p.flight.lookup.tx, m.xy_bits + 1), how("X"));
    log.word("ty", signed_word(p.flight.lookup.ty, m.xy_bits + 1), how("Y"));
}

void trace_jitter(TraceLog& log, const TracedPoint& p) {
    const shadow::LookupRegisters& l = p.flight.lookup;
    for (int t = 0; t < p.plan.lookup.window.taps(); ++t) {
        const auto k = static_cast<std::size_t>(t);
        const int i = t % p.plan.lookup.window.side, j = t / p.plan.lookup.window.side;
        const auto byte = [&](const char* name, std::uint8_t value, int texel) {
            log.word(fmt::format("{}({},{})", name, i, j), unsigned_word(value, 8),
                     fmt::format("256ths of the tap's cell, which put it on texel {}", texel));
        };
        byte("u", l.noise.x[k], l.tap[k].x);
        byte("v", l.noise.y[k], l.tap[k].y);
    }
}

// Both sides of the comparison of percentage and filtered_depth lookup.
void trace_window(TraceLog& log, const TracedPoint& p) {
    const hw::MachineSpec& m = p.spec();
    const shadow::LookupRegisters& l = p.flight.lookup;
    const int taps = p.plan.lookup.window.taps();
    if (p.plan.lookup.counts()) {
        log.word("count", unsigned_word(l.count, 5),
                 fmt::format("of {} taps whose code is less than k", taps));
        return log.word("darkness", unsigned_word(l.darkness, 8),
                        fmt::format("half_up(255 x {} / {})", l.count, taps));
    }
    log.word("taps k", unsigned_word(taps * l.code, m.z_bits + 5), "the point's side");
    log.word("sum", unsigned_word(l.sum, m.z_bits + 5), "the light map's side");
    log.word("shadow", unsigned_word(l.darkness == shadow::mask_shadow, 1), "taps k > sum");
}

}  // namespace

void trace_place(TraceLog& log, const TracedPoint& p) {
    const hw::MachineSpec& m = p.spec();
    const shadow::LookupRegisters& l = p.flight.lookup;
    const int f = m.fraction_bits, bits = m.xy_bits + f + 2;
    const std::int64_t edge = shadow::volume_edge(m);
    const bool dithers = p.plan.dithers;
    log.word("X", signed_word(l.x, bits, f), dithers ? "R_X + dither_X" : "R_X");
    log.word("Y", signed_word(l.y, bits, f), dithers ? "R_Y + dither_Y" : "R_Y");
    log.word("k", signed_word(l.code, m.z_bits + 2),
             fmt::format("R_Z + {}: the code to compare{}", m.depth_offset(),
                         m.depth_store == hw::DepthStore::fixed ? ""
                                                                : ", the nearest that is kept"));
    if (l.outside) return say_outside(log, p);
    log.say(fmt::format("inside the light's volume: {} <= X, Y < {} and 0 <= k <= {}", -edge, edge,
                        m.deepest_drawn()));
    if (p.plan.lookup.window.jittered) return trace_jitter(log, p);
    if (shadow::has_window(p.plan.lookup.lookup)) return trace_first(log, p);
    const bool blends = p.plan.lookup.blends;
    const auto how = [&](const char* axis) {
        const std::string from =
            blends ? fmt::format("({} - {})", axis, std::int64_t{1} << f >> 1) : axis;
        return fmt::format("({} >> {}) + {}", from, f, m.half_px());
    };
    log.word("tx", signed_word(l.tx, m.xy_bits + 1), how("X"));
    log.word("ty", signed_word(l.ty, m.xy_bits + 1), how("Y"));
    if (f == 0) return;
    log.word("fx", unsigned_word(l.fx, f, f), "the fraction that is left");
    log.word("fy", unsigned_word(l.fy, f, f), "the fraction that is left");
}

void trace_fetch(TraceLog& log, const TracedPoint& p, int step) {
    const shadow::LookupRegisters& l = p.flight.lookup;
    if (l.outside) return;
    const shadow::LookupPipeline& plan = p.plan.lookup;
    for (int k = 0; k < plan.window.taps(); ++k) {
        if (!plan.takes(step, k)) continue;
        const auto [x, y] = l.tap[static_cast<std::size_t>(k)];
        const std::uint32_t code = l.texel[static_cast<std::size_t>(k)];
        const bool beyond = !shadow::on_map(p.spec(), x, y);
        log.word(fmt::format("z({},{})", x, y), unsigned_word(code, p.spec().z_bits),
                 beyond                            ? "beyond the map's edge: background"
                 : code == p.spec().background()   ? "the light map's code: background"
                                                   : "the light map's code");
    }
}

void trace_interpolate(TraceLog& log, const TracedPoint& p, int step) {
    const shadow::LookupRegisters& l = p.flight.lookup;
    if (l.outside || step < p.plan.lookup.interpolate_cycles() - 1) return;
    const int f = p.spec().fraction_bits, row_bits = p.spec().z_bits + f;
    const std::int64_t q = std::int64_t{1} << f;
    const auto product = [&](const char* name, std::int64_t weight, std::int64_t of, int fraction,
                             int bits) {
        log.word(name, unsigned_word(weight * of, bits, fraction),
                 fmt::format("{} times {}", weight, of));
    };
    product("(q-fx) z00", q - l.fx, l.texel[0], f, row_bits);
    product("fx z10", l.fx, l.texel[1], f, row_bits);
    product("(q-fx) z01", q - l.fx, l.texel[2], f, row_bits);
    product("fx z11", l.fx, l.texel[3], f, row_bits);
    log.word("upper", unsigned_word(l.upper, row_bits, f), "along x, on row ty");
    log.word("lower", unsigned_word(l.lower, row_bits, f), "along x, on row ty + 1");
    product("(q-fy) upper", q - l.fy, l.upper, 2 * f, blend_bits(p.spec()));
    product("fy lower", l.fy, l.lower, 2 * f, blend_bits(p.spec()));
    log.word("blend", unsigned_word(l.blend, blend_bits(p.spec()), 2 * f), "along y");
}

void trace_sum(TraceLog& log, const TracedPoint& p, int step) {
    const shadow::LookupRegisters& l = p.flight.lookup;
    if (l.outside || step < p.plan.lookup.fetch_cycles() - 1) return;
    log.word("sum", unsigned_word(l.sum, p.spec().z_bits + 5),
             fmt::format("of the {} codes", p.plan.lookup.window.taps()));
}

void trace_compare(TraceLog& log, const TracedPoint& p, int step) {
    const hw::MachineSpec& m = p.spec();
    const shadow::LookupRegisters& l = p.flight.lookup;
    const shadow::LookupPipeline& plan = p.plan.lookup;
    if (step < plan.compare_cycles() - 1) return;
    if (l.outside) return log.say("lit without a comparison");
    if (shadow::has_window(plan.lookup)) return trace_window(log, p);
    const bool shadow = l.darkness == shadow::mask_shadow;
    std::size_t texel = 0;
    if (plan.blends) {
        if (!shadow::falls_back(m, plan.background, l.four())) {
            const int f = m.fraction_bits;
            log.word("k q^2", unsigned_word(shadow::blend_scale(m, l.code), blend_bits(m), 2 * f),
                     "the point's side");
            log.word("blend", unsigned_word(l.blend, blend_bits(m), 2 * f), "the light map's side");
            return log.word("shadow", unsigned_word(shadow, 1), "k q^2 > blend");
        }
        texel = shadow::nearest_of_four(m, l.fx, l.fy);
        log.say("one of the four is background: falls back to the nearest texel");
    }
    log.word("k", unsigned_word(l.code, m.z_bits), "the point's side");
    log.word("z", unsigned_word(l.texel[texel], m.z_bits), "the light map's side");
    log.word("shadow", unsigned_word(shadow, 1), "k > z");
}

void trace_write(TraceLog& log, const TracedPoint& p, std::uint8_t mask) {
    const std::int64_t address = (std::int64_t{p.flight.py} << p.spec().xy_bits) + p.flight.px;
    log.word("address", unsigned_word(address, 2 * p.spec().xy_bits), "py N + px");
    log.word("mask", unsigned_word(mask, 8),
             mask == shadow::mask_shadow ? "in shadow"
             : mask == shadow::mask_lit  ? "lit"
                                         : "in shadow in part");
}

}  // namespace umbra78::tools
