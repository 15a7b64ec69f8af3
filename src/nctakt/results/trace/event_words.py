# SPDX-License-Identifier: MIT
"""Events as a person reads them, in English and German, and those in which a text is found.

The names of events in traces are for programs and are not translated; for a person they are words.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from itertools import islice

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Language, Text
from nctakt.kernel import rows
from nctakt.results.trace.chunks import EventChunk
from nctakt.results.trace.events import Event
from nctakt.results.trace.sinks import TraceHeader

#: Characters of a text that is looked for at most.
MAX_SOUGHT = 200

#: Events whose words a matcher knows at most.
_MAX_KNOWN = 50_000

_ROW_SIZE, _TICK_SIZE = 8 * rows.EVENT_WIDTH, 8

_KINDS = {
    "acknowledged": Text("acknowledged", "quittiert"),
    "aborted": Text("cycle aborted", "Zyklus abgebrochen"),
    "axis": Text("axis", "Achse"),
    "block": Text("block", "Satz"),
    "continued": Text("cycle continued", "Zyklus fortgesetzt"),
    "created": Text("cycle defined", "Zyklus definiert"),
    "dropped": Text("function dropped", "Funktion verworfen"),
    "end": Text("program end", "Programmende"),
    "ended": Text("cycle ended", "Zyklus beendet"),
    "error": Text("error", "Fehler"),
    "fired": Text("reaction", "Reaktion"),
    "fixed_stop": Text("fixed stop", "Festanschlag"),
    "frozen": Text("frozen", "eingefroren"),
    "held": Text("cycle held", "Zyklus angehalten"),
    "loop": Text("loop", "Schleife"),
    "message": Text("message", "Meldung"),
    "notice": Text("notice", "Hinweis"),
    "output": Text("to the PLC", "an die SPS"),
    "overflow": Text("thread too slow", "Thread zu langsam"),
    "paused": Text("waits for START", "wartet auf START"),
    "probe": Text("probe", "Taster"),
    "retrace": Text("on the path", "auf der Bahn"),
    "spindle": Text("spindle", "Spindel"),
    "spindle_position": Text("spindle stopped at", "Spindel steht auf"),
    "spindle_reached": Text("spindle at speed", "Spindel auf Drehzahl"),
    "started": Text("cycle started", "Zyklus gestartet"),
    "starved": Text("queue empty", "Queue leer"),
    "timer": Text("timer", "Timer"),
    "tool_life": Text("tool life sent", "Standgröße gesendet"),
    "touch": Text("probe touches", "Taster schaltet"),
    "user_error": Text("user error", "Anwenderfehler"),
    "user_value": Text("value of the error", "Wert zum Fehler"),
    "waits": Text("decoder waits", "Dekoder wartet"),
    "warning": Text("warning", "Warnung"),
    "written": Text("written", "geschrieben"),
}

#: Words in the details of events; names, messages and numbers are not translated.
_PARTICULARS = {
    "aborted": "abgebrochen",
    "backward": "rückwärts",
    "begun": "begonnen",
    "continued": "fortgesetzt",
    "decoded": "dekodiert",
    "delete": "durch DELETE",
    "done": "fertig",
    "error": "durch Fehler",
    "ended": "beendet",
    "failed": "gescheitert",
    "flush": "auf leeren Vorrat",
    "forward": "vorwärts",
    "front": "am vordersten Punkt",
    "held": "angehalten",
    "left": "verlassen",
    "line": "Zeile",
    "negative": "negativ",
    "positions": "auf Positionen",
    "positive": "positiv",
    "read": "auf Lesen",
    "reset": "durch RESET",
    "scope": "am Ende des Bereichs",
    "skipped": "übersprungen",
    "start": "am Anfang",
    "stopped": "gestoppt",
    "write": "auf Schreiben",
}

#: Events whose details are a user's text.
_VERBATIM = ("message", "user_value", "written", "frozen", "end", "overflow")


def event_words(event: Event, language: Language) -> str:
    """Return an event in words: what has happened, and its details."""
    kind = _KINDS.get(event.kind)
    name = event.kind if kind is None else kind.get(language)
    parts = event.text.split(" ")
    if event.kind == "block":
        parts = []
    if event.kind in ("fired", "paused"):
        parts = parts[:-2]  # its line, which is next to it
    if event.kind in ("M", "H"):
        name, parts = f"{event.kind}{parts[0]}", []
    if event.kind in ("output", "acknowledged", "dropped"):
        parts = ["".join(parts[:2]), *(parts[2:] if event.kind == "output" else [])]
    if language == "de" and event.kind not in _VERBATIM:
        parts = [_PARTICULARS.get(part, part) for part in parts]
    return f"{event.prefix}{name} {' '.join(parts)}".rstrip()


def event_text(event: Event, language: Language) -> str:
    """Return an event in a line: its tick, and what has happened."""
    return f"{event.tick}  {event_words(event, language)}"


@dataclass(frozen=True, slots=True)
class SoughtEvents:
    """Events whose line contains a text, in capitals or not.

    ``count``: how many of them are kept at most, the latest ones where ``is_latest``, else the
    first.
    """

    text: str
    language: Language
    count: int
    is_latest: bool = True


class EventMatcher:
    """A sink that keeps the rows of the events that are sought, up to a number of them.

    Events of different ticks have the same words again and again: only new ones are decoded.
    """

    def __init__(self, sought: SoughtEvents) -> None:
        self.sought = sought
        self._text = " ".join(sought.text[:MAX_SOUGHT].casefold().split())
        self._words: dict[bytes, str] = {}
        self._kept: deque[EventChunk] = deque()
        self._kept_count = self._count = 0
        self._since = 0

    def open(self, header: TraceHeader) -> None:
        """Do nothing."""

    def close(self) -> None:
        """Do nothing."""

    def begin(self, tick: int) -> None:
        """Forget what was found before a tick."""
        self._kept.clear()
        self._kept_count = self._count = 0
        self._since = tick

    def events(self, events: Sequence[Event]) -> None:
        """Keep the events in which the text is found."""
        assert isinstance(events, EventChunk)
        events = events.since(self._since)
        text, data, ticks = self._text, events.data, events.column(rows.EVENT_TICK)
        may_be_tick = text[:1].isdigit()
        found = []
        for index, tick in enumerate(ticks):
            row = data[index * _ROW_SIZE + _TICK_SIZE : (index + 1) * _ROW_SIZE]
            words = self._words.get(row)
            if words is None:
                words = self._learn(row, events.select((index,))[0])
            if text in words or (may_be_tick and text in f"{int(tick)} {words}"):
                found.append(index)
        self._count += len(found)
        if found:
            self._keep(events.select(found))

    def _learn(self, row: bytes, event: Event) -> str:
        if len(self._words) >= _MAX_KNOWN:
            self._words.clear()
        words = " ".join(event_words(event, self.sought.language).casefold().split())
        self._words[row] = words
        return words

    def _keep(self, found: EventChunk) -> None:
        capacity = self.sought.count
        if not self.sought.is_latest:
            found = found.select(range(min(len(found), capacity - self._kept_count)))
            if not found:
                return
        self._kept.append(found)
        self._kept_count += len(found)
        while self._kept_count - len(self._kept[0]) >= capacity:
            self._kept_count -= len(self._kept.popleft())

    def take(self) -> tuple[tuple[Event, ...], int]:
        """Return the events that are kept, and how many others there were."""
        surplus = max(0, self._kept_count - self.sought.count)
        kept = tuple(islice((one for chunk in self._kept for one in chunk), surplus, None))
        left_out = self._count - len(kept)
        self.begin(self._since)
        return kept, left_out
