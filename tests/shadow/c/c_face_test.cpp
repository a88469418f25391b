// The face for C: what it refuses and by which status, and that it draws what the core draws. The
// goldens themselves are drawn in C by tests/installed/user.c.
#include "fixed/fnv.hpp"
#include "shadow/c/umbra78.h"
#include "shadow/frame/frame.hpp"
#include "shadow/frame/ledger.hpp"
#include "shadow/frame/paper_figures.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <new>
#include <string>
#include <vector>

namespace umbra78::shadow {
namespace {

struct Memory {
    struct alignas(UMBRA78_ALIGNMENT) Line {
        std::byte bytes[UMBRA78_ALIGNMENT];
    };
    std::vector<Line> lines;
    std::size_t bytes;
    explicit Memory(std::size_t size) : lines(size / sizeof(Line) + 1), bytes(size) {}
    void* data() { return lines.data(); }
};

struct CScene {
    Memory memory;
    umbra78_scene* scene = nullptr;
    explicit CScene(const umbra78_capacity& capacity) : memory(umbra78_scene_bytes(&capacity)) {
        EXPECT_EQ(umbra78_make_scene(&capacity, memory.data(), memory.bytes, &scene), UMBRA78_OK);
    }
};

constexpr umbra78_capacity room_for_figures{1, 128, 0, 0};
constexpr umbra78_view straight{0, 0, 0, {0, 0, 0}, 2 << 16, 0, 0, 0};

std::string value_of(const umbra78_scene* scene, const char* key) {
    char text[82];
    return umbra78_get(scene, key, text, sizeof text) == UMBRA78_OK ? text : "";
}

TEST(CFace, DrawsTheCoresFrameAndCountsItsCycles) {
    CScene made(room_for_figures);
    ASSERT_EQ(umbra78_take_figure(made.scene, 6), UMBRA78_OK);
    std::size_t bytes = 0;
    ASSERT_EQ(umbra78_frame_bytes(made.scene, &bytes), UMBRA78_OK);
    Memory memory(bytes);
    umbra78_frame* frame = nullptr;
    ASSERT_EQ(umbra78_render(made.scene, memory.data(), bytes - 1, &frame),
              UMBRA78_MEMORY_TOO_SMALL);
    ASSERT_EQ(umbra78_render(made.scene, memory.data(), bytes, &frame), UMBRA78_OK);
    umbra78_plane picture;
    ASSERT_EQ(umbra78_buffer(frame, "picture", 0, &picture), UMBRA78_OK);
    EXPECT_EQ(picture.bits, 8);
    EXPECT_EQ(picture.size_px, 512);

    const FigurePatches patches = figure_patches();
    const std::array materials{figure_material};
    FrameInputs in{.scene = {patches, materials, figure_view(0),
                             {{figure_view(figure_azimuth_q16)}}},
                   .settings = figure_settings(6), .matrices = {}};
    Memory own(frame_bytes<hw::Depth16>(in.settings.machine, patches.size()));
    auto core = carve<hw::Depth16>({static_cast<std::byte*>(own.data()), own.bytes},
                                   in.settings.machine, patches.size());
    FrameCounts counts;
    ASSERT_EQ(render(in.scene, in.settings, core, in.matrices, counts), FrameStatus::ok);
    fixed::Fnv1a64 hash;
    for (const std::uint8_t v : core.picture) hash.byte(v);
    EXPECT_EQ(umbra78_hash(&picture), hash.value());

    std::uint64_t cycles = 0;
    ASSERT_EQ(umbra78_cycles(frame, &cycles), UMBRA78_OK);
    EXPECT_EQ(cycles, frame_ledger(in, core, counts).total(true));
}

// Two lights, a mesh, a lamp: what the figures have not.
TEST(CFace, DrawsTrianglesUnderALampAndALightInWideDepth) {
    CScene made({1, 1, 4, 1});
    std::uint16_t material = 9;
    const umbra78_material grey{200, 55, 5};
    ASSERT_EQ(umbra78_add_material(made.scene, &grey, &material), UMBRA78_OK);
    EXPECT_EQ(material, 0);
    const std::int32_t origin[3] = {-2 << 16, -1 << 16, -2 << 16}, u[3] = {0, 0, 4 << 16},
                       v[3] = {4 << 16, 0, 0};
    ASSERT_EQ(umbra78_add_plane(made.scene, origin, u, v, 0), UMBRA78_OK);
    const std::int32_t corners[3][3] = {{-1 << 15, 0, 0}, {1 << 15, 0, 0}, {0, 0, 1 << 15}};
    for (std::uint32_t k = 0; k < 3; ++k) {
        std::uint32_t number = 9;
        ASSERT_EQ(umbra78_add_vertex(made.scene, corners[k], &number), UMBRA78_OK);
        EXPECT_EQ(number, k);
    }
    const std::uint32_t vertex[3] = {0, 1, 2}, missing[3] = {0, 1, 3};
    EXPECT_EQ(umbra78_add_triangle(made.scene, missing, 0), UMBRA78_NO_SUCH_PART);
    ASSERT_EQ(umbra78_add_triangle(made.scene, vertex, 0), UMBRA78_OK);
    umbra78_view view = straight;
    view.elevation_q16 = 40 << 16;
    ASSERT_EQ(umbra78_set_observer(made.scene, &view), UMBRA78_OK);
    view.elevation_q16 = 80 << 16;
    ASSERT_EQ(umbra78_add_light(made.scene, &view), UMBRA78_OK);
    view.perspective = 1;
    view.distance_q16 = 5 << 16;
    view.azimuth_q16 = -60 * 65536;
    ASSERT_EQ(umbra78_add_light(made.scene, &view), UMBRA78_OK);
    ASSERT_EQ(umbra78_set(made.scene, "profile", "perspective24"), UMBRA78_OK);
    ASSERT_EQ(umbra78_set(made.scene, "z_bits", "24"), UMBRA78_OK);
    ASSERT_EQ(umbra78_set(made.scene, "xy_bits", "7"), UMBRA78_OK);

    std::size_t bytes = 0;
    ASSERT_EQ(umbra78_frame_bytes(made.scene, &bytes), UMBRA78_OK);
    Memory memory(bytes);
    umbra78_frame* frame = nullptr;
    ASSERT_EQ(umbra78_render(made.scene, memory.data(), bytes, &frame), UMBRA78_OK);
    umbra78_plane maps[2], mask;
    for (std::size_t l = 0; l < 2; ++l)
        ASSERT_EQ(umbra78_buffer(frame, "light_z", l, &maps[l]), UMBRA78_OK);
    EXPECT_EQ(maps[0].bits, 32);
    EXPECT_NE(umbra78_hash(&maps[0]), umbra78_hash(&maps[1]));
    ASSERT_EQ(umbra78_buffer(frame, "mask", 1, &mask), UMBRA78_OK);
    int shadowed = 0;
    for (int at = 0; at < 128 * 128; ++at)
        shadowed += static_cast<const std::uint8_t*>(mask.words)[at] != 0;
    EXPECT_GT(shadowed, 50);
    EXPECT_LT(shadowed, 128 * 64);
    std::uint64_t cycles = 0;
    EXPECT_EQ(umbra78_cycles(frame, &cycles), UMBRA78_OK);
    EXPECT_GT(cycles, 0u);
}

TEST(CFace, ReadsSettingsAsASceneFileDoes) {
    CScene made(room_for_figures);
    const auto set = [&](const char* key, const char* value) {
        return umbra78_set(made.scene, key, value);
    };
    EXPECT_EQ(value_of(made.scene, "bias"), "64");
    EXPECT_EQ(set("bias", "1.5"), UMBRA78_OK);
    EXPECT_EQ(value_of(made.scene, "bias"), "1.5");
    EXPECT_EQ(set("lookup", "bilinear"), UMBRA78_OK);
    EXPECT_EQ(value_of(made.scene, "lookup"), "bilinear");
    EXPECT_EQ(set("lookup", "linear"), UMBRA78_BAD_VALUE);
    EXPECT_EQ(set("look", "bilinear"), UMBRA78_UNKNOWN_SETTING);
    EXPECT_EQ(set("z_bits", "27"), UMBRA78_BAD_VALUE);
    EXPECT_EQ(set("z_bits", "16.2"), UMBRA78_BAD_VALUE);
    EXPECT_EQ(set("z_bits", "x"), UMBRA78_BAD_VALUE);
    EXPECT_EQ(set("multipliers", "3"), UMBRA78_CANNOT_BE_BUILT);
    EXPECT_EQ(value_of(made.scene, "multipliers"), "4");
    EXPECT_EQ(set("profile", "of tomorrow"), UMBRA78_BAD_VALUE);
    char one[1];
    EXPECT_EQ(umbra78_get(made.scene, "bias", one, 1), UMBRA78_MEMORY_TOO_SMALL);
    char two[2];  // a digit and the zero byte fill it
    EXPECT_EQ(umbra78_get(made.scene, "multipliers", two, 1), UMBRA78_MEMORY_TOO_SMALL);
    EXPECT_EQ(umbra78_get(made.scene, "multipliers", two, 2), UMBRA78_OK);
    EXPECT_STREQ(two, "4");

    std::size_t rows = 0;
    umbra78_setting row;
    while (umbra78_setting_at(rows, &row) == UMBRA78_OK) {
        const Setting& of = settings_table()[rows];
        EXPECT_EQ(of.key, row.key);
        EXPECT_EQ(of.meaning, row.meaning);
        for (std::size_t k = 0; k < row.choices; ++k)
            EXPECT_EQ(of.names[k], umbra78_choice_at(rows, k));
        EXPECT_EQ(umbra78_choice_at(rows, row.choices), nullptr);
        ++rows;
    }
    EXPECT_EQ(rows, settings_table().size());
}

TEST(CFace, RefusesWhatTheCoreWouldTrapAt) {
    Memory few(64);
    umbra78_scene* scene = nullptr;
    EXPECT_EQ(umbra78_make_scene(&room_for_figures, few.data(), few.bytes, &scene),
              UMBRA78_MEMORY_TOO_SMALL);
    EXPECT_EQ(umbra78_make_scene(&room_for_figures, static_cast<char*>(few.data()) + 1, 1, &scene),
              UMBRA78_NOT_ALIGNED);
    EXPECT_EQ(scene, nullptr);
    EXPECT_EQ(umbra78_take_figure(nullptr, 3), UMBRA78_NULL_ARGUMENT);

    CScene made(room_for_figures);
    std::size_t bytes = 0;
    EXPECT_EQ(umbra78_frame_bytes(made.scene, &bytes), UMBRA78_BAD_VIEW);  // there is none yet
    EXPECT_EQ(umbra78_take_figure(made.scene, 7), UMBRA78_NO_SUCH_PART);
    const std::int32_t middle[3] = {0, 0, 0}, far[3] = {32766 << 16, 0, 0};
    EXPECT_EQ(umbra78_add_sphere(made.scene, middle, 1 << 16, 0), UMBRA78_NO_SUCH_PART);
    const umbra78_material bright{256, 0, 0};
    EXPECT_EQ(umbra78_add_material(made.scene, &bright, nullptr), UMBRA78_BAD_LEVEL);
    const umbra78_material grey{200, 55, 5};
    ASSERT_EQ(umbra78_add_material(made.scene, &grey, nullptr), UMBRA78_OK);
    EXPECT_EQ(umbra78_add_material(made.scene, &grey, nullptr), UMBRA78_SCENE_FULL);
    EXPECT_EQ(umbra78_add_sphere(made.scene, middle, 0, 0), UMBRA78_OUT_OF_WORLD);
    EXPECT_EQ(umbra78_add_sphere(made.scene, far, 1 << 16, 0), UMBRA78_OUT_OF_WORLD);
    for (int k = 0; k < 4; ++k)
        ASSERT_EQ(umbra78_add_sphere(made.scene, middle, 1 << 16, 0), UMBRA78_OK);
    EXPECT_EQ(umbra78_add_sphere(made.scene, middle, 1 << 16, 0), UMBRA78_SCENE_FULL);

    umbra78_view view = straight;
    view.extent_q16 = 0;
    EXPECT_EQ(umbra78_set_observer(made.scene, &view), UMBRA78_BAD_VIEW);
    view = straight;
    view.near_q16 = 1;
    EXPECT_EQ(umbra78_set_observer(made.scene, &view), UMBRA78_BAD_VIEW);
    view = straight;
    view.perspective = 1;
    EXPECT_EQ(umbra78_add_light(made.scene, &view), UMBRA78_BAD_VIEW);
    ASSERT_EQ(umbra78_set_observer(made.scene, &straight), UMBRA78_OK);
    for (int k = 0; k < 8; ++k) ASSERT_EQ(umbra78_add_light(made.scene, &straight), UMBRA78_OK);
    EXPECT_EQ(umbra78_add_light(made.scene, &straight), UMBRA78_SCENE_FULL);
    ASSERT_EQ(umbra78_set(made.scene, "form", "ground"), UMBRA78_OK);
    EXPECT_EQ(umbra78_frame_bytes(made.scene, &bytes), UMBRA78_NO_GROUND);
}

// A rival may find out only while it draws how much memory it needs.
TEST(CFace, SaysWhatARivalWasShortOf) {
    CScene made(room_for_figures);
    ASSERT_EQ(umbra78_take_figure(made.scene, 5), UMBRA78_OK);
    ASSERT_EQ(umbra78_set(made.scene, "form", "atherton"), UMBRA78_OK);
    ASSERT_EQ(umbra78_set(made.scene, "dice_levels", "1"), UMBRA78_OK);
    ASSERT_EQ(umbra78_set(made.scene, "xy_bits", "7"), UMBRA78_OK);
    umbra78_status status = UMBRA78_MEMORY_TOO_SMALL;
    for (int tries = 0; tries < 20 && status == UMBRA78_MEMORY_TOO_SMALL; ++tries) {
        std::size_t bytes = 0;
        ASSERT_EQ(umbra78_frame_bytes(made.scene, &bytes), UMBRA78_OK);
        Memory memory(bytes);
        umbra78_frame* frame = nullptr;
        status = umbra78_render(made.scene, memory.data(), bytes, &frame);
        umbra78_plane plane;
        if (status == UMBRA78_OK) {
            EXPECT_EQ(umbra78_buffer(frame, "light_z", 0, &plane), UMBRA78_NO_SUCH_BUFFER);
            EXPECT_EQ(umbra78_buffer(frame, "mask", 0, &plane), UMBRA78_OK);
        }
    }
    EXPECT_EQ(status, UMBRA78_OK);
}

TEST(CFace, ExplainsEveryStatus) {
    for (int status = 0; status <= UMBRA78_TOO_WIDE_FOR_RIVAL; ++status) {
        const bool is_one = status <= UMBRA78_NO_SUCH_BUFFER || status >= UMBRA78_NOT_BUILT;
        const std::string text = umbra78_explain(static_cast<umbra78_status>(status));
        EXPECT_EQ(text != "there is no such status", is_one) << status;
    }
    EXPECT_STREQ(umbra78_version(), UMBRA78_VERSION_TEXT);
}

}  // namespace
}  // namespace umbra78::shadow
