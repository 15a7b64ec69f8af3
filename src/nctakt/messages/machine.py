# SPDX-License-Identifier: MIT
"""Messages about the machine folder and its parameters."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

MACHINE_FOLDER_MISSING = error(
    900060,
    en="the machine folder {path} does not exist",
    de="das Maschinenverzeichnis {path} gibt es nicht",
    remedy_en="Name a folder with a start-up list, or leave it out to use the demo machine.",
    remedy_de="Ein Verzeichnis mit Hochlaufliste angeben oder weglassen, um die Demomaschine zu "
    "verwenden.",
    path=("the folder as the user gave it", "der Ordner, wie angegeben"),
)
STARTUP_LIST_MISSING = error(
    900061,
    en="the machine folder {path} has no start-up list ({names})",
    de="im Maschinenverzeichnis {path} liegt keine Hochlaufliste ({names})",
    remedy_en="Put the start-up list into the folder, or name the folder where it is.",
    remedy_de="Die Hochlaufliste in das Verzeichnis legen oder das Verzeichnis angeben, in dem sie "
    "liegt.",
    path=("the folder as the user gave it", "der Ordner, wie angegeben"),
    names=(
        "the names that a start-up list may have",
        "die Namen, die eine Hochlaufliste haben kann",
    ),
)
LIST_FILE_MISSING = error(
    900062,
    en="the list {path} does not exist",
    de="die Liste {path} gibt es nicht",
    remedy_en="Searched were {folders}; correct the path, or name another folder with --root.",
    remedy_de="Gesucht wurde in {folders}; den Pfad berichtigen oder mit --root ein weiteres "
    "Verzeichnis angeben.",
    path=("the path as written", "der Pfad, wie geschrieben"),
    folders=("the folders that were searched", "die durchsuchten Verzeichnisse"),
)
PATHS_TAKEN_AS = note(
    900063,
    en="paths that are not spelled as their files are: {count}; {path} is {file}",
    de="Pfade, die anders geschrieben sind als ihre Dateien: {count}; {path} ist {file}",
    remedy_en="The files are found all the same, by other folders, slashes or letter case.",
    remedy_de="Gefunden sind sie in anderen Verzeichnissen, mit anderen Schrägstrichen oder "
    "anderer Schreibweise.",
    count=("the number of these paths", "die Anzahl dieser Pfade"),
    path=("the first path as written", "der erste Pfad, wie geschrieben"),
    file=("the file that was found", "die gefundene Datei"),
)
SEVERAL_STARTUP_LISTS = error(
    900973,
    en="the folder {path} has several start-up lists: {files}",
    de="im Verzeichnis {path} liegen mehrere Hochlauflisten: {files}",
    remedy_en="Name one of them instead of the folder.",
    remedy_de="Statt des Verzeichnisses eine davon angeben.",
    path=("the folder as the user gave it", "der Ordner, wie angegeben"),
    files=("the start-up lists", "die Hochlauflisten"),
)
STARTUP_LIST_IN_FOLDER = note(
    900974,
    en="the machine is that of {file}",
    de="die Maschine ist die von {file}",
    remedy_en="Name this file to leave no doubt.",
    remedy_de="Diese Datei angeben, damit kein Zweifel bleibt.",
    file=("the start-up list that was found", "die gefundene Hochlaufliste"),
)
LIST_FORMAT_NOT_SUPPORTED = error(
    900064,
    en="lists of the format {format} cannot be read",
    de="Listen im Format {format} können nicht gelesen werden",
    remedy_en="Use the machine's lists in ASCII or XML.",
    remedy_de="Die Listen der Maschine in ASCII oder XML verwenden.",
    format=("the format that the start-up list names", "das Format, das die Hochlaufliste nennt"),
)
MANDATORY_PARAMETER_MISSING = warning(
    900065,
    en="{key} is missing: this list is left out",
    de="{key} fehlt: diese Liste entfällt",
    remedy_en="Name the list, or lower the number of lists.",
    remedy_de="Die Liste nennen oder die Anzahl der Listen verringern.",
    key=("the entry that is missing", "der fehlende Eintrag"),
)
AXIS_LIST_MISSING = error(
    900066,
    en="no axis list has the logical number {logical} of {name}; it is left out",
    de="keine Achsliste hat die logische Nummer {logical} von {name}; es entfällt",
    remedy_en="Correct the number, or add the axis to the start-up list.",
    remedy_de="Die Nummer berichtigen oder die Achse in die Hochlaufliste aufnehmen.",
    logical=("the logical axis number", "die logische Achsnummer"),
    name=("the axis or spindle", "die Achse oder Spindel"),
)
INVALID_LOGICAL_AXIS_NUMBER = error(
    900067,
    en="the logical axis number {logical} is 0 or used by another axis list; this list is left out",
    de="die logische Achsnummer {logical} ist 0 oder von einer anderen Achsliste belegt; diese "
    "Liste entfällt",
    remedy_en="Give each axis a number of its own, from 1.",
    remedy_de="Jeder Achse eine eigene Nummer ab 1 geben.",
    logical=("the logical axis number", "die logische Achsnummer"),
)
RTCONF_MISSING = note(
    900068,
    en="there is no rtconf.lis; the NC cycle is {cycle} µs",
    de="es gibt keine rtconf.lis; der NC-Takt ist {cycle} µs",
    remedy_en="Name the list with rtconf_lis to set the cycle time.",
    remedy_de="Die Liste mit rtconf_lis nennen, um die Taktzeit festzulegen.",
    cycle=("the NC cycle that is used, in µs", "der NC-Takt, der gilt, in µs"),
)
INVALID_AXIS_NAME = error(
    900069,
    en="{key}: {value} is no name for it, or used already; it is left out",
    de="{key}: {value} ist kein zulässiger Name oder schon vergeben; es entfällt",
    remedy_en="Axis names begin with A, B, C, Q or U to Z, spindle names with S; each only once.",
    remedy_de="Achsnamen beginnen mit A, B, C, Q oder U bis Z, Spindelnamen mit S; jeder nur "
    "einmal.",
    key=("the entry", "der Eintrag"),
    value=("the name, – if there is none", "der Name, – ohne einen"),
)
DESCRIBED_COUNT_MISMATCH = warning(
    900070,
    en="{key} is {count}, but {found} are described; the lesser number counts",
    de="{key} ist {count}, beschrieben sind aber {found}; die kleinere Zahl gilt",
    remedy_en="Make the number agree with what is described.",
    remedy_de="Die Anzahl an die Beschreibung anpassen.",
    key=("the entry that gives the number", "der Eintrag, der die Anzahl nennt"),
    count=("the number as written", "die Anzahl, wie geschrieben"),
    found=("how many are described", "wie viele beschrieben sind"),
)
UNKNOWN_MAIN_SPINDLE = warning(
    900072,
    en="main_spindle_ax_nr: no spindle of the channel has the logical number {logical}",
    de="main_spindle_ax_nr: keine Spindel des Kanals hat die logische Nummer {logical}",
    remedy_en="Use the logical number of one of the channel's spindles.",
    remedy_de="Die logische Nummer einer Spindel des Kanals verwenden.",
    logical=("the logical number", "die logische Nummer"),
)
MODULO_RANGE_EMPTY = warning(
    900073,
    en="the modulo range {low} … {high} is empty; 0 … 360° are used",
    de="der Modulobereich {low} … {high} ist leer; es gelten 0 … 360°",
    remedy_en="Make moduloo greater than modulou.",
    remedy_de="moduloo größer als modulou wählen.",
    low=("modulou as written", "modulou, wie geschrieben"),
    high=("moduloo as written", "moduloo, wie geschrieben"),
)
UNKNOWN_GEAR_STEP = warning(
    900074,
    en="no gear step has the number {wanted}; gear step {used} is used",
    de="keine Getriebestufe hat die Nummer {wanted}; es gilt die Stufe {used}",
    remedy_en="Correct kenngr.getriebe_stufe or getriebe[i].nummer.",
    remedy_de="kenngr.getriebe_stufe oder getriebe[i].nummer berichtigen.",
    wanted=("the number that is asked for", "die verlangte Nummer"),
    used=("the number of the step that is used", "die Nummer der Stufe, die gilt"),
)
SOFTWARE_LIMITS_SWAPPED = warning(
    900075,
    en="the software limits {low} … {high} are swapped or equal; they are put in order",
    de="die Softwareendschalter {low} … {high} sind vertauscht oder gleich; sie werden geordnet",
    remedy_en="Make kenngr.swe_pos greater than kenngr.swe_neg.",
    remedy_de="kenngr.swe_pos größer als kenngr.swe_neg wählen.",
    low=("kenngr.swe_neg as written", "kenngr.swe_neg, wie geschrieben"),
    high=("kenngr.swe_pos as written", "kenngr.swe_pos, wie geschrieben"),
)
MACHINE_WITHOUT_CHANNELS = error(
    900077,
    en="no channel has an axis or a list: nothing can be run",
    de="kein Kanal hat eine Achse oder eine Liste: es kann nichts laufen",
    remedy_en="Name a channel list with sda_mds[0] and the axes with achs_mds[i].",
    remedy_de="Mit sda_mds[0] eine Kanalliste und mit achs_mds[i] die Achsen nennen.",
)
GLOBAL_VARIABLE_DECLARED_DIFFERENTLY = error(
    900078,
    en="V.E.{name} is GLOBAL, but channel {channel} declares it differently; the declaration of "
    "channel {first} counts",
    de="V.E.{name} ist GLOBAL, Kanal {channel} erklärt sie aber anders; die Erklärung von Kanal "
    "{first} gilt",
    remedy_en="Declare a GLOBAL variable alike in all channels.",
    remedy_de="Eine GLOBAL-Variable in allen Kanälen gleich erklären.",
    name=("the variable", "die Variable"),
    channel=("the number of the channel that differs", "die Nummer des abweichenden Kanals"),
    first=(
        "the number of the channel that declares it first",
        "die Nummer des Kanals, der sie zuerst erklärt",
    ),
)
CYCLE_DURATION_ABOVE_TICK = warning(
    900086,
    en="rt_cycles.max_duration is {value} %: realtime cycles may use more than the whole tick",
    de="rt_cycles.max_duration ist {value} %: Echtzeit-Zyklen dürfen mehr als den ganzen CNC-Takt "
    "nutzen",
    remedy_en="Use at most 100, and leave time for the rest of the tick.",
    remedy_de="Höchstens 100 verwenden und Zeit für den Rest des Takts lassen.",
    value=("P-CHAN-00425", "P-CHAN-00425"),
)
SLOPE_NOT_SIMULATED = warning(
    900885,
    en="slope {name} (prog_start.slope.profile {value}) is not simulated; TRAPEZ takes its place",
    de="Profil {name} (prog_start.slope.profile {value}) wird nicht simuliert; TRAPEZ tritt an "
    "seine Stelle",
    remedy_en="Use 1, the jerk-limited slope TRAPEZ, or 0, the slope STEP.",
    remedy_de="1, das ruckbegrenzte Profil TRAPEZ, oder 0, das Profil STEP, verwenden.",
    value=("P-CHAN-00071", "P-CHAN-00071"),
    name=("the slope's name in #SLOPE", "der Name des Profils in #SLOPE"),
)
