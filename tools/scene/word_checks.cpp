#include "tools/scene/word_checks.hpp"

#include "tools/scene/view_keys.hpp"

#include "raster/projection.hpp"
#include "tools/scene/settings_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace umbra78::tools {
namespace {

using raster::View;
using Real4 = std::array<double, 4>;

// Control points that are measured; of more, evenly spaced ones.
constexpr std::size_t max_points = 4096;

double q16(std::int64_t word) { return std::ldexp(static_cast<double>(word), -16); }

bool perspective(const View& view) { return view.projection == raster::Projection::perspective; }

double pixel(const View& view, const hw::MachineSpec& spec) {
    return q16(view.extent) / spec.half_px();
}

// A matrix of rationals, or of words, as real numbers; both for inputs in world units or pixels.
struct RealMatrix {
    std::array<Real4, 4> row{};

    Real4 operator()(const Real4& v) const {
        Real4 out{};
        for (std::size_t r = 0; r < 4; ++r)
            for (std::size_t k = 0; k < 4; ++k) out[r] += row[r][k] * v[k];
        for (std::size_t r = 0; r < 3; ++r) out[r] /= out[3];
        return out;
    }
};

RealMatrix real(const hw::MatrixWords& words, const hw::MachineSpec& spec, hw::WordFormat input) {
    RealMatrix m;
    const double one = std::ldexp(input.one_word(), -input.fraction);
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t k = 0; k < 4; ++k)
            m.row[r][k] = std::ldexp(words.word[r][k],
                                     words.exponent[r] - spec.coefficient_bits + 2) *
                          (k == 3 ? one : 1);
    if (words.affine) m.row[3] = {0, 0, 0, 1};
    return m;
}

// hw/MACHINE.md, section 4, in double precision: pixels and depth in pixels of the cube.
class ExactView {
public:
    ExactView(const View& view, const hw::MachineSpec& spec)
        : view_(view), half_(spec.half_px()), near_(q16(view.near_depth)),
          far_(q16(view.far_depth)) {}

    Real4 operator()(const Real4& p) const {
        const std::array target{q16(view_.target.x), q16(view_.target.y), q16(view_.target.z)};
        const auto along = [&](const raster::Axis& axis) {
            double sum = 0;
            for (std::size_t k = 0; k < 3; ++k)
                sum += std::ldexp(axis[k], -30) * (p[k] - target[k]);
            return sum;
        };
        const double eye = perspective(view_) ? q16(view_.distance) : 0;
        const double depth = eye - along(view_.axes.back);
        const double scale =
            half_ / q16(view_.extent) * (perspective(view_) ? eye / depth : 1);
        const double z = perspective(view_)
                             ? ((far_ + near_) - 2 * far_ * near_ / depth) / (far_ - near_)
                             : 2 * (depth - near_) / (far_ - near_) - 1;
        return {scale * along(view_.axes.right), -scale * along(view_.axes.up), half_ * z, depth};
    }
    // Whether a point that operator() gave is in the view's volume.
    bool shows(const Real4& seen) const {
        return (!perspective(view_) || seen[3] > 0) && std::abs(seen[0]) <= half_ &&
               std::abs(seen[1]) <= half_ && std::abs(seen[2]) <= half_;
    }

private:
    const View& view_;
    double half_, near_, far_;
};

// Of a stream, those that were noted when it was drawn.
template <class Visit>
void for_points(const LoadedScene& scene, Visit visit) {
    const std::size_t controls = 16 * scene.patches.size();
    const std::size_t held = controls + scene.vertices.size();
    const std::size_t points = held + scene.sample.size();
    const std::size_t step = (points + max_points - 1) / max_points;
    for (std::size_t k = 0; k < points; k += step) {
        const raster::World& p = k < controls ? scene.patches[k / 16].control[k % 16]
                                 : k < held   ? scene.vertices[k - controls]
                                              : scene.sample[k - held];
        visit(Real4{q16(p.x), q16(p.y), q16(p.z), 1});
    }
}

// How far a point is from where it should be in a view: in pixels at the point's depth, aside
// and along the depth. `exact` is as ExactView gives it.
struct Offset {
    double aside = 0, in_depth = 0;

    double max() const { return std::max(aside, in_depth); }
    void widen(const Offset& other) {
        aside = std::max(aside, other.aside);
        in_depth = std::max(in_depth, other.in_depth);
    }
};

Offset offset(const Real4& made, const Real4& exact, const View& view) {
    const double near = q16(view.near_depth), far = q16(view.far_depth), depth = exact[3];
    // Pixels of the cube's Z that a pixel at the point's depth is.
    const double z = 2 * q16(view.extent) / (far - near) *
                     (perspective(view) ? far * near / (depth * q16(view.distance)) : 1);
    Offset off{std::max(std::abs(made[0] - exact[0]), std::abs(made[1] - exact[1])),
               std::abs(made[2] - exact[2]) / z};
    if (!std::isfinite(off.aside) || !std::isfinite(off.in_depth)) off = {HUGE_VAL, HUGE_VAL};
    return off;
}

std::string of_offset(const Offset& off, std::string_view unit) {
    return fmt::format("{:.3g} {} {}", off.max(), unit,
                       off.aside >= off.in_depth ? "aside" : "in depth");
}

void warn_of_view(const LoadedScene& scene, const View& view, const hw::MatrixWords& words,
                  hw::WordFormat object, const std::string& name, Warnings& warnings) {
    const hw::MachineSpec& spec = scene.settings.machine;
    const RealMatrix machine = real(words, spec, object);
    const ExactView exact(view, spec);
    Offset max;
    for_points(scene, [&](const Real4& p) {
        const Real4 seen = exact(p);
        if (exact.shows(seen)) max.widen(offset(machine(p), seen, view));
    });
    if (max.max() <= 0.25) return;
    const std::string remedy = spec.coefficient_bits < 24 ? "set coefficient_bits = 24, or " : "";
    warnings.push_back(
        {"view_matrix", max.max(),
         fmt::format("the {}'s matrix moves surfaces by up to {}: the large translation of a row "
                     "takes the bits of its rotation; {}set {}.target near what it shows", name,
                     of_offset(max, "pixels"), remedy, name)});
}

// False if it moves nothing.
bool warn_of_shadow(const LoadedScene& scene, const View& of_light, const std::string& name,
                    const shadow::LightMatrices& matrices, Warnings& warnings) {
    const hw::MachineSpec& spec = scene.settings.machine;
    const RealMatrix machine = real(matrices.observer_to_light, spec, hw::screen_words(spec));
    const ExactView observer(scene.observer, spec), light(of_light, spec);
    const double bias = std::ldexp(q16(matrices.bias_quanta_q16), -spec.depth_fraction());
    Offset max;
    for_points(scene, [&](const Real4& p) {
        Real4 from = observer(p);
        Real4 to = light(p);
        if (!observer.shows(from) || !light.shows(to)) return;
        from[3] = 1;
        to[2] -= bias;
        max.widen(offset(machine(from), to, of_light));
    });
    if (max.max() <= 0.25) return false;
    warnings.push_back(
        {"shadow_matrix", max.max(),
         fmt::format("the matrix from observer to {} moves points by up to {}: its {} bits do "
                     "not hold both views; {}bring observer.extent and {}.extent nearer each "
                     "other", name, of_offset(max, "texels of the depth map"),
                     spec.coefficient_bits,
                     spec.coefficient_bits < 24 ? "set coefficient_bits = 24, or " : "", name)});
    return true;
}

// Of one sector, the first of which there is something to say.
void warn_of_sector_shadows(const LoadedScene& scene, const SceneLight& light,
                            const std::string& name,
                            std::span<const shadow::LightMatrices> matrices, Warnings& warnings) {
    for (int k = 0; k < hw::sector_count; ++k) {
        const auto at = static_cast<std::size_t>(k);
        shadow::LightMatrices of_face = matrices[at];
        of_face.observer_to_light = hw::face_matrix(of_face.observer_to_light, k);
        if (warn_of_shadow(scene, light.parts[at], name, of_face, warnings)) return;
    }
}

void warn_of_objects(const LoadedScene& scene, hw::WordFormat object, Warnings& warnings) {
    const double step = std::ldexp(1, -object.fraction);
    const double steps = step / pixel(scene.observer, scene.settings.machine);
    if (steps <= 1) return;
    double reach = 0;
    for_points(scene, [&](const Real4& p) {
        for (std::size_t k = 0; k < 3; ++k) reach = std::max(reach, std::abs(p[k]));
    });
    warnings.push_back(
        {"object_words", steps,
         fmt::format("a control point {:.5g} units from the {} makes a step of all places {:.3g} "
                     "units, {:.3g} pixels: surfaces smaller than that are crushed; bring all of "
                     "the scene within {:.3g} units of it, or raise observer.extent",
                     reach, scene.origin == raster::World{} ? "origin" : "target", step, steps,
                     std::max(1.0, std::exp2(std::floor(std::log2(reach / steps)))))});
}

// False if there is an order.
bool warn_of_order(const LoadedScene& scene, const View& view, const std::string& name,
                   Warnings& warnings) {
    const hw::MachineSpec& spec = scene.settings.machine;
    const double near = q16(view.near_depth), far = q16(view.far_depth);
    const double at = q16(view.distance);  // of the target, in perspective
    const double step = std::ldexp(far - near, -spec.z_bits) *
                        (perspective(view) ? at * at / (far * near) : 1);
    const double steps = step / pixel(view, spec);
    if (steps <= 4) return false;
    View whole = view;
    raster::AxisRange back;
    scene.surfaces().for_points(
        [&](const raster::World& p) { back.add(raster::along(view.axes.back, p)); });
    for (const raster::World& p : scene.sample) back.add(raster::along(view.axes.back, p));
    raster::fit_depth(whole, raster::depth_range_of(view, back));
    const bool as_fitted = whole.near_depth == view.near_depth && whole.far_depth == view.far_depth;
    warnings.push_back(
        {"depth_order", steps,
         fmt::format("a step of the {}'s Z is {:.3g} units at its target, {:.3g} pixels: surfaces "
                     "nearer to each other have no order; {}",
                     name, step, steps,
                     as_fitted ? std::string(spec.z_bits < 24 ? "set z_bits = 24, or make the "
                                                                "scene less deep"
                                                              : "make the scene less deep")
                               : fmt::format("set {0}.near = {1:.4g} and {0}.far = {2:.4g}, or "
                                             "leave both out",
                                             name, q16(whole.near_depth), q16(whole.far_depth)))});
    return true;
}

void warn_of_bias(const LoadedScene& scene, const View& light, const std::string& name,
                  const shadow::LightMatrices& matrices, Warnings& warnings) {
    const hw::MachineSpec& spec = scene.settings.machine;
    const double near = q16(light.near_depth), far = q16(light.far_depth), at = q16(light.distance);
    const double step = std::ldexp(far - near, -spec.z_bits) *
                        (perspective(light) ? at * at / (far * near) : 1);
    const double texels = q16(matrices.bias_quanta_q16) * step / pixel(light, spec);
    if (std::abs(texels) <= 4.01) return;  // 4 as it is rounded
    warnings.push_back(
        {"bias", texels,
         fmt::format("the bias is {:.3g} texels of {} depth map, {:.3g} units: shadows begin "
                     "that far from what casts them; set bias = {:.3g} and bias_unit = \"texels\"",
                     texels, scene.lights.size() == 1 ? "the" : name + "'s",
                     q16(matrices.bias_quanta_q16) * step,
                     q16(scene_defaults().bias_q16))});
}

}  // namespace

void warn_of_words(const LoadedScene& scene, Warnings& warnings) {
    shadow::FrameMatrices matrices;
    shadow::load_matrices(scene.view(), scene.settings, matrices);
    warn_of_objects(scene, matrices.object, warnings);
    warn_of_view(scene, scene.observer, matrices.world_to_observer, matrices.object, "observer",
                 warnings);
    // Without an order in depth no matrix moves a point to the right depth.
    const bool ordered = !warn_of_order(scene, scene.observer, "observer", warnings);
    if (shadow::map_layers(scene.settings) == 0) return;  // no view of a light is drawn
    std::size_t first = 0;  // of the source's depth maps
    for (std::size_t l = 0; l < scene.lights.size(); ++l) {
        const View& view = scene.lights[l].views().front();
        const std::size_t at = first;
        const shadow::LightMatrices& m = matrices.lights[at];
        const std::string name = name_of_light(l, scene.lights.size());
        first += scene.lights[l].views().size();
        warn_of_view(scene, view, m.world_to_light, matrices.object, name, warnings);
        const bool in_order = !warn_of_order(scene, view, name, warnings) && ordered;
        if (in_order && scene.lights[l].sectored)
            warn_of_sector_shadows(scene, scene.lights[l], name,
                                   std::span(matrices.lights).subspan(at), warnings);
        else if (in_order)
            warn_of_shadow(scene, view, name, m, warnings);
        warn_of_bias(scene, view, name, m, warnings);
    }
}

}  // namespace umbra78::tools
