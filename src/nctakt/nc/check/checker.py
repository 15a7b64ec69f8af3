# SPDX-License-Identifier: MIT
"""Statements -> diagnostics, before the program runs.

In: statements, the variables and the list of their channel. Out: diagnostics; nothing is executed.
A program without errors can be decoded; the decoder checks everything that depends on values.
Support of commands: ``support_level.py``. Code after a constant false condition is not checked
unless a jump may lead there. ``inspection.py`` applies the checker to a whole text.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import overload

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Span
from nctakt.base.line_shift import LineShift
from nctakt.base.misspelling import nearest_first
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.messages import Collector
from nctakt.messages.programs.checked_blocks import (
    FORMAT_VALUE_COUNT,
    INVALID_COMMAND_FORM,
    INVALID_PLACEHOLDER,
    TEXT_FOR_NUMERIC_WORD,
    UNKNOWN_COMMAND,
    UNKNOWN_COMMAND_OPTION,
)
from nctakt.messages.programs.checked_cycles import (
    DUPLICATE_KEYWORD,
    FREQUENCY_OUTSIDE_REALTIME_CYCLE,
    LOOP_CONTROL_OUTSIDE_LOOP,
)
from nctakt.messages.programs.program_structure import BLOCK_NUMBER_BEFORE_HASH_IF
from nctakt.nc.check.axes.axis_exchange import ExchangeChecker
from nctakt.nc.check.axes.couplings import check_coupling
from nctakt.nc.check.axes.main_spindle import check_main_spindle
from nctakt.nc.check.blocks import Role, WordChecker
from nctakt.nc.check.calls import CallChecker
from nctakt.nc.check.cycles.axis_commands import AxisCommandChecker
from nctakt.nc.check.cycles.realtime_cycles import CycleChecker
from nctakt.nc.check.cycles.realtime_loops import LoopChecker
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings, FindingsState
from nctakt.nc.check.hash_commands import CommandChecker
from nctakt.nc.check.neutral_settings import check_setting
from nctakt.nc.check.path.coordinate_systems import (
    check_cs_command,
    check_machine_command,
    check_plane_command,
    check_transformation,
)
from nctakt.nc.check.path.measuring import check_meas
from nctakt.nc.check.path.path_commands import check_path_command
from nctakt.nc.check.path.splines import check_spline_command
from nctakt.nc.check.path.tools import check_tool_command
from nctakt.nc.check.program_variables import ProgramVariableChecker
from nctakt.nc.check.signals import SignalChecker
from nctakt.nc.check.user_errors import UserErrorChecker
from nctakt.nc.meaning.macros import MacroExpander
from nctakt.nc.outline import AxisUse, SignalUse, labels_in
from nctakt.nc.parse.open_structures import is_false
from nctakt.nc.source import Source
from nctakt.nc.tree import (
    Assignment,
    Block,
    Break,
    Continue,
    CycleControl,
    Do,
    Expression,
    Flush,
    For,
    Goto,
    HashCommand,
    If,
    MacroDefinition,
    Number,
    OffsetCommand,
    Parameter,
    RealtimeCycle,
    RealtimeLoop,
    Repeat,
    Statement,
    StringLiteral,
    SubprogramCall,
    Switch,
    Time,
    Timer,
    UserError,
    UserMessage,
    VariableBlock,
    VariableDeclarations,
    While,
    Word,
)
from nctakt.nc.vocabulary import support_level
from nctakt.nc.vocabulary.commands import forms_of
from nctakt.nc.vocabulary.entries import Support
from nctakt.nc.vocabulary.message_formats import conversions
from nctakt.nc.vocabulary.variables.variable_table import NameTable

__all__ = ["Checker", "Role", "ends"]

_MESSAGE_OPTIONS = ("SAVE", "EXCLUSIVE", "CONTINUE")
#: Options of #MSG that exist and are not simulated.
_REFUSED_OPTIONS = ("INFO", "SYN", "ACK")


@dataclass(frozen=True, slots=True)
class CheckerState:
    """The state of a checker between two statements.

    ``targets``: the labels that the section's jumps name, with the spans of the jumps. ``fetched``:
    names of fetched axes with their numbers.
    """

    role: Role
    targets: Mapping[str, tuple[Span, ...]]
    findings: FindingsState
    fetched: tuple[tuple[str, int | None], ...]

    @property
    def size(self) -> int:
        """How many values are in it."""
        return sum(map(len, self.targets.values())) + len(self.findings[0]) + len(self.findings[1])

    def shifted(self, shift: LineShift) -> CheckerState:
        """Return it for a text with other lines; raises ``ReplacedLine``."""
        targets = {name: tuple(map(shift.span, spans)) for name, spans in self.targets.items()}
        return replace(self, targets=targets)


class Checker:
    """Checks the statements of one program in their order."""

    def __init__(
        self,
        source: Source,
        names: NameTable,
        channel: ChannelParameters,
        collector: Collector,
        named_programs: Iterable[str] = (),
    ) -> None:
        self._findings = Findings(source, collector)
        self._findings.named_programs.update(named_programs)
        names = names.own_table()
        axes = [axis.name for axis in channel.axes]
        self._names = names
        self._values = ValueChecker(names, axes, self._findings, in_cycle=False)
        self._channel = channel
        self._words = WordChecker(channel, self._values, self._findings)
        in_cycle = ValueChecker(names, axes, self._findings, in_cycle=True)
        single = AxisCommandChecker(names, self._words, in_cycle, self._findings)
        self._cycles = CycleChecker(
            channel, self._words, self._values, in_cycle, single, self._findings
        )
        self._realtime_loops = LoopChecker(channel, names, self._findings, self.statement)
        self._calls = CallChecker(self._words, self._values, self._findings)
        self._program_variables = ProgramVariableChecker(self._values, self._findings)
        self._commands = CommandChecker(self._values, axes, self._findings)
        self._signals = SignalChecker(self._values, axes, self._findings)
        self._exchange = ExchangeChecker(channel, names, axes, self._values, self._findings)
        self._macros = MacroExpander(names, self._macro)
        self._loops = 0
        self._switches = 0
        self._role: Role = "main"
        #: Labels named by jumps of this section, with the spans of the jumps.
        self.targets: dict[str, list[Span]] = {}

    @property
    def state(self) -> CheckerState:
        """State that the check of later statements depends on."""
        targets = {name: tuple(spans) for name, spans in self.targets.items()}
        return CheckerState(self._role, targets, self._findings.state, self._exchange.fetched)

    def resume(self, state: CheckerState) -> None:
        """Continue from a state."""
        self._role = state.role
        self.targets = {name: list(spans) for name, spans in state.targets.items()}
        self._findings.resume(state.findings)
        self._exchange.resume(state.fetched)

    def begin(self, role: Role) -> None:
        """Begin a main program or a subprogram."""
        self._role = role
        self.targets = {}
        self._findings.has_other_macros |= role != "main"

    def take_calls(self) -> list[SubprogramCall]:
        """Return the calls by a constant name since the last call of this method."""
        return self._calls.take()

    @property
    def joins_motions(self) -> bool:
        """Whether any statement so far makes motions depend on their neighbours."""
        return self._words.joins_motions

    @property
    def named_programs(self) -> frozenset[str]:
        """The words whose program ``#FILE NAME`` has named so far."""
        return frozenset(self._findings.named_programs)

    def take_signals(self) -> list[SignalUse]:
        """Return the signals sent or awaited since the last call of this method."""
        return self._signals.take()

    def take_exchanges(self) -> list[AxisUse]:
        """Return the axes fetched or given since the last call of this method."""
        return self._exchange.take() + self._words.take_exchanges()

    def has_fetched(self, names: Iterable[object]) -> bool:
        """Return whether one of these names is that of a fetched axis."""
        return not self._names.fetched.keys().isdisjoint(names)

    def _macro(self, text: StringLiteral) -> Expression | None:
        """Return a placeholder number for a macro that is or may be defined, else ``None``."""
        if self._findings.has_other_macros or text.value in self._findings.macros:
            return Parameter(text.span, Number(text.span, 1.0))
        return None

    def _all(self, statements: Sequence[Statement]) -> None:
        for statement in statements:
            self.statement(statement)

    def statement(self, statement: Statement) -> None:
        """Check one statement with all statements inside it."""
        if self._findings.macros or self._findings.has_other_macros:
            statement = self._macros.statement(statement)
        if statement.head.number is not None:
            self._values.block(statement.head.number)
        match statement:
            case Block():
                self._words.block(statement, self._role)
            case OffsetCommand():
                self._words.offsets(statement, self._role)
            case Assignment():
                self._values.assignment(statement)
            case VariableBlock():
                self._values.line(statement.variable)
                self._values.any_value(statement.variable)
            case RealtimeCycle():
                self._cycles.definition(statement)
            case CycleControl():
                self._cycles.control(statement)
            case RealtimeLoop():
                self._realtime_loops.loop(statement)
            case Time():
                self._values.block(statement.seconds)
            case UserMessage():
                self._message(statement)
            case If() | For() | While() | Do() | Repeat() | Switch():
                self._structure(statement)
            case Break() | Continue():
                self._leave(statement)
            case Flush():
                pass
            case _:
                self._other(statement)

    # --- structures ------------------------------------------------------------------------------

    def _structure(self, statement: If | For | While | Do | Repeat | Switch) -> None:
        match statement:
            case If():
                self._if(statement)
            case For():
                bounds = (statement.start, statement.end, statement.step)
                self._values.line(statement.variable, *bounds)
                self._values.write(statement.variable, compound=True)
                for bound in bounds:
                    self._values.value(bound)
                self._loop(statement.body)
            case While():
                self._values.block(statement.condition)
                if not is_false(statement.condition):
                    self._loop(statement.body)
            case Do() | Repeat():
                self._loop(statement.body)
                self._values.block(statement.condition)
            case Switch():
                self._switch(statement)

    def _loop(self, body: Sequence[Statement]) -> None:
        self._loops += 1
        self._all(body)
        self._loops -= 1

    def _switch(self, switch: Switch) -> None:
        self._values.block(switch.subject)
        self._switches += 1
        for case in switch.cases:
            if case.head.number is not None:
                self._values.block(case.head.number)
            if case.value is not None:
                self._values.block(case.value)
            self._all(case.body)
        self._switches -= 1

    def _if(self, statement: If) -> None:
        if statement.preprocessor and statement.head.number is not None:
            self._findings.report(BLOCK_NUMBER_BEFORE_HASH_IF, statement.span)
        if statement.frequency is not None:
            word = f"$IF {statement.frequency}"
            self._findings.report(FREQUENCY_OUTSIDE_REALTIME_CYCLE, statement.span, word=word)
        self._branch(statement.condition, statement.body)
        for branch in statement.elseifs:
            if branch.frequency is not None:
                word = f"$ELSEIF {branch.frequency}"
                self._findings.report(FREQUENCY_OUTSIDE_REALTIME_CYCLE, branch.span, word=word)
            self._branch(branch.condition, branch.body)
        self._all(statement.else_body or ())

    def _branch(self, condition: Expression, body: Sequence[Statement]) -> None:
        self._values.block(condition)
        if not is_false(condition) or any(_has_label(statement) for statement in body):
            self._all(body)

    def _leave(self, statement: Break | Continue) -> None:
        inside = self._loops or (isinstance(statement, Break) and self._switches)
        if not inside:
            word = "$BREAK" if isinstance(statement, Break) else "$CONTINUE"
            self._findings.report(LOOP_CONTROL_OUTSIDE_LOOP, statement.span, word=word)

    # --- commands --------------------------------------------------------------------------------

    def _message(self, message: UserMessage) -> None:
        seen: dict[str, None] = {}
        for option in message.options:
            if option.name in _REFUSED_OPTIONS:
                self._refuse_hash(message, "MSG", "INFO", shown=f"#MSG {option.name}")
            elif option.name not in _MESSAGE_OPTIONS:
                names = nearest_first(option.name, _MESSAGE_OPTIONS)
                self._findings.report(
                    UNKNOWN_COMMAND_OPTION,
                    option.span,
                    command="#MSG",
                    word=option.text,
                    names=", ".join(names),
                )
            elif option.name in seen:
                self._findings.report(
                    DUPLICATE_KEYWORD, option.span, command="#MSG", word=option.name
                )
            seen[option.name] = None
        self._message_text(message)

    def _message_text(self, message: UserMessage) -> None:
        self._values.line(message.format, *message.arguments)
        if not isinstance(message.format, StringLiteral):
            self._values.text(message.format)
            for argument in message.arguments:
                self._values.any_value(argument)
            return
        placeholders = list(conversions(message.format.value))
        wrong = next((conversion for conversion in placeholders if not conversion.is_valid), None)
        if wrong is not None:
            self._findings.report(INVALID_PLACEHOLDER, message.format.span, word=wrong.text)
        elif len(placeholders) != len(message.arguments):
            expected, actual = len(placeholders), len(message.arguments)
            self._findings.report(
                FORMAT_VALUE_COUNT, message.format.span, expected=expected, given=actual
            )
        for index, argument in enumerate(message.arguments):
            self._values.any_value(argument)
            if not self._values.is_text(argument):
                continue
            if (
                index < len(placeholders)
                and placeholders[index].is_valid
                and not placeholders[index].takes_text
            ):
                self._findings.report(
                    TEXT_FOR_NUMERIC_WORD, argument.span, word=placeholders[index].text
                )

    def _other(self, statement: Statement) -> None:
        """Check jumps, calls, declarations and the other commands."""
        match statement:
            case Goto():
                self.targets.setdefault(statement.label, []).append(statement.span)
            case SubprogramCall():
                self._calls.call(statement)
                self._findings.has_other_macros = True
            case MacroDefinition():
                self._findings.macros.add(statement.name)  # its text is checked where it is used
            case VariableDeclarations():
                self._program_variables.declarations(statement)
            case Timer():
                self._commands.timer(statement)
            case UserError():
                UserErrorChecker(self._values, self._findings, in_cycle=False).check(statement)
            case HashCommand():
                self._hash(statement)

    def _refuse_hash(self, statement: Statement, *words: str, shown: str = "") -> None:
        entry = support_level.hash_command(words)
        assert entry is not None
        self._findings.report_support(entry, statement.span, shown)

    def _hash(self, command: HashCommand) -> None:
        words = [word.name for word in command.words]
        entry = support_level.hash_command(words)
        name = "#" + " ".join(words)
        if entry is None:
            nearest = support_level.nearest_hash(words) or "–"
            self._findings.report(UNKNOWN_COMMAND, command.span, word=name, nearest=nearest)
        elif check_path_command(command, self._values, self._words.axes[:3], self._findings):
            return
        elif check_cs_command(command, self._values, self._findings):
            return
        elif check_setting(command, self._values, self._findings):
            return
        elif check_main_spindle(command, self._channel, self._values, self._findings):
            return
        elif check_coupling(
            command,
            (*self._words.axes, *self._channel.spindle_names),
            self._values,
            self._findings,
        ):
            return
        elif check_machine_command(command, self._values, self._findings):
            return
        elif check_plane_command(command, self._words.axes, self._values, self._findings):
            return
        elif check_transformation(command, self._values, self._findings):
            return
        elif check_meas(command, self._words.axes, self._values, self._findings):
            return
        elif check_tool_command(command, self._words.axes, self._values, self._findings):
            return
        elif check_spline_command(command, self._values, self._findings):
            self._words.joins_motions = True
        elif words == ["DELETE"]:
            self._program_variables.delete(command)
        elif self._commands.command(command, words) or self._signals.command(command):
            pass
        elif self._exchange.command(command):
            pass
        elif entry.forms == (name,) and not command.arguments:
            pass
        elif entry.support is Support.SIMULATED:
            forms = forms_of(entry.name)
            self._findings.report(
                INVALID_COMMAND_FORM, command.span, command=entry.name, forms=forms
            )
        else:
            self._findings.report_support(entry, command.span, name)


def ends(statement: Statement, numbers: Sequence[int]) -> bool:
    """Return whether a block holds one of these M functions, regardless of skip levels."""
    return (
        isinstance(statement, Block)
        and statement.head.skip is None
        and any(
            isinstance(word, Word)
            and word.name == "M"
            and isinstance(word.value, Number)
            and word.value.value in numbers
            for word in statement.words
        )
    )


def _has_label(statement: Statement) -> bool:
    return any(True for _ in labels_in(statement))


# --- statements that only the run shows -----------------------------------------------------------


def first_mistake(
    names: NameTable,
    parameters: ChannelParameters,
    statements: Sequence[Statement],
    span: Span,
    line: Callable[[], str],
    is_main: bool,
    named_programs: Iterable[str],
) -> Diagnostic | None:
    """Return the first error in statements at ``span``, ``None`` if there is none.

    ``line`` returns the text that they were read from, for a message that shows part of it.
    ``is_main``: they belong to the main program itself. ``named_programs``: the words whose program
    ``#FILE NAME`` has named.
    """
    collector = Collector()
    source = Source(span.file, _OneLine(span.line, line))
    checker = Checker(source, names, parameters, collector, named_programs)
    checker.begin("main" if is_main else "either")
    for statement in statements:
        checker.statement(statement)
    errors = (one for one in collector.diagnostics if one.severity.name == "ERROR")
    return next(errors, None)


class _OneLine(Sequence[str]):
    """A text of which only the line of this number matters, the last one."""

    def __init__(self, number: int, line: Callable[[], str]) -> None:
        self._number = number
        self._line = line

    def __len__(self) -> int:
        return self._number

    @overload
    def __getitem__(self, index: int) -> str: ...

    @overload
    def __getitem__(self, index: slice) -> Sequence[str]: ...

    def __getitem__(self, index: int | slice) -> str | Sequence[str]:
        if isinstance(index, slice):
            return [self[position] for position in range(*index.indices(self._number))]
        return self._line() if index == self._number - 1 else ""
