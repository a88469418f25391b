// Fuzz target: the second class of rivals, which cuts polygons before any pixel, against brute
// force: splitting by shadow volumes, the light's order and its perimeters facet by facet and in
// pairs, and Atherton's outlines.
#include "tests/fuzz/core/polygons.hpp"
#include "tests/shadow/rivals/atherton.hpp"
#include "tests/shadow/rivals/object_space.hpp"

#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace umbra78::shadow::rivals;
    using umbra78::fuzz::demand;
    umbra78::fuzz::Bytes bytes(data, size);
    const test::Scene scene(umbra78::fuzz::any_polygons(bytes));
    const bool only_seen = bytes.number(0, 1) != 0;
    const std::vector<std::uint8_t> brute_mask = scene.brute_mask();
    // What most scenes need, and what the largest do.
    const test::Capacities little, much{4096, {4096, 32768, 64}, {32768, 262144},
                                        {4096, 32768, 128}};
    test::ObjectSpace o(scene.setting(), scene.shown(), little);
    if (o.split(only_seen) != PieceStatus::ok) {
        o.give(much);
        demand(o.split(only_seen) == PieceStatus::ok, "splitting has room enough");
    }
    demand(o.mask() == brute_mask, "split pieces are brute force");
    for (const bool in_pairs : {false, true}) {
        o.give(little);
        if (o.sort_from_light() != OrderStatus::ok || o.clip(in_pairs) != PieceStatus::ok) {
            o.give(much);
            demand(o.sort_from_light() == OrderStatus::ok, "the light's order has room enough");
            demand(o.clip(in_pairs) == PieceStatus::ok, "perimeters have room enough");
        }
        demand(o.mask() == brute_mask, "pieces within perimeters are brute force");
    }
    test::Outlines outlines(scene.setting(), scene.shown(), {256, {{64, 1024}, 256}, {512, 4096}});
    if (outlines.clip(only_seen) != PieceStatus::ok) {
        outlines.give({4096, {{1024, 32768}, 4096}, {16384, 65536}});
        demand(outlines.clip(only_seen) == PieceStatus::ok, "outlines have room enough");
    }
    demand(outlines.mask() == brute_mask, "outlines are brute force");
    return 0;
}
