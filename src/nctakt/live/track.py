# SPDX-License-Identifier: MIT
"""The drawn data of a session: it grows by increments, and each browser gets the new part.

In: rows of signals, marks, blocks, in the order of their ticks. Out: for each browser the part it
has not seen yet, or everything after a change of the selection.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Iterable, Sequence
from itertools import islice
from typing import Any

from nctakt.base.dataclass import dataclass
from nctakt.live.conditions import Condition
from nctakt.results.trace.events import Event

#: Entries that are kept: of rows, of marks, of blocks, of samples of the lanes.
MAX_ROWS, MAX_MARKS, MAX_BLOCKS, MAX_SAMPLES = 3000, 2000, 20_000, 5000

#: An entry: a tick, and what belongs to it.
Entry = tuple[Any, ...]

#: The part of a list that a browser has seen: edition and number of entries.
Seen = tuple[int, int]


class Growing:
    """A list that grows at its end; at most ``limit`` entries are kept."""

    def __init__(self, limit: int) -> None:
        self._entries: deque[Entry] = deque(maxlen=limit)
        self._edition = 1
        self._count = 0
        self._lock = threading.Lock()

    def __len__(self) -> int:
        return len(self._entries)

    def entries(self) -> list[Entry]:
        """Return the kept entries."""
        with self._lock:
            return list(self._entries)

    def newest(self, count: int = 1) -> list[Entry]:
        """Return the newest entries, the last one first."""
        with self._lock:
            return list(islice(reversed(self._entries), count))

    def add(self, entries: Iterable[Entry]) -> None:
        """Add entries at the end."""
        with self._lock:
            for entry in entries:
                self._entries.append(entry)
                self._count += 1

    def replace(self, entries: Iterable[Entry]) -> None:
        """Replace all entries by these."""
        with self._lock:
            self._entries.clear()
            self._entries.extend(entries)
            self._count = len(self._entries)
            self._edition += 1

    def cut(self, tick: int) -> None:
        """Forget the entries from a tick on."""
        kept = [entry for entry in self.entries() if entry[0] < tick]
        if len(kept) < len(self._entries):
            self.replace(kept)

    def news(self, seen: Seen) -> tuple[dict[str, Any] | None, Seen]:
        """Return the unseen part after ``seen``, ``None`` for nothing; and the new state.

        ``whole``: the entries take the place of those seen.
        """
        with self._lock:
            now = (self._edition, self._count)
            if seen == now:
                return None, now
            is_whole = seen[0] != self._edition
            missing = self._count - (0 if is_whole else seen[1])
            first = max(0, len(self._entries) - missing)
            return {"whole": is_whole, "added": list(islice(self._entries, first, None))}, now


@dataclass(frozen=True, slots=True)
class Shown:
    """The names of the columns of the rows, with their units; the last ``hidden`` are the path's.

    ``conditions``: those of the lanes, whose samples are separate from the rows.
    """

    conditions: tuple[Condition, ...] = ()
    signals: tuple[str, ...] = ()
    units: tuple[str, ...] = ()
    hidden: int = 0


class Track:
    """The curves, marks, blocks and sampled lanes of a branch; ``parts``: by their names."""

    def __init__(self) -> None:
        self.shown = Shown()
        self._branch = 1
        self.rows = Growing(MAX_ROWS)
        self.marks = Growing(MAX_MARKS)
        self.blocks = Growing(MAX_BLOCKS)
        self.lanes = Growing(MAX_SAMPLES)
        self.parts = {
            "rows": self.rows, "marks": self.marks, "blocks": self.blocks, "lanes": self.lanes
        }  # fmt: skip

    def show(self, shown: Shown) -> None:
        """Show these columns from now on; the rows of others are forgotten."""
        if shown != self.shown:
            if shown.conditions != self.shown.conditions:
                self.lanes.replace(())
            self.shown = shown
            self.rows.replace(())

    def clear(self, branch: int | None = None) -> None:
        """Forget all; ``branch``: that of another session."""
        self._branch = self._branch if branch is None else branch
        for part in self.parts.values():
            part.replace(())

    def turn_to(self, branch: int, fork: Callable[[int, int], int]) -> bool:
        """Switch to a branch, and forget everything that the previous one does not share with it.

        Return whether the branch has changed. ``fork``: the tick before which both are the same.
        """
        if branch == self._branch:
            return False
        tick = fork(self._branch, branch)
        self._branch = branch
        for part in self.parts.values():
            part.cut(tick)
        return True

    def note(self, events: Sequence[Event], channel: int, file: str) -> None:
        """Add the marks and blocks of events that are newer than those there."""
        self.marks.add(newer(self.marks, marks_of(events, file)))
        self.blocks.add(newer(self.blocks, blocks_of(events, channel, file)))


def newer(part: Growing, entries: Sequence[Entry]) -> list[Entry]:
    """Return the entries that are newer than all that a list has."""
    known = part.newest(50)
    last = known[0][0] if known else -1
    same = {entry for entry in known if entry[0] == last}
    return [entry for entry in entries if entry[0] >= last and entry not in same]


def marks_of(events: Sequence[Event], file: str) -> list[Entry]:
    """Return reactions, functions, messages and errors.

    Each with tick, kind, label, line in the file; reactions with the number of their channel, too.
    """
    found: list[Entry] = []
    for event in events:
        line_in_text = 0 if event.span is None else event.span.line
        line = line_in_text if event.span is not None and event.span.file == file else 0
        match event.kind:
            case "fired":
                label = f"{event.cycle}:{line_in_text}"
                found.append((event.tick, "fired", label, line, max(event.channel, 1)))
            case "M" | "H":
                found.append((event.tick, event.kind, event.kind + event.text.split()[0], line))
            case "output":
                letter, number = event.text.split()[:2]
                found.append((event.tick, "output", letter + number, line))
            case "message" | "error":
                found.append((event.tick, event.kind, event.text[:24], line))
    return found


def blocks_of(events: Sequence[Event], channel: int, file: str) -> list[Entry]:
    """Return the blocks of a channel that have become current: tick, line in the file or 0."""
    return [
        (event.tick, event.span.line if event.span.file == file else 0)
        for event in events
        if event.kind == "block" and event.span is not None and max(event.channel, 1) == channel
    ]
