# SPDX-License-Identifier: MIT
"""Settings of the path: ``#CONTOUR MODE``, ``#SLOPE``, overrides (MO-2, MO-3, MO-5).

Only simulated words and keywords are allowed; any other is refused by name, because it would change
positions or times.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.base.diagnostics import NOTHING, Span
from nctakt.base.misspelling import nearest, resembles
from nctakt.messages.path.hsc import INVALID_HSC_VALUE
from nctakt.messages.path.motion import (
    COMMAND_WORD_NOT_SIMULATED,
    CONTOUR_SHARE_OUT_OF_RANGE,
    INVALID_CONTOUR_DEVIATION,
    INVALID_VECTOR_LIMIT,
    UNKNOWN_COMMAND_KEYWORD,
)
from nctakt.messages.programs.checked_blocks import (
    EXCLUSIVE_WORDS,
    INVALID_COMMAND_FORM,
    UNKNOWN_COMMAND_OPTION,
    WORD_VALUE_MISSING,
)
from nctakt.messages.programs.checked_cycles import DUPLICATE_KEYWORD
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.check.path.path_notes import check_old_slope, report_curve, report_simplified
from nctakt.nc.meaning.path import (
    CONTOURING_FORM,
    CORNER_NUMBERS,
    OVERRIDE_FACTORS,
    PATH_COMMANDS,
    Form,
    command_name,
    is_hsc_value,
    is_size,
    keywords,
)
from nctakt.nc.tree import (
    Bracket,
    BracketCommand,
    Expression,
    HashCommand,
    Keyword,
    Name,
    Number,
)
from nctakt.nc.vocabulary.commands import forms_of
from nctakt.nc.vocabulary.path_keywords import (
    ACTIONS,
    CONTOUR_MODES,
    CONTOUR_SHARES,
    HSC_CURVES,
    REFUSED_MODES,
    VECTOR_LIMITS,
)

SPINDLE_FACTOR = "SPEED_FACT"


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


def _without_switch(name: str) -> str:
    """Return a command's name without the word that switches it."""
    words = name.split()
    while words[-1] in ("ON", "OFF", "ALL", "DEFAULT"):
        words.pop()
    return " ".join(words)


def check_path_command(
    command: HashCommand, values: ValueChecker, main_axes: Sequence[str], findings: Findings
) -> bool:
    """Check one of these commands; return false for any other."""
    name = command_name(command)
    form = PATH_COMMANDS.get(name)
    if form is None:
        return False
    if form.words == CONTOURING_FORM.words:
        modes = [item.name for item in keywords(command) if item.name in CONTOUR_MODES]
        point = main_axes if modes in ([], ["POS"]) else ()
        form = Form(form.words, (*form.numbers, *point), needs_bracket=form.needs_bracket)
    bracket = command.arguments[0] if len(command.arguments) == 1 else None
    says_something = isinstance(bracket, Bracket) and bool(bracket.items)
    if name == "CORNER PARAM":
        words = {item.name for item in keywords(command)}
        says_something = says_something and words.issuperset((*CORNER_NUMBERS, "UNIT"))
    if not says_something and (form.needs_bracket or command.arguments):
        forms = forms_of(f"#{_without_switch(name)}")
        findings.report(INVALID_COMMAND_FORM, command.span, command=f"#{name}", forms=forms)
        return True
    report_curve(command, name, findings)
    for names in (CONTOUR_MODES, ACTIONS, HSC_CURVES):
        given = [item for item in keywords(command) if item.name in names]
        others = [item for item in given if item.name != given[0].name]
        if others:
            word, other = others[0].name, given[0].name
            findings.report(EXCLUSIVE_WORDS, others[0].span, word=word, other=other)
    check_repetition(name, keywords(command), findings)
    for argument in command.arguments:
        if name == "SET SLOPE PROFIL":
            check_old_slope(argument, values, findings)
            continue
        if not isinstance(argument, Bracket):
            _refuse(f"#{name}", findings.written(argument.span), (), argument.span, findings)
            continue
        for item in argument.items:
            check_item(form, f"#{name}", item, values, findings)
            if isinstance(item, Keyword):
                report_simplified(f"#{name}", item, argument.items, findings)
    return True


def check_repetition(name: str, items: Sequence[Keyword], findings: Findings) -> None:
    """Report keywords that are given twice."""
    found: set[str] = set()
    for item in items:
        if item.name in found:
            findings.report(DUPLICATE_KEYWORD, item.span, command=f"#{name}", word=item.name)
        found.add(item.name)


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
        check_item(form, name, item, values, findings)
    return True


def check_item(
    form: Form, name: str, item: Keyword | Expression, values: ValueChecker, findings: Findings
) -> None:
    """Check an item of a command's bracket against its form."""
    if not isinstance(item, Keyword):
        _refuse(name, findings.written(item.span), form.keywords, item.span, findings)
        return
    if item.name in (*form.words, *form.defaults) and item.value is None:
        return
    if item.value is None and item.name in (*form.numbers, *form.names):
        findings.report(WORD_VALUE_MISSING, item.span, word=item.name)
    elif item.value is not None and item.name in (*form.numbers, *form.defaults):
        values.value(item.value)
        _check_number(name, item, findings)
    elif item.name not in form.names or not isinstance(item.value, Name):
        word = item.name if item.name not in form.keywords else findings.written(item.span)
        _refuse(name, word, form.keywords, item.span, findings)
    elif item.value.name not in form.names[item.name]:
        names = form.names[item.name]
        _refuse(f"{name} [{item.name}]", item.value.name, names, item.value.span, findings)


def _check_number(command: str, item: Keyword, findings: Findings) -> None:
    """Report a constant out of its range."""
    value = item.value
    if item.name in VECTOR_LIMITS and isinstance(value, Number) and value.value <= 0.0:
        word = item.name
        findings.report(INVALID_VECTOR_LIMIT, value.span, word=word, value=value.value)
    if command.startswith("#HSC") and isinstance(value, Number):
        if not is_hsc_value(item.name, value.value):
            word = item.name
            findings.report(INVALID_HSC_VALUE, value.span, word=word, value=value.value)
        return
    if not command.startswith("#CONTOUR MODE"):
        return
    if item.name in CONTOUR_SHARES and isinstance(value, Number):
        highest = CONTOUR_SHARES[item.name]
        if not 0.0 <= value.value <= highest:
            word = item.name
            findings.report(
                CONTOUR_SHARE_OUT_OF_RANGE,
                value.span,
                word=word,
                value=value.value,
                highest=highest,
            )
        return
    sizes = {name for names in CONTOUR_MODES.values() for name in names}
    if not isinstance(value, Number) or item.name not in sizes:
        return
    if not any(is_size(item.name, value.value, mode) for mode in CONTOUR_MODES):
        findings.report(INVALID_CONTOUR_DEVIATION, value.span, value=value.value)


def _refuse(name: str, word: str, allowed: Sequence[str], span: Span, findings: Findings) -> None:
    """Report a word that is misspelt or not simulated."""
    names = ", ".join(allowed) or NOTHING
    is_unknown = word not in (*REFUSED_MODES, *allowed)
    near = nearest(word, allowed) if is_unknown else ""
    if near:
        findings.report(UNKNOWN_COMMAND_KEYWORD, span, command=name, word=word, nearest=near)
    elif is_unknown and resembles(word, allowed):
        findings.report(UNKNOWN_COMMAND_OPTION, span, command=name, word=word, names=names)
    else:
        findings.report(COMMAND_WORD_NOT_SIMULATED, span, command=name, word=word, names=names)
