// The models: the stored files are what the command prints, and their surfaces have no gaps.
#include "tests/support/program.hpp"
#include "tools/io/text_formats.hpp"
#include "tools/sculpt/model.hpp"

#include <nlohmann/json.hpp>

#include <map>
#include <set>
#include <sstream>

namespace umbra78::tools {
namespace {

using test::Program;
using test::Ran;

const std::filesystem::path folder_of_models = UMBRA78_SOURCE_DIR "/tools/scenes/models";

// The numbers of a .bpt text, in ten-thousandths, by the comment before them.
using WholePoint = std::array<long, 3>;
using WholeNet = std::array<WholePoint, 16>;
struct ReadBpt {
    std::size_t declared = 0, patches = 0;
    std::map<std::string, std::vector<WholeNet>> parts;
};

ReadBpt read_bpt(const std::string& text) {
    ReadBpt read;
    std::istringstream in(text);
    std::string line, part;
    const auto next = [&] {
        while (std::getline(in, line) && line.starts_with("#")) part = line.substr(2);
        return !in.eof();
    };
    if (next()) read.declared = std::stoul(line);
    while (next()) {
        EXPECT_EQ(line, "3 3");
        WholeNet net;
        for (WholePoint& point : net) {
            EXPECT_TRUE(next());
            std::istringstream numbers(line);
            for (long& whole : point) {
                double number = 0;
                EXPECT_TRUE(numbers >> number) << line;
                whole = std::lround(number * 10000);
            }
        }
        read.parts[part].push_back(net);
        ++read.patches;
    }
    return read;
}

using Border = std::array<WholePoint, 4>;

std::array<Border, 4> borders(const WholeNet& p) {
    return {{{p[0], p[1], p[2], p[3]},
             {p[12], p[13], p[14], p[15]},
             {p[0], p[4], p[8], p[12]},
             {p[3], p[7], p[11], p[15]}}};
}

// The borders of a part that are no points, each in the direction from its lesser end, and how many
// patches have them.
std::map<Border, int> counted_borders(const std::vector<WholeNet>& part) {
    std::map<Border, int> count;
    for (const WholeNet& net : part)
        for (Border border : borders(net)) {
            if (border.back() < border.front()) std::ranges::reverse(border);
            if (border.front() == border.back()) {
                EXPECT_EQ(border[1], border[0]) << "a border that is a loop";
                EXPECT_EQ(border[2], border[0]) << "a border that is a loop";
                continue;
            }
            ++count[border];
        }
    return count;
}

// Parts that have an end which another part covers.
const std::set<std::string> open_parts{
    "waist", "knobs", "neck", "ears", "goggles", "mouth", "antenna", "right upper arm",
    "left upper arm", "right cuff", "left cuff"};

TEST_F(Program, ModelsAreStoredAsTheyArePrinted) {
    std::set<std::string> files;
    for (const Model& model : models())
        for (const std::string& group : groups_of(model.parts())) {
            const std::string name(model.name), file = name + "-" + group + ".bpt";
            const Ran ran = run("model " + name + " --only " + group);
            EXPECT_EQ(ran.exit_code, 0) << ran.err;
            EXPECT_TRUE(content(folder_of_models / file) == ran.out)
                << file << " is not what umbra78 model " << name << " --only " << group
                << " prints";
            files.insert(file);
        }
    // No file is left of a group that a model had once; models from elsewhere may stand beside.
    for (const auto& entry : std::filesystem::directory_iterator(folder_of_models)) {
        const std::string file = entry.path().filename().string();
        const bool ours = find_model(file.substr(0, file.find('-'))) != nullptr;
        EXPECT_TRUE(!ours || files.contains(file)) << file;
    }
}

TEST(Models, HaveNoGapsBetweenThePatchesOfAPart) {
    std::set<std::string> open;
    for (const Model& model : models()) {
        const ReadBpt read = read_bpt(to_bpt("", model.parts()));
        EXPECT_EQ(read.patches, read.declared);
        for (const auto& [name, part] : read.parts) {
            std::map<std::array<WholePoint, 2>, int> ends;
            for (const auto& [border, count] : counted_borders(part)) {
                EXPECT_LE(count, 2) << model.name << ": " << name;
                EXPECT_EQ((++ends[{border.front(), border.back()}]), 1)
                    << model.name << ": " << name << ": two borders share their ends only";
                if (count == 1) open.insert(name);
            }
        }
    }
    EXPECT_EQ(open, open_parts);
}

TEST(Models, TheRobotHasMorePatchesThanThePapers) {
    EXPECT_GT(read_bpt(to_bpt("", robot_parts())).patches, 350u);
}

TEST(Models, NoTwoPartsHaveTheSameName) {
    for (const Model& model : models()) {
        std::set<std::string> names;
        for (const Part& part : model.parts())
            EXPECT_TRUE(names.insert(part.name).second) << model.name << ": " << part.name;
    }
}

TEST(Models, DecimalsAreRoundedToFourDigits) {
    Net net{};
    net[0] = {-0.00004, 0.00005, -0.00005};
    net[1] = {1.5, -20, 0.123449};
    const std::string text = to_bpt("Title", {{"group", "part", {net}}});
    EXPECT_TRUE(text.starts_with("# Title\n1\n# part\n3 3\n0 0.0001 -0.0001\n1.5 -20 0.1234\n"
                                 "0 0 0\n")) << text;
}

TEST_F(Program, ModelSummaryAndFile) {
    const Ran ran = run("model smile --only teeth --out teeth.bpt --json");
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const auto summary = parse_json(ran.out);
    const ReadBpt read = read_bpt(content(folder / "teeth.bpt"));
    EXPECT_EQ(summary["patches"], read.patches);
    EXPECT_EQ(summary["parts"].size(), read.parts.size());
    WholePoint low{1 << 30, 0, 0};
    for (const auto& [name, part] : read.parts)
        for (const WholeNet& net : part)
            for (const WholePoint& point : net) low[0] = std::min(low[0], point[0]);
    EXPECT_EQ(std::lround(summary["box"]["low"][0].get<double>() * 10000), low[0]);
    EXPECT_EQ(files(), std::vector<std::string>{"teeth.bpt"});
    EXPECT_EQ(run("model smile --only teeth --out -").out, content(folder / "teeth.bpt"));
}

TEST_F(Program, ModelsAndGroupsThatAreNotThere) {
    const Ran model = run("model teapot"), group = run("model robot --only bodi");
    EXPECT_EQ(model.exit_code, 1);
    EXPECT_EQ(model.err, "umbra78: there is no model 'teapot'; known here: robot, smile, knot\n");
    EXPECT_EQ(group.exit_code, 1);
    EXPECT_EQ(group.err, "umbra78: --only bodi: the model 'robot' has no such group; did you mean "
                         "'body'?\n");
    EXPECT_EQ(model.out + group.out, "");
}

}  // namespace
}  // namespace umbra78::tools
