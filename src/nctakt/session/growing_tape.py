# SPDX-License-Identifier: MIT
"""A tape that grows with its session: it survives the end of the process, however that ends.

In: a session, how it was started. Out: ``run.growing.tape`` next to ``run.access.tape``. On every
update the inputs since the last one and a new last line replace the old last line: so the file is a
complete tape at any time, only without checksums of its events. An existing file, left by an
earlier process, is kept: then it is ``run.growing-2.tape`` …
"""

from __future__ import annotations

import contextlib
import errno
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import IO

from nctakt.run.access.inputs import SELECT, pack
from nctakt.run.access.tape import TapeWriter, digest_of, name_on_tape
from nctakt.run.program_loader import NcText
from nctakt.session.session import Session
from nctakt.session.setup import Setup
from nctakt.session.tapes import has_called_plc, programs_of, words_of_setup

#: Files of earlier processes that may be there at most.
_MAX_LEFT = 1000

#: How a tape ends that grows.
_STATE = "interrupted"


class GrowingTape:
    """The growing tape of a session, ``path`` next to that of the complete one.

    ``files``: programs and lists by their names on a tape. Raises ``OSError``.
    """

    def __init__(
        self, whole: str | Path, session: Session, setup: Setup, files: Mapping[str, Path]
    ) -> None:
        self.path = _new_file(Path(whole), "growing")
        self._session = session
        self._setup = setup
        self._digests = {name: digest_of(path) for name, path in files.items()}
        self._file: IO[bytes] | None = None
        self._branch = self._tick = self._end = 0
        try:
            self.look()
        except OSError:
            self.path.unlink()
            raise

    def look(self) -> None:
        """Append the inputs since the last update.

        Raises ``OSError``, then the next look starts the file again, and ``Failure`` once the
        session is closed.
        """
        first = 0 if self._file is None else self._tick
        branch, tick, inputs = self._session.news(first)
        if branch != self._branch and first:
            branch, tick, inputs = self._session.news(0)
            self._give_up()
        elif self._file is not None and tick == self._tick:
            return
        for one in inputs:
            if one.kind == SELECT:
                path = Path(str(one.values[1]))
                name = name_on_tape(path)
                if name not in self._digests:
                    self._digests[name] = digest_of(path)
        try:
            self._append([] if not inputs else pack(inputs), tick)
        except OSError:
            self._give_up()
            raise
        self._branch, self._tick = branch, tick

    def _append(self, cells: list[object], tick: int) -> None:
        """Write inputs and an end; a new file gets its name when it has both."""
        lines: list[str] = []
        setup = self._setup
        texts = {one.name: one.text for one in programs_of(setup) if isinstance(one, NcText)}
        has_plc = has_called_plc(setup)
        writer = TapeWriter(
            lines.append, words_of_setup(setup), texts, has_plc, has_checksums=False
        )
        writer.note(cells)
        writer.close()
        writer.end(_STATE, tick, self._digests)
        if self._file is not None:
            self._file.seek(self._end)
            self._write(self._file, lines[1:])
            return
        begun = _new_file(self.path, "new")
        file = begun.open("r+b", buffering=0)
        try:
            self._write(file, lines)
            begun.replace(self.path)
        except BaseException:
            file.close()
            begun.unlink(missing_ok=True)
            raise
        self._file = file

    def _write(self, file: IO[bytes], lines: Sequence[str]) -> None:
        """Write lines, with one call if the system takes them whole; the last one is the end."""
        rest = memoryview("".join(lines).encode("utf-8", errors="backslashreplace"))
        while rest:
            rest = rest[file.write(rest) :]
        self._end = file.tell() - len(lines[-1].encode("utf-8", errors="backslashreplace"))

    def _give_up(self) -> None:
        """Start again with the next look."""
        if self._file is not None:
            self._file.close()
            self._file = None

    def close(self) -> None:
        """Remove it: there is a complete tape now."""
        self._give_up()
        self.path.unlink(missing_ok=True)


def _new_file(path: Path, word: str) -> Path:
    """Return a new file next to another, with an unused name; raises ``OSError``."""
    for mark in (word, *(f"{word}-{number}" for number in range(2, _MAX_LEFT))):
        found = path.with_name(f"{path.stem}.{mark}{path.suffix}")
        with contextlib.suppress(FileExistsError):
            found.touch(exist_ok=False)
            return found
    raise FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST))
