# SPDX-License-Identifier: MIT
"""The packed memory of a machine's V.E variables: one section for GLOBAL, one for each channel.

In: a machine. Out: its sections, and the fields in them (``describe``). V.CH is in none of them.
"""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.lists.machine.external.variables import Variable, VariableScope
from nctakt.lists.machine.external.variables_layout import (
    Field,
    Placed,
    fields,
    pack_of,
    place_variables,
    size_bytes,
)
from nctakt.lists.machine.machine import Machine

#: Alignment of the sections in bytes: a cache line.
SECTION_ALIGNMENT = 64


@dataclass(frozen=True, slots=True)
class Section:
    """The variables of one scope: ``channel`` is 0 for GLOBAL, else the number of the channel.

    ``offset``: in the image, in bytes; ``size_bytes``: size of its variables.
    """

    channel: int
    offset: int
    size_bytes: int
    placed: tuple[Placed, ...]


def sections(machine: Machine) -> tuple[Section, ...]:
    """Return the sections of a machine's image: GLOBAL first, then the channels."""
    pack = pack_of(machine.startup.member_alignment)
    groups: list[tuple[Variable, ...]] = [machine.global_variables]
    for channel in machine.channels:
        channel_variables = (
            v for v in channel.external_variables if v.scope is VariableScope.CHANNEL
        )
        groups.append(tuple(channel_variables))
    result: list[Section] = []
    end = 0
    for channel_number, variables in enumerate(groups):
        placed = place_variables(variables, pack)
        offset = -(-end // SECTION_ALIGNMENT) * SECTION_ALIGNMENT
        result.append(Section(channel_number, offset, size_bytes(placed), placed))
        end = offset + result[-1].size_bytes
    return tuple(result)


def image_bytes(machine: Machine) -> int:
    """Return the size of the whole image in bytes, at least one section's alignment."""
    last = sections(machine)[-1]
    end = last.offset + last.size_bytes
    return max(1, -(-end // SECTION_ALIGNMENT)) * SECTION_ALIGNMENT


def describe(machine: Machine, channel: int = 0) -> list[Field]:
    """Return the fields of a section: path, offset in it, type, elements, bytes of each number.

    ``channel`` is 0 for the GLOBAL variables, else the number of a channel, from 1 on.
    """
    pack = pack_of(machine.startup.member_alignment)
    return [field for placed in sections(machine)[channel].placed for field in fields(placed, pack)]
