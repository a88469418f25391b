// Writes the constants of the headers that the proofs are about to a file, lines "name value".
#include "hw/machine_spec.hpp"
#include "raster/arc.hpp"
#include "raster/draw_setup.hpp"
#include "raster/facet.hpp"
#include "raster/leaf_grid.hpp"
#include "raster/sampling.hpp"
#include "raster/triangle.hpp"
#include "shadow/rivals/light_lines.hpp"
#include "shadow/rivals/planes.hpp"

#include <cstdint>
#include <cstdio>

namespace {

using umbra78::hw::MachineSpec;

// The least and the greatest value of a width that check() accepts, the others being the default.
void range(const char* name, int MachineSpec::*width) {
    int least = 1000, greatest = -1000;
    for (int v = -100; v <= 100; ++v) {
        MachineSpec m;
        m.*width = v;
        if (check(m) != umbra78::hw::SpecStatus::ok) continue;
        least = v < least ? v : least;
        greatest = v;
    }
    std::printf("least_%s %d\ngreatest_%s %d\n", name, least, name, greatest);
}

void fact(const char* name, std::int64_t value) {
    std::printf("%s %lld\n", name, static_cast<long long>(value));
}

// The greatest component of an arc's control points, Q2.30.
std::int64_t arc_reach() {
    std::int64_t reach = 0;
    for (int k = 0; k < 8; ++k)
        for (int i = 0; i < 4; ++i) {
            const umbra78::fixed::SineCosine p = umbra78::raster::arc_point(k, i);
            for (const std::int64_t v : {p.sine, p.cosine}) {
                const std::int64_t size = v < 0 ? -v : v;
                reach = size > reach ? size : reach;
            }
        }
    return reach;
}

}  // namespace

int main(int, char** words) {
    using namespace umbra78;
    if (words[1] == nullptr || std::freopen(words[1], "w", stdout) == nullptr) return 1;
    range("xy_bits", &MachineSpec::xy_bits);
    range("z_bits", &MachineSpec::z_bits);
    range("coefficient_bits", &MachineSpec::coefficient_bits);
    range("fraction_bits", &MachineSpec::fraction_bits);
    range("max_accumulator_bits", &MachineSpec::max_accumulator_bits);
    fact("min_exponent", hw::min_exponent);
    fact("max_exponent", hw::max_exponent);
    fact("max_apart", hw::max_apart);
    fact("raster_fraction", raster::raster_fraction);
    fact("pixel_units", raster::pixel_units);
    fact("max_bend", raster::max_bend);
    fact("max_slope", raster::max_slope);
    fact("unbounded", raster::unbounded);
    fact("max_growth", raster::max_growth);
    fact("slack", raster::slack);
    fact("max_triangle", raster::max_triangle);
    fact("max_screen", raster::max_screen);
    fact("guard_px", raster::guard_px);
    fact("max_corner_error", raster::max_corner_error);
    fact("deepest_level", raster::deepest_level);
    fact("leaf_levels", raster::leaf_levels);
    fact("max_world", raster::max_world);
    fact("arc_reach", arc_reach());
    fact("word_bits", shadow::rivals::word_bits);
    fact("max_word", shadow::rivals::max_word);
    fact("leading_bits", shadow::rivals::leading_bits);
    fact("normal_bits", shadow::rivals::normal_bits);
    fact("offset_bits", shadow::rivals::offset_bits);
    fact("line_bits", shadow::rivals::line_bits);
    fact("value_bits", shadow::rivals::value_bits);
}
