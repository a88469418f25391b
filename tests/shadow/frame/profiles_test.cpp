// Profiles: what each sets, against literal values, and that each is a machine that can be built.
#include "shadow/frame/profiles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

namespace umbra78::shadow {
namespace {

// What each profile sets, by key and word, beside the sources that shadow/frame/profiles.cpp gives.
// A key that only other profiles set gets its default; what no profile sets stays as it was.
TEST(Profiles, SetTheseValues) {
    using Values = std::map<std::string_view, std::int64_t>;
    const std::map<std::string_view, Values> expected{
        {"affine16",
         {{"coefficient_bits", 16},
          {"multipliers", 4},
          {"clock_ns", 200},
          {"dram_access_ns", 200},
          {"dram_cycle_ns", 375},
          {"dram_column_ns", 135},
          {"dram_page_ns", 225},
          {"dram_rows", 0},
          {"video", 1}}},
        {"affine16x1", {{"coefficient_bits", 16}, {"multipliers", 1}, {"clock_ns", 200}}},
        {"affine16x16",
         {{"coefficient_bits", 16},
          {"multipliers", 16},
          {"clock_ns", 200},
          {"divider", 1},
          {"light_banks", 4}}},
        {"perspective24",
         {{"coefficient_bits", 24}, {"multipliers", 4}, {"clock_ns", 200}, {"divider", 0}}},
        {"ap120b", {{"arithmetic", 1}, {"clock_ns", 167}, {"array_memory", 0}}},
        {"ap120b_fast", {{"arithmetic", 1}, {"clock_ns", 167}, {"array_memory", 1}}},
        {"d16_unorm", {{"xy_bits", 11}, {"z_bits", 16}, {"coefficient_bits", 24}}},
        {"d24", {{"xy_bits", 11}, {"z_bits", 24}, {"coefficient_bits", 24}}},
        {"d32f",
         {{"xy_bits", 11}, {"z_bits", 26}, {"depth_store", 1}, {"coefficient_bits", 24}}},
        {"d32f_reversed",
         {{"xy_bits", 11}, {"z_bits", 26}, {"depth_store", 2}, {"coefficient_bits", 24}}}};
    const auto kind_of = [](std::string_view name) { return find_profile(name)->kind; };
    EXPECT_EQ(profiles_of_1978().size(), 6u);
    EXPECT_EQ(profiles().size(), expected.size());
    for (const Profile& p : profiles()) {
        const auto found = expected.find(p.name);
        ASSERT_NE(found, expected.end()) << p.name;
        // From values that no profile gives, so that each has to be set.
        Settings s;
        s.machine.coefficient_bits = 20;
        s.machine.xy_bits = 8;
        s.machine.z_bits = 15;
        s.machine.multipliers = p.name == "affine16x16" ? 4 : 16;
        s.timing.clock_ns = 300;
        s.timing.divider = p.name == "affine16x16" ? hw::Divider::serial : hw::Divider::pipelined;
        s.timing.light_banks = 2;
        s.bias_q16 = 3 << 16;
        s.timing.dram = {300, 400, 150, 250, hw::DramRows::words, hw::Video::off};
        s.arithmetic = p.name.starts_with("ap120b") ? Arithmetic::fixed : Arithmetic::ap120b;
        s.array_memory = p.name == "ap120b" ? hw::ap120b::MemorySpeed::fast
                                            : hw::ap120b::MemorySpeed::standard;
        const Settings before = s;
        apply(p, s);
        for (const Setting& row : settings_table()) {
            const auto value = found->second.find(row.key);
            const bool of_another =
                std::any_of(expected.begin(), expected.end(),
                            [&](const auto& e) {
                                return kind_of(e.first) == p.kind && e.second.contains(row.key);
                            });
            EXPECT_EQ(of_another, is_set_by_profiles(row.key, p.kind)) << row.key;
            EXPECT_EQ(row.get(s), value != found->second.end() ? value->second
                                  : of_another                 ? row.get(Settings{})
                                                               : row.get(before))
                << p.name << " " << row.key;
        }
        EXPECT_EQ(p.values.size(), found->second.size()) << p.name;
    }
}

// Whatever profile of its kind was there before, nothing of it is left.
TEST(Profiles, ReplaceOneAnother) {
    for (const Profile& before : profiles())
        for (const Profile& p : profiles()) {
            if (before.kind != p.kind) continue;
            Settings alone, after;
            apply(p, alone);
            apply(before, after);
            apply(p, after);
            for (const Setting& row : settings_table())
                EXPECT_EQ(row.get(after), row.get(alone))
                    << p.name << " after " << before.name << ": " << row.key;
        }
}

TEST(Profiles, AreMachinesThatClose) {
    std::set<std::string_view> names;
    for (const Profile& p : profiles()) {
        EXPECT_TRUE(names.insert(p.name).second) << p.name;
        EXPECT_FALSE(p.meaning.empty()) << p.name;
        EXPECT_EQ(find_setting(p.name), nullptr) << p.name;
        Settings s;
        apply(p, s);
        EXPECT_TRUE(can_be_built(s)) << p.name;
        for (const ProfileValue& v : p.values) {
            const Setting* row = find_setting(v.key);
            ASSERT_NE(row, nullptr) << p.name << " " << v.key;
            EXPECT_GE(v.word, row->min) << p.name << " " << v.key;
            EXPECT_LE(v.word, row->max) << p.name << " " << v.key;
            EXPECT_FALSE(v.source.empty()) << p.name << " " << v.key;
        }
        EXPECT_EQ(find_profile(p.name), &p);
    }
    EXPECT_TRUE(names.contains("affine16") && names.contains("perspective24"));
}

}  // namespace
}  // namespace umbra78::shadow
