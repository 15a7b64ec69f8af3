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
    remedy_en="shorten cycle {cycle} or another one, or raise rt_cycles.max_steps (P-CHAN-00427)",
    remedy_de="Zyklus {cycle} oder andere kürzen oder rt_cycles.max_steps (P-CHAN-00427) erhöhen",
    parameters={"cycle": "cycle at fault", "steps": "instructions so far", "limit": "the limit"},
    reaction=6,
    clearing=6,
)
_add(
    50858,
    ERROR,
    "no realtime cycle has the ID {id}",
    "kein Echtzeit-Zyklus hat die ID {id}",
    remedy_en="define the cycle before, and mind its scope: it may have ended already",
    remedy_de="den Zyklus vorher definieren; seine Gültigkeit beachten: er kann schon beendet sein",
    parameters={"id": "the ID"},
    reaction=6,
    clearing=6,
)
_add(
    50877,
    ERROR,
    "more than {count} realtime cycles at once",
    "mehr als {count} Echtzeit-Zyklen zugleich",
    remedy_en="delete cycles that are no longer needed with #RT CYCLE DELETE",
    remedy_de="nicht mehr gebrauchte Zyklen mit #RT CYCLE DELETE löschen",
    parameters={"count": "the most cycles of a channel"},
    reaction=6,
    clearing=6,
)
_add(
    50879,
    ERROR,
    "'{operation}' in realtime cycle {cycle} has no usable result",
    "'{operation}' im Echtzeit-Zyklus {cycle} hat kein brauchbares Ergebnis",
    remedy_en="test the operands with $IF before; '=' stands for a result that is too large",
    remedy_de="die Operanden vorher mit $IF prüfen; '=' steht für ein zu großes Ergebnis",
    parameters={"cycle": "cycle at fault", "operation": "operator or function"},
    reaction=6,
    clearing=6,
)
_add(
    50892,
    ERROR,
    "{value} is outside the range {low} … {high} of {variable}",
    "{value} liegt außerhalb des Bereichs {low} … {high} von {variable}",
    remedy_en="limit the value, or give the variable a larger type",
    remedy_de="den Wert begrenzen oder der Variablen einen größeren Typ geben",
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
    remedy_en="give a finite number",
    remedy_de="eine endliche Zahl angeben",
    parameters={"name": "the variable", "value": "the value"},
    reaction=6,
    clearing=6,
)
_add(
    50900,
    ERROR,
    "the ID {id} belongs to another realtime cycle already",
    "die ID {id} gehört schon einem anderen Echtzeit-Zyklus",
    remedy_en="choose another ID, or delete the other cycle before with #RT CYCLE DELETE",
    remedy_de="eine andere ID wählen oder den anderen Zyklus vorher mit #RT CYCLE DELETE löschen",
    parameters={"id": "the ID"},
    reaction=6,
    clearing=6,
)
_add(
    50939,
    ERROR,
    "the realtime cycles take too long: {steps} elementary instructions, time is for {limit}",
    "die Echtzeit-Zyklen dauern zu lange: {steps} Elementar-Anweisungen, Zeit ist für {limit}",
    remedy_en="shorten cycle {cycle} or others, or raise rt_cycles.max_duration (P-CHAN-00425)",
    remedy_de="Zyklus {cycle} oder andere kürzen, rt_cycles.max_duration (P-CHAN-00425) erhöhen",
    parameters={
        "cycle": "cycle at fault",
        "steps": "instructions so far",
        "limit": "instructions for which the share of the tick lasts",
    },
    reaction=6,
    clearing=6,
)
_add(
    50942,
    ERROR,
    "{function} cannot be handed to the PLC: all {slots} places of the interface are taken",
    "{function} kann der SPS nicht übergeben werden: alle {slots} Plätze der Schnittstelle belegt",
    remedy_en="let the PLC acknowledge in every tick, or output fewer functions",
    remedy_de="die SPS in jedem Takt quittieren lassen oder weniger Funktionen ausgeben",
    parameters={"function": "the function", "slots": "places of the realtime section"},
    reaction=6,
    clearing=6,
)
_add(
    50943,
    ERROR,
    "{function} is one function too many in this tick: the interface holds {slots}",
    "{function} ist in diesem Takt eine Funktion zu viel: die Schnittstelle fasst {slots}",
    remedy_en="spread the functions over several ticks",
    remedy_de="die Funktionen auf mehrere Takte verteilen",
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
)
_add(
    900411,
    NOTE,
    "the realtime cycle does not run: HOLD has no effect",
    "der Echtzeit-Zyklus läuft nicht: HOLD bewirkt nichts",
    remedy_en="",
    remedy_de="",
)
_add(
    900412,
    NOTE,
    "the realtime cycle is not held: CONTINUE has no effect",
    "der Echtzeit-Zyklus ist nicht angehalten: CONTINUE bewirkt nichts",
    remedy_en="",
    remedy_de="",
)
_add(
    900413,
    NOTE,
    "a realtime cycle with scope BLOCK ended with the program without having run",
    "ein Echtzeit-Zyklus mit Gültigkeit BLOCK endete mit dem Programm, ohne gelaufen zu sein",
    remedy_en="",
    remedy_de="",
)
_add(
    900420,
    ERROR,
    "the block does not begin where the axes stand",
    "der Satz beginnt nicht dort, wo die Achsen stehen",
    remedy_en="let the decoder read the positions anew before, with #FLUSH WAIT or #CHANNEL INIT",
    remedy_de="den Dekoder die Positionen vorher neu lesen lassen: #FLUSH WAIT, #CHANNEL INIT",
    reaction=6,
    clearing=6,
)
