#include "shadow/frame/reuse.hpp"

#include <algorithm>

namespace umbra78::shadow {
namespace {

bool same(const hw::MatrixWords& a, const hw::MatrixWords& b) {
    return a.word == b.word && a.exponent == b.exponent && a.affine == b.affine;
}

bool same(const raster::Material& a, const raster::Material& b) {
    return a.diffuse == b.diffuse && a.specular == b.specular && a.shininess == b.shininess;
}

bool same(const raster::Toward& a, const raster::Toward& b) {
    return a.to_point == b.to_point && a.direction == b.direction && a.point == b.point;
}

// What both views' Z is drawn from, but for the view's own matrix.
bool same_drawing(const FrameInputs& a, const FrameInputs& b) {
    const hw::MachineSpec &m = a.settings.machine, &n = b.settings.machine;
    const hw::WordFormat &f = a.matrices.object, &g = b.matrices.object;
    return m.xy_bits == n.xy_bits && m.z_bits == n.z_bits &&
           m.coefficient_bits == n.coefficient_bits &&
           m.transform_rounding == n.transform_rounding && m.depth_rounding == n.depth_rounding &&
           a.settings.sampling == b.settings.sampling && f.bits == g.bits &&
           f.fraction == g.fraction &&
           std::equal(a.scene.patches.begin(), a.scene.patches.end(), b.scene.patches.begin(),
                      b.scene.patches.end(),
                      [](const auto& p, const auto& q) { return p.control == q.control; });
}

bool same_surfaces(const FrameInputs& a, const FrameInputs& b) {
    const auto equal = [](const auto& p, const auto& q, auto&& alike) {
        return std::equal(p.begin(), p.end(), q.begin(), q.end(), alike);
    };
    return equal(a.scene.patches, b.scene.patches,
                 [](const auto& p, const auto& q) { return p.material == q.material; }) &&
           equal(a.scene.materials, b.scene.materials,
                 [](const auto& p, const auto& q) { return same(p, q); });
}

bool same_shading(const FrameInputs& a, const FrameInputs& b) {
    const auto light = [](const FrameInputs& f) {
        return raster::toward_eye(f.scene.light, f.matrices.object);
    };
    const auto viewer = [](const FrameInputs& f) {
        return raster::toward_eye(f.scene.observer, f.matrices.object);
    };
    return same_surfaces(a, b) && a.settings.ambient_q8 == b.settings.ambient_q8 &&
           same(light(a), light(b)) && same(viewer(a), viewer(b));
}

bool same_dither(const Settings& a, const Settings& b) {
    const bool silent_a = hw::silent(a.dither, a.machine);
    const bool silent_b = hw::silent(b.dither, b.machine);
    if (silent_a || silent_b) return silent_a == silent_b;
    return a.dither.shape == b.dither.shape && a.dither.size_q8 == b.dither.size_q8 &&
           a.dither.seed == b.dither.seed;
}

// How a point is tested, once both Z planes are drawn; the bias is in the matrix.
bool same_test(const FrameInputs& a, const FrameInputs& b) {
    const Settings &s = a.settings, &t = b.settings;
    const bool bilinear = s.lookup == Lookup::bilinear;
    if (s.arithmetic != t.arithmetic) return false;
    if (s.arithmetic == Arithmetic::ap120b && a.matrices.array != b.matrices.array) return false;
    return same(a.matrices.observer_to_light, b.matrices.observer_to_light) &&
           s.machine.fraction_bits == t.machine.fraction_bits &&
           hw::product_cut(s.machine) == hw::product_cut(t.machine) &&
           (a.matrices.observer_to_light.affine ||
            s.machine.divide_order == t.machine.divide_order) &&
           s.registration == t.registration && s.lookup == t.lookup &&
           (!bilinear || s.background == t.background) && same_dither(s, t);
}

bool same_filters(const Settings& a, const Settings& b) {
    return a.dequantize_passes == b.dequantize_passes &&
           a.low_pass_passes == b.low_pass_passes &&
           (a.form == Form::correct || a.density_q8 == b.density_q8);
}

}  // namespace

Reuse find_reuse(const FrameInputs& before, const FrameInputs& now) {
    const auto drawn = [&](const hw::MatrixWords FrameMatrices::*matrix) {
        return same_drawing(before, now) && same(before.matrices.*matrix, now.matrices.*matrix);
    };
    Reuse s;
    s.light_map = drawn(&FrameMatrices::world_to_light);
    s.depth = drawn(&FrameMatrices::world_to_observer);
    s.observer = s.depth && same_shading(before, now);
    s.mask = s.depth && s.light_map && same_test(before, now);
    // The correct form draws mask and intensity together: both stand or neither does.
    const bool correct = now.settings.form == Form::correct;
    if (before.settings.form != now.settings.form) s.observer = s.mask = false;
    if (correct) s.observer = s.mask = s.observer && s.mask;
    s.picture = s.observer && s.mask && same_filters(before.settings, now.settings);
    return s;
}

}  // namespace umbra78::shadow
