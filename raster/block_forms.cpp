// The table of a block's forms: block_body.hpp by instruction sets.
#include "raster/block_form.hpp"

namespace umbra78::raster {

#define UMBRA78_LANES_TEXT "raster/block_body.hpp"
#include "fixed/lane_sets.hpp"

namespace {

// What a build leaves out is not in its table, and so not in its program.
constexpr bool has_facets = hw::built(hw::Feature::triangles);
constexpr bool has_lists = hw::built(hw::Feature::reuse);

#define UMBRA78_BLOCK_FORM(set, name)                                                   \
    {name,                                                                              \
     set::supported,                                                                    \
     set::expand_form,                                                                  \
     set::centres_form,                                                                 \
     set::leaves_form,                                                                  \
     set::shade_form,                                                                   \
     has_lists ? set::measure_normals_form : nullptr,                                   \
     has_lists ? set::shade_normals_form : nullptr,                                     \
     has_facets ? FacetForm{set::see_form, set::measure_form, set::few_form,            \
                            set::tile_form, set::put_form, set::shade_facets_form}      \
                : FacetForm{}},
constexpr BlockForm block_table[] = {UMBRA78_LANE_SETS(UMBRA78_BLOCK_FORM)};
#undef UMBRA78_BLOCK_FORM
}  // namespace

std::span<const BlockForm> block_forms() { return block_table; }

const BlockForm& fastest_block_form() {
    const BlockForm* best = block_table;
    for (const BlockForm& form : block_table)
        if (form.supported()) best = &form;
    return *best;
}

}  // namespace umbra78::raster
