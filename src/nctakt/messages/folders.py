# SPDX-License-Identifier: MIT
"""Messages of machine folders: lists that name each other, tools, offsets (900740 …, 900818)."""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, NOTE, WARNING, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_add(
    900740,
    WARNING,
    "tool 0 has no dimensions: D0 takes those of the tool before away; its entries are left out",
    "Werkzeug 0 hat keine Maße: D0 nimmt die des Werkzeugs davor weg; seine Einträge entfallen",
    remedy_en="Give the tool a number from 1 on.",
    remedy_de="Dem Werkzeug eine Nummer ab 1 geben.",
)
_add(
    900741,
    WARNING,
    "there is no axis with index {index}: the channel has {count} axes; the entry is left out",
    "eine Achse mit dem Index {index} gibt es nicht: der Kanal hat {count} Achsen; der Eintrag "
    "entfällt",
    remedy_en="Count the axes of the channel from 0, in the order of its list.",
    remedy_de="Die Achsen des Kanals ab 0 zählen, in der Reihenfolge seiner Liste.",
    parameters={"index": "the index in the list", "count": "how many axes the channel has"},
)
_add(
    900742,
    WARNING,
    "G53 deselects all zero offsets here; the offsets of group 0 are left out",
    "G53 wählt hier alle Nullpunktverschiebungen ab; die Verschiebungen der Gruppe 0 entfallen",
    remedy_en="Set g53_verfuegbar to 1, or use another group.",
    remedy_de="g53_verfuegbar auf 1 setzen oder eine andere Gruppe verwenden.",
)
_add(
    900743,
    WARNING,
    "the default group {group} has no offsets",
    "die voreingestellte Gruppe {group} hat keine Verschiebungen",
    remedy_en="Name a group that the list describes, or 0 for none.",
    remedy_de="Eine Gruppe nennen, die die Liste beschreibt, oder 0 für keine.",
    parameters={"group": "P-ZERO-00002"},
)
_add(
    900744,
    ERROR,
    "lists name each other in a circle: {circle}; it is not followed",
    "Listen nennen einander im Kreis: {circle}; ihm wird nicht gefolgt",
    remedy_en="Name a list that does not lead back to this one.",
    remedy_de="Eine Liste nennen, die nicht hierher zurückführt.",
    parameters={"circle": "the files, the first one at both ends"},
)
_add(
    900745,
    ERROR,
    "{path} is left out: it has no entry of the kind {meaning_en}, but some of {found_en}",
    "{path} entfällt: kein Eintrag ist von der Art {meaning_de}, einige aber von {found_de}",
    remedy_en="Name the right file, or correct the entry's name.",
    remedy_de="Die richtige Datei nennen oder den Namen des Eintrags berichtigen.",
    parameters={
        "path": "the path as written",
        "meaning_en": "the kind of list that belongs here",
        "meaning_de": "the same in German",
        "found_en": "the kind of list that the file holds",
        "found_de": "the same in German",
    },
)
_add(
    900749,
    ERROR,
    "there is no channel {channel}: the machine has {count}",
    "einen Kanal {channel} gibt es nicht: die Maschine hat {count}",
    remedy_en="Count the channels from 1, or give the machine more (kanal_anzahl).",
    remedy_de="Die Kanäle ab 1 zählen oder der Maschine mehr geben (kanal_anzahl).",
    parameters={"channel": "the number of the channel", "count": "how many the machine has"},
)
_add(
    900750,
    ERROR,
    "axis {axis} belongs to channel {first} and to channel {second}; the latter does without",
    "die Achse {axis} gehört zu Kanal {first} und zu Kanal {second}; dort fehlt sie",
    remedy_en="Give each axis to one channel (log_achs_nr).",
    remedy_de="Jede Achse einem Kanal geben (log_achs_nr).",
    parameters={
        "axis": "the logical number",
        "first": "the channel that has it",
        "second": "the channel that wants it, too",
    },
)
_add(
    900751,
    ERROR,
    "no program is named",
    "es ist kein Programm genannt",
    remedy_en="Name the programs of channel 1, or one of another channel: --channel 2 part.nc",
    remedy_de="Die Programme von Kanal 1 nennen oder das eines anderen: --channel 2 part.nc",
)
_add(
    900752,
    ERROR,
    "'{text}' is no number of a channel",
    "'{text}' ist keine Nummer eines Kanals",
    remedy_en="Write the number in front of the program: --channel 2 part.nc",
    remedy_de="Die Nummer vor das Programm schreiben: --channel 2 part.nc",
    parameters={"text": "the word as the user wrote it"},
)
_add(
    900746,
    ERROR,
    "{folder} is not empty; nothing is written",
    "{folder} ist nicht leer; es wird nichts geschrieben",
    remedy_en="Name a folder that does not exist yet.",
    remedy_de="Einen Ordner nennen, den es noch nicht gibt.",
    parameters={"folder": "the folder as the user gave it"},
)
_add(
    900747,
    ERROR,
    "{folder} cannot be written: {reason}",
    "{folder} kann nicht geschrieben werden: {reason}",
    remedy_en="Choose a folder that you may write to.",
    remedy_de="Einen Ordner wählen, in den geschrieben werden darf.",
    parameters={
        "folder": "the folder as the user gave it",
        "reason": "what the operating system says",
    },
)
_add(
    900748,
    NOTE,
    "{count} lists of a machine are in {folder}",
    "{count} Listen einer Maschine stehen in {folder}",
    remedy_en="Change them, then: nctakt check {folder}",
    remedy_de="Sie ändern, dann: nctakt check {folder}",
    parameters={
        "folder": "the folder as the user gave it",
        "count": "how many lists were written",
    },
)
_add(
    900818,
    WARNING,
    "channel {channel} has no axis: nothing of it can move",
    "Kanal {channel} hat keine Achse: nichts in ihm kann sich bewegen",
    remedy_en="Name its axes in the channel list: gruppe[0].achse[i].",
    remedy_de="In der Kanalliste seine Achsen nennen: gruppe[0].achse[i].",
    parameters={"channel": "the number of the channel"},
)
