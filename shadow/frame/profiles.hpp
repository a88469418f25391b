// Profiles: machines of 1978, each a list of settings and where their values come from.
//
// A profile is a whole machine. Applying it sets every setting that any profile names: to its own
// value where it names it, else to the default. So a profile replaces another, and leaves nothing
// of it. Settings that no profile names keep their values. Each value gives its source, or says
// that it is this project's assumption.
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
const Profile* find_profile(std::string_view name);  // null if there is none
bool is_set_by_profiles(std::string_view key);  // whether any profile names the setting
void apply(const Profile& profile, Settings& settings);

}  // namespace umbra78::shadow
