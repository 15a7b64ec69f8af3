# SPDX-License-Identifier: MIT
"""Entries that wait for the PLC of a channel: M, H and T functions, and jobs of its spindles.

In: the realtime part of a channel, its configuration. Out: entries as a PLC in Python meets them,
and where the interface of the controller shows them.
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.hli.function_codes import function_of
from nctakt.hli.function_units import Placed
from nctakt.hli.plc_entries import SpindleEntry, TechnologyEntry
from nctakt.kernel.axes.spindles import Spindles
from nctakt.kernel.plc.technology_slots import Hli
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.run.realtime.event_registry import EventRegistry


def waiting_functions(
    hli: Hli, parameters: ChannelParameters, cycle_time_us: int
) -> list[TechnologyEntry]:
    """Return the waiting functions, those of the main program first, in their order."""
    return [entry for entry, _ in _functions(hli, parameters, cycle_time_us)]


def _functions(
    hli: Hli, parameters: ChannelParameters, cycle_time_us: int
) -> Iterator[tuple[TechnologyEntry, int]]:
    """Yield the waiting functions with their units."""
    if not hli.waiting_count():
        return
    for section, is_realtime in ((hli.program, False), (hli.realtime, True)):
        for slot, function, sequence, tick, serial in section.entries():
            letter, number = function_of(function)
            parameter = parameters.function(letter, number)
            entry = TechnologyEntry(
                letter,
                number,
                sequence,
                tick * cycle_time_us,
                is_realtime,
                parameter.process_time_us,
                parameter.axis_name,
                slot,
                section.value_of(slot),
                serial,
                "MOS" if is_realtime else parameter.synchronisation,
            )
            yield entry, section.unit_of(slot)


def waiting_jobs(
    spindles: Spindles, registry: EventRegistry, cycle_time_us: int
) -> list[SpindleEntry]:
    """Return the jobs of spindles that the PLC turns, in the order of the channel list."""
    if not spindles.has_jobs():
        return []
    return [
        SpindleEntry(
            registry.spindle(spindles.first_number + index),
            function,
            speed_v / 6.0,
            position,
            sense,
            tick * cycle_time_us,
            before_v / 6.0,
            index,
            serial,
        )
        for index, function, speed_v, position, sense, tick, before_v, serial in spindles.jobs()
    ]


def placed_entries(
    hli: Hli,
    spindles: Spindles,
    parameters: ChannelParameters,
    registry: EventRegistry,
    cycle_time_us: int,
) -> list[Placed]:
    """Return all that waits, each with its unit of the interface."""
    jobs = waiting_jobs(spindles, registry, cycle_time_us)
    functions = _functions(hli, parameters, cycle_time_us)
    return [*functions, *((job, job.index) for job in jobs)]
