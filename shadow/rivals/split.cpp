#include "shadow/rivals/split.hpp"

#include "shadow/rivals/visible.hpp"

namespace umbra78::shadow::rivals {
namespace {

// Cuts what is lit of R by F. False if there is no more room.
bool shade_by(LightLines& lines, std::uint32_t r, std::uint32_t f, Before before,
              LitPart& lit_part, PieceStore& out, CutCounts& counts) {
    std::array<LineId, 4> footprint{};
    for (std::size_t k = 0; k < 3; ++k) footprint[k] = lines.side(f, k);
    const std::size_t meetings = lines.meetings();
    std::size_t count = 3;
    if (before == Before::partly) {
        footprint[count++] = lines.meeting(r, f, -lines.setting().light.sides[f]);
        if (!lines.fits()) return false;
    }
    if (!lit_part.shade(std::span(&f, 1), std::span(footprint).first(count), out, counts))
        lines.release(meetings);  // no piece has the line
    return lit_part.fits();
}

}  // namespace

void find_receivers(const Setting& setting, std::span<const std::uint32_t> shown,
                    std::span<std::uint8_t> wanted) {
    std::fill(wanted.begin(), wanted.end(), std::uint8_t{0});
    for (const std::uint32_t f : shown)
        if (f != nothing_seen && !setting.attached(f)) wanted[f] = 1;
}

PieceStatus split(LightLines& lines, Casters& casters, std::span<const std::uint8_t> wanted,
                  LitPart& lit_part, PieceStore& out, SplitCounts& counts) {
    const Setting& setting = lines.setting();
    for (std::uint32_t r = 0; r < setting.mesh.facets.size(); ++r) {
        if (setting.light.sides[r] == 0 || (!wanted.empty() && wanted[r] == 0)) continue;
        ++counts.receivers;
        lit_part.begin(lines, r, lines.outline(r, counts.cuts.signs));
        casters.for_each(r, [&](std::uint32_t f, Before before) {
            if (lit_part.is_dark()) {
                ++counts.all_dark;
                return false;
            }
            return shade_by(lines, r, f, before, lit_part, out, counts.cuts);
        });
        if (!lines.fits()) return PieceStatus::no_meetings;
        if (!lit_part.fits()) return PieceStatus::no_work_room;
        lit_part.finish(out);
    }
    counts.casters = casters.counts();
    return out.finish() ? PieceStatus::ok : PieceStatus::no_room;
}

}  // namespace umbra78::shadow::rivals
