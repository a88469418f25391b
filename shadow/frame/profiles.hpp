// Profiles: machines of 1978 and the depth maps of today, each a list of settings and where their
// values come from.
//
// A profile is a whole machine of its kind. Applying it sets every setting that any profile of that
// kind names: to its own value where it names it, else to the default. So a profile replaces
// another of its kind, and leaves nothing of it. Settings that none of them names keep their
// values: a depth map's profile leaves the clock, and a machine's leaves the stores' widths. Each
// value gives its source, or says that it is this project's assumption.
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

enum class ProfileKind : std::uint8_t { machine_of_1978, map_of_today };

struct Profile {
    ProfileKind kind;
    std::string_view name, meaning;
    std::span<const ProfileValue> values;
};

std::span<const Profile> profiles();
std::span<const Profile> profiles_of_1978();  // the first of them: those with cycles of the time
const Profile* find_profile(std::string_view name);  // null if there is none
bool is_set_by_profiles(std::string_view key, ProfileKind);  // whether any of them names it
void apply(const Profile& profile, Settings& settings);

}  // namespace umbra78::shadow
