#!/usr/bin/env python3
"""Asks gappa, z3 and cvc5 for the proofs, runs the programs beside them, writes tests/PROOFS.md.

    proofs.py --program umbra78_proofs --facts FILE [--weakened] [--table] [NAME ...]

NAME is a file of smt/ or gappa/ without its ending, a stage of words.txt, or a program: agree,
exhaustive, forms, errors. --weakened: each claim with its planted weakening must fail. A solver
that is not installed is left out, with a line.
"""
import argparse
import json
import math
import os
import re
import shutil
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from pathlib import Path

sys.dont_write_bytecode = True
HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import models  # noqa: E402
import words  # noqa: E402

# Seconds on a quiet machine; with these limits a busy one still gets an answer.
SOLVERS = {"z3": ["z3", "-in", "-T:600"],
           "cvc5": ["cvc5", "--incremental", "--tlimit-per=100000"]}
PROGRAMS = ["agree", "exhaustive", "forms", "errors"]
failures = []
facts = {}
told = {}  # (file, claim) -> who proved it
said = threading.local()  # the lines of the task that a thread is at


def line(text):
    said.lines.append(text)


def say(name, ok, text):
    line(f"{'proved' if ok else 'FAILED'}: {name}: {text}")
    if not ok:
        failures.append(name)


def run_all(tasks):
    """Several tasks at a time; their lines come in their order."""
    def run(task):
        said.lines = []
        task()
        return said.lines
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for lines in pool.map(run, tasks):
            print("\n".join(lines), flush=True)


def ask(solver, text):
    """The answers of a solver, one for each check-sat."""
    done = subprocess.run(SOLVERS[solver], input=text, capture_output=True, text=True)
    if "error" in done.stdout or (done.stderr and "interrupted" not in done.stderr):
        sys.exit(f"{solver}: {done.stdout[:300]}{done.stderr[:300]}")
    return re.findall(r"^(?:un)?sat$|^unknown$|^timeout$", done.stdout, re.M)


def present():
    return [s for s in SOLVERS if shutil.which(s)]


def ask_all(text):
    """What each solver answers; they work side by side."""
    with ThreadPoolExecutor(len(SOLVERS)) as pool:
        return dict(zip(present(), pool.map(lambda s: ask(s, text), present())))


# --- SMT-LIB files -------------------------------------------------------------------------------


def claims_of(text):
    """What stands before the first claim, and each claim: its words, its weakening, its lines."""
    parts = re.split(r"^(?=; claim: )", text, flags=re.M)
    out = []
    for part in parts[1:]:
        head = re.match(r"(?:;.*\n)+", part).group(0)
        title = " ".join(l.lstrip("; ") for l in head.splitlines() if "; weaken: " not in l)
        weaken = re.search(r"^; weaken: (.*) => (.*)$", head, re.M)
        out.append((title.removeprefix("claim: "), weaken and weaken.groups(), part))
    return parts[0], out


def smt_file(path, facts, weakened):
    preamble, claims = claims_of(models.fill(path.read_text(), facts))
    since = time.time()
    by = {}
    if weakened:
        for title, weaken, part in claims:
            name = f"{path.stem}: {title}"
            if weaken is None:
                say(name, False, "has no weakening")
                continue
            old, new = weaken
            body = re.sub(r"^; weaken: .*$", "", part, flags=re.M)
            text = preamble + body.replace(old, new) if old in body else (
                preamble.replace(old, new) + body)
            if old not in preamble + body:
                say(name, False, f"'{old}' stands nowhere")
                continue
            answers = [a for all_ in ask_all(text).values() for a in all_]
            say(name, "sat" in answers, "weakened, it fails" if "sat" in answers else
                f"weakened, it still answers {answers}")
        return
    text = preamble + "".join(p for _, _, p in claims)
    for solver, answers in ask_all(text).items():
        answers += ["unknown"] * (len(claims) - len(answers))
        for (title, _, _), answer in zip(claims, answers):
            by.setdefault(title, {})[solver] = answer
    for title, answers in by.items():
        proved = [s for s, a in answers.items() if a == "unsat"]
        ok = bool(proved) and "sat" not in answers.values()
        told[(path.stem, title)] = proved
        say(f"{path.stem}: {title}", ok, " and ".join(proved) if ok else str(answers))
    line(f"{path.stem}: {time.time() - since:.1f} s")


# --- words.txt -----------------------------------------------------------------------------------


def word_stages(facts, names):
    """The stages that are wanted, each with all its steps."""
    by_name = {}
    for s in words.read((HERE / "words.txt").read_text(), facts):
        if not names or s.name in names or "words" in names:
            by_name.setdefault(s.name, []).append(s)
    return by_name


def word_stage(name, all_):
    proved = []
    text = "(set-logic ALL)\n" + "".join(
        f"(push)\n{s.smt()}\n(check-sat)\n(pop)\n" for s in all_)
    for solver, answers in ask_all(text).items():
        if "sat" in answers:
            proved = []
            break
        if answers == ["unsat"] * len(all_):
            proved.append(solver)
    told[("words", name)] = (proved, all_[0].what)
    say(f"words: {name}", bool(proved), " and ".join(proved) or "a step leaves its word")


def weaken_words(name, all_):
    """With words a bit shorter than the least that do, the same stage fails."""
    solver = present()[0]
    for s in all_[-1:]:
        for less in range(0, 200):
            bad = [re.sub(r"(\(or \(< \w+ )(\(- \d+\))(\) \(> \w+ )(\d+)\)\)",
                          lambda m: shorter(m, less), b) for b in s.bad]
            text = "(set-logic ALL)\n" + "\n".join(s.lines) + f"\n(assert (or {' '.join(bad)}))"
            if ask(solver, text + "\n(check-sat)\n") == ["sat"]:
                say(f"words: {name}", less > 0, f"with words {less} bits shorter it fails")
                return
    say(f"words: {name}", False, "no weakening makes it fail")


def shorter(match, less):
    half = (int(match.group(4)) + 1) >> less
    return f"{match.group(1)}{words.number(-half)}{match.group(3)}{words.number(half - 1)}))"


# --- gappa ---------------------------------------------------------------------------------------


def leaf(k):
    """After k halvings in u and v: from and to which error the newest corner has, an older one, and
    a correction. In v all four values are rows that the halvings in u made."""
    low = high = old_low = old_high = g_low = g_high = Fraction(0)
    for i in range(1, k + 1):
        low, high, old_low, old_high = ((low + old_low) / 2 - g_high,
                                        Fraction(1, 2) + (high + old_high) / 2 - g_low,
                                        min(low, old_low), max(high, old_high))
        g_low, g_high = g_low / 4 - Fraction(3, 8), g_high / 4 + Fraction(1, 2)
        if i == 4:
            after_u = min(low, old_low), max(high, old_high)
            if k > 4:
                low, high = old_low, old_high = g_low, g_high = after_u
    if k == 4:
        return after_u * 3
    return low, high, old_low, old_high, g_low, g_high


def deepest():
    """The greatest error of a leaf's corner after as many halvings as a block may have: each adds 2
    to what halving_step.smt2 adds up."""
    return 2 * 2 * (facts["deepest_level"] + facts["leaf_levels"])


def squares(k):
    """Of a cosine squared k times: each rounding by half a unit, doubled by each later square."""
    return Fraction(2 ** k - 1, 2)


def rounded_out(v):
    """Exact where the decimals end, else ten digits, away from zero; a quotient by a bit more, for
    it was rounded before."""
    if isinstance(v, float) and Fraction(v).denominator > 1 << 24:
        v = Fraction(math.ceil(v * 10 ** 10) + 1, 10 ** 10)
    v = Fraction(v)
    rest = v.denominator
    while rest % 2 == 0:
        rest //= 2
    digits = v.denominator.bit_length() if rest == 1 else 10
    scaled = math.ceil(abs(v) * 10 ** digits)
    text = f"{scaled // 10 ** digits}.{scaled % 10 ** digits:0{digits}d}".rstrip("0").rstrip(".")
    return text if v >= 0 else "-" + text


def render(text, variables):
    scope = {**variables, "deepest": deepest, "facts": facts, "leaf": leaf, "squares": squares,
             "max": max}
    text = text.replace("{{", "\1").replace("}}", "\2")

    def value(m):
        try:
            return rounded_out(eval(m.group(1), {}, scope))
        except (SyntaxError, NameError):
            return m.group(0)  # a brace of Gappa's own
    return re.sub(r"\{([^{}\n]+)\}", value, text).replace("\1", "{").replace("\2", "}")


def gappa_proves(text):
    done = subprocess.run(["gappa"], input=text, capture_output=True, text=True)
    if "syntax error" in done.stderr:
        sys.exit(f"gappa: {done.stderr}\n{text}")
    return done.returncode == 0


def instances(path):
    """A file's problems, one for each value of its variable, and what their first lines tell."""
    text = path.read_text()
    each = re.search(r"^# each: (\w+) (-?\d+) \.\. (-?\d+)$", text, re.M)
    values = [{}]
    if each:
        values = [{each[1]: v} for v in range(int(each[2]), int(each[3]) + 1)]
    for v in values:
        problem = render(text, v)
        yield problem, {k: x.strip() for k, x in re.findall(r"^# (\w+): (.*)$", problem, re.M)}


def gappa_bounds(path, bounds):
    for _, field in instances(path):
        bounds[field["stage"]] = field


def gappa_file(path, weakened, bounds):
    for problem, field in instances(path):
        name = field["stage"]
        if weakened:
            old, new = re.search(r"^# weaken: (.*) => (.*)$", problem, re.M).groups()
            body = re.sub(r"^#.*$", "", problem, flags=re.M)
            ok = old in body and not gappa_proves(body.replace(old, new, 1))
            say(f"gappa: {name}", ok, "weakened, it fails" if ok else "weakened, it holds")
            continue
        bounds[name] = field
        say(f"gappa: {name}", gappa_proves(problem), f"error at most {field['bound']}")


# --- programs ------------------------------------------------------------------------------------


def program(name, path, bounds):
    since = time.time()
    done = subprocess.run([path, name], capture_output=True, text=True)
    errors = {}
    for each in done.stdout.splitlines():
        if each.startswith("error "):
            parts = each.split(" ")
            errors[parts[1]] = (float(parts[2]), parts[3] if len(parts) > 3 else "")
        else:
            line("  " + each)
    ok = done.returncode == 0
    for stage, (worst, inputs) in errors.items():
        if stage not in bounds:
            continue
        if worst > float(bounds[stage]["bound"]) + 1e-9:
            say(f"errors: {stage}", False, f"{worst} for {inputs} is more than "
                f"{bounds[stage]['bound']}")
    say(name, ok, f"{time.time() - since:.1f} s")
    return errors


def weakened_program(name, path):
    done = subprocess.run([path, name, "weakened"], capture_output=True, text=True)
    say(name, done.returncode == 1, "with a planted fault it fails: " +
        (done.stdout.splitlines() or ["nothing was said"])[0])


def bounds_tighter(path):
    """Bounds a fifth smaller would be broken by what was found."""
    bounds = {}
    for file in sorted((HERE / "gappa").glob("*.g")):
        gappa_bounds(file, bounds)
    broken = [s for s, (worst, _) in program("errors", path, {}).items()
              if s in bounds and worst > 0.8 * float(bounds[s]["bound"]) > 0]
    say("errors", len(broken) > 20, f"{len(broken)} bounds would be broken, were they a fifth less")


def remember(path, bounds, errors, as_table):
    """Keeps what was seen beside what earlier runs saw of other names; writes the page."""
    seen = json.loads(path.read_text()) if path.exists() else {}
    claims = seen.setdefault("claims", {})
    for file in {f for f, _ in told if f != "words"}:
        claims[file] = []
    for (file, title), proved in told.items():
        if file == "words":
            claims.setdefault("words", {})[title] = proved
        else:
            claims[file].append([title, proved])
    seen.setdefault("bounds", {}).update(bounds)
    seen.setdefault("errors", {}).update(errors)
    path.write_text(json.dumps(seen))
    if as_table:
        import table
        (HERE.parent / "PROOFS.md").write_text(table.text(seen))


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--facts", required=True)
    parser.add_argument("--weakened", action="store_true")
    parser.add_argument("--table", action="store_true")
    parser.add_argument("names", nargs="*")
    args = parser.parse_args()
    facts.update(models.read_facts(args.facts))
    wanted = lambda name: not args.names or name in args.names  # noqa: E731
    for s in [*SOLVERS, "gappa"]:
        if not shutil.which(s):
            print(f"left out: {s} is not installed; what it would prove is not asked of it")
    bounds, errors, tasks, found = {}, {}, [], []
    # The longest first; `errors` compares with all bounds, so it comes after them.
    for name in PROGRAMS[::-1]:
        if wanted(name) and name != "errors":
            tasks.append(lambda name=name: weakened_program(name, args.program) if args.weakened
                         else program(name, args.program, {}))
    if present():
        for path in sorted((HERE / "smt").glob("*.smt2")):
            if wanted(path.stem):
                tasks.append(lambda path=path: smt_file(path, facts, args.weakened))
        for name, steps in word_stages(facts, args.names).items():
            tasks.append(lambda name=name, steps=steps: weaken_words(name, steps) if args.weakened
                         else word_stage(name, steps))
    if shutil.which("gappa"):
        for path in sorted((HERE / "gappa").glob("*.g")):
            if wanted(path.stem) or "errors" in args.names:
                found.append({})
                tasks.append(lambda path=path, into=found[-1]:
                             gappa_file(path, args.weakened, into))
    run_all(tasks)
    for each in found:  # in the files' order
        bounds.update(each)
    if wanted("errors"):
        run_all([lambda: bounds_tighter(args.program) if args.weakened
                 else errors.update(program("errors", args.program, bounds))])
    if not args.weakened:
        remember(Path(args.facts).with_name("seen.json"), bounds, errors, args.table)
    if failures:
        print(f"{len(failures)} failed: " + "; ".join(failures))
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
