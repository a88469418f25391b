// A scene with a [stream] has the views, the words and the frame of the same scene held.
#include "tools/scene/scene.hpp"

#include "shadow/frame/stream.hpp"
#include "tests/support/batches.hpp"
#include "tools/stream/hills.hpp"

#include <gtest/gtest.h>

namespace umbra78::tools {
namespace {

// Patches that are held, as a stream: with no file, so that the reading itself is tested.
class HeldStream final : public PrimitiveStream {
public:
    HeldStream(std::span<const raster::Patch> patches, bool can_rewind)
        : patches_(patches.begin(), patches.end()), can_rewind_(can_rewind) {}

    std::span<const raster::Material> materials() const override { return materials_; }
    std::uint64_t count() const override { return patches_.size(); }
    bool can_rewind() const override { return can_rewind_; }
    std::string_view name() const override { return "a.u78p"; }
    const std::string& error() const override { return error_; }
    std::uint64_t hash() const override { return 0; }
    bool rewind() override {
        at_ = 0;
        ++passes;
        return true;
    }
    Next next(raster::Surfaces& batch) override {
        if (at_ == patches_.size()) return Next::end;
        moved_ = patches_[at_++];
        for (raster::World& p : moved_.control)
            p = {p.x - origin_.x, p.y - origin_.y, p.z - origin_.z};
        batch = std::span<const raster::Patch>(&moved_, 1);
        return Next::batch;
    }

    int passes = 0;

private:
    std::vector<raster::Patch> patches_;
    bool can_rewind_;
    std::array<raster::Material, 1> materials_{};
    std::string error_;
    std::size_t at_ = 0;
    raster::Patch moved_;
};

const std::string solids = "[[sphere]]\ncentre = [3, 1, -2]\nradius = 1.5\n"
                           "[[torus]]\ncentre = [-4, 0, 2.25]\nradius = 2\ntube = 0.5\n"
                           "[[plane]]\norigin = [-9, -2, 9]\nu = [18, 0, 0]\nv = [0, 0, -18]\n";

struct Opened {
    SceneResult result;
    HeldStream* stream = nullptr;
};

// The views with the solids as a stream.
Opened streamed(const std::string& views, bool can_rewind = true,
                const std::string& more = "") {
    const SceneResult made = read_scene(solids + "[light]\nazimuth = 0\n[observer]\n"
                                                 "recentre = \"off\"\n", "held.toml", {});
    EXPECT_TRUE(made.ok()) << made.error;
    Opened opened;
    opened.result = read_scene(
        views + "[stream]\nfile = \"a.u78p\"\n" + more, "a.toml", {}, {},
        [&](const std::string& path) {
            EXPECT_EQ(path, "a.u78p");
            auto stream = std::make_unique<HeldStream>(made.scene.patches, can_rewind);
            opened.stream = stream.get();
            return OpenedStream{std::move(stream), ""};
        });
    return opened;
}

void expect_same_view(const raster::View& a, const raster::View& b) {
    EXPECT_EQ(a.target, b.target);
    EXPECT_EQ(a.extent, b.extent);
    EXPECT_EQ(a.distance, b.distance);
    EXPECT_EQ(a.near_depth, b.near_depth);
    EXPECT_EQ(a.far_depth, b.far_depth);
    EXPECT_EQ(a.axes.right, b.axes.right);
    EXPECT_EQ(a.axes.back, b.axes.back);
}

const std::string orthographic = "[observer]\nazimuth = 30\nelevation = 20\n"
                                 "[light]\nazimuth = -100\nelevation = 35\n";
const std::string perspective = "[observer]\nprojection = \"perspective\"\ndistance = 20\n"
                                "azimuth = 30\nelevation = 20\n"
                                "[light]\nkind = \"point\"\nposition = [-9, 12, 7]\n";
const std::string given = "[observer]\nazimuth = 30\ntarget = [1, 0, 0]\nextent = 9\nnear = -20\n"
                          "far = 20\n[light]\nazimuth = -100\ntarget = [0, 0, 0]\nextent = 12\n"
                          "near = -20\nfar = 20\n";

TEST(StreamScene, ViewsAreFittedAsThoseOfTheSameSceneHeld) {
    const std::string targets = "target = [100, 0.5, -3]\n";
    for (const std::string& views :
         {orthographic, perspective, given, orthographic + targets,
          "[observer]\nrecentre = \"off\"\n" + orthographic.substr(11)}) {
        SCOPED_TRACE(views);
        const SceneResult held = read_scene(solids + views, "a.toml", {});
        ASSERT_TRUE(held.ok()) << held.error;
        const Opened got = streamed(views);
        ASSERT_TRUE(got.result.ok()) << got.result.error;
        const LoadedScene& scene = got.result.scene;
        expect_same_view(held.scene.observer, scene.observer);
        expect_same_view(held.scene.light(), scene.light());
        EXPECT_EQ(held.scene.origin, scene.origin);
        shadow::FrameMatrices a, b;
        EXPECT_EQ(shadow::load_matrices(held.scene.view(), held.scene.settings, a),
                  shadow::FrameStatus::ok);
        EXPECT_EQ(shadow::load_matrices(scene.view(), scene.settings, b), shadow::FrameStatus::ok);
        EXPECT_EQ(a.object.fraction, b.object.fraction);
        EXPECT_EQ(a.lights[0].observer_to_light.word, b.lights[0].observer_to_light.word);
    }
}

// A file is gone through once before it is drawn; more often only for what follows from the first.
TEST(StreamScene, PassesOverTheFile) {
    EXPECT_EQ(streamed(orthographic).stream->passes, 1);
    EXPECT_EQ(streamed(given).stream->passes, 1) << "for the largest coordinate";
    EXPECT_EQ(streamed(given, true, "largest = 12\n").stream->passes, 0);
    EXPECT_EQ(streamed(perspective).stream->passes, 4);
}

TEST(StreamScene, WhatCannotBeReadTwiceNeedsItsViews) {
    const auto needs = [](const std::string& keys) {
        return "a.u78p cannot be read twice, so the scene needs " + keys +
               "; give all of them, or --spool";
    };
    EXPECT_EQ(streamed(orthographic, false).result.error,
              needs("stream.largest, observer.target, observer.extent, observer.near, "
                    "observer.far, light.target, light.extent, light.near, light.far"));
    EXPECT_EQ(streamed(given, false).result.error, needs("stream.largest"));
    const std::string largest = "largest = 12\n";
    for (const std::string key : {"target = [1, 0, 0]\n", "extent = 12\n", "far = 20\n"}) {
        std::string views = given;
        views.erase(views.rfind(key), key.size());
        const std::string table = key == "target = [1, 0, 0]\n" ? "observer." : "light.";
        EXPECT_EQ(streamed(views, false, largest).result.error,
                  needs(table + key.substr(0, key.find(' '))));
    }
    EXPECT_TRUE(streamed(given, false, largest).result.ok());
}

// What is promised decides the words; what is fitted is fitted to the points.
TEST(StreamScene, ALargestCoordinateMovesNoView) {
    for (std::string views : {given, orthographic, perspective}) {
        if (views == given) views.erase(views.find("target = [1, 0, 0]\n"), 19);
        const Opened plain = streamed(views);
        const Opened promised = streamed(views, true, "largest = 15.5\n");
        ASSERT_TRUE(plain.result.ok() && promised.result.ok()) << promised.result.error;
        expect_same_view(plain.result.scene.observer, promised.result.scene.observer);
        expect_same_view(plain.result.scene.light(), promised.result.scene.light());
        EXPECT_LT(plain.result.scene.largest, promised.result.scene.largest);
    }
}

TEST(StreamScene, OwnSurfacesComeFirst) {
    const Opened got = streamed("[[sphere]]\ncentre = [99, 0, 0]\nradius = 1\n" + orthographic);
    ASSERT_TRUE(got.result.ok()) << got.result.error;
    const LoadedScene& scene = got.result.scene;
    EXPECT_EQ(scene.patches.size(), 32u);
    EXPECT_GT(scene.observer.extent, 40 << 16) << "the sphere lies in the fitted view";
    EXPECT_EQ(scene.materials.size(), 2u);
    EXPECT_FALSE(scene.has_closed_form());
    EXPECT_TRUE(scene.view().streamed);
}

TEST(StreamScene, ErrorsAreLines) {
    EXPECT_EQ(read_scene(given + "[stream]\nfile = \"a.u78p\"\n", "a.toml", {}).error,
              "a.toml:13: a scene with a [stream] is drawn by umbra78 render alone; give this "
              "command the scene that the file was packed from");
    const auto refuse = [](const std::string&) { return OpenedStream{nullptr, "it is torn"}; };
    EXPECT_EQ(read_scene(given + "[stream]\nfile = \"a.u78p\"\n", "a.toml", {}, {}, refuse).error,
              "a.toml:14: 'file' in [stream]: it is torn");
    EXPECT_EQ(read_scene(given + "[stream]\nfile = \"\"\n", "a.toml", {}, {}, refuse).error,
              "a.toml:14: 'file' in [stream] is empty; give a path, or \"-\"");
    EXPECT_EQ(read_scene(given + "[stream]\nlargest = 3\n", "a.toml", {}, {}, refuse).error,
              "a.toml:13: [stream] has no 'file'; add file = \"hills.u78p\"");
}

}  // namespace
}  // namespace umbra78::tools
