"""Turns the models of smt/*.smt2 and words.txt into C++, which agree.cpp compares with the code.

    models.py FACTS OUT

FACTS are lines "name value" that umbra78_proof_facts prints. Of an SMT-LIB file the functions are
taken that its line "; compare: NAME ..." names, and those that they use. Bit vectors of up to 128
bits become unsigned words that are cut to their width, whole numbers become 128-bit words.
"""
import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True
HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import words  # noqa: E402


def parse(text):
    """S-expressions as lists and strings."""
    text = re.sub(r";.*", "", text)
    tokens = re.findall(r"[()]|[^\s()]+", text)
    stack = [[]]
    for t in tokens:
        if t == "(":
            stack.append([])
        elif t == ")":
            done = stack.pop()
            stack[-1].append(done)
        else:
            stack[-1].append(t)
    return stack[0]


def sort_of(s):
    return s if isinstance(s, str) else int(s[2])


SIMPLE = {"bvadd": "+", "bvsub": "-", "bvmul": "*", "bvor": "|", "bvand": "&", "bvxor": "^"}
UNSIGNED = {"bvult": "<", "bvule": "<=", "bvugt": ">", "bvuge": ">="}
SIGNED = {"bvslt": "<", "bvsle": "<=", "bvsgt": ">", "bvsge": ">="}
WHOLE = {"<": "<", "<=": "<=", ">": ">", ">=": ">="}


class Functions:
    def __init__(self, text):
        self.defined = {f[1]: f for f in parse(text) if f[0] == "define-fun"}
        self.done, self.out, self.lets = set(), [], 0

    def take(self, name):
        if name in self.done:
            return
        self.done.add(name)
        _, _, params, result, body = self.defined[name]
        scope = {p: (f"{p}_", sort_of(s)) for p, s in params}
        lines = []
        value, sort = self.expression(body, scope, lines)
        args = ", ".join(f"{cpp_type(sort_of(s))} {p}_" for p, s in params)
        text = [f"inline {cpp_type(sort)} {name}({args}) {{"]
        text += ["    " + l for l in lines] + [f"    return {value};", "}"]
        self.out.append("\n".join(text))

    def expression(self, e, scope, lines):
        """A C++ expression and its sort; what `let` names goes to `lines`."""
        if isinstance(e, str):
            if e in scope:
                return scope[e]
            if e.startswith("#x"):
                return f"word(0x{e[2:18]}, 0x{e[18:] or '0'}, {len(e) - 2})", 4 * (len(e) - 2)
            if e.startswith("#b"):
                return f"Bits{{{int(e[2:], 2)}}}", len(e) - 2
            if e in ("true", "false"):
                return e, "Bool"
            if re.fullmatch(r"\d+", e):
                return words.wide(int(e)), "Int"
            self.take(e)
            return f"{e}()", sort_of(self.defined[e][3])
        if e[0] == "_":  # (_ bv1 80)
            return f"Bits{{{e[1][2:]}}}", int(e[2])
        if e[0] == "let":
            inner = dict(scope)
            for name, value in e[1]:
                v, sort = self.expression(value, scope, lines)
                self.lets += 1
                lines.append(f"const {cpp_type(sort)} {name}_{self.lets} = {v};")
                inner[name] = (f"{name}_{self.lets}", sort)
            return self.expression(e[2], inner, lines)
        if isinstance(e[0], list):
            a, sort = self.expression(e[1], scope, lines)
            if e[0][1] == "extract":
                high, low = int(e[0][2]), int(e[0][3])
                return f"cut({a} >> {low}, {high - low + 1})", high - low + 1
            grown = sort + int(e[0][2])
            if e[0][1] == "zero_extend":
                return a, grown
            return f"cut(Bits(as_signed({a}, {sort})), {grown})", grown
        args = [self.expression(x, scope, lines) for x in e[1:]]
        return self.operator(e[0], [v for v, _ in args], args[0][1], [s for _, s in args])

    def operator(self, op, a, sort, sorts):
        if op in SIMPLE:
            return f"cut({f' {SIMPLE[op]} '.join(a)}, {sort})", sort
        if op == "bvneg":
            return f"cut(-{a[0]}, {sort})", sort
        if op in UNSIGNED:
            return f"({a[0]} {UNSIGNED[op]} {a[1]})", "Bool"
        if op in SIGNED:
            return (f"(as_signed({a[0]}, {sort}) {SIGNED[op]} as_signed({a[1]}, {sort}))", "Bool")
        if op in ("bvshl", "bvlshr", "bvashr"):
            return f"{op}({a[0]}, {a[1]}, {sort})", sort
        if op == "ite":
            return f"({a[0]} ? {a[1]} : {a[2]})", sorts[1]
        if op in ("and", "or"):
            return "(" + (" && " if op == "and" else " || ").join(a) + ")", "Bool"
        if op == "not":
            return f"!{a[0]}", "Bool"
        if op == "=":
            return f"({a[0]} == {a[1]})", "Bool"
        if op in WHOLE:
            return f"({a[0]} {WHOLE[op]} {a[1]})", "Bool"
        if op == "-" and len(a) == 1:
            return f"(-{a[0]})", "Int"
        if op in "+-*":
            return "(" + f" {op} ".join(a) + ")", "Int"
        if op == "mod":
            return f"floor_modulo({a[0]}, {a[1]})", "Int"
        if op == "div":
            return f"floor_divide({a[0]}, {a[1]})", "Int"
        self.take(op)
        return f"{op}({', '.join(a)})", sort_of(self.defined[op][3])


def cpp_type(sort):
    return {"Bool": "bool", "Int": "Wide"}.get(sort, "Bits")


# Constants that only a source file knows.
IN_SOURCES = {"raster_bits": "raster/draw.cpp", "farthest_centre": "raster/projection.cpp"}


def read_facts(path):
    facts = {k: int(v) for k, v in (l.split() for l in Path(path).read_text().splitlines())}
    for name, file in IN_SOURCES.items():
        source = (HERE.parents[1] / file).read_text()
        expression = re.search(rf"^constexpr \S+ {name} = ([\d <]+);", source, re.M).group(1)
        facts[name] = eval(expression)
    return facts


def text(facts):
    out = ["// Made by tests/proofs/models.py of smt/*.smt2 and words.txt.", "#pragma once", "",
           '#include "tests/proofs/model.hpp"', "", "namespace umbra78::proofs {"]
    for path in sorted((HERE / "smt").glob("*.smt2")):
        source = path.read_text()
        wanted = re.findall(r"^; compare: (.*)$", source, re.M)
        functions = Functions(fill(source, facts))
        for name in " ".join(wanted).split():
            functions.take(name)
        if functions.out:
            out += [f"namespace {path.stem} {{", *functions.out, "}", ""]
    out += ["namespace stages {", words.cpp(words.read((HERE / "words.txt").read_text(), facts)),
            "}", "}"]
    return "\n".join(out) + "\n"


def fill(source, facts):
    """Constants of the headers, written {name} in a model."""
    return re.sub(r"\{(\w+)\}", lambda m: str(facts[m.group(1)]), source)


if __name__ == "__main__":
    Path(sys.argv[2]).write_text(text(read_facts(sys.argv[1])))
