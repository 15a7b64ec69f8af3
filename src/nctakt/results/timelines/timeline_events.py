# SPDX-License-Identifier: MIT
"""The events of a run -> its timeline.

In: events, the histories of its conditions if they were recorded. Out: ``Timeline``: blocks, waits,
cycles, reactions, functions until their acknowledgement, motions of axes, reports.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.results.explained.why import WhyReport
from nctakt.results.timelines.timeline import KINDS, Slice, TakenSignal, Timeline, Track, TrackKind
from nctakt.results.timelines.timeline_branches import branch_tracks
from nctakt.results.trace.events import Event

#: Events of a single moment: kind of the event -> kind of its track.
_MOMENTS: dict[str, TrackKind] = {
    "message": "message",
    "error": "error",
    "warning": "error",
    "user_error": "error",
    "notice": "error",
    "overflow": "overflow",
    "paused": "paused",
    "end": "end",
}
#: Events in the life of a cycle -> its state from then on.
_STATES = {
    "created": "defined",
    "started": "active",
    "continued": "active",
    "held": "held",
    "ended": "",
}


#: After the name of a channel and in texts of events: it is its decoder that waits.
_DECODER = "decoder"


def timeline_of(
    events: Iterable[Event],
    why: WhyReport | None,
    *,
    cycle_time_us: int,
    first_tick: int,
    ticks: int,
    line_at: Callable[[Span], str],
    idle: bool = False,
) -> Timeline:
    """Return the timeline of a run of ``ticks`` ticks.

    ``line_at`` returns the source line of a span. Without ``why`` there are no conditions, and a
    reaction is as long as it fired in tick after tick. ``idle``: with the conditions that were
    never true and the reactions that never ran.
    """
    begin_us, end_us = first_tick * cycle_time_us, (first_tick + ticks) * cycle_time_us
    builder = _Builder(begin_us, end_us, cycle_time_us, line_at)
    for event in events:
        builder.add(event)
    builder.finish()
    if why is not None:
        builder.replace_reactions(branch_tracks(why, idle=idle))
    tracks = sorted(builder.tracks(), key=lambda track: KINDS.index(track.kind))
    signals = tuple(builder.channels.taken)
    return Timeline(begin_us, end_us, cycle_time_us, tuple(tracks), signals)


@dataclass(slots=True)
class _Open:
    """A slice whose end is not known yet."""

    begin_us: int
    name: str
    span: Span | None
    text: str = ""


class _Builder:
    """Gathers events into slices, by kind and label of their tracks."""

    def __init__(
        self, begin_us: int, end_us: int, cycle_time_us: int, line_at: Callable[[Span], str]
    ) -> None:
        self._begin_us = begin_us
        self._end_us = end_us
        self._tick_us = cycle_time_us
        self._line_at = line_at
        self._slices: dict[tuple[TrackKind, str], list[Slice]] = {}
        self._heads: dict[tuple[TrackKind, str], tuple[str, Span | None, str]] = {}
        self._open: dict[tuple[TrackKind, str], _Open] = {}
        self._groups: dict[Span | None, str] = {}
        self._labels: dict[str, str] = {}
        self._functions: dict[tuple[str, str], list[_Open]] = {}
        self._living: dict[str, _Open] = {}
        self._seen: dict[str, None] = {}
        self._has_blocks = False
        self._histories: list[Track] = []
        self.channels = ChannelTracks(begin_us)

    # --- events ---------------------------------------------------------------------------------

    def add(self, event: Event) -> None:
        """Add an event; those that no track shows are passed over."""
        kind, prefix = event.kind, event.prefix
        if kind in ("block", "end"):
            self._close("wait", prefix, event.time_us)
            self._close("block", prefix, event.time_us)
        if kind == "block":
            self._has_blocks = True
            number = event.text.split()[0]
            text = self._text(event.span)
            name = f"N{number}" if number != "0" else text or _line(event.span)
            self._begin("block", prefix, event, name, text)
        elif kind == "waits":
            self._begin("wait", prefix, event, event.text)
        elif kind in _STATES:
            self._live(event)
        elif kind == "fired":
            self._fire(event)
        elif kind in ("M", "H", "output"):
            self._issue(event)
        elif kind in ("acknowledged", "dropped"):
            self._answer(event)
        elif kind == "starved":
            self._starve(event)
        elif kind in ("axis", "spindle", "spindle_reached"):
            self._move(event)
        elif kind == "signal":
            self.channels.signal(event, self._text(event.span))
        elif kind == "exchange":
            self.channels.exchange(event, self._text(event.span))
            self._exchange(event)
        elif kind in _MOMENTS:
            self._moment(event)
        if kind == "end":
            self.channels.end(event)

    def _exchange(self, event: Event) -> None:
        """Let the decoder wait for an axis: the positions that it has waited for have come."""
        axis, what = event.text.split()[:2]
        self._close("wait", event.prefix, event.time_us)
        if what == "awaited":
            self._begin("wait", event.prefix, event, f"axis {axis}")

    def _text(self, span: Span | None) -> str:
        return "" if span is None else self._line_at(span).strip()

    def _add(self, kind: TrackKind, label: str, item: Slice) -> None:
        self._slices.setdefault((kind, label), []).append(item)

    def _begin(self, kind: TrackKind, label: str, event: Event, name: str, text: str = "") -> None:
        self._slices.setdefault((kind, label), [])
        self._open[kind, label] = _Open(event.time_us, name, event.span, text)

    def _close(self, kind: TrackKind, label: str, time_us: int, *, is_open: bool = False) -> None:
        """End the open slice of a track; a slice without length is dropped."""
        item = self._open.pop((kind, label), None)
        if item is not None and time_us > item.begin_us:
            self._add(kind, label, _ended(item, time_us, is_open=is_open))

    def _live(self, event: Event) -> None:
        """Continue with the next state of a cycle; a cycle from before the run was active."""
        name = event.cycle
        if event.kind == "created" and "#" in name:
            self._labels[name] = self._groups.setdefault(event.span, name)
        if name not in self._seen and event.kind != "created":
            state = "held" if event.kind == "continued" else "active"
            self._living[name] = _Open(self._begin_us, state, event.span)
        self._seen[name] = None
        before = self._living.pop(name, None)
        if before is not None and event.time_us > before.begin_us:
            self._add("cycle", self._label(name), _ended(before, event.time_us))
        if state := _STATES[event.kind]:
            self._living[name] = _Open(event.time_us, state, event.span, self._text(event.span))

    def _label(self, cycle: str) -> str:
        """Return the name of a cycle; without ID, that of the first cycle of its span."""
        return self._labels.get(cycle, cycle)

    def _fire(self, event: Event) -> None:
        """Add a firing; a firing in the tick after the last one prolongs it."""
        group = self._label(event.cycle)
        label = f"{group}: {event.text.split()[-1]}"
        key: tuple[TrackKind, str] = ("reaction", label)
        self._heads.setdefault(key, (group, event.span, self._text(event.span)))
        own = self._slices.setdefault(key, [])
        end_us = event.time_us + self._tick_us
        if own and own[-1].end_us >= event.time_us:
            own[-1] = Slice(own[-1].begin_us, end_us, own[-1].name, event.span)
        else:
            own.append(Slice(event.time_us, end_us, label, event.span))

    def _issue(self, event: Event) -> None:
        """Begin a function, which its acknowledgement ends."""
        words = event.text.split()
        value = ""
        if event.kind == "output":
            name, key = f"{words[0]}{words[1]}", (f"{event.prefix}{words[0]} {words[1]}", "0")
            value = words[3] if len(words) > 2 else ""
        else:
            name, key = (
                f"{event.kind}{words[0]}",
                (f"{event.prefix}{event.kind} {words[0]}", words[1]),
            )
        self._slices.setdefault(("function", f"{event.prefix}{name}"), [])
        shown = f"{name} = {value}" if value else name
        item = _Open(event.time_us, shown, event.span, self._text(event.span))
        self._functions.setdefault(key, []).append(item)

    def _answer(self, event: Event) -> None:
        letter, number, sequence, time = event.text.split()
        waiting = self._functions.get((f"{event.prefix}{letter} {number}", sequence), [])
        item = next((item for item in waiting if item.begin_us == int(time)), None)
        if item is None:
            return  # an earlier run has put it out
        waiting.remove(item)
        label = f"{event.prefix}{letter}{number}"
        self._add("function", label, _ended(item, event.time_us))

    def _starve(self, event: Event) -> None:
        if event.text == "begun":
            self._begin("starved", event.prefix, event, "starved")
        else:
            self._close("starved", event.prefix, event.time_us)

    def _move(self, event: Event) -> None:
        """Begin or end an independent motion of an axis, or a job of a spindle."""
        name, *words = event.text.split()
        kind: TrackKind = "axis" if event.kind == "axis" else "spindle"
        label = f"{event.prefix}{name}"
        if event.kind == "spindle" or (words and words[0] == "begun"):
            self._close(kind, label, event.time_us)
            self._begin(kind, label, event, " ".join(words), self._text(event.span))
        elif not words or words[0] in ("done", "failed", "stopped"):
            self._close(kind, label, event.time_us)

    def _moment(self, event: Event) -> None:
        kind = _MOMENTS[event.kind]
        name = event.text if kind in ("message", "end") else f"{event.kind} {event.text}"
        item = Slice(event.time_us, event.time_us, name, event.span, self._text(event.span))
        self._add(kind, event.prefix, item)

    def finish(self) -> None:
        """Close open slices at the end of the run."""
        for key in tuple(self._open):
            self._close(*key, self._end_us, is_open=True)
        for name, item in self._living.items():
            self._add("cycle", self._label(name), _ended(item, self._end_us, is_open=True))
        for (function, _), items in self._functions.items():
            *prefix, letter, number = function.split()
            label = " ".join((*prefix, f"{letter}{number}"))
            for item in items:
                end_us = self._end_us if self._has_blocks else item.begin_us
                self._add("function", label, _ended(item, end_us, is_open=self._has_blocks))

    # --- histories ------------------------------------------------------------------------------

    def replace_reactions(self, tracks: Iterable[Track]) -> None:
        """Take conditions and reactions from the histories, which know how long they lasted.

        Before the first slice that a history has kept, the firings remain.
        """
        of_branch = {_branch(*head[:2]): key for key, head in self._heads.items()}
        for track in tracks:
            key = of_branch.get(_branch(track.group, track.span))
            if track.kind == "reaction" and key is not None and track.slices:
                first_us = track.slices[0].begin_us
                fired = self._slices.pop(key) if track.left_out else []
                earlier = tuple(item for item in fired if item.end_us <= first_us)
                track = replace(track, slices=earlier + track.slices, left_out=0)  # noqa: PLW2901
                self._slices.pop(key, None)
            self._histories.append(track)

    def tracks(self) -> Iterator[Track]:
        """Yield the tracks that have slices."""
        for (kind, label), own in self._slices.items():
            if own:
                group, span, text = self._heads.get((kind, label), ("", None, ""))
                own.sort(key=lambda item: item.begin_us)
                yield Track(kind, label.strip(), tuple(own), group, span, text)
        yield from self._histories
        yield from self.channels.tracks(self._end_us)


def _ended(item: _Open, end_us: int, *, is_open: bool = False) -> Slice:
    return Slice(item.begin_us, end_us, item.name, item.span, item.text, is_open)


def _branch(group: str, span: Span | None) -> tuple[str, str, int, int] | None:
    """Return the key that distinguishes a branch from others."""
    return None if span is None else (group, span.file, span.line, span.column)


def _line(span: Span | None) -> str:
    return "" if span is None else f"{span.file}:{span.line}"


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
