#include "shadow/frame/culling.hpp"

#include "shadow/post_process.hpp"

#include <algorithm>

namespace umbra78::shadow {
namespace {

using raster::BlockAction;
using raster::ScreenBounds;

enum class Seen : std::uint8_t { outside, within, unknown };

// Of a whole patch in a view: outside, or the bounds of all its samples, or not known.
Seen patch_bounds(const raster::Patch& patch, const FrameInputs& in,
                  const hw::MatrixWords& matrix, ScreenBounds& bounds) {
    const hw::MachineSpec& spec = in.settings.machine;
    const raster::ObjectWords words = raster::to_object_words(patch, in.matrices.object);
    if (matrix.affine) {
        bounds = raster::affine_bounds(
            raster::affine_components(words, matrix, spec, in.matrices.object));
    } else {
        const auto c = raster::homogeneous_components(words, matrix, spec, in.matrices.object);
        const raster::Sight sight = raster::projected_bounds(c, spec, bounds);
        if (sight == raster::Sight::outside) return Seen::outside;
        if (sight == raster::Sight::both) return Seen::unknown;
    }
    const bool outside = raster::block_action(bounds, spec) == BlockAction::outside;
    return outside ? Seen::outside : Seen::within;
}

// Input words of the unit, both ends inclusive.
struct WordBox {
    std::array<std::int32_t, 2> x, y, z;
};

// Pixels by their outer edges and one more all round, so that a pixel's centre, its index and any
// point of it, half a pixel off or not, lie within.
WordBox word_box(const ScreenBounds* bounds, const Settings& s) {
    const hw::MachineSpec& m = s.machine;
    raster::detail::PixelWindow w{0, 0, m.size_px() - 1, m.size_px() - 1};
    std::uint32_t nearest = 0, farthest = m.deepest_drawn();
    if (bounds != nullptr) {
        w = raster::detail::pixel_window(*bounds, m);
        // A quantum to either side, for what rounding may do to the corners.
        const std::int64_t one = std::int64_t{1} << raster::depth_guard(m);
        std::uint32_t code = 0;
        if (raster::depth_code((*bounds)[2].min - one, m, code)) nearest = code;
        if (raster::depth_code((*bounds)[2].max + one, m, code)) farthest = code;
    }
    Settings index = s;
    index.registration = Registration::index;  // a pixel's left and upper edge
    const hw::Words low = pixel_words(w.x0 - 1, w.y0 - 1, nearest, index);
    const hw::Words high = pixel_words(w.x1 + 2, w.y1 + 2, farthest, index);
    return {{low.x, high.x}, {low.y, high.y}, {low.z, high.z}};
}

// The largest dither word's magnitude.
std::int64_t max_dither(const Settings& s) {
    const int k = hw::uniforms(s.dither.shape);
    if (k == 0) return 0;
    const std::int64_t a = fixed::dither_amplitude(k, s.dither.size_q8, s.machine.fraction_bits);
    return fixed::floor_shift(255 * k * a, 16) + 1;
}

struct Extremes {
    std::int64_t min = INT64_MAX, max = INT64_MIN;
    void add(std::int64_t v) {
        min = std::min(min, v);
        max = std::max(max, v);
    }
    bool beyond(std::int64_t low, std::int64_t high) const {
        return max < low || min > high;
    }
};

// Whether a point of the box, dithered, may lie in the light's volume.
bool may_reach(const WordBox& box, const FrameInputs& in) {
    const Settings& s = in.settings;
    const hw::MatrixWords& matrix = in.matrices.observer_to_light;
    if (!matrix.affine && s.machine.divide_order == hw::DivideOrder::round_first) return true;
    const hw::TransformUnit unit(s.machine, matrix);
    Extremes x, y, z;
    for (std::size_t corner = 0; corner < 8; ++corner) {
        const hw::Point p =
            unit({box.x[corner & 1], box.y[corner >> 1 & 1], box.z[corner >> 2]});
        // Overflow saturates, which keeps the order; without a quotient there is none.
        if (p.status == hw::DivideStatus::divisor_not_positive) return true;
        x.add(p.x);
        y.add(p.y);
        z.add(p.z + s.machine.depth_offset());
    }
    const std::int64_t noise = max_dither(s);
    const std::int64_t edge = std::int64_t{s.machine.half_px()} << s.machine.fraction_bits;
    return !x.beyond(-edge - noise, edge - 1 + noise) &&
           !y.beyond(-edge - noise, edge - 1 + noise) &&
           !z.beyond(0, s.machine.deepest_drawn());
}

}  // namespace

Reach cull(const FrameInputs& in) {
    Reach reach;
    for (const raster::Patch& patch : in.scene.patches) {
        ScreenBounds bounds{};
        if (patch_bounds(patch, in, in.matrices.world_to_light, bounds) == Seen::outside)
            ++reach.outside_light;
        const Seen seen = patch_bounds(patch, in, in.matrices.world_to_observer, bounds);
        if (seen == Seen::outside) {
            ++reach.outside_observer;
        } else if (!reach.into_light) {
            reach.into_light =
                may_reach(word_box(seen == Seen::within ? &bounds : nullptr, in.settings), in);
        }
    }
    return reach;
}

}  // namespace umbra78::shadow
