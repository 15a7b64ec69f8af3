# SPDX-License-Identifier: MIT
"""Wrong types in the public face: a ``Failure`` that names the argument, never a bare TypeError."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import Any

import pytest

import nctakt
from nctakt import Controller, Failure, HliView, NcText, Plc, Stimulus, Study

#: The number of the message.
WRONG = 901186
PROGRAM = NcText("move.nc", "G01 X10 F6000\nM30")

CALLS: dict[str, Callable[[Any], object]] = {
    "ticks": lambda value: Controller().step(value),
    "channel": lambda value: Controller().start(PROGRAM, value),
    "channel of select": lambda value: Controller().select(PROGRAM, value),
    "channel of reset": lambda value: Controller().reset(value),
    "channel of backward": lambda value: Controller().backward(value),
    "channel of forward": lambda value: Controller().forward(value),
    "ticks of run": lambda value: Controller().run(PROGRAM, ticks=value),
    "skip": lambda value: Controller().run(PROGRAM, skip=[value]),
}


@pytest.mark.parametrize("call", CALLS)
@pytest.mark.parametrize("value", ["3", 2.5, True, -1, [1], float("nan")], ids=repr)
def test_what_is_no_whole_number(call: str, value: object) -> None:
    """A text, a fraction, a truth value, a negative number, a list."""
    with pytest.raises(Failure) as failure:
        CALLS[call](value)
    (found,) = failure.value.diagnostics
    assert found.id == WRONG
    name, _, _ = call.partition(" ")
    assert found.text("en").startswith(f"{name} must be a whole number from 0 on, not ")
    assert found.text("de").startswith(f"{name} muss eine ganze Zahl ab 0 sein, nicht ")


@pytest.mark.parametrize(
    "call",
    [
        lambda: Controller(2.5),  # type: ignore[arg-type]
        lambda: nctakt.load_machine([]),  # type: ignore[arg-type]
        lambda: nctakt.open_schedule(None),  # type: ignore[arg-type]
        lambda: nctakt.simulate_schedule("rtconf.lis"),  # type: ignore[arg-type]
        lambda: Controller().read(None),  # type: ignore[arg-type]
        lambda: Controller().signal(3),  # type: ignore[arg-type]
        lambda: Controller().write(None, 1),  # type: ignore[arg-type]
        lambda: Controller().write("V.E.COUNT", None),  # type: ignore[arg-type]
        lambda: Controller().interface_image(3),  # type: ignore[arg-type]
        lambda: Controller().run(None),  # type: ignore[arg-type]
        lambda: Controller().start(3),  # type: ignore[arg-type]
        lambda: Controller().select([]),  # type: ignore[arg-type]
        lambda: Controller().run(NcText(None, "M30")),  # type: ignore[arg-type]
        lambda: Controller().run(NcText("a.nc", None)),  # type: ignore[arg-type]
        lambda: Controller().run(PROGRAM, channels="p.nc"),  # type: ignore[arg-type]
        lambda: Controller().run(channels={1: "p.nc"}),
        lambda: Controller().run(PROGRAM, set="V.E.COUNT=1"),  # type: ignore[arg-type]
        lambda: Controller().run(PROGRAM, at=5),  # type: ignore[arg-type]
        lambda: Controller().run(PROGRAM, signals="V.E.COUNT"),
        lambda: Controller().run(PROGRAM, sinks=None),  # type: ignore[arg-type]
        lambda: Controller().run(PROGRAM, skip=None),  # type: ignore[arg-type]
        lambda: Controller().run(PROGRAM, plc="plc.py"),  # type: ignore[arg-type]
        lambda: Controller().run(PROGRAM, on_message="print"),  # type: ignore[arg-type]
        lambda: Controller().run(PROGRAM, on_progress=3),  # type: ignore[arg-type]
        lambda: Controller().run(PROGRAM, replay="run.tape"),  # type: ignore[arg-type]
        lambda: nctakt.check("part.nc", 5),  # type: ignore[arg-type]
        lambda: Study(5),  # type: ignore[arg-type]
        lambda: Stimulus("1 ms", None, 1),  # type: ignore[arg-type]
        lambda: Stimulus("1 ms", "V.E.COUNT", None),  # type: ignore[arg-type]
    ],
    ids=itertools.count(),
)
def test_other_wrong_types(call: Callable[[], object]) -> None:
    """The message names the argument, what it must be, and the value."""
    with pytest.raises(Failure) as failure:
        call()
    assert [one.id for one in failure.value.diagnostics] == [WRONG]
    assert failure.value.diagnostics[0].remedy("en")


def test_numbers_of_numpy_are_numbers() -> None:
    """Each kind of scalar, of each argument, gives the run that the number of Python gives."""
    numpy = pytest.importorskip("numpy")
    program = NcText("move.nc", "N10 G01 X[V.E.VALUE] F6000\nN20 M30")
    assert Controller().step(numpy.int64(3)).ticks == 3
    assert Controller().step(numpy.timedelta64(20, "ms")).ticks == 20
    assert Controller().step(numpy.timedelta64(1_000_001, "ns")).ticks == 2
    for plain, value in ((3, numpy.int64(3)), (2.5, numpy.float32(2.5)), (1, numpy.bool_(True))):
        expected = Controller().run(program, set={"V.E.VALUE": plain})
        assert Controller().run(program, set={"V.E.VALUE": value}) == expected
        at = ("1 ms", "V.E.VALUE", value)
        assert type(Stimulus(*at).value) in (int, float, bool)
        bound = Controller().bind("V.E.VALUE")
        bound.value = value
        assert bound.value == plain
    study = Study(
        program=program,
        set={"V.E.VALUE": numpy.float32(1)},
        vary=[{"variable": "HLI.OVERRIDE", "values": numpy.linspace(50, 100, 3)}],
        seed=numpy.int64(4),
    )
    assert study.run().column("HLI.OVERRIDE") == [50.0, 75.0, 100.0]


def test_a_class_of_plcs_makes_a_new_one_for_each_run() -> None:
    """A class that needs arguments is refused, and so is one that is no PLC."""

    class Counting(Plc):
        ticks = 0

        def cycle(self, hli: HliView) -> None:
            self.ticks += 1
            hli.override_pct = 100 - self.ticks

    class Needy(Counting):
        def __init__(self, size: int) -> None:
            self.size = size

    program = NcText("move.nc", "G01 X1 F6000\nM30")
    assert Controller().run(program, plc=Counting) == Controller().run(program, plc=Counting())
    controller = Controller()
    controller.start(program, plc=Counting)
    controller.step(5)
    assert controller.hli.override_pct == 95
    for wrong in (Needy, int):
        with pytest.raises(Failure) as failure:
            Controller().run(program, plc=wrong)  # type: ignore[arg-type]
        assert failure.value.diagnostics[0].id == WRONG
