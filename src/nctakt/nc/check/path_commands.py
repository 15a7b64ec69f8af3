# SPDX-License-Identifier: MIT
"""Settings of the path: ``#CONTOUR MODE``, ``#SLOPE``, overrides (MO-2, MO-3, MO-5).

Only simulated words and keywords are allowed; any other one is refused by name, because it would
change positions or times.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import NOTHING, Span
from nctakt.base.text import nearest
from nctakt.messages.checked_blocks import INVALID_COMMAND_FORM, WORD_VALUE_MISSING
from nctakt.messages.motion import (
    COMMAND_WORD_NOT_SIMULATED,
    INVALID_CONTOUR_DEVIATION,
    UNKNOWN_COMMAND_KEYWORD,
)
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.tree import (
    Bracket,
    BracketCommand,
    Expression,
    HashCommand,
    Keyword,
    Name,
    Number,
)
from nctakt.nc.vocabulary.command_forms import forms_of

#: Bounds of programmed overrides, %, and their keywords: of feed blocks, of rapid ones.
OVERRIDE_MIN_PCT, OVERRIDE_MAX_PCT = 0.1, 200.0
OVERRIDE_FACTORS = ("FEED_FACT", "RAPID_FACT")
#: Keywords of ``#TURN``.
TURN_KEYWORDS = (
    "ROT_FEED_CPL",
    "TIME_IN_REV_CPL",
    "TAPPING_ACT_POS",
    "TAPPING_N_CYCLES",
    "THREAD_CUT_ACT_SPEED",
    "THREAD_CUT_N_CYCLES",
    "THREAD_CUT_IGNORE_OV",
    "THREAD_CHAIN",
)


@dataclass(frozen=True, slots=True)
class Form:
    """The form of a command: words in brackets, keywords with a number, keywords with a word."""

    words: tuple[str, ...] = ()
    numbers: tuple[str, ...] = ()
    names: dict[str, tuple[str, ...]] = field(default_factory=dict)
    needs_bracket: bool = True

    @property
    def keywords(self) -> tuple[str, ...]:
        """The items that may appear in its bracket."""
        return (*self.words, *self.numbers, *self.names)


#: The commands by their words. Contouring: the corner deviation is the only mode.
FORMS = {
    "CONTOUR MODE": Form(("DEV",), ("PATH_DEV",)),
    "CONTOUR MODE ON": Form(("DEV",), ("PATH_DEV",), needs_bracket=False),
    "CONTOUR MODE OFF": Form(needs_bracket=False),
    "SLOPE": Form(names={"TYPE": ("STEP", "TRAPEZ")}),
    "SLOPE DEFAULT": Form(needs_bracket=False),
    "OVERRIDE": Form(numbers=OVERRIDE_FACTORS),
    "TURN": Form(numbers=TURN_KEYWORDS),
}


#: ``X[OVERRIDE FEED_FACT=50]``.
_AXIS_OVERRIDE = Form(("OVERRIDE",), OVERRIDE_FACTORS)


#: ``X[FIXED_STOP ON POS_LAG_LIMIT=0.5]``; torque and window change nothing in the simulation.
_FIXED_STOP = Form(
    ("FIXED_STOP", "ON", "OFF"),
    (
        "TORQUE_LIMIT",
        "POS_LAG_LIMIT",
        "CYCLES",
        "WINDOW",
        "START",
        "END",
        "ERR_NOT_DETECTED",
    ),
)

#: Commands for one axis of the path, by their first keyword.
_AXIS_FORMS = {"OVERRIDE": _AXIS_OVERRIDE, "FIXED_STOP": _FIXED_STOP}
_AXIS_EXAMPLES = {"OVERRIDE": "FEED_FACT=50", "FIXED_STOP": "ON"}


def command_name(command: HashCommand) -> str:
    """Return the words of a command."""
    return " ".join(word.name for word in command.words)


def keywords(command: HashCommand) -> tuple[Keyword, ...]:
    """Return the keywords in the brackets of a checked command."""
    return tuple(
        item
        for argument in command.arguments
        if isinstance(argument, Bracket)
        for item in argument.items
        if isinstance(item, Keyword)
    )


def check_path_command(command: HashCommand, values: ValueChecker, findings: Findings) -> bool:
    """Check one of these commands; return false for any other."""
    name = command_name(command)
    form = FORMS.get(name)
    if form is None:
        return False
    bracket = command.arguments[0] if len(command.arguments) == 1 else None
    says_something = isinstance(bracket, Bracket) and bool(bracket.items)
    if not says_something and (form.needs_bracket or command.arguments):
        forms = forms_of(
            f"#{name.removesuffix(' ON').removesuffix(' OFF').removesuffix(' DEFAULT')}"
        )
        findings.report(INVALID_COMMAND_FORM, command.span, command=f"#{name}", forms=forms)
        return True
    for argument in command.arguments:
        assert isinstance(argument, Bracket)
        for item in argument.items:
            _check_item(form, f"#{name}", item, values, findings)
    return True


def check_path_axis(command: BracketCommand, values: ValueChecker, findings: Findings) -> bool:
    """Check ``X[OVERRIDE …]`` or ``X[FIXED_STOP …]``; return false for another command."""
    first = command.items[0] if command.items else None
    if not isinstance(first, Keyword) or first.name not in _AXIS_FORMS:
        return False
    form, name = _AXIS_FORMS[first.name], f"{command.name}[{first.name}]"
    if len(command.items) == 1 and first.value is None:
        forms = f"{command.name}[{first.name} {_AXIS_EXAMPLES[first.name]}]"
        findings.report(INVALID_COMMAND_FORM, first.span, command=name, forms=forms)
    for item in command.items:
        _check_item(form, name, item, values, findings)
    return True


def _check_item(
    form: Form, name: str, item: Keyword | Expression, values: ValueChecker, findings: Findings
) -> None:
    if not isinstance(item, Keyword):
        _refuse(name, findings.written(item.span), form.keywords, item.span, findings)
        return
    if item.name in form.words and item.value is None:
        return
    if item.value is None and item.name in (*form.numbers, *form.names):
        findings.report(WORD_VALUE_MISSING, item.span, word=item.name)
    elif item.value is not None and item.name in form.numbers:
        values.value(item.value)
        _check_number(item, findings)
    elif item.name not in form.names or not isinstance(item.value, Name):
        word = item.name if item.name not in form.keywords else findings.written(item.span)
        _refuse(name, word, form.keywords, item.span, findings)
    elif item.value.name not in form.names[item.name]:
        names = form.names[item.name]
        _refuse(f"{name} [{item.name}]", item.value.name, names, item.value.span, findings)


def _check_number(item: Keyword, findings: Findings) -> None:
    """Report a constant out of its range."""
    value = item.value
    if item.name == "PATH_DEV" and isinstance(value, Number) and value.value <= 0.0:
        findings.report(INVALID_CONTOUR_DEVIATION, value.span, value=value.value)


def _refuse(name: str, word: str, allowed: Sequence[str], span: Span, findings: Findings) -> None:
    """Report a word that is misspelt or not simulated."""
    near = nearest(word, allowed)
    names = ", ".join(allowed) or NOTHING
    if near and near != word:
        findings.report(UNKNOWN_COMMAND_KEYWORD, span, command=name, word=word, nearest=near)
    else:
        findings.report(COMMAND_WORD_NOT_SIMULATED, span, command=name, word=word, names=names)
