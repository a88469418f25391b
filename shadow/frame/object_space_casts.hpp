// Class 2 of the rivals, handed its memory from what is left of the frame's (as rival_casts.hpp).
#pragma once

#include "shadow/frame/rival_casts.hpp"

namespace umbra78::shadow {

rivals::Work by_splitting(const rivals::Setting& s, std::span<const std::uint32_t> shown,
                          Carver& carver, std::span<std::uint8_t> mask);

rivals::Work by_perimeters(const rivals::Setting& s, std::span<const std::uint32_t> shown,
                           Carver& carver, std::span<std::uint8_t> mask);

}  // namespace umbra78::shadow
