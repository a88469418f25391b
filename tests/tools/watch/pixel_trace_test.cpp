// The trace of a pixel: the worked pixels of hw/MACHINE.md, and the functional machine's words.
#include "tools/watch/pixel_trace.hpp"

#include "fixed/divide.hpp"
#include "shadow/frame/paper_figures.hpp"
#include "tests/support/effort.hpp"
#include "tests/support/paths.hpp"
#include "tests/tools/watch/traced.hpp"
#include "tools/paper/figure_set.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <string>

namespace umbra78::tools {
namespace {

using test::has_word;
using test::pick;
using test::Random;
using test::word_of;

// --- hw/MACHINE.md, section 15, "Pixels" ---------------------------------------------------------

struct Worked {
    Pixel at;
    int code;
    std::array<std::int64_t, 3> words, accumulators, results;  // results: X, Y and the code k
    Pixel texel3;
    int code3, mask3;
    int k4, dither_x, dither_y;
    Pixel texel4;
    int fx, fy;
    std::array<int, 4> codes4;
    int mask4;
};

constexpr Worked worked_pixels[] = {
    {{80, 180}, 22211, {-22464, -9664, -10557}, {468494550, -158334976, -666941102},
     {14297, -9664, 12415}, {367, 180}, 12393, 255,
     12287, -15, 5, {367, 180}, 10, 5, {12393, 12846, 12402, 12854}, 0},
    {{100, 180}, 21286, {-19904, -9664, -11482}, {483777900, -158334976, -579066652},
     {14764, -9664, 15096}, {371, 180}, 15703, 0,
     14968, 15, -14, {370, 179}, 123, 114, {14094, 15703, 14101, 15703}, 0},
    {{115, 180}, 20998, {-17984, -9664, -11770}, {482146860, -158334976, -515469532},
     {14714, -9664, 17037}, {370, 180}, 14101, 255,
     16909, -22, 1, {370, 180}, 36, 1, {14101, 15703, 14118, 65535}, 255},
    {{330, 300}, 16509, {9536, 5696, -16259}, {470418090, 93323264, 398143278},
     {14356, 5696, 44918}, {368, 300}, 45057, 0,
     44790, 15, -1, {367, 299}, 99, 127, {44870, 45084, 44844, 45057}, 0},
    {{150, 400}, 17759, {-13504, 18496, -15009}, {561178190, 303038464, -352470022},
     {17126, 18496, 22011}, {389, 400}, 19960, 255,
     21883, -8, 18, {389, 400}, 30, 18, {19960, 65535, 19992, 65535}, 0},
};

std::string texel(int x, int y) {
    return "z(" + std::to_string(x) + "," + std::to_string(y) + ")";
}

void expect_transform(const PixelTrace& t, const Worked& w, bool accumulators) {
    EXPECT_EQ(word_of(t, "read", "code"), w.code);
    constexpr const char *inputs[] = {"x", "y", "z"}, *rows[] = {"X", "Y", "Z"};
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(word_of(t, "words", inputs[k]), w.words[k]);
        if (accumulators) {
            EXPECT_EQ(word_of(t, "accumulate", std::string("acc_") + rows[k]), w.accumulators[k]);
        }
        if (k < 2) {
            EXPECT_EQ(word_of(t, "round", std::string("R_") + rows[k]), w.results[k]);
        }
    }
    EXPECT_EQ(word_of(t, "words", "one"), 16384);
}

TEST(PixelTrace, WorkedPixelsOfFigure3) {
    const LoadedScene scene = figures_scene();
    RenderJob job(scene.view(), shadow::figure_settings(3));
    job.render();
    for (const Worked& w : worked_pixels) {
        const PixelTrace t = trace_pixel(job, w.at);
        SCOPED_TRACE(to_text(t.lines));
        EXPECT_EQ(t.outcome, PixelOutcome::compared);
        expect_transform(t, w, true);
        EXPECT_EQ(word_of(t, "place", "X"), w.results[0]);
        EXPECT_EQ(word_of(t, "place", "Y"), w.results[1]);
        EXPECT_EQ(word_of(t, "place", "k"), w.results[2]);
        EXPECT_EQ(word_of(t, "place", "tx"), w.texel3.x);
        EXPECT_EQ(word_of(t, "place", "ty"), w.texel3.y);
        EXPECT_EQ(word_of(t, "fetch", texel(w.texel3.x, w.texel3.y)), w.code3);
        EXPECT_EQ(word_of(t, "write", "mask"), w.mask3);
        EXPECT_EQ(t.mask, w.mask3);
    }
}

TEST(PixelTrace, WorkedPixelsOfFigure4) {
    const LoadedScene scene = figures_scene();
    RenderJob job(scene.view(), shadow::figure_settings(4));
    job.render();
    for (const Worked& w : worked_pixels) {
        const PixelTrace t = trace_pixel(job, w.at);
        SCOPED_TRACE(to_text(t.lines));
        expect_transform(t, w, false);
        EXPECT_EQ(word_of(t, "noise", "dither_X"), w.dither_x);
        EXPECT_EQ(word_of(t, "noise", "dither_Y"), w.dither_y);
        EXPECT_EQ(word_of(t, "place", "X"), w.results[0] + w.dither_x);
        EXPECT_EQ(word_of(t, "place", "Y"), w.results[1] + w.dither_y);
        EXPECT_EQ(word_of(t, "place", "k"), w.k4);
        EXPECT_EQ(word_of(t, "place", "tx"), w.texel4.x);
        EXPECT_EQ(word_of(t, "place", "ty"), w.texel4.y);
        EXPECT_EQ(word_of(t, "place", "fx"), w.fx);
        EXPECT_EQ(word_of(t, "place", "fy"), w.fy);
        for (int k = 0; k < 4; ++k)
            EXPECT_EQ(word_of(t, "fetch", texel(w.texel4.x + (k & 1), w.texel4.y + (k >> 1))),
                      w.codes4[static_cast<std::size_t>(k)]);
        EXPECT_EQ(word_of(t, "compare", "shadow"), w.mask4 == 255);
        EXPECT_EQ(t.mask, w.mask4);
    }
}

// When each part of the machine has its words: hw/README.md's journey, from when the pixel leaves
// the reader.
TEST(PixelTrace, PartsFollowEachOtherCycleByCycle) {
    const LoadedScene scene = figures_scene();
    RenderJob job(scene.view(), shadow::figure_settings(3));
    job.render();
    const PixelTrace t = trace_pixel(job, {80, 180});
    const struct {
        const char *part, *word;
        std::uint64_t cycle;
    } expected[] = {
        {"words", "x", 0},       {"multiply", "c_X0 x", 1},   {"multiply", "c_Y1 y", 2},
        {"sum", "sum_X", 2},     {"accumulate", "acc_X", 3},  {"multiply", "c_Z2 z", 3},
        {"sum", "sum_Z", 4},     {"accumulate", "acc_Z", 5},  {"round", "R_X", 4},
        {"round", "R_Z", 6},     {"place", "tx", 7},          {"fetch", "z(367,180)", 8},
        {"compare", "shadow", 9}, {"write", "mask", 10},
    };
    for (const auto& [part, word, cycle] : expected) {
        int found = 0;
        for (const TraceLine& line : t.lines) {
            if (line.part != part || line.name != word) continue;
            EXPECT_EQ(line.cycle, 169708 + cycle) << part << " " << word;
            ++found;
        }
        EXPECT_EQ(found, 1) << part << " " << word;
    }
}

// --- any pixel -----------------------------------------------------------------------------------

// Cycles of a point never go back, its mask word comes L cycles after it left the reader, and each
// word is the same in every form.
void expect_sound(const PixelTrace& t, const shadow::PostProcessPipeline& plan) {
    std::uint64_t last = 0, released = 0;
    for (const TraceLine& line : t.lines) {
        if (line.part == "words") released = *line.cycle;
        // Noise is traced byte by byte, with cycles before the pixel left the reader.
        if (line.cycle && line.part != "noise") {
            EXPECT_GE(*line.cycle, last);
            last = *line.cycle;
        }
        if (!line.word) continue;
        const MachineWord& w = *line.word;
        EXPECT_EQ(line.decimal, std::to_string(w.value));
        ASSERT_TRUE(w.bits >= 1 && w.bits <= 64) << line.name;
        std::uint64_t bits = std::stoull(hex_text(w), nullptr, 16);
        if (w.has_sign && (bits >> (w.bits - 1) & 1) != 0 && w.bits < 64)
            bits |= ~std::uint64_t{0} << w.bits;
        EXPECT_EQ(static_cast<std::int64_t>(bits), w.value) << line.name;
    }
    if (t.outcome == PixelOutcome::background) return;
    EXPECT_EQ(last, t.last_cycle);
    EXPECT_EQ(t.last_cycle - released, static_cast<std::uint64_t>(plan.latency));
    EXPECT_GE(released, t.first_cycle + static_cast<std::uint64_t>(plan.read_cycles) - 1);
}

// The words against the functional unit's, noise's and mask's.
void expect_functional(const PixelTrace& t, const WatchedFrame& frame, std::uint8_t mask) {
    const shadow::Settings& s = frame.settings();
    const hw::Words words = shadow::pixel_words(
        t.pixel.x, t.pixel.y,
        frame.observer().depth[frame.observer().address(t.pixel.x, t.pixel.y)], s);
    const hw::TransformUnit unit(s.machine, frame.matrix());
    const hw::Point point = unit(words);
    EXPECT_EQ(t.mask, mask);
    EXPECT_EQ(word_of(t, "write", "mask"), mask);
    EXPECT_EQ(t.outcome == PixelOutcome::no_quotient, point.status != hw::DivideStatus::ok);
    const char* part = frame.matrix().affine ? "round" : "divide";
    const std::int64_t result[] = {point.x, point.y, point.z};
    constexpr const char* rows[] = {"X", "Y", "Z", "W"};
    for (int r = 0; r < (frame.matrix().affine ? 3 : 4); ++r) {
        EXPECT_EQ(word_of(t, "accumulate", std::string("acc_") + rows[r]),
                  hw::accumulate(frame.matrix(), static_cast<hw::Row>(r), words,
                                 s.machine.one_word(), hw::product_cut(s.machine)));
        if (r == 3 || point.status != hw::DivideStatus::ok) continue;
        EXPECT_EQ(word_of(t, part, std::string("R_") + rows[r]), result[r]);
    }
    hw::DitherWords d{0, 0};
    if (s.dither.shape != hw::DitherShape::none)
        d = hw::NoiseSource(s.dither, s.machine, t.pixel.x, t.pixel.y).next();
    if (point.status != hw::DivideStatus::ok) return;
    EXPECT_EQ(word_of(t, "place", "X"), point.x + d.x);
    EXPECT_EQ(word_of(t, "place", "Y"), point.y + d.y);
}

std::string decimal_of(const PixelTrace& t, const std::string& name) {
    for (const TraceLine& line : t.lines)
        if (line.part == "divide" && line.name == name) return line.decimal;
    return "no " + name;
}

// Both sides of the certificate of every quotient, and what is said of them.
void expect_certificates(const PixelTrace& t) {
    if (t.outcome == PixelOutcome::no_quotient) return;
    for (const std::string row : {"X", "Y", "Z"}) {
        const std::int64_t x = word_of(t, "divide", "dividend_" + row);
        const std::int64_t w = word_of(t, "divide", "divisor_" + row);
        const std::int64_t q = word_of(t, "divide", "R_" + row);
        const int k = static_cast<int>(word_of(t, "divide", "shift_" + row));
        const int up = k > 0 ? k : 0, down = k < 0 ? -k : 0;
        const WideWord residual = WideWord(q) * WideWord(w) * (WideWord(1) << down) -
                                  WideWord(x) * (WideWord(1) << up);
        EXPECT_EQ(decimal_of(t, "2|q w - x 2^k|_" + row),
                  decimal_text(residual.abs() + residual.abs()));
        EXPECT_EQ(decimal_of(t, "w_" + row), decimal_text(WideWord(w) * (WideWord(1) << down)));
        const bool holds = fixed::certificate_holds(x, w, k, q);
        for (const TraceLine& line : t.lines)
            if (line.name == "w_" + row) {
                EXPECT_EQ(line.how.find("it holds") != std::string::npos, holds) << line.how;
            }
    }
}

TEST(PixelTrace, AnyPixelOfAnyMachine) {
    Random random;
    std::array<int, 4> fates{};
    for (int round = 0; round < umbra78::test::effort(500); ++round) {
        const shadow::Settings s = test::random_machine(random);
        const auto frame = test::random_frame(random, s);
        std::vector<std::uint8_t> mask(frame->mask().size());
        shadow::post_process<hw::Depth32>({.observer = frame->observer(), .light = frame->light()},
                                          frame->matrix(), s, mask);
        const Pixel at{static_cast<int>(random.between(0, 15)),
                       static_cast<int>(random.between(0, 15))};
        const PixelTrace t = trace_post_process(*frame, at);
        SCOPED_TRACE("round " + std::to_string(round) + "\n" + to_text(t.lines));
        ++fates[static_cast<std::size_t>(t.outcome)];
        expect_sound(t, frame->machine()->plan());
        if (t.outcome == PixelOutcome::background) {
            EXPECT_EQ(t.mask, 0);
            EXPECT_FALSE(has_word(t, "write", "mask"));
            continue;
        }
        expect_functional(t, *frame, mask[frame->observer().address(at.x, at.y)]);
        if (!frame->matrix().affine) expect_certificates(t);
        if (HasFailure()) return;
    }
    for (const int seen : fates) EXPECT_GT(seen, umbra78::test::effort(500) / 50);
}

// A scene in perspective, with either lookup, to the picture.
TEST(PixelTrace, LampInPerspective) {
    Random random;
    for (const char* lookup : {"lookup=nearest", "lookup=bilinear", "lookup=percentage",
                               "lookup=filtered_depth"}) {
        const std::string set[] = {lookup, "xy_bits=6", "low_pass=2", "dequantize=1"};
        const LoadedScene scene =
            load_scene(UMBRA78_SOURCE_DIR "/tools/scenes/lamp.toml", set);
        RenderJob job(scene.view(), scene.settings);
        job.render();
        WatchedFrame frame(job);
        int shadowed = 0;
        for (int round = 0; round < 40; ++round) {
            const Pixel at{static_cast<int>(random.between(0, 63)),
                           static_cast<int>(random.between(0, 63))};
            const PixelTrace t = trace_pixel(job, at);
            SCOPED_TRACE(to_text(t.lines));
            const std::size_t a = frame.observer().address(at.x, at.y);
            expect_sound(t, frame.machine()->plan());
            EXPECT_EQ(word_of(t, "composite", "picture"), job.bytes(Plane::picture)[a]);
            if (t.outcome == PixelOutcome::background) continue;
            expect_functional(t, frame, job.bytes(Plane::mask)[a]);
            expect_certificates(t);
            if (scene.settings.lookup == shadow::Lookup::percentage) {
                EXPECT_EQ(job.bytes(Plane::edges)[a], t.mask) << "nothing is dequantized";
            } else {
                EXPECT_EQ(word_of(t, "dequantize", "edges"), job.bytes(Plane::edges)[a]);
            }
            EXPECT_EQ(word_of(t, "low-pass", "filtered"), job.bytes(Plane::filtered)[a]);
            shadowed += t.mask != 0;
            if (HasFailure()) return;
        }
        EXPECT_GT(shadowed, 0);
    }
}

// --- what cannot be traced, and how it is told ---------------------------------------------------

std::string error_of(const RenderJob& job, Pixel pixel) {
    try {
        trace_pixel(job, pixel);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "";
}

TEST(PixelTrace, WhatCannotBeTracedIsOneLine) {
    const LoadedScene scene = figures_scene();
    shadow::Settings s = shadow::figure_settings(6);
    s.machine.xy_bits = 5;
    RenderJob job(scene.view(), s);
    job.render();
    EXPECT_EQ(error_of(job, {31, 31}), "");
    for (const Pixel out : {Pixel{32, 0}, Pixel{0, 32}, Pixel{-1, 0}, Pixel{0, -1}})
        EXPECT_EQ(error_of(job, out), "pixel " + std::to_string(out.x) + "," +
                                          std::to_string(out.y) + " is not in the frame of 32 x "
                                          "32 pixels; give x and y of 0 .. 31");
    s.form = shadow::Form::correct;
    RenderJob correct(scene.view(), s);
    correct.render();
    EXPECT_EQ(error_of(correct, {0, 0}), "the correct form has no post-process to watch; give "
                                         "--set form=post_process");
}

TEST(PixelTrace, ItsJsonHasTheSameWords) {
    const LoadedScene scene = figures_scene();
    RenderJob job(scene.view(), shadow::figure_settings(6));
    job.render();
    const PixelTrace t = trace_pixel(job, {115, 180});
    EXPECT_EQ(summary(t).substr(0, 17), "in shadow, cycles");
    const nlohmann::ordered_json json = to_json(t);
    ASSERT_EQ(json["words"].size(), t.lines.size());
    for (std::size_t k = 0; k < t.lines.size(); ++k) {
        const auto& row = json["words"][k];
        EXPECT_EQ(row["part"], t.lines[k].part);
        if (!t.lines[k].word) continue;
        EXPECT_EQ(row["decimal"], t.lines[k].word->value);
        EXPECT_EQ(row["hex"], hex_text(*t.lines[k].word));
    }
    EXPECT_EQ(json["mask"], 255);
    EXPECT_EQ(json["outcome"], "compared");
}

TEST(WordText, DecimalFormatAndHexadecimal) {
    const struct {
        MachineWord word;
        const char *real, *format, *hex;
    } cases[] = {
        {signed_word(-22464, 16, 7), "-175.5", "Q8.7", "a840"},
        {signed_word(-1, 35, 0), "-1", "Q34.0", "7ffffffff"},
        {unsigned_word(65535, 16), "65535", "UQ16.0", "ffff"},
        {signed_word(200, 8, 7), "1.5625", "Q1.7", "0c8"},  // needs nine bits
        {signed_word(3, 8, -2), "3 x 2^2", "Q9.-2", "03"},
        {signed_word(-5, 32, 70), "-5 x 2^-70", "Q-39.70", "fffffffb"},
        {signed_word(INT64_MIN, 64, 0), "-9223372036854775808", "Q63.0", "8000000000000000"},
        {unsigned_word(0, 1), "0", "UQ1.0", "0"},
    };
    for (const auto& [word, real, format, hex] : cases) {
        EXPECT_EQ(real_text(word), real);
        EXPECT_EQ(format_text(word), format);
        EXPECT_EQ(hex_text(word), hex);
    }
    EXPECT_EQ(decimal_text(0), "0");
    EXPECT_EQ(decimal_text(-(WideWord(1) << 100)), "-1267650600228229401496703205376");
}

}  // namespace
}  // namespace umbra78::tools
