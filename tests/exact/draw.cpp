// Draws figures 1 to 8 and a scene of each method, with the core rooms alone and without a library
// for text, files or memory, so that it runs on a bare processor. It prints lines
//   buffer CASE NAME uBITS:WIDTHxHEIGHT:fnv1a64:HASH      a plane that was drawn
//   stage CASE STAGE N                                    instructions, where they are counted
//   memory CASE BYTES                                     of the frame, and of its method
//   all drawn
// A name that begins with `only` is drawn, and with "" all are.
#include "fixed/fnv.hpp"
#include "shadow/frame/frame.hpp"
#include "shadow/frame/methods.hpp"
#include "shadow/frame/paper_figures.hpp"
#include "tests/exact/port.hpp"
#include "tests/exact/scene_words.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace {

using namespace umbra78;
using exact::port::instructions;

// --- lines ---------------------------------------------------------------------------------------

class Line {
public:
    Line& text(const char* s) {
        while (*s != 0) put(*s++);
        return *this;
    }
    Line& number(std::uint64_t v, unsigned base = 10, int digits = 1) {
        char reversed[20];
        int n = 0;
        for (; v != 0 || n < digits; v /= base) reversed[n++] = "0123456789abcdef"[v % base];
        while (n > 0) put(reversed[--n]);
        return *this;
    }
    ~Line() {
        put('\n');
        exact::port::write(held_, used_);
    }

private:
    void put(char c) {
        if (used_ < sizeof held_) held_[used_++] = c;
    }
    char held_[160];
    std::size_t used_ = 0;
};

template <class Value>
void add(fixed::Fnv1a64& h, std::span<const Value> values) {
    for (const Value v : values) {
        if constexpr (sizeof(Value) == 1) h.byte(v);
        if constexpr (sizeof(Value) == 2) h.u16be(v);
        if constexpr (sizeof(Value) == 4) h.u32be(v);
    }
}

// One buffer of `count` planes, one after another.
struct Buffer {
    const char* of_case;
    int side;

    template <class Plane>
    void print(const char* name, std::size_t count, Plane plane) const {
        fixed::Fnv1a64 h;
        int bits = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const auto values = plane(k);
            bits = 8 * static_cast<int>(sizeof values[0]);
            add(h, std::span<const std::remove_cvref_t<decltype(values[0])>>(values));
        }
        Line line;
        line.text("buffer ").text(of_case).text(" ").text(name).text(" u");
        line.number(static_cast<unsigned>(bits)).text(bits == 8 ? ":" : "be:");
        line.number(static_cast<unsigned>(side)).text("x");
        line.number(count * static_cast<unsigned>(side)).text(":fnv1a64:");
        line.number(h.value(), 16, 16);
    }
    template <class Values>
    void print(const char* name, const Values& values) const {
        print(name, 1, [&](std::size_t) { return values; });
    }
};

// --- frames --------------------------------------------------------------------------------------

// A bare processor has it where there is room, and its start does not clear it.
[[gnu::section(".bss.frames")]] alignas(shadow::frame_alignment) std::byte
    memory[UMBRA78_EXACT_MEMORY];
shadow::FrameInputs inputs;
shadow::FramePlan plan;
shadow::FrameCounts counts;
int filler = 0;
const char* only = "";
bool failed = false;

bool is_drawn(const char* name) {
    const char* wanted = only;
    while (*wanted != 0 && *wanted == *name) ++wanted, ++name;
    return *wanted == 0;
}

template <class Work>
void timed(const char* of_case, const char* stage, Work work) {
    const std::uint64_t before = instructions();
    work();
    const std::uint64_t after = instructions();
    if (after == before) return;
    Line line;
    line.text("stage ").text(of_case).text(" ").text(stage).text(" ").number(after - before);
}

void fail(const char* of_case, const char* why) {
    failed = true;
    Line().text("failed ").text(of_case).text(": ").text(why);
}

bool load(const char* name) {
    bool loaded = false;
    timed(name, "matrices", [&] {
        loaded = shadow::load_matrices(inputs.scene, inputs.settings, inputs.matrices) ==
                 shadow::FrameStatus::ok;
        if (loaded) plan = shadow::make_plan(inputs);
    });
    return loaded;
}

// What lies behind the frame is the method's.
template <class Depth>
bool carve(const char* name, shadow::FrameBuffers<Depth>& frame) {
    const shadow::FrameShape shape(inputs.scene, inputs.settings);
    const hw::MachineSpec& machine = inputs.settings.machine;
    const std::size_t patches = inputs.scene.patches.size();
    const std::size_t bytes = shadow::frame_bytes<Depth>(machine, patches, shape);
    const shadow::Method& method = shadow::method_of(inputs);
    const std::size_t least = method.memory != nullptr ? method.memory(inputs) : 0;
    const std::size_t end = (bytes + shadow::frame_alignment - 1) / shadow::frame_alignment *
                            shadow::frame_alignment;
    if (end + least > sizeof memory) return false;
    std::fill_n(memory, method.memory != nullptr ? sizeof memory : end,
                static_cast<std::byte>(filler));
    frame = shadow::carve<Depth>({memory, bytes}, machine, patches, shape);
    frame.method_memory = std::span(memory).subspan(end);
    Line().text("memory ").text(name).text(" ").number(end + least);
    return true;
}

template <class Depth>
bool draw(const char* name, const shadow::Scene& scene, const shadow::Settings& settings,
          shadow::FrameBuffers<Depth>& frame) {
    inputs.scene = scene;
    inputs.settings = settings;
    counts = {};
    if (!load(name)) return fail(name, "its matrices are refused"), false;
    if (!carve(name, frame)) return fail(name, "its frame needs more memory"), false;
    timed(name, "light", [&] { shadow::draw_light(inputs, plan, frame, counts); });
    timed(name, "observer", [&] { shadow::draw_observer(inputs, plan, frame, counts); });
    timed(name, "shadow", [&] { shadow::cast_shadows(inputs, plan, frame, counts); });
    timed(name, "filters", [&] { shadow::filter_and_composite(inputs, plan, frame, counts); });
    for (const shadow::LightCounts& light : counts.lights)
        if (!light.capacity.enough) return fail(name, "its method needs more memory"), false;
    return true;
}

// --- figures 1 to 6 ------------------------------------------------------------------------------

void draw_figures() {
    const shadow::FigurePatches patches = shadow::figure_patches();
    const std::array materials{shadow::figure_material};
    shadow::Scene scene;
    scene.patches = patches;
    scene.materials = materials;
    scene.observer = shadow::figure_view(0);
    scene.lights[0] = shadow::figure_view(shadow::figure_azimuth_q16);
    shadow::FrameBuffers<hw::Depth16> frame;
    if (draw("fig3", scene, shadow::figure_settings(3), frame)) {
        Buffer{"fig1", 512}.print("observer_z", frame.observer.depth);
        Buffer{"fig1", 512}.print("intensity", frame.observer.intensity);
        Buffer{"fig2", 512}.print("light_z", frame.lights[0].map.depth);
        Buffer{"fig3", 512}.print("mask3", frame.lights[0].mask);
    }
    if (draw("fig4", scene, shadow::figure_settings(4), frame))
        Buffer{"fig4", 512}.print("mask4", frame.lights[0].mask);
    if (draw("fig6", scene, shadow::figure_settings(6), frame)) {
        Buffer{"fig5", 512}.print("edges5", frame.lights[0].edges);
        Buffer{"fig5", 512}.print("filtered5", frame.lights[0].filtered);
        Buffer{"fig6", 512}.print("picture6", frame.picture);
        exact::port::show(frame.picture.data(), 512);
    }
    if constexpr (!hw::built(hw::Feature::ap120b)) return;
    for (const int figure : {3, 4})
        if (draw("ap120b", scene, shadow::array_figure_settings(figure), frame))
            Buffer{"ap120b", 512}.print(figure == 3 ? "mask3_ap120b" : "mask4_ap120b",
                                        frame.lights[0].mask);
}

// --- scenes --------------------------------------------------------------------------------------

template <class Depth>
void draw_scene(const exact::SceneWords& words, const shadow::Settings& settings) {
    const shadow::Scene scene = words.scene();
    shadow::FrameBuffers<Depth> frame;
    if (!draw(words.name, scene, settings, frame)) return;
    const Buffer buffer{words.name, settings.machine.size_px()};
    buffer.print("observer_z", frame.observer.depth);
    if (!frame.lights[0].map.depth.empty())
        buffer.print("light_z", scene.light_count,
                     [&](std::size_t l) { return frame.lights[l].map.depth; });
    buffer.print("intensity", scene.channels, [&](std::size_t c) { return frame.intensity(c); });
    const auto first = [&](std::size_t s) { return scene.source(s).first_light; };
    buffer.print("mask", scene.sources_used(),
                 [&](std::size_t s) { return frame.lights[first(s)].mask; });
    buffer.print("filtered", scene.sources_used(),
                 [&](std::size_t s) { return frame.lights[first(s)].filtered; });
    buffer.print("picture", scene.channels, [&](std::size_t c) { return frame.picture_of(c); });
}

void draw_scene(const exact::SceneWords& words) {
    shadow::Settings settings;
    for (const exact::SettingWord& s : words.settings)
        shadow::find_setting(s.key)->set(settings, s.word);
    if (settings.machine.z_bits <= 16) {
        draw_scene<hw::Depth16>(words, settings);
    } else {
        draw_scene<hw::Depth32>(words, settings);
    }
}

}  // namespace

int umbra78_exact(int with, const char* cases) {
    filler = with;
    only = cases;
    if (is_drawn("figures")) draw_figures();
    for (const exact::SceneWords& words : exact::scenes)
        if (is_drawn(words.name)) draw_scene(words);
    if (!failed) Line().text("all drawn");
    return failed ? 1 : 0;
}
