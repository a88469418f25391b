// What the forms of block_form.hpp and facet_form.hpp shade by, and the levels that they make.
#pragma once

#include "raster/leaf_grid.hpp"
#include "raster/shading.hpp"

#include <cstddef>
#include <cstdint>

namespace umbra78::raster {

// What the lanes need to shade, for a drawing and a material. Plain words only.
struct ShadeSource {
    std::int32_t toward[3];
    std::int32_t halfway[3];  // Blinn's
    std::int32_t l_dot_v;
    std::int32_t level_q8[max_channels];
};
struct ShadeJob {
    std::int32_t normal[4][3];  // at a block's corners
    std::int32_t viewer[3];
    std::size_t sources, channels;
    ShadeSource source[max_sources];
    std::int32_t ambient_q8;
    std::int32_t diffuse[max_channels], specular[max_channels];
    int squares;                  // of the highlight
    bool highlights, by_halfway;  // whether there is one; by the halfway direction
    bool two_sided;               // normals are turned to the viewer
};

// Normals of up to 16 samples, each the mean of a block's unit normals at its leaf's centre, Q.24,
// and what of their shading does not depend on a light (shade_body.hpp).
struct SampleNormals {
    std::int32_t n[3][leaves];
    std::uint32_t length[leaves], reciprocal[leaves];
    std::int32_t n_dot_v[leaves];
};

// The levels of a block's leaves, or of a list's samples: for each channel its intensity and its
// direct shares.
struct LeafLevels {
    static constexpr std::size_t planes = max_channels * (1 + max_sources);
    std::uint8_t level[planes][leaves * leaves];

    Shades of(std::size_t leaf, std::size_t channels, std::size_t sources) const {
        Shades shades{};
        for (std::size_t c = 0; c < channels; ++c) {
            const auto* plane = level + c * (1 + sources);
            shades[c].intensity = plane[0][leaf];
            for (std::size_t l = 0; l < sources; ++l) shades[c].direct[l] = plane[1 + l][leaf];
        }
        return shades;
    }
    void put(std::size_t leaf, const Shades& shades, std::size_t channels, std::size_t sources) {
        for (std::size_t c = 0; c < channels; ++c) {
            auto* plane = level + c * (1 + sources);
            plane[0][leaf] = shades[c].intensity;
            for (std::size_t l = 0; l < sources; ++l) plane[1 + l][leaf] = shades[c].direct[l];
        }
    }
};

// Of these settings and this material, but for the normals. False where lanes do not cover it:
// light or viewer at a point, or no shading.
bool shade_job(const ShadingSpec& spec, const Material& material, ShadeJob& out);

}  // namespace umbra78::raster
