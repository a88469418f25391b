// Every study's quick run as the documents name it: it ends, and no case of it fails.
#include "tests/support/program.hpp"
#include "tools/cli/study_list.hpp"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

namespace umbra78::tools {
namespace {

struct LongQuick : test::Program {};

TEST_F(LongQuick, RunsOfAllStudiesEnd) {
    for (const auto& each : study::studies()) {
        const std::string name(each->name());
        SCOPED_TRACE(name);
        const test::Ran ran = run("study " + name + " --quick --out " + name);
        ASSERT_EQ(ran.exit_code, 0) << ran.err;
        const auto json = parse_json(content(folder / name / (name + ".json")));
        EXPECT_GT(json["cases"], 0);
        EXPECT_EQ(json["failed_cases"], 0);
    }
}

}  // namespace
}  // namespace umbra78::tools
