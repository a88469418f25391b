#include "shadow/rivals/footprint_pairs.hpp"

#include <algorithm>

namespace umbra78::shadow::rivals {
namespace {

struct PairSpans {
    std::span<std::uint32_t> partners, taken;
    std::span<std::array<LineId, 4>> outlines;
};

PairSpans lay_out(Carver& carver, std::size_t facets) {
    return {carver.take<std::uint32_t>(facets), carver.take<std::uint32_t>(facets),
            carver.take<std::array<LineId, 4>>(facets)};
}

// The two lines that follow `last` in an outline.
std::array<LineId, 2> after(const std::array<LineId, 3>& outline, LineId last) {
    const std::size_t at = outline[0] == last ? 0 : outline[1] == last ? 1 : 2;
    return {outline[(at + 1) % 3], outline[(at + 2) % 3]};
}

}  // namespace

std::size_t FootprintPairs::bytes(std::size_t facets) {
    Carver carver(static_cast<std::byte*>(nullptr));
    lay_out(carver, facets);
    return carver.used();
}

bool FootprintPairs::join(const LightLines& lines, std::uint32_t f, std::size_t side,
                          std::uint32_t g, SignCounts& counts) {
    const LineId edge = lines.side(f, side);
    const auto g_outline = lines.outline(g, counts);
    if (std::find(g_outline.begin(), g_outline.end(), edge.turned()) == g_outline.end())
        return false;  // folded over it
    const auto [a, b] = after(lines.outline(f, counts), edge);
    const auto [c, d] = after(g_outline, edge.turned());
    if (lines.sign(c, d, a, counts) <= 0 || lines.sign(c, d, b, counts) <= 0) return false;
    partners_[f] = g, partners_[g] = f;
    outlines_[std::min(f, g)] = {a, b, c, d};
    ++pairs_;
    return true;
}

bool FootprintPairs::make(const LightLines& lines, std::span<std::byte> memory,
                          SignCounts& counts) {
    const Setting& setting = lines.setting();
    const Mesh& mesh = setting.mesh;
    Carver carver(memory);
    const PairSpans s = lay_out(carver, mesh.facets.size());
    if (!carver.fits()) return false;
    partners_ = s.partners, taken_ = s.taken, outlines_ = s.outlines;
    pairs_ = 0;
    std::fill(partners_.begin(), partners_.end(), none);
    std::fill(taken_.begin(), taken_.end(), none);
    for (std::uint32_t f = 0; f < partners_.size(); ++f) {
        if (setting.light.sides[f] == 0) continue;
        for (std::size_t k = 0; k < 3 && partners_[f] == none; ++k) {
            const Edge& edge = mesh.edges[mesh.sides[f][k] / 2];
            if (edge.count != 2) continue;
            const std::uint32_t one = mesh.half_edges[edge.first].facet;
            const std::uint32_t g = one != f ? one : mesh.half_edges[edge.first + 1].facet;
            if (g == f || partners_[g] != none || setting.light.sides[g] == 0) continue;
            join(lines, f, k, g, counts);
        }
    }
    return true;
}

}  // namespace umbra78::shadow::rivals
