#include "tools/truth/edge_distance.hpp"

#include "tools/truth/image_walk.hpp"
#include "tools/truth/real3.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace umbra78::tools {
namespace {

// Squared distances to the nearest marked place of a line of them, each with a squared distance
// of its own: the lower envelope of parabolas (Felzenszwalb and Huttenlocher, "Distance Transforms
// of Sampled Functions", 2012).
class LineDistance {
public:
    explicit LineDistance(int size) : apex_(size), from_(size + 1) {}

    // read(i) is the squared distance that place i has already; write(i, d) takes the new one.
    template <class Read, class Write>
    void operator()(int size, Read read, Write write) {
        int last = -1;
        for (int q = 0; q < size; ++q) {
            if (read(q) == infinity) continue;
            double start = -infinity;
            while (last >= 0) {
                const int p = apex_[last];
                start = (read(q) - read(p) + double(q) * q - double(p) * p) / (2.0 * (q - p));
                if (start > from_[last]) break;
                --last;
            }
            if (last < 0) start = -infinity;
            apex_[++last] = q;
            from_[last] = start;
        }
        for (int q = 0, k = 0; q < size && last >= 0; ++q) {
            while (k < last && from_[k + 1] < q) ++k;
            const double d = q - apex_[k];
            write(q, d * d + read(apex_[k]));
        }
    }

private:
    std::vector<int> apex_;
    std::vector<double> from_;
};

// Of every pixel to the nearest marked one of its column; `nowhere` where none is marked.
constexpr int nowhere = 1 << 30;
std::vector<int> along_columns(const std::vector<std::uint8_t>& marked, int size) {
    const auto n = static_cast<std::size_t>(size);
    std::vector<int> distance(marked.size());
    for (std::size_t at = 0; at < marked.size(); ++at) {
        const int above = at < n ? nowhere : distance[at - n];
        distance[at] = marked[at] ? 0 : std::min(above + 1, nowhere);
    }
    for (std::size_t at = marked.size() - n; at-- > 0;)
        distance[at] = std::min(distance[at], distance[at + n] + 1);
    return distance;
}

// Of each asked pixel to the nearest marked one, in pixels; infinite where none is marked. It says
// nothing of what is not asked.
std::vector<double> distances_to(const std::vector<std::uint8_t>& marked,
                                 const std::vector<std::uint8_t>& asked, int size) {
    const std::vector<int> in_column = along_columns(marked, size);
    std::vector<double> distance(marked.size()), row(static_cast<std::size_t>(size));
    LineDistance along_line(size);
    for (std::size_t start = 0; start < marked.size(); start += row.size()) {
        const auto first = asked.begin() + static_cast<std::ptrdiff_t>(start);
        if (std::find(first, first + size, 1) == first + size) continue;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const int d = in_column[start + i];
            row[i] = d < nowhere ? double(d) * d : infinity;
        }
        std::fill_n(distance.begin() + static_cast<std::ptrdiff_t>(start), size, infinity);
        along_line(size, [&](int i) { return row[static_cast<std::size_t>(i)]; },
                   [&](int i, double squared) {
                       const std::size_t at = start + static_cast<std::size_t>(i);
                       if (asked[at]) distance[at] = std::sqrt(squared);
                   });
    }
    return distance;
}

// The pixels in shadow with a lit 4-neighbour, of those compared.
template <class InShadow>
std::vector<std::uint8_t> shadow_edge(int size, const std::vector<std::uint8_t>& compared,
                                      InShadow in_shadow) {
    std::vector<std::uint8_t> edge(compared.size());
    for (std::size_t at = 0; at < edge.size(); ++at) {
        if (!compared[at] || !in_shadow(at)) continue;
        bool beside_light = false;
        for_disc(size, at, 1, [&](std::size_t other) {
            beside_light |= compared[other] && !in_shadow(other);
        });
        edge[at] = beside_light;
    }
    return edge;
}

}  // namespace

EdgeDistance edge_distance(const Truth& truth, const MachineMask& mask,
                           std::span<const std::uint8_t> leave_out) {
    std::vector<std::uint8_t> compared(truth.visible.size());
    for_compared(truth, mask, leave_out, [&](std::size_t at) { compared[at] = 1; });
    const auto true_edge =
        shadow_edge(truth.size, compared, [&](std::size_t at) { return !truth.lit[at]; });
    const auto drawn_edge =
        shadow_edge(truth.size, compared, [&](std::size_t at) { return mask.in_shadow(at); });
    const auto from_true = distances_to(true_edge, drawn_edge, truth.size);
    const auto from_drawn = distances_to(drawn_edge, true_edge, truth.size);
    double sum = 0, max = 0;
    std::size_t pixels = 0;
    const auto measure = [&](const auto& edge, const auto& distance) {
        for (std::size_t at = 0; at < edge.size(); ++at) {
            if (!edge[at]) continue;
            sum += distance[at];
            max = std::max(max, distance[at]);
            ++pixels;
        }
    };
    measure(true_edge, from_drawn);
    measure(drawn_edge, from_true);
    if (pixels == 0 || max == infinity) return {std::nan(""), std::nan("")};
    return {sum / static_cast<double>(pixels), max};
}

}  // namespace umbra78::tools
