// umbra78 animate: draws a sequence of pictures while the light or the observer moves round the
// scene. Pictures of the same inputs that are already in the folder are not drawn again.
#include "tools/cli/command_line.hpp"
#include "tools/cli/commands.hpp"
#include "tools/io/console.hpp"
#include "tools/io/interruptible.hpp"
#include "tools/render/frame_warnings.hpp"
#include "tools/render/plan_text.hpp"
#include "tools/render/report.hpp"
#include "tools/render/sequence_manifest.hpp"
#include "tools/render/thread_pool.hpp"
#include "tools/scene/azimuth_sweep.hpp"
#include "tools/scene/toml_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <charconv>
#include <chrono>
#include <memory>
#include <set>

namespace umbra78::tools {
namespace {

using nlohmann::ordered_json;

struct AnimateOptions {
    std::string scene, out, light, observer;
    std::vector<std::string> set;
    int frames = 0, threads = 1;
    bool json = false;
};

std::vector<AzimuthSweep> read_sweeps(const AnimateOptions& options) {
    std::vector<AzimuthSweep> sweeps;
    const auto add = [&](const char* view, const std::string& text) {
        if (text.empty()) return;
        sweeps.push_back(read_sweep(view, text));
        for (const std::string& set : options.set)
            if (parse_override(set).key == fmt::format("{}.azimuth", view))
                throw SceneError(fmt::format("--set {}: --{} sets it, too; leave one out", set,
                                             view));
    };
    add("light", options.light);
    add("observer", options.observer);
    if (sweeps.empty()) throw SceneError("nothing moves; give --light A:B, --observer A:B or both");
    return sweeps;
}

bool has_point_light(const AnimateOptions& options) try {
    return load_scene(options.scene, options.set).light().projection ==
           raster::Projection::perspective;
} catch (const SceneError&) {
    return false;
}

class Sequence {
public:
    explicit Sequence(const AnimateOptions& options)
        : options_(options), sweeps_(read_sweeps(options)),
          folder_(options.out.empty() ? Path(options.scene).stem() : Path(options.out)),
          scene_(load(1)), pool_(workers_for(options.threads)), old_(read_manifest(folder_)) {}

    void run();
    void print_summary() const;
    ordered_json to_json() const;

private:
    using Clock = std::chrono::steady_clock;

    // A sweep becomes a --set, so that each picture is the one `umbra78 render` makes.
    std::unique_ptr<LoadedScene> load(int frame) const {
        std::vector<std::string> set = options_.set;
        for (const AzimuthSweep& s : sweeps_) set.push_back(s.override_at(frame, options_.frames));
        try {
            auto loaded = std::make_unique<LoadedScene>(load_scene(options_.scene, set));
            if (loaded->is_coloured())
                throw SceneError(fmt::format("{}: an animation is grey; give materials and lights "
                                             "single levels", options_.scene));
            return loaded;
        } catch (const SceneError&) {
            if (!options_.light.empty() && has_point_light(options_))
                throw SceneError(fmt::format(
                    "--light {}: the light of {} is given by its position and has no azimuth; "
                    "move the observer, or give the light kind = \"directional\"",
                    options_.light, options_.scene));
            throw;
        }
    }
    void warn_of_other_frames();
    void warn(const Warnings&, const std::string& file);
    void draw(int frame);
    void store(const std::string& file, const std::string& inputs);
    void report(int frame, const ordered_json& row) const;
    void show_progress(int frame) const;

    const AnimateOptions& options_;
    std::vector<AzimuthSweep> sweeps_;
    Path folder_;
    std::unique_ptr<LoadedScene> scene_;  // of the current frame
    std::unique_ptr<LoadedScene> drawn_;  // of the last frame drawn; the job reads its spans
    ThreadPool pool_;
    std::unique_ptr<RenderJob> job_;
    SequenceManifest old_, manifest_;
    std::set<std::string> warned_;  // keys
    Warnings warnings_;
    ordered_json rows_ = ordered_json::array();
    int drawn_frames_ = 0;
    Clock::time_point start_ = Clock::now();
};

void Sequence::store(const std::string& file, const std::string& inputs) {
    FileSet files;
    files.make_folder(folder_);
    const Buffer picture = job_->buffer(Plane::picture);
    write_png_gray(folder_ / file, picture.size_px, picture.size_px, job_->bytes(Plane::picture),
                   &files);
    manifest_.push_back({file, inputs, hash_of(picture)});
    // Entries of later frames stay, so that an interrupted run loses nothing.
    SequenceManifest all = manifest_;
    for (const ManifestEntry& e : old_)
        if (e.file > file) all.push_back(e);
    write_manifest(folder_, all, files);
    files.commit();
}

// Pictures of an earlier, longer sequence stay where they are: a player would show them, too.
void Sequence::warn_of_other_frames() {
    std::set<std::string> other;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
        const std::string name = entry.path().filename().string();
        int frame = 0;
        const char* const digits = name.data() + std::string_view("frame_").size();
        if (name.starts_with("frame_") && name.ends_with(".png") &&
            std::from_chars(digits, name.data() + name.size(), frame).ptr ==
                name.data() + name.size() - std::string_view(".png").size() &&
            frame > options_.frames)
            other.insert(name);
    }
    if (other.empty()) return;
    const std::string warning = fmt::format(
        "{} also holds {} of another sequence ({}); remove them, or name another folder with --out",
        folder_.string(),
        other.size() == 1 ? "a frame" : fmt::format("{} frames", other.size()),
        other.size() == 1 ? *other.begin() : *other.begin() + " to " + *other.rbegin());
    warnings_.push_back({"other_frames", static_cast<double>(other.size()), warning});
    print_warning(warning);
}

// Prints each kind of warning once for the whole sequence, with the first frame that it is of.
void Sequence::warn(const Warnings& warnings, const std::string& file) {
    for (const Warning& warning : warnings) {
        if (!warned_.insert(warning.key).second) continue;
        warnings_.push_back(warning);
        warnings_.back().line += fmt::format(" (first in {})", file);
        print_warnings({warnings_.back()});
    }
}

void Sequence::draw(int frame) {
    const auto start = Clock::now();
    if (frame > 1) scene_ = load(frame);
    const std::string file = fmt::format("frame_{:04}.png", frame), inputs = hash_inputs(*scene_);
    warn(scene_->warnings, file);
    const ManifestEntry* there = find_drawn(old_, folder_, file, inputs);
    ordered_json& row = rows_.emplace_back(ordered_json{{"frame", frame}, {"file", file}});
    for (const AzimuthSweep& s : sweeps_)
        row[s.view + "_azimuth"] = s.at(frame, options_.frames);
    row["drawn"] = there == nullptr;
    row["kept"] = ordered_json::array();
    if (there != nullptr) {
        manifest_.push_back(*there);
    } else {
        if (job_) {
            job_->advance(scene_->view(), scene_->settings);
        } else {
            job_ = std::make_unique<RenderJob>(scene_->view(), scene_->settings,
                                               Maps::for_shadows_alone, pool_.executor());
        }
        drawn_ = std::move(scene_);
        job_->render();
        warn(frame_warnings(*drawn_, *job_, {}), file);
        row["kept"] = kept(job_->plan());
        store(file, inputs);
        ++drawn_frames_;
    }
    row["picture"] = manifest_.back().picture;
    row["host_ms"] = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

void Sequence::report(int frame, const ordered_json& row) const {
    std::string text = row["file"];
    for (const AzimuthSweep& s : sweeps_)
        text += fmt::format("  {} {}", s.view, s.at(frame, options_.frames));
    const std::vector<std::string> keys = row["kept"];
    text += !row["drawn"].get<bool>() ? "  already there"
            : keys.empty()            ? "  nothing kept"
                                      : fmt::format("  {}", fmt::join(keys, " "));
    fmt::print("{}  {:.1f} ms\n", text, row["host_ms"].get<double>());
}

// Only on a terminal on which the rows are not printed.
void Sequence::show_progress(int frame) const {
    if (!isatty(STDERR_FILENO) || (!options_.json && isatty(STDOUT_FILENO))) return;
    print_progress(fmt::format("\rframe {} of {}{}", frame, options_.frames,
                               frame == options_.frames ? "\n" : ""));
}

void Sequence::run() {
    const Interruptible interruptible;
    for (int frame = 1; frame <= options_.frames; ++frame) {
        draw(frame);
        if (!options_.json) report(frame, rows_.back());
        show_progress(frame);
        if (Interruptible::asked() && frame < options_.frames)
            throw std::runtime_error(fmt::format(
                "interrupted after frame {} of {}; run the same command again to continue", frame,
                options_.frames));
    }
    // Removes the entries of an earlier, longer sequence.
    FileSet files;
    write_manifest(folder_, manifest_, files);
    files.commit();
    warn_of_other_frames();
}

ordered_json Sequence::to_json() const {
    const std::chrono::duration<double, std::milli> ms = Clock::now() - start_;
    return {{"scene", options_.scene}, {"out", folder_.string()},
            {"frames", rows_},         {"drawn", drawn_frames_},
            {"warnings", tools::to_json(warnings_)}, {"total_host_ms", ms.count()}};
}

void Sequence::print_summary() const {
    const std::chrono::duration<double> s = Clock::now() - start_;
    fmt::print("{}: {} frames, {} drawn, {} already there; {:.1f} s in all.\n", folder_.string(),
               options_.frames, drawn_frames_, options_.frames - drawn_frames_, s.count());
}

void run(const AnimateOptions& options) {
    Sequence sequence(options);
    sequence.run();
    if (options.json) {
        fmt::print("{}", print(sequence.to_json()));
    } else {
        sequence.print_summary();
    }
}

}  // namespace

void add_animate_command(CLI::App& app, int&) {
    const auto options = std::make_shared<AnimateOptions>();
    Command command(app, "animate",
                    "Render a sequence in which the light or the observer moves round the scene");
    command.scene(options->scene);
    command.number("--frames", options->frames, "N", "Number of frames").range(1, 9999).required();
    command.text("--light", options->light, "A:B",
                 "Move the light's azimuth from A to B degrees");
    command.text("--observer", options->observer, "A:B",
                 "Move the observer's azimuth from A to B degrees");
    command.output_folder("--out", options->out,
                          "Folder for frame_0001.png ... and frames.json; default: the scene's "
                          "name. Frames already there with the same inputs are not drawn again");
    command.set(options->set);
    command.threads(options->threads);
    command.json(options->json);
    command.footer("Settings are those of umbra78 render --help.\n\nExample:\n"
                   "  umbra78 animate tools/scenes/figures.toml --frames 60 --light -100:80 "
                   "--out out");
    command.runs([options] { run(*options); });
}

}  // namespace umbra78::tools
