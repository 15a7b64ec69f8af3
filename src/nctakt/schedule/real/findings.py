# SPDX-License-Identifier: MIT
"""Diagnostics of a run: its end, and resources that the system refused.

In: ``RunLog``, ``Measurement``. Out: diagnostics; those that a simulation shares are in
``schedule.analysis.findings``.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from nctakt.base.diagnostics import Diagnostic
from nctakt.messages import diagnostic
from nctakt.messages.scheduling.linux_run import (
    LATE_WAKEUPS,
    NOBODY_WAITS,
    POSTS_CEASED,
    POSTS_DRAINED,
    SCHEDULE_RECORDING_FULL,
    SCHEDULE_RUN_STOPPED,
)
from nctakt.schedule.analysis.findings import is_rare, us
from nctakt.schedule.real import area as layout
from nctakt.schedule.real.measure import Measurement, late_wakes
from nctakt.schedule.real.run import RunLog, placement_refusals

#: Periods without a post after which a semaphore counts as silent.
_SILENT_PERIODS = 4


def run_findings(log: RunLog, measurement: Measurement, requested: int) -> Iterator[Diagnostic]:
    """Yield the diagnostics of a run; ``requested``: the number of NC cycles of the command."""
    cycles = measurement.run.cycles
    yield from placement_refusals(log)
    if log.was_stopped:
        yield diagnostic(SCHEDULE_RUN_STOPPED, cycles=cycles)
    is_shorter = cycles == log.plan.cycles < requested
    if log.is_cut or is_shorter:
        yield diagnostic(SCHEDULE_RECORDING_FULL, cycles=cycles)
    if late := late_wakes(measurement):
        yield diagnostic(LATE_WAKEUPS, count=len(late), latest=us(max(late)))
    if log.plan.source is not None:
        yield from _source_findings(log, log.plan.source)
    yield from _unattended_semaphores(log)


def _source_findings(log: RunLog, name: str) -> Iterator[Diagnostic]:
    """Yield the diagnostics of the semaphore that triggers the NC interrupts."""
    if log.drained:
        yield diagnostic(POSTS_DRAINED, name=name, count=log.drained)
    interrupts = log.entries[log.entries["kind"] == layout.INTERRUPT]
    moments: list[int] = [*interrupts["value"].tolist(), log.end]
    period = log.plan.model.train.distance
    gap, begin = max((after - before, before) for before, after in pairwise(moments))
    if gap > _SILENT_PERIODS * period:
        yield diagnostic(POSTS_CEASED, name=name, gap=us(gap), time=us(begin), expected=us(period))


def _unattended_semaphores(log: RunLog) -> Iterator[Diagnostic]:
    """Yield a diagnostic for each external thread's semaphore with hardly any waiting process."""
    for task in log.plan.tasks:
        wakeups = log.wakeups[task.number]
        posts = log.posts[task.number]
        if wakeups is not None and posts and is_rare(wakeups, posts):
            yield diagnostic(NOBODY_WAITS, name=task.semaphore, taken=wakeups, count=posts)
