// Limits: from which magnitude 2^k on the machine refuses, and with which status.
//
// The first refused k is found by bisection. Then every k is tried: all before it must have the
// status ok, and all from it on must be refused.
#include "tools/render/render_job.hpp"
#include "tools/scene/scene_file.hpp"
#include "tools/study/stability/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace umbra78::tools::study {
namespace {

constexpr std::string_view scene =
    "[observer]\ntarget = [0, 0, 0]\nextent = 2\n"
    "[light]\nazimuth = -60\nelevation = 30\ntarget = [0, 0, 0]\nextent = 2\n"
    "[[sphere]]\ncentre = [0, 0, 0]\nradius = 0.5\n";

std::string asked(std::vector<std::string> set) { return frame_status(std::string(scene), set); }

std::string two_to(int k) { return fmt::format("{:.17g}", std::ldexp(1.0, k)); }

std::string observer_extent(int k) { return asked({"observer.extent=" + two_to(k)}); }
std::string light_extent(int k) { return asked({"light.extent=" + two_to(k)}); }
std::string both_extents(int k) {
    return asked({"observer.extent=" + two_to(14), "light.extent=" + two_to(k)});
}
std::string both_extents_24(int k) {
    return asked({"observer.extent=" + two_to(14), "light.extent=" + two_to(k), "xy_bits=12",
                  "coefficient_bits=24"});
}
std::string light_depth(int k) { return asked({"light.near=0", "light.far=" + two_to(k)}); }
std::string shifted_depth(int k) {
    return asked({"light.near=1000", fmt::format("light.far={:.17g}", 1000 + std::ldexp(1.0, k))});
}
std::string far_over_near(int k, const char* bits) {
    return asked({"observer.projection=perspective", "observer.distance=4",
                  "observer.near=" + two_to(16 - k), "observer.far=" + two_to(16),
                  std::string("coefficient_bits=") + bits});
}
std::string far_over_near_16(int k) { return far_over_near(k, "16"); }
std::string far_over_near_24(int k) { return far_over_near(k, "24"); }
// Whether a depth of 0.9 far is drawn: it is not if its code rounds beyond the last one.
std::string last_code(int k, int z_bits) {
    const double ratio = std::ldexp(1.0, k);  // far / near, with near = 1
    const double z = ((ratio + 1) * 0.9 * ratio - 2 * ratio) / ((ratio - 1) * 0.9 * ratio);
    const double codes = std::ldexp(1.0, z_bits - 1);
    return std::floor(codes + codes * z + 0.5) < 2 * codes ? "ok" : "beyond_last_code";
}
std::string last_code_16(int k) { return last_code(k, 16); }
std::string last_code_24(int k) { return last_code(k, 24); }
std::string bias(int k) { return asked({"bias=" + two_to(k)}); }
std::string bias_in_world(int k) {
    return asked({"bias=" + two_to(k), "bias_unit=world", "light.near=0",
                  "light.far=" + two_to(-15)});
}
std::string place(int k) {
    std::string text(scene);
    text.replace(text.find("centre = [0,"), 12, "centre = [" + two_to(k) + ",");
    return frame_status(text, {});
}
std::string lamp(int k) {
    std::string text = "[observer]\ntarget = [0, 0, 0]\nextent = 2\n[light]\nkind = \"point\"\n";
    text += fmt::format("position = [{}, 0.001, 0]\ntarget = [0, 0, 0]\n", two_to(k));
    return frame_status(text + "[[sphere]]\ncentre = [0, 0, 0]\nradius = 0.5\n", {});
}
// A square 32 000 wide in a window of 2^k: 24 halvings a direction must reduce it to 16 pixels.
std::string halvings(int k) {
    const std::vector<std::string> set{"light.extent=" + two_to(k)};
    const LoadedScene wide = parse_scene(
        "[observer]\ntarget = [0, 0, 0]\nextent = 2\n[light]\nazimuth = 0\ntarget = [0, 0, 0]\n"
        "[[plane]]\norigin = [-16000, -16000, 1]\nu = [32000, 0, 0]\nv = [0, 32000, 0]\n",
        "case", set);
    RenderJob job(wide.view(), wide.settings);
    job.draw_light();
    return job.counts().lights[0].map.unresolved == 0 ? "ok" : "unresolved";
}
// A patch crumpled over 32 000 units, whose corrections are the greatest possible.
std::string depth_of_a_crumpled(int k) {
    std::string text =
        "[observer]\ntarget = [0, 0, 0]\nextent = 2\n[light]\nazimuth = 0\ntarget = [0, 0, 0]\n"
        "extent = 2\n[[patch]]\ncontrol = [";
    for (int row = 0; row < 4; ++row) {
        text += "[";
        for (int i = 0; i < 4; ++i)
            text += fmt::format("[{0}, {0}, {0}], ", (i + row) % 2 == 0 ? 32766 : -32766);
        text += "], ";
    }
    return frame_status(text + "]\n",
                        {"z_bits=24", "xy_bits=4", "observer.near=131000",
                         fmt::format("observer.far={:.17g}", 131000 + std::ldexp(1.0, k))});
}
std::string grazing(int k) {
    return asked({"light.azimuth=-90", "light.elevation=" + two_to(k)});
}

}  // namespace

std::vector<LimitCase> limit_cases() {
    constexpr std::string_view ever = "ok at every magnitude, or a name from one on";
    return {
        {"limit: observer's extent, small", ever, 4, -16, observer_extent, "world units"},
        {"limit: observer's extent, large", ever, 4, 15, observer_extent, "world units"},
        {"limit: light's extent, small", ever, 4, -16, light_extent, "world units"},
        {"limit: light's extent under an observer's of 2^14", ever, 14, -16, both_extents,
         "world units"},
        {"limit: the same, 4096 pixels, 24 bits", ever, 14, -16, both_extents_24,
         "world units"},
        {"limit: light's depth, small", ever, 4, -16, light_depth, "world units"},
        {"limit: light's depth 1000 away, small", ever, 4, -16, shifted_depth, "world units"},
        {"limit: far/near, 16-bit coefficients", ever, 1, 32, far_over_near_16, "far/near"},
        {"limit: far/near, 24-bit coefficients", ever, 1, 32, far_over_near_24, "far/near"},
        {"limit: far/near until 0.9 far is lost, 16-bit Z", ever, 1, 30, last_code_16,
         "far/near"},
        {"limit: far/near until 0.9 far is lost, 24-bit Z", ever, 1, 30, last_code_24,
         "far/near"},
        {"limit: bias in quanta", ever, 0, 26, bias, "quanta"},
        {"limit: bias in world units, depth 2^-15", ever, 0, 26, bias_in_world,
         "world units"},
        {"limit: a sphere's place", ever, 0, 16, place, "world units"},
        {"limit: a lamp's distance, small", ever, 8, -16, lamp, "world units"},
        {"limit: a lamp's distance, large", ever, 0, 16, lamp, "world units"},
        {"limit: a window in a scene of 32000", ever, 4, -16, halvings, "world units"},
        {"limit: depth under a crumpled scene, 24-bit Z, 16 px", ever, 6, -16,
         depth_of_a_crumpled, "world units"},
        {"limit: grazing elevation, small", ever, 3, -16, grazing, "degrees"},
    };
}

Finding examine(const LimitCase& c) {
    const int step = c.to > c.from ? 1 : -1, all = std::abs(c.to - c.from);
    const auto status = [&](int n) { return c.status(c.from + step * n); };
    int held = -1, refused = all + 1;  // by bisection: the last accepted, the first refused
    while (refused - held > 1) {
        const int middle = (held + refused) / 2;
        (status(middle) == "ok" ? held : refused) = middle;
    }
    bool one_end = true;
    for (int n = 0; n <= all; ++n) one_end = one_end && (status(n) == "ok") == (n <= held);
    Finding f;
    f.holds = one_end && held >= 0;
    f.status = refused > all ? "ok" : status(refused);
    f.onset = refused > all
                  ? fmt::format("never, to 2^{} {}", c.to, c.magnitude)
                  : fmt::format("2^{} {}: {}", c.from + step * refused, c.magnitude, f.status);
    f.observed = fmt::format("{} magnitudes asked; refused: {}{}", all + 1, f.onset,
                             one_end ? "" : "; NOT ONE END");
    return f;
}

}  // namespace umbra78::tools::study
