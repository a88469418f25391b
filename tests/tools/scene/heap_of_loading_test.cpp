// The heap that reading a scene takes: operator new is counted, so that a scene of 100 000 patches
// can be read in the memory that README.md names, without reading one here.
#include "tests/support/effort.hpp"
#include "tools/scene/scene.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <malloc.h>
#include <new>

#ifndef __SANITIZE_ADDRESS__  // which has a heap of its own
namespace {
std::size_t live = 0, peak = 0, total = 0, calls = 0;
}

void* operator new(std::size_t size) {
    void* p = std::malloc(size == 0 ? 1 : size);
    if (p == nullptr) std::abort();
    live += malloc_usable_size(p), total += malloc_usable_size(p), ++calls;
    peak = std::max(peak, live);
    return p;
}
void operator delete(void* p) noexcept {
    if (p != nullptr) live -= malloc_usable_size(p);
    std::free(p);
}
void operator delete(void* p, std::size_t) noexcept { operator delete(p); }

namespace umbra78::tools::test {
namespace {

struct Heap {
    double peak, total, calls;  // for each patch
};

Heap heap_of(int patches) {
    std::string text = "[light]\nazimuth = -45\n";
    for (int k = 0; k < patches; ++k) {
        text += "[[patch]]\ncontrol = [\n";
        for (int n = 0; n < 16; ++n)
            text += fmt::format("  [{}.{:06}, {}.25, 0.{:06}],\n", k % 500, n * 1001, n, k);
        text += "]\n";
    }
    const std::size_t live_before = live, total_before = total, calls_before = calls;
    peak = live;
    const SceneResult result = read_scene(text, "a/folder/of/scenes/patches.toml", {});
    EXPECT_EQ(result.error, "");
    EXPECT_EQ(result.scene.patches.size(), static_cast<std::size_t>(patches));
    const auto each = [&](std::size_t n) { return static_cast<double>(n) / patches; };
    return {each(peak - live_before), each(total - total_before), each(calls - calls_before)};
}

// 2500 bytes for each of 100 000 patches are 250 MB; a tree of each would take 12 000.
TEST(HeapOfLoading, AFewTimesThatOfThePatches) {
    const Heap some = heap_of(2048), many = heap_of(16384);
    for (const Heap& heap : {some, many}) {
        RecordProperty("peak_bytes_a_patch", std::to_string(heap.peak));
        EXPECT_LT(heap.peak, 1500);
        EXPECT_LT(heap.total, 6000);
        EXPECT_LT(heap.calls, 80);
    }
    EXPECT_LT(many.peak, 1.1 * some.peak);
    EXPECT_LT(many.total, 1.1 * some.total);
    EXPECT_LT(many.calls, 1.1 * some.calls);
    fmt::print("peak {:.0f}, in all {:.0f} bytes and {:.1f} calls a patch\n", many.peak,
               many.total, many.calls);
}

}  // namespace
}  // namespace umbra78::tools::test
#endif
