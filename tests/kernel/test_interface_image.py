# SPDX-License-Identifier: MIT
"""The interface image between CNC and PLC: slots, waiting, acknowledgement (RC-002, RC-403)."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from support.insides import machine_of
from support.kernel_rig import DEMO

from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import PlcView


class Script:
    """A PLC that does in each tick what a function says, and keeps what it saw."""

    def __init__(self, answer: Callable[[PlcView], None]) -> None:
        self.answer = answer
        self.seen: list[tuple[int, str, int, int, int, bool]] = []

    def cycle(self, hli: PlcView) -> None:
        """One tick."""
        self.seen += [
            (hli.tick, one.letter, one.number, one.sequence, one.time_us, one.is_realtime)
            for one in hli.functions()
        ]
        self.answer(hli)


def silent() -> Script:
    """A PLC that never acknowledges anything."""
    return Script(lambda hli: None)


def after(ticks: int) -> Script:
    """A PLC that acknowledges each function this many ticks after it has seen it first."""

    def answer(hli: PlcView) -> None:
        for one in hli.functions():
            if hli.time_us - one.time_us >= ticks * 1000:
                hli.acknowledge(one)

    return Script(answer)


def once(count: int) -> str:
    """A cycle that commands this many functions in one tick."""
    body = "".join(f"M{100 + n % 10}\n" for n in range(count))
    return f"#RT CYCLE\n$IF ONCE TRUE\n{body}$ENDIF\n#RT CYCLE END\n"


@pytest.mark.parametrize(("count", "errors"), [(19, []), (20, []), (21, [50943])])
def test_the_realtime_section_takes_twenty_functions_in_a_tick(
    count: int, errors: list[int]
) -> None:
    """20 slots: one more in the same tick is 50943; those before it are numbered from 1."""
    run = Controller(DEMO).run(NcText("p.nc", once(count) + "G04 X0.003\nM30"))
    assert [found.id for found in run.errors] == errors
    found = [(one.number, one.sequence, one.time_us) for one in run.technology]
    assert found == [(100 + n % 10, n + 1, 0) for n in range(min(count, 20))]


@pytest.mark.parametrize(("count", "errors"), [(19, []), (20, []), (21, [50942])])
def test_without_acknowledgement_the_slots_run_out(count: int, errors: list[int]) -> None:
    """A PLC that takes nothing leaves room for 20 functions; the next one is 50942."""
    text = f"#RT CYCLE\n$IF V.E.COUNT < {count}\nM100\nV.E.COUNT += 1\n$ENDIF\n#RT CYCLE END\n"
    run = Controller(DEMO).run(NcText("p.nc", text + "G04 X0.030\nM30"), plc=silent())
    assert [found.id for found in run.errors] == errors
    assert len(run.technology) == min(count, 20)
    if errors:
        (error,) = [event for event in run.events if event.kind == "error"]
        assert error.tick == 20


def test_the_default_plc_frees_the_slots_from_the_next_tick_on() -> None:
    """Twenty functions in each of a hundred ticks: each is taken at once."""
    body = "".join("H100\n" for _ in range(20))
    run = Controller(DEMO).run(
        NcText("p.nc", f"#RT CYCLE\n{body}#RT CYCLE END\nG04 X0.100\nM30"), memory_trace=False
    )
    assert run.errors == ()
    assert [(one.letter, one.number, one.count) for one in run.outputs] == [("H", 100, 2000)]


def test_a_plc_sees_functions_in_their_order_with_section_and_stamp() -> None:
    """The main program's section first, then POS_RT with number within the tick and stamp."""
    plc = after(0)
    text = (
        "#RT CYCLE\n$IF EDGE V.RTA.ACS.ACT_POS.X > 0\nM101\nH102\n$ENDIF\n#RT CYCLE END\n"
        "M100\nG00 X1\nM30"
    )
    Controller(DEMO).run(NcText("p.nc", text), plc=plc)
    assert plc.seen == [
        (0, "M", 100, 1, 0, False),
        (1, "M", 101, 1, 1000, True),
        (1, "H", 102, 2, 1000, True),
    ]


@pytest.mark.parametrize("ticks", [0, 1, 2, 7])
@pytest.mark.parametrize(
    ("function", "waits_before", "waits_behind"),
    [
        ("M100", False, False),
        ("M111", True, False),
        ("M112", False, True),
        ("M113", False, True),
        ("H111", True, False),
    ],
)
def test_the_program_waits_exactly_for_the_acknowledgement(
    ticks: int, function: str, waits_before: bool, waits_behind: bool
) -> None:
    """What the PLC answers after tick n counts from n + 1: the next block begins then (RC-002).

    MVS_SVS waits before its motion, MVS_SNS and MNS_SNS after it, MOS not at all.
    """
    text = f"N10 G04 X0.004\nN20 {function} G00 X1\nN30 G04 X0.002\nM30"
    run = Controller(DEMO).run(NcText("p.nc", text), plc=after(ticks), signals=["BLOCK"])
    assert run.errors == ()
    assert run.trace is not None
    blocks = run.trace["BLOCK"].tolist()
    move = 4 + (ticks + 1 if waits_before else 0)
    assert blocks.index(20.0) == move
    behind = move + 32
    if waits_behind:
        issued = 4 if function == "M112" else behind
        behind = max(behind, issued + ticks + 1)
    assert blocks.index(30.0) == behind


def test_a_main_program_waits_for_a_free_slot() -> None:
    """The 21st function of the main program is no error: it waits until the PLC takes one."""
    text = "M100\n" * 21 + "N10 G04 X0.001\nM30"
    run = Controller(DEMO).run(NcText("p.nc", text), plc=after(5), signals=["BLOCK"])
    assert run.errors == ()
    assert [one.tick for one in run.technology] == [0] * 20 + [6]
    assert run.trace is not None
    assert run.trace["BLOCK"].tolist().index(10.0) == 6


def test_nobody_answers_and_the_program_waits_forever() -> None:
    """Without acknowledgement M111 holds its program until the run's limit."""
    run = Controller(DEMO).run(NcText("p.nc", "M111\nG00 X1\nM30"), plc=silent(), ticks=500)
    assert run.state == "limit"
    assert run.ticks == 500


def test_a_reset_frees_all_slots() -> None:
    """What waited for the PLC is gone after a reset (RC-007)."""
    controller = Controller(DEMO)
    machine_of(controller).channels[0].hli.acknowledges_itself = False
    controller.start(NcText("p.nc", once(20) + "M111\nG00 X1\nM30"))
    controller.step(3)
    hli = PlcView(machine_of(controller))
    assert len(hli.functions()) == 21
    controller.reset()
    assert hli.functions() == []
    controller.start(NcText("p.nc", once(20) + "G04 X0.002\nM30"))
    controller.step(5)
    assert controller.state == "ready"


def test_what_a_plc_writes_counts_from_the_next_tick() -> None:
    """A value written after tick n is read by the cycles of tick n + 1 (RC-002)."""

    def answer(hli: PlcView) -> None:
        if hli.tick == 3:
            hli.write("V.E.TRIGGER", 1)

    text = "#RT CYCLE\n$IF EDGE V.E.TRIGGER\nM100\n$ENDIF\n#RT CYCLE END\nG04 X0.01\nM30"
    run = Controller(DEMO).run(NcText("p.nc", text), plc=Script(answer))
    assert [one.tick for one in run.technology] == [4]


def test_override_and_feed_hold_of_the_plc_act_in_the_next_tick() -> None:
    """The operator's override and feed hold are latched like any input (MO-5, MO-6)."""

    def answer(hli: PlcView) -> None:
        if hli.tick == 9:
            hli.override_pct = 0.0
        if hli.tick == 59:
            hli.override_pct = 100.0
        if hli.tick == 69:
            hli.feed_hold = True
        if hli.tick == 119:
            hli.feed_hold = False

    run = Controller(DEMO).run(
        NcText("p.nc", "G00 X50\nM30"),
        plc=Script(answer),
        signals=["PATH.SPEED", "OVERRIDE.VEL.TOTAL", "X.ACS.ACT_POS"],
    )
    assert run.trace is not None
    speeds = [round(speed, 6) for speed in run.trace["PATH.SPEED"].tolist()]
    assert speeds[:21] == [*range(4, 44, 4), *range(36, -4, -4), 0]
    assert set(speeds[20:60]) == {0}
    assert speeds[60:80] == [*range(4, 44, 4), *range(36, -4, -4)]
    assert set(speeds[80:120]) == {0}
    assert speeds[120] == 4
    totals = run.trace["OVERRIDE.VEL.TOTAL"].tolist()
    assert totals[9:11] == [100, 0]
    assert totals[59:61] == [0, 100]
    assert run.trace.at(run.ticks - 1, "X.ACS.ACT_POS") == 50.0
