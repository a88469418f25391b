// The numbers in shadow/rivals/scan_out.md are those that the algorithms count: the figures' scene
// at 512 x 512, its light at -100 degrees, diced into k x k cells a patch.
#include "tests/shadow/rivals/scan_out.hpp"
#include "tests/support/paths.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <sstream>

namespace umbra78::shadow::rivals::test {
namespace {

std::string table_row(std::initializer_list<std::string> cells) {
    std::string row = "|";
    for (const std::string& cell : cells) row += " " + cell + " |";
    return row;
}
std::string whole(std::uint64_t n) { return std::to_string(n); }
// To two decimals, rounded down.
std::string ratio(std::uint64_t a, std::uint64_t b) {
    const std::uint64_t hundredths = 100 * a / b;
    const std::string text = std::to_string(hundredths % 100);
    return whole(hundredths / 100) + "." + (text.size() < 2 ? "0" : "") + text;
}

void expect_row_in_text(const std::string& row) {
    static const std::string text = [] {
        std::ostringstream out;
        out << std::ifstream(UMBRA78_SOURCE_DIR "/shadow/rivals/scan_out.md").rdbuf();
        return out.str();
    }();
    EXPECT_NE(text.find(row + "\n"), std::string::npos) << "scan_out.md lacks\n" << row;
}

void expect_link_rows(const std::string& k, const FiguresScene& scene) {
    const LinkCounts shown = Linked(scene.setting(), scene.shown()).counts;
    const LinkCounts all = Linked(scene.setting(), {}, {0, false, false}).counts;
    const LinkCounts before = Linked(scene.setting(), scene.shown(), {0, true, true}).counts;
    expect_row_in_text(table_row(
        {k, whole(scene.setting().mesh.facets.size()), whole(shown.receivers), whole(shown.links),
         ratio(shown.links, shown.receivers), whole(shown.longest), whole(all.receivers),
         whole(all.links), ratio(all.links, all.receivers), whole(before.links),
         ratio(before.links, before.receivers)}));
}

void expect_sector_row(const std::string& k, const FiguresScene& scene) {
    std::string row = "| " + k + " |";
    for (int cells = 1; cells <= 64; cells *= 2) {
        const Linked linked(scene.setting(), scene.shown(), {cells, true, false});
        row += " " + whole(linked.counts.box_tests) + " |";
    }
    expect_row_in_text(row);
}

void expect_second_scan_rows(const std::string& k, const FiguresScene& scene, const Linked& linked,
                             const Bordered& bordered) {
    std::vector<CounterChange> room(2 * linked.counts.longest + bordered.counts.longest);
    std::vector<std::uint8_t> mask(scene.shown().size());
    for (const int form : {0, 1, 2}) {
        ScanOutCounts c;
        ASSERT_TRUE(bouknight_kelley(scene.setting(), scene.shown(), linked.links,
                                     form == 2 ? &bordered.borders : nullptr, {form == 1}, room,
                                     mask, c));
        const char* const name = form == 0 ? "every edge" : form == 1 ? "stopped" : "borders";
        expect_row_in_text(table_row({k, name, whole(c.runs), whole(c.lit_runs), whole(c.casters),
                                      whole(c.planes), whole(c.edges), whole(c.start_facets),
                                      whole(c.crossings), whole(c.compares), whole(c.stopped),
                                      whole(c.tones)}));
    }
}

void expect_appel_rows(const std::string& k, const FiguresScene& scene, const Bordered& bordered) {
    const Gridded gridded(scene.setting());
    std::vector<CounterChange> room(bordered.counts.longest);
    std::vector<std::int32_t> numbers(scene.shown().size());
    for (const bool carry : {false, true}) {
        AppelCounts c;
        ASSERT_TRUE(appel(scene.setting(), scene.shown(), &gridded.grid, bordered.borders, {carry},
                          room, numbers, c));
        expect_row_in_text(table_row(
            {k, carry ? "carried" : "seeded", whole(c.runs), whole(c.seeds), whole(c.first),
             whole(c.not_joined), whole(c.contour + c.vertex + c.border_on_edge), whole(c.carried),
             whole(c.seed_facets), whole(c.borders), whole(c.crossings)}));
    }
}

void expect_list_row(const std::string& k, const FiguresScene& scene, int texels) {
    IrregularCounts c;
    mask_by_lists(scene.setting(), scene.shown(), texels, c);
    expect_row_in_text(table_row({k, whole(static_cast<std::uint64_t>(texels)), whole(c.samples),
                                  whole(c.texels_filled), ratio(c.samples, c.texels_filled),
                                  whole(c.longest), whole(c.facet_texels), whole(c.visits),
                                  whole(c.facets_asked), whole(c.bytes)}));
}

TEST(ScanOutText, HasTheNumbersThatAreCounted) {
    for (int levels = 1; levels <= (umbra78::test::sanitized ? 2 : 4); ++levels) {
        const FiguresScene scene(levels, 9, -100);
        const std::string k = std::to_string(1 << levels);
        expect_link_rows(k, scene);
        if (levels <= 3) expect_sector_row(k, scene);
        const Linked linked(scene.setting(), scene.shown());
        const Bordered bordered(scene.setting(), linked.links);
        expect_row_in_text(table_row({k, whole(bordered.counts.signs),
                                      whole(bordered.counts.box_tests),
                                      whole(bordered.counts.edges), whole(bordered.counts.facets),
                                      whole(bordered.counts.longest)}));
        expect_second_scan_rows(k, scene, linked, bordered);
        expect_appel_rows(k, scene, bordered);
        for (const int texels : {16, 64, 256, 1024})
            if (levels == 3 || texels == 256) expect_list_row(k, scene, texels);
    }
}

}  // namespace
}  // namespace umbra78::shadow::rivals::test
