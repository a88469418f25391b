// The documents against the program: what they say that a command prints is what it prints.
#include "tests/support/effort.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/program.hpp"
#include "tools/render/report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <sstream>

namespace umbra78::tools {
namespace {

using json = nlohmann::ordered_json;
using test::Ran;

// The numbers are the same under sanitizers, which would take a minute to repeat them.
struct Documents : test::Program {
    void SetUp() override {
        if (umbra78::test::sanitized) GTEST_SKIP() << "numbers are compared without sanitizers";
        test::Program::SetUp();
    }
};

const std::string source = UMBRA78_SOURCE_DIR "/";

// An indented block of a document: a command behind "$ umbra78 ", and its output, in which a line
// "..." is for any number of lines.
struct Shown {
    std::string arguments;
    std::vector<std::string> chunks;
};

std::vector<Shown> shown_in(const std::string& document) {
    const std::string prompt = "    $ umbra78 ", indent = "    ";
    std::vector<Shown> all;
    std::istringstream in(document);
    bool inside = false;
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with(prompt)) {
            all.push_back({line.substr(prompt.size()), {""}});
            inside = true;
        } else if (inside && line == indent + "...") {
            all.back().chunks.emplace_back();
        } else if (inside && line.starts_with(indent)) {
            all.back().chunks.back() += line.substr(indent.size()) + "\n";
        } else {
            inside = false;
        }
    }
    return all;
}

TEST_F(Documents, ShowWhatTheProgramPrints) {
    int compared = 0;
    for (const char* name : {"README.md", "hw/README.md"}) {
        for (const Shown& shown : shown_in(content(source + name))) {
            std::string arguments = shown.arguments;
            const std::string relative = "tools/scenes/";
            for (std::size_t at = 0; (at = arguments.find(relative, at)) != std::string::npos;
                 at += source.size() + relative.size())
                arguments.insert(at, source);
            const Ran ran = run(arguments);
            EXPECT_EQ(ran.exit_code, 0) << ran.err;
            std::size_t from = 0;
            for (const std::string& chunk : shown.chunks) {
                const std::size_t at = ran.out.find(chunk, from);
                ASSERT_NE(at, std::string::npos) << name << " shows\n" << chunk << "but umbra78 "
                                                 << arguments << " prints\n" << ran.out;
                from = at + chunk.size();
                compared += chunk.empty() ? 0 : 1;
            }
        }
    }
    EXPECT_GE(compared, 1) << "no command is shown";
}

// The README's table of the figures.
TEST_F(Documents, TableOfTheFigures) {
    const std::string readme = content(source + "README.md");
    const Ran ran = run("figures --json --no-scenes --out out");
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const json report = parse_json(ran.out);
    const json& figures = report["figures"];
    ASSERT_EQ(figures.size(), 6u);
    for (const json& figure : figures) {
        std::string row = fmt::format("| `{}` | {:.2f} |", figure["hash"].get<std::string>(),
                                      figure["simulated_ms"].get<double>() / 1000);
        // Of a filtered mask the rates are those at half darkness.
        const json& any = figure["error"];
        if (const json& error = any.contains("at_threshold") ? any["at_threshold"] : any;
            error.is_null())
            row += " | |";
        else
            row += fmt::format(" {:.2f} % | {:.2f} % |", 100 * error["false_shadow"].get<double>(),
                               100 * error["false_light"].get<double>());
        const std::string start = fmt::format("\n| {} | ", figure["figure"].get<int>());
        const std::size_t at = readme.find(start);
        ASSERT_NE(at, std::string::npos) << start;
        const std::string line = readme.substr(at + 1, readme.find('\n', at + 1) - at - 1);
        EXPECT_TRUE(line.ends_with(row)) << line << "\nends not with " << row;
    }
}

// hw/README.md's table of figure 4 on every profile.
TEST_F(Documents, TableOfTheProfiles) {
    const std::string text = content(source + "hw/README.md");
    const Ran ran = run("cycles --json");
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const json report = parse_json(ran.out);
    const json& profiles = report[3]["profiles"];
    ASSERT_EQ(profiles.size(), 6u);
    for (const json& p : profiles) {
        const auto number = [&](const char* key) { return p[key].get<double>(); };
        const std::string row =
            fmt::format(" | {:.1f} | {:.1f} | {:.1f} | {:.2f} | ", number("observer_ms"),
                        number("light_ms"), number("transformation_ms"),
                        number("both_views_over_observer"));
        const std::size_t at =
            text.find(fmt::format("\n| `{}` | ", p["profile"].get<std::string>()));
        ASSERT_NE(at, std::string::npos) << p;
        EXPECT_LT(text.find(row, at), text.find('\n', at + 1)) << row;
    }
}

TEST_F(Documents, TableOfTheBands) {
    const Ran ran = run("bands");
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_GT(ran.out.size(), 1000u);
    EXPECT_TRUE(content(source + "tools/paper/BANDS.md").ends_with("\n\n" + ran.out))
        << "umbra78 bands prints\n" << ran.out;
}

}  // namespace
}  // namespace umbra78::tools
