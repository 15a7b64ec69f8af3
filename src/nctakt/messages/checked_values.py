# SPDX-License-Identifier: MIT
"""Messages of checked program: variables and expressions (900213 … 900221, 900227 … 900228)."""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, WARNING, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_WORD = {"word": "the word as written"}
_NAME = {"name": "the variable"}
_NEAREST = {"nearest": "the most similar known name, or –"}

_add(
    900213,
    ERROR,
    "there is no variable {name}",
    "eine Variable {name} gibt es nicht",
    remedy_en="Most similar: {nearest}; names distinguish upper and lower case.",
    remedy_de="Am ähnlichsten: {nearest}; Groß- und Kleinschreibung zählt.",
    parameters={**_NAME, **_NEAREST},
)
_add(
    900214,
    ERROR,
    "{name} has {expected} indices here, not {given}",
    "{name} hat hier {expected} Indizes, nicht {given}",
    remedy_en="Write {expected} indices in brackets.",
    remedy_de="{expected} Indizes in Klammern schreiben.",
    parameters={**_NAME, "expected": "indices of the declaration", "given": "indices as written"},
)
_add(
    900215,
    ERROR,
    "{name} is a structure and no value",
    "{name} ist eine Struktur und kein Wert",
    remedy_en="Name a member: {member}",
    remedy_de="Ein Element angeben: {member}",
    parameters={**_NAME, "member": "the member that is probably meant"},
)
_add(
    900216,
    ERROR,
    "{name} is READ_ONLY and cannot be written",
    "{name} ist READ_ONLY und nicht beschreibbar",
    remedy_en="Write another variable, or change access_rights in the variables list.",
    remedy_de="Eine andere Variable beschreiben oder access_rights in der Variablenliste ändern.",
    parameters=_NAME,
)
_add(
    900217,
    ERROR,
    "{name} is WRITE_ONLY and cannot be read",
    "{name} ist WRITE_ONLY und nicht lesbar",
    remedy_en="Read another variable, or change access_rights in the variables list.",
    remedy_de="Eine andere Variable lesen oder access_rights in der Variablenliste ändern.",
    parameters=_NAME,
)
_add(
    900218,
    ERROR,
    "there is no function {word}",
    "eine Funktion {word} gibt es nicht",
    remedy_en="Most similar: {nearest}",
    remedy_de="Am ähnlichsten: {nearest}",
    parameters={**_WORD, **_NEAREST},
)
_add(
    900219,
    ERROR,
    "{word} takes {expected} arguments, not {given}",
    "{word} hat {expected} Argumente, nicht {given}",
    remedy_en="Write {expected} values in the brackets, commas between them.",
    remedy_de="{expected} Werte in die Klammern schreiben, durch Kommas getrennt.",
    parameters={
        **_WORD,
        "expected": "how many the function takes",
        "given": "how many are written",
    },
)
_add(
    900220,
    ERROR,
    "{word} asks about names or texts and has no place in a realtime cycle",
    "{word} fragt nach Namen oder Texten und hat im Echtzeit-Zyklus keinen Platz",
    remedy_en="Assign its value to a P parameter before, and read that one.",
    remedy_de="Den Wert vorher einem P-Parameter zuweisen und diesen lesen.",
    parameters=_WORD,
)
_add(
    900221,
    ERROR,
    "{word} is no value",
    "{word} ist kein Wert",
    remedy_en="Most similar: {nearest}; variables begin with V., functions have brackets.",
    remedy_de="Am ähnlichsten: {nearest}; Variablen beginnen mit V., Funktionen haben Klammern.",
    parameters={**_WORD, **_NEAREST},
)
_add(
    900227,
    WARNING,
    "{name} is asynchronous: its index is read once, too, when the cycle is defined",
    "{name} ist asynchron: auch der Index wird nur einmal gelesen, beim Definieren des Zyklus",
    remedy_en="Write Vs. in front of it, to read it in each tick.",
    remedy_de="Vs. davor schreiben, damit in jedem Takt gelesen wird.",
    cause_en="The value that the variable had when the definition was decoded stands in the cycle "
    "as a constant.",
    cause_de="Im Zyklus steht als Konstante der Wert, den die Variable beim Dekodieren der "
    "Definition hatte.",
    parameters=_NAME,
)
_add(
    900228,
    ERROR,
    "{name} is accessed with Vs. and without in one block",
    "{name} wird in einem Satz mit und ohne Vs. angesprochen",
    remedy_en="Write Vs. here, too: it is synchronous for the whole block.",
    remedy_de="Auch hier Vs. schreiben: sie ist für den ganzen Satz synchron.",
    parameters=_NAME,
)
_add(
    21993,
    ERROR,
    "{access} access to {name} is not defined: program {decoder}, realtime cycle {cycle}",
    "{access}-Zugriff auf {name} ist nicht definiert: Programm {decoder}, Echtzeit-Zyklus {cycle}",
    remedy_en="R is reading, W writing, – neither; move the access to where it is defined.",
    remedy_de="R ist Lesen, W Schreiben, – keines; den Zugriff dorthin verlegen, wo es ihn gibt.",
    cause_en="Each V.RTG and V.RTA variable has its rights apart for programs and for realtime "
    "cycles; nctakt explain shows them.",
    cause_de="Jede V.RTG- und V.RTA-Variable hat eigene Rechte für Programme und für Echtzeit-"
    "Zyklen; nctakt explain zeigt sie.",
    parameters={
        **_NAME,
        "access": "R for reading, W for writing",
        "decoder": "what programs may do",
        "cycle": "what realtime cycles may do",
    },
    reaction=2,
    clearing=3,
)
_add(
    50929,
    ERROR,
    "{variable} has no element {index}; there are {count}, counted from 0",
    "{variable} hat kein Element {index}; es gibt {count}, gezählt ab 0",
    remedy_en="Keep the index within the array, or enlarge it in the variables list.",
    remedy_de="Den Index im Feld halten oder das Feld in der Variablenliste vergrößern.",
    cause_en="Indices count from 0 and are rounded to the nearest whole number.",
    cause_de="Indizes zählen ab 0 und werden auf die nächste ganze Zahl gerundet.",
    parameters={
        "variable": "the array",
        "index": "the index",
        "count": "elements of the array",
    },
    reaction=6,
    clearing=6,
    known_as=(50895,),
)
_add(
    900136,
    ERROR,
    "there is no type {word}",
    "einen Typ {word} gibt es nicht",
    remedy_en="Most similar: {nearest}. Without a type a variable is REAL64.",
    remedy_de="Am ähnlichsten: {nearest}. Ohne Typ ist eine Variable REAL64.",
    parameters={**_WORD, **_NEAREST},
)
_add(
    900137,
    ERROR,
    "{word} is no variable that a program makes itself",
    "{word} ist keine Variable, die ein Programm selbst anlegt",
    remedy_en="Programs declare and delete these: {families}. V.E and V.CH stand in lists.",
    remedy_de="In Programmen angelegt und gelöscht werden: {families}. V.E und V.CH stehen in "
    "Listen.",
    parameters={**_WORD, "families": "the families of such variables"},
)
_add(
    900138,
    ERROR,
    "{word} is nothing that can be asked for",
    "nach {word} kann nicht gefragt werden",
    remedy_en="Ask for a variable, for @P1 … of a call, or for an M or H function: EXIST[M100]",
    remedy_de="Nach einer Variablen, nach @P1 … oder nach einer M- oder H-Funktion fragen: "
    "EXIST[M100]",
    parameters=_WORD,
)
_add(
    900139,
    ERROR,
    "{name} has more than {most} indices",
    "{name} hat mehr als {most} Indizes",
    remedy_en="Declare an array of at most {most} dimensions.",
    remedy_de="Ein Feld mit höchstens {most} Dimensionen anlegen.",
    parameters={**_NAME, "most": "the most indices"},
)
_add(
    900140,
    ERROR,
    "{name} cannot have {count} elements",
    "{name} kann nicht {count} Elemente haben",
    remedy_en="Write a whole number from 1 on.",
    remedy_de="Eine ganze Zahl ab 1 schreiben.",
    parameters={**_NAME, "count": "the number as written"},
)
