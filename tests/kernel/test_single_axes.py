# SPDX-License-Identifier: MIT
"""Independent motion in the realtime part (MO-11, MO-13), commanded from Python's side.

Demo machine: T 1 ms, ±10 000 mm, 500 mm/s, 4000 mm/s², trapezoid; A modulo 360°.
"""

from __future__ import annotations

import itertools
import math
import shutil
from pathlib import Path

import pytest
from support.kernel_rig import DEMO, Rig

from nctakt.lists.machine.machine import load_machine
from nctakt.results.trace.events import EventDecoder
from nctakt.run.realtime.assembly import AssembledMachine

X, Y, Z, A = range(4)
ABORTING, BUFFERED = 0, 1
CUR, SHORTEST = 0, 2
STANDSTILL, DISCRETE, CONTINUOUS, STOPPING, ERROR_STOP, SYNCHRONIZED = range(1, 7)
OWNER = 7


class AxesRig(Rig):
    """A rig that keeps the position of one axis and the texts of all events, tick by tick."""

    def __init__(self, axis: int = Z, machine: AssembledMachine | None = None) -> None:
        super().__init__()
        if machine is not None:
            self.machine = machine
            self.channel = machine.channels[0]
        self.axis = axis
        self.single = self.machine.single_axes
        self.places: list[float] = []
        self.reported: list[tuple[int, str]] = []
        self._decoder = EventDecoder(1000, self.machine.registry)

    def run(self, ticks: int) -> list[float]:
        before = len(self.places)
        for _ in range(ticks):
            self.machine.reserve()
            self.machine.kernel.run(1)
            tick = len(self.places)
            rows = self._decoder.decode(self.machine.record.take_events())
            self.reported += [(tick, str(event)) for event in rows]
            self.machine.record.take_probes()
            self.places.append(self.machine.axes.positions()[self.axis])
        return self.places[before:]

    def run_to_stand(self, maximum: int = 100_000) -> int:
        """Run until the axis is at rest: the ticks that it took."""
        for ticks in range(maximum):
            if self.single.ending_count() == 0:
                return ticks
            self.run(1)
        raise AssertionError("the axis never stands")

    def state(self) -> int:
        return self.single.state_of(self.axis)[0]

    def absolute(self, target: float, speed: float = 500.0, mode: int = ABORTING) -> int:
        return self.single.absolute(self.axis, target, speed, mode, SHORTEST, OWNER)


def assert_no_step(places: list[float], *, top: float = 500.0, rise: float = 4000.0) -> None:
    """From rest at 0: mean speeds within the limits, those of neighbours at most a·T apart."""
    before = 0.0
    for first, second in zip([0.0, *places], places, strict=False):
        speed = (second - first) / 0.001
        assert abs(speed) <= top + 1e-6
        assert abs(speed - before) <= rise * 0.001 + 1e-6
        before = speed


def test_a_trapezoid_by_hand() -> None:
    """MO-11, MO-14: 10 mm at 100 mm/s: 25 ms to accelerate (1.25 mm), 75 ms, 25 ms to brake.

    After i ticks 2·i² µm, from 25 on 1250 + 100·(i - 25) µm; 125 ticks; the end is exact.
    """
    rig = AxesRig()
    assert rig.absolute(10.0, 100.0) == 0
    assert rig.run_to_stand() == 125
    assert rig.places[9] == pytest.approx(0.2)
    assert rig.places[24] == pytest.approx(1.25)
    assert rig.places[49] == pytest.approx(3.75)
    assert rig.places[124] == 10.0
    assert rig.reported == [(0, "axis Z begun 10"), (124, "axis Z done")]


def test_states_of_a_motion() -> None:
    """PLCopen: Standstill, DiscreteMotion, Stopping while it brakes, Standstill."""
    rig = AxesRig()
    assert rig.state() == STANDSTILL
    rig.absolute(100.0)
    rig.run(10)
    assert rig.state() == DISCRETE
    assert rig.single.halt(Z, OWNER) == 0
    rig.run(5)
    assert rig.state() == STOPPING
    rig.run_to_stand()
    assert rig.state() == STANDSTILL
    assert [text for _, text in rig.reported] == [
        "axis Z begun 100",
        "axis Z aborted",
        "axis Z stopped",
    ]


def test_stop_brakes_from_its_tick_on() -> None:
    """At 40 mm/s after 10 ticks (0.2 mm): 10 ticks and 0.2 mm more."""
    rig = AxesRig()
    rig.absolute(100.0)
    rig.run(10)
    rig.single.halt(Z, OWNER)
    assert rig.run_to_stand() == 10
    assert rig.places[-1] == pytest.approx(0.4)


def test_aborting_takes_over_the_speed() -> None:
    """MO-11: another target against the motion: no step in position or speed, then exact."""
    rig = AxesRig()
    rig.absolute(100.0)
    rig.run(60)
    rig.absolute(-5.0)
    rig.run_to_stand()
    assert_no_step(rig.places)
    assert rig.places[-1] == -5.0


def test_buffered_begins_in_the_tick_after() -> None:
    """The waiting motion begins where the first one ends, with an exact stop between (MO-14)."""
    rig = AxesRig()
    rig.absolute(10.0, 100.0)
    assert rig.absolute(20.0, 100.0, BUFFERED) == 0
    assert rig.absolute(30.0, 100.0, BUFFERED) == 1704
    assert rig.run_to_stand() == 250
    assert rig.places[124] == 10.0
    assert rig.places[125] == pytest.approx(10.002)
    assert rig.places[-1] == 20.0
    assert rig.single.opened(OWNER) == 0


def test_buffered_distance_counts_from_the_target_in_front() -> None:
    """G91 with BUFFERED: 10 mm, then 5 mm more."""
    rig = AxesRig()
    rig.absolute(10.0)
    assert rig.single.relative(Z, 5.0, 500.0, BUFFERED, OWNER) == 0
    assert rig.single.opened(OWNER) == 2
    rig.run_to_stand()
    assert rig.places[-1] == 15.0


def test_endless_and_the_motion_that_waits_for_its_speed() -> None:
    """PLCopen: a motion after MC_MoveVelocity begins when that one has reached its speed."""
    rig = AxesRig()
    assert rig.single.velocity(Z, 100.0, 1, ABORTING, OWNER) == 0
    rig.run(24)
    assert rig.state() == CONTINUOUS
    assert not rig.single.at_speed(Z)
    rig.run(1)
    assert rig.single.at_speed(Z)
    rig.run(10)
    assert rig.places[-1] == pytest.approx(1.25 + 1.0)
    rig.absolute(50.0, 100.0, BUFFERED)
    rig.run_to_stand()
    assert rig.places[-1] == 50.0
    assert_no_step(rig.places, top=100.0)


def test_endless_at_a_software_limit() -> None:
    """RC-405: brakes to a stop at the limit, then an error; ErrorStop until a reset."""
    rig = AxesRig()
    rig.absolute(9990.0)
    rig.run_to_stand()
    rig.single.velocity(Z, 500.0, 1, ABORTING, OWNER)
    rig.run(200)
    assert rig.places[-1] == 10_000.0
    assert rig.state() == ERROR_STOP
    assert rig.absolute(0.0) == 60213
    assert [text for _, text in rig.reported[-3:]] == [
        "axis Z begun positive",
        "error 1702",
        "axis Z failed",
    ]
    assert_no_step(rig.places)
    rig.channel.clear_error()
    rig.channel.request_reset()
    rig.run(2)
    assert rig.state() == STANDSTILL
    assert rig.absolute(0.0) == 0


def test_a_target_beyond_a_limit_moves_nothing() -> None:
    """RC-406."""
    rig = AxesRig()
    assert rig.absolute(10_000.5) == 60158
    assert rig.single.relative(Z, -10_000.5, 500.0, ABORTING, OWNER) == 60159
    assert rig.run(3) == [0.0, 0.0, 0.0]
    assert rig.reported == []


def test_hold_and_continue() -> None:
    """RC-111: brakes from that tick on, keeps its target, goes on from the state of now."""
    rig = AxesRig()
    rig.absolute(10.0, 100.0)
    rig.run(50)
    rig.single.command_owner("hold", OWNER)
    rig.run(10)
    assert rig.state() == STOPPING
    rig.run(15)
    assert rig.state() == STANDSTILL
    assert rig.places[-1] == pytest.approx(5.0)
    assert rig.single.opened(OWNER) == 1
    assert rig.run(5) == [rig.places[-1]] * 5
    rig.single.command_owner("resume", OWNER)
    rig.run(10)
    rig.single.command_owner("hold", OWNER)
    rig.run(2)
    rig.single.command_owner("resume", OWNER)
    rig.run_to_stand()
    assert rig.places[-1] == 10.0
    assert_no_step(rig.places, top=100.0)


def test_hold_of_a_motion_that_waits_after_another_owners() -> None:
    """RC-111: the other owner's goes on; the waiting one begins held, and CONTINUE lets it go."""
    rig = AxesRig()
    rig.single.absolute(Z, 10.0, 100.0, ABORTING, SHORTEST, OWNER + 1)
    rig.run(20)
    rig.absolute(20.0, 100.0, BUFFERED)
    rig.single.command_owner("hold", OWNER)
    rig.run(180)
    assert rig.places[124] == rig.places[-1] == 10.0
    assert rig.state() == STANDSTILL
    assert rig.single.opened(OWNER) == 1
    assert rig.single.moves(Z)
    rig.single.command_owner("resume", OWNER)
    assert rig.run_to_stand() == 125
    assert rig.places[-1] == 20.0
    assert_no_step(rig.places, top=100.0)
    assert [text for _, text in rig.reported[1:]] == [
        "axis Z done",
        "axis Z begun 20",
        "axis Z held",
        "axis Z continued",
        "axis Z done",
    ]


def test_hold_of_a_motion_that_waits_for_anothers_speed() -> None:
    """RC-111: the endless motion in front does not end for one that is held."""
    rig = AxesRig()
    rig.single.velocity(Z, 40.0, 1, ABORTING, OWNER + 1)
    rig.absolute(20.0, 100.0, BUFFERED)
    rig.single.command_owner("hold", OWNER)
    rig.run(60)
    assert rig.single.present_owner(Z) == OWNER + 1
    assert rig.single.ending_count() == 0
    rig.single.command_owner("resume", OWNER)
    rig.run_to_stand()
    assert rig.places[-1] == 20.0
    assert_no_step(rig.places, top=100.0)


def test_the_error_of_an_axis_without_a_channel(tmp_path: Path) -> None:
    """PLCopen's ErrorStop: no channel is reported and none resets it; its own reset does."""
    fewer = machine_with(tmp_path, {"gruppe[0].achs_anzahl": "gruppe[0].achs_anzahl 2"})
    rig = AxesRig(machine=fewer)
    assert rig.single.velocity(Z, 500.0, 1, ABORTING, OWNER) == 0
    rig.run(20_200)
    assert rig.reported[-1][1] == "axis Z failed"
    assert (rig.state(), rig.single.fault_of(Z)) == (ERROR_STOP, 1702)
    assert rig.single.faults.open_count == 0
    assert not rig.channel.executor.is_stopped
    assert rig.absolute(0.0) == 60213
    rig.single.clear(Z)
    assert (rig.state(), rig.single.fault_of(Z)) == (STANDSTILL, 0)
    assert rig.absolute(0.0) == 0


def test_abort_drops_held_and_waiting_motions() -> None:
    """RC-111: ABORT ACTION."""
    rig = AxesRig()
    rig.absolute(10.0, 100.0)
    rig.absolute(20.0, 100.0, BUFFERED)
    rig.run(50)
    rig.single.command_owner("hold", OWNER)
    rig.run(30)
    rig.single.command_owner("abort", OWNER)
    assert rig.single.opened(OWNER) == 0
    rig.run(5)
    assert rig.state() == STANDSTILL
    assert rig.places[-1] == pytest.approx(5.0)
    texts = [text for _, text in rig.reported]
    assert texts == ["axis Z begun 10", "axis Z held", *["axis Z aborted"] * 2, "axis Z stopped"]


def test_motions_that_go_on_without_their_owner() -> None:
    """RC-110: MOVE_CONT."""
    rig = AxesRig()
    rig.absolute(10.0)
    rig.run(5)
    rig.single.command_owner("leave", OWNER)
    assert rig.single.opened(OWNER) == 0
    rig.run_to_stand()
    assert rig.places[-1] == 10.0


def test_modulo_the_short_way_and_a_given_direction() -> None:
    """MO-11: from 350° to 10° is 20° forward the short way, 340° back in negative direction."""
    rig = AxesRig(A)
    rig.absolute(350.0)
    rig.run_to_stand()
    assert min(rig.places) == pytest.approx(-10.0, abs=0.01)
    assert rig.places[-1] == 350.0
    rig.absolute(10.0)
    rig.run_to_stand()
    assert max(rig.places) == pytest.approx(370.0, abs=0.01)
    assert rig.places[-1] == 10.0
    rig.single.absolute(A, 350.0, 360.0, ABORTING, 1, OWNER)
    first = len(rig.places)
    rig.run_to_stand()
    assert min(rig.places[first:]) > 10.0
    assert rig.places[-1] == 350.0
    rig.single.absolute(A, 10.0, 360.0, ABORTING, -1, OWNER)
    rig.run_to_stand()
    assert rig.places[-1] == 10.0


def test_modulo_never_comes_back_in_a_given_direction() -> None:
    """A target that lies within the braking distance is reached a turn later."""
    rig = AxesRig(A)
    rig.single.velocity(A, 360.0, 1, ABORTING, OWNER)
    rig.run(500)
    here = rig.places[-1]
    rig.single.absolute(A, (here + 1.0) % 360.0, 360.0, ABORTING, 1, OWNER)
    rig.run_to_stand()
    assert max(rig.places) == pytest.approx(here + 361.0, abs=0.01)
    assert_no_step(rig.places[:-1], top=360.0)


def test_the_path_owns_what_its_block_moves() -> None:
    """MO-13: a command for an axis of the current block is refused; another axis takes it."""
    rig = AxesRig(X)
    rig.segment(10.0)
    rig.run(5)
    assert rig.state() == SYNCHRONIZED
    assert rig.absolute(50.0) == 50603
    assert rig.single.absolute(Z, 5.0, 500.0, ABORTING, SHORTEST, OWNER) == 0
    rig.run_to_the_end()
    assert rig.places[-1] == 10.0
    rig.run(1)
    assert rig.state() == STANDSTILL


def test_the_path_does_not_take_an_axis_in_motion() -> None:
    """MO-13: the block is an error, and nothing jumps."""
    rig = AxesRig(X)
    rig.absolute(5.0)
    rig.run(3)
    rig.segment(10.0)
    rig.run(1)
    assert rig.reported[-1][1] == "error 50766"
    rig.channel.clear_error()
    rig.run_to_stand()
    assert rig.places[-1] == 5.0


def test_reset_brakes_and_ends_at_standstill() -> None:
    """RC-007: 40 mm/s take 10 ticks to brake; the reset is over when the axis is at rest."""
    rig = AxesRig()
    rig.absolute(100.0)
    rig.run(10)
    rig.channel.request_reset()
    ticks = 0
    while rig.channel.executor.is_resetting:
        rig.run(1)
        ticks += 1
    assert ticks == 10
    assert rig.state() == STANDSTILL
    assert_no_step(rig.places)


# --- other machines ----------------------------------------------------------------------------


def machine_with(folder: Path, changes: dict[str, str]) -> AssembledMachine:
    """The demo machine with other lines in its lists: beginning of the old line -> new line."""
    shutil.copytree(DEMO.folder, folder / "machine")
    for path in sorted((folder / "machine").glob("*.lis")):
        lines = path.read_text("utf-8").split("\n")
        for begin, line in changes.items():
            lines = [line if one.startswith(begin) else one for one in lines]
        path.write_text("\n".join(lines), "utf-8")
    return AssembledMachine(load_machine(folder / "machine"))


def test_a_jerk_limited_motion_by_hand(tmp_path: Path) -> None:
    """P-CHAN-00071 is 1: jerk 4000 mm/s² / 50 ms = 80 000 mm/s³ (P-AXIS-00196).

    100 mm/s are reached in 2·√(100/80000) = 0.070711 s; 10 mm take 0.1 s more: 171 ticks. After
    i ≤ 35 ticks j·t³/6 = 80000/6·i³·1e-9 mm.
    """
    rig = AxesRig(
        machine=machine_with(tmp_path, {"prog_start.slope": "prog_start.slope.profile 1"})
    )
    rig.absolute(10.0, 100.0)
    assert rig.run_to_stand() == 171
    assert rig.places[9] == pytest.approx(80_000 / 6 * 1000e-9)
    assert rig.places[34] == pytest.approx(80_000 / 6 * 42_875e-9)
    assert rig.places[-1] == 10.0


def test_a_jerk_limited_motion_is_stopped_and_turned_without_a_step(tmp_path: Path) -> None:
    """MO-11: ABORTING in mid-acceleration, a stop, an override: jerk within its limit."""
    rig = AxesRig(
        machine=machine_with(tmp_path, {"prog_start.slope": "prog_start.slope.profile 1"})
    )
    rig.absolute(100.0, 300.0)
    rig.run(40)
    rig.absolute(-20.0, 500.0)
    rig.run(90)
    rig.single.command_owner("hold", OWNER)
    rig.run(20)
    rig.single.command_owner("resume", OWNER)
    rig.run_to_stand()
    assert rig.places[-1] == -20.0
    assert_no_step(rig.places)
    speeds = [b - a for a, b in itertools.pairwise([0.0, 0.0, *rig.places])]
    rises = [b - a for a, b in itertools.pairwise(speeds)]
    jerks = [abs(b - a) / 1e-9 for a, b in itertools.pairwise(rises)]
    assert max(jerks) <= 80_000 * (1 + 1e-6)


@pytest.mark.parametrize(("share", "error"), [("0", 2.0), ("3", 0.5)])
def test_the_drive_lags_by_speed_over_gain(tmp_path: Path, share: str, error: float) -> None:
    """MO-10: kv 50/s, 100 mm/s: 2 mm behind; with 3/4 of feed-forward 0.5 mm.

    Where the axis is at rest, the error falls by exp(-0.05) a tick.
    """
    changes = {
        "antr.simu.ist_gleich_soll": "vorsteuer.vorsteuerung VEL\nvorsteuer.default_active 1\n"
        f"vorsteuer.vs_v_faktor {share}\nvorsteuer.vs_v_nenner 4",
        "getriebe[0].vb_eilgang": "getriebe[0].vb_eilgang P-AXIS-00212.0\ngetriebe[0].kv 5000",
    }
    rig = AxesRig(machine=machine_with(tmp_path, changes))
    cells = rig.machine.cells
    command = rig.machine.signals()["Z.ACS.ACT_POS"][0]
    actual = rig.machine.signals()["Z.ACS.CUR_POS"][0]
    rig.single.velocity(Z, 100.0, 1, ABORTING, OWNER)
    rig.run(600)
    assert cells[command] - cells[actual] == pytest.approx(error, rel=1e-6)
    rig.single.halt(Z, OWNER)
    rig.run_to_stand()
    before = cells[command] - cells[actual]
    rig.run(10)
    assert cells[command] - cells[actual] == pytest.approx(before * math.exp(-0.5))
    rig.run(1000)
    assert cells[command] == cells[actual]


@pytest.mark.parametrize(("mode", "ticks"), [(0, 213), (1, 213), (2, 125)])
def test_which_override_a_motion_follows(mode: int, ticks: int) -> None:
    """P-AXIS-00491: the channel's (50 %: 10 mm at 50 mm/s), the lesser one, or the axis' own.

    10 mm at 50 mm/s take 10/50 + 50/4000 s: 213 ticks; at 100 mm/s 125.
    """
    rig = AxesRig()
    rig.machine.axes.set_override(Z, mode, 100.0)
    rig.machine.access.write("HLI.OVERRIDE", 50.0)
    rig.absolute(10.0, 100.0)
    assert rig.run_to_stand() == ticks


def test_at_zero_percent_the_motion_stops_and_continues() -> None:
    """MO-11: override 0 brakes to a standstill, the motion stays; with 100 % it goes on."""
    rig = AxesRig()
    rig.absolute(10.0, 100.0)
    rig.run(50)
    rig.machine.access.write("HLI.OVERRIDE", 0.0)
    rig.run(50)
    assert rig.places[-1] == pytest.approx(5.0)
    assert rig.state() == DISCRETE
    rig.machine.access.write("HLI.OVERRIDE", 100.0)
    rig.run(1)
    rig.run_to_stand()
    assert rig.places[-1] == 10.0
    assert_no_step(rig.places, top=100.0)


def test_half_a_turn_goes_forward() -> None:
    """From 0° to 180°: neither way is shorter."""
    rig = AxesRig(A)
    rig.absolute(180.0)
    rig.run_to_stand()
    assert min(rig.places) >= 0.0
    assert rig.places[-1] == 180.0


def test_the_feed_hold_of_the_channel_stops_independent_motions() -> None:
    """P-AXIS-00540, 0 where it is not given: 1.25 mm to brake from 3.75 mm, then to the target."""
    rig = AxesRig()
    rig.absolute(10.0, 100.0)
    rig.run(50)
    rig.machine.access.write("HLI.FEED_HOLD", 1.0)
    rig.run(50)
    assert rig.places[-1] == pytest.approx(5.0)
    rig.machine.access.write("HLI.FEED_HOLD", 0.0)
    rig.run(1)
    rig.run_to_stand()
    assert rig.places[-1] == 10.0
    assert_no_step(rig.places, top=100.0)


def test_an_axis_may_ignore_the_feed_hold_of_the_channel() -> None:
    """P-AXIS-00540 = 1: only the feed hold of the axis itself stops it."""
    rig = AxesRig()
    rig.machine.axes.set_override(Z, 0, 100.0, ignores_hold=True)
    rig.machine.access.write("HLI.FEED_HOLD", 1.0)
    rig.absolute(10.0, 100.0)
    assert rig.run_to_stand() == 125
