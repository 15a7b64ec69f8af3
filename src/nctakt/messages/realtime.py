# SPDX-License-Identifier: MIT
"""Messages of the realtime part (900400 … 900499)."""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, NOTE, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_add(
    50854,
    ERROR,
    "the realtime cycles need {steps} elementary instructions in a tick, {limit} are allowed",
    "die Echtzeit-Zyklen brauchen {steps} Elementar-Anweisungen im Takt, erlaubt sind {limit}",
    remedy_en="Shorten cycle {cycle} or another one, or raise rt_cycles.max_steps (P-CHAN-00427).",
    remedy_de="Zyklus {cycle} oder andere kürzen oder rt_cycles.max_steps (P-CHAN-00427) erhöhen.",
    cause_en="Each operator, function, variable, assignment, condition and action counts one; "
    "nctakt list shows the counts.",
    cause_de="Operator, Funktion, Variable, Zuweisung, Bedingung und Aktion zählen je eins; nctakt"
    " list zeigt die Zahlen.",
    parameters={"cycle": "cycle at fault", "steps": "instructions so far", "limit": "the limit"},
    reaction=6,
    clearing=6,
)
_add(
    50855,
    ERROR,
    "no memory for another realtime cycle: {needed} bytes needed, {free} are free",
    "kein Speicher für einen weiteren Echtzeit-Zyklus: {needed} Byte nötig, {free} frei",
    remedy_en="Delete cycles that are done, or raise configuration.rt_cycles.memory "
    "(P-CHAN-00407).",
    remedy_de="Erledigte Zyklen löschen oder configuration.rt_cycles.memory "
    "(P-CHAN-00407) erhöhen.",
    parameters={"needed": "bytes of the cycle", "free": "bytes that are left"},
    reaction=6,
    clearing=6,
)
_add(
    50857,
    ERROR,
    "this realtime cycle needs {needed} bytes, more than the whole memory; {free} are free",
    "dieser Echtzeit-Zyklus braucht {needed} Byte, mehr als der ganze Speicher; {free} sind frei",
    remedy_en="Shorten the cycle, or raise configuration.rt_cycles.memory (P-CHAN-00407).",
    remedy_de="Den Zyklus kürzen oder configuration.rt_cycles.memory (P-CHAN-00407) erhöhen.",
    parameters={"needed": "bytes of the cycle", "free": "bytes that are left"},
    reaction=6,
    clearing=6,
)
_add(
    50858,
    ERROR,
    "no realtime cycle has the ID {id}",
    "kein Echtzeit-Zyklus hat die ID {id}",
    remedy_en="Define the cycle before, and mind its scope: it may have ended already.",
    remedy_de="Den Zyklus vorher definieren; seine Gültigkeit beachten: er kann schon beendet "
    "sein.",
    cause_en="PROG cycles end with the main program, BLOCK cycles with their block. A GLOBAL one "
    "lives until DELETE.",
    cause_de="PROG-Zyklen enden mit dem Hauptprogramm, BLOCK-Zyklen mit ihrem Satz. Ein GLOBAL-"
    "Zyklus lebt bis DELETE.",
    parameters={"id": "the ID"},
    reaction=6,
    clearing=6,
)
_add(
    50877,
    ERROR,
    "more than {count} realtime cycles at once",
    "mehr als {count} Echtzeit-Zyklen zugleich",
    remedy_en="Delete cycles that are no longer needed with #RT CYCLE DELETE.",
    remedy_de="Nicht mehr gebrauchte Zyklen mit #RT CYCLE DELETE löschen.",
    cause_en="Cycles without an ID count, too, and definitions in a loop make a new one each time.",
    cause_de="Auch Zyklen ohne ID zählen, und eine Definition in einer Schleife legt jedes Mal "
    "einen neuen an.",
    parameters={"count": "the most cycles of a channel"},
    reaction=6,
    clearing=6,
)
_add(
    50879,
    ERROR,
    "'{operation}' in realtime cycle {cycle} has no usable result",
    "'{operation}' im Echtzeit-Zyklus {cycle} hat kein brauchbares Ergebnis",
    remedy_en="Test the operands with $IF before; '=' stands for a result that is too large.",
    remedy_de="Die Operanden vorher mit $IF prüfen; '=' steht für ein zu großes Ergebnis.",
    cause_en="Division by zero, root or logarithm out of range, or a result beyond all numbers. "
    "The statement assigns nothing.",
    cause_de="Division durch null, Wurzel oder Logarithmus außerhalb des Bereichs oder ein zu "
    "großes Ergebnis. Zugewiesen wird nichts.",
    parameters={"cycle": "cycle at fault", "operation": "operator or function"},
    reaction=6,
    clearing=6,
)
_add(
    50892,
    ERROR,
    "{value} is outside the range {low} … {high} of {variable}",
    "{value} liegt außerhalb des Bereichs {low} … {high} von {variable}",
    remedy_en="Limit the value, or give the variable a larger type.",
    remedy_de="Den Wert begrenzen oder der Variablen einen größeren Typ geben.",
    cause_en="An integer variable takes the nearest whole number (half to even) inside its type's "
    "range; nothing is stored here.",
    cause_de="Eine ganzzahlige Variable nimmt die nächste ganze Zahl (halbe zur geraden) im "
    "Bereich ihres Typs; hier wird nichts gespeichert.",
    parameters={
        "variable": "the variable",
        "value": "the value, rounded",
        "low": "smallest value of its type",
        "high": "largest value of its type",
    },
    reaction=6,
    clearing=6,
)
_add(
    50893,
    ERROR,
    "{value} is not a finite number and cannot be given to {name}",
    "{value} ist keine endliche Zahl und kann {name} nicht zugewiesen werden",
    remedy_en="Give a finite number.",
    remedy_de="Eine endliche Zahl angeben.",
    cause_en="Variables hold finite numbers only.",
    cause_de="Variablen halten nur endliche Zahlen.",
    parameters={"name": "the variable", "value": "the value"},
    reaction=6,
    clearing=6,
)
_add(
    50900,
    ERROR,
    "the ID {id} belongs to another realtime cycle already",
    "die ID {id} gehört schon einem anderen Echtzeit-Zyklus",
    remedy_en="Choose another ID, or delete the other cycle before with #RT CYCLE DELETE.",
    remedy_de="Eine andere ID wählen oder den anderen Zyklus vorher mit #RT CYCLE DELETE löschen.",
    cause_en="A cycle keeps its ID until its scope ends: PROG until the main program's end, GLOBAL"
    " until DELETE, in later programs too.",
    cause_de="Ein Zyklus behält seine ID, bis seine Gültigkeit endet: PROG bis zum "
    "Hauptprogrammende, GLOBAL bis DELETE, auch in späteren Programmen.",
    parameters={"id": "the ID"},
    reaction=6,
    clearing=6,
)
_add(
    50939,
    ERROR,
    "the realtime cycles take too long: {steps} elementary instructions, time is for {limit}",
    "die Echtzeit-Zyklen dauern zu lange: {steps} Elementar-Anweisungen, Zeit ist für {limit}",
    remedy_en="Shorten cycle {cycle} or others, or raise rt_cycles.max_duration (P-CHAN-00425).",
    remedy_de="Zyklus {cycle} oder andere kürzen, rt_cycles.max_duration (P-CHAN-00425) erhöhen.",
    cause_en="All cycles of a tick share the time. In virtual time each elementary instruction is "
    "taken to cost 10 ns.",
    cause_de="Alle Zyklen eines Takts teilen sich die Zeit. In virtueller Zeit gilt jede "
    "Elementar-Anweisung als 10 ns.",
    parameters={
        "cycle": "cycle at fault",
        "steps": "instructions so far",
        "limit": "instructions for which the share of the tick lasts",
    },
    reaction=6,
    clearing=6,
    known_as=(50930,),
)
_add(
    50942,
    ERROR,
    "{function} cannot be handed to the PLC: all {slots} places of the interface are taken",
    "{function} kann der SPS nicht übergeben werden: alle {slots} Plätze der Schnittstelle belegt",
    remedy_en="Let the PLC acknowledge in every tick, or output fewer functions.",
    remedy_de="Die SPS in jedem Takt quittieren lassen oder weniger Funktionen ausgeben.",
    cause_en="A cycle does not wait: a function that finds no place would be lost, so this is an "
    "error.",
    cause_de="Ein Zyklus wartet nicht: eine Funktion ohne Platz ginge verloren; darum ist es ein "
    "Fehler.",
    parameters={"function": "the function", "slots": "places of the realtime section"},
    reaction=6,
    clearing=6,
)
_add(
    50943,
    ERROR,
    "{function} is one function too many in this tick: the interface holds {slots}",
    "{function} ist in diesem Takt eine Funktion zu viel: die Schnittstelle fasst {slots}",
    remedy_en="Spread the functions over several ticks.",
    remedy_de="Die Funktionen auf mehrere Takte verteilen.",
    cause_en="What is put out in one tick stands in the interface at the same time; the PLC frees "
    "places only behind the tick.",
    cause_de="Was in einem Takt ausgegeben wird, steht gleichzeitig in der Schnittstelle; die SPS "
    "gibt Plätze erst nach dem Takt frei.",
    parameters={"function": "the function", "slots": "places of the realtime section"},
    reaction=6,
    clearing=6,
)
_add(
    900410,
    NOTE,
    "there is no realtime cycle with this ID: nothing to delete",
    "es gibt keinen Echtzeit-Zyklus mit dieser ID: nichts zu löschen",
    remedy_en="",
    remedy_de="",
    cause_en="The first line of many programs deletes a cycle that an earlier one may have left; "
    "that is harmless.",
    cause_de="Die erste Zeile vieler Programme löscht einen Zyklus, den ein früheres hinterlassen "
    "haben kann; das ist harmlos.",
)
_add(
    900411,
    NOTE,
    "the realtime cycle does not run: HOLD has no effect",
    "der Echtzeit-Zyklus läuft nicht: HOLD bewirkt nichts",
    remedy_en="",
    remedy_de="",
    cause_en="HOLD stops a running cycle only; it is held already, or was not started.",
    cause_de="HOLD hält nur einen laufenden Zyklus an; er steht schon oder wurde nicht gestartet.",
)
_add(
    900412,
    NOTE,
    "the realtime cycle is not held: CONTINUE has no effect",
    "der Echtzeit-Zyklus ist nicht angehalten: CONTINUE bewirkt nichts",
    remedy_en="",
    remedy_de="",
    cause_en="CONTINUE lets a held cycle go on only.",
    cause_de="CONTINUE setzt nur einen angehaltenen Zyklus fort.",
)
_add(
    900413,
    NOTE,
    "a realtime cycle with scope BLOCK ended with the program without having run",
    "ein Echtzeit-Zyklus mit Gültigkeit BLOCK endete mit dem Programm, ohne gelaufen zu sein",
    remedy_en="",
    remedy_de="",
    cause_en="A BLOCK cycle waits for the next block that takes time, and none came.",
    cause_de="Ein BLOCK-Zyklus wartet auf den nächsten Satz, der Zeit braucht, und es kam keiner.",
)
_add(
    900421,
    ERROR,
    "there is no timer {timer}: timers are numbered 0 … 127",
    "es gibt keinen Timer {timer}: Timer haben die Nummern 0 … 127",
    remedy_en="Give #TIMER an ID from 0 to 127.",
    remedy_de="#TIMER eine ID von 0 bis 127 geben.",
    parameters={"timer": "the ID"},
    reaction=6,
    clearing=6,
)
_add(
    900420,
    ERROR,
    "the block does not begin where the axis {axis} stands",
    "der Satz beginnt nicht dort, wo die Achse {axis} steht",
    remedy_en="Let the decoder read the positions anew before, with #FLUSH WAIT or #CHANNEL INIT.",
    remedy_de="Den Dekoder die Positionen vorher neu lesen lassen: #FLUSH WAIT, #CHANNEL INIT",
    cause_en="Something other than the path has moved an axis since the block was decoded; the "
    "path never jumps.",
    cause_de="Etwas anderes als die Bahn hat eine Achse bewegt, seit der Satz dekodiert wurde; die"
    " Bahn springt nie.",
    parameters={"axis": "the first such axis"},
    reaction=6,
    clearing=6,
)
_add(
    900430,
    ERROR,
    "the axis {axis} is being moved by the path: it takes no command of its own now",
    "die Achse {axis} wird gerade von der Bahn bewegt: sie nimmt jetzt keinen eigenen Auftrag an",
    remedy_en="Command the axis while no block moves it.",
    remedy_de="Die Achse beauftragen, während kein Satz sie bewegt.",
    cause_en="An axis has one owner at a time: the path while the current block moves it.",
    cause_de="Eine Achse hat immer nur einen Eigentümer: die Bahn, während der aktuelle Satz sie"
    " bewegt.",
    parameters={"axis": "the axis"},
    reaction=6,
    clearing=6,
)
_add(
    900431,
    ERROR,
    "the axis {axis} is in error state: it takes no command before a reset",
    "die Achse {axis} ist im Fehlerzustand: vor einem Reset nimmt sie keinen Auftrag an",
    remedy_en="Reset the channel; the error before this one tells what happened.",
    remedy_de="Den Kanal zurücksetzen; der Fehler davor sagt, was geschehen ist.",
    parameters={"axis": "the axis"},
    reaction=6,
    clearing=6,
)
_add(
    900432,
    ERROR,
    "the target {target} of the axis {axis} lies beyond its software limits {low} … {high}",
    "das Ziel {target} der Achse {axis} liegt außerhalb ihrer Softwareendschalter {low} … {high}",
    remedy_en="Give a target between kenngr.swe_neg and kenngr.swe_pos, offsets included.",
    remedy_de="Ein Ziel zwischen kenngr.swe_neg und kenngr.swe_pos angeben, samt Versätzen.",
    parameters={
        "axis": "the axis",
        "target": "the target in mm or degrees",
        "low": "the lower limit",
        "high": "the upper limit",
    },
    reaction=6,
    clearing=6,
)
_add(
    900433,
    ERROR,
    "a motion of the axis {axis} is waiting already: only one BUFFERED motion can wait",
    "es wartet schon eine Bewegung der Achse {axis}: nur eine BUFFERED-Bewegung kann warten",
    remedy_en="Command the next one when the waiting one has begun, or use ABORTING.",
    remedy_de="Die nächste erst beauftragen, wenn die wartende begonnen hat, oder ABORTING"
    " verwenden.",
    parameters={"axis": "the axis"},
    reaction=6,
    clearing=6,
)
_add(
    900434,
    ERROR,
    "the endless motion of the axis {axis} has come to its software limit",
    "die Endlosbewegung der Achse {axis} ist an ihrem Softwareendschalter angekommen",
    remedy_en="Stop the axis before, or make it a modulo axis.",
    remedy_de="Die Achse vorher stoppen oder zur Modulo-Achse machen.",
    cause_en="It was braked so that it stands on the limit.",
    cause_de="Sie wurde so gebremst, dass sie auf dem Endschalter steht.",
    parameters={"axis": "the axis"},
    reaction=6,
    clearing=6,
)
_add(
    900435,
    ERROR,
    "the block moves the axis {axis}, which has an independent motion",
    "der Satz bewegt die Achse {axis}, die eine unabhängige Bewegung hat",
    remedy_en="Let the motion end before, or stop the axis.",
    remedy_de="Die Bewegung vorher enden lassen oder die Achse stoppen.",
    cause_en="An axis has one owner at a time, and the path never jumps. An endless or held motion"
    " never ends by itself.",
    cause_de="Eine Achse hat immer nur einen Eigentümer, und die Bahn springt nie. Eine endlose"
    " oder angehaltene Bewegung endet nie von selbst.",
    parameters={"axis": "the axis"},
    reaction=6,
    clearing=6,
)
_add(
    900436,
    ERROR,
    "the waiting motion of the axis {axis} would go beyond a software limit from where it begins",
    "die wartende Bewegung der Achse {axis} ginge von ihrem Beginn aus über einen"
    " Softwareendschalter",
    remedy_en="Give a shorter distance, or an absolute target.",
    remedy_de="Einen kürzeren Weg oder ein absolutes Ziel angeben.",
    cause_en="A BUFFERED distance behind an endless motion begins where that one reaches its"
    " speed.",
    cause_de="Ein BUFFERED-Weg hinter einer Endlosbewegung beginnt dort, wo diese ihre"
    " Geschwindigkeit erreicht.",
    parameters={"axis": "the axis"},
    reaction=6,
    clearing=6,
)
_add(
    900446,
    ERROR,
    "{axis} moves endlessly beside the path: the block cannot take it over",
    "{axis} fährt endlos neben der Bahn: der Satz kann sie nicht übernehmen",
    remedy_en="Stop it before: {axis}[INDP STOP] in the cycle, ABORT ACTION, or END_ACTION.",
    remedy_de="Vorher anhalten: {axis}[INDP STOP] im Zyklus, ABORT ACTION oder END_ACTION.",
    cause_en="A block that programs an axis which a realtime cycle moves waits until that axis "
    "stands; this one never would.",
    cause_de="Ein Satz mit einer Achse, die ein Echtzeit-Zyklus bewegt, wartet, bis sie steht; "
    "diese stünde nie.",
    parameters={"axis": "the axis"},
    reaction=6,
    clearing=6,
)
_add(
    900447,
    ERROR,
    "a motion of {axis} beside the path is held: the block cannot take it over",
    "eine Bewegung von {axis} neben der Bahn ist angehalten: der Satz kann sie nicht übernehmen",
    remedy_en="Before the block, let it go on with #RT CYCLE CONTINUE or end it with ABORT ACTION.",
    remedy_de="Vor dem Satz mit #RT CYCLE CONTINUE fortsetzen oder mit ABORT ACTION abbrechen.",
    cause_en="The held motion keeps its target and would go on later from a place that the path "
    "has left.",
    cause_de="Die angehaltene Bewegung behält ihr Ziel und ginge später von einem Ort aus weiter, "
    "den die Bahn verlassen hat.",
    parameters={"axis": "the axis"},
    reaction=6,
    clearing=6,
)
