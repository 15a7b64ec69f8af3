# SPDX-License-Identifier: MIT
"""A scheduling list and its load as files -> the schedule of a controller.

In: paths. Out: ``RunSchedule``, or a ``Failure`` with all mistakes. A list usable only with
replacements is good enough for inspection; a controller needs one without errors.
"""

from __future__ import annotations

from pathlib import Path

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Severity, Text
from nctakt.base.failure import Failure
from nctakt.base.text import decode_text
from nctakt.files.access import FileAccess
from nctakt.lists.declared.rtconf import RtconfConfiguration
from nctakt.lists.format import arguments
from nctakt.lists.format.times import Time, TimeLike, read_time
from nctakt.lists.machine.schedules.scheduling import load_rtconf
from nctakt.lists.machine.schedules.scheduling_profile import RtconfOptions
from nctakt.messages import Collector
from nctakt.messages.scheduling.schedule_results import CPU_MISSING, CPU_NOT_ASSIGNABLE
from nctakt.schedule.assemble import assemble
from nctakt.schedule.load import ASSUMED, Load, read_load
from nctakt.schedule.model import NS_PER_US, Model
from nctakt.schedule.simulation.results import Simulation
from nctakt.schedule.simulation.simulate import simulate

#: Errors of a list with a load that leave a schedule: the operating system places the thread.
PLACED = (CPU_MISSING, CPU_NOT_ASSIGNABLE)


@dataclass(frozen=True, slots=True, repr=False)
class RunSchedule:
    """A schedule for a controller; ``diagnostics``: the findings in list and load."""

    file: str
    configuration: RtconfConfiguration
    model: Model
    load: Load
    diagnostics: tuple[Diagnostic, ...]

    def __repr__(self) -> str:
        names = ", ".join(task.name for task in self.model.tasks)
        return f"<RunSchedule of {self.file}: {self.model.schedule}, threads {names}>"


def open_schedule(
    rtconf: str | Path,
    load: str | Path | None = None,
    options: RtconfOptions | None = None,
    access: FileAccess | None = None,
) -> RunSchedule:
    """Return the schedule of a list (rtconf.lis) and a load file, by default assumed times.

    Raises ``Failure`` with all mistakes in both files.

    >>> schedule = open_schedule(load_machine().folder / "rtconf.lis")
    >>> [task.name for task in schedule.model.tasks]
    ['GEO', 'BACKGROUND']
    >>> Controller(schedule=schedule).run(NcText("move.nc", "G01 X100 F6000 M30")).state
    'ended'
    """
    options = options or RtconfOptions()
    access = access or FileAccess()
    collector = Collector()
    path = arguments.path("rtconf", rtconf)
    configuration = load_rtconf(str(rtconf), access.read_bytes(path), collector, options)
    times = ASSUMED
    if load is not None:
        times = read_load(
            str(load), decode_text(access.read_bytes(arguments.path("load", load))).text, collector
        )
    return schedule_of(str(rtconf), configuration, times, options, collector)


def schedule_of(
    file: str,
    configuration: RtconfConfiguration,
    load: Load,
    options: RtconfOptions,
    collector: Collector,
) -> RunSchedule:
    """Return the schedule of a list and a load that were read with ``collector``.

    Raises ``Failure`` with all that was found if there are errors.
    """
    if collector.has_errors:
        raise Failure(*collector.diagnostics)
    model = assemble(configuration, load, options.profile, collector)
    errors = [finding for finding in collector.diagnostics if finding.severity is Severity.ERROR]
    if any(finding.message not in PLACED for finding in errors):
        raise Failure(*collector.diagnostics)
    return RunSchedule(file, configuration, model, load, tuple(collector.diagnostics))


_SCHEDULE = Text("the result of open_schedule", "das Ergebnis von open_schedule")


def simulate_schedule(schedule: RunSchedule, until: TimeLike = "1 s") -> Simulation:
    """Simulate a schedule for this time, at least for one NC cycle, without a controller.

    ``until`` in ticks counts NC cycles. Raises ``Failure`` for an invalid time (900510, 900513).

    >>> schedule = open_schedule(load_machine().folder / "rtconf.lis")
    >>> simulate_schedule(schedule, "100 ms").cycles
    100
    """
    if not isinstance(schedule, RunSchedule):
        arguments.refuse("schedule", schedule, _SCHEDULE)
    return simulate(schedule.model, cycles_within(schedule.model, read_time(until)))


def cycles_within(model: Model, time: Time) -> int:
    """Return how many NC cycles there are within a time, at least one."""
    if time.is_in_ticks:
        return max(1, time.count)
    return max(1, time.count * NS_PER_US // model.train.distance)
