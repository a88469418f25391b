// The measures on inputs whose answer is known, and MEASURES' negative controls: dithers that
// are no good must be told from one that is.
#include "tools/metrics.hpp"

#include "tools/edge_bands.hpp"
#include "tools/edge_distance.hpp"
#include "tools/spectrum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <random>
#include <stdexcept>

namespace umbra78::tools {
namespace {

constexpr double pi = std::numbers::pi;
constexpr unsigned seed = 1978;

using Image = std::vector<double>;
using Bytes = std::vector<std::uint8_t>;

struct Uniform {
    std::mt19937 bits{seed};
    double operator()() { return static_cast<double>(bits()) / 4294967296.0; }  // 0 .. 1
};

Image image(int size, const std::function<double(int, int)>& value) {
    Image made;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) made.push_back(value(x, y));
    return made;
}

LocalFlatness flatness(const Image& error, int size) {
    return median_local_flatness(error, size, Bytes(error.size(), 1));
}

// A truth that is seen everywhere and lit left of `edge`.
Truth half_lit(int size, int edge) {
    Truth truth;
    truth.size = size;
    truth.visible.assign(size * size, 1);
    for (int at = 0; at < size * size; ++at) truth.lit.push_back(at % size < edge);
    return truth;
}

Bytes shadow_from(int size, int edge) {
    Bytes mask;
    for (int at = 0; at < size * size; ++at) mask.push_back(at % size < edge ? 0 : 255);
    return mask;
}

int total(const Bytes& band) { return static_cast<int>(std::count(band.begin(), band.end(), 1)); }

TEST(ShadowError, AShiftedMaskGivesItsShift) {
    const Truth truth = half_lit(40, 20);
    const Bytes later = shadow_from(40, 23), sooner = shadow_from(40, 18);
    EXPECT_EQ(shadow_error(truth, {later, {}}).false_light, 3 * 40);
    EXPECT_EQ(shadow_error(truth, {later, {}}).false_shadow, 0);
    EXPECT_EQ(shadow_error(truth, {sooner, {}}).false_shadow, 2 * 40);
    EXPECT_DOUBLE_EQ(shadow_error(truth, {sooner, {}}).false_shadow_rate(), 0.1);
    EXPECT_DOUBLE_EQ(shadow_error(truth, {later, {}}).false_light_rate(), 0.15);

    for (const int radius : {0, 1, 2, 3, 4}) {
        const Bytes band = edge_band(truth, radius);
        EXPECT_EQ(total(band), 2 * radius * 40);
        const int left = std::max(3 - radius, 0) * 40;
        EXPECT_EQ(shadow_error(truth, {later, {}}, band).false_light, left);
    }
}

TEST(ShadowError, CountsOnlyWhatBothSee) {
    const Truth truth = half_lit(8, 4);
    Bytes drawn(64, 0);
    drawn[0] = drawn[7] = 1;
    const ShadowError error = shadow_error(truth, {Bytes(64, 128), drawn});
    EXPECT_EQ(error.lit, 1);
    EXPECT_EQ(error.shadowed, 1);
    EXPECT_EQ(error.false_shadow, 1);  // 128 is shadow, 127 is not
    EXPECT_EQ(shadow_error(truth, {Bytes(64, 127), drawn}).false_light, 1);
    EXPECT_EQ(shadow_error(truth, {Bytes(64, 127), drawn, 100}).false_light, 0);
    EXPECT_EQ(shadow_error({}, {}).false_shadow_rate(), 0);
    EXPECT_THROW(shadow_error(truth, {Bytes(63), {}}), std::invalid_argument);
}

TEST(ShadowError, AnIsolatedPixelAgreesWithNoNeighbour) {
    Bytes mask(100, 0);
    EXPECT_EQ(isolated_pixels({mask, {}}, 10), 0);
    mask[33] = 255;
    EXPECT_EQ(isolated_pixels({mask, {}}, 10), 1);
    mask[34] = 255;
    EXPECT_EQ(isolated_pixels({mask, {}}, 10), 0);
    for (int at = 0; at < 100; ++at) mask[at] = (at + at / 10) % 2 ? 255 : 0;
    EXPECT_EQ(isolated_pixels({mask, {}}, 10), 100);
    Bytes drawn(100, 0);
    drawn[50] = 1;  // alone: there is none to disagree with
    EXPECT_EQ(isolated_pixels({mask, drawn}, 10), 0);
}

// Light from above onto the floor, seen from above: texel and pixel map to one another.
TEST(LightTexelBand, OfACastShadowIsOneTexelWide) {
    const int size = 200;
    const TruthScene scene{{{{0, 3, 0}, 1.0}}, {{{-4, 0, -4}, {8, 0, 0}, {0, 0, 8}}}};
    const TruthLight light{false, {0, 1, 0}, {}};
    const TruthView above{false, {}, {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, 2, 0, 0, 2.5, 25};
    TruthView observer = above;  // below the sphere, so that only the floor is seen
    observer.target = {0, 1, 0};
    observer.near_depth = 0;
    observer.size = size;
    observer.extent = 2;
    observer.far_depth = 3;
    TruthScene floor_seen = scene;
    floor_seen.spheres.clear();
    Truth truth = trace(floor_seen, observer, light);
    for (std::size_t at = 0; at < truth.lit.size(); ++at) {
        truth.surface[at] += 1;  // as numbered in `scene`
        truth.lit[at] = !occluded(truth.position[at], light, scene, 1);
    }
    const double texel = above.pixel();
    for (const double filter_px : {0.0, 3.0}) {
        const Bytes band = light_texel_band(scene, light, above, truth, filter_px);
        const double width = texel + filter_px * observer.pixel();
        for (std::size_t at = 0; at < band.size(); ++at) {
            const double from_edge =
                std::abs(std::hypot(truth.position[at][0], truth.position[at][2]) - 1);
            const double slack = 0.15 * texel + (filter_px > 0 ? observer.pixel() : 0);
            if (std::abs(from_edge - width) <= slack) continue;
            EXPECT_EQ(band[at] != 0, from_edge < width) << at % size << ", " << at / size;
        }
    }
}

TEST(LightTexelBand, AtASpheresShadowLineReachesRootOfTwoRT) {
    const int size = 512;
    const double radius = 92, angle = -100 * pi / 180;
    const TruthScene scene{{{{0, 0, 0}, radius}}, {}};
    const TruthLight light{false, {std::sin(angle), 0, std::cos(angle)}, {}};
    const TruthView observer{false, {}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                             size / 2, 0, -size, size, size};
    TruthView map = observer;
    map.rotation[0] = {std::cos(angle), 0, -std::sin(angle)};
    map.rotation[2] = light.direction;
    const Truth truth = trace(scene, observer, light);
    const Bytes band = light_texel_band(scene, light, map, truth, 0);
    // Along the middle row: both sides of the line, where 1 - sin(azimuth from it) < T / r.
    const double reach = std::acos(1 - 1 / radius), line = -10 * pi / 180;
    EXPECT_NEAR(radius * std::sin(reach), std::sqrt(2 * radius), 0.1);  // 13.5 px
    for (int column = 0; column < size; ++column) {
        const std::size_t at = size / 2 * size + column;
        if (!truth.visible[at]) continue;
        const double azimuth = std::atan2(truth.position[at][0], truth.position[at][2]);
        if (std::abs(std::abs(azimuth - line) - reach) <= 0.02) continue;
        EXPECT_EQ(band[at] != 0, std::abs(azimuth - line) < reach) << column;
    }
}

// What the observer sees is enough to find the band, but where the edge itself is out of sight.
TEST(SeenTexelBand, IsTheSlidPointsBand) {
    const int size = 256;
    const TruthScene scene{{{{0, 0, 0}, 40.0}, {{-45, 55, 10}, 20}},
                           {{{-120, -60, 100}, {240, 0, 0}, {0, 0, -200}}}};
    const double angle = -60 * pi / 180;
    const TruthLight light{false, {std::sin(angle) * 0.8, 0.6, std::cos(angle) * 0.8}, {}};
    const TruthView observer{false, {}, {{1, 0, 0}, {0, 0.8, -0.6}, {0, 0.6, 0.8}},
                             128, 0, -400, 400, size};
    TruthView map = observer;
    map.rotation[2] = light.direction;
    map.rotation[0] = {std::cos(angle), 0, -std::sin(angle)};
    map.rotation[1] = cross(map.rotation[2], map.rotation[0]);
    for (const double texel : {1.0, 3.0}) {
        map.size = static_cast<int>(size / texel);
        const Truth truth = trace(scene, observer, light);
        const Bytes slid = light_texel_band(scene, light, map, truth, 0);
        const Bytes seen = seen_texel_band(map, truth);
        const Bytes near_slid = widened(slid, size, 1.5), near_seen = widened(seen, size, 1.5);
        int missed = 0, beside = 0;
        for (std::size_t at = 0; at < seen.size(); ++at) {
            missed += slid[at] && !near_seen[at];
            beside += seen[at] && !near_slid[at];
        }
        std::printf("texels of %g pixels: %d pixels slid, %d seen; %d missed, %d beside\n", texel,
                    total(slid), total(seen), missed, beside);
        EXPECT_GT(total(slid), 1000 * texel);
        EXPECT_LT(missed, total(slid) / 20);
        EXPECT_LT(beside, total(slid) / 30);
    }
}

// Straight edges: a shift is a distance; a lone wrong pixel is as far as it is.
TEST(EdgeDistance, IsTheShift) {
    const int size = 40;
    const Truth truth = half_lit(size, 20);
    for (const int shift : {-7, -1, 0, 3}) {
        const EdgeDistance d = edge_distance(truth, {shadow_from(size, 20 + shift), {}});
        EXPECT_DOUBLE_EQ(d.mean, std::abs(shift));
        EXPECT_DOUBLE_EQ(d.hausdorff, std::abs(shift));
    }
    Bytes acne = shadow_from(size, 20);
    acne[10 * size + 8] = 255;
    const EdgeDistance d = edge_distance(truth, {acne, {}});
    EXPECT_DOUBLE_EQ(d.hausdorff, 12);
    EXPECT_DOUBLE_EQ(d.mean, 12.0 / 81);
    Bytes band(size * size);
    band[10 * size + 8] = 1;
    EXPECT_DOUBLE_EQ(edge_distance(truth, {acne, {}}, band).hausdorff, 0);
    EXPECT_TRUE(std::isnan(edge_distance(truth, {Bytes(size * size, 0), {}}).mean));
}

// Against the nearest of all pairs.
TEST(EdgeDistance, IsThatOfTheNearestPixels) {
    std::mt19937 bits{seed};
    const int size = 24;
    for (int round = 0; round < 20; ++round) {
        Truth truth = half_lit(size, size);
        Bytes mask(size * size);
        for (int at = 0; at < size * size; ++at) {
            truth.lit[at] = bits() % 5 != 0;
            truth.visible[at] = bits() % 7 != 0;
            mask[at] = bits() % 5 == 0 ? 255 : 0;
        }
        const auto edge = [&](auto dark) {
            std::vector<int> places;
            for (int at = 0; at < size * size; ++at) {
                const auto lit_at = [&](int x, int y) {
                    const int other = y * size + x;
                    return x >= 0 && y >= 0 && x < size && y < size && truth.visible[other] &&
                           !dark(other);
                };
                const int x = at % size, y = at / size;
                if (truth.visible[at] && dark(at) &&
                    (lit_at(x - 1, y) || lit_at(x + 1, y) || lit_at(x, y - 1) || lit_at(x, y + 1)))
                    places.push_back(at);
            }
            return places;
        };
        const auto real = edge([&](int at) { return !truth.lit[at]; });
        const auto drawn = edge([&](int at) { return mask[at] != 0; });
        ASSERT_FALSE(real.empty() || drawn.empty());
        double sum = 0, most = 0;
        const auto add = [&](const std::vector<int>& from, const std::vector<int>& to) {
            for (const int a : from) {
                double least = 1e9;
                for (const int b : to)
                    least = std::min(least, std::hypot(a % size - b % size, a / size - b / size));
                sum += least;
                most = std::max(most, least);
            }
        };
        add(real, drawn);
        add(drawn, real);
        const EdgeDistance d = edge_distance(truth, {mask, {}});
        EXPECT_NEAR(d.mean, sum / static_cast<double>(real.size() + drawn.size()), 1e-9);
        EXPECT_NEAR(d.hausdorff, most, 1e-9);
    }
}

TEST(Flatness, OfWhiteNoiseIsExpOfMinusGammaAndMoreIfSparse) {
    Uniform uniform;
    const auto white = [&](double density) {
        return flatness(image(512, [&](int, int) { return uniform() < density; }), 512);
    };
    EXPECT_EQ(white(0.5).windows, 31 * 31);
    EXPECT_NEAR(white(0.5).median, 0.5615, 0.01) << "seed " << seed;
    EXPECT_NEAR(white(0.1).median, 0.568, 0.01) << "seed " << seed;
    EXPECT_NEAR(white(0.02).median, 0.592, 0.01) << "seed " << seed;
}

TEST(Flatness, OfWhatRepeatsIsLow) {
    const auto grating = [](int x, int y) { return std::sin(0.9 * x + 0.4 * y) > 0 ? 1.0 : 0.0; };
    EXPECT_LT(flatness(image(256, grating), 256).median, 0.1);
    const auto chirp = [](int x, int y) {
        return std::sin(0.004 * x * x + 0.003 * y * y) > 0 ? 1.0 : 0.0;
    };
    EXPECT_LT(flatness(image(256, chirp), 256).median, 0.48);
}

TEST(Flatness, LeavesOutWindowsThatSayNothing) {
    Uniform uniform;
    const Image noise = image(64, [&](int, int) { return uniform() < 0.5; });
    Bytes valid(noise.size(), 1);
    EXPECT_EQ(median_local_flatness(noise, 64, valid).windows, 9);
    valid[0] = 0;
    EXPECT_EQ(median_local_flatness(noise, 64, valid).windows, 8);
    EXPECT_EQ(median_local_flatness(noise, 64, valid, {.min_valid = 0.9}).windows, 9);
    EXPECT_EQ(flatness(Image(64 * 64, 0.0), 64).windows, 0);
    EXPECT_EQ(flatness(image(64, [](int x, int y) { return x < 15 && y < 1; }), 64).windows, 0);
    EXPECT_EQ(spectral_flatness(Image(32 * 32, 3.0), 32), 0);
}

// A wedge's height in quanta is rounded after dither; the error of the compare "was it rounded
// up?" is what a shadow test sees.
Image dithered_wedge(const std::function<double(int, int)>& dither) {
    return image(256, [&](int x, int y) {
        const double height = 0.37 * x + 0.19 * y;
        return std::floor(height + 0.5 + dither(x, y)) > height ? 1.0 : 0.0;
    });
}

TEST(Flatness, TellsGoodDitherFromBad) {
    Uniform uniform;
    const auto score = [](const std::function<double(int, int)>& dither) {
        return flatness(dithered_wedge(dither), 256).median;
    };
    const auto uniform_over = [&](double quanta) {
        return [&uniform, quanta](int, int) { return quanta * (uniform() - 0.5); };
    };
    EXPECT_GT(score(uniform_over(2)), 0.53) << "seed " << seed;
    EXPECT_LT(score(uniform_over(0)), 0.1);
    EXPECT_LT(score(uniform_over(0.25)), 0.48) << "seed " << seed;

    // A generator that starts every row in the same state.
    Image row;
    for (int x = 0; x < 256; ++x) row.push_back(2 * (uniform() - 0.5));
    EXPECT_LT(score([&](int x, int) { return row[x]; }), 0.48) << "seed " << seed;
}

TEST(Periodogram, AGratingPeaksAtItsFrequency) {
    const int n = 64;
    const Image grating =
        image(n, [](int x, int y) { return std::cos(2 * pi * (5 * x + 11 * y) / n); });
    const auto power = periodogram(grating, n);
    const auto peak = std::max_element(power.begin(), power.end()) - power.begin();
    EXPECT_TRUE(peak == 11 * n + 5 || peak == (n - 11) * n + n - 5) << peak;
    EXPECT_GT(peak_over_mean(grating, n), 500);
    // Against the definition, at one bin, of a window that is neither even nor odd.
    const Image window = image(8, [](int x, int y) { return x * x + 3 * y + x * y % 5; });
    double mean = 0, real = 0, imaginary = 0;
    for (const double value : window) mean += value / 64;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
            const auto hann = [](int i) { return std::pow(std::sin(pi * (i + 0.5) / 8), 2); };
            const double value = (window[y * 8 + x] - mean) * hann(x) * hann(y);
            real += value * std::cos(2 * pi * (3 * x + 6 * y) / 8);
            imaginary += value * std::sin(2 * pi * (3 * x + 6 * y) / 8);
        }
    const auto small = periodogram(window, 8);
    EXPECT_NEAR(small[6 * 8 + 3], real * real + imaginary * imaginary, 1e-9);
    EXPECT_NEAR(small[2 * 8 + 5], small[6 * 8 + 3], 1e-9);
}

TEST(Periodogram, OfWhiteNoisePeaksAtLogOfTheCells) {
    Uniform uniform;
    const Image noise = image(256, [&](int, int) { return uniform(); });
    EXPECT_NEAR(peak_over_mean(noise, 256), std::log(256 * 256), 3) << "seed " << seed;
    EXPECT_NEAR(spectral_flatness(noise, 256), 0.5615, 0.01) << "seed " << seed;
}

TEST(Profile, RunsFromTheLimbToTheShadowLineOnEitherSide) {
    const int size = 256;
    const TruthScene scene{{{{0, 0, 0}, 1.0}}, {}};
    const TruthView view{false, {}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 1.1, 0, -2, 2, size};
    for (const double degrees : {-100.0, 100.0, -150.0}) {
        const double angle = degrees * pi / 180, side = degrees < 0 ? -1 : 1;
        const TruthLight light{false, {std::sin(angle), 0, std::cos(angle)}, {}};
        const Truth truth = trace(scene, view, light);
        Bytes mask(size * size);
        const double line = std::abs(angle) - pi / 2, half_way = (line + pi / 2) / 2;
        for (std::size_t at = 0; at < mask.size(); ++at)  // false shadow on the line's half
            mask[at] = side * std::atan2(truth.position[at][0], truth.position[at][2]) < half_way
                           ? 255 : 0;
        const auto profile = limb_to_line_profile(truth, {mask, {}}, scene, 0, view, light, 4);
        int lit = 0;
        for (int bin = 0; bin < 4; ++bin) {
            EXPECT_GT(profile[bin].lit, 100) << degrees;
            EXPECT_EQ(profile[bin].false_shadow_rate(), bin < 2 ? 0 : 1) << degrees << " " << bin;
            lit += profile[bin].lit;
        }
        EXPECT_EQ(lit, std::count(truth.lit.begin(), truth.lit.end(), 1));
    }
}

}  // namespace
}  // namespace umbra78::tools
