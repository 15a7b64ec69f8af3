# SPDX-License-Identifier: MIT
"""Messages about a machine's log and its comparison with a run."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

LOG_IN_OTHER_FORM = error(
    902510,
    en="{file} is a log in a form that is not read here",
    de="{file} ist eine Aufzeichnung in einer Form, die hier nicht gelesen wird",
    remedy_en="Export it as text: TC3ScopeExportTool.exe writes .csv from .svdx.",
    remedy_de="Als Text exportieren: TC3ScopeExportTool.exe schreibt .csv aus .svdx.",
)
NO_TIME_IN_LOG = error(
    902511,
    en="{file} has no column that is known as one of times",
    de="{file} hat keine Spalte, die als Zeit bekannt ist",
    remedy_en='Name it in a mapping file: [log] time = "t", time_unit = "ms".',
    remedy_de='In einer Zuordnungsdatei nennen: [log] time = "t", time_unit = "ms".',
)
NO_NAMES_IN_LOG = error(
    902512,
    en="{file}, line {line}: there is no row of names before the numbers",
    de="{file}, Zeile {line}: Vor den Zahlen steht keine Zeile mit Namen",
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
    remedy_en="Say separator and decimal mark in a mapping file, or leave the column out of it.",
    remedy_de="Trennzeichen und Dezimalzeichen in einer Zuordnungsdatei sagen oder die Spalte "
    "weglassen.",
    text=("the text", "der Text"),
)
COMMA_FOR_BOTH = error(
    902515,
    en="{file} has the comma as separator and as decimal mark: its columns cannot be told apart",
    de="{file} hat das Komma als Trenn- und als Dezimalzeichen: Spalten sind nicht zu trennen",
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
    en="{file}: the time of {name} runs back after {time} s",
    de="{file}: Die Zeit von {name} läuft nach {time} s zurück",
    time=("the time", "die Zeit"),
    remedy_en="Split the log there: it holds several recordings.",
    remedy_de="Die Aufzeichnung dort teilen: Sie enthält mehrere.",
)
UNITS_DO_NOT_FIT = error(
    902518,
    en="{name} of the log is in {unit}, {signal} in {other}",
    de="{name} der Aufzeichnung hat die Einheit {unit}, {signal} hat {other}",
    remedy_en="Correct the mapping, or give a factor there.",
    remedy_de="Die Zuordnung berichtigen oder dort einen Faktor angeben.",
    signal=("the signal", "das Signal"),
    unit=("the unit", "die Einheit"),
    other=("its unit", "dessen Einheit"),
)
NOTHING_IS_MAPPED = error(
    902519,
    en="no column of {file} belongs to a signal: it has {columns}",
    de="keine Spalte von {file} gehört zu einem Signal: Sie hat {columns}",
    remedy_en='Write a mapping file: [signals] "X.ACS.ACT_POS" = "name in the log".',
    remedy_de='Eine Zuordnungsdatei schreiben: [signals] "X.ACS.ACT_POS" = "Name im Log".',
    columns=("its columns", "ihre Spalten"),
)
LOG_LACKS_SIGNAL = error(
    902619,
    en="no column of {file} belongs to {name}",
    de="keine Spalte von {file} gehört zu {name}",
    remedy_en="Name the column of the log as the signal, or expect one that it has.",
    remedy_de="Die Spalte der Aufzeichnung wie das Signal nennen oder eines erwarten, das sie hat.",
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
    en="{file} is not a mapping of a log: {reason}",
    de="{file} ist keine Zuordnung einer Aufzeichnung: {reason}",
    remedy_en="docs/compare.md says what it may hold.",
    remedy_de="docs/compare.md sagt, was darin stehen kann.",
    reason=("what is wrong", "was falsch ist"),
)
NO_OVERLAP = error(
    902522,
    en="log and run have no time in common: the log lies {offset} s after the run",
    de="Aufzeichnung und Lauf haben keine Zeit gemeinsam: Sie liegt {offset} s nach dem Lauf",
    remedy_en="Give the right time with --offset, or leave it out.",
    remedy_de="Mit --offset die richtige Zeit angeben oder die Angabe weglassen.",
    offset=("the offset", "der Versatz"),
)
LOG_TEXT_CUT = error(
    902523,
    en="{file}, line {line} has more than a million characters",
    de="{file}, Zeile {line} hat mehr als eine Million Zeichen",
    remedy_en="Check whether this is a log.",
    remedy_de="Prüfen, ob das eine Aufzeichnung ist.",
    line=("the line", "die Zeile"),
)
SCALE_IN_LOG = note(
    902524,
    en="{name} has a scale in the log ({rows}); whether it is in the values the log does not say",
    de="{name} hat im Log eine Skalierung ({rows}); ob sie in den Werten steckt, sagt es nicht",
    remedy_en="If it is not, give factor and offset in a mapping file.",
    remedy_de="Wenn nicht, Faktor und Versatz in einer Zuordnungsdatei angeben.",
    rows=("the rows", "die Zeilen"),
)
EQUAL_STAMPS = note(
    902525,
    en="up to {count} samples of {name} share a stamp; they are spread over {time} ms",
    de="bis zu {count} Werte von {name} haben denselben Zeitstempel; sie werden auf {time} ms "
    "verteilt",
    remedy_en="Record with a finer time.",
    remedy_de="Mit feinerer Zeit aufzeichnen.",
    time=("the time between two stamps", "die Zeit zwischen zwei Zeitstempeln"),
    count=("the count", "die Anzahl"),
)
CELLS_LEFT_OUT = note(
    902864,
    en="{name} has no number at {count} of its times; these are no samples",
    de="{name} hat zu {count} seiner Zeiten keine Zahl; das sind keine Werte",
    remedy_en="Nothing, unless the machine should have recorded values there.",
    remedy_de="Nichts, es sei denn, die Maschine sollte dort Werte aufgezeichnet haben.",
    count=("how many", "wie viele"),
)
GAP_IN_LOG = note(
    902865,
    en="{name} has no sample for {length} ms after {time} s; {period} ms are usual",
    de="{name} hat nach {time} s für {length} ms keinen Wert; üblich sind {period} ms",
    remedy_en="What happened there is not compared.",
    remedy_de="Was dort geschah, wird nicht verglichen.",
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
    en="{columns} all look like {signal}: none is compared",
    de="{columns} sehen alle nach {signal} aus: keines wird verglichen",
    remedy_en="Choose one in a mapping file.",
    remedy_de="Eines in einer Zuordnungsdatei wählen.",
    signal=("the signal", "das Signal"),
    columns=("the columns", "die Spalten"),
)
TIMES_NOT_ALIGNED = warning(
    902528,
    en="the time of the log is taken as that of the run: {reason}",
    de="die Zeit der Aufzeichnung gilt als die des Laufs: {reason}",
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
    remedy_en="Say when you send them what a PLC, an FMU or a tape did: it is not in them.",
    remedy_de="Beim Senden dazusagen, was SPS, FMU oder Band getan haben: Das steht nicht darin.",
    signal=("the signal", "das Signal"),
    time=("the time", "die Zeit"),
)
SHARE_DOES_NOT_RUN = warning(
    902741,
    en="the files to share do not run by themselves: message {number}",
    de="die Dateien zum Teilen laufen nicht für sich: Meldung {number}",
    remedy_en="Send them nevertheless: log and deviations are complete.",
    remedy_de="Sie trotzdem senden: Aufzeichnung und Abweichungen sind vollständig.",
    number=("the number of the message", "die Nummer der Meldung"),
)
LOG_TOO_LONG_TO_SHARE = error(
    902742,
    en="{count} samples are too many to share: at most {limit}",
    de="{count} Werte sind zum Teilen zu viele: höchstens {limit}",
    remedy_en="Map fewer signals, or cut the log to where the curves part.",
    remedy_de="Weniger Signale zuordnen oder das Log dort abschneiden, wo sich die Kurven trennen.",
    count=("how many", "wie viele"),
    limit=("the largest number", "die größte Zahl"),
)
SHARE_NOT_WRITTEN = note(
    902743,
    en="nothing is written into {folder} yet",
    de="in {folder} ist noch nichts geschrieben",
    remedy_en="Repeat the command with --yes to write it; nctakt sends nothing.",
    remedy_de="Den Befehl mit --yes wiederholen, um es zu schreiben; nctakt sendet nichts.",
)
LOG_NOT_SHOWN = warning(
    902744,
    en="{log} is not laid over the run, which ends with an error: message {number}",
    de="{log} wird nicht über den Lauf gelegt, der mit einem Fehler endet: Meldung {number}",
    remedy_en="Correct the program, and start the page again.",
    remedy_de="Das Programm berichtigen und die Seite neu starten.",
    log=("the log", "die Aufzeichnung"),
    number=("the number of the message", "die Nummer der Meldung"),
)
NO_ROOM_FOR_SAMPLES = error(
    902730,
    en="the samples of run and log do not fit into the folder of temporary files: {reason}",
    de="Die Werte von Lauf und Aufzeichnung passen nicht in den Ordner der Temporärdateien: "
    "{reason}",
    remedy_en="Make room there, or name another folder in TMPDIR; each sample takes 8 bytes.",
    remedy_de="Dort Platz schaffen oder mit TMPDIR einen anderen Ordner nennen; je Wert 8 Byte.",
    reason=("what the operating system says", "was das Betriebssystem sagt"),
)
LOG_THINNED = note(
    902844,
    en="{name}: the page shows {kept} of the log's {count} samples; what is shorter may be missing",
    de="{name}: Die Seite zeigt {kept} der {count} Werte; Kürzeres kann darin fehlen",
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
    remedy_en="Name an event that happens in both; --trace shows what the run has.",
    remedy_de="Ein Ereignis nennen, das beide haben; --trace zeigt, was der Lauf hat.",
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
    en="--offset and --align both say where the run begins in the log",
    de="--offset und --align sagen beide, wo der Lauf in der Aufzeichnung beginnt",
    remedy_en="Leave one of them out.",
    remedy_de="Eines von beiden weglassen.",
)
BEGIN_UNCERTAIN = warning(
    902849,
    en="where the run begins in the log is uncertain: correlation {quality}, gain {gain}",
    de="der Beginn des Laufs ist unsicher gefunden: Korrelation {quality}, Faktor {gain}",
    remedy_en="The curves differ in more than time: give --offset or --align, then see --propose.",
    remedy_de="Die Kurven weichen nicht nur zeitlich ab: --offset oder --align, dann --propose.",
    quality=("the correlation of the speeds, 1 for equal ones", "die Korrelation, 1 für gleiche"),
    gain=("how many times the run the log is", "wie viel Mal der Lauf die Aufzeichnung ist"),
)
