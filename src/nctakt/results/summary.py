# SPDX-License-Identifier: MIT
"""The summary at the end of a run, for a reader.

In: ``Run`` and its wall-clock time. Out: lines of text: the end of the run, its realtime cycles, M
and H functions, motions of axes, jobs of spindles, messages, errors and warnings. On a terminal the
tables are drawn with rich; elsewhere they are plain text, the same for the same run.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TextIO

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Language, Severity, Span, Text
from nctakt.lists.format.times import time_stamp
from nctakt.results.run import (
    CycleResult,
    MotionCount,
    OutputCount,
    ReactionResult,
    Run,
    RunState,
)
from nctakt.results.starving import schedule_lines
from nctakt.results.trace.events import value_text

_STATES = {
    "ended": Text("ended", "beendet"),
    "error": Text("stopped by an error", "durch einen Fehler angehalten"),
    "limit": Text(
        "stopped at the limit (--until or --ticks sets another)",
        "an der Grenze angehalten (--until oder --ticks setzt eine andere)",
    ),
    "reset": Text("reset", "zurückgesetzt"),
    "interrupted": Text("interrupted", "abgebrochen"),
}
_NOT_RUN = Text("not run", "nicht gelaufen")
_CYCLE_HEADS = (
    Text("Realtime cycle", "Echtzeit-Zyklus"),
    Text("Scope", "Gültigkeit"),
    Text("Runs", "Durchläufe"),
    Text("Reaction", "Reaktion"),
    Text("Became true", "Wurde wahr"),
    Text("Ran", "Lief"),
    Text("First", "Zuerst"),
)
_OUTPUT_HEADS = (
    Text("Function", "Funktion"),
    Text("From", "Aus"),
    Text("Count", "Anzahl"),
    Text("First", "Zuerst"),
)
_MOTION_HEADS = (
    Text("Motion", "Bewegung"),
    Text("From", "Aus"),
    Text("Count", "Anzahl"),
    Text("At target", "Am Ziel"),
    Text("First", "Zuerst"),
)
_JOB_HEADS = (
    Text("Spindle job", "Spindelauftrag"),
    Text("From", "Aus"),
    Text("Count", "Anzahl"),
    Text("First", "Zuerst"),
)
_FROM_PLC = Text("PLC", "SPS")
_FROM_CYCLE = Text("realtime cycle", "Echtzeit-Zyklus")
_FROM_PROGRAM = Text("program", "Programm")
_FROZEN = Text("Frozen in cycle {name}: {values}", "Eingefroren in Zyklus {name}: {values}")
_FROZEN_VALUE = Text("{name} = {value} (line {line})", "{name} = {value} (Zeile {line})")
_FURTHER = Text("… {count} more", "… {count} weitere")
_NEVER = Text("never", "nie")
_NO_REACTION = Text("no branch", "kein Zweig")
_TIMES = Text("{count} times", "{count}-mal")
#: Counted things: singular and plural.
_COUNTS = (
    (Text("message", "Meldung"), Text("messages", "Meldungen")),
    (Text("error", "Fehler"), Text("errors", "Fehler")),
    (Text("warning", "Warnung"), Text("warnings", "Warnungen")),
    (Text("note", "Hinweis"), Text("notes", "Hinweise")),
)


#: Maximum number of frozen values of a cycle in the summary; nctakt disassemble shows all.
MAX_FROZEN = 6


@dataclass(frozen=True, slots=True)
class Table:
    """Heads and rows of text, of equal length."""

    heads: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


def print_summary(
    run: Run, file: TextIO, language: Language = "en", wall_s: float | None = None
) -> None:
    """Write the summary to ``file``.

    ``wall_s`` is the wall-clock time of the run in seconds; it is shown on a terminal only.
    """
    terminal = file.isatty()
    print(headline(run, language, wall_s if terminal else None), file=file)
    for table, notes in (
        (_cycles(run, language), frozen_lines(run, language)),
        (_outputs(run, language), []),
        (_motions(run, language), []),
        (_spindle_jobs(run, language), []),
    ):
        if not table.rows:
            continue
        if terminal:
            _print_rich(table, file)
        else:
            print("", *plain_table(table), sep="\n", file=file)
        if notes:
            print("", *notes, sep="\n", file=file)
    lines = schedule_lines(run.schedule, run.starved, run.overflows, language)
    if lines:
        print("", *lines, sep="\n", file=file)
    print("", counts(run, language), sep="\n", file=file)


def headline(run: Run, language: Language, wall_s: float | None) -> str:
    """Return programs, end, ticks, the machine's time and, with ``wall_s``, the speed factor."""
    names = ", ".join(run.programs)
    if run.ticks == 0:
        return f"{names}: {_NOT_RUN.get(language)}"
    time_s = time_stamp(run.virtual_time_us)
    how = state_text(run.state, language)
    singular, plural = Text("tick", "Takt"), Text("ticks", "Takte")
    ticks = (singular if run.ticks == 1 else plural).get(language)
    text = f"{names}: {how}, {run.ticks} {ticks} = {time_s}"
    if wall_s is None or wall_s <= 0.0:
        return text
    took = f"{wall_s:.1f} s" if wall_s >= 1.0 else f"{wall_s * 1000.0:.0f} ms"
    factor = _factor(run.virtual_time_us / 1e6 / wall_s)
    faster = Text(
        f"in {took}, {factor} times as fast as the machine",
        f"in {took}, {factor}-mal so schnell wie die Maschine",
    )
    return f"{text}, {faster.get(language)}"


def state_text(state: RunState, language: Language) -> str:
    """Return how a run has ended."""
    return _STATES[state].get(language)


def _factor(value: float) -> str:
    return f"{value:.0f}" if value >= 10.0 else f"{value:.1f}"


def counts(run: Run, language: Language) -> str:
    """Return the numbers of messages, errors, warnings and notes on one line."""
    levels = [Severity.ERROR, Severity.WARNING, Severity.NOTE]
    numbers = [len(run.messages), *(_count(run.diagnostics, level) for level in levels)]
    return ", ".join(
        f"{number} {(singular if number == 1 else plural).get(language)}"
        for number, (singular, plural) in zip(numbers, _COUNTS, strict=True)
    )


def _count(diagnostics: Sequence[Diagnostic], severity: Severity) -> int:
    return sum(diagnostic.severity is severity for diagnostic in diagnostics)


def _cycles(run: Run, language: Language) -> Table:
    rows: list[tuple[str, ...]] = []
    for cycle in run.cycles:
        runs = "" if cycle.runs is None else str(cycle.runs)
        head = (_cycle_name(cycle, language), cycle.scope, runs)
        if not cycle.reactions:
            rows.append((*head, _NO_REACTION.get(language), "", "", ""))
        for reaction in cycle.reactions:
            rows.append((*head, *_reaction(run, reaction, language)))
            head = ("", "", "")
    return Table(tuple(head.get(language) for head in _CYCLE_HEADS), tuple(rows))


def frozen_lines(run: Run, language: Language) -> list[str]:
    """Return a line for each cycle with asynchronous variables: their values (RC-302)."""
    shown, further = _FROZEN_VALUE.get(language), _FURTHER.get(language)
    lines: list[str] = []
    for cycle in run.cycles:
        values = [
            shown.format(name=value.name, value=value_text(value.value), line=value.span.line)
            for value in cycle.frozen
        ]
        if len(values) > MAX_FROZEN:
            values[MAX_FROZEN:] = [further.format(count=len(values) - MAX_FROZEN)]
        if values:
            text = _FROZEN.get(language)
            lines.append(text.format(name=cycle.name, values=", ".join(values)))
    return lines


def _cycle_name(cycle: CycleResult, language: Language) -> str:
    name = f"{cycle.name} {_position(cycle.span)}".rstrip()
    if cycle.instances == 1:
        return name
    return f"{name}, {_TIMES.get(language).format(count=cycle.instances)}"


def _reaction(run: Run, reaction: ReactionResult, language: Language) -> tuple[str, ...]:
    position = f"{_position(reaction.span)} {reaction.frequency}".strip()
    if reaction.first_tick is None:
        ran = str(reaction.ran) if reaction.ran else ""
        return position, _NEVER.get(language), ran, ""
    first = _tick(run, reaction.first_tick, language)
    return position, str(reaction.became_true), str(reaction.ran), first


def _outputs(run: Run, language: Language) -> Table:
    rows = tuple(_output(run, output, language) for output in run.outputs)
    return Table(tuple(head.get(language) for head in _OUTPUT_HEADS), rows)


def _output(run: Run, output: OutputCount, language: Language) -> tuple[str, ...]:
    origin = _FROM_CYCLE if output.is_realtime else _FROM_PROGRAM
    first = _tick(run, output.first_tick, language)
    return output.name, origin.get(language), str(output.count), first


def _origin(motion: MotionCount) -> Text:
    """Return who has commanded a motion."""
    if motion.is_realtime:
        return _FROM_CYCLE
    return _FROM_PROGRAM if motion.is_of_program else _FROM_PLC


def _motions(run: Run, language: Language) -> Table:
    rows = tuple(
        (
            motion.axis,
            _origin(motion).get(language),
            str(motion.count),
            str(motion.done),
            _tick(run, motion.first_tick, language),
        )
        for motion in run.motions
    )
    return Table(tuple(head.get(language) for head in _MOTION_HEADS), rows)


def _spindle_jobs(run: Run, language: Language) -> Table:
    rows = tuple(
        (
            f"{job.spindle} {job.function}",
            (_FROM_CYCLE if job.is_realtime else _FROM_PROGRAM).get(language),
            str(job.count),
            _tick(run, job.first_tick, language),
        )
        for job in run.spindle_jobs
    )
    return Table(tuple(head.get(language) for head in _JOB_HEADS), rows)


def _tick(run: Run, tick: int, language: Language) -> str:
    word = Text("tick", "Takt").get(language)
    return f"{word} {tick} = {time_stamp(tick * run.cycle_time_us)}"


def _position(span: Span | None) -> str:
    return "" if span is None else f"{span.file}:{span.line}"


def plain_table(table: Table) -> list[str]:
    """Return the table as lines: columns padded and two blanks apart, a rule below the heads."""
    widths = [max(map(len, column)) for column in zip(table.heads, *table.rows, strict=True)]
    lines = [
        "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip()
        for row in (table.heads, *table.rows)
    ]
    return [lines[0], "-" * (sum(widths) + 2 * (len(widths) - 1)), *lines[1:]]


def _print_rich(table: Table, file: TextIO) -> None:
    from rich import box  # noqa: PLC0415 - only loaded for a terminal
    from rich.console import Console  # noqa: PLC0415
    from rich.markup import escape  # noqa: PLC0415
    from rich.table import Table as RichTable  # noqa: PLC0415

    widths = [max(map(len, column), default=0) for column in zip(*table.rows, strict=True)]
    heads = [
        head if len(head) <= width else head.replace(" ", "\n")
        for head, width in zip(table.heads, widths, strict=True)
    ]
    drawn = RichTable(*heads, box=box.SIMPLE_HEAD, show_edge=False, pad_edge=False)
    for row in table.rows:
        drawn.add_row(*map(escape, row))
    print(file=file)
    Console(file=file, highlight=False).print(drawn)
