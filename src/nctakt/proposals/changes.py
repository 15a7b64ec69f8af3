# SPDX-License-Identifier: MIT
"""Single changes, and runs with them: override, dynamics of axes, limits of the path, functions.

In: a machine, the axes that move in the log, the functions of a run. Out: ``Change`` records, each
with the value that counts now.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Literal, Protocol

from nctakt.base.dataclass import dataclass
from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.lists.machine.axis_configuration import AxisConfiguration, AxisType
from nctakt.lists.machine.machine import Machine
from nctakt.results.run import Run
from nctakt.run.controller import Controller
from nctakt.run.options import RunKeywords
from nctakt.schedule.open_schedule import RunSchedule
from nctakt.studies.plans.changed_lists import changed_machine
from nctakt.studies.plans.faults import FaultyPlc, PlcFaults

#: The operator's override of the path.
OVERRIDE = "HLI.OVERRIDE"

#: A limit of the path from here on limits nothing.
_NO_LIMIT = 1e8
#: The tolerance of corners of ``#HSC``, in 0.1 µm, where a search begins if there is none.
_TOLERANCE = 2000.0


@dataclass(frozen=True, slots=True)
class Change:
    """A change: a variable, a parameter of axes or a channel, the delay of a function.

    ``target``: the variable, the parameter's ID, the function. ``present``: the value that counts
    now; ``guess``: where a search begins; ``step``: values are its multiples.
    """

    kind: Literal["variable", "parameter", "function"]
    target: str
    of: tuple[str, ...]
    present: float
    guess: float
    unit: str
    step: float = 0.0


def changes_of(
    machine: Machine, axes: Sequence[str], functions: Sequence[str], override: float, tick_us: int
) -> Iterator[Change]:
    """Yield the changes that may be tried, those of axes for all of them together."""
    yield Change("variable", OVERRIDE, (), override, override, "%", 0.1)
    chosen = [axis for axis in machine.axes if axis.name in axes]
    if chosen:
        yield from _of_axes(chosen)
        yield from _of_path(machine, max(axis.dynamics.max_acceleration for axis in chosen))
    for name in functions:
        yield Change("function", name, (), 0.0, 0.0, "ms", tick_us)


def changes_by_axis(machine: Machine, change: Change) -> Iterator[Change]:
    """Yield the same change for each of several axes alone."""
    if change.kind == "parameter" and len(change.of) > 1:
        for axis in machine.axes:
            if axis.name in change.of:
                yield from (one for one in _of_axes([axis]) if one.target == change.target)


def _of_axes(axes: Sequence[AxisConfiguration]) -> Iterator[Change]:
    names = tuple(axis.name for axis in axes)
    first, *others = [_dynamics(axis) for axis in axes]
    for id_, (value, unit) in first.items():
        if all(other[id_] == (value, unit) for other in others):
            yield Change("parameter", id_, names, value, value, unit, 1.0)


def _dynamics(axis: AxisConfiguration) -> dict[str, tuple[float, str]]:
    """Return the dynamics of the axis's gear step: ID -> value and unit as in its list."""
    if len(axis.gears) > 1:
        return {}  # which step is active is for the program to say
    found, degree = axis.dynamics, axis.type is AxisType.ROTARY
    acceleration, speed = ("°/s²", "1e-3°/s") if degree else ("mm/s²", "µm/s")
    slope = found.jerk_slope
    up, fade, brake, release = slope.ramp_times_us
    return {
        "P-AXIS-00008": (found.max_acceleration, acceleration),
        "P-AXIS-00011": (found.feed_slope.low, acceleration),
        "P-AXIS-00012": (found.feed_slope.high, acceleration),
        "P-AXIS-00005": (found.rapid_slope.low, acceleration),
        "P-AXIS-00006": (found.rapid_slope.high, acceleration),
        "P-AXIS-00001": (slope.acceleration, acceleration),
        "P-AXIS-00002": (slope.deceleration, acceleration),
        "P-AXIS-00004": (slope.rapid_acceleration, acceleration),
        "P-AXIS-00196": (up, "µs"),
        "P-AXIS-00195": (fade, "µs"),
        "P-AXIS-00198": (brake, "µs"),
        "P-AXIS-00197": (release, "µs"),
        "P-AXIS-00200": (slope.rapid_ramp_time_us, "µs"),
        "P-AXIS-00212": (found.max_speed * 1000.0, speed),
        "P-AXIS-00209": (found.rapid_speed * 1000.0, speed),
    }


def _of_path(machine: Machine, fastest: float) -> Iterator[Change]:
    for channel in machine.channels:
        parameters = channel.parameters
        unit, per = ("mm/s²", 1.0) if parameters.path_limits_per_s else ("mm/min²", 3600.0)
        for word, id_ in (("ACC", "P-CHAN-00002"), ("RADIAL_ACC", "P-CHAN-00361")):
            value = parameters.path_limits[word]
            guess = value if value < _NO_LIMIT else fastest * per
            yield Change("parameter", id_, (str(channel.number),), value, guess, unit)
        tolerance = round(parameters.hsc_deviation_mm * 10_000.0, 6)
        guess = tolerance or _TOLERANCE
        yield Change(
            "parameter", "P-CHAN-00122", (str(channel.number),), tolerance, guess, "0.1 µm"
        )


class RunRequest(Protocol):
    """A run: programs of channel 1 and of others, options, a PLC and an FMU."""

    @property
    def programs(self) -> Sequence[Any]:
        """Those of channel 1."""

    @property
    def channels(self) -> Mapping[int, Sequence[Any]]:
        """Those of the others, by number."""

    @property
    def options(self) -> RunKeywords:
        """The options of ``Controller.run``."""

    @property
    def signals(self) -> tuple[str, ...] | None:
        """The signals that are recorded."""

    @property
    def plc(self) -> Any:
        """The PLC, not yet used."""

    @property
    def fmu(self) -> Any:
        """The FMU, not yet used."""


def changed_run(
    machine: Machine,
    schedule: RunSchedule | None,
    access: FileAccess,
    request: RunRequest,
    change: Change,
    value: float,
) -> Run | None:
    """Return the run with a value of a change; ``None`` if it is not possible."""
    plc = request.plc
    given: dict[str, float | str] = dict(request.options["set"] or {})
    try:
        match change.kind:
            case "variable":
                given[change.target] = value
            case "parameter":
                machine = changed_machine(
                    machine, {(change.target, owner): value for owner in change.of}
                )
            case "function":
                plc = FaultyPlc(plc, PlcFaults({change.target: value}))
        keywords: RunKeywords = {
            **request.options,
            "set": given,
            "plc": plc,
            "fmu": request.fmu,
            "signals": request.signals,
            "memory_trace": True,
        }
        controller = Controller(machine, schedule, access)
        return controller.run(*request.programs, channels=request.channels, **keywords)
    except Failure:
        return None
