# SPDX-License-Identifier: MIT
"""The words that ``nctakt time`` prints for kinds, phases and causes of time, with their meanings.

In: the words of ``timing/words.py``. Out: each with its meaning for a tick.
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.timing.entries import NOTHING, Cause, Limit, Phase, TimeKind
from nctakt.timing.words import CAUSES, KINDS, PHASES, limit_text


@dataclass(frozen=True, slots=True)
class TimeWord:
    """A word and its meaning; ``begin``: of what names an axis, a line or a cycle, too."""

    name: Text
    meaning: Text
    begin: Text = NOTHING


_KINDS: dict[TimeKind, Text] = {
    "dwell": Text(
        "The program waits for a programmed time: G04, #TIME",
        "Das Programm wartet eine programmierte Zeit: G04, #TIME",
    ),
    "commands": Text(
        "The path is at rest while commands are executed, the channel empties or the decoder works",
        "Die Bahn steht, während Befehle übernommen werden, der Kanal leerläuft oder der "
        "Dekoder arbeitet",
    ),
    "backward": Text(
        "The path goes back over its history", "Die Bahn fährt über ihre Historie zurück"
    ),
    "idle": Text(
        "The program of this channel has not begun, or is over",
        "Das Programm dieses Kanals hat noch nicht begonnen oder ist zu Ende",
    ),
}

_PHASES: dict[Phase, Text] = {
    "accelerating": Text(
        "The path becomes faster in the tick", "Die Bahn wird in dem Takt schneller"
    ),
    "constant": Text(
        "The path keeps its speed in the tick", "Die Bahn behält in dem Takt ihre Geschwindigkeit"
    ),
    "braking": Text("The path becomes slower in the tick", "Die Bahn wird in dem Takt langsamer"),
    "standing": Text(
        "The path does not move in the tick", "Die Bahn bewegt sich in dem Takt nicht"
    ),
}

_CAUSES: dict[Cause, Text] = {
    "override operator": Text(
        "The operator's override is below 100 %", "Der Override des Bedieners liegt unter 100 %"
    ),
    "override cycle": Text(
        "A realtime cycle has set an override below 100 %",
        "Ein Echtzeit-Zyklus hat einen Override unter 100 % gesetzt",
    ),
    "override both": Text(
        "The override of the operator and that of a realtime cycle are below 100 %",
        "Der Override des Bedieners und der eines Echtzeit-Zyklus liegen unter 100 %",
    ),
    "override program": Text(
        "The programmed override is below 100 %", "Der programmierte Override liegt unter 100 %"
    ),
    "speed": Text(
        "The largest speed of an axis limits the path",
        "Die größte Geschwindigkeit einer Achse begrenzt die Bahn",
    ),
    "acceleration": Text(
        "The largest acceleration of an axis limits the path",
        "Die größte Beschleunigung einer Achse begrenzt die Bahn",
    ),
    "jerk": Text(
        "The largest jerk of an axis limits the path",
        "Der größte Ruck einer Achse begrenzt die Bahn",
    ),
    "curvature": Text(
        "On an arc or another bent path: less than the axes' speeds",
        "Auf einem Kreisbogen oder einer anderen gekrümmten Bahn: weniger als die "
        "Geschwindigkeiten der Achsen",
    ),
    "rounding": Text(
        "The path goes round a corner with the speed that the curve allows",
        "Die Bahn fährt um eine Ecke, so schnell es die Kurve zulässt",
    ),
    "corner": Text(
        "The path slows down for the corner to the next block",
        "Die Bahn bremst für die Ecke zum nächsten Satz",
    ),
    "next feed": Text(
        "The path slows down for the feed of a later block",
        "Die Bahn bremst für den Vorschub eines späteren Satzes",
    ),
    "next limit": Text(
        "The path slows down for the axes of a later block",
        "Die Bahn bremst für die Achsen eines späteren Satzes",
    ),
    "exact stop": Text(
        "The block ends with an exact stop: the path slows down to a standstill",
        "Der Satz endet mit Genauhalt: Die Bahn bremst bis zum Stillstand",
    ),
    "standstill": Text(
        "The path slows down to a standstill: after the block there is no motion, or something "
        "comes before it that the path stops for",
        "Die Bahn bremst bis zum Stillstand: Nach dem Satz kommt keine Bewegung oder vorher etwas, "
        "wofür die Bahn hält",
    ),
    "horizon": Text(
        "The path slows down because more blocks were not known when the speed was settled",
        "Die Bahn bremst, weil weitere Sätze noch nicht bekannt waren, als die Geschwindigkeit "
        "festgelegt wurde",
    ),
    "spindle": Text(
        "The speed of the spindle decides that of the path: G95, threads",
        "Die Drehzahl der Spindel bestimmt die Geschwindigkeit der Bahn: G95, Gewinde",
    ),
    "stop": Text(
        "An error or a reset has stopped the path", "Ein Fehler oder Reset hat die Bahn angehalten"
    ),
    "tick": Text(
        "The motion begins and ends within a tick",
        "Die Bewegung beginnt und endet innerhalb eines Takts",
    ),
    "programmed": Text(
        "The time is written in the program: G04, #TIME", "Die Zeit steht im Programm: G04, #TIME"
    ),
    "unknown": Text(
        "No cause can be proved, for example on arcs whose limits go by the angle",
        "Keine Ursache lässt sich nachweisen, etwa auf Kreisbögen, deren Grenzen vom Winkel "
        "abhängen",
    ),
}


def _words() -> Iterator[TimeWord]:
    for kind, meaning in _KINDS.items():
        yield TimeWord(KINDS[kind], meaning)
    for phase, meaning in _PHASES.items():
        yield TimeWord(PHASES[phase], meaning)
    for cause, meaning in _CAUSES.items():
        limit = Limit(cause)
        yield TimeWord(
            Text(limit_text(limit, "en"), limit_text(limit, "de")), meaning, CAUSES[cause]
        )


#: The words; rapid, feed, feed hold and waiting are separate subjects.
TIME_WORDS = tuple(_words())
