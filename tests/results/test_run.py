# SPDX-License-Identifier: MIT
"""What a run gives back, counted from its events."""

from nctakt.base.diagnostics import Span
from nctakt.results.run import (
    CycleResult,
    OutputCount,
    Reaction,
    ReactionResult,
    Run,
    TechnologyOutput,
)
from nctakt.results.run_statistics import RunStatistics, branch_key
from nctakt.results.trace.events import Event
from nctakt.results.trace.recorded import MemorySink
from nctakt.results.trace.sinks import TraceHeader

DEFINED = Span("part.nc", 3, 1, 2)
ONCE = Span("part.nc", 5, 3, 20)
EDGE = Span("part.nc", 9, 3, 20)


def at(span: Span) -> Span:
    """The place as an event knows it: one character wide."""
    return Span(span.file, span.line, span.column, span.column + 1)


def reactions(name: str) -> list[Reaction]:
    """Cycle 17 has two branches."""
    return [Reaction(ONCE, "ONCE"), Reaction(EDGE, "EDGE")] if name == "17" else []


EVENTS = [
    Event(0, 0, "created", "17 PROG", DEFINED, "17"),
    Event(0, 0, "started", "17", None, "17"),
    Event(4, 4000, "fired", "17 line 5", at(ONCE), "17"),
    Event(4, 4000, "M", "100 1 4000", at(ONCE), "17"),
    Event(5, 5000, "message", "half way"),
    Event(6, 6000, "output", "M 100"),
    Event(9, 9000, "M", "100 2 9000", None, "17"),
    Event(9, 9000, "ended", "17 scope", None, "17"),
]


def counted(*events: Event) -> RunStatistics:
    """Statistics of these events."""
    statistics = RunStatistics(reactions)
    statistics.events(events)
    return statistics


def test_reactions_are_counted_and_those_that_never_fire_are_reported() -> None:
    """Each branch of a cycle has its count and the ticks of its first and last firing."""
    again = Event(7, 7000, "fired", "17 line 5", at(ONCE), "17")
    assert counted(*EVENTS[:5], again).cycles({"17": 9}, {branch_key("17", ONCE): 5}) == (
        CycleResult(
            "17",
            "PROG",
            DEFINED,
            (
                ReactionResult(ONCE, "ONCE", 2, 5, 4, 7),
                ReactionResult(EDGE, "EDGE", 0, 0, None, None),
            ),
            instances=1,
            runs=9,
        ),
    )


def test_a_definition_that_is_run_again_and_again_is_counted_once() -> None:
    """Cycles without ID get new numbers each time; the result does not grow with them."""
    statistics = RunStatistics()
    for number in range(1, 4):
        name = f"#{number}"
        statistics.events(
            [
                Event(number, 0, "created", f"{name} BLOCK", DEFINED, name),
                Event(number, 0, "fired", f"{name} line 5", at(ONCE), name),
                Event(number, 0, "ended", f"{name} scope", None, name),
            ]
        )
    (cycle,) = statistics.cycles({"#1": 1, "#2": 1, "#3": 1})
    assert cycle.runs is None
    assert (cycle.name, cycle.instances, cycle.reactions[0].became_true) == ("#1", 3, 3)


def test_run_throughs_are_reported_where_they_belong_to_one_definition() -> None:
    """Two definitions with one ID share their number: neither is given it."""
    other = Span("part.nc", 33, 1, 2)
    created = [Event(9, 9000, "created", "17 PROG", place, "17") for place in (DEFINED, other)]
    assert [cycle.runs for cycle in counted(*created).cycles({"17": 9})] == [None, None]
    assert [cycle.runs for cycle in counted(created[0]).cycles({"17": 9})] == [9]


def test_a_cycle_from_an_earlier_run_is_known_when_it_fires() -> None:
    """RC-107: a GLOBAL cycle that the controller brought along is listed by what it does."""
    (cycle,) = counted(Event(4, 4000, "fired", "9 line 5", at(ONCE), "9")).cycles()
    assert (cycle.name, cycle.scope, cycle.span) == ("9", "GLOBAL", None)
    assert cycle.reactions[0].became_true == 1


def test_functions_of_cycles_and_of_the_program_are_counted_apart() -> None:
    """RC-403: M100 of a cycle is another output than M100 of the main program."""
    assert counted(*EVENTS).outputs() == (
        OutputCount("M", 100, True, 2, 4),
        OutputCount("M", 100, False, 1, 6),
    )


def test_technology_lists_each_output() -> None:
    """Each M or H function is there with tick, time, number within the tick and origin."""
    sink = MemorySink()
    sink.open(TraceHeader(1000, ()))
    sink.events(EVENTS)
    run = Run(("part.nc",), 1000, 0, 10, "ended", sink.trace)
    assert run.virtual_time_us == 10_000
    assert run.technology == [
        TechnologyOutput(4, 4000, "M", 100, 1, at(ONCE), "17"),
        TechnologyOutput(6, 6000, "M", 100, 0, None, ""),
        TechnologyOutput(9, 9000, "M", 100, 2, None, "17"),
    ]


def test_a_run_without_a_trace_has_no_events() -> None:
    """Without a trace in memory the lists are empty, the counts are not affected."""
    run = Run(("part.nc",), 1000, 0, 10, "ended")
    assert list(run.events) == []
    assert run.technology == []
