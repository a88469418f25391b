"""The text of tests/PROOFS.md, of what proofs.py has seen."""
import textwrap

HEAD = """# Proofs

What tests cannot enumerate is proved, and each proof is rerun by one command:
`tests/proofs/run [NAME]`, where NAME stands below; `--weakened` plants a weakening in each claim,
which must make it fail; `--table` writes this page. The solvers
[z3](https://github.com/Z3Prover/z3), [cvc5](https://cvc5.github.io) and
[Gappa](https://gappa.gitlabpages.inria.fr) are installed where that is allowed, and left out with a
line where not.

A proof is about a model: a few functions in SMT-LIB, a stage of `words.txt`, or a script for
Gappa. That the model is the code is checked, too. The functions and stages are turned into C++
(`tests/proofs/models.py`) and compared with the production code by the program `agree`, on
boundary-weighted words; constants are read from the headers; and Gappa's bounds stand beside the
worst error that a search with the production code finds: a bound that is too small would be broken
by it, and one that is far too great shows in the ratio.

The programs beside the solvers:

- **agree**: models against the code, on half a million draws each.
- **exhaustive**: every rounding of 12-bit words; both dividers on all dividends of 10 bits and
  divisors of 7; a whole transform, lookup and comparison with pairs of 8-bit coefficients and 16
  codes. By the production templates, against definitions in whole quotients.
- **forms**: rows of 16 pixels by every instruction set against pixel by pixel, for pairs of 8-bit
  coefficients; leaves on a 5 x 5 lattice in lanes against triangle by triangle; the reciprocal root
  of the shading for all its 2^29 arguments, and the reciprocal of a quotient for all its 2^31.
- **errors**: the worst errors of the last section.
"""


def item(text):
    joined = text.replace(" - ", "\1-\1")  # no line begins with a minus, which would make a list
    return textwrap.fill(joined, 100, initial_indent="- ", subsequent_indent="  ",
                         break_long_words=False, break_on_hyphens=False).replace("\1", " ")


def rule(heading, *lines):
    return ["", f"## {heading}", "", *lines, ""]


def claims(seen):
    out = rule("Claims of the solvers",
               "Primitives at their real width, the divider by its inductive step, accumulators of",
               "every machine that `check` accepts, and the forms that are linear enough. Words",
               "are bit vectors, quotients whole numbers. In brackets who proved it.")
    for file in sorted(f for f in seen if f != "words"):
        for title, proved in seen[file]:
            out.append(item(f"**{file}**: {title} ({', '.join(proved)})"))
    out += rule("Words that hold their numbers",
                "Each step of these stages fits the word of its name, for all inputs that the",
                "checks let through. `--weakened` finds for each a word in which it does not.")
    for name, (proved, what) in seen["words"].items():
        out.append(item(f"**{name}**: {what} ({', '.join(proved)})"))
    return out


def family(stage):
    return stage.rstrip("-0123456789").rstrip("_")


def errors_table(bounds, errors):
    out = rule("Errors",
               "Bounds that Gappa proves, and the worst that `errors` finds by production code.")
    out += ["| stage | unit | bound | worst found | ratio |", "|---|---|---|---|---|"]
    why, at, seen = {}, [], {}
    for stage, field in bounds.items():
        bound, unit = float(field["bound"]), field["unit"].split(",")[0]
        seen.setdefault(family(stage), field["what"])
        if stage not in errors:
            out.append(f"| {stage} | {unit} | {bound:.6g} | {field['seen']} | |")
            continue
        worst, inputs = errors[stage]
        ratio = worst / bound if bound else 1.0
        if ratio < 0.9:
            why.setdefault(field.get("why", "NOT EXPLAINED"), []).append(stage)
        out.append(f"| {stage} | {unit} | {bound:.6g} | {worst:.6g} | {ratio:.3f} |")
        at.append(item(f"{stage}: {inputs.replace(',', ' ')}"))
    out += ["", "What each stage is:", ""]
    out += [item(f"**{name}**: {what}") for name, what in seen.items()]
    out += ["", "Where the ratio is under 0.9:", ""]
    for reason, stages in why.items():
        out.append(item(f"{', '.join(stages)}: {reason}"))
    return out + ["", "The words that give the worst:", ""] + at


def text(seen):
    parts = [HEAD.rstrip(), *claims(seen["claims"]), *errors_table(seen["bounds"], seen["errors"])]
    return "\n".join(parts) + "\n"
