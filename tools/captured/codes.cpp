#include "tools/captured/codes.hpp"

#include "tools/scene/scene_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace umbra78::tools::captured {
namespace {

__extension__ using Int128 = __int128;

// A product depth * far as an exact fraction: numerator / 2^down or numerator / over.
struct Scaled {
    Int128 numerator = 0, over = 1;

    std::int64_t half_up() const { return floor_of(2 * numerator + over, 2 * over); }
    double rounding(std::int64_t to) const {
        return std::abs(static_cast<double>(numerator - to * over) / static_cast<double>(over));
    }

private:
    static std::int64_t floor_of(Int128 a, Int128 b) {
        return static_cast<std::int64_t>(a / b - (a % b < 0 ? 1 : 0));
    }
};

class Encoder {
public:
    Encoder(const NumberImage& image, const DepthFormat& format, const hw::MachineSpec& spec)
        : image_(image), format_(format), far_(far_code(format, spec)),
          stored_max_(format.own() ? spec.background()
                                   : (std::uint32_t{1} << format.unorm_bits) - 1) {
        const bool whole = !is_real(image.kind);
        if (format.real && whole)
            throw SceneError(fmt::format("{}: it holds whole numbers ({}), and {} stores floats; "
                                         "give d16 or d24, or the file as float32",
                                         image.name, name_of(image.kind), format.name));
        if (format.own() && !whole)
            throw SceneError(fmt::format("{}: it holds floats, and codes are whole numbers; give "
                                         "another --depth-format", image.name));
        if (whole && image.max < stored_max_)
            throw SceneError(fmt::format("{}: its numbers reach {} at most, and those of {} {}; "
                                         "give a file of more bits, or another --depth-format",
                                         image.name, image.max, format.name, stored_max_));
    }

    // Nothing for what the buffer was cleared to.
    std::optional<Scaled> at(int x, int y) const {
        const double stored = image_.at(x, y);
        const double most = is_real(image_.kind) ? 1 : stored_max_;
        if (!(stored >= 0 && stored <= most)) fail(x, y, stored, most);
        if (stored == (format_.reversed ? 0 : most)) return {};
        return is_real(image_.kind) ? of_real(stored) : of_whole(stored);
    }

private:
    Scaled of_whole(double stored) const {
        const auto code = static_cast<std::int64_t>(stored);
        if (format_.own()) return {code, 1};
        return {Int128(format_.reversed ? stored_max_ - code : code) * far_, stored_max_};
    }
    // stored = word 2^-down: 53 bits and far's 24 leave room for the shift.
    Scaled of_real(double stored) const {
        int exponent = 0;
        auto word = static_cast<std::int64_t>(std::ldexp(std::frexp(stored, &exponent), 53));
        int down = 53 - exponent;
        constexpr int most_down = 100;  // what is smaller rounds as its sign does
        if (down > most_down) {
            word = word != 0 ? 1 : 0;
            down = most_down;
        }
        const Int128 over = Int128(1) << down;
        const Int128 product = Int128(word) * far_;
        return {format_.reversed ? over * far_ - product : product, over};
    }

    [[noreturn]] void fail(int x, int y, double stored, double most) const {
        const char* remedy = is_real(image_.kind) ? "give the depth as it is stored, 0 .. 1, not "
                                                    "a distance"
                                                  : "mask out a stencil's bits, or give another "
                                                    "--depth-format";
        throw SceneError(fmt::format("{}: x {}, y {} is {}, and a depth of {} is 0 .. {}; {}",
                                     image_.name, x, y, stored, format_.name, most, remedy));
    }

    const NumberImage& image_;
    const DepthFormat& format_;
    std::int64_t far_;
    std::uint32_t stored_max_;
};

std::size_t address(int x, int y, const hw::MachineSpec& spec) {
    return (static_cast<std::size_t>(y) << spec.xy_bits) + static_cast<std::size_t>(x);
}

}  // namespace

Codes codes_of(const NumberImage& image, const DepthFormat& format, bool first_row_on_top,
               const hw::MachineSpec& spec) {
    const Encoder encoder(image, format, spec);
    Codes codes;
    codes.depth.assign(std::size_t{1} << 2 * spec.xy_bits, spec.background());
    for (int row = 0; row < image.height; ++row) {
        const int y = first_row_on_top ? row : image.height - 1 - row;
        for (int x = 0; x < image.width; ++x) {
            const std::optional<Scaled> depth = encoder.at(x, row);
            if (!depth) {
                ++codes.background;
                continue;
            }
            const std::int64_t nearest =
                std::min(depth->half_up(), std::int64_t{spec.deepest_drawn()});
            const std::uint32_t code = spec.kept(static_cast<std::uint32_t>(nearest));
            codes.largest_rounding = std::max(codes.largest_rounding, depth->rounding(code));
            codes.depth[address(x, y, spec)] = code;
        }
    }
    if (spec.z_bits <= 16) codes.narrow.assign(codes.depth.begin(), codes.depth.end());
    return codes;
}

int z_bits_of(const DepthFormat& format, const NumberImage& image) {
    if (format.unorm_bits > 0) return format.unorm_bits;
    if (format.real) return 26;
    int bits = 4;
    while (bits < 24 && (std::uint32_t{1} << bits) - 1 < image.max) ++bits;
    return bits;
}

int xy_bits_of(const NumberImage& observer, const NumberImage& light) {
    const int side = std::max({observer.width, observer.height, light.width, light.height});
    int bits = 4;
    while (1 << bits < side) ++bits;
    if (bits > 12)
        throw SceneError(fmt::format("a side of {} pixels: the machine's frames have 4096 at most; "
                                     "cut out a part, and its place from the matrix", side));
    return bits;
}

std::vector<std::uint8_t> darkness_of(const NumberImage& image, bool bright_is_lit,
                                      bool first_row_on_top, const hw::MachineSpec& spec) {
    double most = is_real(image.kind) ? 1 : image.max;
    std::vector<std::uint8_t> darkness(std::size_t{1} << 2 * spec.xy_bits);
    for (int row = 0; row < image.height; ++row) {
        const int y = first_row_on_top ? row : image.height - 1 - row;
        for (int x = 0; x < image.width; ++x) {
            const double value = image.at(x, row);
            if (!(value >= 0 && value <= most))
                throw SceneError(fmt::format("{}: x {}, y {} is {}, and a mask's numbers are 0 .. "
                                             "{}; scale them", image.name, x, row, value, most));
            const bool bright = 2 * value >= most;
            darkness[address(x, y, spec)] = bright != bright_is_lit ? 255 : 0;
        }
    }
    return darkness;
}

}  // namespace umbra78::tools::captured
