# SPDX-License-Identifier: MIT
"""What the live page shows: the state of a session -> rows, marks and curves, without a browser.

In: snapshots of a session, the program's lines. Out: plain values that the page hands to its
elements. Nothing here knows a browser, a thread or a clock.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Language, Span
from nctakt.live.texts import Texts
from nctakt.results.run import ProgramMessage, RunState
from nctakt.run.plc_view import SpindleEntry, TechnologyEntry
from nctakt.session.engine import BranchState, CycleState
from nctakt.trace.events import Event

_AXIS = re.compile(r"(\w+)\.ACS\.ACT_POS")
_OPERAND = re.compile(r"V\.(?:E|RTA|RTG|CH)\.[A-Z_0-9.]+(?:\[\d+\])?[A-Z_0-9.]*", re.IGNORECASE)

#: Signals of the operator's panel and the position display, as far as the machine has them.
PANEL = (
    "PATH.SPEED",
    "PATH.DIST_TO_GO",
    "PATH.RAPID",
    "HLI.OVERRIDE",
    "HLI.FEED_HOLD",
    "HLI.SINGLE_BLOCK",
    "HLI.STATE",
    "HLI.PAUSED",
    "HLI.ARMED",
    "HLI.ERROR",
)

#: A function or a job of a spindle that waits for the PLC.
Entry = TechnologyEntry | SpindleEntry

#: Marks in a chart at most: the latest.
MAX_MARKS = 60

#: Operands beside the lines at most.
MAX_OPERANDS = 40


@dataclass(frozen=True, slots=True)
class Snapshot:
    """A session at a tick, as the page shows it.

    ``number`` counts snapshots, ``serial`` the sessions that have been opened. ``latest``: the tick
    that the branch has reached. ``operands``: name -> value of what conditions read, while the
    session stands.
    """

    number: int
    serial: int
    tick: int
    latest: int
    branch: int
    is_playing: bool
    run_state: RunState | None
    values: Mapping[str, float | bool | str]
    blocks: Mapping[int, Span]
    cycles: Sequence[CycleState]
    waiting: Sequence[tuple[int, Entry]]
    operands: Mapping[str, float]


@dataclass(frozen=True, slots=True)
class LogRow:
    """A row of the lists of findings, messages and events; ``line`` 0: none."""

    kind: str
    line: int
    text: str
    remedy: str = ""


@dataclass(frozen=True, slots=True)
class TimeMark:
    """A reaction (``fired``) or a function (``M``, ``H``) in a tick."""

    tick: int
    kind: str
    label: str


@dataclass(frozen=True, slots=True)
class Curves:
    """Signals over time: ``ticks`` and, for each of ``names``, a value at each of them."""

    names: tuple[str, ...]
    ticks: Sequence[int]
    columns: Sequence[Sequence[float]]


# --- signals ------------------------------------------------------------------------------------


def axes_of(signals: Mapping[str, str]) -> list[str]:
    """Return the names of the first channel's axes, in their order."""
    return [match[1] for name in signals if (match := _AXIS.fullmatch(name))]


def operands_of(lines: Sequence[str], cycles: Sequence[CycleState]) -> list[str]:
    """Return the variables in the conditions of living cycles, each once."""
    names: dict[str, None] = {}
    for cycle in cycles:
        for branch in cycle.branches:
            if 1 <= branch.span.line <= len(lines):
                names.update(dict.fromkeys(operands_in(lines[branch.span.line - 1])))
    return list(names)[:MAX_OPERANDS]


def operands_in(line: str) -> list[str]:
    """Return the variables that a line names, without its comment."""
    code = re.sub(r"\([^)]*\)", "", line.split(";", maxsplit=1)[0])
    return list(dict.fromkeys(_OPERAND.findall(code)))


def first_signals(signals: Mapping[str, str], lines: Sequence[str]) -> list[str]:
    """Return what the scope shows first: axes of the program, path speed, variables that it names.

    At most 12.
    """
    text = "\n".join(lines).upper()
    axes = [axis for axis in axes_of(signals) if re.search(rf"\b{axis}[-+=.\d\[]", text)]
    named = {name.upper() for line in lines for name in operands_in(line)}
    variables = [name for name in signals if name.startswith("V.E.") and name.upper() in named]
    chosen = [f"{axis}.ACS.ACT_POS" for axis in axes[:3]]
    chosen += [name for name in ("PATH.SPEED",) if name in signals]
    return [*chosen, *variables][:12]


def number(value: float | bool | str, digits: int = 3) -> str:
    """Return a value as text: numbers with at most these decimals."""
    if isinstance(value, str):
        return value
    text = f"{float(value):.{digits}f}"
    return text.rstrip("0").rstrip(".") if "." in text and digits > 3 else text


def plain_number(value: float) -> str:
    """Return a number as short as it can be, such as ``0.5`` or ``3``."""
    return f"{value:.6g}"


# --- the program --------------------------------------------------------------------------------


def program_marks(
    lines: Sequence[str], file: str, snapshot: Snapshot, texts: Texts
) -> list[dict[str, Any]]:
    """Return the editor's decorations: the current block, conditions, counts beside the lines."""
    found: list[dict[str, Any]] = []
    offsets = [0]
    for text in lines:
        offsets.append(offsets[-1] + len(text) + 1)
    for span in snapshot.blocks.values():
        if span.file == file and 1 <= span.line <= len(lines):
            found.append({"kind": "line", "line": span.line, "class": "nc-block"})
    for cycle in snapshot.cycles:
        for branch in cycle.branches:
            line = branch.span.line
            if branch.span.file != file or not 1 <= line <= len(lines):
                continue
            found.append({"kind": "line", "line": line, "class": truth_class(branch)})
            found.append(
                {
                    "kind": "widget",
                    "position": offsets[line] - 1,
                    "text": branch_text(branch, lines[line - 1], snapshot.operands, texts),
                    "class": "nc-inline",
                }
            )
    return found


def truth_class(branch: BranchState) -> str:
    """Return the class of a condition's line by its truth and whether its body has run."""
    if branch.truth is None:
        return "nc-unknown"
    run = " nc-ran" if branch.has_run else ""
    return ("nc-true" if branch.truth else "nc-false") + run


def branch_text(branch: BranchState, line: str, operands: Mapping[str, float], texts: Texts) -> str:
    """Return what stands beside a condition: truth, runs, operands."""
    truth = {None: "unknown", True: "true", False: "false"}[branch.truth]
    parts = [f"{texts[truth]} · {branch.count}×"]
    parts += [
        f"{name} = {plain_number(operands[name])}" for name in operands_in(line) if name in operands
    ]
    return "   ".join(parts)


# --- lists --------------------------------------------------------------------------------------


def finding_rows(found: Sequence[Diagnostic], file: str, language: Language) -> list[LogRow]:
    """Return diagnostics of a program as rows: the worst first, then by line."""
    rows = [
        (
            -one.severity,
            one.span.line if one.span is not None and one.span.file == file else 0,
            one,
        )
        for one in found
    ]
    rows.sort(key=lambda row: row[:2])
    return [
        LogRow(
            one.severity.name.casefold(),
            line,
            f"{one.id}: {one.text(language)}",
            one.remedy(language),
        )
        for _, line, one in rows
    ]


def message_row(message: ProgramMessage) -> LogRow:
    """Return a program's message as a row."""
    return LogRow("message", 0, f"{message.time_us / 1000:g} ms  {message.text}")


def event_row(event: Event) -> LogRow:
    """Return an event as a row."""
    line = event.span.line if event.span is not None else 0
    return LogRow(event.kind, line, f"{event.tick}  {event.kind}  {event.text}")


def function_text(entry: Entry) -> str:
    """Return a waiting function as a person names it, such as ``M100`` or ``S M3 500``."""
    if isinstance(entry, SpindleEntry):
        return f"{entry.spindle} M{entry.function} {plain_number(entry.speed)}"
    axis = f" {entry.axis}" if entry.axis else ""
    return f"{entry.letter}{entry.number}{axis}"


# --- marks in time ------------------------------------------------------------------------------


def time_marks(events: Sequence[Event]) -> list[TimeMark]:
    """Return the reactions and functions among events."""
    found = []
    for event in events:
        if event.kind == "fired":
            line = event.span.line if event.span is not None else 0
            found.append(TimeMark(event.tick, "fired", f"{event.cycle}:{line}"))
        elif event.kind in ("M", "H"):
            found.append(TimeMark(event.tick, event.kind, event.kind + event.text.split()[0]))
    return found


def merged_marks(
    marks: Sequence[TimeMark], new: Sequence[TimeMark], up_to: int | None
) -> list[TimeMark]:
    """Return marks without doubles, by tick; those of ``marks`` from ``up_to`` on are dropped."""
    kept = [mark for mark in marks if up_to is None or mark.tick < up_to]
    found = {(mark.tick, mark.kind, mark.label): mark for mark in (*kept, *new)}
    return sorted(found.values(), key=lambda mark: mark.tick)


# --- variables ----------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class VariableRow:
    """A V.E variable: its field is a switch, a whole number or a number."""

    name: str
    field: str


def variable_rows(types: Sequence[tuple[str, str]], lines: Sequence[str]) -> list[VariableRow]:
    """Return the V.E variables with their fields: first those that the program names."""
    named = {name.upper() for line in lines for name in operands_in(line)}
    rows = [
        VariableRow(name, _field(kind))
        for name, kind in types
        if name.startswith("V.E.") and kind not in ("STRING", "VSTRING")
    ]
    return sorted(rows, key=lambda row: row.name.upper() not in named)


def _field(kind: str) -> str:
    if kind == "BOOLEAN":
        return "switch"
    return "number" if kind.startswith("REAL") else "integer"
