# SPDX-License-Identifier: MIT
"""Messages about the decoder, while it evaluates a program."""

from __future__ import annotations

from nctakt.messages.catalogue import error, warning

NO_FEED_ACTIVE = error(
    20008,
    en="no feed is active for this feed motion",
    de="für diese Vorschubbewegung ist kein Vorschub aktiv",
    remedy_en="Program F with a value above 0, or give P-CHAN-00099 a start value.",
    remedy_de="F mit einem Wert über 0 programmieren oder P-CHAN-00099 einen Startwert geben.",
    cause_en="A block with G01 moves at the feed F, and no F has been given since the program's "
    "start.",
    cause_de="Ein Satz mit G01 fährt mit dem Vorschub F; seit Programmstart ist keiner angegeben.",
    reaction=2,
    clearing=3,
)
ARGUMENT_OUT_OF_RANGE = error(
    21241,
    en="the argument of {operation} is outside its range",
    de="das Argument von {operation} liegt außerhalb seines Bereichs",
    remedy_en="Test the argument before, for example with $IF.",
    remedy_de="Das Argument vorher prüfen, zum Beispiel mit $IF.",
    cause_en="Angles are in degrees. Roots need 0 or more, logarithms more than 0, ASIN and ACOS "
    "−1 … 1; TAN and COT have poles.",
    cause_de="Winkel sind in Grad. Wurzeln brauchen Werte ab 0, Logarithmen über 0, ASIN und ACOS "
    "−1 … 1; TAN und COT haben Pole.",
    operation=("the function", "die Funktion"),
    reaction=2,
    clearing=3,
)
OPERATION_WITHOUT_RESULT = error(
    900300,
    en="the operation {operation} has no result for these operands",
    de="die Operation {operation} hat für diese Operanden kein Ergebnis",
    remedy_en="Test the operands before: a divisor of 0, a negative base or too large bit "
    "patterns.",
    remedy_de="Die Operanden vorher prüfen: Divisor 0, negative Basis oder zu große Bitmuster.",
    operation=("the operator", "der Operator"),
    reaction=2,
    clearing=3,
)
RESULT_TOO_LARGE = error(
    900301,
    en="the result of this expression is too large for a number",
    de="das Ergebnis dieses Ausdrucks ist zu groß für eine Zahl",
    remedy_en="Keep intermediate results below 1.8e308.",
    remedy_de="Zwischenergebnisse unter 1,8e308 halten.",
    reaction=2,
    clearing=3,
)
FOR_STEP_ZERO = warning(
    900302,
    en="the step of this $FOR is 0: it never ends by itself",
    de="die Schrittweite dieses $FOR ist 0: es endet nicht von selbst",
    remedy_en="Give a step other than 0, or leave the loop with $BREAK.",
    remedy_de="Eine Schrittweite ungleich 0 angeben oder die Schleife mit $BREAK verlassen.",
)
TOO_MANY_BLOCKS_WITHOUT_TIME = error(
    900303,
    en="{count} blocks in a row without one that takes time: a loop that never moves?",
    de="{count} Sätze hintereinander ohne einen, der Zeit braucht: eine Schleife ohne Bewegung?",
    remedy_en="Give the loop an end, or let it move, dwell (#TIME) or wait (#FLUSH WAIT).",
    remedy_de="Die Schleife beenden oder in ihr fahren, verweilen (#TIME), warten (#FLUSH WAIT).",
    cause_en="Such a loop would be decoded for ever, and no tick would come.",
    cause_de="Eine solche Schleife würde endlos dekodiert, und kein Takt käme.",
    count=("the most blocks that are decoded so", "die meisten Sätze, die so dekodiert werden"),
    reaction=2,
    clearing=3,
)
MSG_FORMAT_MISMATCH = error(
    900304,
    en="format and values of this #MSG do not fit together at '{found}'",
    de="Format und Werte dieses #MSG passen bei '{found}' nicht zusammen",
    remedy_en="Give one value for each %d, %f, %s … of the format.",
    remedy_de="Zu jedem %d, %f, %s … des Formats einen Wert angeben.",
    found=(
        "the place in the format, or the value, that is too much",
        "der überzählige Platz im Format oder Wert",
    ),
    reaction=2,
    clearing=3,
)
INVALID_DWELL_TIME = error(
    900305,
    en="a dwell of {seconds} s is not possible",
    de="eine Verweilzeit von {seconds} s ist nicht möglich",
    remedy_en="Program a time of 0 s or more.",
    remedy_de="Eine Zeit von 0 s oder mehr programmieren.",
    seconds=("the time", "die Zeit"),
    reaction=2,
    clearing=3,
)
TARGET_OUTSIDE_LIMITS = error(
    900306,
    en="the target {position} of axis {axis} is outside its software limits {low} … {high}",
    de="das Ziel {position} der Achse {axis} liegt außerhalb der Software-Endschalter {low} … "
    "{high}",
    remedy_en="Program a position between the limits (P-AXIS-00177, P-AXIS-00178).",
    remedy_de="Eine Position zwischen den Grenzen programmieren (P-AXIS-00177, P-AXIS-00178).",
    axis=("name of the axis", "Name der Achse"),
    position=("target in mm or degrees", "Ziel in mm oder Grad"),
    low=("lower limit", "untere Grenze"),
    high=("upper limit", "obere Grenze"),
    reaction=2,
    clearing=3,
)
PROGRAMS_NESTED_TOO_DEEP = error(
    900307,
    en="more than {limit} programs inside each other: does a subprogram call itself for ever?",
    de="mehr als {limit} Programme ineinander: ruft sich ein Unterprogramm endlos selbst?",
    remedy_en="Give the recursion an end, or call one program after the other.",
    remedy_de="Der Rekursion ein Ende geben oder die Programme nacheinander rufen.",
    limit=(
        "the most programs inside each other, the main program included",
        "die meisten Programme ineinander, mit dem Hauptprogramm",
    ),
    reaction=2,
    clearing=3,
)
STRUCTURES_AND_CALLS_TOO_DEEP = error(
    900308,
    en="structures and subprograms are nested deeper than {limit}",
    de="Strukturen und Unterprogramme sind tiefer als {limit} geschachtelt",
    remedy_en="Nest less deeply.",
    remedy_de="Weniger tief schachteln.",
    limit=("the deepest nesting", "die tiefste Schachtelung"),
    reaction=2,
    clearing=3,
)
RETURN_LABEL_NOT_UNIQUE = error(
    900309,
    en="{name} has no single label {label} to go on at",
    de="{name} hat keine eindeutige Sprungmarke {label}, bei der es weiterginge",
    remedy_en="The label of M17 stands once in the program that goes on, in no loop.",
    remedy_de="Die Marke von M17 steht einmal im Programm, das weiterläuft, in keiner Schleife.",
    name=("the program", "das Programm"),
    label=("the label", "die Sprungmarke"),
    reaction=2,
    clearing=3,
)
TOO_FEW_OPEN_CALLS = error(
    900310,
    en="{count} calls are not open, but {most}",
    de="{count} Aufrufe sind nicht offen, sondern {most}",
    remedy_en="JUMPS counts from 1 to the number of calls; MAIN leads to the main program.",
    remedy_de="JUMPS zählt von 1 bis zur Zahl der Aufrufe; MAIN führt ins Hauptprogramm.",
    count=("the number behind JUMPS", "die Zahl hinter JUMPS"),
    most=("how many calls are open", "wie viele Aufrufe offen sind"),
    reaction=2,
    clearing=3,
)
JUMP_TARGET_NOT_NC_TEXT = error(
    900311,
    en="a jump has led here, and this is no NC text",
    de="ein Sprung hat hierher geführt, und dies ist kein NC-Text",
    remedy_en="Remove the text, or lead the jump to another label.",
    remedy_de="Den Text entfernen oder den Sprung zu einer anderen Marke führen.",
    reaction=2,
    clearing=3,
)
CALL_PARAMETER_MISSING = error(
    900312,
    en="the call has handed over no {name}",
    de="der Aufruf hat kein {name} übergeben",
    remedy_en="Call with L CYCLE [NAME=… {name}=…], or ask with EXIST[{name}].",
    remedy_de="Mit L CYCLE [NAME=… {name}=…] rufen oder mit EXIST[{name}] fragen.",
    name=("the parameter of the call", "der Parameter des Aufrufs"),
    reaction=2,
    clearing=3,
)
VALUE_OUTSIDE_TYPE_RANGE = error(
    900313,
    en="{name} cannot hold {value}: its type goes from {low} to {high}",
    de="{name} kann {value} nicht aufnehmen: ihr Typ reicht von {low} bis {high}",
    remedy_en="Declare it with a wider type, or keep the value within.",
    remedy_de="Sie mit einem weiteren Typ anlegen oder den Wert darin halten.",
    name=("the variable", "die Variable"),
    value=("the value", "der Wert"),
    low=("the lowest value", "der kleinste Wert"),
    high=("the highest value", "der größte Wert"),
    reaction=2,
    clearing=3,
)
VARIABLE_NOT_PRESENT = error(
    900314,
    en="there is no {name} now",
    de="{name} gibt es jetzt nicht",
    remedy_en="Nearest: {nearest}. Declare it in #VAR before; V.L lives as long as its program.",
    remedy_de="Am nächsten: {nearest}. Vorher in #VAR anlegen; V.L lebt so lange wie ihr Programm.",
    name=("the variable", "die Variable"),
    nearest=("the nearest variable that there is", "die nächste Variable, die es gibt"),
    reaction=2,
    clearing=3,
)
VALUE_COUNT_MISMATCH = error(
    900315,
    en="{given} values for {name}, which has {count} elements",
    de="{given} Werte für {name}, die {count} Elemente hat",
    remedy_en="Give at most as many values as there are elements.",
    remedy_de="Höchstens so viele Werte angeben, wie es Elemente gibt.",
    name=("the variable", "die Variable"),
    given=("how many values are given", "wie viele Werte angegeben sind"),
    count=("how many elements there are", "wie viele Elemente es gibt"),
    reaction=2,
    clearing=3,
)
TOO_MANY_ELEMENTS = error(
    900316,
    en="{name} would have {count} elements; {most} are possible",
    de="{name} hätte {count} Elemente; möglich sind {most}",
    remedy_en="Declare a smaller array.",
    remedy_de="Ein kleineres Feld anlegen.",
    name=("the variable", "die Variable"),
    count=("how many elements there are", "wie viele Elemente es gibt"),
    most=("the most elements", "die meisten Elemente"),
    reaction=2,
    clearing=3,
)
VALUE_LIST_FOR_ONE_ELEMENT = error(
    900317,
    en="a list of values is no value of one element",
    de="eine Liste von Werten ist kein Wert eines einzelnen Elements",
    remedy_en="Write the array without indices, or a single value.",
    remedy_de="Das Feld ohne Indizes schreiben oder einen einzelnen Wert.",
    reaction=2,
    clearing=3,
)
UNKNOWN_TIMER = error(
    900318,
    en="there is no timer {id}",
    de="einen Zähler {id} gibt es nicht",
    remedy_en="Timers have whole numbers from 0 to {most}.",
    remedy_de="Zähler haben ganze Nummern von 0 bis {most}.",
    id=("the number as written", "die Anzahl, wie geschrieben"),
    most=("the highest number", "die größte Zahl"),
    reaction=2,
    clearing=3,
)
UNKNOWN_MACRO = error(
    900319,
    en='no macro "{name}" is defined now',
    de='ein Makro "{name}" ist jetzt nicht definiert',
    remedy_en='Nearest: {nearest}. Write "{name}" = "text" before; upper and lower case count.',
    remedy_de='Am nächsten: {nearest}. Vorher "{name}" = "Text" schreiben; Groß- und '
    "Kleinschreibung zählt.",
    name=("the name", "der Name"),
    nearest=("the known name that is most like it", "der ähnlichste bekannte Name"),
    reaction=2,
    clearing=3,
)
MACROS_NESTED_TOO_DEEP = error(
    900848,
    en='macro "{name}": more than {limit} macros stand inside each other',
    de='Makro "{name}": mehr als {limit} Makros stehen ineinander',
    remedy_en="A macro must not stand in its own text, nor in one that it uses.",
    remedy_de="Ein Makro darf weder in seinem eigenen Text stehen noch in einem, den es benutzt.",
    name=("the innermost macro", "das innerste Makro"),
    limit=("the limit", "die Grenze"),
    reaction=2,
    clearing=3,
)
MACRO_TEXT_TOO_LONG = error(
    900849,
    en='macro "{name}": its block would become more than {limit} characters',
    de='Makro "{name}": sein Satz würde länger als {limit} Zeichen',
    remedy_en="Put part of it into a subprogram, or into several blocks.",
    remedy_de="Einen Teil davon in ein Unterprogramm legen oder auf mehrere Sätze verteilen.",
    cause_en="A macro that has others in its text can become a text of any length.",
    cause_de="Ein Makro mit weiteren Makros im Text kann beliebig lang werden.",
    name=("the macro at which the limit is passed", "das Makro, bei dem die Grenze erreicht ist"),
    limit=("the limit", "die Grenze"),
    reaction=2,
    clearing=3,
)
G194_ABOVE_MAX_FEED = error(
    900925,
    en="G194: {value} % is more than the highest feed",
    de="G194: {value} % ist mehr als der höchste Vorschub",
    remedy_en="Under G194 F is a share of the highest feed: above 0, at most {most} %.",
    remedy_de="Unter G194 ist F ein Anteil am höchsten Vorschub: über 0, höchstens {most} %.",
    value=("the value as programmed", "der Wert, wie programmiert"),
    most=("upper limit", "obere Grenze"),
    reaction=2,
    clearing=3,
)
NEGATIVE_FEED = error(
    900926,
    en="the feed of this motion is negative",
    de="der Vorschub dieser Bewegung ist negativ",
    remedy_en="Program F with a value above 0; the target says where the motion goes.",
    remedy_de="F mit einem Wert über 0 programmieren; wohin es geht, sagt das Ziel.",
    reaction=2,
    clearing=3,
)
