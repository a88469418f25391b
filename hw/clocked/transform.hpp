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
        const auto one = static_cast<std::int64_t>(input_.one_word());
        adds_half_ = spec.transform_rounding == Rounding::half_up && spec.accumulator_bits() < 62;
        for (std::size_t r = 0; r < 4; ++r) {
            round_shift_[r] = shift_of(static_cast<int>(r));
            const bool fits = round_shift_[r] >= 0 && round_shift_[r] < 62;
            half_[r] = fits && round_shift_[r] > 0 ? std::int64_t{1} << (round_shift_[r] - 1) : 0;
            adds_half_ = adds_half_ && fits;
            start_[r] = matrix.affine ? cut_(matrix.word[r][3] * one) : 0;
        }
        for (int c = 0; c < cycles_; ++c) turn_[static_cast<std::size_t>(c)] = turn_of(c);
        whole_ = passes_ == 1 && cut_.dropped == 0;
        row_a_turn_ = whole_ && spec.multipliers == 4;
        latency_ = cycles() - 1 + delay_.multiply + delay_.sum + delay_.accumulate + delay_.round;
        fixed::require(latency_ <= most_steps, "clocked transform: more steps than it has a table");
        for (int c = 0; c < latency_; ++c)
            step_[static_cast<std::size_t>(c)] = {
                in_turns(c), in_turns(c - accumulate_step(0)),
                rounds_ ? in_turns(c - round_step(0)) : none};
    }

    // Multiply's cycles a point; the stages that follow it take one each.
    int cycles() const { return cycles_; }
    int latency() const { return latency_; }

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
    int round_shift(int row) const { return round_shift_[std::size_t(row)]; }
    int result_bits(int row) const {
        const int bits = spec_.accumulator_bits() - round_shift(row);
        return bits < 2 ? 2 : bits;
    }

private:
    friend struct TransformRegisters;
    struct Delay {
        int multiply, sum, accumulate, round;
    };
    // What the products of a multiply cycle are: those of rows `row` to `last_row` and of columns
    // `column` to `last_column`, by one pass; and whether they are the last of their rows.
    struct Turn {
        std::uint8_t row, last_row, column, last_column, pass;
        bool ends_rows;
    };
    static constexpr int most_cycles = 4 * 4 * 4;  // one multiplier, both halves of both words
    // What is done in a step: the multiply cycles whose products are formed, accumulated and
    // rounded; `none` where nothing is.
    static constexpr std::int8_t none = -1;
    struct StepWork {
        std::int8_t multiply, accumulate, round;
    };
    static constexpr int most_steps = most_cycles + 32;
    std::int8_t in_turns(int cycle) const {
        return cycle >= 0 && cycle < cycles_ ? static_cast<std::int8_t>(cycle) : none;
    }

    Turn turn_of(int cycle) const {
        const auto narrow = [](int v) { return static_cast<std::uint8_t>(v); };
        const int pass = cycle % passes_, turn = cycle / passes_;
        const bool by_one = spec_.multipliers == 1, by_all = spec_.multipliers == 16;
        const int row = by_all ? 0 : by_one ? turn / columns_ : turn;
        const int column = by_one ? turn % columns_ : 0;
        const int last_column = by_one ? column : columns_ - 1;
        return {narrow(row), narrow(by_all ? rows_ - 1 : row), narrow(column),
                narrow(last_column), narrow(pass),
                pass == passes_ - 1 && last_column == columns_ - 1};
    }
    int shift_of(int row) const {
        if (!matrix_.affine) return spec_.coefficient_bits - 2;
        const int out = row == 2 ? spec_.depth_fraction() : spec_.fraction_bits;
        return affine_shift(matrix_, static_cast<Row>(row), spec_, input_, out);
    }

    MachineSpec spec_;
    MatrixWords matrix_;
    WordFormat input_;
    ProductCut cut_;
    int cycles_, rows_ = 0, columns_ = 0, passes_ = 0, coefficient_cut_ = 0, word_cut_ = 0;
    bool rounds_ = false;
    bool whole_ = false;       // a pass is the product: nothing is cut
    bool row_a_turn_ = false;  // and a turn forms all products of one row
    bool adds_half_ = false;  // rounds by adding half a unit of what is left
    int latency_ = 0;
    Delay delay_{};
    std::array<int, 4> round_shift_{};
    std::array<std::int64_t, 4> half_{};
    Accumulators start_{};  // the accumulators, before the first product
    std::array<Turn, most_cycles> turn_{};
    std::array<StepWork, most_steps> step_{};
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
        accumulator = plan.start_;
    }

    // A step of a unit that does one row at a time, as 1978's widths on four multipliers do, is
    // short enough to be a part of the loop over the stages; any other is a call.
    [[gnu::always_inline]] void step(const TransformPipeline& plan, int cycle) {
        const TransformPipeline::StepWork work = plan.step_[std::size_t(cycle)];
        if (!plan.row_a_turn_) return step_any(plan, work);
        if (work.multiply >= 0)
            under_way_[std::size_t(work.multiply)][0] =
                whole_row(plan, std::size_t(work.multiply));
        if (work.accumulate >= 0)
            accumulator[std::size_t(work.accumulate)] +=
                under_way_[std::size_t(work.accumulate)][0];
        if (work.round >= 0) round_row(plan, std::size_t(work.round));
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

    std::int64_t whole_row(const TransformPipeline& plan, std::size_t r) {
        const auto& a = plan.matrix_.word[r];
        auto& word = product[r];
        word[0] = std::int64_t{a[0]} * words.x;
        word[1] = std::int64_t{a[1]} * words.y;
        word[2] = std::int64_t{a[2]} * words.z;
        const std::int64_t sum = word[0] + word[1] + word[2];
        if (plan.columns_ == 3) return sum;
        word[3] = std::int64_t{a[3]} * plan.input_.one_word();
        return sum + word[3];
    }

    [[gnu::noinline]] void step_any(const TransformPipeline& plan,
                                    TransformPipeline::StepWork work) {
        if (work.multiply >= 0) multiply(plan, work.multiply);
        if (work.accumulate >= 0) accumulate(plan, work.accumulate);
        if (work.round >= 0) round(plan, work.round);
    }

    void multiply(const TransformPipeline& plan, int cycle) {
        const TransformPipeline::Turn& t = plan.turn_[std::size_t(cycle)];
        auto& sums = under_way_[std::size_t(cycle) % max_under_way];
        for (std::size_t r = t.row; r <= t.last_row; ++r) {
            std::int64_t sum = 0;
            for (int c = t.column; c <= t.last_column; ++c)
                sum += multiply_pass(plan, int(r), c, t.pass);
            sums[r - t.row] = sum;
        }
    }

    void accumulate(const TransformPipeline& plan, int cycle) {
        const TransformPipeline::Turn& t = plan.turn_[std::size_t(cycle)];
        const auto& sums = under_way_[std::size_t(cycle) % max_under_way];
        for (std::size_t r = t.row; r <= t.last_row; ++r) accumulator[r] += sums[r - t.row];
    }

    // The rows whose last product was accumulated with this cycle's.
    void round(const TransformPipeline& plan, int cycle) {
        const TransformPipeline::Turn& t = plan.turn_[std::size_t(cycle)];
        if (!t.ends_rows) return;
        for (std::size_t r = t.row; r <= t.last_row; ++r) round_row(plan, r);
    }

    void round_row(const TransformPipeline& plan, std::size_t r) {
        const int shift = plan.round_shift_[r];
        result[r] = plan.adds_half_ ? fixed::floor_shift(accumulator[r] + plan.half_[r], shift)
                                    : fixed::scale_shift(accumulator[r], shift,
                                                         plan.spec_.transform_rounding);
    }
};

}  // namespace umbra78::hw
