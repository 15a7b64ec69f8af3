# SPDX-License-Identifier: MIT
"""A PLC's writes into the image of the HLI, by names, so that they can go on a tape.

In: the layout of a machine's image, its bytes. Out: names and bytes, as hexadecimal digits, of the
PLC's changes since the image was published; and such bytes put back into an image:
``command[1].override``, ``spindle_command[1].ack_job``, ``V.E.DOOR``, ``CH2.V.E.DOOR``.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.hli.layout import COMMAND, SPINDLE_COMMAND
from nctakt.hli.places import ImageLayout, entries
from nctakt.hli.variables_memory import Section


@dataclass(frozen=True, slots=True)
class _Area:
    """The bytes of a value that the PLC writes."""

    name: str
    first: int
    end: int


class ImageInputs:
    """The values of an image that the PLC writes.

    ``memory``: the bytes of the image; ``published``: as many, as the tick has left them.
    """

    def __init__(
        self,
        layout: ImageLayout,
        parts: Sequence[Section],
        memory: memoryview,
        published: memoryview,
    ) -> None:
        self._areas = {area.name: area for area in _areas(layout, parts)}
        self._memory = memory[layout.command_offset :]
        self._published = published[layout.command_offset :]
        self._offset = layout.command_offset

    def changes(self) -> list[tuple[str, str]]:
        """Return the names and bytes of the changes that the next tick will find."""
        written, known = bytes(self._memory), bytes(self._published)
        if written == known:
            return []
        found = []
        for area in self._areas.values():
            first, end = area.first - self._offset, area.end - self._offset
            if written[first:end] != known[first:end]:
                found.append((area.name, written[first:end].hex()))
        return found

    def check(self, name: str, digits: str) -> bytes:
        """Return the bytes of a value; raises ``ValueError`` if this image has no such value."""
        area = self._areas.get(name)
        data = bytes.fromhex(digits)
        if area is None or len(data) != area.end - area.first:
            raise ValueError(name)
        return data

    def put(self, name: str, digits: str) -> None:
        """Write the bytes of a value as the PLC does; raises ``ValueError`` as ``check``."""
        data = self.check(name, digits)
        first = self._areas[name].first - self._offset
        self._memory[first : first + len(data)] = data

    def release(self) -> None:
        """Let go of the bytes."""
        self._memory.release()
        self._published.release()


def _areas(layout: ImageLayout, parts: Sequence[Section]) -> Iterator[_Area]:
    for index in range(layout.channels):
        for placed in entries(COMMAND):
            first = layout.command(index) + placed.offset
            name = f"command[{index + 1}].{placed.entry.name}"
            yield _Area(name, first, first + placed.size_bytes)
    for index in range(layout.spindles):
        for placed in entries(SPINDLE_COMMAND):
            first = layout.spindle_command(index) + placed.offset
            name = f"spindle_command[{index + 1}].{placed.entry.name}"
            yield _Area(name, first, first + placed.size_bytes)
    for section in parts:
        channel = f"CH{section.channel}." if section.channel else ""
        for variable in section.placed:
            first = layout.ve_offset + section.offset + variable.offset
            name = f"{channel}V.E.{variable.variable.name}"
            yield _Area(name, first, first + variable.size_bytes)
