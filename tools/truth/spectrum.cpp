#include "tools/truth/spectrum.hpp"

#include "tools/truth/image_walk.hpp"
#include "tools/truth/real3.hpp"

#include <kissfft/kissfft.hh>

#include <algorithm>
#include <cmath>
#include <complex>

namespace umbra78::tools {
namespace {

// Calls visit(power) for the bins the measures use.
template <class Visit>
void for_bins(std::span<const double> power, int n, Visit visit) {
    for (int v = 0; v < n; ++v)
        for (int u = 0; u < n; ++u)
            if (measured_bin(u, v, n)) visit(power[v * n + u]);
}

}  // namespace

// Rows, then columns; a real window's bin (-u, -v) equals its bin (u, v).
std::vector<double> periodogram(std::span<const double> window, int n, Taper taper) {
    expect_image(window.size(), n);
    if (n == 0) return {};
    using Line = std::vector<std::complex<double>>;
    const kissfft<double> transform(static_cast<std::size_t>(n), false);
    const int half = n / 2;
    double mean = 0;
    for (const double value : window) mean += value / static_cast<double>(window.size());
    std::vector<double> weight(n, 1.0), power(window.size());
    if (taper == Taper::hann)
        for (int i = 0; i < n; ++i) weight[i] = 0.5 - 0.5 * std::cos(2 * pi * (i + 0.5) / n);

    Line line(n), turned(n), columns(static_cast<std::size_t>(half + 1) * n);
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) line[x] = (window[y * n + x] - mean) * weight[x] * weight[y];
        transform.transform(line.data(), turned.data());
        for (int u = 0; u <= half; ++u) columns[u * n + y] = turned[u];
    }
    for (int u = 0; u <= half; ++u) {
        transform.transform(&columns[u * n], turned.data());
        for (int v = 0; v < n; ++v)
            power[v * n + u] = power[(n - v) % n * n + (n - u) % n] = std::norm(turned[v]);
    }
    return power;
}

double spectral_flatness(std::span<const double> window, int n) {
    double sum = 0, log_sum = 0, bins = 0;
    for_bins(periodogram(window, n), n, [&](double power) {
        sum += power;
        log_sum += std::log(std::max(power, 1e-300));  // an empty bin stays finite
        ++bins;
    });
    return sum > 0 ? std::exp(log_sum / bins) / (sum / bins) : 0;
}

double peak_over_mean(std::span<const double> window, int n) {
    double sum = 0, peak = 0, bins = 0;
    for_bins(periodogram(window, n), n, [&](double power) {
        sum += power;
        peak = std::max(peak, power);
        ++bins;
    });
    return sum > 0 ? peak / (sum / bins) : 0;
}

LocalFlatness median_local_flatness(std::span<const double> error, int size,
                                    std::span<const std::uint8_t> valid,
                                    const FlatnessSettings& settings) {
    expect_image(error.size(), size);
    expect_image(valid.size(), size);
    const int n = settings.window;
    std::vector<double> scores, window(static_cast<std::size_t>(n) * n);
    for (int top = 0; top + n <= size; top += settings.stride)
        for (int left = 0; left + n <= size; left += settings.stride) {
            std::vector<double> held;
            const auto at = [&](int i) { return (top + i / n) * size + left + i % n; };
            for (int i = 0; i < n * n; ++i)
                if (valid[at(i)]) held.push_back(error[at(i)]);
            if (held.empty() || static_cast<double>(held.size()) < settings.min_valid * n * n)
                continue;
            double mean = 0;
            for (const double value : held) mean += value / static_cast<double>(held.size());
            for (int i = 0; i < n * n; ++i) window[i] = valid[at(i)] ? error[at(i)] : mean;

            std::sort(held.begin(), held.end());
            const double commonest = held[held.size() / 2];  // of a binary image, the majority
            const auto like = std::count(held.begin(), held.end(), commonest);
            if (static_cast<std::ptrdiff_t>(held.size()) - like < settings.min_errors) continue;
            scores.push_back(spectral_flatness(window, n));
        }
    if (scores.empty()) return {};
    std::sort(scores.begin(), scores.end());
    const std::size_t count = scores.size();
    return {(scores[(count - 1) / 2] + scores[count / 2]) / 2, static_cast<int>(count)};
}

}  // namespace umbra78::tools
