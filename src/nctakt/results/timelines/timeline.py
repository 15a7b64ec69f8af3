# SPDX-License-Identifier: MIT
"""A run over time as data: tracks of slices in microseconds.

Built by ``timeline_events.py`` and ``timeline_branches.py``, drawn by the pictures and written by
the traces for other viewers. Tick n begins at n times the cycle time; a state of one tick lasts
until the next begins.
"""

from __future__ import annotations

from typing import Literal, get_args

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span, Text

#: The kinds of tracks, in the order in which they are shown.
TrackKind = Literal[
    "program",
    "channel",
    "block",
    "wait",
    "cycle",
    "condition",
    "reaction",
    "function",
    "axis",
    "spindle",
    "message",
    "error",
    "starved",
    "overflow",
    "paused",
    "end",
]
KINDS: tuple[TrackKind, ...] = get_args(TrackKind)


@dataclass(frozen=True, slots=True)
class Slice:
    """Something that lasts from ``begin_us`` to ``end_us``; a moment has both the same.

    ``span``: where in the program it comes from. ``text``: its source line or a value.
    ``is_open``: it had not ended when the run was over.
    """

    begin_us: int
    end_us: int
    name: str
    span: Span | None = None
    text: str = ""
    is_open: bool = False

    @property
    def is_moment(self) -> bool:
        """Whether it has no length."""
        return self.begin_us == self.end_us


@dataclass(frozen=True, slots=True)
class Track:
    """The slices of one subject, ordered by start; ``group``: the cycle of a reaction.

    ``text``: the source line of a condition or reaction. ``left_out``: older slices that were not
    kept. ``why_not``: why a condition was never true or a reaction never ran, which then has no
    slices. ``known``: when a condition was evaluated, and since when it is kept whether a body
    ran, in microseconds. Only slices of channels, of functions and of moments may overlap.
    """

    kind: TrackKind
    label: str
    slices: tuple[Slice, ...]
    group: str = ""
    span: Span | None = None
    text: str = ""
    left_out: int = 0
    why_not: Text = Text("", "")
    known: tuple[tuple[int, int], ...] = ()


@dataclass(frozen=True, slots=True)
class TakenSignal:
    """A signal from the channel ``sender`` to the channel ``receiver``, by the labels of their
    tracks.
    """

    name: str
    sender: str
    sent_us: int
    receiver: str
    taken_us: int


@dataclass(frozen=True, slots=True)
class Timeline:
    """The tracks of a run from ``begin_us`` to ``end_us``, by kind, then in order of appearance.

    ``signals``: those that were taken.
    """

    begin_us: int
    end_us: int
    cycle_time_us: int
    tracks: tuple[Track, ...]
    signals: tuple[TakenSignal, ...] = ()

    def of(self, *kinds: TrackKind) -> list[Track]:
        """Return the tracks of these kinds."""
        return [track for track in self.tracks if track.kind in kinds]


def rows_of(track: Track) -> list[list[Slice]]:
    """Return the slices of a track in as few rows as keep those of a row apart."""
    rows: list[list[Slice]] = []
    for item in track.slices:
        row = next((row for row in rows if row[-1].end_us <= item.begin_us), None)
        if row is None:
            rows.append([item])
        else:
            row.append(item)
    return rows
