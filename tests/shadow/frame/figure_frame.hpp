// A frame with memory of its own, and the scene of figures 1 to 6: what the tests of this room and
// of the claims draw.
#pragma once

#include "shadow/frame/frame.hpp"
#include "shadow/frame/methods.hpp"
#include "shadow/frame/paper_figures.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <span>

namespace umbra78::shadow::test {

// Aligned to 64, as carve asks; filled, so that what a frame leaves unwritten shows.
class Memory {
public:
    explicit Memory(std::size_t bytes, std::byte fill = std::byte{0xa5})
        : size_(bytes), data_(static_cast<std::byte*>(
                            ::operator new(bytes == 0 ? 1 : bytes, std::align_val_t{64}))) {
        std::fill_n(data_.get(), size_, fill);
    }
    std::span<std::byte> span() const { return {data_.get(), size_}; }

private:
    struct Free {
        void operator()(std::byte* p) const { ::operator delete(p, std::align_val_t{64}); }
    };
    std::size_t size_;
    std::unique_ptr<std::byte, Free> data_;
};

struct FigureScene {
    FigurePatches patches = figure_patches();
    std::array<raster::Material, 1> materials{figure_material};

    Scene scene(std::int32_t azimuth_q16 = figure_azimuth_q16) const {
        return {patches, materials, figure_view(0), {{figure_view(azimuth_q16)}}};
    }
};

template <class Depth = hw::Depth16>
struct Frame {
    Frame(const hw::MachineSpec& spec, std::size_t patches, const FrameShape& shape = {})
        : memory(frame_bytes<Depth>(spec, patches, shape)),
          buffers(carve<Depth>(memory.span(), spec, patches, shape)) {}
    explicit Frame(const Scene& scene, const Settings& settings, const Executor& executor = {})
        : Frame(settings.machine, scene.patches.size(), shape_of(scene, settings, executor)) {
        buffers.executor = executor;
        draw(scene, settings);
    }
    FrameStatus draw(const Scene& scene, const Settings& settings) {
        if (const Method* method = method_of(settings);
            method != nullptr && method->memory != nullptr && buffers.method_memory.empty()) {
            method_memory = Memory(method->memory({scene, settings, {}}));
            buffers.method_memory = method_memory.span();
        }
        return status = render(scene, settings, buffers, matrices, counts);
    }

    static FrameShape shape_of(const Scene& scene, const Settings& settings,
                               const Executor& executor) {
        FrameShape shape(scene, settings);
        shape.workers = executor.workers;
        return shape;
    }

    Memory memory, method_memory{0};
    FrameBuffers<Depth> buffers;
    FrameMatrices matrices{};
    FrameCounts counts{};
    FrameStatus status = FrameStatus::ok;
};

}  // namespace umbra78::shadow::test
