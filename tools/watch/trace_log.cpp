// The lines of a trace as a table of text, and as JSON.
#include "tools/watch/trace_log.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace umbra78::tools {
namespace {

constexpr std::size_t columns = 8;
using TextRow = std::array<std::string, columns>;

TextRow row_of(const TraceLine& line, bool same) {
    TextRow row;
    if (!same) row[0] = line.cycle ? fmt::format("{}", *line.cycle) : "-";
    if (!same) row[1] = line.part;
    row[2] = line.name;
    row[3] = line.decimal;
    if (line.word) {
        row[4] = real_text(*line.word);
        row[5] = format_text(*line.word);
        row[6] = hex_text(*line.word);
    }
    row[7] = line.how;
    return row;
}

// Numbers are aligned right, text left; a remark needs no columns.
std::string print(const TextRow& row, const std::array<std::size_t, columns>& width) {
    constexpr std::array<bool, columns> right{true, false, false, true, true, false, true, false};
    std::string text = fmt::format("{:>{}}  {:<{}}", row[0], width[0], row[1], width[1]);
    const bool said = row[2].empty();
    for (std::size_t c = 2; c < columns && !said; ++c)
        text += right[c] ? fmt::format("  {:>{}}", row[c], width[c])
                         : fmt::format("  {:<{}}", row[c], width[c]);
    if (said) text += "  " + row[7];
    return text.substr(0, text.find_last_not_of(' ') + 1) + "\n";
}

}  // namespace

void TraceLog::at(std::string_view part, std::optional<std::uint64_t> cycle) {
    part_ = part;
    cycle_ = cycle;
}

void TraceLog::add(TraceLine line) {
    line.part = part_;
    line.cycle = cycle_;
    lines_.push_back(std::move(line));
}

void TraceLog::word(std::string_view name, const MachineWord& word, std::string_view how) {
    TraceLine line;
    line.name = name;
    line.word = word;
    line.decimal = fmt::format("{}", word.value);
    line.how = how;
    add(std::move(line));
}

void TraceLog::number(std::string_view name, const WideWord& value, std::string_view how) {
    TraceLine line;
    line.name = name;
    line.decimal = decimal_text(value);
    line.how = how;
    add(std::move(line));
}

void TraceLog::say(std::string_view what) {
    TraceLine line;
    line.how = what;
    add(std::move(line));
}

std::string to_text(const std::vector<TraceLine>& lines) {
    std::vector<TextRow> rows{
        {"cycle", "part", "word", "decimal", "value", "format", "hex", "how"}};
    const TraceLine* last = nullptr;
    for (const TraceLine& line : lines) {
        rows.push_back(
            row_of(line, last && last->part == line.part && last->cycle == line.cycle));
        last = &line;
    }
    std::array<std::size_t, columns> width{};
    for (const TextRow& row : rows)
        for (std::size_t c = 0; c + 1 < columns; ++c) width[c] = std::max(width[c], row[c].size());
    std::string text;
    for (const TextRow& row : rows) text += print(row, width);
    return text;
}

nlohmann::ordered_json to_json(const std::vector<TraceLine>& lines) {
    auto json = nlohmann::ordered_json::array();
    for (const TraceLine& line : lines) {
        auto& row = json.emplace_back();
        row["part"] = line.part;
        row["cycle"] = nullptr;
        if (line.cycle) row["cycle"] = *line.cycle;
        if (!line.name.empty()) row["word"] = line.name;
        if (line.word) row["decimal"] = line.word->value;
        if (line.word) row["value"] = real_text(*line.word);
        if (line.word) row["format"] = format_text(*line.word);
        if (line.word) row["bits"] = line.word->bits;
        if (line.word) row["hex"] = hex_text(*line.word);
        if (!line.word && !line.decimal.empty()) row["decimal"] = line.decimal;
        if (!line.how.empty()) row["how"] = line.how;
    }
    return json;
}

}  // namespace umbra78::tools
