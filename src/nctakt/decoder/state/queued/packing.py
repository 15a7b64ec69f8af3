# SPDX-License-Identifier: MIT
"""A command of the decoder -> a row of the queue, its columns in the order of ``kernel/rows.py``.

Segments are not packed but prepared in the queue (``CommandQueue.put_segment``).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from operator import attrgetter

from nctakt.decoder.state.queued.commands import Command, WriteText
from nctakt.kernel import rows

#: Getter of source, block number and arguments of a command whose arguments are its fields.
_READERS: dict[type[Command], Callable[[Command], tuple[float, ...]]] = {}


def pack(command: Command, reference: int = 0) -> list[float]:
    """Return the row of a command.

    ``reference`` is the slot of a cycle, the number of a text or program, or a tick.
    """
    read = _READERS.get(type(command))
    if read is None:
        if has_own_arguments(type(command)):
            arguments = command.arguments(reference)
            return [command.packed_as, command.source, command.number, *arguments]
        read = _READERS[type(command)] = attrgetter(*command.__match_args__)
    return [command.packed_as, *read(command)]


def has_own_arguments(kind: type[Command]) -> bool:
    """Return whether the arguments of its row are not just the fields, or it has no row."""
    return kind.arguments is not Command.arguments or kind.packed_as in (0, rows.SEGMENT)


def takes_time(command: Command) -> bool:
    """Return whether ticks pass while the command is executed."""
    return rows.is_timed(command.packed_as)


def write_text(
    source: int, number: int, cell: int, data: bytes, axis_count: int
) -> Iterator[WriteText]:
    """The commands that give the string at ``cell`` all its bytes, zeros at its end included."""
    text = data.rstrip(b"\0")
    room = rows.text_width(axis_count)
    for first in range(0, max(1, len(text)), room):
        part = text[first : first + room]
        is_last = first + room >= len(text)
        yield WriteText(source, number, cell, first, part, len(data) - len(text) if is_last else 0)
