// Arrays of plain numbers in a TOML text, such as the 16 points of a patch, read without a tree.
//
// A scene may hold millions of numbers, and one that passes through toml++ takes 240 bytes and six
// microseconds. So toml++ is given an outline: the text with the arrays of numbers emptied but for
// their ends of lines, in which everything else, every line number too, is as it was. An array that
// stands in the text as below and has nothing but plain numbers is emptied; all others are left to
// toml++. Whether the rest is TOML does not depend on what such arrays hold.
//
//   key = [ ... ]    at the beginning of a line, a bare key; up to max_depth arrays in each other
//                    with blanks, ends of lines and comments of ASCII between what they hold
//   number           sign, up to 18 digits, decimals, and an exponent of up to two digits; all of
//                    it at most 40 characters: what toml++, too, takes as a number
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace umbra78::tools {

struct ArrayToken {
    enum class Kind { open, close, number, other };  // `other` ends what can be read

    Kind kind;
    std::string_view text;
    int line;
};

// The tokens of an array of plain numbers, commas left out, from its '[' on.
class ArrayTokens {
public:
    static constexpr int max_depth = 4;

    explicit ArrayTokens(std::string_view text, int line = 1) : text_(text), line_(line) {}

    ArrayToken next();
    bool done() const { return depth_ == 0; }  // after the array's last token
    std::size_t at() const { return at_; }     // behind the last token

private:
    void skip_blanks();
    ArrayToken take(ArrayToken::Kind kind, std::size_t size);

    std::string_view text_;
    int line_;
    std::size_t at_ = 0;
    int depth_ = 0;
    bool after_value_ = false;
};

struct NumberArray {
    int line = 0;            // of its '['; no two begin on a line
    std::string_view text{}; // in the document, with both brackets
};

struct TomlOutline {
    std::string emptied{};              // the outline, if an array was emptied
    std::vector<NumberArray> arrays{};  // in the order of the text
    // The line of the first byte that is not ASCII and stands neither in a text nor in a comment,
    // or in a text after a backslash and blanks; 0 if there is none. TOML has the first nowhere,
    // and toml++'s behaviour is undefined for some of both.
    int stray_byte = 0;
    bool after_backslash = false;
};

// Arrays are emptied only if `empty_arrays`.
TomlOutline outline_of(std::string_view text, bool empty_arrays);

}  // namespace umbra78::tools
