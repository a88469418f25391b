#include "shadow/rivals/bouknight_kelley.hpp"

#include <algorithm>

namespace umbra78::shadow::rivals {
namespace {

// The list of a run. What does not fit is counted only.
class Changes {
public:
    Changes(std::span<CounterChange> room, ScanOutCounts& counts) : room_(room), counts_(counts) {}
    void clear() { size_ = 0; }
    void add(int column, std::int32_t change) {
        if (size_ < room_.size()) room_[size_] = {column, change};
        else fits_ = false;
        ++size_;
        ++counts_.crossings;
        counts_.longest = std::max<std::uint64_t>(counts_.longest, size_);
    }
    bool fit() const { return fits_; }
    std::span<CounterChange> all() const { return room_.first(std::min(size_, room_.size())); }

private:
    std::span<CounterChange> room_;
    ScanOutCounts& counts_;
    std::size_t size_ = 0;
    bool fits_ = true;
};

// The columns of a run on facet `on` that facet f shadows: Setting::hidden_run, for a run.
Run shadow_within(const Setting& s, std::uint32_t f, std::uint32_t on, int row, Run run,
                  ScanOutCounts& counts) {
    const int side = s.light.sides[f];
    const auto line = [&](const SeenPlane& plane) {
        return RowLine(meet(s.planes[on], plane), s.space, row);
    };
    ++counts.planes;
    run = run_within(line(s.planes[f]), -side, run, s.space, row);
    for (std::size_t k = 0; k < 3 && !run.empty(); ++k) {
        ++counts.edges;
        run = run_within(line(s.light.edge(s.mesh, f, k)), s.light.inside(s.mesh, f, k), run,
                         s.space, row);
    }
    return run;
}

// Goes through a run's sorted changes and writes its tones.
void write_tones(std::span<const CounterChange> changes, std::int32_t counter, const Run& run,
                 std::span<std::uint8_t> mask_row) {
    int from = run.from;
    const auto write_to = [&](int to) {
        if (to <= from) return;
        std::fill(mask_row.begin() + from, mask_row.begin() + to, counter != 0 ? dark : lit);
        from = to;
    };
    for (const CounterChange& c : changes) {
        write_to(std::min(c.column, run.to));
        counter += c.change;
    }
    write_to(run.to);
}

std::uint64_t count_tones(std::span<const std::uint8_t> pixels) {
    std::uint64_t tones = 1;
    for (std::size_t i = 1; i < pixels.size(); ++i) tones += pixels[i] != pixels[i - 1] ? 1 : 0;
    return tones;
}

class SecondScan {
public:
    SecondScan(const Setting& s, const ScanOutOptions& options, std::span<CounterChange> room,
               ScanOutCounts& counts)
        : s_(s), options_(options), changes_(room, counts), counts_(counts) {}

    // First form.
    void facets(std::span<const std::uint32_t> casters, std::uint32_t on, int row, const Run& run,
                std::span<std::uint8_t> mask_row) {
        changes_.clear();
        std::int32_t counter = 0;
        Run rest = run;  // outside of it all is dark
        for (const std::uint32_t f : casters) {
            ++counts_.casters;
            const Run shadow = shadow_within(s_, f, on, row, rest, counts_);
            if (shadow.empty()) continue;
            const bool begins = shadow.from == rest.from, ends = shadow.to == rest.to;
            if (options_.stop_when_dark && (begins || ends)) {
                rest = begins ? Run{shadow.to, rest.to} : Run{rest.from, shadow.from};
                if (!rest.empty()) continue;
                ++counts_.stopped;
                break;
            }
            if (begins) ++counter;
            else changes_.add(shadow.from, 1);
            if (!ends) changes_.add(shadow.to, -1);
        }
        std::fill(mask_row.begin() + run.from, mask_row.begin() + run.to, dark);
        if (rest.empty()) return;
        counts_.compares += sort_changes(changes_.all());
        write_tones(changes_.all(), counter, rest, mask_row);
    }

    // Second form.
    void borders(std::span<const Border> borders, std::span<const std::uint32_t> casters,
                 std::uint32_t on, int row, const Run& run, std::span<std::uint8_t> mask_row) {
        changes_.clear();
        std::int32_t counter = 0;
        for (const std::uint32_t f : casters) {
            ++counts_.start_facets;
            counter += s_.hides(s_.light, f, on, s_.space.centre(run.from), s_.space.centre(row))
                           ? 1 : 0;
        }
        CrossingCounts crossing_counts;
        for (const Border& border : borders) {
            ++counts_.casters;
            ++(border.side == Border::own_plane ? counts_.planes : counts_.edges);
            BorderCrossing c;
            if (crosses(s_, on, border, row, run, c, crossing_counts))
                changes_.add(c.column, c.change);
        }
        counts_.compares += sort_changes(changes_.all());
        write_tones(changes_.all(), counter, run, mask_row);
    }

    // Whether every list has fitted.
    bool fit() const { return changes_.fit(); }

private:
    const Setting& s_;
    ScanOutOptions options_;
    Changes changes_;
    ScanOutCounts& counts_;
};

}  // namespace

// A heap's sort, written out so that its compares are the same everywhere.
std::uint64_t sort_changes(std::span<CounterChange> changes) {
    std::uint64_t compares = 0;
    const auto exchange = [&](std::size_t a, std::size_t b) {
        const CounterChange kept = changes[a];
        changes[a] = changes[b];
        changes[b] = kept;
    };
    const auto sift = [&](std::size_t at, std::size_t size) {
        for (std::size_t child = 2 * at + 1; child < size; child = 2 * at + 1) {
            if (child + 1 < size) {
                ++compares;
                if (changes[child].column < changes[child + 1].column) ++child;
            }
            ++compares;
            if (changes[at].column >= changes[child].column) return;
            exchange(at, child);
            at = child;
        }
    };
    for (std::size_t at = changes.size() / 2; at-- > 0;) sift(at, changes.size());
    for (std::size_t size = changes.size(); size-- > 1;) {
        exchange(0, size);
        sift(0, size);
    }
    return compares;
}

bool bouknight_kelley(const Setting& setting, std::span<const std::uint32_t> shown,
                      const Links& links, const Borders* borders, const ScanOutOptions& options,
                      std::span<CounterChange> room, std::span<std::uint8_t> mask,
                      ScanOutCounts& counts) {
    const auto size = static_cast<std::size_t>(setting.space.size_px());
    SecondScan scan(setting, options, room, counts);
    std::fill(mask.begin(), mask.end(), lit);
    for_runs(setting.space, shown, [&](int row, const Run& run, std::uint32_t on) {
        ++counts.runs;
        const std::span mask_row = mask.subspan(static_cast<std::size_t>(row) * size, size);
        if (setting.attached(on)) {
            std::fill(mask_row.begin() + run.from, mask_row.begin() + run.to, dark);
            return;
        }
        ++counts.lit_runs;
        if (borders == nullptr) {
            scan.facets(links.of(on), on, row, run, mask_row);
        } else {
            scan.borders(borders->of(on), links.of(on), on, row, run, mask_row);
        }
        counts.tones += count_tones(mask_row.subspan(static_cast<std::size_t>(run.from),
                                                     static_cast<std::size_t>(run.to - run.from)));
    });
    return scan.fit();
}

}  // namespace umbra78::shadow::rivals
