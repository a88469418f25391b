#!/usr/bin/env python3
"""A second, independent implementation of the machine.

It was written from hw/MACHINE.md and the files of hw/machine, not from the code: what figures 1 to
6 need by someone who had not seen the project's code, to find out whether the text suffices; the
rest (sections 12, 14, 18, other widths and settings) by the text's author, and sections 21 and 22
again from the text alone.  It computes the worked examples of the text, the vectors of vectors/,
and the buffers of the figures and of the variants, whose hashes it compares with those that section
15 lists.
Its modules are the document's sections, beside which they should be read: stages/.

    python3 machine.py [--machine PATH] [--all] [--only NAME]... [--jobs N] [--buffers DIR]

prints the name and hash of each buffer and exits with 1 if one differs.  Without --all the variants
of more than 128 x 128 pixels are left out, and it takes a minute or two.
"""
import argparse
import multiprocessing
import pathlib
import re
import sys

from stages import examples
from stages.figures import Frame, figure_frames, variants
from stages.notation import published_hash, to_bytes
from stages.settings import HW, document, table
from stages.vectors import STAGES, check

SMALL = 128 * 128


def figures(_):
    results = []
    for name, frame, buffer in figure_frames():
        results.append(("", name, *hashed(frame, buffer)))
        if name == "light_z":  # both views are drawn
            results += [(None, row, None, None) for row in frame.block_counts("figures")]
    return results


def variant(job):
    name, arguments, buffers = job
    frame = Frame(*arguments)
    results = [(name, buffer, *hashed(frame, buffer)) for buffer in buffers]
    return results + [(None, row, None, None) for row in frame.block_counts("variant " + name)]


def hashed(frame, buffer):
    values, size = getattr(frame, buffer), frame.bytes_a_value(buffer)
    return published_hash(values, size, frame.s.size_px), to_bytes(values, size)


def run(job):
    return figures(job) if job is None else variant(job)


def vectors(text):
    """The vectors, and the worked examples of the text."""
    count, missing = examples.check(text)
    print(f"examples: {count} in the text" if not missing else
          "\n".join(f"examples: not in the text: {example}" for example in missing))
    good = not missing
    for stage in STAGES:
        count, message = check(stage)
        good = good and message is None
        print(f"{stage}: {message or f'{count} vectors'}", flush=True)
    return good


def published(text):
    """(variant or "", buffer) to hash"""
    # The figures' rows have three columns before the buffer's name, the variants' one.
    row = r"^\|[^|]*\|[^|]*\|[^|]*\| (\w+) \| `(\w+:\d+x\d+:fnv1a64:[0-9a-f]{16})` \|"
    found = {("", name): h for name, h in re.findall(row, text, re.MULTILINE)}
    for name, buffer, h in table(text, "| variant | buffer | hash |"):
        found[name, buffer] = h.strip("`")
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--machine", type=pathlib.Path, help="hw/MACHINE.md",
                        default=HW / "MACHINE.md")
    parser.add_argument("--all", action="store_true", help="the large variants, too")
    parser.add_argument("--only", action="append", metavar="NAME",
                        help="`vectors`, `figures` or a variant, and no others")
    parser.add_argument("--jobs", type=int, default=multiprocessing.cpu_count())
    parser.add_argument("--buffers", type=pathlib.Path, help="write the buffers into this folder")
    options = parser.parse_args()
    text = document(options.machine)
    listed = published(text)
    jobs = [None] if not options.only or "figures" in options.only else []
    left_out = {key for key in listed if not jobs and not key[0]}
    for name, arguments, buffers, pixels in variants(text):
        wanted = name in options.only if options.only else options.all or pixels <= SMALL
        if wanted:
            jobs.append((name, arguments, buffers))
        else:
            left_out |= {key for key in listed if key[0] == name}
    good = bool(options.only and "vectors" not in options.only) or vectors(text)
    with multiprocessing.Pool(options.jobs) as pool:
        for result in pool.imap(run, jobs, 1):
            for name, buffer, found, data in result:
                if name is None:  # a row of section 6's table, if it has one of that name
                    if buffer.split(" | ")[0] in text:
                        good = good and buffer in text
                        print(buffer + ("" if buffer in text else "  DIFFERS"))
                    continue
                same = found == listed.pop((name, buffer), None)
                good = good and same
                row = f"| {name} | {buffer} | `{found}` |" if name else f"{buffer} {found}"
                print(row + ("" if same else "  DIFFERS"), flush=True)
                if options.buffers:
                    options.buffers.mkdir(parents=True, exist_ok=True)
                    path = options.buffers / f"{name}{buffer}.{found.split(':')[0]}"
                    path.write_bytes(data)
    missing = set(listed) - left_out
    for key in sorted(missing):
        print(" ".join(key), "is not computed here")
    if left_out and not options.only:
        print(f"{len(left_out)} hashes of large variants were left out (--all)")
    return 0 if good and not missing else 1


if __name__ == "__main__":
    sys.exit(main())
