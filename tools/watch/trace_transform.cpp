// The transform unit's words: products, sums, accumulators, rounded rows.
#include "tools/watch/trace_units.hpp"

#include "shadow/frame/settings.hpp"

#include <fmt/format.h>

#include <numeric>

namespace umbra78::tools {
namespace {

std::string rounding_name(hw::Rounding r) {
    const shadow::Setting* setting = shadow::find_setting("transform_rounding");
    return std::string(setting->names[static_cast<std::size_t>(r)]);
}

// Fraction bits of a row's products, sums and accumulator, with the row's exponent.
int row_fraction(const TracedPoint& p, std::size_t row) {
    const hw::MachineSpec& m = p.spec();
    return m.coefficient_bits - 2 + m.input_fraction() - p.matrix().exponent[row];
}

MachineWord row_word(const TracedPoint& p, std::size_t row, std::int64_t value) {
    return signed_word(value, p.spec().accumulator_bits(), row_fraction(p, row));
}

// The rows, and their columns, that are multiplied in multiply cycle `turn`.
struct Turn {
    std::size_t first_row, rows, first_column, columns;
    int pass;
};
Turn turn_of(const hw::TransformPipeline& t, int turn) {
    const auto columns = static_cast<std::size_t>(t.columns());
    const auto index = static_cast<std::size_t>(turn / t.passes());
    const int pass = turn % t.passes();
    switch (t.spec().multipliers) {
        case 16: return {0, static_cast<std::size_t>(t.rows()), 0, columns, pass};
        case 4: return {index, 1, 0, columns, pass};
        default: return {index / columns, 1, index % columns, 1, pass};
    }
}

// Products that are cut are put together from their passes and added with the last pass.
bool adds(const hw::TransformPipeline& t, int pass) {
    return t.spec().dropped_bits() == 0 || pass + 1 == t.passes();
}

std::string cut_name(const hw::TransformPipeline& t) {
    return fmt::format("without the low {} bits of a product", t.spec().dropped_bits());
}

// Which halves of coefficient and word a pass takes.
std::string pass_name(const hw::TransformPipeline& t, int pass) {
    if (t.passes() == 1) return t.spec().dropped_bits() == 0 ? "" : cut_name(t);
    const bool both = t.coefficient_cut() > 0 && t.word_cut() > 0;
    const auto half = [](int cut, int number, const char* of) {
        return cut == 0 ? std::string(of)
                        : fmt::format("{} half of {}", (number & 1) != 0 ? "high" : "low", of);
    };
    return fmt::format("pass {} of {}: {} times {}", pass + 1, t.passes(),
                       half(t.coefficient_cut(), pass, "c"),
                       half(t.word_cut(), both ? pass >> 1 : pass, "the word"));
}

// Whether a row's last product is accumulated with this multiply cycle's products.
bool row_ends(const hw::TransformPipeline& t, int turn) {
    const int each = t.spec().multipliers == 1    ? t.columns() * t.passes()
                     : t.spec().multipliers == 4 ? t.passes()
                                                 : t.cycles();
    return (turn + 1) % each == 0;
}

}  // namespace

void TransformTrace::products(TraceLog& log, const TracedPoint& p, int turn) {
    constexpr const char* column_names[] = {"x", "y", "z", "one"};
    const hw::MachineSpec& m = p.spec();
    const Turn now = turn_of(p.plan.transform, turn);
    const std::string how = pass_name(p.plan.transform, now.pass);
    std::array<std::int64_t, 4> sums{};
    for (std::size_t r = now.first_row; r < now.first_row + now.rows; ++r) {
        const auto& product = p.flight.transform.product[r];
        for (std::size_t c = now.first_column; c < now.first_column + now.columns; ++c) {
            log.word(fmt::format("c_{}{} {}", row_names[r], c, column_names[c]),
                     signed_word(product[c], m.word_bits() + m.coefficient_bits,
                                 row_fraction(p, r)),
                     how);
            if (adds(p.plan.transform, now.pass)) sums[r] += product[c];
        }
    }
    sums_.push_back(sums);
}

void TransformTrace::sums(TraceLog& log, const TracedPoint& p, int turn) const {
    const Turn then = turn_of(p.plan.transform, turn);
    for (std::size_t r = then.first_row; r < then.first_row + then.rows; ++r)
        log.word(fmt::format("sum_{}", row_names[r]),
                 row_word(p, r, sums_[static_cast<std::size_t>(turn)][r]), "of the products");
}

void TransformTrace::accumulators(TraceLog& log, const TracedPoint& p, int turn) const {
    const Turn then = turn_of(p.plan.transform, turn);
    for (std::size_t r = then.first_row; r < then.first_row + then.rows; ++r)
        log.word(fmt::format("acc_{}", row_names[r]),
                 row_word(p, r, p.flight.transform.accumulator[r]),
                 p.spec().dropped_bits() == 0 ? "exact" : cut_name(p.plan.transform));
}

void TransformTrace::results(TraceLog& log, const TracedPoint& p, int turn) const {
    const hw::MachineSpec& m = p.spec();
    const Turn then = turn_of(p.plan.transform, turn);
    for (std::size_t r = then.first_row; r < then.first_row + then.rows; ++r) {
        const int row = static_cast<int>(r), shift = p.plan.transform.round_shift(row);
        const int out = !p.matrix().affine ? row_fraction(p, r) - shift
                        : r == 2           ? m.depth_fraction()
                                           : m.fraction_bits;
        log.word(fmt::format("R_{}", row_names[r]),
                 signed_word(p.flight.transform.result[r], p.plan.transform.result_bits(row), out),
                 fmt::format("{}(acc_{} / 2^{})", rounding_name(m.transform_rounding),
                             row_names[r], shift));
    }
}

void TransformTrace::step(TraceLog& log, const TracedPoint& p, int step, std::uint64_t cycle) {
    const hw::TransformPipeline& t = p.plan.transform;
    const auto inside = [&](int turn) { return turn >= 0 && turn < t.cycles(); };
    if (step < t.cycles()) {
        log.at("multiply", cycle);
        products(log, p, step);
    }
    if (const int turn = step - t.sum_step(0); t.sums() && inside(turn)) {
        log.at("sum", cycle);
        sums(log, p, turn);
    }
    if (const int turn = step - t.accumulate_step(0); inside(turn)) {
        log.at("accumulate", cycle);
        accumulators(log, p, turn);
    }
    if (const int turn = step - t.round_step(0); t.rounds() && inside(turn) && row_ends(t, turn)) {
        log.at("round", cycle);
        results(log, p, turn);
    }
}

}  // namespace umbra78::tools
