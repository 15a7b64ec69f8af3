# SPDX-License-Identifier: MIT
"""A base class for PLCs, whose methods are marked with the time or event of their call.

    class Cell(Plc):
        acknowledge = after("20 ticks")
        inputs = "inputs.csv"

        @at("0.5s")
        def open_the_door(self, hli):
            hli.write("V.E.DOOR", 1)

        @when("V.RTA.ACS.ACT_POS.X > 400")
        def slow_down(self, hli):
            hli.override_pct = 20

        @on("M100")
        def clamp(self, hli, function):
            ...

The realtime part watches for events declared in this form, and calls Python in the ticks in which
they occur; a class with ``each_tick``, or a condition that is a Python function, is called after
each tick. Spindles that the PLC turns get their jobs in the same way: ``spindles`` is the policy
for their acknowledgement, ``@on("S3")`` gets each job.

Actions after tick n count from tick n + 1 on (RC-002). After each tick come, in this order: inputs
from the file, ``at``, ``when``, ``on``, ``each_tick``, acknowledgements; methods of one kind are
called in the order of the class.
"""

from __future__ import annotations

import functools
import linecache
import operator
import re
import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, Self, TypeVar, cast

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import NOTHING, Diagnostic, Span, Text
from nctakt.base.failure import Failure
from nctakt.base.misspelling import nearest
from nctakt.kernel.tick.plc_calls import Delays, When
from nctakt.lists.format.times import Time, TimeLike, read_time
from nctakt.messages import diagnostic
from nctakt.messages.plcs.plc import (
    HANDLER_NOT_CALLED,
    UNKNOWN_FUNCTION_IN_PLC,
    WHEN_CALLED_EACH_TICK,
    WRONG_PLC_TYPE,
    WRONG_TOOL_DATA,
)
from nctakt.plc.class_check import class_slips
from nctakt.plc.inputs import read_inputs
from nctakt.plc.policies import (
    ALL,
    NEVER,
    Only,
    Policy,
    SpindlePolicy,
    delays_of,
    earliest,
)
from nctakt.plc.tool_manager import ToolData, ToolRequest, answer_requests, mistake_in
from nctakt.run.access.stimuli import Stimulus, not_reached
from nctakt.run.conditions import CONDITION_COLUMN, read_expression
from nctakt.run.plcs.plc_view import Declaration, WatchedPlc

if TYPE_CHECKING:
    from nctakt.hli.plc_entries import SpindleEntry, TechnologyEntry
    from nctakt.run.plcs.plc_view import PlcView

_Method = TypeVar("_Method", bound=Callable[..., Any])

_MARK = "_nctakt_when"
#: Methods of ``Plc`` that are called with the HLI.
_CALLED = ("each_tick", "begin_run", "unused_handlers")
#: Members of ``Plc`` that it calls or reads.
#: Among the called methods: ``tool_data``.
_ASKED = ("tool_data", 0)
_NO_REQUEST = Text(
    "no program asked for a tool, as in channels with ext_wzv_vorhanden 1 (P-CHAN-00016)",
    "kein Programm fragte nach einem Werkzeug, wie in Kanälen mit ext_wzv_vorhanden 1 "
    "(P-CHAN-00016)",
)
_MEMBERS = ("cycle", "each_tick", "tool_data", "acknowledge", "spindles", "inputs")

_CONDITION = Text(
    "a condition as a text, or a function that takes the HLI",
    "eine Bedingung als Text oder eine Funktion, die das HLI nimmt",
)
_NAMES = Text('names such as "M100"', 'Namen wie "M100"')


@dataclass(frozen=True, slots=True)
class _At:
    time: Time


@dataclass(frozen=True, slots=True)
class _When:
    condition: Callable[[PlcView], object] | str


@dataclass(frozen=True, slots=True)
class _On:
    names: frozenset[str]


def at(time: TimeLike) -> Callable[[_Method], _Method]:
    """Call the method once, so that its outputs count from this time of the run on.

    ``time``: a text with a unit (``"0.5 s"``, ``"20 ms"``, ``"300 ticks"``), a number of seconds
    or a ``datetime.timedelta``. The method is called after the first tick at the earliest. Raises
    ``Failure`` for an invalid time (900510, 900513).

    >>> class Cell(Plc):
    ...     @at("0.5 s")
    ...     def halve_the_speed(self, hli):
    ...         hli.override_pct = 50
    >>> Controller().run(NcText("move.nc", "G01 X100 F6000 M30"), plc=Cell()).ticks
    1526
    """
    return _marked(_At(read_time(time)))


def when(condition: str | Callable[[PlcView], object]) -> Callable[[_Method], _Method]:
    """Call the method each time that a condition becomes true.

    ``condition``: a text in the language of realtime cycles, in mm and degrees, which the realtime
    part evaluates after each tick; or a function that takes the HLI and is called after each tick.

    >>> class Cell(Plc):
    ...     @when("V.RTA.ACS.ACT_POS.X > 50")
    ...     def report(self, hli):
    ...         print("X beyond 50 mm after tick", hli.tick)
    >>> run = Controller().run(NcText("move.nc", "G01 X100 F6000 M30"), plc=Cell())
    X beyond 50 mm after tick 512
    """
    if not callable(condition) and not isinstance(condition, str):
        raise _wrong_type("@when(…)", condition, _CONDITION)
    return _marked(_When(condition))


def on(*names: str) -> Callable[[_Method], _Method]:
    """Call the method with each function (``M100``, ``H7``), each job of a spindle (``S3``).

    >>> class Cell(Plc):
    ...     @on("M100")
    ...     def clamp(self, hli, function):
    ...         print(function.name, "after tick", hli.tick)
    >>> run = Controller().run(NcText("clamp.nc", "G01 X10 F6000 M100 M30"), plc=Cell())
    M100 after tick 0
    """
    for name in names:
        if not isinstance(name, str):
            raise _wrong_type("@on(…)", name, _NAMES)
    return _marked(_On(frozenset(name.upper() for name in names)))


def _wrong_type(name: str, value: object, expected: Text) -> Failure:
    return Failure(diagnostic(WRONG_PLC_TYPE, name=name, value=repr(value), expected=expected))


def handler_parameters(name: str, method: object, *, is_plc: bool) -> tuple[str, ...]:
    """Return the parameters with which a method is called; empty if it is not called.

    ``is_plc``: its class derives from ``Plc``.
    """
    if name == "cycle" or (is_plc and name in _CALLED):
        return ("self", "hli")
    if is_plc and name == "tool_data":
        return ("self", "hli", "request")
    marks = getattr(method, _MARK, ())
    if any(isinstance(mark, _On) for mark in marks):
        return ("self", "hli", "function")
    return ("self", "hli") if marks else ()


def _marked(mark: object) -> Callable[[_Method], _Method]:
    def decorate(method: _Method) -> _Method:
        setattr(method, _MARK, (*getattr(method, _MARK, ()), mark))
        return method

    return decorate


@dataclass(slots=True)
class _Memory:
    """The state of a PLC from tick to tick.

    ``whens``: the conditions that are texts, on ``machine``; ``declared``: the events that the PLC
    waits for, with the policies that they come from.
    """

    inputs: list[Stimulus]
    first_tick: int | None = None
    done: list[tuple[str, int]] = field(default_factory=list)
    was_true: dict[tuple[str, int], bool] = field(default_factory=dict)
    seen: dict[tuple[str, int], tuple[int, int]] = field(default_factory=dict)
    called: dict[tuple[str, int], None] = field(default_factory=dict)
    whens: dict[tuple[str, int], When] = field(default_factory=dict)
    machine: object = None
    declared: Declaration | None = None
    policies: tuple[Policy, SpindlePolicy] = (ALL, ALL)


class Plc(WatchedPlc):
    """The base class of a PLC, whose methods are marked with ``at``, ``on`` and ``when``.

    ``acknowledge``: the policy for M and H functions; ``inputs``: a CSV file next to the PLC's
    file; ``spindles``: the policy for the jobs of spindles that the PLC turns.

    >>> class Cell(Plc):
    ...     acknowledge = after("20 ms")
    ...
    ...     @on("M100")
    ...     def clamp(self, hli, function):
    ...         hli.write("V.E.VALUE", 1)
    >>> controller = Controller()
    >>> controller.run(NcText("clamp.nc", "M100 G01 X10 F6000 M30"), plc=Cell()).state
    'ended'
    >>> controller.read("V.E.VALUE")
    1.0
    """

    acknowledge: ClassVar[Policy] = ALL
    spindles: ClassVar[SpindlePolicy] = ALL
    inputs: ClassVar[str | Path | None] = None
    _folder: ClassVar[Path] = Path()
    _source: ClassVar[tuple[str, int]] = ("", 1)
    _marks: ClassVar[tuple[tuple[str, int, Any], ...]] = ()
    _ats: ClassVar[tuple[tuple[str, int, _At], ...]] = ()
    _whens: ClassVar[tuple[tuple[str, int, _When], ...]] = ()
    _ons: ClassVar[tuple[tuple[str, int, _On], ...]] = ()
    _is_checked: ClassVar[bool] = False
    _memory: _Memory

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        caller = sys._getframe(1)
        file = caller.f_globals.get("__file__")
        cls._folder = Path() if file is None else Path(file).parent
        cls._source = (file or "", caller.f_lineno)
        names = dict.fromkeys(name for base in reversed(cls.__mro__) for name in vars(base))
        cls._marks = tuple(
            (name, index, mark)
            for name in names
            for index, mark in enumerate(getattr(getattr(cls, name), _MARK, ()))
        )
        cls._ats = tuple(one for one in cls._marks if isinstance(one[2], _At))
        cls._whens = tuple(one for one in cls._marks if isinstance(one[2], _When))
        cls._ons = tuple(one for one in cls._marks if isinstance(one[2], _On))

    def __new__(cls, *words: object, **keywords: object) -> Self:
        """Set up the state here, so that a user's ``__init__`` need not call that of this class."""
        plc = super().__new__(cls)
        path = input_file(plc)
        plc._memory = _Memory([] if path is None else list(read_inputs(path)))
        return plc

    def begin_run(self, hli: PlcView) -> None:
        """Raise ``Failure`` for unknown functions in ``@on`` and ``only`` (901013), for slips in
        the class (901008, 901009, 901011) and for mistakes in conditions.
        """
        functions = hli.known_functions()
        upper = {name.upper() for name in functions}
        requested = [(name, mark.names) for name, _, mark in self._ons]
        for attribute in ("acknowledge", "spindles"):
            policy = getattr(self, attribute)
            if isinstance(policy, Only):
                requested.append((attribute, policy.names))
        unknown = [
            diagnostic(
                UNKNOWN_FUNCTION_IN_PLC,
                *source_position(type(self), member, name),
                name=name,
                nearest=nearest(name, functions) or NOTHING,
            )
            for member, names in requested
            for name in sorted(names - upper)
        ]
        unknown += self._slips()
        try:
            self._memory.machine = None
            self._read_conditions(hli)
        except Failure as failure:
            unknown += failure.diagnostics
        if unknown:
            raise Failure(*unknown)

    def _slips(self) -> list[Diagnostic]:
        """Return the slips in the class, which is checked until it has none."""
        kind = type(self)
        if vars(kind).get("_is_checked", False):
            return []
        slips = [
            diagnostic(message, *source_position(kind, member, word), **values)
            for message, member, word, values in class_slips(
                kind, Plc, _MEMBERS, lambda name, one: handler_parameters(name, one, is_plc=True)
            )
        ]
        kind._is_checked = not slips
        return slips

    def notes(self) -> list[Diagnostic]:
        """Return a note for each condition that is called after each tick (902140)."""
        return [
            diagnostic(WHEN_CALLED_EACH_TICK, *source_position(type(self), name, "when"), name=name)
            for name, _, mark in self._whens
            if callable(mark.condition)
        ]

    def unused_handlers(self, hli: PlcView) -> list[Diagnostic]:
        """Return a diagnostic for each method (901014) and input (901007) left at the end."""
        memory = self._memory
        first_tick = hli.tick + 1 if memory.first_tick is None else memory.first_tick
        end_us = (hli.tick + 1 - first_tick) * hli.cycle_time_us
        unused = [
            diagnostic(
                HANDLER_NOT_CALLED,
                *source_position(type(self), name),
                name=name,
                reason=_reason(mark),
            )
            for name, index, mark in self._marks
            if (name, index) not in memory.called
        ]
        if self._manages_tools() and _ASKED not in memory.called:
            position = source_position(type(self), "tool_data")
            unused.append(
                diagnostic(HANDLER_NOT_CALLED, *position, name="tool_data", reason=_NO_REQUEST)
            )
        return [*not_reached(memory.inputs, end_us, hli.cycle_time_us), *unused]

    def each_tick(self, hli: PlcView) -> None:
        """Do nothing; a class overrides it for actions after each tick."""

    def tool_data(self, hli: PlcView, request: ToolRequest) -> ToolData | None:
        """Return the data of a tool that a channel asks for, ``None`` if there is no such tool.

        A class that overrides it manages the tools of the channels whose list says so
        (``ext_wzv_vorhanden``, P-CHAN-00016). Called after the tick of a D or ``#TOOL DATA``; also
        for D0, with the number 0, and for a T that only has a tool got ready, where the data that
        it returns have no effect.

        >>> class Cell(Plc):
        ...     tools = {5: ToolData(length=120.0, radius=4.0)}
        ...
        ...     def tool_data(self, hli, request):
        ...         return self.tools.get(request.basic)
        """
        return None

    def cycle(self, hli: PlcView) -> None:
        """Call the methods that are due after a tick, and acknowledge."""
        functions, jobs = self._call_due(hli)
        if self._manages_tools():
            if answer_requests(hli, self._tool_of):
                self._memory.called[_ASKED] = None
        for function in functions:
            if self.acknowledge.answers(function, hli):
                hli.acknowledge(function)
        self._acknowledge_jobs(jobs, hli)

    def _tool_of(self, hli: PlcView, request: ToolRequest) -> ToolData | None:
        """Return the answer of ``tool_data``; raise ``Failure`` if it is not the data of a tool."""
        answer: object = self.tool_data(hli, request)
        mistake = mistake_in(answer)
        if mistake is not None:
            shown, reason = mistake
            position = source_position(type(self), "tool_data")
            raise Failure(
                diagnostic(
                    WRONG_TOOL_DATA,
                    *position,
                    answer=shown[:40],
                    tool=request.basic,
                    reason=reason,
                )
            )
        return cast("ToolData | None", answer)

    def _acknowledge_jobs(self, jobs: Sequence[SpindleEntry], hli: PlcView) -> None:
        for job in jobs:
            if self.spindles.answers(job, hli):
                hli.acknowledge_spindle(job)

    # --- called only when something is due ------------------------------------------------------

    def declaration(self, hli: PlcView) -> Declaration | None:
        """Return the events it waits for; ``None`` for a class that is called after each tick."""
        memory = self._memory
        policies = self.acknowledge, self.spindles
        if memory.declared is not None and memory.machine is hli._machine:
            if all(map(operator.is_, policies, memory.policies)):
                return memory.declared
        if self._needs_each_tick():
            return None
        self._read_conditions(hli)
        delays = delays_of(self.acknowledge, hli.cycle_time_us)
        memory.policies = policies
        memory.declared = Declaration(
            list(memory.whens.values()),
            Delays(NEVER, [], []) if delays is None else delays,
            self.cycle if delays is None else self._cycle_without_functions,
            self._next_call,
        )
        return memory.declared

    def _needs_each_tick(self) -> bool:
        """Return whether something of the class has to be called after each tick."""
        called = (getattr(self.cycle, "__func__", None), getattr(self.each_tick, "__func__", None))
        return (
            called != (Plc.cycle, Plc.each_tick)
            or self._manages_tools()
            or any(callable(mark.condition) for _, _, mark in self._whens)
        )

    def _manages_tools(self) -> bool:
        """Return whether the class is asked for tools."""
        return type(self).tool_data is not Plc.tool_data

    def _cycle_without_functions(self, hli: PlcView) -> None:
        """Do as ``cycle``; the realtime part acknowledges the functions."""
        _, jobs = self._call_due(hli)
        self._acknowledge_jobs(jobs, hli)

    def _next_call(self, hli: PlcView) -> int:
        """Return the tick after which ``cycle`` has something to do, if nothing comes before."""
        memory, tick_us = self._memory, hli.cycle_time_us
        first = memory.first_tick or 0
        times = [stimulus.time for stimulus in memory.inputs[:1]]
        times += [mark.time for name, index, mark in self._ats if (name, index) not in memory.done]
        ticks = [first + time.ticks(tick_us) - 1 for time in times]
        ticks += [earliest(self.spindles, job, hli) for job in hli.spindle_jobs()]
        if delays_of(self.acknowledge, tick_us) is None:
            ticks += [hli.tick + 1 for _ in hli.functions()]
        return min(ticks, default=NEVER)

    # --- conditions -----------------------------------------------------------------------------

    def _read_conditions(self, hli: PlcView) -> None:
        """Read the conditions that are texts for this machine; raises ``Failure``."""
        memory, machine = self._memory, hli._machine
        if memory.machine is machine:
            return
        found: list[Diagnostic] = []
        for name, index, mark in self._whens:
            if isinstance(mark.condition, str):
                before = memory.whens.get((name, index))
                was_true = before is not None and before.was_true != 0
                known = machine.realtime.conditions
                try:
                    expression = known.get(mark.condition) or read_expression(
                        machine, mark.condition
                    )
                except Failure as failure:
                    placed = functools.partial(condition_mistake, type(self), name, mark.condition)
                    found += map(placed, failure.diagnostics)
                else:
                    known[mark.condition] = expression
                    memory.whens[name, index] = When(expression, machine.memory, was_true)
        if found:
            raise Failure(*found)
        memory.machine, memory.declared = machine, None

    def _rises(self, name: str, index: int, mark: _When, hli: PlcView) -> bool:
        """Return whether a condition has become true after this tick."""
        memory, key = self._memory, (name, index)
        if isinstance(mark.condition, str):
            return memory.whens[key].rises_in(hli.tick)
        is_true = bool(mark.condition(hli))
        rises = is_true and not memory.was_true.get(key, False)
        memory.was_true[key] = is_true
        return rises

    def _call_due(self, hli: PlcView) -> tuple[Sequence[TechnologyEntry], Sequence[SpindleEntry]]:
        """Call the methods that are due after a tick; return functions and jobs that wait."""
        memory = self._memory
        tick_us = hli.cycle_time_us
        if memory.first_tick is None:
            memory.first_tick = hli.tick
            memory.inputs.sort(key=lambda stimulus: stimulus.time.us(tick_us))
        self._read_conditions(hli)
        next_tick = hli.tick + 1 - memory.first_tick
        while memory.inputs and memory.inputs[0].time.ticks(tick_us) <= next_tick:
            stimulus = memory.inputs.pop(0)
            hli.write(stimulus.name, stimulus.value)
        for name, index, mark in self._ats:
            if mark.time.ticks(tick_us) <= next_tick and (name, index) not in memory.done:
                memory.done.append((name, index))
                self._call(name, index, hli)
        for name, index, waits in self._whens:
            if self._rises(name, index, waits, hli):
                self._call(name, index, hli)
        functions, jobs = hli.functions(), hli.spindle_jobs()
        for entry in self._new([*functions, *jobs]):
            for name, index, named in self._ons:
                if entry.name.upper() in named.names:
                    self._call(name, index, hli, entry)
        self.each_tick(hli)
        return functions, jobs

    def _call(self, name: str, index: int, *words: object) -> None:
        """Call a method for its mark ``index``."""
        self._memory.called[(name, index)] = None
        getattr(self, name)(*words)

    def _new(
        self, entries: Sequence[TechnologyEntry | SpindleEntry]
    ) -> Iterator[TechnologyEntry | SpindleEntry]:
        """Yield the functions and jobs that were not waiting after the previous tick."""
        seen = self._memory.seen
        for entry in entries:
            if seen.get(entry.key) != entry.stamp:
                seen[entry.key] = entry.stamp
                yield entry


def input_file(plc: object) -> Path | None:
    """Return the file of a PLC's inputs; ``None`` for a PLC without."""
    if not isinstance(plc, Plc) or plc.inputs is None:
        return None
    return plc._folder / plc.inputs


def _reason(mark: object) -> Text:
    """Return the reason why the method of a mark was not called."""
    if isinstance(mark, _At):
        return Text(f"the run ended before {mark.time}", f"der Lauf endete vor {mark.time}")
    if isinstance(mark, _On):
        names = sorted(mark.names)
        en, de = " or ".join(names), " oder ".join(names)
        return Text(f"{en} did not appear", f"{de} kam nicht vor")
    return Text("its condition did not become true", "seine Bedingung wurde nicht wahr")


def condition_mistake(kind: type, member: str, text: str, mistake: Diagnostic) -> Diagnostic:
    """Return a mistake in a condition with its place in the file of the class.

    Where the text is not there word for word, the place is that in the text.
    """
    span = mistake.span
    begin, end = (0, len(text)) if span is None else (span.column, span.end_column)
    if span is not None:
        begin, end = (max(0, column - CONDITION_COLUMN) for column in (begin, end))
    file, lines, first = _source_of(kind, member)
    for number, line in enumerate(lines[first - 1 :], first):
        column = line.find(text)
        if re.match(rf"\s*(async )?def {member}\b", line):
            break
        if column >= 0:
            span = Span(file, number, column + begin + 1, column + max(begin + 1, end) + 1)
            return replace(mistake, span=span, source_line=line.rstrip("\n"))
    span = Span(member, 1, begin + 1, max(begin + 1, end) + 1)
    return replace(mistake, span=span, source_line=text)


def _source_of(kind: type, member: str) -> tuple[str, list[str], int]:
    """Return the file of a class, its lines, and the first line of a member of the class."""
    code = getattr(getattr(kind, member), "__code__", None)
    file, first = (
        getattr(kind, "_source", ("", 1))
        if code is None
        else (code.co_filename, code.co_firstlineno)
    )
    return file, linecache.getlines(file), first


def source_position(kind: type, member: str, word: str = "") -> tuple[Span, str] | tuple[()]:
    """Return the span of a method, or of a word at it or in its class, and the source line.

    The result is empty if the source is not available.
    """
    file, lines, first = _source_of(kind, member)
    pattern = re.escape(word) if word else rf"(?<=def ){re.escape(member)}"
    for number, line in enumerate(lines[first - 1 :], first):
        match = re.search(rf"{pattern}\b", line, re.IGNORECASE)
        if match is not None:
            return Span(file, number, match.start() + 1, match.end() + 1), line.rstrip("\n")
    return ()
