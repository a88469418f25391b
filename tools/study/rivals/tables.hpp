// How the study of rivals picks its rows, for its report.
#pragma once

#include "tools/study/rivals/rivals.hpp"

#include <string>
#include <utility>
#include <vector>

namespace umbra78::tools::study {

using Rows = std::vector<const Row*>;
using Points = std::vector<std::pair<double, double>>;

// In the order of their first rows, of the questions about the study's scene.
std::vector<std::string> methods_in(std::span<const Row>);
Rows rows_of(std::span<const Row>, std::string_view question, std::string_view method = {});
// A method's row with the most facets: where methods are compared.
const Row* finest(std::span<const Row>, std::string_view method);
Points points_of(const Rows&, std::string_view x, std::string_view y, double scale = 1);

double at_of(const Row&);           // the column "at"
double pixels_of(const Row&);       // of the picture
double wrong_share_of(const Row&);  // of the pixels that both see

// The parts of the page; pictures draw again what they show.
void sheet_of_methods(const Request&, std::span<const Row>, Report&);
// What stencils count wrongly with few bits of Z.
void report_codes(const Request&, std::span<const Row>, Report&);
// Shadow volumes, split facets, the order from the light.
void report_insides(const Request&, std::span<const Row>, Report&);
void report_growth(std::span<const Row>, Report&);
void report_textbook(const Request&, std::span<const Row>, Report&);
void report_scan_out(std::span<const Row>, Report&);

}  // namespace umbra78::tools::study
