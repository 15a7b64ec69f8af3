# SPDX-License-Identifier: MIT
"""The forms of ``#`` commands of the main program.

In: ``#TIMER``, ``#FILENAME``, ``#CHANNEL INIT``, ``#BACKWARD STORAGE CLEAR``, ``#DISABLE MODAL
CYCLE``, ``#FGROUP``. Out: diagnostics.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.base.text import close_names
from nctakt.messages.checked_blocks import INVALID_COMMAND_FORM, UNKNOWN_COMMAND_OPTION
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.tree import Bracket, Expression, HashCommand, Keyword, Name, Timer
from nctakt.nc.vocabulary.command_forms import forms_of

_TIMER_ACTIONS = ("START", "STOP", "READ", "CLEAR")
_POSITIONS = ("CMDPOS", "ACTPOS")
_WITHOUT_ARGUMENTS = (("BACKWARD", "STORAGE", "CLEAR"), ("DISABLE", "MODAL", "CYCLE"))


class CommandChecker:
    """Checks the commands of one program; ``axes``: the names of the channel's."""

    def __init__(self, values: ValueChecker, axes: Sequence[str], findings: Findings) -> None:
        self._values = values
        self._axes = axes
        self._findings = findings

    def timer(self, timer: Timer) -> None:
        """Check ``#TIMER START|STOP|READ|CLEAR [SYN] [ID=…]``."""
        if timer.action not in _TIMER_ACTIONS:
            self._option("#TIMER", timer.action, _TIMER_ACTIONS, timer)
        for option in timer.options:
            if option.name != "SYN":
                self._option("#TIMER", option.text, ("SYN",), option)
        for item in timer.keywords:
            if isinstance(item, Keyword) and item.name == "ID" and item.value is not None:
                self._values.block(item.value)
            else:
                self._option("#TIMER", self._findings.written(item.span), ("ID",), item)

    def command(self, command: HashCommand, words: Sequence[str]) -> bool:
        """Check one of these commands; return false for any other."""
        if tuple(words) in (("FILENAME",), ("FILE", "NAME")):
            self._file(command)
        elif tuple(words) == ("CHANNEL", "INIT"):
            self._channel(command)
        elif tuple(words) == ("FGROUP",):
            self._feed_group(command)
        elif tuple(words) in _WITHOUT_ARGUMENTS:
            if command.arguments:
                name = "#" + " ".join(words)
                self._findings.report(
                    INVALID_COMMAND_FORM, command.span, command=name, forms=forms_of(name)
                )
        else:
            return False
        return True

    def _file(self, command: HashCommand) -> None:
        """Check ``#FILENAME [MSG=file]``."""
        items = self._items(command, "#FILENAME")
        for item in items:
            if not isinstance(item, Keyword) or item.name != "MSG" or item.value is None:
                self._option("#FILENAME", self._findings.written(item.span), ("MSG",), item)
            elif not isinstance(item.value, Name):
                self._values.text(item.value)

    def _channel(self, command: HashCommand) -> None:
        """Check ``#CHANNEL INIT [CMDPOS]``, also without brackets."""
        if not command.arguments:
            return
        for item in self._items(command, "#CHANNEL INIT"):
            if not isinstance(item, Keyword) or item.name not in _POSITIONS or item.value:
                self._option("#CHANNEL INIT", self._findings.written(item.span), _POSITIONS, item)

    def _feed_group(self, command: HashCommand) -> None:
        """Check ``#FGROUP [X, Y]``; without brackets it is that of the program start."""
        items = self._items(command, "#FGROUP") if command.arguments else ()
        for item in items:
            name = axis_name(item)
            if name not in self._axes:
                self._option("#FGROUP", self._findings.written(item.span), self._axes, item)

    def _items(self, command: HashCommand, name: str) -> tuple[Keyword | Expression, ...]:
        """Return the items of the command's only bracket; report any other form."""
        if len(command.arguments) == 1 and isinstance(command.arguments[0], Bracket):
            return command.arguments[0].items
        self._findings.report(
            INVALID_COMMAND_FORM, command.span, command=name, forms=forms_of(name)
        )
        return ()

    def _option(
        self, command: str, word: str, names: Sequence[str], node: Timer | Keyword | Expression
    ) -> None:
        near = close_names(word.upper(), names)
        order = [*near, *(name for name in names if name not in near)]
        listed = ", ".join(order)
        self._findings.report(
            UNKNOWN_COMMAND_OPTION, node.span, command=command, word=word, names=listed
        )


def axis_name(item: Keyword | Expression) -> str:
    """Return the name in an item of ``#FGROUP``, else an empty text."""
    if isinstance(item, Name) or (isinstance(item, Keyword) and item.value is None):
        return item.name
    return ""
