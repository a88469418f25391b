#include "raster/draw.hpp"

#include "fixed/overflow.hpp"

#include <algorithm>
#include <array>

namespace umbra78::raster {
namespace {

using fixed::Rounding;

// A control point's raster word is at most 2^55: what block.hpp makes of it then fits 64 bits.
constexpr int raster_bits = 55;
static_assert(max_growth <= INT64_MAX / (std::int64_t{1} << raster_bits));
static_assert(max_growth > INT64_MAX / (std::int64_t{2} << raster_bits), "and no more bits do");

template <std::size_t N>
std::array<Component, N> first(const std::array<Component, 4>& c) {
    std::array<Component, N> out;
    std::copy_n(c.begin(), N, out.begin());
    return out;
}

}  // namespace

hw::LoadStatus load_view(const View& view, const MachineSpec& spec, WordFormat object,
                         MatrixWords& out) {
    return load_view(world_to_screen(view, spec), spec, object, out);
}

hw::LoadStatus load_view(const RationalMatrix& exact, const MachineSpec& spec, WordFormat object,
                         MatrixWords& out) {
    const hw::LoadStatus status = hw::load_matrix(exact, spec, object, out);
    if (status != hw::LoadStatus::ok || !out.affine) return status;
    // |accumulator| <= 2^(object.bits + coefficient_bits), and the row's shift makes it a word.
    for (const hw::Row row : {hw::Row::x, hw::Row::y, hw::Row::z}) {
        const int fraction = row == hw::Row::z ? spec.depth_fraction() + depth_guard(spec)
                                               : raster_fraction;
        const int bits = object.bits + spec.coefficient_bits -
                         hw::affine_shift(out, row, spec, object, fraction);
        if (bits > raster_bits) return hw::LoadStatus::exponent_out_of_range;
    }
    return status;
}

namespace {

constexpr std::uint64_t DrawCounts::*all_counts[] = {
    &DrawCounts::patches,        &DrawCounts::blocks,
    &DrawCounts::samples,        &DrawCounts::facet_samples,
    &DrawCounts::hidden_blocks,  &DrawCounts::unresolved,
    &DrawCounts::tested_blocks,  &DrawCounts::splits,
    &DrawCounts::tested_centres, &DrawCounts::facets,
    &DrawCounts::cut_facets,     &DrawCounts::diced_patches,
    &DrawCounts::diced_vertices, &DrawCounts::turned_triangles,
    &DrawCounts::triangles,      &DrawCounts::triangle_lines,
    &DrawCounts::unresolved_facets};
// Whether no more than `scale` blocks that may be drawn follow one another in it each way.
bool is_within(const ScreenBounds& b, std::int64_t scale) {
    for (std::size_t k = 0; k < 3; ++k) {
        if (b[k].max >= unbounded || b[k].min <= -unbounded) return false;
        if (std::max(b[k].bend_u, b[k].bend_v) > scale * scale * max_bend) return false;
        if (k < 2 && b[k].slope_u + b[k].slope_v > scale * max_slope) return false;
    }
    return true;
}

static_assert(sizeof(DrawCounts) == sizeof(std::uint64_t) * std::size(all_counts));

}  // namespace

DrawCounts& DrawCounts::operator+=(const DrawCounts& more) {
    for (const auto count : all_counts) this->*count += more.*count;
    return *this;
}

namespace detail {

bool divide_corners(const std::array<CornerGrid<std::int64_t>, 4>& g, const MachineSpec& spec,
                    Corners& out) {
    const std::array<int, 3> fraction{raster_fraction, raster_fraction,
                                      spec.depth_fraction() + depth_guard(spec)};
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t v = 0; v < corners; ++v) {
            for (std::size_t u = 0; u < corners; ++u) {
                const fixed::Quotient q =
                    fixed::divide(g[c][v][u], g[3][v][u], fraction[c], 31, Rounding::half_up);
                if (q.status != fixed::DivideStatus::ok) return false;
                out[c][v][u] = static_cast<std::int32_t>(q.value);
            }
        }
    }
    return true;
}

void BlockWalk::push_patch(const Patch& patch) {
    StackBlock& b = memory_.stack[depth_++];
    const ObjectWords words = to_object_words(patch, setup_.object);
    if (affine()) {
        const auto c = affine_components(words, setup_.matrix, setup_.spec, setup_.object,
                                         setup_.work);
        std::copy(c.begin(), c.end(), b.screen.begin());
    } else {
        b.screen = homogeneous_components(words, setup_.matrix, setup_.spec, setup_.object);
    }
    b.level_u = b.level_v = b.line = 0;
    splits_ = 0;
    if (!shades_) return;
    std::array<std::array<std::int64_t, 16>, 3> place{};
    for (std::size_t k = 0; k < 16; ++k) {
        place[0][k] = std::int64_t{words[k].x} * (1 << object_guard);
        place[1][k] = std::int64_t{words[k].y} * (1 << object_guard);
        place[2][k] = std::int64_t{words[k].z} * (1 << object_guard);
    }
    for (std::size_t c = 0; c < 3; ++c) b.world[c] = component_from_bezier(place[c]);
}

// A block without lines in the band is outside, too: no sample of it is drawn. A block is counted
// by its first line; one without bounds by its parent's, whose band has split the parent.
BlockWalk::Decision BlockWalk::in_band(StackBlock& b, BlockAction action,
                                       const ScreenBounds& bounds) const {
    if (setup_.band.all()) return {action, true};
    const Footprint reached = footprint(bounds, setup_.spec);
    b.line = std::max(b.line, reached.y0);
    return {setup_.band.meets(reached.y0, reached.y1) ? action : BlockAction::outside, true};
}

BlockWalk::Decision BlockWalk::decide(StackBlock& b, ScreenBounds& bounds) const {
    if (affine()) {
        bounds = affine_bounds(first<3>(b.screen));
        return in_band(b, block_action(bounds, setup_.spec), bounds);
    }
    const auto either = [&] {
        return b.level_u <= b.level_v ? BlockAction::split_u : BlockAction::split_v;
    };
    switch (projected_bounds(b.screen, setup_.spec, bounds)) {
        case Visibility::outside: return {BlockAction::outside, false};
        case Visibility::unknown: return {either(), false};
        case Visibility::bounded: break;
    }
    Decision by_rule = in_band(b, block_action(bounds, setup_.spec), bounds);
    if (by_rule.action == BlockAction::split_u && unbounded_both_ways(bounds))
        by_rule.action = either();
    return by_rule;
}

// Splits the popped block in place: its lower half stays, its upper half goes above it.
void BlockWalk::split(bool along_u) {
    StackBlock& low = memory_.stack[depth_];
    StackBlock& high = memory_.stack[depth_ + 1];
    const auto halve = [&](Component& c, Component& h) {
        const Component whole = c;
        along_u ? split_u(whole, c, h) : split_v(whole, c, h);
    };
    for (std::size_t c = 0; c < (affine() ? 3u : 4u); ++c) halve(low.screen[c], high.screen[c]);
    if (shades_)
        for (std::size_t c = 0; c < 3; ++c) halve(low.world[c], high.world[c]);
    (along_u ? low.level_u : low.level_v) += 1;
    high.level_u = low.level_u;
    high.level_v = low.level_v;
    high.line = low.line;
    depth_ += 2;
}

bool BlockWalk::next(ScreenBounds& bounds, int scale) {
    while (depth_ > 0) {
        StackBlock& b = memory_.stack[--depth_];
        const auto [decided, bounded] = decide(b, bounds);
        const std::uint64_t one = counted() ? 1 : 0;
        counts_.tested_blocks += one;
        if (splits_ == 0 && b.level_u + b.level_v == 0) counts_.patches += one;
        if (decided == BlockAction::draw) return true;
        if (decided == BlockAction::outside) continue;
        if (scale > 1 && bounded && is_within(bounds, scale)) return true;
        const bool can_u = b.level_u < deepest_level, can_v = b.level_v < deepest_level;
        if ((!can_u && !can_v) || splits_ == max_splits) {
            counts_.unresolved += one;
            continue;
        }
        ++splits_;
        counts_.splits += one;
        split(decided == BlockAction::split_u ? can_u : !can_v);
    }
    return false;
}

bool BlockWalk::make_corners(const BlockForm& form) {
    if (affine()) {
        form.expand(first<3>(block().screen), memory_.corners);
        return true;
    }
    expand<std::int64_t, 4>(block().screen, memory_.homogeneous);
    return divide_corners(memory_.homogeneous, setup_.spec, memory_.corners);
}

bool find_samples(const Corners& corners, const DrawSetup& setup, const BlockForm& form,
                  BlockSamples& out) {
    const std::int32_t half = setup.spec.half_px();
    return setup.by_centres() ? form.centres(corners, half, out)
                              : form.leaves(corners, half, out);
}

void shade_leaves(const BlockSamples& samples, const BlockForm& form, LeafLevels& levels,
                  BlockShading& shading) {
    ShadeJob job;
    if (samples.count == 0 || !shading.job(job)) return;
    std::array<std::uint8_t, BlockSamples::most + 15> numbers;
    std::size_t count = 0;
    for (std::size_t k = 0; k < samples.count; ++k) {  // some twice
        numbers[count++] = samples.sample[k].leaf;
    }
    form.shade(job, numbers.data(), count, levels);
    shading.keep(levels);
}

}  // namespace detail

void order_front_to_back(std::span<const Patch> patches, const View& view,
                         std::span<std::uint32_t> order, std::span<std::int64_t> nearest) {
    for (std::size_t k = 0; k < patches.size(); ++k) {
        order[k] = static_cast<std::uint32_t>(k);
        nearest[k] = INT64_MIN;
        for (const World& p : patches[k].control)
            nearest[k] = std::max(nearest[k], along(view.axes.back, p));
    }
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return nearest[a] != nearest[b] ? nearest[a] > nearest[b] : a < b;
    });
}

}  // namespace umbra78::raster
