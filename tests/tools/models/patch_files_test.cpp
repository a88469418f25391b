// Files of Bezier patches: the words of their points, in every form that a format allows.
#include "tests/tools/models/model_texts.hpp"

namespace umbra78::tools::test {
namespace {

ModelData read(const std::string& text, const std::string& name) {
    ModelResult result = read_model(text, name);
    EXPECT_EQ(result.error, "") << name;
    return std::move(result.model);
}

// Patch k of patch_points(k).
void expect_patches(const ModelData& model, std::size_t count) {
    ASSERT_EQ(model.patches.size(), count);
    for (std::size_t k = 0; k < count; ++k)
        for (std::size_t n = 0; n < 16; ++n) {
            const std::array<std::int64_t, 3> word{
                static_cast<std::int64_t>(n % 4) * model_one,
                static_cast<std::int64_t>(n / 4) * model_one,
                static_cast<std::int64_t>(k) * model_one / 4};
            EXPECT_EQ(model.patches[k][n].word, word) << k << " " << n;
        }
}

const std::string two_bpt = "2\n3 3\n" + patch_points(0) + "3 3\n" + patch_points(1);
const std::string two_bez = "BEZ333\n" + patch_points(0) + "\n" + patch_points(1);

// Two patches of vertices of their own.
std::string two_tea() {
    std::string text = "2\n";
    for (int first : {1, 17})
        for (int n = 0; n < 16; ++n) text += std::to_string(first + n) + (n < 15 ? "," : "\n");
    std::string points = patch_points(0) + patch_points(1);
    for (char& c : points) c = c == ' ' ? ',' : c;
    return text + "32\n" + points;
}

TEST(PatchFiles, EveryFormatHoldsTheSamePatches) {
    const std::pair<std::string, std::string> files[] = {
        {two_bpt, "a.bpt"}, {two_bez, "a.bez"}, {two_tea(), "a.tea"}};
    for (const auto& [text, name] : files) {
        expect_patches(read(text, name), 2);
        expect_patches(read(with_crlf(text), name), 2);
        expect_patches(read(with_comments(text), name), 2);
        expect_patches(read(with_crlf(with_comments(text)), name), 2);
        expect_patches(read("\xEF\xBB\xBF" + text, name), 2);
        expect_patches(read(text.substr(0, text.size() - 1), name), 2);  // no end of the last line
    }
    expect_patches(read(two_bpt, "FOLDER.x/A.BPT"), 2);
}

TEST(PatchFiles, PointsKnowTheirLines) {
    const ModelData model = read(two_bpt, "a.bpt");
    EXPECT_EQ(model.patches[0][0].line, 3);
    EXPECT_EQ(model.patches[1][15].line, 35);
    EXPECT_EQ(read(two_tea(), "a.tea").patches[1][0].line, 21);
}

// Colours and texture coordinates of the corners follow the points and are skipped.
TEST(PatchFiles, GeomviewHeaders) {
    const std::string colours = repeated("0.5 0 1 1\n", 4), texture = repeated("0 1\n", 4);
    const auto file = [](const std::string& header, const std::string& after) {
        return header + "\n" + patch_points(0) + after + patch_points(1) + after;
    };
    expect_patches(read(file("BBP", ""), "a.bez"), 2);
    expect_patches(read(file("STBBP", texture), "a.bez"), 2);
    expect_patches(read(file("CBEZ333", colours), "a.bez"), 2);
    expect_patches(read(file("BEZ333_ST", texture), "a.bez"), 2);
    expect_patches(read(file("CBEZ333_ST", texture + colours), "a.bez"), 2);
}

// Half to even in the last place of 2^-32, in every notation.
TEST(PatchFiles, CoordinatesAreExactWords) {
    const std::pair<const char*, std::int64_t> cases[] = {
        {"0", 0}, {"-0.0", 0}, {"+1", model_one}, {".5", model_one / 2}, {"-.5", -model_one / 2},
        {"5.", 5 * model_one}, {"2.e1", 20 * model_one}, {"1E-1", 429496730}, {"0.1", 429496730},
        {"1048576", max_model}, {"-1048576.00", -max_model},
        {"0.00000000023283064365386962890625", 1},       // 2^-32
        {"0.000000000116415321826934814453125", 0},      // 2^-33: a tie, to the even 0
        {"0.0000000001164153218269348144531250001", 1},  // a little more
        {"0.000000000349245965480804443359375", 2},      // 3 2^-33: a tie, to the even 2
    };
    for (const auto& [text, word] : cases) {
        const ModelData model =
            read("1\n3 3\n" + std::string(text) + repeated(" 0", 47) + "\n", "a.bpt");
        EXPECT_EQ(model.patches[0][0].word[0], word) << text;
    }
}

TEST(PatchFiles, DegeneratePatchesAreTakenAsTheyAre) {
    const ModelData model = read("1\n3 3\n" + repeated("1 2 3\n", 16), "a.bpt");
    for (const ModelPoint& point : model.patches.at(0)) EXPECT_EQ(point, model.patches[0][0]);
}

TEST(PatchFileErrors, WhatMayBeWrongInAllFormats) {
    const std::string empty =
        ":1: the file holds no numbers; give it a model, or name another file";
    expect_messages({
        {"a.bpt", "", "a.bpt" + empty},
        {"a.bez", "# nothing\r\n", "a.bez" + empty},
        {"a.tea", " ,\n,", "a.tea" + empty},
        {"teapot", "1\n",
         "teapot: the name ends like no model's; known: .bpt, .bez, .tea, .obj, .stl, .ply"},
        {"a.bpt", "1\n3 3\n0 0 0\n0 nan 0\n",
         "a.bpt:4: 'nan' is no coordinate; write a decimal, such as -2.5"},
        {"a.bpt", "1\n3 3\n0 0 inf\n",
         "a.bpt:3: 'inf' is no coordinate; write a decimal, such as -2.5"},
        {"a.bpt", "1\n3 3\n0 0 0x10\n",
         "a.bpt:3: '0x10' is no coordinate; write a decimal, such as -2.5"},
        {"a.bpt", "1\n3 3\n0 0 1_0\n",
         "a.bpt:3: '1_0' is no coordinate; write a decimal, such as -2.5"},
        {"a.bpt", "1\n3 3\n0 0 .\n",
         "a.bpt:3: '.' is no coordinate; write a decimal, such as -2.5"},
        {"a.bpt", "1\n3 3\n0 0 " + std::string(40, 'x') + "\x01\n",
         "a.bpt:3: 'xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx...' is no coordinate; write a decimal, such "
         "as -2.5"},
        {"a.bez", "BBP\n0 0 \x80\x07\n",
         "a.bez:2: '?\?' is no coordinate; write a decimal, such as -2.5"},
        {"a.bez", "BBP\n0 0 1e300\n",
         "a.bez:2: the coordinate '1e300' is beyond -1048576 .. 1048576; scale the file's points"},
        {"a.bez", "BBP\n-1048576.0000001 0 1\n",
         "a.bez:2: the coordinate '-1048576.0000001' is beyond -1048576 .. 1048576; scale the "
         "file's points"},
    });
}

TEST(PatchFileErrors, Bpt) {
    const std::string points = patch_points(0);
    expect_messages({
        {"a.bpt", "1.5\n", "a.bpt:1: the number of patches is '1.5'; write a whole number"},
        {"a.bpt", "0\n", "a.bpt:1: the number of patches is '0'; its range is 1 .. 1048576"},
        {"a.bpt", "99999999999\n",
         "a.bpt:1: the number of patches is '99999999999'; its range is 1 .. 1048576"},
        {"a.bpt", "1\n", "a.bpt:2: the file ends in the order of patch 1; add the rest, or correct "
                         "the counts"},
        {"a.bpt", "2\n3 3\n" + points, "a.bpt:19: the file ends in the order of patch 2; add the "
                                       "rest, or correct the counts"},
        {"a.bpt", "1\n3 3\n" + points.substr(0, points.size() - 6),
         "a.bpt:18: the file ends in patch 1 of 1; add the rest, or correct the counts"},
        {"a.bpt", "1\n3 3\n" + points + "4 5",
         "a.bpt:19: '4' follows patch 1 of 1; correct the count, or remove it"},
        {"a.bpt", "1\n2 3\n" + points,
         "a.bpt:2: patch 1 has order 2; only bicubic patches, of order 3 3, have an exact form "
         "here"},
    });
}

TEST(PatchFileErrors, Bez) {
    expect_messages({
        {"a.bez", "BBP", "a.bez:1: the file ends in its header; add the rest, or correct the "
                         "counts"},
        {"a.bez", "BBP\n" + patch_points(0) + "1 2\n",
         "a.bez:19: the file ends in patch 2; add the rest, or correct the counts"},
        {"a.bez", "STBBP\n" + patch_points(0) + "1 2\n",
         "a.bez:19: the file ends in patch 1; add the rest, or correct the counts"},
        {"a.bez", "BEZ334\n1 2 3 1\n",
         "a.bez:1: 'BEZ334' is rational: its points have weights, by which the machine would have "
         "to divide; write BEZ333"},
        {"a.bez", "CBEZ224_ST\n",
         "a.bez:1: 'CBEZ224_ST' is rational: its points have weights, by which the machine would "
         "have to divide; write BEZ333"},
        {"a.bez", "BEZ223\n1 2 3\n",
         "a.bez:1: 'BEZ223' is not bicubic: only patches of degree 3 by 3 have an exact form here; "
         "write BEZ333"},
        {"a.bez", "BEZ333 BINARY\n", "a.bez:1: the file is binary; write it as text"},
        {"a.bez", "OFF\n1 2 3\n",
         "a.bez:1: 'OFF' begins no Geomview Bezier file; begin it with BBP or BEZ333"},
        {"a.bez", "1\n3 3\n",
         "a.bez:1: '1' begins no Geomview Bezier file; begin it with BBP or BEZ333"},
    });
}

TEST(PatchFileErrors, Tea) {
    const std::string list = "1\n1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16\n";
    expect_messages({
        {"a.tea", "2\n1,2,3\n",
         "a.tea:3: the file ends in the list of patch 1 of 2; add the rest, or correct the counts"},
        {"a.tea", list, "a.tea:3: the file ends in the number of vertices; add the rest, or "
                        "correct the counts"},
        {"a.tea", list + "17\n" + patch_points(0),
         "a.tea:20: the file ends in vertex 17 of 17; add the rest, or correct the counts"},
        {"a.tea", list + "16\n" + patch_points(0) + "1,2,3\n",
         "a.tea:20: '1' follows vertex 16 of 16; correct the count, or remove it"},
        {"a.tea", list + "1\n0,0,0\n",
         "a.tea:2: a vertex number of patch 1 is '2'; its range is 1 .. 1"},
        {"a.tea", "1\n0" + list.substr(3) + "16\n" + patch_points(0),
         "a.tea:2: a vertex number of patch 1 is '0'; its range is 1 .. 16"},
        {"a.tea", "1\nx" + list.substr(3) + "16\n" + patch_points(0),
         "a.tea:2: a vertex number of patch 1 is 'x'; write a whole number"},
    });
}

}  // namespace
}  // namespace umbra78::tools::test
