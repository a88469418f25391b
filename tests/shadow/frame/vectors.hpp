// Vectors: for a stage, lines "input words -> output words" in tests/independent/vectors/STAGE.txt.
//
// They are made here, by the code, from seeded inputs, and are compared with the file; the
// implementation in Python checks the same file (tests/independent/machine.py). With the
// environment variable UMBRA78_BLESS_VECTORS set, the files are written instead.
#pragma once

#include "raster/block.hpp"
#include "tests/support/inputs.hpp"
#include "tests/support/paths.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <string>
#include <type_traits>
#include <vector>

namespace umbra78::test {

// One line, word by word.
class Line {
public:
    template <class Word>
    Line& operator<<(const Word& word) {
        if (!text_.empty()) text_ += ' ';
        if constexpr (std::is_integral_v<Word>) {
            text_ += std::to_string(word);
        } else {
            text_ += word;
        }
        return *this;
    }
    Line& operator<<(const raster::Component& c) {
        for (const auto& field : {c.f, c.gu, c.gv, c.guv})
            for (const std::int64_t v : field) *this << v;
        return *this;
    }
    const std::string& text() const { return text_; }

private:
    std::string text_;
};

using Lines = std::vector<std::string>;

// `about` is the file's head: what the words are.
inline void check_vectors(const std::string& stage, const Lines& about, const Lines& lines) {
    const std::string path = UMBRA78_SOURCE_DIR "/tests/independent/vectors/" + stage + ".txt";
    Lines all;
    for (const std::string& line : about) all.push_back("# " + line);
    all.insert(all.end(), lines.begin(), lines.end());
    if (std::getenv("UMBRA78_BLESS_VECTORS") != nullptr) {
        std::ofstream file(path);
        for (const std::string& line : all) file << line << '\n';
        ASSERT_TRUE(file.flush()) << path;
        return;
    }
    std::ifstream file(path);
    Lines stored;
    for (std::string line; std::getline(file, line);) stored.push_back(line);
    ASSERT_FALSE(stored.empty()) << path << " is missing; set UMBRA78_BLESS_VECTORS to write it";
    for (std::size_t k = 0; k < all.size() && k < stored.size(); ++k)
        ASSERT_EQ(stored[k], all[k]) << path << ':' << k + 1 << ": the machine's words differ";
    EXPECT_EQ(stored.size(), all.size()) << path;
}

}  // namespace umbra78::test
