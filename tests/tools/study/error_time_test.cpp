// Error against run time: a row measured from a drawing that cases share equals that of a frame
// drawn alone.
#include "tools/cli/study_list.hpp"
#include "tools/study/error_time/error_time.hpp"

#include "tests/support/effort.hpp"
#include "tools/study/error_time/shared_draw.hpp"
#include "tools/study/inputs.hpp"
#include "tools/study/measures.hpp"
#include "tools/study/runner.hpp"
#include "tools/study/truth_cache.hpp"

#include <gtest/gtest.h>

namespace umbra78::tools::study {
namespace {

Asked small_grid() {
    Request request;
    request.quick = true;
    request.vary = {{"xy_bits", {"6"}},
                    {"form", {"post_process", "correct"}},
                    {"sampling", {"centre", "leaf"}},
                    {"z_bits", {"16", "20"}},
                    {"profile", {"affine16", "ap120b"}}};
    return ask(*studies().front(), request);
}

TEST(ErrorTime, EveryRowIsThatOfAFrameDrawnAlone) {
    const Asked asked = small_grid();
    std::size_t compared = 0;
    const std::size_t step = umbra78::test::sanitized ? 35 : 5;
    for (std::size_t k = 0; k < asked.cases.size(); k += step) {
        const Row row = run_case(asked, k, asked.cases[k]);
        if (row.text("status") != "ok") continue;  // the AP-120B has no correct form, no 20 bits
        const LoadedScene scene = scene_of(asked.request, asked.cases[k]);
        RenderJob job(scene.view(), scene.settings);
        job.render();
        EXPECT_EQ(row.text("mask_hash"), hash_of(job.buffer(Plane::mask))) << row.text("name");
        EXPECT_EQ(row.text("picture_hash"), hash_of(job.buffer(Plane::picture)));
        EXPECT_EQ(row.number("frame_cycles"), double(job.ledger().total(true)));
        EXPECT_EQ(row.number("frame_bytes"), double(job.frame_bytes()));
        const bool on_array = row.text("arithmetic") == "ap120b";
        EXPECT_EQ(row.text("affine16_frame_cycles").empty(), on_array) << row.text("name");
        EXPECT_EQ(row.text("ap120b_frame_cycles").empty(), !on_array);
        EXPECT_EQ(row.number(on_array ? "ap120b_frame_cycles" : "affine16_frame_cycles"),
                  row.number("frame_cycles"));
        ++compared;
    }
    EXPECT_GE(compared, asked.cases.size() / step / 4);
}

TEST(ErrorTime, OnlyWhatIsVaried) {
    Request request;
    request.only = true;
    request.vary = {{"bias", {"1", "2", "3"}}, {"low_pass", {"0", "2"}}};
    const Asked asked = ask(*studies().front(), request);
    EXPECT_EQ(asked.cases.size(), 6u);
    for (const Case& c : asked.cases) EXPECT_EQ(c.set.size(), 2u) << c.name;
    const Asked again = ask_again(asked.inputs, "a file", studies());
    EXPECT_EQ(again.hash, asked.hash);
}

TEST(ErrorTime, TheDefaultGridIsPrunedAndHoldsTheScenesBiasInTexels) {
    const Asked asked = ask(*studies().front(), {});
    EXPECT_GT(asked.cases.size(), 100u);
    EXPECT_LT(asked.cases.size(), 250u);
    for (const Case& c : asked.cases)
        EXPECT_NE(c.name.find("bias_unit=texels"), std::string::npos) << c.name;
    const LoadedScene scene = scene_of(asked.request, asked.cases.front());
    EXPECT_EQ(scene.settings.bias_unit, shadow::BiasUnit::texels);
    EXPECT_EQ(scene.settings.bias_q16, 3 << 15);  // 192 quanta of 1/128 pixel
}

// With exact centres the observer's Z is off by little more than its rounding.
TEST(ErrorTime, DepthErrorIsSmallWithExactCentres) {
    const Asked asked = small_grid();
    for (const char* bits : {"12", "16"}) {
        const Case c{"", {std::string("z_bits=") + bits}, {}};
        const LoadedScene scene = scene_of(asked.request, c);
        RenderJob job(scene.view(), scene.settings);
        job.render();
        const auto truth = trace(scene);
        ASSERT_TRUE(truth);
        const DepthError error =
            depth_error(scene, truth->truth, job.buffer(Plane::observer_z));
        EXPECT_GT(error.pixels, 50'000);
        EXPECT_LT(std::abs(error.mean), 0.25) << bits;
        EXPECT_LT(error.rms, 1) << bits;
        EXPECT_LE(error.min, error.mean);
        EXPECT_GE(error.max, error.mean);
    }
}

}  // namespace
}  // namespace umbra78::tools::study
