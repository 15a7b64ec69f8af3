# SPDX-License-Identifier: MIT
"""Program texts with mistakes that chance has made: diagnostics, never a traceback.

The programs of the tests and the examples, each damaged in one to six places, are checked, linted
and, where they pass, run for some ticks.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path
from random import Random

from support.random_seeds import seeds_in_parts

from nctakt.base.text import decode_text
from nctakt.checking.check import check_files
from nctakt.lists.machine.machine import load_machine
from nctakt.run.controller import Controller, NcText
from nctakt.run.realtime.assembly import AssembledMachine

ROOT = Path(__file__).parent.parent.parent
DEMO = load_machine(None)
TARGET = AssembledMachine(DEMO)
#: Ticks that a text runs which passes the check.
TICKS = 60
#: What is put into a text.
PIECES = (
    *"[]()=+-*/<>&|^!\"'%#$;:.,~\\{}@?",
    *(
        "0",
        "-1",
        "1E3",
        "99999999999999999999",
        "0.5",
        ".",
        "[[",
        "]]",
        "1 / 0",
        "V.E.",
        "V.E.LIST[",
    ),
    *(
        "$IF",
        "$ENDIF",
        "$ELSE",
        "$WHILE 1",
        "$ENDWHILE",
        "$GOTO N10",
        "$FOR P1 = 1, 3, 1",
        "$BREAK",
    ),
    *("#RT CYCLE", "#RT CYCLE END", "#RT CYCLE DELETE [ID = 1]", "#VAR", "#ENDVAR", "#TIME 0.1"),
    *(
        "G00",
        "G01 X1 F0",
        "G02 X1 Y1 R1",
        "G41",
        "M30",
        "M100",
        "L UP",
        "LL UP",
        "T1 D1",
        "S1000 M3",
    ),
    *(
        "X",
        "X[INDP POS=5 G90 FEED=100]",
        "N10",
        "ONCE",
        "EDGE",
        "Vs.",
        "\t",
        " ",
        "\0",
        "ä",
        "€",
        "\ufeff",
    ),
)


@cache
def originals() -> list[str]:
    """The texts to be damaged; none so long that its run takes its time."""
    paths = [
        *sorted(ROOT.glob("tests/runs/*/*.nc")),
        *sorted(ROOT.glob("tests/nc/*.nc")),
        *sorted(ROOT.glob("examples/**/*.nc")),
    ]
    return [decode_text(path.read_bytes()).text for path in paths if path.stat().st_size < 20_000]


def lose(text: str, chance: Random) -> str:
    """Some characters are missing."""
    place = chance.randrange(len(text) + 1)
    return text[:place] + text[place + chance.choice((1, 1, 2, 5, 30)) :]


def insert(text: str, chance: Random) -> str:
    """Something is where it does not belong."""
    place = chance.randrange(len(text) + 1)
    return text[:place] + chance.choice(PIECES) + text[place:]


def repeat(text: str, chance: Random) -> str:
    """A piece is repeated several times."""
    first = chance.randrange(len(text) + 1)
    last = first + chance.choice((1, 3, 20))
    return text[:last] + text[first:last] * chance.choice((1, 1, 2, 70)) + text[last:]


def exchange(text: str, chance: Random) -> str:
    """Two lines have changed their places."""
    lines = text.split("\n")
    one, other = chance.randrange(len(lines)), chance.randrange(len(lines))
    lines[one], lines[other] = lines[other], lines[one]
    return "\n".join(lines)


def splice(text: str, chance: Random) -> str:
    """The end is that of another program."""
    other = chance.choice(originals())
    return text[: chance.randrange(len(text) + 1)] + other[chance.randrange(len(other) + 1) :]


def spoil(text: str, chance: Random) -> str:
    """A character is another one."""
    place = chance.randrange(len(text) + 1)
    return (
        text[:place]
        + chr(chance.choice((chance.randrange(32, 127), chance.randrange(256))))
        + (text[place + 1 :])
    )


MISTAKES: tuple[Callable[[str, Random], str], ...] = (
    lose,
    insert,
    insert,
    repeat,
    exchange,
    splice,
    spoil,
)


def damaged(seed: int) -> str:
    """The text of a seed."""
    chance = Random(seed)
    text = chance.choice(originals())
    for _ in range(chance.randint(1, 6)):
        text = chance.choice(MISTAKES)(text, chance)
    return text


@seeds_in_parts(250, 60, 50)
def test_no_text_breaks_the_controller(seeds: range) -> None:
    """Each text gives diagnostics that can be shown, in both languages, or runs."""
    for seed in seeds:
        text = damaged(seed)
        try:
            run = Controller(DEMO).run(NcText("p.nc", text), ticks=TICKS, memory_trace=False)
            found = [one.diagnostic for one in check_files([NcText("p.nc", text)], TARGET).findings]
            found += run.diagnostics
            shown = [one.render(language) for one in found for language in ("en", "de")]
        except Exception as error:
            error.add_note(f"seed {seed}:\n{text}")
            raise
        assert all(shown), seed
        assert run.state in ("ended", "limit", "error"), seed
        assert run.state != "error" or run.errors, seed
