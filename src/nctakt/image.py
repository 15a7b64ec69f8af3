# SPDX-License-Identifier: MIT
"""The memory of V.E variables as a PLC or another process sees it: packed like C structures.

In: a machine. Out: a description of the layout (``describe``, ``describe_c``), and the live image
of a running controller (``Controller.external_image``), in memory of this process or in named
shared memory. The image has one section for the GLOBAL variables and one for each channel; V.CH is
in none. What is written into it counts from the next tick on, what cycles and programs write is in
it at the end of the tick (``kernel/image.py``).
"""

from __future__ import annotations

import contextlib
import weakref
from collections.abc import Iterator, Mapping
from multiprocessing.shared_memory import SharedMemory
from types import TracebackType

from nctakt.failure import Failure
from nctakt.kernel.image import KINDS
from nctakt.kernel.kernel import Kernel
from nctakt.lists.machine import MachineConfiguration
from nctakt.lists.variable_header import describe_c
from nctakt.lists.variable_layout import Field, fields, pack_of
from nctakt.lists.variable_memory import Section, describe, image_bytes, sections
from nctakt.messages import diagnostic
from nctakt.nc.cells import CELL_BYTES

__all__ = ["ExternalImage", "Field", "Section", "describe", "describe_c", "image_bytes", "sections"]


class ExternalImage:
    """The live image of a controller; also a context manager.

    ``memory``: all its bytes; ``section`` gives those of one scope. ``name`` is that of the shared
    memory, ``None`` without. Closing it releases ``memory`` and removes the shared memory; it is
    done at the latest when the controller goes, and by the system's helper when the process dies.
    """

    def __init__(
        self,
        machine: MachineConfiguration,
        kernel: Kernel,
        cells: Mapping[tuple[int, str], int],
        name: str | None = None,
    ) -> None:
        """``cells``: the first cell of each variable by channel (0: GLOBAL) and name."""
        if kernel.image.is_attached:
            raise Failure(diagnostic(900347))
        self.name = name
        self._sections = sections(machine)
        size = image_bytes(machine)
        shared = None if name is None else _create(name, size)
        buffer = memoryview(bytearray(size)) if shared is None else shared.buf
        assert buffer is not None
        self.memory = buffer[:size]
        pack = pack_of(machine.startup.member_alignment)
        kernel.image.attach(self.memory, list(_table(self._sections, pack, cells)))
        self._resources = _Resources(kernel, self.memory, shared)
        self._last_resort = weakref.finalize(self, self._resources.give_up)

    def section(self, channel: int = 0) -> memoryview:
        """The bytes of one scope, writable: 0 for GLOBAL, else the number of a channel.

        Release it before the image is closed.
        """
        one = self._sections[channel]
        return self.memory[one.offset : one.offset + one.size_bytes]

    @property
    def is_closed(self) -> bool:
        """Whether the controller has left it."""
        return self._resources.kernel is None

    def close(self) -> None:
        """Take the image from the controller; twice is no harm.

        Raises ``Failure`` (900348) while views of shared memory live: release them and close it
        again. Nobody can open the shared memory any longer, whatever comes of that.
        """
        self._resources.close()
        self._last_resort.detach()

    def __enter__(self) -> ExternalImage:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self.close()


class _Resources:
    """What an image holds, given back in the order that works: kernel, view, shared memory."""

    def __init__(self, kernel: Kernel, memory: memoryview, shared: SharedMemory | None) -> None:
        self.kernel: Kernel | None = kernel
        self._memory = memory
        self._shared = shared

    def close(self) -> None:
        """Give everything back that is not yet; raises ``Failure`` (900348)."""
        if self.kernel is not None:
            self.kernel.image.detach()
            self.kernel = None
            if self._shared is not None:
                self._shared.unlink()
        try:
            self._memory.release()
            if self._shared is not None:
                self._shared.close()
        except BufferError as error:
            raise Failure(diagnostic(900348)) from error
        self._shared = None

    def give_up(self) -> None:
        """As ``close``, when nobody is left to tell."""
        with contextlib.suppress(Failure):
            self.close()


def _table(
    parts: tuple[Section, ...], pack: int, cells: Mapping[tuple[int, str], int]
) -> Iterator[tuple[int, int, int, int]]:
    """Rows of ``kernel.image``: byte, kind, cell, bytes of each number and string."""
    for section in parts:
        for placed in section.placed:
            cell = cells[(section.channel, placed.variable.name)]
            for field in fields(placed, pack):
                for index in range(max(1, field.count)):
                    offset = section.offset + field.offset + index * field.size_bytes
                    yield offset, KINDS[field.type], cell, field.size_bytes
                    cell += -(-field.size_bytes // CELL_BYTES)


def _create(name: str, size: int) -> SharedMemory:
    """New shared memory, all zero."""
    try:
        return SharedMemory(name, create=True, size=size)
    except FileExistsError as error:
        raise Failure(diagnostic(900349, name=name)) from error
    except (OSError, ValueError) as error:
        raise Failure(diagnostic(900350, name=name, reason=str(error))) from error
