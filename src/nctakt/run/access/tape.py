# SPDX-License-Identifier: MIT
"""A tape: all inputs of a run from outside, in a file, and read back.

In: the words of the run, its inputs, its events. Out: JSON lines. The first line says how the run
was started; then come the inputs (``tape_lines.py``), and between them each tick with events has a
line with a checksum of them; the last line says how the run ended, and has the digests of the files
that it was made of.
"""

from __future__ import annotations

import hashlib
import json
import stat
import zlib
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, TypeGuard

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Span
from nctakt.base.failure import Failure
from nctakt.base.text import decode_text
from nctakt.base.version import __version__
from nctakt.files.access import FileAccess
from nctakt.messages import diagnostic
from nctakt.messages.commands.tape import (
    INVALID_TAPE,
    TAPE_CUT_OFF,
    TAPE_NAMES_OUTSIDE,
    TAPE_OF_OTHER_VERSION,
)
from nctakt.results.trace.events import Event
from nctakt.results.trace.sinks import TraceHeader
from nctakt.results.trace.texts import by_tick, join_events
from nctakt.run.access.inputs import Input
from nctakt.run.access.tape_lines import InputLines, inputs_of, to_json

#: The version of the format; no other is read.
VERSION = 1

#: The first characters of each tape.
_BEGIN = '{"tape":'

#: Prefix of the files of built-in machines on a tape.
_OWN_MARK = "nctakt:"
_OWN_FOLDER = Path(__file__).parents[2]

#: Bytes of a file that are read at a time.
_CHUNK_BYTES = 1 << 20

#: Head, end, and the empty rest after the last line end.
_MIN_LINES = 3


@dataclass(frozen=True, slots=True)
class Tape:
    """A recorded run.

    ``words`` are those of the command that started it, ``texts`` its programs that are not files,
    by name. ``checksums``: tick -> that of its events. ``ticks`` and ``state``: how it ended.
    ``digests``: file -> as ``digest_of`` gives it. ``lists``: the texts of lists that differed from
    their files, by the names of these. ``has_checksums``: false for one that grew until its process
    was ended (``session/growing_tape.py``).
    """

    words: Mapping[str, Any]
    texts: Mapping[str, str]
    has_plc: bool
    inputs: tuple[Input, ...]
    checksums: Mapping[int, int]
    ticks: int
    state: str
    digests: Mapping[str, str | None]
    lists: Mapping[str, str] = field(default_factory=dict)
    has_checksums: bool = True


def digest_of(path: Path) -> str | None:
    """Return the SHA-256 of a regular file in hexadecimal digits, and its size in bytes.

    ``None`` if it cannot be read, or is not a regular file: reading a device may never end.
    """
    size = _size_of(path)
    if size is None:
        return None
    digest, left = hashlib.sha256(), size
    try:
        with path.open("rb") as file:
            while left and (data := file.read(min(left, _CHUNK_BYTES))):
                digest.update(data)
                left -= len(data)
    except OSError:
        return None
    return f"{digest.hexdigest()} {size}"


def _size_of(path: Path) -> int | None:
    """Return the size of a regular file; ``None`` for anything else."""
    try:
        state = path.stat()
    except OSError:
        return None
    return state.st_size if stat.S_ISREG(state.st_mode) else None


def name_on_tape(path: Path) -> str:
    """Return the name of a file on a tape: those of built-in machines are found anywhere."""
    absolute = path.absolute()
    if absolute.is_relative_to(_OWN_FOLDER):
        return f"{_OWN_MARK}{absolute.relative_to(_OWN_FOLDER).as_posix()}"
    return path.as_posix()


def path_of(name: str) -> Path:
    """Return the path of a file by its name on a tape."""
    if name.startswith(_OWN_MARK):
        return _OWN_FOLDER / name.removeprefix(_OWN_MARK)
    return Path(name)


def changed_files(tape: Tape, access: FileAccess) -> list[str]:
    """Return the files of a tape that have changed since it was recorded.

    Raises ``Failure`` (902024) if it names files that ``access`` does not admit: then none is
    opened. A file of another size than the tape states is not read.
    """
    outside = [name for name in (*tape.digests, *tape.lists) if not access.admits(path_of(name))]
    if outside:
        found = diagnostic(
            TAPE_NAMES_OUTSIDE, files=", ".join(outside), folders=access.shown_folders
        )
        raise Failure(found)
    return [name for name, digest in tape.digests.items() if _is_changed(path_of(name), digest)]


def _is_changed(path: Path, digest: str | None) -> bool:
    if digest is None:
        return _size_of(path) is not None
    content, _, size = digest.partition(" ")
    if size and str(_size_of(path)) != size:
        return True
    found = digest_of(path)
    return found is None or found.partition(" ")[0] != content


def checksum(events: Sequence[Event]) -> int:
    """Return the checksum of the events of a tick."""
    return zlib.crc32(join_events(events).encode("utf-8"))


class TapeWriter:
    """Writes a tape line by line: ``note`` takes inputs, as a sink it takes events."""

    def __init__(
        self,
        write: Callable[[str], Any],
        words: Mapping[str, Any],
        texts: Mapping[str, str],
        has_plc: bool,
        lists: Mapping[str, str] | None = None,
        *,
        has_checksums: bool = True,
    ) -> None:
        self._write = write
        self._inputs = InputLines(write)
        self.note = self._inputs.note
        self._line(
            {
                "tape": VERSION,
                "nctakt": __version__,
                "words": words,
                "texts": texts,
                "has_plc": has_plc,
                **({"lists": lists} if lists else {}),
                **({} if has_checksums else {"checksums": False}),
            }
        )

    def _line(self, value: Mapping[str, Any]) -> None:
        self._write(to_json(value) + "\n")

    def open(self, header: TraceHeader) -> None:
        """Do nothing: the first line has been written."""

    def events(self, events: Sequence[Event]) -> None:
        """Write the checksum of each tick with events."""
        for tick, together in by_tick(list(events)):
            self._line({"tick": tick, "events": checksum(together)})

    def close(self) -> None:
        """Write the inputs that are left; ``finish`` writes the last line."""
        self._inputs.flush()

    def finish(self, state: str, ticks: int, files: Mapping[str, Path]) -> None:
        """Write the last line; ``files``: programs and lists by their names on the tape."""
        self.end(state, ticks, {name: digest_of(path) for name, path in files.items()})

    def end(self, state: str, ticks: int, digests: Mapping[str, str | None]) -> None:
        """Write a last line; if there are several, the last counts."""
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


def _are_digests(value: object) -> TypeGuard[dict[str, str | None]]:
    return isinstance(value, dict) and all(isinstance(one, str | None) for one in value.values())


def _has_zero(value: object) -> bool:
    """Return whether a text in a value of JSON has the character 0, which no name has."""
    if isinstance(value, str):
        return "\0" in value
    if isinstance(value, dict):
        return any(map(_has_zero, (*value, *value.values())))
    return isinstance(value, list) and any(map(_has_zero, value))


def _is_texts(value: object) -> bool:
    return isinstance(value, dict) and all(isinstance(one, str) for one in value.values())


class _Reader:
    """Reads the lines of one tape; raises ``Failure`` with the place of a mistake."""

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
        is_whole = isinstance(head.get("words"), dict) and isinstance(head.get("has_plc"), bool)
        has_texts = _is_texts(head.get("texts")) and _is_texts(head.get("lists", {}))
        if not is_whole or not has_texts:
            raise self._invalid(1, "words, texts or has_plc is missing")
        return head

    def add(self, number: int, inputs: list[Input], checksums: dict[int, int]) -> None:
        """Add the content of a line between the first and the last."""
        entry = self._object(number)
        if "end" in entry:
            return
        tick, events = entry.get("tick"), entry.get("events")
        if isinstance(events, int) and type(tick) is int and tick >= 0:
            checksums[tick] = events
            return
        found = inputs_of(entry)
        if isinstance(found, str):
            raise self._invalid(number, found)
        if inputs and found and inputs[-1].tick > found[0].tick:
            raise self._invalid(number, "ticks that go back")
        inputs += found

    def tape(
        self, head: Mapping[str, Any], inputs: Sequence[Input], checksums: Mapping[int, int]
    ) -> Tape:
        end = self._object(len(self._lines) - 1)
        if "end" not in end:
            self.cut_off()
        ticks, digests = end.get("ticks"), end.get("files")
        if not isinstance(ticks, int) or not _are_digests(digests):
            raise self._invalid(len(self._lines) - 1, "ticks or files is missing")
        names = (head["words"], list(head["texts"]), list(head.get("lists", {})), list(digests))
        if any(map(_has_zero, names)):
            raise self._invalid(1, "a name with the character 0")
        return Tape(
            head["words"],
            head["texts"],
            head["has_plc"],
            tuple(inputs),
            checksums,
            ticks,
            str(end["end"]),
            digests,
            head.get("lists", {}),
            head.get("checksums") is not False,
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
