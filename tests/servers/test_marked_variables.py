# SPDX-License-Identifier: MIT
"""What a PLC's text marks for clients is shown by OPC UA and MQTT, and nothing else of it.

The attribute is a pragma in the declaration (ST-204): ``{attribute 'OPC.UA.DA' := '1'}``.
"""

from __future__ import annotations

import asyncio
from pathlib import Path

import pytest

from nctakt.plc.structured_text import structured_programs
from nctakt.servers.catalogue import Value
from nctakt.servers.marked_variables import marked_values

PLC = """TYPE E_Gate : (Closed := 0, Open := 5); END_TYPE
TYPE ST_Tool : STRUCT nNumber : UINT; {attribute 'OPC.UA.DA' := '0'} nHidden : INT;
    sName : STRING(9); pNext : POINTER TO INT; END_STRUCT END_TYPE
FUNCTION_BLOCK FB_Gate
VAR_INPUT bUp : BOOL; END_VAR
VAR_OUTPUT {attribute 'OPC.UA.DA' := '1'} eState : E_Gate; END_VAR
IF bUp THEN eState := E_Gate.Open; END_IF
END_FUNCTION_BLOCK
VAR_GLOBAL
    {attribute 'OPC.UA.DA' := '1'} nLimit : INT := 3;
    nOther : INT;
END_VAR
PROGRAM MAIN
VAR
    {attribute 'OPC.UA.DA' := '1'}
    {attribute 'OPC.UA.DA.Access' := '1'}
    nCount : DINT;
    fbGate : FB_Gate;
    {attribute 'OPC.UA.DA' := '1'}
    aTools : ARRAY[1..2] OF ST_Tool;
    {attribute 'OPC.UA.DA' := '1'}
    nBig : LINT;
END_VAR
nCount := nCount + 1;
fbGate(bUp := nLimit > 3);
END_PROGRAM
"""


def test_marks_count_for_parts_and_instances(tmp_path: Path) -> None:
    """Parts that are taken out, pointers and 64 bits are left out; rights are those of the text."""
    (tmp_path / "cell.st").write_text(PLC, "utf-8")
    found = marked_values(structured_programs(tmp_path / "cell.st"))
    tools = [
        one
        for number in (1, 2)
        for one in (
            Value(f"MAIN.aTools[{number}].nNumber", "UNS16", "", 0, True),
            Value(f"MAIN.aTools[{number}].sName", "STRING", "", 0, True, 10),
        )
    ]
    assert list(found.values()) == [
        Value("nLimit", "SGN16", "", 0, True),
        Value("MAIN.nCount", "SGN32", "", 0, False),
        Value("MAIN.fbGate.eState", "STRING", "", 0, True, 2),
        *tools,
    ]


def test_of_several_plcs_the_second_has_its_project_in_front(tmp_path: Path) -> None:
    """``MAIN.n`` of the first, ``b.MAIN.n`` of the second; what it alone has, by its path."""
    text = "PROGRAM MAIN\nVAR\n    {attribute 'OPC.UA.DA' := '1'} n : INT;\nEND_VAR\nEND_PROGRAM\n"
    (tmp_path / "a.st").write_text(text, "utf-8")
    (tmp_path / "b.st").write_text(text.replace("n : INT", "n, k : INT"), "utf-8")
    programs = [
        program for name in ("a.st", "b.st") for program in structured_programs(tmp_path / name)
    ]
    assert list(marked_values(programs)) == ["MAIN.n", "b.MAIN.n", "MAIN.k"]


@pytest.mark.slow
def test_a_client_of_opc_ua_reads_and_writes_them(tmp_path: Path) -> None:
    """In the object ``PLC`` below ``CncInterface``, by their paths, with their types."""
    pytest.importorskip("asyncua", reason="needs the extra [opcua]")
    from asyncua import ua  # noqa: PLC0415 - an extra
    from support.opcua_client import patient_client  # noqa: PLC0415
    from support.served import Served  # noqa: PLC0415

    (tmp_path / "cell.st").write_text(PLC, "utf-8")
    served = Served(tmp_path, plc=tmp_path / "cell.st")

    async def work() -> None:
        async with patient_client(served.url) as client:
            folder = client.get_node("ns=3;s=CncInterface.PLC")
            names = [(await node.read_browse_name()).Name for node in await folder.get_children()]
            assert sorted(names) == [
                "MAIN.aTools[1].nNumber", "MAIN.aTools[1].sName",
                "MAIN.aTools[2].nNumber", "MAIN.aTools[2].sName",
                "MAIN.fbGate.eState", "MAIN.nCount", "nLimit",
            ]  # fmt: skip
            limit = client.get_node("ns=3;s=CncInterface.PLC.nLimit")
            state = client.get_node("ns=3;s=CncInterface.PLC.MAIN.fbGate.eState")
            count = client.get_node("ns=3;s=CncInterface.PLC.MAIN.nCount")
            assert await limit.read_data_type_as_variant_type() == ua.VariantType.Int16
            assert await limit.read_value() == 3
            served.session.step(100)
            assert await state.read_value() == "E_Gate.Closed"
            assert await count.read_value() > 0
            await limit.write_value(ua.Variant(4, ua.VariantType.Int16))
            served.session.step(50)
            assert await state.read_value() == "E_Gate.Open"
            with pytest.raises(ua.UaStatusCodeError):
                await count.write_value(ua.Variant(4, ua.VariantType.Int32))

    try:
        asyncio.run(asyncio.wait_for(work(), 60))
    finally:
        served.close()
