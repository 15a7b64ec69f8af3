# SPDX-License-Identifier: MIT
"""Messages of ``nctakt check`` on programs that would run: what is likely meant otherwise.

Numbers 900235 … 900259, 900903, 900906, 900928, and the controller's own
where it is an error there.
"""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, NOTE, WARNING, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_NAME = {"name": "the variable"}
_FROZEN = {
    **_NAME,
    "meaning_en": "with which value it is read, in English",
    "meaning_de": "with which value it is read, in German",
}
_STEPS = {
    "steps": "elementary instructions of one run-through at most",
    "limit": "elementary instructions that are allowed in a tick",
}

_add(
    900235,
    WARNING,
    "{name} is asynchronous: in every tick this condition sees {meaning_en}",
    "{name} ist asynchron: in jedem Takt sieht diese Bedingung {meaning_de}",
    remedy_en="For the value of each tick: synchronisation TRUE in the variables list, or Vs. "
    "here.",
    remedy_de="Für den Wert jedes Takts: synchronisation TRUE in der Variablenliste, oder Vs. "
    "hier.",
    cause_en="The decoder builds a cycle from its definition; what is asynchronous becomes a "
    "number then.",
    cause_de="Der Dekoder baut den Zyklus aus seiner Definition; Asynchrones wird dabei zu einer "
    "Zahl.",
    parameters=_FROZEN,
)
_add(
    900236,
    NOTE,
    "{name} is read once: in every tick the realtime cycle sees {meaning_en}",
    "{name} wird einmal gelesen: in jedem Takt sieht der Echtzeit-Zyklus {meaning_de}",
    remedy_en="What shall change while the cycle runs belongs into a synchronous V.E or V.CH.",
    remedy_de="Was sich ändern soll, während der Zyklus läuft, gehört in ein synchrones V.E, V.CH.",
    cause_en="The decoder builds a cycle from its definition; what is asynchronous becomes a "
    "number then.",
    cause_de="Der Dekoder baut den Zyklus aus seiner Definition; Asynchrones wird dabei zu einer "
    "Zahl.",
    parameters=_FROZEN,
)
_add(
    900237,
    WARNING,
    "this condition is a constant and can never change",
    "diese Bedingung ist eine Konstante und kann sich nie ändern",
    remedy_en="Leave the $IF out, or its body; $IF ONCE 1 is the way to say 'once'.",
    remedy_de="Das $IF weglassen oder seinen Inhalt; 'einmal' schreibt man als $IF ONCE 1.",
)
_add(
    900238,
    WARNING,
    "this condition can never change: of {names} it sees {meaning_en}",
    "diese Bedingung kann sich nie ändern: von {names} sieht sie {meaning_de}",
    remedy_en="Ask for something synchronous; a choice made once stands around #RT CYCLE.",
    remedy_de="Nach etwas Synchronem fragen; eine einmalige Wahl steht um #RT CYCLE herum.",
    parameters={"names": "the variables", **{k: v for k, v in _FROZEN.items() if k != "name"}},
)
_add(
    900239,
    WARNING,
    "{name} is of type {type}: this comparison is {meaning_en}, whatever its value is",
    "{name} ist vom Typ {type}: dieser Vergleich ist {meaning_de}, welchen Wert sie auch hat",
    remedy_en="It holds whole numbers from {low} to {high}; compare with one of them.",
    remedy_de="Sie fasst ganze Zahlen von {low} bis {high}; mit einer davon vergleichen.",
    parameters={
        **_NAME,
        "type": "its type",
        "meaning_en": "never true or always true",
        "meaning_de": "the same in German",
        "low": "its least value",
        "high": "its greatest value",
    },
)
_add(
    900240,
    NOTE,
    "$IF {word} inside $IF: it is asked only in ticks that get here, else it keeps its state",
    "$IF {word} in $IF: gefragt wird nur in Takten, die hierher kommen, sonst bleibt sein Zustand",
    remedy_en="That is right where it is meant; else make it the outer one, or join the conditions "
    "with &&.",
    remedy_de="Richtig, wenn es so gemeint ist; sonst nach außen setzen oder die Bedingungen mit "
    "&& verbinden.",
    cause_en="An $IF that is not reached keeps what it knows: a latched ALWAYS stays latched, "
    "EDGE compares with the tick in which it was last reached.",
    cause_de="Ein $IF, das nicht erreicht wird, behält, was es weiß: ALWAYS bleibt gesetzt, EDGE "
    "vergleicht mit dem Takt, in dem es zuletzt erreicht wurde.",
    parameters={"word": "ONCE, EDGE or ALWAYS"},
)
_add(
    900241,
    WARNING,
    "this $IF stands in $IF {word}: it is asked only in the one tick in which that fires",
    "dieses $IF steht in $IF {word}: gefragt wird nur in dem einen Takt, in dem jenes auslöst",
    remedy_en="What shall be watched from then on belongs into $IF ALWAYS.",
    remedy_de="Was von da an beobachtet werden soll, gehört in $IF ALWAYS.",
    parameters={"word": "ONCE or EDGE"},
)
_add(
    900242,
    WARNING,
    "{name} is written under $IF {word}: the override lasts one tick, then it is 100 % again",
    "{name} wird unter $IF {word} geschrieben: der Override gilt einen Takt, dann wieder 100 %",
    remedy_en="Write it in each tick in which it shall hold: under a plain $IF or $IF ALWAYS",
    remedy_de="In jedem Takt schreiben, in dem er gelten soll: unter einfachem $IF oder $IF ALWAYS",
    cause_en="The CYCLE overrides are 100 % at the start of each tick; whoever wants another "
    "value writes it in each tick.",
    cause_de="Die CYCLE-Overrides sind am Anfang jedes Takts 100 %; wer einen anderen Wert will, "
    "schreibt ihn in jedem Takt.",
    parameters={**_NAME, "word": "ONCE or EDGE"},
)
_add(
    900243,
    WARNING,
    "{word} is output again in each tick that gets here; the PLC's interface has few places",
    "{word} wird in jedem Takt neu ausgegeben; die Schnittstelle zur SPS hat wenige Plätze",
    remedy_en="Put it under $IF EDGE or $IF ONCE; too many that wait for the PLC are 50942.",
    remedy_de="Unter $IF EDGE oder $IF ONCE setzen; warten zu viele auf die SPS, kommt 50942.",
    cause_en="Each output takes a place of the realtime section of the interface until the PLC "
    "acknowledges it.",
    cause_de="Jede Ausgabe belegt einen Platz im Echtzeit-Bereich der Schnittstelle, bis die SPS "
    "sie quittiert.",
    parameters={"word": "the M or H function"},
)
_add(
    900244,
    NOTE,
    "the realtime cycle of line {line} writes {names}, too; in each tick the last one wins",
    "auch der Echtzeit-Zyklus von Zeile {line} schreibt {names}; in jedem Takt gewinnt der letzte",
    remedy_en="Let one cycle write it, or mind that they run in the order of their definition.",
    remedy_de="Nur einen Zyklus schreiben lassen oder bedenken: sie laufen in der Reihenfolge "
    "ihrer Definition.",
    cause_en="All cycles run once in each tick, in the order of their definition; what the last "
    "one has written stays.",
    cause_de="Alle Zyklen laufen in jedem Takt einmal, in der Reihenfolge ihrer Definition; es "
    "bleibt, was der letzte geschrieben hat.",
    parameters={"names": "the variables", "line": "the line in which the other cycle begins"},
)
_add(
    900245,
    NOTE,
    "no program that was checked deletes the GLOBAL realtime cycle {id}; it runs until the "
    "controller is restarted",
    "kein geprüftes Programm löscht den GLOBAL-Echtzeit-Zyklus {id}; er läuft bis zum Neustart "
    "der Steuerung",
    remedy_en="#RT CYCLE DELETE [ID={id}] ends it; until then the program cannot define it again.",
    remedy_de="#RT CYCLE DELETE [ID={id}] beendet ihn; bis dahin kann ihn das Programm nicht neu "
    "definieren.",
    cause_en="A GLOBAL cycle outlives its program and runs between programs, too.",
    cause_de="Ein GLOBAL-Zyklus überlebt sein Programm und läuft auch zwischen Programmen.",
    parameters={"id": "the ID of the cycle"},
)
_add(
    900246,
    WARNING,
    "this realtime cycle can need {steps} elementary instructions; P-CHAN-00427 allows {limit}",
    "dieser Echtzeit-Zyklus kann {steps} Elementar-Anweisungen brauchen; P-CHAN-00427 erlaubt "
    "{limit}",
    remedy_en="Shorten it, or raise rt_cycles.max_steps; beyond it the cycle ends with 50854.",
    remedy_de="Kürzen oder rt_cycles.max_steps erhöhen; darüber endet der Zyklus mit 50854.",
    cause_en="The dearest way through its branches is counted: each operator, function, access, "
    "assignment, condition and action is one.",
    cause_de="Gezählt wird der teuerste Weg durch die Zweige: jeder Operator, jede Funktion, "
    "jeder Zugriff, jede Zuweisung, Bedingung und Aktion ist eine.",
    parameters=_STEPS,
)
_add(
    900247,
    WARNING,
    "this realtime cycle can need {steps} elementary instructions; P-CHAN-00425 has time for "
    "{limit}",
    "dieser Echtzeit-Zyklus kann {steps} Elementar-Anweisungen brauchen; P-CHAN-00425 lässt Zeit "
    "für {limit}",
    remedy_en="Shorten it, or raise rt_cycles.max_duration; beyond it the cycle ends with 50939.",
    remedy_de="Kürzen oder rt_cycles.max_duration erhöhen; darüber endet der Zyklus mit 50939.",
    cause_en="In virtual time each elementary instruction takes 10 ns; more than the share of "
    "P-CHAN-00425 in the tick ends the cycle.",
    cause_de="In virtueller Zeit dauert jede Elementar-Anweisung 10 ns; mehr als der Anteil von "
    "P-CHAN-00425 am Takt beendet den Zyklus.",
    parameters=_STEPS,
)
_add(
    900248,
    NOTE,
    "{name} is compared exactly: an axis in motion hardly meets the very value in a tick",
    "{name} wird exakt verglichen: eine bewegte Achse trifft den Wert kaum genau in einem Takt",
    remedy_en="Ask for passing the value: >= or <=",
    remedy_de="Nach dem Überschreiten fragen: >= oder <=",
    cause_en="Positions are numbers with all their digits; from tick to tick a moving axis goes "
    "many of them further.",
    cause_de="Positionen sind Zahlen mit allen Stellen; von Takt zu Takt überspringt eine bewegte "
    "Achse die meisten.",
    parameters=_NAME,
)
_add(
    20651,
    ERROR,
    "{command} empties the channel, which cannot be while {word} is active",
    "{command} entleert den Kanal, was nicht geht, solange {word} aktiv ist",
    remedy_en="Move it in front of {word} or behind G40; realtime cycles may read such variables.",
    remedy_de="Vor {word} oder hinter G40 verlegen; Echtzeit-Zyklen dürfen solche Variablen lesen.",
    cause_en="Where a motion of the contour ends only the one behind it shows, so that the path "
    "cannot stand and wait.",
    cause_de="Wo eine Bewegung der Kontur endet, zeigt erst die nächste: die Bahn kann nicht "
    "stehen und warten.",
    parameters={"command": "the variable or command", "word": "G41 or G42"},
    reaction=2,
    clearing=3,
)
_add(
    900270,
    WARNING,
    "{axis}[INDP … {word}] is commanded again in each tick that gets here",
    "{axis}[INDP … {word}] wird in jedem Takt neu beauftragt, der hierher kommt",
    remedy_en="Put it under $IF EDGE or $IF ONCE.",
    remedy_de="Unter $IF EDGE oder $IF ONCE setzen.",
    cause_en="With G91 each command begins a new way where the axis is now; with BUFFERED each one "
    "wants a place behind the running motion.",
    cause_de="Mit G91 beginnt jeder Befehl einen neuen Weg dort, wo die Achse gerade ist; mit "
    "BUFFERED will jeder einen Platz hinter der laufenden Bewegung.",
    parameters={"axis": "the axis", "word": "G91 or BUFFERED"},
)
_add(
    900903,
    WARNING,
    "the feed {value} is not above 0: a feed motion with it stops the program",
    "der Vorschub {value} liegt nicht über 0: eine Vorschubbewegung damit hält das Programm an",
    remedy_en="Program F with a value above 0.",
    remedy_de="F mit einem Wert über 0 programmieren.",
    parameters={"value": "the value"},
)
_add(
    900906,
    WARNING,
    "this arc has no centre, and no radius has come before",
    "dieser Kreisbogen hat keinen Mittelpunkt, und vorher kam kein Radius",
    remedy_en="Program the centre with I, J or K, or a radius R other than 0.",
    remedy_de="Den Mittelpunkt mit I, J oder K programmieren oder einen Radius R ungleich 0.",
    cause_en="Where the program runs so, it stops here with 900700.",
    cause_de="Läuft das Programm so, hält es hier mit 900700 an.",
)
_add(
    900928,
    WARNING,
    "T{tool}: the tool list has no tool of this number",
    "T{tool}: die Werkzeugliste hat kein Werkzeug mit dieser Nummer",
    remedy_en="T tells the PLC a place; D selects dimensions, and would not find any for it.",
    remedy_de="T nennt der SPS einen Platz; D wählt Maße an und fände keine dafür.",
    parameters={"tool": "the number of the tool"},
)
