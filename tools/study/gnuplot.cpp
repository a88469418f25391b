#include "tools/study/gnuplot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

namespace umbra78::tools::study {
namespace {

// A text in gnuplot's single quotes.
std::string in_quotes(std::string_view text) {
    std::string result = "'";
    for (const char letter : text)
        if (static_cast<unsigned char>(letter) >= ' ')
            result += letter == '\'' ? "''" : std::string(1, letter);
    return result + "'";
}

// A text of a data block, where it is one word in double quotes.
std::string data_text(std::string_view text) {
    std::string result = "\"";
    for (const char letter : text)
        if (letter != '"' && letter != '\\' && static_cast<unsigned char>(letter) >= ' ')
            result += letter;
    return result + '"';
}

std::string head(const std::string& name, const std::string& title, const std::string& x_label,
                 const std::string& y_label) {
    return fmt::format("# {}: umbra78 study; data inside\nset encoding utf8\n"
                       "set termoption noenhanced\nset title {}\nset xlabel {}\nset ylabel {}\n",
                       name, in_quotes(title), in_quotes(x_label), in_quotes(y_label));
}

std::string ticks(char axis, const std::vector<std::string>& names) {
    std::string text = fmt::format("set {}tics (", axis);
    for (std::size_t k = 0; k < names.size(); ++k)
        text += fmt::format("{}{} {}", k ? ", " : "", in_quotes(names[k]), k);
    return text + (axis == 'x' ? ") rotate by 30 right\n" : ")\n");
}

// Powers of ten are enough over two decades; below, what lies between is labelled, too.
std::string log_ticks(char axis, double min, double max) {
    if (max >= 100 * min) return "";
    const std::vector<double> between = max < 8 * min
        ? std::vector<double>{1, 1.5, 2, 2.5, 3, 4, 5, 6, 7, 8, 9}
        : std::vector<double>{1, 2, 5};
    std::vector<std::string> places;
    for (double ten = std::pow(10, std::floor(std::log10(min))); ten <= max; ten *= 10)
        for (const double factor : between)
            if (factor * ten >= min && factor * ten <= max)
                places.push_back(fmt::format("{:.6g}", factor * ten));
    return fmt::format("set {}tics ({})\n", axis, fmt::join(places, ", "));
}

// gnuplot's own range on a logarithmic axis goes to the next power of ten.
std::string log_range(char axis, const std::vector<Series>& series) {
    double min = 0, max = 0;
    for (const Series& s : series)
        for (const auto& [x, y] : s.points) {
            const double value = axis == 'x' ? x : y;
            if (!(value > 0) || !std::isfinite(value)) continue;
            min = min > 0 ? std::min(min, value) : value;
            max = std::max(max, value);
        }
    if (!(min > 0)) return "";
    const double room = std::max(std::pow(max / min, 0.06), 1.02);
    return fmt::format("set logscale {0}\nset {0}range [{1}:{2}]\nset format {0} '%g'\n{3}", axis,
                       min / room, max * room,
                       log_ticks(axis, min / room, max * room));
}

constexpr std::array colours{"#0072b2", "#e69f00", "#009e73", "#cc79a7", "#333333", "#d55e00",
                             "#56b4e9", "#999933", "#7a3b9a", "#8b4513", "#b0b000", "#888888"};

std::string number(double value) {
    return std::isfinite(value) ? fmt::format("{}", value) : "NaN";
}

std::string output_of(const std::string& command, int& status) {
    std::string output;
    std::FILE* pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) return status = -1, output;
    std::array<char, 1 << 14> block;
    while (const std::size_t got = std::fread(block.data(), 1, block.size(), pipe))
        output.append(block.data(), got);
    status = ::pclose(pipe);
    return output;
}

// A temporary file without a name, which the commands that are started inherit. Nothing of it is
// left, however the program ends.
class Script {
public:
    explicit Script(const std::string& text) : file_(std::tmpfile()) {
        if (file_ == nullptr || std::fwrite(text.data(), 1, text.size(), file_) != text.size() ||
            std::fflush(file_) != 0)
            throw std::runtime_error(fmt::format(
                "cannot write a temporary file: {}; make room in /tmp",
                std::generic_category().message(errno)));
    }
    ~Script() {
        if (file_ != nullptr) std::fclose(file_);
    }
    Script(const Script&) = delete;
    Script& operator=(const Script&) = delete;

    std::string run(const char* redirected, int& status) const {
        std::rewind(file_);
        return output_of(fmt::format("gnuplot <&{} {}", fileno(file_), redirected), status);
    }

private:
    std::FILE* file_;
};

}  // namespace

std::string script_of(const Plot& plot) {
    std::string text = head(plot.name, plot.title, plot.x_label, plot.y_label);
    text += "set grid\nset key below height 1\nset xlabel offset 0,0.5\n";
    if (plot.log_x) text += log_range('x', plot.series);
    if (plot.log_y) text += log_range('y', plot.series);
    for (std::size_t k = 0; k < colours.size(); ++k)
        text += fmt::format("set linetype {} lc rgb '{}'\n", k + 1, colours[k]);
    std::string drawn;
    for (std::size_t s = 0; s < plot.series.size(); ++s) {
        const Series& series = plot.series[s];
        if (series.points.empty()) continue;
        text += fmt::format("$s{} << EOD\n", s);
        for (std::size_t k = 0; k < series.points.size(); ++k)
            text += fmt::format("{} {} {}\n", number(series.points[k].first),
                                number(series.points[k].second),
                                data_text(k < series.labels.size() ? series.labels[k] : ""));
        text += "EOD\n";
        drawn += fmt::format("{}$s{} using 1:2 with {} title {}", drawn.empty() ? "" : ", ", s,
                             series.line ? "linespoints pointtype 7 pointsize 0.6"
                                         : "points pointtype 6 pointsize 0.8",
                             in_quotes(series.title));
        if (!series.labels.empty())
            drawn += fmt::format(", $s{} using 1:2:3 with labels left offset char 0.7,0.4 "
                                 "font ',9' notitle", s);
    }
    return text + (drawn.empty() ? "set xrange [0:1]\nset yrange [0:1]\nplot NaN title 'no data'\n"
                                 : "plot " + drawn + "\n");
}

std::string script_of(const HeatMap& map) {
    std::string text = head(map.name, map.title, map.x_label, map.y_label);
    text += fmt::format("set cblabel {}\nset palette defined (0 '#440154', 1 '#3b528b', 2 "
                        "'#21918c', 3 '#5ec962', 4 '#fde725')\nunset key\n",
                        in_quotes(map.value_label));
    text += ticks('x', map.x_ticks) + ticks('y', map.y_ticks);
    const std::size_t columns = map.x_ticks.size();
    text += fmt::format("set xrange [-0.5:{}.5]\nset yrange [-0.5:{}.5]\n",
                        std::ptrdiff_t(columns) - 1, std::ptrdiff_t(map.y_ticks.size()) - 1);
    text += "$m << EOD\n";
    for (std::size_t k = 0; k < map.values.size(); ++k)
        text += fmt::format("{} {} {}\n", k % columns, k / columns, number(map.values[k]));
    return text + "EOD\nplot $m using 1:2:3 with image pixels\n";
}

bool has_gnuplot() {
    int status = 0;
    output_of("gnuplot --version 2>/dev/null", status);
    return status == 0;
}

std::string draw(const std::string& name, const std::string& script, PlotFormat format) {
    const Script text(
        (format == PlotFormat::svg
             ? "set terminal svg size 960,640 background 'white' font 'sans-serif,13'\n"
             : "set terminal pngcairo size 960,640 background 'white' font 'sans,11'\n") + script);
    int status = 0;
    std::string picture = text.run("2>/dev/null", status);
    std::string complaint;
    if (status != 0 || picture.empty()) complaint = text.run("2>&1 >/dev/null", status);
    if (picture.empty() || status != 0)
        throw std::runtime_error(fmt::format("gnuplot cannot draw the plot '{}': {}; install the "
                                             "package gnuplot-nox of gnuplot 5.2 or later", name,
                                             complaint));
    return picture;
}

}  // namespace umbra78::tools::study
