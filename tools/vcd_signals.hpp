// The signals of one stage of the clocked post-process in a value change dump.
#pragma once

#include "tools/machine_watch.hpp"
#include "tools/vcd_text.hpp"

#include <functional>
#include <string>
#include <vector>

namespace umbra78::tools {

class StageSignals {
public:
    // Declares them. `first` stages of a unit have what enters it, too.
    StageSignals(VcdText&, const std::string& scope, shadow::StageKind, bool first,
                 const shadow::PostProcessPlan&);

    void set(VcdText&, const StageCycle&, const shadow::Flight* in_it) const;

private:
    struct Port {
        VcdText::Signal signal;
        std::function<std::int64_t(const shadow::Flight&)> read;
    };
    template <class Read>
    void port(const std::string& name, int bits, Read read);
    void add_ports(shadow::StageKind, bool first, const shadow::PostProcessPlan&);
    void transform_ports(bool first, const hw::TransformPlan&);
    void divider_ports(const shadow::PostProcessPlan&);
    void place_ports(const shadow::PostProcessPlan&);
    void fetch_ports(const shadow::LookupPlan&);
    void interpolate_ports(const hw::MachineSpec&);

    VcdText& vcd_;
    std::string scope_;
    VcdText::Signal state_, valid_, ready_, point_, px_, py_;
    std::vector<Port> ports_;
};

}  // namespace umbra78::tools
