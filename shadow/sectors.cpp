#include "shadow/sectors.hpp"

#include "shadow/pixel_darkness.hpp"

namespace umbra78::shadow {

// One sector: its unit and its map, and what is counted of it.
template <class Depth>
class Sector {
public:
    Sector(const SectorMaps<Depth>& maps, int number, const ShadowTest& test)
        : observer_(maps.observer), test_(test),
          unit_(test.machine, maps.matrix[static_cast<std::size_t>(number)], number),
          map_(light_map(maps.map[static_cast<std::size_t>(number)], test)),
          receiver_(maps.receiver[static_cast<std::size_t>(number)]) {
        check_light(map_.store, test.machine);
        check_normals(observer_, test);
        map_.is_face = true;
    }

    const hw::SectorUnit& unit() const { return unit_; }
    int noisy_taps() const { return map_.window.noisy_taps(); }

    // How dark a pixel is that lies in the sector's cone.
    std::uint8_t dark(const WalkedPixel& at, const hw::Words& words,
                      const hw::Direction& d) const {
        const hw::Point p = unit_(words, d);
        return pixel_darkness(map_, observer_, unit_, test_, at, p, receiver_);
    }

private:
    const hw::FrameStore<const Depth>& observer_;
    const ShadowTest& test_;
    hw::SectorUnit unit_;
    LightMap<Depth> map_;
    ReceiverWords receiver_;
};

namespace {

void check_pass(const hw::MachineSpec& spec, std::span<const std::uint8_t> mask) {
    check_machine(spec);
    check_mask(mask, spec);
}

// Writes a pixel of a sector.
void write(std::span<std::uint8_t> mask, std::size_t address, std::uint8_t dark,
           PostProcessCounts& counts) {
    mask[address] = dark;
    counts.shadowed += dark == mask_lit ? 0 : 1;
}

constexpr auto nothing_to_write = [](int) {};

}  // namespace

template <class Depth>
SectorCounts classified_pass(const SectorMaps<Depth>& maps, const ShadowTest& test,
                             const PostProcessWork& work, std::span<std::uint8_t> mask,
                             hw::Band band) {
    check_pass(test.machine, mask);
    check_observer(maps.observer, test.machine);
    const auto sector = [&](int k) { return Sector<Depth>(maps, k, test); };
    const std::array sectors{sector(0), sector(1), sector(2), sector(3), sector(4), sector(5)};
    SectorCounts counts{};
    walk_pixels(maps.observer, test, work, sectors[0].noisy_taps(), band, nothing_to_write,
                [&](const WalkedPixel& at) {
                    if (!at.visible && !work.background) return;
                    const hw::Words words = pixel_words(at.x, at.y, at.code, test);
                    const hw::Direction d = sectors[0].unit().direction(words);
                    const int k = hw::sector_of(d);
                    if (!at.visible || k == hw::no_sector) return;
                    PostProcessCounts& counted = counts[static_cast<std::size_t>(k)];
                    ++counted.visible;
                    write(mask, at.address,
                          sectors[static_cast<std::size_t>(k)].dark(at, words, d), counted);
                });
    return counts;
}

template <class Depth>
PostProcessCounts sector_pass(const SectorMaps<Depth>& maps, int sector, const ShadowTest& test,
                              const PostProcessWork& work, std::span<std::uint8_t> mask,
                              hw::Band band) {
    check_pass(test.machine, mask);
    check_observer(maps.observer, test.machine);
    const Sector<Depth> only(maps, sector, test);
    PostProcessCounts counts;
    walk_pixels(maps.observer, test, work, only.noisy_taps(), band, nothing_to_write,
                [&](const WalkedPixel& at) {
                    if (!at.visible && !work.background) return;
                    ++counts.visible;
                    const hw::Words words = pixel_words(at.x, at.y, at.code, test);
                    const hw::Direction d = only.unit().direction(words);
                    if (at.visible && only.unit().holds(d))
                        write(mask, at.address, only.dark(at, words, d), counts);
                });
    return counts;
}

#define UMBRA78_SECTORS(Depth)                                                                   \
    template SectorCounts classified_pass(const SectorMaps<Depth>&, const ShadowTest&,           \
                                          const PostProcessWork&, std::span<std::uint8_t>,       \
                                          hw::Band);                                             \
    template PostProcessCounts sector_pass(const SectorMaps<Depth>&, int, const ShadowTest&,     \
                                           const PostProcessWork&, std::span<std::uint8_t>,      \
                                           hw::Band);
UMBRA78_SECTORS(hw::Depth16)
UMBRA78_SECTORS(hw::Depth32)
#undef UMBRA78_SECTORS

}  // namespace umbra78::shadow
