#include "tools/render/render_job.hpp"

#include "shadow/frame/reuse.hpp"
#include "shadow/frame/stream.hpp"
#include "tools/scene/checks.hpp"
#include "tools/scene/scene_error.hpp"

#include <algorithm>
#include <fmt/format.h>

#include <chrono>

namespace umbra78::tools {
namespace {

// Runs a stage and returns its milliseconds.
template <class Stage>
double timed_ms(Stage stage) {
    const auto start = std::chrono::steady_clock::now();
    stage();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

}  // namespace

RenderJob::RenderJob(const shadow::Scene& scene, const shadow::Settings& settings, Maps maps,
                     const shadow::Executor& executor)
    : executor_(executor) {
    inputs_.shows_maps = maps == Maps::shown;
    load({scene, settings, {}}, nullptr);
    if (settings.machine.z_bits <= 16) {
        allocate<hw::Depth16>();
    } else {
        allocate<hw::Depth32>();
    }
}

template <class Depth>
void RenderJob::allocate() {
    const hw::MachineSpec& machine = settings().machine;
    patches_ = inputs_.scene.patches.size();
    layers_ = shadow::map_layers(settings());
    normals_ = shadow::reads_normals(settings());
    shadow::FrameShape shape(inputs_.scene, settings());
    shape.workers = executor_.workers;
    bytes_ = shadow::frame_bytes<Depth>(machine, patches_, shape);
    memory_.reset(new (std::align_val_t{shadow::frame_alignment}) std::byte[bytes_]);
    auto& frame =
        frame_.emplace<shadow::FrameBuffers<Depth>>(
            shadow::carve<Depth>({memory_.get(), bytes_}, machine, patches_, shape));
    frame.executor = executor_;
    make_room(0);
}

// For what the method keeps: at least `bytes`, and what it needs in any case.
void RenderJob::make_room(std::size_t bytes) {
    const shadow::Method& method = shadow::method_of(inputs_);
    if (method.memory != nullptr) bytes = std::max(bytes, method.memory(inputs_));
    if (bytes > method_bytes_) {
        method_memory_.reset(new (std::align_val_t{shadow::frame_alignment}) std::byte[bytes]);
        method_bytes_ = bytes;
    }
    std::visit([&](auto& f) { f.method_memory = {method_memory_.get(), method_bytes_}; }, frame_);
}

void RenderJob::use(const shadow::Settings& settings) {
    check_carved(inputs_.scene, settings);
    load({inputs_.scene, settings, {}}, nullptr);
}

void RenderJob::advance(const shadow::Scene& scene, const shadow::Settings& settings) {
    check_carved(scene, settings);
    load({scene, settings, {}}, &inputs_);
    if (plan_.leaves_out(shadow::Omission::same_depth) &&
        !plan_.leaves_out(shadow::Omission::same_observer))
        list_visible();
}

void RenderJob::list_visible() {
    if (visible_ != nullptr) return;
    std::visit(
        [&](auto& f) {
            visible_blocks_.resize(raster::VisibleList::blocks_for(f.pixels()) + patches_);
            visible_ = std::make_unique<raster::VisibleList>(visible_blocks_);
            f.visible = visible_.get();
        },
        frame_);
}

void RenderJob::check_carved(const shadow::Scene& scene, const shadow::Settings& settings) const {
    const hw::MachineSpec &now = inputs_.settings.machine, &next = settings.machine;
    if (next.xy_bits != now.xy_bits || next.z_bits != now.z_bits)
        throw SceneError(fmt::format("this frame was made for xy_bits {} and z_bits {}: for {} and "
                                     "{} make another",
                                     now.xy_bits, now.z_bits, next.xy_bits, next.z_bits));
    if (shadow::FrameShape(scene) != shadow::FrameShape(inputs_.scene))
        throw SceneError("this frame was made for other lights, or in grey: make another");
    if (shadow::map_layers(settings) > layers_)
        throw SceneError(layers_ == 0 ? "this frame was made for a form on a ground, without a "
                                        "light's map: for another form make another"
                                      : "this frame was made for one depth a texel of the light's "
                                        "map: for map_depth=midpoint make another");
    if (shadow::reads_normals(settings) && !normals_)
        throw SceneError("this frame was made without normals: for slope_source=normals make "
                         "another");
    if (scene.patches.size() > patches_)
        throw SceneError(fmt::format("this frame was made for {} patches: for {} make another",
                                     patches_, scene.patches.size()));
}

// Matrices and plan are made aside and taken over last, so that a refusal changes nothing.
void RenderJob::load(shadow::FrameInputs next, const shadow::FrameInputs* before) {
    next.shows_maps = inputs_.shows_maps;
    auto status = shadow::FrameStatus::ok;
    shadow::FramePlan plan;
    const double ms = timed_ms([&] {
        status = shadow::load_matrices(next.scene, next.settings, next.matrices);
        if (status == shadow::FrameStatus::ok) plan = shadow::make_plan(next, before);
    });
    if (status != shadow::FrameStatus::ok) throw SceneError(explain(status));
    forget_counts(next);
    inputs_ = next;
    plan_ = plan;
    times_.matrices_ms = ms;
}

void RenderJob::draw_light() {
    times_.light_ms = timed_ms([&] {
        std::visit([&](auto& f) { shadow::draw_light(inputs_, plan_, f, counts_); }, frame_);
    });
}

void RenderJob::draw_observer() {
    times_.observer_ms = timed_ms([&] {
        std::visit([&](auto& f) { shadow::draw_observer(inputs_, plan_, f, counts_); }, frame_);
    });
}

void RenderJob::cast_shadows() {
    const auto cast = [&] {
        std::visit([&](auto& f) { shadow::cast_shadows(inputs_, plan_, f, counts_); }, frame_);
    };
    make_room(0);
    times_.post_process_ms = timed_ms(cast);
    // A method that ran out of memory has said how much it needs; that may take several steps.
    for (std::size_t needed = bytes_short_of(); needed > 0; needed = bytes_short_of()) {
        make_room(needed);
        times_.post_process_ms = timed_ms(cast);
    }
}

// Of what the method had too little of; 0 if it had enough.
std::size_t RenderJob::bytes_short_of() const {
    std::size_t needed = 0;
    for (std::size_t l = 0; l < inputs_.scene.light_count; ++l)
        if (const shadow::Capacity& c = counts_.lights[l].capacity; !c.enough)
            needed = std::max(needed, static_cast<std::size_t>(c.needed));
    return needed;
}

void RenderJob::filter_and_composite() {
    times_.filters_ms = timed_ms([&] {
        std::visit([&](auto& f) { shadow::filter_and_composite(inputs_, plan_, f, counts_); },
                   frame_);
    });
}

void RenderJob::render() {
    draw_light();
    draw_observer();
    cast_shadows();
    filter_and_composite();
}

void RenderJob::render_stream(raster::PrimitiveSource& source, const PrimitiveStream& stream) {
    auto status = shadow::StreamStatus::ok;
    times_.stream_ms = timed_ms([&] {
        status = std::visit(
            [&](auto& f) { return shadow::draw_stream(inputs_, plan_, source, f, counts_); },
            frame_);
    });
    switch (status) {
        case shadow::StreamStatus::ok: return;
        case shadow::StreamStatus::source_failed: throw SceneError(stream.error());
        case shadow::StreamStatus::cannot_rewind:
            throw SceneError(fmt::format("{} cannot be read twice, as the correct form does; give "
                                         "--spool, or --set form=post_process", stream.name()));
        case shadow::StreamStatus::beyond_largest:
            throw SceneError(fmt::format("{}: a coordinate is beyond stream.largest; raise it, or "
                                         "leave it out", stream.name()));
    }
}

shadow::FrameLedger RenderJob::ledger(std::size_t light) const {
    const auto known = [](const auto& counted) { return counted ? &*counted : nullptr; };
    const shadow::KnownCounts counts{known(counted_observer_), known(counted_light_[light])};
    const shadow::FrameLedger made = std::visit(
        [&](const auto& frame) {
            return shadow::frame_ledger(inputs_, frame, counts_, light, counts);
        },
        frame_);
    if (!inputs_.scene.streamed) counted_observer_ = counted_light_[light] = made;
    return made;
}

void RenderJob::forget_counts(const shadow::FrameInputs& next) {
    const auto counted = [](const auto& ledger) { return ledger.has_value(); };
    if (!counted_observer_ && std::ranges::none_of(counted_light_, counted)) return;
    const shadow::Reuse kept = shadow::find_reuse(inputs_, next);
    if (!kept.observer) counted_observer_.reset();
    const bool has_map = shadow::method_of(next).has_map();
    for (std::size_t l = 0; l < counted_light_.size(); ++l)
        if (!has_map || !kept.light_map[l]) counted_light_[l].reset();
}

std::vector<shadow::FrameLedger> RenderJob::ledgers() const {
    std::vector<shadow::FrameLedger> made{ledger()};
    for (std::size_t l = 1; l < inputs_.scene.light_count; ++l)
        made.push_back(ledger(l));
    return made;
}

shadow::MemoryLedger RenderJob::replay_memory() const {
    const hw::MatrixWords& matrix = inputs_.matrices.lights[0].observer_to_light;
    const shadow::PostProcessPipeline plan(settings(), matrix);
    return std::visit(
        [&](const auto& frame) {
            return shadow::replay_memory(frame.observer, matrix, settings(),
                                         static_cast<std::uint64_t>(plan.slot_cycles));
        },
        frame_);
}

std::string name_of(const PlaneOf& of, bool coloured) {
    constexpr const char* names[] = {"observer_z", "light_z",  "intensity", "direct", "mask",
                                     "darkness",   "edges",    "filtered",  "picture"};
    if (of.plane == Plane::normal) return fmt::format("normal_{}", "xyz"[of.channel]);
    constexpr const char* channels[] = {"_red", "_green", "_blue"};
    const bool has_channel = of.plane == Plane::intensity || of.plane == Plane::direct ||
                             of.plane == Plane::picture;
    return fmt::format("{}{}{}", names[static_cast<std::size_t>(of.plane)],
                       of.light > 0 ? fmt::format("{}", of.light + 1) : "",
                       coloured && has_channel ? channels[of.channel] : "");
}

std::vector<PlaneOf> RenderJob::planes() const {
    const shadow::Scene& scene = inputs_.scene;
    const std::size_t sources = scene.sources_used();
    std::vector<PlaneOf> all{Plane::observer_z};
    const auto add = [&](Plane plane, std::size_t count) {
        for (std::size_t k = 0; k < count; ++k) all.emplace_back(plane, k);
    };
    if (shadow::map_layers(settings()) > 0) add(Plane::light_z, scene.light_count);
    for (std::size_t c = 0; c < scene.channels; ++c) {
        all.emplace_back(Plane::intensity, 0, c);
        for (std::size_t s = 0; s < sources; ++s) all.emplace_back(Plane::direct, s, c);
    }
    for (std::size_t axis = 0; shadow::reads_normals(settings()) && axis < 3; ++axis)
        all.emplace_back(Plane::normal, 0, axis);
    for (std::size_t l = 0; l < scene.light_count; ++l)  // sectors have one
        if (!scene.source_of(l).sectored || scene.source_of(l).first_light == l)
            all.emplace_back(Plane::mask, l);
    for (std::size_t s = 0; s < sources; ++s)
        if (scene.source(s).is_graded()) all.emplace_back(Plane::darkness, s);
    add(Plane::edges, sources);
    add(Plane::filtered, sources);
    for (std::size_t c = 0; c < scene.channels; ++c) all.emplace_back(Plane::picture, 0, c);
    return all;
}

Buffer RenderJob::buffer(const PlaneOf& of) const {
    const hw::MachineSpec& spec = settings().machine;
    const std::string name = name_of(of, coloured());
    const auto depth = [&](const auto& store) {
        using Word = typename std::remove_cvref_t<decltype(store.depth)>::value_type;
        return Buffer{name, spec.size_px(), spec.background(), std::span<const Word>(store.depth)};
    };
    return std::visit(
        [&](const auto& frame) {
            if (of.plane == Plane::observer_z) return depth(frame.observer);
            if (of.plane == Plane::light_z) return depth(frame.lights[of.light].map);
            if (of.plane == Plane::normal)
                return Buffer{name, spec.size_px(), 0xffff,
                              std::span<const std::uint16_t>(frame.observer.normal)
                                  .subspan(of.channel * frame.pixels(), frame.pixels())};
            return Buffer{name, spec.size_px(), 255, bytes(of)};
        },
        frame_);
}

std::span<const std::uint8_t> RenderJob::bytes(const PlaneOf& of) const {
    const auto of_source = [&](const auto& frame) -> const auto& {
        return frame.lights[inputs_.scene.source(of.light).first_light];
    };
    return std::visit(
        [&](const auto& frame) -> std::span<const std::uint8_t> {
            switch (of.plane) {
                case Plane::intensity: return frame.intensity(of.channel);
                case Plane::direct: return frame.direct(of.channel, of.light);
                case Plane::mask: return frame.lights[of.light].mask;
                case Plane::darkness: return of_source(frame).joined;
                case Plane::edges: return of_source(frame).edges;
                case Plane::filtered: return of_source(frame).filtered;
                case Plane::picture: return frame.picture_of(of.channel);
                default: return {};
            }
        },
        frame_);
}

std::vector<std::uint8_t> RenderJob::rgb() const {
    std::vector<std::uint8_t> made;
    const std::span red = bytes(Plane::picture), green = bytes({Plane::picture, 0, 1}),
                    blue = bytes({Plane::picture, 0, 2});
    made.reserve(3 * red.size());
    for (std::size_t a = 0; a < red.size(); ++a)
        made.insert(made.end(), {red[a], green[a], blue[a]});
    return made;
}

std::vector<std::uint8_t> RenderJob::visible() const {
    const std::uint32_t background = settings().machine.background();
    std::vector<std::uint8_t> seen;
    std::visit(
        [&](const auto& frame) {
            const auto& depth = frame.observer.depth;
            seen.resize(depth.size());
            for (std::size_t at = 0; at < depth.size(); ++at) seen[at] = depth[at] != background;
        },
        frame_);
    return seen;
}

}  // namespace umbra78::tools
