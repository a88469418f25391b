// What the stages of the shadow room require, and what each says when it is not so: at each
// stage's entry, at both ends of a range and one beyond.
#include "shadow/ap120b/cost.hpp"
#include "shadow/ap120b/post_process.hpp"
#include "shadow/clocked/memory_replay.hpp"
#include "shadow/clocked/post_process.hpp"
#include "shadow/correct_form.hpp"
#include "shadow/filters/composite.hpp"
#include "shadow/filters/dequantize.hpp"
#include "shadow/filters/low_pass.hpp"
#include "shadow/post_process.hpp"
#include "tests/shadow/random_frames.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace umbra78::shadow {
namespace {

using hw::Depth16;
using hw::Depth32;
using test::OwnedStore;

// --- the maps' names ----------------------------------------------------------------------------

template <class Maps, class Store>
concept takes_stores_by_position = requires(Store s) { Maps{s, s}; };
template <class Maps, class Store>
concept takes_stores_by_name = requires(Store s) { Maps{.observer = s, .light = s}; };

using ReadOnly = hw::FrameStore<const Depth16>;
static_assert(!takes_stores_by_position<DepthMaps<Depth16>, ReadOnly>);
static_assert(takes_stores_by_name<DepthMaps<Depth16>, ReadOnly>);
static_assert(takes_stores_by_name<DepthMaps<Depth16>, hw::FrameStore<Depth16>>);

// --- passes over a frame ------------------------------------------------------------------------

// Everything that a pass is handed, right at first; a test breaks one thing.
struct Inputs {
    explicit Inputs(int xy_bits = 4)
        : observer(xy_bits), light(xy_bits), mask(observer.depth.size()),
          maps(test::maps_of(observer, light)) {
        s.machine.xy_bits = xy_bits;
        observer.store.clear(s.machine);
        light.store.clear(s.machine);
        matrix.word = {{{1 << 14, 0, 0, 0}, {0, 1 << 14, 0, 0}, {0, 0, 1 << 14, 0}, {0, 0, 0, 0}}};
    }
    Settings s;
    OwnedStore<Depth16> observer, light;
    std::vector<std::uint8_t> mask;
    DepthMaps<Depth16> maps;
    hw::MatrixWords matrix{};
};

TestedLights<Depth16> tested(Inputs& i) {
    TestedLights<Depth16> lights;
    lights[0].emplace(TestedLight<Depth16>{light_map(i.maps.light, i.s),
                                           hw::TransformUnit(i.s.machine, i.matrix), i.mask});
    return lights;
}

using Pass = std::function<void(Inputs&)>;
struct NamedPass {
    const char* name;
    Pass run;
    bool reads_light, writes_mask;
};

std::vector<NamedPass> passes() {
    static const auto rows = std::make_unique<RowMemory>();
    return {
        {"post_process", [](Inputs& i) { post_process(i.maps, i.matrix, i.s, i.mask); }, true,
         true},
        {"post_process_rows",
         [](Inputs& i) { post_process_rows(i.maps, i.matrix, i.s, *rows, i.mask); }, true, true},
        {"array_post_process",
         [](Inputs& i) { array_post_process(i.maps, {}, true, i.s, i.mask); }, true, true},
        {"clocked",
         [](Inputs& i) {
             std::make_unique<ClockedPostProcess<Depth16>>(i.maps, i.matrix, i.s, i.mask);
         },
         true, true},
        {"replay_memory", [](Inputs& i) { replay_memory(i.maps.observer, i.matrix, i.s, 3); },
         false, false},
        {"correct form",
         [](Inputs& i) {
             const TestedLights<Depth16> lights = tested(i);
             hw::FrameStore<Depth16> store = i.observer.store;
             store.xy_bits = i.maps.observer.xy_bits;
             store.depth = store.depth.first(i.maps.observer.depth.size());
             CorrectSink<Depth16>(store, lights, i.s, false);
         },
         true, true},
    };
}

void expect_trap(const NamedPass& pass, const char* why,
                 const std::function<void(Inputs&)>& spoil) {
    Inputs inputs;
    spoil(inputs);
    EXPECT_DEATH(pass.run(inputs), why) << pass.name;
}

TEST(Contract, EveryPassRunsAsItIs) {
    for (const NamedPass& pass : passes()) {
        Inputs inputs;
        pass.run(inputs);
        EXPECT_EQ(inputs.mask, std::vector<std::uint8_t>(256, mask_lit)) << pass.name;
    }
}

TEST(Contract, StoresHaveTheMachinesWidths) {
    const char* const observer = "the observer's store has other widths than the machine";
    const char* const light = "the light's store has other widths than the machine";
    for (const NamedPass& pass : passes()) {
        expect_trap(pass, observer, [](Inputs& i) { i.maps.observer.xy_bits = 5; });
        expect_trap(pass, observer, [](Inputs& i) {
            i.maps.observer.depth = i.maps.observer.depth.first(255);
        });
        expect_trap(pass, observer, [](Inputs& i) { i.s.machine.z_bits = 17; });
        if (!pass.reads_light) continue;
        expect_trap(pass, light, [](Inputs& i) { i.maps.light.xy_bits = 3; });
        expect_trap(pass, light, [](Inputs& i) {
            i.maps.light.depth = i.maps.light.depth.first(128);
        });
    }
}

TEST(Contract, TheMaskHasAByteAPixel) {
    for (const NamedPass& pass : passes()) {
        if (!pass.writes_mask) continue;
        for (const std::size_t bytes : {0, 255, 257})
            expect_trap(pass, "the mask has not one byte for each pixel",
                        [&](Inputs& i) { i.mask.resize(bytes); });
    }
}

// One beyond each end of each width.
TEST(Contract, TheMachinesWidthsAreInTheirRanges) {
    const char* const why = "a width of the machine is out of its range";
    const std::vector<std::function<void(hw::MachineSpec&)>> wrong{
        [](hw::MachineSpec& m) { m.xy_bits = 3; },
        [](hw::MachineSpec& m) { m.xy_bits = 13; },
        [](hw::MachineSpec& m) { m.z_bits = 3; },
        [](hw::MachineSpec& m) { m.z_bits = 27; },
        [](hw::MachineSpec& m) { m.coefficient_bits = 7; },
        [](hw::MachineSpec& m) { m.coefficient_bits = 33; },
        [](hw::MachineSpec& m) { m.fraction_bits = -1; },
        [](hw::MachineSpec& m) { m.fraction_bits = 13; },
        [](hw::MachineSpec& m) { m.multipliers = 2; },
        [](hw::MachineSpec& m) { m.max_accumulator_bits = 15; },
        [](hw::MachineSpec& m) { m.max_accumulator_bits = 65; },
    };
    const NamedPass plain = passes().front();
    for (std::size_t k = 0; k < wrong.size(); ++k) {
        SCOPED_TRACE(k);
        expect_trap(plain, why, [&](Inputs& i) { wrong[k](i.s.machine); });
    }
    for (const NamedPass& pass : passes())
        if (std::string(pass.name) != "correct form")  // its unit is made before it
            expect_trap(pass, why, [](Inputs& i) { i.s.machine.multipliers = 2; });
}

TEST(Contract, TheRowFormRunsWhatItCovers) {
    const NamedPass rows = passes()[1];
    const char* const why = "the row form does not cover these settings or this matrix";
    expect_trap(rows, why, [](Inputs& i) {
        i.matrix.affine = false;
        i.s.machine.divide_order = hw::DivideOrder::round_first;
    });
    expect_trap(rows, why, [](Inputs& i) { i.s.machine.fraction_bits = 8; });
    expect_trap(rows, why, [](Inputs& i) { i.s.machine.max_accumulator_bits = 34; });
    expect_trap(rows, why, [](Inputs& i) { i.matrix.exponent[1] = 31; });
}

// The receiver's plane and normal are the plain post-process's alone.
TEST(Contract, PlanesAreRefusedWhereNoNeighboursAreRead) {
    for (const Receiver receiver : {Receiver::plane, Receiver::normal}) {
        const auto wants = [receiver](Inputs& i) { i.s.receiver = receiver; };
        expect_trap(passes()[1], "the row form does not cover these settings", wants);
        expect_trap(passes()[2], "it takes no receiver's plane or normal", wants);
        expect_trap(passes()[3], "it has no stage for the receiver's plane or normal", wants);
        expect_trap(passes()[5], "has no neighbours for a plane", wants);
        Inputs inputs;
        wants(inputs);
        passes()[0].run(inputs);
        EXPECT_EQ(inputs.mask, std::vector<std::uint8_t>(256, mask_lit));
    }
    Inputs replayed;
    replayed.s.receiver = Receiver::normal;
    EXPECT_DEATH(replay_memory(replayed.maps.observer, replayed.matrix, replayed.s, 3),
                 "it moves no point along its normal");
}

TEST(Contract, TheAp120bsHostSendsSixteenBits) {
    OwnedStore<Depth32> observer(4), light(4);
    std::vector<std::uint8_t> mask(256);
    ShadowTest s;
    s.machine.xy_bits = 4;
    for (s.machine.z_bits = 15; s.machine.z_bits <= 16; ++s.machine.z_bits)
        array_post_process(test::maps_of(observer, light), {}, true, s, mask);
    ASSERT_EQ(s.machine.z_bits, 17);
    EXPECT_DEATH(array_post_process(test::maps_of(observer, light), {}, true, s, mask),
                 "its host sends Z codes of up to 16 bits");
    s.machine.z_bits = 16;
    for (const Lookup lookup : {Lookup::percentage, Lookup::filtered_depth}) {
        s.lookup = lookup;
        EXPECT_DEATH(array_post_process(test::maps_of(observer, light), {}, true, s, mask),
                     "it looks up one texel or four, no window");
    }
}

TEST(Contract, APicturesStoreHasIntensitiesAndDirectShares) {
    Inputs i;
    const TestedLights<Depth16> lights = tested(i);
    using Store = hw::FrameStore<Depth16>;
    for (const auto plane : {&Store::intensity, &Store::direct}) {
        Store without = i.observer.store;
        without.*plane = {};
        EXPECT_DEATH(CorrectSink<Depth16>(without, lights, i.s, false),
                     "the store has no intensities or direct shares");
        EXPECT_DEATH(raster::PictureSink<Depth16>{without},
                     "the store has no intensities or direct shares");
    }
}

// --- times --------------------------------------------------------------------------------------

TEST(Contract, ThePartsTimesAreInTheirRanges) {
    const std::vector<std::function<void(hw::Timing&)>> wrong{
        [](hw::Timing& t) { t.clock_ns = 99; },     [](hw::Timing& t) { t.multiply_ns = 0; },
        [](hw::Timing& t) { t.multiply_ns = 401; }, [](hw::Timing& t) { t.add_ns = 0; },
        [](hw::Timing& t) { t.add_ns = 151; },      [](hw::Timing& t) { t.register_ns = -1; },
        [](hw::Timing& t) { t.register_ns = 41; },  [](hw::Timing& t) { t.noise_bits = 0; },
        [](hw::Timing& t) { t.light_banks = 2; },   [](hw::Timing& t) { t.light_banks = 5; },
    };
    for (std::size_t k = 0; k < wrong.size(); ++k) {
        SCOPED_TRACE(k);
        Inputs i;
        wrong[k](i.s.timing);
        EXPECT_DEATH(PostProcessPipeline(i.s, i.matrix), "a part's time is out of its range");
        EXPECT_DEATH(replay_memory(i.maps.observer, i.matrix, i.s, 3),
                     "a part's time is out of its range");
    }
    Inputs i;
    EXPECT_DEATH(replay_memory(i.maps.observer, i.matrix, i.s, 0),
                 "a visible pixel takes a clock or more");
    EXPECT_DEATH(schedule<Depth16>(i.observer.depth, 65535, 0, 3), "a cycle or more");
    EXPECT_DEATH(schedule<Depth16>(i.observer.depth, 65535, 1, 0), "a cycle or more");
}

// --- filters ------------------------------------------------------------------------------------

// A frame for a filter, and memory for the dequantizing.
struct FilterInputs {
    explicit FilterInputs(int bits = 4)
        : observer(bits), mask(observer.depth.size()), out(mask.size()),
          visited(edge_visited_words(bits)), coverage(edge_coverage_words(bits)) {}
    EdgeMemory memory() { return {visited, coverage}; }
    void low_pass_here() { low_pass<Depth16>(mask, observer.store, 65535, out); }
    void dequantize_here(int passes = 1) {
        dequantize<Depth16>(mask, observer.store, 65535, passes, memory(), out);
    }
    OwnedStore<Depth16> observer;
    std::vector<std::uint8_t> mask, out;
    std::vector<std::uint32_t> visited;
    std::vector<std::int16_t> coverage;
};

TEST(FilterContract, PlanesHaveAByteAPixel) {
    const auto both_trap = [](const char* why, const std::function<void(FilterInputs&)>& spoil) {
        FilterInputs i;
        spoil(i);
        EXPECT_DEATH(i.low_pass_here(), why);
        EXPECT_DEATH(i.dequantize_here(), why);
    };
    const char* const planes = "the mask or the result has not one byte for each pixel";
    for (const std::size_t bytes : {0, 255, 257}) {
        both_trap(planes, [&](FilterInputs& i) { i.mask.resize(bytes); });
        both_trap(planes, [&](FilterInputs& i) { i.out.resize(bytes); });
    }
    both_trap("the observer's store has not one word for each pixel", [](FilterInputs& i) {
        i.observer.store.depth = i.observer.store.depth.first(255);
    });
    for (const int bits : {-1, 3, 13, 40})
        both_trap("a frame has 16 to 4096 pixels a side",
                  [&](FilterInputs& i) { i.observer.store.xy_bits = bits; });
    FilterInputs i;
    i.low_pass_here();
    i.dequantize_here();
}

TEST(FilterContract, PassesAreZeroToSix) {
    FilterInputs i;
    std::fill(i.mask.begin() + 100, i.mask.begin() + 110, std::uint8_t{255});
    for (const int passes : {0, 6}) i.dequantize_here(passes);
    for (const int passes : {-1, 7, 1 << 20})
        EXPECT_DEATH(i.dequantize_here(passes), "0 to 6 passes") << passes;
}

TEST(FilterContract, DequantizingHasItsMemory) {
    const char* const why = "its memory is too small for the frame";
    for (int bits = 4; bits <= 7; ++bits) {
        FilterInputs i(bits);
        const std::size_t pixels = i.mask.size(), side = std::size_t{1} << bits;
        EXPECT_EQ(i.visited.size(), pixels / 32);
        EXPECT_EQ(i.coverage.size(), (side + 2) * side);
        i.visited.resize(pixels / 32 - 1);
        EXPECT_DEATH(i.dequantize_here(), why);
        i.visited.resize(pixels / 32 + 1, 0x5a5a5a5a);
        i.coverage.resize((side + 2) * side - 1);
        EXPECT_DEATH(i.dequantize_here(), why);
        i.coverage.resize((side + 2) * side + 1, 77);
        i.dequantize_here();  // larger is allowed, and what is not needed stays as it is
        EXPECT_EQ(i.visited.back(), 0x5a5a5a5au);
        EXPECT_EQ(i.coverage.back(), 77);
    }
}

// The low-pass reads a pixel's neighbours after it is written, so its planes lie apart; they may
// lie side by side.
TEST(FilterContract, TheLowPassesPlanesLieApart) {
    OwnedStore<Depth16> observer(4);
    std::vector<std::uint8_t> bytes(1024);
    const std::span<std::uint8_t> all(bytes);
    const auto run = [&](std::size_t from, std::size_t to) {
        low_pass<Depth16>(all.subspan(from, 256), observer.store, 65535, all.subspan(to, 256));
    };
    run(0, 256);
    run(256, 0);
    for (const std::size_t to : {256, 257, 511, 255, 1})
        EXPECT_DEATH(run(256, to), "the mask and the result overlap") << to;
}

TEST(FilterContract, TheCompositesPlanesAndDensity) {
    std::vector<std::uint8_t> level(16), share(16), mask(16), out(16);
    for (const int density : {0, 256}) composite(level, share, mask, density, out);
    for (const int density : {-1, 257})
        EXPECT_DEATH(composite(level, share, mask, density, out), "density is 0..256") << density;
    for (std::vector<std::uint8_t>* const plane : {&level, &share, &mask, &out})
        for (const std::size_t size : {15u, 17u}) {
            plane->resize(size);
            EXPECT_DEATH(composite(level, share, mask, 128, out),
                         "picture, share, mask and result have different sizes");
            plane->resize(16);
        }
}

}  // namespace
}  // namespace umbra78::shadow
