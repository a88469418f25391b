#include "tools/study/inputs.hpp"

#include "tools/io/text_formats.hpp"
#include "tools/study/paper_scene.hpp"
#include "tools/study/vary.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace umbra78::tools::study {
namespace {

using nlohmann::ordered_json;

constexpr int format = 1;  // of the rows; raise it when a column comes to mean something else

std::string fnv1a64(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char letter : text) {
        hash ^= static_cast<unsigned char>(letter);
        hash *= 0x100000001b3;
    }
    return fmt::format("fnv1a64:{:016x}", hash);
}

ordered_json inputs_of(const Study& study, const Request& request) {
    ordered_json json{{"program", "umbra78 " UMBRA78_VERSION},
                      {"format", format},
                      {"study", study.name()},
                      {"scene_file", request.scene_file},
                      {"scene", request.scene_text},
                      {"vary", ordered_json::array()},
                      {"quick", request.quick},
                      {"auto", request.automatic},
                      {"host_times", request.host_times}};
    if (request.only) json["only"] = true;
    if (!request.models.empty()) json["models"] = request.models;
    for (const auto& [key, values] : request.vary)
        json["vary"].push_back({{"key", key}, {"values", values}});
    return json;
}

// Of all but the scene's path: the same scene may lie elsewhere on another computer.
std::string hash_of(ordered_json inputs, const std::vector<Case>& cases) {
    inputs.erase("scene_file");
    std::string text = print_line(inputs);
    for (const Case& c : cases) {
        ordered_json extra = ordered_json::array();
        for (const auto& [column, value] : c.extra) extra.push_back({column, value});
        text += print_line({c.name, c.set, extra});
    }
    return fnv1a64(text);
}

}  // namespace

Asked ask(const Study& study, Request request) {
    if (request.scene_text.empty()) request.scene_text = paper_scene_text;
    if (request.scene_file.empty()) request.scene_file = "figures.toml";
    request.scene = scene_of(request, {});
    check_vary(request);
    Asked asked{&study, std::move(request), {}, {}, {}};
    asked.cases = study.cases(asked.request);
    if (asked.cases.empty())
        throw SceneError(fmt::format("the study {} has no cases for {}", study.name(),
                                     asked.request.scene_file));
    asked.inputs = inputs_of(study, asked.request);
    asked.hash = hash_of(asked.inputs, asked.cases);
    return asked;
}

Asked ask_again(const ordered_json& inputs, const std::string& path, Studies known) {
    Request request;
    const Study* study = nullptr;
    try {
        study = &study_of(inputs.at("study"), path, known);
        request.scene_file = inputs.at("scene_file");
        request.scene_text = inputs.at("scene");
        if (inputs.contains("models")) inputs.at("models").get_to(request.models);
        for (const ordered_json& vary : inputs.at("vary"))
            request.vary.emplace_back(vary.at("key"),
                                      vary.at("values").get<std::vector<std::string>>());
        request.quick = inputs.at("quick");
        request.automatic = inputs.at("auto");
        request.host_times = inputs.at("host_times");
        request.only = inputs.value("only", false);
    } catch (const nlohmann::json::exception&) {
        throw std::runtime_error(fmt::format(
            "{}: its inputs are not those of a study; give a file that umbra78 study wrote", path));
    }
    return ask(*study, std::move(request));
}

const Study& study_of(const std::string& name, const std::string& path, Studies known) {
    for (const auto& study : known)
        if (study->name() == name) return *study;
    throw std::runtime_error(fmt::format(
        "{}: this umbra78 has no study '{}'; umbra78 study lists those it has", path, name));
}

}  // namespace umbra78::tools::study
