#include "shadow/frame/profiles.hpp"

#include "fixed/trap.hpp"

#include <array>

namespace umbra78::shadow {
namespace {

using enum Confidence;
using enum ProfileKind;

// A setting's word from its enumerator.
template <class Enum>
constexpr std::int64_t word(Enum value) {
    return static_cast<std::int64_t>(value);
}

constexpr std::string_view chip =
    "TRW MPY-16/TDC1010J class 16 x 16 multiplier(-accumulator), sold from 1976: 155 to 165 ns "
    "from memory, not from a data sheet";
constexpr std::string_view grade =
    "the 200 ns grade (-3) of Mostek's MK4116 16K x 1 RAM, as later texts give it";
constexpr std::string_view page_mode = "the same grade's page mode, from memory, not a data sheet";
constexpr std::string_view ours = "this project's choice";

constexpr std::array affine16{
    ProfileValue{"coefficient_bits", 16, published, "the chips' word; Sutherland 1968 too"},
    ProfileValue{"multipliers", 4, assumed, "a row a clock, as in Evans & Sutherland's units"},
    ProfileValue{"clock_ns", 200, assumed, chip},
    ProfileValue{"dram_access_ns", 200, published, grade},
    ProfileValue{"dram_cycle_ns", 375, published, grade},
    ProfileValue{"dram_column_ns", 135, assumed, page_mode},
    ProfileValue{"dram_page_ns", 225, assumed, page_mode},
    ProfileValue{"dram_rows", word(hw::DramRows::lines), assumed,
                 "a page of four scan lines; a counter refreshes"},
    ProfileValue{"video", word(hw::Video::observer), assumed,
                 "the observer's buffer is on a monitor, the light's is not"},
};
constexpr std::array affine16x1{
    ProfileValue{"coefficient_bits", 16, published, "the chips' word; Sutherland 1968 too"},
    ProfileValue{"multipliers", 1, assumed, "one multiplier-accumulator chip, a product a clock"},
    ProfileValue{"clock_ns", 200, assumed, chip},
};
constexpr std::array affine16x16{
    ProfileValue{"coefficient_bits", 16, published, "the chips' word; Sutherland 1968 too"},
    ProfileValue{"multipliers", 16, assumed, "the whole matrix: a point a clock"},
    ProfileValue{"clock_ns", 200, assumed, chip},
    ProfileValue{"divider", word(hw::Divider::pipelined), assumed,
                 "three in stages keep up with a point a clock"},
    ProfileValue{"light_banks", 4, assumed, "2 x 2 interleaved: bilinear lookup in a clock"},
};
constexpr std::array perspective24{
    ProfileValue{"coefficient_bits", 24, assumed,
                 "two passes of a 16 x 16 multiplier; 16 bits leave 2 px of error at far/near 100"},
    ProfileValue{"multipliers", 4, assumed, ours},
    ProfileValue{"clock_ns", 200, assumed, chip},
    ProfileValue{"divider", word(hw::Divider::serial), published,
                 "a bit a clock, as in the clipping divider of Sproull & Sutherland 1968"},
};

constexpr std::string_view fps =
    "Williams 1978 names it; Floating Point Systems, AP Math Library Manual 860-7288-004, 1979";
constexpr std::string_view fps_clock =
    "the same; the other units are taken at the same clock";
constexpr std::array ap120b{
    ProfileValue{"arithmetic", word(Arithmetic::ap120b), published, fps},
    ProfileValue{"clock_ns", hw::ap120b::clock_ns, published, fps_clock},
    ProfileValue{"array_memory", word(hw::ap120b::MemorySpeed::standard), assumed, ours},
};
constexpr std::array ap120b_fast{
    ProfileValue{"arithmetic", word(Arithmetic::ap120b), published, fps},
    ProfileValue{"clock_ns", hw::ap120b::clock_ns, published, fps_clock},
    ProfileValue{"array_memory", word(hw::ap120b::MemorySpeed::fast), published, fps},
};

// Today's maps are those of engines' first settings: 2048 texels a side.
constexpr std::string_view side = "2048 texels a side, a usual size of an engine's map";
constexpr std::string_view single =
    "IEEE 754 binary32: 24 significant bits, in which today's matrices are computed";
constexpr std::string_view unorm = "D16_UNORM of Direct3D, Vulkan, Metal and WebGPU";
constexpr std::string_view unorm24 = "D24_UNORM of Direct3D and Vulkan, without its stencil";
constexpr std::string_view binary32 = "D32_FLOAT of Direct3D, Vulkan, Metal and WebGPU";
constexpr std::string_view spare = "the most there is: what a float has beyond 24 bits shows";
constexpr std::array d16_unorm{
    ProfileValue{"xy_bits", 11, assumed, side},
    ProfileValue{"z_bits", 16, published, unorm},
    ProfileValue{"coefficient_bits", 24, published, single},
};
constexpr std::array d24{
    ProfileValue{"xy_bits", 11, assumed, side},
    ProfileValue{"z_bits", 24, published, unorm24},
    ProfileValue{"coefficient_bits", 24, published, single},
};
constexpr std::array d32f{
    ProfileValue{"xy_bits", 11, assumed, side},
    ProfileValue{"z_bits", 26, assumed, spare},
    ProfileValue{"depth_store", word(hw::DepthStore::of_floats), published, binary32},
    ProfileValue{"coefficient_bits", 24, published, single},
};
constexpr std::array d32f_reversed{
    ProfileValue{"xy_bits", 11, assumed, side},
    ProfileValue{"z_bits", 26, assumed, spare},
    ProfileValue{"depth_store", word(hw::DepthStore::of_reversed_floats), published, binary32},
    ProfileValue{"coefficient_bits", 24, published, single},
};

constexpr std::size_t of_1978 = 6;
constexpr std::array<Profile, 10> all_profiles{{
    {machine_of_1978, "affine16", "16-bit coefficients, one row a clock: four multipliers",
     affine16},
    {machine_of_1978, "affine16x1", "16-bit coefficients, one multiplier-accumulator", affine16x1},
    {machine_of_1978, "affine16x16", "16-bit coefficients, sixteen multipliers", affine16x16},
    {machine_of_1978, "perspective24", "24-bit coefficients in two passes, for perspective views",
     perspective24},
    {machine_of_1978, "ap120b", "the shadow on an FPS AP-120B with standard memory", ap120b},
    {machine_of_1978, "ap120b_fast", "the shadow on an FPS AP-120B with fast memory", ap120b_fast},
    {map_of_today, "d16_unorm", "today's map of 2048 x 2048 texels with 16-bit integers",
     d16_unorm},
    {map_of_today, "d24", "the same with 24-bit integers", d24},
    {map_of_today, "d32f", "the same with 32-bit floats", d32f},
    {map_of_today, "d32f_reversed", "the same with 32-bit floats of one minus the depth",
     d32f_reversed},
}};

}  // namespace

std::span<const Profile> profiles() { return all_profiles; }
std::span<const Profile> profiles_of_1978() { return std::span(all_profiles).first(of_1978); }

const Profile* find_profile(std::string_view name) {
    for (const Profile& p : all_profiles)
        if (p.name == name) return &p;
    return nullptr;
}

bool is_set_by_profiles(std::string_view key, ProfileKind kind) {
    for (const Profile& p : all_profiles)
        for (const ProfileValue& v : p.values)
            if (p.kind == kind && v.key == key) return true;
    return false;
}

void apply(const Profile& profile, Settings& settings) {
    const Settings defaults;
    for (const Setting& setting : settings_table())
        if (is_set_by_profiles(setting.key, profile.kind))
            setting.set(settings, setting.get(defaults));
    for (const ProfileValue& v : profile.values) {
        const Setting* setting = find_setting(v.key);
        fixed::require(setting != nullptr, "profile: no such setting");
        setting->set(settings, v.word);
    }
}

}  // namespace umbra78::shadow
