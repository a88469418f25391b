"""Views, their matrices and the bias (section 4)."""
import math
from fractions import Fraction

from .notation import dot, half_even, shift_down, to_zero
from .words import cosine, mul30, sine


def axes_from_angles(azimuth, elevation):
    """right, up, back from angles in Q15.16 degrees"""
    sa, ca, se, ce = sine(azimuth), cosine(azimuth), sine(elevation), cosine(elevation)
    return ((ca, 0, -sa), (-mul30(sa, se), ce, -mul30(ca, se)),
            (mul30(sa, ce), se, mul30(ca, ce)))


def unit30(v):
    down = max(map(abs, v)).bit_length() - 30
    v = [shift_down(x, down, half_even) for x in v]
    length = math.isqrt(dot(v, v))
    return tuple(half_even(x << 30, length) for x in v)


def axes_from_points(p, t):
    v = [a - b for a, b in zip(p, t)]
    back = unit30(v)
    right = unit30((v[2], 0, -v[0])) if v[0] or v[2] else (1 << 30, 0, 0)
    return right, (mul30(back[1], right[2]),
                   mul30(back[2], right[0]) - mul30(back[0], right[2]),
                   -mul30(back[1], right[0])), back


class View:
    """Axes are Q2.30 vectors; target, extent, distance (0: orthographic), near, far Q15.16."""

    def __init__(self, axes, extent, distance=0, depths=None, target=(0, 0, 0), patches=()):
        self.axes, self.extent_word = axes, extent
        self.distance_word, self.target_words = distance, target
        self.right, self.up, self.back = ([Fraction(x, 1 << 30) for x in v] for v in axes)
        self.extent, self.distance = Fraction(extent, 1 << 16), Fraction(distance, 1 << 16)
        self.perspective = distance > 0
        self.origin = [Fraction(t, 1 << 16) + self.distance * b
                       for t, b in zip(target, self.back)]
        near, far = depths or self.fitted(extent, patches)
        self.depths = near, far
        self.near, self.far = Fraction(near, 1 << 16), Fraction(far, 1 << 16)

    def fitted(self, extent, patches):
        depths = [dot(self.back, self.origin) - dot(self.back, [Fraction(x, 1 << 16) for x in p])
                  for patch in patches for p in patch] or [Fraction(0)]
        d_min, d_max = math.floor(min(depths) * 65536), math.ceil(max(depths) * 65536)
        if not self.perspective:
            reach = max(extent, -d_min, d_max + 1)
            return -reach, reach
        far = max(d_max + to_zero(d_max, 64) + 1, 1024)
        near = max(d_min - to_zero(d_min, 64) - 1, to_zero(far, 1024))
        return (near if near < far else to_zero(far, 1024)), far

    def world_to_screen(self, s):
        scale = s.half_px / self.extent * (self.distance if self.perspective else 1)
        away = [-x for x in self.back]
        near, far = self.near, self.far

        def row(factor, axis, plus=0):
            return [factor * x for x in axis] + [plus - factor * dot(axis, self.origin)]
        rows = [row(scale, self.right), row(-scale, self.up)]
        if not self.perspective:
            return rows + [row(2 * s.half_px / (far - near), away,
                               -s.half_px * (2 * near / (far - near) + 1)),
                           [0, 0, 0, Fraction(1)]]
        return rows + [row(s.half_px * (far + near) / (far - near), away,
                           -s.half_px * 2 * far * near / (far - near)), row(1, away)]

    def screen_to_world(self, s):
        near, far, h = self.near, self.far, s.half_px
        if not self.perspective:
            pixel, quantum = self.extent / h, (far - near) / (2 * h)
            return [[r * pixel, -u * pixel, -b * quantum, o - b * (far + near) / 2]
                    for r, u, b, o in zip(self.right, self.up, self.back, self.origin)
                    ] + [[0, 0, 0, Fraction(1)]]
        scale = h * self.distance / self.extent
        span, middle = 2 * h * far * near / (far - near), (far + near) / (2 * far * near)
        return [[r / scale, -u / scale, -o / span, o * middle - b]
                for r, u, b, o in zip(self.right, self.up, self.back, self.origin)
                ] + [[0, 0, -1 / span, middle]]

    def bias_quanta(self, bias, unit, s):
        """A bias in Q.16 of its unit as quanta in Q.16."""
        a_world_unit = (1 << s.z_bits) / (self.far - self.near)
        if self.perspective:
            a_world_unit *= self.far * self.near / self.distance ** 2
        factor = {"quanta": 1, "world": a_world_unit,
                  "texels": a_world_unit / (s.half_px / self.extent)}[unit]
        return half_even(bias * factor)


def observer_to_light(observer, light, s, bias_quanta):
    """bias_quanta is Q.16."""
    columns = list(zip(*observer.screen_to_world(s)))
    matrix = [[dot(row, column) for column in columns] for row in light.world_to_screen(s)]
    bias = Fraction(bias_quanta, 1 << 16) * s.quantum_px()
    matrix[2] = [a - bias * w for a, w in zip(matrix[2], matrix[3])]
    return matrix


def shadow_matrix(observer, light, s):
    return observer_to_light(observer, light, s, light.bias_quanta(s.bias, s.bias_unit, s))
