# SPDX-License-Identifier: MIT
"""Messages about NC text: lexer and parser."""

from __future__ import annotations

from nctakt.messages.catalogue import error, warning

UNEXPECTED_TEXT = error(
    900100,
    en="nobody knows what {found} means here",
    de="mit {found} ist hier nichts anzufangen",
    remedy_en="Remove it, or write the block as the grammar has it.",
    remedy_de="Entfernen oder den Satz nach der Grammatik schreiben.",
    found=("what stands at that place", "was an dieser Stelle steht"),
)
VALUE_EXPECTED = error(
    900101,
    en="a value is missing before {found}",
    de="vor {found} fehlt ein Wert",
    remedy_en="Write a number, a variable or an expression.",
    remedy_de="Eine Zahl, eine Variable oder einen Ausdruck schreiben.",
    found=("what stands at that place", "was an dieser Stelle steht"),
)
BRACKET_NOT_CLOSED = error(
    900102,
    en="this bracket is not closed",
    de="diese Klammer wird nicht geschlossen",
    remedy_en="Write ']'; a command goes on in the next line only if this one ends with '\\'.",
    remedy_de="']' schreiben; ein Befehl geht nur weiter, wenn die Zeile mit '\\' endet.",
)
UNMATCHED_CLOSING_BRACKET = error(
    900103,
    en="']' without '['",
    de="']' ohne '['",
    remedy_en="Remove it, or open the bracket before.",
    remedy_de="Entfernen oder die Klammer vorher öffnen.",
)
TEXT_NOT_CLOSED = error(
    900104,
    en="this text has no closing quote",
    de="diesem Text fehlt das schließende Anführungszeichen",
    remedy_en='Write " at its end; a text stays in one line.',
    remedy_de='Am Ende " schreiben; ein Text bleibt in einer Zeile.',
)
STRUCTURE_NOT_CLOSED = error(
    900105,
    en="{begin} is never closed",
    de="{begin} wird nie geschlossen",
    remedy_en="Write {end}; structures end in the opposite order of their begin.",
    remedy_de="{end} schreiben; Strukturen enden umgekehrt, wie sie beginnen.",
    begin=("the word that opens the structure", "das Wort, das die Struktur öffnet"),
    end=("the word that closes it", "das Wort, das sie schließt"),
)
STRUCTURE_NOT_OPENED = error(
    900106,
    en="{word} without {begin}",
    de="{word} ohne {begin}",
    remedy_en="Remove it, or write {begin} before.",
    remedy_de="Entfernen oder vorher {begin} schreiben.",
    word=("the word at that place", "das Wort an dieser Stelle"),
    begin=("the word that should come before", "das Wort, das vorher kommen muss"),
)
UNKNOWN_CONTROL_WORD = error(
    900107,
    en="{word} is no control word",
    de="{word} ist kein Kontrollwort",
    remedy_en="Perhaps {suggestion} is meant; no blank stands behind $.",
    remedy_de="Vielleicht ist {suggestion} gemeint; hinter $ steht kein Leerzeichen.",
    word=("the word as written", "das Wort, wie geschrieben"),
    suggestion=("the most similar control word", "das ähnlichste Steuerwort"),
)
BINARY_FILE = error(
    900108,
    en="this is no text: here stands a byte 0",
    de="das ist kein Text: hier steht ein Byte 0",
    remedy_en="Give an NC program; reading ends here.",
    remedy_de="Ein NC-Programm angeben; hier endet das Lesen.",
)
PROGRAM_EMPTY = warning(
    900109,
    en="the program is empty",
    de="das Programm ist leer",
    remedy_en="Write at least the program end, M30.",
    remedy_de="Wenigstens das Programmende M30 schreiben.",
)
BLOCK_LONGER_THAN_MANUAL = warning(
    900110,
    en="the block has {length} characters, the manual allows {limit}",
    de="der Satz hat {length} Zeichen, das Handbuch erlaubt {limit}",
    remedy_en="Divide it: the machine's controller may refuse it.",
    remedy_de="Teilen: die Steuerung der Maschine lehnt ihn möglicherweise ab.",
    length=("characters of the block", "Zeichen des Satzes"),
    limit=("characters allowed", "erlaubte Zeichen"),
)
STRUCTURES_NESTED_TOO_DEEP = error(
    900111,
    en="{begin} stands inside more than {limit} other structures",
    de="{begin} steht in mehr als {limit} anderen Strukturen",
    remedy_en="Take the inner part out into a subprogram.",
    remedy_de="Den inneren Teil in ein Unterprogramm auslagern.",
    begin=("the word that opens the structure", "das Wort, das die Struktur öffnet"),
    limit=("structures allowed", "erlaubte Strukturen"),
)
COMMENT_NOT_CLOSED = error(
    900112,
    en="this comment is never ended",
    de="dieser Kommentar endet nie",
    remedy_en="Write #COMMENT END alone in a block.",
    remedy_de="#COMMENT END allein in einen Satz schreiben.",
)
SYMBOL_EXPECTED = error(
    900113,
    en="'{symbol}' is missing before {found}",
    de="vor {found} fehlt '{symbol}'",
    remedy_en="Write '{symbol}'.",
    remedy_de="'{symbol}' schreiben.",
    symbol=("what has to stand there", "was dort stehen muss"),
    found=("what stands at that place", "was an dieser Stelle steht"),
)
NAME_EXPECTED = error(
    900114,
    en="a name is missing before {found}",
    de="vor {found} fehlt ein Name",
    remedy_en="Write the name of the variable, label, program or command that is meant.",
    remedy_de="Den Namen schreiben: der Variablen, der Marke, des Programms, des Befehls.",
    found=("what stands at that place", "was an dieser Stelle steht"),
)
STATEMENT_BEFORE_CASE = error(
    900115,
    en="a statement between $SWITCH and its first $CASE",
    de="eine Anweisung zwischen $SWITCH und dem ersten $CASE",
    remedy_en="Put it before $SWITCH or into a branch.",
    remedy_de="Vor $SWITCH oder in einen Zweig setzen.",
)
ONLY_DECLARATIONS_IN_VAR = error(
    900116,
    en="only declarations stand between #VAR and #ENDVAR",
    de="zwischen #VAR und #ENDVAR stehen nur Deklarationen",
    remedy_en="Write V.L.NAME : TYPE = value, or close with #ENDVAR before.",
    remedy_de="V.L.NAME : TYP = Wert schreiben oder vorher mit #ENDVAR schließen.",
)
SECOND_MAIN_PROGRAM = warning(
    900117,
    en="the file has a main program already; %{name} does not run",
    de="die Datei hat schon ein Hauptprogramm; %{name} läuft nicht",
    remedy_en="Begin a subprogram with %L, or use a file of its own.",
    remedy_de="Ein Unterprogramm mit %L beginnen oder eine eigene Datei verwenden.",
    name=("what stands behind %", "was hinter % steht"),
)
TEXT_AFTER_PROGRAM_END = warning(
    900118,
    en="what stands behind the program end is no NC text from here on",
    de="was hinter dem Programmende steht, ist ab hier kein NC-Text",
    remedy_en="Make it a comment; a run that jumps there would end with an error.",
    remedy_de="Zum Kommentar machen; ein Lauf, der dorthin springt, endet mit einem Fehler.",
)
NUMBER_TOO_LARGE = error(
    900119,
    en="this number is too large",
    de="diese Zahl ist zu groß",
    remedy_en="Write a number below 1.8 times 10 to the power of 308.",
    remedy_de="Eine Zahl unter 1,8 mal 10 hoch 308 schreiben.",
)
BRANCH_AFTER_ELSE = error(
    900120,
    en="{word} behind the $ELSE of the same $IF",
    de="{word} hinter dem $ELSE desselben $IF",
    remedy_en="Put $ELSE last, once, or close the $IF before.",
    remedy_de="$ELSE einmal und zuletzt schreiben oder das $IF vorher schließen.",
    word=("the word at that place", "das Wort an dieser Stelle"),
)
INVALID_SKIP_LEVEL = error(
    900122,
    en="there is no skip level {level}: levels are 1 to {limit}",
    de="es gibt keine Ausblendebene {level}: Ebenen sind 1 bis {limit}",
    remedy_en="Write / or /1 to /{limit}",
    remedy_de="/ oder /1 bis /{limit} schreiben.",
    level=("the level as written", "die Ebene, wie geschrieben"),
    limit=("the highest level", "die höchste Ebene"),
)
BLOCK_TOO_LONG = error(
    20301,
    en="the block has {length} characters, {limit} can be read",
    de="der Satz hat {length} Zeichen, lesbar sind {limit}",
    remedy_en="Divide it into several blocks.",
    remedy_de="In mehrere Sätze teilen.",
    length=("characters of the block", "Zeichen des Satzes"),
    limit=("characters that can be read", "lesbare Zeichen"),
    reaction=2,
    clearing=3,
)
COMMENT_BEGIN_NOT_ALONE = error(
    20566,
    en="#COMMENT BEGIN is not alone in its block",
    de="#COMMENT BEGIN steht nicht allein im Satz",
    remedy_en="Put it into a block of its own.",
    remedy_de="In einen eigenen Satz schreiben.",
    reaction=2,
    clearing=3,
)
COMMENT_END_NOT_ALONE = error(
    20569,
    en="#COMMENT END is not alone in its block",
    de="#COMMENT END steht nicht allein im Satz",
    remedy_en="Put it into a block of its own.",
    remedy_de="In einen eigenen Satz schreiben.",
    reaction=2,
    clearing=3,
)
UNKNOWN_CYCLE_KEYWORD = error(
    21985,
    en="#RT CYCLE has no keyword {keyword}",
    de="#RT CYCLE hat kein Schlüsselwort {keyword}",
    remedy_en="DEF, END, START, HOLD, CONTINUE, ABORT ACTION, DELETE; ID, SCOPE, END_ACTION.",
    remedy_de="DEF, END, START, HOLD, CONTINUE, ABORT ACTION, DELETE; ID, SCOPE, END_ACTION.",
    cause_en="The brackets of #RT CYCLE hold ID, SCOPE and END_ACTION, each once and in any order.",
    cause_de="In den Klammern von #RT CYCLE stehen ID, SCOPE und END_ACTION, jedes einmal und in "
    "beliebiger Folge.",
    keyword=("the word as written", "das Wort, wie geschrieben"),
    reaction=2,
    clearing=3,
)
CYCLE_BEGIN_END_MISMATCH = error(
    22005,
    en="begin and end of realtime cycles do not fit together at this {found}",
    de="Beginn und Ende der Echtzeit-Zyklen passen bei diesem {found} nicht zusammen",
    remedy_en="Close each #RT CYCLE with #RT CYCLE END before the next one begins.",
    remedy_de="Jedes #RT CYCLE mit #RT CYCLE END schließen, bevor das nächste beginnt.",
    cause_en="Definitions do not nest: each begins with #RT CYCLE and ends with #RT CYCLE END.",
    cause_de="Definitionen lassen sich nicht schachteln: jede beginnt mit #RT CYCLE und endet mit "
    "#RT CYCLE END.",
    found=("the command at that place", "der Befehl an dieser Stelle"),
    reaction=2,
    clearing=3,
)
EXPRESSION_TOO_DEEP = error(
    50861,
    en="the expression is nested deeper than {limit} levels",
    de="der Ausdruck ist tiefer als {limit} Ebenen geschachtelt",
    remedy_en="Assign a part of it to a variable first.",
    remedy_de="Einen Teil davon vorher einer Variablen zuweisen.",
    cause_en="Evaluation must need little memory in the realtime part, so the depth has a limit.",
    cause_de="Die Auswertung darf im Echtzeit-Teil wenig Speicher brauchen; darum ist die Tiefe "
    "begrenzt.",
    limit=("levels allowed", "erlaubte Ebenen"),
    reaction=6,
    clearing=6,
)
