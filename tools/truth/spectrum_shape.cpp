#include "tools/truth/spectrum_shape.hpp"

#include "fixed/trap.hpp"

#include <cmath>
#include <limits>

namespace umbra78::tools {
namespace {

// A bin's signed number: -n/2 < k <= n/2.
int centred(int k, int n) { return 2 * k > n ? k - n : k; }

// Calls visit(u, v, power) for one bin of each conjugate pair that is measured, u and v signed.
template <class Visit>
void for_half(std::span<const double> power, int n, Visit visit) {
    for (int v = 0; 2 * v <= n; ++v)
        for (int u = 0; u < n; ++u) {
            const bool own_conjugate = 2 * v % n == 0 && 2 * u % n == 0;
            const bool other_half = 2 * v % n == 0 && centred(u, n) < 0;
            if (measured_bin(u, v, n) && !own_conjugate && !other_half)
                visit(centred(u, n), v, power[v * n + u]);
        }
}

double folded(double f) { return f - std::round(f); }

}  // namespace

double Frequency::period_px() const {
    const double f = std::hypot(u, v);
    return f > 0 ? 1 / f : std::numeric_limits<double>::infinity();
}

Frequency aliased(Frequency f) {
    f = {folded(f.u), folded(f.v)};
    if (f.v < 0 || (f.v == 0 && f.u < 0)) f = {-f.u, -f.v};
    return f;
}

double distance(Frequency a, Frequency b) {
    const double same = std::hypot(folded(a.u - b.u), folded(a.v - b.v));
    return std::min(same, std::hypot(folded(a.u + b.u), folded(a.v + b.v)));
}

Peak highest_peak(std::span<const double> power, int n) {
    Peak peak;
    double sum = 0, max = 0, bins = 0;
    for_half(power, n, [&](int u, int v, double p) {
        sum += p;
        ++bins;
        if (p <= max) return;
        max = p;
        peak.at = {double(u) / n, double(v) / n};
    });
    if (sum > 0) peak.over_mean = max / (sum / bins);
    return peak;
}

// The terms fall like L^j / j!, L = m exp(-m g); with L beyond 20 the sum is 1 but for 2e-9, and
// its terms too large to add.
double fisher_p(double g, int m) {
    if (m < 1 || g <= 0 || std::log(m) + (m - 1) * std::log1p(-std::min(g, 0.5)) > std::log(20.0))
        return 1;
    double p = 0, log_choices = 0;  // of C(m, j)
    for (int j = 1; j <= m && j * g < 1; ++j) {
        log_choices += std::log((m - j + 1.0) / j);
        const double term = std::exp(log_choices + (m - 1) * std::log1p(-j * g));
        p += j % 2 ? term : -term;
        if (term < 1e-17 * std::abs(p)) break;
    }
    return std::min(std::max(p, 0.0), 1.0);
}

FisherTest fisher_test(std::span<const double> window, int n) {
    FisherTest test;
    double sum = 0, max = 0;
    const auto power = periodogram(window, n, Taper::none);
    for_half(power, n, [&](int, int, double p) {
        sum += p;
        max = std::max(max, p);
        ++test.ordinates;
    });
    if (sum > 0) {
        test.g = max / sum;
        test.p = fisher_p(test.g, test.ordinates);
    }
    return test;
}

RadialPower radial_power(std::span<const double> power, int n) {
    const int rings = n / 2;
    std::vector<double> sum(rings + 1), squares(rings + 1), bins(rings + 1);
    double total = 0, all = 0;
    for_half(power, n, [&](int u, int v, double p) {
        total += p;
        ++all;
        const auto ring = static_cast<int>(std::lround(std::hypot(u, v)));
        if (ring > rings) return;
        sum[ring] += p;
        squares[ring] += p * p;
        ++bins[ring];
    });
    RadialPower radial;
    radial.max_anisotropy_db = -std::numeric_limits<double>::infinity();
    for (int ring = 1; ring <= rings; ++ring) {
        if (bins[ring] < 2 || sum[ring] <= 0) continue;
        const double mean = sum[ring] / bins[ring];
        const double variance =
            std::max(squares[ring] - bins[ring] * mean * mean, 0.0) / (bins[ring] - 1);
        const double db = 10 * std::log10(std::max(variance / (mean * mean), 1e-12));
        radial.frequency.push_back(double(ring) / n);
        radial.power.push_back(mean / (total / all));
        radial.anisotropy_db.push_back(db);
        if (bins[ring] >= RadialPower::min_bins)
            radial.max_anisotropy_db = std::max(radial.max_anisotropy_db, db);
    }
    return radial;
}

std::vector<double> cut_window(std::span<const double> image, int size, int left, int top,
                               int n) {
    fixed::require(left >= 0 && top >= 0 && left + n <= size && top + n <= size,
                   "cut_window: the window is not within the image");
    std::vector<double> window;
    window.reserve(static_cast<std::size_t>(n) * n);
    for (int y = top; y < top + n; ++y)
        for (int x = left; x < left + n; ++x) window.push_back(image[y * size + x]);
    return window;
}

SegmentedSpectrum segmented_spectrum(std::span<const double> error, int size,
                                     std::span<const std::uint8_t> valid, int n) {
    SegmentedSpectrum mean{std::vector<double>(static_cast<std::size_t>(n) * n), n, 0};
    for (int top = 0; top + n <= size; top += n)
        for (int left = 0; left + n <= size; left += n) {
            bool whole = true;
            for (int i = 0; i < n * n; ++i)
                whole = whole && valid[(top + i / n) * size + left + i % n];
            if (!whole) continue;
            const auto power = periodogram(cut_window(error, size, left, top, n), n);
            for (std::size_t i = 0; i < power.size(); ++i) mean.power[i] += power[i];
            ++mean.segments;
        }
    for (double& p : mean.power) p /= std::max(mean.segments, 1);
    return mean;
}

}  // namespace umbra78::tools
