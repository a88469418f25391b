// Fuzz target: the third class of rivals, shadow volumes. Sides in the order of depth have brute
// force's mask and the numbers of the sides added up; in a frame store, whose codes err, z-pass
// and z-fail have one number in each pixel whatever the codes are.
#include "tests/fuzz/core/polygons.hpp"
#include "tests/shadow/rivals/class3.hpp"

#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace umbra78::shadow::rivals;
    using umbra78::fuzz::demand;
    umbra78::fuzz::Bytes bytes(data, size);
    const test::Scene scene(umbra78::fuzz::any_polygons(bytes));
    const int bits = bytes.number(2, 24), counter_bits = bytes.number(1, 16);
    const Setting& s = scene.setting();
    OrderedCounts counts;
    const test::Numbers numbers = test::ordered(s, scene.shown(), counts);
    demand(numbers == test::summed(s, scene.shown()), "an order changes no sum");
    demand(test::mask_of(s, scene.shown(), numbers) == scene.brute_mask(),
           "ordered volumes are brute force");
    const DepthScale scale = test::scale_of(s, bits);
    const test::Stenciled pass(s, scene.shown(), scale, {StencilPass::z_pass, counter_bits});
    const test::Stenciled fail(s, scene.shown(), scale, {StencilPass::z_fail, counter_bits});
    demand(pass.codes == fail.codes && pass.numbers == fail.numbers,
           "z-pass and z-fail have one number");
    return 0;
}
