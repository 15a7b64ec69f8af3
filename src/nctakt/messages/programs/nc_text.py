# SPDX-License-Identifier: MIT
"""Messages about NC text: lexer and parser."""

from __future__ import annotations

from nctakt.messages.cases import by_beginning
from nctakt.messages.catalogue import error, warning

UNEXPECTED_TEXT = error(
    20797,
    classes=(0, 0),
    known_as=(900100, 20200),
    en="{found} is not expected here",
    de="{found} ist hier nicht zu erwarten",
    remedy_en="Remove it, or write the block according to the grammar.",
    remedy_de="Entfernen oder den Satz nach der Grammatik schreiben.",
)
VALUE_EXPECTED = error(
    900101,
    known_as=(20392, 21461),
    en="a value is missing before {found}",
    de="vor {found} fehlt ein Wert",
    remedy_en="Write a number, a variable or an expression.",
    remedy_de="Eine Zahl, eine Variable oder einen Ausdruck schreiben.",
)
EQUALS_BEFORE_CONDITION = error(
    901041,
    en="there must be no '=' between {word} and the condition",
    de="zwischen {word} und der Bedingung darf kein '=' stehen",
    remedy_en="Leave it out, as in $IF ONCE V.E.COUNT > 5.",
    remedy_de="Weglassen, wie in $IF ONCE V.E.COUNT > 5.",
    cause_en="The syntax line of the manual has '=' between the frequency and the condition; its "
    "programs do not.",
    cause_de="In der Syntaxzeile des Handbuchs steht '=' zwischen Häufigkeit und Bedingung, in "
    "seinen Programmen nicht.",
    word=("the word before it", "das Wort davor"),
)
BRACKET_NOT_CLOSED = error(
    20397,
    classes=(0, 0),
    known_as=(900102, 20198, 21217),
    en="this bracket is not closed",
    de="diese Klammer wird nicht geschlossen",
    remedy_en="Write ']'; a command continues in the next line only if this one ends with '\\'.",
    remedy_de="']' schreiben; ein Befehl geht in der nächsten Zeile nur weiter, wenn diese mit "
    "'\\' endet.",
)
UNMATCHED_CLOSING_BRACKET = error(
    900103,
    en="']' without '['",
    de="']' ohne '['",
    remedy_en="Remove it, or open the bracket first.",
    remedy_de="Entfernen oder die Klammer vorher öffnen.",
)
TEXT_NOT_CLOSED = error(
    20790,
    classes=(0, 0),
    known_as=(900104, 20613, 20615, 20629, 20715),
    en="this text has no closing quote",
    de="diesem Text fehlt das schließende Anführungszeichen",
    remedy_en='Write " at its end; a text cannot extend over several lines.',
    remedy_de='Am Ende " schreiben; ein Text kann nicht über mehrere Zeilen gehen.',
)
STRUCTURE_NOT_CLOSED = error(
    20375,
    classes=(0, 0),
    known_as=(900105, 21500, 21501, 21502),
    cases=by_beginning("begin", {"#IF": 21387}),
    en="{begin} is never closed",
    de="{begin} wird nie geschlossen",
    remedy_en="Write {end}; nested structures end in reverse order.",
    remedy_de="{end} schreiben; geschachtelte Strukturen enden in umgekehrter Reihenfolge.",
    end=("the word that closes it", "das Wort, das sie schließt"),
)
STRUCTURE_NOT_OPENED = error(
    900106,
    cases=by_beginning(
        "word",
        {
            "$ELSEIF": 20216,
            "$ELSE": 20214,
            "$ENDIF": 20218,
            "$CASE": 20221,
            "$DEFAULT": 20223,
            "$ENDSWITCH": 20225,
            "$ENDFOR": 20232,
            "$ENDWHILE": 20237,
            "$ENDDO": 20240,
            "$UNTIL": 21469,
            "#ELSE": 20591,
            "#ENDIF": 20592,
            "#COMMENT": 20567,
        },
    ),
    en="{word} without {begin}",
    de="{word} ohne {begin}",
    remedy_en="Remove it, or write {begin} first.",
    remedy_de="Entfernen oder vorher {begin} schreiben.",
    begin=("the word that should come before", "das Wort, das vorher kommen muss"),
)
UNKNOWN_CONTROL_WORD = error(
    900107,
    known_as=(20209,),
    en="{word} is not a control statement",
    de="{word} ist keine Steueranweisung",
    remedy_en="Did you mean {suggestion}? There must be no blank after $.",
    remedy_de="War {suggestion} gemeint? Nach $ darf kein Leerzeichen stehen.",
    suggestion=("the most similar control statement", "die ähnlichste Steueranweisung"),
)
BINARY_FILE = error(
    900108,
    en="this is not a text: it contains a byte 0 here",
    de="dies ist kein Text: hier steht ein Byte 0",
    remedy_en="Name an NC program; reading ends here.",
    remedy_de="Ein NC-Programm angeben; hier endet das Lesen.",
)
PROGRAM_EMPTY = warning(
    900109,
    en="the program is empty",
    de="das Programm ist leer",
    remedy_en="Write at least M30, the program end.",
    remedy_de="Mindestens M30, das Programmende, schreiben.",
)
BLOCK_LONGER_THAN_MANUAL = warning(
    900110,
    known_as=(20301,),
    en="the block has {length} characters; the manual allows {limit}",
    de="der Satz hat {length} Zeichen, das Handbuch erlaubt {limit}",
    remedy_en="Split it: the controller of the machine may refuse it.",
    remedy_de="Aufteilen: die Steuerung der Maschine lehnt ihn möglicherweise ab.",
    length=("the number of characters in the block", "die Anzahl der Zeichen im Satz"),
    limit=("the maximum number of characters", "die größte Anzahl von Zeichen"),
)
STRUCTURES_NESTED_TOO_DEEP = error(
    20211,
    classes=(0, 0),
    known_as=(900111, 20590),
    en="{begin} is inside more than {limit} other structures",
    de="{begin} steht in mehr als {limit} anderen Strukturen",
    remedy_en="Move the inner part into a subprogram.",
    remedy_de="Den inneren Teil in ein Unterprogramm auslagern.",
    limit=("the maximum nesting", "die größte Schachtelung"),
)
COMMENT_NOT_CLOSED = error(
    20568,
    classes=(0, 0),
    known_as=(900112,),
    en="this comment is never closed",
    de="dieser Kommentar wird nie geschlossen",
    remedy_en="Write #COMMENT END in a separate block.",
    remedy_de="#COMMENT END in einen eigenen Satz schreiben.",
)
SYMBOL_EXPECTED = error(
    900113,
    known_as=(20147, 20194, 20880),
    cases=by_beginning("symbol", {"=": 20228, "[": 20743, "]": 20716, ",": 20229}),
    en="'{symbol}' is missing before {found}",
    de="vor {found} fehlt '{symbol}'",
    remedy_en="Write '{symbol}'.",
    remedy_de="'{symbol}' schreiben.",
    symbol=("the missing symbol", "das fehlende Zeichen"),
)
NAME_EXPECTED = error(
    900114,
    known_as=(20200, 20916),
    en="a name is missing before {found}",
    de="vor {found} fehlt ein Name",
    remedy_en="Write the name of a variable, label, program or command.",
    remedy_de="Den Namen einer Variablen, einer Marke, eines Programms oder eines Befehls "
    "schreiben.",
)
STATEMENT_BEFORE_CASE = error(
    900115,
    en="there must be no statement between $SWITCH and its first $CASE",
    de="zwischen $SWITCH und dem ersten $CASE darf keine Anweisung stehen",
    remedy_en="Put it before $SWITCH or into a branch.",
    remedy_de="Vor $SWITCH oder in einen Zweig setzen.",
)
ONLY_DECLARATIONS_IN_VAR = error(
    900116,
    known_as=(20904, 20972),
    en="only declarations are allowed between #VAR and #ENDVAR",
    de="zwischen #VAR und #ENDVAR sind nur Deklarationen erlaubt",
    remedy_en="Write V.L.NAME : TYPE = value, or close the section with #ENDVAR first.",
    remedy_de="V.L.NAME : TYP = Wert schreiben oder den Abschnitt vorher mit #ENDVAR schließen.",
)
SECOND_MAIN_PROGRAM = error(
    20193,
    classes=(0, 0),
    known_as=(900117, 21313),
    en="the file already has a main program before %{name}",
    de="die Datei hat vor %{name} schon ein Hauptprogramm",
    remedy_en="Start a subprogram with %L, or use a separate file.",
    remedy_de="Ein Unterprogramm mit %L beginnen oder eine eigene Datei verwenden.",
    name=("the text after %", "der Text nach %"),
)
TEXT_AFTER_PROGRAM_END = warning(
    900118,
    en="from here on, the text after the program end is not valid NC text",
    de="ab hier ist der Text nach dem Programmende kein gültiger NC-Text",
    remedy_en="Make it a comment; a run that jumps there would end with an error.",
    remedy_de="Zum Kommentar machen; ein Lauf, der dorthin springt, würde mit einem Fehler enden.",
)
NUMBER_TOO_LARGE = error(
    900119,
    known_as=(20834, 21713),
    en="this number is too large",
    de="diese Zahl ist zu groß",
    remedy_en="Write a number below 1.8e308.",
    remedy_de="Eine Zahl unter 1,8e308 schreiben.",
)
BRANCH_AFTER_ELSE = error(
    20214,
    classes=(0, 0),
    known_as=(900120,),
    cases=by_beginning("word", {"$ELSEIF": 20216}),
    en="{word} after the $ELSE of the same $IF",
    de="{word} nach dem $ELSE desselben $IF",
    remedy_en="Put a single $ELSE last, or close the $IF first.",
    remedy_de="Ein einziges $ELSE ans Ende setzen oder das $IF vorher schließen.",
)
INVALID_SKIP_LEVEL = error(
    21655,
    classes=(0, 0),
    known_as=(900122,),
    en="there is no skip level {level}: levels are 1 to {limit}",
    de="es gibt keine Ausblendebene {level}: Ebenen sind 1 bis {limit}",
    remedy_en="Write / or /1 to /{limit}",
    remedy_de="/ oder /1 bis /{limit} schreiben.",
    level=("the level as written", "die Ebene, wie geschrieben"),
    limit=("the highest level", "die höchste Ebene"),
)
BLOCK_TOO_LONG = error(
    20301,
    en="the block has {length} characters; at most {limit} can be read",
    de="der Satz hat {length} Zeichen; höchstens {limit} sind lesbar",
    remedy_en="Split it into several blocks.",
    remedy_de="Auf mehrere Sätze aufteilen.",
    length=("the number of characters in the block", "die Anzahl der Zeichen im Satz"),
    limit=("the maximum number of characters", "die größte Anzahl von Zeichen"),
)
COMMENT_BEGIN_NOT_ALONE = error(
    20566,
    en="#COMMENT BEGIN must be alone in its block",
    de="#COMMENT BEGIN muss allein im Satz stehen",
    remedy_en="Write it in a separate block.",
    remedy_de="In einen eigenen Satz schreiben.",
)
COMMENT_END_NOT_ALONE = error(
    20569,
    en="#COMMENT END must be alone in its block",
    de="#COMMENT END muss allein im Satz stehen",
    remedy_en="Write it in a separate block.",
    remedy_de="In einen eigenen Satz schreiben.",
)
UNKNOWN_CYCLE_KEYWORD = error(
    21985,
    known_as=(901181,),
    en="#RT CYCLE has no keyword {keyword}",
    de="#RT CYCLE hat kein Schlüsselwort {keyword}",
    remedy_en="Possible: DEF, END, START, HOLD, CONTINUE, ABORT ACTION, DELETE; ID, SCOPE, "
    "END_ACTION.",
    remedy_de="Möglich: DEF, END, START, HOLD, CONTINUE, ABORT ACTION, DELETE; ID, SCOPE, "
    "END_ACTION.",
    cause_en="The brackets of #RT CYCLE contain ID, SCOPE and END_ACTION, each once and in any "
    "order.",
    cause_de="In den Klammern von #RT CYCLE stehen ID, SCOPE und END_ACTION, jedes einmal und in "
    "beliebiger Reihenfolge.",
    keyword=("the word as written", "das Wort, wie geschrieben"),
)
CYCLE_BEGIN_END_MISMATCH = error(
    22005,
    en="begin and end of realtime cycles do not match at this {found}",
    de="Beginn und Ende der Echtzeit-Zyklen passen bei diesem {found} nicht zusammen",
    remedy_en="Close each #RT CYCLE with #RT CYCLE END before the next one starts.",
    remedy_de="Jedes #RT CYCLE mit #RT CYCLE END schließen, bevor das nächste beginnt.",
    cause_en="Definitions cannot be nested: each starts with #RT CYCLE and ends with #RT CYCLE "
    "END.",
    cause_de="Definitionen lassen sich nicht schachteln: jede beginnt mit #RT CYCLE und endet mit "
    "#RT CYCLE END.",
    found=("the command at this position", "der Befehl an dieser Stelle"),
)
EXPRESSION_TOO_DEEP = error(
    20386,
    known_as=(21587, 50861),
    en="the expression is nested more than {limit} levels deep",
    de="der Ausdruck ist mehr als {limit} Ebenen tief geschachtelt",
    remedy_en="Assign part of it to a variable first.",
    remedy_de="Einen Teil davon vorher einer Variablen zuweisen.",
    cause_en="The realtime part evaluates with little memory, so the depth is limited.",
    cause_de="Der Echtzeit-Teil rechnet mit wenig Speicher; darum ist die Tiefe begrenzt.",
    limit=("the maximum nesting", "die größte Schachtelung"),
    classes=(6, 6),
)
INDIRECT_PARAMETER_ARRAY = error(
    901963,
    classes=(2, 3),
    en="an array of P parameters needs its number: {word} is not one",
    de="ein Feld von P-Parametern braucht seine Nummer: {word} ist keine",
    remedy_en="Write P10[1]; PP1 and P[…] name single parameters.",
    remedy_de="P10[1] schreiben; PP1 und P[…] nennen einzelne Parameter.",
    word=("the word as written", "das Wort, wie geschrieben"),
)
