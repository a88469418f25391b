// The settings of umbra78.h: the table of shadow/frame/settings.hpp, by names and texts.
#include "fixed/decimal.hpp"
#include "shadow/c/handles.hpp"
#include "shadow/frame/profiles.hpp"

#include <algorithm>
#include <string_view>

namespace {

using namespace umbra78;
using shadow::Setting;
using shadow::SettingKind;

// The word that a text means; false where it means none in the setting's range.
bool read(const Setting& setting, std::string_view text, std::int64_t& word) {
    if (setting.kind == SettingKind::choice) {
        const auto found = std::find(setting.names.begin(), setting.names.end(), text);
        word = found - setting.names.begin();
        return found != setting.names.end();
    }
    const fixed::DecimalResult read = fixed::parse_decimal(text, setting.fraction, 64);
    word = read.value;
    if (read.status != fixed::DecimalStatus::ok || word < setting.min || word > setting.max)
        return false;
    // A whole number has no fraction that rounding would hide.
    return setting.kind != SettingKind::whole ||
           text.find_first_not_of("+-0123456789_") == std::string_view::npos;
}

}  // namespace

extern "C" {

umbra78_status umbra78_set(umbra78_scene* scene, const char* key, const char* value) {
    if (scene == nullptr || key == nullptr || value == nullptr) return UMBRA78_NULL_ARGUMENT;
    shadow::Settings next = scene->settings;
    if (std::string_view(key) == "profile") {
        const shadow::Profile* profile = shadow::find_profile(value);
        if (profile == nullptr) return UMBRA78_BAD_VALUE;
        shadow::apply(*profile, next);
    } else {
        const Setting* setting = shadow::find_setting(key);
        if (setting == nullptr) return UMBRA78_UNKNOWN_SETTING;
        std::int64_t word = 0;
        if (!read(*setting, value, word)) return UMBRA78_BAD_VALUE;
        setting->set(next, word);
    }
    if (!shadow::can_be_built(next)) return UMBRA78_CANNOT_BE_BUILT;
    scene->settings = next;
    return UMBRA78_OK;
}

umbra78_status umbra78_get(const umbra78_scene* scene, const char* key, char* value,
                           size_t bytes) {
    if (scene == nullptr || key == nullptr || value == nullptr) return UMBRA78_NULL_ARGUMENT;
    const Setting* setting = shadow::find_setting(key);
    if (setting == nullptr) return UMBRA78_UNKNOWN_SETTING;
    const std::int64_t word = setting->get(scene->settings);
    std::array<char, fixed::longest_decimal> digits;
    std::string_view text;
    if (setting->kind == SettingKind::choice) {
        text = setting->names[static_cast<std::size_t>(word)];
    } else {
        const int length = fixed::print_decimal(word, setting->fraction, digits);
        text = {digits.data(), static_cast<std::size_t>(length)};
    }
    if (text.size() + 1 > bytes) return UMBRA78_MEMORY_TOO_SMALL;
    *std::copy(text.begin(), text.end(), value) = '\0';
    return UMBRA78_OK;
}

// The table's texts are literals, which end in a zero byte.
umbra78_status umbra78_setting_at(size_t number, umbra78_setting* setting) {
    if (setting == nullptr) return UMBRA78_NULL_ARGUMENT;
    if (number >= shadow::settings_table().size()) return UMBRA78_NO_SUCH_PART;
    const Setting& row = shadow::settings_table()[number];
    *setting = {row.key.data(), row.unit.data(), row.meaning.data(), row.min,
                row.max,        row.fraction,    row.names.size()};
    return UMBRA78_OK;
}

const char* umbra78_choice_at(size_t setting, size_t choice) {
    if (setting >= shadow::settings_table().size()) return nullptr;
    const Setting& row = shadow::settings_table()[setting];
    return choice < row.names.size() ? row.names[choice].data() : nullptr;
}

}  // extern "C"
