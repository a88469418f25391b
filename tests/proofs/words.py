"""Reads words.txt: stages of whole-number arithmetic whose every step must fit its word.

A stage becomes an SMT-LIB problem that has a solution only if some step leaves its word. A product
of two unknowns is a number of its own, of which only the four linear bounds are told that follow
from its factors' ranges (McCormick 1976; products.smt2 proves them), so that the problem stays
linear. The same expressions become C++, which agree.cpp compares with the code.
"""
import ast
import re


class Node:
    def __init__(self, smt, low, high, cpp):
        self.smt, self.low, self.high, self.cpp = smt, low, high, cpp


class Stage:
    def __init__(self, name, what, facts):
        self.name, self.what, self.facts = name, what, dict(facts)
        self.lines, self.names, self.bad, self.word = [], {}, [], 64
        self.inputs, self.compared, self.cpp_lines, self.count = [], [], [], 0

    def constant(self, text):
        tree = ast.parse(text.strip(), mode="eval")
        node = self.visit(tree.body, False)
        if node.low != node.high:
            raise ValueError(f"{self.name}: {text} is no constant")
        return node.low

    def fresh(self, smt, low, high, cpp, checked):
        """Names a step; it must fit the stage's word."""
        name = f"t{self.count}"
        self.count += 1
        self.lines.append(f"(define-fun {name} () Int {smt})")
        if checked:
            self.must_fit(name)
        self.cpp_lines.append(f"    [[maybe_unused]] const Wide {name} = {cpp};")
        return Node(name, low, high, name)

    def must_fit(self, name):
        half = 2 ** (self.word - 1)
        self.bad.append(f"(or (< {name} {number(-half)}) (> {name} {number(half - 1)}))")

    def product(self, a, b, checked):
        name = f"p{self.count}"
        self.count += 1
        self.lines.append(f"(declare-const {name} Int)")
        al, ah, bl, bh = (number(v) for v in (a.low, a.high, b.low, b.high))
        x, y = a.smt, b.smt
        for sign, s, t in ((">=", al, bl), (">=", ah, bh), ("<=", ah, bl), ("<=", al, bh)):
            self.lines.append(f"(assert ({sign} {name} (- (+ (* {s} {y}) (* {t} {x})) "
                              f"(* {s} {t}))))")
        if checked:
            self.must_fit(name)
        corners = [p * q for p in (a.low, a.high) for q in (b.low, b.high)]
        self.cpp_lines.append(f"    [[maybe_unused]] const Wide {name} = {a.cpp} * {b.cpp};")
        return Node(name, min(corners), max(corners), name)

    def visit(self, t, checked=True):
        if isinstance(t, ast.Constant):
            return Node(number(t.value), t.value, t.value, wide(t.value))
        if isinstance(t, ast.Name):
            if t.id in self.names:
                return self.names[t.id]
            if t.id not in self.facts:
                raise ValueError(f"{self.name}: what is {t.id}?")
            v = self.facts[t.id]
            return Node(number(v), v, v, wide(v))
        if isinstance(t, ast.UnaryOp) and isinstance(t.op, ast.USub):
            a = self.visit(t.operand, checked)
            if a.low == a.high:
                return Node(number(-a.low), -a.low, -a.low, wide(-a.low))
            return self.fresh(f"(- {a.smt})", -a.high, -a.low, f"-{a.cpp}", checked)
        if isinstance(t, ast.Call):
            return self.call(t.func.id, [self.visit(a, checked) for a in t.args], checked)
        a, b = self.visit(t.left, checked), self.visit(t.right, checked)
        if isinstance(t.op, ast.Pow):
            return Node(number(a.low ** b.low), a.low ** b.low, a.low ** b.low,
                        wide(a.low ** b.low))
        if a.low == a.high and b.low == b.high:
            v = {ast.Add: a.low + b.low, ast.Sub: a.low - b.low, ast.Mult: a.low * b.low}.get(
                type(t.op), a.low // b.low if b.low else None)
            return Node(number(v), v, v, wide(v))
        if isinstance(t.op, ast.Add):
            return self.fresh(f"(+ {a.smt} {b.smt})", a.low + b.low, a.high + b.high,
                              f"{a.cpp} + {b.cpp}", checked)
        if isinstance(t.op, ast.Sub):
            return self.fresh(f"(- {a.smt} {b.smt})", a.low - b.high, a.high - b.low,
                              f"{a.cpp} - {b.cpp}", checked)
        if isinstance(t.op, ast.Mult):
            if a.low == a.high or b.low == b.high:
                corners = [p * q for p in (a.low, a.high) for q in (b.low, b.high)]
                return self.fresh(f"(* {a.smt} {b.smt})", min(corners), max(corners),
                                  f"{a.cpp} * {b.cpp}", checked)
            return self.product(a, b, checked)
        if isinstance(t.op, ast.FloorDiv) and b.low == b.high > 0:
            return self.fresh(f"(div {a.smt} {b.smt})", a.low // b.low, a.high // b.low,
                              f"floor_divide({a.cpp}, {b.cpp})", checked)
        raise ValueError(f"{self.name}: {ast.dump(t)}")

    def call(self, name, a, checked):
        if name == "abs":
            x = a[0]
            return self.fresh(f"(ite (< {x.smt} 0) (- {x.smt}) {x.smt})", 0,
                              max(-x.low, x.high), f"({x.cpp} < 0 ? -{x.cpp} : {x.cpp})", checked)
        if name == "half_up":  # floor((x + 2^(n-1)) / 2^n)
            n = a[1].low
            up = self.fresh(f"(+ {a[0].smt} {2 ** (n - 1)})", a[0].low + 2 ** (n - 1),
                            a[0].high + 2 ** (n - 1), f"{a[0].cpp} + {wide(2 ** (n - 1))}", checked)
            return self.fresh(f"(div {up.smt} {2 ** n})", up.low // 2 ** n, up.high // 2 ** n,
                              f"floor_divide({up.cpp}, {wide(2 ** n)})", checked)
        if name in ("min", "max"):
            out = a[0]
            for x in a[1:]:
                low, high = (f(out.low, x.low) for f in (min, max)), None
                pick = min if name == "min" else max
                sign = "<" if name == "min" else ">"
                out = self.fresh(f"(ite ({sign} {x.smt} {out.smt}) {x.smt} {out.smt})",
                                 pick(out.low, x.low), pick(out.high, x.high),
                                 f"({x.cpp} {sign} {out.cpp} ? {x.cpp} : {out.cpp})", checked)
            return out
        raise ValueError(f"{self.name}: what is {name}()?")

    def condition(self, text, checked=False):
        tree = ast.parse(text.strip(), mode="eval").body
        signs = {ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "="}
        parts, left = [], self.visit(tree.left, checked)
        for op, right in zip(tree.ops, tree.comparators):
            right = self.visit(right, checked)
            parts.append(f"({signs[type(op)]} {left.smt} {right.smt})")
            left = right
        return f"(and {' '.join(parts)})"

    def smt(self):
        return "\n".join(self.lines + [f"(assert (or {' '.join(self.bad)}))"])


def number(v):
    return str(v) if v >= 0 else f"(- {-v})"


def wide(v):
    if -(2 ** 63) < v < 2 ** 63:
        return f"Wide{{{v}}}"
    high, low = divmod(abs(v), 2 ** 62)
    return f"({'-' if v < 0 else ''}((Wide{{{high}}} << 62) + Wide{{{low}}}))"


def one_stage(stage, lines):
    for line in lines:
        word, _, rest = line.partition(" ")
        if word == "in":
            names, _, bounds = rest.partition(":")
            low, _, high = bounds.partition(" .. ")
            low, high = stage.constant(low), stage.constant(high)
            for n in names.split():
                stage.lines.append(f"(declare-const {n} Int)")
                stage.lines.append(f"(assert (and (<= {number(low)} {n}) (<= {n} "
                                   f"{number(high)})))")
                stage.names[n] = Node(n, low, high, n)
                stage.inputs.append((n, low, high))
        elif word == "word":
            stage.word = stage.constant(rest)
        elif word == "assume":
            stage.lines.append(f"(assert {stage.condition(rest)})")
        elif word == "show":
            stage.bad.append(f"(not {stage.condition(rest)})")
        elif word == "constant":
            name, _, text = rest.partition(" = ")
            stage.facts[name.strip()] = stage.constant(text)
        elif word == "let":
            name, _, text = rest.partition(" = ")
            stage.names[name.strip()] = stage.visit(ast.parse(text.strip(), mode="eval").body)
        elif word == "compare":
            stage.compared += rest.split()
        else:
            raise ValueError(f"{stage.name}: {line}")
    return stage


def read(text, facts):
    """Stages of words.txt, one for each value of its `each`."""
    stages, head, lines = [], None, []

    def finish():
        if head is None:
            return
        name, _, what = head.partition(": ")
        loops = [l for l in lines if l.startswith("each ")]
        rest = [l for l in lines if not l.startswith("each ")]
        ranges = [{}]
        for l in loops:
            variable, low, high = re.fullmatch(r"each (\w+): (.*) \.\. (.*)", l).groups()
            grown = []
            for r in ranges:
                probe = Stage(name, what, {**facts, **r})
                grown += [{**r, variable: v}
                          for v in range(probe.constant(low), probe.constant(high) + 1)]
            ranges = grown
        for r in ranges:
            stages.append(one_stage(Stage(name, what, {**facts, **r}), rest))

    for line in text.splitlines():
        line = line.split("#")[0].rstrip()
        if not line.strip():
            continue
        if line.startswith("stage "):
            finish()
            head, lines = line[6:], []
        else:
            lines.append(line.strip())
    finish()
    return stages


def cpp(stages):
    """The compared steps as C++ functions of a stage's inputs, with the inputs' ranges."""
    out = []
    seen = set()
    for s in stages:
        if not s.compared or s.name in seen:
            continue
        seen.add(s.name)
        out.append(f"struct {s.name} {{")
        out.append(f"    static constexpr int inputs = {len(s.inputs)};")
        bounds = ", ".join(f"{{{wide(l)}, {wide(h)}}}" for _, l, h in s.inputs)
        out.append(f"    static constexpr Range range[] = {{{bounds}}};")
        out.append("    static std::vector<Wide> model(const Wide* in) {")
        for k, (n, _, _) in enumerate(s.inputs):
            out.append(f"        [[maybe_unused]] const Wide {n} = in[{k}];")
        out += ["    " + l for l in s.cpp_lines]
        out.append(f"        return {{{', '.join(s.names[c].cpp for c in s.compared)}}};")
        out.append("    }\n};")
    return "\n".join(out)
