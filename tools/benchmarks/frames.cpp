#include "tools/benchmarks/frames.hpp"

#include "shadow/filters/dequantize.hpp"
#include "shadow/filters/low_pass.hpp"
#include "tools/benchmarks/drawn_frame.hpp"
#include "tools/benchmarks/float_frame.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace umbra78::tools {
namespace {

using hw::Depth16;

template <class Make>
auto& made(const std::string& key, Make&& make) {
    using Made = decltype(make());
    static std::map<std::string, Made> all;
    const auto found = all.find(key);
    return *(found != all.end() ? found->second : all.emplace(key, make()).first->second);
}

const SphereMesh& mesh_of(int rings) {
    return made(fmt::format("{}", rings), [&] { return std::make_unique<SphereMesh>(rings); });
}

// What the float frame does: one side, no highlight, the bare test.
std::unique_ptr<DrawnFrame> make_triangles(int rings, std::size_t workers) {
    shadow::Settings s = shadow::figure_settings(3);
    s.facing = raster::Facing::front;
    s.shading = raster::ShadingRule::lambert;
    s.bias_q16 = 400 << 16;
    return std::make_unique<DrawnFrame>(s, std::span<const raster::Patch>(),
                                        mesh_of(rings).mesh(), workers);
}
DrawnFrame& triangles(int rings) {
    return made(fmt::format("{}", rings), [&] { return make_triangles(rings, 1); });
}

std::unique_ptr<DrawnFrame> make_figure6(raster::Sampling sampling, std::size_t workers) {
    static const shadow::FigurePatches patches = shadow::figure_patches();
    shadow::Settings s = shadow::figure_settings(6);
    s.sampling = sampling;
    return std::make_unique<DrawnFrame>(s, patches, raster::Mesh{}, workers);
}
DrawnFrame& figure6(raster::Sampling sampling) {
    return made(sampling == raster::Sampling::leaf ? "leaf" : "centre",
                [&] { return make_figure6(sampling, 1); });
}

// Figure 6 with the list of what its observer sees: its view is shaded from that.
struct ListedFrame {
    std::unique_ptr<DrawnFrame> drawn = make_figure6(raster::Sampling::centre, 1);
    std::vector<raster::VisibleBlock> blocks =
        std::vector<raster::VisibleBlock>(raster::VisibleList::blocks_for(drawn->frame.pixels()));
    raster::VisibleList list{blocks};

    ListedFrame() {
        drawn->frame.visible = &list;
        drawn->plan.at(shadow::Omission::same_depth).left_out = true;
    }
    void draw_observer() {
        shadow::draw_observer(drawn->inputs(), drawn->plan, drawn->frame, drawn->counts);
    }
};

template <class Stage>
void add(std::vector<std::string>& names, const std::string& name, Stage&& stage) {
    names.push_back(name);
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
        for (auto _ : state) {
            stage();
            benchmark::ClobberMemory();
        }
    })->Unit(benchmark::kMillisecond);
}

void add_stages(std::vector<std::string>& names, const std::string& what,
                DrawnFrame& (*made_of)(int), int value) {
    add(names, what + ", light's view", [=] {
        DrawnFrame& f = made_of(value);
        shadow::draw_light(f.inputs(), f.plan, f.frame, f.counts);
    });
    add(names, what + ", observer's view", [=] {
        DrawnFrame& f = made_of(value);
        shadow::draw_observer(f.inputs(), f.plan, f.frame, f.counts);
    });
    add(names, what + ", whole frame", [=] { made_of(value).draw(); });
}

}  // namespace

std::vector<std::pair<std::string, std::unique_ptr<DrawnFrame>>> benchmark_frames(
    std::size_t workers) {
    std::vector<std::pair<std::string, std::unique_ptr<DrawnFrame>>> all;
    all.emplace_back("figure 6 by centres", make_figure6(raster::Sampling::centre, workers));
    all.emplace_back("figure 6 by leaves", make_figure6(raster::Sampling::leaf, workers));
    for (const int rings : {12, 44, 178})
        all.emplace_back(fmt::format("{} triangles", 16 * rings * (rings - 1)),
                         make_triangles(rings, workers));
    return all;
}

void add_frames(std::vector<std::string>& names) {
    for (const int rings : {12, 44, 178}) {  // four spheres of 4 rings (rings - 1) triangles
        const std::string what = fmt::format("{} triangles", 16 * rings * (rings - 1));
        add(names, what + ", float frame", [=] {
            made(fmt::format("{}", rings), [&] {
                return std::make_unique<FloatFrame>(mesh_of(rings));
            }).draw();
        });
        add_stages(names, what, triangles, rings);
    }
    const auto figure = [](int leaf) -> DrawnFrame& {
        return figure6(leaf != 0 ? raster::Sampling::leaf : raster::Sampling::centre);
    };
    add_stages(names, "figure 6 by centres", figure, 0);
    add_stages(names, "figure 6 by leaves", figure, 1);
    add(names, "figure 6 by centres, observer's view, the light turned", [=] {
        made("listed", [&] { return std::make_unique<ListedFrame>(); }).draw_observer();
    });
    add(names, "low-pass, one pass", [=] {
        DrawnFrame& f = figure(0);
        shadow::low_pass<Depth16>(f.frame.lights[0].joined, f.frame.observer,
                                  static_cast<Depth16>(f.settings.machine.background()),
                                  f.frame.picture_of(0));
    });
    add(names, "dequantizing, four passes", [=] {
        DrawnFrame& f = figure(0);
        shadow::dequantize<Depth16>(f.frame.lights[0].joined, f.frame.observer,
                                    static_cast<Depth16>(f.settings.machine.background()), 4,
                                    f.frame.edge_memory, f.frame.lights[0].edges);
    });
}

}  // namespace umbra78::tools
