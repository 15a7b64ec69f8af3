# SPDX-License-Identifier: MIT
"""Structured Text in the ticks of the demo machine, for tests."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from nctakt.plc.structured_text import StructuredPlc, load_structured
from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText
from support.plc_text import pou_file

#: A task of 1 ms, the tick of the demo machine, that calls MAIN.
EACH_TICK = """
CONFIGURATION Cell
RESOURCE Controller ON PLC
TASK Fast(INTERVAL := T#1MS, PRIORITY := 1);
PROGRAM Main1 WITH Fast : MAIN;
END_RESOURCE
END_CONFIGURATION
"""

Stimulus = tuple[str, str, float]


def loaded(folder: Path, text: str, task: str = EACH_TICK) -> StructuredPlc:
    """The PLC of a text."""
    path = folder / "cell.st"
    path.write_text(text + task, "utf-8")
    return load_structured(path)


def run(
    plc: StructuredPlc, ticks: int, signals: Sequence[str] = (), at: Sequence[Stimulus] = ()
) -> Run:
    """The run of a program that does nothing for this many ticks, with this PLC."""
    waits = NcText("wait.nc", "G04 10\nM30")
    return Controller().run(waits, plc=plc, ticks=ticks, signals=list(signals), at=at)


def values_in_main(plc: StructuredPlc, *names: str) -> list[object]:
    """The values of variables of MAIN."""
    return [plc.read(f"MAIN.{name}") for name in names]


#: A project with a task of 1 ms whose axes are those of Tc2_MC2.
NC_PROJECT = """<Project xmlns="http://schemas.microsoft.com/developer/msbuild/2003">
<ItemGroup><Compile Include="MAIN.TcPOU"/><Compile Include="T.TcTTO"/></ItemGroup>
<ItemGroup><PlaceholderReference Include="Tc2_Standard"/><PlaceholderReference Include="Tc2_MC2"/>
</ItemGroup></Project>"""
NC_TASK = """<TcPlcObject><Task Name="T"><CycleTime>1000</CycleTime><Priority>20</Priority>
<PouCall><Name>MAIN</Name></PouCall></Task></TcPlcObject>"""


def nc_axis(folder: Path, variables: str, body: str) -> Path:
    """A project whose axes are those of Tc2_MC2, in mm and mm/s."""
    (folder / "MAIN.TcPOU").write_text(pou_file("MAIN", variables, body), "utf-8")
    (folder / "T.TcTTO").write_text(NC_TASK, "utf-8")
    (folder / "Cell.plcproj").write_text(NC_PROJECT, "utf-8")
    return folder / "Cell.plcproj"
