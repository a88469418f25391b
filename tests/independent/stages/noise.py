"""The noise (section 10)."""
from .notation import half_up

BYTES_A_WORD = {"uniform": 1, "triangular": 2, "normal4": 4, "normal": 12}


def noise_bits(seed, count):
    """At least `count` bits of the stream as one integer, first bit least significant.

    With b[n] = b[n-31] xor b[n-28] also b[n] = b[n-31 s] xor b[n-28 s] for any power of two s
    (squaring modulo 2), so 28 s bits are made at once.
    """
    bits, n, s = seed, 31, 1
    while n < count:
        while 62 * s <= n:
            s *= 2
        more = ((bits >> (n - 31 * s)) ^ (bits >> (n - 28 * s))) & ((1 << 28 * s) - 1)
        bits |= more << n
        n += 28 * s
    return bits


def amplitude(k, size, fraction_bits):
    return half_up(size << (fraction_bits + 16), 512 * k << 8)


def dither_word(total, k, scale):
    return half_up((2 * total - 255 * k) * scale, 1 << 16)


def dither_words(s):
    """The (X, Y) dither words of all pixels, or None where there is no dither."""
    if s.dither == "none":
        return None
    k = BYTES_A_WORD[s.dither]
    count = 16 * k * s.size_px * s.size_px
    stream = (noise_bits(s.dither_seed, count) & ((1 << count) - 1)).to_bytes(count // 8, "little")
    scale = amplitude(k, s.dither_size, s.fraction_bits)
    of_sum = [dither_word(total, k, scale) for total in range(255 * k + 1)]
    words = [of_sum[sum(stream[a:a + k])] for a in range(0, len(stream), k)]
    return list(zip(words[::2], words[1::2]))
