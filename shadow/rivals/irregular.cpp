#include "shadow/rivals/irregular.hpp"

#include <algorithm>
#include <bit>

namespace umbra78::shadow::rivals {
namespace {

constexpr std::uint32_t no_sample = UINT32_MAX;

// The grid of lists.
class SampleGrid {
public:
    SampleGrid(std::span<IrregularSample> samples, std::span<std::uint8_t> faces,
               std::span<std::uint32_t> heads, int texels)
        : samples_(samples), faces_(faces), heads_(heads), side_(texels) {}

    void add(std::uint32_t pixel, const LightPlace& place) {
        faces_[count_] = static_cast<std::uint8_t>(place.face);
        samples_[count_++] = {place.u, place.v, pixel, no_sample};
    }
    void make_lists(IrregularCounts& counts) {
        std::int64_t u1 = INT64_MIN, v1 = INT64_MIN;
        u0_ = v0_ = INT64_MAX;
        for (const IrregularSample& s : samples_) {
            u0_ = std::min(u0_, s.u), u1 = std::max(u1, s.u);
            v0_ = std::min(v0_, s.v), v1 = std::max(v1, s.v);
        }
        std::fill(heads_.begin(), heads_.end(), no_sample);
        if (samples_.empty()) return;
        shift_u_ = shift_for(u1 - u0_), shift_v_ = shift_for(v1 - v0_);
        for (std::size_t i = samples_.size(); i-- > 0;) {
            std::uint32_t& head =
                heads_[texel(faces_[i], row(samples_[i].v), column(samples_[i].u))];
            samples_[i].next = head;
            head = static_cast<std::uint32_t>(i);
        }
        for (std::uint32_t head : heads_) {
            std::uint64_t length = 0;
            for (; head != no_sample; head = samples_[head].next) ++length;
            counts.texels_filled += length > 0 ? 1 : 0;
            counts.longest = std::max(counts.longest, length);
        }
    }
    // visit(sample) of those whose place is in the box.
    template <class Visit>
    void for_samples_in(const LightBox& box, IrregularCounts& counts, Visit&& visit) const {
        if (samples_.empty()) return;
        for (std::int64_t r = row(box.v0); r <= row(box.v1); ++r) {
            for (std::int64_t c = column(box.u0); c <= column(box.u1); ++c) {
                ++counts.facet_texels;
                for (std::uint32_t i = heads_[texel(box.face, r, c)]; i != no_sample;
                     i = samples_[i].next) {
                    const IrregularSample& s = samples_[i];
                    ++counts.visits;
                    if (s.u >= box.u0 && s.u <= box.u1 && s.v >= box.v0 && s.v <= box.v1) visit(s);
                }
            }
        }
    }

private:
    // As many bits that `extent` has fewer than texels after it.
    int shift_for(std::int64_t extent) const {
        const auto bits = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(extent)));
        return std::max(0, bits - std::countr_zero(static_cast<unsigned>(side_)));
    }
    std::int64_t column(std::int64_t u) const {
        return std::clamp<std::int64_t>(fixed::floor_shift(u - u0_, shift_u_), 0, side_ - 1);
    }
    std::int64_t row(std::int64_t v) const {
        return std::clamp<std::int64_t>(fixed::floor_shift(v - v0_, shift_v_), 0, side_ - 1);
    }
    std::size_t texel(int face, std::int64_t r, std::int64_t c) const {
        return static_cast<std::size_t>((face * std::int64_t{side_} + r) * side_ + c);
    }

    std::span<IrregularSample> samples_;
    std::span<std::uint8_t> faces_;
    std::span<std::uint32_t> heads_;
    std::int64_t u0_ = 0, v0_ = 0;
    std::size_t count_ = 0;
    int side_, shift_u_ = 0, shift_v_ = 0;
};

}  // namespace

bool irregular(const Setting& setting, std::span<const std::uint32_t> shown,
               const IrregularOptions& options, std::span<std::byte> memory,
               std::span<std::uint8_t> mask, IrregularCounts& counts) {
    const Space& space = setting.space;
    const LightPicture picture(setting.light.centre);
    const auto size = static_cast<std::uint32_t>(space.size_px());
    std::size_t points = 0;
    for (std::size_t at = 0; at < mask.size(); ++at) {
        const bool seen = shown[at] != nothing_seen;
        mask[at] = seen && setting.attached(shown[at]) ? dark : lit;
        points += seen && mask[at] == lit ? 1 : 0;
    }
    const auto side = static_cast<std::size_t>(options.texels);
    const std::size_t texels = static_cast<std::size_t>(picture.faces()) * side * side;
    Carver carver(memory);
    const auto samples = carver.take<IrregularSample>(points);
    const auto faces = carver.take<std::uint8_t>(points);
    const auto heads = carver.take<std::uint32_t>(texels);
    counts.samples += points;
    counts.texels += texels;
    counts.bytes = carver.used();
    if (!carver.fits()) return false;

    SampleGrid grid(samples, faces, heads, options.texels);
    for (std::uint32_t at = 0; at < mask.size(); ++at)
        if (shown[at] != nothing_seen && mask[at] == lit)
            grid.add(at, picture.place(setting.planes[shown[at]], space.eye(),
                                       space.centre(static_cast<int>(at % size)),
                                       space.centre(static_cast<int>(at / size))));
    grid.make_lists(counts);
    LightBox box{};
    for (std::uint32_t f = 0; f < setting.mesh.facets.size(); ++f) {
        if (setting.light.sides[f] == 0) continue;
        HidingLines lines;
        for (int face = 0; face < picture.faces(); ++face) {
            if (!picture.box(setting.mesh.corners(f), face, box)) continue;
            grid.for_samples_in(box, counts, [&](const IrregularSample& s) {
                if (mask[s.pixel] != lit) return;
                ++counts.facets_asked;
                if (lines.hide(setting, f, shown[s.pixel],
                               space.centre(static_cast<int>(s.pixel % size)),
                               space.centre(static_cast<int>(s.pixel / size))))
                    mask[s.pixel] = dark;
            });
        }
    }
    return true;
}

}  // namespace umbra78::shadow::rivals
