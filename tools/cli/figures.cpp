// umbra78 figures: draws figures 1 to 8 and the gallery, prints their errors and cost, and compares
// them with the goldens.
#include "tools/cli/command_line.hpp"
#include "tools/cli/commands.hpp"
#include "tools/io/console.hpp"
#include "tools/io/data_folder.hpp"
#include "tools/io/sheet.hpp"
#include "tools/paper/figure_comparisons.hpp"
#include "tools/paper/goldens.hpp"
#include "tools/paper/scene_pictures.hpp"
#include "tools/paper/scene_words.hpp"
#include "tools/scene/settings_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <deque>
#include <map>
#include <memory>

namespace umbra78::tools {
namespace {

using nlohmann::ordered_json;

struct FiguresOptions {
    std::string out = "out", goldens;
    bool check = false, bless = false, json = false, words = false, no_scenes = false;
};

std::string picture_name(const Figure& figure) { return fmt::format("fig{}.png", figure.number); }

// All that is drawn.
struct Drawn {
    FigureSet set;
    std::vector<DrawnScene> scenes;

    // Of every stage of figures 1 to 6, and the scenes' pictures.
    std::vector<Buffer> buffers() const {
        std::vector<Buffer> all = set.buffers();
        for (const DrawnScene& d : scenes)
            for (const Buffer& b : d.buffers()) all.push_back(b);
        return all;
    }
};

// By name of a buffer: "ok", "DIFFERS", or "none" where there is no golden.
using Statuses = std::map<std::string, std::string>;

Statuses statuses(const Drawn& drawn, const Hashes& hashes, std::span<const GoldenCheck> checks) {
    Statuses result;
    const auto add = [&](const std::string& name, const std::string& hash) {
        const auto found = hashes.find(name);
        result[name] = found == hashes.end() ? "none" : found->second == hash ? "ok" : "DIFFERS";
    };
    for (const Figure& f : drawn.set.figures()) add(f.golden, f.hash);
    for (const DrawnScene& d : drawn.scenes)
        for (const Buffer& b : d.buffers()) add(b.name, hash_of(b));
    for (const GoldenCheck& check : checks)
        if (!check.problem.empty()) result[check.buffer] = "DIFFERS";
    return result;
}

// Of all its channels: "ok" if all are.
std::string status(const DrawnScene& d, const Statuses& goldens) {
    std::string worst = "ok";
    for (const Buffer& b : d.buffers())
        if (const std::string& one = goldens.at(b.name); worst != "DIFFERS" && one != "ok")
            worst = one;
    return worst;
}

using Rate = std::optional<double>;
Rate false_shadow(const Figure& f) {
    return f.error ? Rate(f.error->all.false_shadow_rate()) : Rate();
}
Rate false_light(const Figure& f) {
    return f.error ? Rate(f.error->all.false_light_rate()) : Rate();
}

// A scene's caption: what it shows, of how many pieces, its error. `gray` outlives the cell.
SheetCell cell_of(const DrawnScene& d, std::span<const std::uint8_t> gray,
                  const std::string& title) {
    std::string pieces;
    if (d.patches > 0) pieces = fmt::format("{} patches", d.patches);
    if (d.triangles > 0)
        pieces += fmt::format("{}{} triangles", pieces.empty() ? "" : ", ", d.triangles);
    SheetCell cell{d.size_px, d.size_px, gray, {title, pieces}};
    if (d.error && d.error->graded.graded())
        cell.caption.push_back(fmt::format("light off by {} % on average, rms {} %",
                                           percent(d.error->graded.mean_absolute()),
                                           percent(d.error->graded.rms())));
    else if (d.error)
        cell.caption.push_back(fmt::format("false shadow {} %, false light {} %",
                                           percent(d.error->all.false_shadow_rate()),
                                           percent(d.error->all.false_light_rate())));
    std::string by_light;
    for (const ShadowReport& one : d.by_light)
        by_light += fmt::format("{}{}", by_light.empty() ? "" : ", ",
                                percent(one.graded.mean_absolute()));
    if (!by_light.empty())
        cell.caption.push_back(fmt::format("its lights off by {} % on average", by_light));
    return cell;
}

void write_contact_sheet(const Path& path, const Drawn& drawn, FileSet& files) {
    const FigureSet& set = drawn.set;
    std::vector<SheetCell> cells;
    for (const Figure& f : set.figures()) {
        std::vector<std::string> caption{fmt::format("Fig. {}: {}", f.number, f.shows),
                                         fmt::format("{:.1f} ms from the scene", f.host_ms)};
        if (f.error)
            caption.push_back(fmt::format("false shadow {} %, false light {} %",
                                          percent(false_shadow(f)), percent(false_light(f))));
        cells.push_back({set.size_px(), set.size_px(), f.picture, std::move(caption)});
    }
    for (const DrawnScene& d : drawn.scenes)
        if (d.of->figure)
            cells.push_back(cell_of(d, d.channels.front(),
                                    fmt::format("Fig. {}: {}", d.of->name.substr(3),
                                                d.of->shows)));
    write_sheet(path, cells, {.columns = 3}, &files);
}

void write_scenes(const Path& out, const Drawn& drawn, FileSet& files) {
    if (drawn.scenes.empty()) return;
    std::vector<SheetCell> cells, smile_and_robot;
    std::deque<std::vector<std::uint8_t>> grays;  // that the cells show
    for (const DrawnScene& d : drawn.scenes) {
        if (!d.left_out.empty()) continue;
        grays.push_back(d.gray());
        if (d.of->name == "fig7b" || d.of->name == "fig8")
            smile_and_robot.push_back({d.size_px, d.size_px, grays.back(), {}});
        const Path file =
            (d.of->figure ? out : out / "gallery") / fmt::format("{}.png", d.of->name);
        if (d.coloured())
            write_png_rgb(file, d.size_px, d.size_px, d.rgb, &files);
        else
            write_png_gray(file, d.size_px, d.size_px, grays.back(), &files);
        if (!d.of->figure)
            cells.push_back(cell_of(d, grays.back(), std::string(d.of->shows)));
    }
    write_sheet(out / "gallery" / "sheet.png", cells,
                {.columns = 5, .halved = true, .text_scale = 1}, &files);
    write_sheet(out / "smile_and_robot.png", smile_and_robot, {.columns = 2}, &files);
}

double machine_ms(const FigureSet& set, const Figure& f) {
    return simulated_ms(f.machine_cycles, set.clock_ns());
}

ordered_json to_json(const Drawn& drawn, const Statuses& goldens, double total_ms) {
    const FigureSet& set = drawn.set;
    ordered_json json{{"size_px", set.size_px()}, {"cycle_ns", set.clock_ns()}};
    for (const Figure& f : set.figures()) {
        json["figures"].push_back({{"figure", f.number},
                                   {"shows", f.shows},
                                   {"file", picture_name(f)},
                                   {"buffer", f.golden},
                                   {"hash", f.hash},
                                   {"golden", goldens.at(f.golden)},
                                   {"machine_cycles", f.machine_cycles},
                                   {"simulated_ms", machine_ms(set, f)},
                                   {"host_ms", f.host_ms},
                                   {"bias", to_json(f.bias)},
                                   {"error", to_json(f.error)},
                                   {"settings", settings_json(f.settings)}});
    }
    for (const DrawnScene& d : drawn.scenes) {
        ordered_json& row = json["scenes"].emplace_back(to_json(d));
        if (d.left_out.empty()) row["golden"] = status(d, goldens);
    }
    for (const Buffer& buffer : drawn.buffers()) json["hashes"][buffer.name] = hash_of(buffer);
    json["total_host_ms"] = total_ms;
    return json;
}

void print_rows(const FigureSet& set, const Statuses& goldens) {
    fmt::print("{:<4}{:<33}{:<39}{:<8}{:>9}{:>8}{:>9}{:>8}{:>8}\n", "fig", "shows", "hash",
               "golden", "cycles", "sim ms", "host ms", "FS %", "FL %");
    for (const Figure& f : set.figures())
        fmt::print("{:<4}{:<33}{:<39}{:<8}{:>9}{:>8.1f}{:>9.1f}{:>8}{:>8}\n", f.number, f.shows,
                   f.hash, goldens.at(f.golden), f.machine_cycles, machine_ms(set, f), f.host_ms,
                   percent(false_shadow(f)), percent(false_light(f)));
    fmt::print("\ncycles, sim ms: what the machine takes from the scene to the figure, at {} ns a "
               "cycle; host ms: what\nthis computer took. FS: false shadow, of the pixels that are "
               "lit in truth; FL: false light, of those in\nshadow in truth. A mask of at "
               "least 128 counts as shadow.\n",
               set.clock_ns());
    for (const Figure& f : set.figures()) {
        if (!f.error || f.number == 6) continue;  // figure 6 is figure 5's mask
        fmt::print("Fig. {}: bias {}; outside one light texel of the edge FS {} %, FL {} %; "
                   "{} isolated pixels\n", f.number, print(f.bias),
                   percent(f.error->outside_band.false_shadow_rate()),
                   percent(f.error->outside_band.false_light_rate()), f.error->isolated_pixels);
    }
}

void print_scenes(const Drawn& drawn, const Statuses& goldens) {
    if (drawn.scenes.empty()) return;
    constexpr const char* format =
        "{:<14}{:<35}{:<39}{:<8}{:>8}{:>10}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}\n";
    fmt::print("\n");
    fmt::print(format, "picture", "shows", "hash", "golden", "patches", "triangles", "FS %", "FL %",
               "mean %", "rms %", "lit %", "umbra %");
    for (const DrawnScene& d : drawn.scenes) {
        const std::string name(d.of->name);
        if (!d.left_out.empty()) {
            fmt::print("{:<14}left out: {}\n", name, d.left_out);
            continue;
        }
        const auto rate = [&](auto of) { return percent(d.error ? Rate(of(*d.error)) : Rate()); };
        const auto graded = [&](double (GradedError::*of)() const) {
            return rate([&](const ShadowReport& r) { return (r.graded.*of)(); });
        };
        const std::string hash =
            d.coloured() ? "see figures.json" : hash_of(d.buffers().front());
        fmt::print(format, name, d.of->shows, hash, status(d, goldens), d.patches, d.triangles,
                   rate([](const ShadowReport& r) { return r.all.false_shadow_rate(); }),
                   rate([](const ShadowReport& r) { return r.all.false_light_rate(); }),
                   graded(&GradedError::mean_absolute), graded(&GradedError::rms),
                   graded(&GradedError::lit_below_98_rate),
                   graded(&GradedError::umbra_above_2_rate));
    }
    fmt::print("\nmean, rms: how far the filtered mask is from the light that truth sees; lit: lit "
               "pixels that get less than\n98 % of it; umbra: pixels in shadow that get more than "
               "2 %. These hold for masks with grey levels, too.\n");
    fmt::print("\nWhat the shadow of each light costs, over the observer's view alone:\n{}",
               cost_table(drawn.scenes));
}

// Prints what differs and draws a picture of each difference. Returns whether nothing differs.
bool accept(std::span<const GoldenCheck> checks, const FiguresOptions& options, int size_px,
            FileSet& files) {
    bool all_right = true;
    for (const GoldenCheck& check : checks) {
        const Path picture = Path(options.out) / fmt::format("diff_{}.png", check.buffer);
        if (check.problem.empty()) {
            std::error_code none;
            std::filesystem::remove(picture, none);  // of an earlier check
            continue;
        }
        all_right = false;
        std::string see;
        if (!check.picture.empty()) {
            write_png_rgb(picture, size_px, size_px, check.picture, &files);
            see = fmt::format("; see {}", picture.string());
        }
        print_error(fmt::format("{} differs from its golden: {}{}", check.buffer, check.problem,
                                see));
    }
    return all_right;
}

void write_pictures(const Path& out, const Drawn& drawn, FileSet& files) {
    const FigureSet& set = drawn.set;
    for (const Figure& f : set.figures())
        write_png_gray(out / picture_name(f), set.size_px(), set.size_px(), f.picture, &files);
    write_contact_sheet(out / "sheet.png", drawn, files);
    write_scenes(out, drawn, files);
    write_highlights(out / "highlights.png", &files);
    write_samplings(out / "samplings.png", set, &files);
    write_ap120b_comparison(out / "ap120b.png", set, &files);
}

void run(FiguresOptions options, int& exit_code) {
    if (options.words) {
        const Path scene = data_folder() / "scenes" / "figures.toml";
        fmt::print("{}", paper_scene_words(load_scene(scene.string(), {})));
        return;
    }
    const auto start = std::chrono::steady_clock::now();
    if (options.goldens.empty()) options.goldens = (data_folder() / "goldens").string();
    FileSet files;
    const Path out = options.out;
    files.make_folder(out);  // before the work, for its error
    if (options.check) require_goldens(options.goldens);
    if (!options.no_scenes) files.make_folder(out / "gallery");
    Drawn drawn;
    if (!options.no_scenes)
        drawn.scenes = draw_scene_pictures((data_folder() / "scenes").string());
    const FigureSet& set = drawn.set;
    const std::vector<Buffer> buffers = drawn.buffers();
    const std::vector<GoldenCheck> checks =
        options.check ? check(options.goldens, buffers) : std::vector<GoldenCheck>{};
    Hashes hashes = read_hashes(options.goldens);

    if (options.bless) {
        files.make_folder(options.goldens);
        bless(options.goldens, buffers, files);
        for (const Buffer& buffer : buffers) hashes[buffer.name] = hash_of(buffer);
    }
    write_pictures(out, drawn, files);
    const Statuses goldens = statuses(drawn, hashes, checks);
    const bool right = accept(checks, options, set.size_px(), files);
    exit_code = right ? 0 : 1;
    const std::chrono::duration<double, std::milli> total =
        std::chrono::steady_clock::now() - start;
    const std::string json = print(to_json(drawn, goldens, total.count()));
    write_file(out / "figures.json", std::as_bytes(std::span(json)), &files);
    files.commit();

    if (options.json) {
        fmt::print("{}", json);
        return;
    }
    print_rows(set, goldens);
    print_scenes(drawn, goldens);
    if (options.bless) fmt::print("Goldens written to {}.\n", options.goldens);
    if (options.check && right)
        fmt::print("Every buffer equals its golden in {}.\n", options.goldens);
    fmt::print("{}: fig1.png .. {}, sheet.png, highlights.png, samplings.png, ap120b.png, "
               "figures.json; {:.0f} ms in all.\n",
               out.string(), options.no_scenes ? "fig6.png" : "fig8.png, gallery", total.count());
}

}  // namespace

void add_figures_command(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<FiguresOptions>();
    Command command(app, "figures", "Draw figures 1 to 8 of Williams 1978, and the gallery");
    command.output_folder("--out", options->out, "Folder for the pictures").default_shown();
    command.text("--goldens", options->goldens, "DIR",
                 "Folder of the goldens; default: those that came with the program");
    const Argument check = command.flag(
        "--check", options->check,
        "Compare every stage's buffer with its golden; exit 1 if one differs");
    command.flag("--bless", options->bless, "Make new goldens of what was drawn").excludes(check);
    command.flag("--no-scenes", options->no_scenes,
                 "Leave out what is drawn from scene files: figures 7 and 8 and the gallery");
    command.flag("--json", options->json, "Print figures.json instead of the table");
    command.flag("--words", options->words,
                 "Print the core's header of the figures' scene instead, and draw nothing");
    command.footer("Example:\n  umbra78 figures --out out --check");
    command.runs([options, &exit_code] { run(*options, exit_code); });
}

}  // namespace umbra78::tools
