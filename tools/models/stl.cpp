#include "tools/models/stl.hpp"

#include "tools/models/faces.hpp"
#include "tools/models/scalars.hpp"
#include "tools/models/words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace umbra78::tools {
namespace {

using StlCorners = std::vector<ModelPoint>;  // three for each triangle

constexpr std::size_t header_bytes = 84, triangle_bytes = 50, float_bytes = 4;

bool same_word(std::string_view text, std::string_view lower) {
    return std::equal(text.begin(), text.end(), lower.begin(), lower.end(), [](char a, char b) {
        return a == b || (a >= 'A' && a <= 'Z' && a - 'A' + 'a' == b);
    });
}

// The words of a text file in the order that they must have.
class StlText {
public:
    StlText(std::string_view text, const ModelData& model, FirstError& error)
        : words_(text, model.name, false, error) {}

    StlCorners read() {
        while (!words_.done()) {
            expect("solid", "the file");
            skip_line();
            while (!words_.done() && same_word(words_.peek().text, "facet")) read_facet();
            expect("endsolid", "a solid");
            skip_line();
        }
        return std::move(corners_);
    }

private:
    void expect(std::string_view lower, const std::string& within) {
        if (words_.error().any()) return;
        if (words_.done()) {
            words_.report_end(within);
            return;
        }
        const ModelWord word = words_.take();
        line_ = word.line;
        if (!same_word(word.text, lower))
            words_.report(word.line, fmt::format("{} stands where '{}' belongs; correct the facet "
                                                 "or solid that it is in",
                                                 shown(word.text), lower));
    }

    // A solid's name, which is the rest of its line.
    void skip_line() {
        while (!words_.done() && words_.peek().line == line_) words_.take();
    }

    void read_facet() {
        const std::string within = fmt::format("facet {}", corners_.size() / 3 + 1);
        expect("facet", within);
        expect("normal", within);
        for (int k = 0; k < 3; ++k) {
            if (words_.done()) words_.report_end(within);
            words_.take();
        }
        expect("outer", within);
        expect("loop", within);
        for (int k = 0; k < 3; ++k) {
            expect("vertex", within);
            corners_.push_back(words_.point(within));
        }
        expect("endloop", within);
        expect("endfacet", within);
    }

    ModelWords words_;
    StlCorners corners_;
    int line_ = 0;  // of the word that was expected last
};

StlCorners read_binary(std::string_view text, const ModelData& model, FirstError& error) {
    StlCorners corners;
    for (std::size_t at = header_bytes; at < text.size() && !error.any(); at += triangle_bytes) {
        const int number = static_cast<int>((at - header_bytes) / triangle_bytes) + 1;
        for (std::size_t k = 1; k <= 3; ++k) {
            ModelPoint& point = corners.emplace_back();
            point.line = number;
            for (std::size_t axis = 0; axis < 3; ++axis)
                point.word[axis] = read_coordinate(
                    bits_of(text.substr(at + (3 * k + axis) * float_bytes, float_bytes), false),
                    {ScalarKind::floating, float_bytes}, model, number, error);
        }
    }
    return corners;
}

std::uint64_t binary_size(std::string_view text) {
    return header_bytes + triangle_bytes * bits_of(text.substr(80, 4), false);
}

bool is_text(std::string_view text) {
    const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
    return same_word(text.substr(begin, 5), "solid") &&
           text.substr(0, header_bytes).find('\0') == text.npos;
}

// The number of the first corner with the same words, for each corner.
std::vector<std::uint32_t> first_alike(const StlCorners& corners) {
    std::vector<std::uint32_t> order(corners.size()), first(corners.size());
    for (std::uint32_t k = 0; k < order.size(); ++k) order[k] = k;
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return corners[a].word != corners[b].word ? corners[a].word < corners[b].word : a < b;
    });
    for (std::size_t k = 0; k < order.size(); ++k) {
        const bool again = k > 0 && corners[order[k]] == corners[order[k - 1]];
        first[order[k]] = again ? first[order[k - 1]] : order[k];
    }
    return first;
}

}  // namespace

void read_stl(std::string_view text, ModelData& model, FirstError& error) {
    const bool binary = text.size() >= header_bytes && binary_size(text) == text.size();
    StlCorners corners;
    if (binary) {
        model.counted = "triangle";
        corners = read_binary(text, model, error);
    } else if (text.empty() || is_text(text)) {
        corners = StlText(text, model, error).read();
    } else if (text.size() < header_bytes) {
        error.report(model.name + ": the file is neither text, which begins with 'solid', nor as "
                                  "long as a binary header; name another file");
    } else {
        error.report(fmt::format("{}: the header counts {} triangles, which would be a file of {} "
                                 "bytes; it has {}: write it again, whole",
                                 model.name, bits_of(text.substr(80, 4), false), binary_size(text),
                                 text.size()));
    }
    if (!error.any() && corners.empty())
        error.report(model.name + ": the file holds no triangles; name another file");
    if (error.any()) return;
    const std::vector<std::uint32_t> first = first_alike(corners);
    for (std::size_t k = 0; k < corners.size(); k += 3)
        append_face(std::array<FaceCorner, 3>{{{first[k]}, {first[k + 1]}, {first[k + 2]}}},
                    corners, model);
    keep_used_points(corners, {}, model);
}

}  // namespace umbra78::tools
