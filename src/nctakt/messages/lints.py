# SPDX-License-Identifier: MIT
"""Messages about programs that would run, but are likely meant otherwise."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

ASYNCHRONOUS_CONDITION = warning(
    900235,
    en="{name} is asynchronous: in every tick this condition sees {seen}",
    de="{name} ist asynchron: in jedem Takt sieht diese Bedingung {seen}",
    remedy_en="For the value of each tick: synchronisation TRUE in the variables list, or Vs. "
    "here.",
    remedy_de="Für den Wert jedes Takts: synchronisation TRUE in der Variablenliste, oder Vs. "
    "hier.",
    cause_en="The decoder builds a cycle from its definition; what is asynchronous becomes a "
    "number then.",
    cause_de="Der Dekoder baut den Zyklus aus seiner Definition; Asynchrones wird dabei zu einer "
    "Zahl.",
    name=("the variable", "die Variable"),
    seen=("with which value it is read", "mit welchem Wert sie gelesen wird"),
)
ASYNCHRONOUS_VALUE = note(
    900236,
    en="{name} is read once: in every tick the realtime cycle sees {seen}",
    de="{name} wird einmal gelesen: in jedem Takt sieht der Echtzeit-Zyklus {seen}",
    remedy_en="What shall change while the cycle runs belongs into a synchronous V.E or V.CH.",
    remedy_de="Was sich ändern soll, während der Zyklus läuft, gehört in ein synchrones V.E, V.CH.",
    cause_en="The decoder builds a cycle from its definition; what is asynchronous becomes a "
    "number then.",
    cause_de="Der Dekoder baut den Zyklus aus seiner Definition; Asynchrones wird dabei zu einer "
    "Zahl.",
    name=("the variable", "die Variable"),
    seen=("with which value it is read", "mit welchem Wert sie gelesen wird"),
)
CONSTANT_CONDITION = warning(
    900237,
    en="this condition is a constant and can never change",
    de="diese Bedingung ist eine Konstante und kann sich nie ändern",
    remedy_en="Leave the $IF out, or its body; $IF ONCE 1 is the way to say 'once'.",
    remedy_de="Das $IF weglassen oder seinen Inhalt; 'einmal' schreibt man als $IF ONCE 1.",
)
CONDITION_NEVER_CHANGES = warning(
    900238,
    en="this condition can never change: of {names} it sees {seen}",
    de="diese Bedingung kann sich nie ändern: von {names} sieht sie {seen}",
    remedy_en="Ask for something synchronous; a choice made once stands around #RT CYCLE.",
    remedy_de="Nach etwas Synchronem fragen; eine einmalige Wahl steht um #RT CYCLE herum.",
    names=("the variables", "die Variablen"),
    seen=("with which value it is read", "mit welchem Wert sie gelesen wird"),
)
COMPARISON_OUTSIDE_TYPE_RANGE = warning(
    900239,
    en="{name} is of type {type}: this comparison is {result}, whatever its value is",
    de="{name} ist vom Typ {type}: dieser Vergleich ist {result}, welchen Wert sie auch hat",
    remedy_en="It holds whole numbers from {low} to {high}; compare with one of them.",
    remedy_de="Sie fasst ganze Zahlen von {low} bis {high}; mit einer davon vergleichen.",
    name=("the variable", "die Variable"),
    type=("its type", "ihr Typ"),
    result=("never true or always true", "nie wahr oder immer wahr"),
    low=("its least value", "ihr kleinster Wert"),
    high=("its greatest value", "ihr größter Wert"),
)
IF_NOT_EVALUATED_EVERY_TICK = note(
    900240,
    en="$IF {word} inside $IF: it is asked only in ticks that get here, else it keeps its state",
    de="$IF {word} in $IF: gefragt wird nur in Takten, die hierher kommen, sonst bleibt sein "
    "Zustand",
    remedy_en="That is right where it is meant; else make it the outer one, or join the conditions "
    "with &&.",
    remedy_de="Richtig, wenn es so gemeint ist; sonst nach außen setzen oder die Bedingungen mit "
    "&& verbinden.",
    cause_en="An $IF that is not reached keeps what it knows: a latched ALWAYS stays latched, EDGE "
    "compares with the tick in which it was last reached.",
    cause_de="Ein $IF, das nicht erreicht wird, behält, was es weiß: ALWAYS bleibt gesetzt, EDGE "
    "vergleicht mit dem Takt, in dem es zuletzt erreicht wurde.",
    word=("ONCE, EDGE or ALWAYS", "ONCE, EDGE oder ALWAYS"),
)
IF_EVALUATED_IN_ONE_TICK = warning(
    900241,
    en="this $IF stands in $IF {word}: it is asked only in the one tick in which that fires",
    de="dieses $IF steht in $IF {word}: gefragt wird nur in dem einen Takt, in dem jenes auslöst",
    remedy_en="What shall be watched from then on belongs into $IF ALWAYS.",
    remedy_de="Was von da an beobachtet werden soll, gehört in $IF ALWAYS.",
    word=("ONCE or EDGE", "ONCE oder EDGE"),
)
OVERRIDE_FOR_ONE_TICK = warning(
    900242,
    en="{name} is written under $IF {word}: the override lasts one tick, then it is 100 % again",
    de="{name} wird unter $IF {word} geschrieben: der Override gilt einen Takt, dann wieder 100 %",
    remedy_en="Write it in each tick in which it shall hold: under a plain $IF or $IF ALWAYS",
    remedy_de="In jedem Takt schreiben, in dem er gelten soll: unter einfachem $IF oder $IF ALWAYS",
    cause_en="The CYCLE overrides are 100 % at the start of each tick; whoever wants another value "
    "writes it in each tick.",
    cause_de="Die CYCLE-Overrides sind am Anfang jedes Takts 100 %; wer einen anderen Wert will, "
    "schreibt ihn in jedem Takt.",
    name=("the variable", "die Variable"),
    word=("ONCE or EDGE", "ONCE oder EDGE"),
)
FUNCTION_OUTPUT_EACH_TICK = warning(
    900243,
    en="{word} is output again in each tick that gets here; the PLC's interface has few places",
    de="{word} wird in jedem Takt neu ausgegeben; die Schnittstelle zur SPS hat wenige Plätze",
    remedy_en="Put it under $IF EDGE or $IF ONCE; too many that wait for the PLC are 50942.",
    remedy_de="Unter $IF EDGE oder $IF ONCE setzen; warten zu viele auf die SPS, kommt 50942.",
    cause_en="Each output takes a place of the realtime section of the interface until the PLC "
    "acknowledges it.",
    cause_de="Jede Ausgabe belegt einen Platz im Echtzeit-Bereich der Schnittstelle, bis die SPS "
    "sie quittiert.",
    word=("the M or H function", "die M- oder H-Funktion"),
)
VARIABLE_WRITTEN_BY_SEVERAL_CYCLES = note(
    900244,
    en="the realtime cycle of line {line} writes {names}, too; in each tick the last one wins",
    de="auch der Echtzeit-Zyklus von Zeile {line} schreibt {names}; in jedem Takt gewinnt der "
    "letzte",
    remedy_en="Let one cycle write it, or mind that they run in the order of their definition.",
    remedy_de="Nur einen Zyklus schreiben lassen oder bedenken: sie laufen in der Reihenfolge "
    "ihrer Definition.",
    cause_en="All cycles run once in each tick, in the order of their definition; what the last "
    "one has written stays.",
    cause_de="Alle Zyklen laufen in jedem Takt einmal, in der Reihenfolge ihrer Definition; es "
    "bleibt, was der letzte geschrieben hat.",
    names=("the variables", "die Variablen"),
    line=(
        "the line in which the other cycle begins",
        "die Zeile, in der der andere Zyklus beginnt",
    ),
)
GLOBAL_CYCLE_NEVER_DELETED = note(
    900245,
    en="no program that was checked deletes the GLOBAL realtime cycle {id}; it runs until the "
    "controller is restarted",
    de="kein geprüftes Programm löscht den GLOBAL-Echtzeit-Zyklus {id}; er läuft bis zum Neustart "
    "der Steuerung",
    remedy_en="#RT CYCLE DELETE [ID={id}] ends it; until then the program cannot define it again.",
    remedy_de="#RT CYCLE DELETE [ID={id}] beendet ihn; bis dahin kann ihn das Programm nicht neu "
    "definieren.",
    cause_en="A GLOBAL cycle outlives its program and runs between programs, too.",
    cause_de="Ein GLOBAL-Zyklus überlebt sein Programm und läuft auch zwischen Programmen.",
    id=("the ID of the cycle", "die ID des Zyklus"),
)
CYCLE_MAY_EXCEED_STEP_LIMIT = warning(
    900246,
    en="this realtime cycle can need {steps} elementary instructions; P-CHAN-00427 allows {limit}",
    de="dieser Echtzeit-Zyklus kann {steps} Elementar-Anweisungen brauchen; P-CHAN-00427 erlaubt "
    "{limit}",
    remedy_en="Shorten it, or raise rt_cycles.max_steps; beyond it the cycle ends with 50854.",
    remedy_de="Kürzen oder rt_cycles.max_steps erhöhen; darüber endet der Zyklus mit 50854.",
    cause_en="The dearest way through its branches is counted: each operator, function, access, "
    "assignment, condition and action is one.",
    cause_de="Gezählt wird der teuerste Weg durch die Zweige: jeder Operator, jede Funktion, jeder "
    "Zugriff, jede Zuweisung, Bedingung und Aktion ist eine.",
    steps=(
        "elementary instructions of one run-through at most",
        "Elementar-Anweisungen eines Durchlaufs höchstens",
    ),
    limit=(
        "elementary instructions that are allowed in a tick",
        "Elementar-Anweisungen, die im Takt erlaubt sind",
    ),
)
CYCLE_MAY_EXCEED_DURATION = warning(
    900247,
    en="this realtime cycle can need {steps} elementary instructions; P-CHAN-00425 has time for "
    "{limit}",
    de="dieser Echtzeit-Zyklus kann {steps} Elementar-Anweisungen brauchen; P-CHAN-00425 lässt "
    "Zeit für {limit}",
    remedy_en="Shorten it, or raise rt_cycles.max_duration; beyond it the cycle ends with 50939.",
    remedy_de="Kürzen oder rt_cycles.max_duration erhöhen; darüber endet der Zyklus mit 50939.",
    cause_en="In virtual time each elementary instruction takes 10 ns; more than the share of "
    "P-CHAN-00425 in the tick ends the cycle.",
    cause_de="In virtueller Zeit dauert jede Elementar-Anweisung 10 ns; mehr als der Anteil von "
    "P-CHAN-00425 am Takt beendet den Zyklus.",
    steps=(
        "elementary instructions of one run-through at most",
        "Elementar-Anweisungen eines Durchlaufs höchstens",
    ),
    limit=(
        "elementary instructions that are allowed in a tick",
        "Elementar-Anweisungen, die im Takt erlaubt sind",
    ),
)
EXACT_POSITION_COMPARISON = note(
    900248,
    en="{name} is compared exactly: an axis in motion hardly meets the very value in a tick",
    de="{name} wird exakt verglichen: eine bewegte Achse trifft den Wert kaum genau in einem Takt",
    remedy_en="Ask for passing the value: >= or <=",
    remedy_de="Nach dem Überschreiten fragen: >= oder <=",
    cause_en="Positions are numbers with all their digits; from tick to tick a moving axis goes "
    "many of them further.",
    cause_de="Positionen sind Zahlen mit allen Stellen; von Takt zu Takt überspringt eine bewegte "
    "Achse die meisten.",
    name=("the variable", "die Variable"),
)
FLUSH_DURING_COMPENSATION = error(
    20651,
    en="{command} empties the channel, which cannot be while {word} is active",
    de="{command} entleert den Kanal, was nicht geht, solange {word} aktiv ist",
    remedy_en="Move it in front of {word} or behind G40; realtime cycles may read such variables.",
    remedy_de="Vor {word} oder hinter G40 verlegen; Echtzeit-Zyklen dürfen solche Variablen lesen.",
    cause_en="Where a motion of the contour ends only the one behind it shows, so that the path "
    "cannot stand and wait.",
    cause_de="Wo eine Bewegung der Kontur endet, zeigt erst die nächste: die Bahn kann nicht "
    "stehen und warten.",
    command=("the variable or command", "die Variable oder der Befehl"),
    word=("G41 or G42", "G41 oder G42"),
    reaction=2,
    clearing=3,
)
AXIS_COMMANDED_EACH_TICK = warning(
    900270,
    en="{axis}[INDP … {word}] is commanded again in each tick that gets here",
    de="{axis}[INDP … {word}] wird in jedem Takt neu beauftragt, der hierher kommt",
    remedy_en="Put it under $IF EDGE or $IF ONCE.",
    remedy_de="Unter $IF EDGE oder $IF ONCE setzen.",
    cause_en="With G91 each command begins a new way where the axis is now; with BUFFERED each one "
    "wants a place behind the running motion.",
    cause_de="Mit G91 beginnt jeder Befehl einen neuen Weg dort, wo die Achse gerade ist; mit "
    "BUFFERED will jeder einen Platz hinter der laufenden Bewegung.",
    axis=("the axis", "die Achse"),
    word=("G91 or BUFFERED", "G91 oder BUFFERED"),
)
FEED_NOT_POSITIVE = warning(
    900903,
    en="the feed {value} is not above 0: a feed motion with it stops the program",
    de="der Vorschub {value} liegt nicht über 0: eine Vorschubbewegung damit hält das Programm an",
    remedy_en="Program F with a value above 0.",
    remedy_de="F mit einem Wert über 0 programmieren.",
    value=("the value", "der Wert"),
)
ARC_LIKELY_WITHOUT_CENTRE = warning(
    900906,
    en="this arc has no centre, and no radius has come before",
    de="dieser Kreisbogen hat keinen Mittelpunkt, und vorher kam kein Radius",
    remedy_en="Program the centre with I, J or K, or a radius R other than 0.",
    remedy_de="Den Mittelpunkt mit I, J oder K programmieren oder einen Radius R ungleich 0.",
    cause_en="Where the program runs so, it stops here with 900700.",
    cause_de="Läuft das Programm so, hält es hier mit 900700 an.",
)
TOOL_NOT_IN_LIST = warning(
    900928,
    en="T{tool}: the tool list has no tool of this number",
    de="T{tool}: die Werkzeugliste hat kein Werkzeug mit dieser Nummer",
    remedy_en="T tells the PLC a place; D selects dimensions, and would not find any for it.",
    remedy_de="T nennt der SPS einen Platz; D wählt Maße an und fände keine dafür.",
    tool=("the number of the tool", "die Nummer des Werkzeugs"),
)
POSITION_COMPARED_IN_INCH = note(
    901001,
    en="{name} is in inch here: the realtime cycle is defined under G70",
    de="{name} ist hier in Zoll: der Echtzeit-Zyklus wird unter G70 definiert",
    remedy_en="Compare with inches, or define the cycle under G71.",
    remedy_de="Mit Zoll vergleichen oder den Zyklus unter G71 definieren.",
    cause_en="A realtime cycle keeps the unit of its definition, for positions that it reads as "
    "for those that it commands.",
    cause_de="Ein Echtzeit-Zyklus behält die Einheit seiner Definition, für gelesene Positionen "
    "wie für befohlene.",
    name=("the position", "die Position"),
)
INDP_WORD_WITHOUT_EFFECT = note(
    901002,
    en="{word} has no effect here: {reason}",
    de="{word} wirkt hier nicht: {reason}",
    remedy_en="Leave it out.",
    remedy_de="Weglassen.",
    word=("the keyword", "das Schlüsselwort"),
    reason=("why it has none", "warum es nicht wirkt"),
)
