# SPDX-License-Identifier: MIT
"""Messages about recorded inputs: tapes."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

INVALID_TAPE = error(
    901070,
    en="this is not a line of a tape: {reason}",
    de="das ist keine Zeile eines Bands: {reason}",
    remedy_en="Name a file that nctakt run --record has written.",
    remedy_de="Eine Datei nennen, die nctakt run --record geschrieben hat.",
)
TAPE_OF_OTHER_VERSION = error(
    901071,
    en="the tape has version {found}; this nctakt reads version {version}",
    de="das Band hat die Version {found}; dieses nctakt liest die Version {version}",
    remedy_en="Record the run again, or replay it with nctakt {writer}.",
    remedy_de="Den Lauf neu aufzeichnen oder mit nctakt {writer} wiederholen.",
    found=("the version of the tape", "die Version des Bands"),
    version=("the version that is read", "die Version, die gelesen wird"),
    writer=("the nctakt that wrote it", "das nctakt, das es geschrieben hat"),
)
TAPE_CUT_OFF = error(
    901072,
    en="the tape is cut off: its last line is missing",
    de="das Band ist abgeschnitten: seine letzte Zeile fehlt",
    remedy_en="Record the run again; the tape is complete when the run has ended.",
    remedy_de="Den Lauf neu aufzeichnen; vollständig ist das Band erst, wenn der Lauf zu Ende ist.",
)
TAPE_FILES_CHANGED = error(
    901073,
    en="changed since the tape was recorded: {files}",
    de="geändert seit der Aufzeichnung: {files}",
    remedy_en="--anyway replays it with the files as they are now.",
    remedy_de="--anyway wiederholt den Lauf mit den Dateien, wie sie jetzt sind.",
    files=("programs and lists", "Programme und Listen"),
)
TAPE_NAMES_OUTSIDE = error(
    902024,
    en="the tape names files outside of {folders}: {files}",
    de="das Band nennt Dateien außerhalb von {folders}: {files}",
    remedy_en="If you trust the tape, name the folder whose files it may read: --root FOLDER",
    remedy_de="Ist das Band vertrauenswürdig, den Ordner nennen, dessen Dateien es lesen darf: "
    "--root ORDNER",
    cause_en="A tape may come from anywhere; it may read only the files of its own folder.",
    cause_de="Ein Band kann von überall kommen; es darf nur die Dateien seines Ordners lesen.",
    folders=("the folders that may be read", "die Ordner, die gelesen werden dürfen"),
    files=("the files", "die Dateien"),
)
REPLAY_DIFFERS = warning(
    901074,
    en="the events differ from those of the recorded run, first in tick {tick} ({time}): {events}",
    de="die Ereignisse weichen vom aufgezeichneten Lauf ab, zuerst im Takt {tick} ({time}): "
    "{events}",
    remedy_en="Look at the trace around this tick: --trace out.csv",
    remedy_de="Die Aufzeichnung um diesen Takt ansehen: --trace out.csv",
    tick=("the tick, counted from 0", "der Takt, ab 0 gezählt"),
    time=("its virtual time", "seine virtuelle Zeit"),
    events=("the events of the tick now, or –", "die jetzigen Ereignisse des Takts oder –"),
)
REPLAY_AGREES = note(
    901075,
    en="the events of all {ticks} ticks are those of the recorded run",
    de="die Ereignisse aller {ticks} Takte sind die des aufgezeichneten Laufs",
)
REPLAY_NOT_COMPARED = note(
    901531,
    en="the tape ends where its process was ended: {ticks} ticks, no events to compare with",
    de="das Band endet, wo sein Prozess beendet wurde: {ticks} Takte, keine Ereignisse zum "
    "Vergleichen",
)
INPUT_NOT_POSSIBLE = error(
    901077,
    en="the recorded input of tick {tick} is not possible on this machine: {input}",
    de="die aufgezeichnete Eingabe des Takts {tick} ist auf dieser Maschine nicht möglich: {input}",
    remedy_en="Replay the run on the machine on which it was recorded.",
    remedy_de="Den Lauf auf der Maschine wiederholen, auf der er aufgezeichnet wurde.",
    tick=("the tick, counted from 0", "der Takt, ab 0 gezählt"),
    input=("the input", "die Eingabe"),
)
TAPE_CHANGES_LISTS = error(
    901392,
    en="the tape has other values of parameters than the lists: {files}",
    de="das Band hat andere Parameterwerte als die Listen: {files}",
    remedy_en="Use nctakt replay, which takes the values of the tape.",
    remedy_de="nctakt replay verwenden, das die Werte des Bands nimmt.",
    files=("the lists", "die Listen"),
)
