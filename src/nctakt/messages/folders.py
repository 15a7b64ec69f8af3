# SPDX-License-Identifier: MIT
"""Messages about machine folders: lists that name each other, tools, offsets."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

TOOL_ZERO_WITHOUT_DIMENSIONS = warning(
    900740,
    en="tool 0 has no dimensions: D0 takes those of the tool before away; its entries are left out",
    de="Werkzeug 0 hat keine Maße: D0 nimmt die des Werkzeugs davor weg; seine Einträge entfallen",
    remedy_en="Give the tool a number from 1 on.",
    remedy_de="Dem Werkzeug eine Nummer ab 1 geben.",
)
UNKNOWN_AXIS_INDEX = warning(
    900741,
    en="there is no axis with index {index}: the channel has {count} axes; the entry is left out",
    de="eine Achse mit dem Index {index} gibt es nicht: der Kanal hat {count} Achsen; der Eintrag "
    "entfällt",
    remedy_en="Count the axes of the channel from 0, in the order of its list.",
    remedy_de="Die Achsen des Kanals ab 0 zählen, in der Reihenfolge seiner Liste.",
    index=("the index in the list", "der Index in der Liste"),
    count=("how many axes the channel has", "wie viele Achsen der Kanal hat"),
)
GROUP_ZERO_OFFSETS_IGNORED = warning(
    900742,
    en="G53 deselects all zero offsets here; the offsets of group 0 are left out",
    de="G53 wählt hier alle Nullpunktverschiebungen ab; die Verschiebungen der Gruppe 0 entfallen",
    remedy_en="Set g53_verfuegbar to 1, or use another group.",
    remedy_de="g53_verfuegbar auf 1 setzen oder eine andere Gruppe verwenden.",
)
DEFAULT_GROUP_EMPTY = warning(
    900743,
    en="the default group {group} has no offsets",
    de="die voreingestellte Gruppe {group} hat keine Verschiebungen",
    remedy_en="Name a group that the list describes, or 0 for none.",
    remedy_de="Eine Gruppe nennen, die die Liste beschreibt, oder 0 für keine.",
    group=("P-ZERO-00002", "P-ZERO-00002"),
)
CIRCULAR_LIST_REFERENCE = error(
    900744,
    en="lists name each other in a circle: {circle}; it is not followed",
    de="Listen nennen einander im Kreis: {circle}; ihm wird nicht gefolgt",
    remedy_en="Name a list that does not lead back to this one.",
    remedy_de="Eine Liste nennen, die nicht hierher zurückführt.",
    circle=("the files, the first one at both ends", "die Dateien, die erste an beiden Enden"),
)
WRONG_LIST_KIND = error(
    900745,
    en="{path} is left out: it has no entry of the kind {kind}, but some of {found}",
    de="{path} entfällt: kein Eintrag ist von der Art {kind}, einige aber von {found}",
    remedy_en="Name the right file, or correct the entry's name.",
    remedy_de="Die richtige Datei nennen oder den Namen des Eintrags berichtigen.",
    path=("the path as written", "der Pfad, wie geschrieben"),
    kind=("the kind of list that belongs here", "die Art von Liste, die hierher gehört"),
    found=("the kind of list that the file holds", "die Art von Liste, die die Datei enthält"),
)
UNKNOWN_CHANNEL = error(
    900749,
    en="there is no channel {channel}: the machine has {count}",
    de="einen Kanal {channel} gibt es nicht: die Maschine hat {count}",
    remedy_en="Count the channels from 1, or give the machine more (kanal_anzahl).",
    remedy_de="Die Kanäle ab 1 zählen oder der Maschine mehr geben (kanal_anzahl).",
    channel=("the number of the channel", "die Nummer des Kanals"),
    count=("how many the machine has", "wie viele die Maschine hat"),
)
AXIS_IN_TWO_CHANNELS = error(
    900750,
    en="axis {axis} belongs to channel {first} and to channel {second}; the latter does without",
    de="die Achse {axis} gehört zu Kanal {first} und zu Kanal {second}; dort fehlt sie",
    remedy_en="Give each axis to one channel (log_achs_nr).",
    remedy_de="Jede Achse einem Kanal geben (log_achs_nr).",
    axis=("the logical number", "die logische Nummer"),
    first=("the channel that has it", "der Kanal, der sie hat"),
    second=("the channel that wants it, too", "der Kanal, der sie auch will"),
)
NO_PROGRAM_NAMED = error(
    900751,
    en="no program is named",
    de="es ist kein Programm genannt",
    remedy_en="Name the programs of channel 1, or one of another channel: --channel 2 part.nc",
    remedy_de="Die Programme von Kanal 1 nennen oder das eines anderen: --channel 2 part.nc",
)
INVALID_CHANNEL_NUMBER = error(
    900752,
    en="'{text}' is no number of a channel",
    de="'{text}' ist keine Nummer eines Kanals",
    remedy_en="Write the number in front of the program: --channel 2 part.nc",
    remedy_de="Die Nummer vor das Programm schreiben: --channel 2 part.nc",
    text=("the word as the user wrote it", "das Wort, wie es der Anwender schrieb"),
)
FOLDER_NOT_EMPTY = error(
    900746,
    en="{folder} is not empty; nothing is written",
    de="{folder} ist nicht leer; es wird nichts geschrieben",
    remedy_en="Name a folder that does not exist yet.",
    remedy_de="Einen Ordner nennen, den es noch nicht gibt.",
    folder=("the folder as the user gave it", "der Ordner, wie angegeben"),
)
FOLDER_NOT_WRITABLE = error(
    900747,
    en="{folder} cannot be written: {reason}",
    de="{folder} kann nicht geschrieben werden: {reason}",
    remedy_en="Choose a folder that you may write to.",
    remedy_de="Einen Ordner wählen, in den geschrieben werden darf.",
    folder=("the folder as the user gave it", "der Ordner, wie angegeben"),
    reason=("what the operating system says", "was das Betriebssystem sagt"),
)
LISTS_WRITTEN = note(
    900748,
    en="{count} lists of a machine are in {folder}",
    de="{count} Listen einer Maschine stehen in {folder}",
    remedy_en="Change them, then: nctakt check {folder}",
    remedy_de="Sie ändern, dann: nctakt check {folder}",
    folder=("the folder as the user gave it", "der Ordner, wie angegeben"),
    count=("how many lists were written", "wie viele Listen geschrieben wurden"),
)
CHANNEL_WITHOUT_AXES = warning(
    900818,
    en="channel {channel} has no axis: nothing of it can move",
    de="Kanal {channel} hat keine Achse: nichts in ihm kann sich bewegen",
    remedy_en="Name its axes in the channel list: gruppe[0].achse[i].",
    remedy_de="In der Kanalliste seine Achsen nennen: gruppe[0].achse[i].",
    channel=("the number of the channel", "die Nummer des Kanals"),
)
