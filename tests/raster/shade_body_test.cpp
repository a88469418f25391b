// The shading's lanes from within: the length of a leaf's normal and its cosines are the exact
// floors, for normals of every length that corners within 60 degrees of each other can give.
#include "raster/block_form.hpp"

#include "tests/fixed/boundary.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace umbra78::raster::inner_lanes {
#define UMBRA78_LANES_TEXT
#include "raster/block_body.hpp"
#undef UMBRA78_LANES_TEXT
[[maybe_unused]] constexpr BlockForm whole{
    "", nullptr, expand_form, centres_form, leaves_form, shade_form, measure_normals_form,
    shade_normals_form,
    {see_form, measure_form, few_form, tile_form, put_form, shade_facets_form}};
}  // namespace umbra78::raster::inner_lanes

namespace umbra78::raster {
namespace {

using fixed::test::Random;
using umbra78::test::effort;

TEST(ShadeBody, LengthsAndCosinesAreTheExactFloors) {
    Random random;
    const auto direction = [&] {
        const auto any = [&] { return random.between(-(1 << 20), 1 << 20); };
        return unit_vector({any(), any(), any()});
    };
    int seen = 0;
    for (int n = 0; n < effort(4000); ++n) {
        ShadeJob job{};
        const UnitVector middle = direction(), d = direction();
        for (auto& corner : job.normal) {
            const UnitVector off = direction();
            const UnitVector at = unit_vector({2 * middle[0] + off[0], 2 * middle[1] + off[1],
                                               2 * middle[2] + off[2]});
            std::copy(at.begin(), at.end(), corner);
        }
        std::uint8_t leaf[16];
        for (std::uint8_t& l : leaf) l = static_cast<std::uint8_t>(random.between(0, 255));
        inner_lanes::LeafNormals normals;
        inner_lanes::Lanes cosines;
        inner_lanes::find_normals(job, leaf, normals);
        inner_lanes::find_lengths(normals);
        inner_lanes::find_cosines(normals, d.data(), cosines);
        for (std::size_t i = 0; i < 16; ++i) {
            const WideVector m{normals.n[0][i], normals.n[1][i], normals.n[2][i]};
            const auto square = static_cast<std::uint64_t>(dot(m, m));
            const std::uint64_t length = normals.length[i];
            if (square >> 47 == 0) continue;  // of corners 60 degrees apart and more
            ++seen;
            ASSERT_LE(length * length, square);
            ASSERT_GT((length + 1) * (length + 1), square);
            ASSERT_EQ(cosines[i],
                      fixed::round_divide(dot(m, wide(d)), static_cast<std::int64_t>(length),
                                          fixed::Rounding::floor));
        }
    }
    EXPECT_GT(seen, effort(4000) * 8);
}

}  // namespace
}  // namespace umbra78::raster
