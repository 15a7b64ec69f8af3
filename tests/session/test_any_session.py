# SPDX-License-Identifier: MIT
"""Sessions that chance lives through: any way there and back, and nothing is ever otherwise.

A state machine of hypothesis steps, stops, travels, writes and selects programs that are kept in
memory or read from their file. Whatever it has seen after a tick it sees again whenever it comes
back, and so does a straight run of the tape. ``NCTAKT_SEEDS=1000`` makes as many sessions.
"""

from __future__ import annotations

import random
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import HealthCheck, Phase, seed, settings
from hypothesis import strategies as st
from hypothesis.stateful import (
    RuleBasedStateMachine,
    initialize,
    invariant,
    precondition,
    rule,
    run_state_machine_as_test,
)
from support.random_seeds import FIRST, all_seeds

from nctakt.base.long_text import SHORT_FILE_BYTES
from nctakt.run.access.tape import Tape
from nctakt.run.controller import Controller
from nctakt.session.core import SessionCore
from nctakt.session.process.worker import can_fork
from nctakt.session.setup import Setup
from nctakt.session.stops import read_stop

#: Rules of one session.
STEPS = 22

#: Bytes of the programs: below and above the size from which lines are read when they are due.
SIZES = (2_000, 300_000, SHORT_FILE_BYTES + 200_000)

SIGNALS = ("X.ACS.ACT_POS", "Y.ACS.ACT_POS", "V.E.COUNT", "V.E.VALUE")
NAMES = ("V.RTA.ACS.ACT_POS.X", "V.RTA.ACS.ACT_POS.Y", "V.E.COUNT", "V.E.VALUE")
BY_EVENTS = ("line 40", "line 700", "M100", "fires 3", "notice", "written V.E.COUNT")
BY_RUNNING = ("changes V.E.COUNT", "V.RTA.ACS.ACT_POS.X > 0.3", "V.E.VALUE < 1", "runs 2")

CYCLE = """\
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF EDGE V.E.VALUE > 0.5
    V.E.COUNT += 1
  $ENDIF
  $IF V.RTA.ACS.ACT_POS.X > 0.5
    V.E.COUNT += 2
  $ENDIF
#RT CYCLE END
G01 X0 Y0 F60000
"""


def programs(folder: Path) -> list[Path]:
    """Write the programs: with and without a realtime cycle, of each size."""
    chance = random.Random(5)
    paths = []
    for number, size in enumerate((*SIZES, SHORT_FILE_BYTES + 100_000)):
        lines = [CYCLE if number < len(SIZES) else "G01 X0 Y0 F60000"]
        length = len(lines[0])
        while length < size:
            words = f"X{chance.uniform(0, 0.6):.3f} Y{chance.uniform(0, 0.6):.3f}"
            lines.append(f"N{len(lines)} {words}" + " M100" * (chance.random() < 0.02))
            length += len(lines[-1]) + 1
        paths.append(folder / f"{number}.nc")
        paths[-1].write_text("\n".join([*lines, "M30", ""]), "utf-8")
    return paths


class AnySession(RuleBasedStateMachine):
    """One session; ``paths``: the programs that it runs and selects."""

    paths: list[Path]

    def __init__(self) -> None:
        super().__init__()
        self.core: SessionCore | None = None
        self.setup: Setup
        #: What was seen before a tick of a branch, its own one.
        self.seen: dict[tuple[int, int], list[float | bool | str]] = {}

    @property
    def there(self) -> SessionCore:
        """The session."""
        assert self.core is not None
        return self.core

    @initialize(number=st.integers(0, 3), stays=st.booleans())
    def open(self, number: int, stays: bool) -> None:
        """Open the session."""
        self.setup = Setup({1: [self.paths[number]]}, options={"stays": stays})
        self.core = SessionCore(self.setup)
        self.there.step(500)
        assert self.there.tick == 500, "a program with mistakes, which does not run, shows nothing"

    @rule(ticks=st.integers(1, 2500))
    def step(self, ticks: int) -> None:
        """Run ticks, in the past or beyond it."""
        self.there.step(ticks)

    @rule(text=st.sampled_from([*BY_EVENTS, *BY_RUNNING]), ticks=st.integers(1, 2000))
    def run_to_a_stop(self, text: str, ticks: int) -> None:
        """Run to a stop, or some ticks if it is not there."""
        self.there.run(self.there.tick + ticks, stops=[read_stop(text)])

    @rule(ticks=st.integers(1, 60))
    def back(self, ticks: int) -> None:
        """Step back."""
        self.there.back(ticks)

    @rule(share=st.floats(0, 1), branch=st.integers(0, 30))
    def go_to(self, share: float, branch: int) -> None:
        """Travel to any moment of any branch."""
        target = self.there.branches[branch % len(self.there.branches)]
        self.there.go_to(int(share * target.latest), target.number)

    @rule(text=st.sampled_from(BY_EVENTS))
    def back_to_an_event(self, text: str) -> None:
        """Go back to an event: the record leads to where running again does."""
        stop, core = read_stop(text), self.there
        before = core.tick
        by_running = core.timeline.previous([replace(stop, only_if="1 > 0")])
        done = core.back_to([stop])
        assert (None if done is None else core.tick) == by_running
        assert done is None or core.tick < before

    @rule(text=st.sampled_from(BY_RUNNING))
    def back_to_a_condition(self, text: str) -> None:
        """Go back to a condition, and forward again to it from the tick before.

        What is recorded of signals leads to where running all again does.
        """
        core = self.there
        stop = read_stop(text)
        by_running = core.timeline.previous([replace(stop, kind="condition", text="0 > 1"), stop])
        assert core.timeline.previous([stop]) == by_running
        if core.back_to([stop]) is not None and core.tick > 1:
            tick = core.tick
            core.back()
            assert core.run(tick, stops=[stop]).tick == tick

    @rule(name=st.sampled_from(["V.E.VALUE", "HLI.OVERRIDE"]), value=st.sampled_from([0, 1, 60]))
    def write(self, name: str, value: int) -> None:
        """Write a value; in the past this begins a branch."""
        self.there.write({name: value}, "page")

    @rule(number=st.integers(0, 3))
    def select(self, number: int) -> None:
        """Select a program; a channel whose program runs keeps that."""
        self.there.select(str(self.paths[number]), 1, "page")

    @precondition(lambda self: self.core is not None and self.core.branch.latest > 1)
    @rule(share=st.floats(0, 1), ticks=st.integers(1, 300))
    def look(self, share: float, ticks: int) -> None:
        """Look at some ticks from where the session is: as they were seen."""
        core = self.there
        first = int(share * (core.branch.latest - 1))
        every, cells = core.look(first, first + ticks, SIGNALS)
        assert every == 1
        for (number, tick), values in self.seen.items():
            row = (tick - 1 - first) * len(SIGNALS)
            if 0 <= row < len(cells) and self.is_ours(number, tick):
                assert list(cells[row : row + len(SIGNALS)]) == values

    def is_ours(self, number: int, tick: int) -> bool:
        """Return whether what was seen on a branch is of the present one's past or future."""
        core = self.there
        return core.branch.shares(core.branches[number - 1], tick)

    @invariant()
    def sees_what_was_there(self) -> None:
        """Compare what is seen with what was seen here before."""
        if self.core is None:
            return
        core = self.there
        values = core.read(NAMES)
        for branch in core.branches:
            known = self.seen.get((branch.number, core.tick))
            if known is not None and self.is_ours(branch.number, core.tick):
                assert values == known
        self.seen[core.branch.number, core.tick] = values

    def teardown(self) -> None:
        """Compare all that was seen on this branch with a straight run of its tape."""
        if self.core is None:
            return
        core = self.there
        try:
            inputs = tuple(one for one in core.tape() if one.tick < core.branch.latest)
            run = Controller().run(
                *self.setup.programs[1],
                stays=self.setup.options.get("stays", False),
                replay=Tape({}, {}, False, inputs, {}, 0, "", {}),
                ticks=core.branch.latest,
                signals=SIGNALS,
            )
            for (number, tick), values in self.seen.items():
                if 0 < tick <= run.ticks and self.is_ours(number, tick):
                    assert [run.trace[name][tick - 1] for name in SIGNALS] == values
        finally:
            core.close()


@contextmanager
def written_programs() -> Iterator[None]:
    """Let the programs be there."""
    with tempfile.TemporaryDirectory() as folder:
        AnySession.paths = programs(Path(folder))
        yield


@pytest.mark.slow
@pytest.mark.skipif(not can_fork(), reason="elsewhere the past is run again from the start")
def test_any_session_sees_the_same_whenever_it_comes_back() -> None:
    """Nothing that chance does to a session shows another past than was there."""
    with written_programs():
        run_state_machine_as_test(
            seed(FIRST)(AnySession),
            settings=settings(
                max_examples=len(all_seeds(2, 1)),
                stateful_step_count=STEPS,
                deadline=None,
                database=None,
                phases=(Phase.generate, Phase.shrink),
                suppress_health_check=list(HealthCheck),
            ),
        )
