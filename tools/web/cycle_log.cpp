#include "tools/web/cycle_log.hpp"

#include "tools/watch/machine_watch.hpp"
#include "tools/watch/watched_frame.hpp"

#include <nlohmann/json.hpp>

namespace umbra78::tools::web {
namespace {

using nlohmann::ordered_json;

constexpr const char* reader_names[] = {"done", "read", "slot", "blocked", "held"};
constexpr const char* activity_names[] = {"nothing", "work", "blocked", "held"};

ordered_json cycle_json(const MachineWatch<hw::Depth32>& watch, int size) {
    const WatchedFrame::Machine& machine = watch.machine();
    const ReaderCycle& r = watch.reader();
    const int pixel = static_cast<int>(r.pixel);
    ordered_json reader{reader_names[static_cast<std::size_t>(r.activity)]};
    if (r.activity != ReaderActivity::done) {
        reader.push_back(pixel % size);
        reader.push_back(pixel / size);
        const bool background = r.known && r.code == machine.plan().lookup.spec.background();
        reader.push_back(background ? "background" : r.known ? "visible" : "unknown");
    }
    ordered_json stages = ordered_json::array();
    for (int k = 0; k < machine.chain().stages(); ++k) {
        const StageCycle& s = watch.stage(k);
        if (s.activity == Activity::nothing || s.slot < 0) {
            stages.push_back(nullptr);
            continue;
        }
        const shadow::PointRegisters& point = machine.flight(s.slot);
        stages.push_back({activity_names[static_cast<std::size_t>(s.activity)], s.point, point.px,
                          point.py});
    }
    return {{"cycle", watch.cycle()}, {"reader", reader}, {"stages", stages},
            {"released", r.released}};
}

}  // namespace

ordered_json cycles_json(const RenderJob& job, std::uint64_t from, int count) {
    WatchedFrame frame(job);
    const auto machine = frame.machine();
    MachineWatch<hw::Depth32> watch(*machine);
    while (!machine->done() && machine->cycles() < from) watch.tick();
    ordered_json json{{"stages", ordered_json::array()}, {"cycles", ordered_json::array()}};
    for (int k = 0; k < machine->chain().stages(); ++k)
        json["stages"].push_back(machine->chain().name(k));
    const int size = job.settings().machine.size_px();
    for (int k = 0; k < count && !machine->done(); ++k) {
        watch.tick();
        json["cycles"].push_back(cycle_json(watch, size));
    }
    json["slot_cycles"] = machine->plan().slot_cycles;
    json["latency"] = machine->plan().latency;
    json["done"] = machine->done();
    return json;
}

}  // namespace umbra78::tools::web
