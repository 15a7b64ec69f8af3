# SPDX-License-Identifier: MIT
"""Settings of the channel list for M and H functions, as tables by their numbers for the tick."""

from __future__ import annotations

import struct
from collections.abc import Mapping

from nctakt.kernel.plc.technology_slots import FunctionTable
from nctakt.lists.declared.technology_functions import MAX_FUNCTIONS, TechnologyFunction
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.lists.machine.machine import ChannelConfiguration


def logical_axes(channel: ChannelConfiguration) -> dict[str, int]:
    """Return the logical numbers of a channel's axes and spindles by their names."""
    numbers = {axis.name: axis.logical_number for axis in channel.axes}
    return numbers | {one.name: one.logical_number for one in channel.parameters.spindles}


def axes_of(
    functions: Mapping[int, TechnologyFunction], channel: ChannelConfiguration
) -> bytearray:
    """Return the logical number of the axis or spindle of each function by its number, 0: none."""
    numbers = logical_axes(channel)
    table = bytearray(8 * MAX_FUNCTIONS)
    for function in functions.values():
        logical = numbers.get(function.axis_name, 0)
        struct.pack_into("=q", table, 8 * function.number, logical)
    return table


def types_of(parameters: ChannelParameters) -> FunctionTable:
    """Return the bits of the synchronisation type and modifiers of each function of a channel."""
    tool = parameters.tool_selection.output
    return FunctionTable(
        _types(parameters.m_functions),
        _types(parameters.h_functions),
        0 if tool is None else tool.synchronisation_bits,
    )


def _types(functions: Mapping[int, TechnologyFunction]) -> bytearray:
    table = bytearray(8 * MAX_FUNCTIONS)
    for function in functions.values():
        struct.pack_into("=q", table, 8 * function.number, function.synchronisation_bits)
    return table
