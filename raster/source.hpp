// Primitives that are read as they are drawn and never held: a scene of any size in the memory of
// one batch. Whatever their order, the store holds the least of all records (hw/MACHINE.md,
// section 8).
#pragma once

#include "raster/scene.hpp"

#include <cstdint>

namespace umbra78::raster {

class PrimitiveSource {
public:
    enum class Next : std::uint8_t {
        batch,   // there is one more
        end,     // that was all
        failed,  // the rest cannot be read; whoever made the source knows why
    };

    // To the first batch. False if the source can be read only once, and has been.
    virtual bool rewind() = 0;
    // The next batch. Its spans hold until the next call.
    virtual Next next(Surfaces& batch) = 0;

protected:
    ~PrimitiveSource() = default;  // its maker owns it
};

}  // namespace umbra78::raster
