// A stream of primitives as the program reads it: a source of the core that knows its materials,
// can be moved to another origin, and says in words why it failed.
#pragma once

#include "raster/source.hpp"

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace umbra78::tools {

inline constexpr std::uint64_t unknown_count = std::numeric_limits<std::uint64_t>::max();

class PrimitiveStream : public raster::PrimitiveSource {
public:
    virtual ~PrimitiveStream() = default;

    // What the primitives' material numbers mean.
    virtual std::span<const raster::Material> materials() const = 0;
    // How many primitives there are; unknown_count if whoever writes them does not say.
    virtual std::uint64_t count() const = 0;
    virtual bool can_rewind() const = 0;
    virtual std::string_view name() const = 0;  // for messages: a path, "standard input"
    // One line after Next::failed: where, what is wrong, the remedy.
    virtual const std::string& error() const = 0;
    // The sum of the primitives' hashes, known once all have been read. It does not depend on their
    // order.
    virtual std::uint64_t hash() const = 0;

    // What the next batches' numbers of materials are raised by.
    void number_materials_from(std::uint16_t first) { first_material_ = first; }
    // What is taken from the places of the next batches.
    void take_origin(const raster::World& origin) { origin_ = origin; }
    // A coordinate, as it is read, that is farther from 0 is an error: stream.largest of a scene.
    void limit(std::int32_t largest) { largest_ = largest; }

protected:
    std::int32_t largest_ = 32767 << raster::world_fraction;
    std::uint16_t first_material_ = 0;
    raster::World origin_{};
};

struct OpenedStream {
    std::unique_ptr<PrimitiveStream> stream;
    std::string error;  // one line: the file, what is wrong, the remedy; else empty
};

}  // namespace umbra78::tools
