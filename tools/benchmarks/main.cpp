// umbra78_bench: the stages of figure 6 and the float baseline, as ratios in one run.
//
// Google Benchmark interleaves the repetitions at random, so that a noisy machine slows all rows
// alike; what counts is the last column, a stage's median over the affine float baseline's.

#include "shadow/ap120b/post_process.hpp"
#include "shadow/clocked/memory_replay.hpp"
#include "shadow/correct_form.hpp"
#include "shadow/frame/frame.hpp"
#include "shadow/frame/ledger.hpp"
#include "shadow/frame/paper_figures.hpp"
#include "shadow/row_form.hpp"
#include "tools/benchmarks/float_baseline.hpp"
#include "tools/benchmarks/curves.hpp"
#include "tools/benchmarks/frames.hpp"
#include "tools/benchmarks/ratio_reporter.hpp"
#include "tools/benchmarks/workers.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace umbra78;
using hw::Depth16;

constexpr const char* baseline_name = "float post-process, affine";

// The figures' scene, drawn once; every benchmark runs one stage of it again.
struct Bench {
    shadow::FigurePatches patches = shadow::figure_patches();
    raster::Material material = shadow::figure_material;
    shadow::Scene scene{patches,
                        {&material, 1},
                        shadow::figure_view(0),
                        {{shadow::figure_view(shadow::figure_azimuth_q16)}}};
    std::vector<std::byte> memory;
    shadow::FrameBuffers<Depth16> frame;
    shadow::FrameMatrices matrices;
    shadow::FrameCounts counts;
    shadow::FramePlan plan;
    tools::FloatMatrix floats{};

    explicit Bench(const shadow::Settings& settings)
        : memory(shadow::frame_bytes<Depth16>(settings.machine, patches.size()) + 64) {
        void* at = memory.data();
        std::size_t space = memory.size();
        auto* aligned = static_cast<std::byte*>(std::align(64, space - 64, at, space));
        frame = shadow::carve<Depth16>({aligned, space}, settings.machine, patches.size());
        shadow::render(scene, settings, frame, matrices, counts);
        plan = shadow::make_plan(inputs(settings));
        make_float_matrix(static_cast<double>(settings.bias_q16) / 65536);
    }
    shadow::FrameInputs inputs(const shadow::Settings& settings) const {
        return {scene, settings, matrices};
    }

    hw::ap120b::Matrix array(shadow::Settings settings) const {
        settings.arithmetic = shadow::Arithmetic::ap120b;
        shadow::FrameMatrices words;
        shadow::load_matrices(scene, settings, words);
        return words.lights[0].array;
    }

    // The same turn about the vertical axis, on pixel coordinates and Z codes of both frames.
    void make_float_matrix(double bias) {
        const double angle = -100 * std::numbers::pi / 180;
        const double c = std::cos(angle), s = std::sin(angle);
        const auto row = [&](std::size_t r, double x, double y, double z, double t) {
            floats.m[r] = {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z),
                           static_cast<float>(t)};
        };
        row(0, c, 0, s / 128, 256 - 256 * c - 256 * s);
        row(1, 0, 1, 0, 0);
        row(2, -128 * s, 0, c, 32768 - 32768 * c + 128 * 256 * s - bias);
        row(3, 0, 0, 0, 1);
    }
};

Bench& bench_of(int figure) {
    static std::map<int, std::unique_ptr<Bench>> all;
    auto& b = all[figure];
    if (!b) b = std::make_unique<Bench>(shadow::figure_settings(figure));
    return *b;
}

std::vector<std::string> names;  // in the order of the frame; the runs are in any order

template <class Stage>
void add(const std::string& name, int figure, Stage&& stage) {
    names.push_back(name);
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
        Bench& b = bench_of(figure);
        const shadow::Settings settings = shadow::figure_settings(figure);
        for (auto _ : state) {
            stage(b, settings);
            benchmark::ClobberMemory();
        }
    })->Unit(benchmark::kMillisecond);
}

shadow::PostProcessLedger pass_ledger(const Bench& b, const shadow::Settings& s) {
    const shadow::PostProcessPipeline plan(s, b.matrices.lights[0].observer_to_light);
    return shadow::closed_form(
        shadow::schedule<Depth16>(b.frame.observer.depth, s.machine.background(),
                                  plan.read_cycles, plan.slot_cycles),
        plan);
}

// Reports the simulated cycles a second, too.
void add_clocked(const std::string& name, int figure) {
    names.push_back(name);
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
        Bench& b = bench_of(figure);
        using Machine = shadow::ClockedPostProcess<Depth16>;
        std::uint64_t cycles = 0;
        for (auto _ : state) {
            Machine machine(b.frame.maps(), b.matrices.lights[0].observer_to_light,
                            shadow::figure_settings(figure), b.frame.lights[0].mask);
            machine.run();
            cycles += machine.cycles();
        }
        state.counters["cycles"] = benchmark::Counter(static_cast<double>(cycles),
                                                      benchmark::Counter::kIsRate);
    })->Unit(benchmark::kMillisecond);
}

// Figure 3's; or the same results, each divided by W, which is what perspective costs.
hw::MatrixWords matrix_of(const Bench& b, bool divides) {
    hw::MatrixWords m = b.matrices.lights[0].observer_to_light;
    m.affine = !divides;
    return m;
}

// The row forms that this processor has, on figure 3's frame: each lookup and dither.
void add_row_forms() {
    struct Case {
        const char* name;
        shadow::Lookup lookup;
        hw::DitherShape dither;
        bool divides = false;
        int taps = 3;
    };
    using hw::DitherShape;
    for (const Case& c : {Case{"nearest", shadow::Lookup::nearest, DitherShape::none},
                          Case{"bilinear", shadow::Lookup::bilinear, DitherShape::none},
                          Case{"nearest, normal4", shadow::Lookup::nearest, DitherShape::normal4},
                          Case{"bilinear, normal", shadow::Lookup::bilinear,
                               DitherShape::normal},
                          Case{"percentage closer 3 x 3", shadow::Lookup::percentage,
                               DitherShape::none},
                          Case{"percentage closer 5 x 5", shadow::Lookup::percentage,
                               DitherShape::none, false, 5},
                          Case{"filtered depth 3 x 3", shadow::Lookup::filtered_depth,
                               DitherShape::none},
                          Case{"nearest, in perspective", shadow::Lookup::nearest,
                               DitherShape::none, true}})
        for (const shadow::RowForm& form : shadow::row_forms()) {
            if (!form.supported()) continue;
            add(fmt::format("rows, {}: {}", c.name, form.name), 3,
                [c, &form](Bench& b, shadow::Settings s) {
                    s.lookup = c.lookup;
                    s.dither.shape = c.dither;
                    s.taps = c.taps;
                    shadow::post_process_rows(b.frame.maps(), matrix_of(b, c.divides), s,
                                              *b.frame.rows, b.frame.lights[0].mask, form);
                });
        }
    add("post-process, percentage closer 3 x 3, plain form", 3,
        [](Bench& b, shadow::Settings s) {
            s.lookup = shadow::Lookup::percentage;
            shadow::post_process(b.frame.maps(), matrix_of(b, false), s, b.frame.lights[0].mask);
        });
    add("post-process, in perspective, plain form", 3, [](Bench& b, const shadow::Settings& s) {
        shadow::post_process(b.frame.maps(), matrix_of(b, true), s, b.frame.lights[0].mask);
    });
}

void add_all() {
    using shadow::Settings;
    for (const bool affine : {true, false})
        add(affine ? baseline_name : "float post-process, with division", 3,
            [=](Bench& b, const Settings&) {
                tools::float_post_process(b.frame.observer.depth, b.frame.lights[0].map.depth, 512,
                                          b.floats, affine, b.frame.picture);
            });
    const auto cast = [](Bench& b, const Settings& s) {
        shadow::cast_shadows(b.inputs(s), b.plan, b.frame, b.counts);
    };
    add("post-process, figure 3 (nearest)", 3, cast);
    add("post-process, figure 4 (bilinear, dither)", 4, cast);
    add("post-process, figure 3, plain form", 3, [](Bench& b, const Settings& s) {
        shadow::post_process(b.frame.maps(), b.matrices.lights[0].observer_to_light, s,
                             b.frame.lights[0].mask);
    });
    add_row_forms();
    // The ledger of the pass as the functional machine gets it: one scan of the observer's Z.
    add("post-process, figure 3, with its ledger", 3, [](Bench& b, const Settings& s) {
        shadow::cast_shadows(b.inputs(s), b.plan, b.frame, b.counts);
        benchmark::DoNotOptimize(pass_ledger(b, s));
    });
    for (const int figure : {3, 4})
        add_clocked(fmt::format("post-process, figure {}, clocked", figure), figure);
    add("memory replay, figure 4", 4, [](Bench& b, const Settings& s) {
        benchmark::DoNotOptimize(shadow::replay_memory(
            b.frame.observer, b.matrices.lights[0].observer_to_light, s, 4));
    });
    add("post-process, figure 3, AP-120B", 3, [](Bench& b, const Settings& s) {
        shadow::array_post_process(b.frame.maps(), b.array(s), true, s,
                                   b.frame.lights[0].mask);
    });
    add("matrices", 6, [](Bench& b, const Settings& s) {
        shadow::load_matrices(b.scene, s, b.matrices);
    });
    add("plan", 6, [](Bench& b, const Settings& s) {
        b.plan = shadow::make_plan(b.inputs(s));
    });
    add("light's view", 6, [](Bench& b, const Settings& s) {
        shadow::draw_light(b.inputs(s), b.plan, b.frame, b.counts);
    });
    add("observer's view", 6, [](Bench& b, const Settings& s) {
        shadow::draw_observer(b.inputs(s), b.plan, b.frame, b.counts);
    });
    add("filters and composite, figure 6", 6, [](Bench& b, const Settings& s) {
        shadow::filter_and_composite(b.inputs(s), b.plan, b.frame, b.counts);
    });
    add("figure 6, whole frame", 6, [](Bench& b, const Settings& s) {
        shadow::render(b.scene, s, b.frame, b.matrices, b.counts);
    });
    add("figure 6, whole frame, with its ledger", 6, [](Bench& b, const Settings& s) {
        shadow::render(b.scene, s, b.frame, b.matrices, b.counts);
        benchmark::DoNotOptimize(pass_ledger(b, s));
    });
}

// Figure 6's frame in a changed scene, by its plan and with one omission put back: what the plan
// saves the host. Empty scan lines are not among them: the row form of the test always skips them.
struct OmissionCase {
    const char* name;
    shadow::Omission omission;
    void (*change)(Bench&, shadow::Settings&);
};

void see_half(Bench& b, shadow::Settings&) {
    b.scene.observer.target.x = 3 << 15;
    b.scene.lights[0].target.x = 3 << 15;
}

void add_omissions() {
    using shadow::Omission;
    static const OmissionCase cases[] = {
        {"light sees what the observer sees", Omission::light_drawing,
         [](Bench& b, shadow::Settings&) { b.scene.lights[0] = b.scene.observer; }},
        {"half of the patches outside", Omission::outside_surfaces, see_half},
        {"half of the patches outside, diced", Omission::outside_surfaces,
         [](Bench& b, shadow::Settings& s) {
             see_half(b, s);
             s.surface = raster::PatchForm::diced;
         }},
        {"lit scan lines, some", Omission::lit_lines,
         [](Bench& b, shadow::Settings&) { b.scene.patches = b.scene.patches.first(64); }},
        {"lit scan lines, all", Omission::lit_lines,
         [](Bench& b, shadow::Settings& s) {
             b.scene.patches = b.scene.patches.first(32);
             s.bias_q16 = 16384 << 16;
         }},
    };
    for (const OmissionCase& c : cases) {
        for (const bool put_back : {false, true}) {
            const std::string name = fmt::format("{}: {}", c.name, put_back ? "done" : "left out");
            names.push_back(name);
            benchmark::RegisterBenchmark(name.c_str(), [&c, put_back](benchmark::State& state) {
                shadow::Settings s = shadow::figure_settings(6);
                Bench b(s);
                c.change(b, s);
                shadow::load_matrices(b.scene, s, b.matrices);
                shadow::FramePlan plan = shadow::make_plan(b.inputs(s));
                if (put_back) plan.at(c.omission).left_out = false;
                for (auto _ : state) {
                    shadow::draw_frame(b.inputs(s), plan, b.frame, b.counts);
                    benchmark::ClobberMemory();
                }
            })->Unit(benchmark::kMillisecond);
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    const std::string mode = argc > 1 ? argv[1] : "";
    const char* csv = std::getenv("UMBRA78_BENCH_CSV");  // set by tools/bench
    const std::string csv_file = csv == nullptr ? "" : csv;
    if (mode == "--threads") return tools::compare_workers(argc > 2 ? std::atoi(argv[2]) : 2, 40);
    if (mode == "--curves")
        return tools::measure_curves(argc > 2 ? std::atoi(argv[2]) : 6, csv_file);
    std::vector<std::string> defaults{argv[0], "--benchmark_repetitions=15",
                                      "--benchmark_enable_random_interleaving=true",
                                      "--benchmark_report_aggregates_only=true",
                                      "--benchmark_min_time=0.02"};
    std::vector<char*> args;
    for (std::string& s : defaults) args.push_back(s.data());
    for (int k = 1; k < argc; ++k) args.push_back(argv[k]);
    int count = static_cast<int>(args.size());
    benchmark::Initialize(&count, args.data());
    if (benchmark::ReportUnrecognizedArguments(count, args.data())) return 2;
    add_all();
    add_omissions();
    tools::add_frames(names);
    tools::RatioReporter reporter(names, baseline_name, csv_file);
    benchmark::RunSpecifiedBenchmarks(&reporter);
    benchmark::Shutdown();
}
