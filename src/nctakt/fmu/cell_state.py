# SPDX-License-Identifier: MIT
"""The state of a machine inside an FMU: the inputs until then, and a digest to recognize it.

A state holds no memory of the machine. Its run is made again with the same inputs: same inputs,
same bytes. So a state is small and outlasts its process, and putting it back takes as long as the
run up to it. In: the inputs of a run as they come. Out: ``CellState``, as an object and as bytes.
"""

from __future__ import annotations

import hashlib
import json
import tempfile
from collections.abc import Iterator, Sequence

import numpy
from numpy.typing import NDArray

from nctakt.base.dataclass import dataclass
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.plcs.fmu import CELL_INPUTS_NOT_KEPT, CELL_STATE_UNREADABLE
from nctakt.results.trace.chunks import EventChunk
from nctakt.results.trace.events import Event
from nctakt.results.trace.sinks import TraceHeader

#: Numbers of an input: the tick that latches it, the variable's reference, the value.
_WIDTH = 3
#: Inputs that wait to be written, and that are read at a time.
_PART = 4096
#: Bytes of inputs that stay in memory.
_IN_MEMORY = 1 << 20
#: How an input is stored.
_STORED = "<f8"
_DIGEST_SIZE = 16


@dataclass(frozen=True, slots=True)
class CellState:
    """A state after ``ticks`` ticks: the first ``count`` inputs of ``inputs`` lead to it.

    ``token``: of the FMU; ``start_us``: the importer's time at the begin; ``shown``: how many
    messages it has got; ``digest``: of memory and events.
    """

    token: str
    ticks: int
    start_us: float
    shown: int
    digest: str
    inputs: CellInputs
    count: int


class CellInputs:
    """The inputs of a run, in the order of their arrival; those of another one may come first.

    They lie in a temporary file without a name, so that a long run does not fill the memory.
    """

    def __init__(self, before: CellInputs | None = None, count: int = 0) -> None:
        self._before, self._shared = before, count
        self._file = tempfile.SpooledTemporaryFile(_IN_MEMORY)
        self._waiting: list[float] = []
        self._written = 0

    def __del__(self) -> None:
        self._file.close()

    def __len__(self) -> int:
        return self._shared + self._written + len(self._waiting) // _WIDTH

    def note(self, tick: int, reference: int, value: float) -> None:
        """Note an input; raises ``Failure`` (902840) when the disk is full."""
        self._waiting += (tick, reference, value)
        if len(self._waiting) >= _WIDTH * _PART:
            self._write()

    def _write(self) -> None:
        try:
            self._file.seek(0, 2)
            self._file.write(numpy.array(self._waiting, dtype=_STORED).tobytes())
        except OSError as error:
            reason = error.strerror or str(error)
            raise Failure(diagnostic(CELL_INPUTS_NOT_KEPT, reason=reason)) from error
        self._written += len(self._waiting) // _WIDTH
        self._waiting = []

    def parts(self, count: int) -> Iterator[NDArray[numpy.float64]]:
        """Yield the first ``count`` inputs in parts, a row each."""
        if self._before is not None and self._shared:
            yield from self._before.parts(min(count, self._shared))
        own = count - self._shared
        for begin in range(0, min(own, self._written), _PART):
            rows = min(_PART, own - begin, self._written - begin)
            self._file.seek(begin * _WIDTH * 8)
            yield _rows(self._file.read(rows * _WIDTH * 8))
        if own > self._written:
            waiting = self._waiting[: (own - self._written) * _WIDTH]
            yield numpy.array(waiting, dtype=_STORED).reshape(-1, _WIDTH)


class EventDigest:
    """A sink that digests all events of a run."""

    def __init__(self) -> None:
        self._events = hashlib.blake2b(digest_size=_DIGEST_SIZE)

    def open(self, header: TraceHeader) -> None:
        """Do nothing."""

    def rows(self, first_tick: int, rows: memoryview[float], width: int) -> None:
        """Do nothing."""

    def events(self, events: Sequence[Event]) -> None:
        """Digest events."""
        assert isinstance(events, EventChunk)
        self._events.update(events.data)

    def close(self) -> None:
        """Do nothing."""

    def with_memories(self, memories: Sequence[bytearray | memoryview]) -> str:
        """Return the digest of the events so far and of memories."""
        whole = self._events.copy()
        for one in memories:
            whole.update(one)
        return whole.hexdigest()


def state_to_bytes(state: CellState) -> bytes:
    """Return a state as bytes: a line in JSON, then its inputs."""
    head = {
        "nctakt": state.token,
        "ticks": state.ticks,
        "start_us": state.start_us,
        "shown": state.shown,
        "digest": state.digest,
        "count": state.count,
    }
    parts = (part.tobytes() for part in state.inputs.parts(state.count))
    return b"".join((json.dumps(head).encode(), b"\n", *parts))


def state_from_bytes(data: bytes) -> CellState:
    """Return the state in bytes; raises ``Failure`` (902841) if they are not one."""
    head, _, rows = data.partition(b"\n")
    try:
        said = json.loads(head)
        inputs = CellInputs()
        for tick, reference, value in _rows(rows).tolist():
            inputs.note(int(tick), int(reference), value)
        state = CellState(
            str(said["nctakt"]),
            int(said["ticks"]),
            float(said["start_us"]),
            int(said["shown"]),
            str(said["digest"]),
            inputs,
            int(said["count"]),
        )
    except (ValueError, OverflowError, KeyError, TypeError, RecursionError) as error:
        raise Failure(diagnostic(CELL_STATE_UNREADABLE, reason=str(error))) from error
    if state.count != len(inputs):
        raise Failure(diagnostic(CELL_STATE_UNREADABLE, reason=f"{len(inputs)} / {state.count}"))
    return state


def _rows(data: bytes) -> NDArray[numpy.float64]:
    return numpy.frombuffer(data, dtype=_STORED).reshape(-1, _WIDTH)
