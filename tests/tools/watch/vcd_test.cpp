// The value change dump, read back: its grammar, and its values against a second machine's.
#include "tools/watch/vcd.hpp"

#include "tests/support/effort.hpp"
#include "tests/tools/watch/traced.hpp"
#include "tools/paper/figure_set.hpp"
#include "tools/watch/machine_watch.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <sstream>

namespace umbra78::tools {
namespace {

using test::Random;

// A plain reader of the format: signals by their full names, and the state at any time.
class Dump {
public:
    explicit Dump(const std::string& text) : in_(text) {
        std::string word;
        while (in_ >> word && word != "$enddefinitions") declaration(word);
        skip();
        EXPECT_TRUE(scope_.empty());
        while (in_ >> word) change(word);
    }

    // Of a signal at a time; none before it is set.
    std::optional<std::uint64_t> at(const std::string& name, std::uint64_t ns) const {
        const auto signal = signals_.find(name);
        EXPECT_NE(signal, signals_.end()) << name;
        if (signal == signals_.end()) return {};
        const auto& changes = changes_.at(signal->second.id);
        auto next = changes.upper_bound(ns);
        if (next == changes.begin()) return {};
        return std::prev(next)->second;
    }
    // The same as a signed word of the signal's bits.
    std::optional<std::int64_t> word(const std::string& name, std::uint64_t ns) const {
        const auto value = at(name, ns);
        if (!value) return {};
        const int spare = 64 - signals_.at(name).bits;
        return static_cast<std::int64_t>(*value << spare) >> spare;
    }
    bool has(const std::string& name) const { return signals_.contains(name); }
    int bits(const std::string& name) const { return signals_.at(name).bits; }
    std::uint64_t last_time() const { return time_; }
    const std::vector<std::uint64_t>& times() const { return times_; }

private:
    struct Signal {
        std::string id;
        int bits;
    };
    void skip() {
        std::string word;
        while (in_ >> word && word != "$end") {}
    }
    void declaration(const std::string& word) {
        std::string kind, name;
        if (word == "$scope") {
            in_ >> kind >> name;
            EXPECT_EQ(kind, "module");
            scope_.push_back(name);
        } else if (word == "$upscope") {
            ASSERT_FALSE(scope_.empty());
            scope_.pop_back();
        } else if (word == "$timescale") {
            in_ >> name;
            EXPECT_EQ(name, "1ns");
        } else if (word == "$var") {
            Signal s;
            in_ >> kind >> s.bits >> s.id >> name;
            EXPECT_TRUE(ids_.insert(s.id).second) << "an identifier twice";
            std::string full;
            for (const std::string& part : scope_) full += part + ".";
            EXPECT_TRUE(signals_.emplace(full + name, s).second) << full + name << " twice";
            changes_[s.id];
        } else {
            EXPECT_EQ(word, "$comment");
        }
        skip();
    }
    void change(const std::string& word) {
        if (word == "$dumpvars" || word == "$end") return;
        if (word[0] == '#') {
            const std::uint64_t ns = std::stoull(word.substr(1));
            EXPECT_TRUE(times_.empty() || ns > time_) << "time goes back";
            times_.push_back(time_ = ns);
            return;
        }
        std::string value = word.substr(0, 1), id = word.substr(1);
        if (word[0] == 'b') {
            value = word.substr(1);
            in_ >> id;
        }
        ASSERT_TRUE(ids_.contains(id)) << word;
        if (value == "x") return;
        EXPECT_LE(value.size(), 64u);
        changes_[id][time_] = std::stoull(value, nullptr, 2);
    }

    std::istringstream in_;
    std::vector<std::string> scope_;
    std::map<std::string, Signal> signals_;
    std::set<std::string> ids_;
    std::map<std::string, std::map<std::uint64_t, std::uint64_t>> changes_;
    std::uint64_t time_ = 0;
    std::vector<std::uint64_t> times_;
};

using Watch = MachineWatch<hw::Depth32>;

// The words of the unit that has the point, after the cycle.
void expect_words(const Dump& dump, const std::string& scope, std::uint64_t ns,
                  shadow::StageKind kind, const shadow::PointRegisters& f,
                  const shadow::PostProcessPipeline& plan) {
    const auto expect = [&](const char* name, std::int64_t value) {
        EXPECT_EQ(dump.word(scope + name, ns), value) << scope << name;
    };
    const auto expect_code = [&](const char* name, std::uint64_t value) {
        EXPECT_EQ(dump.at(scope + name, ns), value) << scope << name;
    };
    expect_code("px", static_cast<std::uint64_t>(f.px));
    expect_code("py", static_cast<std::uint64_t>(f.py));
    switch (kind) {
        case shadow::StageKind::transform:
            expect("accumulator_x", f.transform.accumulator[0]);
            expect("accumulator_z", f.transform.accumulator[2]);
            if (plan.transform.rounds()) expect("result_y", f.transform.result[1]);
            if (dump.has(scope + "product_y1")) expect("product_y1", f.transform.product[1][1]);
            break;
        case shadow::StageKind::divide:
            expect_code("remainder_x", f.divider.row[0].remainder);
            expect_code("quotient_z", f.divider.row[2].quotient);
            expect("dividend_y", f.divider.dividend[1]);
            break;
        case shadow::StageKind::place:
            expect("code", f.lookup.code);
            expect_code("outside", f.lookup.outside);
            expect("tx", f.lookup.tx);
            break;
        case shadow::StageKind::fetch:
            expect_code("texel_00", f.lookup.texel[0]);
            if (plan.lookup.blends) expect_code("texel_11", f.lookup.texel[3]);
            break;
        case shadow::StageKind::interpolate:
            expect_code("blend", static_cast<std::uint64_t>(f.lookup.blend));
            break;
        case shadow::StageKind::sum:
            expect_code("sum", static_cast<std::uint64_t>(f.lookup.sum));
            break;
        case shadow::StageKind::compare:
            if (plan.lookup.counts())
                expect_code("count", static_cast<std::uint64_t>(f.lookup.count));
            else
                expect_code("shadow", f.lookup.darkness == 255);
            break;
        case shadow::StageKind::write: expect_code("mask", f.lookup.darkness); break;
    }
}

void expect_cycle(const Dump& dump, const Watch& watch, std::uint64_t ns) {
    EXPECT_EQ(dump.at("umbra78.clock", ns), 1u);
    EXPECT_EQ(dump.at("umbra78.cycle", ns), watch.cycle());
    const ReaderCycle& r = watch.reader();
    EXPECT_EQ(dump.at("umbra78.reader.state", ns), std::uint64_t(r.activity));
    EXPECT_EQ(dump.at("umbra78.reader.go", ns), r.released != 0);
    if (r.known && r.activity != ReaderActivity::done) {
        EXPECT_EQ(dump.at("umbra78.reader.code", ns), r.code);
    }
    const auto& machine = watch.machine();
    for (int k = 0; k < machine.chain().stages(); ++k) {
        const StageCycle& s = watch.stage(k);
        const std::string scope =
            "umbra78.s" + std::to_string(k) + "_" + std::string(machine.chain().name(k)) + ".";
        EXPECT_EQ(dump.at(scope + "state", ns), std::uint64_t(s.activity));
        EXPECT_EQ(dump.at(scope + "valid", ns), s.valid);
        EXPECT_EQ(dump.at(scope + "ready", ns), s.ready);
        EXPECT_EQ(dump.at(scope + "point", ns), s.point);
        if (s.slot < 0) continue;
        expect_words(dump, scope, ns, machine.kind(k), machine.flight(s.slot), machine.plan());
    }
}

// A point moves exactly where the one stage is valid and the next is ready.
void expect_transfers(const Dump& dump, const WatchedFrame::Machine& machine, std::uint64_t ns,
                      std::uint64_t next_ns) {
    for (int k = 0; k + 1 < machine.chain().stages(); ++k) {
        const auto scope = [&](int stage) {
            return "umbra78.s" + std::to_string(stage) + "_" +
                   std::string(machine.chain().name(stage)) + ".";
        };
        const auto here = dump.at(scope(k) + "point", ns);
        const bool moves = dump.at(scope(k) + "valid", ns) == 1u &&
                           dump.at(scope(k + 1) + "ready", ns) == 1u;
        if (here == 0u) continue;
        EXPECT_EQ(dump.at(scope(k + 1) + "point", next_ns) == here, moves) << scope(k);
    }
}

TEST(Vcd, EveryCycleOfAnyMachineUnderAnyStalls) {
    Random random;
    std::uint64_t cycles = 0;
    for (int round = 0; round < umbra78::test::effort(24); ++round) {
        const shadow::Settings s = test::random_machine(random);
        const auto frame = test::random_frame(random, s);
        const auto machine = frame->machine();
        const auto holds =
            shadow::test::random_holds(random, machine->chain().stages(), 400, 16);
        VcdOptions options;
        options.cycles = 400;
        options.from = 0;
        options.clock_ns = s.timing.clock_ns;
        options.holds = [&](std::uint64_t t) { return t < holds.size() ? holds[t] : 0; };
        const std::string text = vcd_of(*machine, options);
        const Dump dump(text);
        const auto clock = static_cast<std::uint64_t>(s.timing.clock_ns);
        const std::uint64_t end = machine->cycles();
        EXPECT_EQ(dump.last_time(), end * clock);

        const auto again = frame->machine();
        Watch watch(*again);
        for (std::uint64_t t = 0; t < end; ++t) {
            watch.tick(t < holds.size() ? holds[t] : 0);
            SCOPED_TRACE("round " + std::to_string(round) + " cycle " + std::to_string(t));
            expect_cycle(dump, watch, t * clock);
            EXPECT_EQ(dump.at("umbra78.clock", t * clock + clock / 2), 0u);
            if (t + 1 < end) expect_transfers(dump, *again, t * clock, (t + 1) * clock);
            if (HasFailure()) return;
        }
        EXPECT_EQ(vcd_of(*frame->machine(), options), text) << "not the same twice";
        cycles += end;
    }
    EXPECT_GT(cycles, std::uint64_t(umbra78::test::effort(24)) * 250);
}

// Figure 4's frame from its first visible pixel on, as a file; a value of hw/MACHINE.md in it.
TEST(Vcd, FileOfAFrame) {
    const LoadedScene scene = figures_scene();
    RenderJob job(scene.view(), shadow::figure_settings(4));
    job.render();
    const PixelTrace trace = trace_pixel(job, {80, 180});
    const Path path = std::filesystem::temp_directory_path() /
                      ("umbra78-vcd-" + std::to_string(getpid()) + ".vcd");
    VcdOptions options;
    options.from = trace.first_cycle;
    options.cycles = 64;
    write_vcd(path, job, options);
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    std::filesystem::remove(path);
    const Dump dump(text);
    EXPECT_EQ(dump.times().front(), trace.first_cycle * 200);
    const std::uint64_t written = trace.last_cycle * 200;
    EXPECT_EQ(dump.at("umbra78.s8_write.address", written), 180u * 512 + 80);
    EXPECT_EQ(dump.at("umbra78.s8_write.mask", written), 0u);
    EXPECT_EQ(dump.word("umbra78.s7_compare.shadow", written - 200), 0);
    const std::uint64_t placed = written - 200 * (1 + 1 + 2 + 4);
    EXPECT_EQ(dump.word("umbra78.s4_place.x", placed), 14297 - 15);
    EXPECT_EQ(dump.word("umbra78.s4_place.code", placed), 12287);
    EXPECT_EQ(dump.bits("umbra78.s3_round.accumulator_z"), 35);

    // The default is the first visible pixel.
    WatchedFrame frame(job);
    const auto machine = frame.machine();
    const Dump first(vcd_of(*machine));
    EXPECT_EQ(first.at("umbra78.reader.go", first.times().front()), 1u);
    EXPECT_EQ(first.last_time() - first.times().front(), 4096u * 200);
}

TEST(Vcd, AFileThatCannotBeWrittenIsOneLine) {
    const LoadedScene scene = figures_scene();
    shadow::Settings s = shadow::figure_settings(4);
    s.machine.xy_bits = 4;
    RenderJob job(scene.view(), s);
    job.render();
    try {
        write_vcd("none/a.vcd", job);
        FAIL() << "no error";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "cannot write 'none/a.vcd': No such file or directory; create "
                                   "its folder first");
    }
}

}  // namespace
}  // namespace umbra78::tools
