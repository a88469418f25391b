// Pictures that compare: highlights in shadow by both forms, figure 3 by sampling and registration,
// and figure 3 in fixed point and on the AP-120B.
#pragma once

#include "tools/io/files.hpp"
#include "tools/paper/figure_set.hpp"

namespace umbra78::tools {

// The post-process beside the correct form, around a sphere whose highlight lies in shadow. In the
// figures' scene no highlight does, so one sphere is moved; the caption says which.
void write_highlights(const Path&, FileSet* set = nullptr);

// Figure 3's mask in leaf and centre sampling, in centre and index registration.
void write_samplings(const Path&, const FigureSet&, FileSet* set = nullptr);

// Figure 3's mask in fixed point, the same on the AP-120B, and where the two differ.
void write_ap120b_comparison(const Path&, const FigureSet&, FileSet* set = nullptr);

}  // namespace umbra78::tools
