# SPDX-License-Identifier: MIT
"""Pointers that are cast, moved and followed at random never leave the PLC's memory (ST-315)."""

from __future__ import annotations

import random

from support.random_seeds import seeds_in_parts
from support.st_statements import cycles

from nctakt.base.diagnostics import Severity
from nctakt.kernel.st import kinds
from nctakt.messages import Collector
from nctakt.plc.structured_text import StructuredPlc
from nctakt.st.inspection import inspect_texts
from nctakt.st.reporting import Reporter
from nctakt.st.sources import Sources

TARGETS = {"BYTE": "nByte", "INT": "nInt", "LREAL": "fReal", "ST_A": "stA", "STRING(9)": "sText"}
POINTERS = {f"p{number}": target for number, target in enumerate(TARGETS)}
EDGES = (0, 1, -1, 8, -8, 4095, 4096, 1 << 16, 1 << 31, -(1 << 31), 1 << 62, -(1 << 63) + 1)
DECLARED = """TYPE ST_A : STRUCT n : DINT; a : ARRAY[0..3] OF INT; p : POINTER TO BYTE; END_STRUCT
END_TYPE
PROGRAM MAIN
VAR
    nByte : BYTE; nInt : INT; fReal : LREAL; stA : ST_A; sText : STRING(9); nMoved : LINT;
    {pointers}
END_VAR
{body}
END_PROGRAM
"""


def statement(draw: random.Random) -> str:
    """A statement that sets, casts, moves or follows a pointer."""
    one, other = draw.choice([*POINTERS]), draw.choice([*POINTERS])
    number, name = draw.choice((draw.randint(-70, 70), draw.choice(EDGES))), draw.choice("abcde")
    variable = TARGETS[POINTERS[one]]
    match draw.randrange(8):
        case 0 | 1:
            return f"{one} := ADR({draw.choice([*TARGETS.values()])});"
        case 2:
            return f"{one} := {other};"
        case 3:
            return f"nMoved := {number}; {one} := {one} + nMoved;"
        case 4:
            return f"{one}^ := {variable};"
        case 5:
            return f"{variable} := {one}[{number % 1000 if name == 'a' else number % 9}];"
        case 6:
            return f"p3^.a[{number % 4}] := nInt; stA.p := {one}; stA.p^ := 3;"
    word = draw.choice(("MEMCPY", "MEMMOVE", "MEMSET"))
    source = "7" if word == "MEMSET" else other
    count = number % (1 << 31) if draw.random() < 0.2 else abs(number) % 40
    return f"{word}({one}, {source}, {count});"


def plc_of(seed: int) -> StructuredPlc:
    """A PLC of random statements; raises ``ValueError`` with what the check reports."""
    draw = random.Random(seed)
    pointers = " ".join(f"{name} : POINTER TO {target};" for name, target in POINTERS.items())
    first = [f"{name} := ADR({TARGETS[target]});" for name, target in POINTERS.items()]
    body = "\n".join([*first, *(statement(draw) for _ in range(40))])
    text = DECLARED.format(pointers=pointers, body=body)
    collector = Collector()
    reporter = Reporter(Sources(), collector)
    program = inspect_texts("random", {"random.st": text.encode()}, reporter)
    for one in collector.diagnostics:
        if one.severity is Severity.ERROR:
            raise ValueError(one.render("en"))
    return StructuredPlc(program, [])


@seeds_in_parts(24, 16, 24)
def test_pointers_stay_in_the_memory(seeds: range) -> None:
    """ST-315, ST-560: each access is inside, or stops the PLC; null and literals stay as they are.

    A build with sanitizers and plain Python find an access beyond the memory by themselves.
    """
    faults = set()
    for seed in seeds:
        plc = plc_of(seed)
        context = plc.context
        literals = context.peek(context.stack_end, context.interface - context.stack_end)
        memory, fault = cycles(plc)[-1]
        faults.add(fault)
        assert (seed, memory[: kinds.NULL_BYTES]) == (seed, bytes(kinds.NULL_BYTES))
        assert (seed, memory[context.stack_end : context.interface]) == (seed, literals)
    assert faults <= {0, kinds.PLACE, kinds.INDEX, kinds.INVALID}
    assert kinds.PLACE in faults
