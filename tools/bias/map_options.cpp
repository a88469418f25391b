#include "tools/bias/map_options.hpp"

#include "tools/scene/scene_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace umbra78::tools::bias {
namespace {

std::optional<double> number_in(const std::string& text) {
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [at, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || at != end || !std::isfinite(value)) return {};
    return value;
}

double within(const char* option, const std::string& text, double low, double high) {
    const std::optional<double> value = number_in(text);
    if (!value) throw SceneError(fmt::format("{}: {}", option, check_decimal(text)));
    if (*value >= low && *value <= high) return *value;
    throw SceneError(fmt::format("{} {}: its range is {:g} .. {:g}", option, text, low, high));
}

}  // namespace

std::string check_decimal(const std::string& text) {
    return number_in(text) ? "" : fmt::format("'{}' is not a number; write it as in 0.5", text);
}
std::string check_depth(const std::string& text) {
    if (depth_format(text)) return "";
    return fmt::format("'{}' is no depth format; give d16, d24 or d32f", text);
}
std::string check_filter(const std::string& text) {
    if (filter(text)) return "";
    return fmt::format("'{}' is no filter; give nearest, bilinear, pcf3 or pcf5", text);
}

MapSetup setup_of(const MapOptions& o) {
    if (o.map_px == 0 || o.extent.empty() || o.range.empty() || o.slope.empty())
        throw SceneError("a depth map is given by --map, --extent, --range and --slope; give all "
                         "four, or a scene");
    for (const std::string& wrong : {check_depth(o.depth), check_filter(o.filter)})
        if (!wrong.empty()) throw SceneError(wrong);
    if (o.map_px < 16 || o.map_px > 65536)
        throw SceneError(fmt::format("--map {}: its range is 16 .. 65536", o.map_px));
    MapSetup s;
    s.map_px = o.map_px;
    s.extent = within("--extent", o.extent, 1e-6, 1e9);
    s.range = within("--range", o.range, 1e-6, 1e9);
    s.slope_deg = within("--slope", o.slope, 0, 89);
    s.azimuth_deg = within("--azimuth", o.azimuth, 0, 90);
    s.depth = within("--z", o.z, 0.001, 0.999);
    if (!o.pixel.empty()) s.pixel = within("--pixel", o.pixel, 1e-9, 1e9);
    s.format = *depth_format(o.depth);
    s.filter = *filter(o.filter);
    s.reversed = o.reversed;
    const double reached = 16 * s.texel() * (s.along_x() + s.along_y()) / s.range;
    if (reached >= std::min(s.depth, 1 - s.depth))
        throw SceneError(fmt::format("such a slope leaves the depth range within 16 texels of "
                                     "--z {:g}; give more --map, more --range or less --extent",
                                     s.depth));
    return s;
}

}  // namespace umbra78::tools::bias
