// Stored depths to codes: bits that are kept, exact rounding, and what is refused.
#include "tools/captured/capture.hpp"
#include "tools/captured/matrix_text.hpp"
#include "tools/scene/scene_error.hpp"

#include "fixed/rational.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace umbra78::tools::captured {
namespace {

NumberImage image_of(NumberKind kind, std::vector<double> values, std::uint32_t max = 0) {
    return {"a.npy", static_cast<int>(values.size()), 1, kind, max, std::move(values)};
}

hw::MachineSpec spec_of(int z_bits) {
    hw::MachineSpec spec;
    spec.xy_bits = 10;
    spec.z_bits = z_bits;
    return spec;
}

std::vector<hw::Depth32> first_codes(const NumberImage& image, const char* format, int z_bits) {
    Codes codes = codes_of(image, *find_depth_format(format), true, spec_of(z_bits));
    codes.depth.resize(image.values.size());
    return codes.depth;
}

TEST(CapturedCodes, IntegersOfTheSameBitsAreKept) {
    std::vector<double> all;
    for (int code = 0; code < 1000; ++code) all.push_back(65535 - 60 * code);
    const auto image = image_of(NumberKind::u16, all, 65535);
    const auto kept = first_codes(image, "d16", 16), own = first_codes(image, "codes", 16),
               turned = first_codes(image, "d16_reversed", 16);
    for (std::size_t at = 0; at < all.size(); ++at) {
        EXPECT_EQ(kept[at], all[at]);
        EXPECT_EQ(own[at], all[at]);
        EXPECT_EQ(turned[at], std::min(65535 - all[at], at == 0 ? 65535.0 : 65534.0));
    }
}

// Against exact fractions, for every kind, at several widths.
TEST(CapturedCodes, AreRoundedExactly) {
    std::mt19937_64 random(78);
    std::vector<double> reals{0, 1e-300, 1e-40, 0.5, 1 - 1e-9, 0.999999999999};
    while (reals.size() < 1000)
        reals.push_back(std::ldexp(static_cast<double>(random() >> 11), -53) *
                        std::ldexp(1, -static_cast<int>(random() % 30)));
    for (const int z_bits : {4, 16, 24})
        for (const char* name : {"d16", "d16_reversed", "d24", "d32f", "d32f_reversed"}) {
            const bool reversed = std::string(name).ends_with("reversed");
            const auto codes = first_codes(image_of(NumberKind::f64, reals), name, z_bits);
            const std::int64_t whole = std::int64_t{1} << z_bits;
            const std::int64_t far = whole - (std::string(name).starts_with("d32f") ? 0 : 1);
            for (std::size_t at = 0; at < reals.size(); ++at) {
                if (reals[at] < 1e-20) continue;  // beyond what the fractions here hold
                const auto word = static_cast<std::int64_t>(std::ldexp(reals[at], 62));
                if (std::ldexp(static_cast<double>(word), -62) != reals[at]) continue;
                fixed::Rational depth(word, std::int64_t{1} << 62);
                if (reversed) depth = fixed::Rational(1) - depth;
                std::int64_t code = 0;
                ASSERT_TRUE((depth * far).round_scaled(0, fixed::Rounding::half_up, code));
                EXPECT_EQ(codes[at], std::min(code, whole - 2)) << name << " " << reals[at];
            }
        }
    // What is not 0 is not the far plane of a reversed float, however small.
    EXPECT_EQ(first_codes(image_of(NumberKind::f64, reals), "d32f_reversed", 24)[0], 0xffffffu);
    EXPECT_EQ(first_codes(image_of(NumberKind::f64, reals), "d32f_reversed", 24)[1], 0xfffffeu);
}

// Floats of 24 bits stay what they are in a machine that stores floats, from 1/4 on.
TEST(CapturedCodes, FloatsAreKeptByAStoreOfFloats) {
    std::mt19937 random(78);
    std::vector<double> reals;
    while (reals.size() < 1000)
        reals.push_back(std::ldexp(static_cast<double>(0x800000 + random() % 0x800000),
                                   -24 - static_cast<int>(random() % 2)));
    hw::MachineSpec spec = spec_of(26);
    for (const bool reversed : {false, true}) {
        spec.depth_store = reversed ? hw::DepthStore::of_reversed_floats
                                    : hw::DepthStore::of_floats;
        const Codes codes =
            codes_of(image_of(NumberKind::f32, reals),
                     *find_depth_format(reversed ? "d32f_reversed" : "d32f"), true, spec);
        EXPECT_EQ(codes.largest_rounding, 0);
        for (std::size_t at = 0; at < reals.size(); ++at) {
            const double depth = std::ldexp(static_cast<double>(codes.depth[at]), -26);
            EXPECT_EQ(reversed ? 1 - depth : depth, reals[at]);
        }
    }
}

TEST(CapturedCodes, RefuseWhatIsNoDepth) {
    const struct {
        NumberImage image;
        const char *format, *message;
    } cases[] = {
        {image_of(NumberKind::f32, {0.5, 1.25}), "d32f",
         "a.npy: x 1, y 0 is 1.25, and a depth of d32f is 0 .. 1; give the depth as it is stored, "
         "0 .. 1, not a distance"},
        {image_of(NumberKind::f32, {0.5, 0.5, std::nan("")}), "d16",
         "a.npy: x 2, y 0 is nan, and a depth of d16 is 0 .. 1; give the depth as it is stored, "
         "0 .. 1, not a distance"},
        {image_of(NumberKind::u32, {16777216}, 0xffffffff), "d24",
         "a.npy: x 0, y 0 is 16777216, and a depth of d24 is 0 .. 16777215; mask out a stencil's "
         "bits, or give another --depth-format"},
        {image_of(NumberKind::u16, {5}, 65535), "d24",
         "a.npy: its numbers reach 65535 at most, and those of d24 16777215; give a file of more "
         "bits, or another --depth-format"},
        {image_of(NumberKind::u16, {5}, 65535), "d32f",
         "a.npy: it holds whole numbers (u16), and d32f stores floats; give d16 or d24, or the "
         "file as float32"},
        {image_of(NumberKind::f32, {0.5}), "codes",
         "a.npy: it holds floats, and codes are whole numbers; give another --depth-format"},
    };
    for (const auto& [image, format, message] : cases) {
        try {
            codes_of(image, *find_depth_format(format), true, spec_of(24));
            FAIL() << message;
        } catch (const SceneError& error) {
            EXPECT_STREQ(error.what(), message);
        }
    }
}

TEST(CapturedMatrices, SayWhatIsWrong) {
    Matrix16 unit{};
    for (std::size_t k = 0; k < 4; ++k) unit[5 * k] = 1;
    const Convention d3d = *find_convention("d3d");
    const auto with = [&](std::size_t at, double value) {
        Matrix16 m = unit;
        m[at] = value;
        return wrong_with(m, d3d);
    };
    EXPECT_EQ(wrong_with(unit, d3d), "");
    EXPECT_EQ(with(15, 0), "its row of w is 0, so that nothing can be divided by it; give "
                           "--vectors row if it is meant for such vectors");
    EXPECT_EQ(with(5, 0), "it is singular: it takes the whole picture to one plane, or less; give "
                          "the light's view-projection times the inverse of the observer's");
    EXPECT_EQ(with(3, std::nan("")), "its number 4 of 16 is nan; give finite numbers");
    EXPECT_EQ(with(0, 1e13), "its number 1 of 16, 1e+13, is 2^40 or more; divide all 16 by one "
                             "number, which changes no place");
    EXPECT_EQ(wrong_with(Matrix16{}, d3d).substr(0, 29), "all of its 16 numbers are 0; ");
    // Numbers of the whole range, small ones with all their bits, become words without a trap.
    std::mt19937_64 random(78);
    for (int k = 0; k < 200; ++k) {
        Matrix16 m;
        for (double& value : m)
            value = std::ldexp(static_cast<double>(random() >> 11) - 0x1p52,
                               static_cast<int>(random() % 200) - 213);
        hw::MatrixWords words;
        hw::load_matrix(screen_to_screen(m, d3d, *find_depth_format("d24"), {1279, 719},
                                         {1531, 2047}, spec_of(24), 123457),
                        spec_of(24), hw::screen_words(spec_of(24)), words);
    }
}

TEST(CapturedMatrices, AreReadFromTexts) {
    const Matrix16 m = read_matrix("1, 0 0 0; [0 1 0 +2.5e-1] 0 0 1 0 # a remark\n 0,0,0,-1");
    EXPECT_EQ(m[7], 0.25);
    EXPECT_EQ(m[15], -1);
    const std::pair<const char*, const char*> wrong[] = {
        {"1,2,x", "--matrix:1: 'x' is no number; give 16 numbers, row by row, on the line, in a "
                  "text file or in an NPY"},
        {"1,2,3", "--matrix: 3 numbers, and a matrix has 16; give 16 numbers, row by row, on the "
                  "line, in a text file or in an NPY"},
    };
    for (const auto& [text, message] : wrong) {
        try {
            read_matrix(text);
            FAIL() << message;
        } catch (const SceneError& error) {
            EXPECT_STREQ(error.what(), message);
        }
    }
}

}  // namespace
}  // namespace umbra78::tools::captured
