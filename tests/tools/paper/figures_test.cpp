// Figures 1 to 6 and their goldens: equal buffers pass, a difference is reported with its pixel.
#include "tools/paper/goldens.hpp"

#include "tests/support/paths.hpp"
#include "tools/io/text_formats.hpp"
#include "tools/paper/figure_set.hpp"
#include "tools/paper/figure_comparisons.hpp"
#include "tools/paper/scene_pictures.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

namespace umbra78::tools {
namespace {

namespace fs = std::filesystem;

const FigureSet& figures() {
    static const FigureSet drawn;
    return drawn;
}

TEST(FigureSet, SharedStagesChangeNoBit) {
    const LoadedScene scene = figures_scene();
    const auto picture = [&](int number, Plane plane) {
        RenderJob job(scene.view(), shadow::figure_settings(number));
        job.render();
        return hash_of(job.buffer(plane));
    };
    const auto& drawn = figures().figures();
    EXPECT_EQ(drawn[0].hash, picture(1, Plane::intensity));
    EXPECT_EQ(drawn[1].hash, picture(2, Plane::light_z));
    EXPECT_EQ(drawn[2].hash, picture(3, Plane::mask));
    EXPECT_EQ(drawn[3].hash, picture(4, Plane::mask));
    EXPECT_EQ(drawn[4].hash, picture(5, Plane::filtered));
    EXPECT_EQ(drawn[5].hash, picture(6, Plane::picture));
}

TEST(FigureSet, ErrorsCyclesAndBiasAreThePaperFigures) {
    const auto& drawn = figures().figures();
    EXPECT_FALSE(drawn[0].error || drawn[1].error);
    for (std::size_t k = 2; k < drawn.size(); ++k) ASSERT_TRUE(drawn[k].error) << k;
    EXPECT_GT(drawn[2].error->all.false_shadow_rate(), 0.1);
    EXPECT_LT(drawn[3].error->all.false_shadow_rate(), 0.01);
    EXPECT_LT(drawn[3].error->outside_band.false_light_rate(), 0.005);
    EXPECT_LT(drawn[4].error->isolated_pixels, drawn[3].error->isolated_pixels);
    EXPECT_EQ(drawn[2].bias.quanta, 64);
    EXPECT_EQ(drawn[2].bias.texels, 0.5);
    EXPECT_EQ(drawn[2].bias.world, 0.5 / 128);
    // Both views, and the shadow pass's closed form of 474 214 cycles.
    EXPECT_EQ(drawn[2].machine_cycles,
              drawn[0].machine_cycles + drawn[1].machine_cycles + 474'214);
    EXPECT_GT(drawn[4].machine_cycles, drawn[3].machine_cycles);
    EXPECT_GT(drawn[5].machine_cycles, drawn[4].machine_cycles);
}

TEST(FigureSet, DepthAsGrayIsBrightestNearest) {
    const std::vector<std::uint16_t> codes{100, 200, 300, 65535};
    const Buffer buffer{"z", 2, 65535, std::span<const std::uint16_t>(codes)};
    EXPECT_EQ(depth_as_gray(buffer), (std::vector<std::uint8_t>{255, 148, 40, 0}));
}

TEST(Hash, IsOverValuesHighByteFirstWithItsFormat) {
    const std::vector<std::uint8_t> bytes{'f', 'o', 'o', 'b'};
    const std::vector<std::uint16_t> words{0x666F, 0x6F62, 0x6172, 0x0000};
    const Buffer eight{"a", 2, 255, std::span<const std::uint8_t>(bytes)};
    const Buffer sixteen{"b", 2, 65535, std::span<const std::uint16_t>(words)};
    // FNV's own test vector for "foob"; "foobar" and two zero bytes by hand from "foobar".
    EXPECT_EQ(hash_of(eight), "u8:2x2:fnv1a64:dd120e790c2512af");
    std::uint64_t foobar = 0x85944171f73967e8;
    for (int k = 0; k < 2; ++k) foobar *= 0x100000001b3;
    char text[64];
    std::snprintf(text, sizeof text, "u16be:2x2:fnv1a64:%016llx",
                  static_cast<unsigned long long>(foobar));
    EXPECT_EQ(hash_of(sixteen), text);
}

class Goldens : public testing::Test {
protected:
    const fs::path folder = fs::temp_directory_path() /
                            ("umbra78-goldens-" + std::to_string(getpid()));

    void SetUp() override {
        FileSet set;
        set.make_folder(folder);
        bless(folder, figures().buffers(), set);
        set.commit();
    }
    void TearDown() override { fs::remove_all(folder); }

    // Changes one byte, counted from the end of the golden's samples.
    void plant(const char* name, long from_end, char value) const {
        std::fstream file(folder / name, std::ios::in | std::ios::out | std::ios::binary);
        file.seekp(-from_end, std::ios::end);
        file.put(value);
    }
    std::vector<std::string> problems() const {
        std::vector<std::string> found;
        for (const GoldenCheck& result : check(folder, figures().buffers()))
            if (!result.problem.empty()) found.push_back(result.buffer + ": " + result.problem);
        return found;
    }
    using Found = std::vector<std::string>;
};

TEST_F(Goldens, WhatWasBlessedIsRight) {
    EXPECT_EQ(problems(), Found{});
    const Hashes hashes = read_hashes(folder);
    EXPECT_EQ(hashes.size(), 10u);
    EXPECT_EQ(hashes.at("picture6"), figures().figures()[5].hash);
    EXPECT_EQ(read_pgm(folder / "light_z.pgm").maxval, 65535);
    EXPECT_EQ(read_pgm(folder / "mask4.pgm").maxval, 255);
}

TEST_F(Goldens, ADifferenceIsFoundWithItsPixel) {
    plant("mask3.pgm", 512 * 512 - (100 * 512 + 77), 9);
    plant("mask3.pgm", 3, 7);
    plant("observer_z.pgm", 2, 1);  // the last pixel's high byte
    EXPECT_EQ(problems(),
              (Found{"observer_z: first at x 511, y 511: golden 511, drawn 65535; 1 of 262144 "
                     "pixels differ",
                     "mask3: first at x 77, y 100: golden 9, drawn 0; 2 of 262144 pixels differ"}));
    const GoldenCheck result = check(folder, figures().buffers())[3];
    ASSERT_EQ(result.picture.size(), 3u * 512 * 512);
    const std::uint8_t* pixel = &result.picture[3 * (100 * 512 + 77)];
    EXPECT_EQ(std::vector(pixel, pixel + 3), (std::vector<std::uint8_t>{255, 0, 0}));
}

TEST_F(Goldens, WhatIsMissingOrDamagedIsNamed) {
    const fs::path edges = folder / "edges5.pgm", light = folder / "light_z.pgm";
    fs::remove(edges);
    std::ofstream(light) << "P5 1 1 255\nx";
    std::ofstream(folder / "hashes.txt") << "observer_z u16be:0\n";
    const Found found = problems();
    ASSERT_EQ(found.size(), 10u);
    EXPECT_EQ(found[0], "observer_z: its picture is right, but hashes.txt says u16be:0, not " +
                            hash_of(figures().buffers()[0]));
    EXPECT_EQ(found[1], "light_z: the golden has 1 x 1 pixels, the buffer 512 x 512");
    EXPECT_EQ(found[2], "intensity: its picture is right, but hashes.txt has no line for it");
    EXPECT_EQ(found[5], "edges5: cannot read '" + edges.string() +
                            "': there is no such file; give a binary PGM (P5) of 8 or 16 bits");
}

// A golden of what was not drawn now stays.
TEST_F(Goldens, BlessingKeepsWhatWasLeftOut) {
    const std::vector<Buffer> all = figures().buffers();
    FileSet set;
    bless(folder, std::span(all).first(2), set);
    set.commit();
    EXPECT_EQ(read_hashes(folder).size(), all.size());
    EXPECT_EQ(problems(), Found{});
}

// A scene without its package's file is left out with the remedy; the others have all columns.
TEST(ScenePictures, HaveNamesThatFitTheirTable) {
    std::set<std::string_view> names;
    int figures = 0;
    for (const ScenePicture& p : scene_pictures()) {
        EXPECT_TRUE(names.insert(p.name).second) << p.name;
        EXPECT_LE(p.name.size(), 13u);
        EXPECT_LE(p.shows.size(), 34u);
        EXPECT_EQ(p.needs.empty(), p.package.empty()) << p.name;
        EXPECT_TRUE(fs::exists(fs::path(UMBRA78_SOURCE_DIR "/tools/scenes") / p.scene)) << p.scene;
        const fs::path goldens(UMBRA78_SOURCE_DIR "/tests/goldens");
        const bool grey = fs::exists(goldens / (std::string(p.name) + ".pgm"));
        EXPECT_TRUE(grey || fs::exists(goldens / (std::string(p.name) + "_blue.pgm"))) << p.name;
        figures += p.figure ? 1 : 0;
    }
    EXPECT_EQ(figures, 3);
    EXPECT_GE(scene_pictures().size(), 11u);
}

// The command itself: bless, check, and the check of a planted difference.
TEST_F(Goldens, TheCommandChecks) {
    const fs::path out = folder / "out", log = folder / "log";
    const auto run = [&](const std::string& options) {
        const std::string command = UMBRA78_PROGRAM " figures --no-scenes --goldens '" +
                                    folder.string() +
                                    "' --out '" + out.string() + "' " + options + " >'" +
                                    log.string() + "' 2>&1";
        const int status = std::system(command.c_str());
        std::ifstream file(log);
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        return std::pair(WIFEXITED(status) ? WEXITSTATUS(status) : -1, text);
    };
    plant("picture6.pgm", 1, 1);
    const auto differs = run("--check");
    EXPECT_EQ(differs.first, 1);
    EXPECT_NE(differs.second.find("umbra78: picture6 differs from its golden: first at x 511, "
                                  "y 511: golden 1, drawn 0; 1 of 262144 pixels differ; see " +
                                  (out / "diff_picture6.png").string() + "\n"),
              std::string::npos) << differs.second;
    EXPECT_TRUE(fs::exists(out / "diff_picture6.png"));

    const auto blessed = run("--bless");
    EXPECT_EQ(blessed.first, 0);
    EXPECT_NE(blessed.second.find("Goldens written to " + folder.string()), std::string::npos);
    const auto right = run("--check --json");
    EXPECT_EQ(right.first, 0);
    EXPECT_FALSE(fs::exists(out / "diff_picture6.png"));
    const auto report = parse_json(right.second);
    ASSERT_EQ(report["figures"].size(), 6u);
    for (const auto& figure : report["figures"]) {
        EXPECT_EQ(figure["golden"], "ok");
        for (const char* key : {"figure", "shows", "file", "buffer", "hash", "machine_cycles",
                                "simulated_ms", "host_ms", "bias", "error", "settings"})
            EXPECT_TRUE(figure.contains(key)) << key;
        EXPECT_TRUE(fs::exists(out / figure["file"]));
    }
    for (const char* name : {"sheet.png", "highlights.png", "samplings.png", "ap120b.png",
                             "figures.json"})
        EXPECT_TRUE(fs::exists(out / name)) << name;
}

}  // namespace
}  // namespace umbra78::tools
