# SPDX-License-Identifier: MIT
"""Traces as MF4 files (ASAM MDF 4.1, extra ``measure``), as measuring tools read them.

In: the chunks of a sink. Out: a group with a channel for each signal, in its unit, over the time of
each tick in seconds; a group ``events`` with their texts. The same trace gives the same bytes: the
measurement begins at 0.
"""

from __future__ import annotations

import datetime
import importlib
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from nctakt.base.failure import Failure
from nctakt.files.output import OutputFile
from nctakt.messages import diagnostic
from nctakt.messages.commands.studies import EXTRA_MISSING
from nctakt.messages.extras import install_command
from nctakt.results.trace.events import Event
from nctakt.results.trace.sinks import TraceHeader
from nctakt.results.trace.texts import by_tick, join_events

#: Rows that are written together.
_GROUP = 65_536
#: Bytes of the finished file that are copied at once.
_PIECE = 1 << 20
#: Where the header block has the address of the history, and a history its successor and its time.
_HISTORY, _NEXT, _TIME = 96, 24, 40
_TIME_BYTES = 8


def load_asammdf() -> Any:
    """Return asammdf; raises ``Failure`` (901311) where it is missing."""
    try:
        return importlib.import_module("asammdf")
    except ImportError as error:
        raise Failure(
            diagnostic(EXTRA_MISSING, package="asammdf", install=install_command("measure"))
        ) from error


class Mf4Sink:
    """Writes a trace to an MF4 file, which gets its name when it is whole.

    Raises ``Failure``: no asammdf (901311), a file that cannot be written (900507).
    """

    def __init__(self, file: Path | OutputFile) -> None:
        self._library = load_asammdf()
        self._target = file
        self._header = TraceHeader(0, ())
        self._measured: Any = None
        self._has_group = False
        self._next_tick = 0
        self._values: list[float] = []
        self._ticks: list[int] = []
        self._texts: list[bytes] = []

    def open(self, header: TraceHeader) -> None:
        """Begin the measurement."""
        self._header = header
        self._measured = self._library.MDF(version="4.10")
        self._measured.header.start_time = datetime.datetime(1970, 1, 1, tzinfo=datetime.UTC)
        self._measured.header.comment = "nctakt"

    def events(self, events: Sequence[Event]) -> None:
        """Keep the events for the end."""
        for tick, together in by_tick(list(events)):
            self._ticks.append(tick)
            self._texts.append(join_events(together).encode())

    def rows(self, first_tick: int, rows: memoryview[float], width: int) -> None:
        """Take the values of ticks; write them when there are many."""
        if not self._values:
            self._next_tick = first_tick
        self._values.extend(rows.tolist())
        if width and len(self._values) >= _GROUP * width:
            self._write()

    def _write(self) -> None:
        import numpy  # noqa: PLC0415 - only where a trace is written

        signals = self._header.signals
        table = numpy.array(self._values).reshape(-1, max(len(signals), 1))
        if not table.size:
            return
        times = self._seconds(numpy.arange(len(table)) + self._next_tick)
        if self._has_group:
            columns = [(table[:, at].copy(), None) for at in range(len(signals))]
            self._measured.extend(0, [(times, None), *columns])
        else:
            channels = [
                self._library.Signal(table[:, at].copy(), times, name=one.name, unit=one.unit)
                for at, one in enumerate(signals)
            ]
            self._measured.append(channels, acq_name="ticks", common_timebase=True)
        self._has_group = True
        self._values = []

    def _seconds(self, ticks: Any) -> Any:
        return ticks * self._header.cycle_time_us / 1e6

    def close(self) -> None:
        """Write the rest, and the file."""
        measured, self._measured = self._measured, None
        if measured is None:
            return
        self._measured = measured
        try:
            self._write()
            self._write_events()
            with tempfile.TemporaryDirectory(prefix="nctakt-mf4-") as folder:
                path = Path(folder, "trace.mf4")
                measured.save(path, overwrite=True, compression=2)
                _remove_times(path)
                self._copy(path)
        finally:
            self._measured = None
            measured.close()

    def _write_events(self) -> None:
        import numpy  # noqa: PLC0415 - as above

        if self._texts:
            texts = numpy.array(self._texts, dtype=bytes)
            times = self._seconds(numpy.array(self._ticks))
            signal = self._library.Signal(texts, times, name="events", encoding="utf-8")
            self._measured.append([signal], acq_name="events", common_timebase=True)

    def _copy(self, path: Path) -> None:
        target = self._target
        file = OutputFile(target) if isinstance(target, Path) else target
        with path.open("rb") as written:
            while piece := written.read(_PIECE):
                file.write(piece)
        if isinstance(target, Path):
            file.close()


def _remove_times(path: Path) -> None:
    """Set the times of the file's history, when it was written, to 0."""
    with path.open("r+b") as file:
        file.seek(_HISTORY)
        address = int.from_bytes(file.read(8), "little")
        while address:
            file.seek(address + _TIME)
            file.write(bytes(_TIME_BYTES))
            file.seek(address + _NEXT)
            address = int.from_bytes(file.read(8), "little")
