# SPDX-License-Identifier: MIT
"""PLCs that run in the realtime part, as seen by a run, and groups of PLCs."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from nctakt.base.diagnostics import Diagnostic, Text
from nctakt.base.failure import Failure
from nctakt.kernel.st.tasks import PlcPair, PlcSide
from nctakt.lists.format import arguments
from nctakt.messages import diagnostic
from nctakt.messages.plcs.plc import SEVERAL_CALLED_PLCS
from nctakt.run.access.named_values import NamedValues, SignalCell
from nctakt.run.plcs.plc_view import AnyPlc, GivenPlc, PlcView, WatchedPlc

if TYPE_CHECKING:
    from nctakt.results.coverage import Coverage
    from nctakt.results.explained.plc_histories import PlcHistory
    from nctakt.run.realtime.assembly import AssembledMachine

_PLC = Text(
    "a Plc, or a class of PLCs that needs no arguments",
    "eine Plc oder eine Klasse davon, die keine Argumente braucht",
)


def is_structured(path: str | Path | None) -> bool:
    """Return whether a PLC's file is Structured Text, which runs again where a tape is replayed."""
    if path is None:
        return False
    from nctakt.st.files.suffixes import PLC_SUFFIXES  # noqa: PLC0415 - a plain run reads no XML

    return Path(path).suffix.lower() in PLC_SUFFIXES


class RealtimePlc(WatchedPlc):
    """A PLC whose tasks run in the tick; it acknowledges only in areas announced.

    ``is_replayed``: what Python did for its blocks comes from a tape.
    """

    is_replayed = False

    def cycle(self, hli: PlcView) -> None:
        """Do nothing: its tasks run in the tick."""

    @property
    def name(self) -> str:
        """The name of its project."""
        return ""

    def attach(self, machine: AssembledMachine) -> NamedValues:
        """Restart on a machine, before its next tick; return its variables."""
        raise NotImplementedError

    def side(self) -> PlcSide:
        """Return the part that runs in the tick, once it is attached."""
        raise NotImplementedError

    def blocks_in_python(
        self, write: Callable[[str, float | bool | str], None]
    ) -> Callable[[PlcView], None] | None:
        """Return what Python does for its blocks after each tick, once it is attached.

        ``write`` sets a variable by its path.
        """
        return None

    def explain(self) -> None:
        """Count its branches and note its changes from the next ``attach`` on, if it can."""
        self.count_branches()

    def count_branches(self) -> None:
        """Count the runs of its branches from the next ``attach`` on, if it can."""

    def changes(self) -> Sequence[PlcHistory]:
        """Return its changes since it was attached, and why, if that is noted."""
        return ()

    def coverage(self) -> Coverage | None:
        """Return which branches have run since it was attached; ``None`` if not counted."""
        return None

    def data(self) -> memoryview:
        """Return its data, once it is attached."""
        return memoryview(b"")

    @property
    def files(self) -> Sequence[str]:
        """The files that it was read from."""
        return ()

    def record_messages(self) -> None:
        """Record the texts that its code has reported in the latest tick as events, if it can."""

    def news(self) -> Sequence[Diagnostic]:
        """Return the faults that have stopped it since the last call."""
        raise NotImplementedError

    def end(self) -> Sequence[Diagnostic]:
        """Run its actions after its last cycle; return a fault in them."""
        raise NotImplementedError


class PlcGroup(WatchedPlc):
    """Several PLCs of one machine, in the order of their tasks in a tick.

    All but one of them run in the tick; that one may be a PLC in Python. Raises ``Failure`` for a
    second one in Python (902761).

    >>> both = PlcGroup([PlcGroup([])])
    >>> len(both.realtime), both.called
    (0, None)
    """

    def __init__(self, plcs: Sequence[AnyPlc]) -> None:
        self.realtime: list[RealtimePlc] = []
        called: list[AnyPlc] = []
        for plc in plcs:
            realtime, other = parts_of(plc)
            self.realtime += realtime
            called += [] if other is None else [other]
        if len(called) > 1:
            raise Failure(diagnostic(SEVERAL_CALLED_PLCS))
        self.called: AnyPlc | None = called[0] if called else None

    def _watched(self) -> list[WatchedPlc]:
        found: list[WatchedPlc] = [*self.realtime]
        if isinstance(self.called, WatchedPlc):
            found.append(self.called)
        return found

    def cycle(self, hli: PlcView) -> None:
        """Call the PLC in Python."""
        if self.called is not None:
            self.called.cycle(hli)

    def begin_run(self, hli: PlcView) -> None:
        """Let each of them begin."""
        for plc in self._watched():
            plc.begin_run(hli)

    def notes(self) -> Sequence[Diagnostic]:
        """Return the notes of all."""
        return [note for plc in self._watched() for note in plc.notes()]

    def unused_handlers(self, hli: PlcView) -> Sequence[Diagnostic]:
        """Return the unused methods of all."""
        return [one for plc in self._watched() for one in plc.unused_handlers(hli)]


def plc_object(plc: GivenPlc | Sequence[GivenPlc] | None) -> AnyPlc | None:
    """Return the PLC: for a class a new object, for several PLCs a group.

    Raises ``Failure`` for anything else (901186), and for a second PLC in Python (902761).
    """
    if isinstance(plc, Sequence) and not isinstance(plc, str):
        plcs = [found for one in plc if (found := plc_object(one)) is not None]
        return PlcGroup(plcs) if len(plcs) > 1 else next(iter(plcs), None)
    if not isinstance(plc, type):
        return plc
    if not hasattr(plc, "cycle") or not _needs_nothing(plc):
        arguments.refuse("plc", plc, _PLC)
    return plc()


def _needs_nothing(plc: type[AnyPlc]) -> bool:
    """Return whether a class makes objects without arguments."""
    try:
        inspect.signature(plc).bind()
    except TypeError:
        return False
    return True


def has_called_plc(plc: AnyPlc | None) -> bool:
    """Return whether Python calls a PLC, so that a tape has its actions."""
    return parts_of(plc)[1] is not None


def parts_of(plc: AnyPlc | None) -> tuple[list[RealtimePlc], AnyPlc | None]:
    """Return the PLCs that run in the tick, and the one that Python calls."""
    if isinstance(plc, PlcGroup):
        return plc.realtime, plc.called
    if isinstance(plc, RealtimePlc):
        return [plc], None
    return [], plc


def files_of(plc: AnyPlc | None) -> list[str]:
    """Return the files of the PLCs that run in the tick."""
    return [file for one in parts_of(plc)[0] for file in one.files]


def memories_of(plc: AnyPlc | None) -> list[memoryview]:
    """Return the data of the PLCs that run in the tick, once they are attached."""
    return [one.data() for one in parts_of(plc)[0]]


def side_of(plcs: Sequence[RealtimePlc]) -> PlcSide:
    """Return the parts of these PLCs that run in the tick, once they are attached."""
    if not plcs:
        return PlcSide()
    first, *others = plcs
    return PlcPair(first.side(), side_of(others)) if others else first.side()


def distinct_names(projects: Sequence[str]) -> list[str]:
    """Return the names that distinguish several projects."""
    found: list[str] = []
    for name in projects:
        taken = {one.lower() for one in found}
        names = (name, *(f"{name}_{number}" for number in range(2, len(projects) + 2)))
        found.append(next(one for one in names if one.lower() not in taken))
    return found


class NamedGroup:
    """The variables of several PLCs by their paths, with or without the project before them.

    Without a project, a path belongs to the first PLC that knows it. The second of several projects
    of one name is ``NAME_2``.
    """

    def __init__(self, parts: Sequence[NamedValues], projects: Sequence[str]) -> None:
        self._parts = parts
        self._projects = distinct_names(projects)

    def path(self, number: int, path: str) -> str:
        """Return the name here of a variable of a PLC, which has it at ``path``."""
        is_first = not any(part.knows(path) for part in self._parts[:number])
        return path if is_first else f"{self._projects[number]}.{path}"

    def _of(self, name: str) -> tuple[NamedValues, str]:
        """Return the PLC that has a variable, and its path there."""
        for project, part in zip(self._projects, self._parts, strict=True):
            path = name[len(project) + 1 :]
            if name.lower().startswith(f"{project.lower()}.") and part.knows(path):
                return part, path
        return next((part for part in self._parts if part.knows(name)), self._parts[0]), name

    def knows(self, name: str) -> bool:
        """Return whether a name is one of their variables."""
        part, path = self._of(name)
        return part.knows(path)

    def names(self, *, are_numbers: bool) -> Iterator[str]:
        """Yield the paths of their values."""
        for number, part in enumerate(self._parts):
            for path in part.names(are_numbers=are_numbers):
                yield self.path(number, path)

    def read(self, name: str) -> float | bool | str:
        """Return the value of a variable."""
        part, path = self._of(name)
        return part.read(path)

    def check(self, name: str, value: float | bool | str) -> object:
        """Raise ``Failure`` for a value that the variable cannot hold."""
        part, path = self._of(name)
        return part.check(path, value)

    def write(self, name: str, value: float | bool | str) -> None:
        """Set a variable from its next cycle on."""
        part, path = self._of(name)
        part.write(path, value)

    def mistake(self, name: str) -> Diagnostic | None:
        """Return the mistake in the path of a missing part, or of one that is not a signal."""
        own = [name, *(name[len(one) + 1 :] for one in self._projects)]
        asked = ((part, path) for part in self._parts for path in own if path)
        return next(filter(None, (part.mistake(path) for part, path in asked)), None)

    def signal(self, name: str) -> SignalCell | None:
        """Return where a variable is shown in each tick; ``None`` if it is not a number."""
        part, path = self._of(name)
        return part.signal(path)
