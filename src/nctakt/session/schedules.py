# SPDX-License-Identifier: MIT
"""The real schedule of a session's controller, if its setup names a scheduling list.

In: a setup. Out: a machine whose ticks follow the list, and the threads scheduled by it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, cast

from nctakt.base.diagnostics import Diagnostic, Language
from nctakt.files.access import FileAccess
from nctakt.lists.machine.machine import Machine
from nctakt.run.plcs.plc_view import AnyPlc
from nctakt.run.tick_loop import TickLoop
from nctakt.session.setup import Setup

if TYPE_CHECKING:
    from nctakt.run.scheduled.real_schedule import RealSchedule
    from nctakt.schedule.open_schedule import RunSchedule
    from nctakt.schedule.simulation.ticks import ThreadRoles

#: Requests of a session: restart after a pause, return the table, end.
RESTART, TABLE, CLOSE = "restart", "table", "close"


def schedule_of_setup(setup: Setup, access: FileAccess) -> RunSchedule | None:
    """Return the schedule of a setup, ``None`` without one; raises ``Failure``."""
    if setup.rtconf is None:
        return None
    from nctakt.lists.machine.schedules.scheduling_profile import PROFILES, RtconfOptions  # noqa: PLC0415
    from nctakt.schedule.open_schedule import open_schedule  # noqa: PLC0415 - rare

    profile = PROFILES[setup.system or "rtx"]
    return open_schedule(setup.rtconf, setup.load, RtconfOptions(profile), access)


class EngineSchedule:
    """The schedule of one controller; without a list it does nothing."""

    def __init__(self, setup: Setup, access: FileAccess) -> None:
        self._schedule = schedule_of_setup(setup, access)
        self._roles: ThreadRoles | None = None
        self._real: RealSchedule | None = None

    def scheduled(self, machine: Machine, diagnostics: list[Diagnostic]) -> Machine:
        """Return the machine with the ticks of the list; ``diagnostics`` are added to its own."""
        if self._schedule is None:
            return machine
        from nctakt.run.scheduled.scheduled_run import scheduled  # noqa: PLC0415 - rare

        changed, self._roles = scheduled(machine, self._schedule)
        diagnostics[:] = changed.diagnostics
        return changed

    def follow(
        self, loop: TickLoop, plc: AnyPlc | None, report: Callable[[Diagnostic], None]
    ) -> None:
        """Let the ticks come when the list says so, on this thread; raises ``Failure``."""
        if self._schedule is None or self._roles is None:
            return
        from nctakt.schedule.real.machine import check_system  # noqa: PLC0415 - rare

        check_system()
        from nctakt.run.scheduled.real_schedule import RealSchedule  # noqa: PLC0415 - on Linux only

        self._real = RealSchedule(loop.machine, self._schedule, self._roles, plc, report)
        loop.follow(self._real)

    def carry_out(self, request: str, *words: str) -> str | None:
        """Carry out a request; return the table, else ``None``."""
        if self._real is None:
            return None
        if request == TABLE:
            return self._real.table(cast("Language", words[0]))
        if request == RESTART:
            self._real.restart()
        elif request == CLOSE:
            self._real.close()
        return None
