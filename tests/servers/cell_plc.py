# SPDX-License-Identifier: MIT
"""The PLC of a cell, by the vendor's own library: cell_plc.py HOST:PORT NETID.

It clamps the part (V.E.INPUT) as soon as the program asks for it (V.E.OUTPUT).
"""

from __future__ import annotations

import sys
import time

import pyads

LIMIT_S = 60.0


def main(address: str, net_id: str) -> None:
    """Wait for the program's wish and grant it."""
    pyads.open_port()
    pyads.set_local_address("10.0.0.9.1.1")
    pyads.close_port()
    cnc = pyads.Connection(net_id, 851, address)
    cnc.open()
    end = time.monotonic() + LIMIT_S
    while cnc.read_by_name("V.E.OUTPUT", pyads.PLCTYPE_LREAL) != 7.0:
        assert time.monotonic() < end, "the program has asked for nothing"
        time.sleep(0.01)
    cnc.write_by_name("V.E.INPUT", 1.0, pyads.PLCTYPE_LREAL)
    cnc.close()


if __name__ == "__main__":
    main(*sys.argv[1:])
