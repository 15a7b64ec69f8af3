# SPDX-License-Identifier: MIT
"""Tool life: what counts, when it is sent, and ``#TOOL LIFE``; ``docs/conformance/tools.md``.

Public manuals: pages 208584843, 208592267, 1025583755, 318264331, 318286731; P-CHAN-00076, 00243,
00255, 00482.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from support.decided import numbers, perform, reported
from support.run_folders import changed_machine

from nctakt.lists.machine.machine import load_machine
from nctakt.messages.path.tools import NEGATIVE_TOOL_LIFE
from nctakt.messages.programs.checked_blocks import INVALID_COMMAND_FORM
from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller


def controller_with(folder: Path, *entries: str) -> Controller:
    """A controller of the demo machine with these entries of its channel list."""
    changes = {"sda_mds1.lis": list(entries)}
    return Controller(load_machine(changed_machine(changes, folder / "machine")))


def life(program: str, controller: Controller | None = None, **options: object) -> list[float]:
    """The seconds and mm that the tool has worked at the end, rounded to µs and nm."""
    controller = controller or Controller()
    run = perform(f"{program}\nM30", controller, **options)
    assert run.state == "ended", run.diagnostics
    return [round(float(controller.read(f"HLI.TOOL_{name}")), 6) for name in ("TIME", "DISTANCE")]


def test_feed_motions_count() -> None:
    """208584843: lines and arcs, the path's length; no rapid motion, no dwell."""
    time_s, distance = life("G01 X10 F6000\nG00 X50\nG04 1\nG01 Y3 Z4\nG03 I5 X60 F3000")
    assert distance == pytest.approx(10.0 + (9.0 + 16.0) ** 0.5 + 5.0 * 3.14159265, abs=1e-5)
    assert 0.4 < time_s < 1.0


def test_a_tracking_axis_counts_its_own_way() -> None:
    """Where it moves alone, in degrees."""
    assert life("G01 A45 F6000")[1] == 45.0
    assert life("G01 X10 A45 F6000")[1] == 10.0


def test_no_time_at_a_standstill() -> None:
    """Feed hold and an override of 0 % stop the clock."""
    hold = [Stimulus("100 ms", "HLI.FEED_HOLD", 1), Stimulus("2 s", "HLI.FEED_HOLD", 0)]
    moving, held = (life("G01 X20 F6000", at=at) for at in ((), hold))
    assert held[1] == moving[1] == 20.0
    assert moving[0] < held[0] < moving[0] + 0.1


def test_the_way_back_counts_once() -> None:
    """MO-7: what the path walks back and goes again."""
    switch = "HLI.BACKWARD_MOTION"
    back = [Stimulus("150 ms", switch, 1), Stimulus("400 ms", switch, 0)]
    assert life("G01 X10 F6000\nX20", at=back)[1] == 20.0


def test_factors_weigh() -> None:
    """V.TLM: from their block on, beyond the end of the program."""
    controller = Controller()
    first = life("G01 X10 F6000\nV.TLM.DIST_FACT = 2 V.TLM.TIME_FACT = 0\nX20", controller)
    assert first[1] == 30.0
    second = life("G01 X10 F6000", controller)
    assert second == [first[0], 50.0]


def test_a_reset_takes_factors_that_were_not_reached() -> None:
    """The decoder goes on with those that count."""
    controller = Controller()
    text = "G01 X100 F1000\nV.TLM.DIST_FACT = 5\nX200\nM30\n"
    perform(text, controller, at=[Stimulus("100 ms", "HLI.RESET", 1)])
    run = perform('#MSG ["%g", V.TLM.DIST_FACT]\nM30', controller)
    assert [one.text for one in run.messages] == ["1"]


def test_commands() -> None:
    """208592267, 1025583755: READ sends and goes on, REMOVE clears, DEF sets what it names."""
    controller = Controller()
    text = "G01 X10 F6000\n{}\nX20"
    assert life(text.format("#TOOL LIFE REMOVE"), controller)[1] == 10.0
    assert life(text.format("#TOOL LIFE DEF [DIST=100]"))[1] == 110.0
    before = life(text.format("G09"))[0]
    assert life(text.format("#TOOL LIFE DEF [TIME=60.5]"))[0] == pytest.approx(
        60.5 + before / 2.0, abs=0.1
    )
    run = perform("G01 X10 F6000\n#TOOL LIFE READ [7, 1, 2]\nX20\n#TOOL LIFE READ [P1]\nM30")
    sent = [line.split(" tool_life ")[1].rsplit(" ", 2) for line in reported(run, "tool_life")]
    assert [(tool, float(distance)) for tool, _, distance in sent] == [
        ("7, 1, 2", 10.0),
        ("0", 20.0),
    ]


def test_each_t_sends(tmp_path: Path) -> None:
    """P-CHAN-00076: the life of the tool before, which may be none; then it begins at 0."""
    text = "G01 X10 F6000\nT1\nX20\nT1\nT2\nX25\nM30"
    controller = controller_with(tmp_path, "tool_life_to_wzv 1")
    run = perform(text, controller)
    sent = [line.split()[2:] for line in reported(run, "tool_life")]
    assert [(tool, round(float(mm))) for tool, _, mm in sent] == [("0", 10), ("1", 10), ("1", 0)]
    values = [controller.read(f"HLI.LIFE_{name}") for name in ("SERIAL", "TOOL", "DISTANCE")]
    assert values == [3.0, 1.0, 0.0]
    assert reported(perform(text), "tool_life") == []


def test_zeros_are_left_out(tmp_path: Path) -> None:
    """P-CHAN-00243."""
    controller = controller_with(tmp_path, "tool_life_to_wzv 1", "tool_life_to_wzv_suppress_zero 1")
    run = perform("T1\nT2\nG01 X5 F6000\nT3\nM30", controller)
    assert len(reported(run, "tool_life")) == 1


def test_d_may_change_the_tool(tmp_path: Path) -> None:
    """P-CHAN-00482: motions between T and D belong to the tool before."""
    text = "T2\nG01 X10 F6000\nD2\nX20"
    assert life(text)[1] == 20.0
    assert life(text, controller_with(tmp_path, "tool_life_with_d 1"))[1] == 10.0


def test_rapid_motions_may_count(tmp_path: Path) -> None:
    """P-CHAN-00255."""
    controller = controller_with(tmp_path, "tool_life_capture_all_movements 1")
    assert life("G00 X10\nG01 X20 F6000", controller)[1] == 20.0


@pytest.mark.parametrize(
    ("command", "number"),
    [
        ("#TOOL LIFE DEF [DIST=-1]", NEGATIVE_TOOL_LIFE.id),
        ("#TOOL LIFE DEF [TIME=P1-1]", NEGATIVE_TOOL_LIFE.id),
        ("#TOOL LIFE DEF", INVALID_COMMAND_FORM.id),
        ("#TOOL LIFE READ", INVALID_COMMAND_FORM.id),
        ("#TOOL LIFE REMOVE [1]", INVALID_COMMAND_FORM.id),
    ],
)
def test_mistakes(command: str, number: int) -> None:
    """Values below 0, other forms."""
    assert numbers(perform(f"{command}\nM30")) == [number]
