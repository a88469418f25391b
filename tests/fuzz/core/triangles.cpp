// Fuzz target: a triangle's samples. Each centre that section 21's rule covers comes once, with
// the plane's depth; no other comes.
#include "raster/triangle.hpp"
#include "tests/fuzz/core/oracle.hpp"

#include <utility>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace umbra78;
    fuzz::Bytes bytes(data, size);
    hw::MachineSpec spec;
    spec.xy_bits = bytes.number(4, 5);
    const int side = spec.size_px(), frame = spec.half_px() << 13;
    // Corners anywhere, near the frame, or on the grid of its centres, where edges meet them.
    const auto place = [&] {
        const int way = bytes.number(0, 2);
        if (way == 0) return bytes.number(-raster::max_screen, raster::max_screen);
        return way == 1 ? bytes.number(-2 * frame, 2 * frame) : 4096 * bytes.number(-40, 40);
    };
    raster::Corner corners[3];
    oracle::Corner given[3];
    for (int k = 0; k < 3; ++k) {
        corners[k] = {place(), place(), bytes.word(31)};
        given[k] = {corners[k].x, corners[k].y, corners[k].z};
    }
    std::vector<std::int64_t> z(static_cast<std::size_t>(side * side), INT64_MIN);
    raster::sample_triangle(corners[0], corners[1], corners[2], spec,
                            [&](const raster::Sample& s) {
        auto& at = z.at(static_cast<std::size_t>(s.py * side + s.px));
        fuzz::demand(at == INT64_MIN, "a centre is sampled once");
        at = s.z;
    });
    const auto area = oracle::cross(given, given + 1, given[2].x, given[2].y);
    if (area < 0) std::swap(given[1], given[2]);
    for (int p = 0; p < side * side; ++p) {
        const std::int64_t x = (2 * (p % side - side / 2) + 1) * 4096,
                           y = (2 * (p / side - side / 2) + 1) * 4096;
        const bool in = area != 0 && oracle::covered(given, x, y);
        fuzz::demand(z[static_cast<std::size_t>(p)] ==
                         (in ? oracle::plane_depth(given, x, y) : INT64_MIN),
                     "a centre is covered, and its depth is section 21's");
    }
    return 0;
}
