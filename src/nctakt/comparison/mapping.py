# SPDX-License-Identifier: MIT
"""Which column of a log belongs to which signal of a run.

In: the columns, the signals, and a mapping file in TOML. Out: pairs. A column with the name of a
signal belongs to it; a similar name is a suggestion and marked as such; if several names are
similar, none is used.
"""

from __future__ import annotations

import math
import re
from collections import defaultdict
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.base.misspelling import nearest
from nctakt.base.unit_factors import factor_between
from nctakt.comparison.log import Log, LogColumn
from nctakt.files.access import FileAccess
from nctakt.files.toml_text import TomlError, entry_place, read_toml
from nctakt.messages import diagnostic
from nctakt.messages.commands.comparison import (
    COLUMN_UNKNOWN,
    MAPPING_UNREADABLE,
    NAMES_ALIKE,
    NOTHING_IS_MAPPED,
    UNITS_DO_NOT_FIT,
)
from nctakt.results.trace.sinks import Signal

_LOG_KEYS = ("separator", "decimal", "time", "time_unit")
_PAIR_KEYS: Mapping[str, tuple[type, ...]] = {
    "log": (str,),
    "unit": (str,),
    "factor": (int, float),
    "offset": (int, float),
    "tolerance": (int, float, str),
}
_TOKEN = re.compile(r"[A-Z]?[a-zäöüß]+|[A-Z]+(?![a-z])|\d+")
_MEANINGS = {
    "actual": "act", "ist": "act", "istwert": "act", "actpos": "act", "cmd": "set",
    "command": "set", "commanded": "set", "setpoint": "set", "soll": "set", "sollwert": "set",
    "position": "pos", "lage": "pos", "vel": "speed", "velo": "speed", "velocity": "speed",
    "feed": "speed", "feedrate": "speed", "drehzahl": "speed", "vorschub": "speed",
    "geschwindigkeit": "speed", "spindle": "s", "spindel": "s", "bahn": "path",
}  # fmt: skip
#: Words of quantities that a run does not have.
_OTHERS = frozenset(
    ("acc", "acceleration", "jerk", "torque", "lag", "following", "error", "diff", "current")
)


_TOLERANCE = re.compile(
    r"(?:(?P<amount>[\d.]+(?:[eE][-+]?\d+)?)\s*(?P<share>%)?)?"
    r"(?:(?(amount)\s*\+\s*)(?P<ticks>\d{1,3})\s*ticks?)?"
)


@dataclass(frozen=True, slots=True)
class Tolerance:
    """How far a log may be from a run: ``amount``, in the signal's unit or in % of its span.

    ``ticks``: this much earlier or later, too: the measure is the log's distance from all values of
    the run in this time.
    """

    amount: float = 0.0
    is_share: bool = False
    ticks: int = 0

    @classmethod
    def of(cls, text: str) -> Tolerance:
        """Return that of ``0.05``, ``2%``, ``3ticks`` or ``0.05+3ticks``; raises ``ValueError``."""
        match = _TOLERANCE.fullmatch(text.strip())
        if match is None or not text.strip():
            raise ValueError(text)
        amount = float(match["amount"] or 0.0)
        if not math.isfinite(amount):
            raise ValueError(text)
        return cls(amount, bool(match["share"]), int(match["ticks"] or 0))


@dataclass(frozen=True, slots=True)
class ColumnMapping:
    """A mapping file's settings for a signal."""

    column: str
    unit: str = ""
    factor: float = 1.0
    offset: float = 0.0
    tolerance: Tolerance | None = None


@dataclass(slots=True)
class MappingFile:
    """A mapping file: how the log is written, and columns by signals."""

    log: dict[str, str] = field(default_factory=dict)
    mappings: dict[str, ColumnMapping] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Pair:
    """A signal and its column; a value is ``factor`` · the log's number + ``offset``."""

    signal: Signal
    column: LogColumn
    factor: float
    offset: float
    tolerance: Tolerance | None
    is_suggested: bool


def read_mapping(path: str | Path, access: FileAccess) -> MappingFile:
    """Return a mapping file; raises ``Failure`` (902521) for any other file."""
    try:
        text = access.read_bytes(Path(path)).decode("utf-8")
        content = read_toml(str(path), text)
    except UnicodeDecodeError as error:
        raise Failure(diagnostic(MAPPING_UNREADABLE, file=str(path), reason=str(error))) from error
    except TomlError as error:
        reason = str(error)
        raise Failure(
            diagnostic(MAPPING_UNREADABLE, error.span, error.line, file=str(path), reason=reason)
        ) from error
    found = MappingFile()

    def refuse(*keys: str, reason: str = "") -> Failure:
        span, line = entry_place(str(path), text, keys)
        reason = reason or ".".join(keys)
        return Failure(diagnostic(MAPPING_UNREADABLE, span, line, file=str(path), reason=reason))

    for name, part in content.items():
        if name not in ("log", "signals") or not isinstance(part, dict):
            raise refuse(name, reason=f"{name} is neither [log] nor [signals]")
    for key, value in content.get("log", {}).items():
        if key not in _LOG_KEYS or not isinstance(value, str) or not value:
            raise refuse("log", key)
        found.log[key] = value
    for signal, said in content.get("signals", {}).items():
        words = {"log": said} if isinstance(said, str) else said
        if not isinstance(words, dict) or "log" not in words:
            raise refuse("signals", signal)
        for key, value in words.items():
            if not isinstance(value, _PAIR_KEYS.get(key, ())) or isinstance(value, bool):
                raise refuse("signals", signal, key)
        try:
            found.mappings[signal] = _column_mapping(words)
        except ValueError:
            raise refuse("signals", signal, "tolerance") from None
    return found


def _column_mapping(words: Mapping[str, Any]) -> ColumnMapping:
    tolerance = words.get("tolerance")
    return ColumnMapping(
        words["log"],
        words.get("unit", ""),
        float(words.get("factor", 1.0)),
        float(words.get("offset", 0.0)),
        None if tolerance is None else Tolerance.of(str(tolerance)),
    )


def pairs_of(
    log: Log, signals: Sequence[Signal], axes: Sequence[str], mappings: Mapping[str, ColumnMapping]
) -> list[Pair]:
    """Return the pairs of signals and columns; ambiguous ones are noted in the log.

    Raises ``Failure`` for columns that there are not (902520), units that do not fit (902518), and
    if nothing is mapped (902519). A mapping file leaves nothing to suggestions.
    """
    known = {signal.name: signal for signal in signals}
    mistakes: list[Diagnostic] = []
    pairs: list[Pair] = []
    if mappings:
        columns = {column.name: column for column in log.columns}
        for name, choice in mappings.items():
            column = columns.get(choice.column)
            if column is None:
                near = nearest(choice.column, columns)
                hint = f": {near}?" if near else ""
                mistakes.append(
                    diagnostic(COLUMN_UNKNOWN, file=log.file, name=choice.column, hint=hint)
                )
            else:
                pairs += _fitting(known[name], column, choice, mistakes)
    else:
        for name, column, is_suggested in _by_name(log, known, axes):
            pairs += _fitting(
                known[name], column, ColumnMapping(column.name), mistakes, is_suggested
            )
    if mistakes:
        raise Failure(*mistakes)
    if not pairs:
        columns_text = ", ".join(column.name for column in log.columns[:20])
        nothing = diagnostic(NOTHING_IS_MAPPED, file=log.file, columns=columns_text)
        raise Failure(nothing, *log.notes)
    return pairs


def _fitting(
    signal: Signal,
    column: LogColumn,
    choice: ColumnMapping,
    mistakes: list[Diagnostic],
    is_suggested: bool = False,
) -> list[Pair]:
    unit = choice.unit or column.unit
    factor = factor_between(unit, signal.unit)
    if factor is None and choice.factor == 1.0:
        mistakes.append(
            diagnostic(
                UNITS_DO_NOT_FIT,
                name=column.name,
                unit=unit,
                signal=signal.name,
                other=signal.unit or "-",
            )
        )
        return []
    factor = choice.factor * (1.0 if factor is None else factor)
    return [Pair(signal, column, factor, choice.offset, choice.tolerance, is_suggested)]


def _by_name(
    log: Log, known: Mapping[str, Signal], axes: Sequence[str]
) -> list[tuple[str, LogColumn, bool]]:
    """Return signals and columns of equal names, then similar ones, marked as suggestions."""
    found = [(column.name, column, False) for column in log.columns if column.name in known]
    taken = {name for name, _, _ in found}
    alike: dict[str, list[LogColumn]] = defaultdict(list)
    for column in log.columns:
        name = suggestion(column.name, axes)
        if column.name not in known and name in known and name not in taken:
            alike[name].append(column)
    for name, columns in alike.items():
        if len(columns) == 1:
            found.append((name, columns[0], True))
        else:
            names = ", ".join(column.name for column in columns)
            log.notes.append(diagnostic(NAMES_ALIKE, columns=names, signal=name))
    return found


def suggestion(name: str, axes: Sequence[str]) -> str:
    """Return the signal that a column resembles, "" for none.

    >>> suggestion("Axis X ActPos", ["X", "Y"]), suggestion("GVL.fbY.Sollwert", ["X", "Y"])
    ('X.ACS.ACT_POS', 'Y.ACS.CMD_POS')
    """
    words = [word.casefold() for word in _TOKEN.findall(name)]
    tokens = {_MEANINGS.get(word, word) for word in words}
    if tokens & _OTHERS:
        return ""
    if "speed" in tokens:
        if "path" in tokens:
            return "PATH.SPEED"
        return "S.SPEED" if "s" in tokens else ""
    named = [axis for axis in axes if axis.casefold() in tokens]
    if len(named) != 1 or not tokens & {"act", "set", "pos"}:
        return ""
    return f"{named[0]}.ACS.{'CMD' if 'set' in tokens else 'ACT'}_POS"
