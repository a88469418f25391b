// Fuzz target: the first class of rivals, which decides while a picture is scanned out, against
// brute force: Bouknight & Kelley's second scan in its forms, Appel's quantitative invisibility
// carried along and asked anew, and lists of pixels in the light's map.
#include "shadow/rivals/bouknight_kelley.hpp"
#include "tests/fuzz/core/polygons.hpp"
#include "tests/shadow/rivals/scan_out.hpp"

#include <array>
#include <vector>

namespace umbra78::fuzz {
namespace {

using namespace shadow::rivals;
namespace scenes = shadow::rivals::test;

using Mask = std::vector<std::uint8_t>;

void check_second_scan(const scenes::Scene& scene, const scenes::Linked& linked,
                       const scenes::Bordered& bordered, const Mask& brute_mask) {
    struct Form {
        bool borders, stops;
    };
    for (const Form form : {Form{false, false}, Form{false, true}, Form{true, true}}) {
        std::vector<CounterChange> room(2 * linked.counts.longest + bordered.counts.longest);
        Mask mask(brute_mask.size(), 77);
        ScanOutCounts counts;
        demand(bouknight_kelley(scene.setting(), scene.shown(), linked.links,
                                form.borders ? &bordered.borders : nullptr, {form.stops}, room,
                                mask, counts),
               "the second scan has room enough");
        demand(mask == brute_mask, "the second scan is brute force");
    }
}

// The surfaces before each pixel's point, by asking every facet.
std::vector<std::int32_t> asked_numbers(const scenes::Scene& scene) {
    const Setting& s = scene.setting();
    std::vector<std::int32_t> numbers(scene.shown().size());
    for (std::size_t at = 0; at < numbers.size(); ++at) {
        const std::uint32_t on = scene.shown()[at];
        const auto column = static_cast<int>(at % 8), row = static_cast<int>(at / 8);
        if (on != nothing_seen && !s.attached(on))
            numbers[at] = static_cast<std::int32_t>(surfaces_before(s, on, column, row));
    }
    return numbers;
}

void check_appel(const scenes::Scene& scene, const scenes::Bordered& bordered) {
    const std::vector<std::int32_t> asked = asked_numbers(scene);
    for (const bool carries : {false, true}) {
        std::vector<CounterChange> room(bordered.counts.longest);
        std::vector<std::int32_t> numbers(asked.size(), 77);
        AppelCounts counts;
        demand(appel(scene.setting(), scene.shown(), nullptr, bordered.borders, {carries}, room,
                     numbers, counts),
               "Appel's counter has room enough");
        demand(numbers == asked, "Appel's counter is the number of surfaces");
    }
}

}  // namespace
}  // namespace umbra78::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace umbra78::fuzz;
    Bytes bytes(data, size);
    const scenes::Scene scene(any_polygons(bytes));
    const Mask brute_mask = scene.brute_mask();
    const scenes::Linked linked(scene.setting(), scene.shown());
    const scenes::Bordered bordered(scene.setting(), linked.links);
    check_second_scan(scene, linked, bordered, brute_mask);
    check_appel(scene, bordered);
    for (const int texels : {1, 4, 32}) {
        IrregularCounts counts;
        demand(scenes::mask_by_lists(scene.setting(), scene.shown(), texels, counts) == brute_mask,
               "lists of pixels are brute force");
    }
    return 0;
}
