// Worst errors of the lookup and the filters, by the production code.
#include "shadow/filters/composite.hpp"
#include "shadow/filters/low_pass.hpp"
#include "shadow/filters/ramp.hpp"
#include "shadow/light_place.hpp"
#include "shadow/window.hpp"
#include "tests/proofs/search.hpp"

#include <cmath>

namespace umbra78::proofs {
namespace {

void low_passes(Words& words) {
    Worst worst("low_pass");
    constexpr int size = 16;
    std::array<hw::Depth16, size * size> depth{};
    std::array<std::uint8_t, size * size> mask{}, out{};
    const hw::ReadOnlyStore<hw::Depth16> store{4, depth};
    for (int k = 0; k < 300; ++k) {
        for (std::uint8_t& m : mask) m = static_cast<std::uint8_t>(words.number(0, 255));
        shadow::low_pass<hw::Depth16>(mask, store, 65535, out);
        for (int y = 1; y < size - 1; ++y)
            for (int x = 1; x < size - 1; ++x) {
                Given in;
                int sum = 0;
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx) {
                        const int m = mask[std::size_t(size * (y + dy) + x + dx)];
                        sum += shadow::low_pass_weight(dx, dy) * m;
                        in.push_back(m);
                    }
                worst.add(ratio(out[std::size_t(size * y + x)] * 16 - sum, 16), in);
            }
    }
}

void composites() {
    Worst worst("composite");
    for (int share = 0; share < 256; share += 3)
        for (int mask = 0; mask < 256; ++mask)
            for (int density = 0; density <= 256; ++density) {
                const int out = shadow::composite(255, static_cast<std::uint8_t>(share),
                                                  static_cast<std::uint8_t>(mask), density);
                worst.add(ratio(out * 65280 - (255 * 65280 - share * mask * density), 65280),
                          {255, share, mask, density});
            }
}

void ramps() {
    for (int width = 2; width <= shadow::max_ramp_px; ++width) {
        Worst worst("ramp_" + std::to_string(width));
        for (int squares = 0; squares < width * width; ++squares) {
            const long double exact =
                255 * (1 - std::sqrt(static_cast<long double>(squares)) / width);
            worst.add(static_cast<double>(shadow::ramp_darkness(squares, width) - exact),
                      {squares});
        }
    }
}

void lookups(Words& words) {
    Worst share("percentage"), blend("bilinear");
    for (int side = 2; side <= 5; ++side)
        for (int count = 0; count <= side * side; ++count)
            share.add(ratio(shadow::share_of_dark(count, {side, false}) * side * side -
                                255 * count, side * side), {count, side});
    const hw::MachineSpec spec;
    for (int k = 0; k < 100'000; ++k) {
        const auto code = [&] { return static_cast<std::uint32_t>(words.number(0, 65535)); };
        const shadow::FourCodes z{code(), code(), code(), code()};
        const int fx = words.number(0, 127), fy = words.number(0, 127);
        const Wide exact = Wide{128 - fy} * ((128 - fx) * Wide{z[0]} + fx * Wide{z[1]}) +
                           Wide{fy} * ((128 - fx) * Wide{z[2]} + fx * Wide{z[3]});
        blend.add(ratio(shadow::blend_of(spec, fx, fy, z).z - exact, 1),
                  {fx, fy, z[0], z[1], z[2], z[3]});
    }
}

}  // namespace

void filter_errors() {
    Words words;
    low_passes(words);
    composites();
    ramps();
    lookups(words);
}

}  // namespace umbra78::proofs
