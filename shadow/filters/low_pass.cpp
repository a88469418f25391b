// The low-pass, in strips of up to 512 pixels down the frame, three lines of them at a time.
#include "shadow/filters/low_pass.hpp"

#include "shadow/filters/filter_check.hpp"
#include "shadow/filters/low_pass_form.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace umbra78::shadow {

#define UMBRA78_LANES_TEXT "shadow/filters/low_pass_body.hpp"
#include "fixed/lane_sets.hpp"

namespace {

#define UMBRA78_LOW_PASS_FORM(set, name) \
    {name, set::supported, set::read_form, set::across_form, set::down_form},
constexpr LowPassForm low_pass_table[] = {UMBRA78_LANE_SETS(UMBRA78_LOW_PASS_FORM)};
#undef UMBRA78_LOW_PASS_FORM

const LowPassForm& fastest_low_pass() {
    const LowPassForm* best = low_pass_table;
    for (const LowPassForm& form : low_pass_table)
        if (form.supported()) best = &form;
    return *best;
}

template <class Depth>
class Strips {
public:
    Strips(std::span<const std::uint8_t> mask, const hw::ReadOnlyStore<Depth>& observer,
           Depth background, const LowPassForm& form, int from, int count)
        : mask_(mask), observer_(observer), background_(background), form_(form), from_(from),
          count_(count) {}

    // The strip of line y, which may be one beyond the frame.
    const LowPassStrip& at(int y) {
        const auto k = static_cast<std::size_t>((y + 3) % 3);
        if (held_[k] != y) fill(y, strip_[k]);
        held_[k] = y;
        return strip_[k];
    }

private:
    void fill(int y, LowPassStrip& strip) const {
        const int size = observer_.size_px(), width = count_ + 2;
        std::fill_n(strip.missing, width, std::uint8_t{1});
        std::fill_n(strip.self, width, std::uint8_t{0});
        if (y >= 0 && y < size) {
            const int first = std::max(from_ - 1, 0), last = std::min(from_ + count_ + 1, size);
            const std::size_t a = observer_.address(first, y);
            read(observer_.depth.data() + a, mask_.data() + a, last - first, first - (from_ - 1),
                 strip);
        }
        form_.across(strip, count_);
    }
    void read(const Depth* depth, const std::uint8_t* mask, int count, int at,
              LowPassStrip& strip) const {
        if constexpr (sizeof(Depth) == sizeof(hw::Depth16)) {
            form_.read(depth, mask, background_, count, strip.missing + at, strip.self + at);
        } else {
            for (int x = 0; x < count; ++x) {
                const bool none = depth[x] == background_;
                strip.missing[at + x] = none ? 1 : 0;
                strip.self[at + x] = none ? std::uint8_t{0} : mask[x];
            }
        }
    }

    std::span<const std::uint8_t> mask_;
    const hw::ReadOnlyStore<Depth>& observer_;
    Depth background_;
    const LowPassForm& form_;
    int from_, count_;
    std::array<LowPassStrip, 3> strip_;
    std::array<int, 3> held_{-2, -2, -2};  // none
};

}  // namespace

std::span<const LowPassForm> low_pass_forms() { return low_pass_table; }

template <class Depth>
void low_pass(std::span<const std::uint8_t> mask, const hw::ReadOnlyStore<Depth>& observer,
              Depth background, std::span<std::uint8_t> out, const LineSet& lines,
              const LowPassForm& form) {
    check_filter(mask, observer, out, lines);
    const auto from = reinterpret_cast<std::uintptr_t>(mask.data());
    const auto to = reinterpret_cast<std::uintptr_t>(out.data());
    fixed::require(from + mask.size() <= to || to + out.size() <= from,
                   "low-pass: the mask and the result overlap");
    const int size = observer.size_px(), count = std::min(size, LowPassStrip::most);
    for (int x = 0; x < size; x += count) {
        Strips<Depth> strips(mask, observer, background, form, x, count);
        for (int y = 0; y < size; ++y)
            if (lines.has(y))
                form.down(strips.at(y - 1), strips.at(y), strips.at(y + 1), count,
                          out.data() + observer.address(x, y));
    }
}

template <class Depth>
void low_pass(std::span<const std::uint8_t> mask, const hw::ReadOnlyStore<Depth>& observer,
              Depth background, std::span<std::uint8_t> out, const LineSet& lines) {
    low_pass<Depth>(mask, observer, background, out, lines, fastest_low_pass());
}

#define UMBRA78_LOW_PASS(Depth)                                                              \
    template void low_pass(std::span<const std::uint8_t>, const hw::ReadOnlyStore<Depth>&,   \
                           Depth, std::span<std::uint8_t>, const LineSet&);                  \
    template void low_pass(std::span<const std::uint8_t>, const hw::ReadOnlyStore<Depth>&,   \
                           Depth, std::span<std::uint8_t>, const LineSet&, const LowPassForm&);
UMBRA78_LOW_PASS(hw::Depth16)
UMBRA78_LOW_PASS(hw::Depth32)
#undef UMBRA78_LOW_PASS

}  // namespace umbra78::shadow
