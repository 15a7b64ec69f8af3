# SPDX-License-Identifier: MIT
"""Messages about realtime cycles while they run."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note

CYCLES_EXCEED_STEP_LIMIT = error(
    50854,
    en="the realtime cycles need {steps} elementary instructions in one tick; {limit} are allowed",
    de="die Echtzeit-Zyklen brauchen {steps} Elementar-Anweisungen in einem Takt; erlaubt sind "
    "{limit}",
    remedy_en="Shorten cycle {cycle} or another cycle, or increase rt_cycles.max_steps "
    "(P-CHAN-00427).",
    remedy_de="Zyklus {cycle} oder andere kürzen oder rt_cycles.max_steps (P-CHAN-00427) erhöhen.",
    cause_en="Each operator, function, variable, assignment, condition and action counts as one; "
    "nctakt disassemble shows the counts.",
    cause_de="Jeder Operator, jede Funktion, Variable, Zuweisung, Bedingung und Aktion zählt als "
    "eine; nctakt disassemble zeigt die Zahlen.",
    steps=("the number of instructions so far", "die Anzahl der Anweisungen bis dahin"),
    classes=(6, 6),
)
CYCLE_MEMORY_FULL = error(
    50855,
    known_as=(21958,),
    en="not enough memory for another realtime cycle: {needed} bytes needed, {free} free",
    de="nicht genug Speicher für einen weiteren Echtzeit-Zyklus: {needed} Byte nötig, {free} frei",
    remedy_en="Delete cycles that are done, or increase configuration.rt_cycles.memory "
    "(P-CHAN-00407).",
    remedy_de="Erledigte Zyklen löschen oder configuration.rt_cycles.memory (P-CHAN-00407) "
    "erhöhen.",
    needed=("the bytes of the cycle", "die Bytes des Zyklus"),
    free=("the bytes that are free", "die freien Bytes"),
    classes=(6, 6),
)
CYCLE_TOO_LARGE = error(
    50857,
    en="this realtime cycle needs {needed} bytes, more than the whole memory; {free} are free",
    de="dieser Echtzeit-Zyklus braucht {needed} Byte, mehr als der ganze Speicher; {free} sind "
    "frei",
    remedy_en="Shorten the cycle, or increase configuration.rt_cycles.memory (P-CHAN-00407).",
    remedy_de="Den Zyklus kürzen oder configuration.rt_cycles.memory (P-CHAN-00407) erhöhen.",
    needed=("the bytes of the cycle", "die Bytes des Zyklus"),
    free=("the bytes that are free", "die freien Bytes"),
    classes=(6, 6),
)
UNKNOWN_CYCLE_ID = error(
    50858,
    en="no realtime cycle has the ID {id}",
    de="kein Echtzeit-Zyklus hat die ID {id}",
    remedy_en="Define the cycle first, and check its scope: it may already have ended.",
    remedy_de="Den Zyklus vorher definieren und seine Gültigkeit prüfen: er kann schon beendet "
    "sein.",
    cause_en="PROG cycles end with the main program, BLOCK cycles with their block. A GLOBAL cycle "
    "lives until DELETE.",
    cause_de="PROG-Zyklen enden mit dem Hauptprogramm, BLOCK-Zyklen mit ihrem Satz. Ein "
    "GLOBAL-Zyklus lebt bis DELETE.",
    classes=(6, 6),
)
TOO_MANY_CYCLES = error(
    50877,
    en="more than {count} realtime cycles at the same time",
    de="mehr als {count} Echtzeit-Zyklen gleichzeitig",
    remedy_en="Delete cycles that are no longer needed with #RT CYCLE DELETE.",
    remedy_de="Nicht mehr gebrauchte Zyklen mit #RT CYCLE DELETE löschen.",
    cause_en="Cycles without an ID count as well, and a definition in a loop creates a new one "
    "each time.",
    cause_de="Auch Zyklen ohne ID zählen, und eine Definition in einer Schleife legt jedes Mal "
    "einen neuen an.",
    count=(
        "the maximum number of cycles of a channel",
        "die größte Anzahl von Zyklen eines Kanals",
    ),
    classes=(6, 6),
)
CYCLE_OPERATION_WITHOUT_RESULT = error(
    50879,
    known_as=(21959,),
    en="'{operation}' in realtime cycle {cycle} has no valid result",
    de="'{operation}' im Echtzeit-Zyklus {cycle} hat kein gültiges Ergebnis",
    remedy_en="Check the operands with $IF first; '=' means a result that is too large.",
    remedy_de="Die Operanden vorher mit $IF prüfen; '=' steht für ein zu großes Ergebnis.",
    cause_en="Division by zero, a root or logarithm out of range, or a result that is too large. "
    "The statement assigns nothing.",
    cause_de="Division durch null, Wurzel oder Logarithmus außerhalb des Bereichs oder ein zu "
    "großes Ergebnis. Zugewiesen wird nichts.",
    operation=("the operator or function", "der Operator oder die Funktion"),
    classes=(6, 6),
)
CYCLE_VALUE_OUT_OF_RANGE = error(
    50892,
    en="{value} is outside the range {low} … {high} of {variable}",
    de="{value} liegt außerhalb des Bereichs {low} … {high} von {variable}",
    remedy_en="Limit the value, or give the variable a larger type.",
    remedy_de="Den Wert begrenzen oder der Variablen einen größeren Typ geben.",
    cause_en="An integer variable takes the nearest whole number (half to even) in the range of "
    "its type; nothing is stored here.",
    cause_de="Eine ganzzahlige Variable erhält die nächste ganze Zahl (halbe zur geraden) im "
    "Bereich ihres Typs; hier wird nichts gespeichert.",
    value=("the value, rounded", "der Wert, gerundet"),
    low=("the smallest value of its type", "der kleinste Wert ihres Typs"),
    high=("the largest value of its type", "der größte Wert ihres Typs"),
    classes=(6, 6),
)
VALUE_NOT_FINITE = error(
    50893,
    en="{value} is not a finite number and cannot be assigned to {name}",
    de="{value} ist keine endliche Zahl und kann {name} nicht zugewiesen werden",
    remedy_en="Use a finite number.",
    remedy_de="Eine endliche Zahl verwenden.",
    cause_en="Variables hold finite numbers only.",
    cause_de="Variablen enthalten nur endliche Zahlen.",
    classes=(6, 6),
)
CYCLE_ID_IN_USE = error(
    50900,
    en="the ID {id} already belongs to another realtime cycle",
    de="die ID {id} gehört schon einem anderen Echtzeit-Zyklus",
    remedy_en="Choose another ID, or first delete the other cycle with #RT CYCLE DELETE.",
    remedy_de="Eine andere ID wählen oder den anderen Zyklus vorher mit #RT CYCLE DELETE löschen.",
    cause_en="A cycle keeps its ID until its scope ends: PROG until the end of the main program, "
    "GLOBAL until DELETE, even in later programs.",
    cause_de="Ein Zyklus behält seine ID, bis seine Gültigkeit endet: PROG bis zum "
    "Hauptprogrammende, GLOBAL bis DELETE, auch in späteren Programmen.",
    classes=(6, 6),
)
CYCLES_EXCEED_DURATION = error(
    50939,
    known_as=(50930,),
    en="the realtime cycles take too long: {steps} elementary instructions; there is time for "
    "{limit}",
    de="die Echtzeit-Zyklen dauern zu lange: {steps} Elementar-Anweisungen; Zeit ist für {limit}",
    remedy_en="Shorten cycle {cycle} or others, or increase rt_cycles.max_duration (P-CHAN-00425).",
    remedy_de="Zyklus {cycle} oder andere kürzen oder rt_cycles.max_duration (P-CHAN-00425) "
    "erhöhen.",
    cause_en="All cycles of a tick share the time. In virtual time each elementary instruction "
    "takes 10 ns. One published list of errors calls this 50930; there 50939 is an M function "
    "that controls programs (M30 …) in a cycle, which is 900207 here.",
    cause_de="Alle Zyklen eines Takts teilen sich die Zeit. In virtueller Zeit dauert jede "
    "Elementar-Anweisung 10 ns. Eine veröffentlichte Fehlerliste nennt das 50930; dort steht "
    "50939 für eine M-Funktion, die Programme steuert (M30 …), in einem Zyklus: hier 900207.",
    steps=("the number of instructions so far", "die Anzahl der Anweisungen bis dahin"),
    limit=(
        "the instructions for which the share of the tick is enough",
        "die Anweisungen, für die der Anteil am Takt reicht",
    ),
    classes=(6, 6),
)
PLC_INTERFACE_FULL = error(
    50942,
    en="{function} cannot be output to the PLC: all {slots} slots of the interface are occupied",
    de="{function} kann nicht an die SPS ausgegeben werden: alle {slots} Plätze der Schnittstelle "
    "sind belegt",
    remedy_en="Let the PLC acknowledge in every tick, or output fewer functions.",
    remedy_de="Die SPS in jedem Takt quittieren lassen oder weniger Funktionen ausgeben.",
    cause_en="A cycle does not wait: a function without a slot would be lost, so this is an error.",
    cause_de="Ein Zyklus wartet nicht: eine Funktion ohne Platz ginge verloren; darum ist das ein "
    "Fehler.",
    slots=("the slots of the realtime section", "die Plätze des Echtzeit-Bereichs"),
    classes=(6, 6),
)
TOO_MANY_FUNCTIONS_IN_TICK = error(
    50943,
    en="{function} is one function too many in this tick: the interface holds {slots}",
    de="{function} ist in diesem Takt eine Funktion zu viel: die Schnittstelle fasst {slots}",
    remedy_en="Spread the functions over several ticks.",
    remedy_de="Die Funktionen auf mehrere Takte verteilen.",
    cause_en="All functions output in one tick are in the interface at the same time; the PLC "
    "frees slots only after the tick.",
    cause_de="Was in einem Takt ausgegeben wird, steht gleichzeitig in der Schnittstelle; die SPS "
    "gibt Plätze erst nach dem Takt frei.",
    slots=("the slots of the realtime section", "die Plätze des Echtzeit-Bereichs"),
    classes=(6, 6),
)
NO_CYCLE_TO_DELETE = note(
    900410,
    known_as=(50858,),
    en="there is no realtime cycle with this ID: nothing to delete",
    de="es gibt keinen Echtzeit-Zyklus mit dieser ID: nichts zu löschen",
    cause_en="Many programs begin by deleting a cycle that an earlier one may have left; that is "
    "harmless.",
    cause_de="Viele Programme löschen zu Beginn einen Zyklus, den ein früheres hinterlassen haben "
    "kann; das ist harmlos.",
)
HOLD_WITHOUT_EFFECT = note(
    900411,
    en="the realtime cycle is not running: HOLD has no effect",
    de="der Echtzeit-Zyklus läuft nicht: HOLD hat keine Wirkung",
    cause_en="HOLD stops only a running cycle; this one is already on hold, or was not started.",
    cause_de="HOLD hält nur einen laufenden Zyklus an; dieser ist schon angehalten oder wurde "
    "nicht gestartet.",
)
CONTINUE_WITHOUT_EFFECT = note(
    900412,
    en="the realtime cycle is not on hold: CONTINUE has no effect",
    de="der Echtzeit-Zyklus ist nicht angehalten: CONTINUE hat keine Wirkung",
    cause_en="CONTINUE resumes only a cycle on hold.",
    cause_de="CONTINUE setzt nur einen angehaltenen Zyklus fort.",
)
BLOCK_CYCLE_NEVER_RAN = note(
    900413,
    en="a realtime cycle with scope BLOCK ended with the program and never ran",
    de="ein Echtzeit-Zyklus mit Gültigkeit BLOCK endete mit dem Programm, ohne je zu laufen",
    cause_en="A BLOCK cycle waits for the next block that takes time, and none came.",
    cause_de="Ein BLOCK-Zyklus wartet auf den nächsten Satz, der Zeit braucht, und es kam keiner.",
)
BLOCK_PASSED_OVER = note(
    901049,
    en="this block takes no time: the realtime cycle with scope BLOCK waits for the next block",
    de="dieser Satz braucht keine Zeit: der Echtzeit-Zyklus mit Gültigkeit BLOCK wartet auf den "
    "nächsten",
    cause_en="A BLOCK cycle runs in the next block that takes at least one tick: by a motion, a "
    "dwell, or because it waits. A motion to where the axes are already has zero length and takes "
    "no time, and neither does a dwell of 0 s.",
    cause_de="Ein BLOCK-Zyklus läuft im nächsten Satz, der mindestens einen Takt dauert: durch "
    "Bewegung, Verweilen oder weil er wartet. Eine Bewegung dorthin, wo die Achsen schon sind, "
    "hat die Länge null und braucht keine Zeit, ebenso wenig eine Verweilzeit von 0 s.",
)
UNKNOWN_CYCLE_TIMER = error(
    21167,
    known_as=(900421,),
    en="unknown timer {timer}: timers are numbered 0 … 127",
    de="unbekannter Timer {timer}: Timer haben die Nummern 0 … 127",
    remedy_en="Give #TIMER an ID from 0 to 127.",
    remedy_de="#TIMER eine ID von 0 bis 127 geben.",
    timer=("the ID", "die ID"),
    classes=(6, 6),
)
