// umbra78 shadow as a user runs it: on the figures' own buffers, and what it refuses.
#include "tests/support/paths.hpp"
#include "tests/support/program.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace umbra78::tools {
namespace {

using json = nlohmann::ordered_json;
using test::Ran;


struct ShadowCommand : test::Program {
    // The figures' buffers, and their matrix: x, y and z of -2 .. 2 about the vertical axis.
    void capture() const {
        const Ran ran = run("render " + figures_scene + " --no-truth --buffers own");
        ASSERT_EQ(ran.exit_code, 0) << ran.err;
        write("m.txt", "# light at azimuth -100\n"
                       "-0.17364817764610052 0 -1.9696155060082674 0.98480775300413370\n"
                       "0 1 0 0\n"
                       "0.49240387650206685 0 -0.17364817764610052 0.58682408882305026\n"
                       "0 0 0 1\n");
    }
    const std::string on_own = "shadow --observer-depth own/observer_z.npy --light-depth "
                               "own/light_z.pgm --matrix m.txt --depth-format codes ";
};

TEST_F(ShadowCommand, OwnBuffersGiveTheFramesMask) {
    capture();
    const Ran drawn = run("render " + figures_scene + " --no-truth --json --set "
                          "lookup=nearest --set dither=none --set bias=64 --set bias_unit=quanta");
    ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
    const Ran ran = run(on_own + "--set coefficient_bits=16 --set bias=64 --json");
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const json report = parse_json(ran.out), frame = parse_json(drawn.out);
    for (const char* plane : {"observer_z", "light_z", "mask"})
        EXPECT_EQ(report.at("hashes").at(plane), frame.at("hashes").at(plane)) << plane;
    EXPECT_EQ(report.at("observer").at("largest_rounding_quanta"), 0);
    EXPECT_EQ(report.at("error").at("estimated"), true);
    EXPECT_GT(report.at("error").at("false_shadow"), 0.1);
}

TEST_F(ShadowCommand, PrintsAndWritesWhatIsAskedFor) {
    capture();
    const Ran ran = run(on_own + "--least-bias --pixel 80,180 --out m.png --error e.png --spectrum "
                        "s.png --buffers b");
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    for (const char* said : {"observer    own/observer_z.npy: 512 x 512 of u16, ", "\nmask        ",
                             "\nleast bias  ", "Direct3D DepthBias: ", "\npixel (80, 180): ",
                             "\nspectrum    ", "the beat of the two grids"})
        EXPECT_NE(ran.out.find(said), std::string::npos) << said << "\n" << ran.out;
    EXPECT_NE(ran.out.find("against an estimate"), std::string::npos);
    const Ran told = run(on_own + "--truth own/mask.npy");
    ASSERT_EQ(told.exit_code, 0) << told.err;
    EXPECT_EQ(told.out.find("against an estimate"), std::string::npos);
    for (const char* name : {"m.png", "e.png", "s.png", "b/observer_z.npy", "b/mask.pgm"})
        EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
    // What it has written, it reads again.
    const Ran again = run("shadow --observer-depth b/observer_z.npy --light-depth b/light_z.npy "
                          "--matrix m.txt --depth-format codes --json");
    ASSERT_EQ(again.exit_code, 0) << again.err;
    EXPECT_EQ(content(folder / "b/mask.pgm").size(), 512 * 512 + 15u);
}

TEST_F(ShadowCommand, RefusesInOneLine) {
    capture();
    write("raw.f32", "12345678");
    write("short.txt", "1 0 0 0");
    write("zero.txt", "0 0 0 0  0 0 0 0  0 0 0 0  0 0 0 0");
    write("behind.txt", "-1 0 0 0  0 -1 0 0  0 0 -1 0  0 0 -1 -1");
    const std::string other = "shadow --observer-depth own/observer_z.npy --light-depth "
                              "own/light_z.pgm --depth-format codes --matrix ";
    const std::string numbers = "; give 16 numbers, row by row, on the line, in a text file or in "
                                "an NPY";
    const struct {
        std::string arguments, message;
        int exit_code = 1;
    } cases[] = {
        {other + "short.txt", "short.txt: 4 numbers, and a matrix has 16" + numbers},
        {other + "none.txt", "cannot read 'none.txt': there is no such file" + numbers},
        {other + "zero.txt", "zero.txt: all of its 16 numbers are 0; give the light's "
                             "view-projection times the inverse of the observer's"},
        {other + "behind.txt", fmt::format("behind.txt: it gives none of the {} drawn pixels a "
                                           "place before the light; negate its 16 numbers, or give "
                                           "--vectors row", 106772)},
        {on_own + "--set low_pass=1", "low_pass is no setting of the shadow test, which is all "
                                      "that runs on captured buffers; leave out low_pass"},
        {on_own + "--set bias_unit=world",
         "bias_unit: a matrix does not tell how large the light's window is; give the bias in "
         "quanta, of which the depth range has 2^z_bits"},
        {on_own + "--set xy_bits=8",
         "xy_bits 8: the buffers need a frame of 9 bits; leave it out"},
        {on_own + "--pixel 600,0", "pixel 600,0 is not in the observer's buffer of 512 x 512; give "
                                   "x of 0 .. 511 and y of 0 .. 511"},
        {on_own + "--vectors both", "--vectors 'both': give row or column"},
        {on_own + "--truth raw.f32",
         "cannot read 'raw.f32': it is no PGM, NPY or PFM; give --size WIDTHxHEIGHT if it holds "
         "raw numbers"},
        {"shadow --observer-depth raw.f32 --light-depth raw.f32 --size 4x1 --matrix m.txt",
         "cannot read 'raw.f32': 8 bytes of numbers where 4 x 1 of f32 need 16; give the whole "
         "file, or its right size and kind"},
        {on_own + "--convention glide", "--convention: 'glide' is no convention; give d3d, vulkan "
                                        "or opengl; see umbra78 shadow --help", 2},
        {on_own + "--out own/observer_z.npy",
         "cannot write 'own/observer_z.npy': it is an input of this command; name another file"},
    };
    for (const auto& [arguments, message, exit_code] : cases) {
        const Ran ran = run(arguments);
        EXPECT_EQ(ran.exit_code, exit_code) << arguments;
        EXPECT_EQ(ran.err, "umbra78: " + message + "\n");
        EXPECT_EQ(ran.out, "");
    }
}

}  // namespace
}  // namespace umbra78::tools
