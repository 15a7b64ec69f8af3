# SPDX-License-Identifier: MIT
"""Arrays of P parameters and indirect parameters (pages 206872331 and 206884875)."""

from __future__ import annotations

import pytest
from support.nc_trees import read, shape

from nctakt import NcText
from nctakt.cli import main
from nctakt.editor.display.line_tokens import tokens
from nctakt.nc.parse.printer import print_program
from nctakt.results.run import Run
from nctakt.run.controller import Controller
from nctakt.session.session import Session

DECLARED = """#VAR
P10[3] = [1, 2, 3]
P20[2][3] = [10, 11, 12, \\
  20, 21, 22]
P30
P40 = 7
P50[4]
#ENDVAR
"""


def run(*lines: str) -> Run:
    """Run lines after the declarations."""
    text = DECLARED + "\n".join((*lines, "M30"))
    return Controller().run(NcText("p.nc", text), signals=["X.ACS.ACT_POS", "Y.ACS.ACT_POS"])


def said(*lines: str) -> list[str]:
    """What the messages of a run without errors say."""
    found = run(*lines)
    assert found.diagnostics == (), found.diagnostics
    return [message.text for message in found.messages]


@pytest.mark.parametrize(
    ("lines", "values", "expected"),
    [
        ((), "P10[0], P10[2], P20[0][2], P20[1][0]", "1 3 12 20"),
        ((), "P20[1, 2], P30, P40, P50[3]", "22 0 7 0"),
        (("P10[1] = 5 P10[0] += 2", "P20[1][1] = P10[1]"), "P10[0], P10[1], P20[1][1]", "3 5 5"),
        (("P1 = 2", "P10[P1] = 9"), "P10[P1], P10[P10[0]], P10[1.4]", "9 2 2"),
        (("P50 = [4, 3]",), "P50[0], P50[1], P50[2]", "4 3 0"),
        ((), "SIZEOF[P10], SIZEOF[P20, 1], SIZEOF[P20, 2]", "3 2 3"),
        ((), "EXIST[P10], EXIST[P10[2]], EXIST[P10[3]], EXIST[P99]", "1 1 0 0"),
        # the manual's examples
        (("P120 = 70 P121 = 71", "PP120 = 123.456", "PP121 = SQRT[4]"), "P70, P71", "123.456 2"),
        (("P1 = 21  P2 = 41", "PP1 = 50", "PP2 = PP1"), "P21, P41", "50 50"),
        (("$FOR P1 = 60, 70, 1", "P[P1 + 5] = P1", "$ENDFOR"), "P65, P75", "60 70"),
        (("P3 = 4 P4 = 5 P5 = 6",), "PP3, PPP3, -PP3", "5 6 -5"),
    ],
)
def test_values(lines: tuple[str, ...], values: str, expected: str) -> None:
    """The last index varies fastest, indices begin at 0 and are rounded; PP1 is P[P1]."""
    formats = " ".join(["%g"] * len(expected.split()))
    assert said(*lines, f'#MSG ["{formats}", {values}]') == [expected]


def test_words_take_elements() -> None:
    """As values of axes, glued or not, and of functions."""
    found = run("G01 F6000 XP10[2] Y P20[1][0]", "P1 = 10", "G04 X[P10[0] * 0.001]")
    assert found.diagnostics == ()
    assert found.trace is not None
    assert [found.trace[f"{axis}.ACS.ACT_POS"][-1] for axis in "XY"] == [3.0, 20.0]


def test_a_cycle_has_the_value_of_its_definition() -> None:
    """RC-302: P parameters are asynchronous; named as they are written."""
    cycle = ("#RT CYCLE [ID=1 SCOPE=PROG]", "V.E.COUNT = P10[2]", "#RT CYCLE END", "P10[2] = 8")
    found = run(*cycle, "G04 X0.01")
    assert [str(one) for one in found.events if one.kind == "frozen"] == ["frozen P10[2] 3"]
    numbers = [one.id for one in run(*cycle[:1], "P10[2] = 1", *cycle[2:3]).errors]
    assert numbers == [22009]


@pytest.mark.parametrize(
    ("line", "number"),
    [
        ("P10 = 5", 21216),
        ("P1 = P10", 21216),
        ("P1 = 10\nP2 = PP1", 21216),
        ("P1 = P[5 + 5] + 1", 21216),
        ("P10[1][1] = 2", 20974),
        ("P1 = P20[1]", 21216),
        ("P10[3] = 1", 21928),
        ("P1 = P10[-1]", 21928),
        ("P11[1] = 2", 20921),
        ("P1 = P11[0]", 20921),
        ('P10[0] = "text"', 21461),
        ("PP1[2] = 1", 901963),
        ("P10[1][1][1][1][1] = 1", 20974),
        ("P10 = [1, 2, 3, 4]", 20912),
        ("P11 = [1]\nP11 = [1, 2]", 20921),
    ],
)
def test_mistakes(line: str, number: int) -> None:
    """Pages 253000075 (20921), 253008779; an array needs all its indices."""
    found = run(line)
    assert found.state == "error"
    assert [one.id for one in found.errors] == [number]


@pytest.mark.parametrize(
    ("line", "number"),
    [("P10[0]", 20917), ("P10[2.5] = [1, 2]", 20917), ("P10[2] = [1, 2, 3]", 20912),
     ("P10[3] : REAL", 20797), ("PP1[3]", 901963), ("P[P1]", 900116)],
)  # fmt: skip
def test_mistakes_of_declarations(line: str, number: int) -> None:
    """Sizes are whole numbers from 1 on; a parameter has no type."""
    found = Controller().run(NcText("p.nc", f"#VAR\n{line}\n#ENDVAR\nM30"))
    assert [one.id for one in found.errors] == [number]


def test_long_programs_know_arrays() -> None:
    """Plain blocks, decoded by templates: a parameter that has become an array is reported."""
    blocks = "\n".join(f"G01 X[P1 + {number}] F6000\nP1 = P1 + 0" for number in range(300))
    text = f"P1 = 0\n{blocks}\n#VAR\nP1[2]\n#ENDVAR\n{blocks}\nM30"
    found = Controller().run(NcText("p.nc", text))
    assert [(one.id, one.span.line) for one in found.errors if one.span] == [(21216, 605)]
    elements = "\n".join(f"G01 XP10[{number % 3}] F6000" for number in range(600))
    found = Controller().run(
        NcText("p.nc", f"{DECLARED}{elements}\nM30"), signals=["X.ACS.ACT_POS"]
    )
    assert found.errors == ()
    assert found.trace is not None
    assert found.trace["X.ACS.ACT_POS"].max() == 3.0


def test_declarations_again() -> None:
    """A later declaration replaces the array, or makes it a single parameter again."""
    again = ("#VAR", "P10[2] = [8, 9]", "P20 = 6", "P40[1] = [5]", "#ENDVAR")
    assert said(*again, '#MSG ["%g %g %g", P10[1], P20, P40[0]]') == ["9 6 5"]


def test_they_are_printed_as_written() -> None:
    """The printer keeps them, and what it prints means the same."""
    program, found = read(f"{DECLARED}P10[P1] = PP1 + P20[1][2]\nXP10[1]\nM30\n")
    assert not found
    printed = print_program(program)
    assert "P10[P1] = P[P1] + P20[1][2]" in printed
    assert shape(read(printed)[0]) == shape(program)


def test_who_looks_sees_them(capsys: pytest.CaptureFixture[str]) -> None:
    """The session shows them beside V.P, explain knows their form, the editor colours them."""
    with Session(NcText("p.nc", f"{DECLARED}G04 X1\nM30")) as session:
        session.run("10 ms")
        (decoder,) = session.decoders()
    shown = {one.name: one.values for one in decoder.program}
    assert shown["P20"] == (10.0, 11.0, 12.0, 20.0, 21.0, 22.0)
    assert dict(decoder.parameters) == {30: 0.0, 40: 7.0}
    assert main(["explain", "P10[1]"]) == 0
    assert main(["explain", "PP1"]) == 0
    assert "P1" in capsys.readouterr().out
    assert [one.text for one in tokens("P10[1] = PP1") if one.kind == "parameter"] == [
        "P10",
        "PP1",
    ]
