// The table of settings in hw/MACHINE.md, section 2, is the program's: every key, default, range
// and unit, in its order.
#include "fixed/decimal.hpp"
#include "shadow/frame/settings.hpp"
#include "tests/support/machine_text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace umbra78::shadow {
namespace {

std::string written(const Setting& s, std::int64_t word) {
    if (s.kind == SettingKind::choice) return std::string(s.names[static_cast<std::size_t>(word)]);
    std::array<char, fixed::longest_decimal> text;
    const int length = fixed::print_decimal(word, s.fraction, text);
    return {text.data(), static_cast<std::size_t>(length)};
}

std::string range(const Setting& s) {
    if (s.kind != SettingKind::choice) return written(s, s.min) + " .. " + written(s, s.max);
    std::string names;
    for (const std::string_view name : s.names)
        names += (names.empty() ? "" : ", ") + std::string(name);
    return names;
}

TEST(SettingsDocument, HasEverySettingWithDefaultAndRange) {
    const auto rows = umbra78::test::machine_table("| setting | default | range |");
    const Settings defaults;
    std::size_t k = 0;
    for (const Setting& s : settings_table()) {
        ASSERT_LT(k, rows.size()) << s.key << " is missing";
        const std::vector<std::string> row(rows[k].begin(), rows[k].begin() + 4);
        const std::vector<std::string> wanted{std::string(s.key), written(s, s.get(defaults)),
                                              range(s), std::string(s.unit)};
        EXPECT_EQ(row, wanted);
        ++k;
    }
    EXPECT_EQ(k, rows.size()) << "more settings than the program has";
}

}  // namespace
}  // namespace umbra78::shadow
