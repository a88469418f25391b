// The report of a study: its plots and pictures as files, and one page that holds them all.
#pragma once

#include "tools/io/files.hpp"
#include "tools/study/study.hpp"

#include <nlohmann/json.hpp>

namespace umbra78::tools::study {

// Writes into a FileSet as it goes. Where gnuplot is missing, plots are scripts alone.
class ReportPage final : public Report {
public:
    ReportPage(const Path& folder, FileSet&);

    void paragraph(std::string_view text) override;
    void plot(const Plot&, std::string_view caption) override;
    void heat_map(const HeatMap&, std::string_view caption) override;
    void picture(std::string_view name, int width, int height,
                 std::span<const std::uint8_t> gray, std::string_view caption) override;
    void table(const std::vector<std::vector<std::string>>& rows,
               std::string_view caption) override;
    nlohmann::ordered_json& summary() override { return summary_; }

    std::string page(const std::string& title, const std::string& lead) const;  // HTML
    const std::vector<std::string>& paragraphs() const { return paragraphs_; }
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
    std::vector<std::string> paragraphs_;
    std::vector<Exhibit> exhibits_;
    nlohmann::ordered_json summary_ = nlohmann::ordered_json::object();
};

}  // namespace umbra78::tools::study
