#include "tools/models/obj.hpp"

#include "tools/models/obj_statements.hpp"
#include "tools/models/polygon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace umbra78::tools {
namespace {

using raster::Facet;
using Words = std::vector<ModelWord>;

// Numbers from 0 as they are known once the statement is read; a number of the file may name what
// follows, so whether it exists is asked at the end.
struct Corner {
    static constexpr std::int64_t none = -1;
    std::int64_t vertex = 0, normal = none;
    int line = 0;
};

// Statements that change nothing that is seen here.
constexpr std::string_view skipped[] = {
    "vt", "vp", "g", "s", "o", "mg", "usemtl", "mtllib", "usemap", "maplib", "bevel",
    "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj", "ctech", "stech"};
constexpr std::string_view curved[] = {"cstype", "deg",  "bmat", "step", "curv",
                                       "curv2",  "surf", "parm", "trim", "hole",
                                       "scrv",   "sp",   "end",  "con"};

template <std::size_t Size>
bool is_in(const std::string_view (&list)[Size], std::string_view word) {
    return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

class ObjReader {
public:
    ObjReader(Model& model, FirstError& error) : model_(model), error_(error) {}

    void read(std::string_view text) {
        ObjStatements statements(text);
        while (!error_.any()) {
            const Words& words = statements.next();
            if (words.empty()) break;
            read_statement(words);
        }
        if (!error_.any() && face_ends_.empty())
            report(statements.line(), "the file holds no faces; a surface needs f statements");
        make_facets();
    }

private:
    void report(int line, const std::string& what) { report_at(error_, model_.name, line, what); }

    void read_statement(const Words& words) {
        const ModelWord& keyword = words.front();
        const std::string_view key = keyword.text;
        if (key == "v") points_.push_back(read_point(words));
        else if (key == "vn") normals_.push_back(read_point(words));
        else if (key == "f" || key == "fo") read_face(words);
        else if (key == "l" || key == "p") ++model_.lines_and_points;
        else if (is_in(curved, key))
            report(keyword.line, shown(key) + " makes a curve or a curved surface; give patches "
                                              "as .bpt, .bez or .tea");
        else if (!is_in(skipped, key))
            report(keyword.line, shown(key) + " begins no statement of OBJ; remove the line, or "
                                              "begin it with #");
    }

    // Three coordinates; a weight or a colour may follow and is not looked at.
    ModelPoint read_point(const Words& words) {
        ModelPoint point{.line = words.front().line};
        if (words.size() < 4)
            report(point.line, fmt::format("{} has {} coordinates; give three",
                                           shown(words.front().text), words.size() - 1));
        for (std::size_t k = 0; k < 3 && !error_.any(); ++k)
            point.word[k] = read_coordinate(words[k + 1], model_.name, error_);
        return point;
    }

    void read_face(const Words& words) {
        const std::size_t corners = words.size() - 1;
        if (corners < 3 || corners > most_corners)
            report(words.front().line, fmt::format("a face has {} corners; give 3 .. {}", corners,
                                                   most_corners));
        for (std::size_t k = 1; k < words.size() && !error_.any(); ++k)
            corners_.push_back(read_corner(words[k]));
        face_ends_.push_back(corners_.size());
    }

    // v, v/t, v//n or v/t/n.
    Corner read_corner(const ModelWord& word) {
        std::array<std::string_view, 3> parts{};
        std::size_t part = 0, begin = 0;
        for (std::size_t at = 0; at <= word.text.size(); ++at) {
            if (at < word.text.size() && word.text[at] != '/') continue;
            if (part < 3) parts[part] = word.text.substr(begin, at - begin);
            ++part, begin = at + 1;
        }
        if (part > 3) report_corner(word);
        Corner corner{.line = word.line};
        corner.vertex = number(parts[0], points_.size(), word);
        if (!parts[1].empty()) number(parts[1], INT64_MAX, word);  // not looked at
        if (!parts[2].empty()) corner.normal = number(parts[2], normals_.size(), word);
        return corner;
    }

    // Numbers count from 1, or from the last of `known` down from -1.
    std::int64_t number(std::string_view text, std::size_t known, const ModelWord& word) {
        std::int64_t value = 0;
        const auto [stop, status] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (stop != text.data() + text.size() || status != std::errc{} || value == 0)
            report_corner(word);
        if (value > 0) return value - 1;
        value += static_cast<std::int64_t>(known);
        if (value < 0)
            report(word.line, fmt::format("{} goes back beyond the first; only {} stand before it",
                                          shown(word.text), known));
        return value;
    }

    void report_corner(const ModelWord& word) {
        report(word.line, shown(word.text) + " is no corner of a face; write v, v/t, v//n or "
                                             "v/t/n, numbers from 1, or from -1 back");
    }

    // Whether there are so many of what the corner names; else a report.
    bool exists(std::int64_t number, const std::vector<ModelPoint>& of, const char* what,
                int line) {
        const bool there = number < static_cast<std::int64_t>(of.size());
        if (!there)
            report(line, fmt::format("a face names {} {}; there are {}: correct the number", what,
                                     number + 1, of.size()));
        return there;
    }

    void make_facets() {
        std::size_t begin = 0;
        for (const std::size_t end : face_ends_) {
            if (error_.any()) return;
            cut_face({corners_.data() + begin, end - begin});
            begin = end;
        }
        keep_used(points_, &Facet::vertex, model_.vertices);
        keep_used(normals_, &Facet::normal, model_.normals);
    }

    void cut_face(std::span<const Corner> face) {
        std::vector<ModelPoint> corners;
        bool smooth = true;
        for (const Corner& c : face) {
            if (!exists(c.vertex, points_, "vertex", c.line)) return;
            smooth = smooth && c.normal != Corner::none;
            if (c.normal != Corner::none && !exists(c.normal, normals_, "normal", c.line))
                return;
            corners.push_back(points_[static_cast<std::size_t>(c.vertex)]);
        }
        for (const auto& [a, b, c] : triangulate(corners)) {
            if (without_area(corners[a], corners[b], corners[c])) {
                ++model_.no_area;
                continue;
            }
            Facet facet;
            for (std::size_t k = 0; k < 3; ++k) {
                const Corner& corner = face[std::array{a, b, c}[k]];
                facet.vertex[k] = static_cast<std::uint32_t>(corner.vertex);
                if (smooth) facet.normal[k] = static_cast<std::uint32_t>(corner.normal);
            }
            model_.facets.push_back(facet);
        }
    }

    // Appends those points of the file that facets name, in the file's order, and renumbers.
    void keep_used(const std::vector<ModelPoint>& all, std::array<std::uint32_t, 3> Facet::*names,
                   std::vector<ModelPoint>& kept) {
        std::vector<std::uint32_t> place(all.size(), Facet::flat);
        for (const Facet& facet : model_.facets)
            for (const std::uint32_t n : facet.*names)
                if (n != Facet::flat) place[n] = 0;
        for (std::size_t k = 0; k < all.size(); ++k) {
            if (place[k] == Facet::flat) continue;
            place[k] = static_cast<std::uint32_t>(kept.size());
            kept.push_back(all[k]);
        }
        for (Facet& facet : model_.facets)
            for (std::uint32_t& n : facet.*names)
                if (n != Facet::flat) n = place[n];
    }

    Model& model_;
    FirstError& error_;
    std::vector<ModelPoint> points_, normals_;
    std::vector<Corner> corners_;           // of all faces
    std::vector<std::size_t> face_ends_;    // where each face's corners end
};

}  // namespace

void read_obj(std::string_view text, Model& model, FirstError& error) {
    ObjReader(model, error).read(text);
}

}  // namespace umbra78::tools
