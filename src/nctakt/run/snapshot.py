# SPDX-License-Identifier: MIT
"""A snapshot of a realtime part: what its ticks change, kept, and put back in place.

In: a realtime part between two calls of ``run``, with the record emptied. Out: ``Snapshot``, which
puts all objects and arrays back as they were, so that the ticks from there on are the same again.
Putting back takes a hundredth of the time that building the part anew takes.
"""

from __future__ import annotations

import gc
from collections.abc import Callable, Iterator
from typing import Any

from nctakt.kernel.path.path import Path
from nctakt.kernel.state import axes, control, path
from nctakt.nc.vocabulary.cells import CELL_BYTES
from nctakt.run.realtime_part import RealtimePart

_COPIERS = {**axes.COPIERS, **path.COPIERS, **control.COPIERS}
_ARRAYS = {**axes.ARRAYS, **path.ARRAYS, **control.ARRAYS}

_KERNEL = "nctakt.kernel."

#: Containers in which objects of the realtime part stand.
_CONTAINERS = (dict, list, tuple)


class Snapshot:
    """The state of a realtime part when it was taken.

    Raises ``ValueError`` with a shared image or with stops, which are not part of it.
    """

    def __init__(self, realtime: RealtimePart) -> None:
        kernel, record = realtime.kernel, realtime.record
        if kernel.image.is_attached or kernel.stops.is_watching:
            raise ValueError("a snapshot has neither a shared image nor stops")
        if record.row_count or record.event_count or record.probe_count:
            raise ValueError("the record has not been emptied")
        self._copies: list[tuple[Callable[[Any, Any], None], Any, Any]] = []
        buffers: dict[int, bytearray] = {id(realtime.memory): realtime.memory}
        self._contents: list[tuple[memoryview, bytes]] = []
        for part in _parts(kernel):
            kept = type(part).__new__(type(part))
            for cls in type(part).__mro__:
                if cls in _COPIERS:
                    self._copies.append((_COPIERS[cls], kept, part))
                    _COPIERS[cls](part, kept)
                if cls in _ARRAYS:
                    for buffer in map(_buffer_of, _ARRAYS[cls](part)):
                        buffers[id(buffer)] = buffer
            if isinstance(part, Path):
                rows, cells = path.history_of_path(part)
                self._keep(memoryview(_buffer_of(rows))[: CELL_BYTES * cells])
        for buffer in buffers.values():
            self._keep(memoryview(buffer))

    def _keep(self, buffer: memoryview) -> None:
        self._contents.append((buffer, bytes(buffer)))

    def put_back(self) -> None:
        """Put everything back as it was when the snapshot was taken."""
        for copy, kept, part in self._copies:
            copy(kept, part)
        for buffer, content in self._contents:
            buffer[:] = content


def _parts(root: object) -> Iterator[object]:
    """Yield an object of the realtime part and all that it holds, each once."""
    seen = {id(root)}
    waiting = [root]
    while waiting:
        part = waiting.pop()
        if not isinstance(part, _CONTAINERS):
            yield part
        for held in gc.get_referents(part):
            is_part = isinstance(held, _CONTAINERS) or type(held).__module__.startswith(_KERNEL)
            if is_part and id(held) not in seen:
                seen.add(id(held))
                waiting.append(held)


def _buffer_of(array: Any) -> bytearray:
    """Return the memory of an array; a compiled one is a view of the view that it was made of."""
    buffer = getattr(array, "base", array).obj
    if not isinstance(buffer, bytearray):
        raise ValueError("an array has its memory elsewhere")
    return buffer
