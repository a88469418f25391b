// A whole frame allocates nothing and fits in 3 MiB: every call of malloc is counted, and operator
// new ends there too. Under AddressSanitizer, which has its own malloc, its hook counts.
#include "shadow/clocked/memory_replay.hpp"
#include "shadow/frame/frame.hpp"
#include "shadow/frame/paper_figures.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace {
std::atomic<long> calls{0};
}

#ifdef __SANITIZE_ADDRESS__
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*)(const volatile void*, size_t),
                                                         void (*)(const volatile void*));
namespace {
const int installed = __sanitizer_install_malloc_and_free_hooks(
    [](const volatile void*, size_t) { ++calls; }, [](const volatile void*) {});
}
#elif defined(__GLIBC__)
extern "C" {
void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void* __libc_memalign(size_t, size_t);
void* malloc(size_t n) { return ++calls, __libc_malloc(n); }
void* calloc(size_t n, size_t each) { return ++calls, __libc_calloc(n, each); }
void* realloc(void* p, size_t n) { return ++calls, __libc_realloc(p, n); }
void* aligned_alloc(size_t at, size_t n) { return ++calls, __libc_memalign(at, n); }
}
#endif

namespace umbra78::shadow {
namespace {

constexpr std::size_t room = std::size_t{14} << 18;

// Allocations of `f`.
template <class F>
long allocations(F&& f) {
    const long before = calls;
    f();
    return calls - before;
}

TEST(Heap, TheCountCounts) {
    EXPECT_EQ(allocations([] {}), 0);
    std::unique_ptr<int> kept;
    EXPECT_GT(allocations([&] { kept = std::make_unique<int>(5); }), 0);
}

TEST(Heap, AFrameOfTheFiguresFitsInThreeAndAHalfMebibytes) {
    EXPECT_LT(frame_bytes<hw::Depth16>({}, 128), room);
    std::cout << "[ measured ] a 512 x 512 frame of 128 patches takes "
              << frame_bytes<hw::Depth16>({}, 128) << " of " << room << " bytes\n";
}

TEST(Heap, AFrameAllocatesNothing) {
    struct alignas(64) Line {
        std::byte bytes[64];
    };
    std::vector<Line> memory(frame_bytes<hw::Depth16>({}, 128) / 64 + 1);
    FigurePatches patches;
    FrameMatrices matrices;
    FrameBuffers<hw::Depth16> frame;
    for (int figure = 1; figure <= figure_count; ++figure) {
        for (const Form form : {Form::post_process, Form::correct, Form::ground, Form::blob}) {
            for (const auto projection :
                 {raster::Projection::orthographic, raster::Projection::perspective}) {
                FrameCounts counts;
                FrameStatus status{};
                EXPECT_EQ(allocations([&] {
                    patches = figure_patches();
                    const std::array materials{figure_material};
                    Scene scene{patches, materials, figure_view(0),
                                {{figure_view(figure_azimuth_q16)}}};
                    scene.observer.projection = projection;
                    scene.observer.distance = 6 << 16;
                    raster::fit_depth(scene.observer,
                                      raster::depth_range(scene.observer, patches));
                    scene.ground = 17;  // by its corners as good a plane as any
                    const std::array blobs{raster::Ellipse{{}, {1 << 16, 0, 0}, {0, 1 << 16, 0}}};
                    scene.blobs = blobs;
                    Settings settings = figure_settings(figure);
                    settings.form = form;
                    frame = carve<hw::Depth16>({memory[0].bytes, 64 * memory.size()},
                                               settings.machine, patches.size());
                    status = render(scene, settings, frame, matrices, counts);
                }), 0) << "figure " << figure;
                EXPECT_EQ(status, FrameStatus::ok);
                EXPECT_GT(counts.observer.samples, 50000u) << "something is drawn";
            }
        }
    }
}

// Nor do its workers, whoever they are: here one thread that is each of three in turn.
TEST(Heap, AFrameOfSeveralWorkersAllocatesNothing) {
    struct alignas(64) Line {
        std::byte bytes[64];
    };
    const FigurePatches patches = figure_patches();
    const std::array materials{figure_material};
    Scene scene{patches, materials, figure_view(0), {{figure_view(figure_azimuth_q16)}}};
    const std::array<raster::World, 3> corners{{{-90000, -90000, 0}, {90000, 0, 0}, {0, 90000, 0}}};
    std::array<raster::Facet, 64> facets;
    facets.fill({{0, 1, 2}});
    scene.mesh = {corners, {}, facets};
    const auto in_turn = [](void*, std::size_t parts, Executor::Task task, void* work) {
        for (std::size_t p = 0; p < parts; ++p) task(work, p, p % 3);
    };
    for (const raster::PatchForm surface : {raster::PatchForm::catmull, raster::PatchForm::diced}) {
        Settings settings = figure_settings(6);
        settings.surface = surface;
        FrameShape shape(scene, settings);
        shape.workers = 3;
        const std::size_t bytes = frame_bytes<hw::Depth16>(settings.machine, 128, shape);
        std::vector<Line> memory(bytes / 64 + 1);
        auto frame = carve<hw::Depth16>({memory[0].bytes, bytes}, settings.machine, 128, shape);
        frame.executor = {in_turn, nullptr, 3};
        FrameInputs in{scene, settings, {}};
        ASSERT_EQ(load_matrices(scene, settings, in.matrices), FrameStatus::ok);
        const FramePlan plan = make_plan(in);
        FrameCounts counts;
        EXPECT_EQ(allocations([&] { draw_frame(in, plan, frame, counts); }), 0);
        EXPECT_GT(counts.observer.samples, 50000u) << "something is drawn";
    }
}

TEST(Heap, AReplayAllocatesNothing) {
    Settings s;
    s.machine.xy_bits = 5;
    std::vector<hw::Depth16> depth(32 * 32, 1000);
    const hw::FrameStore<hw::Depth16> observer{5, depth, {}};
    MemoryLedger ledger;
    EXPECT_EQ(allocations([&] { ledger = replay_memory(observer, hw::MatrixWords{}, s, 3); }), 0);
    EXPECT_EQ(ledger.light.accesses, 1024u) << "something is replayed";
}

}  // namespace
}  // namespace umbra78::shadow
