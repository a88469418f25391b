// The memory replay (a frame's post-process with memory chips of the time) as text and JSON.
#pragma once

#include "shadow/clocked/memory_replay.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace umbra78::tools {

// A line a store: accesses, page hits, row misses, waits; then the time, and that of ideal stores.
std::string print_memory(const shadow::MemoryLedger&);
nlohmann::ordered_json to_json(const shadow::MemoryLedger&);

}  // namespace umbra78::tools
