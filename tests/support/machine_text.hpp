// The machine's definition as one text: hw/MACHINE.md and the files of hw/machine. Tests look up
// published rows in it, wherever they are.
#pragma once

#include "tests/support/paths.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace umbra78::test {

inline const std::string& machine_text() {
    static const std::string text = [] {
        namespace fs = std::filesystem;
        const fs::path hw = fs::path(UMBRA78_SOURCE_DIR) / "hw";
        std::vector<fs::path> files{hw / "MACHINE.md"};
        for (const auto& entry : fs::directory_iterator(hw / "machine"))
            if (entry.path().extension() == ".md") files.push_back(entry.path());
        std::sort(files.begin() + 1, files.end());
        std::string all;
        for (const fs::path& path : files) {
            std::ifstream file(path);
            all.append(std::istreambuf_iterator<char>(file), {});
        }
        return all;
    }();
    return text;
}

// The cells of the rows of all tables whose first cells are `head`, without blanks around them.
inline std::vector<std::vector<std::string>> table_of(const std::string& text,
                                                      const std::string& head) {
    std::vector<std::vector<std::string>> rows;
    bool inside = false;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string line = text.substr(at, end - at);
        at = end + 1;
        if (line.starts_with(head)) {
            inside = true;
        } else if (!line.starts_with("|")) {
            inside = false;
        } else if (inside && !line.starts_with("|---")) {
            std::vector<std::string> cells;
            for (std::size_t from = 1, to; (to = line.find('|', from)) != line.npos;
                 from = to + 1) {
                const std::string cell = line.substr(from, to - from);
                const std::size_t first = cell.find_first_not_of(' ');
                const std::size_t last = cell.find_last_not_of(' ');
                cells.push_back(first == cell.npos ? "" : cell.substr(first, last - first + 1));
            }
            rows.push_back(cells);
        }
    }
    return rows;
}
inline std::vector<std::vector<std::string>> machine_table(const std::string& head) {
    return table_of(machine_text(), head);
}

}  // namespace umbra78::test
