// Files that others wrote, where a Debian package of theirs is installed; a test that finds none
// says which package it wants. Packages may also be unpacked with dpkg -x into a folder that the
// environment variable UMBRA78_MODELS_DATA names; the files are then looked for below it.
#include "tests/support/paths.hpp"
#include "tests/tools/models/model_texts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>

namespace umbra78::tools::test {
namespace {

std::optional<std::string> text_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    return std::string{std::istreambuf_iterator<char>(file), {}};
}

std::optional<std::string> packaged(const std::string& path) {
    const char* root = std::getenv("UMBRA78_MODELS_DATA");
    return text_of((root ? root : "") + ("/usr/share/" + path));
}

ModelData tea_pot(const char* name) {
    const auto text = text_of(std::string(UMBRA78_SOURCE_DIR "/tools/scenes/models/") + name);
    return read_model(text.value_or(""), name).model;
}

double unit(std::int64_t word) { return std::ldexp(static_cast<double>(word), -model_fraction); }

TEST(Packages, GeomviewsTeapot) {
    const auto text = packaged("geomview/geom/teapot.bez");
    if (!text) GTEST_SKIP() << "without the package geomview";
    const ModelResult bez = read_model(*text, "teapot.bez");
    ASSERT_TRUE(bez.ok()) << bez.error;
    // Its x are 0.5 + x / 4 of Newell's, in six digits.
    const auto all_x = [](const ModelData& model, double scale, double shift) {
        std::vector<double> xs;
        for (const ModelPatch& patch : model.patches)
            for (const ModelPoint& p : patch) xs.push_back(unit(p.word[0]) * scale + shift);
        std::sort(xs.begin(), xs.end());
        return xs;
    };
    const std::vector<double> theirs = all_x(bez.model, 4, -2);
    const std::vector<double> ours = all_x(tea_pot("teapot.tea"), 1, 0);
    ASSERT_EQ(theirs.size(), 28u * 16);
    int apart = 0;  // four points beside the lid's pole, which have been put onto it
    for (std::size_t k = 0; k < ours.size(); ++k) {
        EXPECT_NEAR(theirs[k], ours[k], 0.00201) << k;
        apart += std::abs(theirs[k] - ours[k]) > 1e-5 ? 1 : 0;
    }
    EXPECT_EQ(apart, 4);
}

TEST(Packages, GeomviewsRationalFilesAreRefused) {
    const auto text = packaged("geomview/geom/torus.bez");
    if (!text) GTEST_SKIP() << "without the package geomview";
    EXPECT_EQ(read_model(*text, "torus.bez").error,
              "torus.bez:2: 'BEZ224' is rational: its points have weights, by which the machine "
              "would have to divide; write BEZ333");
}

// POV-Ray's teapot has one point that Newell's has not: (2, 1.2, 0.45), for (2, 1.12, 0.45).
TEST(Packages, PovRaysTeapot) {
    const auto text = packaged("doc/povray/examples/advanced/teapot/teapot.inc");
    if (!text) GTEST_SKIP() << "without the package povray-examples";
    std::set<std::array<std::int64_t, 3>> ours;
    for (const ModelPatch& patch : tea_pot("teapot32.tea").patches)
        for (const ModelPoint& p : patch) ours.insert(p.word);
    std::string bpt = "32\n";
    int points = 0;
    for (std::size_t at = text->find('<'); at != text->npos; at = text->find('<', at + 1)) {
        std::string point = text->substr(at + 1, text->find('>', at) - at - 1);
        std::replace(point.begin(), point.end(), ',', ' ');
        bpt += (points++ % 16 == 0 ? "3 3\n" : "") + point + "\n";
    }
    ASSERT_EQ(points, 32 * 16);
    const ModelResult theirs = read_model(bpt, "teapot.bpt");
    ASSERT_TRUE(theirs.ok()) << theirs.error;
    std::set<std::array<std::int64_t, 3>> strange;
    for (const ModelPatch& patch : theirs.model.patches)
        for (const ModelPoint& p : patch)
            if (!ours.contains(p.word)) strange.insert(p.word);
    const ModelResult one_point = read_model("1\n3 3\n" + repeated("2 1.2 0.45\n", 16), "a.bpt");
    EXPECT_EQ(strange, (std::set{one_point.model.patches.at(0)[0].word}));
}

TEST(Packages, TheBunny) {
    const auto text = packaged("glmark2/models/bunny.obj");
    if (!text) GTEST_SKIP() << "without the package glmark2-data";
    const ModelResult bunny = read_model(*text, "bunny.obj");
    ASSERT_TRUE(bunny.ok()) << bunny.error;
    EXPECT_EQ(bunny.model.vertices.size(), 34835u);
    EXPECT_EQ(bunny.model.facets.size() + bunny.model.no_area, 69666u);
}

TEST(Packages, AwkwardFilesOfAssimp) {
    const struct {
        const char* name;
        std::size_t facets, no_area, lines_and_points;
        const char* error;
    } files[] = {
        {"OBJ/spider.obj", 1312, 56, 0, ""},
        {"OBJ/WusonOBJ.obj", 3732, 0, 0, ""},
        {"OBJ/concave_polygon.obj", 64, 0, 0, ""},
        {"OBJ/box_longline.obj", 790, 154, 0, ""},
        {"OBJ/box_without_lineending.obj", 12, 0, 0, ""},
        {"OBJ/testmixed.obj", 12, 0, 12, ""},
        {"OBJ/number_formats.obj", 0, 0, 0,
         ":11: '3.1+e2' is no coordinate; write a decimal, such as -2.5"},
        {"OBJ/box_UTF16BE.obj", 0, 0, 0,
         ":1: '?\?\?' begins no statement of OBJ; remove the line, or begin it with #"},
        {"invalid/empty.obj", 0, 0, 0,
         ":1: the file holds no faces; a surface needs f statements"},
        {"invalid/malformed.obj", 0, 0, 0,
         ":28: '0' is no corner; write v, v/t, v//n or v/t/n, numbers from 1, or from -1 back"},
        {"invalid/malformed2.obj", 0, 0, 0, ":23: a face has 0 corners; give 3 .. 1024"},
    };
    for (const auto& file : files) {
        const auto text = packaged(std::string("assimp/models/") + file.name);
        if (!text) GTEST_SKIP() << "without the package assimp-testmodels";
        const ModelResult result = read_model(*text, "a.obj");
        const std::string error = file.error;
        EXPECT_EQ(result.error, error.empty() ? "" : "a.obj" + error) << file.name;
        if (!result.ok()) continue;
        EXPECT_EQ(result.model.facets.size(), file.facets) << file.name;
        EXPECT_EQ(result.model.no_area, file.no_area) << file.name;
        EXPECT_EQ(result.model.lines_and_points, file.lines_and_points) << file.name;
    }
}

TEST(Packages, StlAndPlyOfAssimp) {
    const struct {
        const char *name, *read_as;
        std::size_t vertices, normals, facets, no_area;
        const char* error;
    } files[] = {
        {"STL/Spider_ascii.stl", "a.stl", 722, 0, 1312, 56, ""},  // as many as in spider.obj
        {"STL/Spider_binary.stl", "a.stl", 722, 0, 1312, 56, ""},
        {"STL/Wuson.stl", "a.stl", 2117, 0, 3732, 0, ""},  // as in WusonOBJ.obj
        {"STL/3DSMaxExport.STL", "a.stl", 1042, 0, 2000, 0, ""},
        {"STL/sphereWithHole.stl", "a.stl", 146, 0, 285, 0, ""},
        {"STL/triangle.stl", "a.stl", 3, 0, 1, 0, ""},
        {"STL/triangle_with_empty_solid.stl", "a.stl", 3, 0, 1, 0, ""},
        {"STL/triangle_with_two_solids.stl", "a.stl", 6, 0, 2, 0, ""},
        {"STL/formatDetection", "a.stl", 3, 0, 1, 0, ""},
        {"PLY/cube.ply", "a.ply", 8, 0, 12, 0, ""},
        {"PLY/cube_binary.ply", "a.ply", 8, 0, 12, 0, ""},
        {"PLY/cube_uv.ply", "a.ply", 24, 24, 12, 0, ""},
        {"PLY/float-color.ply", "a.ply", 3, 0, 1, 0, ""},
        {"PLY/Wuson.ply", "a.ply", 0, 0, 0, 0,
         ":3: 'Created' begins no line of a PLY header; remove the line, or begin it with comment"},
        {"PLY/issue623.ply", "a.ply", 0, 0, 0, 0,
         ":12: the file holds no faces; a surface needs an element face with a list "
         "vertex_indices"},
        {"PLY/pond.0.ply", "a.ply", 0, 0, 0, 0,
         ":14: the file holds no faces; a surface needs an element face with a list "
         "vertex_indices"},
        {"invalid/empty.ply", "a.ply", 0, 0, 0, 0,
         ":1: the file does not begin with the line 'ply'; name another file"},
    };
    for (const auto& file : files) {
        const auto text = packaged(std::string("assimp/models/") + file.name);
        if (!text) GTEST_SKIP() << "without the package assimp-testmodels";
        const ModelResult result = read_model(*text, file.read_as);
        const std::string error = file.error;
        EXPECT_EQ(result.error, error.empty() ? "" : file.read_as + error) << file.name;
        if (!result.ok()) continue;
        EXPECT_EQ(result.model.vertices.size(), file.vertices) << file.name;
        EXPECT_EQ(result.model.normals.size(), file.normals) << file.name;
        EXPECT_EQ(result.model.facets.size(), file.facets) << file.name;
        EXPECT_EQ(result.model.no_area, file.no_area) << file.name;
    }
}

// The same model as text of six decimals and as floats.
TEST(Packages, TextAndBinaryOfAssimpAreTheSameModels) {
    const char* pairs[][2] = {{"STL/Spider_ascii.stl", "STL/Spider_binary.stl"},
                              {"PLY/cube.ply", "PLY/cube_binary.ply"}};
    for (const auto& [text_name, binary_name] : pairs) {
        const auto text = packaged(std::string("assimp/models/") + text_name);
        const auto binary = packaged(std::string("assimp/models/") + binary_name);
        if (!text || !binary) GTEST_SKIP() << "without the package assimp-testmodels";
        const ModelData a = read_model(*text, text_name).model;
        const ModelData b = read_model(*binary, binary_name).model;
        ASSERT_EQ(a.vertices.size(), b.vertices.size()) << text_name;
        for (std::size_t k = 0; k < a.vertices.size(); ++k)
            for (std::size_t axis = 0; axis < 3; ++axis)
                EXPECT_NEAR(unit(a.vertices[k].word[axis]), unit(b.vertices[k].word[axis]), 1e-6);
    }
}

}  // namespace
}  // namespace umbra78::tools::test
