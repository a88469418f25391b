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
          blends(interpolates(s.machine, s.lookup)), banks(s.timing.light_banks) {
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

// To an hw::Chain or an hw::StageList.
template <class Stages>
void add_lookup_stages(Stages& chain, const LookupPipeline& plan) {
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
    FourCodes texel{};                    // (0,0) (1,0) (0,1) (1,1); or the first alone
    std::int64_t upper = 0, lower = 0, blend = 0;
    bool shadow = false;

    void place(const LookupPipeline& plan, const hw::Point& p, const hw::DitherWords& d) {
        const LightPlace at = light_place(plan.spec, p, d);
        x = at.x;
        y = at.y;
        code = at.code;
        outside = !at.inside;
        if (outside) return;
        const TexelPlace t = texel_place(plan.spec, plan.blends, x, y);
        tx = t.x;
        ty = t.y;
        fx = t.fx;
        fy = t.fy;
    }

    template <class Depth>
    void fetch(const LookupPipeline& plan, const LightMap<Depth>& map, int cycle) {
        if (outside) return;
        const int each = plan.blends ? plan.banks : 1;
        for (int k = cycle * each; k < (cycle + 1) * each; ++k)
            texel[static_cast<std::size_t>(k)] = map.texel(tx + k % 2, ty + k / 2);
    }

    // On the last cycle all six products are there.
    void interpolate(const LookupPipeline& plan, int cycle) {
        if (outside || cycle < plan.interpolate_cycles() - 1) return;
        const Blend b = blend_of(plan.spec, fx, fy, texel);
        upper = b.upper;
        lower = b.lower;
        blend = b.z;
    }

    void compare(const LookupPipeline& plan) {
        shadow = false;
        if (outside) return;
        if (plan.blends && !falls_back(plan.spec, plan.background, texel)) {
            shadow = blend_scale(plan.spec, code) > blend;
        } else {
            shadow = code > texel[plan.blends ? nearest_of_four(plan.spec, fx, fy) : 0];
        }
    }
};

}  // namespace umbra78::shadow
