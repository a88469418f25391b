// Scenes that leave out different things, small enough to be drawn a hundred times.
#pragma once

#include "shadow/frame/frame.hpp"
#include "tests/fixed/boundary.hpp"
#include "tests/shadow/frame/figure_frame.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace umbra78::shadow::test {

struct PlannedScene {
    std::string name;
    std::vector<raster::Patch> patches;
    std::vector<raster::Material> materials{figure_material};
    raster::View observer{}, light{};
    Settings settings{};
    std::vector<raster::World> vertices{};  // of a mesh of flat facets
    std::vector<raster::Facet> facets{};
    std::size_t ground = Scene::no_ground;
    std::vector<raster::Ellipse> blobs{};

    Scene scene() const {
        Scene made{patches, materials, observer, {{light}}, 1, {vertices, {}, facets}};
        made.ground = ground;
        made.blobs = blobs;
        return made;
    }
};

inline PlannedScene planned_figure(std::string name, int figure) {
    const FigurePatches patches = figure_patches();
    PlannedScene p{std::move(name), {patches.begin(), patches.end()}};
    p.observer = figure_view(0);
    p.light = figure_view(figure_azimuth_q16);
    p.settings = figure_settings(figure);
    p.settings.machine.xy_bits = 7;
    return p;
}

// In perspective, `distance` from the target, near and far fitted.
inline void put_eye(PlannedScene& p, raster::View& view, std::int32_t distance) {
    view.projection = raster::Projection::perspective;
    view.distance = distance << 16;
    raster::fit_depth(view, raster::depth_range(view, p.patches));
    p.settings.machine.coefficient_bits = 24;
}

// A tent of two triangles over every second patch: over its corners and a point above its middle.
inline void add_mesh(PlannedScene& p) {
    for (std::size_t k = 0; k < p.patches.size(); k += 2) {
        const auto& c = p.patches[k].control;
        const auto at = static_cast<std::uint32_t>(p.vertices.size());
        const raster::World top{c[5].x + c[5].x / 4, c[5].y + c[5].y / 4, c[5].z + c[5].z / 4};
        p.vertices.insert(p.vertices.end(), {c[0], c[3], c[15], top});
        p.facets.push_back({{at, at + 1, at + 3}});
        p.facets.push_back({{at + 1, at + 2, at + 3}});
    }
}

// Scenes whose shadows fall on a floor, from a light above.
inline void add_grounds(std::vector<PlannedScene>& all) {
    const auto add = [&](const char* name, int azimuth, int elevation) -> PlannedScene& {
        PlannedScene& p = all.emplace_back(planned_figure(name, 6));
        p.settings.form = Form::ground;
        p.light.axes = raster::axes_from_angles(azimuth << 16, elevation << 16);
        p.observer.axes = raster::axes_from_angles(30 << 16, 25 << 16);
        p.ground = p.patches.size();
        p.patches.push_back(raster::plane_patch(
            {{-196608, -127795, 196608}, {393216, 0, 0}, {0, 0, -393216}, 0}));
        return p;
    };
    add("ground", -100, 40);
    {
        PlannedScene& p = add("ground, lamp, facets", 60, 50);
        put_eye(p, p.observer, 6);
        put_eye(p, p.light, 4);
        p.observer.extent /= 2;
        p.settings.surface = raster::PatchForm::diced;
        add_mesh(p);
        std::swap(p.patches[0], p.patches[p.ground]);  // it may stand anywhere
        p.ground = 0;
    }
    for (const char* name : {"blob", "blob, diced"}) {
        PlannedScene& p = add(name, -100, 40);
        p.settings.form = Form::blob;
        p.blobs = {{{0, -127795, 0}, {65536, 0, 20000}, {0, 0, 50000}},
                   {{60000, -127795, -30000}, {30000, 0, 0}, {0, 0, -90000}}};
        if (p.name == "blob") continue;
        p.settings.surface = raster::PatchForm::diced;
        put_eye(p, p.observer, 6);
    }
    {
        PlannedScene& p = add("ground, shadow beside the picture", 90, 5);
        p.observer.extent /= 4;
    }
    {
        PlannedScene& p = add("ground, below it", 0, 60);
        p.patches[p.ground] =
            raster::plane_patch({{-196608, 196608, 196608}, {393216, 0, 0}, {0, 0, -393216}, 0});
    }
}

inline std::vector<PlannedScene> planned_scenes() {
    std::vector<PlannedScene> all;
    const auto add = [&](const char* name, int figure) -> PlannedScene& {
        all.push_back(planned_figure(name, figure));
        return all.back();
    };
    const auto add_floor = [](PlannedScene& p) {
        p.patches.push_back(raster::plane_patch(
            {{-196608, -127795, 196608}, {393216, 0, 0}, {0, 0, -393216}, 0}));
    };
    add("figure 6", 6);
    add("figure 3", 3);
    add("figure 4", 4);
    add_floor(add("floor", 4));
    all.back().observer.axes = raster::axes_from_angles(30 << 16, 20 << 16);
    all.back().settings.low_pass_passes = 2;
    add_floor(add("perspective", 4));
    put_eye(all.back(), all.back().observer, 6);
    {
        PlannedScene& p = add("point light", 6);
        put_eye(p, p.light, 8);
    }
    {
        PlannedScene& p = add("perspective, point light", 4);
        p.settings.dither.shape = hw::DitherShape::none;
        put_eye(p, p.observer, 6);
        put_eye(p, p.light, 8);
    }
    {
        PlannedScene& p = add("rounded first", 4);
        p.settings.machine.divide_order = hw::DivideOrder::round_first;
    }
    add("empty", 6).patches.clear();
    {
        PlannedScene& p = add("no caster", 6);
        p.light.target = {20 << 16, 0, 0};
    }
    {
        // A caster in the light's volume that the observer does not see, and spheres he does.
        PlannedScene& p = add("outside the light", 6);
        p.light.target = {0, 20 << 16, 0};
        p.patches.resize(p.patches.size() + raster::patches_per_sphere);
        raster::sphere_patches({p.light.target, 1 << 16, 0},
                               std::span<raster::Patch, raster::patches_per_sphere>(
                                   p.patches.data() + 128, raster::patches_per_sphere));
        PlannedScene q = p;
        q.name = "outside a point light";
        q.light.axes = raster::axes_from_angles(0, 0);
        put_eye(q, q.light, 4);
        all.push_back(q);
    }
    add("no density", 6).settings.density_q8 = 0;
    add("silent dither", 4).settings.dither.size_q8 = 0;
    add("correct", 6).settings.form = Form::correct;
    {
        PlannedScene& p = add("correct, no caster", 6);
        p.settings.form = Form::correct;
        p.light.target = {20 << 16, 0, 0};
    }
    {
        PlannedScene& p = add("leaves, index, odd roundings", 4);
        p.settings.sampling = raster::Sampling::leaf;
        p.settings.registration = Registration::index;
        p.settings.machine.transform_rounding = fixed::Rounding::half_even;
        p.settings.machine.fraction_bits = 0;
        p.settings.machine.max_accumulator_bits = 24;
    }
    {
        PlannedScene& p = add("percentage, jittered", 6);
        p.settings.lookup = Lookup::percentage;
        p.settings.tap_places = TapPlaces::jittered;
    }
    {
        PlannedScene& p = add("filtered depth, correct", 6);
        p.settings.lookup = Lookup::filtered_depth;
        p.settings.taps = 4;
        p.settings.form = Form::correct;
    }
    // Light and observer see the same.
    for (const bool eye : {false, true}) {
        PlannedScene& p = add(eye ? "same eye" : "same view", 6);
        if (eye) put_eye(p, p.observer, 6);
        p.light = p.observer;
        p.settings.bias_q16 = 0;
    }
    {
        PlannedScene& p = add("same view, correct", 6);
        p.light = p.observer;
        p.settings.form = Form::correct;
    }
    {
        PlannedScene& p = add("same view, AP-120B", 6);
        p.light = p.observer;
        p.settings.arithmetic = Arithmetic::ap120b;
    }
    // Windows that hold a part of the scene, from both kinds of eye, and what patches become.
    for (const auto& [name, form] : {std::pair{"near, diced", raster::PatchForm::diced},
                                     std::pair{"near, subdivided", raster::PatchForm::catmull}}) {
        PlannedScene& p = add(name, 6);
        p.settings.surface = form;
        put_eye(p, p.observer, 6);
        p.observer.extent /= 4;
        p.observer.target.x += 1 << 16;
        p.light.extent /= 2;
        p.light.target.x += 1 << 16;
        add_mesh(p);
    }
    {
        PlannedScene& p = add("diced, no caster", 4);
        p.settings.surface = raster::PatchForm::diced;
        p.light.target = {20 << 16, 0, 0};
    }
    {
        PlannedScene& p = add("diced, front facets, correct", 6);
        p.settings.surface = raster::PatchForm::diced;
        p.settings.facing = raster::Facing::front;
        p.settings.form = Form::correct;
        p.observer.extent /= 3;
        p.observer.target.y += 1 << 16;
    }
    {
        // What a sphere hides of itself from this light is hardly seen, and the bias is large.
        PlannedScene& p = add("no shadow after all", 6);
        p.patches.resize(32);
        p.light.axes = raster::axes_from_angles(1 << 16, 0);
        p.settings.bias_q16 = 4000 << 16;
    }
    {
        PlannedScene& p = add("shadow in few lines", 4);  // of one sphere on the other
        p.settings.low_pass_passes = 3;
        p.settings.dequantize_passes = 6;
        p.patches.resize(64);
    }
    for (const MapDepth depth : {MapDepth::back, MapDepth::midpoint}) {
        PlannedScene& p = add(depth == MapDepth::back ? "same view, back" : "midpoint, slopes", 4);
        p.settings.map_depth = depth;
        p.settings.bias_q16 = 0;
        add_mesh(p);
        if (depth == MapDepth::back) {
            p.light = p.observer;
        } else {
            p.settings.bias_slope_q8 = 300;
            p.settings.bias_clamp_q16 = 500 << 16;
            p.settings.form = Form::correct;
        }
    }
    {
        PlannedScene& p = add("receiver's planes", 4);
        add_floor(p);
        p.settings.receiver = Receiver::plane;
        p.settings.bias_q16 = 2 << 16;
        p.settings.bias_clamp_q16 = 400 << 16;
    }
    {
        PlannedScene& p = add("receivers' normals", 4);
        add_floor(p);
        p.settings.receiver = Receiver::normal;
        p.settings.bias_q16 = 2 << 16;
    }
    for (const Receiver receiver : {Receiver::plane, Receiver::normal}) {
        PlannedScene& p = add(receiver == Receiver::plane ? "kept normals" : "kept, unshaded", 4);
        add_mesh(p);
        p.settings.receiver = receiver;
        p.settings.slope_source = SlopeSource::normals;
        p.settings.bias_q16 = 2 << 16;
        if (receiver == Receiver::normal) p.settings.shading = raster::ShadingRule::none;
    }
    add_grounds(all);
    return all;
}

inline PlannedScene planned_scene(std::string_view name) {
    for (const PlannedScene& p : planned_scenes())
        if (p.name == name) return p;
    ADD_FAILURE() << "no scene " << name;
    return {};
}

// A planned scene's inputs, and memory to draw it in. The scene must outlive it.
struct PlannedFrame {
    // `normals`: with room for them, whether the scene keeps them or not.
    explicit PlannedFrame(const PlannedScene& planned, bool normals = false,
                          const Executor& executor = {})
        : frame(planned.settings.machine, planned.patches.size(),
                shape(planned.settings, normals, executor)),
          inputs{planned.scene(), planned.settings, {}} {
        frame.buffers.executor = executor;
        EXPECT_EQ(load_matrices(inputs.scene, inputs.settings, inputs.matrices),
                  FrameStatus::ok)
            << planned.name;
        if (method_of(inputs).memory != nullptr) make_room(method_of(inputs).memory(inputs));
    }
    void make_room(std::size_t bytes) {
        method_memory.assign(bytes / frame_alignment + 1, {});
        frame.buffers.method_memory = std::as_writable_bytes(std::span(method_memory));
    }
    // Again, with the memory that the method asks for, until it has enough.
    void draw(const FramePlan& plan) {
        draw_frame(inputs, plan, frame.buffers, frame.counts);
        if (method_of(inputs).memory == nullptr) return;
        for (const LightCounts& l : std::span(frame.counts.lights).first(inputs.scene.light_count))
            if (!l.capacity.enough) {
                make_room(l.capacity.needed);
                return draw(plan);
            }
    }

    struct alignas(frame_alignment) Line {
        std::array<std::byte, frame_alignment> bytes;
    };

    static FrameShape shape(const Settings& settings, bool normals,
                            const Executor& executor = {}) {
        FrameShape s(map_layers(settings) == 0 ? 0 : 2);
        s.workers = executor.workers;
        s.worker_stores = true;
        s.normals = normals || reads_normals(settings);
        return s;
    }

    Frame<> frame;
    std::vector<Line> method_memory;
    FrameInputs inputs;
};

}  // namespace umbra78::shadow::test
