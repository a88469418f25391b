// A stage for one drawing: a view, its matrix, memory and stores, so that a test of the
// rasterizer reads as what it draws. The heap is the tests', not the core's.
#pragma once

#include "raster/draw.hpp"
#include "raster/sinks.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace umbra78::test {

using Patches = std::vector<raster::Patch>;

// Q15.16 words of a value in world units.
inline std::int32_t q16(double v) {
    return static_cast<std::int32_t>(v < 0 ? v * 65536 - 0.5 : v * 65536 + 0.5);
}

inline raster::View orthographic(double azimuth, double elevation, double extent) {
    raster::View v;
    v.axes = raster::axes_from_angles(q16(azimuth), q16(elevation));
    v.extent = q16(extent);
    v.near_depth = -v.extent;
    v.far_depth = v.extent;
    return v;
}

inline raster::View perspective(double azimuth, double elevation, double extent, double distance,
                                double near, double far) {
    raster::View v = orthographic(azimuth, elevation, extent);
    v.projection = raster::Projection::perspective;
    v.distance = q16(distance);
    v.near_depth = q16(near);
    v.far_depth = q16(far);
    return v;
}

inline void add_sphere(Patches& patches, const raster::Sphere& sphere) {
    const std::size_t n = patches.size();
    patches.resize(n + raster::patches_per_sphere);
    raster::sphere_patches(sphere, std::span<raster::Patch, raster::patches_per_sphere>(
                                       patches.data() + n, raster::patches_per_sphere));
}

inline raster::Sphere sphere(double x, double y, double z, double radius) {
    return {{q16(x), q16(y), q16(z)}, q16(radius), 0};
}

inline raster::Plane plane(const std::array<double, 3>& o, const std::array<double, 3>& u,
                           const std::array<double, 3>& v) {
    const auto world = [](const std::array<double, 3>& p) {
        return raster::World{q16(p[0]), q16(p[1]), q16(p[2])};
    };
    return {world(o), world(u), world(v), 0};
}

// A sink that hides nothing, around one that may.
template <raster::Sink S>
struct Unhiding {
    static constexpr bool shades = S::shades;
    S& sink;
    bool hidden(const raster::Footprint&) const { return false; }
    void sample(const raster::Sample& s, std::uint32_t code, const auto* shading) {
        sink.sample(s, code, shading);
    }
};

template <class Depth = hw::Depth16>
class Drawing {
public:
    explicit Drawing(const hw::MachineSpec& spec = {})
        : spec_(spec), depth_(pixels()), intensity_(pixels()), direct_(pixels()) {
        clear();
    }

    void clear() { store().clear(spec_); }

    hw::FrameStore<Depth> store() { return {spec_.xy_bits, depth_, intensity_, direct_}; }
    const std::vector<Depth>& depth() const { return depth_; }
    const std::vector<std::uint8_t>& intensity() const { return intensity_; }
    const std::vector<std::uint8_t>& direct() const { return direct_; }
    Depth depth_at(int x, int y) const {
        return depth_[static_cast<std::size_t>(y * spec_.size_px() + x)];
    }
    std::uint8_t intensity_at(int x, int y) const {
        return intensity_[static_cast<std::size_t>(y * spec_.size_px() + x)];
    }
    bool drawn(int x, int y) const { return depth_at(x, y) != spec_.background(); }
    const hw::MachineSpec& spec() const { return spec_; }

    // Draws into what is there. `light` shades; without it there is depth alone.
    raster::DrawCounts draw(const raster::Surfaces& surfaces, const raster::View& view,
                            raster::Sampling sampling, const raster::View* light = nullptr,
                            std::span<const std::uint32_t> order = {}, bool may_hide = true) {
        const hw::WordFormat object = raster::object_format(surfaces);
        raster::DrawSetup setup{spec_, {}, object, sampling, materials, {}};
        EXPECT_EQ(raster::load_view(view, spec_, object, setup.matrix), hw::LoadStatus::ok);
        setup.form = form;
        setup.dice_levels = dice_levels;
        setup.dice_tolerance = dice_tolerance;
        setup.facing = facing;
        setup.casters = casters;
        setup.blocks = blocks;
        setup.shading.ambient_q8 = ambient_q8;
        setup.shading.viewer = raster::toward_eye(view, object);
        if (light != nullptr) setup.shading.sources[0].toward = raster::toward_eye(*light, object);
        auto frame = store();
        const auto into = [&](auto sink) {
            if (may_hide) return raster::draw(surfaces, order, setup, *memory_, sink);
            Unhiding<decltype(sink)> open{sink};
            return raster::draw(surfaces, order, setup, *memory_, open);
        };
        return light != nullptr ? into(raster::PictureSink<Depth>{frame})
                                : into(raster::DepthSink<Depth>{frame});
    }

    std::vector<raster::Material> materials{raster::Material{}};
    std::int32_t ambient_q8 = 77;
    raster::PatchForm form = raster::PatchForm::catmull;
    int dice_levels = 4;
    std::int64_t dice_tolerance = 0;
    raster::Facing facing = raster::Facing::both;
    raster::Casters casters{};
    const raster::BlockForm* blocks = nullptr;  // the fastest

private:
    std::size_t pixels() const { return std::size_t{1} << (2 * spec_.xy_bits); }

    hw::MachineSpec spec_;
    std::vector<Depth> depth_;
    std::vector<std::uint8_t> intensity_, direct_;
    std::unique_ptr<raster::DrawMemory> memory_ = std::make_unique<raster::DrawMemory>();
};

}  // namespace umbra78::test
