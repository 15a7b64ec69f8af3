# SPDX-License-Identifier: MIT
"""Expectations in the comments of NC programs: text -> inputs and expected results of its run.

``; given: …`` is an input of the run, ``; expect: …`` an expected result; a comment may have
several, separated by ``;``. An expectation after a block is about its line.

    ; given: V.E.VALUE = 5            before the first tick
    ; given: V.E.DOOR = 1 at 20ms     at a time of the run
    ; given: plc slow_plc.py          files and folders relative to the program
    ; given: machine ../machine       until 2s, after 100ms, start: it waits for HLI.START
    ; given: skip 1,2                 ticks 500, from line 40, from block 120
    ; given: channel 2 unload.nc      a program that runs in another channel meanwhile

    ; expect: fired                   an $IF of a realtime cycle; fired 17 line 5
    ; expect: M100                    a function; H7
    ; expect: message "done"          #MSG
    ; expect: X = 200.25 at 463ms     an axis, V.E.COUNT, PATH.SPEED …; within 0.1
    ; expect: MAIN.eGate = E_Gate.Open at 2s    an item of an enumeration of the PLC; TRUE, FALSE
    ; expect: MAIN.eGate = E_Gate.Open    a variable of the PLC; TRUE, FALSE, an item
    ; expect: X within 0.05 mm of machine.csv    at all times near a log, beside the program
    ; expect: error 22009             in this line; warning 20824
    ; expect: ended                   the program came to its end

After an event: ``at 463ms`` (``at 463 ticks``; several with commas), ``before TIME``,
``after TIME``, ``never``, ``once``, ``3 times``; ``never after 1s`` counts only later events.
After a value ``at TIME`` or ``at end``.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import chain
from pathlib import Path
from typing import Any, Literal, cast

from nctakt.base.comment_keywords import heads, keyword_near
from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Diagnostic, Span
from nctakt.base.failure import Failure
from nctakt.base.text import split_lines
from nctakt.lists.format import times
from nctakt.lists.format.times import Time, read_time
from nctakt.messages import diagnostic
from nctakt.messages.commands.command_line import OPTION_REPEATED
from nctakt.messages.commands.inputs import (
    INVALID_EXPECTATION,
    INVALID_GIVEN_INPUT,
    MISSPELLED_SIGNAL,
    UNKNOWN_SIGNAL,
)
from nctakt.nc.check.comments import misspelt_keywords
from nctakt.nc.source import Source
from nctakt.project.run_settings import Named
from nctakt.run.access.stimuli import Stimulus, parse_assignment
from nctakt.run.option_kinds import Flag, Whole
from nctakt.run.options import BY_NAME, DATA_NAMES, RunKeywords, accepted_by, merged

#: Tolerance of an expected value unless the expectation has one.
TOLERANCE = 1e-6

Kind = Literal["fired", "function", "message", "value", "log", "error", "ended"]
GivenKind = Literal["plc", "machine", "channel", "value"]

_COMMENT = re.compile(r";\s*(?P<kind>expect|given):(?P<text>.*)", re.IGNORECASE)
_LATER = re.compile(r"\s*(?P<kind>expect|given):(?P<text>.*)", re.IGNORECASE | re.DOTALL)
_TIME = times.PATTERN
_WHEN = re.compile(
    rf"(?:\s+at\s+(?P<at>{_TIME}(?:\s*,\s*{_TIME})*)|\s+before\s+(?P<before>{_TIME})"
    rf"|\s+after\s+(?P<after>{_TIME})|\s+(?P<never>never)|\s+(?P<once>once)"
    r"|\s+(?P<count>\d+)\s+times)+\s*$",
    re.IGNORECASE,
)
_FIRED = re.compile(r"fired(?:\s+(?P<cycle>#?\d+))?(?:\s+line\s+(?P<line>\d+))?", re.IGNORECASE)
_FUNCTION = re.compile(r"[MHT]\d+", re.IGNORECASE)
_MESSAGE = re.compile(r'message\s+"(?P<text>.*)"', re.IGNORECASE)
_ERROR = re.compile(r"(?P<severity>error|warning)\s+(?P<number>\d+)", re.IGNORECASE)
_VALUE = re.compile(
    r"(?P<name>[A-Z#][\w.#\[\]]*)\s*=\s*"
    r"(?:(?P<value>[+-]?[\d.]+(?:e[+-]?\d+)?)|(?P<item>[A-Z_][\w.]*))"
    rf"(?:\s+within\s+(?P<within>[\d.]+))?(?:\s+at\s+(?P<at>end|{_TIME}))?\s*$",
    re.IGNORECASE,
)
_NEAR = re.compile(
    r"(?P<name>[A-Z#][\w.#\[\]]*)\s+within\s+(?P<within>\d*\.?\d+)\s*(?P<unit>\S+)?"
    r"\s+of\s+(?P<file>\S.*)",
    re.IGNORECASE,
)
_TRUTH = {"TRUE": 1.0, "FALSE": 0.0}
_CHANNEL = re.compile(r"channel\s+(?P<number>\d{1,3})\s+(?P<path>\S.*)", re.IGNORECASE)
_FILE = re.compile(r"(?P<what>plc|machine)\s+(?P<path>\S.*)", re.IGNORECASE)
_UNTIL = re.compile(rf"until\s+(?P<time>{_TIME})", re.IGNORECASE)
#: Further run options, each with the expression of its comment.
_OPTIONS = tuple(
    (option, re.compile(rf"{option.comment_name}(?:\s+(?P<words>\S.*))?", re.IGNORECASE))
    for option in accepted_by("comment")
    if option.name in DATA_NAMES and option.name != "until"
)
_GIVEN_AT = re.compile(rf"(?P<assignment>.*=.*?)\s+at\s+(?P<time>{_TIME})", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class Place:
    """The place of a part of a comment, with the whole line."""

    span: Span
    source_line: str

    def of(self, found: Diagnostic) -> Diagnostic:
        """Return a diagnostic at this place unless it has one."""
        if found.span is not None:
            return found
        return replace(found, span=self.span, source_line=self.source_line)


@dataclass(frozen=True, slots=True)
class Expectation:
    """An expected result: the ``line`` of its comment and its ``text`` as written.

    ``about``: the line that it is about, ``None``: any. ``at``: exactly these times, all of
    them; ``item``: the item of an enumeration whose number is expected; ``count``: the expected
    number of events, ``None``: at least one; ``within``: the tolerance, in ``unit`` if it is one
    to a log, ``file``.
    """

    line: int
    text: str
    kind: Kind
    about: int | None
    name: str = ""
    number: float = 0.0
    item: str = ""
    within: float = 0.0
    unit: str = ""
    file: str = ""
    at: tuple[Time, ...] = ()
    before: Time | None = None
    after: Time | None = None
    count: int | None = None
    position: Place | None = field(default=None, compare=False)

    def placed(self, failure: Failure) -> Sequence[Diagnostic]:
        """Return the mistakes in the expectation itself, at its position."""
        if self.position is None:
            return failure.diagnostics
        return [self.position.of(found) for found in failure.diagnostics]


@dataclass(frozen=True, slots=True)
class Given:
    """An input as a comment names it: a file or folder, or the name of a variable."""

    kind: GivenKind
    name: str
    position: Place


@dataclass(slots=True)
class Script:
    """The inputs and expectations in the comments of a program."""

    expectations: list[Expectation] = field(default_factory=list)
    assignments: dict[str, float | str] = field(default_factory=dict)
    stimuli: list[Stimulus] = field(default_factory=list)
    plcs: list[str] = field(default_factory=list)
    machine: str | None = None
    until: Time | None = None
    options: RunKeywords = field(default_factory=RunKeywords)
    channels: dict[int, list[str]] = field(default_factory=dict)
    givens: list[Given] = field(default_factory=list)

    def named(self, folder: Path) -> Named:
        """Return the settings of its run that it names; ``folder``: that of the program."""
        return Named(
            machine=self.machine,
            plcs=tuple(self.plcs),
            values=self.assignments,
            until=self.until,
            base=folder,
        )

    def placed(self, failure: Failure) -> Failure:
        """Return a failure of the run; a mistake in a name has the place of its comment."""
        return Failure(*map(self._placed, failure.diagnostics))

    def _placed(self, found: Diagnostic) -> Diagnostic:
        is_signal = found.message in (UNKNOWN_SIGNAL, MISSPELLED_SIGNAL)
        places: list[tuple[str, Place | None]] = [
            *(() if is_signal else ((one.name, one.position) for one in self.givens)),
            *((one.name, one.position) for one in self.expectations),
        ]
        name = found.values.get("name")
        position = next((position for other, position in places if other == name), None)
        return found if position is None else position.of(found)


def read_script(path: Path, text: str) -> Script:
    """Return the inputs and expectations of a program.

    Raises ``Failure`` with all invalid comments in their order: 900660 for an expectation, 900661
    for an input, 900662 for a misspelt keyword, 900510 … 900512 for times and values.
    """
    diagnostics: list[Diagnostic] = []
    script = parse_script(Source(str(path), split_lines(text)), diagnostics)
    if diagnostics:
        raise Failure(*sorted(diagnostics, key=_position))
    return script


def _position(found: Diagnostic) -> tuple[int, int]:
    assert found.span is not None  # each has the place of its comment
    return found.span.line, found.span.column


def is_script(line: str) -> bool:
    """Return whether a line has an input or an expectation, or something like one."""
    if ";" not in line:
        return False
    return _COMMENT.search(line) is not None or next(iter(heads(line)), None) is not None


def parse_script(
    source: Source, diagnostics: list[Diagnostic], numbers: Sequence[int] | None = None
) -> Script:
    """Return the inputs and expectations of a program; invalid comments go to ``diagnostics``.

    ``numbers``: those of the lines with inputs or expectations, if they are known.
    """
    script = Script()
    lines: Iterable[tuple[int, str]]
    if numbers is None:
        lines = enumerate(chain.from_iterable(source.groups()), 1)
    else:
        lines = ((number, source.lines[number - 1]) for number in numbers)
    for number, line in lines:
        if ";" in line:
            _comments(script, source.file, number, line, diagnostics)
    return script


def _comments(
    script: Script, file: str, number: int, line: str, diagnostics: list[Diagnostic]
) -> None:
    """Add the inputs and expectations in a line to the script."""
    diagnostics += misspelt_keywords(file, number, line)
    match = _COMMENT.search(line)
    if match is None:
        return
    about = number if line[: match.start()].strip() else None
    kind = match["kind"].lower()
    for begin, part in _parts(match["text"]):
        later = _LATER.fullmatch(part)
        kind, words = (later["kind"].lower(), later["text"]) if later else (kind, part)
        misspelt = None if later else next(heads(f";{part}"), None)
        if misspelt is not None:  # it has been reported, with the intended keyword
            kind = keyword_near(misspelt["word"])
            continue
        end = match.start("text") + begin + len(part.rstrip())
        words = words.strip()
        column = end - len(words) + 1
        position = Place(Span(file, number, column, max(end, column) + 1), line)
        try:
            if kind == "given":
                _give(script, words, position)
            else:
                script.expectations.append(
                    replace(_expectation(words, number, about), position=position)
                )
        except _NotUnderstoodError:
            message = INVALID_GIVEN_INPUT if kind == "given" else INVALID_EXPECTATION
            diagnostics.append(diagnostic(message, position.span, line, text=words))
        except Failure as failure:
            # Times and values are read wherever a user writes them: here they have a place.
            diagnostics += [
                replace(found, span=position.span, source_line=line)
                for found in failure.diagnostics
            ]


def read_expectation(text: str) -> Expectation:
    """Return the expectation of a text that is in no program; raises ``Failure`` (900660)."""
    try:
        found = _expectation(text.strip(), 0, None)
        if found.kind == "log":  # a log belongs to one run
            raise _NotUnderstoodError
    except _NotUnderstoodError as error:
        raise Failure(diagnostic(INVALID_EXPECTATION, text=text)) from error
    return found


class _NotUnderstoodError(Exception):
    """A comment is not a valid expectation."""


def _parts(text: str) -> Iterator[tuple[int, str]]:
    """Yield the parts between ``;`` outside of quotes, each with its position in the text."""
    begin, quoted = 0, False
    for position, character in enumerate(f"{text};"):
        quoted ^= character == '"'
        if position == len(text) or (character == ";" and not quoted):
            part = text[begin:position]
            if part.strip():
                yield begin, part
            begin = position + 1


def _expectation(text: str, line: int, about: int | None) -> Expectation:
    value = _VALUE.fullmatch(text)
    if value is not None:
        item = value["item"] or ""
        at_end = value["at"] is None or value["at"].lower() == "end"
        return Expectation(
            line,
            text,
            "value",
            None,
            value["name"],
            float(value["value"] or _TRUTH.get(item.upper(), 0.0)),
            item="" if item.upper() in _TRUTH else item,
            within=float(value["within"] or TOLERANCE),
            at=() if at_end else (read_time(value["at"]),),
        )
    near = _NEAR.fullmatch(text)
    if near is not None:
        within, unit, file = float(near["within"]), near["unit"] or "", near["file"].strip()
        name = near["name"]
        return Expectation(line, text, "log", None, name, within=within, unit=unit, file=file)
    match = _WHEN.search(text)
    head = text if match is None else text[: match.start()]
    kind, name, number, about = _subject(head.strip(), about)
    if match is None:
        return Expectation(line, text, kind, about, name, number)
    at = tuple(read_time(time) for time in (match["at"] or "").split(",") if time.strip())
    count = int(match["count"]) if match["count"] else 1 if match["once"] else None
    return Expectation(
        line,
        text,
        kind,
        about,
        name,
        number,
        at=at,
        before=None if match["before"] is None else read_time(match["before"]),
        after=None if match["after"] is None else read_time(match["after"]),
        count=0 if match["never"] else count,
    )


def _subject(text: str, about: int | None) -> tuple[Kind, str, float, int | None]:
    """Return the subject of an expectation: kind, name or text, number, line that it is about."""
    if match := _FIRED.fullmatch(text):
        return "fired", match["cycle"] or "", 0.0, int(match["line"] or 0) or about
    if _FUNCTION.fullmatch(text):
        return "function", text.upper(), 0.0, about
    if match := _MESSAGE.fullmatch(text):
        return "message", match["text"], 0.0, about
    if match := _ERROR.fullmatch(text):
        return "error", match["severity"].lower(), float(match["number"]), about
    if text.lower() == "ended":
        return "ended", "", 0.0, None
    raise _NotUnderstoodError


def _give(script: Script, text: str, position: Place) -> None:
    """Add an input of the run to the script."""
    named: tuple[GivenKind, str] | None = None
    if match := _FILE.fullmatch(text):
        path = match["path"].strip()
        if match["what"].lower() == "plc":
            named = "plc", path
            script.plcs.append(path)
        else:
            named = "machine", path
            _refuse_second(script.machine, "machine")
            script.machine = path
    elif match := _CHANNEL.fullmatch(text):
        path = match["path"].strip()
        named = "channel", path
        script.channels.setdefault(int(match["number"]), []).append(path)
    elif match := _UNTIL.fullmatch(text):
        _refuse_second(script.until, "until")
        script.until = read_time(match["time"])
    elif "=" not in text and (given := _option(text)) is not None:
        for name in given:
            _refuse_second(script.options.get(name), BY_NAME[name].comment_name)
        script.options = merged(script.options, given)
    elif match := _GIVEN_AT.fullmatch(text):
        name, value = parse_assignment(match["assignment"])
        named = "value", name
        script.stimuli.append(Stimulus(match["time"], name, value))
    elif "=" in text:
        name, value = parse_assignment(text)
        named = "value", name
        _refuse_second(script.assignments.get(name), name)
        script.assignments[name] = value
    else:
        raise _NotUnderstoodError
    if named is not None:
        script.givens.append(Given(*named, position))


def _refuse_second(first: object, name: str) -> None:
    """Raise ``Failure`` if an input that counts once has been given before (902953)."""
    if first is not None:
        raise Failure(diagnostic(OPTION_REPEATED, option=f"given: {name}"))


def _option(text: str) -> RunKeywords | None:
    """Return the run option in a comment, ``None`` for another text."""
    for option, pattern in _OPTIONS:
        match = pattern.fullmatch(text)
        if match is None or (match["words"] is None) != isinstance(option.kind, Flag):
            continue
        words: Any = match["words"] or True
        if isinstance(option.kind, Whole):
            if not words.isdecimal():
                return None
            words = int(words)
        value = option.kind.from_words(words)
        option.kind.check(option.name, value)
        return cast("RunKeywords", {option.name: value})
    return None
