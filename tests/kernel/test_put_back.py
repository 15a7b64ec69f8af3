# SPDX-License-Identifier: MIT
"""A realtime part that was put back is as a new one, object by object.

``test_state.py`` finds fields that no copy has in the sources, ``test_snapshot.py`` compares runs.
Here all objects of a part that has run are compared with those of a new one, whatever they hold:
also what is in lists and in arrays, and what is read in rare cases only.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from support import run_folders
from support.insides import machine_of
from support.program_generator import program
from support.random_seeds import MANY, all_seeds

from nctakt.base.mode import is_compiled
from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.run.access.machine_names import names_of_machine
from nctakt.run.controller import Controller, NcText
from nctakt.run.realtime.realtime_part import RealtimePart
from nctakt.run.realtime.snapshot import Snapshot

#: Of this many run folders one is taken, unless ``NCTAKT_SEEDS`` asks for all.
EACH = 1 if MANY else 24

#: Arrays of which nothing is read before it is written again, as in ``test_state.py``.
UNREAD = {"events", "probes", "rows", "history_rows"}

pytestmark = pytest.mark.skipif(is_compiled(), reason="fields of compiled objects are not seen")


class Lent:
    """A controller on a part that was put back, which is compared with a new controller."""

    def __init__(self) -> None:
        self.machine: Machine | None = None
        self.schedule: Any = None
        self.part: RealtimePart | None = None
        self.snapshot: Snapshot | None = None

    def controller(self, machine: Any = None, schedule: Any = None) -> Controller:
        """Return the controller."""
        self.machine, self.schedule = load_machine(machine), schedule
        self.part = RealtimePart(self.machine, names_of_machine(self.machine).layout)
        self.snapshot = Snapshot(self.part)
        return Controller(self.machine, schedule, realtime=self.part)

    def differences(self) -> list[str]:
        """Return what is not as in a new controller once the part has been put back."""
        assert self.machine is not None
        assert self.snapshot is not None
        self.snapshot.put_back()
        again, new = (
            machine_of(Controller(self.machine, self.schedule, realtime=part)).realtime.kernel
            for part in (self.part, None)
        )
        return list(differences(again, new))


def differences(one: object, other: object) -> Iterator[str]:
    """Yield the fields in which two trees of objects differ."""
    waiting: list[tuple[object, object, str]] = [(one, other, "kernel")]
    seen: set[int] = set()
    while waiting:
        a, b, name = waiting.pop()
        if id(a) in seen:
            continue
        if isinstance(a, memoryview | bytearray):
            is_unread = name.rpartition(".")[2] in UNREAD
            if not is_unread and (type(a) is not type(b) or bytes(a) != bytes(b)):  # type: ignore[call-overload]
                yield name
        elif isinstance(a, list | tuple):
            if not isinstance(b, list | tuple) or len(a) != len(b):
                yield f"{name}: length"
                continue
            waiting += [(x, y, f"{name}[{i}]") for i, (x, y) in enumerate(zip(a, b, strict=True))]
        elif type(a).__module__.startswith("nctakt.kernel"):
            seen.add(id(a))
            if type(a) is not type(b) or vars(a).keys() != vars(b).keys():
                yield f"{name}: {type(a).__name__}, {type(b).__name__}"
                continue
            waiting += [(vars(a)[key], vars(b)[key], f"{name}.{key}") for key in vars(a)]
        elif a != b and not (isinstance(a, float) and isinstance(b, float) and math.isnan(a)):
            yield f"{name}: {a!r}, {b!r}"


@pytest.mark.parametrize("name", run_folders.FOLDERS[::EACH])
def test_a_part_put_back_after_a_run_is_a_new_one(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """After the runs of the folders, with their own channels, lists, PLC and schedules."""
    lent = Lent()
    monkeypatch.setattr(run_folders, "Controller", lent.controller)
    run_folders.perform(run_folders.HERE / name, set(), tmp_path)
    assert lent.differences() == []


@pytest.mark.parametrize("seed", all_seeds(compiled=0, plain=3))
def test_a_part_put_back_after_a_random_program_is_a_new_one(seed: int) -> None:
    """And after half of it, with cycles that still run."""
    lent = Lent()
    controller = lent.controller()
    controller.start(NcText(f"p{seed}.nc", program(seed)))
    controller.step(300)
    assert lent.differences() == []
    lent = Lent()
    lent.controller().run(NcText(f"p{seed}.nc", program(seed)), ticks=1500)
    assert lent.differences() == []


def test_a_forgotten_field_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    """The comparison finds a number and an element of an array."""
    lent = Lent()
    controller = lent.controller()
    controller.run(NcText("p.nc", "G01 X1 F6000\nM30\n"))
    monkeypatch.setattr(lent.snapshot, "put_back", lambda: None)
    found = lent.differences()
    assert any(one.startswith("kernel.tick: ") for one in found)
    assert any(one.endswith("cells") for one in found)
