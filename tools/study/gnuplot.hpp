// Plots by gnuplot: a script with its data inside, and what gnuplot draws from it.
#pragma once

#include "tools/study/study.hpp"

#include <string>

namespace umbra78::tools::study {

// Without a terminal: `gnuplot -e "set terminal svg" NAME.gnuplot` draws it again.
std::string script_of(const Plot&);
std::string script_of(const HeatMap&);

bool has_gnuplot();

enum class PlotFormat { svg, png };
// The picture's bytes. Throws std::runtime_error with the plot's name.
std::string draw(const std::string& name, const std::string& script, PlotFormat);

}  // namespace umbra78::tools::study
