"""A depth store of floats (section 28)."""
from .notation import half_even


def kept(code, s):
    """The code that the store keeps of a drawn one."""
    if s.depth_store == "fixed":
        return code
    n, is_reversed = s.z_bits, s.depth_store == "float_reversed"
    v = (1 << n) - code if is_reversed else code
    drop = max(0, v.bit_length() - 24)
    r = half_even(v, 1 << drop) << drop
    return (1 << n) - r if is_reversed else min(r, (1 << n) - (1 << max(1, n - 24)))


def float_bits(v, n):
    """The bits of the float v / 2^n, of at most 24 significant bits."""
    if v == 0:
        return 0
    return ((126 + v.bit_length() - n) << 23) + (v << 24 >> v.bit_length()) - (1 << 23)
