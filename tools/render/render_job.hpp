// A frame as the program draws it: its memory, its stages with their times, and its cost on the
// machine.
//
// The core works in memory that its caller hands in; a RenderJob owns that memory. Stages run one
// by one, so that what does not change between two pictures is drawn once. Times of the host are
// wall clock, in milliseconds.
#pragma once

#include "raster/source.hpp"
#include "shadow/clocked/memory_replay.hpp"
#include "shadow/frame/frame.hpp"
#include "shadow/frame/ledger.hpp"
#include "tools/io/buffers.hpp"
#include "tools/stream/stream.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace umbra78::tools {

struct StageTimes {
    double matrices_ms = 0;  // and the plan
    double light_ms = 0, observer_ms = 0, post_process_ms = 0, filters_ms = 0;
    double stream_ms = 0;    // all stages of a frame that is drawn from a stream, reading included
    double total_ms() const {
        return matrices_ms + light_ms + observer_ms + post_process_ms + filters_ms + stream_ms;
    }
};

constexpr double simulated_ms(std::uint64_t cycles, int clock_ns) {
    return static_cast<double>(cycles) * clock_ns * 1e-6;
}

// The kinds of a frame's planes. Z is 16 or 32 bits a word, a normal's are 16,
// the others are 8.
enum class Plane : std::uint8_t {
    observer_z,
    light_z,    // of each light
    intensity,  // of each channel
    direct,     // a source's share of the intensity, of each source and channel
    mask,       // as compared, of each light
    darkness,   // of a source with several lights, from their masks
    edges,      // after the edge dequantizing, of each source
    filtered,   // after the low-pass, of each source
    picture,    // of each channel
    normal,     // if they are kept; the channel is the axis
};

// One of them: in a grey frame with one light the kind says which.
struct PlaneOf {
    Plane plane;
    std::size_t light = 0;  // or the source
    std::size_t channel = 0;

    PlaneOf(Plane kind, std::size_t of = 0, std::size_t in_channel = 0)
        : plane(kind), light(of), channel(in_channel) {}
};
// "mask", of the second light "mask2", in a channel of a coloured frame "direct2_red".
std::string name_of(const PlaneOf&, bool coloured = false);

// Whether the lights' maps are read by more than the shadow test (FrameInputs::shows_maps).
enum class Maps : std::uint8_t { shown, for_shadows_alone };

class RenderJob {
public:
    // The scene's spans must live as long as the job. Throws SceneError if the frame's matrices
    // do not fit. The executor, a ThreadPool's, must live as long, too; the frame is the same
    // with any.
    RenderJob(const shadow::Scene&, const shadow::Settings&, Maps = Maps::shown,
              const shadow::Executor& executor = {});

    // Other settings for the stages that follow. Throws SceneError, and leaves the job as it was,
    // if xy_bits or z_bits differ from the frame's or the matrices do not fit.
    void use(const shadow::Settings&);

    // The next frame of a sequence, after render(): the stages keep what has not changed. The
    // spans of both scenes must live. Throws SceneError, and leaves the job as it was, where use()
    // does and if the scene has more patches than the first one.
    void advance(const shadow::Scene&, const shadow::Settings&);

    void draw_light();
    void draw_observer();
    void cast_shadows();
    void filter_and_composite();
    void render();  // all of them, in order
    // All of them for a scene that is streamed, from this source, which is `stream` or draws from
    // it. Throws SceneError, and the frame is not whole, if it cannot be read to its end.
    void render_stream(raster::PrimitiveSource&, const PrimitiveStream& stream);

    const shadow::FrameInputs& inputs() const { return inputs_; }
    const shadow::Settings& settings() const { return inputs_.settings; }
    const shadow::FrameMatrices& matrices() const { return inputs_.matrices; }
    const shadow::FramePlan& plan() const { return plan_; }
    const shadow::FrameCounts& counts() const { return counts_; }
    const StageTimes& times() const { return times_; }
    // What the frame takes on the machine, as its first light has it, or each light in turn; draws
    // the views once more, to count, unless that was done in settings that draw them alike.
    shadow::FrameLedger ledger() const { return ledger(0); }
    std::vector<shadow::FrameLedger> ledgers() const;
    // The post-process again, through memory of the time.
    shadow::MemoryLedger replay_memory() const;
    // Without what a sequence adds once its lights alone move: a list of 57 bytes a pixel.
    std::size_t frame_bytes() const { return bytes_ + method_bytes_; }

    // All planes, in the order of the frame.
    std::vector<PlaneOf> planes() const;
    // A view into the frame's memory, as it is now.
    Buffer buffer(const PlaneOf&) const;
    std::span<const std::uint8_t> bytes(const PlaneOf&) const;  // of a plane of 8 bits
    bool coloured() const { return inputs_.scene.channels > 1; }
    // A coloured frame's picture, three bytes a pixel.
    std::vector<std::uint8_t> rgb() const;
    std::vector<std::uint8_t> visible() const;         // 1 where something was drawn

private:
    struct Free {
        void operator()(std::byte* memory) const {
            ::operator delete[](memory, std::align_val_t{shadow::frame_alignment});
        }
    };
    template <class Depth>
    void allocate();
    void make_room(std::size_t bytes);
    std::size_t bytes_short_of() const;
    void check_carved(const shadow::Scene&, const shadow::Settings&) const;
    void load(shadow::FrameInputs next, const shadow::FrameInputs* before);
    shadow::FrameLedger ledger(std::size_t light) const;
    void forget_counts(const shadow::FrameInputs& next);
    void list_visible();

    shadow::FrameInputs inputs_;
    shadow::FramePlan plan_{};
    shadow::FrameCounts counts_{};
    StageTimes times_{};
    std::size_t bytes_ = 0, patches_ = 0;  // that the memory was carved for
    int layers_ = 1;                       // of the light's map, likewise
    bool normals_ = false;                 // whether it has planes for them
    shadow::Executor executor_;
    std::unique_ptr<std::byte[], Free> memory_;
    std::size_t method_bytes_ = 0;
    std::unique_ptr<std::byte[], Free> method_memory_;
    // What the observer sees, from the first frame on whose lights alone are others.
    std::vector<raster::VisibleBlock> visible_blocks_;
    std::unique_ptr<raster::VisibleList> visible_;
    std::variant<shadow::FrameBuffers<hw::Depth16>, shadow::FrameBuffers<hw::Depth32>> frame_;
    // The last ledgers whose counts still are those of the observer's view, and of each light's.
    mutable std::optional<shadow::FrameLedger> counted_observer_;
    mutable std::array<std::optional<shadow::FrameLedger>, shadow::max_lights> counted_light_;
};

}  // namespace umbra78::tools
