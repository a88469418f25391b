// The page of the study of rivals: pictures of what the classes work with.
#include "shadow/frame/object_space_casts.hpp"
#include "shadow/frame/rivals.hpp"
#include "tools/render/aligned_room.hpp"
#include "tools/study/rivals/tables.hpp"
#include "tools/study/strip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace umbra78::tools::study {
namespace {

namespace rivals = shadow::rivals;
using Panel = std::vector<std::uint8_t>;

constexpr std::uint8_t nothing_grey = 235, attached_grey = 90;

// Spreads the numbers of neighbours over 0 .. 1.
double spread(std::uint32_t number) {
    return static_cast<double>(number * 2654435761u >> 8) / 0x1p24;
}

std::uint8_t grey(double value) {
    return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0l, 255l));
}

// What each pixel shows of the facets, and what is put over it: tone(facet, pixel).
template <class Tone>
Panel panel_of(const shadow::RivalView& view, Tone&& tone) {
    Panel panel(view.shown.size(), nothing_grey);
    for (std::size_t at = 0; at < panel.size(); ++at)
        if (const std::uint32_t facet = view.shown[at]; facet != rivals::nothing_seen)
            panel[at] = view.setting.attached(facet) ? attached_grey : tone(facet, at);
    return panel;
}

// The sides of all volumes that cover a pixel, whether before or behind what is seen.
Panel volumes_panel(const shadow::RivalView& view) {
    const rivals::Setting& s = view.setting;
    std::vector<rivals::ContourEdge> contour(rivals::find_contour(s, {}));
    rivals::find_contour(s, contour);
    std::vector<int> sides(view.shown.size());
    const int size = s.space.size_px();
    for (const rivals::ContourEdge& edge : contour) {
        const rivals::ShadowSide side(s, edge);
        if (!side.is_seen()) continue;
        for (int y = 0; y < size; ++y) {
            const rivals::Run run = side.covered_run(s.space, y);
            for (int x = run.from; x < run.to; ++x)
                ++sides[static_cast<std::size_t>(y) * static_cast<std::size_t>(size) +
                        static_cast<std::size_t>(x)];
        }
    }
    Panel panel(view.shown.size());
    for (std::size_t at = 0; at < panel.size(); ++at) {
        const bool seen = view.shown[at] != rivals::nothing_seen;
        panel[at] = grey((seen ? 170 : nothing_grey) * std::pow(0.8, sides[at]));
    }
    return panel;
}

// cut(workshop) in as much memory as it asks for.
template <class Cut>
void with_workshop(const shadow::RivalView& view, bool has_order, Cut&& cut) {
    for (std::size_t bytes = std::size_t{1} << 20;;) {
        AlignedRoom room(bytes);
        shadow::Carver carver(room.bytes().first(bytes));
        rivals::in_workshop(view.setting, carver, has_order, cut);
        if (carver.fits()) return;
        bytes = carver.used();
    }
}

Panel pieces_panel(const shadow::RivalView& view) {
    Panel panel;
    with_workshop(view, false, [&](rivals::Workshop& w) {
        rivals::SplitCounts counts;
        rivals::MaskCounts mask_counts;
        std::vector<std::uint32_t> pieces(view.shown.size());
        if (split(w.lines, w.casters, {}, w.lit_part, w.store, counts) !=
                rivals::PieceStatus::ok ||
            !pieces_of_pixels(w.lines, w.store, view.shown, w.shown, pieces, mask_counts))
            return false;
        panel = panel_of(view, [&](std::uint32_t, std::size_t at) {
            const std::uint32_t piece = pieces[at];
            if (piece == rivals::no_piece) return attached_grey;
            const bool is_lit = w.store.pieces()[piece].is_lit;
            return grey((is_lit ? 150 : 20) + 80 * spread(piece));
        });
        return true;
    });
    return panel;
}

Panel order_panel(const shadow::RivalView& view) {
    Panel panel;
    with_workshop(view, true, [&](rivals::Workshop& w) {
        rivals::OrderCounts counts;
        if (w.order.make(w.lines, w.casters, counts) != rivals::OrderStatus::ok) return false;
        std::vector<std::uint32_t> ranks(view.setting.mesh.facets.size());
        w.order.rank_facets(ranks);
        const auto last = static_cast<double>(w.order.order().size());
        panel = panel_of(view, [&](std::uint32_t facet, std::size_t) {
            if (ranks[facet] == rivals::LightOrder::none) return attached_grey;
            return grey(250 - 230 * ranks[facet] / last);
        });
        return true;
    });
    return panel;
}

}  // namespace

// The study's scene, coarsely diced, so that facets can be told apart.
void report_insides(const Request& request, std::span<const Row> all, Report& report) {
    if (rows_of(all, question::dicing, "splitting").empty()) return;
    Case c;
    c.set = {"form=splitting", "dice_levels=2"};
    if (request.quick) c.set.push_back("xy_bits=6");
    const LoadedScene scene = scene_of(request, c);
    RenderJob job(scene.view(), scene.settings);
    AlignedRoom room(shadow::rival_bytes(job.inputs()));
    const shadow::RivalView view = shadow::rival_view(job.inputs(), 0, room.bytes());
    const std::vector<Panel> panels{volumes_panel(view), pieces_panel(view), order_panel(view)};
    const Strip strip = side_by_side(panels, scene.settings.machine.size_px());
    report.heading("What the classes work with");
    report.picture("rivals-insides", strip.width, strip.height, strip.gray,
                   "From the left, with patches diced into 4 x 4 cells. The sides of shadow "
                   "volumes: each that covers a pixel darkens it, whether it lies before or behind "
                   "what is seen. Facets split by their casters: each piece has a grey of its own, "
                   "light ones lit, dark ones in shadow. The facets' order from the light: the "
                   "nearest white, the farthest dark. What is turned from the light is one grey.");
}

}  // namespace umbra78::tools::study
