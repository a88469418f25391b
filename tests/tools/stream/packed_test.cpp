// Packed files: what is written is what is read, in a block's memory; what is damaged is named.
#include "tools/stream/packed.hpp"

#include "tests/support/paths.hpp"
#include "tools/stream/hills.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <thread>

namespace umbra78::tools {
namespace {

namespace fs = std::filesystem;
using Next = raster::PrimitiveSource::Next;

struct Primitives {
    std::vector<raster::Patch> patches;
    std::vector<raster::World> vertices;
    std::vector<std::array<std::int32_t, 3>> normals{{16384, 0, 0}, {0, -16384, 0}, {0, 0, 16384}};
    std::vector<raster::Facet> facets;

    raster::Surfaces surfaces() const { return {patches, {vertices, normals, facets}}; }
};

// More patches than a block has, and triangles, flat ones and others.
Primitives primitives() {
    Primitives p;
    for (std::int32_t k = 0; k < 2500; ++k) {
        raster::Patch& patch = p.patches.emplace_back();
        for (std::int32_t c = 0; c < 16; ++c)
            patch.control[static_cast<std::size_t>(c)] = {k * 800 + c, -k * 700 - c, c - k};
        patch.material = static_cast<std::uint16_t>(k % 2);
    }
    p.vertices = {{1, 2, 3}, {-2147418112, 2147418112, 0}, {7, 8, 9}, {-1, -2, -3}};
    p.facets = {{{0, 1, 2}}, {{3, 2, 1}, {0, 1, 2}, 1}};
    return p;
}

const std::array<raster::Material, 2> materials{{{200, 55, 5}, {0, 255, 8}}};

std::string text_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

class Packed : public testing::Test {
protected:
    const fs::path path =
        fs::temp_directory_path() /
        fmt::format("umbra78-packed-{}-{}", ::getpid(),
                    testing::UnitTest::GetInstance()->current_test_info()->name());
    void TearDown() override { fs::remove(path); }

    std::string written(std::uint64_t count = 2502) const {
        const Primitives p = primitives();
        PackedWriter writer(path, materials, count);
        writer.add(p.surfaces());
        writer.commit();
        return text_of(path);
    }
    // The error of a file with this content, or "".
    std::string error_of(const std::string& content) const {
        std::ofstream(path, std::ios::binary) << content;
        const OpenedStream opened = open_packed(path.string(), false);
        if (!opened.stream) return opened.error;
        raster::Surfaces batch;
        EXPECT_TRUE(opened.stream->rewind());
        while (opened.stream->next(batch) == Next::batch) continue;
        return opened.stream->error();
    }
};

// Everything that the stream gives, a facet's places and normals written out.
std::vector<std::string> all_of(PrimitiveStream& stream) {
    std::vector<std::string> all;
    raster::Surfaces batch;
    EXPECT_TRUE(stream.rewind());
    Next next = Next::end;
    const auto print = [](const raster::World& w) {
        return fmt::format("({} {} {})", w.x, w.y, w.z);
    };
    while ((next = stream.next(batch)) == Next::batch) {
        EXPECT_LE(batch.count(), max_packed_records);
        for (const raster::Patch& patch : batch.patches) {
            std::string& text = all.emplace_back(fmt::format("patch {}", patch.material));
            for (const raster::World& w : patch.control) text += print(w);
        }
        for (const raster::Facet& facet : batch.mesh.facets) {
            std::string& text = all.emplace_back(fmt::format("facet {}", facet.material));
            for (std::size_t c = 0; c < 3; ++c) {
                text += print(batch.mesh.vertices[facet.vertex[c]]);
                if (facet.normal[c] != raster::Facet::flat)
                    text += fmt::format(" {}", batch.mesh.normals[facet.normal[c]][0]);
            }
        }
    }
    EXPECT_EQ(next, Next::end) << stream.error();
    return all;
}

TEST_F(Packed, ReadsWhatWasWritten) {
    const std::string content = written();
    EXPECT_EQ(content.size(), 20u + 24 + 3 * 8 + 2500 * 196 + 8 + 2 * 56 + 8);
    const OpenedStream opened = open_packed(path.string(), false);
    ASSERT_TRUE(opened.stream) << opened.error;
    PrimitiveStream& stream = *opened.stream;
    EXPECT_EQ(stream.count(), 2502u);
    EXPECT_TRUE(stream.can_rewind());
    ASSERT_EQ(stream.materials().size(), 2u);
    EXPECT_EQ(stream.materials()[1].shininess, 8);
    const std::vector<std::string> all = all_of(stream);
    ASSERT_EQ(all.size(), 2502u);
    EXPECT_EQ(all[2499].substr(0, 30), "patch 1(1999200 -1749300 -2499");
    EXPECT_EQ(all[2500], "facet 0(1 2 3)(-2147418112 2147418112 0)(7 8 9)");
    EXPECT_EQ(all[2501], "facet 1(-1 -2 -3) 16384(7 8 9) 0(-2147418112 2147418112 0) 0");
    const std::uint64_t hash = stream.hash();
    EXPECT_NE(hash, 0u);
    EXPECT_EQ(all_of(stream), all) << "the second pass";
    EXPECT_EQ(stream.hash(), hash);
}

TEST_F(Packed, TakesTheOriginAndRaisesMaterials) {
    written();
    const OpenedStream opened = open_packed(path.string(), false);
    ASSERT_TRUE(opened.stream);
    opened.stream->take_origin({1, 1, 1});
    opened.stream->number_materials_from(10);
    const std::vector<std::string> all = all_of(*opened.stream);
    EXPECT_EQ(all[2500], "facet 10(0 1 2)(-2147418113 2147418111 -1)(6 7 8)");
    opened.stream->take_origin({2147418112, 0, 0});
    raster::Surfaces batch;
    ASSERT_TRUE(opened.stream->rewind());
    Next next = Next::batch;
    while (next == Next::batch) next = opened.stream->next(batch);
    EXPECT_EQ(next, Next::failed);
    EXPECT_NE(opened.stream->error().find("primitive 2500 has the coordinate -32767"),
              std::string::npos)
        << opened.stream->error();
}

TEST_F(Packed, HoldsPlacesToItsLimit) {
    written();
    for (const std::int32_t largest : {2147418112, 2147418111}) {
        const OpenedStream opened = open_packed(path.string(), false);
        ASSERT_TRUE(opened.stream);
        opened.stream->limit(largest);
        raster::Surfaces batch;
        ASSERT_TRUE(opened.stream->rewind());
        Next next = Next::batch;
        while (next == Next::batch) next = opened.stream->next(batch);
        EXPECT_EQ(next, largest == 2147418112 ? Next::end : Next::failed);
    }
}

TEST_F(Packed, WhatIsDamagedIsNamed) {
    const std::string whole = written();
    const auto with = [&](std::size_t at, std::string bytes) {
        std::string damaged = whole;
        return damaged.replace(at, bytes.size(), bytes);
    };
    const std::string huge("\xff\xff\xff\x7f", 4), zero(4, '\0');
    const std::size_t first = 44, last = whole.size() - 8, triangles = last - 2 * 56 - 8;
    const struct {
        std::string content, error;
    } cases[] = {
        {"", " is empty; give a packed file, or the pipe of one"},
        {"v 0 0 0\nv 1 0 0\nf 1 2 3\n", ": it is not a packed file; make one with umbra78 pack"},
        {whole.substr(0, 30), ": it ends at byte 30, before its end block"},
        {whole.substr(0, 1000), ": it ends at byte 1000, before its end block"},
        {whole.substr(0, last), ": it ends at byte 490188, before its end block"},
        {whole + "more", ": something follows its end block"},
        {whole + whole, ": something follows its end block"},
        {with(8, "\x01"), ": it holds 2502 primitives, and says that it holds 2305"},
        {with(16, zero), ": it has 0 materials, if its numbers are little-endian, and 1 .. 65535 "
                         "are possible"},
        {with(16, huge), ": it has 2147483647 materials, if its numbers are little-endian, and"},
        {with(20, huge), ": diffuse of material 0 is 2147483647, and 0 .. 255 are possible"},
        {with(28, "\x09"), ": shininess of material 0 is 9, and 0 .. 8 are possible"},
        {with(first, huge), ": after 0 primitives: a block has kind 1 or 2 and 1 .. 1024 "
                            "records, or kind 0; this one has kind 2147483647 and 1024 records"},
        {with(first + 4, zero), "this one has kind 1 and 0 records"},
        {with(first + 4, huge), "this one has kind 1 and 2147483647 records"},
        {with(first + 8, huge), ": primitive 0 has the coordinate 32768, out of the world"},
        {with(first + 8 + 192, huge),
         ": primitive 0 names material 2147483647, and there are 2, numbered from 0"},
        {with(triangles + 8 + 54, "\x02"),
         ": primitive 2500 names material 2, and there are 2, numbered from 0"},
        {with(triangles + 8 + 56 + 36, "\x01\x01"),
         ": primitive 2501 has a normal that is no unit vector in Q1.14"},
        {with(last + 4, "\x01"), ": its end block has records"},
    };
    for (const auto& c : cases) {
        const std::string error = error_of(c.content);
        EXPECT_NE(error.find(c.error), std::string::npos) << error << "\nexpected " << c.error;
        EXPECT_TRUE(error.starts_with(path.string())) << error;
        EXPECT_EQ(error.find('\n'), std::string::npos);
    }
    EXPECT_EQ(error_of(whole), "");
}

TEST_F(Packed, WhatCannotBeOpenedIsNamed) {
    EXPECT_EQ(open_packed("missing.u78p", false).error,
              "cannot read missing.u78p: No such file or directory; give the path of a packed "
              "file");
    EXPECT_EQ(open_packed("/tmp", false).error,
              "cannot read /tmp: it is a folder; give the path of a packed file");
}

TEST_F(Packed, AFileThatChangesBetweenPassesIsAnError) {
    const std::string whole = written();
    const OpenedStream opened = open_packed(path.string(), false);
    ASSERT_TRUE(opened.stream);
    all_of(*opened.stream);
    std::fstream(path, std::ios::in | std::ios::out | std::ios::binary).seekp(60).put('\x05');
    raster::Surfaces batch;
    ASSERT_TRUE(opened.stream->rewind());
    Next next = Next::batch;
    while (next == Next::batch) next = opened.stream->next(batch);
    EXPECT_EQ(next, Next::failed);
    EXPECT_NE(opened.stream->error().find("it changed between two passes over it"),
              std::string::npos)
        << opened.stream->error();
}

// Two pipes of the same content: one is read once, the other is spooled and read twice.
TEST_F(Packed, APipeIsReadOnceOrSpooled) {
    const std::string whole = written(unknown_count);
    const fs::path pipe = path.string() + "-pipe";
    for (const bool spool : {false, true}) {
        ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
        std::thread writer([&] { std::ofstream(pipe, std::ios::binary) << whole; });
        const OpenedStream opened = open_packed(pipe.string(), spool);
        ASSERT_TRUE(opened.stream) << opened.error;
        EXPECT_EQ(opened.stream->can_rewind(), spool);
        EXPECT_EQ(opened.stream->count(), unknown_count);
        EXPECT_EQ(all_of(*opened.stream).size(), 2502u);
        EXPECT_EQ(opened.stream->rewind(), spool);
        writer.join();
        fs::remove(pipe);
    }
}

TEST_F(Packed, WritesNothingUnlessItIsWhole) {
    {
        PackedWriter writer(path, materials, 7);
        writer.add(primitives().surfaces());
        EXPECT_FALSE(fs::exists(path));
        EXPECT_THROW(writer.commit(), std::runtime_error);
    }
    EXPECT_FALSE(fs::exists(path));
}

// --- hills ---------------------------------------------------------------------------------------

std::vector<raster::Patch> patches_of(const HillsShape& shape) {
    Hills hills(shape);
    std::vector<raster::Patch> all;
    raster::Surfaces batch;
    hills.rewind();
    while (hills.next(batch) == Next::batch)
        all.insert(all.end(), batch.patches.begin(), batch.patches.end());
    return all;
}

// Row by row, each patch has the words of its neighbours on their common border, so there is no
// crack; and the borders of the whole are those of the square.
TEST(Hills, NeighboursShareTheirBorders) {
    for (const std::uint64_t side : {1u, 2u, 7u, 33u}) {
        const std::vector<raster::Patch> all = patches_of({.patches = side * side});
        ASSERT_EQ(all.size(), side * side);
        for (std::size_t k = 0; k < all.size(); ++k)
            for (std::size_t j = 0; j < 4; ++j) {
                if (k % side + 1 < side) {
                    EXPECT_EQ(all[k].control[4 * j + 3], all[k + 1].control[4 * j]);
                }
                if (k / side + 1 < side) {
                    EXPECT_EQ(all[k].control[12 + j], all[k + side].control[j]);
                }
            }
        EXPECT_EQ(all.front().control[0].x, -32 << 16);
        EXPECT_EQ(all.back().control[15].z, 32 << 16);
    }
}

// However finely they are cut, the hills are the same.
TEST(Hills, AreTheSameForEveryNumber) {
    const std::vector<raster::Patch> coarse = patches_of({.patches = 100 * 100});
    const std::vector<raster::Patch> fine = patches_of({.patches = 200 * 200});
    for (std::size_t row = 0; row < 100; row += 9)
        for (std::size_t column = 0; column < 100; column += 9) {
            const raster::World& a = coarse[100 * row + column].control[0];
            const raster::World& b = fine[200 * 2 * row + 2 * column].control[0];
            EXPECT_NEAR(a.x, b.x, 1);
            // A spline of such points flattens the small waves, 3/4 of a unit high, by a tenth.
            EXPECT_NEAR(a.y, b.y, 5000);
        }
}

TEST(Hills, LayersShareThePatches) {
    const std::vector<raster::Patch> all = patches_of({.patches = 10, .layers = 3, .gap = 65536});
    ASSERT_EQ(all.size(), 10u);
    EXPECT_EQ(all[4].control[0].x, all[0].control[0].x);
    EXPECT_EQ(all[4].control[0].y, all[0].control[0].y - 65536);
    EXPECT_EQ(all[9].control[5].y, all[1].control[5].y - 2 * 65536);
}

}  // namespace
}  // namespace umbra78::tools
