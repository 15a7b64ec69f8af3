# SPDX-License-Identifier: MIT
"""Meaning of commands for coordinates: ``#CS``, ``#MCS``, ``#FACE``, ``#TRAFO`` and their kin.

In: ``#`` commands of the tree. Out: their content as records, ``None`` for another form.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.base.dataclass import dataclass
from nctakt.nc.tree import Bracket, Expression, HashCommand, Keyword, Name, Number
from nctakt.nc.vocabulary.orientation import ANGLE, VECTOR

#: Maximum number of components: a shift along three axes, three angles.
MAX_COMPONENTS = 6

#: Commands of each kind of system, and those of ``#CS`` only.
COMMON_ACTIONS = ("DEF", "DEF ACT", "ON", "OFF", "OFF ALL")

SYSTEM_ACTIONS = {
    "CS": (*COMMON_ACTIONS, "ADD", "SELECT", "MODE ON", "MODE OFF"),
    "ACS": COMMON_ACTIONS,
    "BCS": COMMON_ACTIONS,
    "ECS": ("ON", "OFF"),
}

#: Switches of ``#CS MODE`` (P-CHAN-00393, P-CHAN-00397).
FIXED_ROTATION, OWN_OFFSETS = "ROTATION_MODE_FIXED", "AXES_OFFSETS_LAYER_SPECIFIC"

SYSTEM_MODES = (FIXED_ROTATION, OWN_OFFSETS)

MACHINE_SYSTEM, INTERMEDIATE_SYSTEM = "MCS", "IMCS"


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
    if action not in SYSTEM_ACTIONS.get(kind, ()) or (kind == "ECS" and command.arguments):
        return None
    name = ""
    arguments = list(command.arguments)
    if action.startswith("MODE"):
        name = _system_mode(arguments)
        return CsCommand(kind, action, name=name) if name else None
    if action in ("ADD", "SELECT"):
        name = _system_name(arguments.pop(0)) if arguments else ""
        if not name or (action == "SELECT") != (not arguments):
            return None
    elif action == "ON" and arguments:
        name = _system_name(arguments[0])
        if name:
            return CsCommand(kind, action, name=name) if len(arguments) == 1 else None
    brackets = _system_values(arguments)
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


def _system_values(
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


def _system_mode(arguments: Sequence[Bracket | Keyword | Expression]) -> str:
    """Return the word of ``#CS MODE``; empty for anything but a known one, or one with a value."""
    if len(arguments) != 1 or not isinstance(arguments[0], Bracket):
        return ""
    items = arguments[0].items
    if len(items) != 1 or not isinstance(items[0], Keyword):
        return ""
    is_known = items[0].name in SYSTEM_MODES
    return "" if is_known and items[0].value is not None else items[0].name


def _system_name(argument: Bracket | Keyword | Expression) -> str:
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


CONVERSIONS = ("WCS TO MCS", "MCS TO WCS")

MACHINE_COMMANDS = ("MCS ON", "MCS OFF", *CONVERSIONS)


@dataclass(frozen=True, slots=True)
class MachineCommand:
    """One of these commands.

    ``is_without_tools``: ``EX TOOL``. ``system``: the number of a stored coordinate system between
    both positions; ``has_kinematic``: so is the selected kinematic.
    """

    name: str
    is_without_tools: bool = False
    system: Expression | None = None
    has_kinematic: bool = False

    @property
    def shown(self) -> str:
        """The command as written."""
        return f"#{self.name}"


def machine_command(command: HashCommand) -> MachineCommand | None:
    """Return the parsed command; ``None`` if its form is unknown."""
    name = " ".join(word.name for word in command.words)
    items: list[Expression | Keyword] = []
    for argument in command.arguments:
        if not isinstance(argument, Bracket) or not argument.items:
            return None
        items += argument.items
    if name == "MCS ON":
        words = [item.name for item in items if isinstance(item, Keyword) and item.value is None]
        is_known = not items or (len(words) == len(items) and words == ["EX", "TOOL"])
        return MachineCommand(name, bool(items)) if is_known else None
    if name not in CONVERSIONS:
        return MachineCommand(name) if name == "MCS OFF" and not items else None
    system: Expression | None = None
    first = items[0] if items else None
    if isinstance(first, Keyword) and first.name == "CS":
        system = first.value
        del items[0]
        value = items[0] if items else None
        if system is None and isinstance(value, Expression):
            system = value
            del items[0]
        if system is None:
            return None
    has_kinematic = bool(items)
    if has_kinematic:
        last = items.pop(0)
        is_word = isinstance(last, Keyword) and last.value is None and last.name == "KIN"
        if items or not is_word:
            return None
    return MachineCommand(name, False, system, has_kinematic)


#: Commands with the number of axes in their bracket.
PLANE_COMMANDS = {"FACE": 2, "FACE OFF": 0, "CYL": 3, "CYL OFF": 0}


@dataclass(frozen=True, slots=True)
class PlaneCommand:
    """One of these commands; ``axes``: names; ``radius``: comes after the third name of #CYL."""

    name: str
    axes: tuple[str, ...] = ()
    radius: Expression | None = None

    @property
    def shown(self) -> str:
        """The command as written."""
        return f"#{self.name}"


def plane_command(command: HashCommand) -> PlaneCommand | None:
    """Return the parsed command; ``None`` if its form is unknown."""
    name = " ".join(word.name for word in command.words)
    count = PLANE_COMMANDS[name]
    if count == 0:
        return None if command.arguments else PlaneCommand(name)
    if len(command.arguments) != 1 or not isinstance(command.arguments[0], Bracket):
        return None
    items = command.arguments[0].items
    if len(items) != count:
        return None
    axes: list[str] = []
    radius: Expression | None = None
    for index, item in enumerate(items):
        value = item.value if isinstance(item, Keyword) else None
        if not isinstance(item, Name | Keyword) or (value is None) == (index == 2):
            return None
        axes.append(item.name)
        radius = value
    return PlaneCommand(name, tuple(axes), radius)


TransformationItem = Keyword | Expression

#: Commands with the largest number of values in their bracket; those with 0 have none.
TRANSFORMATION_COMMANDS = {
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
_TRANSFORMATION_WORDS = {
    "KIN ID": ("NONE", "DEFAULT"),
    "TRAFO": ("NONE", "DEFAULT", "ON", "OFF"),
    "ORI MODE": (ANGLE, VECTOR),
}

#: Commands whose bracket may be missing.
_BARE_TRANSFORMATIONS = ("KIN ID", "TLC ON")


@dataclass(frozen=True, slots=True)
class TransformationCommand:
    """One of these commands; ``values``: in its bracket, IDs, lengths, or words of a step."""

    name: str
    values: tuple[Expression | str, ...] = ()

    @property
    def shown(self) -> str:
        """The command as written."""
        return f"#{self.name}"


def transformation_command(command: HashCommand) -> TransformationCommand | None:
    """Return the parsed command; ``None`` if its form is unknown."""
    name = " ".join(word.name for word in command.words)
    highest = TRANSFORMATION_COMMANDS.get(name)
    if highest is None or len(command.arguments) > 1:
        return None
    if not command.arguments:
        return (
            TransformationCommand(name) if highest == 0 or name in _BARE_TRANSFORMATIONS else None
        )
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
            if item.name not in _TRANSFORMATION_WORDS.get(name, ()):
                return None
            values.append(item.name)
        elif isinstance(item, Expression) and name != "ORI MODE":
            values.append(item)
        else:
            return None
    return TransformationCommand(name, tuple(values))


def _with_whole_words(items: Sequence[TransformationItem]) -> Sequence[TransformationItem]:
    """Return items with ``VECTOR_2DOF`` as one word, which reads as ``VECTOR_=2`` and ``DOF``."""
    match items:
        case [Keyword(name="VECTOR_", value=Number(value=2.0)), Keyword(name="DOF", value=None)]:
            return [Keyword(items[0].span, VECTOR)]
    return items
