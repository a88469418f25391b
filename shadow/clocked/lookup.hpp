// The lookup, clocked: place, fetch, interpolate or sum, compare.
//
//   X, Y, Z --> [ place ]--> [ fetch ]--> [ interpolate ]--> [ compare ]--> darkness
//              + dither,     1 word, or    bilinear only:     percentage: as
//              inside the    k^2 in as     6 products on as   many cycles as
//              volume?       many cycles,  many multipliers   fetch, counting
//                            or 2 x 2 in   as the transform
//                            4 banks       unit has
//                                         [ sum ], filtered_depth only: as
//                                          many cycles as fetch, adding
//
// Interpolation is linear along x on two rows, then along y: 2 + 2 + 2 products, exact, so that
// code 2^(2F) is compared with the blend as in shadow/compare.hpp, which gives the same bits. A
// window's words are compared, or added, as many in a cycle as a cycle of fetch brought.
// A point that is lit whatever the map says (outside the light's volume, without a quotient) goes
// through the stages all the same and reads nothing.
#pragma once

#include "hw/clocked/handshake.hpp"
#include "shadow/clocked/timed_test.hpp"
#include "shadow/compare.hpp"

#include <array>
#include <cstdint>

namespace umbra78::shadow {

// The reader's cycles for the taps' noise, whose register shifts as fast as the dither's and beside
// it; 0 without jittered taps.
constexpr int tap_noise_cycles(const Window& w, const hw::Timing& timing) {
    return (16 * w.noisy_taps() + timing.noise_bits - 1) / timing.noise_bits;
}

class LookupPipeline {
public:
    explicit LookupPipeline(const TimedTest& s)
        : spec(s.machine), lookup(s.lookup), background(s.background),
          blends(interpolates(s.machine, s.lookup)), window(window_of(s)),
          banks(s.timing.light_banks) {
        for (int t = 0; t < window.taps(); ++t)
            cycle_of_[static_cast<std::size_t>(t)] =
                static_cast<std::uint8_t>(shadow::fetch_cycle(window, banks, t));
        fetch_cycles_ = shadow::fetch_cycles(window, banks);
        const int products = 6;
        interpolate_cycles_ = (products + s.machine.multipliers - 1) / s.machine.multipliers;
    }

    bool counts() const { return lookup == Lookup::percentage; }
    bool sums() const { return lookup == Lookup::filtered_depth; }

    int fetch_cycles() const { return fetch_cycles_; }
    int interpolate_cycles() const { return interpolate_cycles_; }
    int compare_cycles() const { return counts() ? fetch_cycles() : 1; }

    // Taps that the n-th cycle of fetch, sum or compare works on.
    bool takes(int cycle, int tap) const {
        return cycle_of_[static_cast<std::size_t>(tap)] == cycle;
    }

    hw::MachineSpec spec;
    Lookup lookup;
    Background background;
    bool blends;
    Window window;
    int banks;

private:
    int interpolate_cycles_, fetch_cycles_;
    std::array<std::uint8_t, hw::max_taps> cycle_of_{};  // of fetching, by tap
};

// To an hw::Chain or an hw::StageList.
template <class Stages>
void add_lookup_stages(Stages& chain, const LookupPipeline& plan) {
    chain.add("place");
    chain.add("fetch", plan.fetch_cycles());
    if (plan.blends) chain.add("interpolate", plan.interpolate_cycles());
    if (plan.sums()) chain.add("sum", plan.fetch_cycles());
    chain.add("compare", plan.compare_cycles());
}

struct LookupRegisters {
    std::int64_t x = 0, y = 0, code = 0;  // dithered; the Z code to compare
    bool outside = false;                 // lit without a look
    std::int32_t tx = 0, ty = 0;          // the texel, the upper left of four, or a grid's first
    std::int32_t fx = 0, fy = 0;          // 0 .. 2^F - 1
    hw::TapBytes noise{};                 // of jittered taps
    std::array<Texel, hw::max_taps> tap{};           // row by row: (0,0) (1,0) .. (0,1) ..
    std::array<std::uint32_t, hw::max_taps> texel{};  // what the map holds there
    std::int64_t upper = 0, lower = 0, blend = 0;
    int count = 0;                        // of taps that darken
    std::int64_t sum = 0;                 // of the taps' codes
    std::uint8_t darkness = mask_lit;

    void place(const LookupPipeline& plan, const hw::Point& p, const hw::DitherWords& d,
               const hw::TapBytes& bytes) {
        const LightPlace at = light_place(plan.spec, p, d);
        x = at.x;
        y = at.y;
        code = at.code;
        outside = !at.inside;
        noise = bytes;
        count = 0;
        sum = 0;
        if (outside) return;
        tx = first_texel(plan.spec, plan.window, x);
        ty = first_texel(plan.spec, plan.window, y);
        const int side = plan.window.side;
        for (int j = 0, t = 0; j < side; ++j)
            for (int i = 0; i < side; ++i, ++t)
                tap[static_cast<std::size_t>(t)] =
                    plan.window.jittered ? tap_texel(plan.spec, plan.window, t, at, noise)
                                         : Texel{tx + i, ty + j};
        const TexelPlace t = texel_place(plan.spec, plan.blends, x, y);
        fx = t.fx;
        fy = t.fy;
    }

    template <class Depth>
    void fetch(const LookupPipeline& plan, const LightMap<Depth>& map, int cycle) {
        for_taps(plan, cycle, [&](std::size_t t) { texel[t] = map.texel(tap[t].x, tap[t].y); });
    }

    // On the last cycle all six products are there.
    void interpolate(const LookupPipeline& plan, int cycle) {
        if (outside || cycle < plan.interpolate_cycles() - 1) return;
        const Blend b = blend_of(plan.spec, fx, fy, four());
        upper = b.upper;
        lower = b.lower;
        blend = b.z;
    }

    void add(const LookupPipeline& plan, int cycle) {
        for_taps(plan, cycle, [&](std::size_t t) { sum += texel[t]; });
    }

    void compare(const LookupPipeline& plan, int cycle) {
        darkness = mask_lit;
        if (outside) return;
        if (plan.counts()) {
            for_taps(plan, cycle, [&](std::size_t t) { count += code > texel[t]; });
            darkness = share_of_dark(count, plan.window);
        } else if (plan.sums()) {
            darken(code * plan.window.taps() > sum);
        } else if (plan.blends && !falls_back(plan.spec, plan.background, four())) {
            darken(blend_scale(plan.spec, code) > blend);
        } else {
            darken(code > texel[plan.blends ? nearest_of_four(plan.spec, fx, fy) : 0]);
        }
    }

    FourCodes four() const { return {texel[0], texel[1], texel[2], texel[3]}; }

private:
    void darken(bool shadow) { darkness = shadow ? mask_shadow : mask_lit; }

    template <class Work>
    void for_taps(const LookupPipeline& plan, int cycle, Work work) {
        if (outside) return;
        for (int t = 0; t < plan.window.taps(); ++t)
            if (plan.takes(cycle, t)) work(static_cast<std::size_t>(t));
    }
};

}  // namespace umbra78::shadow
