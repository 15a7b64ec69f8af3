# SPDX-License-Identifier: MIT
"""Signals and axes that the programs of several channels need from each other.

In: the signals and axes that all checked programs of a machine send, await, fetch and give. Out:
warnings for signals that none of them sends, and for axes of another channel that none of them
gives. A single program is not judged, since those of the other channels are not known. Computed
numbers fit any.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from nctakt.base.dataclass import dataclass
from nctakt.messages import Collector
from nctakt.messages.programs.lints import NO_PROGRAM_GIVES_AXIS, NO_PROGRAM_SENDS_SIGNAL
from nctakt.nc.outline import AxisUse, SignalUse


@dataclass(frozen=True, slots=True)
class ProgramUses:
    """The uses of one program in a channel of the machine of this folder.

    ``owners``: logical numbers of axes -> the channel whose list has them; ``own_names``: the axes
    of the channel's list with their numbers. ``is_main``: it may run on its own.
    """

    file: str
    machine: Path
    channel: int
    channel_count: int
    owners: dict[int, int]
    own_names: dict[str, int]
    signals: Sequence[SignalUse]
    exchanges: Sequence[AxisUse]
    is_main: bool


def report_missing_partners(programs: Sequence[ProgramUses], collector: Collector) -> None:
    """Report each signal and axis that a program waits for and that no other sends or gives."""
    for machine in dict.fromkeys(program.machine for program in programs):
        of_machine = [program for program in programs if program.machine == machine]
        mains = dict.fromkeys(program.file for program in of_machine if program.is_main)
        if of_machine[0].channel_count > 1 and len(mains) > 1:
            _report_signals(of_machine, collector)
            _report_axes(of_machine, collector)


def _report_signals(programs: Sequence[ProgramUses], collector: Collector) -> None:
    uses = [use for program in programs for use in program.signals]
    sent = {use.number for use in uses if not use.is_wait}
    for use in uses if None not in sent else ():
        if use.is_wait and use.number is not None and use.number not in sent:
            collector.report(NO_PROGRAM_SENDS_SIGNAL, use.span, use.line, id=use.number)


def _report_axes(programs: Sequence[ProgramUses], collector: Collector) -> None:
    for program in programs:
        for use in program.exchanges:
            for number in use.fetched:
                owner = program.owners.get(number or 0, program.channel)
                if owner == program.channel or number is None:
                    continue
                if not any(_gives(other, number) for other in programs):
                    collector.report(
                        NO_PROGRAM_GIVES_AXIS, use.span, use.line, number=number, channel=owner
                    )


def _gives(program: ProgramUses, number: int) -> bool:
    """Return whether a program may give the axis with a logical number."""
    for use in program.exchanges:
        if use.gives_others and number not in use.fetched:
            return True
        if number in use.given_numbers or None in use.given_numbers:
            return True
        if any(program.own_names.get(name, number) == number for name in use.given_names):
            return True
    return False
