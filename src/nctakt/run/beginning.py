# SPDX-License-Identifier: MIT
"""The beginning of a run, kept: runs that differ in values, times and sinks continue from there.

In: a checked program, and the options of its runs. Out: ``Beginning``, which restores everything,
realtime part, decoder and queue, as it was before one of the first statements of the program, and
lets another run continue. That is the last statement before the decoder has to wait or uses a value
of the machine's memory: so nothing before it depends on the values of a run.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Hashable, Mapping, Sequence
from typing import Generic, Protocol, TypeVar, Unpack, cast

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.source_ids import SourceFiles
from nctakt.decoder.state.environment import WatchedEnvironment
from nctakt.nc import tree
from nctakt.run.access.variable_access import is_path
from nctakt.run.kept_objects import KeptObjects, NotKeptError
from nctakt.run.options import BY_NAME, RunKeywords, with_further
from nctakt.run.plcs.realtime_plc import PlcGroup, RealtimePlc
from nctakt.run.program_loader import AnyProgram, LoadedProgram
from nctakt.run.program_run import ProgramRun
from nctakt.run.realtime.event_registry import EventRegistry
from nctakt.run.realtime.realtime_part import RealtimePart
from nctakt.run.realtime.realtime_parts import MACHINES, LentPart
from nctakt.run.realtime.snapshot import Snapshot

#: Options that may be any in runs with a common beginning: those that vary from run to run, and
#: those that are the same in all of them.
_VARIED = frozenset(("set", "at", "plc", "sinks"))
_SAME = frozenset(("after", "memory_trace", "record_writes", "signals", "skip", "ticks", "until"))
#: Attributes that get new values when a run continues or are the same in all runs, and objects that
#: results keep copies of.
_REPLACED = ("_parts", "_decoded", "_bound_values", "before")
_RENEWED = (EventRegistry, SourceFiles)


class BeginningController(Protocol):
    """The part of a controller that the beginning of a run needs."""

    diagnostics: list[Diagnostic]

    def begin(
        self,
        programs: Mapping[int, Sequence[AnyProgram]],
        *,
        statistics: bool = True,
        **given: Unpack[RunKeywords],
    ) -> ProgramRun:
        """Return a run before its first tick."""


Own = TypeVar("Own", bound=BeginningController)


def varied(given: RunKeywords) -> RunKeywords:
    """Return those of the options that may differ in runs with a common beginning."""
    return cast("RunKeywords", {name: value for name, value in given.items() if name in _VARIED})


def in_common(given: RunKeywords) -> Hashable:
    """Return the options shared by runs with a common beginning.

    Raises ``TypeError`` for a value that does not say whether it is the same.
    """
    found = []
    for name, value in sorted(given.items()):
        if name not in _VARIED:
            found.append((name, tuple(value) if isinstance(value, list | set) else value))
            hash(found[-1])
    return tuple(found)


def may_share(given: RunKeywords) -> bool:
    """Return whether runs with these options may have a common beginning."""
    return all(
        name in _VARIED or name in _SAME or value == BY_NAME[name].default
        for name, value in given.items()
    )


class Beginning(Generic[Own]):
    """Makes runs of a program that share their beginning (``may_share``), one at a time.

    ``new`` returns a controller with a realtime part. ``lent``: a realtime part, which it keeps.
    ``keeps_results``: results have statistics, and outlive the next run. ``is_possible`` is false
    where it is not known how to put everything back: then runs begin as any other run.
    """

    def __init__(
        self,
        new: Callable[[RealtimePart], Own],
        lent: LentPart,
        program: LoadedProgram,
        options: RunKeywords,
        *,
        keeps_results: bool,
    ) -> None:
        self._new = new
        self._lent = lent
        self.part = lent.part
        self._program = program
        self._keeps_results = keeps_results
        same = {name: value for name, value in options.items() if name not in _VARIED}
        self._options = cast("RunKeywords", same)
        self.statement: tree.Statement | None = None
        self.is_possible = False
        #: Whether a run continues from here.
        self.is_lent = False
        if program.names_of_fetched_axes is None:
            self._keep()

    def _keep(self) -> None:
        """Find the last statement that all runs reach alike, and keep the state before it."""
        self._last_statement()  # which builds the trees of cycles, so that they exist
        self.statement = self._last_statement()
        if self.statement is None:
            return
        self.controller, self.run = self._begun(watches=False)
        part = self._lent.part
        before = part.cells.tolist()
        reached = self.run.pause(lambda statement: statement is self.statement)
        feeder = self.run.channel_runs[0].feeder
        if not reached or feeder is None or part.record.event_count or part.record.row_count:
            return
        self._feeder = feeder
        self._complete = self.run.options
        self._changed = [
            (cell, value)
            for cell, (value, old) in enumerate(zip(part.cells.tolist(), before, strict=True))
            if value != old
        ]
        try:
            apart = (part.memory, self._program)
            self._objects = KeptObjects(self.run, _REPLACED, _RENEWED, apart)
            self._realtime = Snapshot(part)
        except (NotKeptError, ValueError):
            return
        self.is_possible = True

    def _begun(self, *, watches: bool) -> tuple[Own, ProgramRun]:
        """Return a new run, without the values of any, on the realtime part at start-up."""
        self._lent.put_back()
        controller = self._new(self._lent.part)
        run = controller.begin(
            {1: (self._program,)}, statistics=self._keeps_results, **self._options
        )
        run.machine.watches_decoder = watches
        return controller, run

    def _last_statement(self) -> tree.Statement | None:
        """Return the last statement before which decoding can pause, the same in all runs."""
        _, run = self._begun(watches=True)
        found: list[tree.Statement] = []

        def note(statement: tree.Statement) -> bool:
            feeder = run.channel_runs[0].feeder
            environment = None if feeder is None else feeder.environment
            assert isinstance(environment, WatchedEnvironment)
            if not environment.has_used_memory:
                found[:] = [statement]
            return False

        run.pause(note)
        run.close()
        return found[0] if found else None

    def begin(self, options: RunKeywords) -> ProgramRun | None:
        """Return a run with these options that continues after the beginning.

        ``None`` if its values are not only read after the beginning, and for a PLC that runs in the
        tick. Raises ``Failure`` as
        ``Controller.run``.
        """
        assert self.statement is not None
        if any(map(is_path, options.get("set") or ())) or _is_in_tick(options.get("plc")):
            return None
        given = with_further(self._complete, options)
        run, cells = self.run, self.part.cells
        if self._keeps_results:
            run.leave_names()
        self._feeder.drop()
        self._objects.put_back()
        self._realtime.put_back()
        run.begin_again(given)
        if any(cells[cell] != value for cell, value in self._changed):
            return None
        self._feeder.resume(self.statement)
        self.is_lent = True
        return run

    def give_back(self) -> None:
        """Let another run have it."""
        self.is_lent = False


def _is_in_tick(plc: object) -> bool:
    """Return whether a PLC, or one of several, may run in the realtime part."""
    return plc is not None and isinstance(plc, RealtimePlc | PlcGroup | Sequence)


class Beginnings(Generic[Own]):
    """The beginnings of runs, by their shared options; those used last are kept.

    A single run does not pay for it: a beginning is made for the second run.
    """

    def __init__(self) -> None:
        self._known: OrderedDict[Hashable, Beginning[Own] | None] = OrderedDict()

    def of(self, common: Hashable, make: Callable[[], Beginning[Own]]) -> Beginning[Own] | None:
        """Return a beginning that is free; ``None`` if the run must begin like any other."""
        known = self._known
        beginning = known.get(common)
        if beginning is None:
            beginning = known[common] = make() if common in known else None
        known.move_to_end(common)
        if len(known) > MACHINES:
            known.popitem(last=False)
        is_free = beginning is not None and beginning.is_possible and not beginning.is_lent
        return beginning if is_free else None
