// umbra78 study motion: what flickers when the light or the observer moves a little from frame to
// frame.
//
// A still picture hides what a sequence shows: errors that are as many in each frame may stay where
// they are, crawl, or be others in each frame. The light and the observer turn by a tenth of a
// degree, or move by a fraction of a texel or pixel. The noise belongs to the place of the picture
// or has another seed in each frame. The light's window follows freely or in whole texels.
#include "tools/study/motion/motion.hpp"

#include "tools/study/grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace umbra78::tools::study {
namespace {

std::string_view extra(const Case& c, std::string_view column) {
    for (const auto& [name, value] : c.extra)
        if (name == column) return value;
    return {};
}

class MotionStudy final : public Study {
public:
    std::string_view name() const override { return "motion"; }
    std::string_view meaning() const override {
        return "What flickers when the light or the observer moves a little in each frame";
    }
    std::vector<Case> cases(const Request&) const override;
    Row run(const Request&, const Case&, const LoadedScene*) const override;
    std::vector<ColumnMeaning> columns() const override;
    void report(const Request& request, std::span<const Row> rows, Report& to) const override {
        report_motion(request, rows, to);
    }

private:
    TruthCache truths_;
};

std::vector<Case> settings(const Request& request, std::vector<std::string> lookups,
                           std::vector<std::string> dithers, std::vector<std::string> biases) {
    return grid(request, {{"lookup", std::move(lookups)},
                          {"dither", std::move(dithers)},
                          {"bias_unit", {"quanta"}},
                          {"bias", std::move(biases)}});
}

// Those of figures 3 and 4, and in full what lies between them; each with both kinds of noise.
// Where there is no dither, another seed would change nothing.
std::vector<Case> with_noise(const Request& request) {
    const std::vector<Case> cases =
        request.quick
            ? joined(joined({}, settings(request, {"nearest"}, {"none"}, {"64"})),
                     settings(request, {"bilinear"}, {"none", "normal"}, {"192"}))
            : settings(request, {"nearest", "bilinear"}, {"none", "normal"}, {"64", "192"});
    std::vector<Case> all;
    for (const Case& c : cases) {
        const bool silent = std::ranges::find(c.set, "dither=none") != c.set.end();
        for (const char* noise : {"fixed", "renewed"}) {
            if (silent && noise[0] == 'r') continue;
            all.push_back(c);
            all.back().extra.emplace_back("noise", noise);
        }
    }
    return all;
}

std::vector<Case> MotionStudy::cases(const Request& request) const {
    const auto noisy = with_noise(request);
    const bool lamp = request.scene.light().projection == raster::Projection::perspective;
    std::vector<Case> all;
    for (const std::string_view motion : motion_names)
        for (const char* snapped : {"off", "on"}) {
            // A light that stands still has nothing to snap to, and a lamp's texels no one size.
            if (snapped[1] == 'n' && (lamp || motion == "observer turns")) continue;
            for (Case c : noisy) {
                c.extra.insert(c.extra.begin(), {{"motion", std::string(motion)},
                                                 {"snapped", snapped},
                                                 {"frames", frames_of(request)}});
                c.name = fmt::format("{}, snapped {}, noise {}, {}", motion, snapped,
                                     extra(c, "noise"), c.name);
                all.push_back(std::move(c));
            }
        }
    return all;
}

std::string steps(const std::vector<Flips>& all) {
    std::string text;
    for (const Flips& f : all)
        text += fmt::format("{}{:.6f}", text.empty() ? "" : ";", f.share(f.flicker()));
    return text;
}

// The mean over the steps, and the greatest.
template <class Share>
void set_mean_and_max(Row& row, const std::string& column, const std::vector<Flips>& all,
                      Share share) {
    double sum = 0, max = 0;
    for (const Flips& f : all) {
        sum += share(f);
        max = std::max(max, share(f));
    }
    row.set(column + "_mean", sum / static_cast<double>(all.size()));
    row.set(column + "_max", max);
}

Row MotionStudy::run(const Request&, const Case& c, const LoadedScene* scene) const {
    const MotionSeen seen = see_motion(*scene, motion_case(c), truths_);
    Row row;
    const auto& all = seen.compared;
    const auto set = [&](const char* column, auto pixels) {
        set_mean_and_max(row, column, all, [&](const Flips& f) { return f.share(pixels(f)); });
    };
    std::int64_t compared = 0;
    for (const Flips& f : all) compared += f.compared;
    row.set("compared_px", compared / static_cast<std::int64_t>(all.size()));
    set("truth_flips", [](const Flips& f) { return f.truth; });
    set("flips", [](const Flips& f) { return f.mask; });
    set("rightful", [](const Flips& f) { return f.rightful; });
    set("flicker", [](const Flips& f) { return f.flicker(); });
    set_mean_and_max(row, "flicker_outside", all, [](const Flips& f) { return f.outside_share(); });
    set_mean_and_max(row, "filtered_flicker", seen.filtered,
                     [](const Flips& f) { return f.share(f.flicker()); });
    const auto ever = std::ranges::count_if(seen.flickers, [](int n) { return n > 0; });
    const auto pixels = std::ranges::count(seen.seen, 1);
    row.set("ever_flickered",
            pixels > 0 ? static_cast<double>(ever) / static_cast<double>(pixels) : 0);
    row.set("flicker_steps", steps(all));
    row.set("off_corner_texels", seen.off_corner_texels);
    row.set("outside_light", static_cast<std::int64_t>(seen.outside_light));
    row.set("false_shadow", seen.false_shadow);
    row.set("false_light", seen.false_light);
    set_coverage(row, seen.worst);
    return row;
}

std::vector<ColumnMeaning> MotionStudy::columns() const {
    return {
        {"motion", "what turns by 0.1 degree a frame, or moves by 0.3 and 0.2 of its own pixels "
                   "along its X and Y; the observer takes the window of a light at infinity along"},
        {"snapped", "on: the light's window is moved so that the scene's origin lies on a corner "
                    "of its texels in each frame"},
        {"frames", "frames of the sequence; a step leads from one to the next"},
        {"noise", "fixed: the machine's, the same at each place of every picture; renewed: another "
                  "seed in each frame"},
        {"compared_px", "pixels that truth and machine see in both frames of a step, on average"},
        {"truth_flips_*", "share of the compared pixels whose true state changes in a step, mean "
                          "and maximum over the steps"},
        {"flips_*", "share whose state in the mask changes"},
        {"rightful_*", "share whose true state changes as well"},
        {"flicker_outside_*", "flicker as a share of the pixels outside the edge bands of both "
                              "frames"},
        {"flicker_steps", "flicker of each step"},
        {"flicker_*", "share that changes in the mask and not in truth"},
        {"filtered_flicker_*", "flicker of the mask after the scene's own filters, at half "
                               "darkness"},
        {"ever_flickered", "share of the compared pixels that flicker in some step"},
        {"off_corner_texels", "how far the scene's origin is from a corner of the light's texels, "
                              "the maximum over the frames"},
        {"outside_light", "surfaces that leave the light's volume while it moves: the shadows of "
                          "what lies outside are missing"},
        {"false_shadow", "share of the pixels lit in truth that the mask shadows, mean over the "
                         "frames"},
        {"false_light", "share of the pixels shadowed in truth that the mask lights, likewise"},
    };
}

}  // namespace

const char* frames_of(const Request& request) { return request.quick ? "3" : "16"; }

MotionCase motion_case(const Case& c) {
    MotionCase made;
    const auto found = std::ranges::find(motion_names, extra(c, "motion"));
    made.motion = static_cast<Motion>(found - std::begin(motion_names));
    made.snapped = extra(c, "snapped") == "on";
    made.renewed = extra(c, "noise") == "renewed";
    const std::string_view frames = extra(c, "frames");
    std::from_chars(frames.data(), frames.data() + frames.size(), made.frames);
    return made;
}

std::unique_ptr<Study> make_motion_study() { return std::make_unique<MotionStudy>(); }

}  // namespace umbra78::tools::study
