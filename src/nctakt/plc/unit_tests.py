# SPDX-License-Identifier: MIT
"""Suites of unit tests in Structured Text, under the names of TcUnit (ST-901 … ST-904).

In: a project or a file with suites. Out: its suites with the tests that their texts name, found
without a run; and the result of each test after a run in virtual time.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from pathlib import Path

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Diagnostic, Language, Span, Text
from nctakt.lists.format.times import Time, TimeLike, read_time
from nctakt.lists.machine.machine import Machine
from nctakt.messages import diagnostic
from nctakt.messages.plcs.unit_tests import (
    OTHER_TEST_LIBRARY,
    OUTSIDE_OF_TESTS,
    SUITE_NOT_CALLED,
    TEST_NAME_TWICE,
    TEST_UNFINISHED,
    TOO_MANY_TESTS,
    UNKNOWN_TEST_FINISHED,
)
from nctakt.plc.error import PlcError
from nctakt.plc.structured_text import StructuredPlc, inspected, plc_of
from nctakt.run.controller import Controller, NcText
from nctakt.st.check.project import DEFAULT_CYCLE_US, DEFAULT_TASK
from nctakt.st.files.suffixes import TEXT_SUFFIXES
from nctakt.st.program import Program, Task
from nctakt.st.tree import Call
from nctakt.st.types import ArrayType, BlockType, Callable, Kind, Node, Pou
from nctakt.st.vocabulary.libraries import TEST_LIBRARY
from nctakt.translation.observing.units import methods_of
from nctakt.translation.variables import instances_of

#: How long suites may take if nothing else is said, in s of the machine's time.
DEFAULT_UNTIL = 600
_SUITE, _RUNNERS, _OPENERS = "fb_testsuite", ("run", "run_in_sequence"), ("test", "test_ordered")
_DISABLED = "disabled_"
#: Means all tests of a suite whose names are not in its text.
OTHER_TESTS = "tests with computed names"
_FAILED = Text("an assertion failed", "eine Zusicherung ist nicht erfüllt")
_WHEN = Text("at {time}, tick {tick}", "bei {time}, Takt {tick}")

#: Types of nodes in a syntax tree.
_TREE = (Node, list)
_PARTS: dict[type, list[str]] = {}
#: Ticks between two looks at whether the suites have ended.
_TICKS_AT_ONCE = 200
#: The library keeps the results of a run under this name.
_RUN = "__TestRun"
#: Where TcUnit's sources say that all suites have ended, and the variables read of their tests.
_SOURCES_ENDED = "GVL_TcUnit.TcUnitRunner.AllTestSuitesFinished"
_READ_OF_TESTS = {"testname", "testisfinished", "testisskipped", "testisfailed", "assertionmessage"}


@dataclass(frozen=True, slots=True)
class NamedTest:
    """A test that the text of a suite names; ``span``: where it is opened."""

    name: str
    span: Span


@dataclass(slots=True, eq=False)
class Suite:
    """An instance of a suite by its path, with the tests that its text names.

    ``has_others``: it may open tests whose names are known in a run only.
    """

    path: str
    address: int
    tests: dict[str, NamedTest] = field(default_factory=dict)
    has_others: bool = False


@dataclass(slots=True, eq=False)
class Outcome:
    """The result of a test; it passed if ``problems`` is empty.

    ``problems``: its failures, as texts; ``duration_us``: from its start to its end.
    """

    name: str
    is_disabled: bool = False
    problems: list[str] = field(default_factory=list)
    duration_us: int = 0
    asserts: int = 0


@dataclass(slots=True, eq=False)
class SuiteResults:
    """The tests of a run by suite and name; ``problems`` of a suite concern all its tests."""

    outcomes: dict[str, dict[str, Outcome]] = field(default_factory=dict)
    problems: dict[str, list[str]] = field(default_factory=dict)


def may_hold_suites(path: Path, data: bytes) -> bool:
    """Return whether a file is one with suites, as far as its bytes show."""
    lower = data.lower()
    if path.suffix.lower() == ".plcproj":
        return TEST_LIBRARY.lower().encode() in lower
    return path.suffix.lower() in TEXT_SUFFIXES and _SUITE.encode() in lower


def load_suites(path: Path, plc: Path | None = None) -> StructuredPlc:
    """Return the PLC that runs the suites of a file; raises ``PlcError`` with its mistakes.

    Also raises it if sources of TcUnit keep results in an unknown form (902911).

    ``plc``: the project's own text, which belongs to a single file with suites; of its tasks none
    runs then, but the programs of the file.
    """
    if path.suffix.lower() not in TEXT_SUFFIXES:
        programs, findings, project = inspected(path)
        _check_library(programs[0])
        return plc_of(programs[0], path, findings, project)
    is_text = plc is not None and plc.suffix.lower() in TEXT_SUFFIXES
    others = [plc] if plc is not None and is_text and plc.resolve() != path.resolve() else []
    programs, findings, project = inspected(path, *others)
    _check_library(programs[0])
    _choose_tasks(programs[0], path)
    return plc_of(programs[0], path, findings, project)


def _check_library(program: Program) -> None:
    """Raise ``PlcError`` where suites are those of a library that keeps its results otherwise."""
    base = _base_of(program)
    if base is not None and not _has_own_results(program) and not _has_results_of_sources(base):
        raise PlcError(diagnostic(OTHER_TEST_LIBRARY))


def _has_own_results(program: Program) -> bool:
    """Return whether suites are those of the library of nctakt."""
    return any(one.name == _RUN for one in program.lists)


def _has_results_of_sources(base: Pou) -> bool:
    """Return whether the suites of TcUnit's sources keep the variables needed for results."""
    tests = base.members.get("tests")
    array = None if tests is None else tests.type
    test = array.element if isinstance(array, ArrayType) else None
    if not isinstance(test, BlockType) or "numberoftests" not in base.members:
        return False
    return _READ_OF_TESTS <= test.pou.members.keys()


def _base_of(program: Program) -> Pou | None:
    """Return the block of a library that all suites extend."""
    return next((one for one in program.blocks if one.name.lower() == _SUITE and one.library), None)


def _choose_tasks(program: Program, path: Path) -> None:
    """Run the tasks whose programs are in a file, else its programs that call the suites."""
    own = [
        pou
        for pou in program.pous.values()
        if pou.kind is Kind.PROGRAM and _file_of(program, pou) == path.as_posix()
    ]
    tasks = [task for task in program.tasks if any(pou in own for pou in task.programs)]
    running = [pou for pou in own if any(_is_of(call, _RUNNERS) for call in _calls(pou))]
    if any(pou in running for task in tasks for pou in task.programs):
        program.tasks = tasks
    elif running:
        program.tasks = [Task(DEFAULT_TASK, DEFAULT_CYCLE_US, 0, running)]


def _file_of(program: Program, called: Callable) -> str:
    span = program.sources.span(called.start, called.start + 1)
    return "" if span is None else span.file


def suites_of(program: Program) -> list[Suite]:
    """Return all suites of a checked program in the order of their paths' declarations."""
    base = _base_of(program)
    if base is None:
        return []
    found = [
        (Suite(path, address), pou)
        for path, address, pou in instances_of(program, base)
        if not pou.is_abstract
    ]
    known: dict[int, tuple[dict[str, NamedTest], bool]] = {}
    helpers = _opens_elsewhere(program, base)
    for suite, pou in found:
        if id(pou) not in known:
            known[id(pou)] = _tests_of(program, pou)
        tests, has_others = known[id(pou)]
        suite.tests = dict(tests)
        suite.has_others = has_others or helpers
    return [suite for suite, _ in found]


def _tests_of(program: Program, pou: Pou) -> tuple[dict[str, NamedTest], bool]:
    """Return the tests that a suite and its bases name, and whether others may come."""
    tests: dict[str, NamedTest] = {}
    has_others = False
    for block in reversed([one for one in pou.bases() if not one.library]):
        for called in (block, *methods_of(block)):
            for call in _calls(called):
                if not _is_of(call, _OPENERS):
                    continue
                value = call.bound[0][1].value if call.bound else None
                span = program.sources.span(call.start, call.end)
                if not isinstance(value, bytes) or span is None:
                    has_others = True
                    continue
                name = value.decode("latin-1").strip(" ")
                if name.lower().startswith(_DISABLED):
                    name = name[len(_DISABLED) :]
                tests.setdefault(name, NamedTest(name, span))
    return tests, has_others


def _opens_elsewhere(program: Program, base: Pou) -> bool:
    """Return whether code outside of suites opens tests."""
    return any(
        _is_of(call, _OPENERS)
        for pou in program.pous.values()
        if pou.library != TEST_LIBRARY and base not in pou.bases()
        for called in (pou, *methods_of(pou))
        for call in _calls(called)
    )


def _is_of(call: Call, names: tuple[str, ...]) -> bool:
    target = call.target
    if not isinstance(target, Pou) or target.library != TEST_LIBRARY:
        return False
    return target.name.lower() in names


def _calls(called: Callable) -> Iterator[Call]:
    """Yield all calls in a body, in the order of the text."""
    waiting: list[object] = list(reversed(called.body))
    while waiting:
        node = waiting.pop()
        if isinstance(node, Call):
            yield node
        if isinstance(node, Node):
            parts = [getattr(node, name) for name in _parts_of(node)]
            waiting += [part for part in parts if isinstance(part, _TREE)]
        elif isinstance(node, list):
            waiting += reversed(node)


def _parts_of(node: Node) -> list[str]:
    """Return where nodes of this kind may have further ones, the last of the text first.

    The checker's data in a call is in its arguments, too.
    """
    kind = type(node)
    if kind not in _PARTS:
        names = [*getattr(node, "__dataclass_fields__", ())]
        _PARTS[kind] = [one for one in reversed(names) if one not in ("bound", "operands", "type")]
    return _PARTS[kind]


class SuiteRun:
    """A run of all suites of a project on a machine, in virtual time."""

    def __init__(
        self,
        plc: StructuredPlc,
        suites: list[Suite],
        machine: Machine,
        until: TimeLike | None,
        language: Language,
    ) -> None:
        self._plc = plc
        self._language: Language = language
        self._until = read_time(DEFAULT_UNTIL if until is None else until)
        self._controller = Controller(machine)
        self._suites = {one.address: one for one in suites}
        self._numbers: dict[int, Suite] = {}
        self._fault: Diagnostic | None = None

    def results(self) -> SuiteResults:
        """Run until all suites have ended, the PLC stops, or the time is over."""
        controller, plc = self._controller, self._plc
        controller.start(NcText("no program", "M30\n"), plc=plc)
        end = self._until.ticks(controller.cycle_time_us)
        while controller.tick < end and not self._fault and not self._has_ended():
            step = controller.step(min(_TICKS_AT_ONCE, end - controller.tick))
            if plc.context.fault:
                self._fault = step.diagnostics[-1]
        return self._read()

    def _has_ended(self) -> bool:
        return bool(self._value("bIsFinished"))

    def _value(self, path: str) -> int:
        return int(self._plc.read(f"{_RUN}.{path}"))

    def _text(self, path: str) -> str:
        return str(self._plc.read(f"{_RUN}.{path}"))

    def _span(self, path: str) -> Span | None:
        start = self._value(path)
        return self._plc.span_of(start) if start else None

    def _read(self) -> SuiteResults:
        results = SuiteResults({suite.path: {} for suite in self._suites.values()})
        general = self._general_problems()
        for number in range(1, self._value("nSuites") + 1):
            suite = self._suites.get(self._value(f"aSuites[{number}].pSuite"))
            if suite is not None:
                self._numbers[number] = suite
                results.problems[suite.path] = [*general, *self._stray(f"aSuites[{number}].")]
        for number in range(1, self._value("nTests") + 1):
            suite = self._numbers.get(self._value(f"aTests[{number}].nSuite"))
            if suite is not None:
                outcome = self._outcome(f"aTests[{number}].", suite)
                results.outcomes[suite.path][outcome.name] = outcome
        if self._value("nCycle") or self._fault:
            self._add_tests_without_turn(results)
        else:
            self._complain_of_suites(results)
        return results

    def _complain_of_suites(self, results: SuiteResults) -> None:
        """Note of all suites that nothing calls them."""
        for suite in self._suites.values():
            message = diagnostic(SUITE_NOT_CALLED, suite=suite.path)
            results.problems[suite.path].append(self._rendered(message))

    def _ended(self) -> set[str]:
        """Return the paths of the suites that have ended."""
        return {
            suite.path
            for number, suite in self._numbers.items()
            if self._value(f"aSuites[{number}].bIsFinished")
        }

    def _add_tests_without_turn(self, results: SuiteResults) -> None:
        """Let tests fail that a suite has not opened before the run ended without its end."""
        ended = self._ended()
        for suite in self._suites.values():
            if suite.path in ended:
                continue
            outcomes = results.outcomes[suite.path]
            missing: dict[str, Span | None] = {
                test.name: test.span for test in suite.tests.values() if test.name not in outcomes
            }
            if suite.has_others and all(name in suite.tests for name in outcomes):
                missing[OTHER_TESTS] = None
            for name, span in missing.items():
                reason = self._why_unfinished(span, name, suite)
                outcomes[name] = Outcome(name, problems=[reason])

    def _general_problems(self) -> list[str]:
        """Return the data about the tests of all suites."""
        found = self._stray("")
        if self._value("nTooMany"):
            span = self._span("nTooMany")
            found.append(self._rendered(diagnostic(TOO_MANY_TESTS, span)))
        return found

    def _stray(self, prefix: str) -> list[str]:
        span = self._span(f"{prefix}nStray")
        return [] if span is None else [self._rendered(diagnostic(OUTSIDE_OF_TESTS, span))]

    def _rendered(self, message: Diagnostic) -> str:
        span = message.span
        if span is None:
            return message.render(self._language)
        line = self._plc.program.sources.line(span.file, span.line)
        return diagnostic(message.message, span, line, **message.values).render(self._language)

    def _outcome(self, row: str, suite: Suite) -> Outcome:
        outcome = Outcome(
            self._text(f"{row}sName"),
            bool(self._value(f"{row}bIsDisabled")),
            asserts=self._value(f"{row}nAsserts"),
        )
        if self._value(f"{row}bHasFailed"):
            outcome.problems.append(self._failure(row))
        double = self._span(f"{row}nDouble")
        if double is not None:
            message = diagnostic(TEST_NAME_TWICE, double, name=outcome.name, suite=suite.path)
            outcome.problems.append(self._rendered(message))
        begin = self._value(f"{row}tBegan")
        if self._value(f"{row}bIsFinished"):
            outcome.duration_us = (self._value(f"{row}tFinished") - begin) // 1000
        elif not outcome.is_disabled:
            span = self._span(f"{row}nSource")
            outcome.problems.append(self._why_unfinished(span, outcome.name, suite))
        return outcome

    def _failure(self, row: str) -> str:
        """Return where and when an assertion failed, its message, expected and actual values."""
        failed = self._value(f"{row}nFailure")
        span, nanoseconds = self._span(f"{row}nFailedFrom"), self._value(f"{row}tFailed")
        time = Time(nanoseconds // 1000)
        tick = nanoseconds // (1000 * self._controller.cycle_time_us)
        where = "" if span is None else f"{span.file}:{span.line}: "
        when = _WHEN.get(self._language).format(time=time, tick=tick)
        if not failed:
            return f"{where}{_FAILED.get(self._language)} {when}"
        message = self._text(f"aFailures[{failed}].sMessage")
        line = "" if span is None else self._plc.program.sources.line(span.file, span.line)
        return "\n".join(
            (
                f"{where}{message or line.strip()}",
                f"    EXP: {self._text(f'aFailures[{failed}].sExpected')}",
                f"    ACT: {self._text(f'aFailures[{failed}].sActual')}",
                f"    {when}",
            )
        )

    def _why_unfinished(self, span: Span | None, name: str, suite: Suite) -> str:
        """Return why a test has not ended: a fault, an unknown name, the time."""
        if self._fault is not None:
            return self._rendered(self._fault)
        if (unknown := self._unknown()) is not None:
            return unknown
        time = Time(self._controller.tick * self._controller.cycle_time_us)
        message = diagnostic(TEST_UNFINISHED, span, name=name, suite=suite.path, time=time)
        return self._rendered(message)

    def _unknown(self) -> str | None:
        """Return the problem if a test was finished that does not exist."""
        unknown = self._span("nUnknown")
        if unknown is None:
            return None
        text = self._text("sUnknown")
        return self._rendered(diagnostic(UNKNOWN_TEST_FINISHED, unknown, name=text))


class SourcesRun(SuiteRun):
    """The same with TcUnit's own sources, whose suites hold their tests themselves.

    They do not keep where an assertion is, nor what it expected: a failure has its message, at the
    place where its test is opened.
    """

    def _has_ended(self) -> bool:
        return bool(self._plc.read(_SOURCES_ENDED))

    def _unknown(self) -> str | None:
        return None

    def _ended(self) -> set[str]:
        """Return the paths of the suites all of whose tests have ended; an open run has others."""
        if self._has_ended():
            return {suite.path for suite in self._suites.values()}
        return set()

    def _read(self) -> SuiteResults:
        results = SuiteResults({suite.path: {} for suite in self._suites.values()})
        for suite in self._suites.values():
            results.problems[suite.path] = []
            count = int(self._plc.read(f"{suite.path}.NumberOfTests"))
            room = self._tests.element_count
            if count > room:
                results.problems[suite.path].append(self._rendered(diagnostic(TOO_MANY_TESTS)))
            for number in range(1, min(count, room) + 1):
                outcome = self._outcome(f"{suite.path}.Tests[{number}].", suite)
                results.outcomes[suite.path][outcome.name] = outcome
        if self._has_ended() or self._fault or any(results.outcomes.values()):
            self._add_tests_without_turn(results)
        else:
            self._complain_of_suites(results)
        return results

    @cached_property
    def _tests(self) -> ArrayType:
        """The tests of a suite of these sources."""
        base = _base_of(self._plc.program)
        array = None if base is None else base.members["tests"].type
        if not isinstance(array, ArrayType):
            raise PlcError(diagnostic(OTHER_TEST_LIBRARY))
        return array

    @cached_property
    def _has_durations(self) -> bool:
        """Whether a test of these sources has its duration, in s."""
        return isinstance(self._tests.element, BlockType) and (
            "duration" in self._tests.element.pou.members
        )

    def _outcome(self, row: str, suite: Suite) -> Outcome:
        name = str(self._plc.read(f"{row}TestName"))
        outcome = Outcome(name, bool(self._plc.read(f"{row}TestIsSkipped")))
        test = suite.tests.get(name)
        span = None if test is None else test.span
        if self._has_durations:
            outcome.duration_us = round(1e6 * float(self._plc.read(f"{row}Duration")))
        if self._plc.read(f"{row}TestIsFailed"):
            message = str(self._plc.read(f"{row}AssertionMessage"))
            where = "" if span is None else f"{span.file}:{span.line}: "
            outcome.problems.append(f"{where}{message or _FAILED.get(self._language)}")
        if not self._plc.read(f"{row}TestIsFinished") and not outcome.is_disabled:
            outcome.problems.append(self._why_unfinished(span, name, suite))
        return outcome


def run_suites(
    plc: StructuredPlc,
    machine: Machine,
    until: TimeLike | None = None,
    language: Language = "en",
    suites: list[Suite] | None = None,
) -> SuiteResults:
    """Run the suites of a PLC on a machine; raises ``Failure`` if they cannot start.

    ``suites``: the result of ``suites_of``, if that is known.
    """
    kind = SuiteRun if _has_own_results(plc.program) else SourcesRun
    own = suites_of(plc.program) if suites is None else suites
    return kind(plc, own, machine, until, language).results()
