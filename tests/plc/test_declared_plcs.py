# SPDX-License-Identifier: MIT
"""PLCs that are called when what they declare has come: the same runs as those of each tick.

The realtime part looks for what such a PLC waits for (RC-002: what it answers after a tick counts
from the next one on).
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest

from nctakt.base.failure import Failure
from nctakt.plc import ALL, NONE, Plc, after, at, load_plc, on, only, run_up, when
from nctakt.results.run import Run
from nctakt.run.access.input_words import API
from nctakt.run.access.inputs import Cells, Input, unpack
from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import PlcView

PROGRAM = """
#RT CYCLE [SCOPE=PROG]
$IF EDGE V.E.TRIGGER == 1
M101 M100 H100
$ENDIF
#RT CYCLE END
G01 X20 F6000 M100
M102
S3[M3 REV=500]
G01 X0 Y5
M100
S3[M5]
M30
"""

POLICIES = (
    ALL,
    NONE,
    after("3 ticks"),
    after("2.5 ms"),
    only("M100", "h100"),
    only("M100", "M101", then=only("M101", then=after("7 ticks"))),
)


class Cell(Plc):
    """Declares something of each kind, and notes when it is called."""

    spindles = run_up(20_000)
    calls: list[tuple[str, int]]

    def __init__(self) -> None:
        self.calls = []

    @at("0.05 s")
    def pull(self, hli: PlcView) -> None:
        self.calls.append(("pull", hli.tick))
        hli.write("V.E.TRIGGER", 1)

    @at("90 ticks")
    def slow_down(self, hli: PlcView) -> None:
        self.calls.append(("slow", hli.tick))
        hli.override_pct = 60

    @when("V.RTA.ACS.ACT_POS.X > 10")
    def far(self, hli: PlcView) -> None:
        self.calls.append(("far", hli.tick))
        hli.write("V.E.VALUE", hli.axis("X").command)

    @when("V.RTA.ACS.ACT_POS.X < 5 && V.E.VALUE > 1")
    def near(self, hli: PlcView) -> None:
        self.calls.append(("near", hli.tick))

    @on("M100", "S3")
    def appears(self, hli: PlcView, entry: Any) -> None:
        self.calls.append((entry.name, hli.tick))
        if entry.name == "M100" and len(self.calls) % 2:
            hli.acknowledge(entry)


def called_each_tick(kind: type[Cell]) -> type[Cell]:
    """Return the class with a method that has to be called after each tick."""

    class Each(kind):  # type: ignore[misc,valid-type]
        def each_tick(self, hli: PlcView) -> None:
            """Called after each tick, for nothing."""

    return Each


def recorded(plc: Plc, **words: Any) -> tuple[Run, list[Input]]:
    """Run the program with a PLC; return the run and all its inputs."""
    cells: Cells = []
    run = Controller().run(
        NcText("p.nc", PROGRAM), plc=plc, record=cells.extend, blocks=True, ticks=700, **words
    )
    return run, unpack(cells)


@pytest.mark.parametrize("policy", POLICIES, ids=range(len(POLICIES)))
def test_the_same_run_as_with_a_call_after_each_tick(policy: Any) -> None:
    """Events, inputs for the tape, calls and their ticks do not depend on how it is called."""

    class Declared(Cell):
        acknowledge = policy

    one, other = Declared(), called_each_tick(Declared)()
    first, second = recorded(one), recorded(other)
    assert one.calls == other.calls
    assert one.calls
    assert first[1] == second[1]
    assert first[0].ticks == second[0].ticks
    assert list(first[0].trace.events) == list(second[0].trace.events)
    unheard = Controller().run(NcText("p.nc", PROGRAM), plc=Declared(), blocks=True, ticks=700)
    assert list(unheard.trace.events) == list(first[0].trace.events)


def test_the_tick_of_each_call() -> None:
    """The ticks by hand: 6000 mm/min are 0.1 mm a tick once the axis has its speed."""
    plc = Cell()
    recorded(plc)
    ticks = dict(reversed(plc.calls))
    assert ticks["pull"] == 49  # what it writes counts from tick 50 on, 0.05 s after the begin
    assert ticks["slow"] == 89
    assert ticks["M100"] == 0


def test_only_what_is_due_calls_it(monkeypatch: pytest.MonkeyPatch) -> None:
    """Three functions that appear in two ticks, one time, one condition, and the first tick."""
    calls: list[int] = []
    inner = Plc._cycle_without_functions

    def counted(plc: Plc, hli: PlcView) -> None:
        calls.append(hli.tick)
        inner(plc, hli)

    monkeypatch.setattr(Plc, "_cycle_without_functions", counted)

    class Rare(Plc):
        acknowledge = after("20 ticks")

        @at("0.3 s")
        def late(self, hli: PlcView) -> None:
            """Do nothing."""

        @when("V.RTA.ACS.ACT_POS.X > 10")
        def far(self, hli: PlcView) -> None:
            """Do nothing."""

    run = Controller().run(NcText("p.nc", "M100\nG01 X50 F6000\nM30"), plc=Rare())
    assert run.state == "ended"
    assert len(calls) == 3
    assert calls[0] == 0
    assert calls[2] == 299


def test_a_policy_that_a_handler_changes() -> None:
    """Acknowledgements after the call already follow the new policy, as with each tick."""

    class Changing(Cell):
        acknowledge = NONE

        @when("V.RTA.ACS.ACT_POS.X > 10")
        def far(self, hli: PlcView) -> None:
            self.acknowledge = after("2 ticks")  # type: ignore[misc]

    first, second = recorded(Changing()), recorded(called_each_tick(Changing)())
    assert first[1] == second[1]
    assert first[0].ticks == second[0].ticks


class UsersPolicy:
    """Acknowledges every second function, when a variable says so."""

    def answers(self, function: Any, hli: PlcView) -> bool:
        """Return whether to acknowledge it."""
        return hli.tick % 7 == 0


def test_a_policy_of_the_users_own() -> None:
    """It is asked after each tick in which something waits."""

    class Own(Cell):
        acknowledge = UsersPolicy()

    first, second = recorded(Own()), recorded(called_each_tick(Own)())
    assert first[1] == second[1]
    assert first[0].ticks == second[0].ticks


def test_replaying_the_inputs_gives_the_same_events() -> None:
    """What the realtime part acknowledges for the PLC is on the tape."""

    class Tape:
        has_plc = True

        def __init__(self, inputs: list[Input]) -> None:
            self.inputs = inputs

    class Late(Cell):
        acknowledge = after("11 ticks")

    run, inputs = recorded(Late())
    again = Controller().run(
        NcText("p.nc", PROGRAM),
        replay=Tape(inputs),  # type: ignore[arg-type]
        blocks=True,
        ticks=700,
    )
    assert list(again.trace.events) == list(run.trace.events)


def test_a_mistake_in_a_condition_has_a_caret(tmp_path: Path) -> None:
    """All mistakes of all conditions, at their places in the PLC's file."""
    path = tmp_path / "cell.py"
    path.write_text(
        "from nctakt import Plc, when\n\n\n"
        "class Cell(Plc):\n"
        '    @when("V.RTA.ACS.ACT_PSO.X > 400")\n'
        "    def far(self, hli):\n"
        "        pass\n\n"
        '    @when("V.E.VALUE > ")\n'
        "    def full(self, hli):\n"
        "        pass\n"
    )
    with pytest.raises(Failure) as failure:
        Controller().run(NcText("p.nc", "M30"), plc=load_plc(path))
    shown = [(str(one.span), one.render()) for one in failure.value.diagnostics]
    assert shown[0][0] == f"{path}:5:12"
    assert '    @when("V.RTA.ACS.ACT_PSO.X > 400")\n' in shown[0][1]
    assert "^" in shown[0][1]
    assert shown[-1][0].startswith(f"{path}:9:")


@pytest.mark.parametrize(
    ("text", "word"),
    [("V.E.VALUE >> 20 $$", "a value is missing"), ("V.E.VALUE > 5 $ENDIF", "'$ENDIF' is not")],
)
def test_a_mistake_in_a_condition_is_reported_once(text: str, word: str) -> None:
    """What it does to the cycle around the text is no mistake of the user's."""

    class Cell(Plc):
        @when(text)
        def full(self, hli: PlcView) -> None:
            """Do nothing."""

    with pytest.raises(Failure) as failure:
        Controller().run(NcText("p.nc", "M30"), plc=Cell())
    (found,) = failure.value.diagnostics
    assert word in found.headline()


def test_a_condition_that_is_made_of_parts() -> None:
    """If the text is not in the file, the mistake is shown in the text itself."""
    kind = "VALUE"

    class Cell(Plc):
        @when(f"V.E.{kind}X > 4")
        def full(self, hli: PlcView) -> None:
            """Do nothing."""

    with pytest.raises(Failure, match=r"V\.E\.VALUEX") as failure:
        Controller().run(NcText("p.nc", "M30"), plc=Cell())
    assert failure.value.diagnostics[0].source_line == "V.E.VALUEX > 4"


@pytest.mark.parametrize(
    ("text", "expected"),
    [("V.E.VALUE < 5", [0, 5]), ("1 / [V.E.VALUE - V.E.VALUE] > 0", [])],
    ids=["true_from_the_beginning", "without_a_value"],
)
def test_when_a_condition_calls(text: str, expected: list[int]) -> None:
    """After the first tick if it is true then, and each time that it becomes true again."""
    calls: list[int] = []

    class Cell(Plc):
        @when(text)
        def low(self, hli: PlcView) -> None:
            calls.append(hli.tick)

        @at("3 ticks")
        def high(self, hli: PlcView) -> None:
            hli.write("V.E.VALUE", 9)

        @at("5 ticks")
        def again(self, hli: PlcView) -> None:
            hli.write("V.E.VALUE", 1)

    run = Controller().run(NcText("p.nc", "G04 X0.010\nM30"), plc=Cell())
    assert run.state == "ended"
    assert calls == expected


def test_a_function_as_a_condition_is_called_after_each_tick() -> None:
    """902140 says so; a text has no such note."""
    ticks: list[int] = []

    def condition(hli: PlcView) -> bool:
        ticks.append(hli.tick)
        return False

    class Cell(Plc):
        @when(condition)
        def full(self, hli: PlcView) -> None:
            """Do nothing."""

    run = Controller().run(NcText("p.nc", "G04 X0.010\nM30"), plc=Cell())
    assert ticks == list(range(run.ticks))
    assert [one.id for one in run.diagnostics] == [902140, 901014]


class Raising:
    """Raises in its third call."""

    def __init__(self) -> None:
        self.count = 0

    def cycle(self, hli: PlcView) -> None:
        """Count the calls."""
        self.count += 1
        if self.count == 3:
            raise ZeroDivisionError(hli.tick)


def test_what_a_plc_raises_ends_the_step_in_its_tick() -> None:
    """The exception comes through as it is, after the tick that was run."""
    controller = Controller()
    controller.start(NcText("p.nc", "G01 X50 F6000\nM30"), plc=Raising())
    with pytest.raises(ZeroDivisionError, match="2"):
        controller.step(100)
    assert controller.tick == 3


def test_bound_values() -> None:
    """RC-307, RC-002: a bound value converts and refuses as ``write``, and is read at once."""
    controller = Controller()
    count, flag = controller.bind("V.E.COUNT"), controller.bind("HLI.FEED_HOLD")
    override, place = controller.bind("HLI.OVERRIDE"), controller.bind("V.RTA.ACS.ACT_POS.X")
    for number, stored in ((2.5, 2.0), (3.5, 4.0), (True, 1.0)):
        count.value = number
        assert count.value == controller.read("V.E.COUNT") == stored
    flag.value = 0.6
    assert flag.value is True
    controller.step(1)
    assert (count.value, flag.value) == (1.0, True)
    for bound, wrong in (
        (count, math.nan), (count, math.inf), (count, "a"), (count, 1e300), (count, None),
        (override, -1.0), (place, 1.0),
    ):  # fmt: skip
        with pytest.raises(Failure):
            bound.value = wrong  # type: ignore[assignment]
    with pytest.raises(Failure, match=r"V\.E\.COUNT"):
        controller.bind("V.E.CUONT")
    assert (count.source, repr(override)) == (API, "<HLI.OVERRIDE = 100.0>")


def test_values_of_axis_and_channel_are_the_present_ones() -> None:
    """Views are bound once; ``dict`` keeps the values of a moment."""
    controller = Controller()
    axis, channel = controller.hli.axis("X"), controller.hli.channel()
    controller.start(NcText("p.nc", "G01 X50 F6000\nM30"))
    controller.step(100)
    before = dict(axis)
    controller.step(10)
    assert axis.command == axis["command"] > before["command"] > 0.0
    assert channel.path_speed == pytest.approx(100.0)
    assert channel.state == channel["state"] == 1.0
    with pytest.raises(AttributeError, match="did you mean command"):
        axis.comand  # noqa: B018
    with pytest.raises(Failure, match="901012"):
        axis["comand"]
    with pytest.raises(AttributeError):
        axis.command = 3.0


def test_what_a_plc_writes_is_read_before_it_acts() -> None:
    """RC-002: it counts from the next tick on; whoever reads it sees it at once."""
    seen: list[object] = []

    class Counts:
        def cycle(self, hli: PlcView) -> None:
            """Count ticks."""
            hli.variable("V.E.COUNT").value = hli.tick + 10
            seen.append((hli.read("V.E.COUNT"), hli.variable("V.E.COUNT").value))

    Controller().run(NcText("p.nc", "G04 X0.003\nM30"), plc=Counts(), ticks=3)
    assert seen == [(10.0, 10.0), (11.0, 11.0), (12.0, 12.0)]
