// A bias in the units of what people use: each row of the table is a parameter of an interface or
// an engine, the formula that turns a bias into it, and where that formula is defined.
//
// A constant parameter and a slope parameter each deliver all of the bias alone.
// tools/bias/UNITS.md has the derivations and sources.
#pragma once

#include "tools/bias/need.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace umbra78::tools::bias {

// What kind of bias a parameter sets.
enum class Kind : std::uint8_t { constant, slope, normal };
std::string_view name_of(Kind);

// Where its formula comes from.
enum class Source : std::uint8_t {
    specification,  // the interface's own
    code,           // the engine's published source
    manual,         // the public manual, or excerpts of the source
    third_party,    // other people's account of it
};
std::string_view name_of(Source);

// What is to be converted: world units along the light, and the map that it is for.
struct Amount {
    double world;      // b
    double texel;      // t
    double range;      // R: of a light in perspective, that of an orthographic one with the same
                       // depth a world unit at the target
    double tangent;    // s
    double largest;    // max(|zx|, |zy|)
    int unorm_bits;    // of the depth format; 0: 32-bit float
    int exponent;      // of the stored depth, for the float
    bool reversed;
    int map_px;
    double taps = 1;  // a side of the filter's window, for engines that scale by it

    double depth() const { return world / range; }  // d, of 0 .. 1
    double cosine() const;
    double sine() const { return tangent * cosine(); }
};
Amount amount_of(const MapSetup&, double world);

struct Parameter {
    std::string_view target, name;
    Kind kind;
    std::string_view unit, remark;
    Source source;
    bool whole;  // an integer: rounded away from zero
    std::optional<double> (*value)(const Amount&);  // nothing where the unit cannot say it
};
std::span<const Parameter> parameters();

struct Converted {
    const Parameter* parameter;
    std::optional<double> value;
};
// `constant` for the constants; `geometry`, the bias without the depth step, for what follows the
// surface.
std::vector<Converted> convert(const Amount& constant, const Amount& geometry);

}  // namespace umbra78::tools::bias
