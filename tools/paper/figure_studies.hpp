// Pictures beside the figures: highlights in shadow, figure 3 by its samplings, and figure 3 on the
// AP-120B.
#pragma once

#include "tools/paper/figure_set.hpp"

namespace umbra78::tools {

// The post-process form beside the correct form, around a sphere whose highlight lies in shadow.
// In the figures' scene none does, so one sphere is moved; the caption says which.
void write_highlights(const Path&, FileSet* set = nullptr);

// Figure 3's mask in leaf and centre sampling, in centre and index registration.
void write_samplings(const Path&, const FigureSet&, FileSet* set = nullptr);

// Figure 3's mask in fixed point, on the AP-120B, and where they differ.
void write_array_comparison(const Path&, const FigureSet&, FileSet* set = nullptr);

}  // namespace umbra78::tools
