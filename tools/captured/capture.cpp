#include "tools/captured/capture.hpp"

#include "shadow/light_place.hpp"
#include "tools/scene/scene_error.hpp"
#include "tools/scene/settings_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace umbra78::tools::captured {
namespace {

// The settings that concern the test of a point against a depth map, and its clock.
constexpr std::array<std::string_view, 29> read_keys{
    "xy_bits", "z_bits", "depth_store", "coefficient_bits", "fraction_bits", "multipliers",
    "accumulator_bits", "product_rounding", "transform_rounding", "coefficient_rounding",
    "divide_order", "registration", "lookup", "background", "taps", "tap_places", "bias",
    "bias_unit", "bias_clamp", "receiver", "dither", "dither_size", "dither_seed", "clock_ns",
    "multiply_ns", "add_ns", "register_ns", "divider", "noise_bits"};
// Others of the clock, which profiles set.
constexpr std::array<std::string_view, 7> idle_keys{
    "light_banks", "dram_access_ns", "dram_cycle_ns", "dram_column_ns", "dram_page_ns",
    "dram_rows", "video"};

bool is_read(std::string_view key) {
    return std::find(read_keys.begin(), read_keys.end(), key) != read_keys.end() ||
           std::find(idle_keys.begin(), idle_keys.end(), key) != idle_keys.end();
}

shadow::Settings own_defaults() {
    shadow::Settings s;
    s.bias_q16 = 0;
    s.machine.coefficient_bits = 24;
    return s;
}

void check(const shadow::Settings& s, const shadow::Settings& defaults, int least_xy_bits) {
    for (const shadow::Setting& setting : shadow::settings_table())
        if (!is_read(setting.key) && setting.get(s) != setting.get(defaults))
            throw SceneError(fmt::format("{0} is no setting of the shadow test, which is "
                                         "all that runs on captured buffers; leave out {0}",
                                         setting.key));
    if (s.bias_unit != shadow::BiasUnit::quanta)
        throw SceneError("bias_unit: a matrix does not tell how large the light's window is; give "
                         "the bias in quanta, of which the depth range has 2^z_bits");
    if (s.receiver == shadow::Receiver::normal)
        throw SceneError("receiver = normal moves by texels of the light's window, which a matrix "
                         "does not tell; give receiver = point or plane");
    if (s.machine.xy_bits < least_xy_bits)
        throw SceneError(fmt::format("xy_bits {}: the buffers need a frame of {} bits; leave it "
                                     "out", s.machine.xy_bits, least_xy_bits));
}

shadow::Settings settings_of(const Capture& capture) {
    shadow::Settings s = own_defaults();
    const int xy_bits = xy_bits_of(capture.observer, capture.light);
    s.machine.xy_bits = xy_bits;
    s.machine.z_bits = std::min(z_bits_of(capture.format, capture.observer), xy_bits + 20);
    if (capture.format.real)
        s.machine.depth_store = capture.format.reversed ? hw::DepthStore::of_reversed_floats
                                                        : hw::DepthStore::of_floats;
    const shadow::Settings defaults = s;
    TomlNode table;
    for (const std::string& text : capture.set) table.children.push_back(parse_override(text));
    FirstError error;
    apply_settings(table, s, error);
    if (error.any()) throw SceneError(error.line());
    check(s, defaults, xy_bits);
    return s;
}

Sides sides_of(const NumberImage& image) { return {image.width, image.height}; }

hw::FrameStore<const hw::Depth32> store_of(const Codes& codes, const hw::MachineSpec& spec) {
    return {spec.xy_bits, codes.depth, {}, {}, {}};
}

}  // namespace

CapturedFrame::CapturedFrame(const Capture& capture)
    : capture_(capture), settings_(settings_of(capture)),
      observer_sides_(sides_of(capture.observer)), light_sides_(sides_of(capture.light)) {
    if (const std::string wrong = wrong_with(capture.matrix, capture.convention); !wrong.empty())
        throw SceneError(fmt::format("{}: {}", capture.matrix_name, wrong));
    const bool from_top = capture.convention.first_row_on_top;
    observer_ = codes_of(capture.observer, capture.format, from_top, spec());
    light_ = codes_of(capture.light, capture.format, from_top, spec());
    words(settings_.bias_q16);  // for its errors
}

hw::MatrixWords CapturedFrame::words(std::int64_t bias_q16) const {
    hw::MatrixWords words;
    const hw::RationalMatrix exact =
        screen_to_screen(capture_.matrix, capture_.convention, capture_.format, observer_sides_,
                         light_sides_, spec(), bias_q16);
    if (hw::load_matrix(exact, spec(), hw::screen_words(spec()), words) != hw::LoadStatus::ok)
        throw SceneError(fmt::format("{}: its rows, in pixels and codes, do not fit coefficient "
                                     "words with exponents of -31 .. 31; divide all 16 numbers by "
                                     "one number, or bring the light nearer to the observer's "
                                     "window", capture_.matrix_name));
    return words;
}

std::vector<std::uint8_t> CapturedFrame::mask(const shadow::Settings& s,
                                              std::int64_t bias_q16) const {
    std::vector<std::uint8_t> mask(observer_.depth.size());
    shadow::ReceiverWords receiver;
    if (s.bias_clamp_q16 > 0) receiver.limit = s.bias_clamp_q16 >> 16;
    shadow::post_process<hw::Depth32>({.observer = store_of(observer_, spec()),
                                       .light = store_of(light_, spec())},
                                      words(bias_q16), s, shadow::needed_work(s), mask, receiver);
    return mask;
}

std::vector<std::uint8_t> CapturedFrame::mask(std::int64_t bias_q16) const {
    return mask(settings_, bias_q16);
}

std::vector<std::uint8_t> CapturedFrame::mask_of_planes(std::int64_t bias_q16) const {
    shadow::Settings s = settings_;
    s.receiver = shadow::Receiver::plane;
    s.lookup = shadow::Lookup::nearest;
    s.dither.shape = hw::DitherShape::none;
    s.machine.fraction_bits = 12;  // a plane's depth is as exact as the place that is asked for
    return mask(s, bias_q16);
}

hw::Point CapturedFrame::point(int x, int y) const {
    const hw::TransformUnit unit(spec(), words(settings_.bias_q16));
    const std::uint32_t code = observer_.depth[static_cast<std::size_t>(y) << spec().xy_bits |
                                               static_cast<std::size_t>(x)];
    return unit(shadow::pixel_words(x, y, code, settings_));
}

Outcomes CapturedFrame::outcomes(std::span<const std::uint8_t> mask) const {
    const hw::TransformUnit unit(spec(), words(settings_.bias_q16));
    const std::int64_t one_texel = std::int64_t{1} << spec().fraction_bits;
    const auto within = [&](std::int64_t at, int side) {
        const std::int64_t from_edge = at + spec().half_px() * one_texel;
        return from_edge >= 0 && from_edge < side * one_texel;
    };
    Outcomes o;
    for (int y = 0; y < observer_sides_.height; ++y)
        for (int x = 0; x < observer_sides_.width; ++x) {
            const std::size_t at = static_cast<std::size_t>(y) << spec().xy_bits |
                                   static_cast<std::size_t>(x);
            if (observer_.depth[at] == spec().background()) {
                ++o.background;
                continue;
            }
            const hw::Point p = unit(shadow::pixel_words(x, y, observer_.depth[at], settings_));
            const std::int64_t code = p.z + spec().depth_offset();
            if (p.status != hw::DivideStatus::ok)
                ++o.no_quotient;
            else if (!within(p.x, light_sides_.width) || !within(p.y, light_sides_.height) ||
                     code < 0 || code > spec().deepest_drawn())
                ++o.outside;
            else
                ++o.compared;
            o.shadowed += mask[at] != shadow::mask_lit;
        }
    return o;
}

std::vector<std::uint8_t> CapturedFrame::visible() const {
    std::vector<std::uint8_t> visible(observer_.depth.size());
    for (std::size_t at = 0; at < visible.size(); ++at)
        visible[at] = observer_.depth[at] != spec().background();
    return visible;
}

Buffer CapturedFrame::buffer(const std::string& name, const Codes& codes) const {
    Buffer buffer{name, spec().size_px(), spec().background(), std::span(codes.depth)};
    if (!codes.narrow.empty()) buffer.values = std::span(codes.narrow);
    return buffer;
}
Buffer CapturedFrame::buffer(const std::string& name,
                             std::span<const std::uint8_t> bytes) const {
    return {name, spec().size_px(), 255, bytes};
}

}  // namespace umbra78::tools::captured
