#include "tools/models/obj_surfaces.hpp"

#include "fixed/rounding.hpp"
#include "tools/models/spline.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace umbra78::tools {
namespace {

using Words = std::vector<ModelWord>;
using fixed::Rational;

constexpr std::string_view taken[] = {"cstype", "deg", "surf", "parm", "end"};
constexpr std::string_view refused[] = {"bmat", "step", "curv", "curv2", "trim",
                                        "hole", "scrv", "sp",   "con"};

bool is_among(std::span<const std::string_view> list, std::string_view word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

// The mean of a span's 4 x 4 points by the weights of u and v, one rounding a coordinate.
ModelPoint weighted(const std::array<ModelPoint, 16>& points, const std::array<Rational, 4>& u,
                    const std::array<Rational, 4>& v) {
    ModelPoint mean{.line = points[0].line};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Rational sum(0);
        for (std::size_t n = 0; n < 16; ++n)
            sum = sum + u[n % 4] * v[n / 4] * Rational(points[n].word[axis]);
        sum.round_scaled(0, fixed::Rounding::half_even, mean.word[axis]);  // fits, as the points do
    }
    return mean;
}

}  // namespace

bool ObjSurfaces::takes(std::string_view keyword) {
    return is_among(taken, keyword) || is_among(refused, keyword);
}

void ObjSurfaces::read(const Words& words, std::size_t vertices, std::size_t normals) {
    const std::string_view key = words.front().text;
    const int line = words.front().line;
    if (is_among(refused, key))
        report(line, shown(key) + " makes a curve or cuts a surface; give whole surfaces of "
                                  "patches");
    else if (key == "cstype") read_type(words);
    else if (key == "deg") read_degree(words);
    else if (key == "surf") read_surface(words, vertices, normals);
    else if (surfaces_.empty() || surfaces_.back().ended)
        report(line, shown(key) + " belongs to no surface; begin one with surf");
    else if (key == "parm") read_parameters(words);
    else surfaces_.back().ended = true;
}

void ObjSurfaces::read_type(const Words& words) {
    const std::string_view type = words.size() > 1 ? words[1].text : "";
    kind_ = type == "bezier" ? Kind::bezier : type == "bspline" ? Kind::bspline : Kind::none;
    const int line = words.front().line;
    if (type == "rat")
        report(line, "'cstype rat' is rational: its points have weights, by which the machine "
                     "would have to divide; write cstype bezier or bspline");
    else if (kind_ == Kind::none)
        report(line, fmt::format("'cstype' is {}; write cstype bezier or bspline", shown(type)));
}

void ObjSurfaces::read_degree(const Words& words) {
    bicubic_ = words.size() == 3 && words[1].text == "3" && words[2].text == "3";
    if (!bicubic_)
        report(words.front().line, "'deg' is not 3 3: only bicubic surfaces have an exact form "
                                   "here; write deg 3 3");
}

void ObjSurfaces::read_surface(const Words& words, std::size_t vertices, std::size_t normals) {
    const int line = words.front().line;
    if (kind_ == Kind::none || !bicubic_)
        report(line, "'surf' stands before its cstype and deg; write them first");
    if (words.size() < 5)
        report(line, "'surf' has no range; write surf s0 s1 t0 t1 and its points");
    Surface surface{.kind = kind_, .line = line};
    for (std::size_t k = 1; k < words.size() && !error_.any(); ++k) {
        if (k <= 4) surface.range[k - 1] = read_parameter(words[k]);
        else surface.corners.push_back(read_corner(words[k], vertices, normals, name_, error_));
    }
    surfaces_.push_back(std::move(surface));
}

void ObjSurfaces::read_parameters(const Words& words) {
    const std::string_view direction = words.size() > 1 ? words[1].text : "";
    if (direction != "u" && direction != "v")
        report(words.front().line, "'parm' is of neither u nor v; write parm u or parm v");
    auto& parameters = surfaces_.back().parameters[direction == "u" ? 0 : 1];
    for (std::size_t k = 2; k < words.size() && !error_.any(); ++k)
        parameters.push_back(read_parameter(words[k]));
}

// A parameter's word of 32 fraction bits is near enough to it to tell decimals of nine places
// apart; counted in 10^-9 knots that are a tenth apart are evenly spaced.
std::int64_t ObjSurfaces::read_parameter(const ModelWord& text) {
    constexpr std::int64_t nano = 1'000'000'000;
    const std::int64_t word = read_coordinate(text, name_, error_);
    const std::int64_t whole = fixed::floor_shift(word, model_fraction);
    const std::int64_t rest = word - (whole << model_fraction);
    return whole * nano + fixed::round_shift(rest * nano, model_fraction, fixed::Rounding::half_up);
}

// Checks the parameters of u (0) or v (1); 0 after a report.
std::size_t ObjSurfaces::points_along(const Surface& surface, std::size_t direction) {
    const std::vector<std::int64_t>& p = surface.parameters[direction];
    const bool bspline = surface.kind == Kind::bspline;
    const std::string title = fmt::format("'parm {}' of this surface", "uv"[direction]);
    const std::size_t fewest = bspline ? 8 : 2, end = bspline ? 3 : 0;
    const auto falls = [&](std::int64_t a, std::int64_t b) { return bspline ? a > b : a >= b; };
    if (p.size() < fewest)
        report(surface.line, fmt::format("{} has {} numbers; give at least {}", title, p.size(),
                                         fewest));
    else if (std::adjacent_find(p.begin(), p.end(), falls) != p.end())
        report(surface.line, title + " falls; put its numbers in order");
    else if (surface.range[2 * direction] != p[end] ||
             surface.range[2 * direction + 1] != p[p.size() - 1 - end])
        report(surface.line, fmt::format("{} is not that of the surf statement: only a whole "
                                         "surface can be taken; give it its whole range", title));
    else
        return bspline ? p.size() - 4 : 3 * (p.size() - 1) + 1;
    return 0;
}

void ObjSurfaces::append_patches(const std::vector<ModelPoint>& all,
                                 std::vector<ModelPatch>& patches) {
    for (const Surface& surface : surfaces_) {
        if (!surface.ended) report(surface.line, "this surface has no end; add end after its parm");
        if (error_.any()) return;
        const std::size_t nu = points_along(surface, 0), nv = points_along(surface, 1);
        if (!error_.any() && nu * nv != surface.corners.size())
            report(surface.line, fmt::format("this surface has {} points; its parm ask for {} by "
                                             "{}", surface.corners.size(), nu, nv));
        std::vector<ModelPoint> points;
        for (const ObjCorner& c : surface.corners)
            if (!error_.any())
                points.push_back(point_at(all, c.vertex, "vertex", c.line, name_, error_));
        if (error_.any()) return;
        if (surface.kind == Kind::bezier) append_bezier(points, nu, nv, patches);
        else append_bspline(surface, points, patches);
    }
}

void ObjSurfaces::append_bezier(const std::vector<ModelPoint>& points, std::size_t nu,
                                std::size_t nv, std::vector<ModelPatch>& patches) {
    for (std::size_t j = 0; j + 3 < nv; j += 3) {
        for (std::size_t i = 0; i + 3 < nu; i += 3) {
            patches.emplace_back();
            for (std::size_t n = 0; n < 16; ++n)
                patches.back()[n] = points[(j + n / 4) * nu + i + n % 4];
        }
    }
}

void ObjSurfaces::append_bspline(const Surface& surface, const std::vector<ModelPoint>& points,
                                 std::vector<ModelPatch>& patches) {
    std::array<std::vector<BezierSpan>, 2> spans;
    for (std::size_t k = 0; k < 2; ++k)
        if (!bezier_spans(surface.parameters[k], spans[k]))
            report(surface.line, "the knots of this surface differ by more than 65536 of their "
                                 "common divisor; write them with fewer digits");
    const std::size_t nu = surface.parameters[0].size() - 4;
    for (const BezierSpan& v : spans[1]) {
        for (const BezierSpan& u : spans[0]) {
            std::array<ModelPoint, 16> control;
            for (std::size_t n = 0; n < 16; ++n)
                control[n] = points[(v.last - 3 + n / 4) * nu + u.last - 3 + n % 4];
            patches.emplace_back();
            for (std::size_t n = 0; n < 16; ++n)
                patches.back()[n] = weighted(control, u.weight[n % 4], v.weight[n / 4]);
        }
    }
}

}  // namespace umbra78::tools
