// Clipping by outlines with memory for tests.
#pragma once

#include "shadow/rivals/atherton.hpp"
#include "tests/shadow/rivals/scenes.hpp"

#include <memory>

namespace umbra78::shadow::rivals::test {

struct LoopRoom {
    std::size_t meetings = 1024;
    ClipSize work{{256, 8192}, 4096};
    LoopSize store{16384, 65536};
};

class Outlines {
public:
    Outlines(const Setting& setting, std::span<const std::uint32_t> shown,
             const LoopRoom& room = {})
        : setting_(setting), shown_(shown), marks_(setting.mesh.facets.size()),
          listed_(marks_.size()) {
        std::size_t needed = 0;
        Memory none(0);
        grid_.build(setting, 0, none.bytes().first(0), needed);
        grid_memory_ = std::make_unique<Memory>(needed);
        fixed::require(grid_.build(setting, 0, grid_memory_->bytes(), needed), "a test's grid");
        give(room);
    }
    Outlines(const Outlines&) = delete;
    Outlines& operator=(const Outlines&) = delete;

    void give(const LoopRoom& room) {
        lines_memory_ = std::make_unique<Memory>(LightLines::bytes(setting_.mesh, room.meetings));
        fixed::require(lines_.make(setting_, room.meetings, lines_memory_->bytes()),
                       "a test's lines");
        work_memory_ = std::make_unique<Memory>(LoopClip::bytes(room.work));
        work_ = LoopClip(work_memory_->bytes(), room.work);
        store_memory_ = std::make_unique<Memory>(LoopList::bytes(room.store));
        store_ = LoopList(store_memory_->bytes(), room.store);
    }
    PieceStatus clip(bool only_seen = false) {
        std::vector<std::uint8_t> wanted(only_seen ? setting_.mesh.facets.size() : 0);
        if (only_seen) find_receivers(setting_, shown_, wanted);
        Casters casters(setting_, grid_, marks_);
        counts_ = {};
        return clip_by_outlines(lines_, casters, wanted, listed_, work_, store_, counts_);
    }
    std::vector<std::uint8_t> mask() {
        std::vector<std::uint8_t> mask(shown_.size());
        std::vector<ShownLine> room(most_sides(store_));
        std::vector<std::uint8_t> flips(
            static_cast<std::size_t>(setting_.space.size_px()) + 1);
        mask_counts_ = {};
        fixed::require(mask_of_loops(lines_, store_, shown_, room, flips, mask, mask_counts_),
                       "a test's room for a facet's lines");
        return mask;
    }

    const LightLines& lines() const { return lines_; }
    const LoopClip& work() const { return work_; }
    const LoopList& store() const { return store_; }
    const AthertonCounts& counts() const { return counts_; }
    const LoopMaskCounts& mask_counts() const { return mask_counts_; }

private:
    const Setting& setting_;
    std::span<const std::uint32_t> shown_;
    std::vector<std::uint32_t> marks_;
    std::vector<ListedCaster> listed_;
    LightGrid grid_;
    LightLines lines_;
    LoopClip work_;
    LoopList store_;
    std::unique_ptr<Memory> grid_memory_, lines_memory_, work_memory_, store_memory_;
    AthertonCounts counts_{};
    LoopMaskCounts mask_counts_{};
};

}  // namespace umbra78::shadow::rivals::test
