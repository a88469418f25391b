#include "tools/study/report_page.hpp"

#include "tools/study/gnuplot.hpp"

#include <fmt/format.h>

namespace umbra78::tools::study {
namespace {

constexpr const char* style =
    "body{font:16px/1.5 sans-serif;max-width:62em;margin:2em auto;padding:0 1em;color:#222}"
    "section{background:#f2f6fa;border-left:4px solid #0072b2;padding:.2em 1.2em}"
    "h2{font-size:1.25em;margin:1.5em 0 .5em}section h2{margin-top:.5em}"
    "figure{margin:2em 0}img{max-width:100%;image-rendering:auto}figcaption,caption{color:#444;"
    "text-align:left;margin:.4em 0}table{border-collapse:collapse;font-size:14px;margin:2em 0}"
    "td,th{padding:.2em .7em;border-bottom:1px solid #ddd;text-align:left}";

std::string escaped(std::string_view text) {
    std::string result;
    for (const char letter : text) {
        switch (letter) {
            case '&': result += "&amp;"; break;
            case '<': result += "&lt;"; break;
            case '>': result += "&gt;"; break;
            case '"': result += "&quot;"; break;
            default: result += letter;
        }
    }
    return result;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view letters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
        std::uint32_t word = 0;
        for (std::size_t j = k; j < k + 3; ++j)
            word = word << 8 | (j < bytes.size() ? static_cast<std::uint8_t>(bytes[j]) : 0u);
        for (int shift = 18; shift >= 0; shift -= 6) text += letters[word >> shift & 63];
    }
    const std::size_t missing = (3 - bytes.size() % 3) % 3;
    text.replace(text.size() - missing, missing, missing, '=');
    return text;
}

}  // namespace

ReportPage::ReportPage(const Path& folder, FileSet& files)
    : folder_(folder), files_(files), gnuplot_(has_gnuplot()) {}

void ReportPage::write(const std::string& file, std::string_view bytes) {
    write_file(folder_ / file, std::as_bytes(std::span(bytes)), &files_);
}

void ReportPage::exhibit(const std::string& file, std::string_view type, std::string_view bytes,
                         std::string_view caption) {
    write(file, bytes);
    exhibits_.push_back({file, std::string(caption)});
    body_ += fmt::format("<figure><img alt=\"{}\" src=\"data:{};base64,{}\">"
                         "<figcaption>{}</figcaption></figure>\n",
                         escaped(file), type, base64(bytes), escaped(caption));
}

void ReportPage::answer(std::string_view text) { answers_.emplace_back(text); }

void ReportPage::heading(std::string_view text) {
    body_ += fmt::format("<h2>{}</h2>\n", escaped(text));
}

void ReportPage::paragraph(std::string_view text) {
    paragraphs_.emplace_back(text);
    body_ += fmt::format("<p>{}</p>\n", escaped(text));
}

void ReportPage::plot(const Plot& plot, std::string_view caption) {
    drawn(plot.name, script_of(plot), caption);
}

void ReportPage::heat_map(const HeatMap& map, std::string_view caption) {
    drawn(map.name, script_of(map), caption);
}

void ReportPage::drawn(const std::string& name, const std::string& script,
                       std::string_view caption) {
    write(name + ".gnuplot", script);
    if (!gnuplot_) {
        plots_missing_ = true;
        return;
    }
    write(name + ".png", draw(name, script, PlotFormat::png));
    exhibit(name + ".svg", "image/svg+xml", draw(name, script, PlotFormat::svg), caption);
}

void ReportPage::picture(std::string_view name, int width, int height,
                         std::span<const std::uint8_t> gray, std::string_view caption) {
    const std::vector<std::byte> bytes = png_gray(width, height, gray);
    exhibit(fmt::format("{}.png", name), "image/png",
            {reinterpret_cast<const char*>(bytes.data()), bytes.size()}, caption);
}

void ReportPage::table(const TableCells& rows, std::string_view caption) {
    body_ += fmt::format("<table><caption>{}</caption>\n", escaped(caption));
    const char* cell = "th";
    for (const std::vector<std::string>& row : rows) {
        body_ += "<tr>";
        for (const std::string& text : row)
            body_ += fmt::format("<{0}>{1}</{0}>", cell, escaped(text));
        body_ += "</tr>\n";
        cell = "td";
    }
    body_ += "</table>\n";
}

std::vector<std::string> ReportPage::texts() const {
    std::vector<std::string> all = answers_;
    all.insert(all.end(), paragraphs_.begin(), paragraphs_.end());
    return all;
}

std::string ReportPage::page(const std::string& title) const {
    std::string answers;
    for (const std::string& text : answers_) answers += fmt::format("<p>{}</p>\n", escaped(text));
    if (answers_.empty())
        answers = "<p>These cases do not answer the study's question. Their figures are below."
                  "</p>\n";
    return fmt::format("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
                       "<title>{0}</title><style>{1}</style></head>\n<body><h1>{0}</h1>\n"
                       "<section><h2>The answer</h2>\n{2}</section>\n{3}</body></html>\n",
                       escaped(title), style, answers, body_);
}

}  // namespace umbra78::tools::study
