# SPDX-License-Identifier: MIT
"""Programs that wait for axes of other channels: for whom, and which line would free them.

In: the channels of a machine, and the axes that its programs fetch and give (``AxisUse``). Out:
texts for ``deadlocks.py``, and before the first tick a warning for each axis that no program gives.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from nctakt.base.diagnostics import Diagnostic, Text
from nctakt.messages import diagnostic
from nctakt.messages.axes.axis_exchange import AXIS_NEVER_GIVEN
from nctakt.nc.outline import AxisUse
from nctakt.run.program_loader import LoadedProgram
from nctakt.run.realtime.assembly import AssembledMachine

_NOT_GIVEN = Text(
    "No program of this run gives it: program {command} in channel {channel}.",
    "Kein Programm dieses Laufs gibt sie ab: {command} in Kanal {channel} programmieren.",
)
_GIVEN_BY_WAITING = Text(
    "Line {line} of {file} in channel {channel} would free it, but channel {channel} waits, too.",
    "Zeile {line} von {file} in Kanal {channel} würde ihn befreien, doch Kanal {channel} wartet "
    "auch.",
)
_GIVEN_BY_ENDED = Text(
    "Line {line} of {file} in channel {channel} gives it, but it does not run any more.",
    "Zeile {line} von {file} in Kanal {channel} gibt sie ab, doch es läuft nicht mehr.",
)
_AWAITED = Text("axis {axis}, which channel {channel} has", "Achse {axis}, die Kanal {channel} hat")


def seconds_text(time_us: int) -> str:
    """Return a time in microseconds as text in seconds."""
    return f"{time_us / 1_000_000:.6f} s"


def awaited_axes(machine: AssembledMachine, index: int) -> Text:
    """Return the axes that a channel waits for, and who has them; since when."""
    exchange = machine.channels[index].exchange
    since = seconds_text(exchange.awaited_since()[1] * machine.configuration.cycle_time_us)
    parts = [(machine.registry.axis(axis), exchange.holder(axis)) for axis in exchange.missing()]
    english = " and ".join(_AWAITED.en.format(axis=name, channel=n) for name, n in parts)
    german = " und ".join(_AWAITED.de.format(axis=name, channel=n) for name, n in parts)
    return Text(f"{english} (since {since})", f"{german} (seit {since})")


def axes_freed_by(machine: AssembledMachine, programs: Sequence[LoadedProgram], index: int) -> Text:
    """Return the line that gives the first axis that a channel waits for, or that there is none."""
    exchange = machine.channels[index].exchange
    axis = exchange.missing()[0]
    holder = exchange.holder(axis)
    for channel, use in _uses(programs):
        if channel == holder and _gives(machine, channel, use, axis):
            is_waiting = machine.channels[holder - 1].panel.is_running
            text = _GIVEN_BY_WAITING if is_waiting else _GIVEN_BY_ENDED
            values = {"line": use.span.line, "file": use.span.file, "channel": holder}
            return Text(text.en.format(**values), text.de.format(**values))
    command = _giving(machine, axis)
    values = {"channel": holder, "command": command}
    return Text(_NOT_GIVEN.en.format(**values), _NOT_GIVEN.de.format(**values))


def _giving(machine: AssembledMachine, axis: int) -> str:
    """Return the command by which the channel that has an axis gives it."""
    logical = machine.configuration.axes[axis].logical_number
    holder = machine.channels[0].exchange.holder(axis)
    if logical in machine.realtime.spindles and axis not in machine.members_of(holder - 1):
        return f"{machine.realtime.spindles[logical][0]}[PUTAX]"
    return "#PUT AX"


def never_given(machine: AssembledMachine, programs: Sequence[LoadedProgram]) -> list[Diagnostic]:
    """Return a warning for each command that fetches an axis of a channel that never gives it."""
    uses = list(_uses(programs))
    by_number = {
        axis.logical_number: index for index, axis in enumerate(machine.configuration.axes)
    }
    found = []
    for channel, use in uses:
        for number in use.fetched:
            if number not in by_number:
                continue
            axis = by_number[number]
            holder = _first_holder(machine, {program.channel for program in programs}, axis)
            if holder in (0, channel):
                continue
            if not any(own == holder and _gives(machine, own, one, axis) for own, one in uses):
                values = {"number": number, "channel": holder, "command": _giving(machine, axis)}
                found.append(diagnostic(AXIS_NEVER_GIVEN, use.span, use.line, **values))
    return found


def _first_holder(machine: AssembledMachine, running: set[int], axis: int) -> int:
    """Return the channel that has an axis when these channels have begun their programs; 0: none.

    Each of them begins with the axes of its list.
    """
    for index in sorted(running):
        own = machine.configuration.channels[index]
        if axis in (*(one.index for one in own.axes), *(one.index for one in own.spindles)):
            return index + 1
    holder = machine.channels[0].exchange.holder(axis)
    return 0 if holder - 1 in running else holder


def _uses(programs: Sequence[LoadedProgram]) -> Iterator[tuple[int, AxisUse]]:
    """Yield the axes that the programs fetch and give, with the number of the channel."""
    for program in programs:
        for text in program.texts:
            for use in text.exchanges:
                yield program.channel + 1, use


def _gives(machine: AssembledMachine, channel: int, use: AxisUse, axis: int) -> bool:
    """Return whether a command of a channel may give an axis of the machine."""
    configuration = machine.configuration
    number = configuration.axes[axis].logical_number
    if use.gives_others:
        return number not in use.fetched
    if number in use.given_numbers or None in use.given_numbers:
        return True
    listed = {one.name: one.index for one in configuration.channels[channel - 1].axes}
    return any(listed.get(name, axis) == axis for name in use.given_names)
