// How the waterfall's rows are recorded, cycle by cycle, and printed.
#include "tools/watch/waterfall.hpp"

#include "tools/watch/machine_watch.hpp"
#include "tools/watch/watched_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace umbra78::tools {
namespace {

// When a point that was asked for was where.
struct PointTimes {
    int px = 0, py = 0;
    std::uint64_t released = 0, written = 0, waited = 0;
    bool done = false;
};

template <class Depth>
class Recorder {
public:
    Recorder(shadow::ClockedPostProcess<Depth>& machine, const WaterfallOptions& options)
        : machine_(machine), options_(options), watch_(machine),
          rows_(static_cast<std::size_t>(machine.chain().stages()) + 1) {}

    std::string operator()() {
        skip();
        while (!finished()) cycle();
        return picture() + point_lines() + closed_form();
    }

private:
    int last() const { return machine_.chain().stages() - 1; }
    bool finished() const {
        return machine_.done() || rows_[0].size() >= std::size_t(options_.max_cycles) ||
               (points_.size() == std::size_t(options_.points) && points_.back().done);
    }

    void tick() {
        watch_.tick(options_.holds ? options_.holds(machine_.cycles()) : 0);
    }

    // Runs up to the first column, and records that cycle if it was ticked to find it.
    void skip() {
        if (options_.from) {
            while (!machine_.done() && machine_.cycles() < *options_.from) tick();
            before_ = machine_.counts().visible;
        } else {
            while (!machine_.done() && machine_.counts().visible == before_) tick();
            if (machine_.counts().visible != before_) record();
        }
    }

    void cycle() {
        tick();
        record();
    }

    char letter(std::uint64_t point) const {
        constexpr std::string_view letters =
            "123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
        if (point <= before_) return '<';
        const std::uint64_t index = point - before_ - 1;
        return index < std::uint64_t(options_.points) && index < letters.size() ? letters[index]
                                                                               : '>';
    }

    // A visible pixel in the reader is the next point to be released.
    char reader_letter(const ReaderCycle& r) const {
        const bool visible = r.known && r.code != background();
        switch (r.activity) {
            case ReaderActivity::done: return ' ';
            case ReaderActivity::slot: return r.released != 0 ? letter(r.released) : '~';
            case ReaderActivity::blocked: return '=';
            case ReaderActivity::held: return '#';
            case ReaderActivity::read: break;
        }
        if (!visible) return r.known ? '.' : '-';
        return letter(r.released != 0 ? r.released : machine_.counts().visible + 1);
    }
    std::uint32_t background() const { return machine_.plan().lookup.spec.background(); }

    static char stage_letter(const StageCycle& s, char point) {
        switch (s.activity) {
            case Activity::nothing: return '.';
            case Activity::blocked: return '=';
            case Activity::held: return '#';
            case Activity::work: break;
        }
        return point;
    }

    void record() {
        if (rows_[0].empty()) first_ = watch_.cycle();
        const ReaderCycle& r = watch_.reader();
        rows_[0] += reader_letter(r);
        for (int k = 0; k <= last(); ++k) {
            const StageCycle& s = watch_.stage(k);
            rows_[static_cast<std::size_t>(k) + 1] += stage_letter(s, letter(s.point));
            if (s.point > before_ && s.point - before_ <= points_.size()) follow(k, s);
        }
        if (r.released != 0 && points_.size() < std::size_t(options_.points)) {
            const auto& f = machine_.flight(machine_.chain().slot(0));
            points_.push_back({f.px, f.py, watch_.cycle(), 0, 0, false});
        }
    }

    void follow(int stage, const StageCycle& s) {
        PointTimes& c = points_[static_cast<std::size_t>(s.point - before_ - 1)];
        if (s.activity != Activity::work) ++c.waited;
        if (stage != last() || !s.valid) return;
        c.written = watch_.cycle();
        c.done = true;
    }

    std::string name(std::size_t row) const {
        return row == 0 ? "reader" : std::string(machine_.chain().name(static_cast<int>(row) - 1));
    }

    // The number of every tenth cycle, with a mark below it.
    void ruler(std::string& text, std::size_t from, std::size_t columns) const {
        std::string numbers, marks;
        for (std::size_t c = 0; c < columns; ++c) {
            if ((first_ + from + c) % 10 != 0) continue;
            // A number that would touch the one before it is left out.
            if (numbers.empty() || numbers.size() < c) numbers.resize(c, ' ');
            if (numbers.size() == c) numbers += fmt::format("{}", first_ + from + c);
            marks.resize(c, ' ');
            marks += '|';
        }
        text += fmt::format("{:<12} {}\n{:<12} {}\n", "cycle", numbers, "", marks);
    }

    std::string picture() const {
        std::string text;
        const std::size_t columns = rows_[0].size(), wide = std::size_t(std::max(options_.wide, 1));
        for (std::size_t from = 0; from < columns; from += wide) {
            const std::size_t n = std::min(wide, columns - from);
            ruler(text, from, n);
            for (std::size_t row = 0; row < rows_.size(); ++row)
                text += fmt::format("{:<12} {}\n", name(row), rows_[row].substr(from, n));
            text += "\n";
        }
        if (columns == 0) text = "no point enters\n\n";
        return text;
    }

    std::string point_lines() const {
        std::string text;
        for (std::size_t k = 0; k < points_.size(); ++k) {
            const PointTimes& c = points_[k];
            text += fmt::format("{}  pixel ({}, {}): leaves the reader in cycle {}", letter(
                                    before_ + k + 1), c.px, c.py, c.released);
            if (c.done)
                text += fmt::format(", is written in {}: {} cycles, {} of them waiting", c.written,
                                    c.written - c.released, c.waited);
            text += c.done ? "\n" : "; later cycles are not shown\n";
        }
        return text;
    }

    std::string closed_form() const {
        const shadow::PostProcessPipeline& p = machine_.plan();
        return fmt::format("closed form: points are S = {} cycles apart or more, L = {} cycles on "
                           "their way; {} to read a pixel\n",
                           p.slot_cycles, p.latency, p.read_cycles);
    }

    shadow::ClockedPostProcess<Depth>& machine_;
    const WaterfallOptions& options_;
    MachineWatch<Depth> watch_;
    std::vector<std::string> rows_;    // the reader's, then the stages'
    std::vector<PointTimes> points_;
    std::uint64_t first_ = 0;          // cycle of the first column
    std::uint64_t before_ = 0;         // points let go before it
};

}  // namespace

template <class Depth>
std::string waterfall(shadow::ClockedPostProcess<Depth>& machine,
                      const WaterfallOptions& options) {
    return Recorder<Depth>(machine, options)();
}

template std::string waterfall(shadow::ClockedPostProcess<hw::Depth16>&, const WaterfallOptions&);
template std::string waterfall(shadow::ClockedPostProcess<hw::Depth32>&, const WaterfallOptions&);

std::string waterfall(const RenderJob& job, const WaterfallOptions& options) {
    WatchedFrame frame(job);
    return waterfall(*frame.machine(), options);
}

}  // namespace umbra78::tools
