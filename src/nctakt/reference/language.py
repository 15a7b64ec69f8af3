# SPDX-License-Identifier: MIT
"""Articles about the language: words, commands, functions, operators, keywords of cycles."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from types import MappingProxyType

from nctakt.base.diagnostics import Text
from nctakt.nc.vocabulary import support_level
from nctakt.nc.vocabulary.commands import forms_of
from nctakt.nc.vocabulary.entries import Entry, Kind, Support
from nctakt.nc.vocabulary.function_rows import GFunction
from nctakt.nc.vocabulary.functions import G_FUNCTIONS
from nctakt.nc.vocabulary.keywords import KEYWORDS, KeywordMeaning
from nctakt.nc.vocabulary.operators import CONSTANTS, FUNCTIONS, INFIX, PREFIX, Function, Operator
from nctakt.nc.vocabulary.single_axes import independent_axes, oscillation
from nctakt.nc.vocabulary.variables.system_names import BY_NAME
from nctakt.reference.article import Article, Fact, Topic, fact
from nctakt.reference.variables import UNITS, rows

KINDS = {
    Kind.G_FUNCTION: Text("G function", "G-Funktion"),
    Kind.M_FUNCTION: Text("M function", "M-Funktion"),
    Kind.TECHNOLOGY: Text(
        "synchronisation of M and H functions", "Synchronisation von M- und H-Funktionen"
    ),
    Kind.WORD: Text("word", "Wort"),
    Kind.CONTROL: Text("control word", "Steuerwort"),
    Kind.COMMAND: Text("# command", "#-Befehl"),
    Kind.VARIABLE: Text("variables", "Variablen"),
    Kind.FUNCTION: Text("function of expressions", "Funktion in Ausdrücken"),
    Kind.FORM: Text("form", "Form"),
}
SUPPORT = {
    Support.SIMULATED: Text("simulated", "simuliert"),
    Support.ACCEPTED: Text(
        "accepted: checked, changes no position here",
        "akzeptiert: wird geprüft, ändert hier keine Position",
    ),
    Support.REFUSED: Text(
        "refused: reported by name before the program runs",
        "abgelehnt: mit Namen gemeldet, bevor das Programm läuft",
    ),
}
_CONSTANTS = {
    "TRUE": Text("the value 1", "der Wert 1"),
    "FALSE": Text("the value 0", "der Wert 0"),
    "PI": Text("3.141592653589793", "3.141592653589793"),
}
_KEYWORD = Text("keyword of realtime cycles", "Schlüsselwort der Echtzeit-Zyklen")
_PREFIX = Text("operator before a value", "Operator vor einem Wert")
_INFIX = Text("operator between two values", "Operator zwischen zwei Werten")
_CONSTANT = Text("constant of expressions", "Konstante in Ausdrücken")
_COUNTS = Text("one elementary instruction", "eine Elementar-Anweisung")

_WAITS = Text(
    "at once; a synchronous one is read when the path is at rest, and written in program order",
    "sofort; eine synchrone wird gelesen, wenn die Bahn steht, und der Reihe nach geschrieben",
)
_LIVE_OR_FROZEN = Text(
    "synchronous, or with Vs.: the value of each tick; otherwise the value at decoding",
    "synchron oder mit Vs.: der Wert jedes Takts; sonst der Wert beim Dekodieren",
)
_PUT_OUT = Text(
    "output in the tick, without waiting for the PLC",
    "wird im Takt ausgegeben, ohne auf die SPS zu warten",
)
_READ_ONLY = Text("read", "lesen")
_READ_WRITE = Text("read and write", "lesen und schreiben")
_WHEN_DECODED = Text("when the block is decoded", "wenn der Satz dekodiert wird")
_WHEN_EMPTY = Text(
    "when the path is at rest; empties the channel", "wenn die Bahn steht; leert den Kanal"
)
_FROZEN = Text("the value of the definition, a constant", "der Wert der Definition, eine Konstante")
#: Facts beyond the support table.
_FURTHER: Mapping[str, tuple[Fact, ...]] = MappingProxyType(
    {
        "V.E": (
            fact("In programs", "In Programmen", _WAITS),
            fact("In realtime cycles", "In Echtzeit-Zyklen", _LIVE_OR_FROZEN),
            fact("PLC", "SPS", Text("sees it", "sieht sie")),
        ),
        "V.CH": (
            fact("In programs", "In Programmen", _WAITS),
            fact("In realtime cycles", "In Echtzeit-Zyklen", _LIVE_OR_FROZEN),
            fact("PLC", "SPS", Text("does not see it", "sieht sie nicht")),
            fact("Memory", "Speicher", "P-CHAN-00424 configuration.decoder.v_ch_memory"),
        ),
        "P": (
            fact("In programs", "In Programmen", Text("at once", "sofort")),
            fact(
                "In realtime cycles",
                "In Echtzeit-Zyklen",
                Text(
                    "the value at decoding; cannot be written",
                    "der Wert beim Dekodieren; nicht beschreibbar",
                ),
            ),
        ),
        "M": (fact("In realtime cycles", "In Echtzeit-Zyklen", _PUT_OUT),),
        "H": (fact("In realtime cycles", "In Echtzeit-Zyklen", _PUT_OUT),),
        "$IF": (
            fact("Written", "Schreibweise", "$IF … $ELSEIF … $ELSE … $ENDIF"),
            fact(
                "In realtime cycles",
                "In Echtzeit-Zyklen",
                Text("also $IF ONCE, EDGE or ALWAYS", "auch $IF ONCE, EDGE oder ALWAYS"),
            ),
            fact("True", "Wahr", Text("|value| ≥ 0.5", "|Wert| ≥ 0,5")),
        ),
        "#RT CYCLE": (
            fact(
                "Written",
                "Schreibweise",
                "#RT CYCLE [DEF] [ID=… SCOPE=… END_ACTION=…] … #RT CYCLE END",
            ),
            fact(
                "Management",
                "Verwaltung",
                "#RT CYCLE START | HOLD | CONTINUE | ABORT ACTION | DELETE [ID=…]",
            ),
            fact("Switched on by", "Eingeschaltet durch", "P-CHAN-00406"),
            fact("Limits", "Grenzen", "P-CHAN-00407, P-CHAN-00425, P-CHAN-00426, P-CHAN-00427"),
        ),
    }
)

_FORMS_OF_MOTION = ("X[INDP_SYN …]", "X[INDP_ASYN …]")
#: The keywords of the brackets of axes.
_BRACKET_KEYWORDS: Mapping[str, Sequence[str]] = MappingProxyType(
    {
        **dict.fromkeys(_FORMS_OF_MOTION, (*independent_axes.FLAGS, *independent_axes.VALUES)),
        "X[OSC …]": (*oscillation.FLAGS, *oscillation.VALUES),
        **{
            form.replace("…", row): [
                word for word, of in independent_axes.REFUSED_KEYWORDS.items() if of == row
            ]
            for form in _FORMS_OF_MOTION
            for row in independent_axes.REFUSED_KEYWORDS.values()
        },
    }
)

#: The beginning of a command for an axis or a spindle: its name and the first keyword.
_AXIS_COMMAND = re.compile(r"[^\W\d]\w*\s*\[\s*([^\W\d]\w*)")
_NUMBERED = re.compile(r"([GMH])0*(\d+)")
_PARAMETER = re.compile(r"P+\d+(?:\[.*\])*|P+\[.*\]")
_INDEX = re.compile(r"\[[^]]*\]")
_LAST = re.compile(r"\.\w+$")
_LAST_INDEX = re.compile(r"\[[^]]*\]$")
_FAMILY = re.compile(r"(V)S?(\.[A-Z_]+)(\..*)?")


# --- words, commands -----------------------------------------------------------------------------


def _of_system(name: str) -> Iterator[Fact]:
    """Yield type, unit and rights of V.G and V.A."""
    row = BY_NAME.get(name)
    if row is None:
        return
    yield fact("Type", "Typ", row.type)
    if row.unit:
        yield fact("Unit", "Einheit", UNITS.get(row.unit, Text(row.unit, row.unit)))
    right = _READ_WRITE if row.is_writable else _READ_ONLY
    yield fact("In programs", "In Programmen", right)
    when = _WHEN_EMPTY if row.waits else _WHEN_DECODED
    yield fact("Value", "Wert", when)
    yield fact("In realtime cycles", "In Echtzeit-Zyklen", _FROZEN)


def _members(entry: Entry) -> Iterator[str]:
    """Yield the variables of a family that have their own articles."""
    if entry.kind is Kind.VARIABLE:
        beginning = f"{entry.name}."
        known = (*(name for name, _ in rows()), *_simulated_variables())
        yield from (name for name in known if name.startswith(beginning))


def _simulated_variables() -> Iterator[str]:
    for entry in support_level.entries():
        if entry.kind is Kind.VARIABLE and entry.support is Support.SIMULATED:
            yield entry.name


def entry_article(entry: Entry) -> Article:
    """Return the article of a row of the support table."""
    facts = [*_FURTHER.get(entry.name, ()), *_of_system(entry.name)]
    members = ", ".join(_members(entry))
    if members:
        facts.append(fact("Known here", "Hier bekannt", members))
    if entry.name in _BRACKET_KEYWORDS:
        facts.append(fact("Keywords", "Schlüsselwörter", ", ".join(_BRACKET_KEYWORDS[entry.name])))
    if entry.forms:
        facts.append(fact("Written", "Schreibweise", forms_of(entry.name)))
    label = (
        Text("Others", "Andere")
        if members and entry.support is Support.REFUSED
        else Text("In nctakt", "In nctakt")
    )
    facts.append(Fact(label, SUPPORT[entry.support]))
    if entry.support is Support.REFUSED:
        facts.append(fact("Instead", "Stattdessen", entry.advice))
    if isinstance(entry, GFunction) and entry.group is not None:
        others = ", ".join(
            other.name
            for other in G_FUNCTIONS.values()
            if other.group is entry.group and other is not entry
        )
        facts.append(fact("Not together with", "Nicht zusammen mit", others))
    return Article(entry.name, KINDS[entry.kind], entry.meaning, tuple(facts))


def _entries() -> Iterator[Entry]:
    return (entry for entry in support_level.entries() if entry.kind is not Kind.FUNCTION)


def _all_words() -> Iterator[Article]:
    return (entry_article(entry) for entry in _entries())


def _find_word(word: str) -> tuple[Article, ...]:
    entries = {entry.name.upper(): entry for entry in _entries()}
    for candidate in _spellings(word):
        if candidate in entries:
            return (entry_article(entries[candidate]),)
    return ()


def _spellings(word: str) -> Iterator[str]:
    """Yield the spellings of a word that the table may have, from the nearest to the widest."""
    text = " ".join(word.upper().split())
    yield text
    numbered = _NUMBERED.fullmatch(text)
    if numbered is not None:
        letter, number = numbered[1], int(numbered[2])
        yield f"{letter}{number:02}"
        yield f"{letter}{number}"
        if letter != "G":
            yield letter
    if text.startswith("#"):
        words = text.split()
        for count in range(len(words) - 1, 0, -1):
            yield " ".join(words[:count])
    elif text.startswith("$"):
        yield {"$ELSEIF": "$IF", "$ELSE": "$IF", "$UNTIL": "$REPEAT"}.get(text, text)
        yield text.replace("$END", "$")
        yield {"$CASE": "$SWITCH", "$DEFAULT": "$SWITCH"}.get(text, text)
    elif _PARAMETER.fullmatch(text):
        yield "P"
    command = _AXIS_COMMAND.match(text)
    if command is not None:
        yield from (f"X[{command[1]} …]", f"S[{command[1]} …]")
    if text.startswith(("V.A.", "V.G.")):
        indexed = _INDEX.sub("[1]", text)
        of_axis = _INDEX.sub("[1]", _LAST_INDEX.sub(".X", text))
        yield from (indexed, _LAST.sub(".X", indexed), of_axis)
    family = _FAMILY.fullmatch(text)
    if family is not None and family[2] not in (".RTA", ".RTG"):
        yield family[1] + family[2]


def _word_names() -> Iterator[str]:
    return (entry.name for entry in _entries())


WORDS = Topic(
    "words",
    Text("Words and commands of NC programs", "Wörter und Befehle der NC-Programme"),
    ("G01", "M30", '"#RT CYCLE"', "'$IF'"),
    _all_words,
    _find_word,
    _word_names,
)


# --- expressions ---------------------------------------------------------------------------------


def operator_article(operator: Operator, *, is_prefix: bool) -> Article:
    """Return the article of an operator."""
    side = Text("left to right", "von links nach rechts")
    if operator.right_associative:
        side = Text("right to left", "von rechts nach links")
    facts = [
        fact("Values", "Werte", operator.domain),
        fact("Precedence", "Rang", operator.precedence),
    ]
    if not is_prefix:
        facts.append(fact("Grouped", "Reihenfolge", side))
    facts.append(fact("Counts", "Zählt", _COUNTS))
    kind = _PREFIX if is_prefix else _INFIX
    return Article(operator.symbol, kind, operator.meaning, tuple(facts))


def function_article(function: Function) -> Article:
    """Return the article of a function."""
    letters = ", ".join("ab"[: function.maximum])
    facts = [
        fact("Written", "Schreibweise", f"{function.name}[{letters}]"),
        fact("Values", "Werte", function.domain),
    ]
    entry = support_level.expression_function(function.name)
    assert entry is not None
    if function.decoder_only:
        usage = Text("not in realtime cycles", "nicht in Echtzeit-Zyklen")
        facts.append(fact("Use", "Verwendung", usage))
    else:
        facts.append(fact("Counts", "Zählt", _COUNTS))
    facts.append(fact("In nctakt", "In nctakt", SUPPORT[entry.support]))
    return Article(function.name, KINDS[Kind.FUNCTION], function.meaning, tuple(facts))


def _constant_article(name: str) -> Article:
    return Article(name, _CONSTANT, _CONSTANTS[name], (fact("Counts", "Zählt", "0"),))


def _all_expressions() -> Iterator[Article]:
    yield from (operator_article(operator, is_prefix=True) for operator in PREFIX.values())
    yield from (operator_article(operator, is_prefix=False) for operator in INFIX.values())
    yield from map(function_article, FUNCTIONS.values())
    yield from map(_constant_article, CONSTANTS)


def _find_expression(word: str) -> tuple[Article, ...]:
    name = word.upper().split("[", maxsplit=1)[0].strip()
    return tuple(article for article in _all_expressions() if article.name == name)


def _expression_names() -> Iterator[str]:
    return iter((*PREFIX, *INFIX, *FUNCTIONS, *CONSTANTS))


EXPRESSIONS = Topic(
    "expressions",
    Text("Operators, functions, constants", "Operatoren, Funktionen, Konstanten"),
    ("SQRT", "MOD", "'**'"),
    _all_expressions,
    _find_expression,
    _expression_names,
)


# --- keywords ------------------------------------------------------------------------------------


def _keyword_article(keyword: KeywordMeaning) -> Article:
    facts: tuple[Fact, ...] = (fact("Example", "Beispiel", keyword.example),)
    return Article(keyword.name, _KEYWORD, keyword.meaning, facts)


def _find_keyword(word: str) -> tuple[Article, ...]:
    name = word.upper().removeprefix("#RT CYCLE ").strip()
    return tuple(
        _keyword_article(keyword) for keyword in KEYWORDS.values() if keyword.name.upper() == name
    )


KEYWORDS_TOPIC = Topic(
    "keywords",
    Text("Keywords of realtime cycles", "Schlüsselwörter der Echtzeit-Zyklen"),
    ("ONCE", "SCOPE", "MOVE_CONT"),
    lambda: map(_keyword_article, KEYWORDS.values()),
    _find_keyword,
    lambda: iter(KEYWORDS),
)
