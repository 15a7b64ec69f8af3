# SPDX-License-Identifier: MIT
"""Recordings of an oscilloscope, or of nctakt, as the times in which signals are high.

In: the text of a VCD file, or of a CSV file. Out: ``Recording``; raises ``Failure`` (900641) if it
cannot be read. Times in ns. A CSV file has in its first column the time (``time_us``; also ``_s``,
``_ms``, ``_ns``) and in the others the levels of ``bit1`` to ``bit7``, of which 0.5 and more is
high; or it is the table of events that ``--csv`` writes.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterator
from decimal import Decimal, InvalidOperation
from itertools import pairwise

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Text
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.scheduling.learn import INVALID_RECORDING

Times = list[tuple[int, int]]

_BIT = re.compile(r"bit([1-7])(?!\d)", re.I)
_TIMESCALE = re.compile(r"\s*(1|10|100)\s*(s|ms|us|ns|ps|fs)\s*")
_TIME_COLUMN = re.compile(r"time_(s|ms|us|ns)", re.I)
#: Nanoseconds in a unit.
_UNITS = {
    "s": Decimal(10**9),
    "ms": Decimal(10**6),
    "us": Decimal(1000),
    "ns": Decimal(1),
    "ps": Decimal("1e-3"),
    "fs": Decimal("1e-6"),
}
#: No recording has a greater number.
_GREATEST = Decimal(10**15)
#: The columns of the table of events.
_EVENT_COLUMNS = ["time_us", "event", "thread", "cpu", "job", "value"]


@dataclass(frozen=True, slots=True)
class RecordedJob:
    """A job of which all pieces and the end were recorded; ``length``: its time in ns."""

    thread: str
    length: int


@dataclass(frozen=True, slots=True)
class Recording:
    """The signals recorded from ``begin`` to ``end``.

    ``bits``: when each trace bit is high. ``running``: when each thread has a processor, where the
    recording has it. ``interrupts``: the NC interrupts, where it has them. ``jobs``: whole jobs, of
    a table of events.
    """

    begin: int
    end: int
    bits: dict[int, Times] = field(default_factory=dict)
    running: dict[str, Times] = field(default_factory=dict)
    interrupts: list[int] = field(default_factory=list)
    jobs: list[RecordedJob] = field(default_factory=list)


def read_recording(file: str, text: str) -> Recording:
    """Return the recording in a file; raises ``Failure`` if it cannot be read."""
    if text.lstrip().startswith("$"):
        return _Vcd(file, text).recording()
    return _read_csv(file, text)


def _refuse(file: str, en: str, de: str) -> Failure:
    return Failure(diagnostic(INVALID_RECORDING, file=file, reason=Text(en, de)))


# --- VCD ------------------------------------------------------------------------------------------


class _Vcd:
    """Reads the scalar wires of a VCD file."""

    def __init__(self, file: str, text: str) -> None:
        self._file = file
        self._words = iter(text.split())
        self._unit = _UNITS["ns"]
        #: By identifier: scope and name; when it went high, if it is; when it was.
        self._names: dict[str, tuple[str, str]] = {}
        self._since: dict[str, int] = {}
        self._high: dict[str, Times] = {}
        self._scopes: list[str] = []
        self._times: list[int] = []

    def recording(self) -> Recording:
        """Read the whole file; raises ``Failure`` if it is not a recording."""
        now = 0
        for word in self._words:
            if word.startswith("#"):
                now = self._time(word[1:])
                if self._times and now < self._times[-1]:
                    raise _refuse(self._file, "time runs backwards", "die Zeit läuft rückwärts")
                self._times.append(now)
            elif word in ("$dumpvars", "$dumpall", "$dumpon", "$dumpoff", "$end"):
                continue
            elif word.startswith("$"):
                self._declare(word)
            elif word[0] in "bBrRsS":
                next(self._words, None)  # a value of several bits belongs to no trace bit
            else:
                self._change(word[1:], word[0] == "1", now)
        begin, end = (self._times[0], self._times[-1]) if self._times else (0, 0)
        for identifier, since in self._since.items():
            self._high[identifier].append((since, end))
        return self._result(begin, end)

    def _time(self, text: str) -> int:
        return int(_number(self._file, text) * self._unit)

    def _declare(self, word: str) -> None:
        body = self._until_end()
        if word == "$timescale":
            match = _TIMESCALE.fullmatch("".join(body))
            if match is None:
                raise _refuse(self._file, "$timescale is defective", "$timescale ist fehlerhaft")
            self._unit = int(match[1]) * _UNITS[match[2]]
        elif word == "$scope":
            self._scopes.append(body[-1] if body else "")
        elif word == "$upscope" and self._scopes:
            self._scopes.pop()
        elif word == "$var" and len(body) >= 4 and body[1] == "1":
            self._names[body[2]] = (self._scopes[-1] if self._scopes else "", body[3])
            self._high[body[2]] = []

    def _until_end(self) -> list[str]:
        body: list[str] = []
        for word in self._words:
            if word == "$end":
                return body
            body.append(word)
        raise _refuse(self._file, "$end is missing", "$end fehlt")

    def _change(self, identifier: str, is_high: bool, now: int) -> None:
        if identifier not in self._names:
            return
        since = self._since.get(identifier)
        if is_high and since is None:
            self._since[identifier] = now
        elif not is_high and since is not None:
            self._high[identifier].append((since, now))
            del self._since[identifier]

    def _result(self, begin: int, end: int) -> Recording:
        recording = Recording(begin, end)
        for identifier, (scope, name) in self._names.items():
            times = self._high[identifier]
            if scope == "running":
                recording.running[name] = times
            elif scope == "interrupts" and name == "NC":
                recording.interrupts.extend(start for start, _ in times)
            elif scope not in ("suspended", "overflow") and (match := _BIT.search(name)):
                recording.bits[int(match[1])] = times
        return recording


# --- CSV ------------------------------------------------------------------------------------------


def _read_csv(file: str, text: str) -> Recording:
    try:
        rows = list(csv.reader(io.StringIO(text, newline="")))
    except csv.Error as error:  # a cell of more than 128 KiB
        raise _refuse(
            file, f"it is not a table ({error})", f"sie ist keine Tabelle ({error})"
        ) from error
    if not rows:
        raise _refuse(file, "it is empty", "sie ist leer")
    heads = [head.strip() for head in rows[0]]
    if heads == _EVENT_COLUMNS:
        return _events(file, rows[1:])
    match = _TIME_COLUMN.fullmatch(heads[0]) if heads else None
    columns = {
        int(bit[1]): column for column, head in enumerate(heads) if (bit := _BIT.search(head))
    }
    if match is None or not columns:
        raise _refuse(
            file,
            "the first line does not name time_us and bit1 … bit7",
            "die erste Zeile nennt nicht time_us und bit1 … bit7",
        )
    return _samples(file, rows[1:], _UNITS[match[1].lower()], columns)


def _samples(file: str, rows: list[list[str]], unit: Decimal, columns: dict[int, int]) -> Recording:
    times = [int(time) for time in _numbers(file, rows, 0, unit)]
    if any(after < before for before, after in pairwise(times)):
        raise _refuse(file, "time runs backwards", "die Zeit läuft rückwärts")
    recording = Recording(times[0] if times else 0, times[-1] if times else 0)
    for bit, column in columns.items():
        high: Times = []
        since: int | None = None
        levels = _numbers(file, rows, column, Decimal(1))
        for time, level in zip(times, levels, strict=True):
            if level >= Decimal("0.5") and since is None:
                since = time
            elif level < Decimal("0.5") and since is not None:
                high.append((since, time))
                since = None
        if since is not None:
            high.append((since, recording.end))
        recording.bits[bit] = high
    return recording


def _events(file: str, rows: list[list[str]]) -> Recording:
    """Return the jobs of a table of events: those with an end whose start was recorded, too."""
    whole = [row for row in rows if len(row) == len(_EVENT_COLUMNS)]
    times = [int(time) for time in _numbers(file, whole, 0, _UNITS["us"])]
    lengths: dict[tuple[str, str], Decimal] = {}
    ended: dict[str, int] = {}
    for row in whole:
        _, event, thread, _, job, value = row
        if event == "RUN":
            length = _number(file, value) * _UNITS["us"]
            lengths[thread, job] = lengths.get((thread, job), Decimal(0)) + length
        elif event == "END":
            ended[thread] = ended.get(thread, 0) + 1
    jobs: list[RecordedJob] = []
    counts: dict[str, int] = {}
    for (thread, _), length in lengths.items():
        # Jobs of a thread end in order, so the last ones may be unfinished.
        counts[thread] = counts.get(thread, 0) + 1
        if counts[thread] <= ended.get(thread, 0):
            jobs.append(RecordedJob(thread, int(length)))
    begin, end = (times[0], times[-1]) if times else (0, 0)
    return Recording(begin, end, jobs=jobs)


def _numbers(file: str, rows: list[list[str]], column: int, unit: Decimal) -> Iterator[Decimal]:
    for row in rows:
        if row:
            yield _number(file, row[column] if column < len(row) else "") * unit


def _number(file: str, text: str) -> Decimal:
    try:
        number = Decimal(text.strip())
    except InvalidOperation:
        number = Decimal("NaN")
    if not number.is_finite() or abs(number) > _GREATEST:
        raise _refuse(file, f"'{text}' is not a number", f"'{text}' ist keine Zahl")
    return number
