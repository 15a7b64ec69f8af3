# SPDX-License-Identifier: MIT
"""Messages about a machine's log and its comparison with a run."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

LOG_IN_OTHER_FORM = error(
    902510,
    en="{file} is damaged, or a log in a format that nctakt does not read",
    de="{file} ist beschädigt oder ein Log in einem Format, das nctakt nicht liest",
    remedy_en="Export it again, or as text: TC3ScopeExportTool.exe writes .csv from .svdx.",
    remedy_de="Erneut oder als Text exportieren: TC3ScopeExportTool.exe schreibt .csv aus .svdx.",
)
NO_TIME_IN_LOG = error(
    902511,
    en="no column of {file} is recognised as its time",
    de="keine Spalte von {file} ist als Zeit erkennbar",
    remedy_en='Name it in a mapping file: [log] time = "t", time_unit = "ms".',
    remedy_de='Sie in einer Zuordnungsdatei angeben: [log] time = "t", time_unit = "ms".',
)
TIME_UNIT_UNKNOWN = error(
    902955,
    en="the time of {file} is in '{unit}', which is not a unit of time here",
    de="die Zeit von {file} ist in '{unit}' angegeben; das ist hier keine Zeiteinheit",
    remedy_en='Give it in a mapping file: [log] time_unit = "ms". Units: {units}.',
    remedy_de='Sie in einer Zuordnungsdatei angeben: [log] time_unit = "ms". Einheiten: {units}.',
    unit=("the unit", "die Einheit"),
    units=("the units that are known", "die bekannten Einheiten"),
)
NO_ROW_OF_TRACE = error(
    902956,
    en="this line is not a row of a trace",
    de="diese Zeile ist keine Zeile einer Aufzeichnung",
    remedy_en="Record the trace again with --trace; it may have been cut off, or edited.",
    remedy_de="Mit --trace neu aufzeichnen; die Datei ist vielleicht abgeschnitten oder verändert.",
)
NO_NAMES_IN_LOG = error(
    902512,
    en="{file}, line {line}: the row of names before the numbers is missing",
    de="{file}, Zeile {line}: vor den Zahlen fehlt die Zeile mit den Namen",
    remedy_en="Add a first line with the names of the columns.",
    remedy_de="Eine erste Zeile mit den Namen der Spalten ergänzen.",
    line=("the line", "die Zeile"),
)
NO_SIGNAL_IN_LOG = error(
    902513,
    en="{file} has no signals",
    de="{file} hat keine Signale",
    remedy_en="Check whether the export is complete.",
    remedy_de="Prüfen, ob der Export vollständig ist.",
)
NO_NUMBER_IN_LOG = error(
    902514,
    en="'{text}' is not a number",
    de="'{text}' ist keine Zahl",
    remedy_en="Give separator and decimal mark in a mapping file, or leave the column out; split "
    "a log at a second header.",
    remedy_de="In einer Zuordnungsdatei Trenn- und Dezimalzeichen angeben, die Spalte weglassen; "
    "vor zweitem Kopf teilen.",
    text=("the text", "der Text"),
)
BYTE_NOT_OF_ENCODING = error(
    902880,
    en="these bytes are not a character in {encoding}",
    de="diese Bytes sind in {encoding} kein Zeichen",
    remedy_en="Export the log again, or save it as UTF-8.",
    remedy_de="Die Aufzeichnung noch einmal exportieren oder als UTF-8 speichern.",
    encoding=("the encoding", "die Kodierung"),
)
COMMA_FOR_BOTH = error(
    902515,
    en="{file} has the comma as separator and as decimal mark: its columns cannot be told apart",
    de="{file} hat das Komma als Trenn- und als Dezimalzeichen: die Spalten sind nicht zu trennen",
    remedy_en="Export it with a semicolon or a tab as separator.",
    remedy_de="Mit Semikolon oder Tabulator als Trennzeichen exportieren.",
)
LOG_IS_EMPTY = error(
    902516,
    en="{file} has no samples of {name}",
    de="{file} hat keine Werte von {name}",
    remedy_en="Leave it out of the mapping, or record it.",
    remedy_de="Das Signal aus der Zuordnung nehmen oder aufzeichnen.",
)
TIME_RUNS_BACK = error(
    902517,
    en="{file}: the time of {name} goes backwards after {time} s",
    de="{file}: die Zeit von {name} läuft nach {time} s rückwärts",
    time=("the time", "die Zeit"),
    remedy_en="Split the log there: it holds several recordings.",
    remedy_de="Das Log dort teilen: es enthält mehrere Aufzeichnungen.",
)
UNITS_DO_NOT_FIT = error(
    902518,
    en="{name} of the log is in {unit}, {signal} in {other}",
    de="{name} des Logs hat die Einheit {unit}, {signal} hat {other}",
    remedy_en="Correct the mapping, or give a factor there.",
    remedy_de="Die Zuordnung berichtigen oder dort einen Faktor angeben.",
    signal=("the signal", "das Signal"),
    unit=("the unit", "die Einheit"),
    other=("its unit", "dessen Einheit"),
)
NOTHING_IS_MAPPED = error(
    902519,
    en="no column of {file} belongs to a signal; its columns: {columns}",
    de="keine Spalte von {file} gehört zu einem Signal; ihre Spalten: {columns}",
    remedy_en='Write a mapping file: [signals] "X.ACS.ACT_POS" = "name in the log".',
    remedy_de='Eine Zuordnungsdatei schreiben: [signals] "X.ACS.ACT_POS" = "Name im Log".',
    columns=("its columns", "ihre Spalten"),
)
LOG_LACKS_SIGNAL = error(
    902619,
    en="no column of {file} belongs to {name}",
    de="keine Spalte von {file} gehört zu {name}",
    remedy_en="Give the column of the log the name of the signal, or expect a signal that the log "
    "has.",
    remedy_de="Der Spalte des Logs den Namen des Signals geben oder ein Signal erwarten, das das "
    "Log hat.",
)
COLUMN_UNKNOWN = error(
    902520,
    en="{file} has no column '{name}'{hint}",
    de="{file} hat keine Spalte '{name}'{hint}",
    remedy_en="Correct the mapping.",
    remedy_de="Die Zuordnung berichtigen.",
    hint=("the nearest name", "der nächste Name"),
)
MAPPING_UNREADABLE = error(
    902521,
    en="{file} is not a mapping file: {reason}",
    de="{file} ist keine Zuordnungsdatei: {reason}",
    remedy_en="Correct it; docs/logs.md explains its entries.",
    remedy_de="Sie berichtigen; docs/logs.md erklärt ihre Einträge.",
    reason=("what is wrong", "was falsch ist"),
)
NO_OVERLAP = error(
    902522,
    en="log and run have no time in common: the log is {offset} s after the run",
    de="Log und Lauf haben keine gemeinsame Zeit: das Log liegt {offset} s nach dem Lauf",
    remedy_en="Give the right time with --offset, or leave it out.",
    remedy_de="Mit --offset die richtige Zeit angeben oder die Angabe weglassen.",
    offset=("the offset", "der Versatz"),
)
LOG_TEXT_CUT = error(
    902523,
    en="{file}, line {line} has more than a million characters",
    de="{file}, Zeile {line} hat mehr als eine Million Zeichen",
    remedy_en="Check whether this is a log.",
    remedy_de="Prüfen, ob das ein Log ist.",
    line=("the line", "die Zeile"),
)
SCALE_IN_LOG = note(
    902524,
    en="the log gives {name} a scale ({rows}), but does not say whether the values include it",
    de="das Log nennt für {name} eine Skalierung ({rows}), aber nicht, ob sie in den Werten steckt",
    remedy_en="If it is not, give factor and offset in a mapping file.",
    remedy_de="Wenn nicht, Faktor und Versatz in einer Zuordnungsdatei angeben.",
    rows=("the rows", "die Zeilen"),
)
EQUAL_STAMPS = note(
    902525,
    en="up to {count} samples of {name} share a time stamp; they are spread over {time} ms",
    de="bis zu {count} Werte von {name} haben denselben Zeitstempel; sie werden auf {time} ms "
    "verteilt",
    remedy_en="Record with a finer time resolution.",
    remedy_de="Mit feinerer Zeitauflösung aufzeichnen.",
    time=("the time between two stamps", "die Zeit zwischen zwei Zeitstempeln"),
    count=("the count", "die Anzahl"),
)
CELLS_LEFT_OUT = note(
    902864,
    en="{name} has no number at {count} of its times; they do not count as samples",
    de="{name} hat zu {count} Zeitpunkten keine Zahl; sie zählen nicht als Werte",
    remedy_en="Nothing to do, unless the machine should have recorded values there.",
    remedy_de="Nichts zu tun, außer die Maschine hätte dort Werte aufzeichnen sollen.",
    count=("how many", "wie viele"),
)
GAP_IN_LOG = note(
    902865,
    en="{name} has no sample for {length} ms after {time} s; {period} ms are usual",
    de="{name} hat nach {time} s für {length} ms keinen Wert; üblich sind {period} ms",
    remedy_en="Nothing to do; what happened in the gap is not compared.",
    remedy_de="Nichts zu tun; was in der Lücke geschah, wird nicht verglichen.",
    length=("how long the gap is", "wie lang die Lücke ist"),
    time=("where it begins, in the log's time", "wo sie beginnt, in der Zeit des Logs"),
    period=("the usual time between two samples", "die übliche Zeit zwischen zwei Werten"),
)
LOG_NOT_UTF8 = note(
    902526,
    en="{file} is not UTF-8; it is read as Windows-1252",
    de="{file} ist kein UTF-8; die Datei wird als Windows-1252 gelesen",
    remedy_en="Export it as UTF-8 if names look wrong.",
    remedy_de="Als UTF-8 exportieren, wenn Namen falsch aussehen.",
)
NAMES_ALIKE = note(
    902527,
    en="{columns} all look like {signal}: none of them is compared",
    de="{columns} sehen alle nach {signal} aus: keine davon wird verglichen",
    remedy_en="Choose one in a mapping file.",
    remedy_de="Eine davon in einer Zuordnungsdatei wählen.",
    signal=("the signal", "das Signal"),
    columns=("the columns", "die Spalten"),
)
TIMES_NOT_ALIGNED = warning(
    902528,
    en="the time of the log is taken as that of the run: {reason}",
    de="die Zeit des Logs gilt als die des Laufs: {reason}",
    remedy_en="Give --offset, or record a signal that moves.",
    remedy_de="--offset angeben oder ein Signal aufzeichnen, das sich bewegt.",
    reason=("the reason", "der Grund"),
)
TOLERANCE_UNREADABLE = error(
    902529,
    en="'{text}' is not a tolerance",
    de="'{text}' ist keine Toleranz",
    remedy_en="Write 0.05, 2%, 3ticks or 0.05+3ticks for all signals, or SIGNAL= before it.",
    remedy_de="0.05, 2%, 3ticks oder 0.05+3ticks für alle Signale schreiben, oder SIGNAL= davor.",
    text=("the text", "der Text"),
)
SHARE_DIFFERS = warning(
    902740,
    en="the files to share do not run like the program: {signal} differs from {time} s on",
    de="die Dateien zum Teilen laufen anders als das Programm: {signal} weicht ab {time} s ab",
    remedy_en="When you send them, describe what a PLC, an FMU or a tape did: the files do not "
    "contain it.",
    remedy_de="Beim Senden dazuschreiben, was SPS, FMU oder Band getan haben: die Dateien "
    "enthalten es nicht.",
    signal=("the signal", "das Signal"),
    time=("the time", "die Zeit"),
)
SHARE_DOES_NOT_RUN = warning(
    902741,
    en="the files to share do not run on their own: message {number}",
    de="die Dateien zum Teilen laufen allein nicht: Meldung {number}",
    remedy_en="Send them anyway: log and deviations are complete.",
    remedy_de="Sie trotzdem senden: Log und Abweichungen sind vollständig.",
    number=("the number of the message", "die Nummer der Meldung"),
)
LOG_TOO_LONG_TO_SHARE = error(
    902742,
    en="{count} samples are too many to share: at most {limit}",
    de="{count} Werte sind zum Teilen zu viele: höchstens {limit}",
    remedy_en="Map fewer signals, or cut the log down to the part in which the curves differ.",
    remedy_de="Weniger Signale zuordnen oder das Log auf den Teil kürzen, in dem sich die Kurven "
    "unterscheiden.",
    count=("how many", "wie viele"),
    limit=("the largest number", "die größte Zahl"),
)
SHARE_NOT_WRITTEN = note(
    902743,
    en="nothing has been written to {folder} yet",
    de="in {folder} wurde noch nichts geschrieben",
    remedy_en="Repeat the command with --yes to write it; nctakt sends nothing.",
    remedy_de="Den Befehl mit --yes wiederholen, um es zu schreiben; nctakt sendet nichts.",
)
LOG_NOT_SHOWN = warning(
    902744,
    en="{log} is not shown with the run, which ends with an error: message {number}",
    de="{log} wird nicht mit dem Lauf gezeigt, der mit einem Fehler endet: Meldung {number}",
    remedy_en="Correct the program, and start the page again.",
    remedy_de="Das Programm berichtigen und die Seite neu starten.",
    log=("the log", "das Log"),
    number=("the number of the message", "die Nummer der Meldung"),
)
NO_ROOM_FOR_SAMPLES = error(
    902730,
    en="the samples of run and log do not fit into the folder for temporary files: {reason}",
    de="die Werte von Lauf und Log passen nicht in den Ordner für temporäre Dateien: {reason}",
    remedy_en="Make room there, or name another folder in TMPDIR; each sample takes 8 bytes.",
    remedy_de="Dort Platz schaffen oder mit TMPDIR einen anderen Ordner nennen; je Wert 8 Byte.",
    reason=("what the operating system says", "was das Betriebssystem sagt"),
)
LOG_THINNED = note(
    902844,
    en="{name}: the page shows {kept} of the log's {count} samples; short changes may be missing",
    de="{name}: die Seite zeigt {kept} der {count} Werte; kurze Änderungen können fehlen",
    kept=("how many are shown", "wie viele gezeigt werden"),
)
EVENT_UNREADABLE = error(
    902845,
    en="{text} is not an event: X.ACS.ACT_POS > 10, V.E.GATE rises, M10 @ COLUMN rises",
    de="{text} ist kein Ereignis: X.ACS.ACT_POS > 10, V.E.GATE rises, M10 @ SPALTE rises",
    remedy_en="Name a signal with rises, falls, > or <; or a function or block, @, and a column.",
    remedy_de="Signal mit rises, falls, > oder < nennen; oder Funktion oder Satz, @ und Spalte.",
)
EVENT_NOT_IN_RUN = error(
    902846,
    en="{event} does not happen in the run",
    de="{event} kommt im Lauf nicht vor",
    remedy_en="Name an event that happens in both; --trace shows the events of the run.",
    remedy_de="Ein Ereignis nennen, das in beiden vorkommt; --trace zeigt die des Laufs.",
    event=("the event", "das Ereignis"),
)
EVENT_NOT_IN_LOG = error(
    902847,
    en="{event} does not happen in {file}: {reason}",
    de="{event} kommt in {file} nicht vor: {reason}",
    remedy_en="Name another column after @, or align with --offset.",
    remedy_de="Nach @ eine andere Spalte nennen, oder mit --offset ausrichten.",
    event=("the event", "das Ereignis"),
)
TWO_PLACES = error(
    902848,
    en="--offset and --align both define where the run begins in the log",
    de="--offset und --align legen beide fest, wo der Lauf im Log beginnt",
    remedy_en="Leave one of them out.",
    remedy_de="Eines von beiden weglassen.",
)
BEGIN_UNCERTAIN = warning(
    902849,
    en="where the run begins in the log is uncertain: correlation {quality}, gain {gain}",
    de="der Beginn des Laufs im Log ist unsicher: Korrelation {quality}, Faktor {gain}",
    remedy_en="The curves differ in more than time: give --offset or --align, then try --propose.",
    remedy_de="Die Kurven weichen nicht nur zeitlich ab: --offset oder --align angeben, dann "
    "--propose.",
    quality=("the correlation of the speeds, 1 for equal ones", "die Korrelation, 1 für gleiche"),
    gain=("the log as a multiple of the run", "das Log als Vielfaches des Laufs"),
)
