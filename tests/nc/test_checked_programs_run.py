# SPDX-License-Identifier: MIT
"""What the checker lets pass, decoder and realtime part can run: random programs on the demo."""

from __future__ import annotations

from functools import cache
from random import Random

import pytest
from support.check_machine import passes
from support.nc_chunks import read_chunks

from nctakt.nc.vocabulary.operators import FUNCTIONS, INFIX
from nctakt.run.controller import Controller, NcText

PROGRAMS = 25
_VALUES = (
    "1",
    "P1",
    "PI",
    "V.E.VALUE",
    "V.E.ASYNC",
    "V.E.LIST[P1]",
    "V.CH.Table[V.E.COUNT]",
    "V.RTA.ACS.ACT_POS.X",
    "V.RTG.TIMER[3]",
    "V.E.LEVEL_1_A[1].LEVEL_2_A[0].LIST[2]",
    "V.E.LEVEL_1_A[P2].FROZEN",
)
_TARGETS = ("V.E.VALUE", "V.E.COUNT", "V.E.FLAG", "V.CH.Table[P1]", "V.RTG.OVERRIDE.VEL.CYCLE")
_FUNCTIONS = [function for function in FUNCTIONS.values() if not function.decoder_only]


@cache
def _lines() -> tuple[list[str], list[str]]:
    """Lines of the chunks that pass alone, and those that pass alone in a realtime cycle."""
    texts = (line.split("; ")[0].rstrip() for chunk in read_chunks("*.nc") for line in chunk.lines)
    lines = [line for line in dict.fromkeys(texts) if line.strip()]
    alone = [line for line in lines if passes([line, "M30"]) and "$" not in line]
    inside = [
        line
        for line in lines
        if "#" not in line and passes(["#RT CYCLE", line, "#RT CYCLE END", "M30"])
    ]
    return alone, inside


def _expression(chance: Random, depth: int) -> str:
    kind = chance.random()
    if depth == 0 or kind < 0.3:
        return chance.choice(_VALUES)
    if kind < 0.65:
        operator = chance.choice(list(INFIX))
        left, right = _expression(chance, depth - 1), _expression(chance, depth - 1)
        return f"[{left} {operator} {right}]"
    if kind < 0.75:
        return f"-{_expression(chance, depth - 1)}"
    function = chance.choice(_FUNCTIONS)
    arguments = ", ".join(_expression(chance, depth - 1) for _ in range(function.minimum))
    return f"{function.name}[{arguments}]"


def _cycle(chance: Random) -> list[str]:
    body = []
    for _ in range(chance.randrange(4)):
        operator = chance.choice(("=", "+=", "-=", "*=", "/="))
        assignment = f"{chance.choice(_TARGETS)} {operator} {_expression(chance, 3)}"
        body.append(chance.choice([assignment, chance.choice(_lines()[1])]))
    frequency = chance.choice(("", "ONCE", "EDGE", "ALWAYS"))
    condition = f"$IF {frequency} {_expression(chance, 3)}"
    scope = chance.choice(("BLOCK", "PROG"))
    return [f"#RT CYCLE [SCOPE={scope}]", condition, *body, "$ENDIF", "#RT CYCLE END"]


def _program(chance: Random) -> list[str]:
    alone = _lines()[0]
    program: list[str] = []
    for _ in range(chance.randrange(1, 12)):
        match chance.randrange(5):
            case 0 | 1:
                program.append(chance.choice(alone))
            case 2:
                program += _cycle(chance)
            case 3:
                program.append(f"P{chance.randrange(4)} = {_expression(chance, 3)}")
            case _:
                opening, end = chance.choice(
                    (("$IF P1", "$ENDIF"), ("$FOR P3 = 1, 3, 1", "$ENDFOR"))
                )
                program += [opening, chance.choice(alone), end]
    return [*program, "M30"]


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(6))
def test_what_passes_the_checker_runs(seed: int) -> None:
    """A checked program ends, runs on or gives a numbered error; it never breaks the controller."""
    chance = Random(seed)
    for _ in range(PROGRAMS):
        program = _program(chance)
        if passes(program):
            run = Controller().run(NcText("random.nc", "\n".join(program)), ticks=500)
            assert run.state in ("ended", "limit", "error"), program
