// RenderJob: other settings and other scenes in one frame's memory. What does not fit it is
// refused with one line, and a refusal leaves the job as it was.
#include "tools/render/render_job.hpp"

#include "shadow/frame/paper_figures.hpp"
#include "tests/support/error_of.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace umbra78::tools {
namespace {

using test::error_of;

// The figures' scene on 64 x 64 pixels.
struct SmallScene {
    std::vector<raster::Patch> patches;
    raster::Material material = shadow::figure_material;
    raster::View observer = shadow::figure_view(0);
    raster::View light = shadow::figure_view(shadow::figure_azimuth_q16);
    shadow::Settings settings = shadow::figure_settings(6);

    SmallScene() {
        const shadow::FigurePatches all = shadow::figure_patches();
        patches.assign(all.begin(), all.end());
        settings.machine.xy_bits = 6;
    }
    shadow::Scene view() const { return {patches, {&material, 1}, observer, {{light}}}; }
};

std::vector<std::string> hashes(const RenderJob& job) {
    std::vector<std::string> all;
    for (const PlaneOf& plane : job.planes()) all.push_back(hash_of(job.buffer(plane)));
    return all;
}

// Every plane of the frame that these settings give.
std::vector<std::string> hashes_of(const SmallScene& scene, const shadow::Settings& settings) {
    RenderJob job(scene.view(), settings);
    job.render();
    return hashes(job);
}

// The job still draws its own frame.
void expect_as_it_was(RenderJob& job, const SmallScene& scene) {
    for (const shadow::Setting& s : shadow::settings_table())
        EXPECT_EQ(s.get(job.settings()), s.get(scene.settings)) << s.key;
    job.render();
    EXPECT_EQ(hashes(job), hashes_of(scene, scene.settings));
}

TEST(RenderJob, OtherWidthsAreRefused) {
    const SmallScene scene;
    RenderJob job(scene.view(), scene.settings);
    shadow::Settings wider = scene.settings;
    wider.machine.xy_bits = 9;
    EXPECT_EQ(error_of([&] { job.use(wider); }),
              "this frame was made for xy_bits 6 and z_bits 16: for 9 and 16 make another");
    EXPECT_EQ(error_of([&] { job.advance(scene.view(), wider); }),
              "this frame was made for xy_bits 6 and z_bits 16: for 9 and 16 make another");
    for (const int z_bits : {15, 17, 24}) {
        shadow::Settings deeper = scene.settings;
        deeper.machine.z_bits = z_bits;
        EXPECT_NE(error_of([&] { job.use(deeper); }), "no error") << z_bits;
        EXPECT_NE(error_of([&] { job.advance(scene.view(), deeper); }), "no error") << z_bits;
    }
    expect_as_it_was(job, scene);
}

TEST(RenderJob, MorePatchesAreRefused) {
    const SmallScene scene;
    SmallScene more = scene;
    more.patches.push_back(more.patches.front());
    RenderJob job(scene.view(), scene.settings);
    EXPECT_EQ(error_of([&] { job.advance(more.view(), more.settings); }),
              "this frame was made for 128 patches: for 129 make another");
    expect_as_it_was(job, scene);
    // The first scene's patches count, not those of the scene that it advanced to.
    SmallScene fewer = scene;
    fewer.patches.resize(32);
    job.advance(fewer.view(), fewer.settings);
    job.advance(scene.view(), scene.settings);
    expect_as_it_was(job, scene);
}

// A bias that no word holds is found after the settings and two of the three matrices are read.
TEST(RenderJob, ARefusalLeavesSettingsAndMatrices) {
    const SmallScene scene;
    RenderJob job(scene.view(), scene.settings);
    shadow::Settings refused = scene.settings;
    refused.bias_unit = shadow::BiasUnit::world;
    refused.bias_q16 = std::int64_t{1} << 50;
    const std::string error = error_of([&] { job.use(refused); });
    EXPECT_NE(error, "no error");
    expect_as_it_was(job, scene);

    SmallScene moved = scene;
    moved.observer.axes = raster::axes_from_angles(30 << 16, 0);
    EXPECT_EQ(error_of([&] { job.advance(moved.view(), refused); }), error);
    EXPECT_EQ(job.inputs().scene.observer.axes.right, scene.observer.axes.right);
    expect_as_it_was(job, scene);

    shadow::Settings none = scene.settings;
    none.arithmetic = shadow::Arithmetic::ap120b;
    none.form = shadow::Form::correct;
    EXPECT_NE(error_of([&] { job.use(none); }), "no error");
    expect_as_it_was(job, scene);
}

// Without a map there is no plane of it, and no memory for another form's.
TEST(RenderJob, AFormOnAGroundHasNoMap) {
    const SmallScene small;
    shadow::Scene scene = small.view();
    scene.ground = 17;  // by its corners as good a plane as any
    shadow::Settings settings = small.settings;
    settings.form = shadow::Form::ground;
    RenderJob job(scene, settings);
    for (const PlaneOf& plane : job.planes()) EXPECT_NE(name_of(plane), "light_z");
    settings.form = shadow::Form::blob;
    job.use(settings);
    settings.form = shadow::Form::post_process;
    EXPECT_EQ(error_of([&] { job.use(settings); }),
              "this frame was made for a form on a ground, without a light's map: for another form "
              "make another");
}

// Three planes more, by their axes; and no room for them in a frame made without.
TEST(RenderJob, NormalsAreKeptWhereTheyAreAskedFor) {
    const SmallScene scene;
    shadow::Settings settings = scene.settings;
    settings.receiver = shadow::Receiver::plane;
    RenderJob without(scene.view(), settings);
    settings.slope_source = shadow::SlopeSource::normals;
    EXPECT_EQ(error_of([&] { without.use(settings); }),
              "this frame was made without normals: for slope_source=normals make another");
    RenderJob job(scene.view(), settings);
    EXPECT_EQ(job.frame_bytes() - without.frame_bytes(), 6u * 64 * 64);
    job.render();
    std::vector<std::string> names;
    for (const PlaneOf& plane : job.planes())
        if (plane.plane == Plane::normal) names.push_back(name_of(plane));
    EXPECT_EQ(names, (std::vector<std::string>{"normal_x", "normal_y", "normal_z"}));
    const Buffer x = job.buffer({Plane::normal, 0, 0}), z = job.buffer({Plane::normal, 0, 2});
    EXPECT_EQ(x.maxval, 65535u);
    const Buffer depths = job.buffer(Plane::observer_z);
    for (std::size_t a = 0; a < x.pixels(); ++a) {
        if (depths.at(a) == depths.maxval) {
            EXPECT_EQ(z.at(a), 32768u) << "background has none";
        } else {
            EXPECT_GE(z.at(a), 32768u) << "toward the observer, who looks along -z";
        }
    }
    // The same memory for the other source: nothing is kept, and no plane is listed.
    settings.slope_source = shadow::SlopeSource::depths;
    job.use(settings);
    job.render();
    EXPECT_EQ(hashes(job), hashes_of(scene, settings));
}

// What fits is taken over: every plane is that of a job of its own.
TEST(RenderJob, OtherSettingsAndScenesAreTakenOver) {
    const SmallScene scene;
    RenderJob job(scene.view(), scene.settings);
    job.render();
    shadow::Settings nearest = scene.settings;
    nearest.lookup = shadow::Lookup::nearest;
    nearest.bias_q16 = 64 << 16;
    job.use(nearest);
    job.render();
    EXPECT_EQ(hashes(job), hashes_of(scene, nearest));
    EXPECT_NE(hashes(job), hashes_of(scene, scene.settings));

    SmallScene moved = scene;
    moved.light.axes = raster::axes_from_angles(-60 << 16, 0);
    job.advance(moved.view(), nearest);
    EXPECT_TRUE(job.plan().leaves_out(shadow::Omission::same_depth));
    job.render();
    EXPECT_EQ(hashes(job), hashes_of(moved, nearest));
}

// A job counts a view once for all settings that draw it alike.
TEST(RenderJob, LedgersAfterOtherSettingsAreThoseOfAJobOfItsOwn) {
    SmallScene scene;
    RenderJob job(scene.view(), scene.settings);
    const auto expect_ledger_of_its_own = [&](const char* what) {
        job.use(scene.settings);
        job.render();
        RenderJob own(scene.view(), scene.settings);
        own.render();
        const shadow::FrameLedger a = job.ledger(), b = own.ledger();
        EXPECT_EQ(a.total(true), b.total(true)) << what;
        EXPECT_EQ(a.total(false), b.total(false)) << what;
        EXPECT_EQ(a.light.units.side_by_side(), b.light.units.side_by_side()) << what;
        EXPECT_EQ(a.observer.units.side_by_side(), b.observer.units.side_by_side()) << what;
        EXPECT_EQ(a.light_inside.samples, b.light_inside.samples) << what;
        EXPECT_EQ(a.observer_counts.samples, b.observer_counts.samples) << what;
        EXPECT_EQ(a.visible, b.visible) << what;
    };
    shadow::Settings& s = scene.settings;
    expect_ledger_of_its_own("figure 6");
    s.bias_q16 *= 2, expect_ledger_of_its_own("bias");
    s.bias_slope_q8 = 256, expect_ledger_of_its_own("bias_slope");
    s.lookup = shadow::Lookup::nearest, expect_ledger_of_its_own("lookup");
    s.sampling = raster::Sampling::leaf, expect_ledger_of_its_own("sampling");
    s.machine.coefficient_bits = 24, expect_ledger_of_its_own("coefficient_bits");
    s.surface = raster::PatchForm::diced, expect_ledger_of_its_own("surface");
    s.facing = raster::Facing::front, expect_ledger_of_its_own("facing");
    s.dice_levels = 2, expect_ledger_of_its_own("dice_levels");
    s.bias_slope_q8 = 0, s.form = shadow::Form::correct, expect_ledger_of_its_own("correct");
    s.form = shadow::Form::volumes, expect_ledger_of_its_own("volumes");
    s.form = shadow::Form::post_process, expect_ledger_of_its_own("post_process");
    s.low_pass_passes = 0, expect_ledger_of_its_own("low_pass");
    scene.light.target.x += 1 << 14;
    job.advance(scene.view(), s);
    expect_ledger_of_its_own("another light");
}

}  // namespace
}  // namespace umbra78::tools
