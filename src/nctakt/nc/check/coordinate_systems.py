# SPDX-License-Identifier: MIT
"""``#CS``, ``#ACS``, ``#BCS``, ``#ECS``: the coordinate systems of a program (MO-8).

In: the tree of a command. Out: a ``CsCommand``, and diagnostics for anything other than ``#CS
DEF|ON [id] [v1, v2, v3, a1, a2, a3]``, ``#CS ON``, ``#CS OFF``, ``#CS OFF ALL``, ``#CS DEF ACT
[id]``, the same with ``#ACS`` and ``#BCS``, ``#CS ADD [name] [v1 … a3]``, ``#CS SELECT [name]``,
``#CS MODE ON|OFF [keyword]``, ``#ECS ON|OFF``. A single value in brackets is the ID, a single word
that of a system of the channel list. Shared by checker and decoder.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.messages.checked_blocks import INVALID_COMMAND_FORM
from nctakt.messages.coordinate_systems import INVALID_COORDINATE_SYSTEM_NAME
from nctakt.messages.motion import COMMAND_WORD_NOT_SIMULATED
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.tree import Bracket, Expression, HashCommand, Keyword, Name, Number
from nctakt.nc.vocabulary.commands import forms_of

#: Maximum number of components: a shift along three axes, three angles.
MAX_COMPONENTS = 6

#: What each kind of system has, and what only those of ``#CS`` have.
COMMON_ACTIONS = ("DEF", "DEF ACT", "ON", "OFF", "OFF ALL")
ACTIONS = {
    "CS": (*COMMON_ACTIONS, "ADD", "SELECT", "MODE ON", "MODE OFF"),
    "ACS": COMMON_ACTIONS,
    "BCS": COMMON_ACTIONS,
    "ECS": ("ON", "OFF"),
}

#: What ``#CS MODE`` switches (P-CHAN-00393, P-CHAN-00397).
FIXED_ROTATION, OWN_OFFSETS = "ROTATION_MODE_FIXED", "AXES_OFFSETS_LAYER_SPECIFIC"
MODES = (FIXED_ROTATION, OWN_OFFSETS)

#: Maximum length of a system's name, and the names reserved for kinematics.
MAX_CHARACTERS = 8
MACHINE_SYSTEM, INTERMEDIATE_SYSTEM = "MCS", "IMCS"
RESERVED = ("ACS", INTERMEDIATE_SYSTEM, MACHINE_SYSTEM)

_MEANING_OF_MCS = Text(
    "no system of the stack is active, offsets and the transformation stay",
    "kein System des Stapels ist aktiv, Verschiebungen und Transformation bleiben",
)


@dataclass(frozen=True, slots=True)
class CsCommand:
    """A command; ``components``: ``None`` for a stored system, the last one without an ID.

    ``kind``: CS, ACS, BCS or ECS. ``name``: that of ADD and SELECT, of one of the channel list, the
    word of MODE.
    """

    kind: str
    action: str
    identity: Expression | None = None
    components: tuple[Expression, ...] | None = None
    name: str = ""

    @property
    def shown(self) -> str:
        """The command as programs write it."""
        return f"#{self.kind} {self.action}"


def cs_command(command: HashCommand) -> CsCommand | None:
    """Return the parsed command; ``None`` if its form is unknown."""
    kind, *words = (word.name for word in command.words)
    action = " ".join(words)
    if action not in ACTIONS.get(kind, ()) or (kind == "ECS" and command.arguments):
        return None
    name = ""
    arguments = list(command.arguments)
    if action.startswith("MODE"):
        name = _mode(arguments)
        return CsCommand(kind, action, name=name) if name else None
    if action in ("ADD", "SELECT"):
        name = _name(arguments.pop(0)) if arguments else ""
        if not name or (action == "SELECT") != (not arguments):
            return None
    elif action == "ON" and arguments:
        name = _name(arguments[0])
        if name:
            return CsCommand(kind, action, name=name) if len(arguments) == 1 else None
    brackets = _values(arguments)
    if brackets is None:
        return None
    if name:
        return CsCommand(kind, action, None, brackets[0] if brackets else None, name)
    if action.startswith("OFF"):
        return CsCommand(kind, action) if not brackets else None
    identity = None
    if brackets and len(brackets[0]) == 1:
        identity = brackets.pop(0)[0]
    if len(brackets) > 1 or (action == "DEF" and not brackets):
        return None
    if action == "DEF ACT" and brackets:
        return None
    return CsCommand(kind, action, identity, brackets[0] if brackets else None)


def _values(
    arguments: Sequence[Bracket | Keyword | Expression],
) -> list[tuple[Expression, ...]] | None:
    """Return the values in each of several brackets; ``None`` if there is something else."""
    brackets: list[tuple[Expression, ...]] = []
    for argument in arguments:
        if not isinstance(argument, Bracket):
            return None
        values = tuple(item for item in argument.items if isinstance(item, Expression))
        is_word = any(isinstance(value, Name) for value in values)
        if is_word or len(values) != len(argument.items) or not 0 < len(values) <= MAX_COMPONENTS:
            return None
        brackets.append(values)
    return brackets


def _mode(arguments: Sequence[Bracket | Keyword | Expression]) -> str:
    """Return the word of ``#CS MODE``; empty for anything but a known one, or one with a value."""
    if len(arguments) != 1 or not isinstance(arguments[0], Bracket):
        return ""
    items = arguments[0].items
    if len(items) != 1 or not isinstance(items[0], Keyword):
        return ""
    is_known = items[0].name in MODES
    return "" if is_known and items[0].value is not None else items[0].name


def _name(argument: Bracket | Keyword | Expression) -> str:
    """Return the name in brackets, in upper case; empty if there is none."""
    if not isinstance(argument, Bracket) or len(argument.items) != 1:
        return ""
    (item,) = argument.items
    if isinstance(item, Name):
        return item.name
    if not isinstance(item, Keyword) or item.arguments:
        return ""
    if item.value is None:
        return item.name
    # ``W2`` reads as a keyword with a value, which ``W=2`` is.
    number = item.value
    is_one_word = number.span.column == item.span.column + len(item.name)
    if not isinstance(number, Number) or not is_one_word:
        return ""
    return f"{item.name}{number.value:.0f}"


def check_cs_command(command: HashCommand, values: ValueChecker, findings: Findings) -> bool:
    """Check the command; return false for another command."""
    kind, *words = (word.name for word in command.words)
    if kind not in ACTIONS or " ".join(words) not in ("", *ACTIONS[kind]):
        return False
    parsed = cs_command(command)
    if parsed is None:
        name = " ".join(["#" + kind, *words])
        forms = forms_of(name, "#" + kind)
        findings.report(INVALID_COMMAND_FORM, command.span, command=name, forms=forms)
        return True
    if parsed.action.startswith("MODE"):
        if parsed.name not in MODES:
            findings.report(
                COMMAND_WORD_NOT_SIMULATED,
                command.span,
                command=parsed.shown,
                word=parsed.name,
                names=", ".join(MODES),
            )
    elif parsed.action in ("ADD", "SELECT"):
        _check_name(parsed, command, findings)
    for value in (parsed.identity, *(parsed.components or ())):
        if value is not None:
            values.value(value)
    return True


def _check_name(parsed: CsCommand, command: HashCommand, findings: Findings) -> None:
    """Check the name of a system of the stack."""
    if parsed.action == "SELECT" and parsed.name == INTERMEDIATE_SYSTEM:
        findings.report(
            COMMAND_WORD_NOT_SIMULATED,
            command.span,
            command="#CS SELECT",
            word=INTERMEDIATE_SYSTEM,
            names=MACHINE_SYSTEM,
        )
    elif parsed.action == "SELECT" and parsed.name == MACHINE_SYSTEM:
        findings.report_simplified("#CS SELECT [MCS]", _MEANING_OF_MCS, command.span)
    elif len(parsed.name) > MAX_CHARACTERS or parsed.name in RESERVED:
        maximum = MAX_CHARACTERS
        findings.report(
            INVALID_COORDINATE_SYSTEM_NAME, command.span, name=parsed.name, maximum=maximum
        )
