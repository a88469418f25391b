// The scenes and views of the variants of hw/MACHINE.md, section 15, by their names there.
#pragma once

#include "fixed/root.hpp"
#include "shadow/frame/frame.hpp"
#include "shadow/frame/paper_figures.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace umbra78::shadow::test {

// The figures' four spheres; `floor` has a plane of 6 by 6 units with them. `mesh` has the first
// sphere, and as facets such a floor, an octahedron with normals and a roof.
struct VariantScene {
    std::vector<raster::Patch> patches;
    std::vector<raster::World> vertices;
    std::vector<std::array<std::int32_t, 3>> normals;
    std::vector<raster::Facet> facets;
    std::vector<raster::Ellipse> blobs;
    std::array<raster::Material, 1> materials{figure_material};

    explicit VariantScene(const std::string& name) {
        const FigurePatches spheres = figure_patches();
        patches.assign(spheres.begin(), spheres.end());
        if (name == "mesh")
            make_mesh();
        else if (name == "floor")
            patches.push_back(raster::plane_patch(
                {{-3 * 65536, -127795, 3 * 65536}, {6 * 65536, 0, 0}, {0, 0, -6 * 65536}, 0}));
        else
            EXPECT_EQ(name, "spheres");
        if (name == "floor") make_blobs();
    }
    // `lights`: sources by their names there, "left + dim".
    Scene scene(const std::string& observer, const std::string& lights) const {
        Scene made{patches, materials, view(observer), {}, 0, mesh()};
        if (patches.size() == 129) made.ground = 128;  // the floor
        made.blobs = blobs;
        for (std::size_t from = 0, to; from < lights.size(); from = to + 3) {
            to = std::min(lights.find(" + ", from), lights.size());
            add_source(lights.substr(from, to - from), made);
        }
        if (made.channels > 1) made.materials = coloured;
        return made;
    }
    raster::Mesh mesh() const { return {vertices, normals, facets}; }

private:
    std::array<raster::Material, 1> coloured{
        {{{215, 140, 60}, figure_material.specular, figure_material.shininess}}};

    void add_source(const std::string& name, Scene& made) const {
        if (name == "bulb") {
            add_bulb(made);
            return;
        }
        struct Named {
            std::string name, view;
            raster::Levels level;
        };
        Named found{name, name, 256};
        if (const std::size_t ramp = name.find(" ramp "); ramp != std::string::npos) {
            add_source(name.substr(0, ramp), made);
            made.sources[made.source_count - 1].ramp_px = std::stoi(name.substr(ramp + 6));
            return;
        }
        for (const Named& n : {Named{"dim", "right", 128}, Named{"red", "sun", {256, 64, 32}},
                               Named{"panel", "lamp", 256}, Named{"scatter", "lamp", 256}})
            if (n.name == name) found = n;
        Source source{made.light_count, 1, view(found.view), found.level};
        made.lights[made.light_count++] = source.place;
        if (name == "panel" || name == "scatter") {
            source.lights = 4;
            for (int k = 0; k < 4; ++k)
                made.lights[source.first_light + static_cast<std::size_t>(k)] =
                    on_panel(source.place, k % 2, k / 2, name == "scatter");
            made.light_count += 3;
        }
        if (!found.level.is_grey()) made.channels = 3;
        made.sources[made.source_count++] = source;
    }
    void add_bulb(Scene& made) const {
        Source source{made.light_count, hw::sector_count, {}, 256, true};
        const raster::World from{10000, 60000, 20000};
        for (const auto axis : {&raster::World::x, &raster::World::y, &raster::World::z})
            for (const int d : {65536, -65536}) {
                raster::World to = from;
                to.*axis += d;
                raster::View v = lamp(from, 65536, 65536, 2048, 524288, to);
                made.lights[made.light_count++] = v;
            }
        source.place = made.lights[source.first_light];
        made.sources[made.source_count++] = source;
    }
    raster::View on_panel(const raster::View& place, int i, int j, bool noisy) const {
        fixed::NoiseRegister noise(78);
        noise.jump(static_cast<std::uint64_t>(16 * (2 * j + i)));
        const auto u = static_cast<std::uint8_t>(noise.take(8));
        const auto v = static_cast<std::uint8_t>(noise.take(8));
        const raster::World at = raster::place_on_area({-327680, 262144, 131072}, place.axes,
                                                       131072,
                                                       noisy ? raster::noise_in_cell(2, i, j, u, v)
                                                             : raster::middle_of_cell(2, i, j));
        const auto square = static_cast<std::uint64_t>(std::int64_t{at.x} * at.x +
                                                       std::int64_t{at.y} * at.y +
                                                       std::int64_t{at.z} * at.z);
        const std::uint64_t root = fixed::isqrt(square);
        return lamp(at, place.extent,
                    static_cast<std::int32_t>(root + (square - root * root > root ? 1 : 0)));
    }
    void make_blobs() {
        for (std::size_t sphere = 0; sphere < 4; ++sphere) {
            raster::EllipseFit fit(patches[128]);
            raster::Surfaces(std::span(patches).subspan(32 * sphere, 32))
                .for_points([&](const raster::World& p) { fit.add(p); });
            EXPECT_TRUE(fit.fit(blobs.emplace_back()));
        }
    }
    void make_mesh() {
        patches.resize(raster::patches_per_sphere);
        vertices = {{-196608, -127795, 196608}, {196608, -127795, 196608},
                    {196608, -127795, -196608}, {-196608, -127795, -196608}};
        facets = {{{0, 1, 2}}, {{0, 2, 3}}, {{10, 11, 12}}};
        const raster::World centre{62259, 20000, 19661};
        constexpr std::int32_t radius = 70000, one = 16384;
        for (const auto& n : {std::array{one, 0, 0}, {-one, 0, 0}, {0, one, 0}, {0, -one, 0},
                              {0, 0, one}, {0, 0, -one}}) {
            normals.push_back(n);
            vertices.push_back({centre.x + n[0] / one * radius, centre.y + n[1] / one * radius,
                                centre.z + n[2] / one * radius});
        }
        for (std::uint32_t k = 0; k < 8; ++k) {
            const std::uint32_t x = k & 1, y = 2 + (k >> 1 & 1), z = 4 + (k >> 2);
            facets.push_back({{4 + x, 4 + y, 4 + z}, {x, y, z}});
        }
        vertices.insert(vertices.end(), {{-150000, 110000, -90000}, {170000, 130000, -120000},
                                         {-20000, 122000, 100000}});
    }
    struct Place {
        int azimuth, elevation;  // degrees
        std::int32_t extent;
    };
    raster::View orthographic(Place p, std::int32_t depth) const {
        raster::View v;
        v.axes = raster::axes_from_angles(p.azimuth * 65536, p.elevation * 65536);
        v.extent = p.extent;
        return in_depths(v, -depth, depth);
    }
    raster::View perspective(Place p, std::int32_t distance, std::int32_t near = 0,
                             std::int32_t far = 0) const {
        raster::View v = orthographic(p, 1);
        v.projection = raster::Projection::perspective;
        v.distance = distance;
        return in_depths(v, near, far);
    }
    raster::View lamp(const raster::World& at, std::int32_t extent, std::int32_t distance,
                      std::int32_t near = 0, std::int32_t far = 0,
                      const raster::World& to = {}) const {
        raster::View v = perspective({0, 0, extent}, distance, 1, 2);
        v.target = to;
        EXPECT_TRUE(raster::axes_from_points(at, to, v.axes));
        return in_depths(v, near, far);
    }
    // Equal depths: they are fitted to the scene.
    raster::View in_depths(raster::View v, std::int32_t near, std::int32_t far) const {
        v.near_depth = near;
        v.far_depth = far;
        const raster::Surfaces surfaces{patches, mesh()};
        if (near == far) raster::fit_depth(v, raster::depth_range(v, surfaces));
        return v;
    }

    raster::View view(const std::string& name) const {
        if (name == "front") return orthographic({0, 0, 131072}, 131072);
        if (name == "left") return orthographic({-100, 0, 131072}, 131072);
        if (name == "right") return orthographic({100, 0, 131072}, 131072);
        if (name == "oblique") return perspective({30, 20, 131072}, 393216);
        if (name == "sun") return orthographic({-100, 30, 262144}, 0);
        if (name == "lamp") return lamp({-327680, 262144, 131072}, 262144, 439629);
        if (name == "near_eye") return perspective({30, 20, 131072}, 98304, 4096, 524288);
        if (name == "clipped") return orthographic({-100, 0, 65536}, 32768);
        if (name == "spot") return orthographic({-100, 30, 65536}, 196608);
        if (name == "inside") return lamp({10000, 60000, 20000}, 131072, 64031, 2048, 524288);
        ADD_FAILURE() << "no view " << name;
        return {};
    }
};

}  // namespace umbra78::shadow::test
