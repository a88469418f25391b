// A captured frame with all that was asked about it, and its pictures.
#include "tools/captured/report.hpp"
#include "tools/scene/scene_error.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace umbra78::tools::captured {
namespace {

PixelTrace traced(const CapturedFrame& frame, Pixel pixel, std::span<const std::uint8_t> mask) {
    const Sides sides = frame.observer_sides();
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= sides.width || pixel.y >= sides.height)
        throw SceneError(fmt::format("pixel {},{} is not in the observer's buffer of {} x {}; give "
                                     "x of 0 .. {} and y of 0 .. {}", pixel.x, pixel.y,
                                     sides.width, sides.height, sides.width - 1,
                                     sides.height - 1));
    const shadow::Settings& s = frame.settings();
    if (s.receiver != shadow::Receiver::point)
        throw SceneError("a trace follows the clocked machine, which has no stage for the "
                         "receiver's plane; give --set receiver=point");
    if (const shadow::Method& method = *shadow::method_of(s);
        method.trace != shadow::Trace::clocked_post_process)
        throw SceneError(std::string(method.no_trace));
    WatchedFrame watched(s, frame.words(s.bias_q16), frame.observer().depth, frame.light().depth);
    PixelTrace trace = trace_post_process(watched, pixel);
    const std::size_t at = static_cast<std::size_t>(pixel.y) << frame.spec().xy_bits |
                           static_cast<std::size_t>(pixel.x);
    if (trace.mask != mask[at])
        throw std::logic_error(fmt::format("pixel ({}, {}): the clocked machine's mask is {}, the "
                                           "frame's {}", pixel.x, pixel.y, trace.mask, mask[at]));
    return trace;
}

// What would mean that the matrix is not the one that was meant.
void check_places(const Answer& a, std::vector<std::string>& warnings) {
    const Outcomes& o = a.outcomes;
    const std::size_t drawn = o.no_quotient + o.outside + o.compared;
    const std::string& name = a.capture.matrix_name;
    if (drawn == 0)
        throw SceneError(fmt::format("{}: all of its pixels hold the far plane's depth; give "
                                     "--depth-format *_reversed if 1 is near",
                                     a.capture.observer.name));
    if (o.no_quotient == drawn)
        throw SceneError(fmt::format("{}: it gives none of the {} drawn pixels a place before the "
                                     "light; negate its 16 numbers, or give --vectors {}", name,
                                     drawn,
                                     a.capture.convention.row_vectors ? "column" : "row"));
    if (o.compared == 0)
        warnings.push_back(fmt::format("{}: none of the {} drawn pixels falls within the light's "
                                       "buffer; see --convention and --vectors", name, drawn));
    if (a.frame.light().background ==
        static_cast<std::size_t>(a.frame.light_sides().width) *
            static_cast<std::size_t>(a.frame.light_sides().height))
        warnings.push_back(fmt::format("{}: all of it holds the far plane's depth, so that nothing "
                                       "casts a shadow", a.capture.light.name));
}

}  // namespace

Answer::Answer(const Capture& of, const CapturedFrame& drawn, const Asked& asked)
    : capture(of), frame(drawn), mask(drawn.mask()), outcomes(drawn.outcomes(mask)),
      searched(asked.least_bias) {
    check_places(*this, warnings);
    judged = judge(frame, mask, asked.truth);
    if (searched) least = least_bias(frame, asked.truth);
    if (asked.pixel) trace = traced(frame, *asked.pixel, mask);
}

std::vector<std::uint8_t> mask_picture(const Answer& a) {
    return cut(std::span<const std::uint8_t>(a.mask), a.frame.observer_sides(),
               a.frame.spec().size_px());
}

std::vector<std::uint8_t> error_picture(const Answer& a) {
    const Sides sides = a.frame.observer_sides();
    const int size = a.frame.spec().size_px();
    const auto mask = mask_picture(a);
    const auto error = cut(std::span<const double>(a.judged.error_image), sides, size);
    std::vector<std::uint8_t> rgb;
    rgb.reserve(3 * mask.size());
    for (std::size_t at = 0; at < mask.size(); ++at) {
        const auto grey = static_cast<std::uint8_t>(200 - mask[at] / 2);
        if (error[at] > 0)
            rgb.insert(rgb.end(), {235, 50, 40});
        else if (error[at] < 0)
            rgb.insert(rgb.end(), {70, 120, 255});
        else
            rgb.insert(rgb.end(), {grey, grey, grey});
    }
    return rgb;
}

}  // namespace umbra78::tools::captured
