// The noise source, clocked: in each cycle the register gives `noise_bits` bits to the pixel that
// is being read.
//
// A pixel owns 16 k bits of the stream, visible or not. Where the register gives fewer in a cycle,
// the reader stays at the pixel for cycles_per_pixel cycles.
// In: the settings of the dither and of the timing. Out: words of hw/noise_source.hpp, bit for bit;
// tests hold them equal.
#pragma once

#include "hw/clocked/timing.hpp"
#include "hw/noise_source.hpp"

#include <array>
#include <cstdint>

namespace umbra78::hw {

class ClockedNoise {
public:
    ClockedNoise(const Dither& dither, const MachineSpec& spec, const Timing& timing)
        : k_(uniforms(dither.shape)), bits_a_pixel_(16 * k_), bits_a_cycle_(timing.noise_bits),
          amplitude_(k_ == 0 ? 0 : fixed::dither_amplitude(k_, dither.size_q8, spec.fraction_bits)),
          register_(dither.seed) {}

    static constexpr int cycles_per_pixel(const Dither& dither, const Timing& timing) {
        const int bits = 16 * uniforms(dither.shape);
        const int cycles = (bits + timing.noise_bits - 1) / timing.noise_bits;
        return cycles < 1 ? 1 : cycles;
    }

    // Cycle c of a pixel; after the last one words() are the pixel's.
    void step(int cycle) {
        if (cycle == 0) drawn_ = 0;
        int left = bits_a_pixel_ - drawn_;
        left = left < bits_a_cycle_ ? left : bits_a_cycle_;
        while (left > 0) {
            // As many as fit the word that is being filled.
            const int room = 64 - drawn_ % 64, n = left < room ? left : room;
            std::uint64_t& word = bits_[static_cast<std::size_t>(drawn_ / 64)];
            const std::uint64_t fresh = register_.take(n);
            word = drawn_ % 64 == 0 ? fresh : word | fresh << drawn_ % 64;
            drawn_ += n;
            left -= n;
        }
    }

    DitherWords words() const {
        const int x = sum(0), y = sum(k_);
        return {fixed::dither_word(x, k_, amplitude_), fixed::dither_word(y, k_, amplitude_)};
    }
    std::uint32_t state() const { return register_.state(); }

private:
    // k bytes from byte `first` on; 12 of them lie across two words.
    int sum(int first) const {
        int total = 0;
        for (int byte = first; byte < first + k_;) {
            const int in_word = byte % 8, room = 8 - in_word;
            const int n = first + k_ - byte < room ? first + k_ - byte : room;
            const std::uint64_t word = bits_[static_cast<std::size_t>(byte / 8)];
            total += fixed::sum_of_uniforms(word >> (8 * in_word), n);
            byte += n;
        }
        return total;
    }

    int k_, bits_a_pixel_, bits_a_cycle_, drawn_ = 0;
    std::int32_t amplitude_;
    fixed::NoiseRegister register_;
    std::array<std::uint64_t, 3> bits_{};
};

}  // namespace umbra78::hw
