# SPDX-License-Identifier: MIT
"""Messages about checked programs: variables and expressions."""

from __future__ import annotations

from nctakt.messages.catalogue import error, warning

UNKNOWN_VARIABLE = error(
    900213,
    en="there is no variable {name}",
    de="eine Variable {name} gibt es nicht",
    remedy_en="Most similar: {nearest}; names distinguish upper and lower case.",
    remedy_de="Am ähnlichsten: {nearest}; Groß- und Kleinschreibung zählt.",
    name=("the variable", "die Variable"),
    nearest=("the most similar known name, or –", "der ähnlichste bekannte Name, oder –"),
)
UNKNOWN_AXIS_OF_VARIABLE = error(
    901003,
    en="{name}: this channel has no axis {axis}",
    de="{name}: dieser Kanal hat keine Achse {axis}",
    remedy_en="Axes of the channel: {axes}",
    remedy_de="Achsen des Kanals: {axes}",
    name=("the variable", "die Variable"),
    axis=("the axis as written", "die Achse, wie geschrieben"),
    axes=("the axes of the channel", "die Achsen des Kanals"),
)
WRONG_INDEX_COUNT = error(
    900214,
    en="{name} has {expected} indices here, not {given}",
    de="{name} hat hier {expected} Indizes, nicht {given}",
    remedy_en="Write {expected} indices in brackets.",
    remedy_de="{expected} Indizes in Klammern schreiben.",
    name=("the variable", "die Variable"),
    expected=("indices of the declaration", "Indizes der Deklaration"),
    given=("indices as written", "Indizes, wie geschrieben"),
)
STRUCTURE_USED_AS_VALUE = error(
    900215,
    en="{name} is a structure and no value",
    de="{name} ist eine Struktur und kein Wert",
    remedy_en="Name a member: {member}",
    remedy_de="Ein Element angeben: {member}",
    name=("the variable", "die Variable"),
    member=("the member that is probably meant", "das vermutlich gemeinte Element"),
)
VARIABLE_READ_ONLY = error(
    900216,
    en="{name} is READ_ONLY and cannot be written",
    de="{name} ist READ_ONLY und nicht beschreibbar",
    remedy_en="Write another variable, or change access_rights in the variables list.",
    remedy_de="Eine andere Variable beschreiben oder access_rights in der Variablenliste ändern.",
    name=("the variable", "die Variable"),
)
VARIABLE_WRITE_ONLY = error(
    900217,
    en="{name} is WRITE_ONLY and cannot be read",
    de="{name} ist WRITE_ONLY und nicht lesbar",
    remedy_en="Read another variable, or change access_rights in the variables list.",
    remedy_de="Eine andere Variable lesen oder access_rights in der Variablenliste ändern.",
    name=("the variable", "die Variable"),
)
UNKNOWN_EXPRESSION_FUNCTION = error(
    900218,
    en="there is no function {word}",
    de="eine Funktion {word} gibt es nicht",
    remedy_en="Most similar: {nearest}",
    remedy_de="Am ähnlichsten: {nearest}",
    word=("the word as written", "das Wort, wie geschrieben"),
    nearest=("the most similar known name, or –", "der ähnlichste bekannte Name, oder –"),
)
WRONG_ARGUMENT_COUNT = error(
    900219,
    en="{word} takes {expected} arguments, not {given}",
    de="{word} hat {expected} Argumente, nicht {given}",
    remedy_en="Write {expected} values in the brackets, commas between them.",
    remedy_de="{expected} Werte in die Klammern schreiben, durch Kommas getrennt.",
    word=("the word as written", "das Wort, wie geschrieben"),
    expected=("how many the function takes", "wie viele die Funktion hat"),
    given=("how many are written", "wie viele geschrieben sind"),
)
QUERY_IN_REALTIME_CYCLE = error(
    900220,
    en="{word} asks about names or texts and has no place in a realtime cycle",
    de="{word} fragt nach Namen oder Texten und hat im Echtzeit-Zyklus keinen Platz",
    remedy_en="Assign its value to a P parameter before, and read that one.",
    remedy_de="Den Wert vorher einem P-Parameter zuweisen und diesen lesen.",
    word=("the word as written", "das Wort, wie geschrieben"),
)
NOT_A_VALUE = error(
    900221,
    en="{word} is no value",
    de="{word} ist kein Wert",
    remedy_en="Most similar: {nearest}; variables begin with V., functions have brackets.",
    remedy_de="Am ähnlichsten: {nearest}; Variablen beginnen mit V., Funktionen haben Klammern.",
    word=("the word as written", "das Wort, wie geschrieben"),
    nearest=("the most similar known name, or –", "der ähnlichste bekannte Name, oder –"),
)
ASYNCHRONOUS_INDEX = warning(
    900227,
    en="{name} is asynchronous: its index is read once, too, when the cycle is defined",
    de="{name} ist asynchron: auch der Index wird nur einmal gelesen, beim Definieren des Zyklus",
    remedy_en="Write Vs. in front of it, to read it in each tick.",
    remedy_de="Vs. davor schreiben, damit in jedem Takt gelesen wird.",
    cause_en="The value that the variable had when the definition was decoded stands in the cycle "
    "as a constant.",
    cause_de="Im Zyklus steht als Konstante der Wert, den die Variable beim Dekodieren der "
    "Definition hatte.",
    name=("the variable", "die Variable"),
)
MIXED_SYNCHRONOUS_ACCESS = error(
    900228,
    en="{name} is accessed with Vs. and without in one block",
    de="{name} wird in einem Satz mit und ohne Vs. angesprochen",
    remedy_en="Write Vs. here, too: it is synchronous for the whole block.",
    remedy_de="Auch hier Vs. schreiben: sie ist für den ganzen Satz synchron.",
    name=("the variable", "die Variable"),
)
ACCESS_NOT_DEFINED = error(
    21993,
    en="{access} access to {name} is not defined: program {decoder}, realtime cycle {cycle}",
    de="{access}-Zugriff auf {name} ist nicht definiert: Programm {decoder}, Echtzeit-Zyklus "
    "{cycle}",
    remedy_en="R is reading, W writing, – neither; move the access to where it is defined.",
    remedy_de="R ist Lesen, W Schreiben, – keines; den Zugriff dorthin verlegen, wo es ihn gibt.",
    cause_en="Each V.RTG and V.RTA variable has its rights apart for programs and for realtime "
    "cycles; nctakt explain shows them.",
    cause_de="Jede V.RTG- und V.RTA-Variable hat eigene Rechte für Programme und für "
    "Echtzeit-Zyklen; nctakt explain zeigt sie.",
    name=("the variable", "die Variable"),
    access=("R for reading, W for writing", "R für Lesen, W für Schreiben"),
    decoder=("what programs may do", "was Programme dürfen"),
    cycle=("what realtime cycles may do", "was Echtzeit-Zyklen dürfen"),
    reaction=2,
    clearing=3,
)
INDEX_OUT_OF_RANGE = error(
    50929,
    en="{variable} has no element {index}; there are {count}, counted from 0",
    de="{variable} hat kein Element {index}; es gibt {count}, gezählt ab 0",
    remedy_en="Keep the index within the array, or enlarge it in the variables list.",
    remedy_de="Den Index im Feld halten oder das Feld in der Variablenliste vergrößern.",
    cause_en="Indices count from 0 and are rounded to the nearest whole number.",
    cause_de="Indizes zählen ab 0 und werden auf die nächste ganze Zahl gerundet.",
    variable=("the array", "das Feld"),
    index=("the index", "der Index"),
    count=("elements of the array", "Elemente des Feldes"),
    reaction=6,
    clearing=6,
    known_as=(50895,),
)
UNKNOWN_TYPE = error(
    900136,
    en="there is no type {word}",
    de="einen Typ {word} gibt es nicht",
    remedy_en="Most similar: {nearest}. Without a type a variable is REAL64.",
    remedy_de="Am ähnlichsten: {nearest}. Ohne Typ ist eine Variable REAL64.",
    word=("the word as written", "das Wort, wie geschrieben"),
    nearest=("the most similar known name, or –", "der ähnlichste bekannte Name, oder –"),
)
NOT_A_PROGRAM_VARIABLE = error(
    900137,
    en="{word} is no variable that a program makes itself",
    de="{word} ist keine Variable, die ein Programm selbst anlegt",
    remedy_en="Programs declare and delete these: {families}. V.E and V.CH stand in lists.",
    remedy_de="In Programmen angelegt und gelöscht werden: {families}. V.E und V.CH stehen in "
    "Listen.",
    word=("the word as written", "das Wort, wie geschrieben"),
    families=("the families of such variables", "die Familien solcher Variablen"),
)
INVALID_EXIST_ARGUMENT = error(
    900138,
    en="{word} is nothing that can be asked for",
    de="nach {word} kann nicht gefragt werden",
    remedy_en="Ask for a variable, for @P1 … of a call, or for an M or H function: EXIST[M100]",
    remedy_de="Nach einer Variablen, nach @P1 … oder nach einer M- oder H-Funktion fragen: "
    "EXIST[M100]",
    word=("the word as written", "das Wort, wie geschrieben"),
)
TOO_MANY_INDICES = error(
    900139,
    en="{name} has more than {most} indices",
    de="{name} hat mehr als {most} Indizes",
    remedy_en="Declare an array of at most {most} dimensions.",
    remedy_de="Ein Feld mit höchstens {most} Dimensionen anlegen.",
    name=("the variable", "die Variable"),
    most=("the most indices", "die meisten Indizes"),
)
INVALID_ELEMENT_COUNT = error(
    900140,
    en="{name} cannot have {count} elements",
    de="{name} kann nicht {count} Elemente haben",
    remedy_en="Write a whole number from 1 on.",
    remedy_de="Eine ganze Zahl ab 1 schreiben.",
    name=("the variable", "die Variable"),
    count=("the number as written", "die Anzahl, wie geschrieben"),
)
