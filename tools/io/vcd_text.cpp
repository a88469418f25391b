#include "tools/io/vcd_text.hpp"

#include <fmt/format.h>

namespace umbra78::tools {
namespace {

// Identifiers are numbers in the 94 printable characters from '!' on.
std::string identifier(std::size_t number) {
    constexpr std::size_t base = 94;
    std::string id;
    for (++number; number > 0; number = (number - 1) / base)
        id.push_back(static_cast<char>('!' + (number - 1) % base));
    return id;
}

std::vector<std::string> split(std::string_view scope) {
    std::vector<std::string> parts;
    for (std::size_t from = 0; from <= scope.size();) {
        const std::size_t dot = std::min(scope.find('.', from), scope.size());
        parts.emplace_back(scope.substr(from, dot - from));
        from = dot + 1;
    }
    return parts;
}

// Leading zeros are left out, as the format's own extension rule puts them back.
std::string binary(std::uint64_t value) { return fmt::format("{:b}", value); }

}  // namespace

VcdText::VcdText(std::string_view comment)
    : text_(fmt::format("$comment {} $end\n$timescale 1ns $end\n", comment)) {}

// Leaves the scopes that are not the new one's, and enters those that are missing.
void VcdText::enter(std::string_view scope) {
    const std::vector<std::string> wanted = scope.empty() ? std::vector<std::string>{}
                                                          : split(scope);
    std::size_t same = 0;
    while (same < scope_.size() && same < wanted.size() && scope_[same] == wanted[same]) ++same;
    for (std::size_t k = scope_.size(); k > same; --k) text_ += "$upscope $end\n";
    for (std::size_t k = same; k < wanted.size(); ++k)
        text_ += fmt::format("$scope module {} $end\n", wanted[k]);
    scope_ = wanted;
}

VcdText::Signal VcdText::add(std::string_view scope, std::string_view name, int bits) {
    enter(scope);
    const std::string id = identifier(signals_.size());
    const std::string range = bits == 1 ? "" : fmt::format(" [{}:0]", bits - 1);
    text_ += fmt::format("$var wire {} {} {}{} $end\n", bits, id, name, range);
    signals_.push_back({id, bits, {}});
    return signals_.size() - 1;
}

void VcdText::end_declarations() {
    enter("");
    text_ += "$enddefinitions $end\n$dumpvars\n";
    for (const State& s : signals_)
        text_ += s.bits == 1 ? fmt::format("x{}\n", s.id) : fmt::format("bx {}\n", s.id);
    text_ += "$end\n";
    declared_ = true;
}

void VcdText::time(std::uint64_t ns) {
    if (!declared_) end_declarations();
    time_ = ns;
}

void VcdText::set(Signal signal, std::int64_t value) {
    State& s = signals_[signal];
    const std::uint64_t mask = s.bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << s.bits) - 1;
    const std::uint64_t word = static_cast<std::uint64_t>(value) & mask;
    if (s.value == word) return;
    s.value = word;
    if (time_) text_ += fmt::format("#{}\n", *time_);
    time_.reset();
    text_ += s.bits == 1 ? fmt::format("{}{}\n", word, s.id)
                         : fmt::format("b{} {}\n", binary(word), s.id);
}

}  // namespace umbra78::tools
