# SPDX-License-Identifier: MIT
"""Messages about slips: the writer's intention is known, and how this language expresses it.

Each replaces a general message of the parser or checker and has its number where that
differs from the one here (``nc/slips``). ``found`` is the text as written, ``replacement`` the text
for it.
"""

from __future__ import annotations

from nctakt.messages.catalogue import error

_FOUND = ("the text as written", "der Text, wie geschrieben")
_REPLACEMENT = ("the text that belongs there", "der Text, der dort hingehört")

EQUALS_IN_CONDITION = error(
    20797,
    classes=(0, 0),
    known_as=(901163,),
    en="'{found}' assigns a value; it does not compare",
    de="'{found}' weist einen Wert zu und vergleicht nicht",
    remedy_en="Write {replacement} to compare.",
    remedy_de="Zum Vergleichen {replacement} schreiben.",
    found=_FOUND,
    replacement=_REPLACEMENT,
)
COMPARISON_AS_ASSIGNMENT = error(
    20797,
    classes=(0, 0),
    known_as=(901164,),
    en="'{found}' compares; it does not assign",
    de="'{found}' vergleicht und weist nichts zu",
    remedy_en="Write {replacement} to assign.",
    remedy_de="Zum Zuweisen {replacement} schreiben.",
    found=_FOUND,
    replacement=_REPLACEMENT,
)
OPERATOR_OF_OTHER_LANGUAGE = error(
    20797,
    classes=(0, 0),
    known_as=(901165,),
    en="'{found}' is not an operator of this language",
    de="'{found}' ist kein Operator dieser Sprache",
    remedy_en="Write {replacement}",
    remedy_de="Richtig ist {replacement}",
    found=_FOUND,
    replacement=_REPLACEMENT,
)
MISSPELT_FREQUENCY = error(
    20392,
    classes=(0, 0),
    known_as=(901166,),
    en="'{found}' does not say how often $IF is true",
    de="'{found}' sagt nicht, wie oft $IF zutrifft",
    remedy_en="Write {replacement}; possible are ONCE, EDGE and ALWAYS.",
    remedy_de="{replacement} schreiben; möglich sind ONCE, EDGE und ALWAYS.",
    found=_FOUND,
    replacement=_REPLACEMENT,
)
UNIT_BEHIND_VALUE = error(
    20797,
    classes=(0, 0),
    known_as=(901478,),
    en="{found} follows a value: values have no unit",
    de="{found} steht hinter einem Wert: Werte haben keine Einheit",
    remedy_en="Remove {found}; G70 and G71 choose inch or mm, G94 and G95 the unit of F.",
    remedy_de="{found} entfernen; G70 und G71 wählen Zoll oder mm, G94 und G95 die Einheit von F.",
    found=_FOUND,
)
POINT_MISSING_IN_NAME = error(
    20797,
    classes=(0, 0),
    known_as=(901479,),
    en="{found} is not a variable: points separate the parts of a name",
    de="{found} ist keine Variable: Punkte trennen die Teile ihres Namens",
    remedy_en="Write {replacement}",
    remedy_de="{replacement} schreiben.",
    found=_FOUND,
    replacement=_REPLACEMENT,
)
NAME_OF_INTERFACE = error(
    20797,
    classes=(0, 0),
    known_as=(902979,),
    en="{found} is a name of the interface to the PLC: programs do not have it",
    de="{found} ist ein Name der Schnittstelle zur SPS: Programme kennen ihn nicht",
    remedy_en="Set it from outside: --set, --at or the PLC; programs and PLC share V.E variables.",
    remedy_de="Von außen setzen: --set, --at oder die SPS; Programm und SPS teilen V.E-Variablen.",
    found=_FOUND,
)
SURPLUS_WORD = error(
    20797,
    classes=(0, 0),
    known_as=(901167,),
    en="a condition ends with its line, without {found}",
    de="eine Bedingung endet mit ihrer Zeile, ohne {found}",
    remedy_en="Remove {found}; the body begins in the next line.",
    remedy_de="{found} entfernen; der Rumpf beginnt in der nächsten Zeile.",
    found=_FOUND,
)
BODY_BEHIND_THEN = error(
    20797,
    classes=(0, 0),
    known_as=(901480,),
    en="{found}: a condition ends with its line, without THEN",
    de="{found}: eine Bedingung endet mit ihrer Zeile, ohne THEN",
    remedy_en="Write {replacement} in the next line, and $ENDIF in the line after it.",
    remedy_de="{replacement} in die nächste Zeile schreiben, $ENDIF in die dahinter.",
    found=_FOUND,
    replacement=_REPLACEMENT,
)
BODY_BEHIND_CONDITION = error(
    20797,
    classes=(0, 0),
    known_as=(901168,),
    en="{found} is in the line of the condition",
    de="{found} steht in der Zeile der Bedingung",
    remedy_en="Begin a new line before {replacement}; only $GOTO, $BREAK and $CONTINUE are "
    "allowed here.",
    remedy_de="Vor {replacement} eine neue Zeile beginnen; hier dürfen nur $GOTO, $BREAK, "
    "$CONTINUE stehen.",
    found=_FOUND,
    replacement=_REPLACEMENT,
)
DECIMAL_COMMA = error(
    20797,
    classes=(0, 0),
    known_as=(901169,),
    en="{found} is not a number: decimals follow a point",
    de="{found} ist keine Zahl: Nachkommastellen folgen einem Punkt",
    remedy_en="Write {replacement}",
    remedy_de="{replacement} schreiben.",
    found=_FOUND,
    replacement=_REPLACEMENT,
)
LETTER_IN_NUMBER = error(
    20797,
    classes=(0, 0),
    known_as=(901170,),
    en="{found} has a letter in place of a digit",
    de="{found} hat einen Buchstaben an Stelle einer Ziffer",
    remedy_en="Write {replacement}",
    remedy_de="{replacement} schreiben.",
    found=_FOUND,
    replacement=_REPLACEMENT,
)
COMMENT_OF_OTHER_LANGUAGE = error(
    20797,
    classes=(0, 0),
    known_as=(901171,),
    en="{found} does not begin a comment",
    de="{found} beginnt keinen Kommentar",
    remedy_en="Write ; before a comment: {replacement}",
    remedy_de="Vor einen Kommentar gehört ; : {replacement}",
    found=_FOUND,
    replacement=_REPLACEMENT,
)
STEP_OPERATOR = error(
    20797,
    classes=(0, 0),
    known_as=(901172,),
    en="there is no operator as in {found}",
    de="einen Operator wie in {found} gibt es nicht",
    remedy_en="Write {replacement}",
    remedy_de="{replacement} schreiben.",
    found=_FOUND,
    replacement=_REPLACEMENT,
)
CURLY_BRACKETS = error(
    20797,
    classes=(0, 0),
    known_as=(901481,),
    en="{found}: curly brackets enclose neither a body nor a condition",
    de="{found}: geschweifte Klammern umschließen weder Rumpf noch Bedingung",
    remedy_en="Remove them; a body begins in the next line and ends with $ENDIF or #RT CYCLE END.",
    remedy_de="Klammern entfernen; ein Rumpf beginnt in der nächsten Zeile und endet mit $ENDIF "
    "oder #RT CYCLE END.",
    found=_FOUND,
)
KEYWORDS_WITHOUT_EQUALS = error(
    20797,
    classes=(0, 0),
    known_as=(901482,),
    en="{found}: the sign = is missing between keyword and value",
    de="{found}: zwischen Schlüsselwort und Wert fehlt das Zeichen =",
    remedy_en="Write {replacement}",
    remedy_de="{replacement} schreiben.",
    found=_FOUND,
    replacement=_REPLACEMENT,
)
ROUND_BRACKETS = error(
    20797,
    classes=(0, 0),
    known_as=(901173,),
    en="{found} is a comment: round brackets hold no expression",
    de="{found} ist ein Kommentar: runde Klammern enthalten keinen Ausdruck",
    remedy_en="Write {replacement}",
    remedy_de="{replacement} schreiben.",
    found=_FOUND,
    replacement=_REPLACEMENT,
)
FUNCTION_WITHOUT_BRACKETS = error(
    20797,
    classes=(0, 0),
    known_as=(901174,),
    en="a function needs brackets around its argument: {found}",
    de="eine Funktion braucht Klammern um ihr Argument: {found}",
    remedy_en="Write {replacement}",
    remedy_de="{replacement} schreiben.",
    found=_FOUND,
    replacement=_REPLACEMENT,
)
ARGUMENTS_WITHOUT_BRACKETS = error(
    20797,
    classes=(0, 0),
    known_as=(901175,),
    en="{found} needs square brackets around it",
    de="{found} gehört in eckige Klammern",
    remedy_en="Write {replacement}",
    remedy_de="{replacement} schreiben.",
    found=_FOUND,
    replacement=_REPLACEMENT,
)
WORD_INSIDE_BRACKETS = error(
    21985,
    classes=(0, 0),
    known_as=(901176,),
    en="the word in '{found}' belongs before the bracket",
    de="das Wort in '{found}' gehört vor die Klammer",
    remedy_en="Write '{replacement}'",
    remedy_de="'{replacement}' schreiben.",
    found=_FOUND,
    replacement=_REPLACEMENT,
)
WORD_FOR_CYCLE_COMMAND = error(
    21985,
    classes=(0, 0),
    known_as=(901177,),
    en="#RT CYCLE has no command {found}",
    de="#RT CYCLE hat keinen Befehl {found}",
    remedy_en="Write {replacement}; the commands are START, HOLD, CONTINUE, ABORT ACTION, DELETE.",
    remedy_de="{replacement} schreiben; die Befehle sind START, HOLD, CONTINUE, ABORT ACTION, "
    "DELETE.",
    found=_FOUND,
    replacement=_REPLACEMENT,
)
SIGN_MISSING_BEFORE_WORD = error(
    20797,
    classes=(0, 0),
    known_as=(901178,),
    en="{found} needs the sign of its kind before it",
    de="vor {found} fehlt das Zeichen für die Art des Worts",
    remedy_en="Write {replacement}",
    remedy_de="{replacement} schreiben.",
    found=_FOUND,
    replacement=_REPLACEMENT,
)
SEPARATOR_IN_FOR = error(
    20229,
    classes=(0, 0),
    known_as=(901179,),
    en="{found} does not separate the values of $FOR",
    de="{found} trennt die Werte von $FOR nicht",
    remedy_en="Write '{replacement}', as in $FOR P1 = 1, 10, 1",
    remedy_de="'{replacement}' schreiben, wie in $FOR P1 = 1, 10, 1",
    found=_FOUND,
    replacement=_REPLACEMENT,
)
WORD_OF_OTHER_CONTROL = error(
    20797,
    classes=(0, 0),
    known_as=(901180,),
    en="{found} is a word of {control}, for {meaning}",
    de="{found} ist ein Wort von {control}, für {meaning}",
    remedy_en="{instead}",
    remedy_de="{instead}",
    found=_FOUND,
    control=("the control that knows it", "die Steuerung, die es kennt"),
    meaning=("what it means there", "was es dort bedeutet"),
    instead=("what this language has for it", "was diese Sprache dafür hat"),
)
