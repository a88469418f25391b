// The lines of a pixel's trace: one word each, with its part of the machine and its cycle.
#pragma once

#include "tools/watch/word_text.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace umbra78::tools {

struct TraceLine {
    std::string part;                    // "multiply", "place", ...
    std::optional<std::uint64_t> cycle;  // none: before the frame, or after the post-process
    std::string name;                    // "acc_X"; empty if the line is only a remark
    std::optional<MachineWord> word;     // none: a remark, or a number wider than 64 bits
    std::string decimal;                 // of the word, or of that number
    std::string how;                     // where it comes from
};

class TraceLog {
public:
    // The lines that follow belong to this part and cycle.
    void at(std::string_view part, std::optional<std::uint64_t> cycle = {});
    void word(std::string_view name, const MachineWord&, std::string_view how = "");
    void number(std::string_view name, const WideWord&, std::string_view how = "");
    void say(std::string_view what);

    const std::vector<TraceLine>& lines() const { return lines_; }

private:
    void add(TraceLine line);

    std::string part_;
    std::optional<std::uint64_t> cycle_;
    std::vector<TraceLine> lines_;
};

std::string to_text(const std::vector<TraceLine>&);
nlohmann::ordered_json to_json(const std::vector<TraceLine>&);

}  // namespace umbra78::tools
