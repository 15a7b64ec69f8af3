# SPDX-License-Identifier: MIT
"""Diagnostics: the cause of a problem, its position and its remedy.

In: a message of the catalogue (``messages/``), a position, the values of the message's parameters.
Out: a ``Diagnostic``, and its rendering with number, file, line, column, source line, caret and
remedy. Everything that a user, a list or the PLC can cause is a diagnostic; a mistake of nctakt
itself is an ``assert``.
"""

from __future__ import annotations

import enum
import re
from collections.abc import Callable, Mapping
from typing import Literal, NamedTuple

from nctakt.base.dataclass import dataclass

Language = Literal["en", "de"]
#: The environment variable for the language of texts and messages.
LANGUAGE_VARIABLE = "NCTAKT_LANGUAGE"

#: The value of a parameter without a value: no name is similar, a list is empty.
NOTHING = "–"

#: Longest part of a source line that is shown above the caret, in characters.
EXCERPT_WIDTH = 120


_SENTENCE_END = re.compile(r"(?<=[.?!;]) ")


class Severity(enum.IntEnum):
    """The severity of a message: an error keeps a program from running, a warning does not."""

    NOTE = 0
    WARNING = 1
    ERROR = 2

    def label(self, language: Language) -> str:
        """Return the word before the number: "error", "warning", "note"."""
        return _LABELS[language][self]


_LABELS: dict[Language, tuple[str, str, str]] = {
    "en": ("note", "warning", "error"),
    "de": ("Hinweis", "Warnung", "Fehler"),
}


#: A longer value, such as a name of a million letters, is cut off in messages.
_LONGEST_VALUE = 400


@dataclass(frozen=True, slots=True, order=True)
class Span:
    """A position in a text: lines and columns count from 1, ``end_column`` is exclusive.

    ``file`` is the name as the user wrote it; a span never covers more than one line. Line 0 is the
    file as a whole, for something missing in it.
    """

    file: str
    line: int
    column: int
    end_column: int

    def __str__(self) -> str:
        return f"{self.file}:{self.line}:{self.column}" if self.line else self.file


def whole_file(file: str) -> Span:
    """Return the span of a diagnostic that belongs to no line of a file."""
    return Span(file, 0, 0, 0)


@dataclass(frozen=True, slots=True)
class Text:
    """One text in both languages."""

    en: str
    de: str

    def get(self, language: Language) -> str:
        """Return the text in the language that the user asked for."""
        return self.de if language == "de" else self.en


_NOTHING_SIMILAR = Text(
    "Check the spelling; no known name is clearly meant.",
    "Die Schreibweise prüfen; kein bekannter Name ist eindeutig gemeint.",
)


@dataclass(frozen=True, slots=True)
class Cases:
    """Numbers of a message by case; ``number_of`` gives that of some values, 0: none of them."""

    numbers: tuple[int, ...]
    number_of: Callable[[Mapping[str, object]], int]


class Wording(NamedTuple):
    """What a message says, in English and German: format strings, and how the error comes about."""

    text: tuple[str, str]
    remedy: tuple[str, str]
    cause: tuple[str, str]


class Message:
    """A message of the catalogue, declared in ``messages/``; a slotted class, cheap to make.

    ``id`` is the leading number: the controller's, or from 900000 on nctakt's. ``text`` and
    ``remedy`` are format strings over the names in ``parameters``; ``explained`` returns these with
    their meanings. ``reaction`` and ``clearing`` are the controller's classes for the effect of an
    error and for clearing it (0: none; ``messages/classes.py`` has their meaning). ``cause``
    explains how the error comes about; ``known_as`` are its further numbers, ``cases`` those that
    lead in some cases instead of ``id``.
    """

    __slots__ = (
        "_explained",
        "_parameters",
        "_wording",
        "cases",
        "clearing",
        "id",
        "known_as",
        "reaction",
        "severity",
    )

    def __init__(
        self,
        number: int,
        severity: Severity,
        wording: Wording,
        explained: Callable[[], Mapping[str, tuple[str, str]]],
        classes: tuple[int, int],
        known_as: tuple[int, ...] = (),
        cases: Cases | None = None,
    ) -> None:
        self.id = number
        self.severity = severity
        self._wording = wording
        self._explained = explained
        self._parameters: Mapping[str, tuple[str, str]] | None = None
        self.reaction, self.clearing = classes
        self.known_as = known_as
        self.cases = cases

    @property
    def parameters(self) -> Mapping[str, tuple[str, str]]:
        """The names in text and remedy, and the meaning of each in English and German."""
        if self._parameters is None:
            self._parameters = self._explained()
        return self._parameters

    @property
    def leading(self) -> tuple[int, ...]:
        """The numbers that can lead: ``id``, and those of its cases."""
        return (self.id,) if self.cases is None else (self.id, *self.cases.numbers)

    @property
    def numbers(self) -> tuple[int, ...]:
        """All its numbers, each once."""
        return tuple(dict.fromkeys((*self.leading, *self.known_as)))

    def number_of(self, values: Mapping[str, object]) -> int:
        """The number that leads for these values of its parameters."""
        return (self.cases and self.cases.number_of(values)) or self.id

    def __repr__(self) -> str:
        return f"<Message {self.id}: {self._wording.text[0]}>"

    @property
    def text(self) -> Text:
        """The problem, with the parameters' names in braces."""
        return Text(*self._wording.text)

    @property
    def remedy(self) -> Text:
        """The remedy, with the parameters' names in braces."""
        return Text(*self._wording.remedy)

    @property
    def cause(self) -> Text:
        """The cause, for an explanation; empty if text and remedy say it all."""
        return Text(*self._wording.cause)


@dataclass(frozen=True, slots=True, repr=False)
class Diagnostic:
    """A message, its position (``None``: no file involved) and its parameters' values.

    ``source_line`` is the whole text line of the span, without its end, for the excerpt.
    ``is_lenient``: an error that is only a warning here. ``entry``: the entry of a list that it
    concerns, which may be missing there. ``number``: that of the case; 0: its values tell it.
    ``within``: the part of an object that its line belongs to, as shown by the programming system.

    >>> run = Controller().run(NcText("part.nc", "G01 X100 F6000 Q1 M30"))
    >>> diagnostic = run.diagnostics[0]
    >>> diagnostic.id, str(diagnostic.span), diagnostic.remedy()
    (20797, 'part.nc:1:16', 'Axes of the channel: X, Y, Z, A')
    """

    message: Message
    span: Span | None
    values: Mapping[str, object]
    source_line: str = ""
    is_lenient: bool = False
    entry: str = ""
    number: int = 0
    within: Text | None = None

    def __repr__(self) -> str:
        return f"<{self.headline()}>"

    def __str__(self) -> str:
        return self.render()

    @property
    def id(self) -> int:
        """The number that leads here."""
        return self.number or self.message.number_of(self.values)

    @property
    def also(self) -> tuple[int, ...]:
        """Its other numbers: ours where the controller's leads, those of other documents."""
        others = self.message.known_as
        if self.id != self.message.id:
            others = tuple(number for number in others if number != self.id)
        return others

    @property
    def severity(self) -> Severity:
        """The message's severity, a warning where an error is lenient."""
        return Severity.WARNING if self.is_lenient else self.message.severity

    def text(self, language: Language = "en") -> str:
        """Return the message with its parameters filled in."""
        text = self.message.text.get(language).format_map(self._shown_values(language))
        return text if self.within is None else f"{text} ({self.within.get(language)})"

    def remedy(self, language: Language = "en") -> str:
        """Return the remedy with the parameters filled in, without sentences about ``NOTHING``."""
        template = self.message.remedy.get(language)
        values = self._shown_values(language)
        empty = {name for name, value in values.items() if value == NOTHING}
        if not any(f"{{{name}}}" in template for name in empty):
            return template.format_map(values).rstrip()
        sentences = [
            sentence.format_map(values)
            for sentence in _SENTENCE_END.split(template)
            if not any(f"{{{name}}}" in sentence for name in empty)
        ]
        if not sentences:
            return _NOTHING_SIMILAR.get(language)
        text = " ".join(sentences).removesuffix(";")
        return text[0].upper() + text[1:]

    def _shown_values(self, language: Language) -> dict[str, object]:
        """Return the values as a reader of this language writes them."""
        return {name: _shown_value(value, language) for name, value in self.values.items()}

    def headline(self, language: Language = "en") -> str:
        """Return ``file:line:column: error 22009: text``, without the excerpt."""
        position = f"{self.span}: " if self.span is not None else ""
        return f"{position}{self.severity.label(language)} {self.id}: {self.text(language)}"

    def render(self, language: Language = "en") -> str:
        """Return headline, source line with caret and remedy as lines, without a final newline."""
        lines = [self.headline(language)]
        if self.span is not None and self.source_line:
            lines += excerpt(self.source_line, self.span.column, self.span.end_column)
        remedy = self.remedy(language)
        if remedy:
            label = "Abhilfe" if language == "de" else "remedy"
            lines.append(f"  {label}: {remedy}")
        return "\n".join(lines)


def _shown_value(value: object, language: Language) -> object:
    if isinstance(value, Text):
        return value.get(language)
    if isinstance(value, str) and len(value) > _LONGEST_VALUE:
        return f"{value[:_LONGEST_VALUE]}…"
    return number_text(value) if isinstance(value, float) else value


def number_text(value: float) -> str:
    """Return a number for a reader: integers in full, up to 1e21, others with twelve digits."""
    is_integer = abs(value) < 1e21 and value == int(value)
    return f"{int(value)}" if is_integer else f"{value:.12g}"


def excerpt(line: str, column: int, end_column: int) -> list[str]:
    """Return the source line and a line with carets under ``column`` … ``end_column``.

    A long line is cut around them; a character that does not print becomes a dot, a tab a blank.
    """
    start = max(0, min(column - 1 - EXCERPT_WIDTH // 2, len(line) - EXCERPT_WIDTH))
    end = start + EXCERPT_WIDTH
    shown = "".join(_shown(character) for character in line[start:end])
    before = "…" if start else ""
    after = "…" if end < len(line) else ""
    offset = column - 1 - start + len(before)
    width = max(1, min(end_column, end + 1) - column)
    return [f"    {before}{shown}{after}", f"    {' ' * offset}{'^' * width}"]


def _shown(character: str) -> str:
    if character == "\t":
        return " "
    return character if character.isprintable() else "·"
