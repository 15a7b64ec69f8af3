# SPDX-License-Identifier: MIT
"""pyads uses the PLC through the ADS server: drive_pyads_plc.py HOST:PORT NETID."""

from __future__ import annotations

import sys
import threading
import time

import pyads

LIMIT_S = 60.0


def main(address: str, net_id: str) -> None:
    """Read, write, upload, listen."""
    pyads.open_port()
    pyads.set_local_address("10.0.0.8.1.1")
    pyads.close_port()
    with pyads.Connection(net_id, 851, address) as plc:
        plc.set_timeout(20_000)
        read(plc)
        came = threading.Event()
        attributes = pyads.NotificationAttrib(2)
        handles = plc.add_device_notification(
            "MAIN.fbGate.eState", attributes, lambda *_: came.set()
        )
        plc.write_by_name("MAIN.bGate", True, pyads.PLCTYPE_BOOL)
        assert came.wait(LIMIT_S)
        end = time.monotonic() + LIMIT_S
        while plc.read_by_name("MAIN.fbGate.eState", pyads.PLCTYPE_INT) != 5:
            assert time.monotonic() < end
        plc.del_device_notification(*handles)
        plc.write_by_name("MAIN.aTools[2].sName", "bit", pyads.PLCTYPE_STRING)
        assert plc.read_by_name("MAIN.aTools[2].sName") == "bit"
        assert plc.read_list_by_name(["MAIN.bGate", "MAIN.fReal"]) == {
            "MAIN.bGate": True,
            "MAIN.fReal": 0.5,
        }
        try:
            plc.get_handle("MAIN.fbGate#Open")
        except pyads.ADSError as error:
            assert error.err_code == 0x710
    print("all")


def read(plc: pyads.Connection) -> None:
    """Numbers, texts, arrays by name; all symbols."""
    for name, value, type_ in (
        ("MAIN.nBig", -5_000_000_000, pyads.PLCTYPE_LINT),
        ("MAIN.aTools[1].sName", "drill", pyads.PLCTYPE_STRING),
        ("MAIN.aMatrix[1,-1]", 4, pyads.PLCTYPE_INT),
        ("MAIN.aMatrix", [1, 2, 3, 4, 5, 6], pyads.PLCTYPE_INT * 6),
        ("main.twait", 1500, pyads.PLCTYPE_TIME),
    ):
        assert plc.read_by_name(name, type_) == value
    uploaded = {one.name: one.symbol_type for one in plc.get_all_symbols()}
    assert uploaded["MAIN.fbGate"] == "FB_Gate"
    assert uploaded["MAIN.aTools"] == "ARRAY [1..2] OF ST_Tool"


if __name__ == "__main__":
    main(*sys.argv[1:])
