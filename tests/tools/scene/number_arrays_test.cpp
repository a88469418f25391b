// Arrays of numbers that do not pass through toml++: the trees, the errors and the patches are as
// if they did.
#include "tests/support/effort.hpp"
#include "tests/tools/scene/toml_trees.hpp"
#include "tools/scene/scene.hpp"

#include <gtest/gtest.h>

#include <random>

namespace umbra78::tools::test {
namespace {

std::size_t arrays_in(const std::string& text) { return outline_of(text, true).arrays.size(); }

TEST(NumberArrays, TheOutlineKeepsEverythingElseInItsLine) {
    const std::string text = "[[patch]] # [1]\n"
                             "control = [ [1, -2.5e-1,], # a ' \"\n\t[+3]\r\n] # b\n"
                             "name = '''\nx = [1]\n'''\n y-1=[ ]\nz = [1, 'a']\nw = [2]";
    const TomlOutline outline = outline_of(text, true);
    EXPECT_EQ(outline.emptied, "[[patch]] # [1]\ncontrol = [\n\n] # b\n"
                               "name = '''\nx = [1]\n'''\n y-1=[]\nz = [1, 'a']\nw = []");
    ASSERT_EQ(outline.arrays.size(), 3u);
    EXPECT_EQ(outline.arrays[0].line, 2);
    EXPECT_EQ(outline.arrays[0].text, "[ [1, -2.5e-1,], # a ' \"\n\t[+3]\r\n]");
    EXPECT_EQ(outline.arrays[1].line, 8);
    EXPECT_EQ(outline.arrays[2].line, 10);
    EXPECT_EQ(outline_of(text, false).arrays.size(), 0u);
    EXPECT_EQ(outline_of("x = 1\n", true).emptied, "");
}

TEST(NumberArrays, WhatIsNotPlainIsLeftToTheLibrary) {
    for (const char* plain : {"[1]", "[0]", "[-0.0]", "[[[[1]]]]", "[]", "[[], 1, [2]]",
                              "[123456789012345678]", "[1.5E+10, 1e-99]", "[1, # ]\n2]"})
        EXPECT_EQ(arrays_in(std::string("[a]\nx = ") + plain + "\n"), 1u) << plain;
    for (const char* other :
         {"[01]", "[1_0]", "[.5]", "[5.]", "[inf]", "[0x1]", "[1978-08-23]", "[07:32:00]", "[true]",
          "['1']", "[1 2]", "[1,,2]", "[,]", "[1", "[1]]", "[[[[[1]]]]]", "[{}]", "[1e]", "[1e100]",
          "[1234567890123456789]", "[1.5.5]", "[+-1]", "[1\r]", "[1, # \xCE\xA9\n2]", "[1\v]",
          "[0.1234567890123456789012345678901234567890]"})
        EXPECT_EQ(arrays_in(std::string("[a]\nx = ") + other + "\n"),
                  other == std::string("[1]]") ? 1u : 0u) << other;
    for (const char* place : {"x = 1 y = [1]", "'x' = [1]", "a.b = [1]", "# x = [1]",
                              "x = {y = [1]}", "x == [1]", "x \n= [1]", "= [1]",
                              "x = 'a\\\ny = [1]"})
        EXPECT_EQ(arrays_in(std::string("[a]\n") + place + "\n"),
                  place == std::string("x = 'a\\\ny = [1]") ? 1u : 0u) << place;
}

// Bytes that make and break arrays, texts, comments, keys and tables.
std::string random_text(std::mt19937& random) {
    static constexpr const char* parts[] = {
        "[[p]]\n", "[q]\n", "[p.x]\n", "[[p.x]]\n", "x = [", "y = [", "]", "]\n", "[", ",", ", ",
        "1", "-2.5", "0.1e-3", "1_0", "01", "\n", "\r\n", " ", "# c ] \"\n", "'", "\"", "'''\n",
        "\"\"\"", "x", " = ", "x = 1\n", "{", "}", "{a = [1]}", ".", "\\", "+", "inf", "\xCE\xA9",
        "z = [[1, 2, 3], [4, 5, 6],]\n", "z = [[1, 2], # c\n [3]]\n", "1979-05-27", "\t", "true"};
    std::string text = random() % 8 == 0 ? "\xEF\xBB\xBF[p]\n" : "";
    for (auto n = random() % 24; n > 0; --n) text += parts[random() % std::size(parts)];
    return text;
}

TEST(NumberArrays, TreesAndErrorsAreTheLibrarysOwn) {
    constexpr unsigned seed = 1978;
    std::mt19937 random(seed);
    int whole = 0, emptied = 0;
    for (int n = 0; n < umbra78::test::effort(200'000); ++n) {
        std::string text = random_text(random);
        if (random() % 4 != 0) text = "[[p]]\nx = [1, 2]\n" + text;
        const std::string read = printed_toml(text, ArraysOfNumbers::are_read);
        const std::string stay = printed_toml(text, ArraysOfNumbers::stay_text);
        ASSERT_EQ(read, stay) << "seed " << seed << ", case " << n << ":\n" << text;
        const bool valid = read.find("not valid TOML") == read.npos;
        whole += valid ? 1 : 0;
        emptied += valid && arrays_in(text) > 1 ? 1 : 0;
    }
    EXPECT_GT(whole, umbra78::test::effort(5000));
    EXPECT_GT(emptied, umbra78::test::effort(500));
}

std::string random_number(std::mt19937& random) {
    const auto digits = [&](unsigned most) {
        std::string text;
        for (auto n = 1 + random() % most; n > 0; --n)
            text += static_cast<char>('0' + random() % 10);
        return text;
    };
    std::string text = std::array{"", "-", "+"}[random() % 3] + std::to_string(random() % 33000);
    if (random() % 4 != 0) text += "." + digits(26);
    if (random() % 8 == 0) text = "0." + std::to_string(5 + 10 * (random() % 1000)) + "e-2";
    if (random() % 8 == 0) text = std::to_string(random() % 4096 * 2 + 1) + "." +
                                  "00000762939453125";  // a tie: 2^-17
    if (random() % 16 == 0) text += "e-" + digits(2);
    return text;
}

// A quoted key keeps an array from being emptied, so its numbers pass through the tree.
TEST(NumberArrays, PatchesAreTheSameWordsAndErrors) {
    std::mt19937 random(1978);
    int good = 0, bad = 0;
    for (int n = 0; n < umbra78::test::effort(3000); ++n) {
        const bool rows = random() % 2 != 0;
        std::string control = "[\n";
        for (int k = 0; k < 16; ++k) {
            if (rows && k % 4 == 0) control += "[";
            control += "[" + random_number(random) + ", " + random_number(random) + ", " +
                       random_number(random) + "]";
            if (rows && k % 4 == 3) control += "]";
            control += k == 15 ? "\n" : ",\n";
        }
        control += "]";
        if (random() % 4 == 0) control.erase(random() % control.size(), 1 + random() % 3);
        const std::string head = "[light]\nazimuth = 0\n[observer]\nrecentre = \"off\"\n"
                                 "[[patch]]\n";
        const SceneResult text = read_scene(head + "control = " + control, "a.toml", {});
        const SceneResult tree = read_scene(head + "\"control\" = " + control, "a.toml", {});
        ASSERT_EQ(text.error, tree.error) << control;
        ++(text.ok() ? good : bad);
        if (!text.ok()) continue;
        ASSERT_EQ(text.scene.patches.at(0).control, tree.scene.patches.at(0).control) << control;
    }
    EXPECT_GT(good, umbra78::test::effort(1000));
    EXPECT_GT(bad, umbra78::test::effort(100));
}

}  // namespace
}  // namespace umbra78::tools::test
