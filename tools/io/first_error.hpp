// Where readers report what is wrong with a scene, a model or a setting. They throw nothing: a
// reader reports its error here and goes on with a harmless value, and whoever called it asks at
// the end whether there was one. Only the first error is kept, so the user sees the one that comes
// first.
#pragma once

#include <string>

namespace umbra78::tools {

class FirstError {
public:
    // `line` names the place, what is wrong and the remedy.
    void report(std::string line) {
        if (line_.empty()) line_ = std::move(line);
    }
    bool any() const { return !line_.empty(); }
    const std::string& line() const { return line_; }

private:
    std::string line_;
};

}  // namespace umbra78::tools
