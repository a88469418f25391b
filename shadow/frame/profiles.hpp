// Profiles: machines of the time, each a list of settings with where its values come from.
//
// A profile is nothing but settings set together; whatever it does not name keeps its value. Each
// value says its source, or that it is this project's assumption.
#pragma once

#include "shadow/frame/settings.hpp"

#include <cstdint>
#include <span>
#include <string_view>

namespace umbra78::shadow {

enum class Confidence : std::uint8_t { published, assumed };

struct ProfileValue {
    std::string_view key;  // of settings_table()
    std::int64_t word;
    Confidence confidence;
    std::string_view source;
};

struct Profile {
    std::string_view name, meaning;
    std::span<const ProfileValue> values;
};

std::span<const Profile> profiles();
const Profile* find_profile(std::string_view name);
void apply(const Profile& profile, Settings& settings);

}  // namespace umbra78::shadow
