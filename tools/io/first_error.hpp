// Where readers report what is wrong with a scene, a model or a setting. They throw nothing: a
// reader reports its error here and goes on with a harmless value, and whoever called it asks at
// the end whether there was one. Only the first error is kept, so the user sees the one that comes
// first.
#pragma once

#include <string>
#include <utility>

namespace umbra78::tools {

// With a blank for each control character: a text of a file or of an argument may have lines.
inline std::string in_one_line(std::string text) {
    for (char& letter : text)
        if (static_cast<unsigned char>(letter) < ' ') letter = ' ';
    return text;
}

class FirstError {
public:
    // `text` names the place, what is wrong and the remedy.
    void report(std::string text) {
        if (line_.empty()) line_ = in_one_line(std::move(text));
    }
    bool any() const { return !line_.empty(); }
    const std::string& line() const { return line_; }

private:
    std::string line_;
};

}  // namespace umbra78::tools
