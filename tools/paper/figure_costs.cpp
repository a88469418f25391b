#include "tools/paper/figure_costs.hpp"

#include "tools/io/text_formats.hpp"
#include "tools/paper/figure_set.hpp"

#include <fmt/format.h>

namespace umbra78::tools {

FigureCosts figure_costs() {
    FigureCosts all;
    LoadedScene scene = figures_scene();
    for (int figure = 1; figure <= shadow::figure_count; ++figure) {
        scene.settings = shadow::figure_settings(figure);
        all[static_cast<std::size_t>(figure) - 1] = profile_costs(scene, figure);
    }
    return all;
}

std::string figure_table(const FigureCosts& figures) {
    std::vector<std::vector<std::string>> table;
    for (std::size_t k = 0; k < figures.size(); ++k) {
        const auto rows = profile_rows(figures[k]);
        for (std::size_t r = k == 0 ? 0 : 1; r < rows.size(); ++r) {
            table.push_back(rows[r]);
            table.back().insert(table.back().begin(), r == 0 ? "fig." : fmt::format("{}", k + 1));
        }
    }
    return markdown_table(table);
}

}  // namespace umbra78::tools
