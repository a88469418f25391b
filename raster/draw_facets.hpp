// Drawing a mesh: each facet by itself, or many at once where the forms cover it (facet_batch.hpp).
#pragma once

#include "raster/emitter.hpp"
#include "raster/facet_batch.hpp"
#include "raster/places.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace umbra78::raster::detail {

// Whether a sink can be handed levels that are made already.
template <class SampleSink>
concept TakesLevels = requires(SampleSink& sink, const LeafLevels& levels, std::uint32_t code) {
    sink.keeps(0, 0, code);
    sink.take(0, 0, code, levels, std::size_t{0});
    sink.takes_levels();
};

template <class SampleSink>
class FacetDrawing {
public:
    FacetDrawing(const DrawSetup& setup, FacetMemory& memory, FacetWalk& walk,
                 const Emitter<SampleSink>& emit)
        : setup_(setup), m_(memory), walk_(walk), emit_(emit),
          form_(setup.blocks != nullptr ? setup.blocks->facets : fastest_block_form().facets),
          half_px_(setup.spec.half_px()), batched_(batched()) {
        if constexpr (requires { emit.sink.code_plane(setup.spec); })
            if (batched_) plane_ = emit.sink.code_plane(setup.spec);
    }

    // `all`: whatever setup.drawn says, for a mesh that was chosen as a whole.
    void draw(const Mesh& mesh, bool all) {
        mesh_ = &mesh;
        walk_.begin(mesh);
        m_.vertices.begin(mesh);
        m_.batch.count = 0;
        for (const Facet& facet : mesh.facets) {
            const Material* material = material_of<SampleSink>(facet.material, setup_);
            if (!batched_ || !add(facet, material, all)) draw_one(facet, material, all);
        }
        draw_batch();
    }

private:
    static constexpr bool shades = SampleSink::shades;
    static constexpr bool can_batch =
        !HasPlaces<SampleSink> && (!shades || TakesLevels<SampleSink>);

    bool batched() const {
        if constexpr (!can_batch) return false;
        if (!setup_.batches_facets || setup_.casters.slope_q8 != 0) return false;
        if (!setup_.band.all() || setup_.spec.z_bits > 24) return false;  // of 32-bit words
        if constexpr (can_batch && shades) return emit_.sink.takes_levels();
        return true;
    }

    // --- one facet, by the definition ------------------------------------------------------------

    void draw_one(const Facet& facet, const Material* material, bool all) {
        DrawCounts& counts = emit_.counts;
        const FacetWalk::Outcome outcome = walk_.project(facet);
        if (!all && !setup_.draws([&] { return walk_.unseen(outcome); })) return;
        ++counts.facets;
        if (outcome == FacetWalk::Outcome::unresolved) ++counts.unresolved_facets;
        if (outcome == FacetWalk::Outcome::cut) ++counts.cut_facets;
        if (outcome > FacetWalk::Outcome::cut) return;
        for (std::size_t k = 0; k < walk_.triangles(); ++k) {
            const FacetTriangle triangle = walk_.triangle(k);
            const auto& [a, b, c] = triangle.screen;
            if (setup_.facet_facing() != Facing::both &&
                !is_drawn(setup_.facet_facing(), turn(a, b, c.x, c.y))) {
                ++counts.turned_triangles;
                continue;
            }
            count_lines(draw_triangle(facet, material, triangle));
        }
    }
    void count_lines(std::uint64_t lines) {
        emit_.counts.triangles += lines > 0 ? 1 : 0;
        emit_.counts.triangle_lines += lines;
    }
    // Returns how many lines its box has.
    std::uint64_t draw_triangle(const Facet& facet, const Material* material,
                                const FacetTriangle& triangle) {
        // Names of their own: clang++ 14 captures no structured bindings.
        const Corner &a = triangle.screen[0], &b = triangle.screen[1], &c = triangle.screen[2];
        std::int64_t offset = 0;
        if (!setup_.casters.all_alike() && setup_.casters.slope_q8 > 0)
            offset = setup_.casters.offset(depth_slope(a, b, c));
        const auto sample = [&](const FacetShading* shading) {
            const auto each = [&](const Sample& s) { emit_(s, shading, offset); };
            if constexpr (HasPlaces<SampleSink>) {
                return sample_triangle_places(a, b, c, emit_.sink.places, each);
            } else {
                return sample_triangle(a, b, c, setup_.spec, each);
            }
        };
        if constexpr (shades) {
            const FacetShading shading(triangle, walk_.facet(), facet.normal[0] == Facet::flat,
                                       setup_.shading, *material);
            return sample(&shading);
        } else {
            return sample(nullptr);
        }
    }

    // --- many at once ----------------------------------------------------------------------------

    // False if the facet is cut or has a corner without a quotient.
    bool add(const Facet& facet, const Material* material, bool all) {
        TriangleBatch& batch = m_.batch;
        if (batch.count == TriangleBatch::most || (shades && material != material_)) {
            draw_batch();
            material_ = material;
        }
        const std::size_t slot = batch.count;
        std::uint32_t any = 0, common = ~0u;
        for (std::size_t k = 0; k < 3; ++k) {
            const SeenVertex& v = m_.vertices.see(facet.vertex[k], walk_);
            batch.seen[k][slot] = v;
            any |= v.outside;
            common &= v.outside;
        }
        if ((any & SeenVertex::beyond_band) != 0) return false;
        if constexpr (shades)
            for (const std::uint32_t normal : facet.normal)
                fixed::require(normal == Facet::flat || normal < mesh_->normals.size(),
                               "facet: no such normal");
        if (!all && !setup_.draws([&] { return common != 0; })) return true;
        batch.facet[slot] = static_cast<std::uint32_t>(&facet - mesh_->facets.data());
        ++batch.count;
        return true;
    }

    void draw_batch() {
        TriangleBatch& batch = m_.batch;
        if (batch.count == 0) return;
        const Facing facing = setup_.facet_facing();
        form_.measure({half_px_, facing != Facing::front, facing != Facing::back,
                       facing == Facing::both},
                      batch);
        if constexpr (shades)
            std::fill_n(m_.shading.begin(), batch.count, FacetMemory::Shading::unknown);
        emit_.counts.facets += batch.count;
        m_.centres.count = m_.samples.count = 0;
        m_.samples.coded = 0;
        for (std::size_t slot = 0; slot < batch.count; ++slot) draw_slot(slot);
        draw_few();
        finish_samples();
        batch.count = 0;
    }

    void draw_slot(std::size_t slot) {
        const TriangleBatch& batch = m_.batch;
        const auto kind = static_cast<TriangleKind>(batch.kind[slot]);
        if (kind == TriangleKind::turned) ++emit_.counts.turned_triangles;
        if (kind < TriangleKind::few) return;
        count_lines(static_cast<std::uint64_t>(batch.y1[slot] - batch.y0[slot] + 1));
        if (kind == TriangleKind::few) {
            add_centres(slot);
        } else if (kind == TriangleKind::tiled) {
            TileWalk(batch, slot, half_px_).tiles([&](const Tile& tile, const TileColumns& at) {
                if (!m_.samples.has_room(TileColumns::most * tile_lines)) finish_samples();
                form_.tile(tile, at, plane_, m_.samples);
            });
        } else {
            draw_wide(slot);
        }
    }
    void draw_wide(std::size_t slot) {
        const Corner a = m_.batch.corner(0, slot), b = m_.batch.corner(1, slot);
        const Corner c = m_.batch.corner(2, slot);
        sample_triangle(a, b, c, setup_.spec, [&](const Sample& s) {
            if (!m_.samples.has_room(1)) finish_samples();
            FacetSamples& list = m_.samples;
            list.z[list.count] = static_cast<std::int32_t>(s.z);
            list.place[list.count] = place(s.px, s.py);
            list.slot[list.count] = static_cast<std::uint16_t>(slot);
            form_.put(plane_, list);
        });
    }

    void add_centres(std::size_t slot) {
        const TriangleBatch& batch = m_.batch;
        CentreList& list = m_.centres;
        if (list.count + most_few + 16 > CentreList::most) draw_few();
        for (std::int32_t py = batch.y0[slot]; py <= batch.y1[slot]; ++py) {
            for (std::int32_t px = batch.x0[slot]; px <= batch.x1[slot]; ++px) {
                list.place[list.count] = place(px, py);
                list.slot[list.count++] = static_cast<std::uint16_t>(slot);
            }
        }
    }
    void draw_few() {
        if (!m_.samples.has_room(m_.centres.count)) finish_samples();
        form_.few(m_.batch, m_.centres, half_px_, plane_, m_.samples);
        m_.centres.count = 0;
    }

    // --- samples to the sink ---------------------------------------------------------------------

    static std::uint32_t place(int px, int py) {
        return place_of(static_cast<std::uint32_t>(px), static_cast<std::uint32_t>(py));
    }
    int px(std::size_t k) const { return static_cast<int>(m_.samples.place[k] % 65536); }
    int py(std::size_t k) const { return static_cast<int>(m_.samples.place[k] / 65536); }
    std::uint32_t code(std::size_t k) const {
        return static_cast<std::uint32_t>(m_.samples.z[k]);
    }
    Sample sample(std::size_t k) const {
        return {px(k), py(k), pixel_centre(px(k), half_px_), pixel_centre(py(k), half_px_),
                m_.samples.z[k], 0, 0};
    }
    void finish_samples() {
        FacetSamples& list = m_.samples;
        emit_.counts.samples += list.coded;
        if constexpr (!shades) {
            for (std::size_t k = 0; k < list.count; ++k)
                emit_(sample(k), static_cast<const FacetShading*>(nullptr));
        } else if constexpr (can_batch) {
            const std::size_t kept = plane_.codes != nullptr ? list.count : keep_samples();
            for (std::size_t at = 0; at < kept;) at = shade_some(at, kept);
        }
        list.count = list.coded = 0;
    }
    // Finds the samples' codes and leaves those in the list that the sink may take.
    std::size_t keep_samples() {
        FacetSamples& list = m_.samples;
        std::size_t kept = 0;
        for (std::size_t k = 0; k < list.count; ++k) {
            std::uint32_t code = 0;
            if (!emit_.code_of(list.z[k], 0, code)) continue;
            const bool keeps = emit_.sink.keeps(px(k), py(k), code);
            list.z[kept] = static_cast<std::int32_t>(code);
            list.place[kept] = list.place[k];
            list.slot[kept] = list.slot[k];
            kept += keeps ? 1 : 0;
        }
        return kept;
    }

    // From sample `at` on those that are shaded together; returns where the others begin.
    std::size_t shade_some(std::size_t at, std::size_t kept) {
        const std::uint16_t* slots = m_.samples.slot;
        const std::size_t most = std::min<std::size_t>(kept, at + leaves * leaves);
        std::size_t end = at;
        while (end < most && shading_of(slots[end]) == FacetMemory::Shading::lanes) ++end;
        if (end > at) {
            form_.shade(job_, m_.batch, m_.normals, half_px_, m_.samples, at, end - at,
                        m_.levels);
            for (std::size_t k = at; k < end; ++k)
                emit_.sink.take(px(k), py(k), code(k), m_.levels, k - at);
            return end;
        }
        const std::uint16_t slot = slots[at];
        const Facet& facet = mesh_->facets[m_.batch.facet[slot]];
        walk_.project(facet);
        const FacetTriangle triangle = walk_.triangle(0);
        const FacetShading shading(triangle, walk_.facet(), facet.normal[0] == Facet::flat,
                                   setup_.shading, *material_);
        for (; end < kept && slots[end] == slot; ++end)
            emit_.sink.sample(sample(end), code(end), &shading);
        return end;
    }
    FacetMemory::Shading shading_of(std::size_t slot) {
        using enum FacetMemory::Shading;
        FacetMemory::Shading& s = m_.shading[slot];
        if (s != unknown) return s;
        s = has_job() && find_facet_normals(*mesh_, mesh_->facets[m_.batch.facet[slot]],
                                            setup_.object, setup_.shading.viewer.direction,
                                            m_.batch, slot, m_.normals)
                ? lanes
                : plain;
        return s;
    }
    // Whether the lanes can shade the batch's material, asked once for each.
    bool has_job() {
        if (job_of_ != material_) covers_ = shade_job(setup_.shading, *material_, job_);
        job_of_ = material_;
        return covers_;
    }

    const DrawSetup& setup_;
    FacetMemory& m_;
    FacetWalk& walk_;
    const Emitter<SampleSink>& emit_;
    const FacetForm& form_;
    std::int32_t half_px_;
    bool batched_;
    CodePlane plane_{};
    const Mesh* mesh_ = nullptr;
    const Material* material_ = nullptr;  // of the batch
    const Material* job_of_ = nullptr;    // whose job this is
    bool covers_ = false;
    ShadeJob job_;
};

}  // namespace umbra78::raster::detail
