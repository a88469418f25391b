// The report of a study as files: its plots and pictures, and one HTML page that holds them all.
//
// The page opens with the answers, then shows everything else in the order in which the study
// wrote it, and ends with what the run was. It needs no other file and no network.
#pragma once

#include "tools/io/files.hpp"
#include "tools/study/report.hpp"

#include <nlohmann/json.hpp>

namespace umbra78::tools::study {

// A picture or plot in the study's folder, and its caption.
struct Exhibit {
    std::string file;  // .svg for plots, with a .png beside it; .png for pictures
    std::string caption;
};

// Writes into a FileSet as it goes. If gnuplot is missing, plots are written as scripts alone.
class ReportPage final : public Report {
public:
    ReportPage(const Path& folder, FileSet&);

    void answer(std::string_view text) override;
    void heading(std::string_view text) override;
    void paragraph(std::string_view text) override;
    void plot(const Plot&, std::string_view caption) override;
    void heat_map(const HeatMap&, std::string_view caption) override;
    void picture(std::string_view name, int width, int height,
                 std::span<const std::uint8_t> gray, std::string_view caption) override;
    void table(const TableCells&, std::string_view caption) override;
    nlohmann::ordered_json& summary() override { return summary_; }

    std::string page(const std::string& title) const;  // HTML
    std::vector<std::string> texts() const;            // answers, then paragraphs
    const std::vector<Exhibit>& exhibits() const { return exhibits_; }
    bool plots_missing() const { return plots_missing_; }

private:
    void drawn(const std::string& name, const std::string& script, std::string_view caption);
    void write(const std::string& file, std::string_view bytes);
    void exhibit(const std::string& file, std::string_view type, std::string_view bytes,
                 std::string_view caption);

    Path folder_;
    FileSet& files_;
    bool gnuplot_;
    bool plots_missing_ = false;
    std::string body_;
    std::vector<std::string> answers_, paragraphs_;
    std::vector<Exhibit> exhibits_;
    nlohmann::ordered_json summary_ = nlohmann::ordered_json::object();
};

}  // namespace umbra78::tools::study
