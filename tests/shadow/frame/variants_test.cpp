// What figures 1 to 6 do not reach: other samplings, forms, widths, perspective and point light.
//
// The variants are the rows of the table in hw/MACHINE.md, section 15: a scene, two views, settings
// and buffers. Each buffer's hash is a row of the table after it. A row that is missing or wrong is
// printed as it should be.
#include "fixed/decimal.hpp"
#include "fixed/fnv.hpp"
#include "tests/shadow/frame/figure_frame.hpp"
#include "tests/shadow/frame/variant_scenes.hpp"
#include "tests/support/machine_text.hpp"
#include "tests/support/workers.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <set>
#include <string>
#include <vector>

namespace umbra78::shadow {
namespace {

using umbra78::test::machine_table;
using umbra78::test::machine_text;

constexpr const char* variants_head = "| variant | scene | observer |";
constexpr const char* hashes_head = "| variant | buffer | hash |";

template <class Value>
std::string hash(std::span<Value> values, int size) {
    fixed::Fnv1a64 h;
    for (const Value v : values) {
        if constexpr (sizeof(Value) == 1) h.byte(v);
        if constexpr (sizeof(Value) == 2) h.u16be(v);
        if constexpr (sizeof(Value) == 4) h.u32be(v);
    }
    char text[80];
    std::snprintf(text, sizeof text, "u%d%s:%dx%d:fnv1a64:%016llx",
                  static_cast<int>(8 * sizeof(Value)), sizeof(Value) == 1 ? "" : "be", size, size,
                  static_cast<unsigned long long>(h.value()));
    return text;
}

void expect_documented(const std::string& row) {
    EXPECT_NE(machine_text().find(row), std::string::npos)
        << "hw/MACHINE.md, section 15, has no row\n" << row;
}

std::vector<std::string> split(const std::string& list) {
    std::vector<std::string> parts;
    for (std::size_t from = 0, to; from < list.size(); from = to + 2) {
        to = std::min(list.find(", ", from), list.size());
        parts.push_back(list.substr(from, to - from));
    }
    return parts;
}

// "key value", as the setting's own kind is written.
void set(Settings& settings, const std::string& text) {
    const std::size_t blank = text.find(' ');
    const Setting* s = find_setting(text.substr(0, blank));
    ASSERT_NE(s, nullptr) << text;
    const std::string value = text.substr(blank + 1);
    std::int64_t word = -1;
    for (std::size_t k = 0; k < s->names.size(); ++k)
        if (value == s->names[k]) word = static_cast<std::int64_t>(k);
    if (s->kind != SettingKind::choice) {
        const fixed::DecimalResult read = fixed::parse_decimal(value, s->fraction, 63);
        ASSERT_EQ(read.status, fixed::DecimalStatus::ok) << text;
        word = read.value;
    }
    ASSERT_TRUE(word >= s->min && word <= s->max) << text;
    s->set(settings, word);
}

Settings variant_settings(const std::string& list) {
    Settings settings;
    settings.ambient_q8 = paper_scene::ambient_q8;
    for (const std::string& one : split(list)) set(settings, one);
    return settings;
}

// "direct2_blue": the second source's, in the third channel.
struct BufferName {
    std::string kind;
    std::size_t number = 0, channel = 0;

    explicit BufferName(const std::string& text) : kind(text) {
        constexpr const char* channels[] = {"_red", "_green", "_blue"};
        for (std::size_t c = 0; c < 3; ++c)
            if (kind.ends_with(channels[c])) {
                channel = c;
                kind.resize(kind.size() - std::string(channels[c]).size());
                break;
            }
        if (kind.back() < '2' || kind.back() > '9') return;
        number = static_cast<std::size_t>(kind.back() - '1');
        kind.pop_back();
    }
};

template <class Depth>
std::string buffer_hash(const test::Frame<Depth>& f, const Scene& scene, const std::string& text,
                        int size) {
    const BufferName name(text);
    const FrameBuffers<Depth>& b = f.buffers;
    const std::string& kind = name.kind;
    if (kind == "observer_z") return hash(b.observer.depth, size);
    if (kind == "light_z") return hash(b.lights[name.number].map.depth, size);
    if (kind == "mask") return hash(b.lights[name.number].mask, size);
    if (kind.starts_with("normal_")) {
        const std::span all = b.observer.normal;
        const auto axis = static_cast<std::size_t>(kind.back() - 'x');
        return hash(all.subspan(axis * b.pixels(), b.pixels()), size);
    }
    if (kind == "intensity") return hash(b.intensity(name.channel), size);
    if (kind == "direct") return hash(b.direct(name.channel, name.number), size);
    if (kind == "picture") return hash(b.picture_of(name.channel), size);
    const LightBuffers<Depth>& source = b.lights[scene.source(name.number).first_light];
    if (kind == "darkness") return hash(source.joined, size);
    if (kind == "edges") return hash(source.edges, size);
    if (kind == "filtered") return hash(source.filtered, size);
    return "no such buffer";
}

template <class Depth>
void expect_variant(const std::vector<std::string>& row, const Settings& settings,
                    const Executor& executor) {
    const test::VariantScene made(row[1]);
    const Scene scene = made.scene(row[2], row[3]);
    const test::Frame<Depth> f(scene, settings, executor);
    ASSERT_EQ(f.status, FrameStatus::ok);
    for (const raster::DrawCounts& c : {f.counts.lights[0].map, f.counts.observer})
        EXPECT_EQ(c.unresolved + c.unresolved_facets, 0u);
    for (const std::string& buffer : split(row[5]))
        expect_documented("| " + row[0] + " | " + buffer + " | `" +
                          buffer_hash(f, scene, buffer, settings.machine.size_px()) + "` |");
}

// A row of the table, printed by its name alone.
struct Variant {
    std::vector<std::string> row;
    friend void PrintTo(const Variant& v, std::ostream* out) { *out << v.row[0]; }
};

std::vector<Variant> variants() {
    std::vector<Variant> all;
    for (const auto& row : machine_table(variants_head)) all.push_back({row});
    return all;
}

class Variants : public ::testing::TestWithParam<Variant> {};

void expect_variant(const std::vector<std::string>& row, const Executor& executor) {
    ASSERT_EQ(row.size(), 6u);
    const Settings settings = variant_settings(row[4]);
    if (settings.machine.z_bits <= 16) {
        expect_variant<hw::Depth16>(row, settings, executor);
    } else {
        expect_variant<hw::Depth32>(row, settings, executor);
    }
}

TEST_P(Variants, HaveTheirPublishedHashes) { expect_variant(GetParam().row, {}); }

TEST_P(Variants, HaveThemFromManyWorkers) {
    umbra78::test::Shuffled workers(5);
    expect_variant(GetParam().row, workers.executor());
    EXPECT_GT(workers.parts(), 20u) << "the work is shared";
}

INSTANTIATE_TEST_SUITE_P(OfTheDocument, Variants, ::testing::ValuesIn(variants()),
                         [](const auto& variant) { return variant.param.row[0]; });

// Every hash is of a variant and of a buffer that the variant has.
TEST(VariantTables, NameTheSameBuffers) {
    std::set<std::string> wanted, found;
    for (const auto& row : machine_table(variants_head))
        for (const std::string& buffer : split(row[5])) wanted.insert(row[0] + ' ' + buffer);
    for (const auto& row : machine_table(hashes_head)) found.insert(row[0] + ' ' + row[1]);
    EXPECT_GE(wanted.size(), 38u);
    EXPECT_EQ(wanted, found);
}

// --- masks of the figures' scene by short accumulators --------------------------------------

TEST(ShortAccumulator, CutsProducts) {
    const test::FigureScene s;
    const test::Frame<> f(s.scene(), variant_settings("accumulator_bits 22"));
    ASSERT_EQ(f.status, FrameStatus::ok);
    expect_documented("a short accumulator | accumulator_bits 22 | mask3_short | `" +
                      hash(f.buffers.lights[0].mask, 512) + "` |");
}

// The constant of each row is cut, too: 100 quanta of bias are no multiple of what is left.
TEST(ShortAccumulator, RoundsProductsAndConstants) {
    const test::FigureScene s;
    const std::string list = "accumulator_bits 16, product_rounding half_up, bias 100";
    const test::Frame<> f(s.scene(), variant_settings(list));
    ASSERT_EQ(f.status, FrameStatus::ok);
    expect_documented("a shorter one, rounded | " + list + " | mask3_shorter | `" +
                      hash(f.buffers.lights[0].mask, 512) + "` |");
}

}  // namespace
}  // namespace umbra78::shadow
