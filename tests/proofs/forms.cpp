// The fast forms equal their definitions at widths small enough to try everything: the post-process
// by rows against pixel by pixel, a block's centres in lanes against triangle by triangle, and the
// reciprocal root of the shading for every one of its 2^29 arguments.
#include "fixed/rounding.hpp"
#include "raster/block_form.hpp"
#include "shadow/post_process.hpp"
#include "shadow/result_form.hpp"
#include "shadow/row_form.hpp"
#include "tests/proofs/proofs.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <tuple>
#include <vector>

namespace umbra78::raster::proof_lanes {  // the text itself, to look into it
#define UMBRA78_LANES_TEXT
#include "raster/block_body.hpp"
#undef UMBRA78_LANES_TEXT
[[maybe_unused]] constexpr BlockForm whole{
    "", nullptr, expand_form, centres_form, leaves_form, shade_form, measure_normals_form,
    shade_normals_form,
    {see_form, measure_form, few_form, tile_form, put_form, shade_facets_form}};
}  // namespace umbra78::raster::proof_lanes

namespace umbra78::shadow::proof_lanes {
#define UMBRA78_LANES_TEXT
#include "shadow/result_body.hpp"
#undef UMBRA78_LANES_TEXT
[[maybe_unused]] constexpr ResultForm whole{"", nullptr, results_form};
}  // namespace umbra78::shadow::proof_lanes

namespace umbra78::proofs {
namespace {

constexpr int size = 16;
using Plane = std::array<hw::Depth16, size * size>;
using Mask = std::array<std::uint8_t, size * size>;

// Rows X and Z of every pair of 8-bit coefficients, each over a whole frame of 16 x 16 pixels in
// which every column meets every code.
bool rows_hold() {
    Verdict v("rows of 16 pixels, 8-bit coefficients");
    Plane observer{}, light{};
    for (int k = 0; k < size * size; ++k) {
        observer[std::size_t(k)] = static_cast<hw::Depth16>((k + k / 16) % 16);
        light[std::size_t(k)] = static_cast<hw::Depth16>((7 * k + k / 16 + k * k / 5) % 16);
    }
    const shadow::DepthMaps<hw::Depth16> maps{.observer = {4, observer}, .light = {4, light}};
    const auto memory = std::make_unique<shadow::RowMemory>();
    std::uint64_t covered = 0;
    for (int setting = 0; setting < 16; ++setting) {
        shadow::ShadowTest test;
        test.machine.xy_bits = test.machine.z_bits = 4;
        test.machine.coefficient_bits = 8;
        test.machine.fraction_bits = 1;
        if ((setting & 1) != 0) test.lookup = shadow::Lookup::bilinear;
        if ((setting & 8) != 0)
            test.lookup = (setting & 1) != 0 ? shadow::Lookup::filtered_depth
                                             : shadow::Lookup::percentage;
        if ((setting & 2) != 0) test.machine.transform_rounding = fixed::Rounding::floor;
        if ((setting & 4) != 0) test.dither = {hw::DitherShape::uniform, 512, 1978};
        const int step = setting == 0 ? 1 : 7;
        for (int a = -128; a < 128; ++a)
            for (int b = -128; b < 128; b += step) {
                hw::MatrixWords m;
                m.word = {{{64, 9, 0, 0}, {-5, 64, 0, 3}, {7, 0, 64, 0}, {0, 0, 0, 64}}};
                m.word[(a + b) % 2 == 0 ? 2 : 0] = {b % 3, 3, a, b};
                if (!shadow::rows_cover(test, m)) continue;
                ++covered;
                Mask plain{}, fast{};
                shadow::post_process(maps, m, test, plain);
                hw::MatrixWords other = m;
                if (planted) ++other.word[2][3];
                for (const shadow::RowForm& form : shadow::row_forms()) {
                    if (!form.supported()) continue;
                    shadow::post_process_rows(maps, other, test, *memory, fast, form);
                    for (std::size_t k = 0; k < plain.size(); ++k)
                        if (!v.equal(fast[k], plain[k], Given{setting, a, b, Wide(k)})) break;
                }
            }
    }
    std::printf("rows: %llu matrices\n", static_cast<unsigned long long>(covered));
    return v.tell();
}

// The reciprocal by which quotients are found, of every word of 32 bits with its highest bit set:
// within 15 of 2^62 / n, so that 2^31 times its error is less than 2^35.
bool reciprocals_hold() {
    Verdict v("reciprocals of 31 bits, every argument");
    std::uint64_t wrong = 0, at = 0;
    for (std::uint64_t n = std::uint64_t{1} << 31; n < std::uint64_t{1} << 32; ++n) {
        const auto y = static_cast<std::uint64_t>(
            shadow::proof_lanes::reciprocal_of(static_cast<std::uint32_t>(n)));
        const auto off = static_cast<std::int64_t>(y * n - (std::uint64_t{1} << 62));
        if (static_cast<std::uint64_t>(off < 0 ? -off : off) <= (planted ? 7 : 15) * n) continue;
        ++wrong;
        at = n;
    }
    v.equal(Wide{wrong}, 0, Given{Wide{at}});
    return v.tell();
}

// --- a block's centres ---------------------------------------------------------------------------

using Key = std::tuple<int, int, std::int64_t, int, bool>;

// Leaves whose four corners lie on a 5 x 5 lattice within a pixel: all 25^4 of them, 64 a block,
// and what lies between them. Two lattices: a centre on one of its points, and between them.
class LatticeBlocks {
public:
    explicit LatticeBlocks(std::int32_t offset) : offset_(offset) {}

    bool next(raster::Corners& g) {
        if (at_ >= 25 * 25 * 25 * 25) return false;
        for (std::size_t v = 0; v < 16; v += 2)
            for (std::size_t u = 0; u < 16; u += 2) {
                std::uint32_t k = at_++;
                for (const auto& [dv, du] : {std::pair<std::size_t, std::size_t>{0, 0}, {0, 1},
                                             {1, 0}, {1, 1}}) {
                    put(g, v + dv, u + du, k % 25);
                    k /= 25;
                }
            }
        for (std::size_t k = 0; k < raster::corners; ++k) {  // the last row and column
            put(g, 16, k, static_cast<std::uint32_t>((at_ + k) % 25));
            put(g, k, 16, static_cast<std::uint32_t>((at_ / 7 + k) % 25));
        }
        return true;
    }

private:
    void put(raster::Corners& g, std::size_t v, std::size_t u, std::uint32_t place) {
        g[0][v][u] = offset_ + static_cast<std::int32_t>(place % 5) * 1900;
        g[1][v][u] = offset_ + static_cast<std::int32_t>(place / 5) * 1900;
        g[2][v][u] = static_cast<std::int32_t>((place * 37 + 11 * (u + v) + at_ / 64) % 101) - 50;
    }
    std::int32_t offset_;
    std::uint32_t at_ = 0;
};

bool centres_hold() {
    Verdict v("centres in lanes, leaves on a 5 x 5 lattice");
    hw::MachineSpec spec;
    spec.xy_bits = 4;
    const auto list = std::make_unique<raster::BlockSamples>();
    std::uint64_t samples = 0, stepped_back = 0;
    for (const std::int32_t offset : {4096 - 2 * 1900, 4096 - 1900 - 700}) {
        LatticeBlocks blocks(offset);
        raster::Corners g{};
        while (blocks.next(g)) {
            std::vector<Key> plain, fast;
            raster::sample_centres(g, spec, [&](const raster::Sample& s) {
                plain.emplace_back(s.leaf_j, s.leaf_i, s.z, s.x + s.y, s.second);
            });
            samples += plain.size();
            std::sort(plain.begin(), plain.end());
            if (planted) ++g[2][4][4];
            for (const raster::BlockForm& form : raster::block_forms()) {
                if (!form.supported()) continue;
                if (!form.centres(g, spec.half_px(), *list)) {
                    ++stepped_back;
                    continue;
                }
                fast.clear();
                for (std::size_t k = 0; k < list->count; ++k) {
                    const raster::BlockSample& s = list->sample[k];
                    fast.emplace_back(s.leaf / 16, s.leaf % 16, s.z, s.x + s.y, s.second);
                }
                std::sort(fast.begin(), fast.end());
                v.equal(fast == plain, true, Given{offset});
            }
        }
    }
    std::printf("centres: %llu samples, %llu blocks left to the definition\n",
                static_cast<unsigned long long>(samples),
                static_cast<unsigned long long>(stepped_back));
    return v.tell() && samples > 0;
}

// --- the reciprocal root -------------------------------------------------------------------------

// As find_normals of shade_body.hpp has it, before its two comparisons.
struct Root {
    std::uint64_t reciprocal, root;
};
Root root_of(std::uint64_t s) {
    using raster::proof_lanes::times;
    std::uint64_t y = 1919850381 - (times(s, 869730877) >> 30);
    for (int step = 0; step < 3; ++step) {
        const std::uint64_t syy = times(s, times(y, y) >> 30) >> 30;
        y = times(y, (std::uint64_t{3} << 30) - syy) >> 31;
    }
    return {y, times(s, y) >> 36};
}

// For every s = |n|^2 / 2^18 of normals within 60 degrees the root is within one of the floor of
// every |n| that has this s, so that two comparisons find it.
bool roots_hold() {
    Verdict v("reciprocal roots, every argument");
    const std::uint64_t first = std::uint64_t{1} << 29, last = (std::uint64_t{1} << 30) + (1 << 17);
    std::uint64_t wrong = 0, at = 0;
    for (std::uint64_t s = first; s < last; ++s) {
        const std::uint64_t r = root_of(s).root - (planted ? 2 : 0);
        const std::uint64_t least = s << 18, greatest = least + (1 << 18) - 1;
        if ((r - 1) * (r - 1) > least || (r + 2) * (r + 2) <= greatest) {
            ++wrong;
            at = s;
        }
    }
    v.equal(Wide{wrong}, 0, Given{Wide{at}});
    return v.tell();
}

// root_of is what find_normals computes.
bool root_is_the_codes() {
    Verdict v("root_of and shade_body.hpp");
    Words words;
    for (int k = 0; k < 20'000; ++k) {
        raster::ShadeJob job{};
        const std::int64_t toward[] = {words.word(31), words.word(31), words.word(31)};
        for (auto& corner : job.normal) {
            const auto near = [&](int i) { return toward[i] + words.number(-1 << 28, 1 << 28); };
            const raster::UnitVector n = raster::unit_vector({near(0), near(1), near(2)});
            for (std::size_t i = 0; i < 3; ++i) corner[i] = n[i];
        }
        std::uint8_t leaf[16];
        for (std::uint8_t& l : leaf) l = static_cast<std::uint8_t>(words.number(0, 255));
        raster::proof_lanes::LeafNormals found;
        raster::proof_lanes::find_normals(job, leaf, found);
        raster::proof_lanes::find_lengths(found);
        for (std::size_t i = 0; i < 16; ++i) {
            std::uint64_t square = 0;
            for (const auto& axis : found.n)
                square += static_cast<std::uint64_t>(std::int64_t{axis[i]} * axis[i]);
            const Root r = root_of(square >> 18);
            v.equal(Wide{found.reciprocal[i]}, Wide{r.reciprocal}, Given{Wide{square}});
            if (square >> 18 < std::uint64_t{1} << 29) continue;  // of 60 degrees and more
            const Wide l = Wide{found.length[i]};
            v.equal(l * l <= Wide{square} && (l + 1) * (l + 1) > Wide{square}, true,
                    Given{Wide{square}});
        }
    }
    return v.tell();
}

}  // namespace

bool forms() {
    bool all = rows_hold();
    all = reciprocals_hold() && all;
    all = centres_hold() && all;
    all = root_is_the_codes() && all;
    return roots_hold() && all;
}

}  // namespace umbra78::proofs
