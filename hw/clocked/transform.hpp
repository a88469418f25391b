// The transform unit, clocked: a few multipliers, an adder tree, an accumulator, a rounder.
//
//   words --> [ multiply ]--> [ sum ]--> [ accumulate ]--> [ round ]--> X, Y, Z, or to
//               s cycles     4 or 16       and the           affine      the divider
//                          multipliers   fourth column     views only
//
// With one multiplier a product is formed each cycle, with four a row's, with sixteen all of them.
// A coefficient or word of more than 16 bits is cut into two halves, a = a1 2^h + a0 with a1 signed
// and of 16 bits, a0 >= 0, and each pair of halves is a pass of its own. If the accumulator is too
// short for the product, the passes are added up first, and the product is rounded and accumulated
// with its last pass. Where w is 1 the fourth column is a constant, from which the accumulators
// start. Parts that take longer than a clock are cut into more stages (hw/clocked/timing.hpp);
// a point takes a cycle for each.
//
// In: screen words of hw::screen_words. Out: accumulators for the divider, or rounded rows.
// The model gives each point its own registers, which travel with it through the stages, so any
// number of points may be under way.
// Bits are those of hw/transform_unit.hpp; tests hold the two equal under any stalls.
#pragma once

#include "fixed/rounding.hpp"
#include "hw/clocked/handshake.hpp"
#include "hw/clocked/timing.hpp"
#include "hw/transform_unit.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace umbra78::hw {

// What is fixed while a frame runs.
class TransformPipeline {
public:
    TransformPipeline(const MachineSpec& spec, const Timing& timing, const MatrixWords& matrix)
        : spec_(spec), matrix_(matrix), input_(screen_words(spec)),
          cut_(product_cut(spec)),
          cycles_(transform_cycles(spec, matrix.affine)) {
        columns_ = rows_ = matrix.affine ? 3 : 4;
        coefficient_cut_ = spec.coefficient_bits > 16 ? spec.coefficient_bits - 16 : 0;
        word_cut_ = spec.word_bits() > 16 ? spec.word_bits() - 16 : 0;
        passes_ = (coefficient_cut_ > 0 ? 2 : 1) * (word_cut_ > 0 ? 2 : 1);
        rounds_ = matrix.affine || spec.divide_order == DivideOrder::round_first;
        delay_ = {timing.multiply_stages(), spec.multipliers > 1 ? timing.sum_stages() : 0,
                  timing.accumulate_stages(), rounds_ ? timing.round_stages() : 0};
        fixed::require(accumulate_step(0) < max_under_way,
                       "clocked transform: more sums under way than it has registers for");
    }

    // Multiply's cycles a point; the stages that follow it take one each.
    int cycles() const { return cycles_; }
    int latency() const {
        return cycles() - 1 + delay_.multiply + delay_.sum + delay_.accumulate + delay_.round;
    }

    // To a Chain or a StageList.
    template <class Stages>
    void add_stages(Stages& chain) const {
        chain.add("multiply", cycles());
        for (int k = 1; k < delay_.multiply; ++k) chain.add("multiply");
        for (int k = 0; k < delay_.sum; ++k) chain.add("sum");
        for (int k = 0; k < delay_.accumulate; ++k) chain.add("accumulate");
        for (int k = 0; k < delay_.round; ++k) chain.add("round");
    }

    const MachineSpec& spec() const { return spec_; }
    const MatrixWords& matrix() const { return matrix_; }
    int rows() const { return rows_; }
    int columns() const { return columns_; }
    int passes() const { return passes_; }
    bool rounds() const { return rounds_; }
    // Bits of the low halves; 0 where coefficients, or words, are not cut.
    int coefficient_cut() const { return coefficient_cut_; }
    int word_cut() const { return word_cut_; }
    // A sum of products waits for the accumulator in a register of its own. The one that is formed
    // in step c is used in step c + accumulate_step(0), after that step's own sum was stored.
    static constexpr int max_under_way = 16;
    // The products of multiply cycle c are summed, accumulated and rounded in these steps.
    bool sums() const { return delay_.sum > 0; }
    int sum_step(int c) const { return c + delay_.multiply - 1 + delay_.sum; }
    int accumulate_step(int c) const { return sum_step(c) + delay_.accumulate; }
    int round_step(int c) const { return accumulate_step(c) + delay_.round; }
    // How far a row is shifted right when it is rounded, and how many bits are left.
    int round_shift(int row) const {
        if (!matrix_.affine) return spec_.coefficient_bits - 2;
        const int out = row == 2 ? spec_.depth_fraction() : spec_.fraction_bits;
        return affine_shift(matrix_, static_cast<Row>(row), spec_, input_, out);
    }
    int result_bits(int row) const {
        const int bits = spec_.accumulator_bits() - round_shift(row);
        return bits < 2 ? 2 : bits;
    }

private:
    friend struct TransformRegisters;
    struct Delay {
        int multiply, sum, accumulate, round;
    };

    MachineSpec spec_;
    MatrixWords matrix_;
    WordFormat input_;
    ProductCut cut_;
    int cycles_, rows_ = 0, columns_ = 0, passes_ = 0, coefficient_cut_ = 0, word_cut_ = 0;
    bool rounds_ = false;
    Delay delay_{};
};

static_assert(slowest_legal.multiply_stages() - 1 + slowest_legal.sum_stages() +
                      slowest_legal.accumulate_stages() <
                  TransformPipeline::max_under_way,
              "no legal timing has more sums under way than there are registers");

// A point in the unit. Its user calls step(0), step(1) and so on, latency() steps in all.
struct TransformRegisters {
    Words words{};
    // By row and column. With one or four multipliers the rows are formed one after the other.
    std::array<std::array<std::int64_t, 4>, 4> product{};
    Accumulators accumulator{};
    std::array<std::int64_t, 4> result{};   // rounded rows

    void load(const TransformPipeline& plan, const Words& point) {
        words = point;
        const auto one = static_cast<std::int64_t>(plan.input_.one_word());
        for (std::size_t r = 0; r < 4; ++r)
            accumulator[r] = plan.matrix_.affine ? plan.cut_(plan.matrix_.word[r][3] * one) : 0;
    }

    void step(const TransformPipeline& plan, int cycle) {
        if (cycle < plan.cycles()) multiply(plan, cycle);
        const int accumulated = cycle - plan.accumulate_step(0);
        if (accumulated >= 0 && accumulated < plan.cycles()) accumulate(plan, accumulated);
        const int rounded = cycle - plan.round_step(0);
        if (plan.rounds_ && rounded >= 0 && rounded < plan.cycles()) round(plan, rounded);
    }

private:
    // Sums of products on their way to the accumulator, by the cycle that formed them.
    static constexpr int max_under_way = TransformPipeline::max_under_way;
    std::array<std::array<std::int64_t, 4>, max_under_way> under_way_{};

    // The halves of a word: the low one without sign.
    static std::int64_t half(std::int64_t word, int cut, bool low) {
        return low ? word & ((std::int64_t{1} << cut) - 1) : fixed::floor_shift(word, cut);
    }

    // One pass of one product, shifted to its place.
    std::int64_t pass(const TransformPipeline& plan, int row, int column, int number) const {
        const std::int64_t words_in[4] = {words.x, words.y, words.z, plan.input_.one_word()};
        const std::int64_t a = plan.matrix_.word[std::size_t(row)][std::size_t(column)];
        const std::int64_t b = words_in[column];
        const bool low_a = plan.coefficient_cut_ > 0 && (number & 1) == 0;
        const int pass_of_b = plan.coefficient_cut_ > 0 ? number / 2 : number;
        const bool low_b = plan.word_cut_ > 0 && (pass_of_b & 1) == 0;
        const int shift =
            (low_a ? 0 : plan.coefficient_cut_) + (low_b ? 0 : plan.word_cut_);
        return half(a, plan.coefficient_cut_, low_a) * half(b, plan.word_cut_, low_b) *
               (std::int64_t{1} << shift);
    }

    // What a pass adds to the accumulator. Where products are rounded that is nothing until the
    // last pass, and then the whole product.
    std::int64_t multiply_pass(const TransformPipeline& plan, int row, int column, int number) {
        std::int64_t& word = product[std::size_t(row)][std::size_t(column)];
        const std::int64_t part = pass(plan, row, column, number);
        if (plan.cut_.dropped == 0) return word = part;
        word = number == 0 ? part : word + part;
        if (number + 1 < plan.passes_) return 0;
        return word = plan.cut_(word);
    }

    std::int64_t row_products(const TransformPipeline& plan, int row, int number) {
        std::int64_t sum = 0;
        for (int c = 0; c < plan.columns_; ++c) sum += multiply_pass(plan, row, c, number);
        return sum;
    }

    void multiply(const TransformPipeline& plan, int cycle) {
        auto& sums = under_way_[std::size_t(cycle % max_under_way)];
        const int number = cycle % plan.passes_, turn = cycle / plan.passes_;
        if (plan.spec_.multipliers == 16) {
            for (int r = 0; r < plan.rows_; ++r)
                sums[std::size_t(r)] = row_products(plan, r, number);
        } else if (plan.spec_.multipliers == 4) {
            sums[0] = row_products(plan, turn, number);
        } else {
            const int row = turn / plan.columns_, column = turn % plan.columns_;
            sums[0] = multiply_pass(plan, row, column, number);
        }
    }

    void accumulate(const TransformPipeline& plan, int cycle) {
        const auto& sums = under_way_[std::size_t(cycle % max_under_way)];
        const int turn = cycle / plan.passes_;
        if (plan.spec_.multipliers == 16) {
            for (std::size_t r = 0; r < std::size_t(plan.rows_); ++r) accumulator[r] += sums[r];
        } else {
            accumulator[std::size_t(plan.spec_.multipliers == 4 ? turn : turn / plan.columns_)] +=
                sums[0];
        }
    }

    // The rows whose last product was accumulated with this cycle's.
    void round(const TransformPipeline& plan, int cycle) {
        const int each = plan.spec_.multipliers == 1    ? plan.columns_ * plan.passes_
                         : plan.spec_.multipliers == 4 ? plan.passes_
                                                       : plan.cycles();
        if ((cycle + 1) % each != 0) return;
        if (plan.spec_.multipliers == 16) {
            for (int r = 0; r < plan.rows_; ++r) round_row(plan, r);
        } else {
            round_row(plan, (cycle + 1) / each - 1);
        }
    }

    void round_row(const TransformPipeline& plan, int row) {
        const auto r = static_cast<std::size_t>(row);
        result[r] = fixed::scale_shift(accumulator[r], plan.round_shift(row),
                                       plan.spec_.transform_rounding);
    }
};

}  // namespace umbra78::hw
