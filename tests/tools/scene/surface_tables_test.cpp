// [[model]] and the solids of a scene file: what they append to the scene, and their errors.
#include "tests/tools/scene/surface_files.hpp"

#include "raster/solids.hpp"
#include "tests/support/paths.hpp"
#include "tools/scene/checks.hpp"
#include "tools/scene/scene_file.hpp"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>

namespace umbra78::tools::test {
namespace {

constexpr std::int32_t one = 1 << 16;
const std::string light = "[light]\nazimuth = -100\n[observer]\nrecentre = \"off\"\n";
const std::string sphere_table = "[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n";

// A patch in the plane z = 0.25 over 0 <= x, y <= 3, its points a unit apart.
std::string patch_file() {
    std::string text = "1\n3 3\n";
    for (int n = 0; n < 16; ++n)
        text += std::to_string(n % 4) + " " + std::to_string(n / 4) + " 0.25\n";
    return text;
}
const std::string tent_file = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nl 1 2\nf 1 2 3\nf 2 4 3\n"
                              "f 1 1 2\n";
const Files files{
    {"a.bpt", patch_file()}, {"tent.obj", tent_file}, {"bad.obj", "v 0 0 0\nf 1 2\n"}};

LoadedScene scene_of(const std::string& tables) {
    SceneResult result = read_with(files, tables + light);
    EXPECT_EQ(result.error, "");
    return std::move(result.scene);
}

TEST(ModelTables, PatchesAreTurnedScaledAndPlaced) {
    const LoadedScene scene = scene_of(sphere_table + "[[material]]\nname = \"clay\"\n"
                                       "[[model]]\nfile = \"a.bpt\"\n"
                                       "[[model]]\nfile = \"a.bpt\"\nmaterial = \"clay\"\n"
                                       "place = [10, 20.5, 30]\nturn = [0, 90, 0]\nscale = 0.5\n"
                                       "[[model]]\nfile = \"a.bpt\"\nup = \"z\"\n");
    ASSERT_EQ(scene.patches.size(), 32u + 3);
    EXPECT_EQ(scene.free_patches, 3u);
    const raster::Patch* models = &scene.patches[32];
    EXPECT_EQ(models[0].control[6], (raster::World{2 * one, one, one / 4}));
    EXPECT_EQ(models[0].material, 1);  // that of surfaces that name none
    EXPECT_EQ(models[1].control[6],    // (2, 1, 1/4) turned is (1/4, 1, -2)
              (raster::World{10 * one + one / 8, 21 * one, 29 * one}));
    EXPECT_EQ(models[1].material, 0);
    EXPECT_EQ(models[2].control[6], (raster::World{2 * one, one / 4, -one}));
    EXPECT_TRUE(scene.facets.empty());
}

// A scale of 0.001 is a word of 48 fraction bits, so that even 2^20 units stay within 2^-16.
TEST(ModelTables, SmallScalesKeepTheirDigits) {
    const Files far{{"far.obj", "v 1048576 0 0\nv 1000000 0 0\nv 0 1 0\nf 1 2 3\n"}};
    const SceneResult result = read_with(
        far, sphere_table + "[[model]]\nfile = \"far.obj\"\nscale = 0.001\n" + light);
    ASSERT_TRUE(result.ok()) << result.error;
    EXPECT_EQ(result.scene.vertices[0].x, 68719477);  // 1048.576 x 65536 = 68719476.7
    EXPECT_EQ(result.scene.vertices[1].x, 1000 * one);
}

TEST(ModelTables, FacetsOfSeveralFilesShareTheScenesVertices) {
    const LoadedScene scene =
        scene_of(sphere_table + "[[triangle]]\na = [0, 0, 0]\nb = [1, 0, 0]\nc = [0, 1, 0]\n"
                 "[[model]]\nfile = \"tent.obj\"\n"
                 "[[model]]\nfile = \"tent.obj\"\nplace = [5, 0, 0]\nshading = \"flat\"\n");
    ASSERT_EQ(scene.facets.size(), 1u + 2 + 2);
    ASSERT_EQ(scene.vertices.size(), 3u + 4 + 4);
    using Numbers = std::array<std::uint32_t, 3>;
    constexpr std::uint32_t flat = raster::Facet::flat;
    EXPECT_EQ(scene.facets[0].vertex, (Numbers{0, 1, 2}));
    EXPECT_EQ(scene.facets[0].normal, (Numbers{flat, flat, flat}));
    EXPECT_EQ(scene.facets[2].vertex, (Numbers{4, 6, 5}));
    EXPECT_EQ(scene.facets[2].normal, (Numbers{1, 3, 2}));
    EXPECT_EQ(scene.facets[4].vertex, (Numbers{8, 10, 9}));
    EXPECT_EQ(scene.facets[4].normal, (Numbers{flat, flat, flat}));
    EXPECT_EQ(scene.normals[0], (std::array<std::int32_t, 3>{0, 0, 16384}));
    EXPECT_EQ(scene.vertices[7], (raster::World{5 * one, 0, 0}));
    EXPECT_EQ(scene.free_patches, 0u);
    const std::vector<std::string> lines = lines_of(scene.warnings);
    ASSERT_EQ(lines.size(), 4u);  // for each of the two models
    EXPECT_EQ(lines[0], "folder/tent.obj: 1 triangles have no area and are left out; remove them "
                        "from the file");
    EXPECT_EQ(lines[1], "folder/tent.obj: 1 lines and points are no surface and are left out; "
                        "make thin faces of them");
    EXPECT_EQ(scene.warnings[0].key, "model_no_area");
    EXPECT_EQ(scene.warnings[3].key, "model_lines");
}

// A scene counted from its target moves the vertices, too.
TEST(ModelTables, VerticesMoveWithTheOrigin) {
    const std::string at = "[[model]]\nfile = \"tent.obj\"\nplace = [1000, 0, 0]\n"
                           "[[sphere]]\ncentre = [1000, 0, 0]\nradius = 1\n"
                           "[light]\nazimuth = 0\n[observer]\ntarget = [1000, 0, 0]\n";
    const SceneResult result = read_with(files, at);
    ASSERT_TRUE(result.ok()) << result.error;
    EXPECT_EQ(result.scene.origin, (raster::World{1000 * one, 0, 0}));
    EXPECT_EQ(result.scene.vertices[1], (raster::World{one, 0, 0}));
}

TEST(SolidTables, EachAppendsItsPatches) {
    const LoadedScene scene = scene_of(
        "[[box]]\ncentre = [1, 2, 3]\nsize = [2, 4, 6]\n"
        "[[cone]]\nbase = [0, 0, 0]\nradius = 1\nheight = 2\n"
        "[[cone]]\nbase = [0, 0, 0]\nradius = 1\nheight = 2\ntop = 0.5\n"
        "[[cylinder]]\nbase = [5, 0, 0]\nradius = 1\nheight = 2\ncapped = \"off\"\n"
        "[[cylinder]]\nbase = [0, 0, 0]\nradius = 1\nheight = 2\n"
        "[[torus]]\ncentre = [0, 1, 0]\nradius = 1\ntube = 0.25\nturn = [90, 0, 0]\n");
    ASSERT_EQ(scene.patches.size(), 64u + 8 + 24 + 16 + 24 + 6);
    EXPECT_EQ(scene.free_patches, scene.patches.size());
    std::array<raster::Patch, raster::patches_per_torus> torus;
    ASSERT_TRUE(raster::torus_patches(one, one / 4,
                                      {{0, one, 0}, raster::rotation_of({90 * one, 0, 0})}, torus));
    for (std::size_t k = 0; k < torus.size(); ++k)
        EXPECT_EQ(scene.patches[k].control, torus[k].control) << k;
    EXPECT_EQ(scene.patches[64].control[0], (raster::World{5 * one, 0, one}));   // open cylinder
    EXPECT_EQ(scene.patches[64].control[12], (raster::World{5 * one, 2 * one, one}));
    EXPECT_EQ(scene.patches[88].control[0], (raster::World{0, 2 * one, 0}));     // its twin's lid
    EXPECT_EQ(scene.patches[96].control[12], (raster::World{0, 2 * one, 0}));    // a cone's tip
    EXPECT_EQ(scene.patches[112].control[12], (raster::World{0, 2 * one, one / 2}));
    EXPECT_EQ(scene.patches[136].control[0], (raster::World{0, 0, 0}));          // the box
    EXPECT_EQ(scene.patches[141].control[15], (raster::World{2 * one, 4 * one, 6 * one}));
}

struct Wrong {
    std::string tables, message;
};

TEST(ModelErrors, EachIsOneLineWithItsPlace) {
    const Wrong cases[] = {
        {"[[model]]\nscale = 2\n",
         "a.toml:1: [[model]] has no 'file'; add file = \"models/teapot.tea\""},
        {"[[model]]\nfile = \"none.obj\"\n",
         "a.toml:2: 'file' in [[model]]: cannot read it; name another"},
        {"[[model]]\nfile = \"bad.obj\"\n",
         "folder/bad.obj:2: a face has 2 corners; give 3 .. 1024"},
        {"[[model]]\nfile = \"a.bpt\"\nscale = 0\n",
         "a.toml:3: 'scale' in [[model]] is 0; its range is 2^-48 .. 32767"},
        {"[[model]]\nfile = \"a.bpt\"\nturn = 90\n",
         "a.toml:3: 'turn' in [[model]] is the number 90; write [x, y, z]"},
        {"[[model]]\nfile = \"a.bpt\"\nup = \"x\"\n",
         "a.toml:3: 'up' in [[model]] is the text 'x'; did you mean 'y'?"},
        {"[[model]]\nfile = \"a.bpt\"\nplace = [32766, 0, 0]\n",
         "folder/a.bpt:5: this point lies at [32768, 0, 0.25] in the world, which ends at -32767 "
         "and 32767; change 'scale' or 'place' of the [[model]] at a.toml:1"},
        {"[[torus]]\ncentre = [0, 0, 0]\nradius = 1\ntube = 1.5\n",
         "a.toml:4: 'tube' in [[torus]] is more than 'radius', so that the torus would cross "
         "itself; lower it"},
        {"[[box]]\ncentre = [32766, 0, 0]\nsize = [3, 1, 1]\n",
         "a.toml:1: [[box]] reaches out of the world, -32767 .. 32767; scale the scene"},
        {"[[cone]]\nbase = [0, 0, 0]\nradius = 1\nheight = 2\ntop = -1\n",
         "a.toml:5: 'top' in [[cone]] is -1; its range is 0 .. 32767"},
        {"[[triangle]]\na = [-32767, 0, 0]\nb = [32767, 1, 0]\nc = [0, 0.5, 0]\n",
         "a.toml:4: [[triangle]] has no area: its corners lie on a line; move one"},
    };
    for (const auto& [tables, message] : cases)
        EXPECT_EQ(read_with(files, tables + light).error, message) << tables;
    EXPECT_EQ(read_scene("[[model]]\nfile = \"a.bpt\"\n" + light, "a.toml", {}).error,
              "a.toml:2: 'file' in [[model]] needs a scene that is a file itself; save the scene, "
              "and name its path");
}

// From files: a model's path counts from the scene's folder, wherever the program runs.
TEST(SceneFolder, ModelsAreFoundFromIt) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::path("scene_folder");
    fs::create_directories(folder / "models");
    const auto write = [&](const char* name, const std::string& text) {
        std::ofstream(folder / name, std::ios::binary) << text;
    };
    write("models/a.bpt", patch_file());
    write("a.toml", "[[model]]\nfile = \"models/a.bpt\"\n" + light);
    write("b.toml", "[[model]]\nfile = \"none.bpt\"\n" + light);
    write("c.toml", "[[model]]\nfile = \"models\"\n" + light);
    EXPECT_EQ(load_scene("scene_folder/a.toml", {}).free_patches, 1u);
    const auto error_of = [](const char* path) -> std::string {
        try {
            load_scene(path, {});
        } catch (const SceneError& error) {
            return error.what();
        }
        return "no error";
    };
    EXPECT_EQ(error_of("scene_folder/b.toml"),
              "scene_folder/b.toml:2: 'file' in [[model]]: cannot read 'scene_folder/none.bpt': No "
              "such file or directory; give the path of a model, from the scene's folder");
    EXPECT_EQ(error_of("scene_folder/c.toml"),
              "scene_folder/c.toml:2: 'file' in [[model]]: cannot read 'scene_folder/models': Is a "
              "directory; give the path of a model, from the scene's folder");
}

// Every scene of the project can be read, and none of their models loses anything.
TEST(ScenesOfTheProject, AreReadWhole) {
    int scenes = 0;
    const std::filesystem::path folder = UMBRA78_SOURCE_DIR "/tools/scenes";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".toml") continue;
        if (entry.path().filename() == "hills.toml") continue;  // its surfaces come by a pipe
        const LoadedScene scene = load_scene(entry.path().string(), {});
        for (const Warning& warning : scene.warnings)
            EXPECT_FALSE(warning.key.starts_with("model_")) << warning.line;
        ++scenes;
    }
    EXPECT_GE(scenes, 8);
}

}  // namespace
}  // namespace umbra78::tools::test
