// The scene of umbra78.h: its memory, its surfaces and its views, each checked when it is added.
#include "shadow/c/handles.hpp"

#include "shadow/carver.hpp"
#include "shadow/frame/paper_figures.hpp"

#include <cstdint>
#include <new>

namespace {

using namespace umbra78;

constexpr std::int32_t degrees(int whole) { return whole << 16; }

std::size_t carve_scene(const umbra78_capacity& capacity, shadow::Carver carver,
                        umbra78_scene** made) {
    const auto handle = carver.take<umbra78_scene>(1);
    const auto materials = carver.take<raster::Material>(capacity.materials);
    const auto patches = carver.take<raster::Patch>(capacity.patches);
    const auto vertices = carver.take<raster::World>(capacity.vertices);
    const auto facets = carver.take<raster::Facet>(capacity.triangles);
    if (made != nullptr && carver.fits() && !handle.empty()) {
        *made = new (handle.data()) umbra78_scene;
        (*made)->materials = {materials};
        (*made)->patches = {patches};
        (*made)->vertices = {vertices};
        (*made)->facets = {facets};
    }
    return carver.used();
}

bool in_world(std::int64_t word) {
    return word >= -raster::max_world && word <= raster::max_world;
}
bool in_world(const std::int32_t p[3]) {
    return in_world(p[0]) && in_world(p[1]) && in_world(p[2]);
}
raster::World world(const std::int32_t p[3]) { return {p[0], p[1], p[2]}; }

bool has(const umbra78_scene& scene, std::uint16_t material) {
    return material < scene.materials.used;
}

bool is_level(std::int32_t level) { return level >= 0 && level <= 255; }

// A light is a source of its own.
bool has_room_for_light(const umbra78_scene& scene) {
    return scene.light_count < shadow::max_lights && scene.light_count < raster::max_sources;
}

// Degrees from -360 to 360, elevations up to straight up or down; depths as a scene file has them.
umbra78_status read(const umbra78_view& from, umbra78_placed_view& to) {
    constexpr std::int64_t max_depth = std::int64_t{4} * (32767 << 16);
    const bool perspective = from.perspective != 0;
    const bool fitted = from.near_q16 == 0 && from.far_q16 == 0;
    if (!in_world(from.target_q16)) return UMBRA78_OUT_OF_WORLD;
    if (from.azimuth_q16 < degrees(-360) || from.azimuth_q16 > degrees(360) ||
        from.elevation_q16 < degrees(-90) || from.elevation_q16 > degrees(90) ||
        from.extent_q16 <= 0 || !in_world(from.extent_q16) ||
        (perspective && (from.distance_q16 <= 0 || !in_world(from.distance_q16))))
        return UMBRA78_BAD_VIEW;
    if (!fitted && (from.near_q16 >= from.far_q16 || from.near_q16 < -max_depth ||
                    from.far_q16 > max_depth || (perspective && from.near_q16 <= 0)))
        return UMBRA78_BAD_VIEW;
    raster::View view;
    view.projection =
        perspective ? raster::Projection::perspective : raster::Projection::orthographic;
    view.axes = raster::axes_from_angles(from.azimuth_q16, from.elevation_q16);
    view.target = world(from.target_q16);
    view.extent = from.extent_q16;
    view.distance = perspective ? from.distance_q16 : 0;
    view.near_depth = from.near_q16;
    view.far_depth = from.far_q16;
    to = {view, fitted, true};
    return UMBRA78_OK;
}

}  // namespace

extern "C" {

size_t umbra78_scene_bytes(const umbra78_capacity* capacity) {
    if (capacity == nullptr) return 0;
    return carve_scene(*capacity, shadow::Carver(nullptr), nullptr);
}

umbra78_status umbra78_make_scene(const umbra78_capacity* capacity, void* memory, size_t bytes,
                                  umbra78_scene** scene) {
    if (capacity == nullptr || memory == nullptr || scene == nullptr)
        return UMBRA78_NULL_ARGUMENT;
    *scene = nullptr;
    if (reinterpret_cast<std::uintptr_t>(memory) % UMBRA78_ALIGNMENT != 0)
        return UMBRA78_NOT_ALIGNED;
    if (umbra78_scene_bytes(capacity) > bytes) return UMBRA78_MEMORY_TOO_SMALL;
    carve_scene(*capacity, shadow::Carver({static_cast<std::byte*>(memory), bytes}), scene);
    return UMBRA78_OK;
}

umbra78_status umbra78_add_material(umbra78_scene* scene, const umbra78_material* material,
                                    uint16_t* number) {
    if (scene == nullptr || material == nullptr) return UMBRA78_NULL_ARGUMENT;
    if (!is_level(material->diffuse) || !is_level(material->specular) ||
        material->shininess < 0 || material->shininess > 8)
        return UMBRA78_BAD_LEVEL;
    if (scene->materials.full() || scene->materials.used == UINT16_MAX)
        return UMBRA78_SCENE_FULL;
    if (number != nullptr) *number = static_cast<std::uint16_t>(scene->materials.used);
    scene->materials.add() = {material->diffuse, material->specular, material->shininess};
    return UMBRA78_OK;
}

umbra78_status umbra78_add_sphere(umbra78_scene* scene, const int32_t centre_q16[3],
                                  int32_t radius_q16, uint16_t material) {
    if (scene == nullptr || centre_q16 == nullptr) return UMBRA78_NULL_ARGUMENT;
    if (!has(*scene, material)) return UMBRA78_NO_SUCH_PART;
    for (int a = 0; a < 3; ++a)  // the handles of its patches' corners reach a tenth beyond
        for (const std::int64_t side : {-1, 1})
            if (radius_q16 <= 0 ||
                !in_world(centre_q16[a] + side * (std::int64_t{radius_q16} * 5 / 4)))
                return UMBRA78_OUT_OF_WORLD;
    constexpr std::size_t n = raster::patches_per_sphere;
    if (scene->patches.room.size() - scene->patches.used < n) return UMBRA78_SCENE_FULL;
    const std::span<raster::Patch, n> patches(scene->patches.room.data() + scene->patches.used, n);
    for (raster::Patch& patch : patches) new (&patch) raster::Patch;
    raster::sphere_patches({world(centre_q16), radius_q16, material}, patches);
    scene->patches.used += n;
    return UMBRA78_OK;
}

umbra78_status umbra78_add_plane(umbra78_scene* scene, const int32_t origin_q16[3],
                                 const int32_t u_q16[3], const int32_t v_q16[3],
                                 uint16_t material) {
    if (scene == nullptr || origin_q16 == nullptr || u_q16 == nullptr || v_q16 == nullptr)
        return UMBRA78_NULL_ARGUMENT;
    if (!has(*scene, material)) return UMBRA78_NO_SUCH_PART;
    for (int a = 0; a < 3; ++a)
        for (const std::int64_t s : {0, 1})
            for (const std::int64_t t : {0, 1})
                if (!in_world(origin_q16[a] + s * u_q16[a] + t * v_q16[a]))
                    return UMBRA78_OUT_OF_WORLD;
    if (scene->patches.full()) return UMBRA78_SCENE_FULL;
    scene->patches.add() =
        raster::plane_patch({world(origin_q16), world(u_q16), world(v_q16), material});
    return UMBRA78_OK;
}

umbra78_status umbra78_add_patch(umbra78_scene* scene, const int32_t control_q16[48],
                                 uint16_t material) {
    if (scene == nullptr || control_q16 == nullptr) return UMBRA78_NULL_ARGUMENT;
    if (!has(*scene, material)) return UMBRA78_NO_SUCH_PART;
    raster::Patch patch;
    patch.material = material;
    for (std::size_t p = 0; p < patch.control.size(); ++p) {
        if (!in_world(control_q16 + 3 * p)) return UMBRA78_OUT_OF_WORLD;
        patch.control[p] = world(control_q16 + 3 * p);
    }
    if (scene->patches.full()) return UMBRA78_SCENE_FULL;
    scene->patches.add() = patch;
    return UMBRA78_OK;
}

umbra78_status umbra78_add_vertex(umbra78_scene* scene, const int32_t place_q16[3],
                                  uint32_t* number) {
    if (scene == nullptr || place_q16 == nullptr) return UMBRA78_NULL_ARGUMENT;
    if (!in_world(place_q16)) return UMBRA78_OUT_OF_WORLD;
    if (scene->vertices.full()) return UMBRA78_SCENE_FULL;
    if (number != nullptr) *number = static_cast<std::uint32_t>(scene->vertices.used);
    scene->vertices.add() = world(place_q16);
    return UMBRA78_OK;
}

umbra78_status umbra78_add_triangle(umbra78_scene* scene, const uint32_t vertex[3],
                                    uint16_t material) {
    if (scene == nullptr || vertex == nullptr) return UMBRA78_NULL_ARGUMENT;
    raster::Facet facet;
    facet.material = material;
    if (!has(*scene, material)) return UMBRA78_NO_SUCH_PART;
    for (std::size_t k = 0; k < 3; ++k) {
        if (vertex[k] >= scene->vertices.used) return UMBRA78_NO_SUCH_PART;
        facet.vertex[k] = vertex[k];
    }
    if (scene->facets.full()) return UMBRA78_SCENE_FULL;
    scene->facets.add() = facet;
    return UMBRA78_OK;
}

umbra78_status umbra78_set_observer(umbra78_scene* scene, const umbra78_view* view) {
    if (scene == nullptr || view == nullptr) return UMBRA78_NULL_ARGUMENT;
    return read(*view, scene->observer);
}

umbra78_status umbra78_add_light(umbra78_scene* scene, const umbra78_view* view) {
    if (scene == nullptr || view == nullptr) return UMBRA78_NULL_ARGUMENT;
    if (!has_room_for_light(*scene)) return UMBRA78_SCENE_FULL;
    const umbra78_status status = read(*view, scene->lights[scene->light_count]);
    if (status == UMBRA78_OK) ++scene->light_count;
    return status;
}

umbra78_status umbra78_add_lamp(umbra78_scene* scene, const int32_t place_q16[3],
                                const int32_t target_q16[3], int32_t extent_q16) {
    if (scene == nullptr || place_q16 == nullptr || target_q16 == nullptr)
        return UMBRA78_NULL_ARGUMENT;
    if (!has_room_for_light(*scene)) return UMBRA78_SCENE_FULL;
    if (!in_world(place_q16) || !in_world(target_q16)) return UMBRA78_OUT_OF_WORLD;
    raster::View view;
    const raster::World place = world(place_q16);
    view.projection = raster::Projection::perspective;
    view.target = world(target_q16);
    view.extent = extent_q16;
    view.distance = raster::distance_between(place, view.target);
    if (extent_q16 <= 0 || !in_world(extent_q16) || view.distance == 0 ||
        !raster::axes_from_points(place, view.target, view.axes))
        return UMBRA78_BAD_VIEW;
    scene->lights[scene->light_count++] = {view, true, true};
    return UMBRA78_OK;
}

umbra78_status umbra78_take_figure(umbra78_scene* scene, int figure) {
    if (scene == nullptr) return UMBRA78_NULL_ARGUMENT;
    if (figure < 1 || figure > shadow::figure_count) return UMBRA78_NO_SUCH_PART;
    constexpr std::size_t patches = std::tuple_size_v<shadow::FigurePatches>;
    if (scene->materials.full() || scene->patches.room.size() - scene->patches.used < patches ||
        scene->light_count == shadow::max_lights)
        return UMBRA78_SCENE_FULL;
    const auto material = static_cast<std::uint16_t>(scene->materials.used);
    scene->materials.add() = shadow::figure_material;
    for (const raster::Sphere& sphere : shadow::figure_spheres) {
        const std::int32_t centre[3] = {sphere.centre.x, sphere.centre.y, sphere.centre.z};
        const umbra78_status status = umbra78_add_sphere(scene, centre, sphere.radius, material);
        if (status != UMBRA78_OK) return status;
    }
    scene->observer = {shadow::figure_view(0), false, true};
    scene->lights[scene->light_count++] = {shadow::figure_view(shadow::figure_azimuth_q16), false,
                                           true};
    scene->settings = shadow::figure_settings(figure);
    return UMBRA78_OK;
}

}  // extern "C"
