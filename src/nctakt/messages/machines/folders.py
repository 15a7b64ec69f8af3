# SPDX-License-Identifier: MIT
"""Messages about machine folders: lists that name each other, tools, offsets."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

TOOL_ZERO_WITHOUT_DIMENSIONS = warning(
    900740,
    en="tool 0 has no dimensions: D0 deselects the tool; its entries are ignored",
    de="Werkzeug 0 hat keine Maße: D0 wählt das Werkzeug ab; seine Einträge werden ignoriert",
    remedy_en="Give the tool a number from 1.",
    remedy_de="Dem Werkzeug eine Nummer ab 1 geben.",
)
UNKNOWN_AXIS_INDEX = warning(
    900741,
    known_as=(21900, 22088),
    en="there is no axis with index {index}: the channel has {count} axes; the entry is ignored",
    de="es gibt keine Achse mit dem Index {index}: der Kanal hat {count} Achsen; der Eintrag wird "
    "ignoriert",
    remedy_en="Count the axes of the channel from 0, in the order of its list.",
    remedy_de="Die Achsen des Kanals ab 0 zählen, in der Reihenfolge seiner Liste.",
    index=("the index in the list", "der Index in der Liste"),
    count=("the number of axes of the channel", "die Anzahl der Achsen des Kanals"),
)
GROUP_ZERO_OFFSETS_IGNORED = warning(
    900742,
    en="G53 deselects all zero offsets here; the offsets of group 0 are ignored",
    de="G53 wählt hier alle Nullpunktverschiebungen ab; die der Gruppe 0 werden ignoriert",
    remedy_en="Set g53_verfuegbar to 1, or use another group.",
    remedy_de="g53_verfuegbar auf 1 setzen oder eine andere Gruppe verwenden.",
)
DEFAULT_GROUP_EMPTY = warning(
    20585,
    known_as=(900743,),
    en="the default group {group} has no offsets",
    de="die voreingestellte Gruppe {group} hat keine Verschiebungen",
    remedy_en="Name a group that the list describes, or 0 for none.",
    remedy_de="Eine Gruppe nennen, die die Liste beschreibt, oder 0 für keine.",
    group=("P-ZERO-00002", "P-ZERO-00002"),
)
CIRCULAR_LIST_REFERENCE = error(
    900744,
    en="lists refer to each other in a circle: {circle}; the reference is not followed",
    de="Listen verweisen im Kreis aufeinander: {circle}; dem Verweis wird nicht gefolgt",
    remedy_en="Refer to a list that does not lead back to this one.",
    remedy_de="Auf eine Liste verweisen, die nicht hierher zurückführt.",
    circle=("the files, the first one at both ends", "die Dateien, die erste an beiden Enden"),
)
WRONG_LIST_KIND = error(
    900745,
    known_as=(30005, 1000084),
    en="{path} is ignored: it has no entries of the kind {kind}, but some of {found}",
    de="{path} wird ignoriert: kein Eintrag gehört zu {kind}, einige gehören zu {found}",
    remedy_en="Name the right file, or correct the name of the entry.",
    remedy_de="Die richtige Datei nennen oder den Namen des Eintrags berichtigen.",
    kind=("the kind of list that belongs here", "die Art von Liste, die hierher gehört"),
    found=("the kind of list that the file holds", "die Art von Liste, die die Datei enthält"),
)
UNKNOWN_CHANNEL = error(
    900749,
    known_as=(1000013, 1001848),
    en="there is no channel {channel}: the machine has {count}",
    de="es gibt keinen Kanal {channel}: die Maschine hat {count}",
    remedy_en="Count channels from 1, or give the machine more of them (kanal_anzahl).",
    remedy_de="Kanäle ab 1 zählen oder der Maschine mehr geben (kanal_anzahl).",
    count=("the number of channels of the machine", "die Anzahl der Kanäle der Maschine"),
)
AXIS_IN_TWO_CHANNELS = error(
    900750,
    known_as=(110190,),
    en="axis {axis} is assigned to channels {first} and {second}; channel {second} does not get it",
    de="Achse {axis} ist den Kanälen {first} und {second} zugeordnet; Kanal {second} erhält sie "
    "nicht",
    remedy_en="Assign each axis to one channel (log_achs_nr).",
    remedy_de="Jede Achse einem Kanal zuordnen (log_achs_nr).",
    axis=("the logical number", "die logische Nummer"),
    first=("the channel that has the axis", "der Kanal, der die Achse hat"),
    second=("the channel that also claims it", "der Kanal, der sie ebenfalls beansprucht"),
)
NO_PROGRAM_NAMED = error(
    900751,
    en="no program was named",
    de="es wurde kein Programm angegeben",
    remedy_en="Name the programs of channel 1, or one of another channel: --channel 2 part.nc",
    remedy_de="Die Programme von Kanal 1 angeben oder das eines anderen: --channel 2 part.nc",
)
INVALID_CHANNEL_NUMBER = error(
    900752,
    en="'{text}' is not a channel number",
    de="'{text}' ist keine Kanalnummer",
    remedy_en="Write the number before the program: --channel 2 part.nc",
    remedy_de="Die Nummer vor das Programm schreiben: --channel 2 part.nc",
    text=("the word as the user wrote it", "das Wort, wie es der Anwender schrieb"),
)
FOLDER_NOT_EMPTY = error(
    900746,
    en="{folder} is not empty; nothing was written",
    de="{folder} ist nicht leer; es wurde nichts geschrieben",
    remedy_en="Name a folder that does not exist yet.",
    remedy_de="Einen Ordner nennen, den es noch nicht gibt.",
)
FOLDER_NOT_WRITABLE = error(
    900747,
    en="{folder} cannot be written: {reason}",
    de="{folder} kann nicht geschrieben werden: {reason}",
    remedy_en="Choose a folder with write permission.",
    remedy_de="Einen Ordner mit Schreibrecht wählen.",
)
LISTS_WRITTEN = note(
    900748,
    en="{count} lists of a machine were written to {folder}",
    de="{count} Listen einer Maschine wurden nach {folder} geschrieben",
    remedy_en="Adapt them, then: nctakt check {folder}",
    remedy_de="Sie anpassen, dann: nctakt check {folder}",
    count=("the number of lists", "die Anzahl der Listen"),
)
ENTRIES_AS_COMMENTS = warning(
    900979,
    en="unknown entries are kept as comments in the XML lists: {count} ({names})",
    de="unbekannte Einträge stehen als Kommentare in den XML-Listen: {count} ({names})",
    remedy_en="XML names parameters by their IDs; keep the ASCII lists for these.",
    remedy_de="XML nennt Parameter mit ihrer ID; für diese die ASCII-Listen behalten.",
    names=("the first of them, each with its list", "die ersten davon, mit ihrer Liste"),
)
LISTS_KEPT_IN_ASCII = note(
    900980,
    en="lists that stay in ASCII: {files}",
    de="Listen, die in ASCII bleiben: {files}",
    remedy_en="They have parameters without a known ID; both formats can be used together.",
    remedy_de="Sie haben Parameter ohne bekannte ID; beide Formate lassen sich zusammen verwenden.",
    files=("the lists", "die Listen"),
)
CHANNEL_WITHOUT_AXES = warning(
    900818,
    known_as=(20427,),
    en="channel {channel} has no axes: it cannot move anything",
    de="Kanal {channel} hat keine Achsen: er kann nichts bewegen",
    remedy_en="Name its axes in the channel list: gruppe[0].achse[i].",
    remedy_de="In der Kanalliste seine Achsen nennen: gruppe[0].achse[i].",
)
PROJECT_WITHOUT_LISTS = error(
    902680,
    en="no lists can be taken from the project {file}: {reason}",
    de="aus dem Projekt {file} lassen sich keine Listen nehmen: {reason}",
    remedy_en="Export the lists of its CNC into a folder: docs/machine-folders.md.",
    remedy_de="Die Listen seiner CNC in einen Ordner exportieren: docs/machine-folders.md.",
    reason=("what is wrong", "was falsch ist"),
)
PROJECT_TICK = note(
    902954,
    en="the GEO task of the project runs every {cycle} µs; here the NC cycle is {default} µs",
    de="die GEO-Task des Projekts läuft alle {cycle} µs; hier beträgt der NC-Takt {default} µs",
    remedy_en="Write rtconf.lis with cycle_time {cycle}, and rtconf_lis ./rtconf.lis into "
    "hochlauf.lis.",
    remedy_de="Eine rtconf.lis mit cycle_time {cycle} schreiben und in hochlauf.lis rtconf_lis "
    "./rtconf.lis.",
    cycle=("the cycle of the task in µs", "der Takt der Task in µs"),
    default=("the NC cycle without rtconf.lis, in µs", "der NC-Takt ohne rtconf.lis, in µs"),
)
PROJECT_LISTS_AS_THEY_ARE = error(
    902735,
    en="{option}: the lists of a TwinCAT project are written as they are",
    de="{option}: die Listen eines TwinCAT-Projekts werden unverändert geschrieben",
    remedy_en="Leave it out; then write them again: nctakt new mill-xml --from mill --format xml.",
    remedy_de="Weglassen; danach erneut schreiben: nctakt new mill-xml --from mill --format xml.",
    option=("the option", "die Option"),
)
