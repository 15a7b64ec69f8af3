# SPDX-License-Identifier: MIT
"""``#CALL AX``, ``#PUT AX``, ``#SET AX``, ``#AX REQUEST``, ``#AX RELEASE``, ``#AX DEF``, ``#CAX``.

In: the tree of a command. Out: the uses for checks across programs, and diagnostics for other
forms. The names of fetched axes are known from the command on. Values that
are not constant are checked when they are decoded.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.base.diagnostics import NOTHING, Text
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.messages.axes.axis_exchange import AXIS_OPTION_REFUSED, UNSUITABLE_AXIS_NAME
from nctakt.messages.axes.c_axis import NO_NAME_OF_C_AXIS, NOT_THE_MAIN_SPINDLE
from nctakt.messages.path.rotating_planes import NO_C_AXIS
from nctakt.messages.programs.checked_blocks import INVALID_COMMAND_FORM
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.check.signals import constant
from nctakt.nc.meaning.axes import (
    EXCHANGE_ACTIONS,
    ExchangeCommand,
    c_axis_command,
    exchange_command,
    is_c_axis,
    is_exchange,
)
from nctakt.nc.outline import AxisUse
from nctakt.nc.parse.block_words import AXIS_LETTERS
from nctakt.nc.tree import Bracket, HashCommand
from nctakt.nc.vocabulary.commands import forms_of
from nctakt.nc.vocabulary.variables.variable_table import NameTable

_MEANING = Text(
    "the command waits until path and axes are at rest and no other channel has the axes; "
    "offsets of an exchanged axis begin at 0",
    "der Befehl wartet, bis Bahn und Achsen stehen und kein anderer Kanal die Achsen hat; "
    "Verschiebungen einer getauschten Achse beginnen bei 0",
)


class ExchangeChecker:
    """Checks the commands of one program; adds fetched axes to ``axes`` and ``names``."""

    def __init__(
        self,
        channel: ChannelParameters,
        names: NameTable,
        axes: list[str],
        values: ValueChecker,
        findings: Findings,
    ) -> None:
        self._channel = channel
        self._names = names
        self._axes = axes
        self._values = values
        self._findings = findings
        self._uses: list[AxisUse] = []
        for name in names.fetched:
            self._learn(name, None)

    @property
    def fetched(self) -> tuple[tuple[str, int | None], ...]:
        """The names of fetched axes with their numbers."""
        return tuple(self._names.fetched.items())

    def resume(self, fetched: Sequence[tuple[str, int | None]]) -> None:
        """Know these names of fetched axes."""
        for name, number in fetched:
            self._learn(name, number)

    def take(self) -> list[AxisUse]:
        """Return the uses since the last call of this method."""
        taken, self._uses = self._uses, []
        return taken

    def command(self, command: HashCommand) -> bool:
        """Check one of these commands; return false for any other."""
        if is_c_axis(command):
            name = check_c_axis(command, self._channel, self._names, self._findings)
            self._axes += [name] if name and name not in self._axes else []
            return True
        if not is_exchange(command):
            return False
        name = f"#{EXCHANGE_ACTIONS[tuple(word.name for word in command.words)]}"
        parsed = exchange_command(command)
        if parsed is None:
            self._findings.report(
                INVALID_COMMAND_FORM, command.span, command=name, forms=forms_of(name)
            )
            return True
        self._findings.report_simplified("#CALL AX, #PUT AX, #SET AX, #AX", _MEANING, command.span)
        for one in command.arguments:
            assert isinstance(one, Bracket)
            for item in one.items[3:] if parsed.fetched else ():
                written = self._findings.written(item.span)
                self._findings.report(AXIS_OPTION_REFUSED, item.span, option=written)
        for axis in parsed.fetched:
            self._values.block(axis.number)
            self._values.block(axis.slot)
            if axis.name[0] not in AXIS_LETTERS:
                self._findings.report(UNSUITABLE_AXIS_NAME, axis.span, name=axis.name)
            else:
                self._learn(axis.name, constant(axis.number))
        for number in parsed.numbers:
            self._values.block(number)
        self._note(parsed, command)
        return True

    def _learn(self, name: str, number: int | None) -> None:
        self._names.learn_axis(name, number)
        if name not in self._axes:
            self._axes.append(name)

    def _note(self, parsed: ExchangeCommand, command: HashCommand) -> None:
        """Note the use for checks across programs."""
        fetched = tuple(constant(axis.number) for axis in parsed.fetched)
        numbers = tuple(constant(number) for number in parsed.numbers)
        gives_all = parsed.is_all or not parsed.keeps_others
        line = self._findings.line_of(command.span)
        names = tuple((axis.name, constant(axis.number)) for axis in parsed.fetched)
        self._uses.append(
            AxisUse(fetched, parsed.names, numbers, gives_all, names, command.span, line)
        )


_C_AXIS_MEANING = Text(
    "the spindle stops, and its axis takes the first free index from 3 on, at the spindle's "
    "angle; #CAX OFF or the next program ends it",
    "die Spindel hält an, und ihre Achse bekommt den ersten freien Index ab 3, im Winkel der "
    "Spindel; #CAX OFF oder das nächste Programm beendet es",
)


def check_c_axis(
    command: HashCommand,
    channel: ChannelParameters,
    names: NameTable,
    findings: Findings,
) -> str:
    """Check the command; return the name of the axis that the channel has then, or nothing."""
    parsed = c_axis_command(command)
    if parsed is None:
        findings.report(INVALID_COMMAND_FORM, command.span, command="#CAX", forms=forms_of("#CAX"))
        return ""
    if not parsed.is_on:
        return ""
    main = next((one for one in channel.spindles if one.is_main), None)
    if parsed.spindle and (main is None or parsed.spindle not in (main.name, main.list_name)):
        known = NOTHING if main is None else main.name
        findings.report(NOT_THE_MAIN_SPINDLE, command.span, spindle=parsed.spindle, main=known)
        return ""
    if main is None or main.plc_controlled or not names.can_fetch(main.logical_number):
        findings.report(NO_C_AXIS, command.span, command="#CAX")
        return ""
    name = parsed.name or channel.c_axis_name
    if not name:
        findings.report(NO_NAME_OF_C_AXIS, command.span)
        return ""
    if name[0] not in AXIS_LETTERS:
        findings.report(UNSUITABLE_AXIS_NAME, command.span, name=name)
        return ""
    findings.report_simplified("#CAX", _C_AXIS_MEANING, command.span)
    names.learn_axis(name, main.logical_number)
    return name
