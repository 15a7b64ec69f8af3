# SPDX-License-Identifier: MIT
"""Random statements and whole programs in Structured Text, with what they do in Python.

Run as a script with seeds it prints digests of the PLC's memory after each cycle.
"""

from __future__ import annotations

import hashlib
import json
import random
import sys
from collections.abc import Callable
from typing import Any

from nctakt.base.diagnostics import Severity
from nctakt.messages import Collector
from nctakt.plc.structured_text import StructuredPlc
from nctakt.st.inspection import inspect_texts
from nctakt.st.reporting import Reporter
from nctakt.st.sources import Sources
from support.st_programs import (
    BITS,
    CYCLES,
    ELEMENTS,
    INTS,
    REALS,
    TEXTS,
    Env,
    Expressions,
    Fault,
    Unit,
    cut,
    fresh,
    single,
)

Action = Callable[[Env], str]
ON, EXIT, CONTINUE = "", "EXIT", "CONTINUE"
DEPTH = 2


class Statements(Expressions):
    """Draws statements: a text, and a function that answers how the statement ends."""

    def block(self, depth: int, loops: int) -> tuple[str, Action]:
        """A few statements in order."""
        parts = [self.statement(depth, loops) for _ in range(self.draw.randint(1, 2))]

        def run(env: Env) -> str:
            for _, action in parts:
                end = action(env)
                if end:
                    return end
            return ON

        return "\n".join(text for text, _ in parts), run

    def statement(self, depth: int, loops: int) -> tuple[str, Action]:
        """A statement."""
        pick = self.draw.random()
        if depth <= 0 or pick < 0.5:
            return self.assignment()
        if loops and pick < 0.55:
            word = self.draw.choice((EXIT, CONTINUE))
            truth = self.truth(1)
            return (
                f"IF {truth.text} THEN {word}; END_IF",
                lambda env: word if truth.value(env) else ON,
            )
        makers = (self.branch, self.branch, self.case, self.counted, self.conditional)
        return self.draw.choice(makers)(depth - 1, loops)

    def assignment(self) -> tuple[str, Action]:
        """A value for a variable, an element or a bit."""
        pick = self.draw.random()
        if pick < 0.12 and "a" in self.unit.variables:
            return self.element_assignment()
        if pick < 0.2:
            return self.bit_assignment()
        name = self.draw.choice([one for one in self.unit.variables if self.is_free(one)])
        kind = self.unit.variables[name]
        if kind == "BOOL":
            part = self.truth(DEPTH)
        elif kind == "TEXT":
            part = self.text(DEPTH)
        elif kind in REALS:
            part = self.real(DEPTH)
        else:
            part = self.whole(DEPTH)
            if BITS[part.kind] > BITS[kind] or part.is_constant:
                part = self.fitted(part, kind)

        def run(env: Env) -> str:
            env[name] = stored(part.value(env), kind, name)
            return ON

        return f"{name} := {part.text};", run

    def is_free(self, name: str) -> bool:
        """Whether a variable may be assigned: no counter of a loop, not the array."""
        return not name.startswith("k") and name != "a"

    def element_assignment(self) -> tuple[str, Action]:
        """The index is evaluated before the value (ST-502)."""
        index, part = self.index(), self.fitted(self.whole(DEPTH), "DINT")
        sign = self.draw.choice((0, 0, 1, -1))

        def run(env: Env) -> str:
            number = index.value(env)
            if not 0 <= number < ELEMENTS:
                part.value(env)
                raise Fault(902266)
            before = env["a"][number]
            value = part.value(env)
            env["a"][number] = cut(before + sign * value, "DINT") if sign else value
            return ON

        element = f"a[{index.text}]"
        changed = f"{element} {'+' if sign > 0 else '-'} ({part.text})" if sign else part.text
        return f"{element} := {changed};", run

    def bit_assignment(self) -> tuple[str, Action]:
        """A bit of a whole number (ST-317)."""
        free = [one for one in self.names(*INTS) if self.is_free(one)]
        name, truth = self.draw.choice(free), self.truth(2)
        kind = self.unit.variables[name]
        bit = self.draw.randrange(BITS[kind])

        def run(env: Env) -> str:
            value, mask = truth.value(env), 1 << bit
            env[name] = cut(env[name] | mask if value else env[name] & ~mask, kind)
            return ON

        return f"{name}.{bit} := {truth.text};", run

    def branch(self, depth: int, loops: int) -> tuple[str, Action]:
        """``IF … ELSIF … ELSE``."""
        branches = [
            (self.truth(2), *self.block(depth, loops)) for _ in range(self.draw.randint(1, 3))
        ]
        last = self.block(depth, loops)
        words = ["IF", *["ELSIF"] * (len(branches) - 1)]
        text = "".join(
            f"{word} {truth.text} THEN\n{body}\n"
            for word, (truth, body, _) in zip(words, branches, strict=True)
        )

        def run(env: Env) -> str:
            for truth, _, action in branches:
                if truth.value(env):
                    return action(env)
            return last[1](env)

        return f"{text}ELSE\n{last[0]}\nEND_IF", run

    def case(self, depth: int, loops: int) -> tuple[str, Action]:
        """``CASE`` with single labels and ranges."""
        selector = self.fitted(self.whole(2), "INT")
        ranges, low = [], -40
        for _ in range(self.draw.randint(1, 3)):
            low += self.draw.randint(1, 20)
            high = low + self.draw.choice((0, 0, 5))
            ranges.append((low, high, *self.block(depth, loops)))
            low = high
        last = self.block(depth, loops)
        labels = "".join(
            f"{low}{f'..{high}' if high > low else ''}:\n{body}\n" for low, high, body, _ in ranges
        )

        def run(env: Env) -> str:
            number = selector.value(env)
            for low, high, _, action in ranges:
                if low <= number <= high:
                    return action(env)
            return last[1](env)

        return f"CASE {selector.text} OF\n{labels}ELSE\n{last[0]}\nEND_CASE", run

    def counted(self, depth: int, loops: int) -> tuple[str, Action]:
        """``FOR`` with bounds and a step that are evaluated once (ST-512)."""
        if loops >= 2:
            return self.assignment()
        counter, body = f"k{loops}", self.block(depth, loops + 1)
        first, last = self.draw.randint(-4, 4), self.draw.randint(-4, 6)
        step = self.draw.choice((1, 1, 2, -1, -3))

        def run(env: Env) -> str:
            env[counter] = first
            while env[counter] <= last if step > 0 else env[counter] >= last:
                end = body[1](env)
                if end == EXIT:
                    break
                env[counter] += step
            return ON

        return f"FOR {counter} := {first} TO {last} BY {step} DO\n{body[0]}\nEND_FOR", run

    def conditional(self, depth: int, loops: int) -> tuple[str, Action]:
        """``WHILE`` or ``REPEAT``, which a counter ends."""
        if loops >= 2:
            return self.assignment()
        counter, body, truth = f"k{loops}", self.block(depth, loops + 1), self.truth(2)
        is_while, count = self.draw.random() < 0.5, self.draw.randint(1, 5)

        def run(env: Env) -> str:
            env[counter] = 0
            while True:
                if is_while and not (env[counter] < count and truth.value(env)):
                    return ON
                env[counter] += 1
                end = body[1](env)
                if end == EXIT:
                    return ON
                if not is_while and (env[counter] >= count or truth.value(env)):
                    return ON

        if is_while:
            head = (
                f"WHILE {counter} < {count} AND_THEN {truth.text} DO\n{counter} := {counter} + 1;"
            )
            return f"{counter} := 0;\n{head}\n{body[0]}\nEND_WHILE", run
        tail = f"UNTIL {counter} >= {count} OR_ELSE {truth.text}"
        loop = f"REPEAT\n{counter} := {counter} + 1;\n{body[0]}\n{tail} END_REPEAT"
        return f"{counter} := 0;\n{loop}", run


def stored(value: Any, kind: str, name: str) -> Any:
    """A value as a variable of a type holds it."""
    if kind in BITS:
        return cut(value, kind)
    if kind == "REAL":
        return single(value)
    return value[: TEXTS[name]] if kind == "TEXT" else value


class Program:
    """A random program: two functions, and MAIN with variables of all types."""

    def __init__(self, seed: int) -> None:
        self.draws = Statements(random.Random(seed))
        functions = [self._function(number) for number in range(2)]
        self.draws.functions = functions
        self.main = Unit("MAIN")
        for kind in (*INTS, *REALS, "BOOL"):
            self.main.variables |= {f"{kind.lower()}{n}x": kind for n in range(2)}
        self.main.variables |= {name: "TEXT" for name in TEXTS} | {"a": "ARRAY"}
        self.main.variables |= {"k0": "INT", "k1": "INT"}
        self.draws.unit = self.main
        parts = [self.draws.statement(2, 0) for _ in range(8)]
        self._actions = [action for _, action in parts]
        declared = "".join(
            f"{name} : {shown(name, kind)};\n" for name, kind in self.main.variables.items()
        )
        body = "\n".join(text for text, _ in parts)
        self.text = "".join(one.text for one in functions)
        self.text += f"PROGRAM MAIN\nVAR\n{declared}END_VAR\n{body}\nEND_PROGRAM\n"

    def _function(self, number: int) -> Unit:
        draw = self.draws.draw
        unit = Unit(f"F_{number}", draw.choice(INTS))
        unit.parameters = ["p0", "p1"]
        unit.variables = {"p0": draw.choice(INTS), "p1": draw.choice(INTS), "x0": "LREAL"}
        unit.variables |= {"b0": "BOOL", "i0": "LINT", "u0": "USINT", "r0": "REAL", "k0": "INT"}
        unit.variables |= {"k1": "INT", "s0": "TEXT", unit.name: unit.kind}
        self.draws.unit = unit
        parts = [self.draws.statement(2, 0) for _ in range(4)]

        def run(env: Env) -> None:
            for _, action in parts:
                action(env)

        unit.run = run
        inputs = "".join(f"{one} : {unit.variables[one]}; " for one in unit.parameters)
        others = "".join(
            f"{name} : {shown(name, kind)}; "
            for name, kind in unit.variables.items()
            if name not in (*unit.parameters, unit.name)
        )
        body = "\n".join(text for text, _ in parts)
        unit.text = (
            f"FUNCTION {unit.name} : {unit.kind}\nVAR_INPUT {inputs}END_VAR\nVAR {others}END_VAR\n"
            f"{body}\nEND_FUNCTION\n"
        )
        return unit

    def expected(self) -> tuple[list[Env], int]:
        """The variables after each whole cycle, and the fault that stops the PLC."""
        env, found = fresh(self.main), []
        for _ in range(CYCLES):
            try:
                for action in self._actions:
                    action(env)
            except Fault as fault:
                return found, fault.args[0]
            found.append({name: list(v) if name == "a" else v for name, v in env.items()})
        return found, 0

    def values(self, plc: StructuredPlc) -> Env:
        """The variables of MAIN as they are now."""
        found: Env = {}
        for name, kind in self.main.variables.items():
            if kind == "ARRAY":
                found[name] = [plc.read(f"MAIN.{name}[{number}]") for number in range(ELEMENTS)]
            else:
                found[name] = plc.read(f"MAIN.{name}")
        return found

    def plc(self) -> StructuredPlc:
        """The PLC of its text; raises ``ValueError`` with what the check reports."""
        collector = Collector()
        program = inspect_texts(
            "random", {"random.st": self.text.encode()}, Reporter(Sources(), collector)
        )
        errors = [one for one in collector.diagnostics if one.severity is Severity.ERROR]
        if errors:
            raise ValueError(errors[0].render("en"))
        return StructuredPlc(program, [])


def shown(name: str, kind: str) -> str:
    """The type of a variable as it is declared."""
    if kind == "TEXT":
        return f"STRING({TEXTS[name]})"
    return f"ARRAY[0..{ELEMENTS - 1}] OF DINT" if kind == "ARRAY" else kind


def cycles(plc: StructuredPlc) -> list[tuple[bytes, int]]:
    """The memory after each cycle, and the fault."""
    translated = plc.translated
    context = plc.context
    context.begin(0)
    context.max_steps = 1_000_000
    translated.start.execute(context)
    found = []
    for number in range(CYCLES):
        context.begin(1_000_000 * number)
        translated.bodies["main"].execute(context)
        found.append((context.dump(), context.fault))
        if context.fault:
            break
    return found


def main() -> None:
    """Print the digests of the cycles of some seeds."""
    first, last = int(sys.argv[1]), int(sys.argv[2])
    table = {
        seed: [
            (hashlib.sha256(memory).hexdigest(), fault)
            for memory, fault in cycles(Program(seed).plc())
        ]
        for seed in range(first, last)
    }
    print(json.dumps(table))


if __name__ == "__main__":
    main()
