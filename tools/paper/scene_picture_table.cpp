// Which scenes are drawn with figures 7 and 8 and the gallery, and with which settings.
#include "tools/paper/scene_pictures.hpp"

namespace umbra78::tools {
namespace {

constexpr ScenePicture table[] = {
    {.name = "fig7a", .shows = "a smile", .scene = "smile.toml", .set = "density=0",
     .figure = true},
    {.name = "fig7b", .shows = "the shadow of a smile", .scene = "smile.toml", .figure = true},
    {.name = "fig8", .shows = "a robot and its shadow", .scene = "robot.toml", .figure = true},
    {.name = "teapot", .shows = "Newell's teapot, its own shadow", .scene = "teapot.toml"},
    {.name = "teapot_diced", .shows = "the same, diced to triangles", .scene = "teapot.toml",
     .set = "surface=diced"},
    {.name = "cup", .shows = "teacup, saucer and spoon", .scene = "cup.toml"},
    {.name = "bunny", .shows = "a bunny of 69 666 triangles", .scene = "bunny.toml",
     .needs = "/usr/share/glmark2/models/bunny.obj", .package = "glmark2-data"},
    {.name = "knot", .shows = "a knot shadows itself", .scene = "knot.toml"},
    {.name = "torus", .shows = "a torus with its moire", .scene = "torus.toml"},
    {.name = "solids", .shows = "the solids", .scene = "solids.toml"},
    {.name = "mesh", .shows = "awkward polygons, flat, smooth", .scene = "mesh.toml"},
    {.name = "grazing", .shows = "grazing light, a bias of 1 texel", .scene = "grazing.toml"},
    {.name = "grazing_plane", .shows = "the same, receivers' planes", .scene = "grazing.toml",
     .set = "receiver=plane"},
    {.name = "lamp", .shows = "a lamp over a table", .scene = "lamp.toml"},
    {.name = "corridor", .shows = "columns in steep perspective", .scene = "corridor.toml"},
    {.name = "pcf1", .shows = "coarse map, nearest lookup", .scene = "pcf.toml",
     .set = "lookup=nearest"},
    {.name = "pcf2", .shows = "the same, 2 x 2 compared", .scene = "pcf.toml", .set = "taps=2"},
    {.name = "pcf5", .shows = "the same, 5 x 5 compared", .scene = "pcf.toml"},
    {.name = "pcf5_jittered", .shows = "the same, 5 x 5 jittered", .scene = "pcf.toml",
     .set = "tap_places=jittered"},
    {.name = "depth_mean5", .shows = "the wrong way: 5 x 5 depths' mean", .scene = "pcf.toml",
     .set = "lookup=filtered_depth"},
    {.name = "ground_map", .shows = "a floor, by a depth map", .scene = "ground.toml"},
    {.name = "ground", .shows = "the same, drawn flat on it", .scene = "ground.toml",
     .set = "form=ground"},
    {.name = "blob", .shows = "the same, an ellipse an object", .scene = "ground.toml",
     .set = "form=blob"},
    {.name = "three_lights", .shows = "three coloured lights", .scene = "three_lights.toml"},
    {.name = "sectors", .shows = "a lamp among spheres, six maps", .scene = "sectors.toml"},
    {.name = "penumbra", .shows = "a table under a lamp with area", .scene = "penumbra.toml"},
    {.name = "ramp", .shows = "the same, one map and a ramp", .scene = "penumbra.toml",
     .set = "light.samples=1 light.ramp=4"},
};

}  // namespace

std::span<const ScenePicture> scene_pictures() { return table; }

}  // namespace umbra78::tools
