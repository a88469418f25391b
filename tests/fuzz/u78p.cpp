// Fuzz target: a packed file. What is read twice is the same twice.
#include "tests/fuzz/model_target.hpp"
#include "tools/stream/packed.hpp"

#include <cstdio>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace umbra78;
    using Next = raster::PrimitiveSource::Next;
    if (size == 0) return 0;
    std::FILE* file = ::fmemopen(const_cast<std::uint8_t*>(bytes), size, "rb");
    const tools::OpenedStream opened = tools::open_packed(file, "a.u78p", true);
    if (!opened.stream) return 0;
    std::uint64_t hashes[2] = {};
    for (std::uint64_t& hash : hashes) {
        raster::Surfaces batch;
        Next next = Next::end;
        tools::test::require(opened.stream->rewind());
        while ((next = opened.stream->next(batch)) == Next::batch)
            for (const raster::Facet& facet : batch.mesh.facets)
                for (const std::uint32_t v : facet.vertex)
                    tools::test::require(v < batch.mesh.vertices.size());
        tools::test::require((next == Next::end) == opened.stream->error().empty());
        tools::test::require(opened.stream->error().find('\n') == std::string::npos);
        hash = opened.stream->hash();
        if (next == Next::failed) return 0;
    }
    tools::test::require(hashes[0] == hashes[1]);
    return 0;
}
