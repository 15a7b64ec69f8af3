# SPDX-License-Identifier: MIT
"""A custom PLC in another process, attached to the HLI of a CNC by its name.

In: the name after ``nctakt run --hli``. Out: the PLC's side by names (``plc_side.py``), and the
ticks of the CNC in turn: in lockstep it waits for an answer after each of them. The shared memory
is on Linux a file in ``/dev/shm``; elsewhere Python's class finds it. Only its maker removes it,
never an attached process.
"""

from __future__ import annotations

import mmap
import os
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from types import TracebackType
from typing import Protocol

from nctakt.base.diagnostics import NOTHING
from nctakt.base.failure import Failure
from nctakt.base.python_process import start_resource_tracker
from nctakt.hli.image_access import ImageAccess
from nctakt.hli.layout import COMMAND, HEADER, LINK, MAGIC
from nctakt.hli.places import entry, size_of
from nctakt.hli.plc_side import PlcSide
from nctakt.hli.process_watch import ProcessWatch, is_living
from nctakt.messages import diagnostic
from nctakt.messages.plcs.hli_connection import HLI_HAS_PLC, NO_HLI_OF_NAME, NO_TICK_AT_HLI

#: Looks without a pause: the CNC on another core runs a tick within some microseconds.
_EAGER_LOOKS = 50

#: The pauses between two later looks, in seconds: for the next tick, and for an image.
_TICK_PAUSE_S = 0.00002
_IMAGE_PAUSE_S = 0.01

#: Number of polls between two checks whether the CNC's process still lives.
_LOOKS_PER_WATCH = 500


#: The folder of shared memory on Linux.
FOLDER = Path("/dev/shm")


class TickPlc(Protocol):
    """A PLC that is called after each tick."""

    def cycle(self, hli: PlcSide) -> None:
        """Read inputs and set outputs."""


class PlcConnection(PlcSide):
    """The PLC at the HLI of a CNC in another process; also a context manager.

    It is the PLC's side of the first channel; ``of_channel`` returns that of the others. Closing
    informs the CNC that the PLC has gone.
    """

    def __init__(self, shared: SharedFile, access: ImageAccess) -> None:
        super().__init__(access)
        self._shared: SharedFile | None = shared
        self._cnc = ProcessWatch(int(access.number(HEADER, 0, "process")))
        self._link = access.offset(LINK)
        self._seen_tick = self.tick
        access.put_number(LINK, self._link, "process", os.getpid())
        self._be_present(1)

    # --- ticks ----------------------------------------------------------------------------------

    @property
    def is_lockstep(self) -> bool:
        """Whether the CNC waits for an answer after each tick."""
        return self._access.number(HEADER, 0, "lockstep") != 0

    @property
    def is_running(self) -> bool:
        """Whether the CNC is still there."""
        return self._access.number(HEADER, 0, "ready") != 0 and not self._cnc.is_gone

    def next_tick(self, within_s: float | None = None) -> bool:
        """Answer the latest tick and wait for the next one; return False once the CNC has ended.

        Raises ``Failure`` (901439) if none comes within ``within_s`` seconds; without it the CNC
        may pause for any time.
        """
        if self.is_lockstep:
            turn = self._access.number(HEADER, 0, "turn")
            self._access.put_number(LINK, self._link, "turn", turn)
        end = None if within_s is None else time.monotonic() + within_s
        looks = 0
        while not self._is_tick_done():
            looks += 1
            if looks > _EAGER_LOOKS:
                time.sleep(_TICK_PAUSE_S)
            if looks % _LOOKS_PER_WATCH == 0 and self._cnc.is_gone:
                return False
            if self._access.number(HEADER, 0, "ready") == 0:
                return False
            if end is not None and time.monotonic() > end:
                raise Failure(diagnostic(NO_TICK_AT_HLI, name=self._access.name, seconds=within_s))
        self._seen_tick = self.tick
        return True

    def ticks(self) -> Iterator[int]:
        """Yield the number of each tick once the CNC has run it, until the CNC ends.

        Everything done before the next one is the answer to it. Without lockstep ticks that go by
        meanwhile are left out.
        """
        while self.next_tick():
            yield self.tick

    def run(self, plc: TickPlc) -> None:
        """Let an object with ``cycle(self, hli)`` be the PLC until the CNC ends."""
        for _ in self.ticks():
            plc.cycle(self)

    def _is_tick_done(self) -> bool:
        """Return whether it is the PLC's turn; without lockstep: whether a tick was run."""
        if not self.is_lockstep:
            return self.tick != self._seen_tick
        turn = self._access.number(HEADER, 0, "turn")
        return turn != self._access.number(LINK, self._link, "turn")

    # --- the end --------------------------------------------------------------------------------

    def close(self) -> None:
        """Inform the CNC that the PLC has gone, and release the image; may be repeated."""
        shared, self._shared = self._shared, None
        if shared is None:
            return
        self._be_present(0)
        self._access.put_number(LINK, self._link, "process", 0)
        self._cnc.close()
        self._access.release()
        shared.close()

    def _be_present(self, value: int) -> None:
        for index in range(self.channel_count):
            self._access.put_number(
                COMMAND, self._access.offset(COMMAND, index), "plc_present", value
            )

    def __enter__(self) -> PlcConnection:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self.close()


def attach(name: str, within_s: float = 10.0) -> PlcConnection:
    """Return the PLC's side of the HLI with this name as soon as a CNC shares it.

    Raises ``Failure`` if none does within ``within_s`` seconds (901430), if the shared memory is
    not of this version (901431 … 901433), or if it has a PLC already (901434).
    """
    shared = _open(name, within_s)
    memory = shared.memory[:]
    try:
        access = ImageAccess(name, memory)
        _check_free(access)
    except BaseException:
        memory.release()
        shared.close()
        raise
    return PlcConnection(shared, access)


def _open(name: str, within_s: float) -> SharedFile:
    """Return the shared memory once its maker has finished it."""
    end = time.monotonic() + within_s
    while True:
        shared = _existing(name)
        if shared is not None:
            if _is_finished(shared):
                return shared
            shared.close()
        if time.monotonic() > end:
            known = ", ".join(image_names()) or NOTHING
            raise Failure(diagnostic(NO_HLI_OF_NAME, name=name, seconds=within_s, known=known))
        time.sleep(_IMAGE_PAUSE_S)


def _existing(name: str) -> SharedFile | None:
    try:
        return SharedFile(name)
    except (OSError, ValueError):
        return None


def _is_finished(shared: SharedFile) -> bool:
    """Return whether the CNC is ready; true also without an image, which is reported later."""
    magic = bytes(shared.memory[: len(MAGIC)])
    if magic != MAGIC or len(shared.memory) < size_of(HEADER):
        return any(magic)
    ready = entry(HEADER, "ready").offset
    return any(shared.memory[ready : ready + 4])


def _check_free(access: ImageAccess) -> None:
    """Raise ``Failure`` (901434) if another PLC whose process still lives is attached."""
    process = int(access.number(LINK, access.offset(LINK), "process"))
    is_present = access.number(COMMAND, access.offset(COMMAND), "plc_present") != 0
    if is_present and process > 0 and is_living(process):
        raise Failure(diagnostic(HLI_HAS_PLC, name=access.name, process=process))


class SharedFile:
    """The bytes of shared memory; raises ``OSError`` or ``ValueError`` if there is none."""

    def __init__(self, name: str) -> None:
        if not name or "/" in name or "\0" in name:
            raise ValueError(name)
        if FOLDER.is_dir():
            with (FOLDER / name).open("r+b") as file:
                self._map = mmap.mmap(file.fileno(), 0)
            self.memory = memoryview(self._map)
            self._close = self._map.close
        else:
            from multiprocessing import resource_tracker  # noqa: PLC0415 - not on Linux
            from multiprocessing.shared_memory import SharedMemory  # noqa: PLC0415 - as above

            start_resource_tracker()
            shared = SharedMemory(name)
            if sys.platform != "win32":
                # the maker removes it; without this the end of this process would
                resource_tracker.unregister(f"/{name}", "shared_memory")
            self.memory = memoryview(shared.buf or b"")
            self._close = shared.close

    def close(self) -> None:
        """Let go of the bytes; views of them are released before."""
        self.memory.release()
        self._close()


def image_names() -> list[str]:
    """Return the names of all images of an HLI that can be found; none outside Linux."""
    found = []
    for path in sorted(FOLDER.glob("*")) if FOLDER.is_dir() else ():
        try:
            with path.open("rb") as file:
                if file.read(len(MAGIC)) == MAGIC:
                    found.append(path.name)
        except OSError:
            continue  # another user's
    return found
