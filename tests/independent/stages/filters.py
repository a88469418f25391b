"""Filters and composite (section 13), and the ramp (23)."""
import math

from .notation import half_up


def shadow_chains(mask, n):
    """The boundaries of the shadow, as closed lists of pixel corners, shadow on the right."""
    def shadow(x, y):
        return 0 <= x < n and 0 <= y < n and mask[y * n + x] >= 128

    def beside(x, y, dx, dy, side):
        """The pixel ahead of corner (x, y) on the right (side 1) or on the left (-1)."""
        return shadow(x + (dx - side * dy - 1) // 2, y + (dy + side * dx - 1) // 2)
    seen = set()  # the starts of the steps east above a shadow pixel
    for start in ((x, y) for y in range(n) for x in range(n)):
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


def dequantize(mask, visible, passes, n):
    def drawn(x, y):
        return 0 <= x < n and 0 <= y < n and visible[y * n + x]
    cells = [[0] * (n + 2) for _ in range(n)]  # two to the right of the frame are dropped
    for chain in shadow_chains(mask, n):
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
                step = (x + 128) >> 8
                cells[r >> 4][step >> 4] += sign * (16 - step % 16)
                cells[r >> 4][(step >> 4) + 1] += sign * (step % 16)
    result = []
    for row in cells:
        area = 0
        for cell in row[:n]:
            area += cell
            result.append((255 * min(max(area, 0), 256) + 128) >> 8)
    return [m if v else 0 for m, v in zip(result, visible)]


def low_pass(mask, visible, n):
    result = [0] * (n * n)
    weights = [(dx, dy, (2 - abs(dx)) * (2 - abs(dy))) for dy in (-1, 0, 1) for dx in (-1, 0, 1)]
    for p, seen in enumerate(visible):
        if seen:
            y, x = divmod(p, n)
            total = 8
            for dx, dy, weight in weights:
                inside = 0 <= x + dx < n and 0 <= y + dy < n
                near = p + dy * n + dx
                total += weight * mask[near if inside and visible[near] else p]
            result[p] = total >> 4
    return result


def ramp(mask, visible, width, n):
    """Crow's ramp (section 23)."""
    near = [(dx, dy) for dy in range(1 - width, width) for dx in range(1 - width, width)
            if dx * dx + dy * dy < width * width]
    near.sort(key=lambda d: d[0] ** 2 + d[1] ** 2)
    result = [0] * (n * n)
    for p, seen in enumerate(visible):
        y, x = divmod(p, n)
        if seen:
            found = next((dx * dx + dy * dy for dx, dy in near
                          if 0 <= x + dx < n and 0 <= y + dy < n
                          and mask[p + dy * n + dx] >= 128), None)
            whole = 256 * width
            level = 0 if found is None else half_up(
                255 * (whole - math.isqrt(found << 16)), whole)
            result[p] = max(mask[p], level)
    return result


def darken(level, share, mask, density):
    return (65280 * level - share * mask * density + 32640) // 65280


def composite(intensity, direct, mask, s):
    """For one light; `direct` is its plane."""
    shares = direct if s.composite == "direct" else intensity
    return [darken(i, d, m, s.density) for i, d, m in zip(intensity, shares, mask)]
