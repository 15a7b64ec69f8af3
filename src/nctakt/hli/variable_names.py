# SPDX-License-Identifier: MIT
"""The names of the V.E variables in the image of the HLI, for users without the machine's lists.

In: a machine. Out: a text with a line for each number, string and array of them, and back: name,
type, bytes from the start of the V.E variables, elements (0: a single value), bytes of each,
divided by tabs. The variables of a channel have its prefix: ``CH2.V.E.SPEED``.
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.base.dataclass import dataclass
from nctakt.hli.variables_memory import sections
from nctakt.lists.machine.external.variables_layout import fields, pack_of
from nctakt.lists.machine.machine import Machine


@dataclass(frozen=True, slots=True)
class NamedVariable:
    """A number or string, or an array of them; ``offset`` counts from the V.E variables' start.

    ``count``: 0 for a single value. ``size_bytes``: of one element.
    """

    name: str
    type: str
    offset: int
    count: int
    size_bytes: int

    @property
    def end(self) -> int:
        """The offset of the byte after it."""
        return self.offset + self.size_bytes * max(1, self.count)


def describe_names(machine: Machine) -> bytes:
    """Return the text of a machine in UTF-8."""
    lines = (
        f"{one.name}\t{one.type}\t{one.offset}\t{one.count}\t{one.size_bytes}\n"
        for one in named_variables(machine)
    )
    return "".join(lines).encode()


def named_variables(machine: Machine) -> Iterator[NamedVariable]:
    """Yield the variables of a machine: GLOBAL first, then those of each channel."""
    pack = pack_of(machine.startup.member_alignment)
    for section in sections(machine):
        prefix = f"CH{section.channel}." if section.channel else ""
        for placed in section.placed:
            for field in fields(placed, pack):
                yield NamedVariable(
                    f"{prefix}V.E.{field.path}",
                    field.type,
                    section.offset + field.offset,
                    field.count,
                    field.size_bytes,
                )


def read_names(text: bytes) -> dict[str, NamedVariable]:
    """Return the variables of such a text; raises ``ValueError`` for another text."""
    found = {}
    for line in text.decode().splitlines():
        name, type_, *numbers = line.split("\t")
        offset, count, size_bytes = map(int, numbers)
        found[name] = NamedVariable(name, type_, offset, count, size_bytes)
    return found
