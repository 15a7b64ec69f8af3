# SPDX-License-Identifier: MIT
"""How results, controllers and machines show themselves, in a shell and in a notebook."""

from pathlib import Path

import pytest

from nctakt.lists.machine.machine import load_machine
from nctakt.results.run import ProgramMessage
from nctakt.run.controller import Controller, NcText
from nctakt.schedule.open_schedule import open_schedule, simulate_schedule

REACTION = """\
#RT CYCLE [ID=1 SCOPE=PROG]
$IF ONCE V.RTA.ACS.ACT_POS.X > 1
M100
$ENDIF
#RT CYCLE END
#MSG ["<b>half & way"]
G00 X5
M111
M30
"""
EXAMPLES = Path(__file__).parents[2] / "examples"


def test_a_run_says_on_one_line_how_it_ended() -> None:
    """State, time, ticks and counts."""
    run = Controller().run(NcText("part.nc", REACTION))
    assert repr(run) == (
        f"<Run of part.nc: ended after 0.0{run.ticks} s, {run.ticks} ticks; "
        "1 message, 0 errors, 0 warnings>"
    )
    assert repr(run.trace) == f"<Trace of 12 signals: {run.ticks} ticks, {len(run.events)} events>"


def test_messages_and_functions_have_named_fields() -> None:
    """They read well where a list of them is printed."""
    run = Controller().run(NcText("part.nc", REACTION))
    (message,) = run.messages
    assert (message.time_us, message.text, message.channel) == (0, "<b>half & way", 0)
    assert repr(run.messages) == "(<0 s: '<b>half & way'>,)"
    assert str(message) == "<b>half & way"
    reaction, output = run.technology
    assert (reaction.name, reaction.letter, reaction.number, reaction.cycle) == (
        "M100",
        "M",
        100,
        "1",
    )
    assert repr(reaction) == f"<0.0{reaction.tick} s: M100 of cycle 1, part.nc:3:1>"
    assert repr(output) == f"<0.0{output.tick} s: M111, part.nc:8:1>"
    assert [one.name for one in run.outputs] == ["M100", "M111"]
    assert repr(ProgramMessage(1_500_000, "done", channel=2)) == "<1.5 s CH2: 'done'>"


def test_a_notebook_shows_a_table_with_escaped_texts(monkeypatch: pytest.MonkeyPatch) -> None:
    """State, time, counts, messages, errors; nothing of a program becomes HTML."""
    monkeypatch.setattr("nctakt.plots.drawer.has_matplotlib", lambda: False)
    run = Controller().run(NcText("<i>.nc", f"{REACTION.replace('M30', 'G01 X10 F0')}"))
    assert run.state == "error"
    page = run._repr_html_()
    assert page.startswith("<table><caption>&lt;i&gt;.nc</caption>")
    assert ">error</td>" in page
    assert "error 20176" in page
    run = Controller().run(NcText("<i>.nc", REACTION))
    page = run._repr_html_()
    assert "&lt;b&gt;half &amp; way" in page
    assert "<b>" not in page
    assert "<i>" not in page


def test_controllers_and_machines_say_what_they_are() -> None:
    """Each on one line."""
    controller = Controller()
    assert repr(controller) == "<Controller of demo: 1 channel, 6 axes, ready at tick 0>"
    controller.step(3)
    assert repr(controller.hli) == "<PlcView of channel 1: ready, after tick 2>"
    assert repr(load_machine()).startswith("<Machine demo: 1 channel, axes X, Y, Z, ")
    schedule = open_schedule(EXAMPLES / "schedule" / "rtconf.lis")
    assert repr(schedule).startswith("<RunSchedule of ")
    assert repr(simulate_schedule(schedule, "3 ticks")).startswith("<Simulation of 3 NC cycles: ")


def test_a_diagnostic_is_shown_with_its_number_and_printed_in_full() -> None:
    """``repr`` is the headline, ``str`` has excerpt and remedy, too."""
    (diagnostic,) = Controller().run(NcText("part.nc", "G01 X10 F0\nM30")).errors
    assert repr(diagnostic) == f"<{diagnostic.headline()}>"
    assert str(diagnostic) == diagnostic.render()
