// A line's results in wide lanes against the transform unit, result by result: a mask shows few of
// the quotients that are off by one.
#include "shadow/result_form.hpp"

#include "hw/transform_unit.hpp"
#include "shadow/row_form.hpp"
#include "tests/shadow/random_frames.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <memory>
#include <string>
#include <vector>

namespace umbra78::shadow::result_lanes_text {  // the text itself, to look into it
#define UMBRA78_LANES_TEXT
#include "shadow/result_body.hpp"
#undef UMBRA78_LANES_TEXT
[[maybe_unused]] constexpr ResultForm whole{"", nullptr, results_form};
}  // namespace umbra78::shadow::result_lanes_text

namespace umbra78::shadow {
namespace {

using test::Random;

// --- quotients beside a rounding's boundary ------------------------------------------------------

// A sum whose quotient lies at a boundary between two results, or near it.
std::int64_t sum_at_boundary(Random& random, const ResultRow& row, bool half_up,
                             std::int64_t sum_w) {
    const std::int64_t q = random.between(-(1 << 16), 1 << 16);
    const __int128 twice = __int128{2 * q + (half_up ? 1 : 0)} * sum_w;
    const __int128 sum = row.shift < 0 ? twice << (-row.shift - 1) : twice / 2 / (1ll << row.shift);
    if (sum >= 1ll << 59 || sum <= -(1ll << 59)) return 0;
    return static_cast<std::int64_t>(sum) +
           random.between(-2, 2) * (std::int64_t{1} << random.between(0, 40));
}

// What the lanes are sure of is the quotient; and they are sure of nearly all that lie elsewhere.
TEST(ResultForms, AreSureOfExactQuotientsOnly) {
    using namespace result_lanes_text;
    Random random;
    std::uint64_t sure = 0, unsure_ones = 0, small = 0;
    for (int round = 0; round < 60'000 && !::testing::Test::HasFailure(); ++round) {
        ResultLine line{};
        line.half_up = random.bits() % 2 == 0;
        const int w_bits = static_cast<int>(random.between(16, 48));
        line.cut_w = std::max(0, w_bits - 31);
        ResultRow& row = line.row[0];
        row.bits = static_cast<int>(random.between(15, 19));
        row.shift = static_cast<int>(random.between(-10, 20));
        Lane64 sum, sum_w;
        std::int64_t bound = 1;
        for (int k = 0; k < result_lanes; ++k) {
            const auto less = static_cast<int>(random.between(0, std::min(w_bits - 2, 14)));
            sum_w[k] = random.between(1, (std::int64_t{1} << (w_bits - less)) - 1);
            sum[k] = sum_at_boundary(random, row, line.half_up, sum_w[k]);
            bound = std::max(bound, sum[k] < 0 ? -sum[k] : sum[k]);
        }
        const auto bits = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(bound)));
        row.cut = std::max(0, bits - 31);
        std::int32_t y[result_lanes], up[result_lanes], out[result_lanes];
        Lane32 unsure;
        find_reciprocals(line, sum_w, y, up);
        divide_sums(line, row, sum, y, up, out, unsure);
        for (int k = 0; k < result_lanes; ++k) {
            small += up[k] >= coarse;
            unsure_ones += unsure[k] != 0;
            sure += unsure[k] == 0;
            if (unsure[k] != 0) continue;
            EXPECT_EQ(out[k], quotient_of(line, row, sum[k], sum_w[k]))
                << sum[k] << " 2^" << row.shift << " / " << sum_w[k];
        }
    }
    EXPECT_GT(sure, 100'000u);
    EXPECT_GT(unsure_ones, 100'000u);
    EXPECT_GT(small, 1'000u);
}

// --- whole lines ---------------------------------------------------------------------------------

// Far outside of the light's volume.
bool is_far(std::int64_t result) {
    constexpr std::int64_t far = std::int64_t{1} << 27;
    return result >= far || result < -far;
}

// X, Y and Z of a column. A result that lies far outside may be any such number, and one that lies
// there stands for a point that is none.
bool are_results(const RowMemory& memory, std::size_t x, const hw::Point& p) {
    const std::int64_t expected[] = {p.x, p.y, p.z};
    bool equal = true, far = false;
    for (std::size_t r = 0; r < 3; ++r) {
        const std::int32_t got = memory.column_high[r][x];
        far = far || is_far(got);
        equal = equal && (is_far(expected[r]) ? is_far(got) : got == expected[r]);
    }
    return p.status == hw::DivideStatus::ok ? equal : far;
}

// Of one line of a frame by every form that this processor has; returns how many were asked.
std::uint64_t expect_results(const Settings& s, const hw::MatrixWords& matrix, int y,
                             const std::vector<hw::Depth16>& depth, const std::string& where) {
    static const auto memory = std::make_unique<RowMemory>();
    const hw::TransformUnit unit(s.machine, matrix);
    std::uint64_t count = 0;
    for (const ResultForm& form : result_forms()) {
        if (!form.supported()) continue;
        ResultLine line;
        first_result_line(s, matrix, 0, s.machine.size_px(), line, *memory);
        next_result_line(line, y);
        form.run(line, depth.data(), *memory);
        for (std::size_t x = 0; x < depth.size(); ++x) {
            if (depth[x] == s.machine.background()) continue;
            const hw::Point p = unit(pixel_words(static_cast<int>(x), y, depth[x], s));
            count += p.status == hw::DivideStatus::ok ? 1 : 0;
            if (are_results(*memory, x, p)) continue;
            ADD_FAILURE() << form.name << ", column " << x << ": " << memory->column_high[0][x]
                          << ", and not " << p.x << "; " << where << test::describe(s);
            return count;
        }
    }
    return count;
}

// Rows that are nearly a multiple of the W row: quotients of small sums by small ones.
void follow_w_row(Random& random, const hw::MachineSpec& spec, hw::MatrixWords& m) {
    const std::int64_t max = (std::int64_t{1} << (spec.coefficient_bits - 1)) - 1;
    for (std::int32_t& w : m.word[3]) w = static_cast<std::int32_t>(random.between(-max, max));
    for (std::size_t r = 0; r < 3; ++r) {
        m.exponent[r] = m.exponent[3];
        for (std::size_t c = 0; c < 4; ++c)
            m.word[r][c] = m.word[3][c] / 2 + static_cast<std::int32_t>(random.between(-2, 2));
    }
}

TEST(ResultForms, AreTheTransformUnits) {
    Random random;
    std::uint64_t count = 0;
    for (int round = 0; round < 600 && !::testing::Test::HasFailure(); ++round) {
        Settings s = test::random_settings(random, true);
        s.machine.xy_bits = 9;
        s.machine.z_bits = 16;
        s.machine.coefficient_bits = test::pick(random, {16, 16, 24, 28});
        std::vector<hw::Depth16> depth(512);
        for (hw::Depth16& z : depth) z = static_cast<hw::Depth16>(random.bits());
        hw::MatrixWords m = test::random_matrix(random, s.machine, round % 8 == 0);
        if (round % 8 != 0) test::make_w_row(random, s.machine, m);
        if (round % 8 > 4) follow_w_row(random, s.machine, m);
        if (!result_lines_cover(s, m)) continue;
        count += expect_results(s, m, static_cast<int>(random.between(0, 511)), depth,
                                "round " + std::to_string(round) + " ");
    }
    EXPECT_GT(count, 300000u) << "too few results for a test";
}

}  // namespace
}  // namespace umbra78::shadow
