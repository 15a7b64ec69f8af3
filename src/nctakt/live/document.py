# SPDX-License-Identifier: MIT
"""The program that the page shows: read, checked while it is written, saved.

In: the file named at the start, and no other; texts of the editor. Out: lines, findings. A file
that has changed on disk meanwhile is never written over.
"""

from __future__ import annotations

import math
import os
import tempfile
import threading
from collections.abc import Sequence
from pathlib import Path

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.base.text import decode_text, encode_text, split_lines
from nctakt.checking.check import check_files
from nctakt.editor.token_colours import synchronous_names
from nctakt.files.access import FileAccess
from nctakt.lists.machine.machine import load_machine
from nctakt.messages import diagnostic
from nctakt.messages.connections.live import PROGRAM_CHANGED_ON_DISK
from nctakt.messages.files import FILE_NOT_WRITABLE
from nctakt.run.program_loader import NcText
from nctakt.run.realtime.assembly import AssembledMachine

#: Maximum lines and characters of a program edited on the page; a longer one is only shown.
MAX_EDITED_LINES, MAX_EDITED_CHARACTERS = 20_000, 1_000_000


class Checker:
    """The machine that programs are checked with; raises ``Failure`` where it cannot be read.

    ``types``: name -> type of the machine's variables. ``limits``: axis -> software limits.
    ``synchronous``: variables that realtime cycles read and write in each tick. ``transformed``:
    numbers of the channels with kinematic transformations. ``machine``: its data for check,
    completion and explanations.
    """

    def __init__(self, machine: str | None, folders: Sequence[str | Path]) -> None:
        access = FileAccess(folders)
        self.machine = AssembledMachine(
            load_machine(machine, access=access), access, has_history=False
        )
        names = self.machine.assembled[0].names
        self.synchronous = synchronous_names(names)
        self.types = [(name, kind) for name, _, kind in names.values()]
        channels = self.machine.configuration.channels
        self.transformed = frozenset(
            number
            for number, channel in enumerate(channels, 1)
            if any(channel.parameters.transformations.steps)
        )
        axes = self.machine.configuration.axes
        self.limits = {
            axis.name: [
                one if math.isfinite(one) else None
                for one in (axis.software_limit_low, axis.software_limit_high)
            ]
            for axis in axes
        }

    def check(self, file: str, text: str) -> list[Diagnostic]:
        """Return the findings of the check for a text, with its notes."""
        result = check_files([NcText(file, text)], self.machine)
        return [found.diagnostic for found in result.findings]


class Document:
    """A program in a file; raises ``Failure`` where it cannot be read.

    ``text`` and ``lines``: as last read or saved.
    """

    def __init__(self, file: str, checker: Checker) -> None:
        self.file = file
        self.checker = checker
        self._content = b""
        self._seen: tuple[int, int] | None = None
        self._other: tuple[int, int] | None = None
        self.text = ""
        self.lines: list[str] = []
        self._checked: tuple[str, list[Diagnostic]] | None = None
        self._checking = threading.Lock()
        self.read()

    def read(self) -> None:
        """Read the file."""
        self._seen = self._other = None
        self._content = FileAccess().read_bytes(Path(self.file))
        self._set("\n".join(split_lines(decode_text(self._content).text)))

    def _set(self, text: str) -> None:
        self.text, self.lines = text, text.split("\n")

    @property
    def is_long(self) -> bool:
        """Whether it is shown only: its lines come by request, and it is edited elsewhere."""
        return len(self.lines) > MAX_EDITED_LINES or len(self.text) > MAX_EDITED_CHARACTERS

    @property
    def is_replaced(self) -> bool:
        """Whether the file on disk differs from the one read, or is gone."""
        path = Path(self.file)
        try:
            status = path.stat()
            seen = status.st_mtime_ns, status.st_size
            if seen in (self._seen, self._other):  # it has not changed since it was compared
                return seen == self._other
            is_other = path.read_bytes() != self._content
        except OSError:
            return True
        if is_other:
            self._other = seen
        else:
            self._seen = seen
        return is_other

    @property
    def is_gone(self) -> bool:
        """Whether the file is not there."""
        return not Path(self.file).exists()

    def check(self, text: str) -> list[Diagnostic]:
        """Return the findings of the check for a text of the editor, with its notes.

        The text that was read is checked once for all browsers.
        """
        if text is not self.text:
            return self.checker.check(self.file, text)
        with self._checking:
            known = self._checked
            if known is None or known[0] is not text:
                self._checked = known = text, self.checker.check(self.file, text)
        return known[1]

    def save(self, text: str, begin: str) -> None:
        """Write the editor's text, which was ``begin`` before it was changed.

        Line ends and encoding are kept. Raises ``Failure`` if the file has changed since, also by
        another browser, or cannot be written.
        """
        path = Path(self.file)
        if begin != self.text or FileAccess().read_bytes(path) != self._content:
            raise Failure(diagnostic(PROGRAM_CHANGED_ON_DISK, file=self.file))
        end = "\r\n" if b"\r\n" in self._content else "\n"
        lines = text.split("\n")
        content = encode_text("".join(line + end for line in lines), self._content)
        try:
            replace_file(path, content)
        except OSError as error:
            reason = error.strerror or str(error)
            raise Failure(diagnostic(FILE_NOT_WRITABLE, file=self.file, reason=reason)) from error
        self._content, self._seen, self._other = content, None, None
        self._set(text)


def replace_file(path: Path, content: bytes) -> None:
    """Write a file in one step: readers see the old content or the new."""
    target = path.resolve()
    number, name = tempfile.mkstemp(prefix=f".{target.name}.", dir=target.parent)
    try:
        with os.fdopen(number, "wb") as file:
            file.write(content)
        Path(name).chmod(target.stat().st_mode & 0o7777)
        Path(name).replace(target)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise
