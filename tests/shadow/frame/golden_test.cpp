// Figures 1 to 6 against tests/goldens: every stage's buffer, value by value, and its hash.
//
// `umbra78 figures --bless` writes the goldens. They are binary PGM, one byte a value, and two for
// Z, the higher first; hashes.txt has a line "name format:WxH:fnv1a64:<16 hex digits>" for each
// buffer, with the format u8 or u16be. Of a difference the first pixel is printed with both values,
// and a picture is written to the test's working folder. UMBRA78_GOLDENS names another folder.
// Nothing here uses the program: the tests read the goldens and draw the frames themselves.
#include "fixed/fnv.hpp"
#include "tests/shadow/frame/figure_frame.hpp"
#include "tests/support/buffers.hpp"
#include "tests/support/machine_text.hpp"
#include "tests/support/paths.hpp"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace umbra78::shadow {
namespace {

namespace fs = std::filesystem;
using test::FigureScene;
using test::Frame;
using Values = std::vector<std::uint16_t>;

struct Plane {
    std::string name;
    int maxval;  // 255 or 65535
    int width, height;
    Values values;

    bool operator==(const Plane&) const = default;
};

// --- files --------------------------------------------------------------------------------------

// Binary PGM as the goldens are written: "P5 width height maxval", one white space, samples.
std::optional<Plane> read_pgm(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string magic;
    Plane p{path.stem().string(), 0, 0, 0, {}};
    if (!(file >> magic >> p.width >> p.height >> p.maxval) || magic != "P5") return {};
    if (p.width < 1 || p.height < 1 || (p.maxval != 255 && p.maxval != 65535)) return {};
    if (!std::isspace(file.get())) return {};
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    const std::size_t pixels =
        static_cast<std::size_t>(p.width) * static_cast<std::size_t>(p.height);
    const std::size_t each = p.maxval > 255 ? 2 : 1;
    if (bytes.size() != each * pixels) return {};
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(bytes[k]); };
    for (std::size_t k = 0; k < pixels; ++k)
        p.values.push_back(static_cast<std::uint16_t>(
            each == 1 ? byte(k) : byte(2 * k) * 256 + byte(2 * k + 1)));
    return p;
}

void write_pgm(const fs::path& path, const Plane& p) {
    std::ofstream file(path, std::ios::binary);
    file << "P5\n" << p.width << ' ' << p.height << '\n' << p.maxval << '\n';
    for (const std::uint16_t v : p.values) {
        if (p.maxval > 255) file.put(static_cast<char>(v >> 8));
        file.put(static_cast<char>(v));
    }
}

std::string hash_of(const Plane& p) {
    fixed::Fnv1a64 hash;
    for (const std::uint16_t v : p.values)
        p.maxval > 255 ? hash.u16be(v) : hash.byte(static_cast<std::uint8_t>(v));
    std::ostringstream text;
    text << (p.maxval > 255 ? "u16be" : "u8") << ':' << p.width << 'x' << p.height << ":fnv1a64:"
         << std::hex << std::setw(16) << std::setfill('0') << hash.value();
    return text.str();
}

std::map<std::string, std::string> read_hashes(const fs::path& path) {
    std::map<std::string, std::string> hashes;
    std::ifstream file(path);
    for (std::string name, hash; file >> name >> hash;) hashes[name] = hash;
    return hashes;
}

fs::path goldens() {
    const char* elsewhere = std::getenv("UMBRA78_GOLDENS");
    return elsewhere != nullptr ? fs::path(elsewhere)
                                : fs::path(UMBRA78_SOURCE_DIR) / "tests" / "goldens";
}

// --- the figures' buffers -----------------------------------------------------------------------

template <class T>
Plane plane(const std::string& name, std::span<T> values) {
    return {name, sizeof(T) == 1 ? 255 : 65535, 512, 512, Values(values.begin(), values.end())};
}

std::vector<Plane> draw_figures() {
    const FigureScene figures;
    const Frame<> three(figures.scene(), figure_settings(3));
    const Frame<> four(figures.scene(), figure_settings(4));
    const Frame<> five(figures.scene(), figure_settings(5));
    const Frame<> six(figures.scene(), figure_settings(6));
    const Frame<> array3(figures.scene(), array_figure_settings(3));
    const Frame<> array4(figures.scene(), array_figure_settings(4));
    return {plane("observer_z", three.buffers.observer.depth),
            plane("light_z", three.buffers.lights[0].map.depth),
            plane("intensity", three.buffers.observer.intensity),
            plane("mask3", three.buffers.lights[0].mask),
            plane("mask4", four.buffers.lights[0].mask),
            plane("edges5", five.buffers.lights[0].edges),
            plane("filtered5", five.buffers.lights[0].filtered),
            plane("picture6", six.buffers.picture),
            plane("mask3_ap120b", array3.buffers.lights[0].mask),
            plane("mask4_ap120b", array4.buffers.lights[0].mask)};
}

TEST(Golden, EveryBufferOfTheFigures) {
    const std::map<std::string, std::string> hashes = read_hashes(goldens() / "hashes.txt");
    std::size_t found = 0;
    for (const Plane& now : draw_figures()) {
        const fs::path path = goldens() / (now.name + ".pgm");
        const std::optional<Plane> golden = read_pgm(path);
        if (!golden) {
            ADD_FAILURE() << path << " is missing or no golden; write it: umbra78 figures --bless";
            continue;
        }
        EXPECT_EQ(golden->maxval, now.maxval) << now.name;
        EXPECT_EQ(golden->width, 512) << now.name;
        umbra78::test::expect_equal_buffers(now.name, 512, golden->values, now.values);
        const auto hash = hashes.find(now.name);
        if (hash == hashes.end()) {
            ADD_FAILURE() << now.name << " has no line in " << goldens() / "hashes.txt";
            continue;
        }
        ++found;
        EXPECT_EQ(hash->second, hash_of(*golden)) << now.name << ": hash and golden disagree";
        EXPECT_EQ(hash->second, hash_of(now)) << now.name;
    }
    EXPECT_EQ(found, 10u) << "figures 1 to 6; the others are pictures of scene files";
}

// The normative text publishes the same hashes, in table rows "... | buffer | `hash` |".
TEST(Golden, MachineMdPublishesTheHashes) {
    const std::string& text = umbra78::test::machine_text();
    for (const Plane& now : draw_figures()) {
        const std::string row = "| " + now.name + " | `" + hash_of(now) + "` |";
        EXPECT_NE(text.find(row), std::string::npos) << "hw/MACHINE.md has no " << row;
    }
}

// All figures share their views, so their stores are the same; 5 is 6 up to the picture.
TEST(Golden, FiguresShareTheirStages) {
    const FigureScene figures;
    const Frame<> three(figures.scene(), figure_settings(3));
    const Frame<> five(figures.scene(), figure_settings(5));
    const Frame<> six(figures.scene(), figure_settings(6));
    using umbra78::test::expect_equal_buffers;
    expect_equal_buffers("light_z", 512, three.buffers.lights[0].map.depth,
                         six.buffers.lights[0].map.depth);
    expect_equal_buffers("observer_z", 512, three.buffers.observer.depth,
                         six.buffers.observer.depth);
    expect_equal_buffers("intensity", 512, three.buffers.observer.intensity,
                         six.buffers.observer.intensity);
    expect_equal_buffers("filtered", 512, five.buffers.lights[0].filtered,
                         six.buffers.lights[0].filtered);
}

// --- the reader itself --------------------------------------------------------------------------

class GoldenReader : public ::testing::Test {
protected:
    GoldenReader() { fs::create_directories(folder); }
    ~GoldenReader() override { fs::remove_all(folder); }
    void write(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder / name, std::ios::binary) << bytes;
    }
    const fs::path folder =
        fs::path(::testing::TempDir()) / ("umbra78-goldens-" + std::to_string(::getpid()));
};

TEST_F(GoldenReader, ReadsBothWidths) {
    using namespace std::string_literals;
    write("a.pgm", "P5\n2 2\n65535\n\x01\x02\xff\xff\x00\x00\x0a\x20"s);
    EXPECT_EQ(read_pgm(folder / "a.pgm"),
              (Plane{"a", 65535, 2, 2, {0x0102, 0xffff, 0, 0x0a20}}));
    write("b.pgm", "P5 3 1 255 \x20\x0a\xff"s);
    EXPECT_EQ(read_pgm(folder / "b.pgm"), (Plane{"b", 255, 3, 1, {0x20, 0x0a, 0xff}}));
    for (const std::string& bad :
         {""s, "P2 1 1 255 0"s, "P5 2 2 255 abc"s, "P5 2 2 255 abcde"s, "P5 2 2 65535 abcd"s,
          "P5 2 2 31 abcd"s, "P5 0 2 255 "s, "P5 2 2 255"s}) {
        write("bad.pgm", bad);
        EXPECT_EQ(read_pgm(folder / "bad.pgm"), std::nullopt) << bad;
    }
    EXPECT_EQ(read_pgm(folder / "none.pgm"), std::nullopt);
    write("hashes.txt", "a u16be:2x2:fnv1a64:0123456789abcdef\nb u8:3x1:fnv1a64:0\n");
    EXPECT_EQ(read_hashes(folder / "hashes.txt"),
              (std::map<std::string, std::string>{{"a", "u16be:2x2:fnv1a64:0123456789abcdef"},
                                                  {"b", "u8:3x1:fnv1a64:0"}}));
}

TEST_F(GoldenReader, WhatIsWrittenIsReadAndAChangeIsFound) {
    const FigureScene figures;
    Settings s = figure_settings(6);
    const Frame<> frame(figures.scene(), s);
    for (const Plane& p : {plane("observer_z", frame.buffers.observer.depth),
                           plane("picture6", frame.buffers.picture)}) {
        const fs::path path = folder / (p.name + ".pgm");
        write_pgm(path, p);
        std::optional<Plane> read = read_pgm(path);
        ASSERT_TRUE(read);
        EXPECT_EQ(*read, p);
        EXPECT_EQ(hash_of(*read), hash_of(p));
        read->values[512 * 100 + 200] ^= 1;
        EXPECT_NE(hash_of(*read), hash_of(p));
        EXPECT_NONFATAL_FAILURE(
            umbra78::test::expect_equal_buffers(p.name, 512, read->values, p.values),
            "1 of 262144 words differ, first x 200 y 100");
    }
    for (const char* name : {"observer_z", "picture6"})  // the pictures of that one pixel
        fs::remove("GoldenReader.WhatIsWrittenIsReadAndAChangeIsFound." + std::string(name) +
                   ".difference.pgm");
}

// The hash's published test vectors: nothing, and "a".
TEST(GoldenHash, IsFnv1a64) {
    EXPECT_EQ(hash_of({"", 255, 0, 0, {}}), "u8:0x0:fnv1a64:cbf29ce484222325");
    EXPECT_EQ(hash_of({"", 255, 1, 1, {'a'}}), "u8:1x1:fnv1a64:af63dc4c8601ec8c");
    EXPECT_NE(hash_of({"", 65535, 1, 1, {0x0102}}).substr(5),
              hash_of({"", 65535, 1, 1, {0x0201}}).substr(5));
}

}  // namespace
}  // namespace umbra78::shadow
