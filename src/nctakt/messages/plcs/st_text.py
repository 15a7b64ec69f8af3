# SPDX-License-Identifier: MIT
"""Messages about files and syntax of Structured Text.

The numbers of the form C0009 are those of the compiler of the programming system.
"""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

_OBJECT = ("the object of the project", "das Objekt des Projekts")

PROJECT_FILE_MISSING = error(
    902160,
    en="the project names {path}, which does not exist",
    de="das Projekt nennt {path}, das es nicht gibt",
    remedy_en="Add the file, or remove it from the project.",
    remedy_de="Die Datei ergänzen oder aus dem Projekt entfernen.",
)
XML_ELEMENT_UNKNOWN = note(
    902161,
    en="the element {name} is not known and is skipped",
    de="das Element {name} ist nicht bekannt und wird übergangen",
)
XML_FAULT = error(
    902162,
    en="the file is not well-formed XML: {reason}",
    de="die Datei ist kein gültiges XML: {reason}",
    remedy_en="Save the object again in the programming system.",
    remedy_de="Das Objekt im Programmiersystem neu speichern.",
)
XML_REFUSED = error(
    902163,
    en="document types and entities are not read",
    de="Dokumenttypen und Entitäten werden nicht gelesen",
    remedy_en="Remove the declaration.",
    remedy_de="Die Deklaration entfernen.",
)
PLC_FILE_TOO_LARGE = error(
    902164,
    en="the file has more than {limit} bytes or is nested too deeply",
    de="die Datei hat mehr als {limit} Byte oder ist zu tief verschachtelt",
    remedy_en="Split the object.",
    remedy_de="Das Objekt aufteilen.",
)
LANGUAGE_REFUSED = error(
    902165,
    en="{name} is written in {language}, which nctakt does not run",
    de="{name} ist in {language} geschrieben, das nctakt nicht ausführt",
    remedy_en="Write the implementation in Structured Text (ST).",
    remedy_de="Die Implementierung in Strukturiertem Text (ST) schreiben.",
    name=_OBJECT,
    language=("the language of the implementation", "die Sprache der Implementierung"),
)
OBJECT_MISSING = error(
    902166,
    en="{file} contains no object of a PLC",
    de="{file} enthält kein Objekt einer SPS",
    remedy_en="Name a .TcPOU, .TcDUT, .TcGVL, .TcIO or .TcTTO file.",
    remedy_de="Eine Datei .TcPOU, .TcDUT, .TcGVL, .TcIO oder .TcTTO angeben.",
)
ST_COMMENT_NOT_CLOSED = error(
    902167,
    en="this comment is not closed",
    de="dieser Kommentar ist nicht geschlossen",
    remedy_en="Write *) at its end; comments nest.",
    remedy_de="Am Ende *) schreiben; Kommentare sind schachtelbar.",
)
STRING_NOT_CLOSED = error(
    902168,
    en="this string is not closed on its line",
    de="diese Zeichenkette ist in ihrer Zeile nicht geschlossen",
    remedy_en="Write the closing quote; a quote in the string is $' or $\".",
    remedy_de="Das schließende Anführungszeichen schreiben; im Text selbst steht dafür $' oder "
    '$".',
)
PRAGMA_NOT_CLOSED = error(
    902169,
    en="this pragma is not closed",
    de="dieses Pragma ist nicht geschlossen",
    remedy_en="Write }} at its end.",
    remedy_de="Am Ende }} schreiben.",
)
CHARACTER_UNKNOWN = error(
    902170,
    en="{text} is not part of Structured Text (C0009)",
    de="{text} gehört nicht zu Strukturiertem Text (C0009)",
    remedy_en="Remove it.",
    remedy_de="Das Zeichen entfernen.",
)
PRAGMA_NOTE = note(902171, en="{text}", de="{text}")
PRAGMA_WARNING = warning(902172, en="{text}", de="{text}")
PRAGMA_ERROR = error(
    902173,
    en="{text}",
    de="{text}",
    remedy_en="The program reports this by {{error}}.",
    remedy_de="Das Programm meldet dies mit {{error}}.",
)
CONDITION_NOT_KNOWN = error(
    902174,
    en="the condition {condition} cannot be evaluated",
    de="die Bedingung {condition} kann nicht ausgewertet werden",
    remedy_en="Known are defined(…) and hasvalue(…) with NOT, AND, OR and brackets.",
    remedy_de="Bekannt sind defined(…) und hasvalue(…) mit NOT, AND, OR und Klammern.",
    condition=("the condition as written", "die Bedingung, wie geschrieben"),
)
CONDITION_WITHOUT_IF = error(
    902175,
    en="{{{word}}} without {{IF}}",
    de="{{{word}}} ohne {{IF}}",
    remedy_en="Remove it, or write the {{IF}}.",
    remedy_de="Entfernen oder das {{IF}} schreiben.",
)
CONDITION_NOT_CLOSED = error(
    902176,
    en="{{IF}} is not closed",
    de="{{IF}} ist nicht geschlossen",
    remedy_en="Write {{END_IF}}.",
    remedy_de="{{END_IF}} schreiben.",
)
TOKEN_EXPECTED = error(
    902177,
    en="{expected} expected, not {found} (C0009)",
    de="{expected} erwartet, nicht {found} (C0009)",
    remedy_en="Write {expected} before {found}.",
    remedy_de="{expected} vor {found} schreiben.",
)
EXPRESSION_EXPECTED = error(
    902178,
    en="a value is expected, not {found} (C0009)",
    de="ein Wert wird erwartet, nicht {found} (C0009)",
    remedy_en="Write a variable, a literal or a call.",
    remedy_de="Eine Variable, ein Literal oder einen Aufruf schreiben.",
)
STATEMENT_EXPECTED = error(
    902179,
    en="no statement begins with {found} (C0009)",
    de="mit {found} beginnt keine Anweisung (C0009)",
    remedy_en="Write an assignment, a call or a keyword such as IF.",
    remedy_de="Eine Zuweisung, einen Aufruf oder ein Schlüsselwort wie IF schreiben.",
)
UNEXPECTED_TOKEN = error(
    902180,
    en="{found} is not expected (C0009)",
    de="{found} wird nicht erwartet (C0009)",
    remedy_en="Check what comes before it.",
    remedy_de="Prüfen, was davor steht.",
)
END_KEYWORD_MISSING = error(
    902181,
    en="{keyword} expected, found {found}; it closes line {line} (C0008)",
    de="{keyword} erwartet, gefunden: {found}; es schließt Zeile {line} (C0008)",
    remedy_en="Write {keyword}.",
    remedy_de="{keyword} schreiben.",
    keyword=("the keyword", "das Schlüsselwort"),
)
COMPARISON_AS_STATEMENT = error(
    902182,
    en="= compares; it does not assign (C0020)",
    de="= vergleicht und weist nichts zu (C0020)",
    remedy_en="Write := to assign.",
    remedy_de="Zum Zuweisen := schreiben.",
)
LONE_EXPRESSION = error(
    902183,
    en="an expression alone is not a statement (C0020)",
    de="ein Ausdruck allein ist keine Anweisung (C0020)",
    remedy_en="Assign the value, or call with brackets: name().",
    remedy_de="Den Wert zuweisen oder mit Klammern aufrufen: Name().",
)
JUMP_REFUSED = error(
    902184,
    en="jumps and labels ({word}) are not supported",
    de="Sprünge und Marken ({word}) werden nicht unterstützt",
    remedy_en="Use IF, CASE or a loop with EXIT.",
    remedy_de="IF, CASE oder eine Schleife mit EXIT verwenden.",
)
TRY_REFUSED = error(
    902185,
    en="__TRY … __CATCH is not supported",
    de="__TRY … __CATCH wird nicht unterstützt",
    remedy_en="Check values before they are used: divisors, indices, pointers.",
    remedy_de="Werte vor der Verwendung prüfen: Divisoren, Indizes, Zeiger.",
)
NESTED_TOO_DEEP = error(
    902186,
    en="nested deeper than {limit} levels",
    de="tiefer als {limit} Ebenen verschachtelt",
    remedy_en="Split it, for example with a method.",
    remedy_de="Aufteilen, zum Beispiel durch eine Methode.",
)
EXPRESSION_TOO_LONG = error(
    902187,
    en="the expression has more than {limit} operators in a row",
    de="der Ausdruck hat mehr als {limit} Operatoren hintereinander",
    remedy_en="Split it with an intermediate variable.",
    remedy_de="Mit einer Zwischenvariablen aufteilen.",
)
VARIABLES_EXPECTED = error(
    902188,
    en="{found} does not belong in a declaration (C0006)",
    de="{found} gehört nicht in eine Deklaration (C0006)",
    remedy_en="Declare variables between VAR and END_VAR.",
    remedy_de="Variablen zwischen VAR und END_VAR deklarieren.",
)
TASK_TIME_UNKNOWN = error(
    902189,
    en="{text} is not a cycle time of a task",
    de="{text} ist keine Zykluszeit einer Task",
    remedy_en="Write INTERVAL := T#10MS.",
    remedy_de="INTERVAL := T#10MS schreiben.",
)
GENERIC_REFUSED = error(
    902258,
    en="generic blocks (VAR_GENERIC) are not supported",
    de="generische Bausteine (VAR_GENERIC) werden nicht unterstützt",
    remedy_en="Declare the size as a constant.",
    remedy_de="Die Größe als Konstante deklarieren.",
)
