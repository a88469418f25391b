// Malformed scenes, each with the one line it must be answered with.
#pragma once

#include "tools/scene/scene_file.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace umbra78::tools::test {

inline const std::string ball = "[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n";
inline const std::string ball_and_light = ball + "[light]\nazimuth = -100\n";

struct Malformed {
    std::string scene;
    std::string message;
    std::vector<std::string> set{};
};

inline std::string error_of(const Malformed& m) {
    try {
        parse_scene(m.scene, "a.toml", m.set);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "no error";
}

inline void expect_messages(const std::vector<Malformed>& cases) {
    for (const Malformed& m : cases) EXPECT_EQ(error_of(m), m.message) << m.scene;
}

}  // namespace umbra78::tools::test
