# SPDX-License-Identifier: MIT
"""``#KIN ID``, ``#TRAFO``, ``#RTCP``, ``#TLC``, ``#PTP``, ``#ORI MODE``, ``#TOOL ORI CS`` (MO-8).

In: the tree of a command. Out: a ``TransformationCommand``, and diagnostics for any other form.
Shared by checker and decoder.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.base.dataclass import dataclass
from nctakt.messages.checked_blocks import INVALID_COMMAND_FORM
from nctakt.messages.motion import COMMAND_WORD_NOT_SIMULATED
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.tree import Bracket, Expression, HashCommand, Keyword, Name, Number
from nctakt.nc.vocabulary.commands import forms_of
from nctakt.nc.vocabulary.orientation import ANGLE, VECTOR

Item = Keyword | Expression

#: Commands with the largest number of values in their bracket; those with 0 have none.
COMMANDS = {
    "KIN ID": 2,
    "TRAFO": 2,
    "TRAFO ON": 0,
    "TRAFO OFF": 0,
    "RTCP ON": 0,
    "RTCP OFF": 0,
    "TLC ON": 1,
    "TLC OFF": 0,
    "PTP ON": 0,
    "PTP OFF": 0,
    "ORI MODE": 1,
    "TOOL ORI CS": 0,
}

#: Words in brackets, for the IDs of steps or alone.
_WORDS = {
    "KIN ID": ("NONE", "DEFAULT"),
    "TRAFO": ("NONE", "DEFAULT", "ON", "OFF"),
    "ORI MODE": (ANGLE, VECTOR),
}

#: Modes of ``#ORI MODE`` that belong to robots with six axes (P-CHAN-00177).
_OF_SIX_AXES = ("VECTOR_ABC", "VECTOR_IJK")

#: Commands whose bracket may be missing.
_BARE = ("KIN ID", "TLC ON")


@dataclass(frozen=True, slots=True)
class TransformationCommand:
    """One of these commands; ``values``: in its bracket, IDs, lengths, or words of a step."""

    name: str
    values: tuple[Expression | str, ...] = ()

    @property
    def shown(self) -> str:
        """The command as it is written."""
        return f"#{self.name}"


def transformation_command(command: HashCommand) -> TransformationCommand | None:
    """Return the parsed command; ``None`` if its form is unknown."""
    name = " ".join(word.name for word in command.words)
    highest = COMMANDS.get(name)
    if highest is None or len(command.arguments) > 1:
        return None
    if not command.arguments:
        return TransformationCommand(name) if highest == 0 or name in _BARE else None
    (bracket,) = command.arguments
    if not isinstance(bracket, Bracket):
        return None
    items = _with_whole_words(bracket.items)
    if not 0 < len(items) <= highest:
        return None
    values: list[Expression | str] = []
    for item in items:
        is_word = isinstance(item, Name) or (isinstance(item, Keyword) and item.value is None)
        if is_word:
            assert isinstance(item, Name | Keyword)
            if item.name not in _WORDS.get(name, ()):
                return None
            values.append(item.name)
        elif isinstance(item, Expression) and name != "ORI MODE":
            values.append(item)
        else:
            return None
    return TransformationCommand(name, tuple(values))


def _with_whole_words(items: Sequence[Item]) -> Sequence[Item]:
    """Return items with ``VECTOR_2DOF`` as one word, which reads as ``VECTOR_=2`` and ``DOF``."""
    match items:
        case [Keyword(name="VECTOR_", value=Number(value=2.0)), Keyword(name="DOF", value=None)]:
            return [Keyword(items[0].span, VECTOR)]
    return items


def check_transformation(command: HashCommand, values: ValueChecker, findings: Findings) -> bool:
    """Check the command; return false for another command."""
    words = [word.name for word in command.words]
    if " ".join(words) not in COMMANDS:
        return False
    parsed = transformation_command(command)
    if parsed is None:
        name = "#" + " ".join(words)
        written = findings.written(command.span).upper()
        other = next((word for word in _OF_SIX_AXES if word in written), "")
        if words == ["ORI", "MODE"] and other:
            names = f"{ANGLE}, {VECTOR}"
            findings.report(
                COMMAND_WORD_NOT_SIMULATED, command.span, command=name, word=other, names=names
            )
            return True
        forms = forms_of(name, f"#{words[0]}")
        findings.report(INVALID_COMMAND_FORM, command.span, command=name, forms=forms)
        return True
    for value in parsed.values:
        if isinstance(value, Expression):
            values.value(value)
    return True
