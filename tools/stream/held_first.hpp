// A scene's own surfaces as the first batch, and those of a stream after them.
#pragma once

#include "raster/source.hpp"

namespace umbra78::tools {

class HeldFirst final : public raster::PrimitiveSource {
public:
    // Both outlive it.
    HeldFirst(const raster::Surfaces& held, raster::PrimitiveSource& rest)
        : held_(held), rest_(rest) {}

    bool rewind() override {
        held_is_next_ = !held_.empty();
        return rest_.rewind();
    }
    Next next(raster::Surfaces& batch) override {
        if (!held_is_next_) return rest_.next(batch);
        held_is_next_ = false;
        batch = held_;
        return Next::batch;
    }

private:
    raster::Surfaces held_;
    raster::PrimitiveSource& rest_;
    bool held_is_next_ = false;
};

}  // namespace umbra78::tools
