// umbra78 pack and a [stream] as a user has them: by file and by pipe, the same bits as held, the
// same memory for any number, and one line for what is wrong.
#include "tests/support/program.hpp"

#include <nlohmann/json.hpp>

namespace umbra78::tools {
namespace {

using json = nlohmann::ordered_json;
using test::Program;
using test::Ran;

const std::string views = "[observer]\nazimuth = 25\nelevation = 30\n"
                          "[light]\nazimuth = -60\nelevation = 20\n"
                          "[settings]\nxy_bits = 7\nlow_pass = 1\n";
const std::string solids = "[[material]]\nname = \"matte\"\nspecular = 0\n"
                           "[[sphere]]\ncentre = [1, 1, 0]\nradius = 1\nmaterial = \"matte\"\n"
                           "[[triangle]]\na = [-3, 0, 3]\nb = [3, 0, 3]\nc = [0, 0, -4]\n";
const std::string stream = "[stream]\nfile = \"a.u78p\"\n";

json rendered(const Ran& ran) {
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    return json::parse(ran.out, nullptr, false);
}

TEST_F(Program, APackedSceneHasTheHeldOnesBits) {
    write("held.toml", views + solids);
    write("stream.toml", views + stream);
    const Ran packed = run("pack held.toml --out a.u78p");
    EXPECT_EQ(packed.out, "a.u78p: 33 primitives\n") << packed.err;
    for (const char* form : {"post_process", "correct"}) {
        const std::string set = std::string(" --json --set form=") + form;
        const json held = rendered(run("render held.toml --no-truth" + set));
        const json by_file = rendered(run("render stream.toml" + set));
        EXPECT_EQ(held["hashes"], by_file["hashes"]) << form;
        EXPECT_EQ(held["machine"], by_file["machine"]) << form;
        EXPECT_EQ(by_file["patches"], 32);
        EXPECT_EQ(by_file["triangles"], 1);
        EXPECT_EQ(by_file["error"], nullptr);
        EXPECT_EQ(by_file["stream_hash"].get<std::string>().size(), 16u);
    }
}

TEST_F(Program, APipeIsDrawnAsItComes) {
    write("spooled.toml", views + "[stream]\nfile = \"-\"\n");
    run("pack --hills 300 --out a.u78p");
    const json piped = rendered(run("render " + scenes + "hills.toml --json < a.u78p"));
    const json streamed = rendered(run("pack --hills 300 --out - 2> note | " UMBRA78_PROGRAM
                                       " render " + scenes + "hills.toml --json"));
    EXPECT_EQ(piped["hashes"], streamed["hashes"]);
    EXPECT_EQ(streamed["patches"], 300);
    const Ran once = run("pack --hills 300 --out - 2> note | " UMBRA78_PROGRAM
                         " render spooled.toml");
    EXPECT_EQ(once.exit_code, 1);
    EXPECT_EQ(once.err, "umbra78: standard input cannot be read twice, so the scene needs "
                        "stream.largest, observer.target, observer.extent, observer.near, "
                        "observer.far, light.target, light.extent, light.near, light.far; give "
                        "all of them, or --spool\n");
    EXPECT_EQ(run("render " + scenes + "hills.toml <&-").err,
              "umbra78: " + scenes + "hills.toml:25: 'file' in [stream]: cannot read standard "
              "input: Bad file descriptor; give a packed file, or the pipe of one\n");
    EXPECT_EQ(run("pack --hills 3 --out - 2> note | TMPDIR=/missing " UMBRA78_PROGRAM
                  " render spooled.toml --spool").err,
              "umbra78: spooled.toml:11: 'file' in [stream]: cannot read standard input: its copy "
              "in /missing: No such file or directory; set TMPDIR to a folder with room for it\n");
    const Ran spooled = run("pack --hills 300 --out - 2> note | " UMBRA78_PROGRAM
                            " render spooled.toml --spool --json");
    EXPECT_EQ(rendered(spooled)["patches"], 300);
}

// A hundred times as many primitives take no more memory than a tenth more; CI draws 10^5 of them.
TEST_F(Program, AStreamTakesTheMemoryOfABatch) {
    const auto peak_of = [&](const std::string& number) {
        return rendered(run("pack --hills " + number + " --out - 2> note | " UMBRA78_PROGRAM
                            " render " + scenes + "hills.toml --json"))["peak_bytes"].get<double>();
    };
    EXPECT_LT(peak_of("100000"), 1.1 * peak_of("1000"));
}

TEST_F(Program, WhatAStreamLosesIsWarnedOf) {
    run("pack --hills 50 --out a.u78p");
    write("lost.toml", "[observer]\nazimuth = 25\nextent = 5\n[light]\nazimuth = -60\n"
                       "elevation = 20\nextent = 6\nnear = 2\nfar = 9\n" + stream);
    const Ran lost = run("render lost.toml");
    EXPECT_EQ(lost.exit_code, 0);
    EXPECT_NE(lost.err.find("of 50 primitives reach out of the light's picture and may cast no "
                            "shadow; raise light.extent"), std::string::npos)
        << lost.err;
    EXPECT_NE(lost.err.find("of 50 primitives are in the light's window from depth"),
              std::string::npos)
        << lost.err;
}

TEST_F(Program, WhatIsWrongWithAStreamIsOneLine) {
    write("held.toml", views + solids);
    write("stream.toml", views + stream);
    write("small.toml", views + stream + "largest = 2\n");
    run("pack held.toml --out a.u78p");
    const std::string whole = content(folder / "a.u78p");
    const struct {
        std::string arguments, message;
    } cases[] = {
        {"pack --out b.u78p", "give a scene, or --hills N with N from 1 up"},
        {"pack held.toml --layers 2 --out b.u78p",
         "--layers is of --hills; give --hills N, or leave --layers out"},
        {"pack held.toml --hills 3 --out b.u78p", "give a scene or --hills, and not both"},
        {"pack --hills 3 --layers 4 --out b.u78p",
         "--hills takes 1 to 2^32 patches, and --layers 1 to as many"},
        {"pack stream.toml --out b.u78p",
         "stream.toml:10: a scene with a [stream] is drawn by umbra78 render alone; give this "
         "command the scene that the file was packed from"},
        {"plan stream.toml",
         "stream.toml:10: a scene with a [stream] is drawn by umbra78 render alone; give this "
         "command the scene that the file was packed from"},
        {"render stream.toml --error e.png",
         "--error e.png: stream.toml has no exact truth: a stream: its primitives are not held"},
        {"render small.toml",
         "a.u78p: primitive 32 has the coordinate -3, beyond stream.largest = 2; raise it"},
        {"render stream.toml --out a.u78p",
         "cannot write 'a.u78p': it would not be a .u78p file: .png is the only format; name it "
         "'a.png'"},
    };
    for (const auto& c : cases) {
        const Ran ran = run(c.arguments);
        EXPECT_NE(ran.exit_code, 0) << c.arguments;
        EXPECT_EQ(ran.err, "umbra78: " + c.message + "\n") << c.arguments;
        EXPECT_EQ(files(), (std::vector<std::string>{"a.u78p", "held.toml", "small.toml",
                                                     "stream.toml"}))
            << c.arguments;
    }
    write("a.u78p", whole.substr(0, 3000));
    EXPECT_EQ(run("render stream.toml").err,
              "umbra78: a.u78p: it ends at byte 3000, before its end block; write it again, with "
              "umbra78 pack or as tools/stream/packed.hpp says\n");
    EXPECT_EQ(content(folder / "a.u78p"), whole.substr(0, 3000));
}

}  // namespace
}  // namespace umbra78::tools
