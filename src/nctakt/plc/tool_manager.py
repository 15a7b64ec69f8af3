# SPDX-License-Identifier: MIT
"""The tool manager of a PLC in Python: what a channel asks for, and the tool that answers.

A class that derives from ``Plc`` manages the tools of all channels with an external tool management
(P-CHAN-00016) if it has a method ``tool_data``. In: the values ``HLI.TOOL_REQUEST…``; out:
``HLI.TOOL_ANSWER…``, as any other PLC may write them.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from nctakt.base.dataclass import dataclass
from nctakt.hli.layout import PREFIX, TOOL_OFFSETS, TOOL_PARAMETERS

if TYPE_CHECKING:
    from nctakt.run.plcs.plc_view import PlcView


@dataclass(frozen=True, slots=True)
class ToolRequest:
    """A tool that a program asks for, by D or ``#TOOL DATA``.

    ``channel`` counts from 1; ``basic``, ``sister`` and ``variant`` identify the tool; all are 0
    for D0. ``is_preparation``: T or ``#TOOL PREP`` only has it got ready (P-CHAN-00087).
    ``last_t``, ``last_d``: the numbers in force, ``parameters`` the free values of the tool that
    goes: V.G.WZ_AKT.P[0] …

    >>> ToolRequest(channel=1, basic=7).sister
    0
    """

    channel: int
    basic: int
    sister: int = 0
    variant: int = 0
    is_preparation: bool = False
    last_t: int = 0
    last_d: int = 0
    parameters: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True)
class ToolData:
    """The data of a tool: mm, degrees, revolutions per minute, degrees per second².

    ``offsets`` of the first axes, at most 6; ``parameters`` V.G.WZ_AKT.P[0] …, at most 10.
    ``cutter``: orientation of the cutter (P-TOOL-00002), ``spindle``: logical number of its
    spindle, ``kinematic``: ID of its kinematic, 0 for none.

    >>> ToolData(length=120.5, radius=5.0).offsets
    ()
    """

    length: float = 0.0
    radius: float = 0.0
    offsets: Sequence[float] = ()
    parameters: Sequence[float] = ()
    type: int = 0
    cutter: int = 0
    spindle: int = 0
    kinematic: int = 0
    min_speed: float = 0.0
    max_speed: float = 0.0
    max_acceleration: float = 0.0


def answer_requests(hli: PlcView, find: Callable[[PlcView, ToolRequest], ToolData | None]) -> None:
    """Answer the open requests of all channels by what ``find`` returns; ``None``: no such tool."""
    for number in range(1, hli.channel_count + 1):
        channel = hli.of_channel(number)
        if channel.read(f"{PREFIX}TOOL_MANAGER") == 0.0:
            channel.write(f"{PREFIX}TOOL_MANAGER", 1)
        request = channel.read(f"{PREFIX}TOOL_REQUEST")
        if request != channel.read(f"{PREFIX}TOOL_ANSWER"):
            _write(channel, find(channel, _request(channel, number)))
            channel.write(f"{PREFIX}TOOL_ANSWER", request)


def _request(hli: PlcView, channel: int) -> ToolRequest:
    def number(name: str) -> int:
        return int(hli.read(f"{PREFIX}TOOL_REQUEST_{name}"))

    return ToolRequest(
        channel,
        number("BASIC"),
        number("SISTER"),
        number("VARIANT"),
        number("KIND") == 2,
        number("T"),
        number("D"),
        tuple(
            float(hli.read(f"{PREFIX}TOOL_REQUEST_PARAMETER_{i}")) for i in range(TOOL_PARAMETERS)
        ),
    )


def _write(hli: PlcView, tool: ToolData | None) -> None:
    """Write the data of a tool, or that there is none."""
    hli.write(f"{PREFIX}TOOL_VALID", tool is not None)
    if tool is None:
        return
    for name in (
        "length", "radius", "type", "cutter", "spindle", "kinematic",
        "min_speed", "max_speed", "max_acceleration",
    ):  # fmt: skip
        hli.write(f"{PREFIX}TOOL_{name.upper()}", getattr(tool, name))
    for word, count, values in (
        ("OFFSET", TOOL_OFFSETS, tool.offsets),
        ("PARAMETER", TOOL_PARAMETERS, tool.parameters),
    ):
        if len(values) > count:
            raise ValueError(f"a tool has at most {count} values of {word.lower()}s here")
        for i in range(count):
            hli.write(f"{PREFIX}TOOL_{word}_{i}", values[i] if i < len(values) else 0.0)
