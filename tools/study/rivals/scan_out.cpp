// A look into the first class: what the links and the second scan of Bouknight & Kelley take, by
// the size of the sectors and by which edges are projected.
#include "shadow/frame/rivals.hpp"
#include "shadow/rivals/costs.hpp"
#include "tools/render/aligned_room.hpp"
#include "tools/render/report.hpp"
#include "tools/study/rivals/rivals.hpp"

#include <algorithm>
#include <charconv>

namespace umbra78::tools::study {
namespace {

namespace rivals = shadow::rivals;

// Gives build(memory, needed) the memory that it asks for, until it is done.
template <class Build>
void build_in(AlignedRoom& room, Build&& build) {
    for (std::size_t needed = 0; !build(room.bytes(), needed);) room = AlignedRoom(needed);
}

int cells_of(const Case& c) {
    int cells = 0;
    const std::string_view text = extra_of(c, "cells");
    std::from_chars(text.data(), text.data() + text.size(), cells);
    return cells;
}

void set_counts(Row& row, const rivals::LinkCounts& links, const rivals::ScanOutCounts& scan) {
    const auto set = [&](const char* column, std::uint64_t n) {
        row.set(column, static_cast<std::int64_t>(n));
    };
    set("links", links.links);
    set("link_tests", links.box_tests);
    set("edges_projected", scan.edges);
    set("crossings", scan.crossings);
    set("runs_stopped", scan.stopped);
}

}  // namespace

Row scan_out_row(const LoadedScene& scene, const Case& c) {
    RenderJob job(scene.view(), scene.settings);
    job.draw_observer();
    const shadow::FrameInputs& in = job.inputs();
    AlignedRoom room(shadow::rival_bytes(in)), link_room(0), border_room(0);
    const shadow::RivalView view = shadow::rival_view(in, 0, room.bytes());
    const rivals::Setting& s = view.setting;

    rivals::Links links;
    rivals::LinkCounts link_counts;
    build_in(link_room, [&](std::span<std::byte> memory, std::size_t& needed) {
        link_counts = {};
        return links.build(s, view.shown, {.cells = cells_of(c)}, memory, needed, link_counts) ==
               rivals::LinkStatus::ok;
    });
    rivals::Borders borders;
    rivals::BorderCounts border_counts;
    const bool contours = extra_of(c, "edges") == "contour";
    if (contours)
        build_in(border_room, [&](std::span<std::byte> memory, std::size_t& needed) {
            border_counts = {};
            return borders.build(s, links, memory, needed, border_counts);
        });
    std::vector<rivals::CounterChange> changes(
        std::max(2 * link_counts.longest, border_counts.longest));
    std::vector<std::uint8_t> mask(view.shown.size());
    rivals::ScanOutCounts counts;
    fixed::require(rivals::bouknight_kelley(
                       s, view.shown, links, contours ? &borders : nullptr,
                       {.stop_when_dark = extra_of(c, "stop") == "yes"}, changes, mask, counts),
                   "a run has more crossings than its links allow");

    hw::Operations taken = rivals::work_of(link_counts, counts, s.mesh, mask.size()).frame;
    if (contours)
        taken = taken + border_counts.signs * rivals::cost::plane_side +
                border_counts.box_tests * rivals::cost::box_test;
    Row row;
    row.set("facets", static_cast<std::int64_t>(s.mesh.facets.size()));
    row.set("mask_hash", hash_of(Buffer{"mask", in.settings.machine.size_px(), 255,
                                        std::span<const std::uint8_t>(mask)}));
    set_counts(row, link_counts, counts);
    row.set("shadow_cycles",
            static_cast<std::int64_t>(
                shadow::method_of(in).units(taken, in.settings).side_by_side()));
    return row;
}

}  // namespace umbra78::tools::study
