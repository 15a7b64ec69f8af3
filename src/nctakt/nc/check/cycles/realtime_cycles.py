# SPDX-License-Identifier: MIT
"""Realtime cycles, checked before they run.

In: definitions and management commands. Out: diagnostics. Keywords (RC-101 … RC-105), P-CHAN-00406
(RC-114), the statements of a body (RC-201 … RC-208), M and H functions (RC-403). ``expressions.py``
checks expressions and accesses, ``axis_commands.py`` single-axis commands.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from nctakt.base.diagnostics import Span
from nctakt.base.misspelling import nearest_first
from nctakt.base.whole_numbers import is_whole
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.messages.programs.checked_blocks import (
    AXIS_FUNCTION_IN_CYCLE,
    NOT_NC_TEXT,
    PROGRAM_CONTROL_IN_CYCLE,
    UNKNOWN_COMMAND,
    WORD_VALUE_MISSING,
)
from nctakt.messages.programs.checked_cycles import (
    COMMAND_NOT_ALLOWED_IN_CYCLE,
    CYCLE_COMMAND_WITHOUT_ID,
    CYCLE_H_FUNCTION_NOT_DEFINED,
    CYCLE_M_FUNCTION_NOT_DEFINED,
    CYCLE_WITHOUT_ID,
    DUPLICATE_KEYWORD,
    ELSEIF_WITH_FREQUENCY,
    FREQUENCY_IF_WITH_ELSE,
    INVALID_CYCLE_ID,
    INVALID_GLOBAL_CYCLE_ID,
    INVALID_KEYWORD_VALUE,
    REALTIME_CYCLES_OFF,
    TIMER_WITHOUT_SYN,
    UNKNOWN_KEYWORD_IN_CYCLE,
)
from nctakt.messages.programs.nc_text import UNKNOWN_CYCLE_KEYWORD
from nctakt.messages.programs.slips import ROUND_BRACKETS
from nctakt.nc.check.axes.spindle_commands import SpindleChecker
from nctakt.nc.check.blocks import WordChecker
from nctakt.nc.check.cycles.axis_commands import AxisCommandChecker
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.check.user_errors import UserErrorChecker
from nctakt.nc.meaning.words import HIGHEST_CYCLE_ID
from nctakt.nc.tree import (
    Assignment,
    Block,
    BlockWord,
    BracketCommand,
    CycleControl,
    Expression,
    HashCommand,
    If,
    Keyword,
    Name,
    Number,
    RealtimeCycle,
    Statement,
    Timer,
    Unreadable,
    UserError,
    VariableBlock,
    Word,
)
from nctakt.nc.vocabulary import support_level
from nctakt.nc.vocabulary.functions import FLOW_FUNCTIONS, RETURN_COMMANDS
from nctakt.nc.vocabulary.single_axes.axis_commands import is_axis_command
from nctakt.nc.vocabulary.spindle_commands import split

SCOPES = ("BLOCK", "PROG", "GLOBAL")
END_ACTIONS = ("MOVE_ABORT", "MOVE_CONT")
TIMER_ACTIONS = ("START", "STOP", "READ", "CLEAR")

_KEYWORDS_IN_COMMENT = re.compile(
    r"^[A-Z ]*(?P<found>\((?P<inner>\s*(?:DEF\s+)?(?:ID|SCOPE|END_ACTION)\s*=[^()]*)\))",
    re.IGNORECASE,
)


class CycleChecker:
    """Checks definitions and management commands.

    ``words`` and ``program_values``: the checkers of the enclosing program; ``values`` and
    ``axes``: those of the cycles.
    """

    def __init__(
        self,
        channel: ChannelParameters,
        words: WordChecker,
        program_values: ValueChecker,
        values: ValueChecker,
        axes: AxisCommandChecker,
        findings: Findings,
    ) -> None:
        self._axes = axes
        self._channel = channel
        self._words = words
        self._program_values = program_values
        self._values = values
        self._findings = findings
        self._spindles = SpindleChecker(channel, values, findings, in_cycle=True)
        self._user_errors = UserErrorChecker(values, findings, in_cycle=True)

    # --- definition and management ---------------------------------------------------------------

    def definition(self, cycle: RealtimeCycle) -> None:
        """Check ``#RT CYCLE … #RT CYCLE END``."""
        command = "#RT CYCLE DEF" if cycle.definition_only else "#RT CYCLE"
        self._enabled(cycle, command)
        if not cycle.keywords and self._has_round_brackets(cycle):
            self._statements(cycle.body)
            return
        keywords = self._keywords(cycle.keywords, ("ID", "SCOPE", "END_ACTION"))
        scope = self._choice(keywords.get("SCOPE"), SCOPES)
        self._choice(keywords.get("END_ACTION"), END_ACTIONS)
        if "ID" in keywords:
            self._identity(keywords["ID"], is_global=scope == "GLOBAL")
        elif cycle.definition_only:
            self._findings.report(CYCLE_WITHOUT_ID, cycle.span, word="DEF")
        elif scope == "GLOBAL":
            self._findings.report(CYCLE_WITHOUT_ID, cycle.span, word="SCOPE=GLOBAL")
        self._axes.begin(cycle.body)
        self._statements(cycle.body)

    def control(self, control: CycleControl) -> None:
        """Check ``#RT CYCLE START [ID=…]`` and the other management commands (RC-111)."""
        self._enabled(control, f"#RT CYCLE {control.action}")
        if not control.keywords and self._has_round_brackets(control):
            return
        keywords = self._keywords(control.keywords, ("ID",))
        if "ID" in keywords:
            self._identity(keywords["ID"], is_global=False)
        else:
            self._findings.report(CYCLE_COMMAND_WITHOUT_ID, control.span, action=control.action)

    def _has_round_brackets(self, statement: Statement) -> bool:
        """Return whether the keywords are in a comment; report it."""
        sign = replace(statement.span, end_column=statement.span.column + 1)
        text, span = self._findings.text_after(sign)
        match = _KEYWORDS_IN_COMMENT.search(text)
        if match is None:
            return False
        begin, end = (span.column + at for at in match.span("found"))
        self._findings.report(
            ROUND_BRACKETS,
            replace(span, column=begin, end_column=end),
            found=match["found"],
            replacement=f"[{match['inner'].strip()}]",
        )
        return True

    def _enabled(self, statement: Statement, command: str) -> None:
        if not self._channel.realtime_cycles.enable:
            self._findings.report(REALTIME_CYCLES_OFF, statement.span, command=command)

    def _keywords(
        self, items: Sequence[Keyword | Expression], allowed: Sequence[str]
    ) -> dict[str, Keyword]:
        keywords: dict[str, Keyword] = {}
        for item in items:
            if not isinstance(item, Keyword) or item.name not in allowed or item.arguments:
                self._findings.report(
                    UNKNOWN_CYCLE_KEYWORD,
                    item.span,
                    keyword=self._findings.written(item.span) or "–",
                )
            elif item.name in keywords:
                self._findings.report(
                    DUPLICATE_KEYWORD, item.span, command="#RT CYCLE", word=item.name
                )
            else:
                keywords[item.name] = item
        return keywords

    def _choice(self, keyword: Keyword | None, names: Sequence[str]) -> str:
        """Return the value of a keyword if it is one of ``names``, else report it; empty without
        one.
        """
        if keyword is None:
            return ""
        value = keyword.value
        if isinstance(value, Name) and value.name in names:
            return value.name
        written = "–" if value is None else self._findings.written(value.span)
        order = nearest_first(value.name, names) if isinstance(value, Name) else names
        span = keyword.span if value is None else value.span
        self._findings.report(
            INVALID_KEYWORD_VALUE, span, word=keyword.name, value=written, names=", ".join(order)
        )
        return ""

    def _identity(self, keyword: Keyword, *, is_global: bool) -> None:
        """Check the ID; a constant one is an integer above 0 (RC-103)."""
        value = keyword.value
        if value is None:
            self._findings.report(WORD_VALUE_MISSING, keyword.span, word="ID")
            return
        self._program_values.block(value)
        if not isinstance(value, Number):
            return
        if is_global and value.value <= 0:
            self._findings.report(
                INVALID_GLOBAL_CYCLE_ID, value.span, id=self._findings.written(value.span)
            )
        elif not is_whole(value.value, 1, HIGHEST_CYCLE_ID):
            self._findings.report(
                INVALID_CYCLE_ID, value.span, id=self._findings.written(value.span)
            )

    # --- the body --------------------------------------------------------------------------------

    def _statements(self, statements: Sequence[Statement]) -> None:
        for statement in statements:
            self._statement(statement)

    def _statement(self, statement: Statement) -> None:
        if statement.head.number is not None:
            self._program_values.block(statement.head.number)
        match statement:
            case Block():
                self._block(statement)
            case Assignment():
                self._values.assignment(statement)
            case VariableBlock():
                self._values.block(statement.variable)
            case If():
                self._if(statement)
            case Timer():
                self._timer(statement)
            case UserError():
                self._user_errors.check(statement)
            case HashCommand():
                self._hash(statement)
            case Unreadable():
                self._findings.report(NOT_NC_TEXT, statement.span)
            case _:
                self._no_meaning(statement)

    def _no_meaning(self, node: Statement | Word) -> None:
        self._findings.report(
            COMMAND_NOT_ALLOWED_IN_CYCLE, node.span, command=self._findings.written(node.span)
        )

    def _if(self, statement: If) -> None:
        if statement.preprocessor:
            self._no_meaning(statement)
            return
        if statement.frequency is not None:
            if statement.elseifs or statement.else_body is not None:
                self._findings.report(
                    FREQUENCY_IF_WITH_ELSE, _first_other(statement), word=statement.frequency
                )
        self._values.block(statement.condition)
        self._statements(statement.body)
        for branch in statement.elseifs:
            if branch.frequency is not None:
                self._findings.report(ELSEIF_WITH_FREQUENCY, branch.span, word=branch.frequency)
            self._values.block(branch.condition)
            self._statements(branch.body)
        self._statements(statement.else_body or ())

    def _timer(self, timer: Timer) -> None:
        """Check ``#TIMER`` with SYN and at most an ID (RC-401)."""
        for option in timer.options:
            if option.name != "SYN":
                self._findings.report(
                    UNKNOWN_KEYWORD_IN_CYCLE, option.span, command="#TIMER", word=option.text
                )
        for item in timer.keywords:
            if not isinstance(item, Keyword) or item.name != "ID":
                written = self._findings.written(item.span)
                self._findings.report(
                    UNKNOWN_KEYWORD_IN_CYCLE, item.span, command="#TIMER", word=written
                )
        if timer.action not in TIMER_ACTIONS:
            self._findings.report(
                UNKNOWN_KEYWORD_IN_CYCLE, timer.span, command="#TIMER", word=timer.action
            )
        elif not any(option.name == "SYN" for option in timer.options):
            self._findings.report(TIMER_WITHOUT_SYN, timer.span, action=timer.action)
        for item in timer.keywords:
            if isinstance(item, Keyword) and item.value is not None:
                self._values.block(item.value)

    def _hash(self, command: HashCommand) -> None:
        words = [word.name for word in command.words]
        if support_level.hash_command(words) is not None:
            self._no_meaning(command)
            return
        nearest = support_level.nearest_hash(words) or "–"
        self._findings.report(
            UNKNOWN_COMMAND, command.span, word="#" + " ".join(words), nearest=nearest
        )

    # --- words -----------------------------------------------------------------------------------

    def _block(self, block: Block) -> None:
        """Check functions, spindles and single axes; report the first word for the path."""
        is_reported = False
        for word in block.words:
            if isinstance(word, BracketCommand) and _moves_an_axis(word):
                self._axes.command(word)
        others = [word for word in block.words if not _moves_an_axis(word)]
        commands, words = split(others, self._words.spindles)
        for command in commands:
            self._spindles.check(command)
        for word in words:
            if isinstance(word, Word) and word.name in ("M", "H"):
                self._function(word)
            elif isinstance(word, BracketCommand) and word.name not in RETURN_COMMANDS:
                if not self._words.bracket(word):
                    self._words.unknown(word)
            elif not is_reported:
                is_reported = True
                self._findings.report(
                    COMMAND_NOT_ALLOWED_IN_CYCLE,
                    word.span,
                    command=self._findings.written(word.span),
                )

    def _function(self, word: Word) -> None:
        """Check an M or H function: in the channel list, for the channel, not for program
        control.
        """
        number = self._words.number(word)
        if number is None:
            return
        name, letter = f"{word.name}{number:02}", word.name.lower()
        is_m = word.name == "M"
        functions = self._channel.m_functions if is_m else self._channel.h_functions
        if is_m and number in FLOW_FUNCTIONS:
            self._findings.report(PROGRAM_CONTROL_IN_CYCLE, word.span, word=name)
        elif number not in functions:
            self._findings.report(
                CYCLE_M_FUNCTION_NOT_DEFINED if is_m else CYCLE_H_FUNCTION_NOT_DEFINED,
                word.span,
                function=number,
            )
        elif functions[number].axis_name:
            self._findings.report(
                AXIS_FUNCTION_IN_CYCLE,
                word.span,
                word=name,
                axis=functions[number].axis_name,
                key=f"{letter}_default_outp_ax_name[{number}]",
            )
        elif word.additional is not None or word.arguments:
            written = self._findings.written(word.span)
            self._findings.report_support(
                support_level.form("M110=130, in cycles"), word.span, written
            )


def _moves_an_axis(word: BlockWord) -> bool:
    return isinstance(word, BracketCommand) and is_axis_command(word)


def _first_other(statement: If) -> Span:
    """Return the span of the first ``$ELSEIF`` or ``$ELSE`` of an ``$IF``."""
    if statement.elseifs:
        return statement.elseifs[0].span
    return statement.else_span or statement.span
