#!/usr/bin/env python3
"""A second reading of the rivals' definition (shadow/rivals/RIVALS.md), in exact numbers.

Reads the scenes of tests/goldens/rivals.txt, finds for each pixel what is seen and whether it is
dark, by rays, and compares with the pictures there. Nothing is shared with the C++ code: rays and
facets meet in points, quotients of integers, and the pixel's centre really is moved by a small
fraction, where the C++ code asks for the signs of coefficients.

    python3 -B tests/independent/rivals.py tests/goldens/rivals.txt [NAME ...]
"""
import sys

# The pixel's centre is moved by e to the right and by e^2 down. e = 2^-120 is so small that no
# value of these scenes which is not 0 changes its sign by it.
SMALL = 120
ONE = 1 << 2 * SMALL


def minus(a, b):
    return [p - q for p, q in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


class Facet:
    def __init__(self, a, b, c):
        self.vertices = a, b, c
        self.normal = cross(minus(b, a), minus(c, a))
        # Inward normals of the three planes that stand on its edges.
        self.walls = [(u, cross(self.normal, minus(v, u))) for u, v in ((a, b), (b, c), (c, a))]

    def side(self, centre):
        """On which side of its plane a centre of projection lies: 1, 0 or -1."""
        v = dot(self.normal, centre[:3]) - (dot(self.normal, self.vertices[0]) if centre[3] else 0)
        return (v > 0) - (v < 0)

    def meeting(self, origin, direction):
        """(point, n, d) where the line meets it: origin + n / d direction, d > 0; or None.

        Points are (x, y, z, w), w > 0, and stand for (x, y, z) / w."""
        slope = dot(self.normal, direction)
        if slope == 0:
            return None
        w = origin[3]
        n = w * dot(self.normal, self.vertices[0]) - dot(self.normal, origin[:3])
        if slope < 0:
            slope, n = -slope, -n
        point = [o * slope + n * d for o, d in zip(origin[:3], direction)] + [w * slope]
        if all(dot(wall, point[:3]) > dot(wall, u) * point[3] for u, wall in self.walls):
            return point, n, w * slope
        return None


def pixel(scene, column, row):
    bits, fraction = scene["frame"]
    half_pixel = 1 << (fraction - 1)
    p = [(2 * column + 1 - (1 << bits)) * half_pixel * ONE + (1 << SMALL),
         (2 * row + 1 - (1 << bits)) * half_pixel * ONE + 1, 0, ONE]
    eye, light, facets = scene["eye"], scene["light"], scene["facets"]
    if eye[3]:
        origin, direction = eye, [q - e * ONE for q, e in zip(p, eye[:3])]
    else:
        origin, direction = p, [-d for d in eye[:3]]
    best = None
    for number, facet in enumerate(facets):
        met = facet.meeting(origin, direction)
        if met is None or (eye[3] and met[1] <= 0):
            continue
        if best is None or met[1] * best[1][2] < best[1][1] * met[2]:
            best = number, met
    if best is None:
        return "."
    number, (point, _, _) = best
    if facets[number].side(eye) != facets[number].side(light):
        return "a"
    w = point[3]
    toward = [q * w - r for q, r in zip(light[:3], point)] if light[3] else light[:3]
    for other, facet in enumerate(facets):
        if other == number:
            continue
        met = facet.meeting(point, toward)
        if met is not None and met[1] > 0 and (not light[3] or met[1] * w < met[2]):
            return "c"
    return "l"


def read(path):
    scenes = []
    for line in open(path):
        words = line.split()
        if not words or words[0] == "#":
            continue
        if words[0] == "scene":
            scenes.append({"name": " ".join(words[1:]), "facets": [], "rows": []})
        elif words[0] in ("frame", "eye", "light"):
            scenes[-1][words[0]] = [int(w) for w in words[1:]]
        elif words[0] == "facet":
            v = [int(w) for w in words[1:]]
            if v[0:3] != v[3:6] != v[6:9] != v[0:3]:  # else it has lost a vertex, and is none
                scenes[-1]["facets"].append(Facet(v[0:3], v[3:6], v[6:9]))
        else:
            scenes[-1]["rows"].append(words[0])
    return scenes


def main():
    scenes = read(sys.argv[1])
    wanted = sys.argv[2:]
    wrong = pixels = 0
    for scene in scenes:
        if wanted and scene["name"] not in wanted:
            continue
        for row, text in enumerate(scene["rows"]):
            for column, expected in enumerate(text):
                pixels += 1
                got = pixel(scene, column, row)
                if got != expected:
                    wrong += 1
                    if wrong <= 10:
                        print(f"{scene['name']}: column {column}, row {row}: "
                              f"{got} here, {expected} in {sys.argv[1]}")
    print(f"{pixels} pixels of {len(wanted) or len(scenes)} scenes, {wrong} differ")
    return 1 if wrong or not pixels else 0


if __name__ == "__main__":
    sys.exit(main())
