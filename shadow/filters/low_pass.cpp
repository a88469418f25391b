// The low-pass, in strips of up to 256 pixels down the frame, three lines of them at a time. Where
// all three are lit the result is, and nothing is summed.
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

    // Line y of the result.
    void filter(int y, std::uint8_t* out) {
        LowPassStrip &above = at(y - 1), &here = at(y), &below = at(y + 1);
        if (!above.dark && !here.dark && !below.dark) {
            std::fill_n(out, count_, std::uint8_t{0});
            return;
        }
        for (LowPassStrip* strip : {&above, &here, &below}) add_up(*strip);
        form_.down(above, here, below, count_, out);
    }

private:
    // The strip of line y, which may be one beyond the frame.
    LowPassStrip& at(int y) {
        const auto k = static_cast<std::size_t>((y + 3) % 3);
        if (held_[k] != y) {
            summed_[k] = false;
            strip_[k].dark = fill(y, strip_[k]);
        }
        held_[k] = y;
        return strip_[k];
    }
    void add_up(LowPassStrip& strip) {
        bool& summed = summed_[static_cast<std::size_t>(&strip - strip_.data())];
        if (!summed) form_.across(strip, count_);
        summed = true;
    }

    bool fill(int y, LowPassStrip& strip) const {
        const int size = observer_.size_px(), width = count_ + 2;
        if (y < 0 || y >= size) {
            std::fill_n(strip.missing, width, std::uint8_t{1});
            std::fill_n(strip.self, width, std::uint8_t{0});
            return false;
        }
        const std::size_t a = observer_.address(from_, y);
        const Depth* depth = observer_.depth.data() + a;
        const std::uint8_t* mask = mask_.data() + a;
        bool dark = read(depth, mask, count_, strip.missing + 1, strip.self + 1);
        for (const int x : {-1, count_}) {
            strip.missing[x + 1] = 1;
            strip.self[x + 1] = 0;
            if (from_ + x >= 0 && from_ + x < size)
                dark = read_each(depth + x, mask + x, 1, strip.missing + (x + 1),
                                 strip.self + (x + 1)) || dark;
        }
        return dark;
    }
    bool read(const Depth* depth, const std::uint8_t* mask, int count, std::uint8_t* missing,
              std::uint8_t* self) const {
        if constexpr (sizeof(Depth) == sizeof(hw::Depth16))
            return form_.read(depth, mask, background_, count, missing, self);
        return read_each(depth, mask, count, missing, self);
    }
    bool read_each(const Depth* depth, const std::uint8_t* mask, int count,
                   std::uint8_t* missing, std::uint8_t* self) const {
        bool dark = false;
        for (int x = 0; x < count; ++x) {
            const bool none = depth[x] == background_;
            missing[x] = none ? 1 : 0;
            self[x] = none ? std::uint8_t{0} : mask[x];
            dark = dark || self[x] != 0;
        }
        return dark;
    }

    std::span<const std::uint8_t> mask_;
    const hw::ReadOnlyStore<Depth>& observer_;
    Depth background_;
    const LowPassForm& form_;
    int from_, count_;
    std::array<LowPassStrip, 3> strip_;
    std::array<int, 3> held_{-2, -2, -2};  // none
    std::array<bool, 3> summed_{};
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
                strips.filter(y, out.data() + observer.address(x, y));
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
