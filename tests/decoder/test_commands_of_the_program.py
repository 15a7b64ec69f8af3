# SPDX-License-Identifier: MIT
"""Commands of the main program whose effect no trace shows."""

from __future__ import annotations

import pytest

from nctakt.results.run import ProgramMessage, Run
from nctakt.run.controller import Controller, NcText


def run(text: str, said: list[ProgramMessage] | None = None) -> Run:
    """A program on the demo machine; what it says goes to ``said``."""
    listen = None if said is None else said.append
    return Controller().run(NcText("p.nc", text + "M30\n"), on_message=listen)


def test_saved_messages_name_the_file_that_the_program_wants() -> None:
    """Only those with SAVE; the last name counts."""
    said: list[ProgramMessage] = []
    result = run(
        '#MSG SAVE ["a"]\n#FILENAME [MSG="one.txt"]\n#MSG SAVE ["b"]\n#MSG ["c"]\n'
        '#FILE NAME [MSG=Two.txt]\n#MSG SAVE EXCLUSIVE CONTINUE ["d"]\n',
        said,
    )
    assert result.errors == ()
    found = [(one.text, one.file, one.is_exclusive, one.is_unbroken) for one in said]
    assert found == [
        ("a", "", False, False),
        ("b", "one.txt", False, False),
        ("c", "", False, False),
        ("d", "Two.txt", True, True),
    ]


@pytest.mark.parametrize(
    "command",
    [
        "#CHANNEL INIT [CMDPOS]",
        "#CHANNEL INIT [CMDPOS AX=X AX=Y]",
        "#CHANNEL INIT [ACTPOS AXNR=1]",
        "#SET DEC LR SOLL",
    ],
)
def test_channel_init_waits_until_the_path_stops(command: str) -> None:
    """206703627, 206709515: what follows is decoded with the positions of then."""
    text = f"G00 X100\n{command}\nG91 X10\nV.E.VALUE = V.RTA.ACS.ACT_POS.X\n"
    controller = Controller()
    result = controller.run(NcText("p.nc", text + "M30\n"), blocks=True)
    assert result.errors == ()
    assert controller.read("V.E.VALUE") == 110
    waits = [event.text for event in result.events if event.kind == "waits"]
    assert waits == ["positions", "read V.RTA.ACS.ACT_POS.X"]


@pytest.mark.parametrize(
    ("command", "number"),
    [
        ("#CHANNEL INIT [AX=X]", 900233),
        ("#CHANNEL INIT [CMDPOS AX=Q]", 900706),
        ("P1 = 99\n#CHANNEL INIT [CMDPOS AXNR=P1]", 901801),
        ("#SET DEC LR SOLL [X]", 900233),
    ],
)
def test_channel_init_names_axes_of_the_channel(command: str, number: int) -> None:
    """Each mistake has its number."""
    assert [one.id for one in run(command + "\n").diagnostics] == [number]


def test_data_of_the_controller_are_read_when_the_block_is_decoded() -> None:
    """Software limits in the program's unit; no tool is active."""
    said: list[ProgramMessage] = []
    run(
        '#MSG ["%g %g %g", V.A.+SWE_MDS.X, V.A.-SWE_MDS.X, V.G.WZ_AKT.R]\n'
        'G70\n#MSG ["%.4f", V.A.+SWE_MDS.X]\n',
        said,
    )
    high, low, tool = (float(word) for word in said[0].text.split())
    assert low < 0 < high
    assert tool == 0
    assert float(said[1].text) == round(high / 25.4, 4)


def test_a_timer_has_a_whole_number_within_the_bank() -> None:
    """0 … 127."""
    for identity in ("128", "-1", "0.5"):
        assert [one.id for one in run(f"P1 = {identity}\n#TIMER START [ID=P1]\n").errors] == [21167]
