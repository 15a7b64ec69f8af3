# SPDX-License-Identifier: MIT
"""PLCs that chance has written: late, twice, stale, forged and raising acknowledgements (RC-403).

A state machine of hypothesis plays the PLC of a program that outputs functions of all
synchronisations, functions of realtime cycles and jobs of spindles. Whatever it does, a function
waits until its own serial is acknowledged, what is not there is a ``ValueError`` or a ``Failure``,
and what no longer waits is told once. ``NCTAKT_SEEDS=100000`` makes as many PLCs.
"""

from __future__ import annotations

import dataclasses
import math

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
from random_seeds import FIRST, all_seeds

from nctakt.base.failure import Failure
from nctakt.kernel import codes
from nctakt.lists.machine.machine import load_machine
from nctakt.run.controller import Controller, NcText
from nctakt.run.plc_view import STATES, PlcView, SpindleEntry, TechnologyEntry

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
REALS = st.floats(width=64)
NAMES = st.sampled_from(["X", "Y", "A", "S", "S3", "Q", "", "x"])


class RandomPlc(RuleBasedStateMachine):
    """One controller with its program, and the PLC that chance plays."""

    functions = Bundle("functions")
    jobs = Bundle("jobs")

    def __init__(self) -> None:
        super().__init__()
        self.controller = Controller(DEMO)
        self.hli: PlcView = self.controller.hli
        self.answered: set[tuple[bool, int]] = set()
        self.resets = 0

    @initialize(
        cycle=st.sampled_from(CYCLES),
        words=st.lists(st.sampled_from(WORDS), min_size=1, max_size=9),
    )
    def begin(self, cycle: str, words: list[str]) -> None:
        """Start a program; the PLC is there."""
        self.controller.write("HLI.PLC_PRESENT", 1)
        self.controller.start(NcText("p.nc", cycle + "\n".join(words) + "\nM30\n"))

    @rule(ticks=st.integers(1, 12))
    def step(self, ticks: int) -> None:
        """Let the controller run: what was acknowledged waits no longer, all others still do."""
        before = self._waiting()
        self.controller.step(ticks)
        after = self._waiting()
        if not self.resets and self.hli.state != "error":
            assert not after & self.answered
            assert before - self.answered <= after
        self.resets = 0

    @rule(target=functions)
    def look(self) -> object:
        """Keep the functions that wait, to acknowledge them now, later or again."""
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

    @rule(job=jobs)
    def acknowledge_spindle(self, job: SpindleEntry) -> None:
        """As a function."""
        self.hli.acknowledge_spindle(job)

    @rule()
    def acknowledge_all(self) -> None:
        """Everything that waits."""
        self.answered |= self._waiting()
        self.hli.acknowledge_all()

    @rule(entry=functions, slot=NUMBERS, serial=NUMBERS, is_realtime=st.booleans())
    def forge(self, entry: TechnologyEntry, slot: int, serial: int, is_realtime: bool) -> None:
        """Another slot, serial or section."""
        waiting = {(kind, one.serial, one.slot) for kind, one in self._entries()}
        forged = dataclasses.replace(entry, slot=slot, serial=serial, is_realtime=is_realtime)
        try:
            self.hli.acknowledge(forged)
        except (ValueError, OverflowError):
            return
        if (is_realtime, serial, slot) in waiting:
            self.answered.add((is_realtime, serial))

    @rule(job=jobs, place=NUMBERS, serial=NUMBERS)
    def forge_a_job(self, job: SpindleEntry, place: int, serial: int) -> None:
        """Another spindle or serial."""
        forged = dataclasses.replace(job, place=place, serial=serial)
        try:
            self.hli.acknowledge_spindle(forged)
        except (ValueError, OverflowError):
            return

    @rule(
        kind=st.sampled_from([codes.ABSOLUTE, codes.RELATIVE, codes.VELOCITY, codes.HALT, 9, -1]),
        name=NAMES,
        value=REALS,
        speed=REALS,
        mode=NUMBERS,
        way=NUMBERS,
    )
    def move(self, kind: int, name: str, value: float, speed: float, mode: int, way: int) -> None:
        """Command a single axis, mostly with nonsense."""
        try:
            owner = self.hli.request_axis(kind, name, value, speed, mode, way)
            self.hli.is_axis_active(name, owner)
            self.hli.axis_answer(owner)
        except (ValueError, OverflowError, Failure):
            return

    @rule(owner=NUMBERS)
    def ask(self, owner: int) -> None:
        """Follow a command that was never given."""
        for question in (self.hli.axis_answer, self.hli.is_axis_open):
            try:
                question(owner)
            except (ValueError, OverflowError):
                continue

    @rule(
        name=st.sampled_from(["V.E.TRIGGER", "V.E.COUNT", "HLI.OVERRIDE", "V.E.NOPE", "HLI.NOPE"]),
        value=st.one_of(NUMBERS, REALS, st.text(max_size=3)),
    )
    def write(self, name: str, value: float | str) -> None:
        """Any value; what cannot be is a diagnostic."""
        try:
            self.hli.write(name, value)
        except (Failure, OverflowError):
            return

    @rule(key=st.sampled_from(["reset", "start", "feed_hold", "single_block", "backward_motion"]))
    def press(self, key: str) -> None:
        """The operator's keys."""
        if key in ("reset", "start"):
            getattr(self.hli, key)()
            self.resets += key == "reset"
        else:
            setattr(self.hli, key, not getattr(self.hli, key))

    @rule(name=NAMES)
    def read(self, name: str) -> None:
        """An axis by a name that may be none."""
        try:
            values = self.hli.axis(name)
        except Failure as failure:
            assert failure.diagnostics[0].id == 900656
            return
        assert all(math.isfinite(value) for value in values.values())

    @invariant()
    def the_channel_is_in_a_state(self) -> None:
        """One of the known ones, with finite values; stale names are told once each."""
        assert self.hli.state in STATES
        assert all(math.isfinite(value) for value in self.hli.channel().values())
        told = [one.values["name"] for one in self.controller.diagnostics if one.id == 900671]
        assert len(told) == len(set(told))

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
            max_examples=len(all_seeds(120, 20)),
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
