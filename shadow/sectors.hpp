// The post-process of a light that shines in all directions, with a map for each of its six sectors
// (Williams 1978, p. 272; hw/sectors.hpp; hw/MACHINE.md, section 25).
//
//   classified   each visible pixel is sorted into its sector, and moved into that one's view:
//                one pass over the frame, one transform a pixel
//   every        each sector in a pass of its own moves every visible pixel into its view, and
//                writes those that lie in its cone: six passes
//
// The paper gives both ways. Both write the same mask, because a pixel lies in the cone that it is
// sorted into and in no other; tests hold them equal.
// Both write the pixels of the tested sectors alone, and of a band's lines: the mask is all lit
// before.
#pragma once

#include "hw/sectors.hpp"
#include "shadow/post_process.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace umbra78::shadow {

enum class SectorTest : std::uint8_t { classified, every };

// What the tests read: the observer's store, and for each sector its map, its matrix
// (hw::load_sector) and what follows a receiver's surface (post_process()).
template <class Depth>
struct SectorMaps {
    hw::FrameStore<const Depth> observer;
    std::array<hw::FrameStore<const Depth>, hw::sector_count> map;
    std::array<hw::MatrixWords, hw::sector_count> matrix;
    std::array<ReceiverWords, hw::sector_count> receiver;
};
struct SectorCounts : std::array<PostProcessCounts, hw::sector_count> {
    SectorCounts& operator+=(const SectorCounts& more) {
        for (std::size_t k = 0; k < size(); ++k) (*this)[k] += more[k];
        return *this;
    }
};

template <class Depth>
SectorCounts classified_pass(const SectorMaps<Depth>& maps, const ShadowTest& test,
                             const PostProcessWork& work, std::span<std::uint8_t> mask,
                             hw::Band band = {});
template <class Depth>
PostProcessCounts sector_pass(const SectorMaps<Depth>& maps, int sector, const ShadowTest& test,
                              const PostProcessWork& work, std::span<std::uint8_t> mask,
                              hw::Band band = {});

}  // namespace umbra78::shadow
