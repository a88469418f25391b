// A whole drawing once more, from the text of hw/MACHINE.md (sections 6 to 9 and 14), by
// exact_blocks.hpp and exact_drawing.hpp: every patch, no block left out as hidden.
#pragma once

#include "tests/raster/exact_drawing.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace umbra78::raster::test {

struct ExactFrame {
    std::vector<std::uint32_t> depth;
    std::vector<std::uint8_t> intensity, direct;
    DrawCounts counts;  // of patches, blocks, samples, unresolved, tested blocks and splits

    ExactFrame(std::span<const Patch> patches, const DrawSetup& setup) : setup_(setup) {
        const std::size_t pixels = std::size_t{1} << (2 * setup.spec.xy_bits);
        depth.assign(pixels, (1u << setup.spec.z_bits) - 1);
        intensity.assign(pixels, 0);
        direct.assign(pixels, 0);
        for (const Patch& p : patches) draw(p);
    }

private:
    struct Block {
        std::array<ExactComponent, 4> screen;  // x, y, z, or X, Y, Z, W
        std::array<ExactComponent, 3> world;
        int split_u, split_v;
    };

    std::size_t rows() const { return setup_.matrix.affine ? 3 : 4; }

    Block whole(const Patch& patch) const {
        const MatrixWords& m = setup_.matrix;
        const MachineSpec& spec = setup_.spec;
        const auto words = exact_object_words(patch, setup_.object.fraction);
        const int greatest = std::max({m.exponent[0], m.exponent[1], m.exponent[2], m.exponent[3]});
        Block b{};
        for (std::size_t r = 0; r < rows(); ++r) {
            const int out = r == 2 ? depth_out(spec) : 13;
            const int down =
                m.affine ? spec.coefficient_bits - 2 + setup_.object.fraction - out - m.exponent[r]
                         : greatest - m.exponent[r] - (44 - (16 + spec.coefficient_bits + 2));
            std::array<Int128, 16> control{};
            for (std::size_t k = 0; k < 16; ++k)
                control[k] = half_up_scaled(exact_sum(m, r, words[k]), down);
            b.screen[r] = exact_component(control);
        }
        for (std::size_t c = 0; c < 3; ++c) {
            std::array<Int128, 16> control{};
            for (std::size_t k = 0; k < 16; ++k) control[k] = words[k][c] * 64;
            b.world[c] = exact_component(control);
        }
        return b;
    }

    BlockAction action(const Block& b) const {
        ExactScreen bounds{};
        const BlockAction either =
            b.split_u <= b.split_v ? BlockAction::split_u : BlockAction::split_v;
        if (!setup_.matrix.affine) {
            const Visibility v = exact_projected(b.screen, setup_.spec, bounds);
            if (v == Visibility::outside) return BlockAction::outside;
            if (v == Visibility::unknown) return either;
        } else {
            for (std::size_t k = 0; k < 3; ++k) bounds[k] = exact_bounds(b.screen[k]);
        }
        const BlockAction a = exact_rule(bounds, setup_.spec);
        const bool splits = a == BlockAction::split_u || a == BlockAction::split_v;
        return splits && !setup_.matrix.affine && exact_says_nothing(bounds) ? either : a;
    }

    void draw(const Patch& patch) {
        ++counts.patches;
        std::vector<Block> left{whole(patch)};
        int splits = 0;
        while (!left.empty()) {
            const Block b = left.back();
            left.pop_back();
            ++counts.tested_blocks;
            BlockAction a = action(b);
            if (a == BlockAction::outside) continue;
            if (a == BlockAction::draw) {
                sample(b, patch);
                continue;
            }
            if (a == BlockAction::split_u && b.split_u == 24) a = BlockAction::split_v;
            if (a == BlockAction::split_v && b.split_v == 24) a = BlockAction::split_u;
            if ((b.split_u == 24 && b.split_v == 24) || splits == 1 << 20) {
                ++counts.unresolved;
                continue;
            }
            ++splits;
            ++counts.splits;
            const bool along_u = a == BlockAction::split_u;
            Block half[2] = {b, b};
            for (std::size_t r = 0; r < rows(); ++r) {
                const auto parts = exact_split(b.screen[r], along_u);
                for (std::size_t k = 0; k < 2; ++k) half[k].screen[r] = parts[k];
            }
            for (std::size_t c = 0; c < 3; ++c) {
                const auto parts = exact_split(b.world[c], along_u);
                for (std::size_t k = 0; k < 2; ++k) half[k].world[c] = parts[k];
            }
            for (Block& h : half) {
                ++(along_u ? h.split_u : h.split_v);
                left.push_back(h);  // the upper half is taken first
            }
        }
    }

    // Leaf corners by four splits in u everywhere, then four in v.
    static std::array<std::array<Int128, 17>, 17> grid(const ExactComponent& c) {
        std::vector<ExactComponent> parts{c};
        for (int level = 0; level < 8; ++level) {
            std::vector<ExactComponent> next;
            for (const ExactComponent& p : parts)
                for (const ExactComponent& h : exact_split(p, level < 4)) next.push_back(h);
            parts = next;
        }
        std::array<std::array<Int128, 17>, 17> g{};
        for (std::size_t n = 0; n < 256; ++n)
            for (std::size_t k = 0; k < 4; ++k) g[n % 16 + k / 2][n / 16 + k % 2] = parts[n].f[k];
        return g;
    }

    // False if a corner has no quotient of 31 bits.
    bool corners_of(const Block& b, ExactCorners& out) const {
        std::array<std::array<std::array<Int128, 17>, 17>, 4> g{};
        for (std::size_t r = 0; r < rows(); ++r) g[r] = grid(b.screen[r]);
        for (std::size_t j = 0; j < 17; ++j) {
            for (std::size_t i = 0; i < 17; ++i) {
                for (std::size_t k = 0; k < 3; ++k) {
                    Int128& q = out[j][i][k] = g[k][j][i];
                    if (setup_.matrix.affine) continue;
                    const Int128 w = g[3][j][i];
                    if (w <= 0) return false;
                    const int up = k == 2 ? depth_out(setup_.spec) : 13;
                    q = up >= 0 ? half_up_of(q * power(up), w) : half_up_of(q, w * power(-up));
                    if (q < -power(30) || q >= power(30)) return false;
                }
            }
        }
        return true;
    }

    void sample(const Block& b, const Patch& patch) {
        ExactCorners g{};
        if (!corners_of(b, g)) {
            ++counts.unresolved;
            return;
        }
        ++counts.blocks;
        const ExactShading shading(b.world, setup_.shading, setup_.materials[patch.material]);
        exact_samples(g, setup_.spec, setup_.sampling, [&](const ExactSample& s) {
            const auto code = exact_code(s.z, setup_.spec);
            if (!code) return;
            ++counts.samples;
            const auto a = (static_cast<std::size_t>(s.py) << setup_.spec.xy_bits) +
                           static_cast<std::size_t>(s.px);
            if (*code > depth[a]) return;
            const Shade shade = shading.shade(s.i, s.j, false);
            if (*code == depth[a] && shade >= Shade{intensity[a], {direct[a]}}) return;
            depth[a] = *code;
            intensity[a] = shade.intensity;
            direct[a] = shade.direct[0];
        });
    }

    const DrawSetup& setup_;
};

}  // namespace umbra78::raster::test
