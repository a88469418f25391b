#include "tools/stream/packed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace umbra78::tools {
namespace {

template <class Word>
void put(std::vector<std::byte>& out, Word word) {
    using Bits = std::make_unsigned_t<Word>;
    for (std::size_t k = 0; k < sizeof(Word); ++k)
        out.push_back(static_cast<std::byte>(static_cast<std::uint64_t>(Bits(word)) >> (8 * k)));
}

void put(std::vector<std::byte>& out, const raster::World& p) {
    for (const std::int32_t v : {p.x, p.y, p.z}) put(out, v);
}

}  // namespace

PackedWriter::PackedWriter(const Path& path, std::span<const raster::Material> materials,
                           std::uint64_t count)
    : file_(path), count_(count) {
    for (const char c : {'U', '7', '8', 'P', 'A', 'C', 'K', '1'}) put(block_, c);
    put(block_, count);
    put(block_, static_cast<std::uint32_t>(materials.size()));
    for (const raster::Material& m : materials)
        for (const std::int32_t v : {m.diffuse[0], m.specular[0], m.shininess}) put(block_, v);
    flush();
}

void PackedWriter::flush() {
    file_.write(block_);
    block_.clear();
}

template <class Record>
void PackedWriter::add(Kind kind, std::size_t count, Record&& record) {
    for (std::size_t first = 0; first < count; first += max_packed_records) {
        const std::size_t records = std::min(count - first, max_packed_records);
        put(block_, static_cast<std::uint32_t>(kind));
        put(block_, static_cast<std::uint32_t>(records));
        for (std::size_t k = first; k < first + records; ++k) record(k);
        flush();
        written_ += records;
    }
}

void PackedWriter::add(const raster::Surfaces& surfaces) {
    add(Kind::patches, surfaces.patches.size(), [&](std::size_t k) {
        const raster::Patch& patch = surfaces.patches[k];
        for (const raster::World& p : patch.control) put(block_, p);
        put(block_, std::uint32_t{patch.material});
    });
    const raster::Mesh& mesh = surfaces.mesh;
    add(Kind::triangles, mesh.facets.size(), [&](std::size_t k) {
        const raster::Facet& facet = mesh.facets[k];
        for (const std::uint32_t v : facet.vertex) put(block_, mesh.vertices[v]);
        for (const std::uint32_t n : facet.normal)
            for (std::size_t c = 0; c < 3; ++c)
                put(block_, n == raster::Facet::flat
                                ? std::int16_t{0}
                                : static_cast<std::int16_t>(mesh.normals[n][c]));
        put(block_, facet.material);
    });
}

void PackedWriter::commit() {
    put(block_, static_cast<std::uint32_t>(Kind::end));
    put(block_, std::uint32_t{0});
    flush();
    if (count_ != unknown_count && written_ != count_)
        throw std::runtime_error(
            fmt::format("{} primitives were written of {}", written_, count_));
    file_.commit();
}

}  // namespace umbra78::tools
