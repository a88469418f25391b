// umbra78 study: runs a study (a table of cases, each drawn and measured), merges the parts of one,
// or renders rows of its CSV again.
#include "tools/cli/command_line.hpp"
#include "tools/cli/commands.hpp"
#include "tools/render/frame_warnings.hpp"
#include "tools/cli/study_list.hpp"
#include "tools/io/console.hpp"
#include "tools/render/report.hpp"
#include "tools/study/study_files.hpp"
#include "tools/study/vary.hpp"
#include "tools/study/verify.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <limits>
#include <memory>
#include <stdexcept>

namespace umbra78::tools {
namespace {

using namespace study;

struct StudyOptions {
    std::string scene, out, shard;
    std::vector<std::string> vary, parts;
    int jobs = 0;
    std::uint64_t sample = 8;
    bool quick = false, automatic = false, only = false, no_host_times = false;
    bool replace = false, json = false;
};

// "i/n" with 1 <= i <= n. A number that an int does not hold is refused.
Shard read_shard(const std::string& text) {
    Shard shard{0, 0};
    const char* const end = text.data() + text.size();
    const auto i = std::from_chars(text.data(), end, shard.i);
    const bool slash = i.ec == std::errc() && i.ptr != end && *i.ptr == '/';
    const auto n = slash ? std::from_chars(i.ptr + 1, end, shard.n) : i;
    if (!slash || n.ec != std::errc() || n.ptr != end || shard.i < 1 || shard.i > shard.n)
        throw std::runtime_error(fmt::format("--shard {}: it is not a part of a whole; write i/n "
                                             "as in 1/3, 2/3, 3/3, n up to {}",
                                             text, std::numeric_limits<int>::max()));
    return shard;
}

Asked asked_of(const Study& study, const StudyOptions& options) {
    Request request;
    if (!options.scene.empty()) take_scene(options.scene, request);
    for (const std::string& vary : options.vary) request.vary.push_back(parse_vary(vary));
    request.quick = options.quick;
    request.automatic = options.automatic;
    request.only = options.only;
    request.host_times = !options.no_host_times;
    return ask(study, std::move(request));
}

void print_done(const StudyDone& done, bool json) {
    if (done.failed > 0)
        print_warning(fmt::format("{} of {} cases failed; the first: {}", done.failed, done.rows,
                                  done.first_failure));
    if (done.plots_missing)
        print_warning("there are no plots, because gnuplot is missing; install it with: sudo "
                      "apt-get install gnuplot-nox");
    if (json) {
        fmt::print("{}", tools::print(done.summary));
        return;
    }
    for (const std::string& paragraph : done.paragraphs) fmt::print("{}\n\n", paragraph);
    for (const std::string& file : done.files) fmt::print("{}\n", file);
}

void run(const Study& study, const StudyOptions& options) {
    RunOptions how{options.jobs, {}, options.replace};
    if (!options.shard.empty()) how.shard = read_shard(options.shard);
    const Asked asked = asked_of(study, options);
    print_warnings(asked.request.scene.warnings);
    const Path folder = options.out.empty() ? Path("out") / study.name() : Path(options.out);
    print_done(run_study(asked, how, folder, !options.shard.empty()), options.json);
}

constexpr const char* replace_help = "Overwrite the folder's finished study of other inputs";

void add_study(const Command& above, const Study& study) {
    const auto options = std::make_shared<StudyOptions>();
    const std::string name(study.name());
    Command command(above, name, std::string(study.meaning()));
    if (study.takes().scene) {
        command.input("scene", options->scene, "FILE",
                      "Scene file (TOML); without one, the paper's scene");
        command.texts("--vary", options->vary, "KEY=VALUES",
                      "key=first:last:step or key=value,value: a setting, profile, observer.KEY or "
                      "light.KEY; in place of the study's values of that key, or crossed with all");
    }
    command.output_folder("--out", options->out, "Folder for the files; default: out/" + name);
    command.flag("--quick", options->quick, "A small grid: seconds");
    command.number("--jobs", options->jobs, "N", "Cases at a time; default: as many as cores")
        .range(1, 1024);
    command.text("--shard", options->shard, "I/N",
                 "Run the i-th of n parts, for umbra78 study merge, on this computer or others");
    if (study.takes().automatic)
        command.flag("--auto", options->automatic, "Print the answer for the scene");
    if (study.takes().only)
        command.flag("--only", options->only,
                     "No cases but the product of all --vary; what they leave out is the scene's");
    command.flag("--no-host-times", options->no_host_times,
                 "Leave out the columns that end in _host_ms or _host_mb: the same files every "
                 "time");
    command.flag("--replace", options->replace, replace_help);
    command.flag("--json", options->json, "Print the summary as JSON instead of text");
    command.footer(fmt::format("{1}Example:\n  umbra78 study {0} --quick --out out/{0}", name,
                               study.takes().scene ? "" : "Its cases are its own: it takes no "
                                                          "scene and no --vary.\n\n"));
    command.runs([options, &study] { run(study, *options); });
}

void add_merge(const Command& above) {
    const auto options = std::make_shared<StudyOptions>();
    Command command(above, "merge", "Make the files of a study from its parts");
    command.output_folder("out", options->out, "Folder for the files").required();
    command.inputs("parts", options->parts, "PART", "NAME.part-1-of-3.jsonl ..., all of them")
        .required();
    command.flag("--replace", options->replace, replace_help);
    command.flag("--json", options->json, "Print the summary as JSON instead of text");
    command.footer("Example:\n"
                   "  parallel umbra78 study error-time --quick --out parts --shard {}/3 ::: 1 2 "
                   "3\n  umbra78 study merge out/error-time parts/*.jsonl");
    command.runs([options] {
        print_done(merge_parts(options->parts, options->out, studies(), options->replace),
                   options->json);
    });
}

void add_verify(const Command& above, int& exit_code) {
    const auto options = std::make_shared<StudyOptions>();
    Command command(above, "verify",
                    "Render rows of a study's CSV again, and compare every figure but host times");
    command.input("csv", options->scene, "FILE.csv", "The CSV; its NAME.json beside it").required();
    command.number("--sample", options->sample, "N", "How many rows, by a fixed seed")
        .range(1, 1 << 20)
        .default_shown();
    command.json(options->json);
    command.footer("Example:\n  umbra78 study verify out/error-time/error-time.csv --sample 20");
    command.runs([options, &exit_code] {
        const Verified verified = verify(options->scene, options->sample, studies());
        exit_code = verified.differences.empty() ? 0 : 1;
        if (options->json) {
            fmt::print("{}", tools::print(nlohmann::ordered_json{
                                 {"csv", options->scene},
                                 {"rows", verified.rows},
                                 {"sampled", verified.sampled},
                                 {"differences", verified.differences}}));
            return;
        }
        for (const std::string& difference : verified.differences) fmt::print("{}\n", difference);
        if (verified.differences.empty())
            fmt::print("{}: {} of {} rows rendered again, no difference{}\n", options->scene,
                       verified.sampled, verified.rows,
                       verified.sampled < verified.rows
                           ? fmt::format("; --sample {} for all", verified.rows) : "");
    });
}

}  // namespace

void add_study_command(CLI::App& app, int& exit_code) {
    Command command(app, "study",
                    "Run a study: a grid of settings, measured and plotted; alone, list them");
    for (const auto& each : studies()) add_study(command, *each);
    add_merge(command);
    add_verify(command, exit_code);
    command.needs_no_command_below();
    const auto json = std::make_shared<bool>(false);
    command.json(*json);
    command.footer("Example:\n  umbra78 study error-time --quick");
    command.runs([command, json] {
        if (command.has_command_below()) return;
        nlohmann::ordered_json list = nlohmann::ordered_json::array();
        for (const auto& each : studies()) {
            list.push_back({{"study", each->name()}, {"meaning", each->meaning()}});
            if (!*json) fmt::print("{:<12} {}\n", each->name(), each->meaning());
        }
        if (*json) fmt::print("{}", tools::print(list));
    });
}

}  // namespace umbra78::tools
