# SPDX-License-Identifier: MIT
"""Signals and exchanged axes of a run -> a track for each channel: program, waits, signals, axes.

Without any of these there are no tracks.
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.results.timelines.timeline import Slice, TakenSignal, Track
from nctakt.results.trace.events import Event

#: After the name of a channel and in texts of events: it is its decoder that waits.
_DECODER = "decoder"


class ChannelTracks:
    """Gathers the signals of a run that begins at ``begin_us``."""

    def __init__(self, begin_us: int) -> None:
        self._begin_us = begin_us
        self._begun: dict[str, int] = {}
        self._programs: dict[str, list[Slice]] = {}
        self._slices: dict[str, list[Slice]] = {}
        self._waiting: dict[tuple[str, str], Slice] = {}
        self._given: dict[str, tuple[str, int]] = {}
        self.taken: list[TakenSignal] = []

    def signal(self, event: Event, text: str) -> None:
        """Add a signal that was sent, awaited or taken; ``text``: its source line."""
        number, what, *channels = event.text.split()
        label = sender = event.prefix.strip()
        if channels[-1] == _DECODER:
            label = f"{label} {channels.pop()}".strip()
        own = self._slices.setdefault(label, [])
        at_us = event.time_us
        if what == "sent":
            name = f"{number} → {' '.join(channels)}"
            own.append(Slice(at_us, at_us, name, event.span, text))
        elif what == "awaited":
            name = f"{number} ← {' '.join(channels)}"
            self._waiting[label, number] = Slice(at_us, at_us, name, event.span, text)
        else:
            self._close(label, number, at_us)
            sender, sent_us = (channels[0] if sender else ""), int(channels[1])
            self.taken.append(TakenSignal(number, sender, sent_us, label, at_us))

    def exchange(self, event: Event, text: str) -> None:
        """Add an axis that was awaited, taken or given; ``text``: its source line."""
        axis, what, *holder = event.text.split()
        label, at_us = event.prefix.strip(), event.time_us
        own = self._slices.setdefault(label, [])
        if what == "awaited":
            name = f"{axis} ← {' '.join(holder)}"
            self._waiting[label, axis] = Slice(at_us, at_us, name, event.span, text)
        elif what == "given":
            own.append(Slice(at_us, at_us, f"{axis} →", event.span, text))
            self._given[axis] = label, at_us
        else:
            own.append(Slice(at_us, at_us, f"← {axis}", event.span, text))
            self._close(label, axis, at_us)
            if axis in self._given:
                giver, given_us = self._given.pop(axis)
                self.taken.append(TakenSignal(axis, giver, given_us, label, at_us))

    def _close(self, label: str, number: str, at_us: int, *, is_open: bool = False) -> None:
        begun = self._waiting.pop((label, number), None)
        if begun is not None and at_us > begun.begin_us:
            item = Slice(begun.begin_us, at_us, begun.name, begun.span, begun.text, is_open)
            self._slices[label].append(item)

    def end(self, event: Event) -> None:
        """Add the end of a program."""
        self._end(event.prefix.strip(), event.time_us, event.text)

    def _end(self, label: str, at_us: int, name: str) -> None:
        begin_us = self._begun.get(label, self._begin_us)
        self._programs.setdefault(label, []).append(Slice(begin_us, at_us, name))
        self._begun[label] = at_us

    def tracks(self, end_us: int) -> Iterator[Track]:
        """Yield the tracks; open slices last to the end of the run."""
        for label, number in tuple(self._waiting):
            self._close(label, number, end_us, is_open=True)
            channel = label.removesuffix(_DECODER).strip()
            if channel not in self._programs:
                self._end(channel, end_us, "")
        if not self._slices:
            return
        for label in sorted({*self._slices, *self._programs}):
            if own := tuple(self._programs.get(label, ())):
                yield Track("program", label, own)
            slices = sorted(self._slices.get(label, ()), key=lambda item: item.begin_us)
            yield Track("channel", label, tuple(slices))
