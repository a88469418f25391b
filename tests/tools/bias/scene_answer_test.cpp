// The answer for a scene: the study's own search, and the bound of a plane whose slope is known.
#include "tests/tools/study/study_cases.hpp"
#include "tools/bias/answer.hpp"
#include "tools/study/bias/search.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace umbra78::tools::bias {
namespace {

// The plane z = 0, lit from 30 degrees aside: a slope of tan 30 along an axis of the map.
LoadedScene plane_lit_from_30_degrees() {
    return study::request_of(R"([light]
azimuth = 30
extent  = 4
near    = -8
far     = 8
[observer]
extent  = 1
[[plane]]
origin  = [-1.5, -1.5, 0]
u       = [3, 0, 0]
v       = [0, 3, 0]
[settings]
xy_bits = 8
)").scene;
}

TEST(BiasOfAScene, IsTheStudysSearchAndThePlanesBound) {
    const LoadedScene scene = plane_lit_from_30_degrees();
    const Answer a = answer(scene);
    const double texel = 8.0 / 256, quantum = 16 / 65536.0, slope = std::tan(M_PI / 6);
    EXPECT_NEAR(a.texel, texel, 1e-12);
    EXPECT_NEAR(a.pixel, 2.0 / 256, 1e-12);
    ASSERT_EQ(a.least.size(), 3u);
    EXPECT_NEAR(*a.least[0].bound, texel * slope / 2 + quantum, 1e-6);
    EXPECT_NEAR(*a.least[2].bound, texel * std::sin(M_PI / 6) / 2, 1e-6);
    EXPECT_NEAR(a.geometry.world, texel * slope / 2, 1e-6);
    EXPECT_NEAR(a.geometry.range, 16, 1e-9);

    const study::TruthCache truths;
    const auto traced = truths.needed(scene);
    study::BiasedFrames frames(scene, *traced);
    EXPECT_NEAR(*a.least[0].found, study::min_bias(frames).outside * quantum, 1e-12);
    for (const Least& l : a.least) {
        ASSERT_TRUE(l.found);
        EXPECT_LE(*l.found, *l.bound + texel / 16);
        EXPECT_GE(*l.found, 0.8 * *l.bound - texel / 16);
    }
    for (const Converted& c : convert(a.constant, a.geometry)) {
        if (c.parameter->name == "SlopeScaledDepthBias") {
            EXPECT_NEAR(*c.value, 0.5, 1e-4);
        }
        if (c.parameter->name == "shadow_depth_bias") {
            EXPECT_NEAR(*c.value, *a.least[0].bound, 1e-12);
        }
    }
    const nlohmann::ordered_json json = to_json(a);
    EXPECT_EQ(json.at("units").size(), parameters().size());
    EXPECT_NEAR(json.at("least").at("constant").at("bound").at("texels"),
                *a.least[0].bound / texel, 1e-12);
    EXPECT_NE(print(a).find("| Direct3D"), std::string::npos);
}

}  // namespace
}  // namespace umbra78::tools::bias
