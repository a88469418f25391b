// What a frame of streamed hills takes: the machine's cycles, this computer's time and memory.
#include "tools/render/render_job.hpp"
#include "tools/scene/scene_error.hpp"
#include "tools/study/growth/growth.hpp"

#include <fmt/format.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <cmath>
#include <fstream>
#include <cstdlib>
#include <limits>
#include <mutex>

namespace umbra78::tools::study {
namespace {

// Both views hold all hills, however many layers there are.
constexpr const char* views = R"(
[observer]
azimuth = 25
elevation = 35
target = [0, 0, 0]
extent = 46
near = -80
far = 80
[light]
azimuth = -60
elevation = 14
target = [0, 0, 0]
extent = 48
near = -80
far = 80
[stream]
file = "hills"
largest = 40
)";

LoadedScene scene_of_hills(const HillsShape& shape) {
    SceneResult read = read_scene(views, "hills", {}, {}, [&](const std::string&) {
        return OpenedStream{std::make_unique<Hills>(shape), ""};
    });
    if (!read.ok()) throw SceneError(read.error);
    return std::move(read.scene);
}

// The kernel's record of the most memory since it was last reset; NaN where there is none.
class PeakMemory {
public:
    PeakMemory() {
#ifdef __GLIBC__
        ::malloc_trim(0);  // what earlier cases gave back is not this one's
#endif
        std::ofstream reset("/proc/self/clear_refs");
        reset << "5";
        reset.close();
        known_ = reset.good();
    }
    double megabytes() const {
        std::ifstream status("/proc/self/status");
        for (std::string line; known_ && std::getline(status, line);)
            if (line.starts_with("VmHWM:")) return std::strtod(line.c_str() + 6, nullptr) / 1024;
        return std::numeric_limits<double>::quiet_NaN();
    }

private:
    bool known_ = false;
};

constexpr std::uint64_t often = 20000;  // patches up to which a time is the least of five

double milliseconds_of(RenderJob& job, Hills& hills, int runs) {
    double least = std::numeric_limits<double>::infinity();
    for (int run = 0; run < runs; ++run) {
        job.render_stream(hills, hills);
        least = std::min(least, job.times().stream_ms);
    }
    return least;
}

}  // namespace

Row growth_row(const HillsShape& shape, bool host_times) {
    static std::mutex one_at_a_time;
    const std::scoped_lock lock(one_at_a_time);
    const PeakMemory peak;
    const LoadedScene scene = scene_of_hills(shape);
    RenderJob job(scene.view(), scene.settings);
    Hills hills(shape);
    hills.number_materials_from(1);  // the scene's own one comes first
    const double ms = milliseconds_of(job, hills, host_times && shape.patches < often ? 5 : 1);
    const shadow::FrameLedger ledger = job.ledger();
    const auto whole = [](std::uint64_t count) { return static_cast<std::int64_t>(count); };
    Row row;
    row.set("patches", whole(shape.patches));
    row.set("layers", whole(shape.layers));
    row.set("area_px", whole(ledger.light_counts.samples + ledger.observer_counts.samples));
    row.set("picture_hash", hash_of(job.buffer(Plane::picture)));
    row.set("light_cycles", whole(shadow::FrameLedger::cycles(ledger.light, true)));
    row.set("observer_cycles", whole(shadow::FrameLedger::cycles(ledger.observer, true)));
    row.set("transformation_cycles", whole(ledger.transformation(true)));
    row.set("frame_cycles", whole(ledger.total(true)));
    row.set("frame_bytes", whole(job.frame_bytes()));
    row.set("frame_host_ms", ms);
    row.set("peak_host_mb", peak.megabytes());
    return row;
}

Line line_through(std::span<const std::pair<double, double>> points) {
    double w = 0, wx = 0, wxx = 0, wy = 0, wxy = 0;
    for (const auto& [x, y] : points) {
        const double weight = 1 / (y * y);
        w += weight;
        wx += weight * x;
        wxx += weight * x * x;
        wy += weight * y;
        wxy += weight * x * y;
    }
    Line line;
    line.slope = (w * wxy - wx * wy) / (w * wxx - wx * wx);
    line.fixed = (wy - line.slope * wx) / w;
    for (const auto& [x, y] : points)
        line.worst = std::max(line.worst, std::abs(line.fixed + line.slope * x - y) / y);
    return line;
}

}  // namespace umbra78::tools::study
