// The tables of shadow/rivals/object_space.md and atherton.md, and the rows that the program makes
// of them.
#pragma once

#include "tests/shadow/rivals/atherton.hpp"
#include "tests/shadow/rivals/figures_scene.hpp"
#include "tests/shadow/rivals/partition.hpp"
#include "tests/support/paths.hpp"

#include <fstream>
#include <sstream>

namespace umbra78::shadow::rivals::test {

using Row = std::vector<std::uint64_t>;

// The row that begins with k of the table below a heading; empty if there is none.
inline Row published_row(const std::string& heading, int k,
                         const std::string& text = "object_space.md") {
    std::ifstream file(UMBRA78_SOURCE_DIR "/shadow/rivals/" + text);
    bool here = false;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with('#')) here = line.ends_with("# " + heading);
        if (!here || !line.starts_with("| " + std::to_string(k) + " |")) continue;
        std::replace(line.begin(), line.end(), '|', ' ');
        std::istringstream words(line);
        Row row;
        for (std::uint64_t v = 0; words >> v;) row.push_back(v);
        return row;
    }
    return {};
}

// Room for the figures' scene.
inline Capacities figures_room(const Setting& setting) {
    const std::size_t n = setting.mesh.facets.size();
    return {256, {1024, 8192, 64}, {4 * n + 1024, 16 * n + 4096}, {n + 64, 4 * n, 64}};
}

inline std::uint64_t lit_pieces(const PieceStore& store) {
    const auto pieces = store.pieces();
    return static_cast<std::uint64_t>(
        std::count_if(pieces.begin(), pieces.end(), [](const Piece& p) { return p.is_lit; }));
}

// After split().
inline Row split_row(ObjectSpace& o, const Setting& setting, int k) {
    const SplitCounts& c = o.split_counts();
    const SignCounts& s = c.cuts.signs;
    return {static_cast<std::uint64_t>(k), setting.mesh.facets.size(), c.receivers,
            c.casters.boxes, c.casters.casters, c.cuts.boxes, c.cuts.corners, c.cuts.tests,
            c.cuts.cuts, c.cuts.undone,
            s.edges + s.meetings, o.store().needed().pieces, lit_pieces(o.store()),
            o.store().needed().lines};
}

// After sort_from_light() and clip().
inline Row perimeter_row(ObjectSpace& o, int k) {
    const OrderCounts& order = o.order_counts();
    const PerimeterCounts& c = o.perimeter_counts();
    const SignCounts &s = order.cuts.signs, &t = c.cuts.signs;
    return {static_cast<std::uint64_t>(k), c.fragments,
            o.order_casters().boxes + c.casters.boxes, order.asked, c.joined, c.compared, c.pairs,
            c.cuts.boxes, c.cuts.tests, c.cuts.cuts, s.edges + s.meetings + t.edges + t.meetings,
            o.store().needed().pieces, lit_pieces(o.store()), o.store().needed().lines};
}

// Splitting, of the facets that are seen or of all, makes the published row and brute force's mask.
inline void check_split(const FiguresScene& scene, int k, bool only_seen) {
    ObjectSpace o(scene.setting(), scene.shown(), figures_room(scene.setting()));
    ASSERT_EQ(o.split(only_seen), PieceStatus::ok);
    const std::string table =
        only_seen ? "Splitting of the facets that are seen" : "Splitting of all facets";
    EXPECT_EQ(split_row(o, scene.setting(), k), published_row(table, k)) << table;
    BruteCounts counts;
    EXPECT_EQ(o.mask(), o.brute_mask(counts)) << table << ", k " << k;
    EXPECT_EQ(pixels_in_pieces(o, scene.shown()), counts.points);  // each is in one piece
    expect_partition(o, scene.shown(), 97);
}

inline void check_perimeters(const FiguresScene& scene, int k, bool in_pairs) {
    ObjectSpace o(scene.setting(), scene.shown(), figures_room(scene.setting()));
    ASSERT_EQ(o.sort_from_light(), OrderStatus::ok);
    ASSERT_EQ(o.clip(in_pairs), PieceStatus::ok);
    const std::string table = in_pairs ? "Perimeters, merged by two" : "Perimeters";
    EXPECT_EQ(perimeter_row(o, k), published_row(table, k)) << table;
    EXPECT_EQ(o.order_counts().cycles, 0u);
    EXPECT_EQ(o.order_counts().hides, k == 16 ? 8u : 0u);
    BruteCounts counts;
    EXPECT_EQ(o.mask(), o.brute_mask(counts)) << "k " << k;
    EXPECT_EQ(pixels_in_pieces(o, scene.shown()), counts.points);  // each is in one piece
    expect_partition(o, scene.shown(), 97);
}

// After clip().
inline Row outlines_row(const Outlines& o, const Setting& setting, int k) {
    const AthertonCounts& c = o.counts();
    const ClipCounts& clips = c.clips;
    const SignCounts& s = clips.moved.signs;
    return {static_cast<std::uint64_t>(k), setting.mesh.facets.size(), c.receivers,
            c.casters.casters, c.wrong, clips.clips, clips.corners, clips.crossings, clips.walks,
            clips.flat, clips.holes, clips.inside, s.edges + s.meetings, clips.moved.ties,
            c.loops, c.sides, c.longest};
}

// Outlines taken away from the facets that are seen, or from all, make the published row and brute
// force's mask.
inline void check_outlines(const FiguresScene& scene, int k, bool only_seen) {
    const std::size_t n = scene.setting().mesh.facets.size();
    Outlines o(scene.setting(), scene.shown(), {256, {{256, 8192}, 1024}, {n, 4 * n + 1024}});
    ASSERT_EQ(o.clip(only_seen), PieceStatus::ok);
    const std::string table =
        only_seen ? "Outlines taken away from the facets that are seen"
                  : "Outlines taken away from all facets";
    EXPECT_EQ(outlines_row(o, scene.setting(), k), published_row(table, k, "atherton.md"))
        << table;
    EXPECT_EQ(o.mask(), scene.brute_mask()) << table << ", k " << k;
}

}  // namespace umbra78::shadow::rivals::test
