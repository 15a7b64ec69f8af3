# SPDX-License-Identifier: MIT
"""What MO-1 demands of a run of a random program, tick by tick: limits, places, ends of blocks."""

from __future__ import annotations

import numpy as np

from nctakt.results.run import Run
from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller, NcText
from support.motion_machines import AXES, DrawnMachine, machine
from support.motion_programs import MotionProgram

SIGNALS = [*(f"{name}.ACS.ACT_POS" for name in AXES), "BLOCK"]
#: The deviation of a rounded corner is one in the linear axes.
LINEAR = 3
#: What rounding may add to a position, mm.
FUZZ_MM = 1e-9
#: How far a place may be from the programmed way, whose numbers have nine decimals, mm.
OFF_MM = 1e-6


def positions(run: Run) -> np.ndarray:
    """The axes' positions after each tick; the modulo axis as it runs on."""
    assert run.trace is not None
    places = np.array([run.trace[name] for name in SIGNALS[:4]]).T
    places[:, 3] = np.unwrap(np.concatenate([[0.0], places[:, 3]]), period=360.0)[1:]
    return places


def blocks(run: Run) -> np.ndarray:
    """The block of each tick; where there is none, the one before."""
    assert run.trace is not None
    found = np.asarray(run.trace["BLOCK"]).astype(int)
    latest = np.maximum.accumulate(np.where(found > 0, np.arange(len(found)), 0))
    return found[latest]


def broken_limits(
    places: np.ndarray, machine: DrawnMachine, limits_jerk: np.ndarray, *, stands: bool = True
) -> list[str]:
    """Where an axis is faster, or changes its speed or acceleration more, than it may in a tick.

    ``limits_jerk``: whether the slope of each tick has a limit of the jerk. ``is``: after the last
    tick the axes are at rest.
    """
    behind = [places[-1:]] * 3 if stands else []
    path = np.concatenate([np.zeros((3, 4)), places, *behind])
    smooth = np.concatenate(
        [[limits_jerk[0]] * 3, limits_jerk, *([limits_jerk[-1:]] * len(behind))]
    )
    speed = np.diff(path, axis=0)
    change = np.diff(speed, axis=0)
    jerk = np.diff(change, axis=0)
    jerk[~(smooth[3:] & smooth[2:-1] & smooth[1:-2] & smooth[:-3])] = 0.0
    found = []
    for what, values, maximum, skipped in (
        ("speed", speed, machine.speed, 2),
        ("acceleration", change, machine.acceleration, 1),
        ("jerk", jerk, machine.jerk, 0),
    ):
        for axis, name in enumerate(AXES):
            sizes = np.abs(values[:, axis])
            if (worst := sizes.max()) > maximum[axis] * (1 + 1e-6) + FUZZ_MM:
                tick = int(sizes.argmax()) - skipped
                found.append(
                    f"{name}: {what} {worst / maximum[axis]:.4f} of its limit, tick {tick}"
                )
    return found


def off_the_way(program: MotionProgram, places: np.ndarray, numbers: np.ndarray) -> list[str]:
    """The blocks in which the axes are not where the program has them."""
    found = []
    order = [number for number, way in program.ways.items() if way.moves]
    borders = np.flatnonzero(np.diff(numbers)) + 1
    for begin, end in zip([0, *borders], [*borders, len(numbers)], strict=True):
        number = int(numbers[begin])
        way = program.ways.get(number)
        if way is None or not way.moves or way.is_compensated:
            continue
        off = way.distance(places[begin:end])
        if off.max() <= OFF_MM:
            continue
        if way.rounding and order[-1] != number:
            following = program.ways[order[order.index(number) + 1]]
            if following.is_compensated:
                continue
            off = np.minimum(
                way.distance(places[begin:end], LINEAR),
                following.distance(places[begin:end], LINEAR),
            )
            for tick in np.flatnonzero(off > way.rounding + OFF_MM):
                place = places[begin + tick]
                off[tick] = min(way.nearest(place, LINEAR), following.nearest(place, LINEAR))
        if (worst := off.max()) > way.rounding + OFF_MM:
            found.append(f"N{number}: {worst:.3g} mm off its way, tick {begin + int(off.argmax())}")
    return found


def ends_missed(program: MotionProgram, places: np.ndarray, numbers: np.ndarray) -> list[str]:
    """The blocks with an exact stop, and the last one, that do not end as programmed."""
    found = []
    final = max(program.ways, default=0)
    last = dict(zip(numbers.tolist(), range(len(numbers)), strict=True))
    for number, way in program.ways.items():
        is_exact = way.exact or number == final
        if not is_exact or way.is_compensated or not way.moves or number not in last:
            continue
        off = np.abs(places[last[number]] - way.target)
        # A turned axis is shown within its range; one that does not move stays where it was.
        off[(off < 1e-9) & (np.abs(way.target - way.start) < 1e-9)] = 0.0
        off[3] = 0.0 if off[3] < 1e-9 else off[3]
        if off.max() > (0.0 if way.plain else 1e-9):
            found.append(f"N{number}: its end is missed by {off.max():.3g} mm")
    return found


def limits_jerk(program: MotionProgram, numbers: np.ndarray) -> np.ndarray:
    """Whether the slope of each tick limits the jerk; before all blocks as the first one."""
    smooth = np.zeros(max(program.ways, default=0) + 1, dtype=bool)
    for number, way in program.ways.items():
        smooth[number] = way.limits_jerk
    smooth[0] = smooth[min(program.ways, default=0)]
    return smooth[numbers]


def violations(program: MotionProgram, run: Run, machine: DrawnMachine) -> list[str]:
    """Everything that is wrong with a run."""
    places, numbers = positions(run), blocks(run)
    is_over = run.state != "limit"
    if not is_over and (places[-2000:] == places[-1]).all():
        return ["it is at rest and does not end"]
    return [
        *broken_limits(places, machine, limits_jerk(program, numbers), stands=is_over),
        *off_the_way(program, places, numbers),
        *(ends_missed(program, places, numbers) if run.state == "ended" else []),
    ]


def stop_violations(
    program: MotionProgram, run: Run, machine: DrawnMachine, *, stands: bool
) -> list[str]:
    """Everything that is wrong with a run that has been stopped, and may have to stop by now.

    An error or a reset ends the run in the tick in which the path has stopped.
    """
    places, numbers = positions(run), blocks(run)
    if not len(places):
        return []
    is_over = run.state in ("error", "reset")
    smooth = limits_jerk(program, numbers)
    moves = stands and not is_over and (places[-2:] != places[-1]).any()
    return [
        *broken_limits(places, machine, smooth, stands=stands or is_over),
        *off_the_way(program, places, numbers),
        *(["it does not stand"] if moves else []),
    ]


def run_of(number: int, text: str, stimuli: list[Stimulus] | None = None) -> Run:
    """The run of a program on a machine, to its end."""
    controller = Controller(machine(number).configuration)
    run = controller.run(NcText("p.nc", text), signals=SIGNALS, at=stimuli or [])
    assert run.state == "ended", run.diagnostics
    return run


def assert_smooth(number: int, run: Run) -> None:
    """All limits hold, that of the jerk in each tick."""
    places = positions(run)
    wrong = broken_limits(places, machine(number), np.ones(len(places), dtype=bool))
    assert not wrong, wrong
