// The divider behind the transform unit: one rounded quotient, with its certificate.
//
//   q = round(acc_r 2^shift / acc_w),   2 |q acc_w - acc_r 2^shift| <= acc_w
//
// The arithmetic is fixed::divide. A serial restoring divider makes one quotient bit a cycle, as
// the clipping dividers of Sproull & Sutherland 1968 did; three quotients share one divider.
// Not emulated here: the clock (functional form; the cost is the closed form below).
#pragma once

#include "hw/machine_spec.hpp"

namespace umbra78::hw {

// Cycles to divide one point's X, Y and Z: a cycle for each bit of the quotient (sign, value and
// the rounding bit) and two to load and to correct.
constexpr int serial_divide_cycles(const MachineSpec& spec) {
    const int xy = spec.xy_bits + spec.fraction_bits + 2;
    const int z = spec.z_bits + 2;
    return 2 * (xy + 2) + z + 2;
}

}  // namespace umbra78::hw
