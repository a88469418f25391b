// What the handles of umbra78.h are, and what its sources share.
#pragma once

#include "shadow/c/umbra78.h"
#include "shadow/frame/buffers.hpp"
#include "shadow/frame/inputs.hpp"
#include "shadow/frame/ledger.hpp"
#include "shadow/frame/plan.hpp"

#include <array>
#include <cstddef>
#include <span>

// As many as `used` says are filled.
template <class T>
struct umbra78_list {
    std::span<T> room{};
    std::size_t used = 0;

    bool full() const { return used == room.size(); }
    T& add() { return room[used++]; }
    std::span<const T> all() const { return room.first(used); }
};

// A view whose near and far are fitted when the frame is drawn, once all surfaces are there.
struct umbra78_placed_view {
    umbra78::raster::View view{};
    bool fitted = false, given = false;
};

struct umbra78_scene {
    umbra78_list<umbra78::raster::Material> materials{};
    umbra78_list<umbra78::raster::Patch> patches{};
    umbra78_list<umbra78::raster::World> vertices{};
    umbra78_list<umbra78::raster::Facet> facets{};
    umbra78_placed_view observer{};
    std::array<umbra78_placed_view, umbra78::shadow::max_lights> lights{};
    std::size_t light_count = 0;
    umbra78::shadow::Settings settings{};
    // What the frame is drawn from, made of the above; and what a method was short of when it was
    // last drawn.
    umbra78::shadow::FrameInputs inputs{};
    std::size_t method_bytes = 0;
};

struct umbra78_frame {
    const umbra78_scene* scene = nullptr;
    umbra78::shadow::FramePlan plan{};
    umbra78::shadow::FrameCounts counts{};
    // One of the two is carved.
    umbra78::shadow::FrameBuffers<umbra78::hw::Depth16> narrow{};
    umbra78::shadow::FrameBuffers<umbra78::hw::Depth32> wide{};
    umbra78::shadow::FrameLedger* ledgers = nullptr;  // one for each light

    bool is_wide() const { return scene->inputs.settings.machine.z_bits > 16; }
};
