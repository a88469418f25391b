"""The transform unit (section 5)."""
from fractions import Fraction

from .notation import fits, shift_down


def load_row(row, bits, rounding, start=-31):
    if not any(row):
        return [0] * 4, max(0, start)
    for e in range(start, 32):
        scaled = [Fraction(a) * Fraction(2) ** (bits - 2 - e) for a in row]
        words = [rounding(a.numerator, a.denominator) for a in scaled]
        if all(fits(word, bits) for word in words):
            return words, e
    raise ValueError("no exponent fits")


class Loaded:
    """A matrix as words, for input words with the given fraction and `one`."""

    def __init__(self, matrix, fraction, one, s):
        w = matrix[3]
        self.affine = not any(w[:3])
        if not any(w):
            raise ValueError("row W is all zeros")
        one_value = Fraction(one, 1 << fraction)
        self.rows = []
        for row in matrix:
            row = [a / w[3] for a in row] if self.affine else list(row)
            row[3] = row[3] / one_value
            self.rows.append(load_row(row, s.coefficient_bits, s.rounding("coefficient")))
        self.words = [words for words, _ in self.rows]
        self.exponents = [e for _, e in self.rows]
        if not self.affine and any(abs(e - self.exponents[3]) > 42 for e in self.exponents):
            raise ValueError("a row is too far from W")
        self.fraction, self.one = fraction, one

    def shift(self, r, out, s):
        return s.coefficient_bits - 2 + self.fraction - out - self.exponents[r]


class ScreenUnit:
    """The unit of the shadow test: screen words in, (X, Y, Z) or None (a status) out."""

    def __init__(self, matrix, s):
        self.m = matrix if isinstance(matrix, Loaded) else Loaded(
            matrix, s.input_fraction, s.one_word, s)
        self.s = s
        self.out = (s.fraction_bits, s.fraction_bits, s.depth_fraction)
        self.bits = (s.xy_bits + s.fraction_bits + 1,) * 2 + (s.z_bits + 1,)
        self.transform = s.rounding("transform")
        self.product, self.place = s.rounding("product"), 1 << s.dropped_bits
        self.constant = [self.cut(row[3] * self.m.one) for row in self.m.words]
        self.shifts = [self.m.shift(r, self.out[r], s) for r in range(3)]

    def cut(self, product):
        return self.product(product, self.place) * self.place if self.place > 1 else product

    def accumulators(self, x, y, z):
        if self.place > 1:
            return [self.cut(a * x) + self.cut(b * y) + self.cut(c * z) + k
                    for (a, b, c, _), k in zip(self.m.words, self.constant)]
        return [a * x + b * y + c * z + k
                for (a, b, c, _), k in zip(self.m.words, self.constant)]

    def status_and_results(self, x, y, z):
        acc = self.accumulators(x, y, z)
        if self.m.affine:
            return "ok", [shift_down(a, n, self.transform) for a, n in zip(acc, self.shifts)]
        if self.s.divide_order == "round_first":
            acc = [self.transform(a, 1 << (self.s.coefficient_bits - 2)) for a in acc]
        if acc[3] <= 0:
            return "divisor_not_positive", None
        results = []
        for a, e, out, bits in zip(acc, self.m.exponents, self.out, self.bits):
            k = out + e - self.m.exponents[3]
            q = self.transform(a << max(k, 0), acc[3] << max(-k, 0))
            if not fits(q, bits):
                return "overflow", None
            results.append(q)
        return "ok", results

    def __call__(self, x, y, z):
        return self.status_and_results(x, y, z)[1]
