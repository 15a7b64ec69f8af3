# SPDX-License-Identifier: MIT
"""Messages about the PLC's side: scripted PLCs, partners in other processes, recorded inputs."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

PLC_CLASS_MISSING = error(
    900520,
    en="{file} has no class derived from nctakt.Plc and none with a method cycle(self, hli)",
    de="{file} hat weder eine von nctakt.Plc abgeleitete Klasse noch eine mit einer Methode "
    "cycle(self, hli)",
    remedy_en="Derive a class from nctakt.Plc; docs/plc.md has examples of both.",
    remedy_de="Eine Klasse von nctakt.Plc ableiten; Beispiele für beides stehen in docs/plc.md.",
    file=("the file of the PLC", "die Datei der SPS"),
)
PLC_CLASS_AMBIGUOUS = error(
    900521,
    en="{file} has several classes with a method cycle: {names}",
    de="{file} hat mehrere Klassen mit einer Methode cycle: {names}",
    remedy_en="Keep one of them; put an underscore before the names of the others.",
    remedy_de="Eine davon behalten; den Namen der anderen einen Unterstrich voranstellen.",
    file=("the file of the PLC", "die Datei der SPS"),
    names=("the classes", "die Klassen"),
)
PLC_LOAD_FAILED = error(
    900522,
    en="the PLC file failed while it was loaded: {reason}\n{traceback}",
    de="die Datei der SPS ist beim Laden gescheitert: {reason}\n{traceback}",
    remedy_en="Correct the file at the last line shown.",
    remedy_de="Die Datei an der zuletzt gezeigten Zeile berichtigen.",
    reason=("the exception", "die Ausnahme"),
    traceback=(
        "the calls that led there, in the user's files",
        "die Aufrufe bis dorthin, in den Dateien des Anwenders",
    ),
)
PLC_FAILED = error(
    900523,
    en="the PLC failed after tick {tick}: {reason}\n{traceback}",
    de="die SPS ist nach Takt {tick} gescheitert: {reason}\n{traceback}",
    remedy_en="Correct the PLC file at the last line shown.",
    remedy_de="Die Datei der SPS an der zuletzt gezeigten Zeile berichtigen.",
    tick=("the last tick that was run", "der zuletzt gelaufene Takt"),
    reason=("the exception", "die Ausnahme"),
    traceback=(
        "the calls that led there, in the user's files",
        "die Aufrufe bis dorthin, in den Dateien des Anwenders",
    ),
)
NO_PLC_AT_HLI = error(
    900650,
    known_as=(270101,),
    en="no PLC has connected to the HLI {name}",
    de="keine SPS hat sich mit dem HLI {name} verbunden",
    remedy_en="Start the program that writes 1 to plc_present of hli_command.",
    remedy_de="Das Programm starten, das 1 in plc_present von hli_command schreibt.",
    name=("the name of the shared memory", "der Name des gemeinsamen Speichers"),
)
PLC_NOT_ANSWERING = error(
    900651,
    known_as=(270053,),
    en="the PLC at the HLI did not answer after tick {tick}",
    de="die SPS am HLI hat nach Takt {tick} nicht geantwortet",
    remedy_en="After each tick it must write turn of hli_header to turn of hli_link.",
    remedy_de="Sie muss nach jedem Takt turn von hli_header in turn von hli_link schreiben.",
    tick=("the last tick that was run", "der zuletzt gelaufene Takt"),
)
PLC_LEFT_HLI = error(
    900652,
    known_as=(270101,),
    en="the PLC left the HLI after tick {tick}",
    de="die SPS hat das HLI nach Takt {tick} verlassen",
    remedy_en="It must stay until ready of hli_header is 0.",
    remedy_de="Sie muss bleiben, bis ready von hli_header 0 ist.",
    cause_en="It has withdrawn plc_present, or its process, whose ID it has written into process "
    "of hli_link, has ended.",
    cause_de="Sie hat plc_present zurückgenommen, oder ihr Prozess, dessen Nummer sie in process "
    "von hli_link geschrieben hat, ist zu Ende.",
    tick=("the last tick that was run", "der zuletzt gelaufene Takt"),
)
PLC_AND_HLI_OPTIONS = error(
    900653,
    en="--plc and --hli must not be used together: only one PLC answers the CNC",
    de="--plc und --hli schließen sich aus: nur eine SPS antwortet der CNC",
    remedy_en="Omit one of them.",
    remedy_de="Eine der beiden Optionen weglassen.",
)
INPUT_CELL_COUNT = error(
    900654,
    en="{file}, line {line}: {count} cells, but {expected} are needed",
    de="{file}, Zeile {line}: {count} Zellen, nötig sind {expected}",
    remedy_en="Give each column a cell; an empty cell leaves its variable unchanged.",
    remedy_de="Jeder Spalte eine Zelle geben; eine leere Zelle lässt ihre Variable unverändert.",
    file=("the file of inputs", "die Datei der Eingaben"),
    line=("the line in it", "die Zeile darin"),
    count=("the number of cells in the row", "die Anzahl der Zellen in der Zeile"),
    expected=("the number of columns of the first row", "die Anzahl der Spalten der ersten Zeile"),
)
INPUT_HEADER_MISSING = error(
    900655,
    en="{file}, line {line}: the first row must name time and variables",
    de="{file}, Zeile {line}: die erste Zeile muss Zeit und Variablen nennen",
    remedy_en="Write time, then variables: time,V.E.DOOR,HLI.OVERRIDE",
    remedy_de="Zuerst time schreiben, dann Variablen: time,V.E.DOOR,HLI.OVERRIDE",
    file=("the file of inputs", "die Datei der Eingaben"),
    line=("the line in it", "die Zeile darin"),
)
UNKNOWN_PLC_AXIS = error(
    900656,
    known_as=(40091, 40092),
    en="unknown axis {name}",
    de="unbekannte Achse {name}",
    remedy_en="Did you mean {nearest}? Name one of these: {known}",
    remedy_de="War {nearest} gemeint? Eine von diesen nennen: {known}",
    nearest=("the nearest axis, or –", "die ähnlichste Achse, oder –"),
    known=("the axes of the machine", "die Achsen der Maschine"),
)
INVALID_AXIS_COMMAND = error(
    900657,
    known_as=(44003, 44004, 44033, 50520, 50521),
    en="axis {name} cannot be moved with value {value} at speed {speed}",
    de="Achse {name} kann mit Wert {value} und Geschwindigkeit {speed} nicht fahren",
    remedy_en="Give a finite position or distance, and a speed above 0.",
    remedy_de="Eine endliche Position oder Strecke und eine Geschwindigkeit über 0 angeben.",
    name=("the axis", "die Achse"),
    value=("the position or distance", "die Position oder Strecke"),
    speed=("the speed of the axis", "die Geschwindigkeit der Achse"),
)
TOO_MANY_AXIS_COMMANDS = error(
    900658,
    known_as=(44000, 50645, 50646, 60305, 1705, 1708),
    en="too many axis commands in one tick: the command for {name} is ignored",
    de="zu viele Achsaufträge in einem Takt: der für {name} wird ignoriert",
    remedy_en="Call function blocks with a rising edge of execute in different ticks.",
    remedy_de="Funktionsbausteine mit steigender Flanke an execute in verschiedenen Takten "
    "aufrufen.",
    name=("the axis", "die Achse"),
)
STALE_ACKNOWLEDGEMENT = warning(
    900671,
    en="after tick {tick} the PLC acknowledged {name}, which was not waiting; this is ignored",
    de="nach Takt {tick} hat die SPS {name} quittiert, das nicht gewartet hat; dies wird ignoriert",
    remedy_en="Acknowledge what hli.functions() and hli.spindle_jobs() return in the same call.",
    remedy_de="Quittieren, was hli.functions() und hli.spindle_jobs() im selben Aufruf liefern.",
    cause_en="The function was acknowledged before, or a reset has cleared it. Another function "
    "may have its slot by now; that one still waits.",
    cause_de="Die Funktion wurde schon quittiert, oder ein Reset hat sie gelöscht. Ihren Platz "
    "kann inzwischen eine andere Funktion haben; diese wartet weiter.",
    name=("the function or spindle", "die Funktion oder Spindel"),
    tick=("the last tick that was run", "der zuletzt gelaufene Takt"),
)
CHANNEL_BEING_RESET = error(
    900810,
    en="the channel of axis {axis} is being reset: it takes no commands until all axes have "
    "stopped",
    de="der Kanal der Achse {axis} wird zurückgesetzt: bis alle Achsen stehen, nimmt sie keinen "
    "Auftrag an",
    remedy_en="Command the axis again after the reset.",
    remedy_de="Die Achse nach dem Reset erneut beauftragen.",
    cause_en="A reset lasts until all axes of the channel have stopped.",
    cause_de="Ein Reset dauert, bis alle Achsen des Kanals stehen.",
    classes=(6, 6),
)
UNKNOWN_PLC_NAME = error(
    901008,
    en="{owner} has no {name}",
    de="{owner} hat kein {name}",
    remedy_en="Did you mean {nearest}? docs/plc.md lists the names.",
    remedy_de="War {nearest} gemeint? docs/plc.md nennt die Namen.",
    owner=("the object in the PLC's file", "das Objekt in der Datei der SPS"),
)
PLC_NAME_NOT_SETTABLE = error(
    901009,
    en="hli.{name} cannot be set",
    de="hli.{name} lässt sich nicht setzen",
    remedy_en="The attributes that can be set are {settable}.",
    remedy_de="Setzen lassen sich {settable}.",
    name=("the attribute", "das Attribut"),
    settable=("the attributes that can be set", "die Attribute, die sich setzen lassen"),
)
WRONG_PLC_TYPE = error(
    901010,
    en="{name} is {value}, but must be {expected}",
    de="{name} ist {value}, muss aber {expected} sein",
    remedy_en="Correct the value; docs/plc.md shows an example of each.",
    remedy_de="Den Wert berichtigen; docs/plc.md zeigt je ein Beispiel.",
    name=("the attribute", "das Attribut"),
    value=("the value as written", "der Wert, wie geschrieben"),
)
WRONG_HANDLER_PARAMETERS = error(
    901011,
    en="{name} does not take the parameters ({expected}) with which it is called",
    de="{name} nimmt die Parameter ({expected}) nicht an, mit denen es aufgerufen wird",
    remedy_en="Write def {name}({expected}).",
    remedy_de="Dort def {name}({expected}) schreiben.",
    name=("the method", "die Methode"),
    expected=("the parameters that it needs", "die nötigen Parameter"),
)
UNKNOWN_HLI_VALUE = error(
    901012,
    en="the HLI has no value {name} here",
    de="das HLI hat hier keinen Wert {name}",
    remedy_en="Did you mean {nearest}? Possible are: {known}",
    remedy_de="War {nearest} gemeint? Möglich sind: {known}",
    known=("the names that there are", "die vorhandenen Namen"),
)
UNKNOWN_FUNCTION_IN_PLC = error(
    901013,
    en="the PLC waits for {name}, which the channel list does not have",
    de="die SPS wartet auf {name}, das in der Kanalliste fehlt",
    remedy_en="Did you mean {nearest}? Define it in the channel list, or delete it here.",
    remedy_de="War {nearest} gemeint? In der Kanalliste definieren oder hier streichen.",
    cause_en="The PLC sees M and H functions with a synchronisation type (m_synch[], h_synch[]), "
    "and the jobs of spindles that it turns (spindel[].plc_control).",
    cause_de="Die SPS sieht M- und H-Funktionen mit Synchronisationsart (m_synch[], h_synch[]) "
    "und Aufträge der Spindeln, die sie dreht (spindel[].plc_control).",
    name=("the function or spindle", "die Funktion oder Spindel"),
    nearest=(
        "the nearest name of the channel list, or –",
        "der ähnlichste Name der Kanalliste, oder –",
    ),
)
HANDLER_NOT_CALLED = note(
    901014,
    en="{name} of the PLC was never called: {reason}",
    de="{name} der SPS wurde nie aufgerufen: {reason}",
    remedy_en="Check when it should have been called.",
    remedy_de="Prüfen, wann es hätte aufgerufen werden sollen.",
    name=("the method", "die Methode"),
    reason=("what did not happen", "was nicht eingetreten ist"),
)
WRONG_TOOL_DATA = error(
    902804,
    en="tool_data of the PLC answers {answer} for tool {tool}: {reason}",
    de="tool_data der SPS antwortet {answer} auf Werkzeug {tool}: {reason}",
    remedy_en="Return nctakt.ToolData(length=120.0, radius=4.0), or None for an unknown tool.",
    remedy_de="nctakt.ToolData(length=120.0, radius=4.0) zurückgeben, oder None für ein "
    "unbekanntes Werkzeug.",
    answer=("what it returned", "was sie zurückgab"),
    tool=("the number of the tool", "die Nummer des Werkzeugs"),
    reason=("what does not fit", "was nicht passt"),
)
PLC_SILENT = error(
    902320,
    en="the PLC has given no sign of life for 100 ms",
    de="die SPS hat seit 100 ms kein Lebenszeichen gegeben",
    remedy_en="Set mc_watchdog.alive_rw in each cycle of the PLC, or clear enable_w.",
    remedy_de="mc_watchdog.alive_rw in jedem Zyklus der SPS setzen oder enable_w zurücknehmen.",
)
WHEN_CALLED_EACH_TICK = note(
    902140,
    en="the condition of {name} is a Python function, so the PLC is called after each tick",
    de="die Bedingung von {name} ist eine Python-Funktion, also läuft die SPS nach jedem Takt",
    remedy_en='Write it as a text, which the realtime part evaluates: @when("V.E.VALUE > 5").',
    remedy_de='Als Text schreiben, den der Echtzeit-Teil auswertet: @when("V.E.VALUE > 5").',
    name=("the method", "die Methode"),
)
SEVERAL_CALLED_PLCS = error(
    902761,
    en="a run has more than one PLC in Python",
    de="ein Lauf hat mehr als eine SPS in Python",
    remedy_en="Call one from the other; there may be any number of projects in Structured Text.",
    remedy_de="Eine von der anderen aufrufen; Projekte in Strukturiertem Text darf es beliebig "
    "viele geben.",
)
FUNCTION_BEFORE_PLC = note(
    902931,
    en="{function} was acknowledged at once: the PLC announced itself ({path}) only in tick {tick}",
    de="{function} hat sich selbst quittiert: die SPS meldete sich ({path}) erst in Takt {tick} an",
    remedy_en="Let the program wait at its beginning: G04 {dwell}. On the machine the PLC has "
    "long been running.",
    remedy_de="Das Programm am Anfang warten lassen: G04 {dwell}. An der Maschine läuft die SPS "
    "längst.",
    cause_en="Functions wait only for a PLC that has announced itself; a PLC starts with the run "
    "and needs some of its cycles to do so.",
    cause_de="Funktionen warten nur auf eine SPS, die sich angemeldet hat; eine SPS startet mit "
    "dem Lauf und braucht dafür einige ihrer Zyklen.",
    path=("the element that announces it", "das Element, das sie anmeldet"),
    dwell=("the time to wait, in seconds", "die Wartezeit in Sekunden"),
)
MOTION_BEFORE_PLC = note(
    902965,
    en="{axis} moved without releases: the PLC announced itself ({path}) only in tick {tick}",
    de="{axis} bewegte sich ohne Freigaben: die SPS meldete sich ({path}) erst in Takt {tick} an",
    remedy_en="Let the program wait at its beginning: G04 {dwell}. On the machine the PLC has "
    "long been running.",
    remedy_de="Das Programm am Anfang warten lassen: G04 {dwell}. An der Maschine läuft die SPS "
    "längst.",
    cause_en="An axis needs the releases of a PLC that has announced itself for it, and none "
    "before that.",
    cause_de="Eine Achse braucht die Freigaben einer SPS, die sich für sie angemeldet hat, und "
    "vorher keine.",
    path=("the element that announces it", "das Element, das sie anmeldet"),
    dwell=("the time to wait, in seconds", "die Wartezeit in Sekunden"),
)
FUNCTION_WITHOUT_PLC = note(
    902966,
    en="{function} was acknowledged at once: until the run's end the PLC did not announce itself "
    "({path})",
    de="{function} hat sich selbst quittiert: bis zum Ende des Laufs hat sich die SPS nicht "
    "angemeldet ({path})",
    remedy_en="Let the PLC set {path} to TRUE if it is to acknowledge functions.",
    remedy_de="Die SPS {path} auf TRUE setzen lassen, wenn sie Funktionen quittieren soll.",
    cause_en="Functions wait only for a PLC that has announced itself.",
    cause_de="Funktionen warten nur auf eine SPS, die sich angemeldet hat.",
    path=("the element that announces it", "das Element, das sie anmeldet"),
)
