#include "shadow/rivals/atherton.hpp"

#include "shadow/rivals/brute.hpp"

#include <algorithm>
#include <bit>

namespace umbra78::shadow::rivals {
namespace {

// A convex outline while it is cut by one line.
struct Outline {
    std::array<LineId, most_template_sides> lines{};
    std::size_t count = 0;

    void add(LineId line) { lines[count++] = line; }
    std::span<const LineId> sides() const { return std::span(lines).first(count); }
};

// What of a facet's outline is inside a line. Nothing, if it is wholly outside.
Outline part_inside(const LightLines& lines, const std::array<LineId, 3>& outline, LineId line,
                    MovedCounts& counts) {
    Outline part;
    bool before = moved_sign(lines, outline[2], outline[0], line, counts) > 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const bool after = moved_sign(lines, outline[k], outline[(k + 1) % 3], line, counts) > 0;
        if (before || after) part.add(outline[k]);
        if (before && !after) part.add(line);
        before = after;
    }
    return part;
}

struct OutlineClipping {
    LightLines& lines;
    Casters& casters;
    std::span<ListedCaster> room;
    LoopClip& lit_part;
    AthertonCounts& counts;

    // False if there is no more room.
    bool clip(std::uint32_t r);

private:
    std::span<ListedCaster> listed(std::uint32_t r);
    bool clip_by(std::uint32_t r, const ListedCaster& caster);
};

// What may shadow R, the nearest to the light first.
std::span<ListedCaster> OutlineClipping::listed(std::uint32_t r) {
    const std::int64_t own = nearest_depth(lines.setting(), r);
    std::size_t count = 0;
    casters.for_each(r, [&](std::uint32_t f, Before before) {
        const std::int64_t depth = nearest_depth(lines.setting(), f);
        counts.wrong += depth > own || (depth == own && f > r) ? 1 : 0;
        room[count++] = {depth, f, before};
        return true;
    });
    counts.sorting += count * static_cast<std::size_t>(std::bit_width(count));
    const auto list = room.first(count);
    std::sort(list.begin(), list.end(), [](const ListedCaster& a, const ListedCaster& b) {
        return a.depth != b.depth ? a.depth < b.depth : a.facet < b.facet;
    });
    return list;
}

bool OutlineClipping::clip_by(std::uint32_t r, const ListedCaster& caster) {
    const auto outline = lines.outline(caster.facet, counts.clips.moved.signs);
    const std::size_t meetings = lines.meetings();
    Outline part{{outline[0], outline[1], outline[2]}, 3};
    if (caster.before == Before::partly) {
        const LineId line =
            lines.meeting(r, caster.facet, -lines.setting().light.sides[caster.facet]);
        if (!lines.fits()) return false;
        part = part_inside(lines, outline, line, counts.clips.moved);
    }
    if (part.count == 0 || !lit_part.take_away(part.sides(), counts.clips))
        lines.release(meetings);  // no loop has the line
    return lit_part.fits();
}

bool OutlineClipping::clip(std::uint32_t r) {
    ++counts.receivers;
    lit_part.begin(lines, r, lines.outline(r, counts.clips.moved.signs));
    if (!lit_part.fits()) return false;
    for (const ListedCaster& caster : listed(r)) {
        if (lit_part.is_dark()) {
            ++counts.all_dark;
            break;
        }
        if (!clip_by(r, caster)) return false;
    }
    return true;
}

}  // namespace

PieceStatus clip_by_outlines(LightLines& lines, Casters& casters,
                             std::span<const std::uint8_t> wanted, std::span<ListedCaster> room,
                             LoopClip& lit_part, LoopStore& out, AthertonCounts& counts) {
    const Setting& setting = lines.setting();
    const std::size_t facets = setting.mesh.facets.size();
    if (room.size() < facets) return PieceStatus::no_work_room;
    OutlineClipping clipping{lines, casters, room, lit_part, counts};
    for (std::uint32_t r = 0; r < facets; ++r) {
        if (setting.light.sides[r] == 0 || (!wanted.empty() && wanted[r] == 0)) continue;
        if (!clipping.clip(r))
            return lines.fits() ? PieceStatus::no_work_room : PieceStatus::no_meetings;
        for (const Loop& loop : lit_part.lit().loops()) out.copy(lit_part.lit(), loop);
    }
    counts.casters = casters.counts();
    counts.loops = out.count().loops, counts.sides = out.count().sides;
    counts.longest = out.longest();
    return out.fits() ? PieceStatus::ok : PieceStatus::no_room;
}

// --- the second pass ------------------------------------------------------------------------

namespace {

// The loops of one facet, which follow each other.
struct FacetLoops {
    std::span<const Loop> loops;
    std::span<const LoopSide> sides;  // of all facets
    std::uint32_t facet() const { return loops.front().facet; }
    std::size_t first() const { return loops.front().first; }
    std::size_t count() const { return loops.back().first + loops.back().count - first(); }
};

// visit(the loops of each facet).
template <class Visit>
void for_facets(const LoopStore& store, Visit&& visit) {
    const auto loops = store.loops();
    for (std::size_t from = 0, to = 0; from < loops.size(); from = to) {
        while (to < loops.size() && loops[to].facet == loops[from].facet) ++to;
        visit(FacetLoops{loops.subspan(from, to - from), store.sides()});
    }
}

// The columns of a run at which a line's sign is -1, if `inside` are those where it is 1.
Run rest_of(const Run& run, const Run& inside) {
    if (inside.empty()) return run;
    return inside.from == run.from ? Run{inside.to, run.to} : Run{run.from, inside.from};
}

// Marks where along a row it becomes inside the loops or outside. A side that the row crosses
// counts for the pixels on one side of it, which is its inside or its outside as it goes up or
// down.
void find_flips(const LightLines& lines, const FacetLoops& of, std::span<const ShownLine> shown,
                const Run& run, int row, std::span<std::uint8_t> flips, LoopMaskCounts& counts) {
    const SeenRow seen = seen_row(lines, of.facet(), row);
    const Space& space = lines.setting().space;
    const auto side_of_corner = [&](const LoopSide& a, const LoopSide& b) {
        return row_sign(lines, a.line, b.line, seen) * (a.is_reflex ? -1 : 1);
    };
    for (const Loop& loop : of.loops) {
        const auto sides = of.sides.subspan(loop.first, loop.count);
        const int last = side_of_corner(sides.back(), sides.front());
        int before = last;
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const int after =
                i + 1 < sides.size() ? side_of_corner(sides[i], sides[i + 1]) : last;
            if (before != after) {
                ++counts.crossings;
                const Run inside = shown[loop.first - of.first() + i].inside(space, run, row);
                const Run counted = after > 0 ? inside : rest_of(run, inside);
                if (!counted.empty()) {
                    flips[static_cast<std::size_t>(counted.from)] ^= 1;
                    flips[static_cast<std::size_t>(counted.to)] ^= 1;
                }
            }
            before = after;
        }
    }
}

void draw(const LightLines& lines, const FacetLoops& of, std::span<const std::uint32_t> shown,
          std::span<ShownLine> room, std::span<std::uint8_t> flips,
          std::span<std::uint8_t> mask, LoopMaskCounts& counts) {
    const Setting& setting = lines.setting();
    const std::uint32_t facet = of.facet();
    if (setting.eye.sides[facet] == 0 || setting.attached(facet)) return;
    for (std::size_t k = 0; k < of.count(); ++k)
        room[k] = lines.shown(facet, of.sides[of.first() + k].line);
    counts.loops += of.loops.size();
    const Run rows = rows_of(setting, facet);
    for (int row = rows.from; row < rows.to; ++row) {
        counts.sides += of.count();
        const Run run = setting.covered_run(facet, row);
        if (run.empty()) continue;
        std::fill(flips.begin() + run.from, flips.begin() + run.to + 1, std::uint8_t{0});
        find_flips(lines, of, room, run, row, flips, counts);
        const std::size_t start =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(setting.space.size_px());
        std::uint8_t is_lit = 0;
        for (int column = run.from; column < run.to; ++column) {
            is_lit ^= flips[static_cast<std::size_t>(column)];
            const std::size_t at = start + static_cast<std::size_t>(column);
            if (shown[at] != facet || is_lit == 0) continue;
            ++counts.pixels;
            mask[at] = lit;
        }
    }
}

}  // namespace

std::size_t most_sides(const LoopStore& store) {
    std::size_t most = 0;
    for_facets(store, [&](const FacetLoops& of) { most = std::max(most, of.count()); });
    return most;
}

bool mask_of_loops(const LightLines& lines, const LoopStore& store,
                   std::span<const std::uint32_t> shown, std::span<ShownLine> room,
                   std::span<std::uint8_t> flips, std::span<std::uint8_t> mask,
                   LoopMaskCounts& counts) {
    const auto row = static_cast<std::size_t>(lines.setting().space.size_px());
    if (room.size() < most_sides(store) || flips.size() < row + 1) return false;
    for (std::size_t at = 0; at < mask.size(); ++at)
        mask[at] = shown[at] == nothing_seen ? lit : dark;
    for_facets(store, [&](const FacetLoops& of) {
        draw(lines, of, shown, room, flips, mask, counts);
    });
    return true;
}

}  // namespace umbra78::shadow::rivals
