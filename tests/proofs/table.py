"""The text of tests/PROOFS.md, of what proofs.py has seen."""
from pathlib import Path

HERE = Path(__file__).resolve().parent

HEAD = """# Proofs

What tests cannot enumerate is proved, and each proof is rerun by one command:
`tests/proofs/run [NAME]`, where NAME stands in the tables below; `--weakened` plants a weakening in
each claim, which must make it fail; `--table` writes this page. [z3](https://github.com/Z3Prover/z3),
[cvc5](https://cvc5.github.io) and [Gappa](https://gappa.gitlabpages.inria.fr) are installed where that
is allowed, and left out with a line where not.

A proof is about a model: a few functions in SMT-LIB, a stage of `words.txt`, or a script for Gappa. That
the model is the code is checked, too. The functions and stages are turned into C++
(`tests/proofs/models.py`) and compared with the production code by the program `agree`, on
boundary-weighted words; constants are read from the headers; and Gappa's bounds stand beside the
worst error that a search with the production code finds. A bound that were too small would be broken
by it, and one that is far too great shows in the last column.

| program | what it tries |
|---|---|
| agree | models against the code, half a million draws each |
| exhaustive | every rounding of 12-bit words, both dividers on all dividends of 10 bits and divisors of 7, \
and a whole transform, lookup and comparison with 8-bit coefficients and 16 codes, by the production \
templates |
| forms | rows of 16 pixels by every instruction set against pixel by pixel, for pairs of 8-bit \
coefficients; leaves on a 5 x 5 lattice in lanes against triangle by triangle; the reciprocal root of \
the shading for all its 2^29 arguments |
| errors | the worst errors in the last table |
"""


def wrapped(text):
    return text.replace("|", "\\|")


def text(told, bounds, errors):
    out = [HEAD, "## Claims of the solvers", "",
           "Primitives at their real width, the divider by its inductive step, accumulators of every "
           "machine that",
           "`check` accepts, and the forms that are linear enough. Words are bit vectors, quotients "
           "whole numbers.",
           "", "| file | claim | proved by |", "|---|---|---|"]
    for (file, title), proved in told.items():
        if file != "words":
            out.append(f"| {file} | {wrapped(title)} | {', '.join(proved)} |")
    out += ["", "## Words that hold their numbers", "",
            "Each step of these stages fits the word of its name, for all inputs that the checks let "
            "through.", "", "| stage | what | proved by |", "|---|---|---|"]
    for (file, name), proved in told.items():
        if file == "words":
            out.append(f"| {name} | {wrapped(proved[1])} | {', '.join(proved[0])} |")
    out += ["", "## Errors", "",
            "Bounds that Gappa proves, and the worst that `errors` finds, with its words. A ratio "
            "under 0.9 is explained", "below.", "",
            "| stage | unit | bound | worst found | ratio | at |", "|---|---|---|---|---|---|"]
    why = {}
    for stage, field in bounds.items():
        bound = float(field["bound"])
        if stage not in errors:
            out.append(f"| {stage} | {field['unit']} | {bound:.6g} | | | {field.get('seen', '')} |")
            continue
        worst, inputs = errors[stage]
        ratio = worst / bound if bound else 1.0
        if ratio < 0.9:
            why.setdefault(field.get("why", "NOT EXPLAINED"), []).append(stage)
        inputs = inputs.replace(",", " ")
        shown = inputs if len(inputs) < 70 else inputs[:67].rsplit(" ", 1)[0] + " ..."
        out.append(f"| {stage} | {field['unit']} | {bound:.6g} | {worst:.6g} | {ratio:.3f} | "
                   f"{shown} |")
    out += ["", "What each is:", ""]
    seen = set()
    for stage, field in bounds.items():
        family = stage.rstrip("-0123456789").rstrip("_")
        if family not in seen:
            seen.add(family)
            out.append(f"- {family}: {field['what']}")
    out += ["", "Where the ratio is under 0.9:", ""]
    for reason, stages in why.items():
        first, last = stages[0], stages[-1]
        out.append(f"- {first}{' to ' + last if first != last else ''}: {reason}")
    return "\n".join(out) + "\n"
