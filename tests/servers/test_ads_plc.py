# SPDX-License-Identifier: MIT
"""Variables of a PLC in Structured Text over ADS: symbols with the types of its text (AD-3)."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from struct import pack

import pytest
from support.ads_server import Server, drive_with_npm

from nctakt.plc.structured_text import structured_programs
from nctakt.servers.ads.codes import AdsError, Error
from nctakt.servers.ads.plc_symbols import PlcSymbols
from nctakt.servers.ads.types import DataType
from nctakt.servers.ads.uploads import symbol_entry

FOLDER = Path(__file__).parent

PLC = """TYPE E_Gate : (Closed := 0, Open := 5); END_TYPE
TYPE ST_Tool : STRUCT nNumber : UINT; fLength : LREAL; sName : STRING(9); pNext : POINTER TO INT;
    END_STRUCT END_TYPE
FUNCTION_BLOCK FB_Gate
VAR_INPUT bUp : BOOL; END_VAR
VAR_OUTPUT eState : E_Gate; END_VAR
IF bUp THEN eState := E_Gate.Open; END_IF
END_FUNCTION_BLOCK
PROGRAM MAIN
VAR
    bGate AT %I* : BOOL;
    fbGate : FB_Gate;
    aTools : ARRAY[1..2] OF ST_Tool := [(nNumber := 7, fLength := 1.5, sName := 'drill')];
    aMatrix : ARRAY[0..1, -1..1] OF INT := [1, 2, 3, 4, 5, 6];
    fReal : REAL := 0.5;
    nBig : LINT := -5000000000;
    tWait : TIME := T#1500MS;
END_VAR
fbGate(bUp := bGate);
END_PROGRAM
"""


@pytest.fixture
def symbols(tmp_path: Path) -> PlcSymbols:
    """The symbols of the PLC."""
    (tmp_path / "cell.st").write_text(PLC, "utf-8")
    types: dict[str, DataType] = {}
    programs = structured_programs(tmp_path / "cell.st")
    return PlcSymbols(programs, lambda one: types.setdefault(one.name, one))


def test_types_are_those_of_the_text(symbols: PlcSymbols) -> None:
    """Names, numbers of ADS, sizes; members at the controller's offsets (ST-330)."""
    found = {one.name: one.type for one in symbols.all()}
    assert [(name, one.name, one.number, one.size_bytes) for name, one in found.items()] == [
        ("MAIN.bGate", "BOOL", 33, 1),
        ("MAIN.fbGate", "FB_Gate", 65, 16),
        ("MAIN.aTools", "ARRAY [1..2] OF ST_Tool", 65, 80),
        ("MAIN.aMatrix", "ARRAY [0..1,-1..1] OF INT", 2, 12),
        ("MAIN.fReal", "REAL", 4, 4),
        ("MAIN.nBig", "LINT", 20, 8),
        ("MAIN.tWait", "TIME", 19, 4),
    ]
    gate = {one.name: (one.type.name, one.type.number) for one in found["MAIN.fbGate"].members}
    assert gate == {"bUp": ("BOOL", 33), "eState": ("E_Gate", 2)}
    tool = symbols.find("main.atools[2]")
    assert tool is not None
    assert [(one.name, one.offset) for one in tool.type.members] == [
        ("nNumber", 0), ("fLength", 8), ("sName", 16), ("pNext", 32),
    ]  # fmt: skip
    matrix = symbols.find("MAIN.aMatrix")
    assert matrix is not None
    assert symbol_entry(matrix).endswith(pack("<iIiI", 0, 2, -1, 3))


def test_values_are_bytes_of_their_types(symbols: PlcSymbols) -> None:
    """A structure is read and written whole; enumerations are numbers; pointers are no values."""
    tool, state = symbols.find("MAIN.aTools[1]"), symbols.find("MAIN.fbGate.eState")
    assert tool is not None
    assert state is not None
    item = symbols.item(tool.group, tool.offset, 40)
    names = [f"MAIN.aTools[1].{name}" for name in ("nNumber", "fLength", "sName")]
    assert list(item.names) == names
    data = item.read(dict(zip(names, (7, 1.5, "drill"), strict=True)))
    assert data == pack("<H6xd10s6x8x", 7, 1.5, b"drill")
    assert item.write(data) == dict(zip(names, (7, 1.5, "drill"), strict=True))
    item = symbols.item(state.group, state.offset, 2)
    assert item.read({"MAIN.fbGate.eState": "E_Gate.Open"}) == pack("<h", 5)
    assert item.write(pack("<h", 5)) == {"MAIN.fbGate.eState": 5}


def test_methods_and_unknown_parts_are_refused(symbols: PlcSymbols) -> None:
    """No RPC methods: 0x710; nothing at this offset: 0x703."""
    with pytest.raises(AdsError) as raised:
        symbols.find("MAIN.fbGate#Open")
    assert (raised.value.code, raised.value.kind) == (Error.SYMBOL, "rpc")
    assert symbols.find("MAIN.fbGate.nNone") is None
    with pytest.raises(AdsError) as raised:
        symbols.item(0x4060, 3, 1)
    assert raised.value.code is Error.OFFSET


def test_the_first_members_are_read_and_written_alone(symbols: PlcSymbols) -> None:
    """As on the controller: a read of fewer bytes than a symbol has gives its first ones."""
    tool = symbols.find("MAIN.aTools[1]")
    assert tool is not None
    item = symbols.item(tool.group, tool.offset, 16)  # nNumber, 6 bytes between, fLength
    names = ("MAIN.aTools[1].nNumber", "MAIN.aTools[1].fLength")
    assert item.names == names
    assert item.read(dict(zip(names, (7, 1.5), strict=True))) == pack("<H6xd", 7, 1.5)
    with pytest.raises(AdsError) as raised:
        symbols.item(tool.group, tool.offset, 12)  # within fLength
    assert raised.value.code is Error.SIZE


@pytest.mark.slow
def test_a_client_of_npm_finds_them(tmp_path: Path) -> None:
    """ads-client uploads symbols and types, reads arrays by them, writes, listens, uses handles."""
    (tmp_path / "cell.st").write_text(PLC, "utf-8")
    server = Server(tmp_path, "--plc=cell.st", "--pace=tick")
    try:
        drive_with_npm(server, "drive_ads_plc.js", tmp_path)
    finally:
        server.end()


@pytest.mark.nightly
def test_the_library_of_the_vendor_finds_them(tmp_path: Path) -> None:
    """pyads reads, writes, uploads and listens; what it writes is on the tape."""
    (tmp_path / "cell.st").write_text(PLC, "utf-8")
    server = Server(tmp_path, "--plc=cell.st", "--pace=tick", "--record=run.tape")
    words = [sys.executable, "drive_pyads_plc.py", server.address, server.net_id]
    done = subprocess.run(
        words, cwd=FOLDER, capture_output=True, text=True, timeout=120, check=False
    )
    assert server.end()[0] == 0
    assert (done.returncode, done.stdout.splitlines()[-1:]) == (0, ["all"]), done.stderr
    words = [sys.executable, "-m", "nctakt", "replay", "run.tape", "--trace=run.csv", "--quiet"]
    words.append("--signals=MAIN.bGate,MAIN.fbGate.eState")
    done = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "1,5" in (tmp_path / "run.csv").read_text("utf-8").splitlines()[-1]
