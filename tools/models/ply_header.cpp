#include "tools/models/ply_header.hpp"

#include "tools/models/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace umbra78::tools {
namespace {

constexpr std::size_t most_elements = 256;  // far more than a file has; each is looked for by name

using PlyWords = std::vector<std::string_view>;

struct NamedType {
    std::string_view name, sized;
    Scalar type;
};
constexpr NamedType types[] = {
    {"char", "int8", {ScalarKind::whole, 1}},      {"uchar", "uint8", {ScalarKind::natural, 1}},
    {"short", "int16", {ScalarKind::whole, 2}},    {"ushort", "uint16", {ScalarKind::natural, 2}},
    {"int", "int32", {ScalarKind::whole, 4}},      {"uint", "uint32", {ScalarKind::natural, 4}},
    {"float", "float32", {ScalarKind::floating, 4}},
    {"double", "float64", {ScalarKind::floating, 8}},
};

PlyWords words_of(std::string_view line) {
    constexpr std::string_view blanks = " \t\r";
    PlyWords words;
    for (std::size_t at = line.find_first_not_of(blanks); at < line.size();) {
        const std::size_t stop = std::min(line.find_first_of(blanks, at), line.size());
        words.push_back(line.substr(at, stop - at));
        at = line.find_first_not_of(blanks, stop);
    }
    return words;
}

class HeaderReader {
public:
    HeaderReader(std::string_view text, const std::string& name, FirstError& error)
        : rest_(text), name_(name), error_(error) {}

    PlyHeader read() {
        if (take_line() != PlyWords{"ply"})
            report("the file does not begin with the line 'ply'; name another file");
        while (!error_.any() && !ended_) {
            if (rest_.empty()) report("the file ends in its header; add end_header and the data");
            else read_line(take_line());
        }
        if (!error_.any() && !has_format_)
            report("the header has no format; add 'format ascii 1.0' below 'ply'");
        header_.data = rest_;
        header_.data_line = line_ + 1;
        return std::move(header_);
    }

private:
    void report(const std::string& what) { report_at(error_, name_, line_, what); }

    PlyWords take_line() {
        ++line_;
        const std::size_t end = std::min(rest_.find('\n'), rest_.size());
        const std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        return words_of(line);
    }

    void read_line(const PlyWords& words) {
        if (words.empty() || words[0] == "comment" || words[0] == "obj_info") return;
        if (words[0] == "end_header") ended_ = true;
        else if (words[0] == "format") read_format(words);
        else if (words[0] == "element") read_element(words);
        else if (words[0] == "property") read_property(words);
        else report(shown(words[0]) + " begins no line of a PLY header; remove the line, or begin "
                                      "it with comment");
    }

    void read_format(const PlyWords& words) {
        constexpr std::string_view names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
        const auto known = std::find(std::begin(names), std::end(names),
                                     words.size() > 1 ? words[1] : std::string_view{});
        if (words.size() != 3 || words[2] != "1.0" || known == std::end(names))
            report("the format is unknown; write 'format ascii 1.0', binary_little_endian or "
                   "binary_big_endian");
        header_.format = static_cast<PlyFormat>(known - std::begin(names));
        has_format_ = true;
    }

    void read_element(const PlyWords& words) {
        PlyElement element;
        element.line = line_;
        bool good = words.size() == 3;
        if (good) {
            const char *begin = words[2].data(), *end = begin + words[2].size();
            const auto [stop, status] = std::from_chars(begin, end, element.count);
            good = stop == end && status == std::errc{};
            element.name = words[1];
        }
        if (!good) report("an element needs a name and a count; write 'element vertex 8'");
        else if (header_.elements.size() == most_elements)
            report(fmt::format("there are more than {} elements; remove those that are not vertex "
                               "and face", most_elements));
        else if (header_.find(element.name))
            report(fmt::format("there is an element {} already; remove one", shown(element.name)));
        header_.elements.push_back(element);
    }

    void read_property(const PlyWords& words) {
        const bool is_list = words.size() > 1 && words[1] == "list";
        if (header_.elements.empty())
            report("a property stands before the first element; move it below its element");
        else if (words.size() != (is_list ? 5u : 3u))
            report("a property needs a type and a name; write 'property float x' or 'property list "
                   "uchar int vertex_indices'");
        if (error_.any()) return;
        PlyProperty property{.name = words.back(), .type = type_of(words[words.size() - 2]),
                             .is_list = is_list};
        if (is_list) property.count_type = type_of(words[2]);
        if (is_list && property.count_type.kind == ScalarKind::floating)
            report(shown(words[2]) + " counts no list; write uchar or another whole type");
        header_.elements.back().properties.push_back(property);
    }

    Scalar type_of(std::string_view word) {
        for (const NamedType& type : types)
            if (word == type.name || word == type.sized) return type.type;
        report(shown(word) + " is no type; write char, uchar, short, ushort, int, uint, float or "
                             "double");
        return {};
    }

    std::string_view rest_;
    const std::string& name_;
    FirstError& error_;
    PlyHeader header_;
    int line_ = 0;
    bool has_format_ = false, ended_ = false;
};

}  // namespace

const PlyElement* PlyHeader::find(std::string_view name) const {
    const auto found = std::find_if(elements.begin(), elements.end(),
                                    [&](const PlyElement& e) { return e.name == name; });
    return found == elements.end() ? nullptr : &*found;
}

PlyHeader read_ply_header(std::string_view text, const std::string& name, FirstError& error) {
    return HeaderReader(text, name, error).read();
}

}  // namespace umbra78::tools
