// The published times, and the steps of a pass. hw/MACHINE.md, section 18, has both as tables.
#include "shadow/ap120b/cost.hpp"

#include "fixed/rounding.hpp"
#include "hw/ap120b/transform.hpp"

#include <algorithm>

namespace umbra78::shadow {
namespace {

using hw::ap120b::MemorySpeed;

// An element's published time, in tenths of a microsecond.
struct Published {
    int fast, standard;
};
constexpr Published arithmetic{8, 13};  // vector add, subtract, multiply
constexpr Published compare{8, 13};
constexpr Published fix{7, 8};          // float to fix; fix to float is assumed to take as long
constexpr Published divide{17, 17};     // one figure is given
constexpr Published random{12, 12};     // likewise
constexpr Published pack{9, 9};         // bytes into words, likewise

int cycles(Published p, MemorySpeed speed) {
    const int ns = 100 * (speed == MemorySpeed::fast ? p.fast : p.standard);
    return static_cast<int>(
        fixed::round_divide(ns, hw::ap120b::clock_ns, fixed::Rounding::half_up));
}

}  // namespace

ArrayCost array_cost(const PostProcessCounts& counts, const ShadowTest& settings,
                     MemorySpeed speed, bool affine) {
    using enum ArrayCycleSource;
    const bool bilinear = settings.lookup == Lookup::bilinear;
    const bool falls_back = bilinear && settings.background == Background::fall_back;
    const int dithered = settings.dither.shape != hw::DitherShape::none ? 1 : 0;
    ArrayCost c;
    c.pixels = counts.visible;
    c.lines = counts.lines;
    const auto add = [&](ArrayCostStep s) {
        if (s.elements > 0) c.step[c.steps++] = s;
    };
    const auto routine = [&](std::string_view name, Published p, int elements, int calls,
                             ArrayCycleSource source = published) {
        add({name, source, elements, cycles(p, speed), calls});
    };
    const int codes = bilinear ? 4 : 1;
    routine("float x, y, z", fix, 3, 1, assumed);
    add({"4 x 4 transform", replayed, 1,
         static_cast<int>(hw::ap120b::transform_cycles_a_vector(speed)), 1});
    routine("divide by w", divide, affine ? 0 : 3, 3);
    routine("dither: random words", random, 2 * dithered, 1);
    routine("dither: add", arithmetic, 2 * dithered, 2);
    routine("inside the volume?", compare, affine ? 6 : 7, affine ? 6 : 7);
    routine("fix texel", fix, falls_back ? 4 : 2, falls_back ? 4 : 2);
    routine("texel's fraction", arithmetic, bilinear ? 4 : 0, 4);
    routine("float texel and codes", fix, codes + (bilinear ? 2 : 0), bilinear ? 3 : 1, assumed);
    routine("interpolate", arithmetic, bilinear ? 9 : 0, 9);
    routine("compare", compare, falls_back ? 5 : 1, falls_back ? 5 : 1);
    routine("pack mask", pack, 1, 1);
    // In: px, py, code; out: the texel's two numbers; in: its codes; out: the mask, two a word.
    c.host_bytes = 2 * (3 + 2 + codes) + 1;
    return c;
}

const ArrayCostStep& ArrayCost::longest() const {
    return *std::max_element(step.begin(), step.begin() + steps, [this](auto& a, auto& b) {
        return cycles(a) < cycles(b);
    });
}

std::uint64_t ArrayCost::cycles() const {
    std::uint64_t sum = 0;
    for (const ArrayCostStep& s : list()) sum += cycles(s);
    return sum;
}

std::uint64_t ArrayCost::calls() const {
    std::uint64_t sum = 0;
    for (const ArrayCostStep& s : list()) sum += lines * static_cast<std::uint64_t>(s.calls);
    return sum;
}

}  // namespace umbra78::shadow
