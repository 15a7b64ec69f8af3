# SPDX-License-Identifier: MIT
"""Each tick: the span of an injection, and the strip of its effects, over the program.

In: a plan with an ``each_tick`` dimension. Out: the plan with the span of the unchanged run; after
the runs, a strip with a line for each block of the program: when it was current, at how many of its
ticks the expectations held, the longest reaction.
"""

from __future__ import annotations

import bisect
import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Language
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.commands.studies import NOT_AN_INJECTION
from nctakt.studies.plans.dimension import END_OF_RUN, Dimension
from nctakt.studies.plans.inputs import RunInputs
from nctakt.studies.plans.plan import Plan
from nctakt.studies.plans.units import REACTION
from nctakt.studies.runs.study_runner import PASSED, Row, StudyRunner

_INJECTION = re.compile(r"(?P<assignment>.*=.*?)(?:\s+for\s+(?P<time>\S.*))?")

#: Marks of a strip: all ticks of it passed, some failed, all failed.
MARKS = ("·", "x", "X")

_HEADS = {
    "en": "  line  from          to            passed longest reaction",
    "de": " Zeile  von           bis           bestanden längste Reaktion",
}

_REST = {
    "en": "… {blocks} more blocks, {failed} of them with failed runs",
    "de": "… {blocks} weitere Blöcke, {failed} davon mit nicht bestandenen Läufen",
}

#: Characters of a strip, blocks that have one.
WIDTH, MAX_BLOCKS = 60, 6


def injection_table(text: str) -> dict[str, object]:
    """Return the entry of a plan for ``V.E.STOP=1 for 20 ms``; raises ``Failure`` (901315)."""
    match = _INJECTION.fullmatch(text.strip())
    if match is None:
        raise Failure(diagnostic(NOT_AN_INJECTION, text=text))
    entry: dict[str, object] = {
        "time_of": match["assignment"],
        "name": "injected",
        "each_tick": True,
    }
    return entry if match["time"] is None else entry | {"for": match["time"]}


@dataclass(frozen=True, slots=True)
class Nominal:
    """The unchanged run: its length in ticks, and first tick, line and text of its blocks.

    ``broken``: the expectations that it does not meet, apart from those about an injection.
    """

    ticks: int
    cycle_time_us: int
    blocks: tuple[tuple[int, int, str], ...]
    broken: str = ""


def nominal_run(runner: StudyRunner) -> Nominal:
    """Make the unchanged run; raises ``Failure`` as a run."""
    inputs = RunInputs(dict(runner.plan.assignments), list(runner.plan.stimuli))
    outcome = runner.begin(inputs, blocks=True).finish().outcome
    run = outcome.run
    blocks: list[tuple[int, int, str]] = []
    assert run.trace is not None
    for event in run.trace.events:
        if event.kind == "block" and event.span is not None:
            blocks.append((event.tick, event.span.line, runner.line(event.span.line)))
    about_it = [one for one in runner.plan.expectations if not one.is_about_injection]
    broken = "; ".join(runner.broken(outcome, about_it))
    return Nominal(run.ticks, run.cycle_time_us, tuple(blocks), broken)


def with_span(plan: Plan, nominal: Nominal) -> Plan:
    """Return a plan whose ``each_tick`` dimensions end with the unchanged run."""
    end_us = (nominal.ticks - 1) * nominal.cycle_time_us

    def settled(dimension: Dimension) -> Dimension:
        is_open = dimension.is_each_tick and dimension.high == END_OF_RUN
        return replace(dimension, high=end_us) if is_open else dimension

    return replace(plan, dimensions=tuple(settled(one) for one in plan.dimensions))


def strip(
    rows: Sequence[Row], nominal: Nominal, name: str, language: Language = "en"
) -> Iterator[str]:
    """Yield the lines of the strip; ``name``: the column with the time of the injection.

    Of many blocks those with failed runs come first; a last line counts the others.
    """
    starts = [start for start, _, _ in nominal.blocks]
    ends = [*starts[1:], nominal.ticks]
    blocks = [_Block() for _ in starts]
    for row in rows:
        tick = round(float(row[name] or 0) * 1e6) // nominal.cycle_time_us
        number = bisect.bisect_right(starts, tick) - 1
        if number >= 0 and tick < ends[number]:
            blocks[number].add(row)
    tried = [number for number, own in enumerate(blocks) if own.held]
    failed = [number for number in tried if not all(blocks[number].held)]
    shown = sorted(sorted(tried, key=lambda number: all(blocks[number].held))[:MAX_BLOCKS])
    yield _HEADS[language]
    for number in shown:
        own, (start, line, text), end = blocks[number], nominal.blocks[number], ends[number]
        longest = "–" if own.longest_s is None else f"{own.longest_s:.6f} s"
        first_s, last_s = (tick * nominal.cycle_time_us / 1e6 for tick in (start, end - 1))
        span = f"{first_s:.6f} s … {last_s:.6f} s"
        yield f"{line:6}  {span}  {sum(own.held)}/{len(own.held)}  {longest}  {text.strip()}"
        yield f"        {marks(own.held)}"
    if len(tried) > len(shown):
        left = len(failed) - len({*failed} & {*shown})
        yield _REST[language].format(blocks=len(tried) - len(shown), failed=left)


class _Block:
    """Results of the injections into a block: whether each passed, and the longest reaction."""

    def __init__(self) -> None:
        self.held = bytearray()
        self.longest_s: float | None = None

    def add(self, row: Row) -> None:
        """Add an injection."""
        self.held.append(row["verdict"] == PASSED)
        time_s = row.get(REACTION)
        if isinstance(time_s, float):
            self.longest_s = max(time_s, self.longest_s or 0.0)


def marks(held: Sequence[int]) -> str:
    """Return a strip of at most ``WIDTH`` characters for verdicts in the order of their ticks."""
    count = min(len(held), WIDTH)
    text = ""
    for index in range(count):
        part = held[index * len(held) // count : (index + 1) * len(held) // count]
        text += MARKS[0] if all(part) else MARKS[1] if any(part) else MARKS[2]
    return text
