# SPDX-License-Identifier: MIT
"""Messages about studies: plans, measures, results."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

INVALID_PLAN = error(
    901300,
    en="the plan is not valid TOML: {reason}",
    de="der Plan ist kein gültiges TOML: {reason}",
    remedy_en="docs/studies.md shows a plan.",
    remedy_de="Einen Plan zeigt docs/studies.md.",
)
UNKNOWN_PLAN_ENTRY = error(
    901301,
    en="unknown entry {key} in the plan; nearest: {nearest}",
    de="unbekannter Eintrag {key} im Plan; am ähnlichsten: {nearest}",
    remedy_en="Possible here: {names}.",
    remedy_de="Hier möglich: {names}.",
    nearest=("the nearest known one", "der nächste bekannte"),
    names=("the known entries", "die bekannten Einträge"),
)
INVALID_PLAN_VALUE = error(
    901302,
    en="{key} must be {expected}, not {value}",
    de="{key} muss {expected} sein, nicht {value}",
    remedy_en="Change the entry of the plan; docs/studies.md lists all entries.",
    remedy_de="Den Eintrag des Plans ändern; alle Einträge stehen in docs/studies.md.",
)
PLAN_ENTRY_MISSING = error(
    901303,
    en="an entry is missing in {table}: {key}",
    de="in {table} fehlt ein Eintrag: {key}",
    remedy_en="Add it; docs/studies.md lists all entries.",
    remedy_de="Den Eintrag ergänzen; alle Einträge stehen in docs/studies.md.",
    table=("the table of the plan", "die Tabelle des Plans"),
)
EMPTY_STUDY = error(
    901304,
    en="the plan has no runs: {name} has no value",
    de="der Plan hat keine Läufe: {name} hat keinen Wert",
    remedy_en="Give values, or from, to (not below from) and step; other methods need count.",
    remedy_de="Die Werte (values) oder from, to (nicht unter from) und step angeben; andere "
    "Verfahren brauchen count.",
    name=("the dimension, or count", "die Dimension oder count"),
)
STUDY_TOO_LARGE = error(
    901305,
    en="the plan has {count} runs, which take about {time} on {cores} cores",
    de="der Plan hat {count} Läufe; das dauert etwa {time} auf {cores} Kernen",
    remedy_en='--yes starts it nevertheless; --sample 10000, or method = "sobol" with count, takes '
    "some of the points.",
    remedy_de='--yes startet sie trotzdem; --sample 10000 oder method = "sobol" mit count nimmt '
    "einen Teil der Punkte.",
    count=("the number of runs", "die Zahl der Läufe"),
    time=("the estimated time", "die geschätzte Zeit"),
    cores=("the number of cores", "die Zahl der Kerne"),
)
INVALID_MEASURE = error(
    901306,
    en="{text} is not a measure: {reason}",
    de="{text} ist keine Messgröße: {reason}",
    remedy_en="Write for example: time of M100 · count of fired 17 · max X · X at end · time from "
    "M100 to M101 · duration.",
    remedy_de="Möglich: time of M100 · count of fired 17 · max X · X at end · time from M100 to "
    "M101 · duration.",
)
INVALID_STUDY_EXPECTATION = error(
    901307,
    en="{text} is not an expectation: {reason}",
    de="{text} ist keine Erwartung: {reason}",
    remedy_en='Write for example: max X < 300 · X < 50 within 100 ms · M100 once · message "done" '
    "before 2 s.",
    remedy_de='Möglich: max X < 300 · X < 50 within 100 ms · M100 once · message "done" before 2 '
    "s.",
)
RUN_CRASHED = warning(
    901308,
    en="the process of run {index} has ended unexpectedly; the other runs continue",
    de="der Prozess des Laufs {index} ist unerwartet zu Ende; die anderen Läufe gehen weiter",
    remedy_en="Look at this run alone: nctakt study … --only {index}",
    remedy_de="Diesen Lauf allein ansehen: nctakt study … --only {index}",
    index=("the number of the run", "die Nummer des Laufs"),
)
OTHER_PLAN = error(
    901309,
    en="the results in {folder} are those of another plan, program, list or corpus",
    de="die Ergebnisse in {folder} gehören zu anderen Dateien: Plan, Programm, Liste oder Korpus",
    remedy_en="Remove the folder, write to another file with --out, or leave --resume out.",
    remedy_de="Den Ordner entfernen, mit --out in eine andere Datei schreiben oder --resume "
    "weglassen.",
)
NOT_ROWS_OF_A_STUDY = error(
    902023,
    en="{file} exists, but does not contain rows of a study",
    de="{file} gibt es, aber die Datei enthält keine Zeilen einer Studie",
    remedy_en="Move the file, or write to another one with --out.",
    remedy_de="Die Datei verschieben oder mit --out in eine andere schreiben.",
    cause_en="The rows of a study are kept there until it is finished.",
    cause_de="Dort stehen die Zeilen einer Studie, bis sie fertig ist.",
)
STUDY_INTERRUPTED = note(
    901310,
    en="interrupted after {count} of {size} runs; they are kept in {folder}",
    de="unterbrochen nach {count} von {size} Läufen; sie stehen in {folder}",
    remedy_en="Use --resume to make the missing runs.",
    remedy_de="Mit --resume die fehlenden Läufe nachholen.",
    count=("the number of finished runs", "die Zahl der fertigen Läufe"),
    size=("the number of all runs", "die Zahl aller Läufe"),
)
EXTRA_MISSING = error(
    901311,
    en="this needs the package {package}, which is not installed",
    de="dafür fehlt das Paket {package}",
    remedy_en="Install it: {install}",
    remedy_de="Installieren: {install}",
    package=("the package", "das Paket"),
    install=("the command that installs it", "der Befehl, der es installiert"),
)
UNKNOWN_PARAMETER_OF_STUDY = error(
    901312,
    en="{parameter} of {of}: {reason}",
    de="{parameter} von {of}: {reason}",
    remedy_en="nctakt explain {parameter} says which list has it.",
    remedy_de="In welcher Liste er steht, sagt nctakt explain {parameter}.",
    parameter=("the parameter's ID", "die ID des Parameters"),
    of=("the axis or channel", "die Achse oder der Kanal"),
)
UNKNOWN_PROGRAM_VARIABLE = error(
    901313,
    en="the program gives {name} no plain number that a study could vary",
    de="das Programm gibt {name} keine einfache Zahl, die eine Studie variieren könnte",
    remedy_en="Assign it a number in the program: {name} = 5",
    remedy_de="Ihr im Programm eine Zahl zuweisen: {name} = 5",
)
NO_BOUNDARY = warning(
    901314,
    en="nothing changes between {low} and {high}: the expectations hold at both ends or at neither",
    de="zwischen {low} und {high} ändert sich nichts: die Erwartungen gelten an beiden Enden oder "
    "an keinem",
    remedy_en="Choose from and to so that the expectations hold at one end only.",
    remedy_de="Die Grenzen from und to ändern, bis die Erwartungen nur an einem Ende gelten.",
)
NOT_AN_INJECTION = error(
    901315,
    en="{text} is not an injection",
    de="{text} ist kein Eingriff",
    remedy_en='Write for example: --each-tick "V.E.STOP=1 for 20 ms"',
    remedy_de='Zum Beispiel schreiben: --each-tick "V.E.STOP=1 for 20 ms"',
)
CLUSTER_LOST = error(
    901316,
    en="no connection to the scheduler {address}: {reason}",
    de="keine Verbindung zum Scheduler {address}: {reason}",
    remedy_en="Start it (dask scheduler); --resume continues with the finished runs.",
    remedy_de="Ihn starten (dask scheduler); --resume macht mit den fertigen Läufen weiter.",
    address=("the address", "die Adresse"),
)
NAME_TAKEN = error(
    901390,
    en="two columns of the results have the name {name}",
    de="zwei Spalten der Ergebnisse heißen {name}",
    remedy_en="Give each dimension (name) and each measure a different name; {name} is taken.",
    remedy_de="Jeder Dimension (name) und jeder Messgröße einen eigenen Namen geben; {name} ist "
    "vergeben.",
)
UNKNOWN_THREAD = error(
    901391,
    en="the schedule has no thread or CPU {name}; nearest: {nearest}",
    de="der Ablaufplan hat keinen Thread und keine CPU {name}; am ähnlichsten: {nearest}",
    remedy_en="nctakt schedule show lists the threads; put a name that contains a blank in quotes.",
    remedy_de="Die Threads zeigt nctakt schedule show; ein Name mit Leerzeichen steht in "
    "Anführungszeichen.",
    nearest=("the nearest one", "der nächste"),
)
ANSWER_BROKEN = error(
    901940,
    en="no run of the search meets the expectations; in the best one: {broken}",
    de="kein Lauf der Suche erfüllt die Erwartungen; im besten: {broken}",
    remedy_en="Widen the ranges in [[vary]], raise budget, or relax an expectation.",
    remedy_de="Die variierten Bereiche erweitern, budget erhöhen oder eine Erwartung lockern.",
    broken=("what does not hold", "was verletzt ist"),
)
DIMENSION_WITHOUT_EFFECT = warning(
    901941,
    en="{name} has no effect: runs that differ in it alone have the same events and measured "
    "values",
    de="{name} hat keine Wirkung: Läufe, die sich nur darin unterscheiden, haben gleiche "
    "Ereignisse und Messwerte",
    remedy_en="Check whether the program uses it, and whether values and measures can show it.",
    remedy_de="Prüfen, ob das Programm es benutzt und ob Werte und Messgrößen es zeigen können.",
    name=("the dimension", "die Dimension"),
)
NO_EFFECT_SHOWN = warning(
    902061,
    en="{name} has shown no effect: {count} runs repeated with another value of it were the same",
    de="{name} hat keine Wirkung gezeigt: {count} Läufe waren mit einem anderen Wert davon gleich",
    remedy_en="Check whether the program uses it, and whether values and measures can show it.",
    remedy_de="Prüfen, ob das Programm es benutzt und ob Werte und Messgrößen es zeigen können.",
    cause_en="Each of these runs was repeated with another value of this dimension alone, and had "
    "the same events and measured values.",
    cause_de="Jeder dieser Läufe wurde mit einem anderen Wert nur dieser Dimension wiederholt und "
    "hatte gleiche Ereignisse und Messwerte.",
    name=("the dimension", "die Dimension"),
    count=("the number of the repeated runs", "die Zahl der wiederholten Läufe"),
)
UNCHANGED_RUN_BROKEN = warning(
    901942,
    en="the run without any injection already fails: {broken}",
    de="schon der Lauf ohne Eingriff scheitert: {broken}",
    remedy_en="Correct program or expectation first: each injection would show the same.",
    remedy_de="Zuerst Programm oder Erwartung berichtigen: jeder Eingriff würde dasselbe zeigen.",
    broken=("what does not hold", "was verletzt ist"),
)
NOTHING_MEASURED = warning(
    901393,
    en="{measure} has no value in any of the {count} runs of the search",
    de="{measure} hat in keinem der {count} Läufe der Suche einen Wert",
    remedy_en="Run the plan without find: its summary says why.",
    remedy_de="Den Plan ohne find ausführen: seine Zusammenfassung nennt den Grund.",
    measure=("the measure", "die Messgröße"),
    count=("the number of runs", "die Zahl der Läufe"),
)
UPLOAD_TOO_LARGE = error(
    901484,
    en="{file} is too large: at most {limit} MB of files can be sent with the runs",
    de="{file} ist zu groß: mit den Läufen lassen sich höchstens {limit} MB an Dateien senden",
    remedy_en="Copy it to the workers beforehand, or send only the files that the runs need.",
    remedy_de="Es vorher auf die Worker kopieren oder nur die Dateien senden, die die Läufe "
    "brauchen.",
    file=("the file or folder", "die Datei oder der Ordner"),
    limit=("the limit in MB", "die Grenze in MB"),
)
WORKER_UNFIT = error(
    901485,
    en="{worker} cannot make the runs: {reason}",
    de="{worker} kann die Läufe nicht ausführen: {reason}",
    remedy_en="Install the same on scheduler and workers as here; --upload FILE.whl sends packages "
    "for the PLC.",
    remedy_de="Auf Scheduler und Workern dasselbe installieren wie hier; --upload DATEI.whl "
    "sendet, was die SPS braucht.",
    worker=("the worker or the scheduler", "der Worker oder der Scheduler"),
)
WORKER_NOT_STARTED = error(
    901486,
    en="a process for the runs does not start: {reason}",
    de="ein Prozess für die Läufe startet nicht: {reason}",
    remedy_en="Memory may be short: use fewer processes (-j 1); --resume keeps finished runs.",
    remedy_de="Vielleicht fehlt Speicher: weniger Prozesse verwenden (-j 1); --resume behält "
    "fertige Läufe.",
)
RUN_WITHOUT_TRACE = error(
    901350,
    en="the run has no trace in memory",
    de="der Lauf hat keine Aufzeichnung im Speicher",
    remedy_en="Run with memory_trace=True, which is the default.",
    remedy_de="Mit memory_trace=True laufen lassen; das ist die Voreinstellung.",
)
INVALID_CORPUS = error(
    902530,
    en="this is not a line of a corpus of --cover",
    de="das ist keine Zeile eines Korpus von --cover",
    remedy_en="Delete the line, or name another file; --corpus writes each line as a JSON object.",
    remedy_de="Die Zeile löschen oder eine andere Datei angeben; --corpus schreibt jede Zeile als "
    "JSON-Objekt.",
)
IMPOSSIBLE_RUNS = warning(
    902531,
    en="runs that were not possible: {count}; the first of them reported the finding above",
    de="nicht mögliche Läufe: {count}; der erste davon meldete den Befund darüber",
    count=("the number of runs", "die Zahl der Läufe"),
)
INVALID_SAMPLE = error(
    902532,
    en="{value} is not a value that can be drawn",
    de="{value} ist kein Wert, der gezogen werden kann",
    remedy_en="Write a number with a decimal point, or a time such as 20 ms for times; # begins a "
    "line that is skipped.",
    remedy_de="Eine Zahl mit Dezimalpunkt schreiben, für Zeiten etwa 20 ms; # beginnt eine Zeile, "
    "die übersprungen wird.",
)
SAMPLE_COLUMN_MISSING = error(
    902533,
    en="{file} has no column of samples named {name}; its columns: {names}",
    de="{file} hat keine Spalte mit Stichproben namens {name}; ihre Spalten: {names}",
    remedy_en="Name a column of its first row in the entry column; a file with a single column "
    "needs none.",
    remedy_de="Im Eintrag column eine Spalte der ersten Zeile nennen; eine Datei mit nur einer "
    "Spalte braucht keine.",
    names=("the columns of the file", "die Spalten der Datei"),
)
NO_PARTS = error(
    902534,
    en="{folder} does not hold the parts of one study; numbers of parts found: {counts}",
    de="{folder} enthält nicht die Teile genau einer Studie; gefundene Teilezahlen: {counts}",
    remedy_en="Use a folder that nctakt study --part I/N --out FOLDER has written, a separate one "
    "for each N.",
    remedy_de="Einen Ordner angeben, den nctakt study --part I/N --out ORDNER geschrieben hat, für "
    "jedes N einen eigenen.",
    counts=("the numbers of parts that were found", "die gefundenen Zahlen von Teilen"),
)
FOLDER_HAS_RESULTS = error(
    902690,
    en="{folder} has the results of an earlier study",
    de="{folder} hat die Ergebnisse einer früheren Studie",
    remedy_en="--resume continues it, if it has the same plan; otherwise name another folder.",
    remedy_de="Mit --resume weitermachen, wenn der Plan derselbe ist; sonst einen anderen Ordner "
    "angeben.",
)
ROWS_NOT_SHARED = error(
    902982,
    en="{missing} runs are not in {folder}: the processes that made them write to another place",
    de="{missing} Läufe sind nicht in {folder}: ihre Prozesse schreiben an einen anderen Ort",
    remedy_en="Name a folder that all workers and this command share, or object storage.",
    remedy_de="Einen Ordner angeben, den alle Worker und dieser Befehl gemeinsam haben, oder einen "
    "Objektspeicher.",
    missing=("how many runs", "wie viele Läufe"),
)
PARTS_MISSING = warning(
    902535,
    en="the study in {folder} lacks these parts: {names}; the report covers only the others",
    de="der Studie in {folder} fehlen diese Teile: {names}; der Bericht enthält nur die übrigen",
    names=("the numbers of the parts", "die Nummern der Teile"),
)
FAULTS_OF_STRUCTURED_PLC = error(
    902670,
    en="faults can be injected only into a PLC in Python, not into {file}",
    de="Fehler lassen sich nur in eine SPS in Python einspielen, nicht in {file}",
    remedy_en='Vary its inputs instead: time_of = "MAIN.bSensor = 1".',
    remedy_de='Stattdessen ihre Eingänge variieren: time_of = "MAIN.bSensor = 1".',
)
