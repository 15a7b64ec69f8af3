# SPDX-License-Identifier: MIT
"""``#SIGNAL`` and ``#WAIT``: signals between channels, waits of the decoder.

In: the tree of a command. Out: diagnostics for other forms. Values that are not constant
are checked when they are decoded.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.base.diagnostics import Span, Text
from nctakt.base.misspelling import nearest_first
from nctakt.base.whole_numbers import is_whole
from nctakt.messages.programs.checked_blocks import (
    INVALID_COMMAND_FORM,
    UNKNOWN_COMMAND_OPTION,
    WORD_VALUE_MISSING,
)
from nctakt.messages.programs.signals import (
    AHEAD_TAKES_SIGNAL_EARLY,
    INVALID_SIGNAL_CHANNEL,
    INVALID_SIGNAL_NUMBER,
    SIGNAL_FORM,
    SIGNAL_NUMBER_MISSING,
    SIGNAL_NUMBER_TWICE,
    SIGNAL_TARGET,
    WAIT_SYN_WITH_VALUES,
)
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.meaning.signals import (
    MAX_CHANNEL,
    MAX_SIGNAL,
    action_of,
    axis_name,
    items_of,
    signal_command,
)
from nctakt.nc.outline import SignalUse
from nctakt.nc.tree import (
    Bracket,
    Expression,
    HashCommand,
    Keyword,
    Number,
    Parameter,
    Variable,
)
from nctakt.nc.vocabulary.commands import forms_of

_END_OF_BLOCK = Text("the end of the block", "das Satzende")

_ACTIONS = ("SIGNAL", "WAIT", "SIGNAL READ", "SIGNAL REMOVE")
_KEYWORDS = {
    "SIGNAL": ("ID", "COUNT", "P", "CH"),
    "WAIT": ("ID", "P", "CH", "AHEAD"),
    "SIGNAL READ": ("ID", "P", "CH"),
    "SIGNAL REMOVE": ("ID", "IDMIN", "IDMAX", "CH"),
}
_ONCE = ("ID", "COUNT", "IDMIN", "IDMAX")


def is_in_block_order(command: HashCommand) -> bool:
    """Return whether it is ``#SIGNAL SYN`` or ``#WAIT SYN``."""
    return action_of(command) in ("SIGNAL", "WAIT") and command.words[-1].name == "SYN"


def constant(expression: Expression | None) -> int | None:
    """Return a literal as a whole number; ``None`` for anything else."""
    if isinstance(expression, Number) and expression.value == int(expression.value):
        return int(expression.value)
    return None


class SignalChecker:
    """Checks the commands of one program; ``uses``: the signals it sends and awaits."""

    def __init__(self, values: ValueChecker, axes: Sequence[str], findings: Findings) -> None:
        self._values = values
        self._axes = axes
        self._findings = findings
        self._uses: list[SignalUse] = []

    def take(self) -> list[SignalUse]:
        """Return the uses since the last call of this method."""
        taken, self._uses = self._uses, []
        return taken

    def command(self, command: HashCommand) -> bool:
        """Check one of these commands; return false for any other."""
        words = [word.name for word in command.words]
        if words[0] not in ("SIGNAL", "WAIT"):
            return False
        if words == ["WAIT", "FOR"]:
            self._condition(command)
        elif words[:2] == ["WAIT", "INDP"]:
            self._axes_of(command, words)
        else:
            self._signal(command)
        return True

    def _condition(self, command: HashCommand) -> None:
        """Check ``#WAIT FOR <expression>``."""
        if len(command.arguments) == 1 and isinstance(command.arguments[0], Expression):
            self._values.block(command.arguments[0])
        else:
            self._misformed(command, "#WAIT FOR")

    def _axes_of(self, command: HashCommand, words: list[str]) -> None:
        """Check ``#WAIT INDP [X, Y]`` and ``#WAIT INDP ALL``."""
        if words == ["WAIT", "INDP", "ALL"] and not command.arguments:
            return
        items = list(items_of(command))
        if words != ["WAIT", "INDP"] or len(command.arguments) != 1 or not items:
            self._misformed(command, "#WAIT INDP")
            return
        for item in items:
            if axis_name(item) not in self._axes:
                written = self._findings.written(item.span)
                self._option("#WAIT INDP", written, self._axes, item.span)

    def _misformed(self, command: HashCommand, name: str) -> None:
        forms = forms_of(name)
        self._findings.report(INVALID_COMMAND_FORM, command.span, command=name, forms=forms)

    def _signal(self, command: HashCommand) -> None:
        action = action_of(command)
        assert action in _ACTIONS
        name = f"#{action}"
        rest = command.words[len(action.split()) :]
        wrong = next((word for word in rest if word.name != "SYN"), None)
        if wrong is not None or len(rest) > 1:
            span = (wrong or rest[-1]).span
            self._form(name, self._findings.written(span), span)
            return
        if len(command.arguments) != 1 or not isinstance(command.arguments[0], Bracket):
            arguments = command.arguments
            found = self._findings.written(arguments[0].span) if arguments else _END_OF_BLOCK
            self._form(" ".join((name, *(word.name for word in rest))), found, command.span)
            return
        if self._keywords(action, name, command) and self._meaning(action, name, command):
            self._note_use(action, command)

    def _form(self, name: str, found: object, span: Span) -> None:
        forms = forms_of(name.removesuffix(" SYN"))
        self._findings.report(SIGNAL_FORM, span, command=name, found=found, forms=forms)

    def _keywords(self, action: str, name: str, command: HashCommand) -> bool:
        """Check each item in the brackets; return whether all are in order."""
        seen: dict[str, None] = {}
        is_right = True
        for item in items_of(command):
            if not isinstance(item, Keyword) or item.name not in _KEYWORDS[action]:
                written = self._findings.written(item.span)
                self._option(name, written, _KEYWORDS[action], item.span)
                is_right = False
            elif item.name in _ONCE and item.name in seen:
                self._findings.report(
                    SIGNAL_NUMBER_TWICE, item.span, keyword=item.name, command=name
                )
                is_right = False
            elif item.name == "AHEAD" and item.value is None:
                self._findings.report_once(AHEAD_TAKES_SIGNAL_EARLY, item.span)
            elif item.name == "P":
                is_right &= self._parameter(action, name, item)
            elif item.value is None:
                self._findings.report(WORD_VALUE_MISSING, item.span, word=item.name)
                is_right = False
            else:
                self._values.block(item.value)
            if isinstance(item, Keyword):
                seen[item.name] = None
        return is_right

    def _parameter(self, action: str, name: str, item: Keyword) -> bool:
        """Check ``P[0]=value`` of a signal, or ``P[0]=target`` of a wait."""
        if item.value is None or not item.arguments:
            self._findings.report(WORD_VALUE_MISSING, item.span, word="P[0]")
            return False
        index = item.arguments[0]
        assert isinstance(index, Expression)
        self._values.block(index)
        if action == "SIGNAL":
            self._values.block(item.value)
        elif isinstance(item.value, Variable | Parameter):
            self._values.write(item.value)
        else:
            self._findings.report(SIGNAL_TARGET, item.value.span, command=name)
            return False
        return True

    def _meaning(self, action: str, name: str, command: HashCommand) -> bool:
        """Check the items as a whole; return whether they are right."""
        parsed = signal_command(command)
        number = parsed.numbers.get("ID", parsed.numbers.get("IDMIN"))
        if number is None:
            self._findings.report(SIGNAL_NUMBER_MISSING, command.span, command=name)
            return False
        if parsed.is_synchronous and action == "SIGNAL READ":
            self._findings.report(WAIT_SYN_WITH_VALUES, command.words[-1].span, command=name)
            return False
        if parsed.is_synchronous and action == "WAIT" and parsed.parameters:
            self._findings.report(WAIT_SYN_WITH_VALUES, parsed.parameters[0][1].span, command=name)
            return False
        for value in (value for key, value in parsed.numbers.items() if key != "COUNT"):
            if isinstance(value, Number) and not is_whole(value.value, 1, MAX_SIGNAL):
                self._findings.report(
                    INVALID_SIGNAL_NUMBER, value.span, value=value.value, highest=MAX_SIGNAL
                )
                return False
        for channel in parsed.channels:
            if isinstance(channel, Number) and not is_whole(channel.value, 1, MAX_CHANNEL):
                self._findings.report(
                    INVALID_SIGNAL_CHANNEL, channel.span, value=channel.value, highest=MAX_CHANNEL
                )
                return False
        return True

    def _note_use(self, action: str, command: HashCommand) -> None:
        """Note the signals sent or awaited."""
        if action not in ("SIGNAL", "WAIT"):
            return
        parsed = signal_command(command)
        numbers = [constant(channel) for channel in parsed.channels]
        channels = tuple(number for number in numbers if number is not None)
        is_known = len(channels) == len(numbers)
        self._uses.append(
            SignalUse(
                action == "WAIT",
                constant(parsed.numbers["ID"]),
                channels if is_known else None,
                command.span,
                self._findings.line_of(command.span),
            )
        )

    def _option(self, command: str, word: str, names: Sequence[str], span: Span) -> None:
        listed = ", ".join(nearest_first(word, names))
        self._findings.report(
            UNKNOWN_COMMAND_OPTION, span, command=command, word=word, names=listed
        )
