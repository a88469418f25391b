// Class 2 with memory for tests: what its parts need, and their masks.
#pragma once

#include "shadow/rivals/perimeters.hpp"
#include "tests/shadow/rivals/scenes.hpp"

#include <memory>
#include <vector>

namespace umbra78::shadow::rivals::test {

struct Capacities {
    std::size_t meetings = 256;
    WorkSize work{256, 2048, 32};
    PieceSize pieces{1024, 8192};
    FragmentSize fragments{512, 4096, 64};
};

// The grid, the lines and the memory of class 2, for a setting. What it makes refers to it.
class ObjectSpace {
public:
    ObjectSpace(const Setting& setting, std::span<const std::uint32_t> shown,
                const Capacities& room = {})
        : setting_(setting), shown_(shown), marks_(setting.mesh.facets.size()) {
        std::size_t needed = 0;
        Memory none(0);
        grid_.build(setting, 0, none.bytes().first(0), needed);
        grid_memory_ = std::make_unique<Memory>(needed);
        fixed::require(grid_.build(setting, 0, grid_memory_->bytes(), needed), "a test's grid");
        give(room);
    }
    ObjectSpace(const ObjectSpace&) = delete;
    ObjectSpace& operator=(const ObjectSpace&) = delete;

    void give(const Capacities& room) {
        const std::size_t facets = setting_.mesh.facets.size();
        lines_memory_ = std::make_unique<Memory>(LightLines::bytes(setting_.mesh, room.meetings));
        fixed::require(lines_.make(setting_, room.meetings, lines_memory_->bytes()),
                       "a test's lines");
        work_memory_ = std::make_unique<Memory>(LitPart::bytes(room.work));
        lit_part_ = LitPart(work_memory_->bytes(), room.work);
        store_memory_ = std::make_unique<Memory>(PieceStore::bytes(room.pieces, facets));
        store_ = PieceStore(store_memory_->bytes(), room.pieces, facets);
        order_memory_ = std::make_unique<Memory>(LightOrder::bytes(room.fragments, facets));
        order_ = LightOrder(order_memory_->bytes(), room.fragments, facets);
    }

    // Of the facets that are seen, or of all.
    PieceStatus split(bool only_seen = true) {
        std::vector<std::uint8_t> wanted(only_seen ? setting_.mesh.facets.size() : 0);
        if (only_seen) find_receivers(setting_, shown_, wanted);
        Casters casters(setting_, grid_, marks_);
        split_counts_ = {};
        return rivals::split(lines_, casters, wanted, lit_part_, store_, split_counts_);
    }
    OrderStatus sort_from_light() {
        Casters casters(setting_, grid_, marks_);
        order_counts_ = {};
        const OrderStatus status = order_.make(lines_, casters, order_counts_);
        order_casters_ = casters.counts();
        return status;
    }
    // After sort_from_light().
    PieceStatus clip(bool in_pairs = false) {
        Casters casters(setting_, grid_, marks_);
        FootprintPairs pairs;
        perimeter_counts_ = {};
        pairs_memory_ =
            std::make_unique<Memory>(FootprintPairs::bytes(setting_.mesh.facets.size()));
        fixed::require(!in_pairs || pairs.make(lines_, pairs_memory_->bytes(),
                                               perimeter_counts_.cuts.signs), "a test's pairs");
        return clip_by_perimeters(lines_, casters, order_, pairs, lit_part_, store_,
                                  perimeter_counts_);
    }
    std::vector<std::uint8_t> mask() {
        std::vector<std::uint8_t> mask(shown_.size());
        std::vector<ShownLine> room(store_.longest());
        mask_counts_ = {};
        fixed::require(mask_of_pieces(lines_, store_, shown_, room, mask, mask_counts_),
                       "a test's room for a piece's lines");
        return mask;
    }
    // Through the grid, which fuzz_test compares with all facets.
    std::vector<std::uint8_t> brute_mask(BruteCounts& counts) const {
        std::vector<std::uint8_t> mask(shown_.size());
        brute(setting_, shown_, &grid_, mask, counts);
        return mask;
    }

    LightLines& lines() { return lines_; }
    LitPart& lit_part() { return lit_part_; }
    PieceStore& store() { return store_; }
    LightOrder& order() { return order_; }
    const SplitCounts& split_counts() const { return split_counts_; }
    const OrderCounts& order_counts() const { return order_counts_; }
    const CasterCounts& order_casters() const { return order_casters_; }
    const PerimeterCounts& perimeter_counts() const { return perimeter_counts_; }
    const MaskCounts& mask_counts() const { return mask_counts_; }

private:
    const Setting& setting_;
    std::span<const std::uint32_t> shown_;
    std::vector<std::uint32_t> marks_;
    LightGrid grid_;
    LightLines lines_;
    LitPart lit_part_;
    PieceStore store_;
    LightOrder order_;
    std::unique_ptr<Memory> grid_memory_, lines_memory_, work_memory_, store_memory_,
        order_memory_, pairs_memory_;
    SplitCounts split_counts_{};
    OrderCounts order_counts_{};
    CasterCounts order_casters_{};
    PerimeterCounts perimeter_counts_{};
    MaskCounts mask_counts_{};
};

}  // namespace umbra78::shadow::rivals::test
