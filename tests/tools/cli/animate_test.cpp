// umbra78 animate: each picture equals the one of `umbra78 render`, unchanged stages are kept, and
// an interrupted sequence continues to the same files.
#include "tests/support/paths.hpp"
#include "tests/support/program.hpp"
#include "tools/render/sequence_manifest.hpp"
#include "tools/scene/azimuth_sweep.hpp"

#include <nlohmann/json.hpp>

#include <map>

namespace umbra78::tools {
namespace {

namespace fs = std::filesystem;
using json = nlohmann::ordered_json;
using test::Ran;

class Animate : public test::Program {
protected:
    json animate(const std::string& arguments) const {
        const Ran ran = run("animate --set xy_bits=6 --json " + arguments);
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        EXPECT_EQ(ran.err, "");  // no progress where there is no terminal
        return parse_json(ran.out);
    }
    std::map<std::string, std::string> contents(const char* of) const {
        std::map<std::string, std::string> all;
        for (const std::string& name : files())
            if (name.starts_with(std::string(of) + "/"))
                all[name.substr(std::string(of).size())] = content(folder / name);
        return all;
    }
};

std::vector<bool> drawn(const json& report) {
    std::vector<bool> all;
    for (const json& row : report["frames"]) all.push_back(row["drawn"]);
    return all;
}

TEST(AzimuthSweep, IsExact) {
    const AzimuthSweep sweep = read_sweep("light", "-100:80.5");
    EXPECT_EQ(sweep.override_at(1, 7), "light.azimuth=-100");
    EXPECT_EQ(sweep.at(7, 7), "80.5");
    EXPECT_EQ(sweep.at(4, 7), "-9.75");
    EXPECT_EQ(sweep.at(1, 1), "-100");
    EXPECT_EQ(read_sweep("light", "0:1").at(2, 4), "0.3333282470703125");  // 21845 / 2^16
    EXPECT_EQ(read_sweep("light", "1:0").at(3, 4), "0.3333282470703125");
    EXPECT_EQ(read_sweep("observer", "30:30").at(5, 9), "30");
    for (const char* wrong : {"", ":", "1", "1:", ":1", "a:b", "1:2:3", "0:361", "-400:0", "1 2"})
        EXPECT_THROW(read_sweep("light", wrong), SceneError) << wrong;
}

TEST_F(Animate, EachPictureIsRenders) {
    const json report =
        animate(figures_scene + " --frames 3 --light -100:80 --observer 0:-30 --out a");
    ASSERT_EQ(report["frames"].size(), 3u);
    EXPECT_EQ(files(), (std::vector<std::string>{"a/frame_0001.png", "a/frame_0002.png",
                                                 "a/frame_0003.png", "a/frames.json"}));
    for (const json& row : report["frames"]) {
        const json render = parse_json(
            run("render --no-truth --json --set xy_bits=6 " + figures_scene +
                " --set light.azimuth=" + row["light_azimuth"].get<std::string>() +
                " --set observer.azimuth=" + row["observer_azimuth"].get<std::string>() +
                " --out p.png").out);
        EXPECT_EQ(render["hashes"]["picture"], row["picture"]);
        const auto png = read_png_gray(folder / "a" / row["file"].get<std::string>());
        const auto other = read_png_gray(folder / "p.png");
        ASSERT_TRUE(png && other);
        EXPECT_EQ(png->samples, other->samples);
    }
}

TEST_F(Animate, KeepsWhatStandsStill) {
    const auto kept = [&](const std::string& arguments) {
        return animate(arguments)["frames"][1]["kept"];
    };
    EXPECT_EQ(kept(figures_scene + " --frames 2 --light -100:80 --out a"), json{"same_depth"});
    EXPECT_EQ(kept(figures_scene + " --frames 2 --observer 0:9 --out b"), json{"same_light_map"});
    EXPECT_EQ(kept(scenes + "lamp.toml --frames 2 --observer 25:60 --out c"),
              json{"same_light_map"});
    EXPECT_EQ(kept(figures_scene + " --frames 2 --observer 0:9 --light 0:9 --out d"),
              json::array());
    const json still = animate(figures_scene + " --frames 2 --light 0:0 --out e");
    EXPECT_EQ(still["frames"][1]["kept"].size(), 5u);
    EXPECT_EQ(still["frames"][1]["picture"], still["frames"][0]["picture"]);
}

TEST_F(Animate, DrawsOnlyWhatIsNotThere) {
    const std::string arguments = figures_scene + " --frames 4 --light -100:80 --out a";
    EXPECT_EQ(drawn(animate(arguments)), (std::vector<bool>{true, true, true, true}));
    const auto whole = contents("a");
    EXPECT_EQ(drawn(animate(arguments)), (std::vector<bool>{false, false, false, false}));
    EXPECT_EQ(contents("a"), whole);

    fs::remove(folder / "a/frame_0003.png");
    fs::resize_file(folder / "a/frame_0002.png", 300);
    EXPECT_EQ(drawn(animate(arguments)), (std::vector<bool>{false, true, true, false}));
    EXPECT_EQ(contents("a"), whole);

    fs::copy_file(folder / "a/frame_0001.png", folder / "a/frame_0004.png",
                  fs::copy_options::overwrite_existing);
    EXPECT_EQ(drawn(animate(arguments)), (std::vector<bool>{false, false, false, true}));
    EXPECT_EQ(contents("a"), whole);

    fs::remove(folder / "a/frames.json");
    EXPECT_EQ(drawn(animate(arguments)), (std::vector<bool>{true, true, true, true}));
    EXPECT_EQ(contents("a"), whole);
}

TEST_F(Animate, SaysWhatAnotherSequenceLeft) {
    const std::string to_a = " --frames 5 --light 0:9 --out a", scene = figures_scene;
    animate(scene + to_a);
    write("a/frame_0009.txt", "");
    write("a/frame_x.png", "");
    const Ran ran = run("animate --set xy_bits=6 " + scene + " --frames 3 --light 0:9 --out a");
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_EQ(ran.err, "umbra78: warning: a also holds 2 frames of another sequence "
                       "(frame_0004.png to frame_0005.png); remove them, or name another folder "
                       "with --out\n");
    EXPECT_EQ(contents("a").count("/frame_0005.png"), 1u);  // it removes nothing itself
    const Ran four = run("animate --json --set xy_bits=6 " + scene + " --frames 4 --light 0:9 "
                         "--out a");
    EXPECT_EQ(parse_json(four.out)["warnings"].size(), 1u);
    EXPECT_NE(four.err.find("a also holds a frame of another sequence (frame_0005.png);"),
              std::string::npos) << four.err;
    animate(scene + to_a);  // which holds no warning
}

TEST_F(Animate, AChangedInputIsDrawnAgain) {
    const std::string text = content(figures_scene);
    write("s.toml", text);
    const std::string arguments = "s.toml --frames 2 --light -100:80";
    EXPECT_EQ(animate(arguments)["drawn"], 2);
    EXPECT_EQ(files(), (std::vector<std::string>{"s.toml", "s/frame_0001.png",
                                                 "s/frame_0002.png", "s/frames.json"}));
    write("s.toml", "# the same scene\n" + text);
    EXPECT_EQ(animate(arguments)["drawn"], 0);
    EXPECT_EQ(animate(arguments + " --set bias=100")["drawn"], 2);
    EXPECT_EQ(animate(arguments)["drawn"], 2);
    EXPECT_EQ(drawn(animate("s.toml --frames 2 --light -100:70")),
              (std::vector<bool>{false, true}));
    std::string moved = text;
    moved.replace(moved.find("1.18"), 4, "1.17");
    write("s.toml", moved);
    EXPECT_EQ(animate("s.toml --frames 2 --light -100:70")["drawn"], 2);
}

// Interrupted as soon as the second picture is there: an error of one line, no half file, and the
// same command makes what it would have made.
TEST_F(Animate, GoesOnWhereItWasInterrupted) {
    const std::string arguments =
        figures_scene + " --frames 25 --observer 0:40 --set xy_bits=8 --out ";
    const std::string cut =
        "animate " + arguments + "a & p=$!; n=0; while [ ! -e a/frame_0002.png ] && "
        "[ $n -lt 2000 ]; do sleep 0.01; n=$((n + 1)); done; kill -INT $p; wait $p";
    const Ran ran = run("settings >/dev/null; { " UMBRA78_PROGRAM " " + cut + "; }");
    if (ran.exit_code == 0) GTEST_SKIP() << "it was done before it was interrupted";
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_EQ(ran.err.find("umbra78: interrupted after frame "), 0u) << ran.err;
    EXPECT_EQ(ran.err.find('\n'), ran.err.size() - 1);
    const auto left = contents("a");
    EXPECT_LT(left.size(), 26u);
    for (const auto& [name, bytes] : left)
        EXPECT_EQ(name.find(".partial"), std::string::npos) << name;
    const json rest = parse_json(run("animate --json " + arguments + "a").out);
    EXPECT_LT(rest["drawn"], 24);
    EXPECT_EQ(run("animate --json " + arguments + "b").exit_code, 0);
    EXPECT_EQ(contents("a"), contents("b"));
}

TEST_F(Animate, PrintsARowAFrame) {
    const Ran ran = run("animate " + figures_scene +
                        " --set xy_bits=5 --frames 2 --light 0:1 --out a");
    EXPECT_EQ(ran.err, "");
    EXPECT_EQ(ran.out.find("frame_0001.png  light 0  nothing kept  "), 0u) << ran.out;
    EXPECT_NE(ran.out.find("\nframe_0002.png  light 1  same_depth  "), std::string::npos);
    EXPECT_NE(ran.out.find("\na: 2 frames, 2 drawn, 0 already there; "), std::string::npos);
}

TEST_F(Animate, AFailureIsOneLine) {
    write("file", "");
    fs::create_directory(folder / "other");
    write("other/frames.json", "[1, 2]");
    const struct {
        std::string arguments, message;
    } cases[] = {
        {scenes + "lamp.toml --frames 2 --light 0:9",
         "--light 0:9: the light of " + scenes + "lamp.toml is given by its position and has no "
         "azimuth; move the observer, or give the light kind = \"directional\""},
        {figures_scene + " --frames 2", "nothing moves; give --light A:B, --observer A:B or both"},
        {figures_scene + " --frames 2 --light 5",
         "--light 5: write two azimuths in degrees, such as -100:80"},
        {figures_scene + " --frames 2 --light 0:400",
         "--light 0:400: an azimuth is 400; its range is -360 .. 360"},
        {figures_scene + " --frames 2 --light 0:9 --set light.azimuth=3",
         "--set light.azimuth=3: --light sets it, too; leave one out"},
        {"none.toml --frames 2 --light 0:9",
         "cannot read 'none.toml': No such file or directory; give the path of a scene file"},
        {figures_scene + " --frames 2 --light 0:9 --out other",
         "'other/frames.json' is not a list of frames; remove it, or name another folder with "
         "--out"},
        {figures_scene + " --frames 2 --light 0:9 --out file",
         "cannot make the folder 'file': Not a directory; name a place that can be written to"},
    };
    for (const auto& [arguments, message] : cases) {
        const Ran ran = run("animate " + arguments);
        EXPECT_EQ(ran.exit_code, 1) << arguments;
        EXPECT_EQ(ran.err, "umbra78: " + message + "\n");
        EXPECT_EQ(ran.out, "");
    }
    EXPECT_EQ(run("animate " + figures_scene + " --frames 0 --light 0:9").exit_code, 2);
    EXPECT_EQ(run("animate " + figures_scene + " --light 0:9").err,
              "umbra78: --frames is required; see umbra78 animate --help\n");
    EXPECT_EQ(files(), (std::vector<std::string>{"file", "other/frames.json"}));
}

}  // namespace
}  // namespace umbra78::tools
