# SPDX-License-Identifier: MIT
"""Hover text of the word under the mouse: articles of ``nctakt explain``, facts of the program.

In: a document, a position. Out: Markdown, ``None`` for a word without an article.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import lru_cache

from lsprotocol.types import Hover, MarkupContent, MarkupKind, Position

from nctakt.base.diagnostics import Diagnostic, Language, Text
from nctakt.editor.display.line_tokens import Token, word_at
from nctakt.editor.document import Document
from nctakt.editor.names import Occurrence, occurrences, section_of, symbol_at
from nctakt.messages.programs.lints import ASYNCHRONOUS_CONDITION, ASYNCHRONOUS_VALUE
from nctakt.nc.vocabulary import support_level
from nctakt.nc.vocabulary.functions import M_FUNCTIONS
from nctakt.reference.article import Article
from nctakt.reference.language import entry_article
from nctakt.reference.machine_variables import MachineVariables
from nctakt.reference.machine_words import axis_articles, feed_articles, function_articles
from nctakt.reference.topics import articles_about
from nctakt.run.realtime.assembly import AssembledMachine

_NOT_DECLARED = Text("not in the lists of this machine", "nicht in den Listen dieser Maschine")
#: Variables that the lists of the machine declare.
_OF_LISTS = ("V.E.", "V.CH.")
_KEY = re.compile(r"[\w.\[\]]+")
#: A path of the interface to the PLC, in a comment or in a PLC.
_INTERFACE = re.compile(
    r"(?<![\w.])(?:HLI_Global_Variables\.)?gp(?:Ch|Ax|Pform)(?:\[\w*\])?\^[\w\[\].]*",
    re.IGNORECASE,
)
_NUMBER = re.compile(r"\d{4,6}")
_DEFINED = Text("defined in line {line}", "definiert in Zeile {line}")
_ASSIGNED = Text("first assigned in line {line}", "zuerst zugewiesen in Zeile {line}")
_NEVER = Text("not defined in this program", "in diesem Programm nicht definiert")
#: Maximum number of articles shown for one word.
_MAX_ARTICLES = 4


def hover(
    document: Document,
    position: Position,
    machine: AssembledMachine,
    findings: Sequence[Diagnostic],
    language: Language,
) -> Hover | None:
    """Return the explanation of the word at a position."""
    line, index = document.line(position.line), document.index(position)
    if any(match.start() <= index <= match.end() for match in _INTERFACE.finditer(line)):
        return _of_pattern(_INTERFACE, document, position, line, index, language)
    if document.is_list:
        return _of_pattern(_KEY, document, position, line, index, language)
    token = word_at(line, index)
    if token is None:
        return None
    symbol = symbol_at(document.lines, position.line, index)
    parts = [
        *_frozen(findings, position.line + 1, index + 1, language),
        *_own_facts(document, symbol, language),
        *_articles(token, symbol, machine, language),
    ]
    if not parts:
        return None
    area = document.range(position.line, token.start, token.end)
    return Hover(MarkupContent(MarkupKind.Markdown, "\n\n".join(parts)), area)


def _of_pattern(
    pattern: re.Pattern[str],
    document: Document,
    position: Position,
    line: str,
    index: int,
    language: Language,
) -> Hover | None:
    """Return the explanation of the word at a position that a pattern finds."""
    match = next((m for m in pattern.finditer(line) if m.start() <= index <= m.end()), None)
    if match is None:
        return None
    text = [article_text(article, language) for article in articles_of(match[0])]
    if not text:
        return None
    area = document.range(position.line, *match.span())
    return Hover(MarkupContent(MarkupKind.Markdown, "\n\n".join(text)), area)


def _frozen(
    findings: Sequence[Diagnostic], line: int, column: int, language: Language
) -> Iterator[str]:
    """Yield the check's note at this place if a value is frozen."""
    for item in findings:
        span = item.span
        if item.message not in (ASYNCHRONOUS_CONDITION, ASYNCHRONOUS_VALUE) or span is None:
            continue
        if span.line == line and span.column <= column <= span.end_column:
            yield f"**{item.text(language)}**"


def _own_facts(document: Document, symbol: Occurrence | None, language: Language) -> Iterator[str]:
    """Yield where the program defines a name, with the line that does."""
    if symbol is None or symbol.symbol.kind in ("axis", "file"):
        return
    kind, name = symbol.symbol
    if kind == "variable" and name.split(".")[1] not in ("P", "L", "S", "CYC"):
        return
    within = section_of(document.lines, symbol.line) if kind == "label" else None
    found = (item for item in occurrences(document.lines, symbol.symbol, within))
    definition = next((item for item in found if item.is_definition), None)
    if definition is None:
        yield f"{name}: {_NEVER.get(language)}"
        return
    words = _ASSIGNED if kind == "parameter" else _DEFINED
    where = words.get(language).format(line=definition.line + 1)
    yield f"{name}: {where}\n```nc\n{document.line(definition.line).strip()}\n```"


def _of_function(text: str, machine: AssembledMachine) -> list[Article]:
    """Return the articles of a G, M or H function; none if no channel has it."""
    letter, written = text[0].upper(), text[1:]
    if not written.isdecimal():
        return [] if written else list(articles_of(letter))
    number = int(written)
    if letter == "G":
        known = support_level.g_function(number)
        return [] if known is None else [entry_article(known)]
    listed = function_articles(machine.configuration, letter, number)
    known_m = M_FUNCTIONS.get(number) if letter == "M" else None
    if known_m is not None:
        return [entry_article(known_m), *listed]
    return [*listed, *articles_of(letter)] if listed else []


def _articles(
    token: Token,
    symbol: Occurrence | None,
    machine: AssembledMachine,
    language: Language,
) -> list[str]:
    if token.kind in ("comment", "string"):
        numbers = _NUMBER.findall(token.text) if "nctakt" in token.text else []
        return [article_text(item, language) for number in numbers for item in articles_of(number)]
    articles: Sequence[Article] = ()
    if symbol is not None and symbol.symbol.kind == "variable":
        name = symbol.symbol.name
        articles = MachineVariables(machine.configuration).find(name)
        if not articles and name.startswith(_OF_LISTS):
            return [f"{name}: {_NOT_DECLARED.get(language)}"]
    if token.kind == "function":
        articles = _of_function(token.text, machine)
        return [article_text(article, language) for article in articles]
    articles = [*articles, *_of_machine(token, machine)]
    if articles and token.kind in ("axisword", "keyword"):
        articles = [*articles, *articles_of(token.text)]
    for word in _words(token):
        articles = articles or articles_of(word)
    return [article_text(article, language) for article in articles[:_MAX_ARTICLES]]


def _of_machine(token: Token, machine: AssembledMachine) -> tuple[Article, ...]:
    """Return the machine lists' data for an axis word, ``X[…]``, or F."""
    if token.kind not in ("axisword", "keyword", "name"):
        return ()
    if token.text.upper() == "F":
        return feed_articles(machine.configuration)
    return axis_articles(machine.configuration, token.text)


def _words(token: Token) -> Iterator[str]:
    """Yield the words to be explained of a token, the most specific first."""
    text = " ".join(token.text.split())
    if token.kind == "command":
        words = text.lstrip("# ").split(" ")
        for count in range(len(words), 0, -1):
            yield "#" + " ".join(words[:count])
    elif token.kind == "program":
        yield "%"
    elif token.kind == "call":
        yield text.split(" ")[0]
    elif token.kind == "variable":
        yield re.sub(r"^Vs\.", "V.", text, flags=re.IGNORECASE)
    elif token.kind not in ("number", "member"):
        yield text
        if token.kind in ("block", "parameter"):
            yield text.rstrip(":0123456789.")


@lru_cache(maxsize=512)
def articles_of(word: str) -> tuple[Article, ...]:
    """Return the articles of a word."""
    return articles_about(word)


def article_text(article: Article, language: Language) -> str:
    """Return an article as Markdown."""
    lines = [
        f"**{article.name}** – {article.kind.get(language)}",
        "",
        article.meaning.get(language).replace("\n", "  \n"),
    ]
    if article.facts:
        lines.append("")
    for fact in article.facts:
        value = fact.value.get(language).replace("\n", " ")
        lines.append(f"- {fact.label.get(language)}: {value}")
    return "\n".join(lines)
