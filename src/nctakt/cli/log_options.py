# SPDX-License-Identifier: MIT
"""The options of commands that read a machine's log, and the log with its signals.

In: the name of a log, what the command line says of it. Out: ``OpenedLog``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypeVar

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.base.failure import Failure
from nctakt.cli.help import option
from nctakt.files.access import FileAccess
from nctakt.messages import diagnostic
from nctakt.messages.comparison import TOLERANCE_UNREADABLE

if TYPE_CHECKING:
    from nctakt.comparison.log import Log
    from nctakt.comparison.mapping import Pair, Tolerance
    from nctakt.run.controller import Controller

_Command = TypeVar("_Command", bound=Callable[..., Any])

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
        "Wann der Lauf in der Aufzeichnung beginnt [Vorgabe: über Korrelation gesucht].",
    ),
)


def log_options(function: _Command) -> _Command:
    """Add the options that say how a log is read."""
    return _MAP(_TOLERANCE(_OFFSET(function)))


@dataclass(frozen=True, slots=True)
class LogWords:
    """The words of these options, and the name of the log."""

    log: str
    mapping: str | None
    tolerances: tuple[str, ...]
    offset: str | None

    def read_limits(self) -> dict[str, Tolerance]:
        """Return the tolerances by signals, "" for all others; raises ``Failure`` (902529)."""
        return dict(_tolerance(text) for text in self.tolerances)


@dataclass(frozen=True, slots=True)
class OpenedLog:
    """A log, its pairs of columns and signals; ``limits``: tolerances by signals."""

    log: Log
    pairs: Sequence[Pair]
    limits: Mapping[str, Tolerance]
    offset_us: float | None

    @property
    def signals(self) -> tuple[str, ...]:
        """The names of the signals that the run must record."""
        return tuple(dict.fromkeys(pair.signal.name for pair in self.pairs))


def opened_log(words: LogWords, controller: Controller, access: FileAccess) -> OpenedLog:
    """Return the log and its signals; raises ``Failure`` for what cannot be used."""
    from nctakt.comparison.log_file import open_log  # noqa: PLC0415 - the mode is chosen before
    from nctakt.comparison.mapping import MappingFile, pairs_of, read_mapping  # noqa: PLC0415
    from nctakt.lists.format.times import read_time  # noqa: PLC0415

    limits = words.read_limits()
    said = MappingFile() if words.mapping is None else read_mapping(words.mapping, access)
    log = open_log(words.log, access, said.log)
    offset = words.offset
    offset_us = None if offset is None else read_time(offset).us(controller.cycle_time_us)
    signals = {one.name: one for one in controller.signals()}
    for wished in (*said.wishes, *filter(None, limits)):
        if wished not in signals:
            controller.signal(wished)  # raises with the nearest name
    axes = [axis.name for axis in controller.machine.axes]
    return OpenedLog(
        log, pairs_of(log, list(signals.values()), axes, said.wishes), limits, offset_us
    )


def _tolerance(text: str) -> tuple[str, Tolerance]:
    """Return signal ("" for all) and tolerance; raises ``Failure`` (902529)."""
    from nctakt.comparison.mapping import Tolerance  # noqa: PLC0415 - the mode is chosen before

    name, _, value = text.rpartition("=")
    try:
        return name.strip(), Tolerance.of(value)
    except ValueError:
        raise Failure(diagnostic(TOLERANCE_UNREADABLE, text=text)) from None
