# SPDX-License-Identifier: MIT
"""The forms of ``#`` commands of the main program.

In: ``#TIMER``, ``#FILENAME``, ``#CHANNEL INIT``, ``#BACKWARD STORAGE CLEAR``, ``#DISABLE MODAL
CYCLE``, ``#FGROUP`` of the axes that F has anyway. Out: diagnostics.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nctakt.base.text import close_names
from nctakt.messages.checked_blocks import INVALID_COMMAND_FORM, UNKNOWN_COMMAND_OPTION
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.tree import Bracket, Expression, HashCommand, Keyword, Name, Timer
from nctakt.nc.vocabulary import support_level
from nctakt.nc.vocabulary.command_forms import forms_of
from nctakt.nc.vocabulary.entries import Support
from nctakt.nc.vocabulary.variable_table import NameTable

_TIMER_ACTIONS = ("START", "STOP", "READ", "CLEAR")
_POSITIONS = ("CMDPOS", "ACTPOS")
_WITHOUT_ARGUMENTS = (("BACKWARD", "STORAGE", "CLEAR"), ("DISABLE", "MODAL", "CYCLE"))


class CommandChecker:
    """Checks the commands of one program; ``axes``: the names of the channel's."""

    def __init__(
        self, values: ValueChecker, names: NameTable, axes: Sequence[str], findings: Findings
    ) -> None:
        self._values = values
        self._names = names
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
        elif tuple(words) == ("FGROUP",) and _names_feed_axes(command, self._names, self._axes):
            entry = support_level.hash_command(words)
            assert entry is not None
            self._findings.report_support(replace(entry, support=Support.ACCEPTED), command.span)
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


def _names_feed_axes(command: HashCommand, names: NameTable, axes: Sequence[str]) -> bool:
    """Return whether ``#FGROUP`` names just the axes that F refers to anyway.

    These are the linear ones of the channel's ``axes``, or all of them where none is linear.
    Without names the command restores them.
    """
    if not command.arguments:
        return True
    if len(command.arguments) > 1 or not isinstance(command.arguments[0], Bracket):
        return False
    items = command.arguments[0].items
    named = [
        item.name
        for item in items
        if isinstance(item, Name) or (isinstance(item, Keyword) and item.value is None)
    ]
    traits = {axis: names.axis(axis) for axis in axes}
    linear = [axis for axis, found in traits.items() if found is not None and found.is_linear]
    return len(named) == len(items) and sorted(named) == sorted(linear or axes)
