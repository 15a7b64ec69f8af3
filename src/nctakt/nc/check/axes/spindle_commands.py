# SPDX-License-Identifier: MIT
"""Commands to spindles: words that exclude or need each other (RC-404).

In: a ``SpindleCommand``. Out: diagnostics. The main program may give speed, direction and position
in several blocks; a realtime cycle gives a whole job in one.
"""

from __future__ import annotations

from nctakt.base.diagnostics import NOTHING
from nctakt.base.misspelling import nearest
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.messages.axes.spindles import (
    EXCLUSIVE_SPINDLE_WORDS,
    NO_MAIN_SPINDLE,
    NOT_A_SPINDLE_WORD,
    SPINDLE_EXCHANGE_NOT_ALONE,
    SPINDLE_POSITION_WITHOUT_M19,
    SPINDLE_WORD_COUNT,
)
from nctakt.messages.programs.checked_cycles import DUPLICATE_KEYWORD
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.outline import AxisUse
from nctakt.nc.tree import BlockWord, Expression, Keyword, Number
from nctakt.nc.vocabulary import support_level
from nctakt.nc.vocabulary.functions import (
    CLOCKWISE,
    COUNTERCLOCKWISE,
    HOMING,
    SPINDLE_FUNCTIONS,
    SPINDLE_POSITION,
    SPINDLE_STOP,
)
from nctakt.nc.vocabulary.spindle_commands import CALLAX, PUTAX, SpindleCommand

#: Words of a command to a spindle, for suggestions.
WORDS = (
    *(f"M{number}" for number in SPINDLE_FUNCTIONS),
    "S",
    "REV",
    "S.POS",
    "POS",
    "G167",
    CALLAX,
    PUTAX,
)


class SpindleChecker:
    """Checks commands to the spindles of one channel; ``in_cycle``: those of realtime cycles."""

    def __init__(
        self,
        channel: ChannelParameters,
        values: ValueChecker,
        findings: Findings,
        *,
        in_cycle: bool,
    ) -> None:
        self._has_main = any(spindle.is_main for spindle in channel.spindles)
        self._values = values
        self._findings = findings
        self._in_cycle = in_cycle
        self._spindles = channel.spindles
        self._uses: list[AxisUse] = []

    def take(self) -> list[AxisUse]:
        """Return the axes that spindles fetched or gave since the last call of this method."""
        taken, self._uses = self._uses, []
        return taken

    def check(self, command: SpindleCommand) -> None:
        """Check one command."""
        if not command.name and not self._has_main:
            self._findings.report(NO_MAIN_SPINDLE, command.span)
        refused = [(form, word) for word in command.wrong if (form := _refused_form(word))]
        for form, word in refused:
            shown = form.replace("S", command.name or "S", 1)
            self._findings.report_support(support_level.form(form), word.span, shown)
        # The rest of the brackets of a refused word belongs to it.
        for word in () if refused else command.wrong:
            self._not_a_word(command, word)
        for doubled in command.doubled:
            self._findings.report(
                DUPLICATE_KEYWORD,
                doubled.span,
                command=f"{command.name or 'S'}[…]",
                word=self._findings.written(doubled.span),
            )
        for value in (command.speed, command.position):
            if value is not None:
                self._values.value(value)
        if command.override is not None and command.override.value is not None:
            self._values.value(command.override.value)
            if not self._in_cycle:
                return
        if command.wrong or command.doubled:
            return
        if not self._in_cycle:
            self._fit(command)
        elif not self._is_job(command):
            self._findings.report(
                SPINDLE_WORD_COUNT, command.span, command=self._findings.written(command.span)
            )

    def _not_a_word(self, command: SpindleCommand, word: BlockWord | Keyword | Expression) -> None:
        """Report an item that a spindle command cannot have, and suggest the intended one."""
        written = self._findings.written(word.span)
        if written in (CALLAX, PUTAX):
            suggestion = f"{command.name}[{written}]"
        elif written in WORDS:
            suggestion = f"{written}=…"
        else:
            suggestion = nearest(written, WORDS) or NOTHING
        self._findings.report(NOT_A_SPINDLE_WORD, word.span, word=written, nearest=suggestion)

    def _fit(self, command: SpindleCommand) -> None:
        """Check that the words of a command of the main program fit together."""
        turns = [
            function for function in command.functions if function in (CLOCKWISE, COUNTERCLOCKWISE)
        ]
        if command.exchanges:
            self._fit_exchange(command)
        elif len(turns) > 1 or (SPINDLE_STOP in command.functions and len(command.functions) > 1):
            words = ", ".join(f"M{function}" for function in command.functions)
            self._findings.report(EXCLUSIVE_SPINDLE_WORDS, command.span, words=words)
        elif command.position is not None and SPINDLE_POSITION not in command.functions:
            self._findings.report(SPINDLE_POSITION_WITHOUT_M19, command.position.span)
        elif not (command.functions or command.speed is not None or command.ignores_override):
            self._findings.report(
                SPINDLE_WORD_COUNT, command.span, command=self._findings.written(command.span)
            )

    def _fit_exchange(self, command: SpindleCommand) -> None:
        """Check that an exchange of the axis is alone in its brackets."""
        values = (command.speed, command.position)
        has_others = command.functions or command.ignores_override or any(map(bool, values))
        if has_others or len(command.exchanges) > 1:
            self._findings.report(
                SPINDLE_EXCHANGE_NOT_ALONE, command.span, word=command.exchanges[0]
            )
            return
        number = self._number(command.name)
        numbers = () if number is None else (number,)
        fetched, given = ((), numbers) if command.exchanges == [PUTAX] else (numbers, ())
        line = self._findings.line_of(command.span)
        self._uses.append(AxisUse(fetched, (), given, False, (), command.span, line))

    def _number(self, name: str) -> int | None:
        """Return the logical number of a spindle of the list; ``None`` for an unknown one.

        Without a name it is the main spindle of the list; ``#MAIN SPINDLE`` is not looked at.
        """
        for spindle in self._spindles:
            is_named = name in (spindle.name, spindle.list_name)
            if not spindle.plc_controlled and (is_named if name else spindle.is_main):
                return spindle.logical_number
        return None

    def _is_job(self, command: SpindleCommand) -> bool:
        """Return whether they are a complete job: turn, position, or stop."""
        if command.ignores_override:
            return False
        functions = sorted(command.functions)
        has_values = (command.speed is not None, command.position is not None)
        if functions == [SPINDLE_STOP]:
            return has_values == (False, False)
        if len(functions) == 1:
            return functions[0] != SPINDLE_POSITION and has_values == (True, False)
        turns = functions[:1] in ([CLOCKWISE], [COUNTERCLOCKWISE])
        return turns and functions[1:] == [SPINDLE_POSITION] and has_values == (True, True)


def _refused_form(word: BlockWord | Keyword | Expression) -> str:
    """Return the form of a known word of spindle commands; empty for any other word."""
    if not isinstance(word, Keyword):
        return ""
    if word.name == "FEED_LINK":
        return "S[FEED_LINK …]"
    is_homing = isinstance(word.value, Number) and word.value.value == HOMING
    return "S[G74]" if word.name == "G" and is_homing else ""
