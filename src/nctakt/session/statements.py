# SPDX-License-Identifier: MIT
"""The statements of a session's PLC in one controller: stops at them, inspection of a tick.

In: stops, numbers of statements within a tick, paths of variables. Out: the kernel's stops; where
in a tick something has held; calls and values where the PLC has halted or failed.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.kernel.cycles.expressions import Expression
from nctakt.kernel.st.observing.probes import Sought
from nctakt.kernel.tick.stops import Faults, PassesStatement, Stop
from nctakt.messages import diagnostic
from nctakt.messages.plc_debugging import NO_STATEMENT_THERE, NO_STRUCTURED_TEXT
from nctakt.plc.stepping.beside import Branch, Line
from nctakt.plc.stepping.debugging import PlcFrame, StDebugging
from nctakt.plc.stepping.shown import PlcValue
from nctakt.plc.structured_text import StructuredPlc
from nctakt.run.plcs.plc_view import AnyPlc
from nctakt.run.plcs.realtime_plc import parts_of


class Wanted(Protocol):
    """A stop at statements or at a fault, as ``stops.StopAt`` names it."""

    @property
    def kind(self) -> str:
        """``statement`` or ``fault``."""

    @property
    def text(self) -> str:
        """The number of a fault, empty: any."""

    @property
    def file(self) -> str:
        """The file, empty: any."""

    @property
    def line(self) -> int:
        """The line, 0: any statement."""

    @property
    def only_if(self) -> str:
        """The condition before it."""

    @property
    def count(self) -> int:
        """In how many ticks it must hold."""

    @property
    def max_depth(self) -> int:
        """How many calls may be open, 0: any number."""


@dataclass(frozen=True, slots=True)
class PlcPlace:
    """Where a session is in the cycle of a PLC.

    ``tick`` is the current one, ``number`` that of the next statement among those of the tick, from
    1 on; ``frames``: the open calls, the innermost first. ``fault``: why the PLC has stopped there
    for good, ``None`` if it keeps running.
    """

    tick: int
    number: int
    frames: tuple[PlcFrame, ...]
    fault: Diagnostic | None = None


class Statements:
    """A controller's knowledge of the statements of its PLC; at first there is no PLC."""

    def __init__(self) -> None:
        self._plc: StDebugging | None = None
        self._chains: dict[int, Sought] = {}
        self._sought: dict[Wanted, list[Sought]] = {}

    def follow(self, plc: AnyPlc | None) -> None:
        """Take the PLC of the controller, if it is one in Structured Text."""
        for one in parts_of(plc)[0]:
            if isinstance(one, StructuredPlc):
                self._plc = StDebugging(one)
                return

    @property
    def has_plc(self) -> bool:
        """Whether there is a PLC in Structured Text."""
        return self._plc is not None

    @property
    def plc(self) -> StDebugging:
        """The PLC; raises ``Failure`` (902810) if there is none."""
        if self._plc is None:
            raise Failure(diagnostic(NO_STRUCTURED_TEXT, what="statement"))
        return self._plc

    def texts(self) -> dict[str, tuple[str, ...]]:
        """Return the files of the PLC with their lines."""
        if self._plc is None:
            return {}
        program = self._plc.program
        return {file: tuple(program.sources.lines.get(file, ())) for file in program.files}

    def lines(self) -> dict[str, list[int]]:
        """Return by file the lines in which statements begin, in ascending order."""
        if self._plc is None:
            return {}
        return {file: sorted(own) for file, own in self._plc.lines.items()}

    # --- stops

    def begin(self) -> None:
        """Look for nothing any more."""
        self._chains, self._sought = {}, {}
        if self._plc is not None:
            self._plc.forget()

    def nodes(self, stop: Wanted, guard: Expression, *, is_watched: bool) -> list[Stop]:
        """Return the kernel's stops for a statement or a fault; raises ``Failure``."""
        if stop.kind == "fault":
            if self._plc is None:
                return []
            return [Faults(self._plc.context, int(stop.text or 0), guard, stop.count)]
        sources = self._sources(stop)
        if not is_watched:
            self.plc.check(sources, stop.only_if)
            return []
        found = self.plc.seek(sources, stop.only_if, stop.max_depth, self._chains)
        self._sought.setdefault(stop, []).extend(found)
        return [PassesStatement(one, guard, stop.count) for one in found]

    def _sources(self, stop: Wanted) -> list[int]:
        """Return the statements of a line; none means any statement."""
        lines = self.plc.lines
        if not stop.line:
            return []
        found = [
            own[stop.line]
            for file, own in lines.items()
            if stop.line in own and names_file(stop.file, file)
        ]
        if not found:
            raise Failure(diagnostic(NO_STATEMENT_THERE, line=stop.line, file=stop.file or "-"))
        return found

    # --- within a tick

    def within(self, after: int, before: int) -> None:
        """Note from now on the first hit after a statement, and the last before another."""
        self.plc.install().begin(0)
        for found in self._sought.values():
            for one in found:
                one.within(after, before)

    def met(self, stops: Sequence[Wanted]) -> list[tuple[int, int]]:
        """Return for each stop the first and the last statement at which it held, 0: none."""
        met = []
        for stop in stops:
            found = self._sought.get(stop, [])
            firsts = [one.first for one in found if one.first]
            met.append((min(firsts, default=0), max((one.last for one in found), default=0)))
        return met

    def passed(self) -> tuple[list[int], list[int]] | None:
        """Return sources and depths of the statements of a tick; ``None`` where it has too many."""
        counter = self.plc.install()
        count = counter.passed
        if count > len(counter.sources):
            return None
        sources, depths = memoryview(counter.sources), memoryview(counter.depths)
        return sources[:count].tolist(), depths[:count].tolist()

    def sources(self, stops: Sequence[Wanted]) -> list[list[int]]:
        """Return for each stop the statements that it means; none: any."""
        return [self._sources(stop) for stop in stops]

    def halt_at(self, number: int) -> None:
        """Halt before a statement of the ticks to come."""
        self.plc.install().begin(number)

    def stopped_at(self, tick: int, number: int) -> PlcPlace | None:
        """Return where the PLC has halted or failed; ``None`` if it keeps running."""
        if self._plc is None or not self._plc.has_stopped:
            return None
        frames = tuple(self._plc.frames())
        return PlcPlace(tick, number, frames, self._plc.fault()) if frames else None

    def scopes(self, level: int | None) -> list[str]:
        """Return the scopes of a call."""
        return self.plc.scopes(level)

    def of_scope(self, level: int | None, scope: str, first: int, count: int) -> list[PlcValue]:
        """Return the variables of a scope."""
        return self.plc.of_scope(level, scope, first, count)

    def below(self, level: int | None, path: str, first: int, count: int) -> list[PlcValue]:
        """Return the children of a variable."""
        return self.plc.below(level, path, first, count)

    def texts_beside(
        self, level: int | None, instance: str, file: str, lines: Sequence[Line]
    ) -> list[list[str]]:
        """Return the values of names in lines of a file."""
        return self.plc.texts_beside(level, instance, file, lines)

    def tree_beside(
        self, level: int | None, instance: str, file: str, line: Line, opened: Sequence[str]
    ) -> list[Branch]:
        """Return the variables named in a line of a file as a tree."""
        return self.plc.tree_beside(level, instance, file, line, opened)

    def instances(self, file: str) -> list[str]:
        """Return the paths of the instances of the blocks that a file declares."""
        return self.plc.beside.instances(file)

    def value(self, level: int | None, text: str) -> PlcValue:
        """Return the value of a path or an expression."""
        return self.plc.value(level, text)


def names_file(asked: str, name: str) -> bool:
    """Return whether a file is meant by its name, by the end of its path, or by no name at all."""
    name, asked = name.replace("\\", "/"), asked.replace("\\", "/")
    return not asked or name == asked or name.endswith(f"/{asked}")
