// Newell's tea set as it is entered in tools/scenes/models: counts, and what mistyped digits would
// break.
#include "tests/support/paths.hpp"
#include "tests/tools/models/model_texts.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

namespace umbra78::tools::test {
namespace {

using WordsOfPoint = std::array<std::int64_t, 3>;

ModelData tea_set(const std::string& name) {
    std::ifstream file(UMBRA78_SOURCE_DIR "/tools/scenes/models/" + name, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    ModelResult result = read_model(text, name);
    EXPECT_EQ(result.error, "");
    return std::move(result.model);
}

std::vector<WordsOfPoint> points_of(const ModelPatch& patch) {
    std::vector<WordsOfPoint> points;
    for (const ModelPoint& point : patch) points.push_back(point.word);
    std::sort(points.begin(), points.end());
    return points;
}

std::set<std::vector<WordsOfPoint>> patches_of(const ModelData& model) {
    std::set<std::vector<WordsOfPoint>> patches;
    for (const ModelPatch& patch : model.patches) patches.insert(points_of(patch));
    return patches;
}

// The same patches with one coordinate negated.
ModelData mirrored(ModelData model, std::size_t axis) {
    for (ModelPatch& patch : model.patches)
        for (ModelPoint& point : patch) point.word[axis] = -point.word[axis];
    return model;
}

TEST(TeaSet, HasAsManyPatchesAsPublished) {
    EXPECT_EQ(tea_set("teapot.tea").patches.size(), 28u);
    EXPECT_EQ(tea_set("teapot32.tea").patches.size(), 32u);
    EXPECT_EQ(tea_set("teacup.tea").patches.size(), 26u);
    EXPECT_EQ(tea_set("teaspoon.tea").patches.size(), 16u);
}

// The pot is its own mirror image, patch by patch and word by word.
TEST(TeaSet, ThePotIsSymmetric) {
    for (const char* name : {"teapot.tea", "teapot32.tea"}) {
        const ModelData pot = tea_set(name);
        EXPECT_EQ(patches_of(mirrored(pot, 1)), patches_of(pot)) << name;
    }
    const ModelData cup = tea_set("teacup.tea");
    EXPECT_EQ(patches_of(mirrored(cup, 2)), patches_of(cup));
}

TEST(TeaSet, TheBottomIsAddedToThePotAsPublished) {
    const ModelData pot = tea_set("teapot.tea"), whole = tea_set("teapot32.tea");
    for (std::size_t k = 0; k < pot.patches.size(); ++k)
        EXPECT_EQ(whole.patches[k], pot.patches[k]) << k;
    // The edge of the bottom is the lower edge of the body.
    std::set<WordsOfPoint> edge, bottom;
    for (const ModelPatch& patch : pot.patches)
        for (const ModelPoint& p : patch)
            if (p.word[2] == (3 * model_one + 10) / 20) edge.insert(p.word);
    for (std::size_t k = 28; k < 32; ++k)
        for (const ModelPoint& p : whole.patches[k])
            if (p.word[2] == (3 * model_one + 10) / 20) bottom.insert(p.word);
    EXPECT_EQ(bottom.size(), 12u);
    EXPECT_EQ(bottom, edge);
}

}  // namespace
}  // namespace umbra78::tools::test
