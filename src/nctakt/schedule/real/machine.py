# SPDX-License-Identifier: MIT
"""Abilities of the machine that is to run a schedule.

In: the machine. Out: its processors, whether the realtime scheduling class is permitted. Nothing is
changed.
"""

from __future__ import annotations

import importlib.util
import os
import sys
from pathlib import Path

from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.scheduling.linux_run import LINUX_ONLY, SCHEDULE_RUNNER_MISSING
from nctakt.schedule.load import MAX_CPUS

_ONLINE = Path("/sys/devices/system/cpu/online")
_PRESENT = Path("/sys/devices/system/cpu/present")


def check_system() -> None:
    """Raise ``Failure`` (900680, 900681) if the system cannot run a schedule."""
    if sys.platform != "linux":
        raise Failure(diagnostic(LINUX_ONLY, system=sys.platform))
    if importlib.util.find_spec("nctakt.schedule.real.processes") is None:
        raise Failure(diagnostic(SCHEDULE_RUNNER_MISSING))


def parse_cpus(text: str) -> tuple[int, ...]:
    """Return the processors in a text of the system (``0-2,4``), counted from 1."""
    cpus: list[int] = []
    for part in text.strip().split(","):
        low, _, high = part.partition("-")
        cpus += range(int(low) + 1, int(high or low) + 2)
    return tuple(cpu for cpu in cpus if cpu <= MAX_CPUS)


def present_cpus() -> tuple[int, ...]:
    """Return the processors of the machine, counted from 1."""
    return parse_cpus(_PRESENT.read_text("ascii"))


def usable_cpus() -> tuple[int, ...]:
    """Return the processors that are online and permitted for this process."""
    assert sys.platform == "linux"
    allowed = {cpu + 1 for cpu in os.sched_getaffinity(0)}
    return tuple(cpu for cpu in parse_cpus(_ONLINE.read_text("ascii")) if cpu in allowed)


def fifo_refusal() -> str | None:
    """Return the system's reason for refusing SCHED_FIFO; ``None`` if it is permitted."""
    assert sys.platform == "linux"
    policy, parameter = os.sched_getscheduler(0), os.sched_getparam(0)
    try:
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(1))
    except OSError as error:
        return error.strerror or str(error)
    os.sched_setscheduler(0, policy, parameter)
    return None
