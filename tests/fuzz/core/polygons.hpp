// Polygons of the rivals' fuzz targets: a scene full of ties, from bytes.
#pragma once

#include "tests/fuzz/core/oracle.hpp"
#include "tests/shadow/rivals/scenes.hpp"

namespace umbra78::fuzz {

inline shadow::rivals::test::Polygons any_polygons(Bytes& bytes) {
    int left = 400;  // of zeros without end a light would never come
    return shadow::rivals::test::chosen_polygons([&](int from, int to) {
        if (--left < 0) return to;
        return bytes.number(from, to);
    });
}

}  // namespace umbra78::fuzz
