# SPDX-License-Identifier: MIT
"""Messages of command line, files, PLC, stimuli (900500 … 900549, 900570 … 900599)."""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, NOTE, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_add(
    900500,
    ERROR,
    "{file} does not exist",
    "{file} gibt es nicht",
    remedy_en="Check the path; it is relative to the folder in which nctakt runs.",
    remedy_de="Den Pfad prüfen; er gilt ab dem Ordner, in dem nctakt läuft.",
    parameters={"file": "the path as it was given"},
)
_add(
    900501,
    ERROR,
    "{file} is a folder; a file is needed here",
    "{file} ist ein Ordner; hier wird eine Datei gebraucht",
    remedy_en="Name a file in the folder.",
    remedy_de="Eine Datei aus dem Ordner nennen.",
    parameters={"file": "the path as it was given"},
)
_add(
    900502,
    ERROR,
    "{folder} is neither a folder nor a list",
    "{folder} ist weder ein Ordner noch eine Liste",
    remedy_en="Name the folder that holds the machine's lists, or its start-up list.",
    remedy_de="Den Ordner mit den Listen der Maschine nennen, oder ihre Hochlaufliste.",
    parameters={"folder": "the path as it was given"},
)
_add(
    900503,
    ERROR,
    "{file} cannot be read: {reason}",
    "{file} kann nicht gelesen werden: {reason}",
    remedy_en="Check the rights of the file, and whether it is complete.",
    remedy_de="Die Rechte der Datei prüfen, und ob sie vollständig ist.",
    parameters={"file": "the path as it was given", "reason": "what the system says"},
)
_add(
    900504,
    ERROR,
    "standard input ('-') is named more than once",
    "die Standardeingabe ('-') ist mehrfach genannt",
    remedy_en="Name '-' once; further programs need files.",
    remedy_de="'-' einmal nennen; weitere Programme brauchen Dateien.",
)
_add(
    900506,
    ERROR,
    "{file}: the end of the name says no trace format",
    "{file}: die Endung nennt kein Format für Aufzeichnungen",
    remedy_en="Give the file the suffix {suffixes}.",
    remedy_de="Der Datei eine dieser Endungen geben: {suffixes}.",
    parameters={"file": "the path as it was given", "suffixes": "the suffixes that are known"},
)
_add(
    900507,
    ERROR,
    "{file} cannot be written: {reason}",
    "{file} kann nicht geschrieben werden: {reason}",
    remedy_en="Choose a folder that exists, with the right to write and room on the disk.",
    remedy_de="Einen vorhandenen Ordner mit Schreibrecht und freiem Platz wählen.",
    parameters={"file": "the path as it was given", "reason": "what the system says"},
)
_add(
    900508,
    ERROR,
    "{file} is no trace that nctakt has written",
    "{file} ist keine Aufzeichnung von nctakt",
    remedy_en="Name a file that nctakt run --trace made.",
    remedy_de="Eine Datei nennen, die nctakt run --trace geschrieben hat.",
    parameters={"file": "the path as it was given"},
)
_add(
    900510,
    ERROR,
    "'{text}' is no time",
    "'{text}' ist keine Zeit",
    remedy_en="Write a number from 0 on with us, ms, s or min, such as 1500us or 1.5ms; "
    "a number alone means seconds.",
    remedy_de="Eine Zahl ab 0 mit us, ms, s oder min schreiben, etwa 1500us oder 1.5ms; "
    "eine Zahl allein bedeutet Sekunden.",
    parameters={"text": "the time as it was given"},
)
_add(
    900511,
    ERROR,
    "'{text}' does not give a value to a variable",
    "'{text}' gibt keiner Variablen einen Wert",
    remedy_en="Write NAME=VALUE, such as V.E.VALUE=5.",
    remedy_de="NAME=WERT schreiben, etwa V.E.VALUE=5.",
    parameters={"text": "what was given"},
)
_add(
    900512,
    ERROR,
    "{name}: '{value}' is no value",
    "{name}: '{value}' ist kein Wert",
    remedy_en='Write a number, TRUE, FALSE or a text between "…".',
    remedy_de='Eine Zahl, TRUE, FALSE oder einen Text zwischen "…" schreiben.',
    parameters={"name": "the variable", "value": "the value as it was given"},
)
_add(
    900520,
    ERROR,
    "{file} has no class with a method cycle(self, hli)",
    "{file} hat keine Klasse mit einer Methode cycle(self, hli)",
    remedy_en="Define one class whose method cycle is called after each tick.",
    remedy_de="Eine Klasse definieren, deren Methode cycle nach jedem Takt aufgerufen wird.",
    parameters={"file": "the PLC's file"},
)
_add(
    900521,
    ERROR,
    "{file} has several classes with a method cycle: {names}",
    "{file} hat mehrere Klassen mit einer Methode cycle: {names}",
    remedy_en="Keep one; put an underscore in front of the names of the others.",
    remedy_de="Eine behalten; den Namen der anderen einen Unterstrich voranstellen.",
    parameters={"file": "the PLC's file", "names": "the classes"},
)
_add(
    900522,
    ERROR,
    "the PLC's file fails while it is loaded: {reason}\n{traceback}",
    "die Datei der SPS scheitert beim Laden: {reason}\n{traceback}",
    remedy_en="Correct the file at the line that stands last.",
    remedy_de="Die Datei an der zuletzt genannten Zeile berichtigen.",
    parameters={"reason": "the exception", "traceback": "the way to it, in the user's files"},
)
_add(
    900523,
    ERROR,
    "the PLC fails after tick {tick}: {reason}\n{traceback}",
    "die SPS scheitert nach Takt {tick}: {reason}\n{traceback}",
    remedy_en="Correct the PLC's file at the line that stands last.",
    remedy_de="Die Datei der SPS an der zuletzt genannten Zeile berichtigen.",
    parameters={
        "tick": "the tick that had just been run",
        "reason": "the exception",
        "traceback": "the way to it, in the user's files",
    },
)
_add(
    900530,
    ERROR,
    "the realtime part is not compiled here, so --compiled cannot be had",
    "der Echtzeit-Teil ist hier nicht übersetzt, --compiled ist nicht möglich",
    remedy_en="Install nctakt where a C compiler is present, or leave --compiled out.",
    remedy_de="nctakt mit einem C-Compiler installieren oder --compiled weglassen.",
)
_add(
    900531,
    NOTE,
    "the realtime part is not compiled here; the results are the same, it takes longer",
    "der Echtzeit-Teil ist hier nicht übersetzt; die Ergebnisse sind gleich, es dauert länger",
    remedy_en="Install nctakt where a C compiler is present.",
    remedy_de="nctakt mit einem C-Compiler installieren.",
)
_add(
    900817,
    ERROR,
    "{option} says what is recorded, and there is no trace",
    "{option} sagt, was aufgezeichnet wird, und es gibt keine Aufzeichnung",
    remedy_en="Name a file for it: --trace out.csv",
    remedy_de="Eine Datei dafür angeben: --trace out.csv",
    parameters={"option": "the option"},
)
_add(
    900820,
    NOTE,
    "at the limit of the run the program waits for {awaited_en}",
    "an der Grenze des Laufs wartet das Programm auf {awaited_de}",
    remedy_en="Give what it waits for at a time (--at 500ms HLI.START=1), or set another limit "
    "(--until, --ticks).",
    remedy_de="Geben, worauf es wartet (--at 500ms HLI.START=1), oder eine andere Grenze setzen "
    "(--until, --ticks).",
    parameters={
        "awaited_en": "what is waited for, in English",
        "awaited_de": "what is waited for, in German",
    },
)
_add(
    900816,
    NOTE,
    "the demo machine runs the program, not the machine of {file}",
    "das Programm läuft auf der Demo-Maschine, nicht auf der Maschine von {file}",
    remedy_en="--machine {folder} runs it on that one.",
    remedy_de="--machine {folder} lässt es auf jener laufen.",
    parameters={"file": "the start-up list around it", "folder": "a machine's folder"},
)
_add(
    900540,
    ERROR,
    "there is no variable {name}",
    "es gibt keine Variable {name}",
    remedy_en="See the machine's variables list for the names.",
    remedy_de="Die Namen stehen in der Variablenliste der Maschine.",
    parameters={"name": "the name"},
)
_add(
    900541,
    ERROR,
    "there is no variable {name}",
    "es gibt keine Variable {name}",
    remedy_en="Did you mean {nearest}?",
    remedy_de="War {nearest} gemeint?",
    parameters={"name": "the name", "nearest": "the nearest known name"},
)
_add(
    900542,
    ERROR,
    "{name} belongs to the controller and cannot be set from outside",
    "{name} gehört der Steuerung und kann nicht von außen gesetzt werden",
    remedy_en="Set V.E or V.CH variables; write V.RT* variables in a program or a realtime cycle.",
    remedy_de="V.E- oder V.CH-Variablen setzen; V.RT* in Programm oder Echtzeit-Zyklus schreiben.",
    parameters={"name": "the name"},
)
_add(
    900543,
    ERROR,
    "{name} of type {type} does not take the value {value}",
    "{name} vom Typ {type} nimmt den Wert {value} nicht",
    remedy_en="Give a number to a number, a text to a text.",
    remedy_de="Einer Zahl eine Zahl geben, einem Text einen Text.",
    parameters={"name": "the variable", "type": "its type", "value": "the value"},
)
_add(
    900544,
    ERROR,
    "there is no signal {name}",
    "es gibt kein Signal {name}",
    remedy_en="Signals are X.ACS.ACT_POS and its kin, PATH.SPEED, BLOCK, V.E and V.CH variables.",
    remedy_de="Signale sind X.ACS.ACT_POS und andere, PATH.SPEED, BLOCK, V.E- und V.CH-Variablen.",
    parameters={"name": "the name"},
)
_add(
    900545,
    ERROR,
    "there is no signal {name}",
    "es gibt kein Signal {name}",
    remedy_en="Did you mean {nearest}?",
    remedy_de="War {nearest} gemeint?",
    parameters={"name": "the name", "nearest": "the nearest known name"},
)
_add(
    900570,
    ERROR,
    "'{word}' is known to nobody here",
    "'{word}' kennt hier niemand",
    remedy_en="nctakt explain without a word lists what can be asked for.",
    remedy_de="nctakt explain ohne Wort zeigt, wonach gefragt werden kann.",
    parameters={"word": "the word as it was given"},
)
_add(
    900571,
    ERROR,
    "'{word}' is known to nobody here",
    "'{word}' kennt hier niemand",
    remedy_en="Did you mean {nearest}?",
    remedy_de="Ist {nearest} gemeint?",
    parameters={"word": "the word as it was given", "nearest": "the nearest known word"},
)
_add(
    900574,
    ERROR,
    "there is no realtime cycle {cycle} in this run",
    "es gibt in diesem Lauf keinen Echtzeit-Zyklus {cycle}",
    remedy_en="Name one of: {known}",
    remedy_de="Einen von diesen nennen: {known}",
    parameters={"cycle": "the ID that was given", "known": "the IDs of the run's cycles"},
)
_add(
    900575,
    ERROR,
    "line {line} belongs to no realtime cycle",
    "Zeile {line} gehört zu keinem Echtzeit-Zyklus",
    remedy_en="The nearest line that does is {nearest}",
    remedy_de="Die nächste Zeile, die zu einem gehört, ist {nearest}",
    parameters={"line": "the line that was given", "nearest": "the nearest line of a cycle"},
)
_add(
    900576,
    ERROR,
    "tick {tick} is not in the run, which went from tick {first} to tick {last}",
    "Takt {tick} liegt nicht im Lauf, der von Takt {first} bis Takt {last} ging",
    remedy_en="Give a time within the run.",
    remedy_de="Eine Zeit innerhalb des Laufs angeben.",
    parameters={"tick": "the tick", "first": "the run's first tick", "last": "its last tick"},
)
_add(
    900577,
    ERROR,
    "there is no realtime cycle {cycle}: this run has defined none",
    "es gibt keinen Echtzeit-Zyklus {cycle}: dieser Lauf hat keinen angelegt",
    remedy_en="Ask without a cycle to see which definitions were not reached.",
    remedy_de="Ohne Zyklus fragen, um zu sehen, welche Definitionen nicht erreicht wurden.",
    parameters={"cycle": "the ID that was given"},
)
_add(
    900578,
    ERROR,
    "line {line} belongs to no realtime cycle: the programs have none",
    "Zeile {line} gehört zu keinem Echtzeit-Zyklus: die Programme haben keinen",
    remedy_en="Name a program that defines realtime cycles.",
    remedy_de="Ein Programm nennen, das Echtzeit-Zyklen definiert.",
    parameters={"line": "the line that was given"},
)
_add(
    900590,
    NOTE,
    "the listing ends at the limit of the run, tick {ticks}; what is decoded later is missing",
    "die Auflistung endet an der Grenze des Laufs, Takt {ticks}; später Dekodiertes fehlt",
    remedy_en="Give another limit with --until or --ticks.",
    remedy_de="Mit --until oder --ticks eine andere Grenze setzen.",
    parameters={"ticks": "the ticks that were run"},
)
_add(
    900591,
    NOTE,
    "no realtime cycle was defined",
    "kein Echtzeit-Zyklus wurde definiert",
    remedy_en="Branches that were not taken are not decoded: --set gives variables other values.",
    remedy_de="Nicht genommene Zweige werden nicht dekodiert: --set gibt Variablen andere Werte.",
)
_add(
    900490,
    ERROR,
    "{found} is no skip level",
    "{found} ist keine Ausblendebene",
    remedy_en="Levels are whole numbers from 1 to {most}, with commas between: --skip 1,3",
    remedy_de="Ebenen sind ganze Zahlen von 1 bis {most}, mit Kommas dazwischen: --skip 1,3",
    parameters={"found": "the word as written", "most": "the highest level"},
)
_HELP = {"help": "the command that shows the help"}
_add(
    900907,
    ERROR,
    "there is no option {option}",
    "eine Option {option} gibt es nicht",
    remedy_en="Did you mean {nearest}? All options: {help}",
    remedy_de="War {nearest} gemeint? Alle Optionen: {help}",
    parameters={"option": "the option", "nearest": "the nearest known name", **_HELP},
)
_add(
    900908,
    ERROR,
    "{value} is no value for {name}",
    "{value} ist kein Wert für {name}",
    remedy_en="Give {expected}. More: {help}",
    remedy_de="Anzugeben ist {expected}. Mehr: {help}",
    parameters={
        "value": "the value as it was given",
        "name": "the option or argument",
        "expected": "what it takes",
        **_HELP,
    },
)
_add(
    900909,
    ERROR,
    "the words of the command cannot be used: {reason}",
    "die Wörter des Befehls sind nicht zu gebrauchen: {reason}",
    remedy_en="What can be said: {help}",
    remedy_de="Was möglich ist: {help}",
    parameters={"reason": "why", **_HELP},
)
_add(
    900910,
    ERROR,
    "{name} is missing",
    "{name} fehlt",
    remedy_en="Give it behind the command. More: {help}",
    remedy_de="Es hinter dem Befehl angeben. Mehr: {help}",
    parameters={"name": "the option or argument", **_HELP},
)
_add(
    900911,
    ERROR,
    "a value is missing behind {option} on the command line",
    "in der Befehlszeile fehlt hinter {option} ein Wert",
    remedy_en="Give the value behind the option. More: {help}",
    remedy_de="Den Wert hinter der Option angeben. Mehr: {help}",
    parameters={"option": "the option", **_HELP},
)
_add(
    900912,
    ERROR,
    "there is no command {word}",
    "einen Befehl {word} gibt es nicht",
    remedy_en="Did you mean {nearest}? There are {names}.",
    remedy_de="War {nearest} gemeint? Es gibt {names}.",
    parameters={
        "word": "the word as it was given",
        "nearest": "the nearest known name",
        "names": "the commands that there are",
    },
)
