# SPDX-License-Identifier: MIT
"""Messages about the decoder, while it evaluates a program."""

from __future__ import annotations

from nctakt.messages.cases import by_beginning, by_limit, by_sign, by_word, in_case, number
from nctakt.messages.catalogue import error, warning

NO_FEED_ACTIVE = error(
    20008,
    en="no feed is active for this feed motion",
    de="für diese Vorschubbewegung ist kein Vorschub aktiv",
    remedy_en="Program F with a value above 0, or give P-CHAN-00099 a start value.",
    remedy_de="F mit einem Wert über 0 programmieren oder P-CHAN-00099 einen Startwert geben.",
    cause_en="A G01 block moves at the feed F, and no F has been given since the start of the "
    "program.",
    cause_de="Ein G01-Satz fährt mit dem Vorschub F; seit Programmstart ist keiner programmiert.",
)
ARGUMENT_OUT_OF_RANGE = error(
    21241,
    cases=by_word(
        "operation",
        {"SQRT": 20398, "LN": 20399, "LOG": 20399, "EXP": 21739, "DEXP": 21739, "INV": 20396},
    ),
    en="the argument of {operation} is out of range",
    de="das Argument von {operation} liegt außerhalb des gültigen Bereichs",
    remedy_en="Check the argument first, for example with $IF.",
    remedy_de="Das Argument vorher prüfen, zum Beispiel mit $IF.",
    cause_en="Angles are in degrees. Roots need 0 or more, logarithms more than 0, ASIN and ACOS "
    "−1 … 1; TAN and COT have poles.",
    cause_de="Winkel sind in Grad. Wurzeln brauchen Werte ab 0, Logarithmen über 0, ASIN und ACOS "
    "−1 … 1; TAN und COT haben Pole.",
    operation=("the function", "die Funktion"),
)
OPERATION_WITHOUT_RESULT = error(
    20396,
    known_as=(900300, 20574, 21959, 21272),
    cases=by_beginning("operation", {"&": 20978, "|": 20978, "^": 20978}),
    en="the operation {operation} has no result for these operands",
    de="die Operation {operation} hat für diese Operanden kein Ergebnis",
    remedy_en="Check the operands first: a divisor of 0, a negative base, or bit patterns that are "
    "too large.",
    remedy_de="Die Operanden vorher prüfen: Divisor 0, negative Basis oder zu große Bitmuster.",
    operation=("the operator", "der Operator"),
)
RESULT_TOO_LARGE = error(
    21739,
    known_as=(900301, 21880, 21881, 21882, 21883),
    en="the result of this expression is too large for a number",
    de="das Ergebnis dieses Ausdrucks ist zu groß für eine Zahl",
    remedy_en="Keep intermediate results below 1.8e308.",
    remedy_de="Zwischenergebnisse unter 1,8e308 halten.",
)
FOR_STEP_ZERO = error(
    20852,
    known_as=(900302,),
    en="the step of this $FOR is 0",
    de="die Schrittweite dieses $FOR ist 0",
    remedy_en="Give a step other than 0; for a loop that only $BREAK ends, write $WHILE 1.",
    remedy_de="Eine Schrittweite ungleich 0 angeben; $WHILE 1, wenn nur $BREAK sie beendet.",
)
TOO_MANY_BLOCKS_WITHOUT_TIME = error(
    900303,
    en="{count} blocks in a row take no time: a loop that never moves?",
    de="{count} Sätze hintereinander brauchen keine Zeit: eine Schleife ohne Bewegung?",
    remedy_en="Give the loop an end, or let it move, dwell (#TIME) or wait (#FLUSH WAIT).",
    remedy_de="Die Schleife enden lassen oder in ihr fahren, verweilen (#TIME) oder warten (#FLUSH "
    "WAIT).",
    cause_en="Such a loop would be decoded forever, and no tick would ever run.",
    cause_de="Eine solche Schleife würde endlos dekodiert, und es käme nie ein Takt.",
    count=("the maximum number of such blocks", "die größte Anzahl solcher Sätze"),
    classes=(2, 3),
)
MSG_FORMAT_MISMATCH = error(
    20721,
    known_as=(900304,),
    en="format and values of this #MSG do not match at '{found}'",
    de="Format und Werte dieses #MSG passen bei '{found}' nicht zusammen",
    remedy_en="Give one value for each %d, %f, %s … of the format.",
    remedy_de="Zu jedem %d, %f, %s … des Formats einen Wert angeben.",
    found=("the surplus placeholder or value", "der überzählige Platzhalter oder Wert"),
)
INVALID_DWELL_TIME = error(
    20751,
    known_as=(900305, 20015, 20752, 50764),
    cases=by_sign("seconds", negative=20017),
    en="a dwell time of {seconds} s is not possible",
    de="eine Verweilzeit von {seconds} s ist nicht möglich",
    remedy_en="Program a time of 0 s or more.",
    remedy_de="Eine Zeit von 0 s oder mehr programmieren.",
    seconds=("the time", "die Zeit"),
)
TARGET_OUTSIDE_LIMITS = error(
    120002,
    known_as=(900306, 50041, 50042),
    cases=by_limit("position", above=120002, below=120003),
    en="the target {position} of axis {axis} is outside its software limits {low} … {high}",
    de="das Ziel {position} der Achse {axis} liegt außerhalb ihrer Software-Endschalter {low} … "
    "{high}",
    remedy_en="Program a position between the limits (P-AXIS-00177, P-AXIS-00178).",
    remedy_de="Eine Position zwischen den Grenzen programmieren (P-AXIS-00177, P-AXIS-00178).",
    position=("target in mm or degrees", "Ziel in mm oder Grad"),
)
PROGRAMS_NESTED_TOO_DEEP = error(
    20365,
    known_as=(900307, 20360, 20361, 20371),
    en="more than {limit} nested programs: does a subprogram call itself forever?",
    de="mehr als {limit} geschachtelte Programme: ruft sich ein Unterprogramm endlos selbst auf?",
    remedy_en="Give the recursion an end, or call the programs one after the other.",
    remedy_de="Der Rekursion ein Ende geben oder die Programme nacheinander aufrufen.",
    limit=(
        "the maximum nesting, the main program included",
        "die größte Schachtelung, einschließlich Hauptprogramm",
    ),
)
STRUCTURES_AND_CALLS_TOO_DEEP = error(
    20211,
    known_as=(900308,),
    en="structures and subprograms are nested deeper than {limit}",
    de="Strukturen und Unterprogramme sind tiefer als {limit} geschachtelt",
    remedy_en="Nest less deeply.",
    remedy_de="Weniger tief schachteln.",
    limit=("the maximum nesting", "die größte Schachtelung"),
)
RETURN_LABEL_NOT_UNIQUE = error(
    20836,
    known_as=(900309, 20840),
    en="{name} has no unique label {label} to continue at",
    de="{name} hat keine eindeutige Sprungmarke {label} zum Fortsetzen",
    remedy_en="The label of M17 must appear once in the program that continues, outside loops.",
    remedy_de="Die Marke von M17 muss im weiterlaufenden Programm genau einmal stehen, außerhalb "
    "von Schleifen.",
    name=("the program", "das Programm"),
)
TOO_FEW_OPEN_CALLS = warning(
    22268,
    known_as=(900310,),
    en="there are not {count} open calls, only {maximum}: the main program continues",
    de="es sind keine {count} Aufrufe offen, nur {maximum}: das Hauptprogramm läuft weiter",
    remedy_en="JUMPS counts from 1 to the number of open calls; MAIN returns to the main program.",
    remedy_de="JUMPS zählt von 1 bis zur Anzahl offener Aufrufe; MAIN führt ins Hauptprogramm.",
    count=("the number after JUMPS", "die Zahl hinter JUMPS"),
    maximum=("the number of open calls", "die Anzahl offener Aufrufe"),
    classes=(1, 1),
)
JUMP_TARGET_NOT_NC_TEXT = error(
    900311,
    known_as=(20797,),
    en="a jump has led here, and this is not valid NC text",
    de="ein Sprung hat hierher geführt, und dies ist kein gültiger NC-Text",
    remedy_en="Remove the text, or jump to another label.",
    remedy_de="Den Text entfernen oder zu einer anderen Marke springen.",
    classes=(2, 3),
)
CALL_PARAMETER_MISSING = error(
    20925,
    known_as=(900312, 20394, 20934),
    en="the call has not passed {name}",
    de="der Aufruf hat {name} nicht übergeben",
    remedy_en="Call with L CYCLE [NAME=… {name}=…], or check with EXIST[{name}].",
    remedy_de="Mit L CYCLE [NAME=… {name}=…] aufrufen oder mit EXIST[{name}] prüfen.",
    name=("the parameter of the call", "der Parameter des Aufrufs"),
)
PARAMETER_ARRAY_MISSING = error(
    20921,
    classes=(2, 3),
    en="there is no array {name} of parameters at this point",
    de="es gibt an dieser Stelle kein Feld {name} von Parametern",
    remedy_en="Declare it before, in separate lines: #VAR, {name}[3] = [1, 2, 3], #ENDVAR.",
    remedy_de="Vorher in eigenen Zeilen anlegen: #VAR, {name}[3] = [1, 2, 3], #ENDVAR.",
    name=("the array", "das Feld"),
)
VALUE_OUTSIDE_TYPE_RANGE = error(
    20847,
    known_as=(900313, 20084),
    en="{name} cannot hold {value}: its type ranges from {low} to {high}",
    de="{name} kann {value} nicht aufnehmen: ihr Typ reicht von {low} bis {high}",
    remedy_en="Declare it with a larger type, or keep the value within the range.",
    remedy_de="Sie mit einem größeren Typ anlegen oder den Wert im Bereich halten.",
)
VARIABLE_NOT_PRESENT = error(
    20932,
    known_as=(900314, 20933),
    en="{name} does not exist at this point",
    de="{name} gibt es an dieser Stelle nicht",
    remedy_en="Did you mean {nearest}? Declare it in #VAR first; a V.L variable lives as long as "
    "its program.",
    remedy_de="War {nearest} gemeint? Vorher in #VAR anlegen; eine V.L-Variable lebt so lange wie "
    "ihr Programm.",
    nearest=("the most similar variable that exists", "die ähnlichste vorhandene Variable"),
)
VALUE_COUNT_MISMATCH = error(
    900315,
    cases=in_case(20912, lambda values: number(values["given"]) > number(values["count"])),
    en="{given} values for {name}, which has {count} elements",
    de="{given} Werte für {name}, die {count} Elemente hat",
    remedy_en="Give at most as many values as there are elements.",
    remedy_de="Höchstens so viele Werte angeben, wie es Elemente gibt.",
    given=("the number of values", "die Anzahl der Werte"),
    count=("the number of elements", "die Anzahl der Elemente"),
    classes=(2, 3),
)
TOO_MANY_ELEMENTS = error(
    20917,
    known_as=(900316, 20906, 21602),
    en="{name} would have {count} elements; {maximum} are possible",
    de="{name} hätte {count} Elemente; möglich sind {maximum}",
    remedy_en="Declare a smaller array.",
    remedy_de="Ein kleineres Feld anlegen.",
    count=("the number of elements", "die Anzahl der Elemente"),
    maximum=("the maximum number of elements", "die größte Anzahl von Elementen"),
)
VALUE_LIST_FOR_ONE_ELEMENT = error(
    900317,
    known_as=(20912, 21920),
    en="a list of values cannot be assigned to a single element",
    de="einem einzelnen Element kann keine Werteliste zugewiesen werden",
    remedy_en="Write the array without indices, or a single value.",
    remedy_de="Das Feld ohne Indizes oder einen einzelnen Wert schreiben.",
    classes=(2, 3),
)
UNKNOWN_TIMER = error(
    21167,
    known_as=(900318,),
    en="unknown timer {id}",
    de="unbekannter Timer {id}",
    remedy_en="Timers are numbered from 0 to {maximum}.",
    remedy_de="Timer haben die Nummern 0 bis {maximum}.",
)
UNKNOWN_MACRO = error(
    20619,
    known_as=(900319,),
    en='macro "{name}" is not defined at this point',
    de='das Makro "{name}" ist an dieser Stelle nicht definiert',
    remedy_en='Did you mean {nearest}? Write "{name}" = "text" first; names are case-sensitive.',
    remedy_de='War {nearest} gemeint? Vorher "{name}" = "Text" schreiben; Groß- und '
    "Kleinschreibung zählt.",
)
MACROS_NESTED_TOO_DEEP = error(
    900848,
    known_as=(20618,),
    en='macro "{name}": more than {limit} macros are nested',
    de='Makro "{name}": mehr als {limit} Makros sind geschachtelt',
    remedy_en="A macro must not appear in its own text, nor in that of a macro it uses.",
    remedy_de="Ein Makro darf weder im eigenen Text vorkommen noch in dem eines Makros, das es "
    "benutzt.",
    name=("the innermost macro", "das innerste Makro"),
    classes=(2, 3),
)
MACRO_TEXT_TOO_LONG = error(
    900849,
    en='macro "{name}": its block would become longer than {limit} characters',
    de='Makro "{name}": sein Satz würde länger als {limit} Zeichen',
    remedy_en="Move part of it into a subprogram, or split it into several blocks.",
    remedy_de="Einen Teil davon in ein Unterprogramm legen oder auf mehrere Sätze verteilen.",
    cause_en="A macro that contains other macros can become a text of any length.",
    cause_de="Ein Makro mit weiteren Makros im Text kann beliebig lang werden.",
    name=(
        "the macro at which the limit is exceeded",
        "das Makro, bei dem die Grenze überschritten wird",
    ),
    classes=(2, 3),
)
G194_ABOVE_MAX_FEED = error(
    900925,
    known_as=(20799, 21889),
    en="G194: {value} % is above the maximum feed",
    de="G194: {value} % liegt über dem maximalen Vorschub",
    remedy_en="With G194, F is a share of the maximum feed: above 0, at most {maximum} %.",
    remedy_de="Mit G194 ist F ein Anteil am maximalen Vorschub: über 0, höchstens {maximum} %.",
    classes=(2, 3),
)
