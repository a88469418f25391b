// Coverage: planted losses are counted as what they are, and silhouettes a pixel off are not.
#include "tools/truth/coverage.hpp"

#include <gtest/gtest.h>

namespace umbra78::tools {
namespace {

constexpr int size = 32;
constexpr std::uint32_t background = 65535;

// A disc of radius 10 before the front view, and the codes of a machine that draws it exactly.
struct Drawn {
    TruthScene scene{{{{0, 0, 0}, 10.0}}, {}};
    TruthView view{false, {}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 16, 0, -16, 16, size};
    Truth truth = trace(scene, view, {false, {0, 0, 1}, {}});
    std::vector<std::uint16_t> codes;

    Drawn() {
        for (std::size_t at = 0; at < truth.visible.size(); ++at)
            codes.push_back(truth.visible[at] ? code(truth.depth[at]) : background);
    }
    static std::uint16_t code(double depth) {
        return static_cast<std::uint16_t>((depth + 16) * 2048);
    }
    Coverage count() const {
        const Buffer depths{"z", size, background, std::span<const std::uint16_t>(codes)};
        return coverage(truth, depths, coverage_image(truth, depths, view));
    }
    std::uint16_t& at(int x, int y) { return codes[static_cast<std::size_t>(y * size + x)]; }
};

TEST(Coverage, OfAnExactPictureIsComplete) {
    const Coverage c = Drawn().count();
    EXPECT_TRUE(c.complete());
    EXPECT_EQ(c.seen, c.drawn);
    EXPECT_GT(c.seen, 300);
    EXPECT_EQ(c.beyond_edge, 0);
}

TEST(Coverage, AHoleIsMissing) {
    Drawn d;
    d.at(16, 16) = background;
    EXPECT_EQ(d.count().missing, 1);
    for (int y = 12; y < 20; ++y)
        for (int x = 12; x < 20; ++x) d.at(x, y) = background;
    EXPECT_EQ(d.count().missing, 64);
    EXPECT_EQ(d.count().extra + d.count().misplaced, 0);
}

TEST(Coverage, APictureOfNothingMissesAll) {
    Drawn d;
    d.codes.assign(d.codes.size(), background);
    const Coverage c = d.count();
    EXPECT_EQ(c.missing, c.seen);
    EXPECT_EQ(c.drawn, 0);
}

TEST(Coverage, ASpeckIsExtra) {
    Drawn d;
    d.at(2, 2) = 30000;
    EXPECT_EQ(d.count().extra, 1);
    EXPECT_EQ(d.count().beyond_edge, 0);
}

// The machine's silhouette a pixel too far out or in, all round.
TEST(Coverage, ASilhouetteAPixelOffIsNeither) {
    for (const double radius : {11.0, 9.0}) {
        Drawn d;
        const Truth other = trace({{{{0, 0, 0}, radius}}, {}}, d.view, {false, {0, 0, 1}, {}});
        for (std::size_t at = 0; at < d.codes.size(); ++at)
            d.codes[at] = !other.visible[at]       ? background
                          : d.truth.visible[at] ? d.codes[at]
                                                : Drawn::code(0);
        const Coverage c = d.count();
        EXPECT_TRUE(c.complete()) << radius;
        EXPECT_EQ(c.beyond_edge, std::max(c.drawn - c.seen, 0)) << radius;
        EXPECT_NE(c.drawn, c.seen);
    }
}

TEST(Coverage, AnotherDepthIsMisplaced) {
    Drawn d;
    for (int x = 12; x < 20; ++x) d.at(x, 16) = Drawn::code(5);
    const Coverage c = d.count();
    EXPECT_EQ(c.misplaced, 8);
    EXPECT_EQ(c.missing + c.extra, 0);
    Drawn one;
    one.at(16, 16) = Drawn::code(5);
    EXPECT_TRUE(one.count().complete());  // a pixel alone: the tip of a fold
    Drawn near;
    for (std::uint16_t& code : near.codes)
        if (code != background) code = static_cast<std::uint16_t>(code + 4);
    EXPECT_TRUE(near.count().complete());
}

}  // namespace
}  // namespace umbra78::tools
