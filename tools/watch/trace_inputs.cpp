// The words that enter the post-process: the matrix, the noise's bytes, the pixel's words.
#include "tools/watch/trace_units.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace umbra78::tools {
namespace {

std::string column_name(std::size_t column) {
    constexpr const char* names[] = {"x", "y", "z", "one"};
    return names[column];
}

// Traces the k bytes of one dither word, each with the cycle in which its last bit was drawn, and
// returns the word.
std::int32_t trace_dither_word(TraceLog& log, const TracedPoint& p, fixed::NoiseRegister& noise,
                               bool second, const std::vector<std::uint64_t>& read) {
    const int k = hw::uniforms(p.settings.dither.shape);
    const char* axis = second ? "Y" : "X";
    int sum = 0;
    for (int i = 0; i < k; ++i) {
        const int last_bit = 8 * (i + (second ? k : 0)) + 7;
        const auto in = static_cast<std::size_t>(last_bit / p.settings.timing.noise_bits);
        log.at("noise", read.at(in));
        const auto byte = static_cast<std::int64_t>(noise.take(8));
        log.word(fmt::format("byte_{}{}", axis, i), unsigned_word(byte, 8));
        sum += static_cast<int>(byte);
    }
    const auto amplitude =
        fixed::dither_amplitude(k, p.settings.dither.size_q8, p.spec().fraction_bits);
    const std::int32_t word = fixed::dither_word(sum, k, amplitude);
    log.at("noise", read.back());
    log.word(fmt::format("sum_{}", axis), unsigned_word(sum, 12), fmt::format("{} bytes", k));
    log.word(fmt::format("dither_{}", axis),
             signed_word(word, p.spec().fraction_bits + 1, p.spec().fraction_bits),
             fmt::format("half_up((2 sum - {}) {} / 2^16), in texels", 255 * k, amplitude));
    return word;
}

}  // namespace

void trace_matrix(TraceLog& log, const shadow::Settings& s, const hw::MatrixWords& m) {
    const int bits = s.machine.coefficient_bits;
    log.at("matrix");
    for (std::size_t r = 0; r < (m.affine ? 3u : 4u); ++r) {
        for (std::size_t c = 0; c < 4; ++c)
            log.word(fmt::format("c_{}{}", row_names[r], c),
                     signed_word(m.word[r][c], bits, bits - 2), "times " + column_name(c));
        log.word(fmt::format("e_{}", row_names[r]), signed_word(m.exponent[r], 6),
                 fmt::format("row {} counts 2^{}", row_names[r], m.exponent[r]));
    }
    if (m.affine) log.say("row W is (0, 0, 0, 1): affine, nothing is divided");
}

void trace_noise(TraceLog& log, const TracedPoint& p, const std::vector<std::uint64_t>& read,
                 std::uint64_t released) {
    if (!p.plan.dithers) {
        log.at("noise", released);
        log.say("no dither: X and Y are looked up unchanged");
        return;
    }
    const int k = hw::uniforms(p.settings.dither.shape);
    const auto pixel = (static_cast<std::uint64_t>(p.flight.py) << p.spec().xy_bits) +
                       static_cast<std::uint64_t>(p.flight.px);
    fixed::NoiseRegister noise(p.settings.dither.seed);
    noise.jump(pixel * 16 * static_cast<std::uint64_t>(k));
    log.at("noise", read.front());
    log.word("register", unsigned_word(noise.state(), 31),
             fmt::format("{} bits a pixel into the stream", 16 * k));
    const std::int32_t x = trace_dither_word(log, p, noise, false, read);
    const std::int32_t y = trace_dither_word(log, p, noise, true, read);
    if (x != p.flight.dither.x || y != p.flight.dither.y)
        throw std::logic_error("the clocked noise source and its stream disagree");
}

void trace_words(TraceLog& log, const TracedPoint& p, std::uint64_t released) {
    const hw::MachineSpec& m = p.spec();
    const int bits = m.word_bits(), fraction = m.input_fraction();
    const hw::Words& w = p.flight.transform.words;
    const bool centre = p.settings.registration == shadow::Registration::centre;
    const auto how = [&](const char* axis, int at) {
        return fmt::format("(2 ({} - {}){}) 2^{}: {} is {}", axis, m.half_px(),
                           centre ? " + 1" : "", fraction - 1, axis, at);
    };
    log.at("words", released);
    log.word("x", signed_word(w.x, bits, fraction), how("px", p.flight.px));
    log.word("y", signed_word(w.y, bits, fraction), how("py", p.flight.py));
    log.word("z", signed_word(w.z, bits, fraction),
             fmt::format("(code - {}) 2^{}", m.depth_offset(), fraction - m.depth_fraction()));
    log.word("one", signed_word(m.one_word(), bits, fraction), "the constant, 2^(W-2)");
    if (!p.matrix().affine) return;
    for (std::size_t r = 0; r < 3; ++r)
        log.word(fmt::format("acc_{}", row_names[r]),
                 signed_word(p.flight.transform.accumulator[r], m.accumulator_bits(),
                             m.coefficient_bits - 2 + fraction - p.matrix().exponent[r]),
                 fmt::format("starts from c_{}3 one{}", row_names[r],
                             m.dropped_bits() == 0
                                 ? ""
                                 : fmt::format(", without its low {} bits", m.dropped_bits())));
}

}  // namespace umbra78::tools
