// The machine's own buffers, as if they had been captured: its masks, bit for bit.
#include "tools/captured/report.hpp"

#include "raster/view.hpp"
#include "shadow/frame/paper_figures.hpp"
#include "tools/render/render_job.hpp"
#include "tools/scene/scene_file.hpp"
#include "tools/scene/settings_text.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace umbra78::tools::captured {
namespace {

// In double precision, as who captures it has it: nearly as exact as it is long.
double real(const hw::Rational& exact) {
    if (exact.is_zero()) return 0;
    const int shift = 61 - exact.floor_log2();
    std::int64_t word = 0;
    EXPECT_TRUE(exact.round_scaled(shift, fixed::Rounding::half_even, word));
    return std::ldexp(static_cast<double>(word), -shift);
}

NumberImage image_of(const Buffer& buffer) {
    NumberImage image{buffer.name, buffer.size_px, buffer.size_px,
                      buffer.maxval > 65535 ? NumberKind::u32 : NumberKind::u16, buffer.maxval, {}};
    for (std::size_t at = 0; at < buffer.pixels(); ++at) image.values.push_back(buffer.at(at));
    return image;
}

// Between the views' device coordinates, z 0 .. 1: screen pixels over half_px, Y turned over.
Matrix16 device_matrix(const RenderJob& job) {
    const shadow::Scene& scene = job.inputs().scene;
    const hw::MachineSpec& m = job.settings().machine;
    const hw::RationalMatrix screen = raster::observer_to_light(scene.observer, scene.lights[0], m,
                                                                0);
    const hw::Rational half(m.half_px());
    hw::RationalMatrix to{}, from{};
    to[0] = {hw::Rational(1) / half, 0, 0, 0};
    to[1] = {0, hw::Rational(-1) / half, 0, 0};
    to[2] = {0, 0, hw::Rational(1, 2) / half, hw::Rational(1, 2)};
    from[0] = {half, 0, 0, 0};
    from[1] = {0, -half, 0, 0};
    from[2] = {0, 0, half * 2, -half};
    to[3] = from[3] = {0, 0, 0, 1};
    const hw::RationalMatrix whole = raster::multiply(raster::multiply(to, screen), from);
    Matrix16 matrix{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) matrix[4 * i + j] = real(whole[i][j]);
    return matrix;
}

Capture capture_of(const RenderJob& job) {
    Capture capture;
    capture.observer = image_of(job.buffer(Plane::observer_z));
    capture.light = image_of(job.buffer(Plane::light_z));
    capture.matrix = device_matrix(job);
    capture.convention = *find_convention("d3d");
    capture.format = *find_depth_format("codes");
    return capture;
}

TEST(OwnFrame, FiguresThreeAndFourComeOut) {
    for (const int figure : {3, 4}) {
        const shadow::FigurePatches patches = shadow::figure_patches();
        const std::array materials{shadow::figure_material};
        const raster::View observer = shadow::figure_view(0);
        const raster::View light = shadow::figure_view(shadow::figure_azimuth_q16);
        const shadow::Scene scene{patches, materials, observer, {{light}}};
        RenderJob job(scene, shadow::figure_settings(figure));
        job.render();
        Capture capture = capture_of(job);
        capture.set = {"coefficient_bits=16", figure == 3 ? "bias=64" : "bias=192"};
        if (figure == 4)
            capture.set.insert(capture.set.end(), {"lookup=bilinear", "dither=normal4"});
        for (const shadow::Setting& setting : shadow::settings_table())
            if (setting.key == "dither")  // whatever the figure has
                capture.set.push_back("dither=" +
                                      tools::print(setting, setting.get(job.settings())));
        const CapturedFrame frame(capture);
        const std::vector<std::uint8_t> mask = frame.mask();
        const std::span<const std::uint8_t> own = job.bytes(Plane::mask);
        EXPECT_TRUE(std::equal(mask.begin(), mask.end(), own.begin(), own.end())) << figure;
        EXPECT_EQ(hash_of(frame.buffer("mask", std::span<const std::uint8_t>(mask))),
                  hash_of(job.buffer(Plane::mask)));
        EXPECT_EQ(frame.words(std::int64_t{figure == 3 ? 64 : 192} << 16),
                  job.matrices().lights[0].observer_to_light);
    }
}

// A lamp in perspective, 20 bits of Z in words of 32 bits, the receiver's plane.
TEST(OwnFrame, OfALampComesOut) {
    const std::string text = R"(
[observer]
projection = "perspective"
azimuth = 30
elevation = 20
distance = 7
target = [0, 0, 0]
extent = 2
[light]
kind = "point"
position = [-4, 5, 2]
target = [0, 0, 0]
[[sphere]]
centre = [0, 0, 0]
radius = 1
[[plane]]
origin = [-2, -1, -2]
u = [0, 0, 4]
v = [4, 0, 0]
)";
    const std::vector<std::string> set{"xy_bits=7", "z_bits=20", "bias=100", "bias_unit=quanta",
                                       "receiver=plane"};
    const LoadedScene scene = parse_scene(text, "lamp.toml", set);
    RenderJob job(scene.view(), scene.settings);
    job.render();
    Capture capture = capture_of(job);
    capture.set = {"bias=100", "receiver=plane", "coefficient_bits=24"};
    const CapturedFrame frame(capture);
    EXPECT_EQ(frame.spec().z_bits, 20);
    const std::vector<std::uint8_t> mask = frame.mask();
    const std::span<const std::uint8_t> own = job.bytes(Plane::mask);
    EXPECT_TRUE(std::equal(mask.begin(), mask.end(), own.begin(), own.end()));
    EXPECT_GT(std::count(mask.begin(), mask.end(), 255), 500);
    // A fault is seen: another bias is another mask.
    EXPECT_NE(frame.mask(std::int64_t{200000} << 16), mask);
}

}  // namespace
}  // namespace umbra78::tools::captured
