# SPDX-License-Identifier: MIT
"""A snapshot of a realtime part: everything that its ticks change, kept and restored in place.

In: a realtime part between two calls of ``run``, with the record emptied. Out: ``Snapshot``, which
restores all objects and arrays, so that the ticks from there on are the same again. Restoring takes
a hundredth of the time needed to rebuild the part.
"""

from __future__ import annotations

import operator
from collections.abc import Iterator
from typing import Any

from nctakt.base.held_objects import held_objects
from nctakt.kernel.cycles.cycles import RealtimeCycle
from nctakt.kernel.path.path import Path
from nctakt.kernel.state import ARRAYS, ArrayCopies, ObjectCopies
from nctakt.kernel.tick.command_queue import CommandQueue
from nctakt.nc.vocabulary.variables.cells import CELL_BYTES
from nctakt.run.realtime.realtime_part import RealtimePart

_KERNEL = "nctakt.kernel."


class Snapshot:
    """The state of a realtime part when it was taken, at first or again.

    Raises ``ValueError`` with a shared image or with stops, which are not part of it.
    """

    def __init__(self, realtime: RealtimePart) -> None:
        self._realtime = realtime
        parts = list(held_objects(realtime.kernel, _KERNEL))
        buffers: dict[int, bytearray] = {id(realtime.memory): realtime.memory}
        for part in parts:
            buffers |= {id(buffer): buffer for buffer in _buffers_of(part)}
        self._paths = [part for part in parts if isinstance(part, Path)]
        self._queues = [part for part in parts if isinstance(part, CommandQueue)]
        self._objects = ObjectCopies(parts)
        self._arrays = ArrayCopies(list(buffers.values()))
        self._used: list[tuple[memoryview, bytes]] = []
        self._cycles = self._loaded_cycles()
        self._take()

    def _loaded_cycles(self) -> list[list[RealtimeCycle]]:
        return [list(channel.manager.loaded) for channel in self._realtime.channels]

    def take_again(self) -> bool:
        """Take the present state instead; return False if there are other objects to keep now."""
        cycles = self._loaded_cycles()
        are_same = len(cycles) == len(self._cycles) and all(
            len(one) == len(other) and all(map(operator.is_, one, other))
            for one, other in zip(cycles, self._cycles, strict=True)
        )
        if not are_same or not self._objects.have_same_arrays():
            return False
        self._take()
        return True

    def _take(self) -> None:
        kernel, record = self._realtime.kernel, self._realtime.record
        if kernel.image.is_attached or kernel.stops.is_watching:
            raise ValueError("a snapshot has neither a shared image nor stops")
        if record.row_count or record.event_count or record.probe_count:
            raise ValueError("the record has not been emptied")
        self._objects.take()
        self._arrays.take()
        self._used = []
        for rows, cells in (
            *(path.history() for path in self._paths),
            *(queue.used_rows() for queue in self._queues),
        ):
            used = memoryview(_buffer_of(rows))[: CELL_BYTES * cells]
            self._used.append((used, bytes(used)))

    def put_back(self) -> None:
        """Restore everything to the state of the snapshot."""
        self._objects.put_back()
        self._arrays.put_back()
        for used, kept_rows in self._used:
            used[:] = kept_rows


def _buffers_of(part: object) -> Iterator[bytearray]:
    """Yield the memory of the arrays of an object."""
    for cls in type(part).__mro__:
        if cls in ARRAYS:
            yield from map(_buffer_of, ARRAYS[cls](part))


def _buffer_of(array: Any) -> bytearray:
    """Return the memory of an array; a compiled array is a view of the view it was made from."""
    buffer = getattr(array, "base", array).obj
    if not isinstance(buffer, bytearray):
        raise ValueError("an array has its memory elsewhere")
    return buffer
