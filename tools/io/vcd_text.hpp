// A value change dump (IEEE 1364, "four-state VCD") as text: signals, times, changes.
//
//   $timescale 1ns $end  $scope module machine $end  $var wire 16 ! code [15:0] $end  ...
//   #400  b1010 !  1"            time, then each signal that changed
//
// Signals are declared first, in scopes that nest by the dots of their names; until they are set
// they are unknown (x). Only what changes is written, so the text depends on the values alone.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace umbra78::tools {

class VcdText {
public:
    using Signal = std::size_t;

    explicit VcdText(std::string_view comment);

    // `scope` is "machine.s2_accumulate"; declare a scope's signals one after the other.
    Signal add(std::string_view scope, std::string_view name, int bits);

    // The time of the changes that follow, in ns; ascending. The first ends the declarations.
    void time(std::uint64_t ns);
    void set(Signal, std::int64_t value);  // two's complement in the signal's bits

    std::size_t signals() const { return signals_.size(); }
    const std::string& text() const { return text_; }

private:
    struct State {
        std::string id;
        int bits;
        std::optional<std::uint64_t> value;
    };
    void enter(std::string_view scope);
    void end_declarations();

    std::string text_;
    std::vector<State> signals_;
    std::vector<std::string> scope_;
    std::optional<std::uint64_t> time_;  // not yet written
    bool declared_ = false;
};

}  // namespace umbra78::tools
