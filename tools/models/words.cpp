#include "tools/models/words.hpp"

#include "fixed/decimal.hpp"

#include <fmt/format.h>

#include <charconv>

namespace umbra78::tools {
namespace {

using fixed::DecimalResult;
using fixed::DecimalStatus;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Puts the zeros that TOML's decimals need beside a point: ".5" becomes "0.5", "5." becomes "5.0".
std::string with_zeros(std::string_view word) {
    std::string full;
    for (std::size_t k = 0; k < word.size(); ++k) {
        const bool before = k > 0 && is_digit(word[k - 1]);
        const bool after = k + 1 < word.size() && is_digit(word[k + 1]);
        const bool lone = word[k] == '.' && (before || after);
        if (lone && !before) full += '0';
        full += word[k];
        if (lone && !after) full += '0';
    }
    return full;
}

DecimalResult parse_coordinate(std::string_view word) {
    if (word.find('_') != word.npos) return {0, DecimalStatus::bad_character};
    const DecimalResult plain = fixed::parse_decimal(word, model_fraction, 64);
    if (plain.status != DecimalStatus::bad_character) return plain;
    return fixed::parse_decimal(with_zeros(word), model_fraction, 64);
}

}  // namespace

void report_at(FirstError& error, const std::string& name, int line, const std::string& what) {
    error.report(fmt::format("{}:{}: {}", name, line, what));
}

std::string shown(std::string_view word) {
    constexpr std::size_t longest = 32;
    std::string text = "'";
    for (const char c : word.substr(0, longest)) text += c >= ' ' && c <= '~' ? c : '?';
    return text + (word.size() > longest ? "...'" : "'");
}

std::int64_t read_coordinate(const ModelWord& word, const std::string& name, FirstError& error) {
    const auto [value, status] = parse_coordinate(word.text);
    if (status == DecimalStatus::bad_character || status == DecimalStatus::empty) {
        report_at(error, name, word.line,
                  shown(word.text) + " is no coordinate; write a decimal, such as -2.5");
        return 0;
    }
    if (status == DecimalStatus::out_of_range || value > max_model || value < -max_model) {
        report_at(error, name, word.line,
                  fmt::format("the coordinate {0} is beyond -{1} .. {1}; scale the file's points",
                              shown(word.text), max_model >> model_fraction));
        return 0;
    }
    return value;
}

int read_whole(const ModelWord& word, const std::string& called, int min, int max,
               const std::string& name, FirstError& error) {
    int value = 0;
    const char *begin = word.text.data(), *end = begin + word.text.size();
    const auto [stop, status] = std::from_chars(begin, end, value);
    if (stop != end || status == std::errc::invalid_argument) {
        report_at(error, name, word.line,
                  fmt::format("{} is {}; write a whole number", called, shown(word.text)));
        return min;
    }
    if (status != std::errc{} || value < min || value > max) {
        report_at(error, name, word.line, fmt::format("{} is {}; its range is {} .. {}", called,
                                                      shown(word.text), min, max));
        return min;
    }
    return value;
}

ModelWords::ModelWords(std::string_view text, const std::string& name, bool commas,
                       FirstError& error, int line)
    : rest_(text), name_(name), commas_(commas), error_(error), line_(line) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
    advance();
    if (done()) report(line, "the file holds no numbers; give it a model, or name another file");
}

void ModelWords::advance() {
    const auto is_blank = [&](char c) {
        return c == ' ' || c == '\t' || c == '\r' || c == '\n' || (commas_ && c == ',');
    };
    while (!rest_.empty() && (is_blank(rest_.front()) || rest_.front() == '#')) {
        if (rest_.front() == '#') {
            rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
            continue;
        }
        line_ += rest_.front() == '\n' ? 1 : 0;
        rest_.remove_prefix(1);
    }
    std::size_t size = 0;
    while (size < rest_.size() && !is_blank(rest_[size]) && rest_[size] != '#') ++size;
    next_ = {rest_.substr(0, size), line_};
    rest_.remove_prefix(size);
}

ModelWord ModelWords::take() {
    const ModelWord word = next_;
    advance();
    return word;
}

void ModelWords::report_end(const std::string& within) {
    report(line_, fmt::format("the file ends in {}; add the rest, or correct the counts", within));
}

int ModelWords::count(const std::string& called, int min, int max) {
    if (done()) {
        report_end(called);
        return min;
    }
    return read_whole(take(), called, min, max, name_, error_);
}

std::int64_t ModelWords::coordinate(const std::string& within) {
    if (done()) {
        report_end(within);
        return 0;
    }
    return read_coordinate(take(), name_, error_);
}

ModelPoint ModelWords::point(const std::string& within) {
    ModelPoint point{.line = next_.line};
    for (std::int64_t& word : point.word) word = coordinate(within);
    return point;
}

}  // namespace umbra78::tools
