# SPDX-License-Identifier: MIT
"""The tool manager of a PLC in Python: requests of a channel, and tools as answers.

A class that derives from ``Plc`` manages the tools of all channels with an external tool management
(P-CHAN-00016) if it has a method ``tool_data``. In: the values ``HLI.TOOL_REQUEST…``; out:
``HLI.TOOL_ANSWER…``, as any other PLC may write them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import fields
from numbers import Real
from typing import TYPE_CHECKING

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.hli.layout import PREFIX, TOOL_ANSWER, TOOL_OFFSETS, TOOL_PARAMETERS, Entry
from nctakt.lists.declared.variables import SCALARS

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


_ENTRIES = {entry.name.removeprefix("tool_"): entry for entry in TOOL_ANSWER}
#: The single values of a tool, and its series, each with the words of its values.
_SINGLE = tuple(one.name for one in fields(ToolData) if one.name in _ENTRIES)
_SERIES = (("offsets", "offset", TOOL_OFFSETS), ("parameters", "parameter", TOOL_PARAMETERS))


def mistake_in(answer: object) -> tuple[str, Text] | None:
    """Return the mistake in an answer, and why; ``None`` for good data and for no tool."""
    if answer is None:
        return None
    if not isinstance(answer, ToolData):
        return repr(answer), Text("neither ToolData nor None", "weder ToolData noch None")
    for name in _SINGLE:
        reason = _misfit(_ENTRIES[name], getattr(answer, name))
        if reason is not None:
            return f"{name}={getattr(answer, name)!r}", reason
    for name, word, count in _SERIES:
        values = getattr(answer, name)
        if not isinstance(values, Sequence) or len(values) > count:
            reason = Text(f"not a series of at most {count}", f"keine Folge von höchstens {count}")
            return f"{name}={values!r}", reason
        for i, value in enumerate(values):
            reason = _misfit(_ENTRIES[f"{word}_{i}"], value)
            if reason is not None:
                return f"{name}[{i}]={value!r}", reason
    return None


def _misfit(entry: Entry, value: object) -> Text | None:
    """Return why a value cannot be that of an entry of the interface."""
    number = float(value) if isinstance(value, Real) else math.nan
    if not math.isfinite(number):
        return Text("not a finite number", "keine endliche Zahl")
    if entry.type != "REAL64" and not number.is_integer():
        return Text("not a whole number", "keine ganze Zahl")
    if number < 0.0 and not entry.is_signed:
        return Text("below 0", "unter 0")
    high = SCALARS[entry.type].high
    return Text(f"above {high:g}", f"über {high:g}") if number > high else None


def answer_requests(hli: PlcView, find: Callable[[PlcView, ToolRequest], ToolData | None]) -> bool:
    """Answer the open requests of all channels by what ``find`` returns, ``None``: no such tool;
    return whether there was one.
    """
    is_asked = False
    for number in range(1, hli.channel_count + 1):
        channel = hli.of_channel(number)
        if channel.read(f"{PREFIX}TOOL_MANAGER") == 0.0:
            channel.write(f"{PREFIX}TOOL_MANAGER", 1)
        request = channel.read(f"{PREFIX}TOOL_REQUEST")
        if request != channel.read(f"{PREFIX}TOOL_ANSWER"):
            _write(channel, find(channel, _request(channel, number)))
            channel.write(f"{PREFIX}TOOL_ANSWER", request)
            is_asked = True
    return is_asked


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
    for name in _SINGLE:
        hli.write(f"{PREFIX}TOOL_{name.upper()}", getattr(tool, name))
    for name, word, count in _SERIES:
        values = getattr(tool, name)
        for i in range(count):
            hli.write(f"{PREFIX}TOOL_{word.upper()}_{i}", values[i] if i < len(values) else 0.0)
