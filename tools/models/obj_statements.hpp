// The statements of an OBJ file: a line each, or several that end with a backslash.
#pragma once

#include "tools/models/words.hpp"

#include <string_view>
#include <vector>

namespace umbra78::tools {

class ObjStatements {
public:
    explicit ObjStatements(std::string_view text);

    // The words of the next statement that has any, the keyword first; none at the end of the file.
    // Comments go from # to the end of the line. What is returned lives until the next call.
    const std::vector<ModelWord>& next();

    int line() const { return line_; }  // of what is read next; at the end the last one

private:
    void take_line();

    std::string_view rest_;
    std::vector<ModelWord> words_;
    int line_ = 1;
    bool goes_on_ = false;
};

}  // namespace umbra78::tools
