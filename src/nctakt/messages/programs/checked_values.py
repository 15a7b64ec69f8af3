# SPDX-License-Identifier: MIT
"""Messages about checked programs: variables and expressions."""

from __future__ import annotations

from nctakt.messages.cases import by_beginning, by_counts
from nctakt.messages.catalogue import error, warning

UNKNOWN_VARIABLE = error(
    20196,
    classes=(0, 0),
    known_as=(900213, 20092, 20394),
    cases=by_beginning("name", {"V.P.": 20932, "V.L.": 20932, "V.S.": 20932, "V.I.": 21761}),
    en="unknown variable {name}",
    de="unbekannte Variable {name}",
    remedy_en="Did you mean {nearest}? Names are case-sensitive. {declared}",
    remedy_de="War {nearest} gemeint? Groß- und Kleinschreibung zählt. {declared}",
    declared=("where such variables are declared, or –", "wo man sie deklariert, oder –"),
)
UNKNOWN_AXIS_OF_VARIABLE = error(
    901003,
    en="{name}: this channel has no axis {axis}",
    de="{name}: dieser Kanal hat keine Achse {axis}",
    remedy_en="Axes of the channel: {axes}",
    remedy_de="Achsen des Kanals: {axes}",
)
WRONG_INDEX_COUNT = error(
    20974,
    classes=(0, 0),
    known_as=(900214,),
    cases=by_counts(few=21216, many=20974, none=21768),
    en="wrong number of indices for {name}: {expected} expected, {given} given",
    de="falsche Anzahl von Indizes bei {name}: {expected} erwartet, {given} angegeben",
    remedy_en="Indices needed in brackets: {expected}.",
    remedy_de="Benötigte Indizes in Klammern: {expected}.",
    expected=("the number of declared indices", "die Anzahl der deklarierten Indizes"),
    given=("the number of indices as written", "die Anzahl der angegebenen Indizes"),
)
STRUCTURE_USED_AS_VALUE = error(
    900215,
    known_as=(21446, 21979),
    en="{name} is a structure, not a single value",
    de="{name} ist eine Struktur, kein einzelner Wert",
    remedy_en="Use a member: {member}",
    remedy_de="Ein Element angeben: {member}",
    member=("the member that was probably meant", "das vermutlich gemeinte Element"),
)
VARIABLE_READ_ONLY = error(
    20100,
    classes=(0, 0),
    known_as=(900216,),
    en="{name} is READ_ONLY and cannot be written",
    de="{name} ist READ_ONLY und nicht beschreibbar",
    remedy_en="Write another variable, or change access_rights in the variables list.",
    remedy_de="Eine andere Variable beschreiben oder access_rights in der Variablenliste ändern.",
)
VARIABLE_WRITE_ONLY = error(
    20097,
    classes=(0, 0),
    known_as=(900217,),
    en="{name} is WRITE_ONLY and cannot be read",
    de="{name} ist WRITE_ONLY und nicht lesbar",
    remedy_en="Read another variable, or change access_rights in the variables list.",
    remedy_de="Eine andere Variable lesen oder access_rights in der Variablenliste ändern.",
)
UNKNOWN_EXPRESSION_FUNCTION = error(
    20392,
    classes=(0, 0),
    known_as=(900218,),
    en="unknown function {word}",
    de="unbekannte Funktion {word}",
    remedy_en="Did you mean {nearest}?",
    remedy_de="War {nearest} gemeint?",
)
WRONG_ARGUMENT_COUNT = error(
    21474,
    classes=(0, 0),
    known_as=(900219,),
    cases=by_counts(few=21471, many=21474),
    en="wrong number of arguments for {word}: {expected} expected, {given} given",
    de="falsche Anzahl von Argumenten bei {word}: {expected} erwartet, {given} angegeben",
    remedy_en="Write {expected} values in the brackets, separated by commas.",
    remedy_de="{expected} Werte in die Klammern schreiben, durch Kommas getrennt.",
    expected=("the number of arguments of the function", "die Anzahl der Argumente der Funktion"),
    given=("the number of arguments as written", "die Anzahl der angegebenen Argumente"),
)
QUERY_IN_REALTIME_CYCLE = error(
    900220,
    known_as=(22002,),
    en="{word} asks for names or texts and is not allowed in a realtime cycle",
    de="{word} fragt nach Namen oder Texten und ist im Echtzeit-Zyklus nicht erlaubt",
    remedy_en="Assign its value to a P parameter first, and read that parameter.",
    remedy_de="Den Wert vorher einem P-Parameter zuweisen und diesen lesen.",
)
NOT_A_VALUE = error(
    20392,
    classes=(0, 0),
    known_as=(900221,),
    en="{word} is not a value",
    de="{word} ist kein Wert",
    remedy_en="Did you mean {nearest}? Variables begin with V., functions have brackets.",
    remedy_de="War {nearest} gemeint? Variablen beginnen mit V., Funktionen haben Klammern.",
)
ASYNCHRONOUS_INDEX = warning(
    900227,
    en="{name} is asynchronous: its index, too, is read only once, when the cycle is defined",
    de="{name} ist asynchron: auch der Index wird nur einmal gelesen, beim Definieren des Zyklus",
    remedy_en="Write Vs. before it to read it in each tick.",
    remedy_de="Vs. davor schreiben, damit in jedem Takt gelesen wird.",
    cause_en="The cycle holds the value that the variable had when the definition was decoded, as "
    "a constant.",
    cause_de="Der Zyklus enthält als Konstante den Wert, den die Variable beim Dekodieren der "
    "Definition hatte.",
)
MIXED_SYNCHRONOUS_ACCESS = error(
    900228,
    en="{name} is accessed both with and without Vs. in one block",
    de="{name} wird in einem Satz mit und ohne Vs. angesprochen",
    remedy_en="Write Vs. here, too: the variable is synchronous for the whole block.",
    remedy_de="Auch hier Vs. schreiben: die Variable ist für den ganzen Satz synchron.",
)
ACCESS_NOT_DEFINED = error(
    21993,
    en="{access} access to {name} is not available here: program {decoder}, realtime cycle {cycle}",
    de="{access}-Zugriff auf {name} gibt es hier nicht: Programm {decoder}, Echtzeit-Zyklus "
    "{cycle}",
    remedy_en="R is read, W write, – none; move the access to where it is available.",
    remedy_de="R heißt Lesen, W Schreiben, – keines; den Zugriff dorthin verlegen, wo es ihn gibt.",
    cause_en="Each V.RTG and V.RTA variable has separate rights for programs and for realtime "
    "cycles; nctakt explain shows them.",
    cause_de="Jede V.RTG- und V.RTA-Variable hat eigene Rechte für Programme und für "
    "Echtzeit-Zyklen; nctakt explain zeigt sie.",
    access=("R for reading, W for writing", "R für Lesen, W für Schreiben"),
    decoder=("what programs may do", "was Programme dürfen"),
    cycle=("what realtime cycles may do", "was Echtzeit-Zyklen dürfen"),
)
INDEX_OUT_OF_RANGE = error(
    21928,
    en="{variable} has no element {index}; it has {count} elements, counted from 0",
    de="{variable} hat kein Element {index}; es gibt {count} Elemente, gezählt ab 0",
    remedy_en="Keep it below {count}. The list sizes V.E and V.CH, #VAR V.P, V.S and V.L; all "
    "others are built in.",
    remedy_de="Unter {count} bleiben. V.E und V.CH bemisst die Liste, V.P, V.S und V.L #VAR; die "
    "übrigen sind fest.",
    cause_en="Indices count from 0 and are rounded to the nearest whole number.",
    cause_de="Indizes zählen ab 0 und werden auf die nächste ganze Zahl gerundet.",
    variable=("the array", "das Feld"),
    count=("elements of the array", "Elemente des Feldes"),
)
CYCLE_INDEX_OUT_OF_RANGE = error(
    50929,
    cases=by_beginning("variable", {"V.E.": 50895}),
    en="{variable} has no element {index} in this tick; it has {count} elements, counted from 0",
    de="{variable} hat in diesem Takt kein Element {index}; es gibt {count}, gezählt ab 0",
    remedy_en="Keep it below {count}. The list sizes V.E and V.CH, #VAR V.P, V.S and V.L; all "
    "others are built in.",
    remedy_de="Unter {count} bleiben. V.E und V.CH bemisst die Liste, V.P, V.S und V.L #VAR; die "
    "übrigen sind fest.",
    cause_en="Indices count from 0 and are rounded to the nearest whole number.",
    cause_de="Indizes zählen ab 0 und werden auf die nächste ganze Zahl gerundet.",
    variable=("the array", "das Feld"),
    count=("elements of the array", "Elemente des Feldes"),
    classes=(6, 6),
)
UNKNOWN_TYPE = error(
    900136,
    known_as=(20904, 21603),
    en="unknown type {word}",
    de="unbekannter Typ {word}",
    remedy_en="Did you mean {nearest}? A variable without a type is REAL64.",
    remedy_de="War {nearest} gemeint? Ohne Typ ist eine Variable REAL64.",
)
NOT_A_PROGRAM_VARIABLE = error(
    20908,
    classes=(0, 0),
    known_as=(900137, 20915, 20931),
    en="{word} is not a variable that programs can create",
    de="{word} ist keine Variable, die ein Programm anlegen kann",
    remedy_en="Programs create and delete {families}. V.E and V.CH are declared in lists.",
    remedy_de="Programme legen {families} an und löschen sie. V.E und V.CH werden in Listen "
    "deklariert.",
    families=("the families of such variables", "die Familien solcher Variablen"),
)
INVALID_EXIST_ARGUMENT = error(
    20868,
    classes=(0, 0),
    known_as=(900138, 21023, 22254, 22275),
    en="{word} cannot be queried",
    de="{word} kann nicht abgefragt werden",
    remedy_en="Query a variable, @P1 … of a call, or an M or H function: EXIST[M100]",
    remedy_de="Eine Variable, @P1 … eines Aufrufs oder eine M- oder H-Funktion abfragen: "
    "EXIST[M100]",
)
TOO_MANY_INDICES = error(
    20974,
    classes=(0, 0),
    known_as=(900139, 20924),
    en="{name} has more than {maximum} indices",
    de="{name} hat mehr als {maximum} Indizes",
    remedy_en="Declare an array of at most {maximum} dimensions.",
    remedy_de="Ein Feld mit höchstens {maximum} Dimensionen anlegen.",
    maximum=("the maximum number of indices", "die größte Anzahl von Indizes"),
)
INVALID_ELEMENT_COUNT = error(
    20917,
    classes=(0, 0),
    known_as=(900140, 20906),
    en="{name} cannot have {count} elements",
    de="{name} kann nicht {count} Elemente haben",
    remedy_en="Write a whole number of at least 1.",
    remedy_de="Eine ganze Zahl ab 1 schreiben.",
)
