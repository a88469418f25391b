"""Settings, as section 2's table lists them, and the widths that follow from them."""
import pathlib
from fractions import Fraction

from .notation import ROUNDINGS, half_even

FRACTION = {"ambient": 8, "density": 8, "dither_size": 8, "bias": 16,  # others are whole
            "bias_slope": 8, "bias_clamp": 16, "normal_offset": 8}
HW = pathlib.Path(__file__).parent / "../../../hw"


def document(path=HW / "MACHINE.md"):
    """The machine's definition as one text: MACHINE.md and the files of machine/ beside it."""
    files = [path, *sorted((path.parent / "machine").glob("*.md"))]
    return "".join(file.read_text(encoding="utf-8") for file in files)


def table(text, head):
    """The cells of all tables whose first line starts with `head`."""
    rows, inside = [], False
    for line in text.split("\n"):
        if line.startswith(head):
            inside = True
        elif not line.startswith("|"):
            inside = False
        elif inside and not line.startswith("|---"):
            rows.append([cell.strip() for cell in line.strip("|").split("|")])
    return rows


def value(key, written):
    """A setting's word: a whole number, a decimal with a fraction, or a choice's name."""
    try:
        return half_even(Fraction(written) * (1 << FRACTION.get(key, 0)))
    except ValueError:
        return written


DEFAULTS = {row[0]: value(row[0], row[1])
            for row in table(document(), "| setting | default | range |")}


class Settings:
    """All settings as attributes, and the widths of section 2 by their names there."""

    def __init__(self, written="", **words):
        self.__dict__.update(DEFAULTS)
        for one in filter(None, written.split(", ")):
            key, text = one.split(" ")
            words[key] = value(key, text)
        for key, word in words.items():
            assert key in DEFAULTS, key
            setattr(self, key, word)
        self.size_px, self.half_px = 1 << self.xy_bits, 1 << (self.xy_bits - 1)
        self.depth_fraction = self.z_bits - self.xy_bits
        self.depth_offset = 1 << (self.z_bits - 1)
        self.background_code = (1 << self.z_bits) - 1
        self.deepest_drawn = self.background_code - 1
        self.input_fraction = max(1, self.depth_fraction)
        self.word_bits = self.xy_bits + self.input_fraction
        self.one_word = 1 << (self.word_bits - 2)
        self.needed_bits = self.word_bits + self.coefficient_bits + 3
        self.dropped_bits = max(0, self.needed_bits - self.accumulator_bits)
        self.depth_guard = 6 if self.z_bits <= 20 else 26 - self.z_bits
        self.z_bytes = 2 if self.z_bits <= 16 else 4
        self.one_texel = 1 << self.fraction_bits

    def rounding(self, name):
        return ROUNDINGS[getattr(self, name + "_rounding")]

    @property
    def round_depth(self):
        return ROUNDINGS[self.depth_rounding]

    def quantum_px(self):
        return Fraction(1, 2) ** self.depth_fraction
