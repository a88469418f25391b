#include "tools/render/memory_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <utility>
#include <vector>

namespace umbra78::tools {
namespace {

using nlohmann::ordered_json;

std::vector<std::pair<const char*, const hw::DramCounts*>> stores(const shadow::MemoryLedger& l) {
    return {{"observer's Z", &l.observer}, {"light's Z", &l.light}, {"mask", &l.mask}};
}

double ms(std::uint64_t ns) { return static_cast<double>(ns) * 1e-6; }

double miss_percent(const hw::DramCounts& c) {
    return c.accesses == 0
               ? 0
               : 100.0 * static_cast<double>(c.row_misses) / static_cast<double>(c.accesses);
}

ordered_json to_json(const shadow::PathTime& p) {
    return {{"read", ms(p.read_ns)},
            {"unit", ms(p.unit_ns)},
            {"light", ms(p.light_ns)},
            {"write", ms(p.write_ns)}};
}

}  // namespace

std::string print_memory(const shadow::MemoryLedger& l) {
    std::string text =
        fmt::format("{:<14}{:>10}{:>11}{:>11}{:>7}{:>13}{:>12}{:>11}{:>10}\n", "store", "accesses",
                    "page hits", "row misses", "%", "row changes", "refresh ms", "video ms",
                    "busy ms");
    for (const auto& [name, c] : stores(l))
        text += fmt::format("{:<14}{:>10}{:>11}{:>11}{:>7.1f}{:>13}{:>12.2f}{:>11.2f}{:>10.2f}\n",
                            name, c->accesses, c->page_hits, c->row_misses, miss_percent(*c),
                            c->row_changes, ms(c->refresh_wait_ns), ms(c->video_wait_ns),
                            ms(c->busy_ns));
    text += fmt::format("transformation with this memory {:.2f} ms, with a store of one cycle "
                        "{:.2f} ms; it waits {:.2f} ms\nto read, {:.2f} for the unit, {:.2f} for "
                        "the light's store, {:.2f} to write\n",
                        ms(l.total_ns), ms(l.ideal_ns), ms(l.path.read_ns), ms(l.path.unit_ns),
                        ms(l.path.light_ns), ms(l.path.write_ns));
    return text;
}

ordered_json to_json(const shadow::MemoryLedger& l) {
    ordered_json json{{"total_ms", ms(l.total_ns)},
                      {"ideal_ms", ms(l.ideal_ns)},
                      {"waits_for_ms", to_json(l.path)}};
    for (const auto& [name, c] : stores(l))
        json["stores"].push_back({{"store", name},
                                  {"accesses", c->accesses},
                                  {"page_hits", c->page_hits},
                                  {"row_misses", c->row_misses},
                                  {"row_changes", c->row_changes},
                                  {"refresh_cycles", c->refresh_cycles},
                                  {"video_cycles", c->video_cycles},
                                  {"refresh_wait_ms", ms(c->refresh_wait_ns)},
                                  {"video_wait_ms", ms(c->video_wait_ns)},
                                  {"busy_ms", ms(c->busy_ns)}});
    return json;
}

}  // namespace umbra78::tools
