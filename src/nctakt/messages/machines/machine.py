# SPDX-License-Identifier: MIT
"""Messages about the machine folder and its parameters."""

from __future__ import annotations

from nctakt.base.diagnostics import Cases
from nctakt.messages.cases import by_end, by_sign, in_case, names_of_axes
from nctakt.messages.catalogue import error, note, warning

MACHINE_FOLDER_MISSING = error(
    900060,
    en="the machine folder {path} does not exist",
    de="den Maschinenordner {path} gibt es nicht",
    remedy_en="Name a folder with a start-up list or a built-in machine: {names}",
    remedy_de="Einen Ordner mit einer Hochlaufliste oder eine eingebaute Maschine nennen: {names}",
    path=("the folder as the user gave it", "der Ordner, wie angegeben"),
    names=("the built-in machines", "die eingebauten Maschinen"),
)
STARTUP_LIST_MISSING = error(
    900061,
    known_as=(1000070,),
    en="the machine folder {path} has no start-up list ({names})",
    de="im Maschinenordner {path} liegt keine Hochlaufliste ({names})",
    remedy_en="Put the start-up list in the folder, or name the folder that contains it.",
    remedy_de="Die Hochlaufliste in den Ordner legen oder den Ordner angeben, in dem sie liegt.",
    path=("the folder as the user gave it", "der Ordner, wie angegeben"),
    names=("the possible names of a start-up list", "die möglichen Namen einer Hochlaufliste"),
)
LIST_FILE_MISSING = error(
    2001,
    classes=(0, 0),
    known_as=(900062, 1000056, 1000058, 1000059, 1000060, 1000061, 1000062, 21144, 22017),
    en="the list {path} does not exist",
    de="die Liste {path} gibt es nicht",
    remedy_en="Searched: {paths}; correct the path, or name another folder with --root.",
    remedy_de="Gesucht: {paths}; den Pfad berichtigen oder mit --root einen weiteren Ordner "
    "angeben.",
    paths=("the paths that were tried", "die versuchten Pfade"),
)
PATHS_TAKEN_AS = note(
    900063,
    en="paths written differently from the names of their files: {count}; {path} is {file}",
    de="Pfade, die anders geschrieben sind als die Namen ihrer Dateien: {count}; {path} ist {file}",
    remedy_en="The files were found in other folders, or with other slashes or upper and lower "
    "case.",
    remedy_de="Die Dateien liegen in anderen Ordnern oder haben andere Schrägstriche oder "
    "Groß-/Kleinschreibung.",
    count=("the number of these paths", "die Anzahl dieser Pfade"),
    path=("the first path as written", "der erste Pfad, wie geschrieben"),
)
SEVERAL_STARTUP_LISTS = error(
    900973,
    en="the folder {path} has several start-up lists: {files}",
    de="im Ordner {path} liegen mehrere Hochlauflisten: {files}",
    remedy_en="Name one of them instead of the folder.",
    remedy_de="Statt des Ordners eine davon angeben.",
    path=("the folder as the user gave it", "der Ordner, wie angegeben"),
    files=("the start-up lists", "die Hochlauflisten"),
)
STARTUP_LIST_IN_FOLDER = note(
    900974,
    en="the machine of {file} is used",
    de="es gilt die Maschine von {file}",
    remedy_en="Name this file to choose it explicitly.",
    remedy_de="Diese Datei angeben, um sie ausdrücklich zu wählen.",
    file=("the start-up list that was found", "die gefundene Hochlaufliste"),
)
LIST_FORMAT_NOT_SUPPORTED = error(
    900064,
    known_as=(1000084, 2067),
    en="lists in the format {format} cannot be read",
    de="Listen im Format {format} können nicht gelesen werden",
    remedy_en="Use the machine's lists in ASCII or XML.",
    remedy_de="Die Listen der Maschine in ASCII oder XML verwenden.",
    format=("the format that the start-up list names", "das Format, das die Hochlaufliste nennt"),
)
MANDATORY_PARAMETER_MISSING = warning(
    2024,
    known_as=(900065,),
    en="{key} is missing: this list is ignored",
    de="{key} fehlt: diese Liste wird ignoriert",
    remedy_en="Name the list, or reduce the number of lists.",
    remedy_de="Die Liste nennen oder die Anzahl der Listen verringern.",
    key=("the entry that is missing", "der fehlende Eintrag"),
)
AXIS_LIST_MISSING = error(
    20312,
    classes=(0, 0),
    known_as=(900066, 110199, 1000099),
    en="no axis list has the logical number {logical} of {name}, which is ignored",
    de="keine Achsliste hat die logische Nummer {logical} von {name}; {name} wird ignoriert",
    remedy_en="Correct the number, or add the axis to the start-up list.",
    remedy_de="Die Nummer berichtigen oder die Achse in die Hochlaufliste aufnehmen.",
    logical=("the logical axis number", "die logische Achsnummer"),
    name=("the axis or spindle", "die Achse oder Spindel"),
)
INVALID_LOGICAL_AXIS_NUMBER = error(
    110064,
    classes=(0, 0),
    known_as=(900067, 1000177, 1001121),
    cases=in_case(110076, lambda values: values["logical"] == 0),
    en="the logical axis number {logical} is 0 or already used by another axis list; this list is "
    "ignored",
    de="die logische Achsnummer {logical} ist 0 oder von einer anderen Achsliste belegt; diese "
    "Liste wird ignoriert",
    remedy_en="Give each axis a different number, from 1.",
    remedy_de="Jeder Achse eine eigene Nummer ab 1 geben.",
    logical=("the logical axis number", "die logische Achsnummer"),
)
RTCONF_MISSING = note(
    900068,
    en="there is no rtconf.lis; the NC cycle is {cycle} µs",
    de="es gibt keine rtconf.lis; der NC-Takt beträgt {cycle} µs",
    remedy_en="Set the list with rtconf_lis to define the cycle time.",
    remedy_de="Die Liste mit rtconf_lis angeben, um die Taktzeit festzulegen.",
    cycle=("the NC cycle in µs", "der NC-Takt in µs"),
)
INVALID_AXIS_NAME = error(
    20425,
    classes=(0, 0),
    known_as=(900069, 20420, 20423),
    cases=Cases((20419, 20424, 20971, 21045), names_of_axes),
    en="{key}: {value} is not a valid name or is already used; the entry is ignored",
    de="{key}: {value} ist kein gültiger Name oder schon vergeben; der Eintrag wird ignoriert",
    remedy_en="Axis names begin with A, B, C, Q or U to Z, spindle names with S; use each only "
    "once.",
    remedy_de="Achsnamen beginnen mit A, B, C, Q oder U bis Z, Spindelnamen mit S; jeder nur "
    "einmal.",
    value=("the name, or –", "der Name oder –"),
)
DESCRIBED_COUNT_MISMATCH = warning(
    900070,
    cases=by_end("key", {"achs_anzahl": 20428, "spdl_anzahl": 20418, "kanal_anzahl": 1001125}),
    en="{key} is {count}, but {found} are described; the smaller number is used",
    de="{key} ist {count}, beschrieben sind aber {found}; es gilt die kleinere Zahl",
    remedy_en="Make the number match the number of descriptions.",
    remedy_de="Die Anzahl an die Beschreibung anpassen.",
    key=("the entry that gives the number", "der Eintrag, der die Anzahl nennt"),
    found=("the number of those that are described", "die Anzahl der beschriebenen"),
)
UNKNOWN_MAIN_SPINDLE = warning(
    21037,
    known_as=(900072,),
    en="main_spindle_ax_nr: no spindle of the channel has the logical number {logical}",
    de="main_spindle_ax_nr: keine Spindel des Kanals hat die logische Nummer {logical}",
    remedy_en="Use the logical number of one of the spindles of the channel.",
    remedy_de="Die logische Nummer einer Spindel des Kanals verwenden.",
    logical=("the logical number", "die logische Nummer"),
)
FEED_FORWARD_ON_AND_OFF = warning(
    110354,
    en="feed-forward control is always on and always off; it is off",
    de="die Vorsteuerung ist immer ein und immer aus; sie ist aus",
    remedy_en="Set vorsteuer.default_active or vorsteuer.global_disable, not both.",
    remedy_de="vorsteuer.default_active oder vorsteuer.global_disable setzen, nicht beide.",
)
MODULO_RANGE_EMPTY = warning(
    110052,
    known_as=(900073, 110310),
    en="the modulo range {low} … {high} is empty; 0 … 360° are used",
    de="der Modulobereich {low} … {high} ist leer; es gelten 0 … 360°",
    remedy_en="Set moduloo greater than modulou.",
    remedy_de="moduloo größer als modulou setzen.",
    low=("modulou as written", "modulou, wie geschrieben"),
    high=("moduloo as written", "moduloo, wie geschrieben"),
)
UNKNOWN_GEAR_STEP = warning(
    110066,
    known_as=(900074,),
    en="there is no gear step {number}; gear step {used} is used",
    de="es gibt keine Getriebestufe {number}; es gilt Stufe {used}",
    remedy_en="Correct kenngr.getriebe_stufe or getriebe[i].nummer.",
    remedy_de="kenngr.getriebe_stufe oder getriebe[i].nummer berichtigen.",
    used=("the gear step that is used", "die Stufe, die gilt"),
)
SOFTWARE_LIMITS_SWAPPED = warning(
    900075,
    cases=in_case(110110, lambda values: values["low"] == values["high"]),
    en="the software limits {low} … {high} are swapped or equal; they are sorted",
    de="die Software-Endschalter {low} … {high} sind vertauscht oder gleich; sie werden geordnet",
    remedy_en="Set kenngr.swe_pos greater than kenngr.swe_neg.",
    remedy_de="kenngr.swe_pos größer als kenngr.swe_neg setzen.",
    low=("kenngr.swe_neg as written", "kenngr.swe_neg, wie geschrieben"),
    high=("kenngr.swe_pos as written", "kenngr.swe_pos, wie geschrieben"),
)
AXIS_BEYOND_LIMIT = warning(
    110054,
    cases=by_sign("limit", negative=110054, other=110055),
    en="axis {axis} is at 0, beyond its software limit {limit} by more than {tolerance}",
    de="Achse {axis} steht bei 0, um mehr als {tolerance} jenseits ihres Software-Endschalters "
    "{limit}",
    remedy_en="Move it between its limits first: a run begins with all axes at 0.",
    remedy_de="Sie zuerst zwischen ihre Endschalter fahren: ein Lauf beginnt mit allen Achsen bei "
    "0.",
    limit=("the limit in mm or degrees", "der Endschalter in mm oder Grad"),
    tolerance=("its tolerance (P-AXIS-00179)", "seine Toleranz (P-AXIS-00179)"),
)
LIMIT_TOLERANCE_TOO_LARGE = warning(
    110317,
    cases=by_sign("limit", negative=110318, other=110317),
    en="kenngr.swe_toleranz {value}: with it the limit {limit} exceeds 32 bits; {maximum} is used",
    de="kenngr.swe_toleranz {value}: der Endschalter {limit} hat damit mehr als 32 Bit; es gilt "
    "{maximum}",
    remedy_en="Write a smaller tolerance.",
    remedy_de="Eine kleinere Toleranz angeben.",
    value=("the tolerance as written", "die Toleranz, wie geschrieben"),
    limit=("the limit as written", "der Endschalter, wie geschrieben"),
    maximum=("the tolerance that is used", "die Toleranz, die gilt"),
)
MACHINE_WITHOUT_CHANNELS = error(
    900077,
    known_as=(70012,),
    en="no channel has an axis or a list: nothing can run",
    de="kein Kanal hat eine Achse oder eine Liste: es kann nichts laufen",
    remedy_en="Name a channel list with sda_mds[0] and the axes with achs_mds[i].",
    remedy_de="Mit sda_mds[0] eine Kanalliste und mit achs_mds[i] die Achsen nennen.",
)
GLOBAL_VARIABLE_DECLARED_DIFFERENTLY = error(
    900078,
    en="V.E.{name} is GLOBAL, but channel {channel} declares it differently; that of channel "
    "{first} is used",
    de="V.E.{name} ist GLOBAL, Kanal {channel} deklariert sie aber anders; es gilt die von Kanal "
    "{first}",
    remedy_en="Declare a GLOBAL variable identically in all channels.",
    remedy_de="Eine GLOBAL-Variable in allen Kanälen gleich deklarieren.",
    channel=("the number of the channel that differs", "die Nummer des abweichenden Kanals"),
    first=(
        "the number of the channel that declares it first",
        "die Nummer des Kanals, der sie zuerst deklariert",
    ),
)
CYCLE_DURATION_ABOVE_TICK = warning(
    900086,
    en="rt_cycles.max_duration is {value} %: realtime cycles may take longer than the whole tick",
    de="rt_cycles.max_duration ist {value} %: Echtzeit-Zyklen dürfen länger als der ganze Takt "
    "dauern",
    remedy_en="Use at most 100, and leave time for the rest of the tick.",
    remedy_de="Höchstens 100 verwenden und Zeit für den Rest des Takts lassen.",
    value=("P-CHAN-00425", "P-CHAN-00425"),
)
SLOPE_NOT_SIMULATED = warning(
    900885,
    en="slope {name} (prog_start.slope.profile {value}) is not simulated; TRAPEZ is used instead",
    de="das Beschleunigungsprofil {name} (prog_start.slope.profile {value}) wird nicht simuliert; "
    "es gilt TRAPEZ",
    remedy_en="Use 1, the jerk-limited slope TRAPEZ, or 0, the slope STEP.",
    remedy_de="1, das ruckbegrenzte Beschleunigungsprofil TRAPEZ, oder 0, STEP, verwenden.",
    value=("P-CHAN-00071", "P-CHAN-00071"),
    name=("the slope's name in #SLOPE", "der Name des Profils in #SLOPE"),
)
