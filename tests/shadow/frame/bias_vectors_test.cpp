// Vectors of the bias that follows the surface: a caster's slope, its moved code, the midpoint.
#include "raster/draw.hpp"
#include "shadow/midpoint.hpp"
#include "shadow/normal_offset.hpp"
#include "tests/shadow/frame/vectors.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace umbra78::test {
namespace {

// Triangles of leaves, of facets as wide as the guard band, slivers, and edge-on ones.
void add_offsets(Inputs& in, Lines& lines) {
    for (int k = 0; k < 64; ++k) {
        const std::int64_t reach = k % 4 == 3 ? raster::max_screen : std::int64_t{1} << (8 + k % 8);
        const auto word = [&](std::int64_t limit) {
            return static_cast<std::int32_t>(in.between(-limit, limit));
        };
        const auto corner = [&] {
            const std::int64_t deep = k % 8 == 3 ? INT32_MAX / 4 : 1 << 20;
            return raster::Corner{word(reach), word(reach), word(deep)};
        };
        const raster::Corner a = corner(), b = corner();
        raster::Corner c = corner();
        if (k % 16 == 1) c = {2 * b.x - a.x, 2 * b.y - a.y, c.z};
        if (k % 16 == 2) c = {b.x, b.y + 1, c.z};
        raster::Casters casters{.slope_q8 = static_cast<std::int32_t>(in.between(1, 64 << 8))};
        Line line;
        line << "offset" << casters.slope_q8;
        if (k % 3 == 0) {
            casters.limit = in.between(0, 1 << (k % 30));
            line << casters.limit;
        } else {
            line << "none";
        }
        for (const raster::Corner& p : {a, b, c}) line << p.x << p.y << p.z;
        const std::int64_t slope = raster::depth_slope(a, b, c);
        lines.push_back((line << "->" << slope << casters.offset(slope)).text());
    }
}

struct Codes {
    static constexpr bool shades = false;
    std::int64_t code = -1;
    bool hidden(const raster::Footprint&) const { return false; }
    void sample(const raster::Sample&, std::uint32_t c, const auto*) { code = c; }
};

// About the near plane, the far plane and between.
void add_moved(Inputs& in, Lines& lines) {
    for (int k = 0; k < 32; ++k) {
        raster::DrawSetup setup;
        setup.spec.z_bits = static_cast<int>(in.between(4, 24));
        setup.spec.xy_bits = 9;
        const std::int64_t half = setup.spec.depth_offset() << raster::depth_guard(setup.spec);
        raster::Sample s{};
        s.z = (k % 3 == 0 ? half : k % 3 == 1 ? -half : in.between(-half, half)) +
              in.between(-200, 200);
        const std::int64_t offset =
            k % 8 == 0 ? 0 : in.between(0, std::int64_t{1} << (k % 4 == 1 ? 40 : 8));
        Codes sink;
        raster::DrawCounts counts;
        const raster::BlockShading* const none = nullptr;
        raster::detail::Emitter<Codes>{setup, sink, counts}(s, none, offset);
        Line line;
        line << "moved" << setup.spec.z_bits << s.z << offset << "->";
        if (sink.code < 0) {
            line << "none";
        } else {
            line << sink.code;
        }
        lines.push_back(line.text());
    }
}

void add_midpoints(Inputs& in, Lines& lines) {
    for (int k = 0; k < 32; ++k) {
        hw::MachineSpec spec;
        spec.xy_bits = 4;
        spec.z_bits = static_cast<int>(in.between(4, 24));
        std::vector<hw::Depth32> first(256), second(256);
        hw::FrameStore<hw::Depth32> map{4, first, {}, {}}, behind{4, second, {}, {}};
        map.clear(spec);
        behind.clear(spec);
        shadow::MidpointSink<hw::Depth32> sink{map, behind};
        Line line;
        line << "midpoint" << spec.z_bits;
        for (std::int64_t n = in.between(0, 5), like = in.between(0, 14); n > 0; --n) {
            const std::int64_t code =
                in.between(0, 2) == 0 ? like : in.between(0, spec.deepest_drawn());
            sink.sample(raster::Sample{}, static_cast<std::uint32_t>(code), nullptr);
            line << code;
        }
        shadow::take_midpoints<hw::Depth32>(spec, second, first);
        lines.push_back((line << "->" << first[0]).text());
    }
}

// Planes of pixels near each other, of places far apart, edge-on ones, and steps that are too long.
void add_planes(Inputs& in, Lines& lines) {
    for (int k = 0; k < 64; ++k) {
        const int bits = k % 4 == 3 ? 31 : static_cast<int>(in.between(4, 20));
        const hw::Point at{in.word(18), in.word(18), in.word(17), hw::DivideStatus::ok};
        const auto near = [&] {
            return hw::Point{at.x + in.word(bits), at.y + in.word(bits), at.z + in.word(bits),
                             hw::DivideStatus::ok};
        };
        const hw::Point beside = near();
        hw::Point below = near();
        if (k % 16 == 1) below = beside;
        if (k % 16 == 2) below.z += std::int64_t{1} << 30;
        Line line;
        line << "plane";
        std::int64_t limit = INT64_MAX;
        if (k % 3 == 0) {
            limit = in.between(0, 1 << (k % 20));
            line << limit;
        } else {
            line << "none";
        }
        for (const hw::Point& p : {at, beside, below}) line << p.x << p.y << p.z;
        const std::int64_t x2 = 2 * at.x + in.word(10), y2 = 2 * at.y + in.word(10);
        const shadow::ReceiverPlane plane = shadow::receiver_plane(at, beside, below, limit);
        lines.push_back((line << x2 << y2 << "->" << plane.slope_x << plane.slope_y
                              << plane.change(x2, y2)).text());
    }
}

// Points moved along normals: near ones and far ones, lights at infinity and lamps, slivers, and
// what is not moved.
void add_normals(Inputs& in, Lines& lines) {
    for (int k = 0; k < 96; ++k) {
        const int fraction = k % 5 == 4 ? 12 : static_cast<int>(in.between(0, 11));
        const int bits = k % 8 == 7 ? 31 : static_cast<int>(in.between(3, 18));
        shadow::LightScale light;
        Line line;
        line << "normal" << fraction;
        if (k % 2 == 0) {
            light.quanta_q16 = k % 10 == 0 ? shadow::max_texel_quanta >> in.between(0, 40)
                                           : in.between(1, 1 << 26);
            line << light.quanta_q16;
        } else {
            light.focal_q8 = in.between(1, 1 << in.between(1, 30));
            light.reach_q8 = in.between(-1000, std::int64_t{1} << in.between(16, 40));
            line << "lamp" << light.reach_q8 << light.focal_q8;
        }
        const std::int64_t offset = in.between(0, 16 << 8), turn = k % 3 == 0 ? -1 : 1;
        const hw::Point at{in.word(18), in.word(18), in.word(17), hw::DivideStatus::ok};
        const auto near = [&] {
            return hw::Point{at.x + in.word(bits), at.y + in.word(bits), at.z + in.word(bits),
                             hw::DivideStatus::ok};
        };
        const hw::Point beside = near();
        hw::Point below = near();
        if (k % 16 == 1) below = beside;
        if (k % 16 == 2) below.z += std::int64_t{1} << 30;
        line << offset << turn;
        for (const hw::Point& p : {at, beside, below}) line << p.x << p.y << p.z;
        const hw::Point moved = shadow::moved_along_normal(at, beside, below,
                                                           static_cast<int>(turn), offset, light,
                                                           fraction);
        lines.push_back((line << "->" << moved.x << moved.y << moved.z).text());
    }
}

// A pixel and the two beside it in one direction; -1 for background.
void add_neighbours(Inputs& in, Lines& lines) {
    for (int k = 0; k < 32; ++k) {
        std::vector<hw::Depth32> codes(256, 65535);
        const int dx = k % 2, dy = 1 - dx;
        const auto place = [&] {
            return static_cast<int>(k % 5 == 0 ? in.between(0, 1) * 15 : in.between(1, 14));
        };
        const int x = place(), y = place();
        const std::int64_t own = in.between(0, 65534);
        std::array<std::int64_t, 3> three{own, own, own};
        for (std::size_t side : {0u, 2u})
            three[side] = in.between(0, 4) == 0
                              ? -1 : std::clamp<std::int64_t>(own + in.between(-3, 3), 0, 65534);
        for (int step = -1; step <= 1; ++step) {
            const int at_x = x + step * dx, at_y = y + step * dy;
            const std::int64_t code = three[static_cast<std::size_t>(step + 1)];
            if (at_x >= 0 && at_y >= 0 && at_x < 16 && at_y < 16 && code >= 0)
                codes[static_cast<std::size_t>(16 * at_y + at_x)] = static_cast<hw::Depth32>(code);
        }
        const hw::FrameStore<const hw::Depth32> store{4, codes, {}, {}};
        Line line;
        line << "neighbour" << x << y << dx << dy << three[0] << three[1] << three[2] << "->";
        int to_x = 0, to_y = 0;
        if (shadow::nearer_neighbour(store, 65535, x, y, dx, dy, to_x, to_y)) {
            line << to_x << to_y;
        } else {
            line << "none";
        }
        lines.push_back(line.text());
    }
}

TEST(Vectors, Bias) {
    Inputs in(23);
    Lines lines;
    add_offsets(in, lines);
    add_moved(in, lines);
    add_midpoints(in, lines);
    add_planes(in, lines);
    add_neighbours(in, lines);
    add_normals(in, lines);
    check_vectors("bias",
                  {"Section 24.",
                   "offset factor limit a (x y z) b c -> slope offset",
                   "moved z_bits Z offset -> code, or none, with xy_bits 9",
                   "midpoint z_bits and a texel's codes as they come -> the map's code",
                   "plane limit, results (X Y Z) of a pixel and of its neighbours in X and in Y,",
                   "twice the place -> slope_X slope_Y change, both slopes 0 without a plane",
                   "neighbour px py, direction, codes before, of and after the pixel, -1 for",
                   "background -> the neighbour that is taken, with xy_bits 4",
                   "normal fraction_bits, quanta_a_texel or \"lamp\" reach focal, c, way, results",
                   "of a pixel and its neighbours -> the results, moved"},
                  lines);
}

}  // namespace
}  // namespace umbra78::test
