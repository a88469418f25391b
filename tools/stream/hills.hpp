// Hills: a landscape of as many patches as are asked for, made as they are asked for. It is what
// the growth of time and memory is measured on.
//
// A layer is a square of x and z about the origin, k by k patches, which together are one uniform
// bicubic B-spline surface of the heights of its control net: patches share their borders' words.
// The heights are a sum of sines, so that the landscape, and with it the area that is drawn, is the
// same for every k, but for how finely it is cut. Layers lie below each other, a
// gap apart.
#pragma once

#include "tools/stream/stream.hpp"

#include <array>
#include <vector>

namespace umbra78::tools {

struct HillsShape {
    std::uint64_t patches = 1024;         // in all; the last layer may be incomplete
    std::uint64_t layers = 1;
    std::int32_t side = 64 << raster::world_fraction;  // of the square, a world word
    std::int32_t gap = 4 << raster::world_fraction;    // from layer to layer, downward
};

class Hills final : public PrimitiveStream {
public:
    explicit Hills(const HillsShape&);

    std::span<const raster::Material> materials() const override { return material_; }
    std::uint64_t count() const override { return shape_.patches; }
    bool can_rewind() const override { return true; }
    std::string_view name() const override { return "hills"; }
    const std::string& error() const override { return no_error_; }
    std::uint64_t hash() const override { return 0; }  // made anew each time, always the same

    bool rewind() override;
    Next next(raster::Surfaces& batch) override;

    std::uint64_t side_patches() const { return per_side_; }

private:
    std::int32_t height(std::int64_t i, std::int64_t j) const;
    raster::Patch patch(std::uint64_t number) const;

    HillsShape shape_;
    std::uint64_t per_layer_, per_side_, at_ = 0;
    std::array<raster::Material, 1> material_{};
    // Sines of the net's columns and rows, from one before the square to one after it.
    std::vector<std::array<std::int32_t, 2>> sines_;
    std::vector<raster::Patch> patches_;
    std::string no_error_;
};

}  // namespace umbra78::tools
