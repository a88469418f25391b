// Scenes of the rivals for tests: polygons in rival words, an eye, a light, and what they make.
#pragma once

#include "shadow/rivals/volumes.hpp"
#include "tests/support/effort.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace umbra78::shadow::rivals::test {

inline constexpr Centre straight_ahead{0, 0, -1, 0};

// How many random scenes every rival is compared in.
inline constexpr std::uint32_t random_scenes =
    static_cast<std::uint32_t>(umbra78::test::effort(10'000));
// The figures' scene is diced into 2^levels a side, at 512 x 512 pixels. Sanitizers see each path
// by the second level, where the third takes them ten seconds a rival.
inline constexpr int figures_levels = umbra78::test::sanitized ? 2 : 3;
// What they should come to at least, where all of them come to this.
constexpr std::uint64_t enough(std::uint64_t of_all) {
    return umbra78::test::sanitized ? of_all / 16 : of_all;
}

// Memory aligned as the core wants it.
class Memory {
public:
    explicit Memory(std::size_t bytes) : words_((bytes + frame_alignment) / frame_alignment) {}
    std::span<std::byte> bytes() { return std::as_writable_bytes(std::span(words_)); }

private:
    struct alignas(frame_alignment) Line {
        std::array<std::byte, frame_alignment> bytes;
    };
    std::vector<Line> words_;
};

struct Polygons {
    std::string name;
    int xy_bits = 6, fraction = 4;
    Centre eye = straight_ahead, light{};
    std::vector<Point> vertices;
    std::vector<Triangle> facets;

    // A triangle with vertices of its own: equal ones are welded.
    Polygons& triangle(Point a, Point b, Point c) {
        const auto first = static_cast<std::uint32_t>(vertices.size());
        vertices.insert(vertices.end(), {a, b, c});
        facets.push_back({{first, first + 1, first + 2}});
        return *this;
    }
    Polygons& quad(Point a, Point b, Point c, Point d) {
        return triangle(a, b, c).triangle(a, c, d);
    }
    // Between two opposite corners.
    Polygons& box(Point a, Point b) {
        const auto corner = [&](int k) {
            return Point{k & 1 ? b.x : a.x, k & 2 ? b.y : a.y, k & 4 ? b.z : a.z};
        };
        for (const auto& f : {std::array{0, 2, 6, 4}, std::array{1, 5, 7, 3},
                              std::array{0, 4, 5, 1}, std::array{2, 3, 7, 6},
                              std::array{0, 1, 3, 2}, std::array{4, 6, 7, 5}})
            quad(corner(f[0]), corner(f[1]), corner(f[2]), corner(f[3]));
        return *this;
    }
};

// Polygons on their way through the rivals. It owns what its spans refer to, so it is not copied.
class Scene {
public:
    explicit Scene(const Polygons& p)
        : mesh_memory_(MeshBuilder::bytes({p.vertices.size(), p.facets.size()})),
          builder_(mesh_memory_.bytes(), {p.vertices.size(), p.facets.size()}) {
        builder_.add(p.vertices, p.facets);
        Mesh mesh;
        fixed::require(builder_.finish(mesh) == MeshStatus::ok, "a test's mesh");
        const Space space(p.xy_bits, p.fraction, p.eye);
        setting_memory_ = std::make_unique<Memory>(
            setting_bytes(mesh.facets.size(), mesh.edges.size()));
        fixed::require(make_setting(space, mesh, p.light, setting_memory_->bytes(), setting_),
                       "a test's setting");
        shown_.resize(space.pixels());
        VisibleCounts counts;
        find_visible(setting_, shown_, counts);
        std::uint64_t rows = 0;
        for (std::size_t f = 0; f < setting_.mesh.facets.size(); ++f) {
            if (setting_.eye.sides[f] == 0) continue;
            const auto of_facet = rows_of(setting_, f);
            if (!of_facet.empty()) rows += static_cast<std::uint64_t>(of_facet.to - of_facet.from);
        }
        fixed::require(counts.rows == rows, "the rows that are looked at are the facets' own");
    }
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    const Setting& setting() const { return setting_; }
    std::span<const std::uint32_t> shown() const { return shown_; }
    // Of brute force over every facet.
    std::vector<std::uint8_t> brute_mask() const {
        std::vector<std::uint8_t> mask(shown_.size());
        BruteCounts counts;
        brute(setting_, shown_, nullptr, mask, counts);
        return mask;
    }

private:
    Memory mesh_memory_;
    MeshBuilder builder_;
    std::unique_ptr<Memory> setting_memory_;
    Setting setting_{};
    std::vector<std::uint32_t> shown_;
};

// A scene on a grid so coarse that pixels' centres, vertices, edges and planes coincide often:
// 8 x 8 pixels, up to eight facets and boxes, an eye and a light at a place or at infinity.
// `in(from, to)` chooses.
template <class In>
Polygons chosen_polygons(In&& in) {
    Polygons p;
    p.xy_bits = 3;
    p.fraction = in(1, 2);
    // Vertices at pixels' centres in half of the scenes, with depths and lights of few values.
    const int half_px = 1 << (p.fraction - 1);
    const bool at_centres = in(0, 1) == 0;
    const auto coordinate = [&] {
        return at_centres ? (2 * in(-5, 4) + 1) * half_px : in(-10 * half_px, 10 * half_px);
    };
    const auto point = [&] { return Point{coordinate(), coordinate(), in(-2, 2) * half_px}; };
    if (in(0, 2) == 0) p.eye = {0, 0, -in(4, 24), 1};
    do {
        const int w = in(0, 1), reach = w == 0 ? 2 : 8;
        p.light = {in(-reach, reach), in(-reach, reach), in(-reach, reach), w};
    } while (p.light.w == 0 && p.light.x == 0 && p.light.y == 0 && p.light.z == 0);
    std::vector<Point> shared(static_cast<std::size_t>(in(3, 8)));
    for (Point& v : shared) v = point();
    const auto vertex = [&] {
        const auto n = static_cast<std::size_t>(in(0, 7)) % shared.size();
        return in(0, 3) == 0 ? point() : shared[n];
    };
    for (int n = in(1, 8); n > 0; --n) {
        // One after the other: the order of a call's arguments is the compiler's.
        const bool is_box = in(0, 7) == 0;
        const Point c = is_box ? Point{} : vertex(), b = vertex(), a = vertex();
        if (is_box) {
            p.box(a, b);
        } else {
            p.triangle(a, b, c);
        }
    }
    return p;
}

inline Polygons random_polygons(std::uint32_t seed) {
    std::mt19937 random(seed);
    Polygons p = chosen_polygons([&random](int from, int to) {
        // std::uniform_int_distribution differs by library
        return from + static_cast<int>(random() % static_cast<std::uint32_t>(to - from + 1));
    });
    p.name = "random " + std::to_string(seed);
    return p;
}

}  // namespace umbra78::shadow::rivals::test
