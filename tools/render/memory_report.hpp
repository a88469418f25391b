// The memory replay as text and JSON.
#pragma once

#include "shadow/clocked/memory_replay.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace umbra78::tools {

// Store by store: accesses, page hits, row misses, waits; and the frame beside the ideal one.
std::string print_memory(const shadow::MemoryLedger&);
nlohmann::ordered_json to_json(const shadow::MemoryLedger&);

}  // namespace umbra78::tools
