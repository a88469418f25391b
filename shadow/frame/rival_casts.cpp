#include "shadow/frame/rival_casts.hpp"

#include <algorithm>

namespace umbra78::shadow {
namespace {

using namespace rivals;
using Shown = std::span<const std::uint32_t>;
using Mask = std::span<std::uint8_t>;
using SettingOf = const rivals::Setting&;

// What takes its memory from the rest and says how much it needs: build(memory, needed).
template <class Build>
bool built_from(Carver& carver, Build&& build) {
    if (!carver.fits()) return false;
    std::size_t needed = 0;
    const bool done = build(carver.rest(), needed);
    carver.take<std::byte>(needed);
    return done && carver.fits();
}

bool built_grid(SettingOf s, Carver& carver, LightGrid& grid) {
    return built_from(carver, [&](std::span<std::byte> memory, std::size_t& needed) {
        return grid.build(s, 0, memory, needed);
    });
}

bool built_links(SettingOf s, Shown shown, Carver& carver, Links& links, LinkCounts& counts) {
    return built_from(carver, [&](std::span<std::byte> memory, std::size_t& needed) {
        return links.build(s, shown, {}, memory, needed, counts) == LinkStatus::ok;
    });
}

Work by_brute(SettingOf s, Shown shown, Carver& carver, Mask mask) {
    LightGrid grid;
    if (!built_grid(s, carver, grid)) return {};
    BruteCounts counts;
    brute(s, shown, &grid, mask, counts);
    return work_of(counts, s.mesh, mask.size());
}

// Class 3: count(contour, surfaces, work) writes a number a pixel, which is 0 where it is lit, and
// what it took. False if its memory is too small.
template <class Count>
Work by_counts(SettingOf s, Shown shown, Carver& carver, Mask mask, Count&& count) {
    const auto contour = carver.take<ContourEdge>(find_contour(s, {}));
    const auto surfaces = carver.take<std::int32_t>(shown.size());
    if (!carver.fits()) return {};
    find_contour(s, contour);
    Work work;
    if (!count(contour, surfaces, work)) return {};
    mask_of_counts(s, shown, surfaces, mask);
    return work;
}

using Contour = std::span<const ContourEdge>;
using Surfaces = std::span<std::int32_t>;

Work by_volumes(SettingOf s, Shown shown, Carver& carver, Mask mask) {
    return by_counts(s, shown, carver, mask, [&](Contour contour, Surfaces surfaces, Work& work) {
        VolumeCounts counts;
        count_volumes(s, shown, contour, surfaces, counts);
        work = work_of(counts, mask.size());
        return true;
    });
}

Work by_order(SettingOf s, Shown shown, Carver& carver, Mask mask) {
    return by_counts(s, shown, carver, mask, [&](Contour contour, Surfaces surfaces, Work& work) {
        OrderedCounts counts;
        const bool done = built_from(carver, [&](std::span<std::byte> memory, std::size_t& needed) {
            const bool fits = order_volumes(s, shown, contour, memory, surfaces, counts);
            needed = counts.bytes;
            return fits;
        });
        work = work_of(counts, mask.size());
        return done;
    });
}

Work by_stencil(SettingOf s, Shown shown, const DepthScale& scale, StencilPass pass,
                Carver& carver, Mask mask) {
    return by_counts(s, shown, carver, mask, [&](Contour contour, Surfaces counters, Work& work) {
        const auto codes = carver.take<std::uint32_t>(shown.size());
        if (!carver.fits()) return false;
        StencilCounts counts;
        count_stencil(s, shown, contour, scale, {pass}, {codes, counters}, counts);
        work = work_of(counts, mask.size());
        return true;
    });
}

Work by_scan_out(SettingOf s, Shown shown, Carver& carver, Mask mask) {
    Links links;
    LinkCounts link_counts;
    if (!built_links(s, shown, carver, links, link_counts)) return {};
    const auto room = carver.take<CounterChange>(2 * link_counts.longest);
    if (!carver.fits()) return {};
    ScanOutCounts counts;
    bouknight_kelley(s, shown, links, nullptr, {}, room, mask, counts);
    return work_of(link_counts, counts, s.mesh, mask.size());
}

Work by_appel(SettingOf s, Shown shown, Carver& carver, Mask mask) {
    const auto surfaces = carver.take<std::int32_t>(shown.size());
    LightGrid grid;
    Links links;
    Borders borders;
    LinkCounts link_counts;
    BorderCounts border_counts;
    const bool built = built_grid(s, carver, grid) &&
                       built_links(s, shown, carver, links, link_counts) &&
                       built_from(carver, [&](std::span<std::byte> memory, std::size_t& needed) {
                           return borders.build(s, links, memory, needed, border_counts);
                       });
    if (!built) return {};
    const auto room = carver.take<CounterChange>(border_counts.longest);
    if (!carver.fits()) return {};
    AppelCounts counts;
    appel(s, shown, &grid, borders, {}, room, surfaces, counts);
    mask_of_counts(s, shown, surfaces, mask);
    return work_of(link_counts, border_counts, counts, s.mesh, mask.size());
}

Work by_irregular(SettingOf s, Shown shown, Carver& carver, Mask mask) {
    IrregularCounts counts;
    const bool done = built_from(carver, [&](std::span<std::byte> memory, std::size_t& needed) {
        const bool fits = irregular(s, shown, {}, memory, mask, counts);
        needed = counts.bytes;
        return fits;
    });
    return done ? work_of(counts, s.mesh, mask.size()) : Work{};
}

// How much room pieces get: `turn` times as much for each step in which it was too little.
struct PieceRoom {
    std::size_t meetings;
    WorkSize work;
    PieceSize pieces;

    PieceRoom(std::size_t facets, std::size_t turn)
        : meetings(turn * 256), work{turn * 256, turn * 2048, turn * 32},
          pieces{turn * (4 * facets + 256), turn * (16 * facets + 1024)} {}
};

struct PieceParts {
    std::span<std::byte> lines, work, store;
    std::span<std::uint32_t> marks;
};

PieceParts parts_of(Carver& carver, const Mesh& mesh, const PieceRoom& room) {
    const std::size_t facets = mesh.facets.size();
    return {carver.take<std::byte>(LightLines::bytes(mesh, room.meetings)),
            carver.take<std::byte>(LitPart::bytes(room.work)),
            carver.take<std::byte>(PieceStore::bytes(room.pieces, facets)),
            carver.take<std::uint32_t>(facets)};
}

Work by_splitting(SettingOf s, Shown shown, Carver& carver, Mask mask) {
    const std::size_t facets = s.mesh.facets.size();
    LightGrid grid;
    if (!built_grid(s, carver, grid)) return {};
    // As much room as the memory has, in doublings; if that is too little, twice as much is asked.
    const auto needs = [&](std::size_t turn) {
        Carver trial(static_cast<std::byte*>(nullptr));
        parts_of(trial, s.mesh, PieceRoom(facets, turn));
        return trial.used();
    };
    std::size_t turn = 1;
    while (needs(2 * turn) <= carver.rest().size()) turn *= 2;
    Carver before = carver;
    const PieceRoom room(facets, turn);
    const PieceParts parts = parts_of(carver, s.mesh, room);
    if (!carver.fits()) return {};
    LightLines lines;
    if (!lines.make(s, room.meetings, parts.lines)) return {};
    LitPart lit_part(parts.work, room.work);
    PieceStore store(parts.store, room.pieces, facets);
    Casters casters(s, grid, parts.marks);
    SplitCounts counts;
    MaskCounts mask_counts;
    if (split(lines, casters, {}, lit_part, store, counts) != PieceStatus::ok) {
        carver = before;
        carver.take<std::byte>(needs(2 * turn));
        return {};
    }
    const auto shown_lines = carver.take<ShownLine>(store.longest());
    if (!carver.fits()) return {};
    mask_of_pieces(lines, store, shown, shown_lines, mask, mask_counts);
    return work_of(counts, mask_counts, store.pieces().size(), s.mesh, mask.size());
}

}  // namespace

Work cast_by(Form form, const rivals::Setting& setting, std::span<const std::uint32_t> shown,
             const DepthScale& scale, Carver& carver, std::span<std::uint8_t> mask) {
    const auto by_passes = [&](StencilPass pass) {
        return by_stencil(setting, shown, scale, pass, carver, mask);
    };
    switch (form) {
        case Form::volumes: return by_volumes(setting, shown, carver, mask);
        case Form::ordered_volumes: return by_order(setting, shown, carver, mask);
        case Form::stencil_pass: return by_passes(StencilPass::z_pass);
        case Form::stencil_fail: return by_passes(StencilPass::z_fail);
        case Form::bouknight_kelley: return by_scan_out(setting, shown, carver, mask);
        case Form::appel: return by_appel(setting, shown, carver, mask);
        case Form::splitting: return by_splitting(setting, shown, carver, mask);
        case Form::irregular: return by_irregular(setting, shown, carver, mask);
        default: return by_brute(setting, shown, carver, mask);
    }
}

}  // namespace umbra78::shadow
