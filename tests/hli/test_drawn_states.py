# SPDX-License-Identifier: MIT
"""The state machines of docs/hli.md against the controller: each event in each state.

The tables below the drawings are read. A transition that is in a table has to come, an event that
is not in it for a state has to leave that state as it is.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from itertools import product
from pathlib import Path

import pytest

from nctakt import Controller, NcText, Session

TEXT = (Path(__file__).parents[2] / "docs" / "hli.md").read_text("utf-8")
CHANNEL, AXIS = "gpCh[0]^", "gpAx[0]^"
RELEASES = ("drive_on", "torque_permission", "release_feedhold")
MODES = {2: "SELECTED", 3: "READY", 4: "ACTIVE", 5: "HOLD", 6: "ERROR", 15: "RESETTING"}


class ControlUnit:
    """The override in 0.1 %, which the PLC commands as 500 and the HMI asks for as 700."""

    def __init__(self) -> None:
        self.controller = Controller()
        self.unit = f"{CHANNEL}.bahn_mc_control.override"
        self.controller.write(f"{self.unit}.command_w", 500)
        self.events: dict[str, Callable[[], object]] = {
            "`plc_present_w` and `enable_w` TRUE": lambda: self.write(present=1, enable=1),
            "`enable_w` FALSE": lambda: self.write(enable=0),
            "`plc_present_w` FALSE": lambda: self.write(present=0),
        }

    def write(self, **flags: int) -> None:
        """Write the flags."""
        paths = {"present": f"{CHANNEL}.head.plc_present_w", "enable": f"{self.unit}.enable_w"}
        for name, value in flags.items():
            self.controller.write(paths[name], value)

    def state(self) -> str:
        """Who decides."""
        self.controller.write(f"ask {self.unit}", 700)
        return {50: "PLC", 70: "HMI"}[int(self.controller.read("HLI.OVERRIDE"))]


class Releases:
    """The releases of an axis, and its motion."""

    def __init__(self) -> None:
        self.controller = Controller()
        self.present = f"{AXIS}.head.plc_present_w"
        self.events: dict[str, Callable[[], object]] = {
            "`plc_present_w` TRUE": lambda: self.controller.write(self.present, 1),
            "`plc_present_w` FALSE": lambda: self.controller.write(self.present, 0),
            "all three TRUE": lambda: self.write(RELEASES, 1),
            "one of them FALSE": lambda: self.write(RELEASES[1:2], 0),
        }

    def write(self, names: tuple[str, ...], value: int) -> None:
        """Write releases."""
        for name, part in product(names, ("enable_w", "command_w")):
            self.controller.write(f"{AXIS}.lr_mc_control.{name}.{part}", value)

    def state(self) -> str:
        """Whether the axis moves, and whether a PLC is there for it."""
        self.controller.start(NcText("move.nc", "G91 G01 X1 F60000\nM30\n"))
        self.controller.step(50)
        before = self.controller.read("V.RTA.ACS.ACT_POS.X")
        self.controller.start(NcText("move.nc", "G91 G01 X1 F60000\nM30\n"))
        self.controller.step(100)
        moves = self.controller.read("V.RTA.ACS.ACT_POS.X") != before
        if not self.controller.read(self.present):
            assert moves
            return "no PLC"
        return "released" if moves else "locked"


class Watchdog:
    """The PLC shows that it lives."""

    def __init__(self) -> None:
        self.controller = Controller()
        self.controller.write(f"{CHANNEL}.head.plc_present_w", 1)
        self.unit = f"{CHANNEL}.head.mc_watchdog"
        self.events: dict[str, Callable[[], object]] = {
            "`enable_w` TRUE": lambda: self.write(1),
            "`enable_w` FALSE": lambda: self.write(0),
            "100 ms without `alive_rw`": lambda: self.controller.step(120),
            "RESET": self.reset,
        }

    def write(self, value: int) -> None:
        """Let it watch or not."""
        self.controller.write(f"{self.unit}.enable_w", value)
        self.controller.step()

    def reset(self) -> None:
        """Press RESET."""
        self.controller.hli.reset()
        self.controller.step(20)

    def state(self) -> str:
        """What it does."""
        if self.controller.read("HLI.ERROR") == 902320:
            return "error"
        for _ in range(3):  # 150 ms, each third with a sign of life
            self.controller.write(f"{self.unit}.alive_rw", 1)
            self.controller.step(50)
        assert self.controller.read("HLI.ERROR") == 0
        return "watches" if self.controller.read(f"{self.unit}.enable_w") else "off"


class TechnologyFunction:
    """The first unit of the channel."""

    def __init__(self) -> None:
        self.controller = Controller()
        self.controller.write(f"{CHANNEL}.head.plc_present_w", 1)
        self.unit = f"{CHANNEL}.techno_unit_std_sync[0]"
        self.events: dict[str, Callable[[], object]] = {
            "a function is put there": self.put,
            "`please_rw` FALSE": lambda: self.write("please_rw", 0),
            "`done_w` TRUE": lambda: self.write("done_w", 1),
        }

    def put(self) -> None:
        """Let a program put M40 there; while one waits, the program waits as well."""
        if self.state() == "free":
            self.controller.start(NcText("clamp.nc", "M40\nM30\n"))
        self.controller.step(5)

    def write(self, part: str, value: int) -> None:
        """Write a flag of the unit."""
        self.controller.write(f"{self.unit}.{part}", value)
        self.controller.step(5)

    def state(self) -> str:
        """Whether a function waits there, and whether it was read."""
        if not self.controller.read(f"{CHANNEL}.used_units_std_sync_r"):
            return "free"
        return "new" if self.controller.read(f"{self.unit}.please_rw") else "read"


class OperationMode:
    """The operation mode manager of a session that waits for START."""

    def __init__(self, folder: Path) -> None:
        self.part, self.bad = folder / "part.nc", folder / "bad.nc"
        self.part.write_text("G91 G01 X20 F6000\nM30\n", "utf-8")
        self.bad.write_text("G01 X5 F6000\n#ERROR [ID455 RC2]\nM30\n", "utf-8")
        self.session = Session(self.part, wait_for_start=True, stays=True)
        self.unit = f"{CHANNEL}.channel_mc_control.mode_and_state"
        self.session.write({f"{CHANNEL}.head.plc_present_w": 1, f"{self.unit}.enable_w": 1})
        self.session.step(2)
        self.events: dict[str, Callable[[], object]] = {
            "`to_state` 3 with a program": lambda: self.go(3, str(self.part)),
            "`to_state` 4": lambda: self.go(4),
            "`to_state` 5": lambda: self.go(5),
            "`to_state` 15": lambda: self.go(15, ticks=1),
            "the program ends": lambda: self.session.step(700),
            "the program has an error": self.fail,
            "the path stops": self.rest,
        }

    def go(self, state: int, program: str = "", ticks: int = 3) -> None:
        """Command a transition, all of it at once."""
        command = f"{self.unit}.command_w"
        data = {f"{command}.to_mode": 2, f"{command}.to_state": state}
        flag = {f"{self.unit}.command_semaphor_rw": 1}
        self.session.write({**data, f"{command}.parameter": program, **flag})
        self.session.step(ticks)

    def fail(self) -> None:
        """Let a program with an error run, where one runs."""
        if self.state() == "ACTIVE":
            self.go(15, ticks=60)
            self.go(3, str(self.bad))
            self.go(4, ticks=200)

    def rest(self) -> None:
        """Let a reset end."""
        if self.state() == "RESETTING":
            self.session.step(60)

    def state(self) -> str:
        """What is shown."""
        return MODES[int(self.session.read(f"{self.unit}.state_r.state")[0])]


#: A machine as the tests use it.
Machine = ControlUnit | Releases | Watchdog | TechnologyFunction | OperationMode

MACHINES: dict[str, Callable[[], Machine]] = {
    "control unit": ControlUnit,
    "releases": Releases,
    "watchdog": Watchdog,
    "function": TechnologyFunction,
}
FIRST = {"control unit": "HMI", "releases": "no PLC", "watchdog": "off", "function": "free"}
FIRST["operation mode"] = "READY"


def drawn(title: str) -> dict[tuple[str, str], str]:
    """The transitions of a table."""
    table = TEXT.partition(f"| {title}: from | what happens | to |\n|---|---|---|\n")[2]
    lines = [line.strip("|").split("|") for line in table.partition("\n\n")[0].splitlines()]
    assert lines
    found = {(one[0].strip(), one[1].strip()): one[2].strip() for one in lines}
    assert len(found) == len(lines)
    return found


def ways(title: str, first: str) -> dict[str, tuple[str, ...]]:
    """The events that lead to each state, by the table."""
    found: dict[str, tuple[str, ...]] = {first: ()}
    table = drawn(title)
    for _ in table:
        for (state, event), target in table.items():
            if state in found:
                found.setdefault(target, (*found[state], event))
    return found


def cases() -> Iterator[tuple[str, str, str]]:
    """Each event in each state of each machine."""
    for title, first in FIRST.items():
        table = drawn(title)
        events = dict.fromkeys(event for _, event in table)
        states = dict.fromkeys([state for state, _ in table] + list(table.values()))
        assert set(states) == set(ways(title, first))
        for state, event in product(states, events):
            if state != "RESETTING" or event == "the path stops":  # a reset ends by itself
                yield title, state, event


@pytest.mark.parametrize(("title", "state", "event"), [*cases()])
def test_each_event_does_what_is_drawn(title: str, state: str, event: str, tmp_path: Path) -> None:
    """In its state; elsewhere nothing."""
    table = drawn(title)
    machine: Machine = MACHINES[title]() if title in MACHINES else OperationMode(tmp_path)
    assert set(machine.events) == {event for _, event in table}
    for one in ways(title, FIRST[title])[state]:
        machine.events[one]()
    assert machine.state() == state
    machine.events[event]()
    assert machine.state() == table.get((state, event), state)
    if isinstance(machine, OperationMode):
        machine.session.close()


def test_the_drawings_name_the_states_of_the_tables() -> None:
    """In the drawing above each table."""
    for title in FIRST:
        above = TEXT.partition(f"| {title}: from |")[0]
        fences = re.findall(r"^```(\w*)\n(.*?)^```$", above, re.DOTALL | re.MULTILINE)
        language, drawing = fences[-1]
        assert not language
        for state in dict.fromkeys([one for one, _ in drawn(title)]):
            assert state.split()[-1] in drawing, (title, state)


@pytest.mark.parametrize("target", [1, 2])
def test_selected_and_deselected_reset_as_well(target: int, tmp_path: Path) -> None:
    """But in SELECTED, where nothing is to be reset."""
    machine = OperationMode(tmp_path)
    machine.go(target, ticks=1)
    assert machine.state() == "RESETTING"
    machine.session.step(60)
    machine.go(4)
    machine.session.step(700)
    assert machine.state() == "SELECTED"
    machine.go(target, ticks=1)
    assert machine.state() == "SELECTED"
    machine.session.close()


def test_active_comes_with_its_program(tmp_path: Path) -> None:
    """A program and its START in one command, written as one sum command of a client is."""
    machine = OperationMode(tmp_path)
    machine.go(4, ticks=700)
    assert machine.state() == "SELECTED"
    machine.go(4, str(machine.part), ticks=1)
    seen = [machine.state()]  # of the tick that takes START
    machine.session.step(1)
    assert (*seen, machine.state()) == ("SELECTED", "ACTIVE")
    machine.session.close()
