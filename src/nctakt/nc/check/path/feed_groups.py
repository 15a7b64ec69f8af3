# SPDX-License-Identifier: MIT
"""The forms of ``#FGROUP``: axes, a radius of a rotary axis, the weakest axis.

In: the command's tree. Out: diagnostics.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nctakt.base.diagnostics import Text
from nctakt.messages.programs.checked_blocks import INVALID_COMMAND_FORM, UNKNOWN_COMMAND_OPTION
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.check.path.path_commands import check_item, check_repetition
from nctakt.nc.meaning.path import FEED_GROUP_RADIUS, FEED_GROUP_WEAKEST, Form, keywords
from nctakt.nc.tree import Bracket, Expression, HashCommand, Keyword, Name
from nctakt.nc.vocabulary.commands import forms_of

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
