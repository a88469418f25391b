#include "tools/study/report.hpp"

#include <fmt/format.h>

#include <cmath>

namespace umbra78::tools::study {

std::string rounded(double value, int digits) {
    if (std::isnan(value)) return "";
    if (std::abs(value) >= std::pow(10, digits) - 0.5 && std::isfinite(value))
        return fmt::format("{:.0f}", value);
    return fmt::format("{:.{}g}", value, digits);
}

std::string percent(double rate) {
    const double percents = 100 * rate;
    if (std::isnan(rate)) return "";
    if (percents == 0) return "0 %";
    return std::abs(percents) >= 1 ? fmt::format("{:.1f} %", percents)
                                   : fmt::format("{:.2g} %", percents);
}

}  // namespace umbra78::tools::study
