// Fuzz target: scenes of polygons full of ties, which the rivals' other targets take, too. Brute
// force by lines that it keeps, by the light's grid and by asking every facet, and shadow volumes,
// have the same mask.
#include "shadow/rivals/brute.hpp"
#include "shadow/rivals/light_grid.hpp"
#include "shadow/rivals/volumes.hpp"
#include "tests/fuzz/core/polygons.hpp"

#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace umbra78::shadow::rivals;
    using umbra78::fuzz::demand;
    umbra78::fuzz::Bytes bytes(data, size);
    const test::Scene scene(umbra78::fuzz::any_polygons(bytes));
    const Setting& s = scene.setting();
    const std::vector<std::uint8_t> brute_mask = scene.brute_mask();
    for (std::size_t at = 0; at < brute_mask.size(); ++at) {
        const std::uint32_t on = scene.shown()[at];
        const auto column = static_cast<int>(at % 8), row = static_cast<int>(at / 8);
        const bool is_dark = on != nothing_seen &&
                             (s.attached(on) || surfaces_before(s, on, column, row) > 0);
        demand(brute_mask[at] == (is_dark ? dark : lit), "brute force asks every facet");
    }
    std::vector<std::uint8_t> mask(brute_mask.size());
    for (const int cells : {0, 1, 8}) {
        LightGrid grid;
        std::size_t needed = 0;
        test::Memory memory(1 << 16);
        demand(grid.build(s, cells, memory.bytes(), needed), "the grid has memory enough");
        BruteCounts counts;
        brute(s, scene.shown(), &grid, mask, counts);
        demand(mask == brute_mask, "the grid leaves out nothing");
    }
    std::vector<ContourEdge> contour(find_contour(s, {}));
    find_contour(s, contour);
    std::vector<std::int32_t> surfaces(mask.size());
    VolumeCounts counts;
    count_volumes(s, scene.shown(), contour, surfaces, counts);
    mask_of_counts(s, scene.shown(), surfaces, mask);
    demand(mask == brute_mask, "volumes count the surfaces");
    return 0;
}
