"""The text of tests/MUTANTS.md, of the faults and their results."""
import textwrap

HEAD = """# Planted faults

`tests/mutation/run` plants the small faults of [faults.txt](mutation/faults.txt) in a copy of the
core, one at a time, and asks the tests that read the file; it goes on where it was stopped, and
`--table` writes this page. A fault is killed by a test that fails, or by the compiler: a
static_assert, or a constant that has no value. Where no behaviour changes the fault is not planted,
and the reason is given.
"""
KINDS = ["killed by a test", "killed by the compiler", "changes nothing", "alive", "not run"]


def kind_of(fault, result):
    if fault["equal"]:
        return "changes nothing"
    if result is None:
        return "not run"
    return {"killed": "killed by a test", "alive": "alive"}.get(result["found"],
                                                               "killed by the compiler")


def told(fault, result):
    """What killed it, or why it changes nothing."""
    if fault["equal"]:
        return fault["equal"]
    if result is None:
        return "not run"
    if result["found"] == "killed":
        return result["by"].removeprefix("tests/").removesuffix("_test.cpp")
    return result["found"]


def counts_table(faults, results):
    counts = {}
    for f, r in zip(faults, results):
        room = counts.setdefault(f["file"].split("/")[0], dict.fromkeys(KINDS, 0))
        room[kind_of(f, r)] += 1
    counts["all"] = {k: sum(c[k] for c in counts.values()) for k in KINDS}
    out = ["| room | " + " | ".join(KINDS) + " | all |", "|---|" + "---|" * 6]
    for room, c in counts.items():
        out.append(f"| {room} | {' | '.join(str(c[k]) for k in KINDS)} | {sum(c.values())} |")
    return out


def paragraph(text):
    return ["", *textwrap.wrap(text, 100, break_on_hyphens=False, break_long_words=False)]


def text(faults, result_of, files):
    results = [result_of(f) for f in faults]
    commits = {}
    for f, r in zip(faults, results):
        if r and not f["equal"]:
            commits[r["commit"]] = commits.get(r["commit"], 0) + 1
    run = ", ".join(f"{n} at commit {c}" for c, n in sorted(commits.items(), key=lambda x: x[1]))
    none = sorted(set(files) - {f["file"] for f in faults})
    out = [HEAD, *counts_table(faults, results),
           *paragraph(f"Planted: {run}; none of their files has changed since."),
           *paragraph(f"Nothing is planted in {len(none)} files. Most declare what other files "
                      f"define, or hold types and constants: {', '.join(none)}."),
           "", "Faults are numbered in the order of faults.txt, as `--only` takes them.", "",
           "| fault | file | killed by, or why it changes nothing |", "|---|---|---|"]
    out += [f"| {f['number']} | {f['file']} | {told(f, r)} |" for f, r in zip(faults, results)]
    return "\n".join(out) + "\n"
