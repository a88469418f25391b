// The scenes and views of the variants of hw/MACHINE.md, section 15, by their names there.
#pragma once

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
    }
    Scene scene(const std::string& observer, const std::string& light) const {
        return {patches, materials, view(observer), {{view(light)}}, 1, mesh()};
    }
    raster::Mesh mesh() const { return {vertices, normals, facets}; }

private:
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
                      std::int32_t near = 0, std::int32_t far = 0) const {
        raster::View v = perspective({0, 0, extent}, distance, 1, 2);
        EXPECT_TRUE(raster::axes_from_points(at, v.target, v.axes));
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
