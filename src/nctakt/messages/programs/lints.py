# SPDX-License-Identifier: MIT
"""Messages about programs that would run, but are likely meant otherwise."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

ASYNCHRONOUS_CONDITION = warning(
    900235,
    en="{name} is asynchronous: in every tick this condition sees {seen}",
    de="{name} ist asynchron: in jedem Takt sieht diese Bedingung {seen}",
    remedy_en="To read the value of each tick, set synchronisation TRUE in the variables list, or "
    "write Vs. here.",
    remedy_de="Für den Wert jedes Takts: synchronisation TRUE in der Variablenliste setzen, oder "
    "hier Vs. schreiben.",
    cause_en="The decoder builds a cycle from its definition; whatever is asynchronous becomes a "
    "number then.",
    cause_de="Der Dekoder baut den Zyklus aus seiner Definition; Asynchrones wird dabei zu einer "
    "Zahl.",
    seen=("the value that is read", "der gelesene Wert"),
)
ASYNCHRONOUS_VALUE = note(
    900236,
    en="{name} is read once: in every tick the realtime cycle sees {seen}",
    de="{name} wird einmal gelesen: in jedem Takt sieht der Echtzeit-Zyklus {seen}",
    remedy_en="For a value that should change while the cycle runs, use a synchronous V.E or V.CH "
    "variable.",
    remedy_de="Was sich ändern soll, während der Zyklus läuft, gehört in eine synchrone V.E- oder "
    "V.CH-Variable.",
    cause_en="The decoder builds a cycle from its definition; whatever is asynchronous becomes a "
    "number then.",
    cause_de="Der Dekoder baut den Zyklus aus seiner Definition; Asynchrones wird dabei zu einer "
    "Zahl.",
    seen=("the value that is read", "der gelesene Wert"),
)
CONSTANT_CONDITION = warning(
    900237,
    en="this condition is constant and can never change",
    de="diese Bedingung ist konstant und kann sich nie ändern",
    remedy_en="Remove the $IF, or its body; to do something once, write $IF ONCE 1.",
    remedy_de="Das $IF oder seinen Inhalt entfernen; für einmalige Aktionen $IF ONCE 1 schreiben.",
)
CONDITION_NEVER_CHANGES = warning(
    900238,
    en="this condition can never change: of {names} it sees {seen}",
    de="diese Bedingung kann sich nie ändern: von {names} sieht sie {seen}",
    remedy_en="Query something synchronous; put a choice that is made once around #RT CYCLE.",
    remedy_de="Etwas Synchrones abfragen; eine einmalige Auswahl um #RT CYCLE herum schreiben.",
    names=("the variables", "die Variablen"),
    seen=("the value that is read", "der gelesene Wert"),
)
COMPARISON_OUTSIDE_TYPE_RANGE = warning(
    900239,
    en="{name} is of type {type}: this comparison is {result}, whatever the value",
    de="{name} ist vom Typ {type}: dieser Vergleich ist {result}, unabhängig vom Wert",
    remedy_en="It holds whole numbers from {low} to {high}; compare with one of these.",
    remedy_de="Sie fasst ganze Zahlen von {low} bis {high}; mit einer davon vergleichen.",
    result=("never true or always true", "nie wahr oder immer wahr"),
    low=("its lowest value", "ihr kleinster Wert"),
    high=("its highest value", "ihr größter Wert"),
)
IF_NOT_EVALUATED_EVERY_TICK = note(
    900240,
    en="$IF {word} inside $IF is evaluated only in ticks that reach it; otherwise it keeps its "
    "state",
    de="$IF {word} in $IF wird nur in Takten ausgewertet, die es erreichen; sonst bleibt sein "
    "Zustand",
    remedy_en="This may be intended; otherwise make it the outer $IF, or combine the conditions "
    "with &&.",
    remedy_de="Das kann gewollt sein; sonst nach außen setzen oder die Bedingungen mit && "
    "verbinden.",
    cause_en="An $IF that is not reached keeps its state: a latched ALWAYS stays latched, EDGE "
    "compares with the tick in which it was last reached.",
    cause_de="Ein $IF, das nicht erreicht wird, behält seinen Zustand: ALWAYS bleibt eingerastet, "
    "EDGE vergleicht mit dem Takt, in dem es zuletzt erreicht wurde.",
    word=("ONCE, EDGE or ALWAYS", "ONCE, EDGE oder ALWAYS"),
)
IF_EVALUATED_IN_ONE_TICK = warning(
    900241,
    en="this $IF is inside $IF {word}: it is evaluated only in the one tick in which that fires",
    de="dieses $IF steht in $IF {word}: es wird nur in dem einen Takt ausgewertet, in dem jenes "
    "auslöst",
    remedy_en="To watch a condition from then on, use $IF ALWAYS.",
    remedy_de="Was von da an beobachtet werden soll, gehört in $IF ALWAYS.",
    word=("ONCE or EDGE", "ONCE oder EDGE"),
)
OVERRIDE_FOR_ONE_TICK = warning(
    900242,
    en="{name} is written inside $IF {word}: the override lasts one tick, then it is 100 % again",
    de="{name} wird in $IF {word} geschrieben: der Override gilt einen Takt, dann wieder 100 %",
    remedy_en="Write it in each tick in which it should apply: inside a plain $IF or $IF ALWAYS",
    remedy_de="In jedem Takt schreiben, in dem er gelten soll: in einfachem $IF oder in $IF ALWAYS",
    cause_en="The CYCLE overrides are 100 % at the start of each tick; another value must be "
    "written in each tick.",
    cause_de="Die CYCLE-Overrides sind am Anfang jedes Takts 100 %; ein anderer Wert muss in jedem "
    "Takt geschrieben werden.",
    word=("ONCE or EDGE", "ONCE oder EDGE"),
)
FUNCTION_OUTPUT_EACH_TICK = warning(
    900243,
    en="{word} is output again in each tick that reaches this line; the interface to the PLC has "
    "few slots",
    de="{word} wird in jedem Takt neu ausgegeben; die Schnittstelle zur SPS hat nur wenige Plätze",
    remedy_en="Put it inside $IF EDGE or $IF ONCE; if too many wait for the PLC, the result is "
    "50942.",
    remedy_de="In $IF EDGE oder $IF ONCE setzen; warten zu viele auf die SPS, kommt 50942.",
    cause_en="Each output occupies a slot in the realtime section of the interface until the PLC "
    "acknowledges it.",
    cause_de="Jede Ausgabe belegt einen Platz im Echtzeit-Bereich der Schnittstelle, bis die SPS "
    "sie quittiert.",
    word=("the M or H function", "die M- oder H-Funktion"),
)
VARIABLE_WRITTEN_BY_SEVERAL_CYCLES = note(
    900244,
    en="the realtime cycle in line {line} also writes {names}; in each tick the last one wins",
    de="auch der Echtzeit-Zyklus in Zeile {line} schreibt {names}; in jedem Takt gewinnt der "
    "letzte",
    remedy_en="Let only one cycle write it, or note that they run in the order of their "
    "definition.",
    remedy_de="Nur einen Zyklus schreiben lassen oder bedenken: sie laufen in der Reihenfolge "
    "ihrer Definition.",
    cause_en="All cycles run once in each tick, in the order of their definition; the value "
    "written last stays.",
    cause_de="Alle Zyklen laufen in jedem Takt einmal, in der Reihenfolge ihrer Definition; der "
    "zuletzt geschriebene Wert bleibt.",
    names=("the variables", "die Variablen"),
    line=(
        "the line in which the other cycle begins",
        "die Zeile, in der der andere Zyklus beginnt",
    ),
)
GLOBAL_CYCLE_NEVER_DELETED = note(
    900245,
    en="no checked program deletes the GLOBAL realtime cycle {id}; it runs until the controller is "
    "restarted",
    de="kein geprüftes Programm löscht den GLOBAL-Echtzeit-Zyklus {id}; er läuft bis zum Neustart "
    "der Steuerung",
    remedy_en="End it with #RT CYCLE DELETE [ID={id}]; until then the program cannot define it "
    "again.",
    remedy_de="Ihn mit #RT CYCLE DELETE [ID={id}] beenden; bis dahin kann ihn das Programm nicht "
    "neu definieren.",
    cause_en="A GLOBAL cycle outlives its program and also runs between programs.",
    cause_de="Ein GLOBAL-Zyklus überlebt sein Programm und läuft auch zwischen Programmen.",
    id=("the ID of the cycle", "die ID des Zyklus"),
)
CYCLE_NEVER_STARTED = warning(
    901986,
    en="realtime cycle {id} is defined, and nothing starts it: it never runs",
    de="Echtzeit-Zyklus {id} ist definiert, und nichts startet ihn: er läuft nie",
    remedy_en="#RT CYCLE START [ID={id}] starts it; without DEF it starts at once.",
    remedy_de="#RT CYCLE START [ID={id}] startet ihn; ohne DEF startet er sofort.",
    id=("the ID of the cycle", "die ID des Zyklus"),
)
STARTED_CYCLE_NOT_DEFINED = warning(
    901987,
    en="no checked program defines realtime cycle {id}; unless one is left over, START gives 50858",
    de="kein geprüftes Programm definiert Echtzeit-Zyklus {id}; lebt keiner von früher, meldet "
    "START 50858",
    remedy_en="Define it first: #RT CYCLE DEF [ID={id} SCOPE=PROG].",
    remedy_de="Ihn vorher definieren: #RT CYCLE DEF [ID={id} SCOPE=PROG].",
    cause_en="A GLOBAL cycle outlives its program: an earlier one may have left it.",
    cause_de="Ein GLOBAL-Zyklus überlebt sein Programm: ein früheres kann ihn hinterlassen haben.",
    id=("the ID of the cycle", "die ID des Zyklus"),
)
CYCLE_MAY_EXCEED_STEP_LIMIT = warning(
    900246,
    en="this realtime cycle may need {steps} elementary instructions; P-CHAN-00427 allows {limit}",
    de="dieser Echtzeit-Zyklus kann {steps} Elementar-Anweisungen brauchen; P-CHAN-00427 erlaubt "
    "{limit}",
    remedy_en="Shorten it, or increase rt_cycles.max_steps; above the limit the cycle ends with "
    "50854.",
    remedy_de="Kürzen oder rt_cycles.max_steps erhöhen; darüber endet der Zyklus mit 50854.",
    cause_en="The most expensive path through the branches counts: each operator, function, "
    "access, assignment, condition and action is one instruction.",
    cause_de="Gezählt wird der teuerste Weg durch die Zweige: jeder Operator, jede Funktion, jeder "
    "Zugriff, jede Zuweisung, Bedingung und Aktion ist eine Anweisung.",
    steps=(
        "the maximum of elementary instructions in one run-through",
        "die größte Anzahl Elementar-Anweisungen eines Durchlaufs",
    ),
    limit=(
        "the elementary instructions that are allowed in a tick",
        "die im Takt erlaubten Elementar-Anweisungen",
    ),
)
CYCLE_MAY_EXCEED_DURATION = warning(
    900247,
    en="this realtime cycle may need {steps} elementary instructions; P-CHAN-00425 allows time for "
    "{limit}",
    de="dieser Echtzeit-Zyklus kann {steps} Elementar-Anweisungen brauchen; P-CHAN-00425 lässt "
    "Zeit für {limit}",
    remedy_en="Shorten it, or increase rt_cycles.max_duration; above the limit the cycle ends with "
    "50939.",
    remedy_de="Kürzen oder rt_cycles.max_duration erhöhen; darüber endet der Zyklus mit 50939.",
    cause_en="In virtual time each elementary instruction takes 10 ns; more than the share of "
    "P-CHAN-00425 in the tick ends the cycle.",
    cause_de="In virtueller Zeit dauert jede Elementar-Anweisung 10 ns; mehr als der Anteil von "
    "P-CHAN-00425 am Takt beendet den Zyklus.",
    steps=(
        "the maximum of elementary instructions in one run-through",
        "die größte Anzahl Elementar-Anweisungen eines Durchlaufs",
    ),
    limit=(
        "the elementary instructions for which a tick has time",
        "die Elementar-Anweisungen, für die ein Takt Zeit hat",
    ),
)
EXACT_POSITION_COMPARISON = note(
    900248,
    en="{name} is compared for equality: a moving axis hardly ever has exactly this value in a "
    "tick",
    de="{name} wird auf Gleichheit verglichen: eine bewegte Achse hat fast nie genau diesen Wert",
    remedy_en="Check whether the value is passed: >= or <=",
    remedy_de="Das Überschreiten abfragen: >= oder <=",
    cause_en="Positions have many decimal places; from tick to tick a moving axis skips almost all "
    "values.",
    cause_de="Positionen haben viele Nachkommastellen; von Takt zu Takt überspringt eine bewegte "
    "Achse fast alle Werte.",
)
FLUSH_DURING_COMPENSATION = error(
    20651,
    en="{command} empties the channel, which is not possible while {word} is active",
    de="{command} entleert den Kanal; das ist nicht möglich, solange {word} aktiv ist",
    remedy_en="Move it before {word} or after its end. A realtime cycle may use {variable}.",
    remedy_de="Vor {word} oder hinter sein Ende verlegen. Ein Echtzeit-Zyklus darf {variable} "
    "benutzen.",
    cause_en="The end of a motion of the contour is known only from the next motion, so the path "
    "cannot stop and wait.",
    cause_de="Das Ende einer Bewegung der Kontur ergibt sich erst aus der nächsten; die Bahn kann "
    "darum nicht anhalten und warten.",
    command=("the variable or command", "die Variable oder der Befehl"),
    word=("G41, G42 or #SPLINE ON", "G41, G42 oder #SPLINE ON"),
    variable=("the variable, if it is one", "die Variable, falls es eine ist"),
)
AXIS_COMMANDED_EACH_TICK = warning(
    900270,
    en="{axis}[INDP … {word}] is commanded again in each tick that reaches this line",
    de="{axis}[INDP … {word}] wird in jedem Takt neu befohlen, der diese Zeile erreicht",
    remedy_en="Put it inside $IF EDGE or $IF ONCE.",
    remedy_de="In $IF EDGE oder $IF ONCE setzen.",
    cause_en="With G91 each command starts a new distance from where the axis is now; with "
    "BUFFERED each one waits for the running motion.",
    cause_de="Mit G91 beginnt jeder Befehl einen neuen Weg dort, wo die Achse gerade ist; mit "
    "BUFFERED wartet jeder auf die laufende Bewegung.",
    word=("G91 or BUFFERED", "G91 oder BUFFERED"),
)
ARC_LIKELY_WITHOUT_CENTRE = warning(
    20036,
    known_as=(900906,),
    en="this arc has no centre, and no radius was programmed before",
    de="dieser Kreisbogen hat keinen Mittelpunkt, und vorher wurde kein Radius programmiert",
    remedy_en="Program the centre with I, J or K, or a radius R other than 0.",
    remedy_de="Den Mittelpunkt mit I, J oder K programmieren oder einen Radius R ungleich 0.",
    cause_en="If the program runs like this, it stops here (900700).",
    cause_de="Läuft das Programm so, hält es hier an (900700).",
)
POSITION_COMPARED_IN_INCH = note(
    901001,
    en="{name} is in inches here: the realtime cycle is defined under G70",
    de="{name} ist hier in Zoll: der Echtzeit-Zyklus wird unter G70 definiert",
    remedy_en="Compare with inches, or define the cycle under G71.",
    remedy_de="Mit Zoll vergleichen oder den Zyklus unter G71 definieren.",
    cause_en="A realtime cycle keeps the unit of its definition, for the positions that it reads "
    "and for those that it commands.",
    cause_de="Ein Echtzeit-Zyklus behält die Einheit seiner Definition, für gelesene Positionen "
    "wie für befohlene.",
    name=("the position", "die Position"),
)
INDP_WORD_WITHOUT_EFFECT = note(
    901002,
    en="{word} has no effect here: {reason}",
    de="{word} hat hier keine Wirkung: {reason}",
    remedy_en="Remove it.",
    remedy_de="Entfernen.",
)
CONSTANT_ROUNDED = warning(
    901050,
    en="{name} is of type {type}: {value} is rounded to {rounded}",
    de="{name} ist vom Typ {type}: {value} wird auf {rounded} gerundet",
    remedy_en="Write a whole number, or use a variable of type REAL64. {percent}",
    remedy_de="Eine ganze Zahl schreiben oder eine Variable vom Typ REAL64 verwenden. {percent}",
    value=("the constant", "die Konstante"),
    rounded=("the constant, rounded", "die Konstante, gerundet"),
    percent=("what percentages mean, or –", "was Prozente bedeuten, oder –"),
)
CONSTANT_NOT_BOOLEAN = warning(
    901051,
    en="{name} is of type BOOLEAN: {value} counts as {stored}",
    de="{name} ist vom Typ BOOLEAN: {value} zählt als {stored}",
    remedy_en="Write 0 or 1 (FALSE or TRUE), or use a variable of another type.",
    remedy_de="0 oder 1 schreiben (FALSE oder TRUE) oder eine Variable eines anderen Typs "
    "verwenden.",
    value=("the constant", "die Konstante"),
    stored=("the value that is stored", "der gespeicherte Wert"),
)
POSITION_NEVER_REACHED = warning(
    901052,
    en="{name} is between {low} and {high}: this comparison is {result}",
    de="{name} liegt zwischen {low} und {high}: dieser Vergleich ist {result}",
    remedy_en="Compare with a position within the software limits or the modulo range.",
    remedy_de="Mit einer Position innerhalb der Software-Endschalter oder des Modulobereichs "
    "vergleichen.",
    name=("the position", "die Position"),
    low=("lowest position of the axis", "kleinste Position der Achse"),
    high=("highest position of the axis", "größte Position der Achse"),
    result=("never true or always true", "nie wahr oder immer wahr"),
)
OVERRIDE_IS_PERCENT = warning(
    901158,
    en="{word}={value} is an override of {value} %",
    de="{word}={value} ist ein Override von {value} %",
    remedy_en="An override is in percent: write {meant} for that share of the programmed speed.",
    remedy_de="Ein Override ist in Prozent: für diesen Anteil der programmierten Geschwindigkeit "
    "{meant} schreiben.",
    word=("FEED_FACT, RAPID_FACT or SPEED_FACT", "FEED_FACT, RAPID_FACT oder SPEED_FACT"),
    value=("the constant", "die Konstante"),
    meant=("the constant as a share, in percent", "die Konstante als Anteil, in Prozent"),
)
NO_PROGRAM_GIVES_AXIS = warning(
    901810,
    en="none of the checked programs gives away axis number {number}, which belongs to channel "
    "{channel}",
    de="keines der geprüften Programme gibt die Achse Nummer {number} ab, die Kanal {channel} hat",
    remedy_en="Program #PUT AX, or PUTAX for a spindle, in channel {channel}; check the programs "
    "of all channels together.",
    remedy_de="#PUT AX, bei einer Spindel PUTAX, in Kanal {channel} programmieren; alle Kanäle "
    "gemeinsam prüfen.",
    number=("the logical number", "die logische Nummer"),
    channel=("the channel that has it", "der Kanal, der sie hat"),
)
NO_PROGRAM_SENDS_SIGNAL = warning(
    901811,
    en="none of the checked programs sends signal {id}",
    de="keines der geprüften Programme sendet Signal {id}",
    remedy_en="Check the number of #WAIT and #SIGNAL; check the programs of all channels together.",
    remedy_de="Nummer von #WAIT und #SIGNAL prüfen; die Programme aller Kanäle gemeinsam prüfen.",
    id=("number of the signal", "Nummer des Signals"),
)
