#include "shadow/rivals/planes.hpp"

namespace umbra78::shadow::rivals {

Run run_of(const ScreenLine& line, int wanted, const Space& space, int row) {
    const int size = space.size_px();
    const Sum at_middle = line.y * space.centre(row) + line.c;  // of the row: px = 0
    const auto sign_at = [&](int column) {
        const int s = sign(line.x * space.centre(column) + at_middle);
        return s != 0 ? s : line.tie();
    };
    const int first = sign_at(0), last = sign_at(size - 1);
    if (first == last) return first == wanted ? Run{0, size} : Run{0, 0};
    // One change, at px = -at_middle / x. A centre on the line has the sign of x, as those after
    // it.
    const auto [quotient, rest] = Sum::divide(-at_middle, line.x);
    const bool up = !rest.is_zero() && at_middle.is_negative() != line.x.is_negative();
    const std::int64_t change = quotient.to_int64() + (up ? 1 : 0);
    const auto column = static_cast<int>(space.first_not_below(change));
    return last == wanted ? Run{column, size} : Run{0, column};
}

}  // namespace umbra78::shadow::rivals
