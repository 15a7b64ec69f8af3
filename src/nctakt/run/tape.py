# SPDX-License-Identifier: MIT
"""A tape: all inputs of a run from outside, in a file, and read back.

In: the words of the run, its inputs, its events. Out: JSON lines. The first line says how the run
was started; then each tick with inputs has a line, and each tick with events one with a checksum of
them; the last line says how the run ended, and has the digests of the files that it was made of.
"""

from __future__ import annotations

import hashlib
import json
import zlib
from collections.abc import Callable, Mapping, Sequence
from math import isfinite
from pathlib import Path
from typing import Any

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.base.failure import Failure
from nctakt.base.text import decode_text
from nctakt.base.version import __version__
from nctakt.files.access import FileAccess
from nctakt.messages import diagnostic
from nctakt.messages.tape import INVALID_TAPE, TAPE_CUT_OFF, TAPE_OF_OTHER_VERSION
from nctakt.run.inputs import ACKNOWLEDGE, ACKNOWLEDGE_SPINDLE, AXIS, WRITE, Input
from nctakt.trace.events import Event
from nctakt.trace.sinks import TraceHeader
from nctakt.trace.texts import by_tick, join_events

#: The version of the format; no other one is read.
VERSION = 1

#: The first characters of each tape.
_BEGIN = '{"tape":'

#: Head, end, and what stands behind the last line end: nothing.
_MIN_LINES = 3

#: The types of the values of each kind of input.
_SHAPES: Mapping[str, tuple[tuple[type, ...], ...]] = {
    WRITE: ((str,), (float, int, str)),
    ACKNOWLEDGE: ((int,), (bool,), (int,), (int,), (str,)),
    ACKNOWLEDGE_SPINDLE: ((int,), (int,), (int,), (str,)),
    AXIS: ((int,), (int,), (float, int), (float, int), (int,), (int,)),
}


@dataclass(frozen=True, slots=True)
class Tape:
    """A recorded run.

    ``words`` are those of the command that it was started with, ``text`` its program from standard
    input. ``checksums``: tick -> that of its events. ``ticks`` and ``state``: how it ended.
    ``digests``: file -> SHA-256 in hexadecimal digits.
    """

    words: Mapping[str, Any]
    text: str | None
    has_plc: bool
    inputs: tuple[Input, ...]
    checksums: Mapping[int, int]
    ticks: int
    state: str
    digests: Mapping[str, str]


def digest_of(path: Path) -> str | None:
    """Return the SHA-256 of a file in hexadecimal digits; ``None`` if it cannot be read."""
    try:
        with path.open("rb") as file:
            return hashlib.file_digest(file, "sha256").hexdigest()
    except OSError:
        return None


def checksum(events: Sequence[Event]) -> int:
    """Return the checksum of the events of a tick."""
    return zlib.crc32(join_events(events).encode("utf-8"))


def _json(value: object) -> str:
    return json.dumps(value, ensure_ascii=False, separators=(",", ":"))


class TapeWriter:
    """Writes a tape line by line: ``note`` takes inputs, as a sink it takes events."""

    def __init__(
        self, write: Callable[[str], Any], words: Mapping[str, Any], text: str | None, has_plc: bool
    ) -> None:
        self._write = write
        self._tick = -1
        self._inputs: list[str] = []
        self._heads: dict[tuple[str, str], str] = {}
        self._line(
            {
                "tape": VERSION,
                "nctakt": __version__,
                "words": words,
                "text": text,
                "has_plc": has_plc,
            }
        )

    def _line(self, value: Mapping[str, Any]) -> None:
        self._write(_json(value) + "\n")

    def note(self, arrived: Input) -> None:
        """Take an input; those of a tick come together."""
        if arrived.tick != self._tick:
            self._write_inputs()
            self._tick = arrived.tick
        self._inputs.append(self._text_of(arrived))

    def _text_of(self, arrived: Input) -> str:
        """Return an input as JSON; a number for a variable, of which there are many, fast."""
        source, values = arrived.source, arrived.values
        if arrived.kind != WRITE or type(values[1]) is not float or not isfinite(values[1]):
            return _json([source, arrived.kind, *values])
        name = values[0]
        assert isinstance(name, str)
        head = self._heads.get((source, name))
        if head is None:
            head = self._heads[source, name] = _json([source, WRITE, name])[:-1]
        return f"{head},{values[1]!r}]"

    def _write_inputs(self) -> None:
        if self._inputs:
            self._write(f'{{"tick":{self._tick},"inputs":[{",".join(self._inputs)}]}}\n')
            self._inputs.clear()

    def open(self, header: TraceHeader) -> None:
        """Do nothing: the first line has been written."""

    def events(self, events: Sequence[Event]) -> None:
        """Write the checksum of each tick with events."""
        for tick, together in by_tick(list(events)):
            if self._tick <= tick:
                self._write_inputs()
            self._line({"tick": tick, "events": checksum(together)})

    def rows(self, first_tick: int, rows: memoryview[float], width: int) -> None:
        """Ignore the values: they follow from the inputs."""

    def close(self) -> None:
        """Write the inputs that are left; ``finish`` writes the last line."""
        self._write_inputs()

    def finish(self, state: str, ticks: int, files: Mapping[str, Path]) -> None:
        """Write the last line; ``files``: programs and lists by their names on the tape."""
        digests = {name: digest_of(path) for name, path in files.items()}
        self._line({"end": state, "ticks": ticks, "files": digests})


class TapeComparison:
    """Compares the events of a run with the checksums of a tape, as a sink."""

    def __init__(self, tape: Tape) -> None:
        self._expected = dict(tape.checksums)
        self.first: tuple[int, str] | None = None

    def open(self, header: TraceHeader) -> None:
        """Do nothing."""

    def events(self, events: Sequence[Event]) -> None:
        """Compare the events of each tick."""
        for tick, together in by_tick(list(events)):
            if self._expected.pop(tick, None) != checksum(together):
                self._differ(tick, join_events(together))

    def rows(self, first_tick: int, rows: memoryview[float], width: int) -> None:
        """Ignore the values."""

    def close(self) -> None:
        """Note the first tick whose events are missing."""
        if self._expected:
            self._differ(min(self._expected), "–")

    def _differ(self, tick: int, events: str) -> None:
        if self.first is None or tick < self.first[0]:
            self.first = tick, events


def read_tape(path: Path, access: FileAccess) -> Tape:
    """Return the tape of a file.

    Raises ``Failure`` for a file that cannot be read, that is not a tape (901070), that has another
    version (901071) or that is cut off (901072).
    """
    lines = decode_text(access.read_bytes(path)).text.split("\n")
    reader = _Reader(path.as_posix(), lines)
    if len(lines) == 1 and _BEGIN.startswith(lines[0][: len(_BEGIN)]):
        reader.cut_off()
    head = reader.head()
    if lines[-1] or len(lines) < _MIN_LINES:
        reader.cut_off()
    inputs: list[Input] = []
    checksums: dict[int, int] = {}
    for number in range(2, len(lines) - 1):
        reader.add(number, inputs, checksums)
    return reader.tape(head, inputs, checksums)


class _Reader:
    """Reads the lines of one tape; raises ``Failure`` with the place of what is wrong."""

    def __init__(self, name: str, lines: Sequence[str]) -> None:
        self._name = name
        self._lines = lines

    def head(self) -> dict[str, Any]:
        head = self._object(1)
        version = head.get("tape")
        if not isinstance(version, int) or isinstance(version, bool):
            raise self._invalid(1, "no version")
        if version != VERSION:
            writer = str(head.get("nctakt", "–"))
            message = diagnostic(
                TAPE_OF_OTHER_VERSION,
                self._span(1),
                found=version,
                version=VERSION,
                writer=writer,
            )
            raise Failure(message)
        text = head.get("text")
        is_whole = isinstance(head.get("words"), dict) and isinstance(head.get("has_plc"), bool)
        if not is_whole or not isinstance(text, str | None):
            raise self._invalid(1, "words, text or has_plc is missing")
        return head

    def add(self, number: int, inputs: list[Input], checksums: dict[int, int]) -> None:
        """Add what a line between the first and the last one has."""
        entry = self._object(number)
        if "end" in entry:
            return
        tick = entry.get("tick")
        if not isinstance(tick, int) or isinstance(tick, bool) or tick < 0:
            raise self._invalid(number, "no tick")
        if "events" in entry and isinstance(entry["events"], int):
            checksums[tick] = entry["events"]
            return
        arrived = entry.get("inputs")
        if not isinstance(arrived, list):
            raise self._invalid(number, "neither inputs nor events")
        if inputs and inputs[-1].tick > tick:
            raise self._invalid(number, "ticks that go back")
        for one in arrived:
            if not _is_input(one):
                raise self._invalid(number, f"no input: {one}")
            inputs.append(Input(tick, one[0], one[1], tuple(one[2:])))

    def tape(
        self, head: Mapping[str, Any], inputs: Sequence[Input], checksums: Mapping[int, int]
    ) -> Tape:
        end = self._object(len(self._lines) - 1)
        if "end" not in end:
            self.cut_off()
        ticks, digests = end.get("ticks"), end.get("files")
        if not isinstance(ticks, int) or not isinstance(digests, dict):
            raise self._invalid(len(self._lines) - 1, "ticks or files is missing")
        return Tape(
            head["words"],
            head["text"],
            head["has_plc"],
            tuple(inputs),
            checksums,
            ticks,
            str(end["end"]),
            digests,
        )

    def cut_off(self) -> None:
        raise Failure(diagnostic(TAPE_CUT_OFF, self._span(len(self._lines))))

    def _object(self, number: int) -> dict[str, Any]:
        try:
            value = json.loads(self._lines[number - 1])
        except (ValueError, RecursionError) as error:
            raise self._invalid(number, str(error)) from error
        if not isinstance(value, dict):
            raise self._invalid(number, "not an object")
        return value

    def _invalid(self, number: int, reason: str) -> Failure:
        line = self._lines[number - 1]
        return Failure(diagnostic(INVALID_TAPE, self._span(number), line, reason=reason))

    def _span(self, number: int) -> Span:
        return Span(self._name, number, 1, 2)


def _is_input(value: Any) -> bool:
    """Return whether a list of JSON is source, kind and the values of that kind."""
    if not isinstance(value, list) or len(value) < 2 or not isinstance(value[0], str):
        return False
    shape = _SHAPES.get(value[1]) if isinstance(value[1], str) else None
    if shape is None or len(value) != 2 + len(shape):
        return False
    return all(
        isinstance(one, types) and (bool in types or not isinstance(one, bool))
        for one, types in zip(value[2:], shape, strict=True)
    )
