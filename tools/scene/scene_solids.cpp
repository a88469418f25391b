#include "tools/scene/scene_solids.hpp"

#include "raster/solids.hpp"
#include "tools/scene/scene_models.hpp"

#include <array>

namespace umbra78::tools {
namespace {

// One table of a solid: what they have in common, and where its patches go.
class SolidReader {
public:
    SolidReader(const TableReader& in, const char* place, const MaterialNames& names,
                LoadedScene& scene)
        : in_(in), scene_(scene), material_(read_material(in, names)),
          placing_{in.needed_point(place), raster::rotation_of(read_turn(in))} {}

    const raster::Placing& placing() const { return placing_; }

    // Appends the Count patches that `make` writes.
    template <std::size_t Count, class Make>
    void append(Make make) {
        std::array<raster::Patch, Count> made;
        if (!make(std::span<raster::Patch, Count>(made)))
            in_.report(in_.node(), in_.title() + " reaches out of the world, -32767 .. 32767; "
                                                 "scale the scene");
        for (raster::Patch& patch : made) {
            patch.material = material_;
            scene_.patches.push_back(patch);
        }
    }

private:
    const TableReader& in_;
    LoadedScene& scene_;
    std::uint16_t material_;
    raster::Placing placing_;
};

std::int32_t length(const TableReader& in, const char* key) {
    return static_cast<std::int32_t>(in.needed_number(key));
}

void read_torus(const TableReader& in, SolidReader solid) {
    const std::int32_t radius = length(in, "radius"), tube = length(in, "tube");
    if (tube > radius)
        in.report(in.need("tube"), in.called("tube") + " is more than 'radius', so that the torus "
                                                       "would cross itself; lower it");
    solid.append<raster::patches_per_torus>([&](auto out) {
        return raster::torus_patches(radius, tube, solid.placing(), out);
    });
}

// A cone from radius `base` to radius `top`, with discs at its ends where it is capped.
void append_cone(SolidReader& solid, std::int32_t base, std::int32_t top, std::int32_t height,
                 bool capped) {
    constexpr std::size_t round = raster::patches_round;
    solid.append<round>([&](auto out) {
        return raster::wall_patches(base, top, height, solid.placing(), out);
    });
    if (!capped) return;
    solid.append<round>([&](auto out) {
        return raster::disc_patches(base, 0, solid.placing(), out);
    });
    if (top == 0) return;
    solid.append<round>([&](auto out) {
        return raster::disc_patches(top, height, solid.placing(), out);
    });
}

void read_cylinder(const TableReader& in, SolidReader solid) {
    const std::int32_t radius = length(in, "radius"), height = length(in, "height");
    append_cone(solid, radius, radius, height, in.choice("capped") == 0);
}

void read_cone(const TableReader& in, SolidReader solid) {
    const std::int32_t radius = length(in, "radius"), height = length(in, "height");
    const auto top = static_cast<std::int32_t>(in.number("top"));
    append_cone(solid, radius, top, height, in.choice("capped") == 0);
}

void read_box(const TableReader& in, SolidReader solid) {
    const raster::World size = in.needed_point("size");
    solid.append<raster::patches_per_box>([&](auto out) {
        return raster::box_patches(size, solid.placing(), out);
    });
}

bool on_one_line(const raster::World* p) {
    using raster::Vector, raster::Wide;
    const auto from_first = [&](int k) {
        return Vector<Wide>{std::int64_t{p[k].x} - p[0].x, std::int64_t{p[k].y} - p[0].y,
                            std::int64_t{p[k].z} - p[0].z};
    };
    return raster::cross(from_first(1), from_first(2)) == Vector<Wide>{};
}

void read_triangle(const TableReader& in, const MaterialNames& names, LoadedScene& scene) {
    raster::Facet facet;
    facet.material = read_material(in, names);
    const char* const corners[] = {"a", "b", "c"};
    for (std::size_t k = 0; k < 3; ++k) {
        facet.vertex[k] = static_cast<std::uint32_t>(scene.vertices.size());
        scene.vertices.push_back(in.needed_point(corners[k]));
    }
    if (!in.error().any() && on_one_line(&scene.vertices[facet.vertex[0]]))
        in.report(in.need("c"), in.title() + " has no area: its corners lie on a line; move one");
    scene.facets.push_back(facet);
}

}  // namespace

void read_solids(const TomlNode& root, const MaterialNames& names, LoadedScene& scene,
                 FirstError& error) {
    const struct {
        const char *name, *place;
        void (*read)(const TableReader&, SolidReader);
    } solids[] = {{"torus", "centre", read_torus}, {"cylinder", "base", read_cylinder},
                  {"cone", "base", read_cone}, {"box", "centre", read_box}};
    for (const auto& solid : solids) {
        for (const TomlNode& node : tables_of(root, solid.name, error)) {
            const TableReader in(node, scene_table(solid.name), error);
            solid.read(in, SolidReader(in, solid.place, names, scene));
            scene.end_object();
        }
    }
    for (const TomlNode& node : tables_of(root, "triangle", error)) {
        read_triangle(TableReader(node, scene_table("triangle"), error), names, scene);
        scene.end_object();
    }
}

}  // namespace umbra78::tools
