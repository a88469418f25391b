// Diced patches in a view, before they are diced: whether one lies outside, and its footprint.
//
// A vertex is an exact mean of the patch's control points, rounded to world words and then to
// object words; the control points' object words are rounded, too. So a vertex's words are a mean
// of the control points' object words plus a displacement of less than
//
//   1/2 + 2^-3   object word: the vertex's roundings; an object word is at least 4 world words
//   + 1/2        the control points'
//
// in each coordinate. What two words do to X, Y, Z and W is found by the transform itself, which is
// linear but for its roundings; these, and those of cutting to the guard band, are added. What
// cannot be decided counts as seen.
#pragma once

#include "raster/facet.hpp"

#include <array>
#include <cstdint>

namespace umbra78::raster {

class DicedView {
public:
    DicedView(const MachineSpec& spec, const MatrixWords& matrix, WordFormat object);

    // Whether all control points lie beyond one side of the cube, or before or behind it, by more
    // than a vertex can be from them: then no facet has a sample in the view.
    bool outside(const Patch& patch) const;
    // As patch_footprint.
    Visibility footprint(const Patch& patch, Footprint& out) const;

private:
    ScreenPlace place(const hw::Words& words) const;
    std::int64_t within(const ScreenPlace& p, std::size_t plane) const;
    bool quotients(const ScreenPlace& p, std::size_t axis, Bounds& bounds) const;

    MachineSpec spec_;
    hw::TransformUnit unit_;
    WordFormat object_;
    GuardBand limit_;                       // of the cube: |X| <= limit W
    std::array<std::int64_t, 6> margin_{};  // of `within`, by plane
    std::array<std::int64_t, 4> spread_{};  // of X, Y, Z, W
};

}  // namespace umbra78::raster
