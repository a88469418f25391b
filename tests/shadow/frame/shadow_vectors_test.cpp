// Vectors of the shadow test and the filters: input words, noise, comparison, dequantize, low-pass,
// composite.
#include "hw/noise_source.hpp"
#include "shadow/compare.hpp"
#include "shadow/filters/composite.hpp"
#include "shadow/filters/dequantize.hpp"
#include "shadow/filters/low_pass.hpp"
#include "shadow/post_process.hpp"
#include "tests/shadow/frame/vectors.hpp"

namespace umbra78::test {
namespace {

constexpr std::array<const char*, 5> shapes{"none", "uniform", "triangular", "normal4", "normal"};

TEST(Vectors, Noise) {
    Inputs in(10);
    Lines lines;
    for (int k = 0; k < 48; ++k) {
        hw::MachineSpec s;
        s.xy_bits = static_cast<int>(in.between(4, 8));
        s.fraction_bits = static_cast<int>(in.between(0, 12));
        const hw::Dither d{static_cast<hw::DitherShape>(in.between(1, 4)),
                           static_cast<std::int32_t>(in.between(1, 1024)),
                           static_cast<std::uint32_t>(in.between(1, 0x7fffffff))};
        const int last = k % 8 == 0 ? 0 : s.size_px() - 1;
        const int x = static_cast<int>(in.between(0, last));
        const int y = static_cast<int>(in.between(0, last));
        const hw::DitherWords w = hw::NoiseSource(d, s, x, y).next();
        lines.push_back((Line() << s.xy_bits << s.fraction_bits
                                << shapes[static_cast<std::size_t>(d.shape)] << d.size_q8 << d.seed
                                << x << y << "->" << w.x << w.y).text());
    }
    check_vectors("noise",
                  {"Section 10: xy_bits fraction_bits dither dither_size (Q.8) dither_seed px py",
                   "-> the X and the Y word"},
                  lines);
}

// A map with no two texels alike, and background here and there.
std::uint32_t map_code(int a, int b, const hw::MachineSpec& s) {
    const std::int64_t code = (a * 7919 + b * 104729 + a * b * 613) % (std::int64_t{1} << s.z_bits);
    return (a + 2 * b) % 11 == 0 ? s.background() : static_cast<std::uint32_t>(code);
}

TEST(Vectors, ShadowTest) {
    Inputs in(11);
    Lines lines;
    constexpr std::array<const char*, 2> lookups{"nearest", "bilinear"};
    constexpr std::array<const char*, 2> backgrounds{"blend", "fall_back"};
    constexpr std::array<const char*, 2> registrations{"centre", "index"};
    for (int k = 0; k < 32; ++k) {
        shadow::ShadowTest t;
        t.machine.xy_bits = static_cast<int>(in.between(4, 12));
        t.machine.z_bits = static_cast<int>(in.between(4, 24));
        t.registration = static_cast<shadow::Registration>(k % 2);
        const int size = t.machine.size_px();
        const int px = static_cast<int>(in.between(0, size - 1));
        const int py = static_cast<int>(in.between(0, size - 1));
        const auto code = static_cast<std::uint32_t>(in.between(0, t.machine.deepest_drawn()));
        const hw::Words w = shadow::pixel_words(px, py, code, t);
        lines.push_back((Line() << "words" << t.machine.xy_bits << t.machine.z_bits
                                << registrations[static_cast<std::size_t>(k % 2)] << px << py
                                << code << "->" << w.x << w.y << w.z).text());
    }
    for (int k = 0; k < 96; ++k) {
        shadow::ShadowTest t;
        t.machine.xy_bits = 4;
        t.machine.z_bits = static_cast<int>(in.between(4, 24));
        t.machine.fraction_bits = static_cast<int>(in.between(0, 12));
        t.lookup = static_cast<shadow::Lookup>(in.between(0, 1));
        t.background = static_cast<shadow::Background>(in.between(0, 1));
        std::vector<hw::Depth32> map(256);
        for (int b = 0; b < 16; ++b)
            for (int a = 0; a < 16; ++a)
                map[static_cast<std::size_t>(16 * b + a)] = map_code(a, b, t.machine);
        const hw::FrameStore<const hw::Depth32> store{4, map, {}};
        const std::int64_t edge = std::int64_t{8} << t.machine.fraction_bits;
        const auto place = [&] {
            return k % 6 == 0 ? (in.between(0, 1) == 0 ? -edge : edge) + in.between(-2, 1)
                              : in.between(-edge, edge - 1);
        };
        hw::Point p{place(), place(), 0, hw::DivideStatus::ok};
        hw::DitherWords d{static_cast<std::int32_t>(in.between(-2, 2)),
                          static_cast<std::int32_t>(in.between(-2, 2))};
        if (k % 12 == 0) {  // just outside in one direction, deeper than all, no dither
            t.lookup = shadow::Lookup::bilinear;
            t.background = shadow::Background::blend;
            p.x = k % 24 == 0 ? -edge - 1 : edge;
            p.y = in.between(-edge, edge - 1);
            if (k % 48 == 0) std::swap(p.x, p.y);
            d = {0, 0};
        }
        // A code about that of the texel below, or about an end of its range.
        const auto at = [&](std::int64_t v) {
            return static_cast<int>(std::clamp<std::int64_t>((v + edge) >> t.machine.fraction_bits,
                                                             0, 15));
        };
        const std::int64_t near = map_code(at(p.x), at(p.y), t.machine);
        const std::int64_t code = k % 12 == 0  ? t.machine.deepest_drawn()  // deeper than all
                                  : k % 7 == 0 ? t.machine.deepest_drawn() + in.between(-1, 1)
                                  : k % 7 == 1 ? in.between(-1, 1)
                                  : k % 7 == 2 ? near + in.between(-1, 1)
                                               : in.between(0, t.machine.deepest_drawn());
        p.z = code - t.machine.depth_offset();
        const bool shadow =
            shadow::in_shadow(shadow::light_map<hw::Depth32>(store, t), p, d);
        lines.push_back((Line() << "test" << t.machine.z_bits << t.machine.fraction_bits
                                << lookups[static_cast<std::size_t>(t.lookup)]
                                << backgrounds[static_cast<std::size_t>(t.background)] << p.x
                                << p.y << p.z << d.x << d.y << "->" << (shadow ? 255 : 0)).text());
    }
    check_vectors("shadow_test",
                  {"Section 11.",
                   "words xy_bits z_bits registration px py code -> word_x word_y word_z",
                   "test z_bits fraction_bits lookup background X Y Z dither_x dither_y -> mask,",
                   "with xy_bits 4 and the light map's code of texel (a, b): background if a + 2 b",
                   "is a multiple of 11, else (7919 a + 104729 b + 613 a b) mod 2^z_bits"},
                  lines);
}

TEST(Vectors, Windows) {
    Inputs in(14);
    Lines lines;
    for (int k = 0; k < 96; ++k) {
        shadow::ShadowTest t;
        t.machine.xy_bits = 4;
        t.machine.z_bits = static_cast<int>(in.between(4, 24));
        t.machine.fraction_bits = static_cast<int>(k % 8 == 0 ? 0 : in.between(1, 12));
        t.lookup = k % 3 == 2 ? shadow::Lookup::filtered_depth : shadow::Lookup::percentage;
        t.taps = 2 + k % 4;
        t.tap_places = k / 4 % 2 == 0 ? shadow::TapPlaces::grid : shadow::TapPlaces::jittered;
        std::vector<hw::Depth32> map(256);
        for (int b = 0; b < 16; ++b)
            for (int a = 0; a < 16; ++a)
                map[static_cast<std::size_t>(16 * b + a)] = map_code(a, b, t.machine);
        const hw::FrameStore<const hw::Depth32> store{4, map, {}};
        const std::int64_t edge = std::int64_t{8} << t.machine.fraction_bits;
        // Now and then beside the map's edge, or a step from a texel's edge or middle.
        const auto place = [&] {
            const std::int64_t half = edge / 16;
            if (k % 6 == 0) return (in.between(0, 1) == 0 ? -edge : edge) + in.between(-2, 1);
            return k % 6 == 1 ? in.between(-15, 15) * half + in.between(-1, 1)
                              : in.between(-edge, edge - 1);
        };
        const std::int64_t x = place(), y = place();
        const std::int64_t z = in.between(0, t.machine.deepest_drawn()) - t.machine.depth_offset();
        const hw::DitherWords d{static_cast<std::int32_t>(in.between(-1, 1)),
                                static_cast<std::int32_t>(in.between(-1, 1))};
        const auto seed = static_cast<std::uint32_t>(in.between(1, 0x7fffffff));
        const int px = static_cast<int>(in.between(0, 15));
        const int py = static_cast<int>(in.between(0, 15));
        const auto noise = hw::TapNoise(seed, t.taps * t.taps, t.machine, px, py).next();
        const int dark = shadow::darkness(shadow::light_map<hw::Depth32>(store, t),
                                          hw::Point{x, y, z, hw::DivideStatus::ok}, d, noise);
        lines.push_back(
            (Line() << t.machine.z_bits << t.machine.fraction_bits
                    << (t.lookup == shadow::Lookup::percentage ? "percentage" : "filtered_depth")
                    << t.taps
                    << (t.tap_places == shadow::TapPlaces::grid ? "grid" : "jittered") << x << y
                    << z << d.x << d.y << seed << px << py << "->" << dark).text());
    }
    check_vectors("windows",
                  {"Sections 10 and 11, steps 7 and 8.",
                   "z_bits fraction_bits lookup taps tap_places X Y Z dither_x dither_y",
                   "dither_seed px py -> mask, with xy_bits 4 and shadow_test.txt's light map"},
                  lines);
}

// --- filters: frames of 16 x 16 pixels ------------------------------------------------------

// Bits of 256 pixels as 64 digits, bytes as 512: row by row, the first pixel first.
std::string hex(std::span<const std::uint8_t> bytes) {
    std::string text;
    for (const std::uint8_t b : bytes)
        for (const int digit : {b >> 4, b & 15}) text += "0123456789abcdef"[digit];
    return text;
}
std::string bits(std::span<const std::uint8_t> bytes) {
    std::string text;
    for (std::size_t k = 0; k < bytes.size(); k += 4) {
        int digit = 0;
        for (std::size_t i = 0; i < 4; ++i) digit = 2 * digit + (bytes[k + i] != 0 ? 1 : 0);
        text += "0123456789abcdef"[digit];
    }
    return text;
}

// Blobs: a random picture, smoothed by the majority of five, now and then not.
std::vector<std::uint8_t> blobs(Inputs& in, int percent, int smoothings) {
    std::vector<std::uint8_t> picture(256);
    for (std::uint8_t& p : picture) p = in.between(0, 99) < percent ? 255 : 0;
    for (; smoothings > 0; --smoothings) {
        const std::vector<std::uint8_t> before = picture;
        for (int k = 0; k < 256; ++k) {
            int set = 0;
            for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
                const int x = std::clamp(k % 16 + dx, 0, 15), y = std::clamp(k / 16 + dy, 0, 15);
                set += before[static_cast<std::size_t>(16 * y + x)] != 0 ? 1 : 0;
            }
            picture[static_cast<std::size_t>(k)] = set > 2 ? 255 : 0;
        }
    }
    return picture;
}
std::vector<hw::Depth16> depths(const std::vector<std::uint8_t>& visible) {
    std::vector<hw::Depth16> z(256);
    for (std::size_t k = 0; k < 256; ++k) z[k] = visible[k] != 0 ? 100 : 65535;
    return z;
}

TEST(Vectors, Filters) {
    Inputs in(12);
    Lines dequantized, passed;
    for (int k = 0; k < 24; ++k) {
        const auto mask = blobs(in, 50, k % 4), visible = blobs(in, k % 3 == 0 ? 100 : 80, 1);
        const auto z = depths(visible);
        const hw::FrameStore<const hw::Depth16> store{4, z, {}};
        std::vector<std::uint8_t> out(256);
        std::vector<std::uint32_t> visited(shadow::edge_visited_words(4));
        std::vector<std::int16_t> coverage(shadow::edge_coverage_words(4));
        const int passes = 1 + k % 6;
        shadow::dequantize<hw::Depth16>(mask, store, 65535, passes, {visited, coverage}, out);
        dequantized.push_back((Line() << passes << bits(mask) << bits(visible) << "->" << hex(out))
                                  .text());
        std::vector<std::uint8_t> levels(256), low(256);
        for (std::uint8_t& v : levels) v = static_cast<std::uint8_t>(in.between(0, 255));
        shadow::low_pass<hw::Depth16>(levels, store, 65535, low);
        if (k < 16)
            passed.push_back((Line() << hex(levels) << bits(visible) << "->" << hex(low)).text());
    }
    const std::string frame = "16 x 16 pixels; shadow and visible are 256 bits, levels 256 bytes,";
    const std::string order = "hexadecimal, row by row from the top, the first pixel first.";
    check_vectors("dequantize", {"Section 13. " + frame, order, "passes shadow visible -> levels"},
                  dequantized);
    check_vectors("low_pass", {"Section 13, one pass. " + frame, order, "levels visible -> levels"},
                  passed);
}

TEST(Vectors, Composite) {
    Inputs in(13);
    Lines lines;
    for (int k = 0; k < 64; ++k) {
        const auto byte = [&](std::int64_t max) {
            return static_cast<std::uint8_t>(in.between(0, max));
        };
        const std::uint8_t level = byte(255), mask = k % 4 == 0 ? std::uint8_t{255} : byte(255);
        const std::uint8_t share = k % 4 == 1 ? level : byte(level);
        const int density = k % 8 == 0 ? 256 : static_cast<int>(in.between(0, 256));
        lines.push_back((Line() << int{level} << int{share} << int{mask} << density << "->"
                                << int{shadow::composite(level, share, mask, density)}).text());
    }
    check_vectors("composite",
                  {"Section 13, one light: out before, share, mask, density (Q0.8) -> out after"},
                  lines);
}

}  // namespace
}  // namespace umbra78::test
