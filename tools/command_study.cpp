// umbra78 study: a question put to the machine as a table of cases.
#include "tools/commands.hpp"
#include "tools/report.hpp"
#include "tools/study/study_files.hpp"
#include "tools/study/vary.hpp"
#include "tools/study/verify.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

namespace umbra78::tools {
namespace {

using namespace study;

struct Options {
    std::string scene, out, shard;
    std::vector<std::string> vary, parts;
    int jobs = 0;
    std::size_t sample = 8;
    bool quick = false, automatic = false, no_host_times = false, json = false;
};

Shard read_shard(const std::string& text) {
    Shard shard{0, 0};
    int length = 0;
    if (std::sscanf(text.c_str(), "%d/%d%n", &shard.i, &shard.n, &length) != 2 ||
        length != static_cast<int>(text.size()) || shard.i < 1 || shard.i > shard.n)
        throw std::runtime_error(fmt::format("--shard {}: it is no part of a whole; write i/n as "
                                             "in 1/3, 2/3, 3/3", text));
    return shard;
}

Asked asked_of(const Study& study, const Options& options) {
    Request request;
    if (!options.scene.empty()) {
        request.scene = load_scene(options.scene, {});  // for its errors
        request.scene_file = options.scene;
        std::ifstream file(options.scene, std::ios::binary);
        request.scene_text.assign(std::istreambuf_iterator<char>(file), {});
    }
    for (const std::string& vary : options.vary) request.vary.push_back(parse_vary(vary));
    request.quick = options.quick;
    request.automatic = options.automatic;
    request.host_times = !options.no_host_times;
    return ask(study, std::move(request));
}

void print_done(const StudyDone& done, bool json) {
    if (done.failed > 0)
        fmt::print(stderr, "umbra78: warning: {} of {} cases failed; the first: {}\n", done.failed,
                   done.rows, done.first_failure);
    if (done.plots_missing)
        fmt::print(stderr, "umbra78: warning: there are no plots, for gnuplot is missing; install "
                           "it with: sudo apt-get install gnuplot-nox\n");
    if (json) {
        fmt::print("{}", tools::print(done.summary));
        return;
    }
    for (const std::string& paragraph : done.paragraphs) fmt::print("{}\n\n", paragraph);
    for (const std::string& file : done.files) fmt::print("{}\n", file);
}

void run(const Study& study, const Options& options) {
    RunOptions how{options.jobs, {}};
    if (!options.shard.empty()) how.shard = read_shard(options.shard);
    const Asked asked = asked_of(study, options);
    for (const std::string& warning : asked.request.scene.warnings)
        fmt::print(stderr, "umbra78: warning: {}\n", warning);
    const Path folder = options.out.empty() ? Path("out") / study.name() : Path(options.out);
    print_done(run_study(asked, how, folder, !options.shard.empty()), options.json);
}

void add_study(CLI::App& at, const Study& study) {
    const auto options = std::make_shared<Options>();
    CLI::App* command = at.add_subcommand(std::string(study.name()), std::string(study.meaning()));
    command
        ->add_option("scene", options->scene, "Scene file (TOML); without one, the paper's scene")
        ->type_name("FILE");
    command
        ->add_option("--vary", options->vary,
                     "key=first:last:step or key=value,value: a setting, profile, observer.KEY or "
                     "light.KEY; in place of the study's values of that key")
        ->type_name("KEY=VALUES")
        ->allow_extra_args(false);
    command
        ->add_option("--out", options->out,
                     fmt::format("Folder for the files; default: out/{}", study.name()))
        ->type_name("DIR");
    command->add_flag("--quick", options->quick, "A small grid: seconds");
    command->add_option("--jobs", options->jobs, "Cases at a time; default: as many as cores")
        ->type_name("N")
        ->check(CLI::Range(1, 1024));
    command
        ->add_option("--shard", options->shard,
                     "Run the i-th of n parts, for umbra78 study merge, on this computer or others")
        ->type_name("I/N");
    command->add_flag("--auto", options->automatic, "Print the answer for the scene");
    command->add_flag("--no-host-times", options->no_host_times,
                      "Leave out the columns that end in _host_ms: the same files every time");
    command->add_flag("--json", options->json, "Print the summary as JSON instead of text");
    command->footer(fmt::format("Example:\n  umbra78 study {} --quick --out out/{}", study.name(),
                                study.name()));
    command->callback([options, &study] { run(study, *options); });
}

void add_merge(CLI::App& at) {
    const auto options = std::make_shared<Options>();
    CLI::App* command = at.add_subcommand("merge", "Make the files of a study from its parts");
    command->add_option("out", options->out, "Folder for the files")->type_name("OUT")->required();
    command->add_option("parts", options->parts, "NAME.part-1-of-3.jsonl ..., all of them")
        ->type_name("PART")
        ->required();
    command->add_flag("--json", options->json, "Print the summary as JSON instead of text");
    command->footer("Example:\n"
                    "  parallel umbra78 study error-time --quick --out parts --shard {}/3 ::: 1 2 "
                    "3\n  umbra78 study merge out/error-time parts/*.jsonl");
    command->callback(
        [options] { print_done(merge_parts(options->parts, options->out), options->json); });
}

void add_verify(CLI::App& at, int& exit_code) {
    const auto options = std::make_shared<Options>();
    CLI::App* command = at.add_subcommand(
        "verify", "Render rows of a study's CSV again, and compare every figure but host times");
    command->add_option("csv", options->scene, "The CSV; its NAME.json beside it")
        ->type_name("FILE.csv")
        ->required();
    command->add_option("--sample", options->sample, "How many rows, by a fixed seed")
        ->type_name("N")
        ->capture_default_str();
    command->footer("Example:\n  umbra78 study verify out/error-time/error-time.csv --sample 20");
    command->callback([options, &exit_code] {
        const Verified verified = verify(options->scene, options->sample);
        for (const std::string& difference : verified.differences) fmt::print("{}\n", difference);
        if (!verified.differences.empty()) {
            exit_code = 1;
        } else {
            fmt::print("{}: {} of {} rows rendered again, no difference\n", options->scene,
                       verified.sampled, verified.rows);
        }
    });
}

}  // namespace

void add_study_command(CLI::App& app, int& exit_code) {
    CLI::App* command = app.add_subcommand(
        "study", "Run a study: a grid of settings, measured, plotted and told; alone, list them");
    for (const auto& each : studies()) add_study(*command, *each);
    add_merge(*command);
    add_verify(*command, exit_code);
    command->require_subcommand(0, 1);
    command->footer("Example:\n  umbra78 study error-time --quick");
    command->callback([command] {
        if (!command->get_subcommands().empty()) return;
        for (const auto& each : studies()) fmt::print("{:<12} {}\n", each->name(), each->meaning());
    });
}

}  // namespace umbra78::tools
