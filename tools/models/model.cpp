#include "tools/models/model.hpp"

#include "tools/models/obj.hpp"
#include "tools/models/patch_files.hpp"
#include "tools/models/ply.hpp"
#include "tools/models/stl.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace umbra78::tools {
namespace {

struct ModelFormat {
    std::string_view ending;
    void (*read)(std::string_view text, ModelData&, FirstError&);
};

constexpr ModelFormat formats[] = {
    {".bpt", read_bpt}, {".bez", read_bez}, {".tea", read_tea},
    {".obj", read_obj}, {".stl", read_stl}, {".ply", read_ply}};

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return lower;
}

}  // namespace

std::string place_in(const ModelData& model, int line) {
    if (model.counted.empty()) return fmt::format("{}:{}", model.name, line);
    return fmt::format("{}: {} {}", model.name, model.counted, line);
}

ModelResult read_model(std::string_view text, const std::string& name) {
    ModelResult result;
    result.model.name = name;
    FirstError error;
    const std::string lower = lower_case(name);
    const auto format = std::find_if(std::begin(formats), std::end(formats), [&](const auto& f) {
        return lower.ends_with(f.ending);
    });
    if (format == std::end(formats))
        error.report(name + ": the name ends like no model's; known: .bpt, .bez, .tea, .obj, "
                            ".stl, .ply" +
                     (lower.ends_with(".u78p") ? "; a packed file stands in [stream]" : ""));
    else
        format->read(text, result.model, error);
    result.error = error.line();
    return result;
}

}  // namespace umbra78::tools
