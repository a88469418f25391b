#include "tools/bias/units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace umbra78::tools::bias {
namespace {

using Value = std::optional<double>;
using enum Kind;
using enum Source;

double signed_for(const Amount& a, double value) { return a.reversed ? -value : value; }

// Divided by r. A float's r near the far plane of a reversed map goes to 0 and takes a constant
// with it: from 2^-10 of the depth on the constant is no remedy.
double in_steps(const Amount& a, double unorm_step) {
    if (a.unorm_bits > 0) return signed_for(a, a.depth() / unorm_step);
    return signed_for(a, a.depth() * std::ldexp(1, 23 - a.exponent));
}
Value whole_steps(const Amount& a) {
    return in_steps(a, 1 / (std::ldexp(1, a.unorm_bits) - 1));
}
Value power_steps(const Amount& a) { return in_steps(a, std::ldexp(1, -a.unorm_bits)); }
Value forced_unorm(const Amount& a) {
    return signed_for(a, a.depth() * std::ldexp(1, a.unorm_bits > 0 ? a.unorm_bits : 24));
}
Value forced_float(const Amount& a) { return signed_for(a, a.depth()); }

// All of the bias by the slope that the interface takes: the larger part, or the whole.
Value by_largest(const Amount& a) {
    if (!(a.largest > 0)) return {};
    return signed_for(a, a.world / (a.largest * a.texel));
}
Value by_gradient(const Amount& a) {
    if (!(a.tangent > 0)) return {};
    return signed_for(a, a.world / (a.tangent * a.texel));
}
Value unsigned_gradient(const Amount& a) {
    if (!(a.tangent > 0)) return {};
    return a.world / (a.tangent * a.texel);
}

// Soft filters of Unity's URP scale both of its values.
double urp_kernel(const Amount& a) {
    if (a.taps <= 1) return 1;
    return a.taps <= 3 ? 1.5 : a.taps <= 5 ? 2.5 : 3.5;
}
Value per_sideways(const Amount& a, double divisor) {
    if (!(a.tangent > 0)) return {};
    return a.world / divisor;
}

constexpr std::array table{
    Parameter{"Vulkan", "depthBiasConstantFactor", constant, "r",
              "r = 2^-n by depthBiasExact, else up to twice that: then half; of a float 2^(e-23)",
              specification, false, power_steps},
    Parameter{"Vulkan", "depthBiasConstantFactor, FORCE_UNORM", constant, "2^-n",
              "VK_EXT_depth_bias_control with depthBiasExact; n = 24 for D32F", specification,
              false, forced_unorm},
    Parameter{"Vulkan", "depthBiasConstantFactor, FLOAT", constant, "window depth",
              "VK_EXT_depth_bias_control", specification, false, forced_float},
    Parameter{"Vulkan", "depthBiasSlopeFactor", slope, "m",
              "where the driver takes the gradient; it may take Direct3D's m: then that value",
              specification, false, by_gradient},
    Parameter{"Direct3D", "DepthBias", constant, "r",
              "an integer, away from zero; r = 1/(2^n - 1) or 2^(e-23)", manual, true,
              whole_steps},
    Parameter{"Direct3D", "SlopeScaledDepthBias", slope, "m", "m = max(|dz/dx|, |dz/dy|)", manual,
              false, by_largest},
    Parameter{"OpenGL", "glPolygonOffset units", constant, "r",
              "r = 2^-n; drivers have up to 4 times that: divide by as much", manual, false,
              power_steps},
    Parameter{"OpenGL", "glPolygonOffset factor", slope, "m",
              "where the driver takes the gradient, else Direct3D's value", manual, false,
              by_gradient},
    Parameter{"WebGPU", "depthBias", constant, "r", "an integer, away from zero", specification,
              true, whole_steps},
    Parameter{"WebGPU", "depthBiasSlopeScale", slope, "m", "m = max(|dz/dx|, |dz/dy|)",
              specification, false, by_largest},
    Parameter{"Metal", "setDepthBias depthBias", constant, "r", "", manual, false, whole_steps},
    Parameter{"Metal", "setDepthBias slopeScale", slope, "m", "", manual, false, by_largest},
    Parameter{"three.js", "shadow.bias", constant, "window depth", "negative removes acne", code,
              false, [](const Amount& a) -> Value { return -a.depth(); }},
    Parameter{"three.js", "shadow.normalBias", normal, "world units", "", code, false,
              [](const Amount& a) -> Value { return a.world * a.cosine(); }},
    Parameter{"Babylon.js", "bias, PCF and PCSS", constant, "half of window depth", "", code,
              false, [](const Amount& a) -> Value { return 2 * a.depth(); }},
    Parameter{"Babylon.js", "bias, other filters", constant, "window depth", "", code, false,
              [](const Amount& a) -> Value { return a.depth(); }},
    Parameter{"Babylon.js", "bias, cascades with PCF and depthClamp", constant,
              "2/3 of window depth", "", code, false,
              [](const Amount& a) -> Value { return a.depth() / 1.5; }},
    Parameter{"Babylon.js", "normalBias", normal, "world units", "times the sine", code, false,
              [](const Amount& a) { return per_sideways(a, a.tangent); }},
    Parameter{"Godot 4", "shadow_bias", constant, "percent of range",
              "divide by shadow_blur and, with a soft filter, by its radius", code, false,
              [](const Amount& a) -> Value { return 100 * a.depth(); }},
    Parameter{"Godot 4", "shadow_normal_bias", normal, "texels", "", code, false,
              [](const Amount& a) {
                  return per_sideways(a, a.texel * a.sine() * a.tangent);
              }},
    Parameter{"Unity URP", "depth bias", constant, "texels", "scaled by the soft filter's width",
              code, false,
              [](const Amount& a) -> Value { return a.world / (a.texel * urp_kernel(a)); }},
    Parameter{"Unity URP", "normal bias", normal, "texels", "scaled by the soft filter's width",
              code, false,
              [](const Amount& a) {
                  const double in = a.texel * urp_kernel(a) * (1 - a.cosine());
                  return per_sideways(a, in / a.cosine());
              }},
    Parameter{"Unity HDRP", "slope-scale depth bias", slope, "m/5", "the raster's constant is 1",
              manual, false,
              [](const Amount& a) -> Value {
                  const Value factor = by_largest(a);
                  return factor ? Value(std::abs(*factor) / 5) : Value();
              }},
    Parameter{"Unity HDRP", "normal bias", normal, "texels", "", manual, false,
              [](const Amount& a) -> Value { return a.world * a.cosine() / a.texel; }},
    Parameter{"Unity built-in", "bias", constant, "world units", "", manual, false,
              [](const Amount& a) -> Value { return a.world; }},
    Parameter{"Unity built-in", "normal bias", normal, "texels", "", manual, false,
              [](const Amount& a) { return per_sideways(a, a.texel * a.tangent); }},
    Parameter{"Unreal", "ShadowBias, with SlopeBias 0.5", constant, "texels/5",
              "directional, CascadeBiasDistribution 1, the cascade's radius half of the extent",
              third_party, false,
              [](const Amount& a) -> Value {
                  return a.world / (5 * a.texel * (1 + 1.5 * std::min(a.tangent, 1.0)));
              }},
    Parameter{"bevy", "shadow_depth_bias", constant, "world units", "", code, false,
              [](const Amount& a) -> Value { return a.world; }},
    Parameter{"bevy", "shadow_normal_bias", normal, "texels times the root of 2", "", code, false,
              [](const Amount& a) -> Value {
                  return a.world * a.cosine() / (std::numbers::sqrt2 * a.texel);
              }},
    Parameter{"Filament", "constantBias", constant, "world units", "", code, false,
              [](const Amount& a) -> Value { return a.world; }},
    Parameter{"Filament", "normalBias", normal, "half texels",
              "of a map without its border of one texel", code, false,
              [](const Amount& a) {
                  const double inner = a.texel * a.map_px / (a.map_px - 2);
                  return per_sideways(a, inner * a.tangent / 2);
              }},
    Parameter{"Filament", "polygonOffsetSlope", slope, "m", "", code, false, unsigned_gradient},
};

}  // namespace

std::string_view name_of(Kind kind) {
    constexpr std::string_view names[] = {"constant", "slope", "normal"};
    return names[static_cast<std::size_t>(kind)];
}
std::string_view name_of(Source source) {
    constexpr std::string_view names[] = {"specification", "source code", "manual",
                                          "third party"};
    return names[static_cast<std::size_t>(source)];
}

double Amount::cosine() const { return 1 / std::sqrt(1 + tangent * tangent); }

Amount amount_of(const MapSetup& s, double world) {
    return {world, s.texel(), s.range, s.tangent(), s.largest_slope(), unorm_bits(s.format),
            s.exponent(), s.reversed, s.map_px, static_cast<double>(taps_a_side(s.filter))};
}

std::span<const Parameter> parameters() { return table; }

std::vector<Converted> convert(const Amount& constant_amount, const Amount& geometry) {
    std::vector<Converted> all;
    for (const Parameter& p : table) {
        Value value = p.value(p.kind == constant ? constant_amount : geometry);
        if (value && p.whole) value = value < 0.0 ? std::floor(*value) : std::ceil(*value);
        if (value && !std::isfinite(*value)) value.reset();
        all.push_back({&p, value});
    }
    return all;
}

}  // namespace umbra78::tools::bias
