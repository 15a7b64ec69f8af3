# SPDX-License-Identifier: MIT
"""Content of the live page: the state of a session -> rows, marks and curves, without a browser.

In: snapshots of a session, the program's lines. Out: plain values that the page hands to its
elements. Nothing here knows a browser, a thread or a clock.
"""

from __future__ import annotations

import math
import re
from collections.abc import Collection, Mapping, Sequence
from typing import Any

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Language, Span, Text
from nctakt.hli.plc_entries import SpindleEntry, TechnologyEntry
from nctakt.live.conditions import is_condition
from nctakt.live.syntax import units
from nctakt.live.texts import Texts
from nctakt.results.compared import Compared
from nctakt.results.run import ProgramMessage, RunState
from nctakt.results.trace.event_words import event_text
from nctakt.results.trace.events import Event
from nctakt.session.engine import BranchState, CycleState
from nctakt.session.statements import PlcPlace, names_file

_AXIS = re.compile(r"((?:CH\d+\.)?)(\w+)\.ACS\.ACT_POS")
_ELSE = re.compile(r"\s*(?:N\d+\s*)?\$ELSE\b(?!IF)", re.IGNORECASE)
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
    "HLI.BACKWARD_MOTION",
    "HLI.RETRACE",
    "HLI.HISTORY_SIZE",
)

#: A function or a job of a spindle that waits for the PLC.
Entry = TechnologyEntry | SpindleEntry

#: Maximum characters of the compared values next to a condition.
_MAX_COMPARED = 100

#: V.E variables that the page shows at most, and signals of the scope.
MAX_VARIABLES, MAX_SIGNALS = 400, 12


@dataclass(frozen=True, slots=True)
class Snapshot:
    """A session at a tick, as the page shows it.

    ``number`` counts snapshots, ``serial`` the sessions that have been opened. ``latest``: the tick
    that the branch has reached. ``blocks`` and ``decoding``: number of the channel -> place of the
    current block, and of the decoder. ``cycles``: those that have ended come first. ``late``:
    slices that came late since the clock began. ``awaited``: the reason for which the program of
    the shown channel waits. ``statement``: its position within the tick, before a statement of its
    PLC.
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
    decoding: Mapping[int, Span]
    cycles: Sequence[CycleState]
    waiting: Sequence[tuple[int, Entry]]
    late: int = 0
    awaited: Text | None = None
    statement: PlcPlace | None = None

    @property
    def shown_tick(self) -> int:
        """The tick that the page names: the last one that has run, -1 before the first.

        All values are those after this tick, as in traces.
        """
        return self.tick - 1


@dataclass(frozen=True, slots=True)
class LogRow:
    """A row of the lists of findings, messages and events; ``line`` 0: none that can be shown.

    ``file``: the PLC's file that has the line, empty: the program shown. ``outside``: file and line
    of an entry outside this program, empty: ``line`` has it. ``signal``: the one that it offers.
    """

    kind: str
    line: int
    text: str
    remedy: str = ""
    file: str = ""
    outside: str = ""
    signal: str = ""


# --- signals ------------------------------------------------------------------------------------


def axes_of(signals: Mapping[str, str], prefix: str = "") -> list[str]:
    """Return the names of a channel's axes, in their order; ``prefix``: that of its signals."""
    matches = (_AXIS.fullmatch(name) for name in signals)
    return [match[2] for match in matches if match is not None and match[1] == prefix]


def placed_axes(axes: Sequence[str]) -> tuple[str | None, str | None, str | None]:
    """Return the axes of a channel that are drawn along with another channel's as X, Y and Z.

    By their first letters, with U, V, W as axes parallel to X, Y, Z.
    """
    found: dict[int, str] = {}
    for axis in axes:
        index = "XYZUVW".find(axis[0])
        if index >= 0:
            found.setdefault(index % 3, axis)
    return found.get(0), found.get(1), found.get(2)


def choosable(signals: Mapping[str, str]) -> list[str]:
    """Return the signals that a person may choose; those of channel 1 by their short names."""
    return [
        name for name in signals if name.removeprefix("CH1.") == name or name[4:] not in signals
    ]


def variables_read(signals: Mapping[str, str], prefix: str = "") -> list[str]:
    """Return the V.E variables of a channel that are read in each look."""
    return [name for name in signals if name.startswith(f"{prefix}V.E.")][:MAX_VARIABLES]


def branches_in(
    cycles: Sequence[CycleState], file: str
) -> dict[int, tuple[CycleState, BranchState]]:
    """Return the branches in a file by line: if there are several, the last evaluated one.

    A cycle that has ended gives way to a living one.
    """
    found: dict[int, tuple[CycleState, BranchState]] = {}
    for cycle in sorted(cycles, key=lambda one: one.state != "ended"):
        for branch in cycle.branches:
            if branch.span.file != file:
                continue
            known = found.get(branch.span.line)
            is_older = (
                known is not None
                and known[0].state == cycle.state
                and (known[1].evaluated_at or -1) > (branch.evaluated_at or -1)
            )
            if not is_older:
                found[branch.span.line] = cycle, branch
    return found


def truths(cycles: Sequence[CycleState], file: str) -> dict[int, bool | None]:
    """Return the truth of the conditions in a file, by their lines: ``None`` once it has ended."""
    return {
        line: None if cycle.state == "ended" else branch.truth
        for line, (cycle, branch) in branches_in(cycles, file).items()
    }


def operands_in(line: str) -> list[str]:
    """Return the variables that a line names, without its comment."""
    code = re.sub(r"\([^)]*\)", "", line.split(";", maxsplit=1)[0])
    return list(dict.fromkeys(_OPERAND.findall(code)))


def variables_named(lines: Sequence[str]) -> set[str]:
    """Return the variables that a program names, in capitals."""
    return {
        name.upper() for line in lines if "V." in line or "v." in line for name in operands_in(line)
    }


def first_signals(signals: Mapping[str, str], lines: Sequence[str], prefix: str = "") -> list[str]:
    """Return the initial signals of the scope: axes of the program, path speed, its variables.

    At most 12.
    """
    text = "\n".join(lines).upper()
    axes = [
        axis
        for axis in axes_of(signals, prefix)
        if axis in text and re.search(rf"\b{axis}[-+=.\d\[]", text)
    ]
    named = variables_named(lines)
    variables = [
        name
        for name in signals
        if name.startswith(f"{prefix}V.E.") and name.removeprefix(prefix).upper() in named
    ]
    chosen = [f"{prefix}{axis}.ACS.ACT_POS" for axis in axes[:3]]
    chosen += [name for name in (f"{prefix}PATH.SPEED",) if name in signals]
    return [*chosen, *variables][:MAX_SIGNALS]


def rounded(value: float) -> float | None:
    """Return a number with the digits shown in a chart; ``None`` for NaN."""
    return float(f"{value:.7g}") if math.isfinite(value) else None


def plain_number(value: float) -> str:
    """Return a number as short as it can be, such as ``0.5`` or ``3``."""
    return f"{value:.6g}"


def values_of(snapshot: Snapshot, names: Sequence[str]) -> list[float | None]:
    """Return the values of signals at a snapshot's tick; ``None`` if it has none."""
    values = snapshot.values
    return [rounded(float(values[name])) if name in values else None for name in names]


# --- the program --------------------------------------------------------------------------------


def program_marks(
    lines: Sequence[str],
    file: str,
    snapshot: Snapshot,
    texts: Texts,
    stops: Sequence[int] = (),
) -> list[dict[str, Any]]:
    """Return the editor's marks of lines: blocks of path and decoder, stops, conditions.

    ``text`` next to a condition has its truth, the compared values, and its runs. ``stops``: lines
    with a stop.
    """
    found: list[dict[str, Any]] = []
    for places, name in ((snapshot.blocks, "nc-block"), (snapshot.decoding, "nc-decoding")):
        for span in places.values():
            if span.file == file and 1 <= span.line <= len(lines):
                found.append({"line": span.line, "class": name})
    for line in stops:
        if 1 <= line <= len(lines):
            found.append({"line": line, "class": "nc-stop"})
    for line, (cycle, branch) in branches_in(snapshot.cycles, file).items():
        if not 1 <= line <= len(lines):
            continue
        has_ended = cycle.state == "ended"
        name = "nc-unknown" if has_ended else truth_class(branch)
        text = branch_text(branch, lines[line - 1], texts, has_ended=has_ended)
        moved = " nc-moved" if is_moved(branch) else ""
        found.append({"line": line, "class": name})
        found.append({"line": line, "text": text, "class": f"nc-inline{moved}"})
    return found


def block_line(snapshot: Snapshot, channel: int, file: str) -> int:
    """Return the line of a channel's current block, 0 where it is in another file."""
    span = snapshot.blocks.get(channel)
    return span.line if span is not None and span.file == file else 0


def finding_marks(
    lines: Sequence[str], file: str, found: Sequence[Diagnostic], language: Language
) -> list[dict[str, Any]]:
    """Return the editor's marks of findings: their columns are underlined, ``text`` says why."""
    marks = []
    for one in found:
        span = one.span
        if span is None or span.file != file or not 1 <= span.line <= len(lines):
            continue
        line = lines[span.line - 1]
        begin = min(max(span.column - 1, 0), max(len(line) - 1, 0))
        end = min(max(span.end_column - 1, begin + 1), len(line))
        marks.append(
            {
                "line": span.line,
                "from": units(line, begin),
                "to": units(line, end),
                "class": f"nc-{one.severity.name.casefold()}",
                "text": f"{one.id}: {one.text(language)}",
                "remedy": one.remedy(language),
            }
        )
    return marks


def truth_class(branch: BranchState) -> str:
    """Return the class of a condition's line by its truth and whether its body has run."""
    if branch.truth is None:
        return "nc-unknown"
    run = " nc-ran" if branch.has_run else ""
    return ("nc-true" if branch.truth else "nc-false") + run


def is_moved(branch: BranchState) -> bool:
    """Return whether a condition would compare visibly other values now than when evaluated.

    A difference below the digits that are shown would look like none.
    """
    seen, now = branch.seen, branch.now
    if seen is None or now is None:
        return seen is not now
    return (seen.truth, str(seen)) != (now.truth, str(now))


def branch_text(branch: BranchState, line: str, texts: Texts, *, has_ended: bool = False) -> str:
    """Return the text next to a condition: last evaluation, present values, number of runs."""
    ran = f"{texts['ran']} {branch.count}×"
    seen, now = branch.seen, branch.now
    if seen is None:
        unknown = texts["no_result" if has_ended else "unknown"]
        return ran if _ELSE.match(line) else f"{unknown} · {ran}"
    when = texts["in_tick"].format(tick=branch.evaluated_at)
    parts = [f"{_truth_text(seen, texts)} {when}{_compared_text(seen)}"]
    if is_moved(branch):
        text = texts["undefined"]
        if now is not None:
            text = f"{_truth_text(now, texts)}{_compared_text(now)}"
        parts.append(f"{texts['now']} {text}")
    return " · ".join([*parts, ran])


def _truth_text(compared: Compared, texts: Texts) -> str:
    return texts["true" if compared.truth else "false"]


def _compared_text(compared: Compared) -> str:
    """Return the compared values after a colon; texts are not recorded."""
    if compared.operator == "text":
        return ""
    text = str(compared)
    return f": {text if len(text) <= _MAX_COMPARED else text[: _MAX_COMPARED - 1] + '…'}"


# --- lists --------------------------------------------------------------------------------------


def finding_rows(
    found: Sequence[Diagnostic], file: str, language: Language, plc: Collection[str] = ()
) -> list[LogRow]:
    """Return diagnostics of a program as rows: the worst first, then by file and line.

    ``plc``: the files of the PLC, which can be shown, too. Lines of other files are named only.
    """
    rows = [(-one.severity, *location_of(one.span, file, plc), one) for one in found]
    rows.sort(key=lambda row: (row[0], row[3], row[1], row[4].id))
    return [
        LogRow(
            one.severity.name.casefold(),
            line,
            f"{one.id}: {one.text(language)}",
            one.remedy(language),
            of_plc,
            outside,
        )
        for _, line, of_plc, outside, one in rows
    ]


def location_of(span: Span | None, file: str, plc: Collection[str]) -> tuple[int, str, str]:
    """Return the line of a span, 0 where it cannot be shown; its file of the PLC; file and line.

    The last is empty in the program that is shown.
    """
    if span is None:
        return 0, "", ""
    if span.file == file:
        return span.line, "", ""
    outside = f"{span.file}:{span.line}" if span.line else span.file
    return (span.line, span.file, outside) if span.file in plc else (0, "", outside)


def message_row(message: ProgramMessage | LogRow) -> LogRow:
    """Return a program's message as a row; a row is returned unchanged."""
    if isinstance(message, LogRow):
        return message
    return LogRow("message", 0, f"{message.time_us / 1000:g} ms  {message.text}")


def event_row(
    event: Event, language: Language, file: str = "", plc: Collection[str] = ()
) -> LogRow:
    """Return an event as a row, with its line, and its file if that is another."""
    line, of_plc, outside = location_of(event.span, file, plc)
    return LogRow(event.kind, line, event_text(event, language), file=of_plc, outside=outside)


def function_text(entry: Entry) -> str:
    """Return a waiting function as a person names it, such as ``M100`` or ``S M3 500``."""
    if isinstance(entry, SpindleEntry):
        return f"{entry.spindle} M{entry.function} {plain_number(entry.speed)}"
    axis = f" {entry.axis}" if entry.axis else ""
    return f"{entry.letter}{entry.number}{axis}"


# --- stops ------------------------------------------------------------------------------------


def stop_for(file: str, line: int, text: str) -> str:
    """Return the stop that a person means by a line: its branch fires, or its block comes up."""
    word = "fires" if is_condition(text) else "line"
    return f"{word} {file}:{line}"


def stop_lines(stops: Sequence[str], file: str) -> list[int]:
    """Return the lines of a file that have a stop."""
    found = []
    for text in stops:
        match = re.match(r"(?:line|fires|runs|turns) (?:(.*):)?(\d+)\b", text, re.IGNORECASE)
        if match is not None and (match[1] is None or names_file(match[1], file)):
            found.append(int(match[2]))
    return found


# --- variables ----------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class VariableRow:
    """A V.E variable: its field is a switch, a whole number or a number.

    ``low`` and ``high``: the range of its slider. ``is_named``: the program names it.
    """

    name: str
    field: str
    low: float
    high: float
    is_named: bool


#: Ranges of sliders by type; others go to 100.
_RANGES = {"SGN08": (-128, 127), "UNS08": (0, 255)}


def variable_rows(types: Sequence[tuple[str, str]], lines: Sequence[str]) -> list[VariableRow]:
    """Return the V.E variables with their fields: first those that the program names."""
    named = variables_named(lines)
    rows = [
        VariableRow(name, _field(kind), *_RANGES.get(kind, (0, 100)), name.upper() in named)
        for name, kind in types
        if name.startswith("V.E.") and kind not in ("STRING", "VSTRING")
    ]
    return sorted(rows[:MAX_VARIABLES], key=lambda row: not row.is_named)


def _field(kind: str) -> str:
    if kind == "BOOLEAN":
        return "switch"
    return "number" if kind.startswith("REAL") else "integer"


# --- readings -----------------------------------------------------------------------------------


def readings(
    snapshot: Snapshot, axes: Sequence[str], prefix: str, cycle_time_us: int, texts: Texts
) -> dict[str, str]:
    """Return the texts of a tick, by the names of their places on the page."""
    values = snapshot.values
    found = {
        "clock": " · ".join(_clock(snapshot, cycle_time_us, texts)),
        "path-speed": f"{float(values.get(f'{prefix}PATH.SPEED', 0.0)) * 60:.0f}",
        "percent": f"{float(values.get(f'{prefix}HLI.OVERRIDE', 100.0)):.0f} %",
    }
    for axis in axes:
        found[f"axis-{axis}"] = f"{float(values[f'{prefix}{axis}.ACS.ACT_POS']):.3f}"
        found[f"rest-{axis}"] = f"{float(values.get(f'{prefix}{axis}.PCS.DIST_TO_GO', 0.0)):.3f}"
    return found


def _clock(snapshot: Snapshot, cycle_time_us: int, texts: Texts) -> list[str]:
    """Return the tick that is shown, its time and the branch."""
    tick = snapshot.shown_tick
    branch = f"{texts['branch']} {snapshot.branch}"
    late = [texts["late"].format(count=snapshot.late)] if snapshot.late else []
    if tick < 0:
        return [texts["before_first"], branch, *late]
    return [
        f"{texts['tick_number']} {tick}",
        f"{tick * cycle_time_us / 1000:.3f} ms",
        branch,
        *late,
    ]
