// The worst error of a stage: what is kept of all inputs that a search tries.
#pragma once

#include "tests/proofs/proofs.hpp"

#include <string>

namespace umbra78::proofs {

// |error| in the stage's unit, and the inputs that give it; told as "error STAGE WORST INPUTS".
class Worst {
public:
    explicit Worst(std::string stage) : stage_(std::move(stage)) {}
    Worst(const Worst&) = delete;
    Worst& operator=(const Worst&) = delete;
    ~Worst() {
        std::printf("error %s %.9g %s\n", stage_.c_str(), worst_, inputs_.c_str());
    }
    bool add(double error, const Given& inputs) {
        const double size = error < 0 ? -error : error;
        if (size <= worst_) return false;
        worst_ = size;
        inputs_.clear();
        for (const Wide v : inputs) inputs_ += (inputs_.empty() ? "" : ",") + decimal(v);
        return true;
    }
    double worst() const { return worst_; }

private:
    std::string stage_, inputs_;
    double worst_ = -1;
};

inline double ratio(Wide numerator, Wide denominator) {
    return static_cast<double>(static_cast<long double>(numerator) /
                               static_cast<long double>(denominator));
}

void transform_errors();  // errors_transform.cpp
bool surface_errors();    // errors_surface.cpp
void filter_errors();     // errors_filter.cpp
void line_errors();       // errors_lines.cpp

}  // namespace umbra78::proofs
