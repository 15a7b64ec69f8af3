# SPDX-License-Identifier: MIT
"""Messages of the decoder, while it evaluates (900300 … 900399, 900848, 900925, 900926)."""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, WARNING, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_add(
    20008,
    ERROR,
    "no feed is active for this feed motion",
    "für diese Vorschubbewegung ist kein Vorschub aktiv",
    remedy_en="Program F with a value above 0, or give P-CHAN-00099 a start value.",
    remedy_de="F mit einem Wert über 0 programmieren oder P-CHAN-00099 einen Startwert geben.",
    cause_en="A block with G01 moves at the feed F, and no F has been given since the program's "
    "start.",
    cause_de="Ein Satz mit G01 fährt mit dem Vorschub F; seit Programmstart ist keiner angegeben.",
    reaction=2,
    clearing=3,
)
_add(
    21241,
    ERROR,
    "the argument of {operation} is outside its range",
    "das Argument von {operation} liegt außerhalb seines Bereichs",
    remedy_en="Test the argument before, for example with $IF.",
    remedy_de="Das Argument vorher prüfen, zum Beispiel mit $IF.",
    cause_en="Angles are in degrees. Roots need 0 or more, logarithms more than 0, ASIN and ACOS "
    "−1 … 1; TAN and COT have poles.",
    cause_de="Winkel sind in Grad. Wurzeln brauchen Werte ab 0, Logarithmen über 0, ASIN und ACOS "
    "−1 … 1; TAN und COT haben Pole.",
    parameters={"operation": "the function"},
    reaction=2,
    clearing=3,
)
_add(
    900300,
    ERROR,
    "the operation {operation} has no result for these operands",
    "die Operation {operation} hat für diese Operanden kein Ergebnis",
    remedy_en="Test the operands before: a divisor of 0, a negative base or too large bit "
    "patterns.",
    remedy_de="Die Operanden vorher prüfen: Divisor 0, negative Basis oder zu große Bitmuster.",
    parameters={"operation": "the operator"},
    reaction=2,
    clearing=3,
)
_add(
    900301,
    ERROR,
    "the result of this expression is too large for a number",
    "das Ergebnis dieses Ausdrucks ist zu groß für eine Zahl",
    remedy_en="Keep intermediate results below 1.8e308.",
    remedy_de="Zwischenergebnisse unter 1,8e308 halten.",
    reaction=2,
    clearing=3,
)
_add(
    900302,
    WARNING,
    "the step of this $FOR is 0: it never ends by itself",
    "die Schrittweite dieses $FOR ist 0: es endet nicht von selbst",
    remedy_en="Give a step other than 0, or leave the loop with $BREAK.",
    remedy_de="Eine Schrittweite ungleich 0 angeben oder die Schleife mit $BREAK verlassen.",
)
_add(
    900303,
    ERROR,
    "{count} blocks in a row without one that takes time: a loop that never moves?",
    "{count} Sätze hintereinander ohne einen, der Zeit braucht: eine Schleife ohne Bewegung?",
    remedy_en="Give the loop an end, or let it move, dwell (#TIME) or wait (#FLUSH WAIT).",
    remedy_de="Die Schleife beenden oder in ihr fahren, verweilen (#TIME), warten (#FLUSH WAIT).",
    cause_en="Such a loop would be decoded for ever, and no tick would come.",
    cause_de="Eine solche Schleife würde endlos dekodiert, und kein Takt käme.",
    parameters={"count": "the most blocks that are decoded so"},
    reaction=2,
    clearing=3,
)
_add(
    900304,
    ERROR,
    "format and values of this #MSG do not fit together at '{found}'",
    "Format und Werte dieses #MSG passen bei '{found}' nicht zusammen",
    remedy_en="Give one value for each %d, %f, %s … of the format.",
    remedy_de="Zu jedem %d, %f, %s … des Formats einen Wert angeben.",
    parameters={"found": "the place in the format, or the value, that is too much"},
    reaction=2,
    clearing=3,
)
_add(
    900305,
    ERROR,
    "a dwell of {seconds} s is not possible",
    "eine Verweilzeit von {seconds} s ist nicht möglich",
    remedy_en="Program a time of 0 s or more.",
    remedy_de="Eine Zeit von 0 s oder mehr programmieren.",
    parameters={"seconds": "the time"},
    reaction=2,
    clearing=3,
)
_add(
    900306,
    ERROR,
    "the target {position} of axis {axis} is outside its software limits {low} … {high}",
    "das Ziel {position} der Achse {axis} liegt außerhalb der Software-Endschalter {low} … {high}",
    remedy_en="Program a position between the limits (P-AXIS-00177, P-AXIS-00178).",
    remedy_de="Eine Position zwischen den Grenzen programmieren (P-AXIS-00177, P-AXIS-00178).",
    parameters={
        "axis": "name of the axis",
        "position": "target in mm or degrees",
        "low": "lower limit",
        "high": "upper limit",
    },
    reaction=2,
    clearing=3,
)
_add(
    900307,
    ERROR,
    "more than {limit} programs inside each other: does a subprogram call itself for ever?",
    "mehr als {limit} Programme ineinander: ruft sich ein Unterprogramm endlos selbst?",
    remedy_en="Give the recursion an end, or call one program after the other.",
    remedy_de="Der Rekursion ein Ende geben oder die Programme nacheinander rufen.",
    parameters={"limit": "the most programs inside each other, the main program included"},
    reaction=2,
    clearing=3,
)
_add(
    900308,
    ERROR,
    "structures and subprograms are nested deeper than {limit}",
    "Strukturen und Unterprogramme sind tiefer als {limit} geschachtelt",
    remedy_en="Nest less deeply.",
    remedy_de="Weniger tief schachteln.",
    parameters={"limit": "the deepest nesting"},
    reaction=2,
    clearing=3,
)
_add(
    900309,
    ERROR,
    "{name} has no single label {label} to go on at",
    "{name} hat keine eindeutige Sprungmarke {label}, bei der es weiterginge",
    remedy_en="The label of M17 stands once in the program that goes on, in no loop.",
    remedy_de="Die Marke von M17 steht einmal im Programm, das weiterläuft, in keiner Schleife.",
    parameters={"name": "the program", "label": "the label"},
    reaction=2,
    clearing=3,
)
_add(
    900310,
    ERROR,
    "{count} calls are not open, but {most}",
    "{count} Aufrufe sind nicht offen, sondern {most}",
    remedy_en="JUMPS counts from 1 to the number of calls; MAIN leads to the main program.",
    remedy_de="JUMPS zählt von 1 bis zur Zahl der Aufrufe; MAIN führt ins Hauptprogramm.",
    parameters={"count": "the number behind JUMPS", "most": "how many calls are open"},
    reaction=2,
    clearing=3,
)
_add(
    900311,
    ERROR,
    "a jump has led here, and this is no NC text",
    "ein Sprung hat hierher geführt, und dies ist kein NC-Text",
    remedy_en="Remove the text, or lead the jump to another label.",
    remedy_de="Den Text entfernen oder den Sprung zu einer anderen Marke führen.",
    reaction=2,
    clearing=3,
)
_add(
    900312,
    ERROR,
    "the call has handed over no {name}",
    "der Aufruf hat kein {name} übergeben",
    remedy_en="Call with L CYCLE [NAME=… {name}=…], or ask with EXIST[{name}].",
    remedy_de="Mit L CYCLE [NAME=… {name}=…] rufen oder mit EXIST[{name}] fragen.",
    parameters={"name": "the parameter of the call"},
    reaction=2,
    clearing=3,
)
_add(
    900313,
    ERROR,
    "{name} cannot hold {value}: its type goes from {low} to {high}",
    "{name} kann {value} nicht aufnehmen: ihr Typ reicht von {low} bis {high}",
    remedy_en="Declare it with a wider type, or keep the value within.",
    remedy_de="Sie mit einem weiteren Typ anlegen oder den Wert darin halten.",
    parameters={
        "name": "the variable",
        "value": "the value",
        "low": "the lowest value",
        "high": "the highest value",
    },
    reaction=2,
    clearing=3,
)
_add(
    900314,
    ERROR,
    "there is no {name} now",
    "{name} gibt es jetzt nicht",
    remedy_en="Nearest: {nearest}. Declare it in #VAR before; V.L lives as long as its program.",
    remedy_de="Am nächsten: {nearest}. Vorher in #VAR anlegen; V.L lebt so lange wie ihr Programm.",
    parameters={"name": "the variable", "nearest": "the nearest variable that there is"},
    reaction=2,
    clearing=3,
)
_add(
    900315,
    ERROR,
    "{given} values for {name}, which has {count} elements",
    "{given} Werte für {name}, die {count} Elemente hat",
    remedy_en="Give at most as many values as there are elements.",
    remedy_de="Höchstens so viele Werte angeben, wie es Elemente gibt.",
    parameters={
        "name": "the variable",
        "given": "how many values are given",
        "count": "how many elements there are",
    },
    reaction=2,
    clearing=3,
)
_add(
    900316,
    ERROR,
    "{name} would have {count} elements; {most} are possible",
    "{name} hätte {count} Elemente; möglich sind {most}",
    remedy_en="Declare a smaller array.",
    remedy_de="Ein kleineres Feld anlegen.",
    parameters={
        "name": "the variable",
        "count": "how many elements there are",
        "most": "the most elements",
    },
    reaction=2,
    clearing=3,
)
_add(
    900317,
    ERROR,
    "a list of values is no value of one element",
    "eine Liste von Werten ist kein Wert eines einzelnen Elements",
    remedy_en="Write the array without indices, or a single value.",
    remedy_de="Das Feld ohne Indizes schreiben oder einen einzelnen Wert.",
    reaction=2,
    clearing=3,
)
_add(
    900318,
    ERROR,
    "there is no timer {id}",
    "einen Zähler {id} gibt es nicht",
    remedy_en="Timers have whole numbers from 0 to {most}.",
    remedy_de="Zähler haben ganze Nummern von 0 bis {most}.",
    parameters={"id": "the number as written", "most": "the highest number"},
    reaction=2,
    clearing=3,
)
_add(
    900319,
    ERROR,
    'no macro "{name}" is defined now',
    'ein Makro "{name}" ist jetzt nicht definiert',
    remedy_en='Nearest: {nearest}. Write "{name}" = "text" before; upper and lower case count.',
    remedy_de='Am nächsten: {nearest}. Vorher "{name}" = "Text" schreiben; Groß- und '
    "Kleinschreibung zählt.",
    parameters={"name": "the name", "nearest": "the known name that is most like it"},
    reaction=2,
    clearing=3,
)
_add(
    900848,
    ERROR,
    'macro "{name}": more than {limit} macros stand inside each other',
    'Makro "{name}": mehr als {limit} Makros stehen ineinander',
    remedy_en="A macro must not stand in its own text, nor in one that it uses.",
    remedy_de="Ein Makro darf weder in seinem eigenen Text stehen noch in einem, den es benutzt.",
    parameters={"name": "the innermost macro", "limit": "the limit"},
    reaction=2,
    clearing=3,
)
_add(
    900849,
    ERROR,
    'macro "{name}": its block would become more than {limit} characters',
    'Makro "{name}": sein Satz würde länger als {limit} Zeichen',
    remedy_en="Put part of it into a subprogram, or into several blocks.",
    remedy_de="Einen Teil davon in ein Unterprogramm legen oder auf mehrere Sätze verteilen.",
    cause_en="A macro that has others in its text can become a text of any length.",
    cause_de="Ein Makro mit weiteren Makros im Text kann beliebig lang werden.",
    parameters={"name": "the macro at which the limit is passed", "limit": "the limit"},
    reaction=2,
    clearing=3,
)
_add(
    900925,
    ERROR,
    "G194: {value} % is more than the highest feed",
    "G194: {value} % ist mehr als der höchste Vorschub",
    remedy_en="Under G194 F is a share of the highest feed: above 0, at most {most} %.",
    remedy_de="Unter G194 ist F ein Anteil am höchsten Vorschub: über 0, höchstens {most} %.",
    parameters={"value": "the value as programmed", "most": "upper limit"},
    reaction=2,
    clearing=3,
)
_add(
    900926,
    ERROR,
    "the feed of this motion is negative",
    "der Vorschub dieser Bewegung ist negativ",
    remedy_en="Program F with a value above 0; the target says where the motion goes.",
    remedy_de="F mit einem Wert über 0 programmieren; wohin es geht, sagt das Ziel.",
    reaction=2,
    clearing=3,
)
