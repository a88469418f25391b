// The row of a case, from its name to its figures.
#include "tools/scene/settings_text.hpp"
#include "tools/study/row_text.hpp"
#include "tools/study/runner.hpp"

#include <nlohmann/json.hpp>

#include <exception>
#include <new>

namespace umbra78::tools::study {
namespace {

// What the case overrides that is no setting: a profile, observer.KEY, light.KEY.
void set_overrides(Row& row, const Case& c) {
    for (const std::string& set : c.set) {
        const std::size_t equals = set.find('=');
        const std::string key = set.substr(0, equals);
        if (shadow::find_setting(key) == nullptr) row.set(key, set.substr(equals + 1));
    }
}

void set_settings(Row& row, const std::optional<shadow::Settings>& settings) {
    const Row as_json = row_of(settings_json(settings.value_or(shadow::Settings{})));
    for (const auto& [key, value] : as_json.cells()) {
        if (!settings) {
            row.set(key, Value());
            continue;
        }
        const auto* real = std::get_if<double>(&value);
        const bool whole = real != nullptr && *real == static_cast<double>(std::int64_t(*real));
        row.set(key, whole ? Value(std::int64_t(*real)) : value);
    }
}

bool is_host_time(const std::string& column) { return column.ends_with("_host_ms"); }

}  // namespace

std::optional<shadow::Settings> Study::settings(const Request& request, const Case& c) const {
    return scene_of(request, c).settings;
}

Row run_case(const Asked& asked, std::size_t index, const Case& c) {
    Row row;
    row.set("case", static_cast<std::int64_t>(index));
    row.set("name", c.name);
    set_overrides(row, c);
    for (const auto& [column, value] : c.extra) row.set(column, value);
    try {
        set_settings(row, asked.study->settings(asked.request, c));
        row.set("status", std::string("ok"));
        const Row figures = asked.study->run(asked.request, c);
        for (const auto& [column, value] : figures.cells())
            if (asked.request.host_times || !is_host_time(column)) row.set(column, value);
    } catch (const std::bad_alloc&) {
        row.set("status", std::string("not enough memory"));
    } catch (const std::exception& error) {
        row.set("status", std::string(error.what()));
    }
    return row;
}

}  // namespace umbra78::tools::study
