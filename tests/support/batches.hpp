// A source that hands out surfaces that are held: shuffled, in batches of a given size.
#pragma once

#include "raster/source.hpp"
#include "tests/support/inputs.hpp"

#include <algorithm>
#include <vector>

namespace umbra78::test {

class Batches : public raster::PrimitiveSource {
public:
    // Facets take their vertices and normals with them.
    Batches(const raster::Surfaces& all, std::size_t size) : all_(all), size_(size) {
        for (std::size_t k = 0; k < all.count(); ++k) order_.push_back(k);
    }
    template <class Random>
    void shuffle(Random& random) {
        for (std::size_t k = order_.size(); k > 1; --k)
            std::swap(order_[k - 1], order_[random.bits() % k]);
    }

    bool rewind() override {
        if (rewinds > 0 && once) return false;
        ++rewinds;
        at_ = 0;
        return true;
    }
    Next next(raster::Surfaces& batch) override {
        if (at_ == fails_at) return Next::failed;
        if (at_ == order_.size()) return Next::end;
        patches_.clear(), vertices_.clear(), normals_.clear(), facets_.clear();
        for (const std::size_t end = std::min(at_ + size_, order_.size()); at_ < end; ++at_)
            add(order_[at_]);
        batch = {patches_, {vertices_, normals_, facets_}};
        return Next::batch;
    }

    bool once = false;                 // it cannot be read again
    std::size_t fails_at = SIZE_MAX;   // before this primitive, where a batch starts
    int rewinds = 0;

private:
    void add(std::size_t k) {
        if (k < all_.patches.size()) {
            patches_.push_back(all_.patches[k]);
            return;
        }
        raster::Facet facet = all_.mesh.facets[k - all_.patches.size()];
        for (std::size_t c = 0; c < 3; ++c) {
            vertices_.push_back(all_.mesh.vertices[facet.vertex[c]]);
            facet.vertex[c] = static_cast<std::uint32_t>(vertices_.size() - 1);
            if (facet.normal[c] == raster::Facet::flat) continue;
            normals_.push_back(all_.mesh.normals[facet.normal[c]]);
            facet.normal[c] = static_cast<std::uint32_t>(normals_.size() - 1);
        }
        facets_.push_back(facet);
    }

    raster::Surfaces all_;
    std::size_t size_, at_ = 0;
    std::vector<std::size_t> order_;
    std::vector<raster::Patch> patches_;
    std::vector<raster::World> vertices_;
    std::vector<std::array<std::int32_t, 3>> normals_;
    std::vector<raster::Facet> facets_;
};

}  // namespace umbra78::test
