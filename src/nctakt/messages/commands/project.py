# SPDX-License-Identifier: MIT
"""Messages about the project file and the machine that programs run on."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note

_ENTRY = ("the entry", "der Eintrag")
_REASON = (
    "who owns it, or that others may write to it",
    "wem es gehört, oder dass andere es ändern dürfen",
)
_LIST = ("the file with the trusted folders", "die Datei mit den vertrauenswürdigen Ordnern")

INVALID_PROJECT_FILE = error(
    901060,
    en="the project file is not valid TOML: {reason}",
    de="die Projektdatei ist kein gültiges TOML: {reason}",
    remedy_en='Correct the text; entries look like this: machine = "lists"',
    remedy_de='Den Text berichtigen; Einträge sehen so aus: machine = "listen"',
    reason=("the error of the TOML reader", "der Fehler beim Lesen von TOML"),
)
UNKNOWN_PROJECT_ENTRY = error(
    901061,
    en="project file: unknown entry {key}",
    de="Projektdatei: unbekannter Eintrag {key}",
    remedy_en="Did you mean {nearest}? Possible entries: {names}.",
    remedy_de="War {nearest} gemeint? Mögliche Einträge: {names}.",
    names=("the possible entries", "die möglichen Einträge"),
)
INVALID_PROJECT_VALUE = error(
    901062,
    en="project file: {key}: {value} is not {expected}",
    de="Projektdatei: {key}: {value} ist nicht {expected}",
    remedy_en="Write it like this: {example}",
    remedy_de="So schreiben: {example}",
    example=("an example", "ein Beispiel"),
)
PROJECT_PATH_MISSING = error(
    901063,
    en="project file: {key}: {path} does not exist",
    de="Projektdatei: {key}: {path} gibt es nicht",
    remedy_en="Paths are relative to the folder of the project file.",
    remedy_de="Pfade gehen vom Ordner der Projektdatei aus.",
)
PROJECT_NOT_TRUSTED = error(
    902025,
    en="project file: {key} is not run: {reason}",
    de="Projektdatei: {key} wird nicht ausgeführt: {reason}",
    remedy_en="If you trust it, use --trust, add {folder} to {list}, or name the file yourself.",
    remedy_de="Bei Vertrauen --trust verwenden, {folder} in {list} eintragen oder die Datei "
    "selbst angeben.",
    cause_en="Code of a project is run only if it, the project file and their folders belong to "
    "you or to root, and no one else can write to them.",
    cause_de="Code eines Projekts wird nur ausgeführt, wenn er, die Projektdatei und deren Ordner "
    "dem Benutzer oder root gehören und niemand sonst sie ändern darf.",
    key=_ENTRY,
    reason=_REASON,
    folder=("the folder of the project", "der Ordner des Projekts"),
    list=_LIST,
)
PLAN_NOT_TRUSTED = error(
    902970,
    en="the plan: {key} is not run: {reason}",
    de="der Plan: {key} wird nicht ausgeführt: {reason}",
    remedy_en="If you trust the plan, use --trust, or add {folder} to {list}.",
    remedy_de="Bei Vertrauen in den Plan --trust verwenden oder {folder} in {list} eintragen.",
    cause_en="Code of a plan is run only if it, the plan and their folders belong to you or to "
    "root, and no one else can write to them.",
    cause_de="Code eines Plans wird nur ausgeführt, wenn er, der Plan und deren Ordner dem "
    "Benutzer oder root gehören und niemand sonst sie ändern darf.",
    key=_ENTRY,
    reason=_REASON,
    folder=("the folder of the plan", "der Ordner des Plans"),
    list=_LIST,
)
TESTS_NOT_TRUSTED = error(
    902971,
    en="no test is run, because pytest would use {file}: {reason}",
    de="kein Test wird ausgeführt, denn pytest würde {file} verwenden: {reason}",
    remedy_en="If you trust it, use --trust, or add {folder} to {list}.",
    remedy_de="Bei Vertrauen --trust verwenden oder {folder} in {list} eintragen.",
    cause_en="pytest runs conftest.py and takes its settings from folders above the tests, too, "
    "such as /tmp, where anybody may have written them.",
    cause_de="pytest führt conftest.py auch aus Ordnern über den Tests aus und liest dort seine "
    "Einstellungen, etwa in /tmp, wo sie von jedem stammen können.",
    reason=_REASON,
    folder=("its folder", "dessen Ordner"),
    list=_LIST,
)
PLC_NOT_RUN = note(
    902026,
    en="the PLC of the project, {plc}, is not run: this command runs no code of a project",
    de="die SPS des Projekts, {plc}, läuft nicht: dieser Befehl führt keinen fremden Code aus",
    remedy_en="Give --plc {plc} to run it.",
    remedy_de="Mit --plc {plc} wird sie ausgeführt.",
    plc=("the file", "die Datei"),
)
FMU_NOT_RUN = note(
    902613,
    en="the FMU of the project, {fmu}, is not run: this command runs no code of others",
    de="die FMU des Projekts, {fmu}, läuft nicht: dieser Befehl führt keinen fremden Code aus",
    remedy_en="Give --fmu {fmu} to run it.",
    remedy_de="Mit --fmu {fmu} wird sie ausgeführt.",
    fmu=("the file", "die Datei"),
)
PROJECT_FMU_NOT_POSSIBLE = error(
    902614,
    en="project file: an FMU runs only in tests and in commands that run a program to its end",
    de="Projektdatei: eine FMU läuft nur in Tests und in Befehlen, die ein Programm bis zum Ende "
    "ausführen",
    remedy_en="Record the run (nctakt run --record part.tape), and open the tape here.",
    remedy_de="Den Lauf aufzeichnen (nctakt run --record teil.tape) und hier das Band öffnen.",
)
MACHINE_OF_SETTING = note(
    901064,
    en="the machine is {machine}, as {source} says",
    de="die Maschine ist {machine}, wie {source} es angibt",
    remedy_en="--machine FOLDER selects another machine, --machine demo the built-in one.",
    remedy_de="--machine ORDNER wählt eine andere, --machine demo die eingebaute.",
    machine=("the folder with its lists", "der Ordner mit ihren Listen"),
    source=(
        "the project file or the environment variable",
        "die Projektdatei oder die Umgebungsvariable",
    ),
)
RUN_ON_MACHINE_OF_FILE = note(
    900816,
    en="the program runs on the machine of {file}",
    de="das Programm läuft auf der Maschine von {file}",
    remedy_en="--machine FOLDER selects another machine, --machine demo the built-in one.",
    remedy_de="--machine ORDNER wählt eine andere, --machine demo die eingebaute.",
    file=(
        "the start-up list in whose folder the program lies",
        "die Hochlaufliste, in deren Ordner das Programm liegt",
    ),
)
RUN_ON_DEMO_MACHINE = note(
    902944,
    en="the program runs on the demo machine: {file} has no usual name of a start-up list",
    de="das Programm läuft auf der Demo-Maschine: {file} heißt nicht wie eine Hochlaufliste",
    remedy_en="By its entries it is one: --machine {file}, or name it so in nctakt.toml.",
    remedy_de="Nach ihren Einträgen ist sie eine: --machine {file}, oder so in nctakt.toml nennen.",
    file=("the list beside the program", "die Liste neben dem Programm"),
)
MACHINE_BESIDE_PROGRAM = note(
    902967,
    en="the program runs on the demo machine, not on that of {file}",
    de="das Programm läuft auf der Demo-Maschine, nicht auf der von {file}",
    remedy_en="--machine {folder} takes that one; nctakt init makes it the machine of the project.",
    remedy_de="--machine {folder} nimmt diese; nctakt init macht sie zur Maschine des Projekts.",
    file=("the start-up list near the program", "die Hochlaufliste in der Nähe des Programms"),
    folder=("its folder", "ihr Ordner"),
)
PROGRAMS_OF_DIFFERENT_MACHINES = error(
    901065,
    en="the programs belong to different machines: {first} runs on {machine}, {second} on {other}",
    de="die Programme gehören zu verschiedenen Maschinen: {first} läuft auf {machine}, {second} "
    "auf {other}",
    remedy_en="Name the machine for all of them: --machine FOLDER",
    remedy_de="Die Maschine für alle angeben: --machine ORDNER",
    first=("the first program", "das erste Programm"),
    machine=("its machine", "seine Maschine"),
    second=("another program", "ein anderes Programm"),
    other=("the machine of the other program", "dessen Maschine"),
)
FILE_KEPT = note(
    902382,
    en="{file} already exists and is not changed",
    de="{file} gibt es schon und bleibt, wie sie ist",
    remedy_en="Delete it first to have it written again.",
    remedy_de="Sie vorher löschen, damit sie neu geschrieben wird.",
)
TAKEN_AS_STARTUP_LIST = note(
    902942,
    en="{file} is taken as the start-up list by its entries; no list has a usual name",
    de="{file} gilt nach ihren Einträgen als Hochlaufliste; keine Liste heißt wie üblich",
    remedy_en="Name it for other folders: --machine {file}; {names} are found without that.",
    remedy_de="Sie anderswo mit --machine {file} nennen; {names} werden ohne das gefunden.",
    names=("the usual names", "die üblichen Namen"),
)
NO_STARTUP_LIST = error(
    902943,
    en="{folder} has {count} lists, but no start-up list: none has such entries",
    de="{folder} enthält {count} Listen, aber keine Hochlaufliste: keine hat solche Einträge",
    remedy_en="Copy it there, too ({names}): without it programs run on the demo machine.",
    remedy_de="Auch sie dorthin kopieren ({names}): ohne sie laufen Programme auf der "
    "Demo-Maschine.",
    count=("the number of lists", "die Anzahl der Listen"),
    names=("the usual names", "die üblichen Namen"),
)
NO_LISTS_OR_PROGRAMS = error(
    902383,
    en="{folder} has neither lists nor programs",
    de="{folder} enthält weder Listen noch Programme",
    remedy_en="Name the folder that has them, or begin with a machine of nctakt: nctakt new FOLDER",
    remedy_de="Den Ordner nennen, der sie enthält, oder mit einer Maschine von nctakt beginnen: "
    "nctakt new ORDNER",
)
