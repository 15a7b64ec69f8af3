# SPDX-License-Identifier: MIT
"""A PLC in Structured Text as a debugger sees it: its statements, calls and variables.

In: a PLC on a machine. Out: hits of stops at its statements; where it has halted or failed: the
open calls, their scopes, and values by path or expression. Probes are put into the code when the
first statement is requested; without a debugger there are none.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator, Sequence
from functools import cached_property
from operator import itemgetter

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Span, Text
from nctakt.base.failure import Failure
from nctakt.kernel.st import kinds
from nctakt.kernel.st.context import PlcContext
from nctakt.kernel.st.observing.probes import ALWAYS, Sought, SoughtStatement, StatementCounter
from nctakt.kernel.st.reals import Real
from nctakt.kernel.st.wholes import Whole
from nctakt.messages import diagnostic
from nctakt.messages.connections.debugger import NO_VALUE
from nctakt.messages.plc_debugging import (
    CONDITION_IS_NO_TRUTH,
    NOT_EVALUATED,
    UNKNOWN_PLC_VARIABLE,
)
from nctakt.plc.stepping.beside import Beside, Branch, Line
from nctakt.plc.stepping.places import Call, Place, Places
from nctakt.plc.stepping.shown import COMPUTED, PlcValue, Shown, whole_text
from nctakt.plc.structured_text import StructuredPlc
from nctakt.results.trace.events import number_text
from nctakt.st.types import (
    BlockType,
    Callable,
    Elementary,
    Expression,
    Family,
    Method,
    Pou,
    Variable,
)
from nctakt.translation.body import CannotRunError
from nctakt.translation.layout import kind_of
from nctakt.translation.observing.probing import Probes, statement_lines
from nctakt.translation.observing.single import translate_single
from nctakt.translation.observing.units import methods_of

#: Values that are given at once, at most.
MAX_VALUES = 1000

#: Fields of a context changed temporarily by evaluating an expression.
_OF_STATE = (
    "frame", "instance", "fault", "fault_source", "fault_a", "fault_b", "fault_frame",
    "fault_instance", "trail_length",
)  # fmt: skip

#: Why an expression has no value, by the fault that it would be.
_FAULTS = {
    kinds.DIVISION: Text("division by zero", "Division durch null"),
    kinds.INDEX: Text("an index is outside of its array", "ein Index liegt außerhalb seines Felds"),
    kinds.PLACE: Text("something in it refers to nothing", "etwas darin verweist auf nichts"),
    kinds.CONVERSION: Text("a real number does not fit", "eine Realzahl passt nicht hinein"),
}

_START = itemgetter(0)

_GLOBAL, _PROGRAMS, _THIS = "VAR_GLOBAL", "PROGRAM", "THIS^"


@dataclass(frozen=True, slots=True)
class PlcFrame:
    """An open call: the callee, the instance, and the place.

    ``span``: the statement that comes next in it, or that has failed; ``within``: the same as the
    programming system shows it, of XML only.
    """

    name: str
    instance: str
    span: Span | None
    within: Text | None


class StDebugging:
    """One PLC on its machine."""

    def __init__(self, plc: StructuredPlc) -> None:
        self._plc = plc
        self.program = plc.program
        self._probes: Probes | None = None

    # --- statements

    @cached_property
    def lines(self) -> dict[str, dict[int, int]]:
        """The lines of each file in which statements begin, with the source of the first one."""
        return statement_lines(self.program)

    def install(self) -> StatementCounter:
        """Put probes into the code, once; return the statement counter."""
        return self._installed().counter

    def _installed(self) -> Probes:
        if self._probes is None:
            probes = Probes(self.program)
            self._plc.probe(probes)
            self._probes = probes
        return self._probes

    def forget(self) -> None:
        """Look for nothing any more."""
        if self._probes is not None:
            self._probes.counter.seek(Sought())
            for probes in self._probes.by_source.values():
                for probe in probes:
                    probe.seek(Sought())

    def check(self, sources: Sequence[int], condition: str) -> None:
        """Raise ``Failure`` with the mistakes of a condition at statements."""
        for source in sources or (0,):
            self._guard(source, condition)

    def seek(
        self, sources: Sequence[int], condition: str, max_depth: int, chains: dict[int, Sought]
    ) -> list[Sought]:
        """Look for statements by their sources, none: for any; ``chains``: the probes."""
        probes = self._installed()
        depth = max_depth or kinds.MAX_DEPTH
        found: list[Sought] = []
        for source in sources or (0,):
            guard = self._guard(source, condition)
            one = SoughtStatement(guard, depth, chains.get(source, Sought()))
            chains[source] = one
            found.append(one)
            if not source:
                probes.counter.seek(one)
            for probe in probes.by_source.get(source, ()):
                probe.seek(one)
        return found

    def _guard(self, source: int, condition: str) -> Whole:
        """Return the condition before a statement; raises ``Failure`` with its mistakes."""
        if not condition:
            return ALWAYS
        unit = self.unit_of(source)
        expression = self._read(condition, unit)
        sought = expression.type
        if not isinstance(sought, Elementary) or sought.family is not Family.BOOL:
            name = "?" if sought is None else sought.name
            raise Failure(diagnostic(CONDITION_IS_NO_TRUTH, text=condition, type=name))
        node = self._node(condition, unit)
        return node if isinstance(node, Whole) else ALWAYS

    def _read(self, text: str, unit: Callable | None) -> Expression:
        single = self.program.single
        if single is None:
            raise Failure(diagnostic(NOT_EVALUATED, what=text))
        return single.read(text, unit)

    def _node(self, text: str, unit: Callable | None) -> Whole | Real:
        expression = self._read(text, unit)
        called = unit if unit is not None else Callable("", "")
        layout = self._plc.translated.layout
        try:
            return translate_single(expression, called, self._owner_of(called), layout)
        except CannotRunError as error:
            raise Failure(diagnostic(NOT_EVALUATED, what=error.what)) from error

    # --- calls

    @cached_property
    def _units(self) -> list[tuple[int, Callable]]:
        """All that can be called, by where it begins and where each statement of its body does.

        Of a block in plain text, the body comes after the methods. Code inside a statement comes
        before the next one.
        """
        found: list[tuple[int, Callable]] = []
        for pou in self.program.pous.values():
            for one in (pou, *methods_of(pou)):
                starts = [one.start, *(statement.start for statement in one.body)]
                found += [(start, one) for start in starts if start]
        return sorted(found, key=_START)

    def unit_of(self, source: int) -> Callable | None:
        """Return the unit whose text holds a position: the last that begins before it."""
        index = bisect_right(self._units, source, key=_START)
        return self._units[index - 1][1] if index else None

    def _owner_of(self, called: Callable) -> Pou | None:
        owner = called if isinstance(called, Pou) else getattr(called, "owner", None)
        return owner if isinstance(owner, Pou) and owner.type is not None else None

    @property
    def context(self) -> PlcContext:
        """The context of its running code."""
        return self._plc.context

    @property
    def has_stopped(self) -> bool:
        """Whether a halt or a fault has stopped the PLC."""
        return bool(self._plc.context.fault)

    def fault(self) -> Diagnostic | None:
        """Return the fault that has stopped the PLC, ``None`` if it has halted or runs."""
        return self._plc.fault()

    def _trail(self) -> Iterator[tuple[int, int, int]]:
        """Yield source, frame and instance of each open call, the innermost first."""
        context = self._plc.context
        if not context.fault:
            return
        yield context.fault_source, context.fault_frame, context.fault_instance
        words = list(context.trail[: context.trail_length])
        # The last is the call by the task.
        for i in range(0, len(words) - kinds.TRAIL_WIDTH, kinds.TRAIL_WIDTH):
            source, instance, frame = words[i : i + kinds.TRAIL_WIDTH]
            yield source, frame, instance

    @property
    def calls(self) -> list[Call]:
        """The calls that are open where it has stopped, the innermost first."""
        found = []
        for source, frame, instance in self._trail():
            called = self.unit_of(source)
            if called is not None:
                found.append(Call(called, self._owner_of(called), frame, instance))
        return found

    def frames(self) -> list[PlcFrame]:
        """Return the calls that are open where it has stopped, the innermost first."""
        sources = self.program.sources
        found = []
        for (source, _, _), call in zip(self._trail(), self.calls, strict=False):
            instance = ""
            if call.pou is not None and call.pou.type is not None:
                instance = self._places.path_of(call.instance, call.pou.type) or ""
            span = sources.span(source, source + 1)
            found.append(PlcFrame(call.called.path, instance, span, sources.within(source)))
        return found

    def _call(self, level: int | None) -> Call | None:
        calls = self.calls
        return calls[level] if level is not None and 0 <= level < len(calls) else None

    # --- values

    @cached_property
    def _places(self) -> Places:
        return Places(self.program, self._plc.context)

    @cached_property
    def _shown(self) -> Shown:
        return Shown(self._places)

    @cached_property
    def beside(self) -> Beside:
        """The values next to the lines of its text."""
        return Beside(self.program, self._places, self._shown, self.unit_of)

    def texts_beside(
        self, level: int | None, instance: str, file: str, lines: Sequence[Line]
    ) -> list[list[str]]:
        """Return the values of names in lines of a file, in an open call or an instance."""
        return self.beside.texts(self._call(level), instance, file, lines)

    def tree_beside(
        self, level: int | None, instance: str, file: str, line: Line, opened: Sequence[str]
    ) -> list[Branch]:
        """Return the variables of a line of a file as a tree, in an open call or an instance."""
        return self.beside.tree(self._call(level), instance, file, line, opened)

    def scopes(self, level: int | None) -> list[str]:
        """Return the names of the scopes of a call, without one the global ones."""
        call = self._call(level)
        names = [] if call is None else [name for name, _ in self._sections(call)]
        return [*dict.fromkeys(names), _GLOBAL, _PROGRAMS]

    def _sections(self, call: Call) -> Iterator[tuple[str, tuple[str, Variable]]]:
        """Yield the variables of a call with the keyword of their declaration, or ``THIS^``."""
        is_method = isinstance(call.called, Method)
        for prefix, variable in self._places.seen(call):
            own = prefix == "" or not is_method
            yield (variable.section.value if own else _THIS), (prefix, variable)

    def of_scope(self, level: int | None, scope: str, first: int, count: int) -> list[PlcValue]:
        """Return the variables of a scope."""
        count = min(count or MAX_VALUES, MAX_VALUES)
        found: list[tuple[str, Place]] = []
        call = self._call(level)
        if scope in (_GLOBAL, _PROGRAMS):
            for path, location in self._places.roots():
                is_program = isinstance(location.type, BlockType) and "." not in path
                is_program = is_program and path.lower() in self.program.pous
                if is_program == (scope == _PROGRAMS) and self._is_own(path):
                    found.append((path, location))
        elif call is not None:
            for name, (prefix, variable) in self._sections(call):
                own = self._placed(prefix, variable, call) if name == scope else None
                if own is not None:
                    found.append((variable.name, own))
        return [self._shown.value(name, one) for name, one in found[first : first + count]]

    def _placed(self, prefix: str, variable: Variable, call: Call) -> Place | None:
        if variable.is_constant and variable.value is not None:
            return None
        return self._places.placed(prefix, variable, call)

    def _is_own(self, path: str) -> bool:
        """Return whether a program or a list of a path belongs to the project itself."""
        first = path.partition(".")[0].lower()
        pou = self.program.pous.get(first)
        if pou is not None:
            return not pou.library
        lists = [one for one in self.program.lists if one.name.lower() == first]
        return not any(getattr(one, "library", "") for one in lists)

    def below(self, level: int | None, path: str, first: int, count: int) -> list[PlcValue]:
        """Return the children of a variable by its path; raises ``Failure``."""
        location = self._places.find(path, self._call(level))
        if location is None:
            raise Failure(diagnostic(UNKNOWN_PLC_VARIABLE, name=path))
        return self._shown.below(location, first, min(count or MAX_VALUES, MAX_VALUES))

    def value(self, level: int | None, text: str) -> PlcValue:
        """Return the value of a path or an expression; raises ``Failure`` for mistakes in it."""
        call = self._call(level)
        try:
            location = self._places.find(text, call)
        except Failure as failure:
            if failure.diagnostics[0].message is not UNKNOWN_PLC_VARIABLE:
                raise
            return self._property(text, call, failure)
        if location is not None:
            return self._shown.value(text.strip(), location)
        return self._computed(text, call)

    def _property(self, text: str, call: Call | None, failure: Failure) -> PlcValue:
        """Say of a property that it is not asked; raises the ``failure`` for any other path."""
        try:
            self._read(text, None if call is None else call.called)
        except Failure:
            raise failure from None
        return self._computed(text, call)

    def _computed(self, text: str, call: Call | None) -> PlcValue:
        """Return the value of an expression, evaluated as code does before its statement."""
        unit = None if call is None else call.called
        node = self._node(text, unit)
        sought = self._read(text, unit).type
        if sought is None or kind_of(sought) is None:
            raise Failure(diagnostic(NOT_EVALUATED, what=text))
        number, failed = self._measured(node, call)
        if failed:
            reason = _FAULTS.get(failed, str(failed))
            raise Failure(diagnostic(NO_VALUE, text=text, reason=reason))
        is_real = isinstance(number, float)
        shown = number_text(number) if is_real else whole_text(sought, int(number))
        return PlcValue(text, text, sought.name, shown, fixed=COMPUTED)

    def _measured(self, node: Whole | Real, call: Call | None) -> tuple[float, int]:
        """Return the value of a node in a call, and the number of its fault; all else stays."""
        context = self._plc.context
        kept = {name: getattr(context, name) for name in _OF_STATE}
        if call is not None:
            context.frame, context.instance = call.frame, call.instance
        context.fault = 0
        try:
            return node.measure(context), context.fault
        finally:
            for name, value in kept.items():
                setattr(context, name, value)
