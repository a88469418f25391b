// Outputs destroy nothing: no input, no link, no device, no mode; and whatever ends the program
// early, nothing torn is left and its exit code says so.
#include "tests/support/program.hpp"
#include "tools/io/files.hpp"

#include <nlohmann/json.hpp>
#include <sys/stat.h>

namespace umbra78::tools {
namespace {

namespace fs = std::filesystem;
using json = nlohmann::ordered_json;
using test::Ran;
using Names = std::vector<std::string>;

const std::string scene = "[light]\nazimuth = 30\n[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n"
                          "[settings]\nxy_bits = 5\n";

struct Outputs : test::Program {
    void SetUp() override {
        Program::SetUp();
        write("s.toml", scene);
    }
    // Exit code 1 or 2, one line on standard error, nothing on standard output.
    void expect_refused(const std::string& arguments, const std::string& message) const {
        const Ran ran = run(arguments);
        EXPECT_NE(ran.exit_code, 0) << arguments;
        EXPECT_EQ(ran.err, "umbra78: " + message + "\n") << arguments;
        EXPECT_EQ(ran.out, "") << arguments;
    }
    bool is_png(const char* name) const { return content(folder / name).starts_with("\x89PNG"); }
    // The exit code of a line of shell in which U is the program.
    int shell(const std::string& line) const {
        return run("--version >/dev/null; U=" UMBRA78_PROGRAM "; ( " + line + " )").exit_code;
    }
};

TEST_F(Outputs, AreNeverAnInput) {
    write("x.png", scene);
    write("other.toml", scene);
    fs::create_symlink("s.toml", folder / "link.png");
    fs::create_hard_link(folder / "s.toml", folder / "hard.vcd");
    const auto input = [](const std::string& name) {
        return "cannot write '" + name + "': it is an input of this command; name another file";
    };
    for (const char* out : {"s.toml", "./s.toml", "link.png", "hard.vcd"}) {
        expect_refused("render s.toml --out " + std::string(out), input(out));
        expect_refused("cycles s.toml --vcd " + std::string(out), input(out));
        expect_refused("trace s.toml --pixel 3,3 --vcd " + std::string(out), input(out));
    }
    expect_refused("render link.png --out s.toml", input("s.toml"));
    expect_refused("render x.png", input("x.png"));  // whose picture would be x.png
    EXPECT_EQ(content(folder / "s.toml"), scene);
    EXPECT_EQ(content(folder / "x.png"), scene);

    // Files of a folder, too: here a buffer and a study's row log.
    fs::create_directory(folder / "b");
    write("b/mask.pgm", scene);
    expect_refused("render b/mask.pgm --out a.png --buffers b", input("b/mask.pgm"));
    write("b/error-time.partial.jsonl", scene + "# no newline at the end");
    expect_refused("study error-time b/error-time.partial.jsonl --quick --out b",
                   input("b/error-time.partial.jsonl"));
    EXPECT_EQ(content(folder / "b/error-time.partial.jsonl"), scene + "# no newline at the end");
    EXPECT_EQ(files(), (Names{"b/error-time.partial.jsonl", "b/mask.pgm", "hard.vcd", "link.png",
                              "other.toml", "s.toml", "x.png"}));
}

TEST_F(Outputs, FollowLinksAndKeepTheMode) {
    write("real.png", "old");
    fs::permissions(folder / "real.png", fs::perms(0640));
    fs::create_directory(folder / "d");
    fs::create_symlink("../real.png", folder / "d/link.png");
    fs::create_symlink("later.png", folder / "d/dangling.png");
    for (const char* out : {"d/link.png", "d/dangling.png"})
        EXPECT_EQ(run("render s.toml --out " + std::string(out)).exit_code, 0) << out;
    EXPECT_TRUE(fs::is_symlink(folder / "d/link.png"));
    EXPECT_TRUE(fs::is_symlink(folder / "d/dangling.png"));
    EXPECT_TRUE(is_png("real.png"));
    EXPECT_TRUE(is_png("d/later.png"));
    EXPECT_EQ(fs::status(folder / "real.png").permissions(), fs::perms(0640));
}

TEST_F(Outputs, AreWrittenInPlaceWhereThereIsNoFile) {
    ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
    EXPECT_EQ(shell("timeout 60 cat fifo >p.png & $U render s.toml --out fifo >/dev/null; r=$?; "
                    "wait; exit $r"), 0);
    EXPECT_TRUE(is_png("p.png"));
    EXPECT_TRUE(fs::is_fifo(folder / "fifo"));
    if (::mknod((folder / "null").c_str(), S_IFCHR | 0666, 1 << 8 | 3) != 0)
        GTEST_SKIP() << "only root makes devices";
    run("render s.toml --out null");
    EXPECT_TRUE(fs::is_character_file(folder / "null"));
}

TEST_F(Outputs, MayBeStandardOutput) {
    ASSERT_EQ(run("render s.toml --out a.png").exit_code, 0);
    for (const char* out : {"-", "/dev/stdout"}) {
        EXPECT_EQ(shell("$U render s.toml --json --out " + std::string(out) +
                        " 2>report.json | cat >p.png"), 0);
        EXPECT_EQ(content(folder / "p.png"), content(folder / "a.png")) << out;
        EXPECT_EQ(parse_json(content(folder / "report.json"))["picture"], out);
    }
    const Ran dump = run("cycles s.toml --vcd -");
    EXPECT_TRUE(dump.out.starts_with("$comment")) << dump.out.substr(0, 80);
    EXPECT_NE(dump.err.find("roughly twice"), std::string::npos);
    expect_refused("figures --out -", "cannot make the folder '-': standard output is no folder; "
                                      "name one, or ./- for a folder of this name");
}

TEST_F(Outputs, SayTheirFormats) {
    write("two.names.toml", scene);
    const auto only = [](const std::string& name, const std::string& its, const std::string& ending,
                         const std::string& better) {
        return "cannot write '" + name + "': it would not be a " + its + " file: " + ending +
               " is the only format; name it '" + better + "'";
    };
    expect_refused("render s.toml --out x.jpg", only("x.jpg", ".jpg", ".png", "x.png"));
    expect_refused("render s.toml --out b/x.Jpeg --buffers b",
                   only("b/x.Jpeg", ".jpeg", ".png", "b/x.png"));
    expect_refused("cycles s.toml --vcd x.png", only("x.png", ".png", ".vcd", "x.vcd"));
    const std::string empty = ": it is empty; give a value, or leave it out; see umbra78 ";
    expect_refused("render s.toml --out ''", "--out" + empty + "render --help");
    expect_refused("render s.toml --buffers ''", "--buffers" + empty + "render --help");
    expect_refused("render ''", "scene" + empty + "render --help");
    expect_refused("figures --out ''", "--out" + empty + "figures --help");
    expect_refused("trace s.toml --pixel 3,3 --vcd ''", "--vcd" + empty + "trace --help");
    expect_refused("study error-time --out ''", "--out" + empty + "study error-time --help");
    expect_refused("study merge '' a.jsonl", "out" + empty + "study merge --help");
    expect_refused("study merge a ''", "parts" + empty + "study merge --help");
    EXPECT_EQ(files(), (Names{"s.toml", "two.names.toml"}));
    for (const char* out : {"a.PNG", "a"})
        EXPECT_EQ(run("render s.toml --out " + std::string(out)).exit_code, 0) << out;
    EXPECT_EQ(run("render two.names.toml").exit_code, 0);
    EXPECT_EQ(files(), (Names{"a", "a.PNG", "s.toml", "two.names.png", "two.names.toml"}));
}

TEST_F(Outputs, APictureMayBeInTheFolderOfTheBuffers) {
    EXPECT_EQ(run("render s.toml --buffers b/c --out b/c/m.png").exit_code, 0);
    EXPECT_TRUE(is_png("b/c/m.png"));
    expect_refused("render s.toml --buffers d --out dd/m.png",
                   "cannot write 'dd/m.png': No such file or directory; create its folder first");
    EXPECT_FALSE(fs::exists(folder / "d"));
}

// As another user than root, who may write anywhere.
TEST_F(Outputs, APlaceThatMayNotBeWrittenIsRefusedBeforeTheWork) {
    const std::string user =
        ::geteuid() == 0 ? "setpriv --reuid=65534 --regid=65534 --clear-groups " : "";
    fs::permissions(folder, fs::perms(0777));
    fs::create_directories(folder / "closed");
    write("kept.png", "kept");
    fs::permissions(folder / "closed", fs::perms(0555));
    fs::permissions(folder / "kept.png", fs::perms(0444));
    const auto as_user = [&](const std::string& arguments) {
        return run("--version >/dev/null; " + user + UMBRA78_PROGRAM " " + arguments);
    };
    if (as_user("render s.toml").exit_code != 0) GTEST_SKIP() << "no other user can be had here";
    for (const auto& [arguments, doing] :
         {std::pair<std::string, std::string>{"render none.toml --out closed/a.png",
                                              "write 'closed/a.png'"},
          {"render none.toml --out kept.png", "write 'kept.png'"},
          {"render none.toml --buffers closed", "write 'closed'"},
          {"render none.toml --buffers closed/b/c", "make the folder 'closed/b/c'"},
          {"cycles none.toml --vcd closed/a.vcd", "write 'closed/a.vcd'"},
          {"animate none.toml --frames 2 --light 0:1 --out closed", "write 'closed'"},
          {"study error-time --quick --out closed/x", "make the folder 'closed/x'"},
          {"study merge closed none.jsonl", "write 'closed'"},
          {"figures --out closed", "write 'closed'"}}) {
        const Ran ran = as_user(arguments);
        EXPECT_EQ(ran.exit_code, 1) << arguments;
        EXPECT_EQ(ran.err, "umbra78: cannot " + doing + ": Permission denied; name a place that "
                           "can be written to\n") << arguments;
    }
    EXPECT_EQ(content(folder / "kept.png"), "kept");
    fs::permissions(folder / "closed", fs::perms(0755));
}

// File names are bytes; JSON is UTF-8.
TEST_F(Outputs, NamesNeedNotBeUtf8) {
    write("\xFF.toml", scene);
    for (const char* command : {"render", "animate --frames 2 --light 0:1", "plan"}) {
        const Ran ran = run(std::string(command) + " --json \xFF.toml");
        EXPECT_EQ(ran.exit_code, 0) << command << ran.err;
        EXPECT_EQ(parse_json(ran.out)["scene"], "\xEF\xBF\xBD.toml") << command;
    }
    const Ran study =
        run("study error-time --quick --vary bias=1 --no-host-times --out a \xFF.toml");
    EXPECT_EQ(study.exit_code, 0) << study.err;
    EXPECT_EQ(run("study verify a/error-time.csv").exit_code, 0);
}

// No signal (a shell says 134 for SIGABRT), and not 0 where something was lost.
TEST_F(Outputs, AClosedOrFullStreamIsAFailure) {
    for (const char* none : {"&-", "/dev/full"}) {
        const std::string out = std::string(" >") + none, err = std::string(" 2>") + none;
        for (const char* command : {"--help", "--version", "render --help", "settings",
                                    "render s.toml", "study"})
            EXPECT_EQ(shell("$U " + (command + out)), 1) << command << out;
        EXPECT_EQ(shell("$U render none.toml" + err), 1) << err;
        EXPECT_EQ(shell("$U frobnicate" + err), 2) << err;
        EXPECT_EQ(shell("$U render none.toml" + out + err), 1) << err;
        // A warning that is lost, then none.
        EXPECT_EQ(shell("$U render s.toml --set light.extent=0.5" + err), 1) << err;
        EXPECT_TRUE(is_png("s.png"));  // the picture is not
        EXPECT_EQ(shell("$U render s.toml" + err), 0) << err;
        // Nothing of what is printed goes into a file that was given a stream's number.
        EXPECT_EQ(shell("$U render s.toml --out t.png <&-" + out + err), 1);
        EXPECT_EQ(content(folder / "t.png"), content(folder / "s.png"));
    }
    run("settings >/dev/full 2>e #");
    EXPECT_EQ(content(folder / "e"), "umbra78: cannot print: No space left on device; give a place "
                                     "that can be written to\n");
}

TEST_F(Outputs, ASignalLeavesNoPartialFile) {
    ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
    // Nobody reads the pipe, so the program waits with its buffers written, but not in place.
    // (A shell's background commands ignore INT.)
    for (const auto& [signal, number] : {std::pair{"TERM", 15}, {"HUP", 1}}) {
        const std::string line =
            "$U render s.toml --out fifo --buffers b & p=$!; n=0; "
            "while [ $(ls b 2>/dev/null | grep -c partial) -lt 14 ] && [ $n -lt 1000 ]; do "
            "sleep 0.01; n=$((n + 1)); done; kill -" + std::string(signal) + " $p; wait $p";
        EXPECT_EQ(shell(line), 128 + number) << signal;
        EXPECT_EQ(files(), Names{"s.toml"}) << signal;
    }
}

TEST_F(Outputs, ALimitOfTheFileSizeLeavesNothing) {
    const Ran ran = run("--version >/dev/null; ulimit -f 8; " UMBRA78_PROGRAM
                        " render s.toml --set xy_bits=6 --out a.png --buffers b");
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_NE(ran.err.find("b/observer_z.pgm': File too large; raise the limit of a file's size "
                           "(ulimit -f)\n"), std::string::npos) << ran.err;
    EXPECT_EQ(files(), Names{"s.toml"});
    EXPECT_FALSE(fs::exists(folder / "b"));
}

TEST_F(Outputs, ScenesOfOtherEditorsAreRead) {
    std::string other = "\xEF\xBB\xBF";
    for (const char letter : scene) other += letter == '\n' ? "\r\n" : std::string(1, letter);
    write("other.toml", other);
    const auto hashes = [&](const char* name) {
        return parse_json(run(std::string("render --json --out a.png ") + name).out)["hashes"];
    };
    EXPECT_EQ(hashes("other.toml"), hashes("s.toml"));
    write("bad.toml", other + "x = 1\r\n");
    EXPECT_EQ(run("render bad.toml").err.find("umbra78: bad.toml:8: unknown key 'x' in "), 0u);
}

}  // namespace
}  // namespace umbra78::tools
