// The named scenes: right answers counted by hand, volumes equal to brute force, and all of it
// equal to tests/goldens/rivals.txt, which tests/independent/rivals.py reads by itself.
#include "tests/shadow/rivals/named_scenes.hpp"
#include "tests/support/paths.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace umbra78::shadow::rivals::test {
namespace {

const char* const golden = UMBRA78_SOURCE_DIR "/tests/goldens/rivals.txt";

Polygons scene_named(const std::string& name) {
    for (const Polygons& p : named_scenes())
        if (p.name == name) return p;
    ADD_FAILURE() << "no scene " << name;
    return {};
}

// A character a pixel: '.' nothing is seen, 'l' lit, 'a' attached shadow, 'c' cast shadow.
std::string picture(const Scene& scene, std::span<const std::uint8_t> mask) {
    std::string text;
    const auto size = static_cast<std::size_t>(scene.setting().space.size_px());
    for (std::size_t at = 0; at < mask.size(); ++at) {
        const std::uint32_t on = scene.shown()[at];
        text += on == nothing_seen              ? '.'
                : mask[at] == lit               ? 'l'
                : scene.setting().attached(on) ? 'a'
                                                : 'c';
        if ((at + 1) % size == 0) text += '\n';
    }
    return text;
}
std::string picture(const std::string& name) {
    const Scene scene(scene_named(name));
    return picture(scene, scene.brute_mask());
}
std::ptrdiff_t count(const std::string& picture, char what) {
    return std::count(picture.begin(), picture.end(), what);
}

TEST(RivalScenes, HaveTheirRightAnswers) {
    EXPECT_EQ(count(picture("edge_on_centres"), 'c'), 16 * 16);
    // 96 wide and 128 high, right of the box: 6 x 8 pixels. No leak, and no acne, where it stands.
    EXPECT_EQ(count(picture("cube_on_floor"), 'c'), 6 * 8);
    EXPECT_EQ(count(picture("cube_on_floor"), 'a'), 0);
    EXPECT_EQ(picture("light_is_eye").find_first_of("ac"), std::string::npos);
    EXPECT_EQ(picture("slanted_plane").find_first_of("ac"), std::string::npos);
    EXPECT_EQ(picture("light_behind_scene").find_first_of("lc"), std::string::npos);
    EXPECT_EQ(picture("one_triangle"), picture("both_windings"));
    EXPECT_EQ(picture("shared_edge"), picture("split_in_four"));
    EXPECT_EQ(count(picture("shared_edge"), 'c'), 6 * 12);
    // Behind the wall's height the shadow goes on to the frame's edge: every row it stands in.
    const std::string thin = picture("thin_wall");
    for (std::size_t row = 8; row < 24; ++row)
        EXPECT_EQ(thin.substr(33 * row + 10, 22), std::string(22, 'c')) << row;
}

// On the wall, which is the first two facets; they shadow each other, too.
TEST(RivalScenes, NestedSheetsAreAllCounted) {
    const Scene scene(scene_named("nested_256"));
    const std::vector<std::uint8_t> mask = scene.brute_mask();
    int pixels = 0;
    for (std::size_t at = 0; at < mask.size(); ++at) {
        if (mask[at] == lit || scene.shown()[at] >= 2) continue;
        const auto column = static_cast<int>(at % 32), row = static_cast<int>(at / 32);
        EXPECT_EQ(surfaces_before(scene.setting(), scene.shown()[at], column, row), 256u);
        ++pixels;
    }
    EXPECT_EQ(pixels, 6 * 8);
}

// The shadow of several casters is the union of theirs, where the same receiver is seen.
TEST(RivalScenes, CastersAddUp) {
    for (const char* name : {"cycle_of_three", "through_each_other", "crossed_bars", "book",
                             "three_layers", "frame_in_frame"}) {
        const Polygons all = scene_named(name);
        const Scene scene(all);
        const std::vector<std::uint8_t> mask = scene.brute_mask();
        std::vector<bool> expected(mask.size());
        for (std::size_t f = 2; f < all.facets.size(); ++f) {  // the first two are the wall
            Polygons one = all;
            one.facets = {all.facets[0], all.facets[1], all.facets[f]};
            const Scene alone(one);
            const std::vector<std::uint8_t> its = alone.brute_mask();
            for (std::size_t at = 0; at < its.size(); ++at)
                if (scene.shown()[at] < 2 && its[at] == dark) expected[at] = true;
        }
        std::size_t dark_pixels = 0;
        for (std::size_t at = 0; at < mask.size(); ++at) {
            if (scene.shown()[at] >= 2) continue;
            EXPECT_EQ(mask[at] == dark, expected[at]) << name << ", pixel " << at;
            dark_pixels += expected[at] ? 1 : 0;
        }
        EXPECT_GT(dark_pixels, 20u) << name;
    }
}

TEST(RivalScenes, VolumesEqualBruteForce) {
    for (const Polygons& p : named_scenes()) {
        const Scene scene(p);
        const Setting& s = scene.setting();
        std::vector<ContourEdge> contour(find_contour(s, {}));
        find_contour(s, contour);
        std::vector<std::int32_t> surfaces(scene.shown().size());
        std::vector<std::uint8_t> mask(surfaces.size());
        VolumeCounts counts;
        count_volumes(s, scene.shown(), contour, surfaces, counts);
        mask_of_counts(s, scene.shown(), surfaces, mask);
        EXPECT_EQ(picture(scene, mask), picture(scene, scene.brute_mask())) << p.name;
    }
}

// All scenes with their pictures, as text.
std::string as_text() {
    std::vector<Polygons> all = named_scenes();
    for (std::uint32_t seed = 0; seed < 60; ++seed) all.push_back(random_polygons(seed));
    std::ostringstream out;
    out << "# The rivals' scenes: shadow/rivals/RIVALS.md says what is in them. Written by the "
           "test\n# RivalScenes.EqualTheGolden with UMBRA78_BLESS_RIVALS set; read by it and by\n"
           "# tests/independent/rivals.py.\n";
    for (const Polygons& p : all) {
        const Scene scene(p);
        const auto centre = [&](const char* what, const Centre& c) {
            out << what << ' ' << c.x << ' ' << c.y << ' ' << c.z << ' ' << c.w << '\n';
        };
        out << "\nscene " << p.name << "\nframe " << p.xy_bits << ' ' << p.fraction << '\n';
        centre("eye", p.eye);
        centre("light", p.light);
        for (const Triangle& f : p.facets) {
            out << "facet";
            for (const std::uint32_t v : f.vertex)
                out << "  " << p.vertices[v].x << ' ' << p.vertices[v].y << ' ' << p.vertices[v].z;
            out << '\n';
        }
        out << picture(scene, scene.brute_mask());
    }
    return out.str();
}

TEST(RivalScenes, EqualTheGolden) {
    const std::string text = as_text();
    if (std::getenv("UMBRA78_BLESS_RIVALS") != nullptr) std::ofstream(golden) << text;
    std::ostringstream expected;
    expected << std::ifstream(golden).rdbuf();
    EXPECT_EQ(text, expected.str()) << "bless it with UMBRA78_BLESS_RIVALS=1";
}

}  // namespace
}  // namespace umbra78::shadow::rivals::test
