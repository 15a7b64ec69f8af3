# SPDX-License-Identifier: MIT
"""Wrong types in the public face: a ``Failure`` that names the argument, never a bare TypeError."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import Any

import pytest

import nctakt
from nctakt import Controller, Failure, NcText, Stimulus

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


def test_numbers_of_other_libraries_count() -> None:
    """Whatever is an index of a list is a number of ticks."""
    numpy = pytest.importorskip("numpy")
    assert Controller().step(numpy.int64(3)).ticks == 3
