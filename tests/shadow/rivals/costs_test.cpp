// The constants of the rivals' costs are the rows of the table in shadow/rivals/RIVALS.md, section
// 8, and none is missing there.
#include "shadow/rivals/costs.hpp"

#include "tests/support/machine_text.hpp"

#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>
#include <string>

namespace umbra78::shadow::rivals {
namespace {

std::string file_text(const char* path) {
    std::ifstream file(std::string(UMBRA78_SOURCE_DIR) + path);
    return {std::istreambuf_iterator<char>(file), {}};
}

// As they are written in the table: a blank for none.
std::vector<std::string> cells_of(const hw::Operations& o) {
    std::vector<std::string> cells;
    for (const std::uint64_t n :
         {o.adds, o.products, o.passes, o.quotients, o.quotient_bits, o.accesses})
        cells.push_back(n == 0 ? "" : std::to_string(n));
    return cells;
}

const std::map<std::string, hw::Operations>& constants() {
    static const std::map<std::string, hw::Operations> all{
#define UMBRA78_COST(name) {#name, cost::name}
        UMBRA78_COST(plane), UMBRA78_COST(plane_side), UMBRA78_COST(facet_side),
        UMBRA78_COST(edge_multiplicity), UMBRA78_COST(asked_facet), UMBRA78_COST(side_setup),
        UMBRA78_COST(side_row), UMBRA78_COST(side_pixel), UMBRA78_COST(count_update),
        UMBRA78_COST(depth_order), UMBRA78_COST(picture_place), UMBRA78_COST(picture_facet),
        UMBRA78_COST(box_test), UMBRA78_COST(depth_test), UMBRA78_COST(projected_edge),
        UMBRA78_COST(listed_crossing), UMBRA78_COST(compare), UMBRA78_COST(written_pixel),
        UMBRA78_COST(placed_sample), UMBRA78_COST(moved_point), UMBRA78_COST(divided_point),
        UMBRA78_COST(scanned_texel), UMBRA78_COST(line_sign), UMBRA78_COST(meeting_sign),
        UMBRA78_COST(piece_corner), UMBRA78_COST(cut_piece), UMBRA78_COST(piece_row),
        UMBRA78_COST(read_pixel), UMBRA78_COST(masked_pixel)
#undef UMBRA78_COST
    };
    return all;
}

TEST(RivalCosts, AreTheRowsOfTheText) {
    std::set<std::string> told;
    for (const auto& row : umbra78::test::table_of(file_text("/shadow/rivals/RIVALS.md"),
                                                   "| what | adds | products | passes |")) {
        ASSERT_EQ(row.size(), 7u);
        const std::string name = row[0].substr(0, row[0].find(':'));
        ASSERT_TRUE(constants().contains(name)) << name;
        EXPECT_EQ(std::vector<std::string>(row.begin() + 1, row.end()),
                  cells_of(constants().at(name)))
            << name;
        EXPECT_TRUE(told.insert(name).second) << name << " is told twice";
    }
    const std::string source = file_text("/shadow/rivals/costs.hpp");
    const std::regex constant("inline constexpr Operations (\\w+)");
    std::set<std::string> written;
    for (std::sregex_iterator it(source.begin(), source.end(), constant), end; it != end; ++it)
        written.insert((*it)[1]);
    EXPECT_EQ(told, written);
    EXPECT_GE(told.size(), 25u);
}

// Each count of the irregular map's costs what the text says, and only that.
TEST(RivalCosts, OfTheIrregularMapByItsCounts) {
    const struct {
        std::uint64_t IrregularCounts::*count;
        hw::Operations each;
    } told[] = {{&IrregularCounts::samples, cost::placed_sample},
                {&IrregularCounts::facet_texels, cost::scanned_texel},
                {&IrregularCounts::visits, cost::box_test},
                {&IrregularCounts::facets_asked, cost::asked_facet},
                {&IrregularCounts::texels_filled, {}}};
    for (const auto& [count, each] : told) {
        IrregularCounts counts;
        counts.*count = 7;
        const Work work = work_of(counts, Mesh{}, 3);
        EXPECT_EQ(cells_of(work.frame), cells_of(3 * cost::written_pixel + 7 * each));
        EXPECT_EQ(cells_of(work.once), cells_of({}));
    }
}

}  // namespace
}  // namespace umbra78::shadow::rivals
