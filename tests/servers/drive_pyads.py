# SPDX-License-Identifier: MIT
"""pyads, the vendor's own library, drives the ADS server: drive_pyads.py HOST:PORT NETID.

In its own process: the library may crash when its process ends in the middle.
"""

from __future__ import annotations

import contextlib
import io
import struct
import sys
import time
from collections.abc import Callable
from datetime import datetime
from itertools import pairwise
from pathlib import Path

import pyads

#: Opens a connection to a port.
Connect = Callable[[int], pyads.Connection]

LIMIT_S = 60.0


def until(holds: Callable[[], bool]) -> None:
    """Wait until something holds."""
    end = time.monotonic() + LIMIT_S
    while not holds():
        assert time.monotonic() < end
        time.sleep(0.005)


def try_device_and_state(plc: pyads.Connection, connect: Connect) -> None:
    """Device info, state; write control presses the operator's keys."""
    assert plc.read_device_info()[0] == "nctakt CNC"
    assert plc.read_state() == (pyads.ADSSTATE_RUN, 0)
    with connect(551) as cnc:
        cnc.write_control(pyads.ADSSTATE_STOP, 1, 0, pyads.PLCTYPE_INT)
        assert cnc.read_state()[0] == pyads.ADSSTATE_STOP
        assert plc.read_by_name("HLI.FEED_HOLD") is True
        cnc.write_control(pyads.ADSSTATE_RUN, 1, 0, pyads.PLCTYPE_INT)
        assert cnc.read_state()[0] == pyads.ADSSTATE_RUN


def try_values_by_name_and_handle(plc: pyads.Connection, connect: Connect) -> None:
    """Numbers, truth values, texts and arrays, written and read by name."""
    for name, value, type_ in (
        ("V.E.COUNT", 77, pyads.PLCTYPE_UDINT),
        ("V.E.SMALL", -5, pyads.PLCTYPE_SINT),
        ("V.E.FLAG", True, pyads.PLCTYPE_BOOL),
        ("V.E.SYNC", 0.25, pyads.PLCTYPE_LREAL),
        ("V.E.TEXT", "Grüße", pyads.PLCTYPE_STRING),
    ):
        plc.write_by_name(name, value, type_)
        assert plc.read_by_name(name, type_) == value
        assert plc.read_by_name(name) == value
    values = [1.5 * index for index in range(10)]
    plc.write_by_name("V.E.LIST", values, pyads.PLCTYPE_LREAL * 10)
    assert plc.read_by_name("V.E.LIST") == values
    assert plc.read_by_name("v.e.list[3]", pyads.PLCTYPE_LREAL) == 4.5
    handle = plc.get_handle("V.E.COUNT")
    assert plc.read_by_name("", pyads.PLCTYPE_UDINT, handle=handle) == 77
    plc.release_handle(handle)
    try:
        plc.read_by_name("V.E.NOTHING", pyads.PLCTYPE_UDINT)
    except pyads.ADSError as error:
        assert "1808" in str(error)
    else:
        raise AssertionError


def try_structures(plc: pyads.Connection, connect: Connect) -> None:
    """A structure as a whole, laid out as a PLC has it (P-STUP-00145)."""
    definition = (
        ("REAL64", pyads.PLCTYPE_LREAL, 1),
        ("LIST", pyads.PLCTYPE_DINT, 4),
    )
    name = "V.E.LEVEL_1_A[2].LEVEL_2_A[1]"
    value = {"REAL64": 2.5, "LIST": [1, -2, 3, -4]}
    plc.write_structure_by_name(name, value, definition)
    assert plc.read_structure_by_name(name, definition) == value
    assert plc.read_by_name(f"{name}.LIST[3]") == -4


def try_upload_of_symbols(plc: pyads.Connection, connect: Connect) -> None:
    """All symbols with their types; each can be read."""
    symbols = {symbol.name: symbol for symbol in plc.get_all_symbols()}
    assert symbols["V.E.LIST"].symbol_type == "ARRAY [0..9] OF LREAL"
    assert {"HLI.OVERRIDE", "X.ACS.ACT_POS", "V.E.LEVEL_1_A[0].LEVEL_2_A"} <= symbols.keys()
    names = [name for name, one in symbols.items() if "LEVEL" not in one.symbol_type]
    values = plc.read_list_by_name(names[:200])
    assert len(values) == 200
    assert plc.get_symbol("HLI.OVERRIDE").read() == 100.0


def try_sum_commands(plc: pyads.Connection, connect: Connect) -> None:
    """Several values in one request, and their errors."""
    answer = plc.write_list_by_name({"V.E.COUNT": 5, "V.E.SHORT": -6, "V.E.TEXT": "abc"})
    assert set(answer.values()) == {"no error"}
    names = ["V.E.COUNT", "V.E.SHORT", "V.E.TEXT", "HLI.OVERRIDE"]
    assert list(plc.read_list_by_name(names).values()) == [5, -6, "abc", 100.0]


def try_notifications(plc: pyads.Connection, connect: Connect) -> None:
    """On change: the value at once, each change once; cyclic: equal distances of machine time."""
    changes: list[tuple[datetime, int]] = []
    cyclic: list[datetime] = []

    @plc.notification(pyads.PLCTYPE_DINT)
    def note_change(handle: int, name: str, moment: datetime, value: int) -> None:
        changes.append((moment, value))

    @plc.notification(pyads.PLCTYPE_LREAL)
    def note_cycle(handle: int, name: str, moment: datetime, value: float) -> None:
        cyclic.append(moment)

    first = plc.read_by_name("V.E.COUNT_POS", pyads.PLCTYPE_DINT)
    on_change = pyads.NotificationAttrib(4, pyads.ADSTRANS_SERVERONCHA, 0, 0)
    each_20_ms = pyads.NotificationAttrib(8, pyads.ADSTRANS_SERVERCYCLE, 0, 20)
    handles = [
        plc.add_device_notification("V.E.COUNT_POS", on_change, note_change),
        plc.add_device_notification("X.ACS.ACT_POS", each_20_ms, note_cycle),
    ]
    until(lambda: len(changes) == 1)
    plc.write_by_name("V.E.TRIGGER", 1, pyads.PLCTYPE_DINT)
    until(lambda: len(changes) == 2)
    assert [value for _, value in changes] == [first, first + 1]
    until(lambda: len(cyclic) >= 20)
    for handle in handles:
        plc.del_device_notification(*handle)
    distances = {round((b - a).total_seconds(), 4) for a, b in pairwise(cyclic[1:])}
    assert distances == {0.02}


def try_objects_and_variables_of_the_decoder(plc: pyads.Connection, connect: Connect) -> None:
    """A client that knows nothing walks the objects; variables by handle (AD-4, AD-5)."""
    with connect(553) as cnc:
        highest = cnc.read(0x123301, 0, pyads.PLCTYPE_UDINT)
        names = {}
        for number in range(highest + 1):
            with contextlib.suppress(pyads.ADSError):  # there is none of this number
                names[cnc.read(0x123401, number, pyads.PLCTYPE_STRING)] = number
        assert names["channel 1"] == 0
        assert cnc.read(0x123501, names["HLI.OVERRIDE"], pyads.PLCTYPE_STRING) == "REAL64"
        assert cnc.read(0x123401, 0x10000, pyads.PLCTYPE_STRING) == "X"
    with connect(552) as cnc:
        type_ = pyads.PLCTYPE_STRING
        handle = cnc.read_write(0x122301, 0x46, pyads.PLCTYPE_UDINT, "V.E.COUNT", type_)
        assert handle > 0


def try_an_hmi_that_knows_only_the_names_of_the_controller(
    plc: pyads.Connection, connect: Connect
) -> None:
    """Positions, override, feed hold, single block by control units and by objects (AD-3, AD-4)."""
    channel = "HLI_Global_Variables.gpCh[0]^"
    position = f"{channel}.bahn_state.coord_r[0].act_position_r"
    found = plc.read_list_by_name([position, "X.PCS.ACT_POS", f"{channel}.head.channel_nr"])
    assert found[position] == round(10_000 * found["X.PCS.ACT_POS"])
    assert found[f"{channel}.head.channel_nr"] == 1
    control = f"{channel}.bahn_mc_control"
    plc.write_by_name(f"{channel}.head.plc_present_w", True, pyads.PLCTYPE_BOOL)
    plc.write_by_name(f"{control}.feedhold.enable_w", True, pyads.PLCTYPE_BOOL)
    plc.write_by_name(f"{control}.feedhold.command_w", True, pyads.PLCTYPE_BOOL)
    until(lambda: plc.read_by_name("HLI.FEED_HOLD") is True)
    with connect(553) as hmi:
        hmi.write(0x120101, 0x9, 500, pyads.PLCTYPE_UINT)
        until(lambda: plc.read_by_name("HLI.OVERRIDE") == 50.0)
        assert hmi.read(0x120101, 0xA, pyads.PLCTYPE_UINT) == 500
        hmi.write(0x120101, 0x9, 1000, pyads.PLCTYPE_UINT)
        hmi.write(0x120101, 0x1, True, pyads.PLCTYPE_BOOL)
        until(lambda: hmi.read(0x120101, 0x3, pyads.PLCTYPE_BOOL) is True)
        hmi.write(0x120101, 0x1, False, pyads.PLCTYPE_BOOL)
    plc.write_by_name(f"{control}.feedhold.command_w", False, pyads.PLCTYPE_BOOL)
    plc.write_by_name(f"{control}.feedhold.enable_w", False, pyads.PLCTYPE_BOOL)
    plc.write_by_name(f"{channel}.head.plc_present_w", False, pyads.PLCTYPE_BOOL)
    until(lambda: plc.read_by_name("HLI.FEED_HOLD") is False)


def try_the_list_of_objects(plc: pyads.Connection, connect: Connect) -> None:
    """A client looks an object up by its name, and reads what it needs (AD-4)."""
    with connect(553) as hmi:
        count = hmi.read(0x130100, 0, pyads.PLCTYPE_UDINT)
        data = bytes(hmi.read(0x130100, 1, pyads.PLCTYPE_BYTE * (84 * count)))
        records = [data[at : at + 84] for at in range(0, len(data), 84)]
        found = {
            one[20:52].rstrip(b"\0").decode(): struct.unpack_from("<II", one, 12) for one in records
        }
        assert hmi.read(*found["cnc_number_of_channel_r"], pyads.PLCTYPE_UINT) == 1
        assert hmi.read(*found["mc_command_feedrate_r"], pyads.PLCTYPE_LREAL) >= 0.0
        tick = hmi.read(*found["cnc_tick_counter_r"], pyads.PLCTYPE_UDINT)
        until(lambda: hmi.read(*found["cnc_tick_counter_r"], pyads.PLCTYPE_UDINT) >= tick)


def try_selection_of_a_program(plc: pyads.Connection, connect: Connect) -> None:
    """Write control with the name of a file: it runs; one that is not there is refused."""
    position = plc.read_by_name("X.ACS.ACT_POS")
    until(lambda: plc.read_by_name("HLI.STATE") == 0)
    with connect(551) as cnc:
        cnc.write_control(8, 1, "back.nc", pyads.PLCTYPE_STRING)
        until(lambda: plc.read_by_name("X.ACS.ACT_POS") < position)
        try:
            cnc.write_control(8, 0, "nowhere.nc", pyads.PLCTYPE_STRING)
        except pyads.ADSError as error:
            assert error.err_code == 0x70B
        else:
            raise AssertionError("it is not there")


def try_the_hmi_of_the_examples(plc: pyads.Connection, connect: Connect) -> None:
    """It loads, starts, goes block by block, holds, acknowledges and resets by names alone."""
    until(lambda: plc.read_by_name("HLI.STATE") == 0)
    sys.path.insert(0, str(Path(__file__).parents[2] / "examples"))
    from ads_hmi import drive  # noqa: PLC0415 - its folder is known here only

    with contextlib.redirect_stdout(io.StringIO()) as out:
        drive(plc, "there.nc")
    assert out.getvalue().endswith("ended at X 60.0000 mm, 2 times START, 1 functions\n")


def main(address: str, net_id: str) -> None:
    """Try all."""
    pyads.open_port()
    pyads.set_local_address("10.0.0.8.1.1")
    pyads.close_port()

    def connect(port: int) -> pyads.Connection:
        connection = pyads.Connection(net_id, port, address)
        connection.open()
        connection.set_timeout(20_000)
        return connection

    for name, attempt in list(globals().items()):
        if name.startswith("try_"):
            with connect(851) as plc:
                attempt(plc, connect)
            print(name, flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
