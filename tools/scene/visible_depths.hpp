// Which depths a view's window shows, of the surfaces themselves: what near and far cut off.
//
// A patch lies in the hull of its control points; a facet is taken for a patch with a side that is
// a point. Where a hull reaches out of near .. far the patch
// is halved (de Casteljau) until its pieces are beside the window, within near .. far, or small: a
// 32nd of the window wide and, in perspective, a 32nd of their depth deep. Of all pieces the
// corners are measured, which are points of the surface. So what is reported as cut is cut; what is
// narrower than a 32nd of the window may be overlooked.
// In double precision: no bit of a frame depends on it.
#pragma once

#include "tools/scene/view_fit.hpp"

#include <algorithm>
#include <limits>

namespace umbra78::tools {

struct CutDepths {
    // Patches and facets with a part in the window that is nearer than near, or farther than far.
    std::size_t before = 0, behind = 0;
    // The min depth of the one, the max of the other, world units, as near and far measure them.
    double nearest = std::numeric_limits<double>::infinity();
    double farthest = -std::numeric_limits<double>::infinity();

    bool any() const { return before + behind > 0; }
    CutDepths& operator+=(const CutDepths& more) {
        before += more.before;
        behind += more.behind;
        nearest = std::min(nearest, more.nearest);
        farthest = std::max(farthest, more.farthest);
        return *this;
    }
};

CutDepths cut_depths(const raster::View&, const Surfaces&);

}  // namespace umbra78::tools
