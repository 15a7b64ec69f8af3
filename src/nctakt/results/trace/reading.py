# SPDX-License-Identifier: MIT
"""Files that the trace sinks wrote -> ``Trace``.

In: a CSV or JSONL file as ``sinks.py`` writes it. Out: the same signals and events. A last line
that is cut off, since its run was, is left out. A CSV file has no units, and its cycle time is the
time between its first two lines.
"""

from __future__ import annotations

import array
import csv
import json
import math
import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from nctakt.base.diagnostics import Span
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.files import FILE_NOT_READABLE, NOT_A_TRACE, UNKNOWN_TRACE_FORMAT
from nctakt.results.trace.events import Event
from nctakt.results.trace.recorded import Trace
from nctakt.results.trace.sinks import FORMAT_NAME, FORMAT_VERSION, SUFFIXES, Signal, TraceHeader

_ORIGIN = re.compile(r"(?s)(?P<cycle>\S+) (?P<place>.+)")
_POSITION = re.compile(r"(?s)(?P<file>.+):(?P<line>\d+):(?P<column>\d+)")
_CHANNEL = re.compile(r"CH(\d+) ")
_UNMARKED = {"n": "\n", "r": "\r"}


def read_trace(path: str | Path) -> Trace:
    """Read a trace file in the format of its suffix and return the trace.

    Raises ``Failure`` for another suffix (900506), a file that cannot be read (900503) and a file
    that is not a trace (900508).
    """
    path = Path(path)
    if path.suffix.lower() not in SUFFIXES:
        raise Failure(
            diagnostic(UNKNOWN_TRACE_FORMAT, file=str(path), suffixes=" or ".join(SUFFIXES))
        )
    read = _read_csv if path.suffix.lower() == ".csv" else _read_jsonl
    try:
        with path.open(encoding="utf-8", newline="") as file:
            return read(_whole_lines(file))
    except OSError as error:
        reason = error.strerror or str(error)
        raise Failure(diagnostic(FILE_NOT_READABLE, file=str(path), reason=reason)) from error
    except (ValueError, KeyError, TypeError, IndexError) as error:
        raise Failure(diagnostic(NOT_A_TRACE, file=str(path))) from error


def _whole_lines(lines: Iterable[str]) -> Iterator[str]:
    """Yield the lines that are complete."""
    return (line for line in lines if line.endswith("\n"))


class _Rows:
    """Gathers rows of consecutive ticks and events."""

    def __init__(self) -> None:
        self.values = array.array("d")
        self.events: list[Event] = []
        self.first_tick: int | None = None

    def add(self, tick: int, values: list[float]) -> None:
        if self.first_tick is None:
            self.first_tick = tick
        self.values.extend(values)

    def trace(self, cycle_time_us: int, signals: tuple[Signal, ...]) -> Trace:
        header = TraceHeader(cycle_time_us, signals)
        chunks = (self.values.tobytes(),) if self.values else ()
        return Trace(header, self.first_tick or 0, chunks, (self.events,))


def _read_csv(lines: Iterator[str]) -> Trace:
    rows = csv.reader(lines)
    names = next(rows, [])
    if names[:2] != ["tick", "time_us"] or names[-1:] != ["events"]:
        raise ValueError
    gathered = _Rows()
    integral = [True] * (len(names) - 3)
    times: list[int] = []
    for row in rows:
        tick, time_us, cells = int(row[0]), int(row[1]), row[2:-1]
        if len(row) != len(names):
            raise ValueError
        if len(times) < 2:
            times.append(time_us)
        if any(cells):
            gathered.add(tick, [float(cell) for cell in cells])
            integral = [
                whole and _is_whole(cell) for whole, cell in zip(integral, cells, strict=True)
            ]
        gathered.events += split_events(row[-1], tick, time_us)
    signals = zip(names[2:-1], integral, strict=True)
    cycle_time_us = times[1] - times[0] if len(times) == 2 else 0
    return gathered.trace(
        cycle_time_us, tuple(Signal(name, integral=whole) for name, whole in signals)
    )


def _is_whole(cell: str) -> bool:
    return cell.lstrip("-").isdigit()


def _read_jsonl(lines: Iterator[str]) -> Trace:
    header = json.loads(next(lines, "null"))
    if header["format"] != FORMAT_NAME or header["version"] != FORMAT_VERSION:
        raise ValueError
    signals = tuple(
        Signal(signal["name"], signal["unit"], signal["integral"]) for signal in header["signals"]
    )
    gathered = _Rows()
    for line in lines:
        content = json.loads(line)
        if "values" in content:
            values = [math.nan if value is None else float(value) for value in content["values"]]
            if len(values) != len(signals):
                raise ValueError
            gathered.add(content["tick"], values)
        for event in content.get("events", ()):
            gathered.events.append(_event_of(event, content["tick"], content["time_us"]))
    return gathered.trace(header["cycle_time_us"], signals)


def _event_of(content: dict[str, Any], tick: int, time_us: int) -> Event:
    span = None
    if "file" in content:
        span = Span(content["file"], content["line"], content["column"], content["end_column"])
    kind, text = content["kind"], content["text"]
    return Event(
        tick, time_us, kind, text, span, content.get("cycle", ""), content.get("channel", 0)
    )


def split_events(cell: str, tick: int, time_us: int) -> list[Event]:
    """Return the events of a tick from the last column of a CSV line, as by ``join_events``."""
    return [_event(text, tick, time_us) for text in _divide(cell, "; ") if text]


def _event(text: str, tick: int, time_us: int) -> Event:
    body, *origin = _divide(text, " <")
    channel = _CHANNEL.match(body)
    if channel is not None:
        body = body[channel.end() :]
    kind, _, particulars = body.partition(" ")
    cycle, span = _origin(origin[0].removesuffix(">")) if origin else ("", None)
    number = 0 if channel is None else int(channel[1])
    return Event(tick, time_us, kind, _unescape(particulars), span, cycle, number)


def _origin(text: str) -> tuple[str, Span | None]:
    match = _ORIGIN.fullmatch(text)
    if match is None:
        raise ValueError
    cycle = "" if match["cycle"] == "-" else _unescape(match["cycle"])
    position = _POSITION.fullmatch(match["place"])
    if position is None:
        return cycle, None
    line, column = int(position["line"]), int(position["column"])
    return cycle, Span(_unescape(position["file"]), line, column, column + 1)


def _divide(text: str, divider: str) -> list[str]:
    r"""Split at each ``divider``; a character after a ``\`` is never part of one."""
    if "\\" not in text:  # nearly always, and much faster
        return text.split(divider)
    parts = [""]
    i = 0
    while i < len(text):
        if text[i] == "\\":
            parts[-1] += text[i : i + 2]
            i += 2
        elif text.startswith(divider, i):
            parts.append("")
            i += len(divider)
        else:
            parts[-1] += text[i]
            i += 1
    return parts


def _unescape(text: str) -> str:
    if "\\" not in text:
        return text
    return re.sub(r"(?s)\\(.)", lambda match: _UNMARKED.get(match[1], match[1]), text)
