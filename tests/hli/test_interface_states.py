# SPDX-License-Identifier: MIT
"""The state machines of the interface (docs/hli.md): any order of commands, and again the same.

``NCTAKT_SEEDS=1000`` makes as many orders.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import HealthCheck, Phase, seed, settings
from hypothesis import strategies as st
from hypothesis.stateful import (
    RuleBasedStateMachine,
    initialize,
    invariant,
    rule,
    run_state_machine_as_test,
)
from support.insides import machine_of
from support.random_seeds import FIRST, examples

from nctakt import Controller, Failure, NcText, Session
from nctakt.hli import table

PROGRAM = NcText(
    "cell.nc", "N10 G01 X100 F6000\nN20 M100\nN30 G01 X0 Y50\nN40 M40\nN50 G01 Y0\nN60 M30\n"
)
CHANNEL, AXIS = "gpCh[0]^", "gpAx[0]^"
PRESENT = f"{CHANNEL}.head.plc_present_w"
WATCHDOG = f"{CHANNEL}.head.mc_watchdog"
MODE = f"{CHANNEL}.channel_mc_control.mode_and_state"
RELEASES = ("drive_on", "torque_permission", "release_feedhold")

#: Control units of a channel, the values that they set, and how many of its units one of these is.
UNITS = {
    "bahn_mc_control.override": ("HLI.OVERRIDE", 10, 100.0),
    "bahn_mc_control.feedhold": ("HLI.FEED_HOLD", 1, 0.0),
    "bahn_mc_control.single_block": ("HLI.SINGLE_BLOCK", 1, 0.0),
    "bahn_mc_control.m01_stop_enable": ("HLI.OPTIONAL_STOP", 1, 0.0),
}


class Unit:
    """A control unit as docs/hli.md draws it: who decides, and what is in force."""

    def __init__(self, start: float) -> None:
        self.enable = False
        self.command = self.request = self.in_force = start

    def decide(self, was_decided: bool, is_decided: bool) -> None:
        """The PLC begins or ends to decide: its command, or again the wish of the HMI."""
        if is_decided and not was_decided:
            self.request, self.in_force = self.in_force, self.command
        elif was_decided and not is_decided:
            self.in_force = self.request


class Interface(RuleBasedStateMachine):
    """A PLC and an HMI that write what they like, when they like."""

    def __init__(self) -> None:
        super().__init__()
        self.controller = Controller()
        self.writes: list[tuple[int, str, float | str]] = []
        self.present = False
        self.units = {path: Unit(factor * start) for path, (_, factor, start) in UNITS.items()}
        self.releases: dict[str, list[bool]] = {name: [False, False] for name in RELEASES}
        self.axis_present = False

    @initialize()
    def begin(self) -> None:
        """Start the program."""
        self.controller.start(PROGRAM)

    def write(self, name: str, value: float | str) -> None:
        """Write now, and remember it."""
        self.controller.write(name, value)
        self.writes.append((self.controller.tick, name, value))

    @rule(
        path=st.sampled_from(list(UNITS)),
        part=st.sampled_from(("enable_w", "command_w")),
        number=st.integers(0, 2),
    )
    def write_unit(self, path: str, part: str, number: int) -> None:
        unit = self.units[path]
        if part == "enable_w":
            was = unit.enable and self.present
            unit.enable = number > 0
            self.write(f"{CHANNEL}.{path}.enable_w", float(number > 0))
            unit.decide(was, unit.enable and self.present)
            return
        value = 500.0 * number if "override" in path else float(number > 0)
        unit.command = value
        self.write(f"{CHANNEL}.{path}.command_w", value)
        if unit.enable and self.present:
            unit.in_force = value

    @rule(path=st.sampled_from(list(UNITS)), number=st.integers(0, 1))
    def ask(self, path: str, number: int) -> None:
        unit = self.units[path]
        unit.request = 700.0 * number if "override" in path else float(number)
        self.write(f"ask {CHANNEL}.{path}", unit.request)
        if not (unit.enable and self.present):
            unit.in_force = unit.request

    @rule(is_there=st.booleans())
    def announce(self, is_there: bool) -> None:
        was, self.present = self.present, is_there
        self.write(PRESENT, float(is_there))
        for unit in self.units.values():
            unit.decide(unit.enable and was, unit.enable and is_there)
        hold = self.units["bahn_mc_control.feedhold"]  # a transition that stood is taken now
        hold.in_force = float(bool(self.controller.read("HLI.FEED_HOLD")))

    @rule(name=st.sampled_from(RELEASES), at=st.integers(0, 1), value=st.booleans())
    def release(self, name: str, at: int, value: bool) -> None:
        self.releases[name][at] = value
        part = ("command_w", "enable_w")[at]
        self.write(f"{AXIS}.lr_mc_control.{name}.{part}", float(value))

    @rule(is_there=st.booleans())
    def announce_axis(self, is_there: bool) -> None:
        self.axis_present = is_there
        self.write(f"{AXIS}.head.plc_present_w", float(is_there))

    @rule(part=st.sampled_from(("enable_w", "alive_rw")), value=st.booleans())
    def watch(self, part: str, value: bool) -> None:
        self.write(f"{WATCHDOG}.{part}", float(value))

    @rule(state=st.sampled_from((2, 4, 5, 15)), is_enabled=st.booleans(), goes=st.booleans())
    def transit(self, state: int, is_enabled: bool, goes: bool) -> None:
        """A semaphore may be left standing: then nothing is in force until the PLC is there."""
        self.write(f"{MODE}.enable_w", float(is_enabled))
        self.write(f"{MODE}.command_w.to_mode", 2.0)
        self.write(f"{MODE}.command_w.to_state", float(state))
        self.write(f"{MODE}.command_semaphor_rw", float(goes))
        hold = self.units["bahn_mc_control.feedhold"]
        hold.in_force = float(bool(self.controller.read("HLI.FEED_HOLD")))
        standing = self.controller.read(f"{MODE}.command_semaphor_rw")
        assert standing == (goes and not (self.present and is_enabled))

    @rule(
        array=st.sampled_from(("std", "late")),
        index=st.integers(0, 19),
        flag=st.sampled_from(("please_rw", "done_w")),
        value=st.booleans(),
    )
    def answer(self, array: str, index: int, flag: str, value: bool) -> None:
        """Also where nothing waits: a forged or a stale acknowledgement does nothing."""
        self.write(f"{CHANNEL}.techno_unit_{array}_sync[{index}].{flag}", float(value))

    @rule(ticks=st.sampled_from((1, 3, 40, 120)))
    def step(self, ticks: int) -> None:
        self.controller.step(ticks)

    @rule()
    def look(self) -> None:
        """Somebody reads: nothing comes of it."""
        self.controller.read(whole_name(CHANNEL))

    @invariant()
    def what_is_in_force_follows_from_who_decides(self) -> None:
        if self.controller.tick == 0 and not self.writes:
            return
        for path, unit in self.units.items():
            name, factor, _ = UNITS[path]
            assert self.controller.read(name) * factor == unit.in_force, path  # type: ignore[operator]
            assert self.controller.read(f"{CHANNEL}.{path}.state_r") == unit.in_force
        released = not self.axis_present or all(all(one) for one in self.releases.values())
        assert machine_of(self.controller).axes.is_locked(0) is not released

    def teardown(self) -> None:
        """Whoever writes the same in the same ticks gets the same bytes, without having read."""
        again, end = Controller(), self.controller.tick
        again.start(PROGRAM)
        for tick, name, value in self.writes:
            again.step(tick - again.tick)
            again.write(name, value)
        again.step(end - again.tick)
        for pointer in (CHANNEL, AXIS):
            name = whole_name(pointer)
            assert again.read(name) == self.controller.read(name)


def whole_name(pointer: str) -> str:
    """The name of all bytes after a pointer."""
    size = table.root(pointer.partition("[")[0]).type.size_bytes
    return f"{pointer}:0+{size}"


def test_units_do_what_their_state_machines_say_in_any_order() -> None:
    run_state_machine_as_test(
        seed(FIRST)(Interface),
        settings=settings(
            max_examples=examples(4),
            stateful_step_count=30,
            deadline=None,
            database=None,
            phases=(Phase.generate, Phase.shrink),
            suppress_health_check=list(HealthCheck),
        ),
    )


def test_going_back_restores_units_and_a_tape_repeats_them(tmp_path: Path) -> None:
    """Units, releases, semaphores and read errors are state of the run (RC-002)."""
    unit = f"{CHANNEL}.bahn_mc_control.override"
    names = (f"{unit}.state_r", f"{unit}.enable_w", whole_name(CHANNEL), whole_name(AXIS))
    with Session(PROGRAM, acknowledges=False) as session:
        session.step(5)
        before = session.read(*names)
        session.write({PRESENT: 1.0, f"{unit}.command_w": 500.0, f"{unit}.enable_w": 1.0})
        session.step(5)
        after = session.read(*names)
        assert (before[:2], after[:2]) == ([1000, False], [500, True])
        session.go_to(5)
        assert session.read(*names) == before
        session.go_to(10)
        assert session.read(*names) == after
        session.write({f"{MODE}.command_semaphor_rw": 1.0, f"{MODE}.command_w.to_state": 5.0})
        session.step(20)
        end = session.read(*names)
        session.save(tmp_path / "units.tape")
    with Session.of_tape(tmp_path / "units.tape") as again:
        again.run()
        assert again.tick == 30
        assert again.read(*names) == end


def test_an_axis_of_a_plc_moves_with_its_three_releases_only() -> None:
    """Each needs enable_w and command_w; one taken away brakes at the limits, and why says so."""
    controller = Controller()
    controller.start(NcText("x.nc", "N10 G01 X100 F6000\nN20 M30\n"))
    controller.step(200)
    controller.write(f"{AXIS}.head.plc_present_w", 1.0)
    controller.step(200)
    assert controller.read("gpCh[0]^.bahn_state.active_feed_r") == 0.0
    assert not controller.read(f"{AXIS}.lr_mc_control.drive_on.state_r")
    position = controller.read("V.RTA.ACS.ACT_POS.X")
    assert position > 10.0  # it braked, and did not jump
    for name in RELEASES:
        assert controller.read("V.RTA.ACS.ACT_POS.X") == position
        for part in ("command_w", "enable_w"):
            controller.write(f"{AXIS}.lr_mc_control.{name}.{part}", 1.0)
        controller.step(100)
    assert controller.read("V.RTA.ACS.ACT_POS.X") > position
    assert controller.read(f"{AXIS}.lr_mc_control.drive_on.state_r")


def test_an_axis_in_independent_motion_needs_its_releases_too() -> None:
    cycle = "#RT CYCLE [ID=1]\n$IF ONCE 1\nY[INDP G90 G00 POS=20]\n$ENDIF\n#RT CYCLE END\n"
    controller = Controller()
    controller.start(NcText("y.nc", f"{cycle}N10 G04 1\nN20 M30\n"))
    controller.write("gpAx[1]^.head.plc_present_w", 1.0)
    controller.step(200)
    assert controller.read("V.RTA.ACS.ACT_POS.Y") == 0.0
    controller.write("gpAx[1]^.head.plc_present_w", 0.0)
    controller.step(400)
    assert controller.read("V.RTA.ACS.ACT_POS.Y") == 20.0


def test_a_plc_that_shows_no_sign_of_life_stops_its_channel() -> None:
    """100 ms; the CNC clears each sign; neither without a PLC nor before enable_w."""
    controller = Controller()
    controller.start(NcText("x.nc", "N10 G01 X100 F6000\nN20 M30\n"))
    controller.write(f"{WATCHDOG}.enable_w", 1.0)
    controller.step(200)
    assert controller.read("HLI.ERROR") == 0.0  # no PLC is there
    controller.write(PRESENT, 1.0)
    for _ in range(3):
        controller.write(f"{WATCHDOG}.alive_rw", 1.0)
        controller.step(90)
        assert not controller.read(f"{WATCHDOG}.alive_rw")
    assert controller.read("HLI.ERROR") == 0.0
    controller.step(10)
    assert controller.read("HLI.ERROR") == 0.0
    controller.step(2)
    assert controller.read("HLI.ERROR") == 902320.0
    assert controller.read(f"{CHANNEL}.mc_error.semaphor_rw")


def test_a_stale_or_forged_done_acknowledges_nothing() -> None:
    """The next function has another unit; a TRUE already in it is not its own."""
    controller = Controller()
    controller.write(PRESENT, 1.0)
    unit = f"{CHANNEL}.techno_unit_std_sync[0]"
    controller.write(f"{unit}.done_w", 1.0)
    controller.start(NcText("m.nc", "N10 M40\nN20 M41\nN30 G01 X1 F600\nN40 M30\n"))
    controller.step(50)
    assert controller.read(f"{unit}.please_rw")
    assert not controller.read(f"{unit}.done_w")
    controller.write(f"{unit}.please_rw", 0.0)
    controller.write(f"{unit}.done_w", 1.0)
    controller.step(5)
    assert controller.read(f"{unit}.please_rw")  # the second one, new
    assert not controller.read(f"{unit}.done_w")
    controller.step(100)
    assert controller.read("V.RTA.ACS.ACT_POS.X") == 0.0


@pytest.mark.parametrize(
    ("name", "value", "number"),
    [
        ("gpCh[0]^:1+1", "00", 902321),
        ("gpCh[0]^:0+999999", "00", 902321),
        ("gpCh[0]^:36+1", "0", 90),
        ("gpCh[0]^:36+1", "zz", 90),
        ("gpCh[0]^:36+1", 1.0, 90),
        ("gpCh[7]^:36+1", "00", 902103),
        ("gpAx[0]^.head.plc_presnt_w", 1.0, 902100),
        ("gpCh[0]^.bahn_state.coord_r[32].state_r", 1.0, 902101),
        ("gpCh[0]^.bahn_mc_control.override.state_r", 1.0, 902105),
        ("ask gpCh[0]^.bahn_mc_control.override", 1e9, 20847),
        ("kept ^x", "no digits", 90),
    ],
)
def test_what_does_not_fit_is_refused_by_any_door(
    name: str, value: float | str, number: int
) -> None:
    with pytest.raises(Failure) as caught:
        Controller().write(name, value)
    assert str(caught.value.diagnostics[0].id).startswith(str(number))
