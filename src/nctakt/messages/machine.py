# SPDX-License-Identifier: MIT
"""Messages of the machine folder and its parameters (900060 … 900079, 900086, 900885)."""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, NOTE, WARNING, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_add(
    900060,
    ERROR,
    "the machine folder {path} does not exist",
    "das Maschinenverzeichnis {path} gibt es nicht",
    remedy_en="Name a folder with a start-up list, or leave it out to use the demo machine.",
    remedy_de="Ein Verzeichnis mit Hochlaufliste angeben oder weglassen, um die Demomaschine zu "
    "verwenden.",
    parameters={
        "path": "the folder as the user gave it",
    },
)
_add(
    900061,
    ERROR,
    "the machine folder {path} has no start-up list ({names})",
    "im Maschinenverzeichnis {path} liegt keine Hochlaufliste ({names})",
    remedy_en="Put the start-up list into the folder, or name the folder where it is.",
    remedy_de="Die Hochlaufliste in das Verzeichnis legen oder das Verzeichnis angeben, in dem sie "
    "liegt.",
    parameters={
        "path": "the folder as the user gave it",
        "names": "the names that a start-up list may have",
    },
)
_add(
    900062,
    ERROR,
    "the list {path} does not exist",
    "die Liste {path} gibt es nicht",
    remedy_en="It is searched in the folder of this list, then in the folder above; correct the "
    "path.",
    remedy_de="Gesucht wird im Verzeichnis dieser Liste, dann im übergeordneten; den Pfad "
    "berichtigen.",
    parameters={
        "path": "the path as written",
    },
)
_add(
    900063,
    NOTE,
    "{path} is taken to mean {found}",
    "{path} wird als {found} verstanden",
    remedy_en="Write the path with '/' and in the letter case of the file.",
    remedy_de="Den Pfad mit '/' und in der Schreibweise der Datei angeben.",
    parameters={
        "path": "the path as written",
        "found": "the file that was found",
    },
)
_add(
    900064,
    ERROR,
    "lists of the format {format} cannot be read",
    "Listen im Format {format} können nicht gelesen werden",
    remedy_en="Use the machine's ASCII lists.",
    remedy_de="Die ASCII-Listen der Maschine verwenden.",
    parameters={
        "format": "the format that the start-up list names",
    },
)
_add(
    900065,
    WARNING,
    "{key} is missing: this list is left out",
    "{key} fehlt: diese Liste entfällt",
    remedy_en="Name the list, or lower the number of lists.",
    remedy_de="Die Liste nennen oder die Anzahl der Listen verringern.",
    parameters={
        "key": "the entry that is missing",
    },
)
_add(
    900066,
    ERROR,
    "no axis list has the logical number {logical} of {name}; it is left out",
    "keine Achsliste hat die logische Nummer {logical} von {name}; es entfällt",
    remedy_en="Correct the number, or add the axis to the start-up list.",
    remedy_de="Die Nummer berichtigen oder die Achse in die Hochlaufliste aufnehmen.",
    parameters={
        "logical": "the logical axis number",
        "name": "the axis or spindle",
    },
)
_add(
    900067,
    ERROR,
    "the logical axis number {logical} is 0 or used by another axis list; this list is left out",
    "die logische Achsnummer {logical} ist 0 oder von einer anderen Achsliste belegt; "
    "diese Liste entfällt",
    remedy_en="Give each axis a number of its own, from 1.",
    remedy_de="Jeder Achse eine eigene Nummer ab 1 geben.",
    parameters={
        "logical": "the logical axis number",
    },
)
_add(
    900068,
    NOTE,
    "there is no rtconf.lis; the NC cycle is {cycle} µs",
    "es gibt keine rtconf.lis; der NC-Takt ist {cycle} µs",
    remedy_en="Name the list with rtconf_lis to set the cycle time.",
    remedy_de="Die Liste mit rtconf_lis nennen, um die Taktzeit festzulegen.",
    parameters={
        "cycle": "the NC cycle that is used, in µs",
    },
)
_add(
    900069,
    ERROR,
    "{key}: {value} is no name for it, or used already; it is left out",
    "{key}: {value} ist kein zulässiger Name oder schon vergeben; es entfällt",
    remedy_en="Axis names begin with A, B, C, Q or U to Z, spindle names with S; each only once.",
    remedy_de="Achsnamen beginnen mit A, B, C, Q oder U bis Z, Spindelnamen mit S; jeder nur "
    "einmal.",
    parameters={
        "key": "the entry",
        "value": "the name, – if there is none",
    },
)
_add(
    900070,
    WARNING,
    "{key} is {count}, but {found} are described; the lesser number counts",
    "{key} ist {count}, beschrieben sind aber {found}; die kleinere Zahl gilt",
    remedy_en="Make the number agree with what is described.",
    remedy_de="Die Anzahl an die Beschreibung anpassen.",
    parameters={
        "key": "the entry that gives the number",
        "count": "the number as written",
        "found": "how many are described",
    },
)
_add(
    900072,
    WARNING,
    "main_spindle_ax_nr: no spindle of the channel has the logical number {logical}",
    "main_spindle_ax_nr: keine Spindel des Kanals hat die logische Nummer {logical}",
    remedy_en="Use the logical number of one of the channel's spindles.",
    remedy_de="Die logische Nummer einer Spindel des Kanals verwenden.",
    parameters={
        "logical": "the logical number",
    },
)
_add(
    900073,
    WARNING,
    "the modulo range {low} … {high} is empty; 0 … 360° are used",
    "der Modulobereich {low} … {high} ist leer; es gelten 0 … 360°",
    remedy_en="Make moduloo greater than modulou.",
    remedy_de="moduloo größer als modulou wählen.",
    parameters={
        "low": "modulou as written",
        "high": "moduloo as written",
    },
)
_add(
    900074,
    WARNING,
    "no gear step has the number {wanted}; gear step {used} is used",
    "keine Getriebestufe hat die Nummer {wanted}; es gilt die Stufe {used}",
    remedy_en="Correct kenngr.getriebe_stufe or getriebe[i].nummer.",
    remedy_de="kenngr.getriebe_stufe oder getriebe[i].nummer berichtigen.",
    parameters={
        "wanted": "the number that is asked for",
        "used": "the number of the step that is used",
    },
)
_add(
    900075,
    WARNING,
    "the software limits {low} … {high} are swapped or equal; they are put in order",
    "die Softwareendschalter {low} … {high} sind vertauscht oder gleich; sie werden geordnet",
    remedy_en="Make kenngr.swe_pos greater than kenngr.swe_neg.",
    remedy_de="kenngr.swe_pos größer als kenngr.swe_neg wählen.",
    parameters={
        "low": "kenngr.swe_neg as written",
        "high": "kenngr.swe_pos as written",
    },
)
_add(
    900076,
    ERROR,
    "{path} cannot be read: {reason}",
    "{path} kann nicht gelesen werden: {reason}",
    remedy_en="Make the file readable.",
    remedy_de="Die Datei lesbar machen.",
    parameters={
        "path": "the file",
        "reason": "what the operating system says",
    },
)
_add(
    900077,
    ERROR,
    "no channel has an axis or a list: nothing can be run",
    "kein Kanal hat eine Achse oder eine Liste: es kann nichts laufen",
    remedy_en="Name a channel list with sda_mds[0] and the axes with achs_mds[i].",
    remedy_de="Mit sda_mds[0] eine Kanalliste und mit achs_mds[i] die Achsen nennen.",
)
_add(
    900078,
    ERROR,
    "V.E.{name} is GLOBAL, but channel {channel} declares it differently; the "
    "declaration of channel {first} counts",
    "V.E.{name} ist GLOBAL, Kanal {channel} erklärt sie aber anders; die Erklärung von "
    "Kanal {first} gilt",
    remedy_en="Declare a GLOBAL variable alike in all channels.",
    remedy_de="Eine GLOBAL-Variable in allen Kanälen gleich erklären.",
    parameters={
        "name": "the variable",
        "channel": "the number of the channel that differs",
        "first": "the number of the channel that declares it first",
    },
)
_add(
    900086,
    WARNING,
    "rt_cycles.max_duration is {value} %: realtime cycles may use more than the whole tick",
    "rt_cycles.max_duration ist {value} %: Echtzeit-Zyklen dürfen mehr als den ganzen "
    "CNC-Takt nutzen",
    remedy_en="Use at most 100, and leave time for the rest of the tick.",
    remedy_de="Höchstens 100 verwenden und Zeit für den Rest des Takts lassen.",
    parameters={
        "value": "P-CHAN-00425",
    },
)
_add(
    900885,
    WARNING,
    "slope {name} (prog_start.slope.profile {value}) is not simulated; TRAPEZ takes its place",
    "Profil {name} (prog_start.slope.profile {value}) wird nicht simuliert; TRAPEZ tritt an seine "
    "Stelle",
    remedy_en="Use 1, the jerk-limited slope TRAPEZ, or 0, the slope STEP.",
    remedy_de="1, das ruckbegrenzte Profil TRAPEZ, oder 0, das Profil STEP, verwenden.",
    parameters={
        "value": "P-CHAN-00071",
        "name": "the slope's name in #SLOPE",
    },
)
