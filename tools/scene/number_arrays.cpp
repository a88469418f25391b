#include "tools/scene/number_arrays.hpp"

#include <algorithm>

namespace umbra78::tools {
namespace {

using TokenKind = ArrayToken::Kind;

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

bool is_printable(char c) { return (c >= ' ' && c <= '~') || c == '\t'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

// The length of the plain number that `text` begins with; 0 if it is none.
std::size_t size_of_number(std::string_view text) {
    constexpr std::size_t max_size = 40, max_digits = 18, max_exponent = 2;
    text = text.substr(0, max_size + 1);
    std::size_t at = 0;
    const auto eat = [&](char a, char b) {
        const bool here = at < text.size() && (text[at] == a || text[at] == b);
        at += here ? 1 : 0;
        return here;
    };
    const auto digits = [&] {
        const std::size_t begin = at;
        while (at < text.size() && is_digit(text[at])) ++at;
        return at - begin;
    };
    eat('+', '-');
    const bool zero = at < text.size() && text[at] == '0';
    const std::size_t whole = digits();
    if (whole == 0 || whole > max_digits || (zero && whole > 1)) return 0;
    if (eat('.', '.') && digits() == 0) return 0;
    if (eat('e', 'E')) {
        eat('+', '-');
        const std::size_t exponent = digits();
        if (exponent == 0 || exponent > max_exponent) return 0;
    }
    return at <= max_size ? at : 0;
}

// Goes through the text once, line by line, and knows where texts and comments are.
class Outliner {
public:
    Outliner(std::string_view text, bool empty_arrays) : text_(text), empties_(empty_arrays) {
        if (text_.starts_with(byte_order_mark)) at_ = byte_order_mark.size();
    }

    TomlOutline run() {
        while (at_ < text_.size() && outline_.stray_byte == 0) {
            if (empties_ && quote_ == 0) empty_array();
            read_line();
        }
        if (copied_ > 0) outline_.emptied.append(text_.substr(copied_));
        return std::move(outline_);
    }

private:
    // "key = [" from a line's beginning: the place of the bracket, or the end of the text.
    std::size_t find_array() const {
        std::size_t k = at_;
        const auto skip = [&](auto is_skipped) {
            const std::size_t begin = k;
            while (k < text_.size() && is_skipped(text_[k])) ++k;
            return k > begin;
        };
        const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
        const auto is_bare = [](char c) {
            return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
                   c == '-';
        };
        skip(is_blank);
        if (!skip(is_bare)) return text_.size();
        skip(is_blank);
        if (k == text_.size() || text_[k++] != '=') return text_.size();
        skip(is_blank);
        return k < text_.size() && text_[k] == '[' ? k : text_.size();
    }

    void empty_array() {
        const std::size_t begin = find_array();
        if (begin == text_.size()) return;
        ArrayTokens tokens(text_.substr(begin), line_);
        ArrayToken token = tokens.next();
        while (!tokens.done() && token.kind != TokenKind::other) token = tokens.next();
        if (token.kind == TokenKind::other) return;
        outline_.arrays.push_back({line_, text_.substr(begin, tokens.at())});
        outline_.emptied.append(text_.substr(copied_, begin + 1 - copied_));
        outline_.emptied.append(static_cast<std::size_t>(token.line - line_), '\n');
        at_ = copied_ = begin + tokens.at() - 1;  // its ']' is copied
        line_ = token.line;
    }

    // Elsewhere a quote is an error, up to which toml++ and this reader need not agree.
    bool may_quote() const {
        return at_ == 0 || std::string_view(" \t\n=,[{.\xBF").find(text_[at_ - 1]) != text_.npos;
    }

    bool three(std::size_t at) const {
        return text_.substr(at, 3) == std::string(3, text_[at]);
    }

    // To the next line's first byte.
    void read_line() {
        for (; at_ < text_.size(); ++at_) {
            const char c = text_[at_];
            if (c == '\n') {
                ++line_, ++at_;
                if (!many_) quote_ = 0;
                return;
            }
            if (quote_ == 0) {
                if (static_cast<unsigned char>(c) >= 0x80) {
                    outline_.stray_byte = line_;
                    return;
                }
                if (c == '#' || ((c == '"' || c == '\'') && may_quote())) open_quote(c);
            } else if (c == '\\' && quote_ == '"') {
                if (find_after_backslash()) return;
                if (at_ + 1 < text_.size() && text_[at_ + 1] != '\n') ++at_;
            } else if (c == quote_ && c != '#' && (!many_ || three(at_))) {
                close_quote();
            }
        }
    }

    // What follows a backslash, blanks and ends of lines left out.
    bool find_after_backslash() {
        const std::size_t next = text_.find_first_not_of(" \t\r\n", at_ + 1);
        if (next == text_.npos || static_cast<unsigned char>(text_[next]) < 0x80) return false;
        outline_.stray_byte =
            line_ + static_cast<int>(std::count(text_.begin() + at_, text_.begin() + next, '\n'));
        outline_.after_backslash = true;
        return true;
    }

    void open_quote(char c) {
        quote_ = c;
        many_ = c != '#' && three(at_);
        if (many_) at_ += 2;
    }

    void close_quote() {
        if (many_) at_ += 2;
        for (int more = 0; many_ && more < 2 && at_ + 1 < text_.size() && text_[at_ + 1] == quote_;
             ++more)
            ++at_;  // quotes of the text itself, before the last three
        quote_ = 0;
        many_ = false;
    }

    std::string_view text_;
    bool empties_;
    TomlOutline outline_;
    std::size_t at_ = 0, copied_ = 0;
    int line_ = 1;
    char quote_ = 0;     // of the text that the place is in; '#' in a comment, 0 elsewhere
    bool many_ = false;  // the text goes over lines
};

}  // namespace

// Comments, too, if they are of ASCII: what stops in one is no token.
void ArrayTokens::skip_blanks() {
    for (; at_ < text_.size(); ++at_) {
        if (text_[at_] == '#')
            while (at_ < text_.size() && is_printable(text_[at_])) ++at_;
        if (at_ == text_.size()) return;
        const char c = text_[at_];
        const bool end_of_line =
            c == '\n' || (c == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n');
        if (c != ' ' && c != '\t' && !end_of_line) return;
        line_ += c == '\n' ? 1 : 0;
    }
}

ArrayToken ArrayTokens::take(TokenKind kind, std::size_t size) {
    at_ += size;
    after_value_ = kind != TokenKind::open;
    return {kind, text_.substr(at_ - size, size), line_};
}

ArrayToken ArrayTokens::next() {
    const ArrayToken other{TokenKind::other, {}, line_};
    skip_blanks();
    if (after_value_ && at_ < text_.size() && text_[at_] == ',') {
        ++at_;
        after_value_ = false;
        skip_blanks();
    }
    if (at_ == text_.size()) return other;
    if (text_[at_] == ']') {
        --depth_;
        return take(TokenKind::close, 1);
    }
    if (after_value_) return other;
    if (text_[at_] == '[') return ++depth_ > max_depth ? other : take(TokenKind::open, 1);
    const std::size_t size = size_of_number(text_.substr(at_));
    return size == 0 ? other : take(TokenKind::number, size);
}

TomlOutline outline_of(std::string_view text, bool empty_arrays) {
    return Outliner(text, empty_arrays).run();
}

}  // namespace umbra78::tools
