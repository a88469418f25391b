#include "tools/benchmarks/float_baseline.hpp"

#include <cstddef>

namespace umbra78::tools {
namespace {

template <bool Affine>
void run(std::span<const std::uint16_t> observer, std::span<const std::uint16_t> light, int size,
         const FloatMatrix& matrix, std::span<std::uint8_t> mask) {
    const auto& m = matrix.m;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const auto i = static_cast<std::size_t>(y * size + x);
            mask[i] = 0;
            if (observer[i] == 65535) continue;
            const float px = static_cast<float>(x) + 0.5f, py = static_cast<float>(y) + 0.5f;
            const float pz = observer[i];
            float lx = m[0][0] * px + m[0][1] * py + m[0][2] * pz + m[0][3];
            float ly = m[1][0] * px + m[1][1] * py + m[1][2] * pz + m[1][3];
            float lz = m[2][0] * px + m[2][1] * py + m[2][2] * pz + m[2][3];
            if constexpr (!Affine) {
                const float over =
                    1.0f / (m[3][0] * px + m[3][1] * py + m[3][2] * pz + m[3][3]);
                lx *= over;
                ly *= over;
                lz *= over;
            }
            const int tx = static_cast<int>(lx), ty = static_cast<int>(ly);
            if (lx < 0 || ly < 0 || tx >= size || ty >= size) continue;
            if (lz > light[static_cast<std::size_t>(ty * size + tx)]) mask[i] = 255;
        }
    }
}

}  // namespace

void float_post_process(std::span<const std::uint16_t> observer,
                        std::span<const std::uint16_t> light, int size, const FloatMatrix& matrix,
                        bool affine, std::span<std::uint8_t> mask) {
    affine ? run<true>(observer, light, size, matrix, mask)
           : run<false>(observer, light, size, matrix, mask);
}

}  // namespace umbra78::tools
