# SPDX-License-Identifier: MIT
"""Messages about sessions: stops, going back."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

NOT_A_STOP = error(
    901150,
    en="this is not a stop: {text}",
    de="das ist kein Haltepunkt: {text}",
    remedy_en="Write line 12, runs 6, turns 6, V.E.X > 5, changes V.E.X, M100, message or error.",
    remedy_de="Schreibweisen: line 12, runs 6, turns 6, V.E.X > 5, changes V.E.X, M100, message, "
    "error.",
)
NOT_IN_THE_TICK = error(
    901151,
    en="{name} belongs to the decoder, so a tick does not see it",
    de="{name} gehört zum Dekoder, ein Takt sieht es nicht",
    remedy_en="Watch a V.E, V.CH, V.RTA or V.RTG variable, or stop at the line that writes it.",
    remedy_de="Eine Variable V.E, V.CH, V.RTA oder V.RTG beobachten oder an der Zeile halten, die "
    "sie schreibt.",
)
TOO_MANY_STOPS = error(
    901152,
    en="{count} stops are more than the {limit} that a session watches",
    de="{count} Haltepunkte sind mehr als die {limit}, die eine Sitzung beobachtet",
    remedy_en="Remove some of them, or give one of them a condition.",
    remedy_de="Einige entfernen oder einen mit einer Bedingung versehen.",
    count=("the number of stops", "die Anzahl der Haltepunkte"),
)
CONTROLLER_LOST = error(
    901153,
    en="the session's controller is gone: {reason}",
    de="die Steuerung der Sitzung ist nicht mehr da: {reason}",
    remedy_en="Open a new session; its tape is still there.",
    remedy_de="Eine neue Sitzung öffnen; das Band ist noch da.",
    reason=("what happened to it", "was mit ihr geschah"),
)
INTERRUPTED = error(
    901474,
    en="interrupted before the end",
    de="vor dem Ende unterbrochen",
    remedy_en="Ask again, and wait until it has ended.",
    remedy_de="Noch einmal anfordern und das Ende abwarten.",
)
TICK_NOT_REACHED = error(
    901154,
    en="tick {tick} lies outside this branch, which has reached tick {latest}",
    de="Takt {tick} liegt nicht in diesem Zweig, der bis Takt {latest} reicht",
    remedy_en="Let the session run on to reach it.",
    remedy_de="Die Sitzung bis dorthin weiterlaufen lassen.",
    latest=("the last tick so far", "der bisher letzte Takt"),
)
PLC_HOLDS_OPEN = error(
    902060,
    en="the session cannot go back: the PLC holds {names} open, which copies of it would share",
    de="die Sitzung kann nicht zurück: die SPS hält {names} offen; ihre Kopien müssten sich das "
    "teilen",
    remedy_en="Let the PLC open files for writing and connections only while it needs them.",
    remedy_de="Dateien zum Schreiben und Verbindungen in der SPS nur offen halten, solange sie "
    "nötig sind.",
    names=("the files and connections", "die Dateien und Verbindungen"),
)
PAST_DIFFERS = error(
    901901,
    en="internal error of nctakt: up to tick {tick}, the past differs from the first run",
    de="interner Fehler von nctakt: bis Takt {tick} ist die Vergangenheit nicht die des ersten "
    "Laufs",
    remedy_en="Do not trust this session's past; save its tape and report the error with it.",
    remedy_de="Der Vergangenheit dieser Sitzung nicht trauen; das Band sichern und den Fehler "
    "damit melden.",
    cause_en="Ticks of the past are run again. Their positions, variables and events are compared "
    "with those of the first run, and differ; so they are not shown.",
    cause_de="Takte der Vergangenheit laufen noch einmal. Ihre Positionen, Variablen und "
    "Ereignisse werden mit denen des ersten Laufs verglichen und weichen ab; daher werden sie "
    "nicht gezeigt.",
    tick=("the tick at which it shows", "der Takt, an dem es sich zeigt"),
)
SESSION_IS_CLOSED = error(
    901155,
    en="the session is closed",
    de="die Sitzung ist geschlossen",
    remedy_en="Open a new one.",
    remedy_de="Eine neue öffnen.",
)
PLC_DIFFERS = warning(
    901156,
    en="from tick {tick} on the PLC behaves differently from before: it depends on more than its "
    "inputs",
    de="ab Takt {tick} verhält sich die SPS anders als zuvor: sie hängt von mehr als ihren "
    "Eingängen ab",
    remedy_en="Random numbers, clocks or files can cause this; the tape holds what the PLC did "
    "first.",
    remedy_de="Zufall, Uhren oder Dateien können das bewirken; das Band enthält, was sie zuerst "
    "tat.",
    tick=("the first tick that differs", "der erste abweichende Takt"),
)
NO_SUCH_BRANCH = error(
    901157,
    en="there is no branch {branch}; the session has branches 1 … {count}",
    de="es gibt keinen Zweig {branch}; die Sitzung hat die Zweige 1 … {count}",
    remedy_en="Name one of them.",
    remedy_de="Einen davon nennen.",
    branch=("the number asked for", "die verlangte Nummer"),
    count=("the number of branches", "die Anzahl der Zweige"),
)

PROGRAM_NOT_SELECTED = warning(
    901148,
    en="program {program} was not selected: channel {channel} is in state {state}",
    de="Programm {program} wurde nicht angewählt: Kanal {channel} ist im Zustand {state}",
    remedy_en="Wait for the end of its program, or press RESET first.",
    remedy_de="Das Ende seines Programms abwarten oder zuerst RESET drücken.",
    program=("the program's file", "die Datei des Programms"),
    state=("`running` or `error`", "`running` oder `error`"),
)

TAPE_NEEDS_SCHEDULE = error(
    901149,
    en="the run on this tape used the schedule {list}, which a session cannot use",
    de="der Lauf auf diesem Band folgte dem Ablaufplan {list}, den eine Sitzung nicht verwenden "
    "kann",
    remedy_en="Repeat it with `nctakt replay`.",
    remedy_de="Ihn mit `nctakt replay` wiederholen.",
    list=("the scheduling list", "die Liste der Echtzeitkonfiguration"),
)

NO_BLOCK_COMES = note(
    901925,
    en="no further block can begin: the program waits for {awaited}",
    de="von allein kommt kein weiterer Satz: das Programm wartet auf {awaited}",
    remedy_en="Provide what it waits for, then continue: START is HLI.START = 1.",
    remedy_de="Auslösen, worauf es wartet, dann fortfahren: START ist HLI.START = 1.",
    awaited=("what is waited for", "worauf gewartet wird"),
)
