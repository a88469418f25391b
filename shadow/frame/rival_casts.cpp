#include "shadow/frame/rival_casts.hpp"

#include "shadow/frame/object_space_casts.hpp"

namespace umbra78::shadow::rivals {
namespace {

using Shown = std::span<const std::uint32_t>;
using Mask = std::span<std::uint8_t>;
using SettingOf = const Setting&;

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

}  // namespace

Work cast_by(Form form, const Setting& setting, std::span<const std::uint32_t> shown,
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
        case Form::perimeters: return by_perimeters(setting, shown, carver, mask);
        case Form::atherton: return by_outlines(setting, shown, carver, mask);
        case Form::irregular: return by_irregular(setting, shown, carver, mask);
        default: return by_brute(setting, shown, carver, mask);
    }
}

}  // namespace umbra78::shadow::rivals
