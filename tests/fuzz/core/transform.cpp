// Fuzz target: machine specifications and the transform unit. A specification that passes its check
// has formats that fit; the unit, the clocked unit, the certificate of each quotient and the
// implementation in C agree.
#include "hw/clocked/divider.hpp"
#include "hw/clocked/transform.hpp"
#include "tests/fuzz/core/oracle.hpp"

namespace umbra78::fuzz {
namespace {

using hw::MachineSpec;

void check_formats(const MachineSpec& m, const oracle::Settings& s, Bytes& bytes) {
    const auto code = static_cast<std::uint32_t>(bytes.in(0, std::int64_t{m.deepest_drawn()}));
    demand(m.kept(code) == oracle::kept_code(code, &s), "the store keeps section 28's codes");

    demand(m.word_bits() <= 32 && m.built_bits() <= 64, "a format of the specification");
    demand(m.size_px() == s.size_px && m.word_bits() == s.word_bits &&
               m.one_word() == s.one_word && m.dropped_bits() == s.dropped_bits &&
               m.background() == s.background_code && m.depth_offset() == s.depth_offset &&
               m.input_fraction() == s.input_fraction,
           "the formats of the specification are those of section 2");
}

hw::MatrixWords any_matrix(Bytes& bytes, const MachineSpec& m) {
    hw::MatrixWords matrix;
    matrix.affine = bytes.number(0, 1) != 0;
    const int middle = bytes.number(-10, 10);
    for (std::size_t r = 0; r < 4; ++r) {
        for (std::int32_t& word : matrix.word[r]) word = bytes.word(m.coefficient_bits);
        matrix.exponent[r] = middle + bytes.number(-21, 21);
    }
    return matrix;
}

// An affine row whose result does not fit 64 bits has no meaning.
bool has_results(const hw::MatrixWords& matrix, const MachineSpec& m) {
    for (std::size_t r = 0; r < 3 && matrix.affine; ++r) {
        const int out = r < 2 ? m.fraction_bits : m.depth_fraction();
        const int shift = hw::affine_shift(matrix, static_cast<hw::Row>(r), m,
                                           hw::screen_words(m), out);
        if (m.accumulator_bits() - shift > 62) return false;
    }
    return true;
}

void check_clocked(const MachineSpec& m, const hw::MatrixWords& matrix, const hw::Words& v,
                   const hw::Point& point, Bytes& bytes) {
    hw::Timing timing;
    timing.clock_ns = bytes.number(100, 300);
    timing.multiply_ns = bytes.number(1, 400);
    timing.add_ns = bytes.number(1, 150);
    timing.register_ns = bytes.number(0, 40);
    timing.divider = static_cast<hw::Divider>(bytes.number(0, 1));
    if (hw::check(timing) != hw::TimingStatus::ok) return;
    const hw::TransformPipeline plan(m, timing, matrix);
    hw::TransformRegisters registers;
    registers.load(plan, v);
    for (int step = 0; step < plan.latency(); ++step) registers.step(plan, step);
    for (int r = 0; r < plan.rows() && !plan.rounds(); ++r)
        demand(registers.accumulator[static_cast<std::size_t>(r)] ==
                   hw::accumulate(matrix, static_cast<hw::Row>(r), v, m.one_word(),
                                  hw::product_cut(m)),
               "a clocked sum is the unit's");
    if (matrix.affine)
        demand(registers.result[0] == point.x && registers.result[1] == point.y &&
                   registers.result[2] == point.z,
               "the clocked results are the unit's");
}

void check_certificates(const MachineSpec& m, const hw::MatrixWords& matrix,
                        const hw::TransformUnit& unit, const hw::Words& v,
                        const hw::Point& point) {
    const auto sum = [&](hw::Row row) { return unit.sum(row, v); };
    const std::int64_t results[] = {point.x, point.y, point.z};
    const int fractions[] = {m.fraction_bits, m.fraction_bits, m.depth_fraction()};
    for (int r = 0; r < 3; ++r) {
        const auto row = static_cast<hw::Row>(r);
        demand(fixed::certificate_holds(sum(row), sum(hw::Row::w),
                                        hw::divide_shift(matrix, row, fractions[r]), results[r]),
               "a quotient has its certificate");
    }
}

void run(Bytes& bytes) {
    const MachineSpec m = any_spec(bytes);
    if (hw::check(m) != hw::SpecStatus::ok) return;
    const oracle::Settings s = settings_of(m);
    check_formats(m, s, bytes);
    const hw::MatrixWords matrix = any_matrix(bytes, m);
    if (!has_results(matrix, m)) return;
    const hw::Words v{bytes.word(m.word_bits()), bytes.word(m.word_bits()),
                      bytes.word(m.word_bits())};
    const hw::TransformUnit unit(m, matrix);
    const hw::Point point = unit(v);
    oracle::Loaded loaded{};
    loaded.affine = matrix.affine;
    loaded.fraction = m.input_fraction();
    loaded.one = m.one_word();
    for (std::size_t r = 0; r < 4; ++r) {
        loaded.e[r] = matrix.exponent[r];
        for (std::size_t j = 0; j < 4; ++j) loaded.c[r][j] = matrix.word[r][j];
    }
    const oracle::i64 words[3] = {v.x, v.y, v.z};
    oracle::i64 out[3] = {};
    const oracle::Status status = oracle::transform(&loaded, &s, words, out);
    demand(static_cast<int>(status) == static_cast<int>(point.status),
           "the unit's status is section 5's");
    if (status == oracle::OK)
        demand(point.x == out[0] && point.y == out[1] && point.z == out[2],
               "the unit's results are section 5's");
    const bool nearest = m.transform_rounding >= hw::Rounding::half_up;
    if (status == oracle::OK && matrix.divides() && nearest &&
        m.divide_order == hw::DivideOrder::exact)
        check_certificates(m, matrix, unit, v, point);
    check_clocked(m, matrix, v, point, bytes);
}

}  // namespace
}  // namespace umbra78::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    umbra78::fuzz::Bytes bytes(data, size);
    umbra78::fuzz::run(bytes);
    return 0;
}
