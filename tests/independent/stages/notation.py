"""Notation and the hash (section 1)."""
from fractions import Fraction


def half_up(a, b):
    return (2 * a + b) // (2 * b)


def half_even(a, b=1):
    return round(Fraction(a, b))


def to_zero(a, b):
    return -(-a // b) if a < 0 else a // b


def _half(a, b, tie_up):
    q, rest = divmod(a, b)
    return q + (2 * rest > b or (2 * rest == b and tie_up(q)))


# a / b, b > 0, by the roundings' names
ROUNDINGS = {
    "floor": lambda a, b: a // b,
    "ceiling": lambda a, b: -(-a // b),
    "to_zero": to_zero,
    "half_up": half_up,
    "half_to_zero": lambda a, b: _half(a, b, lambda _: a < 0),
    "half_away": lambda a, b: _half(a, b, lambda _: a > 0),
    "half_even": lambda a, b: _half(a, b, lambda q: q & 1),
}


def shift_down(a, n, rounding=half_up):
    """a / 2^n rounded, or for n <= 0 exactly."""
    return rounding(a, 1 << n) if n > 0 else a << -n


def fits(word, bits):
    return -(1 << (bits - 1)) <= word < 1 << (bits - 1)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def to_bytes(values, size):
    return b"".join(value.to_bytes(size, "big") for value in values)


def fnv(data):
    h = 0xCBF29CE484222325
    for byte in data:
        h = (h ^ byte) * 0x100000001B3 & 0xFFFFFFFFFFFFFFFF
    return h


def published_hash(values, size, size_px):
    name = {1: "u8", 2: "u16be", 4: "u32be"}[size]
    return f"{name}:{size_px}x{size_px}:fnv1a64:{fnv(to_bytes(values, size)):016x}"
