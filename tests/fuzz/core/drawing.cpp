// Fuzz target: drawing. A patch and some facets, in any view and widths, are subdivided to an end;
// matrix, depths and counts are those of the implementation in C, and nothing is written outside
// the store.
#include "raster/draw.hpp"
#include "raster/sinks.hpp"
#include "tests/fuzz/core/oracle.hpp"

#include <memory>
#include <vector>

namespace umbra78::fuzz {
namespace {

struct Things {
    raster::Patch patch;
    std::vector<raster::World> vertices;
    std::vector<raster::Facet> facets;

    raster::Surfaces surfaces() const {
        return {std::span(&patch, 1), raster::Mesh{vertices, {}, facets}};
    }
};

// Words of up to `bits` bits, one in four of them a repetition.
Things any_things(Bytes& bytes) {
    Things t;
    const int bits = bytes.number(4, 30);
    raster::World last{};
    const auto point = [&] {
        if (bytes.number(0, 3) != 0) last = {bytes.word(bits), bytes.word(bits), bytes.word(bits)};
        return last;
    };
    for (raster::World& p : t.patch.control) p = point();
    for (int n = bytes.number(3, 6); n > 0; --n) t.vertices.push_back(point());
    const auto last_vertex = static_cast<int>(t.vertices.size()) - 1;
    for (int n = bytes.number(0, 3); n > 0; --n) {
        raster::Facet facet;
        for (std::uint32_t& v : facet.vertex)
            v = static_cast<std::uint32_t>(bytes.number(0, last_vertex));
        t.facets.push_back(facet);
    }
    return t;
}

raster::View any_view(Bytes& bytes) {
    raster::View v;
    v.axes = raster::axes_from_angles(bytes.number(-360, 360) * 32768,
                                      bytes.number(-180, 180) * 32768);
    v.target = {bytes.word(20), bytes.word(20), bytes.word(20)};
    v.extent = 1 << bytes.number(4, 28);
    v.far_depth = std::int64_t{v.extent} * bytes.number(2, 64);
    v.near_depth = -v.far_depth;
    if (bytes.number(0, 1) == 0) return v;
    v.projection = raster::Projection::perspective;
    v.distance = static_cast<std::int32_t>(std::int64_t{v.extent} * bytes.number(1, 7));
    v.near_depth = v.extent / 16 + 1;
    return v;
}

oracle::View view_of(const raster::View& v) {
    const auto copy = [](const raster::Axis& from, oracle::i64* to) {
        for (std::size_t k = 0; k < 3; ++k) to[k] = from[k];
    };
    oracle::View o{};
    copy(v.axes.right, o.right);
    copy(v.axes.up, o.up);
    copy(v.axes.back, o.back);
    o.target[0] = v.target.x, o.target[1] = v.target.y, o.target[2] = v.target.z;
    o.extent = v.extent;
    o.distance = v.distance;
    o.near = v.near_depth;
    o.far = v.far_depth;
    return o;
}

void copy_place(const raster::World& p, int fraction, oracle::i64* to) {
    to[0] = oracle::object_word(p.x, fraction);
    to[1] = oracle::object_word(p.y, fraction);
    to[2] = oracle::object_word(p.z, fraction);
}

// The light's map by the implementation in C: two codes a pixel, the first the least.
struct Drawn {
    std::vector<std::int32_t> codes;
    oracle::Counts counts{};
};
Drawn by_text(const Things& things, const oracle::Settings& s, const oracle::Loaded& m) {
    oracle::Patch patch{};
    std::vector<oracle::Facet> facets(things.facets.size());
    for (std::size_t k = 0; k < 16; ++k)
        copy_place(things.patch.control[k], m.fraction, patch.p[k]);
    for (std::size_t n = 0; n < facets.size(); ++n)
        for (std::size_t k = 0; k < 3; ++k)
            copy_place(things.vertices[things.facets[n].vertex[k]], m.fraction, facets[n].p[k]);
    Drawn drawn;
    drawn.codes.assign(static_cast<std::size_t>(2 * s.pixels),
                       static_cast<std::int32_t>(s.background_code));
    const auto d = std::make_unique<oracle::Drawing>();
    d->s = &s;
    d->m = m;
    d->fraction = m.fraction;
    d->light = true;
    d->slope_limit = -1;
    d->records = drawn.codes.data();
    const oracle::Surfaces surfaces{&patch, 1, facets.data(), static_cast<int>(facets.size())};
    oracle::draw(d.get(), &surfaces);
    drawn.counts = d->counts;
    return drawn;
}

bool load_by_text(const raster::View& view, const oracle::Settings& s, int fraction,
                  oracle::Loaded& m) {
    const auto exact = std::make_unique<oracle::Exact>();
    const oracle::View v = view_of(view);
    oracle::world_to_screen(&v, &s, exact.get());
    if (!oracle::load(exact.get(), &s, fraction, 1 << 14, &m)) return false;
    const std::int64_t out[3] = {13, 13, s.depth_fraction + s.depth_guard};
    for (int r = 0; r < 3 && m.affine; ++r)
        if (m.e[r] > 37 + fraction - out[r]) return false;
    return true;
}

template <class Depth>
void draw_both(const Things& things, raster::DrawSetup& setup, const oracle::Settings& s,
               const oracle::Loaded& m) {
    std::vector<Depth> depth(static_cast<std::size_t>(s.pixels),
                             static_cast<Depth>(s.background_code));
    hw::FrameStore<Depth> store{setup.spec.xy_bits, depth};
    raster::DepthSink<Depth> sink{store};
    static const auto memory = std::make_unique<raster::DrawMemory>();
    const raster::DrawCounts counts =
        raster::draw(things.surfaces(), std::span<const std::uint32_t>{}, setup, *memory, sink);
    const Drawn expected = by_text(things, s, m);
    for (std::size_t p = 0; p < depth.size(); ++p)
        demand(static_cast<std::int32_t>(depth[p]) == expected.codes[2 * p],
               "a depth is that of sections 6, 7, 14, 21 and 28");
    demand(counts.splits == static_cast<std::uint64_t>(expected.counts.splits) &&
               counts.tested_blocks == static_cast<std::uint64_t>(expected.counts.tested),
           "blocks are split as in sections 6 and 14");
}

void run(Bytes& bytes) {
    raster::DrawSetup setup;
    setup.spec = any_spec(bytes);
    setup.spec.xy_bits = bytes.number(4, 6);  // of 6 on Z has 26 bits, and floats round it
    if (hw::check(setup.spec) != hw::SpecStatus::ok) return;
    oracle::Settings s = settings_of(setup.spec);
    const raster::View view = any_view(bytes);
    const Things things = any_things(bytes);
    if (bytes.number(0, 1) != 0) {
        setup.sampling = raster::Sampling::leaf;
        s.sampling = oracle::LEAF;
    }
    setup.object = raster::object_format(things.surfaces());
    setup.leaves_out_hidden = false;
    static const std::vector<raster::Material> materials(1);
    setup.materials = materials;
    const bool loaded =
        raster::load_view(view, setup.spec, setup.object, setup.matrix) == hw::LoadStatus::ok;
    oracle::Loaded m{};
    demand(load_by_text(view, s, setup.object.fraction, m) == loaded,
           "a matrix is refused where section 5 or 6 refuses it");
    if (!loaded) return;
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t j = 0; j < 4; ++j)
            demand(m.c[r][j] == setup.matrix.word[r][j] && m.e[r] == setup.matrix.exponent[r],
                   "a matrix has the words of sections 4 and 5");
    if (setup.spec.z_bits <= 16) {
        draw_both<hw::Depth16>(things, setup, s, m);
    } else {
        draw_both<hw::Depth32>(things, setup, s, m);
    }
}

}  // namespace
}  // namespace umbra78::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    umbra78::fuzz::Bytes bytes(data, size);
    umbra78::fuzz::run(bytes);
    return 0;
}
