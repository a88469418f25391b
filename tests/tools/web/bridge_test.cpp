// What the machine answers to the page, compiled for this computer: the published hashes, the
// errors of the figures, a pixel's words and the pipeline's cycles. In a browser the same is asked
// by page_test.py.
#include "tools/web/bridge.hpp"

#include "tests/support/paths.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace umbra78::tools::web {
namespace {

using nlohmann::ordered_json;

std::string text_of(const std::string& path) {
    std::ifstream file(UMBRA78_SOURCE_DIR "/" + path, std::ios::binary);
    EXPECT_TRUE(file) << path;
    return {std::istreambuf_iterator<char>(file), {}};
}

class PageBridge : public testing::Test {
protected:
    PageBridge() {
        hand_in("figures.toml", "tools/scenes/figures.toml");
        std::istringstream lines(text_of("tests/goldens/hashes.txt"));
        for (std::string name, hash; lines >> name >> hash;) goldens_[name] = hash;
    }

    ordered_json ask(const ordered_json& request) {
        return ordered_json::parse(bridge_.answer(request.dump()));
    }
    void hand_in(const std::string& name, const std::string& path) {
        ask({{"do", "hand_in"}, {"path", name}, {"text", text_of(path)}});
    }
    ordered_json draw(const ordered_json& set) {
        return ask({{"do", "draw"}, {"scene", "figures.toml"}, {"set", set}});
    }

    Bridge bridge_;
    std::map<std::string, std::string> goldens_;
};

const ordered_json figure3{"lookup=nearest", "bias=64", "dither=none", "dequantize=0",
                           "low_pass=0"};

TEST_F(PageBridge, PresetsOfThePapersFiguresAreTheirGoldens) {
    const ordered_json presets = ask({{"do", "presets"}});
    ASSERT_EQ(presets.size(), 6u);  // the other scenes were not handed in
    for (const ordered_json& preset : presets) {
        const ordered_json frame = draw(preset.at("set"));
        ASSERT_FALSE(frame.contains("problem")) << frame;
        const ordered_json hashes = ask({{"do", "hashes"}});
        const std::string plane = preset.at("plane"), golden = preset.at("golden");
        EXPECT_EQ(hashes.at(plane), goldens_.at(golden)) << preset.at("name");
    }
}

TEST_F(PageBridge, AFrameThatKeepsWhatItCanIsTheSameAsANewOne) {
    draw(figure3);
    draw({"bias=64", "light.azimuth=-90"});
    draw({"xy_bits=7"});
    draw(figure3);
    EXPECT_EQ(ask({{"do", "hashes"}}).at("mask"), goldens_.at("mask3"));
}

// A picture's red bytes, which the answer says the place of.
std::vector<std::uint8_t> red_of(const ordered_json& answer) {
    const auto* at = reinterpret_cast<const std::uint8_t*>(answer.at("at").get<std::uintptr_t>());
    std::vector<std::uint8_t> red(answer.at("bytes").get<std::size_t>() / 4);
    for (std::size_t k = 0; k < red.size(); ++k) red[k] = at[4 * k];
    return red;
}

TEST_F(PageBridge, ATileIsTheMeansOfItsPicture) {
    draw(figure3);
    for (const char* name : {"light_z", "mask", "picture"}) {
        const ordered_json whole = ask({{"do", "picture"}, {"name", name}});
        ASSERT_EQ(whole.at("size"), 512);
        const std::vector<std::uint8_t> pixels = red_of(whole);
        const ordered_json small = ask({{"do", "picture"}, {"name", name}, {"by", 4}});
        ASSERT_EQ(small.at("size"), 128);
        const std::vector<std::uint8_t> tile = red_of(small);
        for (std::size_t at = 0; at < tile.size(); ++at) {
            int sum = 0;
            for (std::size_t k = 0; k < 16; ++k)
                sum += pixels[(4 * (at / 128) + k / 4) * 512 + 4 * (at % 128) + k % 4];
            ASSERT_EQ(tile[at], sum / 16) << name << " " << at;
        }
    }
    EXPECT_EQ(ask({{"do", "picture"}, {"name", "mask"}, {"by", 5}}).at("size"), 512);
}

TEST_F(PageBridge, ErrorOfFigure3IsTheReadmes) {
    EXPECT_FALSE(draw(figure3).contains("rates"));  // before truth is known
    const ordered_json answer = ask({{"do", "error"}});
    const ordered_json frame = draw(figure3);
    for (const char* rate : {"false_shadow", "false_light"})
        EXPECT_EQ(frame.at("rates").at(rate), answer.at("error").at(rate));
    EXPECT_NEAR(answer.at("error").at("false_shadow").get<double>(), 0.2387, 0.00005);
    EXPECT_EQ(frame.at("isolated_pixels"), 2263);
    EXPECT_NEAR(answer.at("flatness").get<double>(), 0.36, 0.005);
    // Truth is traced anew where the light has moved.
    ordered_json turned = figure3;
    turned.push_back("light.azimuth=-60");
    draw(turned);
    EXPECT_NE(ask({{"do", "error"}}).at("error").at("lit_pixels"),
              answer.at("error").at("lit_pixels"));
}

// Embree traces 0.376 % false shadow of the teapot's smooth patches (umbra78 render); the facets
// agree but for what dicing moves at silhouettes.
TEST_F(PageBridge, ErrorOfPatchesIsAgainstTheirFacets) {
    hand_in("teapot.toml", "tools/scenes/teapot.toml");
    hand_in("models/teapot.tea", "tools/scenes/models/teapot.tea");
    const ordered_json frame = ask({{"do", "draw"}, {"scene", "teapot.toml"}});
    ASSERT_FALSE(frame.contains("problem")) << frame;
    EXPECT_FALSE(frame.at("has_closed_form"));
    const ordered_json error = ask({{"do", "error"}}).at("error");
    EXPECT_EQ(error.at("truth").at("by"), "polygons");
    EXPECT_NEAR(error.at("false_shadow").get<double>(), 0.00376, 0.0003);
    EXPECT_LT(error.at("false_light").get<double>(), 0.01);
    EXPECT_NEAR(error.at("lit_pixels").get<double>(), 216251, 2000);
    EXPECT_EQ(ask({{"do", "picture"}, {"name", "error"}}).at("size"), 512);
    // The same truth for another machine: only the bias has changed.
    const ordered_json none =
        ask({{"do", "draw"}, {"scene", "teapot.toml"}, {"set", {"bias=0"}}});
    EXPECT_GT(none.at("rates").at("false_shadow").get<double>(), 0.05);
}

TEST_F(PageBridge, ErrorOfPatchesUnderALightWithAnAreaIsSaidToBeMissing) {
    hand_in("penumbra.toml", "tools/scenes/penumbra.toml");
    const ordered_json frame = ask({{"do", "draw"}, {"scene", "penumbra.toml"}});
    ASSERT_FALSE(frame.contains("problem")) << frame;
    const ordered_json answer = ask({{"do", "error"}});
    EXPECT_TRUE(answer.at("error").is_null());
    EXPECT_NE(answer.at("because").get<std::string>().find("an area"), std::string::npos);
}

TEST_F(PageBridge, APixelIsFollowedAndThePipelineStepped) {
    draw(figure3);
    const ordered_json trace = ask({{"do", "trace"}, {"x", 80}, {"y", 180}});
    EXPECT_EQ(trace.at("summary"), "in shadow, cycles 169706 to 169718");
    const ordered_json log =
        ask({{"do", "cycles"}, {"from", trace.at("first_cycle")}, {"count", 13}});
    ASSERT_EQ(log.at("cycles").size(), 13u);
    const ordered_json& last = log.at("cycles").back();
    EXPECT_EQ(last.at("cycle"), trace.at("last_cycle"));
    EXPECT_EQ(log.at("stages").back(), "write");
    const ordered_json& written = last.at("stages").back();
    EXPECT_EQ(written.at(2), 80);
    EXPECT_EQ(written.at(3), 180);
    const ordered_json around =
        ask({{"do", "around"}, {"plane", "light_z"}, {"x", 367}, {"y", 180}, {"radius", 1}});
    EXPECT_EQ(around.at("rows").at(1).at(1), 12393);
}

TEST_F(PageBridge, BadRequestsAreSaidInALine) {
    EXPECT_TRUE(ask({{"do", "hashes"}}).contains("problem"));
    EXPECT_EQ(draw({"bias=much"}).at("problem").get<std::string>().rfind("--set bias=much", 0), 0u);
    EXPECT_TRUE(ask({{"do", "draw"}, {"scene", "none.toml"}}).contains("problem"));
    draw(figure3);
    EXPECT_TRUE(ask({{"do", "dance"}}).contains("problem"));
    EXPECT_TRUE(ask({{"do", "around"}, {"plane", "nothing"}}).contains("problem"));
    EXPECT_TRUE(ordered_json::parse(bridge_.answer("{")).contains("problem"));
    // After a request that was refused the frame before is still there.
    draw({"bias=much"});
    EXPECT_EQ(ask({{"do", "hashes"}}).at("mask"), goldens_.at("mask3"));
}

}  // namespace
}  // namespace umbra78::tools::web
