// Files: PGM and PNG are read back, NPY is compared byte for byte; a failure names the file and
// leaves nothing behind.
#include "tools/io/files.hpp"

#include "tests/support/error_of.hpp"
#include "tools/io/sheet.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <functional>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <string>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace umbra78::tools {
namespace {

using namespace std::string_literals;
using test::error_of;
namespace fs = std::filesystem;

class Files : public testing::Test {
protected:
    const Path folder = fs::temp_directory_path() /
                        ("umbra78-files-" + std::to_string(getpid()) + "-" +
                         testing::UnitTest::GetInstance()->current_test_info()->name());

    void SetUp() override { fs::create_directory(folder); }
    void TearDown() override { fs::remove_all(folder); }

    std::string content(const char* name) const {
        std::ifstream file(folder / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    Path holding(const char* name, const std::string& bytes) const {
        std::ofstream(folder / name, std::ios::binary) << bytes;
        return folder / name;
    }
    int files() const {
        return static_cast<int>(std::distance(fs::directory_iterator(folder), {}));
    }
};

std::vector<std::uint16_t> ramp16(int count) {
    std::vector<std::uint16_t> samples(count);
    std::iota(samples.begin(), samples.end(), std::uint16_t{65000});
    return samples;
}

TEST_F(Files, APgmIsReadBackAsItWasWritten) {
    const auto samples = ramp16(7 * 5);
    write_pgm16(folder / "a.pgm", 7, 5, samples);
    const Pgm read = read_pgm(folder / "a.pgm");
    EXPECT_EQ(read.width, 7);
    EXPECT_EQ(read.height, 5);
    EXPECT_EQ(read.maxval, 65535);
    EXPECT_EQ(read.samples, samples);

    write_pgm8(folder / "b.pgm", 2, 1, std::vector<std::uint8_t>{7, 255});
    EXPECT_EQ(read_pgm(folder / "b.pgm").samples, (std::vector<std::uint16_t>{7, 255}));
    EXPECT_EQ(files(), 2);
}

TEST_F(Files, PgmBytesAreTheFormats) {
    write_pgm16(folder / "a.pgm", 2, 1, std::vector<std::uint32_t>{0x1234, 10}, 0x2000);
    EXPECT_EQ(content("a.pgm"), "P5\n2 1\n8192\n\x12\x34\x00\x0a"s);
    write_pgm16(folder / "b.pgm", 2, 1, std::vector<std::uint16_t>{9, 10}, 15);
    EXPECT_EQ(content("b.pgm"), "P5\n2 1\n15\n\x09\x0a"s);  // below 256: one byte
}

TEST_F(Files, PgmHeadersMayHoldComments) {
    const Path path = holding("a.pgm", "P5 # a\n#b\n 2#c\n\t1\r\n#\n300\n\x01\x02\x00#"s);
    EXPECT_EQ(read_pgm(path).samples, (std::vector<std::uint16_t>{0x102, '#'}));
}

TEST_F(Files, AMalformedPgmIsNamedWithWhatIsWrong) {
    const struct {
        std::string bytes;
        const char* says;
    } cases[] = {
        {"", "it does not begin with 'P5'"},
        {"P6\n1 1\n255\n\x01", "it does not begin with 'P5'"},
        {"P5", "its width is not a number"},
        {"P51 1\n255\n\x01", "its width is not a number"},
        {"P5 # no end", "its width is not a number"},
        {"P5\n0 1\n255\n", "its width is not a number"},
        {"P5\n-1 1\n255\n\x01", "its width is not a number"},
        {"P5\n99999999999 1\n255\n", "its width is not a number"},
        {"P5\n1 x\n255\n\x01", "its height is not a number"},
        {"P5\n65536 65536\n255\n", "its height is not a number from 1 to 4096"},
        {"P5\n1 1\n0\n\x01", "its maxval is not a number"},
        {"P5\n1 1\n65536\n\x01", "its maxval is not a number"},
        {"P5\n1 1\n255", "no white space follows its maxval"},
        {"P5\n1 1\n255x\x01", "no white space follows its maxval"},
        {"P5\n1 1\n255\n", "0 bytes of samples where 1 x 1 pixels need 1"},
        {"P5\n2 1\n256\n\x01\x01\x01", "3 bytes of samples where 2 x 1 pixels need 4"},
        {"P5\n1 1\n255\n\x01\x02", "2 bytes of samples where 1 x 1 pixels need 1"},
        {"P5\n2 1\n15\n\x01\x10", "sample 16 at x 1, y 0 is above its maxval 15"},
    };
    for (const auto& [bytes, says] : cases) {
        const Path path = holding("bad.pgm", bytes);
        const std::string error = error_of([&] { read_pgm(path); });
        EXPECT_NE(error.find(says), std::string::npos) << error;
        EXPECT_NE(error.find(path.string()), std::string::npos) << error;
    }
    EXPECT_NE(error_of([&] { read_pgm(folder / "none.pgm"); }).find("no such file"),
              std::string::npos);
    EXPECT_NE(error_of([&] { read_pgm(folder); }).find("not a file"), std::string::npos);
}

TEST_F(Files, NpyBytesAreTheFormats) {
    write_npy(folder / "a.npy", 3, 1, std::vector<std::uint16_t>{0x102, 3, 4});
    const std::string a = content("a.npy");
    EXPECT_EQ(a.size(), 128u + 6);
    EXPECT_EQ(a.substr(0, 10), "\x93NUMPY\x01\x00\x76\x00"s);
    EXPECT_EQ(a.substr(10, 60), "{'descr': '<u2', 'fortran_order': False, 'shape': (1, 3), } ");
    EXPECT_EQ(a.substr(127), "\n\x02\x01\x03\x00\x04\x00"s);
    write_npy(folder / "b.npy", 1, 1, std::vector<std::uint8_t>{5});
    EXPECT_EQ(content("b.npy").substr(127), "\n\x05");
    write_npy(folder / "c.npy", 1, 1, std::vector<std::uint32_t>{0x01020304});
    EXPECT_EQ(content("c.npy").substr(127), "\n\x04\x03\x02\x01");
}

TEST_F(Files, APngIsReadBackByAnotherDecoder) {
    std::vector<std::uint8_t> samples(37 * 21 * 3);
    for (std::size_t at = 0; at < samples.size(); ++at)
        samples[at] = static_cast<std::uint8_t>(at * at / 7);
    write_png_gray(folder / "1.png", 37, 21, std::span(samples).first(37 * 21));
    write_png_rgb(folder / "3.png", 37, 21, samples);
    for (const int channels : {1, 3}) {
        const Path path = folder / (std::to_string(channels) + ".png");
        int width = 0, height = 0, found = 0;
        std::uint8_t* read = stbi_load(path.c_str(), &width, &height, &found, 0);
        ASSERT_TRUE(read) << path;
        EXPECT_EQ(std::vector({width, height, found}), std::vector({37, 21, channels}));
        EXPECT_TRUE(std::equal(read, read + 37 * 21 * channels, samples.begin()));
        stbi_image_free(read);
    }
}

TEST_F(Files, AFailureNamesTheFileAndLeavesTheOldOne) {
    const Path path = holding("old.pgm", "old");
    const std::vector<std::uint16_t> samples{1, 300};
    EXPECT_EQ(error_of([&] { write_pgm16(path, 2, 1, samples, 256); }),
              "cannot write '" + path.string() +
                  "': sample 300 at x 1, y 0 is above maxval 256; scale it down, or write NPY");
    EXPECT_NE(error_of([&] { write_pgm16(path, 3, 1, samples); }).find("hand in 3"),
              std::string::npos);
    EXPECT_NE(error_of([&] { write_npy(path, 0, 1, samples); }).find("at least 1"),
              std::string::npos);
    EXPECT_EQ(content("old.pgm"), "old");
    EXPECT_EQ(files(), 1);

    const Path nowhere = folder / "none" / "a.pgm";
    EXPECT_EQ(error_of([&] { write_pgm16(nowhere, 2, 1, samples); }),
              "cannot write '" + nowhere.string() +
                  "': No such file or directory; create its folder first");
    EXPECT_NE(error_of([&] { write_pgm16(folder, 2, 1, samples); }).find("name a file"),
              std::string::npos);
    EXPECT_EQ(files(), 1);
}

TEST_F(Files, AFullDiskLeavesNothingBehind) {
    const auto signal_before = std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const rlimit small{8, before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const std::string error =
        error_of([&] { write_file(folder / "a.bin", std::vector<std::byte>(9)); });
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, signal_before);
    EXPECT_NE(error.find("a.bin': File too large; raise the limit"), std::string::npos) << error;
    EXPECT_EQ(files(), 0);
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    EXPECT_EQ(error_of([&] { write_file("/dev/full", std::vector<std::byte>(9)); }),
              "cannot write '/dev/full': No space left on device; free some space there");
}

// What cannot be taken back is written first: if that fails, no file of the set appears.
TEST_F(Files, ASetAppearsTogether) {
    const std::vector<std::byte> nine(9);
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    {
        FileSet set;
        set.make_folder(folder / "b");
        set.write(folder / "b" / "a", nine);
        set.write("/dev/full", nine);
        EXPECT_NE(error_of([&] { set.commit(); }), "");
    }
    EXPECT_EQ(files(), 0);
    FileSet set;
    set.write(folder / "a", nine);
    EXPECT_NE(error_of([&] { set.write(folder / "." / "a", nine); }).find("another output"),
              std::string::npos);
    set.commit();
    EXPECT_EQ(files(), 1);
}

TEST_F(Files, AFileIsReplacedWithItsModeAndItsLinks) {
    const Path path = holding("a", "old");
    fs::permissions(path, fs::perms(0600));
    fs::create_symlink("a", folder / "b");
    fs::create_symlink("b", folder / "c");
    write_file(folder / "c", std::vector<std::byte>(9));
    EXPECT_EQ(content("a"), std::string(9, '\0'));
    EXPECT_EQ(fs::status(path).permissions(), fs::perms(0600));
    EXPECT_TRUE(fs::is_symlink(folder / "b") && fs::is_symlink(folder / "c"));
    fs::create_symlink("e", folder / "d");
    fs::create_symlink("d", folder / "e");
    EXPECT_NE(error_of([&] { write_file(folder / "e", {}); }).find("levels of symbolic links"),
              std::string::npos);
    EXPECT_EQ(files(), 5);
}

TEST(Sheet, PlacesEveryPictureUnchanged) {
    const std::vector<std::uint8_t> pale(40 * 20, 200), dark(40 * 20, 0);
    const SheetCell cells[] = {{40, 20, pale, {"ab", "c"}}, {40, 20, dark, {}},
                               {40, 20, pale, {"a caption that is too long for its picture"}}};
    const Gray sheet = compose_sheet(cells, {.columns = 2});
    EXPECT_EQ(sheet.pixels.size(), static_cast<std::size_t>(sheet.width) * sheet.height);
    EXPECT_EQ(std::count(sheet.pixels.begin(), sheet.pixels.end(), 200), 2 * 40 * 20);
    EXPECT_EQ(std::count(sheet.pixels.begin(), sheet.pixels.end(), 0), 40 * 20);
    const Gray half = compose_sheet(cells, {.columns = 2, .halved = true});
    EXPECT_EQ(std::count(half.pixels.begin(), half.pixels.end(), 200), 2 * 20 * 10);
    EXPECT_LT(half.width, sheet.width);
    EXPECT_EQ(compose_sheet({}).pixels.size() > 0, true);
    EXPECT_THROW(compose_sheet(std::vector<SheetCell>{{3, 3, pale, {}}}), std::invalid_argument);
}

TEST(Sheet, DrawsTextInItsCell) {
    const std::vector<std::uint8_t> black(200 * 8, 0);
    const SheetCell plain{200, 8, black, {""}}, said{200, 8, black, {"Fig. 3"}};
    const SheetCell odd{200, 8, black, {"\xe2\x80\x93"}}, question{200, 8, black, {"???"}};
    const auto drawn = [](const SheetCell& cell) { return compose_sheet({&cell, 1}).pixels; };
    const auto with = drawn(said), without = drawn(plain);
    ASSERT_EQ(with.size(), without.size());
    EXPECT_NE(with, without);
    EXPECT_EQ(drawn(odd), drawn(question));
}

}  // namespace
}  // namespace umbra78::tools
