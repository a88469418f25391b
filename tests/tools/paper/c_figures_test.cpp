// Figures 7 and 8 by the face for C, from the words of their scene files: the same hashes as the
// program's. Figures 1 to 6 are drawn in C itself, by tests/installed/user.c.
#include "shadow/c/umbra78.h"
#include "tests/support/paths.hpp"
#include "tools/scene/scene_file.hpp"
#include "tools/scene/settings_text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace umbra78::tools {
namespace {

struct alignas(UMBRA78_ALIGNMENT) MemoryLine {
    std::byte bytes[UMBRA78_ALIGNMENT];
};

std::vector<MemoryLine> lines_for(std::size_t bytes) {
    return std::vector<MemoryLine>(bytes / sizeof(MemoryLine) + 1);
}

using Decimals = std::array<double, 3>;

// A place of a scene file, less the origin that its words are taken from.
std::array<std::int32_t, 3> words_of(const Decimals& place, const raster::World& origin) {
    const auto word = [](double p) { return static_cast<std::int32_t>(std::lround(p * 65536)); };
    return {word(place[0]) - origin.x, word(place[1]) - origin.y, word(place[2]) - origin.z};
}

// What the scene files say of their views.
struct ViewsOfFile {
    std::int32_t azimuth, elevation, distance;
    Decimals observed;
    double extent;
    Decimals place, lit;
    double lamp_extent;
};
constexpr ViewsOfFile smile{19, 6, 18, {0.75, -0.65, -0.8}, 3.3, {-2.0, 6.5, 7.8},
                            {0, 0.1, -0.4}, 3.2};
constexpr ViewsOfFile robot{14, 10, 22, {1.95, 3.2, -0.5}, 4.4, {-4.2, 7.3, 8.2},
                            {0.2, 3.3, 0.2}, 3.8};

// The picture's hash, as the goldens have it.
std::string drawn_in_c(const std::string& file, const std::vector<std::string>& set,
                       const ViewsOfFile& views) {
    const LoadedScene from =
        load_scene(UMBRA78_SOURCE_DIR "/tools/scenes/" + file, set);
    const umbra78_capacity capacity{from.materials.size(), from.patches.size(), 0, 0};
    std::vector<MemoryLine> memory = lines_for(umbra78_scene_bytes(&capacity));
    umbra78_scene* scene = nullptr;
    const auto ok = [](umbra78_status status) {
        EXPECT_EQ(status, UMBRA78_OK) << umbra78_explain(status);
    };
    ok(umbra78_make_scene(&capacity, memory.data(), umbra78_scene_bytes(&capacity), &scene));
    for (const raster::Material& m : from.materials) {
        const umbra78_material material{m.diffuse[0], m.specular[0], m.shininess};
        ok(umbra78_add_material(scene, &material, nullptr));
    }
    for (const raster::Patch& patch : from.patches) {
        std::vector<std::int32_t> control;
        for (const raster::World& p : patch.control)
            control.insert(control.end(), {p.x, p.y, p.z});
        ok(umbra78_add_patch(scene, control.data(), patch.material));
    }
    const auto target = words_of(views.observed, from.origin);
    const auto length = [](double world) {
        return static_cast<std::int32_t>(std::lround(world * 65536));
    };
    const umbra78_view observer{1,
                                views.azimuth << 16,
                                views.elevation << 16,
                                {target[0], target[1], target[2]},
                                length(views.extent),
                                views.distance << 16,
                                0,
                                0};
    ok(umbra78_set_observer(scene, &observer));
    ok(umbra78_add_lamp(scene, words_of(views.place, from.origin).data(),
                        words_of(views.lit, from.origin).data(), length(views.lamp_extent)));
    for (const shadow::Setting& s : shadow::settings_table())
        ok(umbra78_set(scene, std::string(s.key).c_str(),
                       print(s, s.get(from.settings)).c_str()));
    std::size_t bytes = 0;
    ok(umbra78_frame_bytes(scene, &bytes));
    std::vector<MemoryLine> room = lines_for(bytes);
    umbra78_frame* frame = nullptr;
    ok(umbra78_render(scene, room.data(), bytes, &frame));
    umbra78_plane picture{};
    ok(umbra78_buffer(frame, "picture", 0, &picture));
    char text[64];
    std::snprintf(text, sizeof text, "u%d:%dx%d:fnv1a64:%016llx", picture.bits, picture.size_px,
                  picture.size_px, static_cast<unsigned long long>(umbra78_hash(&picture)));
    return text;
}

TEST(CFigures, SevenAndEightAreTheirGoldens) {
    std::ifstream lines(UMBRA78_SOURCE_DIR "/tests/goldens/hashes.txt");
    std::map<std::string, std::string> goldens;
    for (std::string name, hash; lines >> name >> hash;) goldens[name] = hash;
    EXPECT_EQ(drawn_in_c("smile.toml", {"density=0"}, smile), goldens.at("fig7a"));
    EXPECT_EQ(drawn_in_c("smile.toml", {}, smile), goldens.at("fig7b"));
    EXPECT_EQ(drawn_in_c("robot.toml", {}, robot), goldens.at("fig8"));
}

TEST(CFigures, ALampIsRefusedWhereItHasNoView) {
    const umbra78_capacity capacity{1, 0, 0, 0};
    std::vector<MemoryLine> memory = lines_for(umbra78_scene_bytes(&capacity));
    umbra78_scene* scene = nullptr;
    ASSERT_EQ(umbra78_make_scene(&capacity, memory.data(), umbra78_scene_bytes(&capacity), &scene),
              UMBRA78_OK);
    const std::int32_t here[3]{0, 0, 65536}, there[3]{0, 65536, 0};
    const std::int32_t out[3]{32767 << 16, 0, 0};
    EXPECT_EQ(umbra78_add_lamp(scene, here, here, 65536), UMBRA78_BAD_VIEW);
    EXPECT_EQ(umbra78_add_lamp(scene, here, there, 0), UMBRA78_BAD_VIEW);
    EXPECT_EQ(umbra78_add_lamp(scene, out, there, 65536), UMBRA78_OUT_OF_WORLD);
    EXPECT_EQ(umbra78_add_lamp(scene, nullptr, there, 65536), UMBRA78_NULL_ARGUMENT);
    EXPECT_EQ(umbra78_add_lamp(scene, here, there, 65536), UMBRA78_OK);
}

}  // namespace
}  // namespace umbra78::tools
