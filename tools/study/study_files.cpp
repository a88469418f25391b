#include "tools/study/study_files.hpp"

#include "tools/io/text_formats.hpp"
#include "tools/render/report.hpp"
#include "tools/study/column_meanings.hpp"
#include "tools/study/csv.hpp"
#include "tools/study/measures.hpp"
#include "tools/study/report_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

namespace umbra78::tools::study {
namespace {

using nlohmann::ordered_json;

void write_text(const Path& path, std::string_view text, FileSet& files) {
    write_file(path, std::as_bytes(std::span(text)), &files);
}

// What host times depend on. The host's name is not recorded.
ordered_json environment() {
    std::string processor = "unknown", line;
    for (std::ifstream info("/proc/cpuinfo"); std::getline(info, line);)
        if (line.starts_with("model name")) {
            processor = line.substr(std::min(line.find(": ") + 2, line.size()));
            break;
        }
    return {{"compiler", __VERSION__},
            {"processor", processor},
            {"cores", std::thread::hardware_concurrency()}};
}

// The columns that make a case. With them a row of the CSV can be run again.
ordered_json case_columns(const std::vector<Case>& cases) {
    std::vector<std::string> varied, extra;
    const auto add = [](std::vector<std::string>& to, const std::string& name) {
        if (std::find(to.begin(), to.end(), name) == to.end()) to.push_back(name);
    };
    for (const Case& c : cases) {
        for (const std::string& set : c.set) add(varied, set.substr(0, set.find('=')));
        for (const auto& [column, value] : c.extra) add(extra, column);
    }
    return {{"varied", varied}, {"extra", extra}};
}

ordered_json summary_of(const Asked& asked, const StudyDone& done, const ReportPage& page,
                        const ordered_json& answers) {
    ordered_json json{{"study", asked.study->name()},
                      {"meaning", asked.study->meaning()},
                      {"inputs_hash", asked.hash},
                      {"cases", done.rows},
                      {"failed_cases", done.failed},
                      {"answers", answers},
                      {"paragraphs", page.texts()},
                      {"exhibits", ordered_json::array()},
                      {"case_columns", case_columns(asked.cases)},
                      {"inputs", asked.inputs}};
    for (const Exhibit& e : page.exhibits())
        json["exhibits"].push_back({{"file", e.file}, {"caption", e.caption}});
    if (asked.request.host_times) json["environment"] = environment();
    return json;
}

void count_failures(StudyDone& done, std::span<const Row> rows) {
    for (const Row& row : rows) {
        if (row.text("status") == "ok") continue;
        if (done.failed++ == 0)
            done.first_failure = fmt::format("case {} ({}): {}", row.text("case"),
                                             row.text("name"), row.text("status"));
    }
    if (done.failed == done.rows)
        throw std::runtime_error(fmt::format("every case of the study failed; {}",
                                             done.first_failure));
}

// What was run and what its columns mean, at the page's end.
void describe_run(const Asked& asked, std::span<const Row> rows, Report& page) {
    const Study& study = *asked.study;
    page.heading("The run");
    std::string text = fmt::format("{}. ", study.meaning());
    if (study.takes().scene) text += fmt::format("The scene is {}. ", asked.request.scene_file);
    text += fmt::format("There are {0} cases; each is a row of {1}.csv, which holds every figure "
                        "with all its digits. umbra78 study verify {1}.csv draws rows again.",
                        rows.size(), study.name());
    page.paragraph(text);
    page.table(column_table(rows.front(), study),
               fmt::format("The columns of {}.csv, without the settings of the frame, which "
                           "umbra78 settings describes.", study.name()));
}

// Of all rows, in the order of the cases.
StudyDone write_files(const Asked& asked, const std::map<std::size_t, Row>& by_case,
                      const Path& folder) {
    std::vector<Row> rows;
    for (const auto& [index, row] : by_case) rows.push_back(row);
    rows = aligned(rows);
    StudyDone done;
    done.rows = rows.size();
    count_failures(done, rows);

    FileSet files;
    files.make_folder(folder);
    const std::string name(asked.study->name());
    write_text(folder / (name + ".csv"), to_csv(rows), files);
    ReportPage page(folder, files);
    if (const std::string lost = words_of_coverage(rows); !lost.empty()) page.answer(lost);
    asked.study->report(asked.request, rows, page);
    done.summary = summary_of(asked, done, page, page.summary());
    write_text(folder / (name + ".json"), tools::print(done.summary), files);
    done.paragraphs = page.texts();
    describe_run(asked, rows, page);
    write_text(folder / "index.html", page.page("umbra78 study " + name), files);
    files.commit();
    done.plots_missing = page.plots_missing();
    done.files = {(folder / (name + ".csv")).string(), (folder / (name + ".json")).string(),
                  (folder / "index.html").string()};
    return done;
}

// The inputs that the first line of a part, or a whole summary, was made from. "" if it is neither.
std::string hash_in(const Path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string text;
    if (path.extension() == ".jsonl") {
        std::getline(file, text);
    } else {
        text.assign(std::istreambuf_iterator<char>(file), {});
    }
    try {
        return parse_json(text).at("inputs_hash");
    } catch (const nlohmann::json::exception&) {
        return "";
    }
}

// A finished study may have taken days.
void keep_other_inputs(const Path& file, const Asked& asked, bool replace) {
    std::error_code none;
    if (replace || !std::filesystem::exists(file, none) || hash_in(file) == asked.hash) return;
    throw std::runtime_error(fmt::format(
        "{}: it is of other inputs (scene, settings, grid or version) and would be overwritten; "
        "give another folder with --out, or --replace it", file.string()));
}

StudyDone write_part(const Asked& asked, const std::map<std::size_t, Row>& rows, Shard shard,
                     const Path& path) {
    std::string text = head_line(asked, shard);
    for (const auto& [index, row] : rows) text += row_line(index, row);
    write_file(path, std::as_bytes(std::span(text)));
    StudyDone done;
    done.rows = rows.size();
    done.files = {path.string()};
    done.summary = {{"study", asked.study->name()}, {"part", path.string()},
                    {"inputs_hash", asked.hash}, {"cases", rows.size()}};
    return done;
}

}  // namespace

StudyDone run_study(const Asked& asked, const RunOptions& options, const Path& folder,
                    bool as_part) {
    const Shard shard = options.shard;
    std::string name(asked.study->name());
    if (as_part) name += fmt::format(".part-{}-of-{}", shard.i, shard.n);
    keep_other_inputs(folder / (name + (as_part ? ".jsonl" : ".json")), asked, options.replace);
    FileSet made;
    made.make_folder(folder);
    made.commit();  // the rows to come are kept there, whatever happens
    const Path log = folder / (name + ".partial.jsonl");
    const std::map<std::size_t, Row> rows = run_cases(asked, options, log);
    StudyDone done = as_part ? write_part(asked, rows, shard, folder / (name + ".jsonl"))
                             : write_files(asked, rows, folder);
    std::filesystem::remove(log);
    return done;
}

StudyDone merge_parts(std::span<const std::string> parts, const Path& folder, Studies known,
                      bool replace) {
    std::optional<RowLog> all;
    std::map<int, std::string> seen;  // by the shard's number
    for (const std::string& path : parts) {
        RowLog part = read_row_log(path, all ? &*all : nullptr);
        if (all && (part.hash != all->hash || part.shard.n != all->shard.n))
            throw std::runtime_error(fmt::format(
                "{}: it is of another run than {}; merge the parts of one run", path,
                seen.begin()->second));
        const auto [twin, is_new] = seen.emplace(part.shard.i, path);
        if (!is_new)
            throw std::runtime_error(fmt::format("{}: it is part {} of {}, as is {}; give each "
                                                 "part once", path, part.shard.i, part.shard.n,
                                                 twin->second));
        if (all) {
            all->rows.merge(part.rows);
        } else {
            all = std::move(part);
        }
    }
    if (!all) throw std::runtime_error("there is nothing to merge; name the parts");
    for (int i = 1; i <= all->shard.n; ++i)
        if (!seen.contains(i))
            throw std::runtime_error(fmt::format("part {} of {} is missing; run it with --shard "
                                                 "{}/{}", i, all->shard.n, i, all->shard.n));
    const Asked asked = ask_again(all->inputs, seen.begin()->second, known);
    if (asked.hash != all->hash)
        throw std::runtime_error(fmt::format("{}: another version of umbra78 wrote it; run the "
                                             "study again with this one", seen.begin()->second));
    keep_other_inputs(folder / fmt::format("{}.json", asked.study->name()), asked, replace);
    for (std::size_t k = 0; k < asked.cases.size(); ++k)
        if (!all->rows.contains(k)) {
            const int i = static_cast<int>(k) % all->shard.n + 1;
            throw std::runtime_error(fmt::format("{}: it has no row of case {}; run part {} of {} "
                                                 "again", seen[i], k, i, all->shard.n));
        }
    return write_files(asked, all->rows, folder);
}

}  // namespace umbra78::tools::study
