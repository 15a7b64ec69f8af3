# SPDX-License-Identifier: MIT
"""PLCs that chance has written: late, twice, stale, forged and raising acknowledgements (RC-403).

A state machine of hypothesis plays the PLC of a program that outputs functions of all
synchronisations, functions of realtime cycles and jobs of spindles. Whatever it does, a function
waits until its own serial is acknowledged, what is not there is a ``ValueError`` or a ``Failure``,
and what no longer waits is reported once. ``NCTAKT_SEEDS=100000`` makes as many PLCs.
"""

from __future__ import annotations

import contextlib
import dataclasses
import math
from collections.abc import Callable
from random import Random

import pytest
from hypothesis import HealthCheck, Phase, seed, settings
from hypothesis import strategies as st
from hypothesis.stateful import (
    Bundle,
    RuleBasedStateMachine,
    initialize,
    invariant,
    multiple,
    rule,
    run_state_machine_as_test,
)
from support.random_seeds import FIRST, all_seeds

from nctakt.base.failure import Failure
from nctakt.hli.operator_panel import STATES
from nctakt.hli.plc_entries import SpindleEntry, TechnologyEntry
from nctakt.kernel import codes
from nctakt.lists.machine.machine import load_machine
from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import PlcView

DEMO = load_machine(None)
#: Rules of one PLC.
STEPS = 40
WORDS = (
    *("M100", "M111", "M112", "M113", "M114", "M115", "M116", "M117", "M118", "H1", "H111"),
    *("M100 M101 H2", "G01 X5 F6000", "G00 Y-3", "G04 X0.003", "S3[M3 REV=500]", "S3[M5]"),
    *("M110=130", "#FLUSH WAIT", "V.E.COUNT = V.E.COUNT + 1"),
)
CYCLES = (
    "",
    "#RT CYCLE [ID=1 SCOPE=PROG]\n$IF EDGE V.E.TRIGGER == 1\nM102 H3\n$ENDIF\n#RT CYCLE END\n",
    "#RT CYCLE [ID=2]\nM103\n#RT CYCLE END\n",
)
NUMBERS = st.one_of(
    st.integers(-3, 300), st.sampled_from([-(10**9), 1 << 31, 1 << 62, -(1 << 63), 10**30])
)
#: A number that represents another one; ``None``: it stays as it is.
CHANGED = st.one_of(st.none(), NUMBERS)
REALS = st.floats(width=64)
WRITTEN = ("V.E.TRIGGER", "V.E.COUNT", "HLI.OVERRIDE", "V.E.NOPE", "HLI.NOPE")
KEYS = ("reset", "start", "feed_hold", "single_block", "backward_motion")
NAMES = st.sampled_from(["X", "Y", "A", "S", "S3", "Q", "", "x"])


class RandomPlc(RuleBasedStateMachine):
    """One controller with its program, and the PLC that chance plays."""

    functions = Bundle("functions")
    jobs = Bundle("jobs")

    def __init__(self) -> None:
        super().__init__()
        self.controller = Controller(DEMO)
        self.hli: PlcView = self.controller.hli
        #: Section and serial of the functions that waited after the last step.
        self.seen: set[tuple[bool, int]] = set()
        self.answered: set[tuple[bool, int]] = set()
        self.resets = 0

    @initialize(
        cycle=st.sampled_from(CYCLES),
        words=st.lists(st.sampled_from(WORDS), min_size=1, max_size=9),
    )
    def begin(self, cycle: str, words: list[str]) -> None:
        """Start a program that repeats its words; the PLC is there."""
        self.controller.write("HLI.PLC_PRESENT", 1)
        lines = [cycle, "$FOR P1 = 1, 100, 1", *words, "$ENDFOR", "M30"]
        self.controller.start(NcText("p.nc", "\n".join(lines)))

    @rule(ticks=st.integers(1, 12))
    def step(self, ticks: int) -> None:
        """Let the controller run: what was acknowledged waits no longer, all others still do."""
        self.controller.step(ticks)
        before, self.seen = self.seen, self._waiting()
        if not self.resets and self.hli.state != "error":
            assert not self.seen & self.answered
            assert before - self.answered <= self.seen
        self.resets = 0

    @rule(target=functions, ticks=st.integers(0, 4))
    def look(self, ticks: int) -> object:
        """Keep the functions that wait, to acknowledge them now, later or again."""
        if ticks:
            self.step(ticks)
        return multiple(*self.hli.functions())

    @rule(target=jobs)
    def look_at_spindles(self) -> object:
        """Keep the jobs that wait."""
        return multiple(*self.hli.spindle_jobs())

    @rule(entry=functions)
    def acknowledge(self, entry: TechnologyEntry) -> None:
        """At once, late, twice or stale: only the function itself is acknowledged."""
        self.hli.acknowledge(entry)
        self.answered.add((entry.is_realtime, entry.serial))

    @rule(entry=functions, ticks=st.integers(1, 3))
    def acknowledge_and_step(self, entry: TechnologyEntry, ticks: int) -> None:
        """The usual PLC; for an entry of before, a stale one."""
        self.acknowledge(entry)
        self.step(ticks)

    @rule(job=jobs)
    def acknowledge_spindle(self, job: SpindleEntry) -> None:
        """As a function."""
        self.hli.acknowledge_spindle(job)

    @rule()
    def acknowledge_all(self) -> None:
        """Everything that waits."""
        self.answered |= self._waiting()
        self.hli.acknowledge_all()

    @rule(entry=functions, slot=CHANGED, serial=CHANGED, is_realtime=st.booleans())
    def forge(
        self, entry: TechnologyEntry, slot: int | None, serial: int | None, is_realtime: bool
    ) -> None:
        """Another slot, serial or section, or several of them."""
        waiting = {(kind, one.serial, one.slot) for kind, one in self._entries()}
        forged = dataclasses.replace(
            entry,
            slot=entry.slot if slot is None else slot,
            serial=entry.serial if serial is None else serial,
            is_realtime=is_realtime,
        )
        with contextlib.suppress(ValueError, OverflowError):
            self.hli.acknowledge(forged)
        if (is_realtime, forged.serial, forged.slot) in waiting:
            self.answered.add((is_realtime, forged.serial))
        self.step(1)

    @rule(job=jobs, index=CHANGED, serial=CHANGED)
    def forge_a_job(self, job: SpindleEntry, index: int | None, serial: int | None) -> None:
        """Another spindle or serial: a job that waits still does, unless it is the one."""
        forged = dataclasses.replace(
            job,
            index=job.index if index is None else index,
            serial=job.serial if serial is None else serial,
        )
        before = {(one.index, one.serial) for one in self.hli.spindle_jobs()}
        with contextlib.suppress(ValueError, OverflowError):
            self.hli.acknowledge_spindle(forged)
        after = {(one.index, one.serial) for one in self.hli.spindle_jobs()}
        assert before - after <= {(forged.index, forged.serial)}

    @rule(chance=st.randoms(use_true_random=False), number=NUMBERS, real=REALS, name=NAMES)
    def do_anything(self, chance: Random, number: int, real: float, name: str) -> None:
        """Command an axis, ask for one, write a value, press a key: mostly with nonsense."""
        hli = self.hli
        numbers = [number, int(chance.random() * 5), -1, 300]
        deeds: list[Callable[[], object]] = [
            lambda: hli.request_axis(
                chance.choice([codes.ABSOLUTE, codes.VELOCITY, codes.HALT, 9, -1]),
                name,
                chance.choice([real, 1.0]),
                chance.choice([real, 5.0]),
                chance.choice(numbers),
                chance.choice(numbers),
            ),
            lambda: hli.axis_answer(number),
            lambda: hli.is_axis_open(number),
            lambda: hli.is_axis_active(name, number),
            lambda: hli.write(chance.choice(WRITTEN), chance.choice([number, real, 1, 0, name])),
            lambda: hli.axis(name),
            lambda: self._press(chance.choice(KEYS)),
        ]
        with contextlib.suppress(ValueError, OverflowError, Failure):
            chance.choice(deeds)()

    def _press(self, key: str) -> None:
        if key in ("reset", "start"):
            getattr(self.hli, key)()
            self.resets += key == "reset"
        else:
            setattr(self.hli, key, not getattr(self.hli, key))

    @invariant()
    def the_channel_is_in_a_state(self) -> None:
        """One of the known ones, with finite values; stale names are reported once each."""
        assert self.hli.state in STATES
        assert all(math.isfinite(value) for value in self.hli.channel().values())
        reported = [one.values["name"] for one in self.controller.diagnostics if one.id == 900671]
        assert len(reported) == len(set(reported))

    def _entries(self) -> list[tuple[bool, TechnologyEntry]]:
        return [(one.is_realtime, one) for one in self.hli.functions()]

    def _waiting(self) -> set[tuple[bool, int]]:
        return {(kind, one.serial) for kind, one in self._entries()}


class RaisingError(Exception):
    """What a user's PLC raises."""


@pytest.mark.slow
def test_any_plc_leaves_the_controller_sound() -> None:
    """Each rule, in any order; the invariants hold after each."""
    machine = seed(FIRST)(RandomPlc)
    run_state_machine_as_test(
        machine,
        settings=settings(
            max_examples=len(all_seeds(60, 12)),
            stateful_step_count=STEPS,
            deadline=None,
            database=None,
            phases=(Phase.generate, Phase.shrink),
            suppress_health_check=list(HealthCheck),
        ),
    )


@pytest.mark.parametrize("tick", [0, 1, 7])
def test_a_plc_that_raises_leaves_a_controller_that_runs_on(tick: int) -> None:
    """Its exception is the caller's; the next run is as if nothing had been."""

    class Raises:
        def cycle(self, hli: PlcView) -> None:
            hli.acknowledge_all()
            if hli.tick >= tick:
                raise RaisingError

    controller = Controller(DEMO)
    program = NcText("p.nc", "M100\nM111\nG04 X0.01\nM30")
    with pytest.raises(RaisingError):
        controller.run(program, plc=Raises())
    run = controller.run(program)
    assert (run.state, run.errors) == ("ended", ())
