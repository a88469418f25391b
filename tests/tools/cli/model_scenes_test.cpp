// umbra78 render of scenes that name models, as a user runs it.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace umbra78::tools {
namespace {

namespace fs = std::filesystem;
using test::Ran;

struct ModelScenes : test::Program {
    // A scene of one model, whose file holds `text`.
    Ran render(const std::string& file, const std::string& text) {
        write(file.c_str(), text);
        write("a.toml", "[[model]]\nfile = \"" + file +
                            "\"\n[light]\nazimuth = 40\n[settings]\nxy_bits = 6\n");
        return run("render a.toml --out a.png --buffers b");
    }
};

TEST_F(ModelScenes, AMalformedModelIsOneLineAndLeavesNothing) {
    const struct {
        const char *file, *text, *message;
    } cases[] = {
        {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n",
         "a.obj:3: 'nan' is no coordinate; write a decimal, such as -2.5"},
        {"a.bez", "BEZ334\n1 2 3 1\n",
         "a.bez:1: 'BEZ334' is rational: its points have weights, by which the machine would have "
         "to divide; write BEZ333"},
        {"a.tea", "1\n1,2,3\n",
         "a.tea:3: the file ends in the list of patch 1 of 1; add the rest, or correct the counts"},
        {"a.stl", "solid\n",
         "a.stl:2: the file ends in a solid; add the rest, or correct the counts"},
        {"a.ply", "ply\n", "a.ply:1: the file ends in its header; add end_header and the data"},
        {"a.off", "OFF\n",
         "a.off: the name ends like no model's; known: .bpt, .bez, .tea, .obj, .stl, .ply"},
    };
    for (const auto& [file, text, message] : cases) {
        const Ran ran = render(file, text);
        EXPECT_EQ(ran.exit_code, 1);
        EXPECT_EQ(ran.out, "");
        EXPECT_EQ(ran.err, "umbra78: " + std::string(message) + "\n");
        EXPECT_FALSE(fs::exists(folder / "a.png")) << file;
        EXPECT_FALSE(fs::exists(folder / "b")) << file;
    }
}

TEST_F(ModelScenes, AWholeModelIsDrawn) {
    const Ran ran = render("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nl 1 2\n"
                                    "f 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 3 4\n");
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(ran.err, "umbra78: warning: a.obj: 1 lines and points are no surface and are left "
                       "out; make thin faces of them\n");
    EXPECT_TRUE(fs::exists(folder / "a.png"));
}

}  // namespace
}  // namespace umbra78::tools
