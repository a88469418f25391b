#include "tools/study/study.hpp"

#include <cmath>

namespace umbra78::tools::study {
namespace {

class ErrorTime final : public Study {
public:
    std::string_view name() const override { return "error-time"; }
    std::string_view meaning() const override { return "Error against run time"; }
    std::vector<Case> cases(const Request& request) const override {
        return grid(request, {{"lookup", {"nearest", "bilinear"}}, {"bias", {"64", "192"}}});
    }
    Row run(const Request&, const Case&) const override { return {}; }
    void report(const Request&, std::span<const Row>, Report& report) const override {
        report.paragraph("test");
        report.plot({"x", "t", "x (px)", "y (%)", false, false,
                     {{"a", {{1, 2}, {2, 3}}, true, {"l", "m"}}}}, "cap");
        report.heat_map({"h", "t", "x (px)", "y (%)", "z",
                         {"a", "b"}, {"c", "d"}, {1, 2, 3, std::nan("")}}, "cap");
    }
};

}  // namespace

std::unique_ptr<Study> make_error_time_study() { return std::make_unique<ErrorTime>(); }

}  // namespace umbra78::tools::study
