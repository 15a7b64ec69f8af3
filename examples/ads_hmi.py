# SPDX-License-Identifier: MIT
"""An HMI that knows only the controller's names: ``python ads_hmi.py HOST:PORT NETID PROGRAM``.

It announces itself as the PLC, loads and starts a program by the operation mode manager, takes the
override over, lets one block after the other go, holds and continues, acknowledges M functions,
shows positions and errors, and resets at the end. Needs pyads; start a controller before it, for
example ``nctakt serve crossing.nc --ads --wait-for-start``.
"""

from __future__ import annotations

import struct
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pyads

CHANNEL = "HLI_Global_Variables.gpCh[0]^"
PATH = f"{CHANNEL}.bahn_mc_control"
MODE = f"{CHANNEL}.channel_mc_control.mode_and_state"
#: Mode and states of the operation mode manager (HLI_IMCM_…).
AUTOMATIC, ACTIVE, HOLD, RESETTING = 2, 4, 5, 15
LIMIT_S = 60.0


class Hmi:
    """The machine by its interface."""

    def __init__(self, plc: pyads.Connection) -> None:
        self._plc = plc
        self.write(f"{CHANNEL}.head.plc_present_w", True, pyads.PLCTYPE_BOOL)
        self.write(f"{MODE}.enable_w", True, pyads.PLCTYPE_BOOL)

    def write(self, path: str, value: object, type_: type) -> None:
        """Write an element."""
        self._plc.write_by_name(path, value, type_)

    def number(self, path: str, type_: type) -> float:
        """Read an element."""
        return float(self._plc.read_by_name(path, type_))

    def command(self, unit: str, value: object, type_: type) -> None:
        """Take a control unit over with a value."""
        self.write(f"{PATH}.{unit}.command_w", value, type_)
        self.write(f"{PATH}.{unit}.enable_w", True, pyads.PLCTYPE_BOOL)

    def go_to(self, state: int, program: str = "") -> None:
        """Command a transition, and wait until the controller has taken it."""
        data = struct.pack("<6I300sI", 0, 0, AUTOMATIC, state, 1, 0, program.encode("cp1252"), 0)
        self.write(f"{MODE}.command_w", list(data), pyads.PLCTYPE_BYTE * len(data))
        self.write(f"{MODE}.command_semaphor_rw", True, pyads.PLCTYPE_BOOL)
        self.until(lambda: not self.number(f"{MODE}.command_semaphor_rw", pyads.PLCTYPE_BOOL))

    @property
    def state(self) -> int:
        """The state of the mode."""
        return int(self.number(f"{MODE}.state_r.state", pyads.PLCTYPE_UDINT))

    @property
    def position_mm(self) -> float:
        """The command position of the first axis."""
        path = f"{CHANNEL}.bahn_state.coord_r[0].act_position_r"
        return self.number(path, pyads.PLCTYPE_DINT) / 10_000

    def acknowledge(self) -> int:
        """Acknowledge the functions that have come; return how many.

        Those of blocks are in the first area, those of realtime cycles in the second one.
        """
        acknowledged = 0
        for area in ("std_sync", "late_sync"):
            used = int(self.number(f"{CHANNEL}.used_units_{area}_r", pyads.PLCTYPE_UINT))
            for index in range(used):
                unit = f"{CHANNEL}.techno_unit_{area}[{index}]"
                if self.number(f"{unit}.please_rw", pyads.PLCTYPE_BOOL):
                    self.write(f"{unit}.please_rw", False, pyads.PLCTYPE_BOOL)
                    self.write(f"{unit}.done_w", True, pyads.PLCTYPE_BOOL)
                    acknowledged += 1
        return acknowledged

    def go_on(self) -> int:
        """Press START if single block waits for it; return how often."""
        if not self.number(f"{CHANNEL}.bahn_state.wait_continue_r", pyads.PLCTYPE_BOOL):
            return 0
        for pressed in (True, False):  # its rising edge counts
            self.command("continue_on", pressed, pyads.PLCTYPE_BOOL)
        return 1

    def error(self) -> int:
        """Return the number of a new error, 0 without one."""
        if not self.number(f"{CHANNEL}.mc_error.semaphor_rw", pyads.PLCTYPE_BOOL):
            return 0
        number = int(self.number(f"{CHANNEL}.mc_error.satz_r.kopf.error_id", pyads.PLCTYPE_UDINT))
        self.write(f"{CHANNEL}.mc_error.semaphor_rw", False, pyads.PLCTYPE_BOOL)
        return number

    @staticmethod
    def until(holds: Callable[[], bool]) -> None:
        """Wait until something holds; raises ``TimeoutError``."""
        end = time.monotonic() + LIMIT_S
        while not holds():
            if time.monotonic() > end:
                raise TimeoutError
            time.sleep(0.005)

    def leave(self) -> None:
        """Give the control units back; functions acknowledge themselves again."""
        for unit in ("override", "single_block", "continue_on"):
            self.write(f"{PATH}.{unit}.enable_w", False, pyads.PLCTYPE_BOOL)
        self.write(f"{CHANNEL}.head.plc_present_w", False, pyads.PLCTYPE_BOOL)


def drive(plc: pyads.Connection, program: str) -> None:
    """Run a program block by block with half of the override, held once; then reset."""
    hmi = Hmi(plc)
    hmi.command("override", 500, pyads.PLCTYPE_UINT)
    hmi.command("single_block", True, pyads.PLCTYPE_BOOL)
    hmi.go_to(ACTIVE, program)
    hmi.until(lambda: hmi.go_on() == 1)
    starts = 1
    hmi.go_to(HOLD)
    hmi.until(lambda: hmi.state == HOLD)
    print(f"held at X {hmi.position_mm:.4f} mm")
    hmi.go_to(ACTIVE)
    functions = hmi.acknowledge()
    while hmi.state in (ACTIVE, HOLD):
        functions += hmi.acknowledge()
        starts += hmi.go_on()
        if number := hmi.error():
            print(f"error {number}")
            break
        time.sleep(0.005)
    hmi.go_to(RESETTING)
    print(f"ended at X {hmi.position_mm:.4f} mm, {starts} times START, {functions} functions")
    hmi.leave()


def main(address: str, net_id: str, program: str) -> None:
    """Connect and drive."""
    pyads.open_port()
    pyads.set_local_address("10.0.0.7.1.1")
    pyads.close_port()
    with pyads.Connection(net_id, 851, address) as plc:
        plc.set_timeout(20_000)
        drive(plc, str(Path(program)))


if __name__ == "__main__":
    main(*sys.argv[1:])
