// The scenes that tools/exact draws beside the figures 1 to 6, in the words of the machine: what a
// program without files and text has of a scene file. Made by scene_words.cpp.
#pragma once

#include "shadow/frame/inputs.hpp"

#include <cstdint>
#include <span>
#include <string_view>

namespace umbra78::exact {

struct SettingWord {
    std::string_view key;
    std::int64_t word;
};

struct SceneWords {
    const char* name;
    std::span<const SettingWord> settings;  // those that are not the default
    shadow::Scene (*scene)();               // its spans are of constant tables
};

extern const std::span<const SceneWords> scenes;

}  // namespace umbra78::exact
