// Vectors of the bias that follows the surface: a caster's slope, its moved code, the midpoint.
#include "raster/draw.hpp"
#include "shadow/midpoint.hpp"
#include "tests/shadow/frame/vectors.hpp"

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
            const std::int64_t code = in.between(0, 2) == 0 ? like : in.between(0, spec.deepest_drawn());
            sink.sample(raster::Sample{}, static_cast<std::uint32_t>(code), nullptr);
            line << code;
        }
        shadow::take_midpoints<hw::Depth32>(second, first);
        lines.push_back((line << "->" << first[0]).text());
    }
}

TEST(Vectors, Bias) {
    Inputs in(23);
    Lines lines;
    add_offsets(in, lines);
    add_moved(in, lines);
    add_midpoints(in, lines);
    check_vectors("bias",
                  {"Section 23.",
                   "offset factor limit a (x y z) b c -> slope offset",
                   "moved z_bits Z offset -> code, or none, with xy_bits 9",
                   "midpoint z_bits and a texel's codes as they come -> the map's code"},
                  lines);
}

}  // namespace
}  // namespace umbra78::test
