// The lookup, clocked: place, fetch, interpolate, compare.
//
//   X, Y, Z --> [ place ]--> [ fetch ]--> [ interpolate ]--> [ compare ]--> in shadow?
//              + dither,     1 word, or    bilinear only:
//              inside the    4 in as many  6 products on as many
//              volume?       cycles, or    multipliers as the
//                            in 4 banks    transform unit has
//
// Interpolation is linear along x on two rows, then along y: 2 + 2 + 2 products, exact, so that
// code 2^(2F) is compared with the blend as in shadow/compare.hpp, which gives the same bits.
// A point that is lit whatever the map says (outside the light's volume, without a quotient) goes
// through the stages all the same and reads nothing.
#pragma once

#include "hw/clocked/handshake.hpp"
#include "shadow/clocked/timed_test.hpp"
#include "shadow/compare.hpp"

#include <array>
#include <cstdint>

namespace umbra78::shadow {

class LookupPipeline {
public:
    explicit LookupPipeline(const TimedTest& s)
        : spec(s.machine), background(s.background),
          blends(s.lookup == Lookup::bilinear && s.machine.fraction_bits > 0),
          banks(s.timing.light_banks) {
        const int products = 6;
        interpolate_cycles_ = (products + s.machine.multipliers - 1) / s.machine.multipliers;
    }

    int fetch_cycles() const { return blends ? 4 / banks : 1; }
    int interpolate_cycles() const { return interpolate_cycles_; }

    hw::MachineSpec spec;
    Background background;
    bool blends;
    int banks;

private:
    int interpolate_cycles_;
};

template <class Rule>
void add_lookup_stages(hw::Chain<Rule>& chain, const LookupPipeline& plan) {
    chain.add("place");
    chain.add("fetch", plan.fetch_cycles());
    if (plan.blends) chain.add("interpolate", plan.interpolate_cycles());
    chain.add("compare");
}

struct LookupRegisters {
    std::int64_t x = 0, y = 0, code = 0;  // dithered; the Z code to compare
    bool outside = false;                 // lit without a look
    std::int32_t tx = 0, ty = 0;          // the texel, or the upper left of four
    std::int32_t fx = 0, fy = 0;          // 0 .. 2^F - 1
    std::array<std::uint32_t, 4> texel{};  // (0,0) (1,0) (0,1) (1,1)
    std::int64_t upper = 0, lower = 0, blend = 0;
    bool shadow = false;

    void place(const LookupPipeline& plan, const hw::Point& p, const hw::DitherWords& d) {
        const hw::MachineSpec& m = plan.spec;
        const std::int64_t edge = std::int64_t{m.half_px()} << m.fraction_bits;
        x = p.x + d.x;
        y = p.y + d.y;
        code = p.z + m.depth_offset();
        outside = p.status != hw::DivideStatus::ok || x < -edge || x >= edge || y < -edge ||
                  y >= edge || code < 0 || code > m.deepest_drawn();
        if (outside) return;
        const std::int64_t one = std::int64_t{1} << m.fraction_bits;
        const std::int64_t back = plan.blends ? one / 2 : 0;
        tx = static_cast<std::int32_t>((x - back) >> m.fraction_bits) + m.half_px();
        ty = static_cast<std::int32_t>((y - back) >> m.fraction_bits) + m.half_px();
        fx = static_cast<std::int32_t>((x - back) & (one - 1));
        fy = static_cast<std::int32_t>((y - back) & (one - 1));
    }

    template <class Depth>
    void fetch(const LookupPipeline& plan, const LightMap<Depth>& map, int cycle) {
        if (outside) return;
        const int each = plan.blends ? plan.banks : 1;
        for (int k = cycle * each; k < (cycle + 1) * each; ++k)
            texel[static_cast<std::size_t>(k)] = map.texel(tx + (k & 1), ty + (k >> 1));
    }

    // On the last cycle all six products are there.
    void interpolate(const LookupPipeline& plan, int cycle) {
        if (outside || cycle < plan.interpolate_cycles() - 1) return;
        const std::int64_t one = std::int64_t{1} << plan.spec.fraction_bits;
        upper = (one - fx) * texel[0] + fx * std::int64_t{texel[1]};
        lower = (one - fx) * texel[2] + fx * std::int64_t{texel[3]};
        blend = (one - fy) * upper + fy * lower;
    }

    void compare(const LookupPipeline& plan) {
        const int f = plan.spec.fraction_bits;
        shadow = false;
        if (outside) return;
        if (plan.blends && !falls_back(plan)) {
            shadow = code * (std::int64_t{1} << (2 * f)) > blend;
        } else {
            // The texel the point lies in is the first, or of the four the one nearest.
            const int k = plan.blends ? nearest_of_four(f) : 0;
            shadow = code > texel[static_cast<std::size_t>(k)];
        }
    }

private:
    bool falls_back(const LookupPipeline& plan) const {
        if (plan.background != Background::fall_back) return false;
        for (const std::uint32_t t : texel)
            if (t == plan.spec.background()) return true;
        return false;
    }
    int nearest_of_four(int f) const {
        const int half = 1 << (f - 1);
        return (fx >= half ? 1 : 0) + (fy >= half ? 2 : 0);
    }
};

}  // namespace umbra78::shadow
