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


def state_at(seed, n):
    """bit[n] .. bit[n + 30]: x^n modulo x^31 + x^3 + 1 says which bits of the seed are added."""
    power = 1
    for digit in f"{n:b}":
        square = sum((power >> i & 1) << 2 * i for i in range(31))
        power = square << int(digit)
        while power >> 31:
            power = (power & (2 ** 31 - 1)) ^ (power >> 31) ^ (power >> 31 << 3)
    known, state = noise_bits(seed, 62), 0
    for i in range(31):
        if power >> i & 1:
            state ^= known >> i
    return state & (2 ** 31 - 1)


def tap_bytes(s):
    """For each pixel its taps' bytes, (u, v) tap by tap, row by row; None where there are none."""
    if s.tap_places == "grid" or s.lookup not in ("percentage", "filtered_depth"):
        return None
    a_pixel = 2 * s.taps ** 2
    count = 8 * a_pixel * s.size_px ** 2
    stream = noise_bits(state_at(s.dither_seed, 2 ** 30), count) & ((1 << count) - 1)
    stream = stream.to_bytes(count // 8, "little")
    return [tap_pairs(stream[a:a + a_pixel]) for a in range(0, len(stream), a_pixel)]


def tap_pairs(own):
    return list(zip(own[::2], own[1::2]))


def taps_of_pixel(seed, taps, pixel):
    own = noise_bits(state_at(seed, 2 ** 30 + 16 * taps ** 2 * pixel), 16 * taps ** 2)
    count = 16 * taps ** 2
    return tap_pairs((own & ((1 << count) - 1)).to_bytes(count // 8, "little"))
