"""The noise, the post-process, the filters and the composite (sections 10, 11 and 13)."""
from words import BACKGROUND, C, F, H, I, MIDDLE, N, ONE, TransformUnit, XY_BITS, Z, half_up

# -- 10. The noise --------------------------------------------------------------------------------


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


def dither_words(seed, k, size):
    """The (X, Y) dither words of all pixels; k bytes a word."""
    count = 16 * k * N * N
    stream = (noise_bits(seed, count) & ((1 << count) - 1)).to_bytes(count // 8, "little")
    scale = half_up(size << (F + 16), 512 * k << 8)
    words = [half_up((2 * sum(stream[a:a + k]) - 255 * k) * scale, 1 << 16)
             for a in range(0, len(stream), k)]
    return list(zip(words[::2], words[1::2]))


# -- 11. The post-process -------------------------------------------------------------------------


def nearest(light_z, x, y, k):
    return k > light_z[((y >> F) + H) * N + (x >> F) + H]


def bilinear(light_z, x, y, k):
    def texel(a, b):
        return light_z[b * N + a] if 0 <= a < N and 0 <= b < N else BACKGROUND
    q = 1 << F
    x, y = x - q // 2, y - q // 2
    tx, ty, fx, fy = (x >> F) + H, (y >> F) + H, x & (q - 1), y & (q - 1)
    return k * q * q > ((q - fy) * ((q - fx) * texel(tx, ty) + fx * texel(tx + 1, ty))
                        + fy * ((q - fx) * texel(tx, ty + 1) + fx * texel(tx + 1, ty + 1)))


def shadow_mask(observer_z, light_z, matrix, lookup, dither=None, accumulator=64, near=False):
    unit = TransformUnit(matrix, I, ONE, max(0, XY_BITS + I + C + 3 - accumulator), near)
    mask = [0] * (N * N)
    for p, c in enumerate(observer_z):
        if c == BACKGROUND:
            continue
        py, px = divmod(p, N)
        words = [(2 * (q - H) + 1) << (I - 1) for q in (px, py)] + [(c - MIDDLE) << (I - Z)]
        x, y, depth = unit(words, (F, F, Z))
        if dither:
            x, y = x + dither[p][0], y + dither[p][1]
        k = depth + MIDDLE
        if -H << F <= x < H << F and -H << F <= y < H << F and 0 <= k < BACKGROUND:
            mask[p] = 255 * lookup(light_z, x, y, k)
    return mask


# -- 13. Filters and composite --------------------------------------------------------------------


def shadow_chains(mask):
    """The boundaries of the shadow, as closed lists of pixel corners, shadow on the right."""
    def shadow(x, y):
        return 0 <= x < N and 0 <= y < N and mask[y * N + x] >= 128

    def beside(x, y, dx, dy, side):
        """The pixel ahead of corner (x, y) on the right (side 1) or on the left (-1)."""
        return shadow(x + (dx - side * dy - 1) // 2, y + (dy + side * dx - 1) // 2)
    seen = set()  # the starts of the steps east above a shadow pixel
    for start in ((x, y) for y in range(N) for x in range(N)):
        if start in seen or not shadow(*start) or shadow(start[0], start[1] - 1):
            continue
        (x, y), (dx, dy), chain = start, (1, 0), []
        while not chain or (x, y, dx, dy) != (*start, 1, 0):
            chain.append((x, y))
            if dx == 1:
                seen.add((x, y))
            x, y = x + dx, y + dy
            if not beside(x, y, dx, dy, 1):
                dx, dy = -dy, dx
            elif beside(x, y, dx, dy, -1):
                dx, dy = dy, -dx
        yield chain


def dequantize(mask, observer_z, passes):
    def drawn(x, y):
        return 0 <= x < N and 0 <= y < N and observer_z[y * N + x] != BACKGROUND
    cells = [[0] * (N + 1) for _ in range(N)]
    for chain in shadow_chains(mask):
        free = [all(drawn(x - a, y - b) for a in (0, 1) for b in (0, 1)) for x, y in chain]
        nodes = [(x << 12, y << 12) for x, y in chain]
        for _ in range(passes):
            nodes = [tuple((a + 2 * b + c) >> 2 for a, b, c in zip(nodes[i - 1], nodes[i], after))
                     if free[i] else nodes[i]
                     for i, after in enumerate(nodes[1:] + nodes[:1])]
        for (x0, y0), (x1, y1) in zip(nodes, nodes[1:] + nodes[:1]):
            sign = 1 if y1 < y0 else -1
            (yt, xt), (ye, xe) = sorted(((y0, x0), (y1, x1)))
            for r in range((yt + 127) >> 8, (ye + 127) >> 8):  # yt <= 256 r + 128 < ye
                x = xt + (256 * r + 128 - yt) * (xe - xt) // (ye - yt)
                s = (x + 128) >> 8
                cells[r >> 4][s >> 4] += sign * (16 - s % 16)
                cells[r >> 4][(s >> 4) + 1] += sign * (s % 16)
    result = []
    for row in cells:
        area = 0
        for cell in row[:N]:
            area += cell
            result.append((255 * min(max(area, 0), 256) + 128) >> 8)
    return [0 if c == BACKGROUND else m for m, c in zip(result, observer_z)]


def low_pass(mask, observer_z):
    result = [0] * (N * N)
    weights = [(dx, dy, (2 - abs(dx)) * (2 - abs(dy))) for dy in (-1, 0, 1) for dx in (-1, 0, 1)]
    for p, c in enumerate(observer_z):
        if c != BACKGROUND:
            y, x = divmod(p, N)
            total = 8
            for dx, dy, weight in weights:
                inside = 0 <= x + dx < N and 0 <= y + dy < N
                near = p + dy * N + dx
                total += weight * mask[near if inside and observer_z[near] != BACKGROUND else p]
            result[p] = total >> 4
    return result


def composite(intensity, share, mask, density):
    return [(65280 * i - s * m * density + 32640) // 65280
            for i, s, m in zip(intensity, share, mask)]
