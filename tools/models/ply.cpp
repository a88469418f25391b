#include "tools/models/ply.hpp"

#include "tools/models/faces.hpp"
#include "tools/models/ply_values.hpp"
#include "tools/models/words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace umbra78::tools {
namespace {

constexpr std::string_view places[] = {"x", "y", "z"}, directions[] = {"nx", "ny", "nz"};
constexpr std::string_view lists[] = {"vertex_indices", "vertex_index"};

class PlyReader {
public:
    PlyReader(std::string_view text, ModelData& model, FirstError& error)
        : model_(model), error_(error), header_(read_ply_header(text, model.name, error)) {}

    void read() {
        check_header();
        if (error_.any()) return;
        values_ = ply_values(header_, model_, error_);
        for (const PlyElement& element : header_.elements) read_elements(element);
        if (!error_.any()) values_->end();
        model_.counted = header_.format == PlyFormat::ascii ? "" : "vertex";
        make_facets();
    }

private:
    void report(int line, const std::string& what) { report_at(error_, model_.name, line, what); }

    // How many properties of an element have the name and are lists, or are not.
    static long count(const PlyElement& element, std::string_view name, bool is_list) {
        return std::count_if(element.properties.begin(), element.properties.end(),
                             [&](const PlyProperty& p) {
                                 return p.name == name && p.is_list == is_list;
                             });
    }

    void check_header() {
        if (error_.any()) return;
        const PlyElement *vertex = header_.find("vertex"), *face = header_.find("face");
        const int last = header_.data_line - 1;
        if (!vertex) {
            report(last, "the header has no element vertex; name another file");
            return;
        }
        for (const std::string_view name : places)
            if (count(*vertex, name, false) != 1)
                report(vertex->line, fmt::format("the element vertex has {} properties {}; give it "
                                                 "one that is no list",
                                                 count(*vertex, name, false), name));
        has_normals_ = std::all_of(std::begin(directions), std::end(directions), [&](auto name) {
            return count(*vertex, name, false) == 1;
        });
        const long found = face ? count(*face, lists[0], true) + count(*face, lists[1], true) : 0;
        if (!face || face->count == 0 || found == 0)
            report(last, "the file holds no faces; a surface needs an element face with a list "
                         "vertex_indices");
        else if (found > 1)
            report(face->line, "the element face has two lists of vertices; remove one");
        vertices_ = vertex->count;
    }

    void read_elements(const PlyElement& element) {
        const bool vertex = element.name == "vertex", face = element.name == "face";
        if (element.properties.empty()) return;  // there are no data, however many there are
        for (std::uint64_t k = 0; k < element.count && !error_.any(); ++k) {
            values_->begin(element, k);
            if (error_.any()) return;
            if (vertex) read_vertex(element);
            else for (const PlyProperty& property : element.properties) {
                if (face && property.is_list && names_vertices(property)) read_face(property);
                else skip(property);
            }
        }
    }

    static bool names_vertices(const PlyProperty& property) {
        return property.name == lists[0] || property.name == lists[1];
    }

    void read_vertex(const PlyElement& element) {
        ModelPoint place{.line = values_->line()}, normal = place;
        const auto take = [&](const PlyProperty& property, const auto& names, ModelPoint& point) {
            const auto axis = std::find(std::begin(names), std::end(names), property.name);
            if (property.is_list || axis == std::end(names)) return false;
            point.word[static_cast<std::size_t>(axis - std::begin(names))] =
                values_->coordinate(property.type);
            return true;
        };
        for (const PlyProperty& property : element.properties) {
            if (error_.any()) return;
            if (take(property, places, place)) continue;
            if (has_normals_ && take(property, directions, normal)) continue;
            skip(property);
        }
        points_.push_back(place);
        if (has_normals_) normals_.push_back(normal);
    }

    void skip(const PlyProperty& property) {
        if (error_.any()) return;
        values_->skip(property.type, property.is_list ? size_of_list(property) : 1);
    }

    std::uint64_t size_of_list(const PlyProperty& property) {
        const std::int64_t size = values_->whole(property.count_type);
        if (size < 0)
            values_->report(fmt::format("a list {} has {} items; correct the count",
                                        shown(property.name), size));
        return size < 0 ? 0 : static_cast<std::uint64_t>(size);
    }

    void read_face(const PlyProperty& property) {
        if (error_.any()) return;
        const std::uint64_t corners = size_of_list(property);
        if (!error_.any() && (corners < 3 || corners > most_corners))
            values_->report(fmt::format("a face has {} corners; give 3 .. {}", corners,
                                        most_corners));
        for (std::uint64_t k = 0; k < corners && !error_.any(); ++k) {
            const std::int64_t vertex = values_->whole(property.type);
            if (!error_.any() && (vertex < 0 || static_cast<std::uint64_t>(vertex) >= vertices_))
                values_->report(fmt::format("vertex {} is named; there are {}, numbered from 0: "
                                            "correct the number", vertex, vertices_));
            const auto number = static_cast<std::uint32_t>(vertex);
            corners_.push_back({number, has_normals_ ? number : raster::Facet::flat});
        }
        face_ends_.push_back(corners_.size());
    }

    void make_facets() {
        std::size_t begin = 0;
        if (error_.any()) return;
        for (const std::size_t end : face_ends_) {
            append_face({corners_.data() + begin, end - begin}, points_, model_);
            begin = end;
        }
        keep_used_points(points_, normals_, model_);
    }

    ModelData& model_;
    FirstError& error_;
    PlyHeader header_;
    std::unique_ptr<PlyValues> values_;
    std::uint64_t vertices_ = 0;  // that the header counts
    bool has_normals_ = false;
    std::vector<ModelPoint> points_, normals_;
    std::vector<FaceCorner> corners_;     // of all faces
    std::vector<std::size_t> face_ends_;  // where each face's corners end
};

}  // namespace

void read_ply(std::string_view text, ModelData& model, FirstError& error) {
    PlyReader(text, model, error).read();
}

}  // namespace umbra78::tools
