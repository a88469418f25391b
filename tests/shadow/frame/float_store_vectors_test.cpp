// Vectors of the depth store of floats: the code that is kept, and its float's bits by the host.
#include "hw/machine_spec.hpp"
#include "tests/shadow/frame/vectors.hpp"

#include <bit>
#include <cmath>

namespace umbra78::test {
namespace {

TEST(Vectors, FloatStore) {
    Inputs in(28);
    Lines lines;
    for (int k = 0; k < 64; ++k) {
        const bool reversed = k % 2 == 1;
        hw::MachineSpec m;
        m.z_bits = k % 8 == 0 ? static_cast<int>(in.between(4, 25)) : 26;
        m.depth_store =
            reversed ? hw::DepthStore::of_reversed_floats : hw::DepthStore::of_floats;
        const std::int64_t last = m.deepest_drawn();
        const std::int64_t code = k < 4    ? (k < 2 ? 0 : last)
                                  : k % 3  ? in.between(0, last)
                                           : last - in.between(0, 40 << (k % 5));
        const auto drawn = static_cast<std::uint32_t>(code < 0 ? 0 : code);
        const std::uint32_t kept = m.kept(drawn);
        const std::uint32_t v = reversed ? (std::uint32_t{1} << m.z_bits) - kept : kept;
        const float depth = std::ldexp(static_cast<float>(v), -m.z_bits);
        lines.push_back((Line() << m.z_bits << (reversed ? "float_reversed" : "float") << drawn
                                << "->" << kept << std::bit_cast<std::uint32_t>(depth))
                            .text());
    }
    check_vectors("float_store",
                  {"Section 28.", "z_bits, depth_store, a drawn code -> the kept code, float_bits"},
                  lines);
}

}  // namespace
}  // namespace umbra78::test
