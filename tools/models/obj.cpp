#include "tools/models/obj.hpp"

#include "tools/models/faces.hpp"
#include "tools/models/obj_corner.hpp"
#include "tools/models/obj_statements.hpp"
#include "tools/models/obj_surfaces.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace umbra78::tools {
namespace {

using Words = std::vector<ModelWord>;

// Statements that change nothing that is seen here.
constexpr std::string_view skipped[] = {
    "vt", "vp", "g", "s", "o", "mg", "usemtl", "mtllib", "usemap", "maplib", "bevel",
    "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj", "ctech", "stech"};
bool is_skipped(std::string_view word) {
    return std::find(std::begin(skipped), std::end(skipped), word) != std::end(skipped);
}

class ObjReader {
public:
    ObjReader(ModelData& model, FirstError& error) : model_(model), error_(error) {}

    void read(std::string_view text) {
        ObjStatements statements(text);
        while (!error_.any()) {
            const Words& words = statements.next();
            if (words.empty()) break;
            read_statement(words);
        }
        if (!error_.any() && face_ends_.empty() && !surfaces_.any())
            report(statements.line(), "the file holds no faces; a surface needs f statements");
        surfaces_.append_patches(points_, model_.patches);
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
        else if (ObjSurfaces::takes(key)) surfaces_.read(words, points_.size(), normals_.size());
        else if (!is_skipped(key))
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
            corners_.push_back(read_corner(words[k], points_.size(), normals_.size(),
                                           model_.name, error_));
        face_ends_.push_back(corners_.size());
    }

    void make_facets() {
        std::size_t begin = 0;
        for (const std::size_t end : face_ends_) {
            if (error_.any()) return;
            cut_face({corners_.data() + begin, end - begin});
            begin = end;
        }
        keep_used_points(points_, normals_, model_);
    }

    void cut_face(std::span<const ObjCorner> corners) {
        std::vector<FaceCorner> face;
        for (const ObjCorner& c : corners) {
            point_at(points_, c.vertex, "vertex", c.line, model_.name, error_);
            if (c.normal != ObjCorner::none)
                point_at(normals_, c.normal, "normal", c.line, model_.name, error_);
            if (error_.any()) return;
            face.push_back({.vertex = static_cast<std::uint32_t>(c.vertex)});
            if (c.normal != ObjCorner::none)
                face.back().normal = static_cast<std::uint32_t>(c.normal);
        }
        append_face(face, points_, model_);
    }

    ModelData& model_;
    FirstError& error_;
    std::vector<ModelPoint> points_, normals_;
    std::vector<ObjCorner> corners_;        // of all faces
    std::vector<std::size_t> face_ends_;    // where each face's corners end
    ObjSurfaces surfaces_{model_.name, error_};
};

}  // namespace

void read_obj(std::string_view text, ModelData& model, FirstError& error) {
    ObjReader(model, error).read(text);
}

}  // namespace umbra78::tools
