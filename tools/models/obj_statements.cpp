#include "tools/models/obj_statements.hpp"

namespace umbra78::tools {

ObjStatements::ObjStatements(std::string_view text) : rest_(text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
}

const std::vector<ModelWord>& ObjStatements::next() {
    words_.clear();
    goes_on_ = false;
    while (!rest_.empty() && (words_.empty() || goes_on_)) take_line();
    return words_;
}

void ObjStatements::take_line() {
    const std::size_t end = rest_.find('\n');
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end == rest_.npos ? rest_.size() : end + 1);
    line = line.substr(0, line.find('#'));
    constexpr std::string_view blanks = " \t\r\v\f";
    while (!line.empty() && blanks.find(line.back()) != blanks.npos) line.remove_suffix(1);
    goes_on_ = line.ends_with('\\');
    if (goes_on_) line.remove_suffix(1);
    for (std::size_t at = line.find_first_not_of(blanks); at < line.size();) {
        const std::size_t stop = std::min(line.find_first_of(blanks, at), line.size());
        words_.push_back({line.substr(at, stop - at), line_});
        at = line.find_first_not_of(blanks, stop);
    }
    line_ += rest_.empty() ? 0 : 1;
}

}  // namespace umbra78::tools
