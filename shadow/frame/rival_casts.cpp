#include "shadow/frame/rival_casts.hpp"

#include "shadow/frame/object_space_casts.hpp"

namespace umbra78::shadow {
namespace {

using namespace rivals;
using Shown = std::span<const std::uint32_t>;
using Mask = std::span<std::uint8_t>;
using SettingOf = const rivals::Setting&;

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

Work by_volumes(SettingOf s, Shown shown, Carver& carver, Mask mask) {
    const auto contour = carver.take<ContourEdge>(find_contour(s, {}));
    const auto surfaces = carver.take<std::int32_t>(shown.size());
    if (!carver.fits()) return {};
    find_contour(s, contour);
    VolumeCounts counts;
    count_volumes(s, shown, contour, surfaces, counts);
    mask_of_counts(s, shown, surfaces, mask);
    return work_of(counts, mask.size());
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

Work cast_by(Form form, const rivals::Setting& setting, std::span<const std::uint32_t> shown,
             Carver& carver, std::span<std::uint8_t> mask) {
    switch (form) {
        case Form::volumes: return by_volumes(setting, shown, carver, mask);
        case Form::bouknight_kelley: return by_scan_out(setting, shown, carver, mask);
        case Form::appel: return by_appel(setting, shown, carver, mask);
        case Form::splitting: return by_splitting(setting, shown, carver, mask);
        case Form::perimeters: return by_perimeters(setting, shown, carver, mask);
        case Form::irregular: return by_irregular(setting, shown, carver, mask);
        default: return by_brute(setting, shown, carver, mask);
    }
}

}  // namespace umbra78::shadow
