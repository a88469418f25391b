// umbra78 model: prints a model of figure 7 or 8 as bicubic patches, from its table of parts.
#include "tools/cli/command_line.hpp"
#include "tools/cli/commands.hpp"
#include "tools/io/files.hpp"
#include "tools/io/suggest.hpp"
#include "tools/io/text_formats.hpp"
#include "tools/sculpt/model.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <stdexcept>

namespace umbra78::tools {
namespace {

struct ModelOptions {
    std::string name, only, out;
    bool json = false;
};

const Model& model_named(const std::string& name) {
    if (const Model* model = find_model(name)) return *model;
    std::vector<std::string_view> known;
    for (const Model& each : models()) known.push_back(each.name);
    throw std::runtime_error(
        fmt::format("there is no model '{}'; {}", name, suggest(name, known)));
}

std::vector<Part> chosen_parts(const Model& model, const std::string& only) {
    std::vector<Part> parts = model.parts();
    if (only.empty()) return parts;
    std::vector<Part> some = only_group(parts, only);
    if (!some.empty()) return some;
    const std::vector<std::string> groups = groups_of(parts);
    const std::vector<std::string_view> known(groups.begin(), groups.end());
    throw std::runtime_error(fmt::format("--only {}: the model '{}' has no such group; {}", only,
                                         model.name, suggest(only, known)));
}

void print_model(const ModelOptions& options) {
    const Model& model = model_named(options.name);
    const std::vector<Part> parts = chosen_parts(model, options.only);
    const std::string text = to_bpt(
        fmt::format("The {}: {}. Our own, not the paper's; printed by: umbra78 model {}{}",
                    model.name, model.meaning, model.name,
                    options.only.empty() ? "" : " --only " + options.only), parts);
    if (!options.out.empty()) write_file(options.out, std::as_bytes(std::span(text)));
    if (options.json)
        fmt::print("{}", print(model_summary(model.name, parts)));
    else if (options.out.empty())
        fmt::print("{}", text);
}

}  // namespace

void add_model_command(CLI::App& app, int&) {
    const auto options = std::make_shared<ModelOptions>();
    Command command(app, "model", "Print a model of figure 7 or 8 as bicubic patches (.bpt)");
    std::string names;
    for (const Model& model : models())
        names += fmt::format("{}{}: {}", names.empty() ? "" : "; ", model.name, model.meaning);
    command.text("name", options->name, "NAME", names).required();
    command.text("--only", options->only, "GROUP",
                 "Only the parts of one material: body or details of the robot, lips or teeth of "
                 "the smile");
    command.output("--out", options->out, ".bpt", "The file; default: it is printed");
    command.json(options->json, "the patches: their number, the parts, the box");
    command.footer("Example:\n  umbra78 model robot --only body > robot-body.bpt");
    command.runs([options] { print_model(*options); });
}

}  // namespace umbra78::tools
