# SPDX-License-Identifier: MIT
"""The packed memory of a machine's V.E variables: one section for GLOBAL, one for each channel.

In: a machine. Out: its sections, and what stands in them (``describe``). V.CH is in none.
"""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.lists.machine.machine import Machine
from nctakt.lists.machine.variables import Variable, VariableScope
from nctakt.lists.machine.variables_layout import Field, Placed, fields, pack_of, place, size_bytes

#: Sections begin at multiples of this: a cache line.
SECTION_ALIGNMENT = 64


@dataclass(frozen=True, slots=True)
class Section:
    """The variables of one scope: ``channel`` is 0 for GLOBAL, else the number of the channel.

    ``offset``: its first byte in the image; ``size_bytes``: of the variables in it.
    """

    channel: int
    offset: int
    size_bytes: int
    placed: tuple[Placed, ...]


def sections(machine: Machine) -> tuple[Section, ...]:
    """The sections of a machine's image: GLOBAL first, then the channels."""
    pack = pack_of(machine.startup.member_alignment)
    groups: list[tuple[Variable, ...]] = [machine.global_variables]
    for channel in machine.channels:
        own = (v for v in channel.external_variables if v.scope is VariableScope.CHANNEL)
        groups.append(tuple(own))
    found: list[Section] = []
    end = 0
    for channel_number, variables in enumerate(groups):
        placed = place(variables, pack)
        offset = -(-end // SECTION_ALIGNMENT) * SECTION_ALIGNMENT
        found.append(Section(channel_number, offset, size_bytes(placed), placed))
        end = offset + found[-1].size_bytes
    return tuple(found)


def image_bytes(machine: Machine) -> int:
    """Bytes of the whole image, at least one section's alignment."""
    last = sections(machine)[-1]
    end = last.offset + last.size_bytes
    return max(1, -(-end // SECTION_ALIGNMENT)) * SECTION_ALIGNMENT


def describe(machine: Machine, channel: int = 0) -> list[Field]:
    """The layout of a section: path, offset in it, type, elements, bytes of each number.

    ``channel`` is 0 for the GLOBAL variables, else the number of a channel, from 1 on.
    """
    pack = pack_of(machine.startup.member_alignment)
    return [field for one in sections(machine)[channel].placed for field in fields(one, pack)]
