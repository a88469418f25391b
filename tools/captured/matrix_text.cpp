#include "tools/captured/matrix_text.hpp"

#include "tools/io/file_errors.hpp"
#include "tools/io/number_images.hpp"
#include "tools/scene/scene_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace umbra78::tools::captured {
namespace {

constexpr std::string_view dividers = " \t\r\n,;[](){}";
constexpr std::string_view matrix_remedy =
    "give 16 numbers, row by row, on the line, in a text file or in an NPY";

std::vector<double> numbers_in(std::string_view text, const std::string& name) {
    std::vector<double> numbers;
    int line = 1;
    for (std::size_t at = 0; at < text.size();) {
        if (text[at] == '\n') ++line;
        if (text[at] == '#') {
            at = std::min(text.find('\n', at), text.size());
            continue;
        }
        if (dividers.find(text[at]) != std::string_view::npos) {
            ++at;
            continue;
        }
        const std::size_t end =
            std::min(text.find_first_of(dividers, at), text.size());
        const std::string_view word = text.substr(at, end - at);
        const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
        double value = 0;
        const auto [stop, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error != std::errc() || stop != digits.data() + digits.size())
            throw SceneError(fmt::format("{}:{}: '{}' is no number; {}", name, line, word,
                                         matrix_remedy));
        numbers.push_back(value);
        at = end;
    }
    return numbers;
}

bool is_path(const std::string& given) {
    return given.find_first_of(", ;\t\n") == std::string::npos;
}

}  // namespace

Matrix16 read_matrix(const std::string& given) {
    std::vector<double> numbers;
    std::string name = given;
    if (std::filesystem::exists(given) || is_path(given)) {
        const std::string bytes = read_bytes(given, matrix_remedy);
        numbers = bytes.starts_with("\x93NUMPY") ? read_numbers(given).values
                                                 : numbers_in(bytes, given);
    } else {
        name = "--matrix";
        numbers = numbers_in(given, name);
    }
    if (numbers.size() != 16)
        throw SceneError(fmt::format("{}: {} numbers, and a matrix has 16; {}", name,
                                     numbers.size(), matrix_remedy));
    Matrix16 matrix;
    std::copy(numbers.begin(), numbers.end(), matrix.begin());
    return matrix;
}

}  // namespace umbra78::tools::captured
