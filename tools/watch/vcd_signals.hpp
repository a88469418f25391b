// The signals of one stage of the clocked post-process in a value change dump.
#pragma once

#include "tools/io/vcd_text.hpp"
#include "tools/watch/machine_watch.hpp"

#include <functional>
#include <string>
#include <vector>

namespace umbra78::tools {

class StageSignals {
public:
    // Declares the signals. The `first` stage of a unit also has the words that enter it.
    StageSignals(VcdText&, const std::string& scope, shadow::StageKind, bool first,
                 const shadow::PostProcessPipeline&);

    void set(VcdText&, const StageCycle&, const shadow::PointRegisters* in_it) const;

private:
    struct Port {
        VcdText::Signal signal;
        std::function<std::int64_t(const shadow::PointRegisters&)> read;
    };
    template <class Read>
    void port(const std::string& name, int bits, Read read);
    void add_ports(shadow::StageKind, bool first, const shadow::PostProcessPipeline&);
    void transform_ports(bool first, const hw::TransformPipeline&);
    void divider_ports(const shadow::PostProcessPipeline&);
    void place_ports(const shadow::PostProcessPipeline&);
    void fetch_ports(const shadow::LookupPipeline&);
    void compare_ports(const shadow::LookupPipeline&);
    void interpolate_ports(const hw::MachineSpec&);

    VcdText& vcd_;
    std::string scope_;
    VcdText::Signal state_, valid_, ready_, point_, px_, py_;
    std::vector<Port> ports_;
};

}  // namespace umbra78::tools
