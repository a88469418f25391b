#include "tools/study/bias/maps.hpp"

#include "shadow/frame/profiles.hpp"
#include "tools/study/bias/report.hpp"
#include "tools/study/bias/search.hpp"
#include "tools/study/report_sections.hpp"
#include "tools/study/strip.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace umbra78::tools::study {
namespace {

constexpr std::string_view own_map = "the scene's";
constexpr int deeper = 32;

// The light's range about its middle, so many times as deep.
std::vector<std::string> deep_range(const raster::View& light) {
    const std::int64_t middle = (std::int64_t{light.near_depth} + light.far_depth) / 2;
    const auto place = [&](std::int64_t depth) {
        return static_cast<double>(middle + deeper * (depth - middle)) / 65536;
    };
    return {fmt::format("light.near={}", place(light.near_depth)),
            fmt::format("light.far={}", place(light.far_depth))};
}

std::string label_of(const Row& row) {
    const std::string own = row.text("map") == own_map
                                ? fmt::format("{}, {} x {} texels, {} bits", own_map,
                                              1 << int(row.number("xy_bits")),
                                              1 << int(row.number("xy_bits")),
                                              row.text("z_bits"))
                                : row.text("map");
    return row.text("range") == "1" ? own : own + ", deep range";
}

// Of a case's error picture the square of a quarter of its side that has the most false shadow,
// enlarged or reduced to side_px. Squares begin at sixteenths of the picture, so that maps of all
// sizes show the same part of the scene.
std::vector<std::uint8_t> stripes_of(const Request& request, const Case& c,
                                     const TruthCache& truths, int side_px) {
    const LoadedScene scene = scene_of(request, c);
    const auto traced = truths.needed(scene);
    BiasedFrames frames(scene, *traced);
    const std::vector<std::uint8_t> whole = error_picture(traced->truth, frames.draw());
    const int size = scene.settings.machine.size_px(), part = size / 4;
    std::vector<std::uint8_t> made(std::size_t(side_px) * side_px);
    std::int64_t most = -1;
    int best_x = 0, best_y = 0;
    for (int y = 0; y + part <= size; y += size / 16) {
        for (int x = 0; x + part <= size; x += size / 16) {
            std::int64_t dark = 0;
            for (int j = y; j < y + part; ++j)
                for (int i = x; i < x + part; ++i) dark += whole[std::size_t(j) * size + i] == 0;
            if (dark <= most) continue;
            most = dark;
            best_x = x;
            best_y = y;
        }
    }
    for (int j = 0; j < side_px; ++j)
        for (int i = 0; i < side_px; ++i)
            made[std::size_t(j) * side_px + i] =
                whole[std::size_t(best_y + j * part / side_px) * size + best_x +
                      i * part / side_px];
    return made;
}

void picture_maps(const Request& request, Report& report) {
    constexpr int side_px = 512;  // a quarter of today's 2048
    const TruthCache truths;
    std::vector<std::vector<std::uint8_t>> pictures;
    std::string names;
    for (const Case& c : map_cases(request)) {
        if (c.extra.at(2).second != "1") continue;
        pictures.push_back(stripes_of(request, c, truths, side_px));
        names += (names.empty() ? "" : ", ") + c.extra.at(1).second;
    }
    const Strip strip = side_by_side(pictures, side_px);
    report.picture("maps", strip.width, strip.height, strip.gray,
                   fmt::format("The sixteenth of the picture with the most false shadow (black), "
                               "half a texel of bias, nearest lookup. From left to right: {}.",
                               names));
}

}  // namespace

std::vector<Case> map_cases(const Request& request) {
    std::vector<Case> cases;
    const bool parallel = request.scene.light().projection == raster::Projection::orthographic;
    for (const int times : {1, deeper}) {
        if (times > 1 && !parallel) break;
        std::vector<std::string> maps{std::string(own_map)};
        for (const shadow::Profile& p : shadow::profiles())
            if (p.kind == shadow::ProfileKind::map_of_today) maps.emplace_back(p.name);
        for (const std::string& map : maps) {
            Case c;
            c.name = fmt::format("map {}{}", map, times > 1 ? ", deep range" : "");
            if (map != own_map) c.set.push_back("profile=" + map);
            if (request.quick) c.set.push_back("xy_bits=7");
            for (const char* each : {"lookup=nearest", "dither=none", "bias=0.5",
                                     "bias_unit=texels"})
                c.set.emplace_back(each);
            if (times > 1)
                for (std::string& each : deep_range(request.scene.light()))
                    c.set.push_back(std::move(each));
            c.extra = {{"find", "map"}, {"map", map}, {"range", std::to_string(times)}};
            cases.push_back(std::move(c));
        }
    }
    return cases;
}

void report_maps(const Request& request, std::span<const Row> rows, Report& report) {
    if (rows.empty()) return;
    report.heading("Depth maps of today");
    TableCells table{{"map", "bias, world units", "quanta", "false shadow", "flatness of the error",
                      "isolated pixels", "least bias outside the edge band, quanta", "texels",
                      "world units", "analytic bound, texels"}};
    auto& json = report.summary()["maps"];
    for (const Row& row : rows) {
        table.push_back({label_of(row), figure(row, "bias_world"), figure(row, "bias_quanta"),
                         percent(row.number("false_shadow")), rounded(row.number("flatness")),
                         row.text("isolated_pixels"), figure(row, "least_outside_quanta"),
                         figure(row, "least_outside_texels"), figure(row, "least_outside_world"),
                         figure(row, "bound_outside_texels")});
        json.push_back({{"map", row.text("map")},
                        {"range", row.number("range")},
                        {"false_shadow", row.number("false_shadow")},
                        {"flatness", row.number("flatness")},
                        {"least_outside_texels", row.number("least_outside_texels")},
                        {"least_outside_world", row.number("least_outside_world")}});
    }
    report.table(table, "The scene's own map and today's, nearest lookup on the same light's view. "
                        "The rates are with half a texel of bias. The flatness of the error's "
                        "spectrum is 0.56 for noise; a pattern tends to 0. In the deep range the "
                        "light's near and far planes are 32 times as far apart.");
    if (!request.quick) picture_maps(request, report);
}

}  // namespace umbra78::tools::study
