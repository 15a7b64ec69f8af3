# SPDX-License-Identifier: MIT
"""The forms of ``#`` commands of the main program.

In: ``#TIMER``, ``#FILENAME``, ``#FGROUP``, ``#OPTIONAL EXECUTION`` and others. Out: diagnostics. A
command without arguments needs no check here: the only form in its row of ``commands.tsv`` is its
name.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nctakt.base.diagnostics import Text
from nctakt.base.misspelling import nearest_first
from nctakt.messages.path.backward import OPTIONAL_PART_SWITCHED_TWICE, OPTIONAL_PART_WORDS
from nctakt.messages.path.motion import COMMAND_WORD_NOT_SIMULATED
from nctakt.messages.programs.checked_blocks import INVALID_COMMAND_FORM, UNKNOWN_COMMAND_OPTION
from nctakt.messages.programs.single_steps import NEGATIVE_RESOLUTION, SINGLE_STEP_WORDS
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.check.path.path_commands import check_item, check_repetition
from nctakt.nc.meaning.path import FEED_GROUP_RADIUS, FEED_GROUP_WEAKEST, Form, keywords
from nctakt.nc.meaning.words import SINGLE_STEP_OFF
from nctakt.nc.tree import Bracket, Expression, HashCommand, Keyword, Name, Number, Timer
from nctakt.nc.vocabulary.commands import INIT, forms_of
from nctakt.nc.vocabulary.file_names import (
    MESSAGES,
    NAMED_FILES,
    is_file_name,
    named_files,
    names_program,
)

_SINGLE_STEP = "#SINGLE STEP"
_RESOLUTION = "RESOLUTION"
_SINGLE_STEP_FORM = Form((SINGLE_STEP_OFF, "ENABLE"), (_RESOLUTION,))
_TIMER_ACTIONS = ("START", "STOP", "READ", "CLEAR")
_POSITIONS = ("CMDPOS", "ACTPOS")


NAME = "#OPTIONAL EXECUTION"
SWITCHES = ("ON", "OFF", "CLEAR")
_FORM = Form(("SIMULATE", "APPROACH"), ("MASK",))
_NOT_BEHIND = Text(
    "backward motion ends after such a part, and does not leave it out",
    "die Rückwärtsfahrt endet nach einem solchen Teil und lässt ihn nicht aus",
)
_NEVER_LEFT_OUT = Text(
    "the part is always executed, for no motion is simulated",
    "der Teil wird immer ausgeführt, denn keine Bewegung wird simuliert",
)


_ROTARY = Form(numbers=("REF",))
_FACTORS = Text(
    "F is the speed of the path, whose length includes the distance of each axis times its factor",
    "F ist die Geschwindigkeit der Bahn, in deren Länge jeder Achsweg mal seinem Faktor eingeht",
)
_WEAKEST = Text(
    "F is the speed of the axis whose distance takes the longest at its highest speed "
    "(P-AXIS-00212)",
    "F ist die Geschwindigkeit der Achse, deren Weg mit ihrer Höchstgeschwindigkeit am längsten "
    "dauert",
)


class CommandChecker:
    """Checks the commands of one program; ``axes``: the names of the channel's axes."""

    def __init__(self, values: ValueChecker, axes: Sequence[str], findings: Findings) -> None:
        self._values = values
        self._axes = axes
        self._findings = findings

    def timer(self, timer: Timer) -> None:
        """Check ``#TIMER START|STOP|READ|CLEAR [SYN] [ID=…]``."""
        if timer.action not in _TIMER_ACTIONS:
            self._option("#TIMER", timer.action, _TIMER_ACTIONS, timer)
        for option in timer.options:
            if option.name != "SYN":
                self._option("#TIMER", option.text, ("SYN",), option)
        for item in timer.keywords:
            if isinstance(item, Keyword) and item.name == "ID" and item.value is not None:
                self._values.block(item.value)
            else:
                self._option("#TIMER", self._findings.written(item.span), ("ID",), item)

    def command(self, command: HashCommand, words: Sequence[str]) -> bool:
        """Check one of these commands; return false for any other."""
        if is_file_name(words):
            self._file(command)
        elif tuple(words) == INIT:
            self._channel(command)
        elif check_feed_group(command, self._axes, self._values, self._findings):
            return True
        elif tuple(words) == ("SINGLE", "STEP"):
            check_single_step(command, self._values, self._findings)
        elif words[:2] == ["OPTIONAL", "EXECUTION"]:
            check_optional(command, self._values, self._findings)
        else:
            return False
        return True

    def _file(self, command: HashCommand) -> None:
        """Check ``#FILENAME [MSG=file G80="file"]``."""
        for key, file, item in named_files(self._items(command, "#FILENAME")):
            is_known = key == MESSAGES or names_program(key)
            if not is_known or file is None:
                self._option("#FILENAME", self._findings.written(item.span), NAMED_FILES, item)
                continue
            if key != MESSAGES:
                self._findings.named_programs.add(key)
            if not isinstance(file, Name):
                self._values.text(file)

    def _channel(self, command: HashCommand) -> None:
        """Check ``#CHANNEL INIT [CMDPOS AX=X]``, also without brackets."""
        if not command.arguments:
            return
        items = self._items(command, "#CHANNEL INIT")
        form = Form(_POSITIONS, ("AXNR",), {"AX": tuple(self._axes)})
        for item in items:
            check_item(form, "#CHANNEL INIT", item, self._values, self._findings)
        names = {item.name for item in items if isinstance(item, Keyword)}
        if not names.isdisjoint(("AX", "AXNR")) and names.isdisjoint(_POSITIONS):
            forms = forms_of("#CHANNEL INIT")
            self._findings.report(
                INVALID_COMMAND_FORM, command.span, command="#CHANNEL INIT", forms=forms
            )

    def _items(self, command: HashCommand, name: str) -> tuple[Keyword | Expression, ...]:
        """Return the items of the command's only bracket; report any other form."""
        if len(command.arguments) == 1 and isinstance(command.arguments[0], Bracket):
            return command.arguments[0].items
        self._findings.report(
            INVALID_COMMAND_FORM, command.span, command=name, forms=forms_of(name)
        )
        return ()

    def _option(
        self, command: str, word: str, names: Sequence[str], node: Timer | Keyword | Expression
    ) -> None:
        listed = ", ".join(nearest_first(word, names))
        self._findings.report(
            UNKNOWN_COMMAND_OPTION, node.span, command=command, word=word, names=listed
        )


def check_single_step(command: HashCommand, values: ValueChecker, findings: Findings) -> None:
    """Check ``#SINGLE STEP [DISABLE]``, ``[ENABLE]``, ``[RESOLUTION=10]`` (207618443)."""
    bracket = command.arguments[0] if len(command.arguments) == 1 else None
    if not isinstance(bracket, Bracket) or not bracket.items:
        forms = forms_of(_SINGLE_STEP)
        findings.report(INVALID_COMMAND_FORM, command.span, command=_SINGLE_STEP, forms=forms)
        return
    if len(bracket.items) > 1:
        findings.report(SINGLE_STEP_WORDS, bracket.items[1].span)
        return
    check_item(_SINGLE_STEP_FORM, _SINGLE_STEP, bracket.items[0], values, findings)
    for item in keywords(command):
        value = item.value
        if item.name == _RESOLUTION and isinstance(value, Number) and value.value < 0.0:
            findings.report(NEGATIVE_RESOLUTION, value.span, value=value.value)


def check_optional(command: HashCommand, values: ValueChecker, findings: Findings) -> None:
    """Check ``#OPTIONAL EXECUTION ON [SIMULATE]``."""
    switches = [word.name for word in command.words[2:]]
    bracket = command.arguments[0] if command.arguments else None
    if len(switches) > 1 and set(switches) <= set(SWITCHES):
        findings.report(OPTIONAL_PART_SWITCHED_TWICE, command.words[3].span)
        return
    is_known = len(switches) == 1 and switches[0] in SWITCHES
    if not is_known or len(command.arguments) > 1 or not isinstance(bracket, Bracket | None):
        forms = forms_of(NAME)
        findings.report(INVALID_COMMAND_FORM, command.span, command=NAME, forms=forms)
        return
    for item in bracket.items if bracket is not None else ():
        check_item(_FORM, NAME, item, values, findings)
    given = {item.name: item for item in keywords(command)}
    approach = given.get("APPROACH")
    if approach is not None and "SIMULATE" in given:
        findings.report(OPTIONAL_PART_WORDS, approach.span)
    elif approach is not None:
        findings.report(
            COMMAND_WORD_NOT_SIMULATED,
            approach.span,
            command=NAME,
            word="APPROACH",
            names="SIMULATE, MASK",
        )
    if "SIMULATE" in given:
        findings.report_simplified(f"{NAME} [SIMULATE]", _NEVER_LEFT_OUT, command.span)
    elif switches == ["ON"]:
        findings.report_simplified(NAME, _NOT_BEHIND, command.span)


def check_feed_group(
    command: HashCommand, axes: Sequence[str], values: ValueChecker, findings: Findings
) -> bool:
    """Check ``#FGROUP``; ``axes``: those of the channel. Return false for another command."""
    words = [word.name for word in command.words]
    if words[0] != "FGROUP":
        return False
    arguments = command.arguments
    bracket = arguments[0] if len(arguments) == 1 else None
    items = bracket.items if isinstance(bracket, Bracket) else ()
    is_right = bool(items) or not arguments
    if words == ["FGROUP", FEED_GROUP_WEAKEST]:
        is_right = not arguments
        findings.report_simplified(f"#FGROUP {FEED_GROUP_WEAKEST}", _WEAKEST, command.span)
    elif words == ["FGROUP", FEED_GROUP_RADIUS]:
        names = {item.name for item in items if isinstance(item, Keyword)}
        is_right = not arguments or {"AX", "REF"} <= names
    elif words != ["FGROUP"]:
        is_right = False
    if not is_right:
        name = "#" + " ".join(words[:2])
        forms = forms_of(name)
        findings.report(INVALID_COMMAND_FORM, command.span, command=name, forms=forms)
        return True
    form = Form(tuple(axes), defaults=tuple(axes))
    if words == ["FGROUP", FEED_GROUP_RADIUS]:
        form = replace(_ROTARY, names={"AX": tuple(axes)})
    for item in items:
        axis = _named_axis(item, is_radius=words[-1] == FEED_GROUP_RADIUS)
        if axis is not None and axis.name not in axes:
            findings.report(
                UNKNOWN_COMMAND_OPTION,
                axis.span,
                command="#" + " ".join(words),
                word=axis.name,
                names=", ".join(axes),
            )
            continue
        keyword = Keyword(item.span, item.name, None) if isinstance(item, Name) else item
        check_item(form, "#" + " ".join(words), keyword, values, findings)
        if words == ["FGROUP"] and isinstance(item, Keyword) and item.value is not None:
            findings.report_simplified("#FGROUP [X=2]", _FACTORS, item.span)
    check_repetition(" ".join(words), keywords(command), findings)
    return True


def _named_axis(item: Keyword | Expression, *, is_radius: bool) -> Keyword | Name | None:
    """Return the part of an item that names an axis; ``is_radius``: of ``#FGROUP ROT``."""
    if is_radius and isinstance(item, Keyword):
        return item.value if item.name == "AX" and isinstance(item.value, Name) else None
    return item if isinstance(item, Keyword | Name) else None
