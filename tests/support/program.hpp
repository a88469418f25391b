// A folder of its own, and the program run in it: exit code, output, errors, and what it leaves.
#pragma once

#include "tests/support/paths.hpp"
#include "tools/io/text_formats.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace umbra78::tools::test {

struct Ran {
    int exit_code;
    std::string out, err;
};

class Program : public testing::Test {
protected:
    static inline const std::string scenes = UMBRA78_SOURCE_DIR "/tools/scenes/";
    static inline const std::string figures_scene = scenes + "figures.toml";

    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() /
        ("umbra78-program-" + std::to_string(getpid()) + "-" +
         testing::UnitTest::GetInstance()->current_test_info()->name());

    void SetUp() override { std::filesystem::create_directory(folder); }
    void TearDown() override {
        std::filesystem::remove_all(folder);
        std::filesystem::remove(text_path("out"));
        std::filesystem::remove(text_path("err"));
    }

    Ran run(const std::string& arguments) const {
        const std::string command = "cd '" + folder.string() + "' && " UMBRA78_PROGRAM " " +
                                    arguments + " >" + text_path("out") + " 2>" + text_path("err");
        const int status = std::system(command.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(text_path("out")),
                content(text_path("err"))};
    }
    void write(const char* name, const std::string& text) const {
        std::ofstream(folder / name, std::ios::binary) << text;
    }
    static std::string content(const std::filesystem::path& path) {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    std::vector<std::string> files() const {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
            if (entry.is_regular_file())
                names.push_back(entry.path().lexically_relative(folder).string());
        std::sort(names.begin(), names.end());
        return names;
    }

private:
    std::string text_path(const char* what) const { return folder.string() + "." + what; }
};

}  // namespace umbra78::tools::test
