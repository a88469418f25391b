// Fuzz target: the edge dequantizer. Any mask over any background, with each number of passes, has
// the levels that the implementation in C gives it; nothing is written outside the spans.
#include "shadow/filters/dequantize.hpp"
#include "tests/fuzz/core/oracle.hpp"

#include <memory>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace umbra78;
    fuzz::Bytes bytes(data, size);
    const int xy_bits = bytes.number(4, 5), passes = bytes.number(1, 6), side = 1 << xy_bits;
    const auto pixels = static_cast<std::size_t>(side * side);
    std::vector<hw::Depth16> depth(pixels);
    std::vector<std::uint8_t> mask(pixels), levels(pixels);
    std::vector<std::uint32_t> visited(shadow::edge_visited_words(xy_bits), 0xdeadbeef);
    std::vector<std::int16_t> coverage(shadow::edge_coverage_words(xy_bits), -77);
    std::vector<std::int32_t> given(pixels), expected(pixels);
    const std::unique_ptr<bool[]> visible(new bool[pixels]);
    for (std::size_t p = 0; p < pixels; ++p) {
        const int kind = bytes.number(0, 7);
        visible[p] = kind != 7;
        depth[p] = visible[p] ? 1000 : 65535;
        mask[p] = static_cast<std::uint8_t>(std::array{0, 127, 128, 255}[kind % 4]);
        given[p] = mask[p];
    }
    const hw::ReadOnlyStore<hw::Depth16> store{xy_bits, depth};
    shadow::dequantize<hw::Depth16>(mask, store, hw::Depth16{65535}, passes, {visited, coverage},
                                    levels);
    oracle::dequantize(given.data(), visible.get(), passes, side, expected.data());
    for (std::size_t p = 0; p < pixels; ++p)
        fuzz::demand(levels[p] == expected[p], "a level is section 13's");
    return 0;
}
