// What the algorithms of class 1 need, made for tests with as much memory as they ask for.
#pragma once

#include "shadow/rivals/appel.hpp"
#include "shadow/rivals/irregular.hpp"
#include "tests/shadow/rivals/figures_scene.hpp"

#include <memory>
#include <vector>

namespace umbra78::shadow::rivals::test {

// Calls build(memory, needed) with the bytes that it asked for, three times at most.
template <class Build>
std::unique_ptr<Memory> with_room(Build&& build) {
    std::size_t needed = 0;
    for (int call = 0; call < 3; ++call) {
        auto memory = std::make_unique<Memory>(needed);
        if (build(memory->bytes().first(needed), needed)) return memory;
    }
    fixed::require(false, "a test's memory: what was asked for was not enough");
    return nullptr;
}

class Linked {
public:
    Linked(const Setting& setting, std::span<const std::uint32_t> shown, LinkOptions options = {})
        : memory_(with_room([&](std::span<std::byte> memory, std::size_t& needed) {
              counts = {};
              return links.build(setting, shown, options, memory, needed, counts) ==
                     LinkStatus::ok;
          })) {}
    Links links;
    LinkCounts counts;

private:
    std::unique_ptr<Memory> memory_;
};

class Bordered {
public:
    Bordered(const Setting& setting, const Links& links)
        : memory_(with_room([&](std::span<std::byte> memory, std::size_t& needed) {
              counts = {};
              return borders.build(setting, links, memory, needed, counts);
          })) {}
    Borders borders;
    BorderCounts counts;

private:
    std::unique_ptr<Memory> memory_;
};

class Gridded {
public:
    explicit Gridded(const Setting& setting)
        : memory_(with_room([&](std::span<std::byte> memory, std::size_t& needed) {
              return grid.build(setting, 0, memory, needed);
          })) {}
    LightGrid grid;

private:
    std::unique_ptr<Memory> memory_;
};

inline std::vector<std::uint8_t> mask_by_lists(const Setting& setting,
                                               std::span<const std::uint32_t> shown, int texels,
                                               IrregularCounts& counts) {
    std::vector<std::uint8_t> mask(shown.size());
    with_room([&](std::span<std::byte> memory, std::size_t& needed) {
        counts = {};
        const bool ok = irregular(setting, shown, {texels}, memory, mask, counts);
        needed = counts.bytes;
        return ok;
    });
    return mask;
}

}  // namespace umbra78::shadow::rivals::test
