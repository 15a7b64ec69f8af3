# SPDX-License-Identifier: MIT
"""Messages about checked programs: control statements and realtime cycles."""

from __future__ import annotations

from nctakt.messages.cases import by_beginning
from nctakt.messages.catalogue import error

FREQUENCY_OUTSIDE_REALTIME_CYCLE = error(
    900222,
    known_as=(20212, 21039),
    en="{word}: ONCE, EDGE and ALWAYS belong in a realtime cycle",
    de="{word}: ONCE, EDGE und ALWAYS gehören in einen Echtzeit-Zyklus",
    remedy_en="Remove the word, or move the $IF into #RT CYCLE … #RT CYCLE END.",
    remedy_de="Das Wort entfernen oder das $IF in #RT CYCLE … #RT CYCLE END verschieben.",
)
LOOP_CONTROL_OUTSIDE_LOOP = error(
    20243,
    classes=(0, 0),
    known_as=(900223,),
    cases=by_beginning("word", {"$CONTINUE": 20244}),
    en="{word} is not inside a loop that it could leave or repeat",
    de="{word} steht nicht in einer Schleife, die es verlassen oder wiederholen könnte",
    remedy_en="Put it in a loop; $BREAK also ends a $CASE.",
    remedy_de="In eine Schleife setzen; $BREAK beendet auch ein $CASE.",
)
DUPLICATE_KEYWORD = error(
    21887,
    classes=(0, 0),
    known_as=(900224, 21537),
    cases=by_beginning(
        "command",
        {"#MSG": 21710, "L": 21379, "#ROTATION": 22155, "#SLOPE": 21569, "#OVERRIDE": 21420},
    ),
    en="{command}: the keyword {word} is given twice",
    de="{command}: das Schlüsselwort {word} ist doppelt angegeben",
    remedy_en="Keep one of them.",
    remedy_de="Eines davon behalten.",
)
INVALID_KEYWORD_VALUE = error(
    900225,
    known_as=(21948, 22260),
    en="{word} = {value} is not valid",
    de="{word} = {value} ist nicht gültig",
    remedy_en="Possible values: {names}",
    remedy_de="Mögliche Werte: {names}",
    value=("the value as written, or –", "der Wert, wie geschrieben, oder –"),
    names=("the possible values", "die möglichen Werte"),
)
CYCLE_COMMAND_WITHOUT_ID = error(
    900226,
    known_as=(22003,),
    en="#RT CYCLE {action} needs an ID",
    de="#RT CYCLE {action} braucht eine ID",
    remedy_en="Write #RT CYCLE {action} [ID=1] with the ID of the definition.",
    remedy_de="#RT CYCLE {action} [ID=1] mit der ID der Definition schreiben.",
    action=("the management command", "der Verwaltungsbefehl"),
)
TEXT_IN_REALTIME_CYCLE = error(
    21981,
    en="{name} is a text, which a realtime cycle can only compare and assign",
    de="{name} ist ein Text; ein Echtzeit-Zyklus kann ihn nur vergleichen und zuweisen",
    remedy_en="Use only ==, != and = with texts; for anything else use a variable that holds a "
    "number.",
    remedy_de="Texte nur mit ==, != und = verwenden, sonst eine Variable, die eine Zahl enthält.",
    cause_en="Code that runs in each tick takes a bounded time; the decoder does everything else "
    "with texts. The controller has no texts in realtime cycles at all.",
    cause_de="Was in jedem Takt läuft, darf nur begrenzt lange dauern; alles andere mit Texten ist "
    "Sache des Dekoders. Die Steuerung kennt in Echtzeit-Zyklen gar keine Texte.",
    name=("the variable or text", "die Variable oder der Text"),
)
TEXT_OF_ANOTHER_LENGTH = error(
    901079,
    en="{value} has {other} bytes and {name} has {size}: a realtime cycle assigns only strings of "
    "the same length",
    de="{value} hat {other} Bytes und {name} hat {size}: ein Echtzeit-Zyklus weist nur "
    "Zeichenketten gleicher Länge zu",
    remedy_en="Give both variables one type and size: P-EXTV-00003 and P-EXTV-00008.",
    remedy_de="Beiden Variablen denselben Typ und dieselbe Größe geben: P-EXTV-00003 und "
    "P-EXTV-00008.",
    cause_en="In the tick nothing checks whether a text fits.",
    cause_de="Im Takt prüft nichts, ob ein Text passt.",
    value=("the assigned variable", "die zugewiesene Variable"),
    other=("its bytes", "ihre Bytes"),
    name=("the target", "das Ziel"),
    size=("the bytes of the target", "die Bytes des Ziels"),
)
REALTIME_CYCLES_OFF = error(
    21982,
    en="{command}: realtime cycles are off in this channel (P-CHAN-00406)",
    de="{command}: Echtzeit-Zyklen sind in diesem Kanal ausgeschaltet (P-CHAN-00406)",
    remedy_en="Write configuration.rt_cycles.enable 1 in the channel list and restart.",
    remedy_de="configuration.rt_cycles.enable 1 in die Kanalliste schreiben und neu starten.",
    cause_en="Without an entry in the channel list they are off; a change takes effect at the next "
    "start.",
    cause_de="Ohne Eintrag in der Kanalliste sind sie ausgeschaltet; eine Änderung wirkt ab dem "
    "nächsten Start.",
)
INVALID_GLOBAL_CYCLE_ID = error(
    21983,
    en="the ID of a GLOBAL realtime cycle must be above 0, not {id}",
    de="die ID eines GLOBAL-Echtzeit-Zyklus muss größer als 0 sein, nicht {id}",
    remedy_en="Give it a whole number of at least 1.",
    remedy_de="Eine ganze Zahl ab 1 angeben.",
    cause_en="A GLOBAL cycle outlives its program; later it can be held or deleted only by its ID.",
    cause_de="Ein GLOBAL-Zyklus überlebt sein Programm; später lässt er sich nur über seine ID "
    "anhalten oder löschen.",
)
VALUE_LIST_IN_CYCLE = error(
    22001,
    en="a list of values cannot be assigned to {name} in a realtime cycle",
    de="{name} kann im Echtzeit-Zyklus keine Werteliste zugewiesen werden",
    remedy_en="Assign member by member, or assign the list before the cycle.",
    remedy_de="Element für Element zuweisen oder die Liste vor dem Zyklus zuweisen.",
    cause_en="An assignment stores one number per tick, so that the run time of a cycle is known.",
    cause_de="Eine Zuweisung speichert je Takt eine Zahl, damit die Laufzeit eines Zyklus bekannt "
    "ist.",
    name=("the structure or array", "die Struktur oder das Feld"),
)
COMMAND_NOT_ALLOWED_IN_CYCLE = error(
    22002,
    known_as=(21950, 21952, 21957),
    en="{command} is not possible in a realtime cycle",
    de="{command} ist in einem Echtzeit-Zyklus nicht möglich",
    remedy_en="Possible are $IF, assignments, M and H functions, spindle and axis commands, #TIMER "
    "and #ERROR.",
    remedy_de="Möglich sind $IF, Zuweisungen, M- und H-Funktionen, Spindel- und Achsbefehle, "
    "#TIMER und #ERROR.",
    cause_en="A realtime cycle runs to its end in every tick: nothing in it can jump, wait or move "
    "the path.",
    cause_de="Ein Echtzeit-Zyklus läuft in jedem Takt bis zu seinem Ende: nichts darin kann "
    "springen, warten oder die Bahn bewegen.",
)
CYCLE_WITHOUT_ID = error(
    22003,
    en="a realtime cycle with {word} needs an ID",
    de="ein Echtzeit-Zyklus mit {word} braucht eine ID",
    remedy_en="Write ID=1 or another whole number in the brackets.",
    remedy_de="ID=1 oder eine andere ganze Zahl in die Klammern schreiben.",
    cause_en="Without an ID such a cycle could not be started or ended later.",
    cause_de="Ohne ID ließe sich ein solcher Zyklus später weder starten noch beenden.",
    word=("DEF or SCOPE=GLOBAL", "DEF oder SCOPE=GLOBAL"),
)
UNKNOWN_KEYWORD_IN_CYCLE = error(
    22004,
    en="{command} has no keyword {word} in a realtime cycle",
    de="{command} hat im Echtzeit-Zyklus kein Schlüsselwort {word}",
    remedy_en="Remove it.",
    remedy_de="Entfernen.",
    cause_en="The command is available in realtime cycles, but this part of it needs the decoder.",
    cause_de="Den Befehl gibt es im Echtzeit-Zyklus, aber dieser Teil davon braucht den Dekoder.",
)
TIMER_WITHOUT_SYN = error(
    22006,
    en="#TIMER in a realtime cycle needs the word SYN",
    de="#TIMER braucht im Echtzeit-Zyklus das Wort SYN",
    remedy_en="Write #TIMER {action} SYN.",
    remedy_de="#TIMER {action} SYN schreiben.",
    cause_en="Timers of the decoder run when blocks are decoded, ahead of the motion; those of "
    "cycles run with the ticks.",
    cause_de="Timer des Dekoders laufen beim Dekodieren, der Bewegung voraus; die der Zyklen "
    "laufen mit den Takten.",
    action=("START, STOP, READ or CLEAR", "START, STOP, READ oder CLEAR"),
)
ASYNCHRONOUS_WRITE_IN_CYCLE = error(
    22009,
    en="{name} is asynchronous and cannot be written in a realtime cycle",
    de="{name} ist asynchron und im Echtzeit-Zyklus nicht beschreibbar",
    remedy_en="V.E and V.CH: set synchronisation TRUE in the variables list, or use Vs. for this "
    "block.",
    remedy_de="V.E und V.CH: synchronisation TRUE in der Variablenliste setzen, oder Vs. für "
    "diesen Satz.",
    cause_en="An asynchronous variable is read once, when the definition is decoded, and is a "
    "constant in the cycle from then on.",
    cause_de="Eine asynchrone Variable wird einmal gelesen, wenn die Definition dekodiert wird, "
    "und ist dann im Zyklus eine Konstante.",
)
ELSEIF_WITH_FREQUENCY = error(
    22021,
    en="$ELSEIF cannot have {word}",
    de="$ELSEIF kann kein {word} haben",
    remedy_en="Write a separate $IF {word} inside the branch.",
    remedy_de="Ein eigenes $IF {word} in den Zweig schreiben.",
    cause_en="ONCE, EDGE and ALWAYS keep a state for their own $IF; another branch would have "
    "none.",
    cause_de="ONCE, EDGE und ALWAYS halten einen Zustand für ihr eigenes $IF; ein weiterer Zweig "
    "hätte keinen.",
)
FREQUENCY_IF_WITH_ELSE = error(
    22022,
    en="$IF {word} cannot have $ELSEIF or $ELSE",
    de="$IF {word} kann weder $ELSEIF noch $ELSE haben",
    remedy_en="Close it first and write a second $IF.",
    remedy_de="Vorher schließen und ein zweites $IF schreiben.",
    cause_en="While an ALWAYS is latched or a ONCE is done, its condition is not evaluated: the "
    "other branch could never be decided.",
    cause_de="Solange ALWAYS eingerastet oder ONCE erledigt ist, wird die Bedingung nicht "
    "ausgewertet: über den anderen Zweig würde nie entschieden.",
    word=("ONCE, EDGE or ALWAYS", "ONCE, EDGE oder ALWAYS"),
)
FUNCTION_GIVEN_TO_AXIS_IN_CYCLE = error(
    901004,
    en="a realtime cycle cannot output an M or H function to an axis: {command}",
    de="ein Echtzeit-Zyklus kann keine M- oder H-Funktion an eine Achse ausgeben: {command}",
    remedy_en="Output the function of the channel here, or that of the axis in the program.",
    remedy_de="Hier die Funktion des Kanals ausgeben oder die der Achse im Programm.",
)
INVALID_CYCLE_ID = error(
    50875,
    en="{id} is not a valid ID of a realtime cycle",
    de="{id} ist keine gültige ID eines Echtzeit-Zyklus",
    remedy_en="IDs are whole numbers from 1 to 2147483647.",
    remedy_de="IDs sind ganze Zahlen von 1 bis 2147483647.",
    cause_en="An ID is a whole number from 1; expressions in it are computed when the block is "
    "decoded.",
    cause_de="Eine ID ist eine ganze Zahl ab 1; Ausdrücke darin werden beim Dekodieren des Satzes "
    "berechnet.",
    id=("the value of the ID", "der Wert der ID"),
    classes=(6, 6),
)
CYCLE_M_FUNCTION_NOT_DEFINED = error(
    50938,
    en="M{function} is not defined in the channel list",
    de="M{function} ist in der Kanalliste nicht definiert",
    remedy_en="Give it a synchronisation type there, for example m_synch[{function}] MOS",
    remedy_de="Dort eine Synchronisationsart angeben, zum Beispiel m_synch[{function}] MOS",
    cause_en="A cycle outputs functions to the PLC without waiting; only those of the channel list "
    "can be output.",
    cause_de="Ein Zyklus gibt Funktionen an die SPS aus, ohne zu warten; ausgeben lassen sich nur "
    "die der Kanalliste.",
    classes=(6, 6),
)
CYCLE_H_FUNCTION_NOT_DEFINED = error(
    50940,
    en="H{function} is not defined in the channel list",
    de="H{function} ist in der Kanalliste nicht definiert",
    remedy_en="Give it a synchronisation type there, for example h_synch[{function}] MOS",
    remedy_de="Dort eine Synchronisationsart angeben, zum Beispiel h_synch[{function}] MOS",
    cause_en="A cycle outputs functions to the PLC without waiting; only those of the channel list "
    "can be output.",
    cause_de="Ein Zyklus gibt Funktionen an die SPS aus, ohne zu warten; ausgeben lassen sich nur "
    "die der Kanalliste.",
    classes=(6, 6),
)
