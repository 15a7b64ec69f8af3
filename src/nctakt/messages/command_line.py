# SPDX-License-Identifier: MIT
"""Messages about the command line and the kind of a run."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note

COMPILED_PART_MISSING = error(
    900530,
    en="the realtime part is not compiled here, so --compiled cannot be had",
    de="der Echtzeit-Teil ist hier nicht übersetzt, --compiled ist nicht möglich",
    remedy_en="Install nctakt where a C compiler is present, or leave --compiled out.",
    remedy_de="nctakt mit einem C-Compiler installieren oder --compiled weglassen.",
)
RUNNING_UNCOMPILED = note(
    900531,
    en="the realtime part is not compiled here; the results are the same, it takes longer",
    de="der Echtzeit-Teil ist hier nicht übersetzt; die Ergebnisse sind gleich, es dauert länger",
    remedy_en="Install nctakt where a C compiler is present.",
    remedy_de="nctakt mit einem C-Compiler installieren.",
)
RECORDING_WITHOUT_TRACE = error(
    900817,
    en="{option} says what is recorded, and there is no trace",
    de="{option} sagt, was aufgezeichnet wird, und es gibt keine Aufzeichnung",
    remedy_en="Name a file for it: --trace out.csv",
    remedy_de="Eine Datei dafür angeben: --trace out.csv",
    option=("the option", "die Option"),
)
WAITING_AT_RUN_LIMIT = note(
    900820,
    en="at the limit of the run the program waits for {awaited}",
    de="an der Grenze des Laufs wartet das Programm auf {awaited}",
    remedy_en="Give what it waits for at a time (--at 500ms HLI.START=1), or set another limit "
    "(--until, --ticks).",
    remedy_de="Geben, worauf es wartet (--at 500ms HLI.START=1), oder eine andere Grenze setzen "
    "(--until, --ticks).",
    awaited=("what is waited for", "worauf gewartet wird"),
)
RUN_ON_DEMO_MACHINE = note(
    900816,
    en="the demo machine runs the program, not the machine of {file}",
    de="das Programm läuft auf der Demo-Maschine, nicht auf der Maschine von {file}",
    remedy_en="--machine {folder} runs it on that one.",
    remedy_de="--machine {folder} lässt es auf jener laufen.",
    file=("the start-up list around it", "die Hochlaufliste, in deren Ordner es liegt"),
    folder=("a machine's folder", "der Ordner einer Maschine"),
)
LISTING_INCOMPLETE = note(
    900590,
    en="the listing ends at the limit of the run, tick {ticks}; what is decoded later is missing",
    de="die Auflistung endet an der Grenze des Laufs, Takt {ticks}; später Dekodiertes fehlt",
    remedy_en="Give another limit with --until or --ticks.",
    remedy_de="Mit --until oder --ticks eine andere Grenze setzen.",
    ticks=("the ticks that were run", "die gelaufenen Takte"),
)
NO_CYCLE_DEFINED = note(
    900591,
    en="no realtime cycle was defined",
    de="kein Echtzeit-Zyklus wurde definiert",
    remedy_en="Branches that were not taken are not decoded: --set gives variables other values.",
    remedy_de="Nicht genommene Zweige werden nicht dekodiert: --set gibt Variablen andere Werte.",
)
INVALID_SKIP_OPTION = error(
    900490,
    en="{found} is no skip level",
    de="{found} ist keine Ausblendebene",
    remedy_en="Levels are whole numbers from 1 to {most}, with commas between: --skip 1,3",
    remedy_de="Ebenen sind ganze Zahlen von 1 bis {most}, mit Kommas dazwischen: --skip 1,3",
    found=("the word as written", "das Wort, wie geschrieben"),
    most=("the highest level", "die höchste Ebene"),
)
UNKNOWN_OPTION = error(
    900907,
    en="there is no option {option}",
    de="eine Option {option} gibt es nicht",
    remedy_en="Did you mean {nearest}? All options: {help}",
    remedy_de="War {nearest} gemeint? Alle Optionen: {help}",
    option=("the option", "die Option"),
    nearest=("the nearest known name", "der ähnlichste bekannte Name"),
    help=("the command that shows the help", "der Befehl, der die Hilfe zeigt"),
)
INVALID_OPTION_VALUE = error(
    900908,
    en="{value} is no value for {name}",
    de="{value} ist kein Wert für {name}",
    remedy_en="Give {expected}. More: {help}",
    remedy_de="Anzugeben ist {expected}. Mehr: {help}",
    value=("the value as it was given", "der Wert, wie angegeben"),
    name=("the option or argument", "die Option oder das Argument"),
    expected=("what it takes", "was es annimmt"),
    help=("the command that shows the help", "der Befehl, der die Hilfe zeigt"),
)
INVALID_COMMAND_LINE = error(
    900909,
    en="the words of the command cannot be used: {reason}",
    de="die Wörter des Befehls sind nicht zu gebrauchen: {reason}",
    remedy_en="What can be said: {help}",
    remedy_de="Was möglich ist: {help}",
    reason=("why", "warum"),
    help=("the command that shows the help", "der Befehl, der die Hilfe zeigt"),
)
ARGUMENT_MISSING = error(
    900910,
    en="{name} is missing",
    de="{name} fehlt",
    remedy_en="Give it behind the command. More: {help}",
    remedy_de="Es hinter dem Befehl angeben. Mehr: {help}",
    name=("the option or argument", "die Option oder das Argument"),
    help=("the command that shows the help", "der Befehl, der die Hilfe zeigt"),
)
OPTION_VALUE_MISSING = error(
    900911,
    en="a value is missing behind {option} on the command line",
    de="in der Befehlszeile fehlt hinter {option} ein Wert",
    remedy_en="Give the value behind the option. More: {help}",
    remedy_de="Den Wert hinter der Option angeben. Mehr: {help}",
    option=("the option", "die Option"),
    help=("the command that shows the help", "der Befehl, der die Hilfe zeigt"),
)
UNKNOWN_SUBCOMMAND = error(
    900912,
    en="there is no command {word}",
    de="einen Befehl {word} gibt es nicht",
    remedy_en="Did you mean {nearest}? There are {names}.",
    remedy_de="War {nearest} gemeint? Es gibt {names}.",
    word=("the word as it was given", "das Wort, wie angegeben"),
    nearest=("the nearest known name", "der ähnlichste bekannte Name"),
    names=("the commands that there are", "die Befehle, die es gibt"),
)
