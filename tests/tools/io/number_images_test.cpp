// Images of numbers: every format's own example, and damaged ones.
#include "tools/io/number_images.hpp"

#include "tests/support/error_of.hpp"
#include "tools/io/files.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <filesystem>
#include <fstream>

namespace umbra78::tools {
namespace {

using namespace std::string_literals;
using test::error_of;

class NumberImages : public testing::Test {
protected:
    const Path folder = std::filesystem::temp_directory_path() /
                        ("umbra78-numbers-" + std::to_string(getpid()) + "-" +
                         testing::UnitTest::GetInstance()->current_test_info()->name());

    void SetUp() override { std::filesystem::create_directory(folder); }
    void TearDown() override { std::filesystem::remove_all(folder); }

    Path holding(const char* name, const std::string& bytes) const {
        std::ofstream(folder / name, std::ios::binary) << bytes;
        return folder / name;
    }
    std::string error(const char* name, const std::string& bytes,
                      const std::optional<RawNumbers>& raw = std::nullopt) const {
        const Path path = holding(name, bytes);
        return error_of([&] { read_numbers(path, raw); });
    }
    std::string cannot(const char* name, const std::string& rest) const {
        return "cannot read '" + (folder / name).string() + "': " + rest;
    }
};

const std::string formats = "give a binary PGM, an NPY, a one-channel PFM, or raw numbers and "
                            "--size";

std::string float_bytes(float value, bool high_first = false) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    std::string bytes;
    for (int k = 0; k < 4; ++k)
        bytes += static_cast<char>(bits >> (high_first ? 24 - 8 * k : 8 * k));
    return bytes;
}

std::string npy(const std::string& head, const std::string& data) {
    return "\x93NUMPY\x01\0"s + static_cast<char>(head.size()) + "\0"s + head + data;
}
std::string head(const std::string& dtype, const std::string& shape,
                 const std::string& by_columns = "False") {
    return "{'descr': '" + dtype + "', 'fortran_order': " + by_columns + ", 'shape': " + shape +
           ", }\n";
}

TEST_F(NumberImages, EveryKindIsRead) {
    const std::vector<std::uint16_t> samples{1, 2, 3, 4, 5, 65535};
    write_npy(folder / "a.npy", 3, 2, samples);
    write_pgm16(folder / "a.pgm", 3, 2, samples, 65535);
    for (const char* name : {"a.npy", "a.pgm"}) {
        const NumberImage image = read_numbers(folder / name);
        EXPECT_EQ(image.width, 3);
        EXPECT_EQ(image.height, 2);
        EXPECT_EQ(image.kind, NumberKind::u16);
        EXPECT_EQ(image.max, 65535u);
        EXPECT_EQ(image.values, (std::vector<double>{1, 2, 3, 4, 5, 65535}));
    }
    const std::string two = float_bytes(0.25f) + float_bytes(1e-30f);
    EXPECT_EQ(read_numbers(holding("f.npy", npy(head("<f4", "(1, 2)"), two))).values,
              (std::vector<double>{0.25, static_cast<double>(1e-30f)}));
    EXPECT_EQ(read_numbers(holding("b.npy", npy(head(">f4", "(2,)"), float_bytes(0.75f, true) +
                                                                         float_bytes(3, true))))
                  .values,
              (std::vector<double>{0.75, 3}));
    // By columns, and with a side that is 1.
    const NumberImage turned =
        read_numbers(holding("t.npy", npy(head("|u1", "(2, 3, 1)", "True"), "\1\2\3\4\5\6")));
    EXPECT_EQ(turned.width, 3);
    EXPECT_EQ(turned.values, (std::vector<double>{1, 3, 5, 2, 4, 6}));
    // A PFM's rows go upward.
    const std::string rows = float_bytes(1) + float_bytes(2) + float_bytes(3) + float_bytes(4);
    EXPECT_EQ(read_numbers(holding("a.pfm", "Pf\n2 2\n-1.0\n" + rows)).values,
              (std::vector<double>{3, 4, 1, 2}));
    EXPECT_EQ(read_numbers(holding("h.pfm", "Pf\n1 1\n1.0\n" + float_bytes(5, true))).values,
              std::vector<double>{5});
    // Raw, whatever it begins with.
    const NumberImage raw = read_numbers(holding("raw.bin", "P5\x01\x02"),
                                         RawNumbers{2, 1, NumberKind::u16});
    EXPECT_EQ(raw.values, (std::vector<double>{0x3550, 0x0201}));
}

TEST_F(NumberImages, RefuseInOneLine) {
    EXPECT_EQ(error("a.bin", "abc"), cannot("a.bin", "it is no PGM, NPY or PFM; give --size "
                                                     "WIDTHxHEIGHT if it holds raw numbers"));
    EXPECT_EQ(error("a.bin", "abc", RawNumbers{2, 1, NumberKind::f32}),
              cannot("a.bin", "3 bytes of numbers where 2 x 1 of f32 need 8; give the whole file, "
                              "or its right size and kind"));
    EXPECT_EQ(error("a.bin", "abc", RawNumbers{5000, 1, NumberKind::f32}),
              cannot("a.bin", "5000 x 1 numbers; give at most 4096 x 4096 of them, for a frame has "
                              "no more"));
    EXPECT_EQ(error("a.npy", npy(head("<i4", "(1, 1)"), "abcd")),
              cannot("a.npy", "its numbers are of the kind '<i4'; give them as uint8, uint16, "
                              "uint32, float32 or float64, as numpy's astype does"));
    EXPECT_EQ(error("a.npy", npy(head("<f4", "(2, 2, 2)"), "abcd")),
              cannot("a.npy", "its shape is (2, 2, 2); give an array of two dimensions, height and "
                              "width"));
    EXPECT_EQ(error("a.npy", npy(head("<f4", "(2, 2)"), "abcd")),
              cannot("a.npy", "4 bytes of numbers where 2 x 2 of f32 need 16; give the whole file, "
                              "or its right size and kind"));
    EXPECT_EQ(error("a.npy", "\x93NUMPY\x01"), cannot("a.npy", "it ends within its head; " +
                                                                   formats));
    EXPECT_EQ(error("a.npy", npy("{}\n", "")), cannot("a.npy", "its head has no 'descr'; " +
                                                                   formats));
    EXPECT_EQ(error("a.pfm", "Pf\n2 x\n1\n"), cannot("a.pfm", "its height 'x' is no number; " +
                                                                  formats));
    EXPECT_EQ(error("a.pfm", "Pf\n2 2"), cannot("a.pfm", "its head ends before its height; " +
                                                             formats));
    EXPECT_EQ(error("a.pfm", "PF\n2 2\n1\n"),
              cannot("a.pfm", "it is a PFM of three channels; give one of a single channel (Pf)"));
    EXPECT_EQ(error_of([&] { read_numbers(folder / "none.npy"); }),
              cannot("none.npy", "there is no such file; " + formats));
}

// Each part of a file, however it is cut or changed, is read or refused.
TEST_F(NumberImages, NoDamageDoesMore) {
    const std::string whole = npy(head("<f4", "(2, 2)"), std::string(16, 'x'));
    for (std::size_t length = 0; length < whole.size(); ++length)
        EXPECT_NE(error("cut.npy", whole.substr(0, length)), "no error") << length;
    for (std::size_t at = 0; at < whole.size(); ++at)
        for (const char byte : {'\0', '\xff', '9', '('}) {
            std::string changed = whole;
            changed[at] = byte;
            error("changed.npy", changed);
        }
}

}  // namespace
}  // namespace umbra78::tools
