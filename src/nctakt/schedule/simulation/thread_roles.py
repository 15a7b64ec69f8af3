# SPDX-License-Identifier: MIT
"""Which threads of a list work for a controller.

In: the list, its model, the contexts of the channels. Out: ``ThreadRoles``; mistakes that leave a
controller without decoder, interpolation or a common tick go to the collector. A channel's threads
are those with its contexts (P-RTCF-00017 with P-CHAN-00410 and 00411), else all with the function.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.base.dataclass import dataclass
from nctakt.lists.declared.rtconf import REALTIME_FUNCTION, RtconfConfiguration
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.messages import Collector
from nctakt.messages.scheduling.scheduled_runs import (
    NO_COMMON_TICK,
    REQUIRED_FUNCTION_NOT_CALLED,
    UNKNOWN_PLC_THREAD,
)
from nctakt.schedule.model import Model, TaskClass
from nctakt.schedule.simulation.ticks import DECODER_FUNCTION, ThreadRoles


@dataclass(frozen=True, slots=True)
class _Lists:
    configuration: RtconfConfiguration
    model: Model

    def with_function(self, function: str, context: int) -> tuple[int, ...]:
        """Return the threads that call a function: those of the context, else all."""
        threads = self.configuration.threads
        callers = [
            i
            for i, task in enumerate(self.model.tasks[: len(threads)])
            if any(call.function == function for call in task.calls)
        ]
        own = tuple(i for i in callers if threads[i].context == context)
        return own or tuple(callers)

    def interpolators(self, context: int) -> tuple[int, ...]:
        """Return the threads of the interpolation: with ``task_int``, else the most urgent."""
        callers = self.with_function(REALTIME_FUNCTION, context)
        tasks = enumerate(self.model.tasks)
        return callers or tuple(
            i for i, task in tasks if task.kind is TaskClass.REALTIME and task.calls
        )


def find_thread_roles(
    configuration: RtconfConfiguration,
    model: Model,
    channels: Sequence[ChannelParameters],
    plc: str | None,
    collector: Collector,
) -> ThreadRoles | None:
    """Return the roles; ``None`` after errors. ``plc``: its semaphore, if the load names it."""
    lists = _Lists(configuration, model)
    found = Collector()
    interpolators: dict[int, None] = {}
    decoders: dict[tuple[int, ...], list[int]] = {}
    for index, channel in enumerate(channels):
        interpolators |= dict.fromkeys(lists.interpolators(channel.context_geo))
        threads = lists.with_function(DECODER_FUNCTION, channel.context_sda)
        decoders.setdefault(threads, []).append(index)
    if not interpolators:
        found.report(REQUIRED_FUNCTION_NOT_CALLED, None, function=REALTIME_FUNCTION)
    if () in decoders:
        found.report(REQUIRED_FUNCTION_NOT_CALLED, None, function=DECODER_FUNCTION)
    periods = {model.tasks[i].every for i in interpolators}
    if len(periods) > 1:
        names = ", ".join(model.tasks[i].name for i in interpolators)
        found.report(NO_COMMON_TICK, None, threads=names)
    plc_thread = _plc(model, plc, found)
    collector.diagnostics += found.diagnostics
    if found.has_errors:
        return None
    groups = tuple((threads, tuple(own)) for threads, own in decoders.items())
    return ThreadRoles(periods.pop(), tuple(interpolators), groups, plc_thread)


def _plc(model: Model, name: str | None, collector: Collector) -> int | None:
    """Return the external thread that is the PLC: the one that the load names, else the first."""
    external = [i for i, task in enumerate(model.tasks) if task.kind is TaskClass.EXTERNAL]
    if name is None:
        return external[0] if external else None
    for i in external:
        if model.tasks[i].name == name:
            return i
    names = ", ".join(model.tasks[i].name for i in external)
    collector.report(UNKNOWN_PLC_THREAD, None, name=name, names=names or "–")
    return None
