#include "tools/study/column_meanings.hpp"

#include "shadow/frame/settings.hpp"
#include "tools/study/measures.hpp"

namespace umbra78::tools::study {
namespace {

constexpr std::string_view a_setting = "a setting: see umbra78 settings";

constexpr ColumnMeaning of_the_framework[] = {
    {"case", "number of the case, from 0: umbra78 study verify names it"},
    {"name", "the case in words or as its overrides"},
    {"status", "ok, or why the case has no figures"},
    {"profile", "the profile whose settings the case takes"},
    {"observer.*", "a key of the scene's [observer] that the case overrides"},
    {"light.*", "a key of the scene's [light] that the case overrides"},
};

bool fits(std::string_view column, std::string_view name) {
    if (name.ends_with('*')) return column.starts_with(name.substr(0, name.size() - 1));
    if (name.starts_with('*')) return column.ends_with(name.substr(1));
    return column == name;
}

}  // namespace

std::optional<std::string> meaning_of(std::string_view column, const Study& study) {
    if (shadow::find_setting(column) != nullptr) return std::string(a_setting);
    for (const ColumnMeaning& known : study.columns())
        if (fits(column, known.name)) return std::string(known.meaning);
    for (const ColumnMeaning& known : coverage_columns)
        if (known.name == column) return std::string(known.meaning);
    for (const ColumnMeaning& known : of_the_framework)
        if (fits(column, known.name)) return std::string(known.meaning);
    return {};
}

TableCells column_table(const Row& row, const Study& study) {
    TableCells table{{"column", "meaning"}};
    for (const auto& [column, value] : row.cells()) {
        const auto meaning = meaning_of(column, study);
        if (meaning != a_setting) table.push_back({column, meaning.value_or("")});
    }
    return table;
}

}  // namespace umbra78::tools::study
