# SPDX-License-Identifier: MIT
"""The options of commands that read a machine's log, and the log with its signals.

In: the name of a log, its options on the command line. Out: ``OpenedLog``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypeVar

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.base.failure import Failure
from nctakt.cli.common.help import NumberRange, option
from nctakt.files.access import FileAccess
from nctakt.messages import diagnostic
from nctakt.messages.commands.comparison import TOLERANCE_UNREADABLE, TWO_PLACES
from nctakt.run.option_kinds import by_name

if TYPE_CHECKING:
    from nctakt.comparison.aligning_event import GivenTime
    from nctakt.comparison.log import Log
    from nctakt.comparison.mapping import Pair, Tolerance
    from nctakt.run.controller import Controller

_Command = TypeVar("_Command", bound=Callable[..., Any])

#: More is another speed, and no drift of a clock.
_MAX_DRIFT_PPM = 1000.0

_MAP = option(
    "--map",
    "mapping",
    metavar="FILE.toml",
    text=Text("Which column belongs to which signal.", "Welche Spalte zu welchem Signal gehört."),
)
_TOLERANCE = option(
    "--tolerance",
    "tolerances",
    metavar="[NAME=]VALUE",
    multiple=True,
    text=Text(
        "How far a signal, or each, may be off: in its unit, in % of its span, and with +Nticks "
        "that much earlier or later; may be repeated.",
        "Wie weit ein Signal oder jedes abweichen darf: in seiner Einheit, in % seiner Spanne, und "
        "mit +Nticks so viele Takte früher oder später; mehrfach möglich.",
    ),
)
_OFFSET = option(
    "--offset",
    metavar="TIME",
    text=Text(
        "When the run begins in the log [default: found by correlation].",
        "Wann der Lauf im Log beginnt [Vorgabe: über Korrelation gesucht].",
    ),
)

_ALIGN = option(
    "--align",
    metavar="EVENT",
    text=Text(
        "An event that run and log have: 'X.ACS.ACT_POS > 10', 'V.E.GATE rises', "
        "'M10 @ COLUMN rises', 'part.nc:4 @ COLUMN > 1'.",
        "Ein Ereignis, das in Lauf und Log vorkommt: 'X.ACS.ACT_POS > 10', 'V.E.GATE rises', "
        "'M10 @ SPALTE rises', 'part.nc:4 @ SPALTE > 1'.",
    ),
)
_DRIFT = option(
    "--drift",
    metavar="PPM",
    type=NumberRange(-_MAX_DRIFT_PPM, _MAX_DRIFT_PPM),
    text=Text(
        "By how many ppm the log's clock is faster than the run's [default: found in the curves].",
        "Um wie viele ppm die Uhr des Logs gegen die des Laufs vorgeht [Vorgabe: in den Kurven "
        "gesucht].",
    ),
)


def log_options(function: _Command) -> _Command:
    """Add the options that say how a log is read."""
    return _MAP(_TOLERANCE(_OFFSET(_ALIGN(_DRIFT(function)))))


@dataclass(frozen=True, slots=True)
class LogWords:
    """The words of these options, and the name of the log."""

    log: str
    mapping: str | None
    tolerances: tuple[str, ...]
    offset: str | None
    align: str | None = None
    drift: float | None = None

    def read_limits(self) -> dict[str, Tolerance]:
        """Return the tolerances by signals, "" for all others; raises ``Failure`` (902529)."""
        return by_name("--tolerance", map(_tolerance, self.tolerances))


@dataclass(frozen=True, slots=True)
class OpenedLog:
    """A log, its pairs of columns and signals; ``limits``: tolerances by signals."""

    log: Log
    pairs: Sequence[Pair]
    limits: Mapping[str, Tolerance]
    given: GivenTime

    @property
    def signals(self) -> tuple[str, ...]:
        """The names of the signals that the run must record."""
        names = [pair.signal.name for pair in self.pairs]
        event = self.given.event
        if event is not None and event.event.signal:
            names.append(event.event.signal)
        return tuple(dict.fromkeys(names))


def opened_log(words: LogWords, controller: Controller, access: FileAccess) -> OpenedLog:
    """Return the log and its signals; raises ``Failure`` if it cannot be used."""
    from nctakt.comparison.aligning_event import (  # noqa: PLC0415 - the mode is chosen before
        AligningEvent,
        EventInLog,
        GivenTime,
    )
    from nctakt.comparison.log_file import open_log  # noqa: PLC0415 - the mode is chosen before
    from nctakt.comparison.mapping import MappingFile, pairs_of, read_mapping  # noqa: PLC0415
    from nctakt.lists.format.times import read_time  # noqa: PLC0415

    limits = words.read_limits()
    if words.offset is not None and words.align is not None:
        raise Failure(diagnostic(TWO_PLACES))
    said = MappingFile() if words.mapping is None else read_mapping(words.mapping, access)
    log = open_log(words.log, access, said.log)
    offset = words.offset
    offset_us = None if offset is None else read_time(offset).us(controller.cycle_time_us)
    signals = {one.name: one for one in controller.signals()}
    event = None if words.align is None else AligningEvent.of(words.align)
    own = () if event is None or not event.signal else (event.signal,)
    for requested in (*said.mappings, *filter(None, limits), *own):
        if requested not in signals:
            controller.signal(requested)  # raises with the nearest name
    axes = [axis.name for axis in controller.machine.axes]
    pairs = pairs_of(log, list(signals.values()), axes, said.mappings)
    begin: float | EventInLog | None = offset_us
    if event is not None:
        begin = EventInLog(event, *event.log_us(log, pairs, signals), signals)
    drift = None if words.drift is None else words.drift * 1e-6
    return OpenedLog(log, pairs, limits, GivenTime(begin, drift))


def _tolerance(text: str) -> tuple[str, Tolerance]:
    """Return signal ("" for all) and tolerance; raises ``Failure`` (902529)."""
    from nctakt.comparison.mapping import Tolerance  # noqa: PLC0415 - the mode is chosen before

    name, _, value = text.rpartition("=")
    try:
        return name.strip(), Tolerance.of(value)
    except ValueError:
        raise Failure(diagnostic(TOLERANCE_UNREADABLE, text=text)) from None
