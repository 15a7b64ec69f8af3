# SPDX-License-Identifier: MIT
"""``blocks`` records acknowledgements of functions, ``condition_signals`` what conditions read."""

from __future__ import annotations

from nctakt import Controller, NcText, Plc, after

PART = """\
#RT CYCLE [ID = 17 SCOPE = PROG]
$IF ONCE V.RTA.ACS.ACT_POS.X > 5 && V.E.COUNT == 0
M100
$ENDIF
$IF V.E.LIST[2] > V.RTG.OVERRIDE.VEL.TOTAL
V.E.COUNT = 1
$ENDIF
#RT CYCLE END
G00 X20
M101
G01 X10 F6000
M30
"""


class Slow(Plc):
    """A PLC that takes its time."""

    acknowledge = after("20 ms")


def texts(program: str, **options: object) -> list[str]:
    """The events about acknowledgements."""
    part = NcText("part.nc", program)
    run = Controller().run(part, blocks=True, **options)  # type: ignore[arg-type]
    return [
        f"{event.tick} {event.kind} {event.text}"
        for event in run.events
        if event.kind in ("acknowledged", "dropped")
    ]


def test_an_acknowledgement_takes_effect_in_the_tick_after_it() -> None:
    """RC-403: the built-in PLC answers in the tick of the output, which counts from the next on."""
    assert texts(PART) == ["52 acknowledged M 100 1 51000", "143 acknowledged M 101 0 142000"]


def test_a_slow_plc_acknowledges_later() -> None:
    """20 ms after the output."""
    found = texts(PART, plc=Slow())
    assert found[0] == "72 acknowledged M 100 1 51000"


def test_a_reset_drops_what_waits() -> None:
    """RC-007: nobody acknowledges M100 before the RESET."""

    class Late(Plc):
        acknowledge = after("1 s")

    events = texts(PART, plc=Late(), at=[("60 ms", "HLI.RESET", 1)], ticks=400)
    assert [event.partition(" ")[2] for event in events] == ["dropped M 100 1 51000"]


def test_without_blocks_nothing_is_added() -> None:
    """The events of a trace are those that it always had."""
    run = Controller().run(NcText("part.nc", PART))
    assert not any(event.kind in ("acknowledged", "dropped") for event in run.events)


def test_the_signals_of_conditions_are_recorded_after_the_others() -> None:
    """Each once, also elements with a constant index; ``V.RTA`` and ``V.RTG`` by their signals."""
    run = Controller().run(
        NcText("part.nc", PART), signals=["PATH.SPEED"], condition_signals=True, ticks=1
    )
    assert run.trace is not None
    assert list(run.trace) == [
        "PATH.SPEED",
        "X.ACS.ACT_POS",
        "V.E.COUNT",
        "V.E.LIST[2]",
        "OVERRIDE.VEL.TOTAL",
    ]


def test_a_rapid_motion_is_reported_apart_from_feed() -> None:
    """PATH.RAPID: 1 in the ticks of G00, 0 in those of G01 and of dwells."""
    text = "G00 X20\nG04 0.01\nG01 X10 F6000\nM30\n"
    run = Controller().run(NcText("part.nc", text), signals=["PATH.RAPID", "PATH.SPEED"])
    assert run.trace is not None
    rapid, speed = run.trace["PATH.RAPID"], run.trace["PATH.SPEED"]
    assert set(rapid.tolist()) == {0.0, 1.0}
    assert speed[rapid == 1.0].max() > 100.0
    assert speed[rapid == 0.0].max() == 100.0
