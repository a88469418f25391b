#include "tools/study/moire/frame.hpp"

#include "hw/noise_source.hpp"
#include "shadow/post_process.hpp"

#include <algorithm>
#include <cmath>

namespace umbra78::tools::study {

const std::string_view slanted_plane = R"([observer]
projection = "orthographic"
target     = [0, 0, 0]
extent     = 2

[light]
kind      = "directional"
azimuth   = -80
elevation = 17
target    = [0, 0, 0]
extent    = 2.75

[[plane]]               # z = 0.37 x + 0.19 y
origin = [-2.2, -2.2, -1.232]
u      = [4.4, 0, 1.628]
v      = [0, 4.4, 0.836]
)";

Frequency GridBeat::harmonic(int k, int l) const {
    return aliased({k * x.u + l * y.u, k * x.v + l * y.v});
}

Frequency GridBeat::predicted() const {
    return std::abs(zu) >= std::abs(zv) ? harmonic(1, 0) : harmonic(0, 1);
}

GridBeat grid_beat(const SceneTruth& s) {
    const std::size_t size = s.truth.size, at = size / 2 * size + size / 2;
    const Real3 here = s.light_view.project(s.truth.position[at]);
    const auto step = [&](std::size_t next) {
        if (s.truth.surface[next] != s.truth.surface[at] || s.truth.surface[at] == no_surface)
            throw SceneError("the middle of the picture does not show one plane");
        return along(s.light_view.project(s.truth.position[next]), -1, here);
    };
    const Real3 a = step(at + 1), b = step(at + size);
    GridBeat beat{{a[0], b[0]}, {a[1], b[1]}, 0, 0};
    const double area = a[0] * b[1] - a[1] * b[0];
    beat.zu = (a[2] * b[1] - b[2] * a[1]) / area;
    beat.zv = (b[2] * a[0] - a[2] * b[0]) / area;
    return beat;
}

Harmonic harmonic_at(const GridBeat& beat, Frequency f, double reach, int max_order) {
    for (int order = 1; order <= max_order; ++order)
        for (int k = order; k >= 0; --k)
            for (const int l : {order - k, k - order})
                if (distance(beat.harmonic(k, l), f) <= reach) return {k, l};
    return {};
}

std::vector<std::uint8_t> mask_with_restarted_rows(const RenderJob& job) {
    using Words = std::span<const hw::Depth16>;
    const shadow::Settings& s = job.settings();
    const Buffer observer = job.buffer(Plane::observer_z), light = job.buffer(Plane::light_z);
    if (!std::holds_alternative<Words>(light.values))
        throw SceneError("the restarted generator is for Z of up to 16 bits");
    const Words z = std::get<Words>(observer.values), map_z = std::get<Words>(light.values);
    std::vector<hw::Depth16> held(map_z.begin(), map_z.end());  // a store's words are not const
    const hw::FrameStore<hw::Depth16> store{s.machine.xy_bits, held, {}};
    const shadow::LightMap<hw::Depth16> map{store, s.machine, s.lookup, s.background};
    const hw::TransformUnit unit(s.machine, job.matrices().lights[0].observer_to_light);

    std::vector<std::uint8_t> mask(z.size());
    for (int y = 0; y < s.machine.size_px(); ++y) {
        hw::NoiseSource noise(shadow::drawn_dither(s), s.machine, 0, 0);
        for (int x = 0; x < s.machine.size_px(); ++x) {
            const std::size_t at = store.address(x, y);
            const hw::DitherWords words = noise.next();
            if (z[at] == s.machine.background()) continue;
            if (in_shadow(map, unit(shadow::pixel_words(x, y, z[at], s)), words))
                mask[at] = shadow::mask_shadow;
        }
    }
    return mask;
}

ErrorSpectrum error_spectrum(const SceneTruth& s, const MachineMask& mask, int window_px) {
    const int size = s.truth.size, n = window_px;
    const auto error = error_image(s.truth, mask);
    const auto lit = lit_pixels(s.truth, mask);
    ErrorSpectrum spectrum;
    spectrum.flatness = median_local_flatness(error, size, lit);
    if (n == 0) return spectrum;
    const int corner = (size - n) / 2;
    const auto window = cut_window(error, size, corner, corner, n);
    spectrum.power = periodogram(window, n);
    spectrum.peak = highest_peak(spectrum.power, n);
    spectrum.fisher = fisher_test(window, n);
    const int segment = std::min(ErrorSpectrum::segment_px, n);
    const auto mean = segmented_spectrum(window, n, std::vector<std::uint8_t>(window.size(), 1),
                                         segment);
    spectrum.radial = radial_power(mean.power, segment);
    spectrum.segments = mean.segments;
    return spectrum;
}

std::vector<std::uint8_t> spectrum_picture(std::span<const double> power, int n,
                                           double decades) {
    double highest = 0;
    for (int at = 0; at < n * n; ++at)
        if (measured_bin(at % n, at / n, n)) highest = std::max(highest, power[at]);
    std::vector<std::uint8_t> gray(power.size());
    if (!(highest > 0)) return gray;
    for (int at = 0; at < n * n; ++at) {
        const int u = (at % n + n / 2) % n, v = (at / n + n / 2) % n;
        const double below = std::log10(std::max(power[v * n + u] / highest, 1e-300));
        gray[at] = static_cast<std::uint8_t>(
            std::lround(255 * std::clamp(1 + below / decades, 0.0, 1.0)));
    }
    return gray;
}

std::vector<double> busiest_window(const SceneTruth& s, const MachineMask& mask, int n) {
    const int size = s.truth.size;
    const auto error = error_image(s.truth, mask);
    const auto lit = lit_pixels(s.truth, mask);
    std::vector<double> busiest(static_cast<std::size_t>(n) * n);
    std::ptrdiff_t max = 0;
    for (int top = 0; top + n <= size; top += n / 4)
        for (int left = 0; left + n <= size; left += n / 4) {
            bool whole = true;
            for (int y = top; y < top + n && whole; ++y)
                for (int x = left; x < left + n; ++x) whole = whole && lit[y * size + x];
            if (!whole) continue;
            auto window = cut_window(error, size, left, top, n);
            const auto errors = std::count(window.begin(), window.end(), 1.0);
            if (errors <= max) continue;
            max = errors;
            busiest = std::move(window);
        }
    return busiest;
}

}  // namespace umbra78::tools::study
