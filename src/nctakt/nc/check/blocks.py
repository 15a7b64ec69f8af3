# SPDX-License-Identifier: MIT
"""The words of a program's block: which exist, which exclude each other (nc-programs, RC-403).

In: a block of the main program or a subprogram, not of a realtime cycle. Out: diagnostics. A block
without errors can be decoded: axis words of the channel with a value, at most one G function of a
group, F, M and H functions of the channel list with constant numbers.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import NOTHING, Text, number_text
from nctakt.base.misspelling import nearest
from nctakt.lists.declared.offsets import MAX_GROUPS
from nctakt.lists.machine.channel_configuration import ChannelParameters, program_parameter
from nctakt.messages.axes.spindles import NOT_A_SPINDLE_WORD
from nctakt.messages.programs.checked_axes import (
    INDP_MISSING,
    INDP_OUTSIDE_REALTIME_CYCLE,
    UNKNOWN_AXIS_COMMAND,
)
from nctakt.messages.programs.checked_blocks import (
    DUPLICATE_WORD,
    EXCLUSIVE_WORDS,
    EXTRA_PARAMETERS,
    FUNCTION_NOT_DEFINED,
    G163_WITHOUT_RADIUS,
    INVALID_FUNCTION_NUMBER,
    NO_PROGRAM_FOR_G_FUNCTION,
    UNKNOWN_WORD,
    WORD_VALUE_MISSING,
    WORD_VALUE_OUT_OF_RANGE,
)
from nctakt.messages.programs.checked_cycles import (
    COMMAND_NOT_ALLOWED_IN_CYCLE,
    FUNCTION_GIVEN_TO_AXIS_IN_CYCLE,
)
from nctakt.messages.programs.offsets import (
    COMMAND_WITHOUT_AXIS,
    G159_WITHOUT_NUMBER,
    MOTION_WORD_WITH_OFFSETS,
    UNKNOWN_OFFSET_KIND,
    UNKNOWN_ZERO_OFFSET,
)
from nctakt.messages.programs.program_structure import (
    INVALID_RETURN_OPTION,
    PROGRAM_END_IN_SUBPROGRAM,
    SUBPROGRAM_END_IN_MAIN_PROGRAM,
)
from nctakt.nc.check.axes.independent_axes import check_independent
from nctakt.nc.check.axes.spindle_commands import SpindleChecker
from nctakt.nc.check.block_rules import BlockChecker, GivenWords
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.check.path.dwells import check_dwell, dwell_of
from nctakt.nc.check.path.frames import (
    check_scale_factors,
)
from nctakt.nc.check.path.motion_words import functions_of
from nctakt.nc.check.path.path_commands import check_path_axis
from nctakt.nc.meaning.path import SWITCHES, VECTORS
from nctakt.nc.meaning.words import MAX_VALUE, MIN_VALUE
from nctakt.nc.outline import AxisUse
from nctakt.nc.tree import (
    AxisWord,
    Block,
    BlockWord,
    BracketCommand,
    Expression,
    Keyword,
    Name,
    Number,
    OffsetCommand,
    StringWord,
    Word,
)
from nctakt.nc.vocabulary import support_level
from nctakt.nc.vocabulary.entries import Entry, Support
from nctakt.nc.vocabulary.file_names import CHANGE
from nctakt.nc.vocabulary.function_rows import WITH_AXES, Form, GFunction, Group
from nctakt.nc.vocabulary.functions import (
    BLOCK_TRANSITIONS,
    GEAR_FUNCTIONS,
    HOMING,
    PROGRAM_ENDS,
    RETURN_COMMANDS,
    SUBPROGRAM_ENDS,
    TOOL_CHANGE,
)
from nctakt.nc.vocabulary.orientation import VECTOR_WORDS
from nctakt.nc.vocabulary.single_axes.axis_brackets import FORMS, form_of
from nctakt.nc.vocabulary.single_axes.axis_commands import INDP_WORDS, has_function, is_axis_command
from nctakt.nc.vocabulary.spindle_commands import split


def check_weight(word: Word, values: ValueChecker, findings: Findings) -> None:
    """Check the weight of all axes: ``G131=70``."""
    if word.additional is None or word.arguments:
        findings.report(WORD_VALUE_MISSING, word.span, word=findings.written(word.span))
    else:
        values.value(word.additional)


def is_neutral(word: Word, entry: GFunction) -> bool:
    """Return whether a G function that is not simulated changes nothing: ``G52=0``."""
    value = word.additional
    return isinstance(value, Number) and value.value == entry.neutral


#: Kinds of offsets in ``#SUPPRESS OFFSETS`` (RC-407).
OFFSETS = ("ZERO", "ADD_ZERO", "PSET", "CLAMP", "TOOL", "MEASURE", "MANUAL")
_NUMBERED = ("G", "M", "H")
#: Words of axis commands that are known and not simulated.
_AXIS_FORMS = (
    *("DIST_CTRL", "LIFT", "LIFT_START", "LIFT_END", "POLY", "COMP", "DYNAMIC", "SYNC"),
    *("CALLAX", "PUTAX"),
)


#: The program that M17 or M30 ends: the main program, a subprogram, or a file that may be either.
Role = Literal["main", "called", "either"]


@dataclass(slots=True)
class _BlockState:
    """The words of a block so far: names, G function of each group, unknown word, independent axes,
    whether a G function is computed, whether G74 homes spindles.

    A block that begins with an unknown word is usually not NC text, so one report is enough.
    """

    role: Role
    returns: bool = False
    names: dict[str, None] = field(default_factory=dict)
    groups: dict[Group, str] = field(default_factory=dict)
    unknown: bool = False
    axis_words: tuple[AxisWord, ...] = ()
    independent: set[str] = field(default_factory=set)
    words: set[str] = field(default_factory=set)
    functions: set[float] = field(default_factory=set)
    is_computed: bool = False
    homes_spindles: bool = False


#: Findings about gear changes that are reported once per program.
_GEAR_CHANGE = Text(
    "the spindle turns to the position of the active step, the PLC acknowledges the M function, "
    "then the limits of the new step count and the spindle continues as before",
    "die Spindel dreht auf die Position der aktiven Stufe, die SPS quittiert die M-Funktion, dann "
    "gelten die Grenzen der neuen Stufe, und die Spindel dreht weiter wie zuvor",
)


class WordChecker:
    """Checks blocks of one channel; ``axes``: the names that it knows."""

    def __init__(
        self, channel: ChannelParameters, values: ValueChecker, findings: Findings
    ) -> None:
        self._channel = channel
        self._values = values
        self._findings = findings
        self.axes = values.axes
        self._components = VECTOR_WORDS if any(channel.transformations.steps) else ()
        self.spindles = channel.spindle_names
        self._commands = SpindleChecker(channel, values, findings, in_cycle=False)
        self._together = BlockChecker(channel, self.axes[:3], findings)
        self.joins_motions = False

    def take_exchanges(self) -> list[AxisUse]:
        """Return the axes that spindles fetched or gave since the last call of this method."""
        return self._commands.take()

    def block(self, block: Block, role: Role = "either") -> None:
        """Check one block of a program in this role."""
        self._values.line(*_expressions(block))
        dwell = dwell_of(block)
        if dwell is not None:
            check_dwell(block, dwell, self._values, self._findings)
            return
        state = _BlockState(role, any(_returns(word) for word in block.words))
        state.axis_words = tuple(word for word in block.words if isinstance(word, AxisWord))
        commands, words = split(block.words, self.spindles)
        state.homes_spindles = bool(commands) and HOMING in functions_of(block)
        for command in commands:
            if state.homes_spindles:
                self._findings.report_support(support_level.form("G74 S1"), command.span)
            else:
                self._commands.check(command)
        for word in words:
            match word:
                case AxisWord():
                    self._axis(word, state, self._components)
                case Word():
                    self._word(word, state)
                case BracketCommand():
                    if self._is_of_path(word) or self._is_independent(word, state):
                        continue
                    if not self.bracket(word, state):
                        self._unknown(word, state)
                case StringWord():
                    state.is_computed = True  # expanded when the block is decoded
        given = GivenWords(state.words.union(state.names), state.functions)
        self.joins_motions |= state.is_computed
        self.joins_motions |= self._together.check(block, given)

    # --- axes, feed ------------------------------------------------------------------------------

    def _axis(self, word: AxisWord, state: _BlockState, others: tuple[str, ...] = ()) -> None:
        if word.name not in self.axes and word.name not in others:
            self._unknown(word, state)
        else:
            self._value(word, state)

    def _value(self, word: AxisWord | Word, state: _BlockState) -> None:
        """Check the value of a word that may appear once in a block."""
        if word.value is None:
            if not state.unknown:
                self._needs_value(word)
        elif word.name in state.names:
            self._findings.report(DUPLICATE_WORD, word.span, word=word.name)
        else:
            state.names[word.name] = None
            self._values.value(word.value)

    def _unknown(self, word: AxisWord | Word | BracketCommand, state: _BlockState) -> None:
        if not state.unknown:
            state.unknown = True
            self.unknown(word)

    def unknown(self, word: AxisWord | Word | BracketCommand) -> None:
        """Report a word that is neither known nor an axis or spindle of the channel."""
        self._findings.report(
            UNKNOWN_WORD,
            word.span,
            word=self._findings.written(word.span),
            axes=", ".join(self.axes) or "–",
            nearest=nearest(word.name, (*self.axes, *self.spindles)) or NOTHING,
        )

    def _needs_value(self, word: AxisWord | Word) -> None:
        self._findings.report(WORD_VALUE_MISSING, word.span, word=word.name)

    def _word(self, word: Word, state: _BlockState) -> None:
        state.words.add(word.name)
        if word.name in _NUMBERED:
            if word.name == "G" and isinstance(word.value, Number):
                state.functions.add(word.value.value)
            state.is_computed |= word.name == "G" and not isinstance(word.value, Number)
            self._numbered(word, state)
            return
        if word.name == "N" and state.returns:
            return
        if word.name in self.spindles:
            written = self._findings.written(word.span)
            self._findings.report(
                NOT_A_SPINDLE_WORD, word.span, word=written, nearest=f"{word.name}[M3 REV=1000]"
            )
            return
        if word.name in SWITCHES or word.name in VECTORS:
            return
        entry = support_level.word(word.name)
        if entry is None:
            self._unknown(word, state)
        elif entry.support is Support.REFUSED:
            self._findings.report_support(entry, word.span, self._findings.written(word.span))
        else:
            if word.name != "T" or not self._channel.tool_selection.reports_t:
                self._findings.report_support(entry, word.span)
            self._value(word, state)

    # --- G, M, H ---------------------------------------------------------------------------------

    def number(self, word: Word) -> int | None:
        """Return the number of a G, M or H function; report it and return ``None`` if there is
        none.
        """
        value = word.value
        if value is None:
            self._needs_value(word)
        elif not isinstance(value, Number):
            written = self._findings.written(word.span)
            self._findings.report_support(
                support_level.form("M[P1], in cycles"), word.span, written
            )
        elif not value.value.is_integer() or value.value < 0:
            self._findings.report(
                INVALID_FUNCTION_NUMBER, word.span, word=f"{word.name}{number_text(value.value)}"
            )
        else:
            return int(value.value)
        return None

    def _numbered(self, word: Word, state: _BlockState) -> None:
        if word.value is not None and not isinstance(word.value, Number):
            self._values.value(word.value)
            self._value_for_plc(word)
            return
        number = self.number(word)
        if number is None:
            return
        if word.name == "G":
            self._g(word, number, state)
        elif word.name == "M" and number in SUBPROGRAM_ENDS:
            if state.role == "main":
                self._findings.report(SUBPROGRAM_END_IN_MAIN_PROGRAM, word.span, word=f"M{number}")
            self._value_for_plc(word)
        else:
            if word.name == "M" and number in PROGRAM_ENDS and state.role == "called":
                self._findings.report(PROGRAM_END_IN_SUBPROGRAM, word.span, word=f"M{number:02}")
            self._technology(word, number)

    def _g(self, word: Word, number: int, state: _BlockState) -> None:
        entry = support_level.g_function(number)
        is_named = f"G{number}" in self._findings.named_programs
        if is_named or number in self._channel.implicit_programs.g:
            for argument in word.arguments:
                self._values.any_value(argument)
            return
        if entry is None:
            self._findings.report(INVALID_FUNCTION_NUMBER, word.span, word=f"G{number}")
            return
        if is_neutral(word, entry):
            self._findings.report_support(replace(entry, support=Support.ACCEPTED), word.span)
            return
        if entry.form is Form.SUBPROGRAM:
            key = program_parameter(number)
            self._findings.report(NO_PROGRAM_FOR_G_FUNCTION, word.span, word=entry.name, key=key)
            return
        self._findings.report_support(entry, word.span)
        if entry.support is Support.REFUSED:
            return
        if entry.instead.en:
            self._findings.report_simplified(entry.name, entry.instead, word.span)
        if entry.form is Form.ZERO_OFFSET:
            self._zero_offset(word)
        elif entry.form is Form.RADIUS:
            self._radius(word)
        elif entry.form is Form.WEIGHT:
            check_weight(word, self._values, self._findings)
        elif word.additional is not None or word.arguments:
            self._findings.report(EXTRA_PARAMETERS, word.span, word=entry.name)
        if entry.form in WITH_AXES and not (state.axis_words or state.homes_spindles):
            self._findings.report(COMMAND_WITHOUT_AXIS, word.span, command=entry.name)
        group = Group.CONTOURING if number in BLOCK_TRANSITIONS else entry.group
        if group is None:
            return
        if group not in state.groups:
            state.groups[group] = entry.name
        elif state.groups[group] == entry.name:
            self._findings.report(DUPLICATE_WORD, word.span, word=entry.name)
        else:
            other = state.groups[group]
            self._findings.report(EXCLUSIVE_WORDS, word.span, word=entry.name, other=other)

    def _technology(self, word: Word, number: int) -> None:
        entry = self._technology_entry(word.name, number)
        name = f"{word.name}{number:02}"
        if entry is None:
            key = f"{word.name.lower()}_synch[{number}]"
            self._findings.report(FUNCTION_NOT_DEFINED, word.span, word=name, key=key)
        else:
            self._findings.report_support(entry, word.span, name)
            self._value_for_plc(word)
            if word.name == "M" and number in GEAR_FUNCTIONS and self._channel.gears.is_enabled:
                self._findings.report_simplified("M40 … M45", _GEAR_CHANGE, word.span)

    def _value_for_plc(self, word: Word) -> None:
        """Check the value that a function passes to the PLC: ``M110=130``."""
        value = word.additional
        if value is None:
            return
        self._values.value(value)
        if isinstance(value, Number) and not MIN_VALUE <= round(value.value) <= MAX_VALUE:
            name = self._findings.written(word.span)
            self._findings.report(
                WORD_VALUE_OUT_OF_RANGE,
                value.span,
                word=name,
                value=round(value.value),
                minimum=MIN_VALUE,
                maximum=MAX_VALUE,
            )

    def _technology_entry(self, letter: str, number: int) -> Entry | None:
        if letter == "H":
            return support_level.h_function(number, self._channel.h_functions)
        listed = self._channel.implicit_programs
        if number == TOOL_CHANGE and (listed.m6 or CHANGE in self._findings.named_programs):
            return support_level.word("L")
        return support_level.m_function(number, self._channel.m_functions)

    # --- other words -----------------------------------------------------------------------------

    def _is_of_path(self, command: BracketCommand) -> bool:
        """Check ``X[OVERRIDE …]`` or ``X[FIXED_STOP …]``; return false for anything else."""
        if command.name not in self.axes:
            return False
        return check_path_axis(command, self._values, self._findings)

    def _is_independent(self, command: BracketCommand, state: _BlockState) -> bool:
        """Check a command for an independent axis, X[OSC …] …; return whether it is one."""
        name = command.name
        if name not in self.axes:
            return False
        if not check_independent(command, state.axis_words, self._values, self._findings):
            return False
        if name in state.independent:
            self._findings.report(DUPLICATE_WORD, command.span, word=name)
        state.independent.add(name)
        return True

    def bracket(self, command: BracketCommand, state: _BlockState | None = None) -> bool:
        """Check ``X[…]`` or ``M17[MAIN]``; return false if the name is unknown."""
        name = command.name
        if name in self.axes and is_axis_command(command):
            self._findings.report(INDP_OUTSIDE_REALTIME_CYCLE, command.span, axis=name)
            return True
        if name in self.axes and state is None and has_function(command):
            written = self._findings.written(command.span)
            self._findings.report(FUNCTION_GIVEN_TO_AXIS_IN_CYCLE, command.span, command=written)
            return True
        if name in self.axes:
            self._other_axis_command(command)
            return True
        if name in RETURN_COMMANDS:
            _check_return(
                command, state is not None and state.role == "main", self._values, self._findings
            )
            return True
        return False

    def _other_axis_command(self, command: BracketCommand) -> None:
        """Report a command for an axis that is not simulated, misspelt, or lacks INDP."""
        words = [item.name for item in command.items if isinstance(item, Keyword | Name)]
        axis = command.name
        form = form_of(command)
        if form:
            written = f"{axis}[{form} …]"
            self._findings.report(COMMAND_NOT_ALLOWED_IN_CYCLE, command.span, command=written)
            return
        known = next((word for word in words if word in _AXIS_FORMS), None)
        motion = next((word for word in words if word in INDP_WORDS), None)
        if known is not None:
            entry = support_level.form(f"X[{known} …]")
            self._findings.report_support(entry, command.span, f"{axis}[{known} …]")
            return
        if has_function(command):
            written = self._findings.written(command.span)
            self._findings.report_support(support_level.form("X[M7]"), command.span, written)
            return
        names = ("INDP", *FORMS, "OVERRIDE", "FIXED_STOP", *_AXIS_FORMS)
        others = (word for word in words if word not in INDP_WORDS)
        misspelt = next((word for word in others if nearest(word, names) not in ("", word)), None)
        if misspelt is not None:
            self._findings.report(
                UNKNOWN_AXIS_COMMAND,
                command.span,
                axis=axis,
                word=misspelt,
                nearest=nearest(misspelt, names),
                names=", ".join(names),
            )
        elif motion is not None:
            self._findings.report(INDP_MISSING, command.span, axis=axis, word=motion)
        else:
            entry = support_level.form("X[…]")
            self._findings.report_support(entry, command.span, f"{axis}[…]")

    # --- offsets ---------------------------------------------------------------------------------

    def _zero_offset(self, word: Word) -> None:
        """Check ``G159 = n``."""
        if word.additional is None or word.arguments:
            self._findings.report(G159_WITHOUT_NUMBER, word.span)
        else:
            self._values.value(word.additional)
            self._known_group(word.additional)

    def _radius(self, word: Word) -> None:
        """Check ``G163 = r``."""
        if word.additional is None or word.arguments:
            self._findings.report(G163_WITHOUT_RADIUS, word.span)
        else:
            self._values.value(word.additional)

    def _known_group(self, value: Expression) -> None:
        """Check the zero offset of G159 if it is a constant."""
        if isinstance(value, Number):
            group = value.value
            if not 0 <= round(group) < MAX_GROUPS:
                self._findings.report(
                    UNKNOWN_ZERO_OFFSET, value.span, group=group, highest=MAX_GROUPS - 1
                )

    def offsets(self, command: OffsetCommand, role: Role) -> None:
        """Check ``#PSET``, ``#PRESET`` and ``#SCALE`` with axes, ``#SUPPRESS OFFSETS`` with any
        motion.
        """
        name = f"#{command.name}"
        state = _BlockState(role)
        for kind in command.kinds:
            word = kind.name if isinstance(kind, Keyword) and kind.value is None else ""
            if command.name != "SUPPRESS OFFSETS" or word not in OFFSETS:
                written = self._findings.written(kind.span)
                self._findings.report(
                    UNKNOWN_OFFSET_KIND, kind.span, word=written, names=", ".join(OFFSETS)
                )
        if command.name == "SUPPRESS OFFSETS":
            self.block(Block(command.span, command.head, command.words), role)
        else:
            for other in command.words:
                if isinstance(other, AxisWord):
                    self._axis(other, state)
                else:
                    written = self._findings.written(other.span)
                    self._findings.report(
                        MOTION_WORD_WITH_OFFSETS, other.span, word=written, command=name
                    )
        check_scale_factors(command, self._findings)
        needs_axis = command.name not in ("PRESET", "SCALE ON")
        if needs_axis and not any(isinstance(word, AxisWord) for word in command.words):
            self._findings.report(COMMAND_WITHOUT_AXIS, command.span, command=name)


def _returns(word: BlockWord) -> bool:
    if isinstance(word, BracketCommand):
        return word.name in RETURN_COMMANDS
    return any(_is_m(word, number) for number in SUBPROGRAM_ENDS)


def _is_m(word: BlockWord, number: int) -> bool:
    return _is(word, "M", number)


def _is(word: BlockWord, name: str, number: int) -> bool:
    return (
        isinstance(word, Word)
        and word.name == name
        and isinstance(word.value, Number)
        and word.value.value == number
    )


def _expressions(block: Block) -> list[Expression]:
    """Return the values of a block's words."""
    expressions: list[Expression] = []
    for word in block.words:
        if isinstance(word, Word | AxisWord) and word.value is not None:
            expressions.append(word.value)
        if isinstance(word, Word) and word.additional is not None:
            expressions.append(word.additional)
    return expressions


def _check_return(
    command: BracketCommand, is_in_main: bool, values: ValueChecker, findings: Findings
) -> None:
    """Check ``M17 […]``; ``is_in_main``: it is in a main program."""
    if is_in_main:
        findings.report(SUBPROGRAM_END_IN_MAIN_PROGRAM, command.span, word=command.name)
    seen: dict[str, None] = {}
    for item in command.items:
        kind = _kind_of_option(item)
        if not kind or kind in seen:
            findings.report(INVALID_RETURN_OPTION, item.span, word=findings.written(item.span))
        elif isinstance(item, Keyword) and item.name == "JUMPS" and item.value is not None:
            values.value(item.value)
        seen[kind] = None


def _kind_of_option(item: Keyword | Expression) -> str:
    """Return the kind of an item: "calls", "label", or empty if unknown."""
    if isinstance(item, Name):
        return "label"
    if not isinstance(item, Keyword):
        return ""
    if item.name == "JUMPS":
        return "calls" if item.value is not None else ""
    if item.name == "N":
        return "label" if isinstance(item.value, Number) else ""
    if item.value is not None or item.arguments:
        return ""
    return "calls" if item.name == "MAIN" else "label"
