# SPDX-License-Identifier: MIT
"""Messages about the command line and the kind of a run."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note
from nctakt.messages.extras import install_command

COMPILED_PART_MISSING = error(
    900530,
    en="the realtime part is not compiled here, so --compiled is not possible",
    de="der Echtzeit-Teil ist hier nicht übersetzt, daher ist --compiled nicht möglich",
    remedy_en="Install nctakt where a C compiler is available, or omit --compiled.",
    remedy_de="nctakt dort installieren, wo es einen C-Compiler gibt, oder --compiled weglassen.",
)
RUNNING_UNCOMPILED = note(
    900531,
    en="the realtime part is not compiled here; results are the same, runs take longer",
    de="der Echtzeit-Teil ist hier nicht übersetzt; die Ergebnisse sind gleich, die Läufe dauern "
    "länger",
    remedy_en="Install nctakt where a C compiler is available.",
    remedy_de="nctakt dort installieren, wo es einen C-Compiler gibt.",
)
RECORDING_WITHOUT_TRACE = error(
    900817,
    en="{option} selects signals, but no trace is recorded",
    de="{option} wählt aus, was aufgezeichnet wird, aber es gibt keine Aufzeichnung",
    remedy_en="Name a file for the trace: --trace out.csv; --signals chooses for --plot, too.",
    remedy_de="Eine Datei für die Aufzeichnung angeben: --trace out.csv; --signals wählt auch für "
    "--plot aus.",
)
WAITING_AT_RUN_LIMIT = note(
    900820,
    en="at the limit of the run the program is waiting for {awaited}",
    de="an der Grenze des Laufs wartet das Programm auf {awaited}",
    remedy_en="{freed_by}. Another limit: --until, --ticks.",
    remedy_de="{freed_by}. Eine andere Grenze: --until, --ticks.",
    awaited=("what is waited for", "worauf gewartet wird"),
    freed_by=("what lets the program continue", "was das Programm weiterlaufen lässt"),
)
WAITS_FOREVER = error(
    902000,
    en="after {limit} of the machine's time the program is still waiting for {awaited}",
    de="nach {limit} Maschinenzeit wartet das Programm immer noch auf {awaited}",
    remedy_en="{freed_by}. If the run should end there, set a limit: --until, --ticks.",
    remedy_de="{freed_by}. Soll der Lauf dort enden, eine Grenze setzen: --until, --ticks.",
    cause_en="No limit is set, so the run was meant to end with its program.",
    cause_de="Es ist keine Grenze gesetzt; der Lauf sollte also mit seinem Programm enden.",
    limit=("the limit of runs without one", "die Grenze von Läufen ohne eigene"),
    awaited=("what is waited for", "worauf gewartet wird"),
    freed_by=("what lets the program continue", "was das Programm weiterlaufen lässt"),
)
LISTING_INCOMPLETE = note(
    900590,
    en="the listing ends at the limit of the run, tick {ticks}; blocks decoded later are missing",
    de="die Auflistung endet an der Grenze des Laufs, Takt {ticks}; später dekodierte Sätze fehlen",
    remedy_en="Set another limit with --until or --ticks.",
    remedy_de="Mit --until oder --ticks eine andere Grenze setzen.",
    ticks=("the number of ticks that were run", "die Anzahl der gelaufenen Takte"),
)
NO_CYCLE_DEFINED = note(
    900591,
    en="no realtime cycle was defined",
    de="es wurde kein Echtzeit-Zyklus definiert",
    remedy_en="Branches that are not taken are not decoded: --set gives variables other values.",
    remedy_de="Nicht durchlaufene Zweige werden nicht dekodiert: --set gibt Variablen andere "
    "Werte.",
)
INVALID_SKIP_OPTION = error(
    21655,
    classes=(0, 0),
    known_as=(900490,),
    en="{found} is not a skip level",
    de="{found} ist keine Ausblendebene",
    remedy_en="Levels are whole numbers from 1 to {maximum}, separated by commas: --skip 1,3",
    remedy_de="Ebenen sind ganze Zahlen von 1 bis {maximum}, durch Kommas getrennt: --skip 1,3",
    maximum=("the highest level", "die höchste Ebene"),
)
UNKNOWN_OPTION = error(
    900907,
    en="unknown option {option}",
    de="unbekannte Option {option}",
    remedy_en="Did you mean {nearest}? All options: {help}",
    remedy_de="War {nearest} gemeint? Alle Optionen: {help}",
)
INVALID_OPTION_VALUE = error(
    900908,
    en="{value} is not a valid value for {name}",
    de="{value} ist kein gültiger Wert für {name}",
    remedy_en="Expected: {expected}. More: {help}",
    remedy_de="Erwartet: {expected}. Mehr: {help}",
    name=("the option or argument", "die Option oder das Argument"),
    expected=("the possible values", "die möglichen Werte"),
)
INVALID_COMMAND_LINE = error(
    900909,
    en="the command line is not valid: {reason}",
    de="die Befehlszeile ist ungültig: {reason}",
    remedy_en="{help} shows what is possible.",
    remedy_de="Was möglich ist, zeigt {help}.",
)
ARGUMENT_MISSING = error(
    900910,
    en="{name} is missing",
    de="{name} fehlt",
    remedy_en="Add it after the command. More: {help}",
    remedy_de="Nach dem Befehl angeben. Mehr: {help}",
    name=("the option or argument", "die Option oder das Argument"),
)
OPTION_VALUE_MISSING = error(
    900911,
    en="the value after {option} is missing on the command line",
    de="in der Befehlszeile fehlt der Wert nach {option}",
    remedy_en="Add the value after the option. More: {help}",
    remedy_de="Den Wert nach der Option angeben. Mehr: {help}",
)
OPTION_REPEATED = error(
    902953,
    en="{option} is given more than once; only the last value would count",
    de="{option} ist mehrmals angegeben; nur der letzte Wert würde gelten",
    remedy_en="Keep only the one that you need.",
    remedy_de="Nur den Wert angeben, der gelten soll.",
)
UNKNOWN_SUBCOMMAND = error(
    900912,
    en="unknown command {word}",
    de="unbekannter Befehl {word}",
    remedy_en="Did you mean {nearest}? Commands: {names}.",
    remedy_de="War {nearest} gemeint? Befehle: {names}.",
    names=("the commands", "die Befehle"),
)
WATCH_LIBRARY_MISSING = error(
    901067,
    en="--watch needs the library watchfiles, which is not installed",
    de="--watch braucht die Bibliothek watchfiles, die nicht installiert ist",
    remedy_en=f"Install it: {install_command('watch')}",
    remedy_de=f"Installieren: {install_command('watch')}",
)
WATCH_OF_STDIN = error(
    901068,
    en="--watch needs files; standard input comes only once",
    de="--watch braucht Dateien; die Standardeingabe kommt nur einmal",
    remedy_en="Name the file instead of '-'.",
    remedy_de="Statt '-' die Datei nennen.",
)
WATCHING_FILES = note(
    901069,
    en="watching {count} files for changes; stop with Ctrl-C",
    de="{count} Dateien werden auf Änderungen überwacht; Ende mit Strg-C",
    count=("the number of files that were read", "die Anzahl der gelesenen Dateien"),
)
NO_DIAGNOSIS_DATA = note(
    901040,
    en="no channel of the machine has realtime cycles, so there is no diagnosis data",
    de="kein Kanal der Maschine hat Echtzeit-Zyklen, also gibt es keine Diagnosedaten",
    remedy_en="Write configuration.rt_cycles.enable 1 (P-CHAN-00406) in the channel list.",
    remedy_de="configuration.rt_cycles.enable 1 (P-CHAN-00406) in die Kanalliste schreiben.",
)
RUN_NOT_ENDED = error(
    901016,
    en="the run reached its limit, {time}, before the program ended",
    de="der Lauf hat seine Grenze, {time}, vor dem Programmende erreicht",
    remedy_en="Set another limit (--until, --ticks), or find out what the program waits for.",
    remedy_de="Eine andere Grenze setzen (--until, --ticks) oder herausfinden, worauf das Programm "
    "wartet.",
    time=("how long the run lasted", "die Dauer des Laufs"),
)
OPTION_OF_OTHERS = error(
    902380,
    en="{option} cannot be set in {front_end}",
    de="{option} lässt sich nicht angeben in: {front_end}",
    remedy_en="It can be set in: {others}.",
    remedy_de="Es lässt sich angeben in: {others}.",
    option=("the run option", "die Option des Laufs"),
    front_end=("the command, the file or the function", "der Befehl, die Datei oder die Funktion"),
    others=("what accepts the option, and how", "was die Option annimmt, und wie"),
)
COMMAND_RENAMED = note(
    902381,
    en="nctakt {name} is now called nctakt {new_name}",
    de="nctakt {name} heißt jetzt nctakt {new_name}",
    remedy_en="Use the new name; the next version drops the old one.",
    remedy_de="Den neuen Namen verwenden; der alte entfällt mit der nächsten Version.",
    name=("the old name", "der alte Name"),
    new_name=("the new name", "der neue Name"),
)
