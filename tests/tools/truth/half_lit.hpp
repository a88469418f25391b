// A truth and masks with one straight edge, top to bottom.
#pragma once

#include "tools/truth/truth.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace umbra78::tools::test {

using Bytes = std::vector<std::uint8_t>;

// A truth that is seen everywhere and lit left of `edge`.
inline Truth half_lit(int size, int edge) {
    Truth truth;
    truth.size = size;
    truth.visible.assign(size * size, 1);
    for (int at = 0; at < size * size; ++at) truth.lit.push_back(at % size < edge);
    return truth;
}

inline Bytes shadow_from(int size, int edge) {
    Bytes mask;
    for (int at = 0; at < size * size; ++at) mask.push_back(at % size < edge ? 0 : 255);
    return mask;
}

inline int total(const Bytes& band) {
    return static_cast<int>(std::count(band.begin(), band.end(), 1));
}

}  // namespace umbra78::tools::test
