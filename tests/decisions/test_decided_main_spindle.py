# SPDX-License-Identifier: MIT
"""Decisions on ``#MAIN SPINDLE`` (public manuals, page 208277131; IDs 21306, 21175, 21980).

The demo machine: S1 (5) is the main spindle S, S2 (6) another one, S3 (10) turned by the PLC.
"""

from __future__ import annotations

import pytest
from support.decided import numbers, perform, reported

from nctakt.run.controller import Controller


def jobs(program: str) -> list[str]:
    """The jobs of spindles in a program, in their order: name, function, speed."""
    run = perform(f"{program}\nM30", ticks=5000)
    assert run.state == "ended", run.diagnostics
    lines = [line.split() for line in reported(run, "spindle")]
    return [" ".join(line[2:]) for line in lines]


def test_the_public_example() -> None:
    """Each #MAIN SPINDLE gives S to another spindle, whose former name is that of the list."""
    program = (
        "N10 S100 M3 S2[REV200 M3] S3[REV300 M4]\n"
        "N20 #MAIN SPINDLE [S2]\nN30 S110 M3 S1[REV210 M3] S3[REV310 M4]\n"
        "N40 #MAIN SPINDLE [S3]\nN50 S120 M3 S1[REV220 M3] S2[REV320 M4]\n"
        "N60 #MAIN SPINDLE\nN70 S150 M3 S2[REV250 M3] S3[REV350 M4]\n"
        "N80 M5 S2[M5] S3[M5]"
    )
    assert jobs(program) == [
        *("S M3 100", "S2 M3 200", "S3 M4 300"),
        *("S2 M3 110", "S M3 210", "S3 M4 310"),
        *("S3 M3 120", "S M3 220", "S2 M4 320"),
        *("S M3 150", "S2 M3 250", "S3 M4 350"),
        *("S M5 0", "S2 M5 0", "S3 M5 0"),
    ]


def test_it_is_named_by_its_number_as_well() -> None:
    """6 is the logical number of S2; V.SPDL and V.SPDL_PROG of S are then those of S2."""
    run = perform(
        "#MAIN SPINDLE [3 + 3]\nS70 M3\n"
        '#MSG ["%d %d %d", V.SPDL.LOG_AX_NR.S, V.SPDL_PROG.SPEED.S2, V.SPDL.LOG_AX_NR.S1]\nM30'
    )
    assert reported(run, "message")[0].endswith(" 6 70 5")


def test_feed_per_revolution_follows_the_main_spindle() -> None:
    """G95: 0.5 mm per revolution of S2 at 600/min are 5 mm/s, however fast S1 turns."""
    program = "S1[REV60 M3] S2[REV600 M3]\nG04 3\n#MAIN SPINDLE [S2]\nG95 F0.5\nG01 X20\nM30"
    run = perform(program, signals=["PATH.SPEED"])
    assert run.trace is not None
    assert max(run.trace["PATH.SPEED"]) == pytest.approx(5.0, rel=1e-6)


def test_a_cycle_keeps_the_spindle_of_its_definition() -> None:
    """S in a realtime cycle is the main spindle at the line that defines the cycle."""
    cycle = "#RT CYCLE [SCOPE=PROG]\n$IF ONCE 1\nS[M3 REV=40]\n$ENDIF\n#RT CYCLE END"
    assert jobs(f"#MAIN SPINDLE [S2]\n{cycle}\n#MAIN SPINDLE\nG04 0.1")[0] == "S2 M3 40"


def test_each_program_begins_with_that_of_the_list() -> None:
    """Choice: as after start-up."""
    controller = Controller()
    perform("#MAIN SPINDLE [S2]\nM30", controller)
    run = perform("S50 M3\nM30", controller)
    assert reported(run, "spindle")[0].endswith("S M3 50")


@pytest.mark.parametrize(
    ("program", "number"),
    [
        ("#MAIN SPINDLE [S9]", 21306),
        ("#MAIN SPINDLE [7]", 21306),
        ("#MAIN SPINDLE [S2, S1]", 900233),
        ("#MAIN SPINDLE S2", 900233),
    ],
)
def test_what_cannot_be(program: str, number: int) -> None:
    """Each with its own number."""
    assert numbers(perform(f"{program}\nM30")) == [number]
