# SPDX-License-Identifier: MIT
"""The tables ``[[vary]]`` of a plan -> its dimensions, checked entry by entry."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any

from nctakt.base.diagnostics import Text
from nctakt.lists.all_parameters import SCHEMAS
from nctakt.lists.format.times import Time, read_time
from nctakt.run.access.stimuli import parse_assignment
from nctakt.studies.plans.dimension import (
    END_OF_RUN,
    FILE_KINDS,
    TIME_KINDS,
    Dimension,
    Kind,
    Value,
)
from nctakt.studies.plans.distribution import Distribution
from nctakt.studies.plans.distribution_reader import OF_DISTRIBUTION, DistributionReader
from nctakt.studies.plans.faults import NEVER, TWICE
from nctakt.studies.plans.plan_reader import (
    LIST,
    NAME,
    NUMBER,
    NUMBER_OR_TEXT,
    WHOLE,
    PlanReader,
    is_name,
    is_number,
    is_value,
)

COMMON = (
    "name", "values", "from", "to", "step", "nominal", "distribution", *OF_DISTRIBUTION
)  # fmt: skip
#: Quantities that can be varied, with the further entries of each.
WORDS: Mapping[Kind, tuple[str, ...]] = MappingProxyType(
    {
        "variable": ("at", "for", "rest", "over"),
        "time_of": ("for", "rest", "each_tick"),
        "noise": ("at", "for", "rest", "amount"),
        "series": (),
        "acknowledge": (),
        "plc_dies": (),
        "plc_returns": (),
        "parameter": ("of",),
        "program_variable": (),
        "load_entry": ("each_phase",),
        "rtconf": (),
        "load": (),
    }
)
#: The most values of a ramp or a noise.
MAX_COURSE = 1_000_000

_OF = re.compile(r"(P-[A-Z]+-\d+)\s+of\s+(\S.*)")
_FUNCTION = re.compile(r"[MHT]\d+", re.IGNORECASE)
_ACKNOWLEDGED = Text('a function such as "M8"', 'eine Funktion wie "M8"')
_EITHER = Text("left out beside from and to", "neben from und to weggelassen")
_ANSWER = Text('a time, "never" or "twice"', 'eine Zeit, "never" oder "twice"')
_SHORT = Text(
    f"a time of at most {MAX_COURSE} ticks", f"eine Zeit von höchstens {MAX_COURSE} Takten"
)
_STEP = Text("above 0", "größer als 0")
_PHASE = Text("interrupt.phase, to vary each phase", "interrupt.phase, um jede Phase zu nehmen")


class DimensionReader:
    """Reads dimensions for ``reader``.

    ``tick_us`` and ``slice_us`` return the length of a tick, and the distance of the timer
    interrupts of the plan's scheduling list, in microseconds.
    """

    def __init__(
        self, reader: PlanReader, tick_us: Callable[[], int], slice_us: Callable[[], int]
    ) -> None:
        self._reader = reader
        self._tick_us = tick_us
        self._slice_us = slice_us
        self._entry: dict[str, Any] = {}
        self._number = 0

    def dimensions(self, entries: Any) -> tuple[Dimension, ...]:
        """Return the dimensions of the tables of a plan."""
        tables = self._reader.tables(entries, "vary")
        found = [self._dimension(entry, number) for number, entry in enumerate(tables)]
        dimensions = tuple(dimension for dimension in found if dimension is not None)
        kinds = [dimension.kind for dimension in dimensions]
        if "plc_returns" in kinds and "plc_dies" not in kinds:
            self._reader.missing("plc_dies", "vary", kinds.index("plc_returns"), "vary")
        return dimensions

    def _dimension(self, entry: dict[str, Any], number: int) -> Dimension | None:
        reader, self._entry, self._number = self._reader, entry, number
        kinds = [kind for kind in WORDS if kind in entry]
        if len(kinds) > 1:
            self._wrong(kinds[1], entry[kinds[1]], _beside(kinds[0]))
            return None
        if not kinds:
            every = (*COMMON, *WORDS, *(word for own in WORDS.values() for word in own))
            reader.check_keys(entry, tuple(dict.fromkeys(every)), "vary", number)
            reader.missing(" / ".join(WORDS), f"vary {number + 1}", number, "vary")
            return None
        kind = kinds[0]
        reader.check_keys(entry, (kind, *COMMON, *WORDS[kind]), "vary", number)
        target = self._text(kind, "")
        amount: float | str = self._amount("amount") if kind == "noise" else 0.0
        of = self._text("of", "")
        if kind == "time_of":
            assignment = reader.tried(kind, "vary", number, parse_assignment, target)
            if assignment is None:
                return None
            target, amount = assignment
        if kind == "acknowledge" and not _FUNCTION.fullmatch(target):
            self._wrong(kind, target, _ACKNOWLEDGED)
        if kind == "parameter" and (match := _OF.fullmatch(target.strip())) is not None:
            target, of = match[1], match[2].strip()
        low, high, step = self._span(kind)
        drawn = DistributionReader(
            reader, entry, number, lambda key: self._bound(key, kind in TIME_KINDS)
        )
        distribution, low, high = drawn.distribution(kind, low, high)
        return Dimension(
            self._text("name", _name(kind, target, of)),
            kind,
            target,
            of,
            self._values(kind),
            low,
            high,
            step,
            amount,
            self._amount("rest")
            if kind == "noise" or "over" in entry
            else reader.value(entry, "rest", "vary", number),
            self._begin(),
            self._duration(kind),
            "over" in entry,
            reader.truth(entry, "each_tick", "vary", number),
            self._nominal(kind, distribution),
            kind == "noise" or is_whole(kind, target),
            self._tick_us() if kind in TIME_KINDS else 1,
            distribution,
        )

    # --- entries ---------------------------------------------------------------------------------

    def _text(self, key: str, default: str) -> str:
        text = self._reader.text(self._entry, key, default, "vary", self._number)
        if self._entry.get(key) == text and not is_name(text):
            self._wrong(key, text, NAME)
        return text

    def _amount(self, key: str) -> float:
        return self._reader.number(self._entry, key, "vary", self._number)

    def _wrong(self, key: str, value: object, expected: Text) -> None:
        self._reader.wrong(key, value, expected, "vary", self._number)

    def _begin(self) -> Time | None:
        """Return from which time on; a value that goes back to rest begins with the run."""
        time = self._reader.time(self._entry, "at", "vary", self._number)
        return Time(0) if time is None and "for" in self._entry else time

    def _duration(self, kind: Kind) -> Time | None:
        key = "over" if "over" in self._entry else "for"
        time = self._reader.length(self._entry, key, "vary", self._number)
        if kind == "noise" and "for" not in self._entry:
            self._reader.missing("for", f"vary {self._number + 1}", self._number, "vary")
        is_course = kind == "noise" or key == "over"
        if time is not None and is_course and time.ticks(self._tick_us()) > MAX_COURSE:
            self._wrong(key, self._entry[key], _SHORT)
            return Time(1)
        return time

    def _span(self, kind: Kind) -> tuple[float, float, float]:
        """Return the lowest and the highest value, and the step."""
        entry = self._entry
        is_time = kind in TIME_KINDS
        low, high = (self._bound(key, is_time) for key in ("from", "to"))
        known = len(self._reader.diagnostics)
        step = self._bound("step", is_time)
        is_read = len(self._reader.diagnostics) == known
        if entry.get("each_tick") is True:
            return low, high if "to" in entry else END_OF_RUN, step or self._tick_us()
        if self._reader.truth(entry, "each_phase", "vary", self._number):
            if entry["load_entry"] != "interrupt.phase":
                self._wrong("load_entry", entry["load_entry"], _PHASE)
            return low, high if "to" in entry else self._slice_us() - 1, step or 1
        if entry.get("distribution") in ("normal", "samples"):
            return low, high, step
        has_span = "from" in entry or "to" in entry
        if "values" in entry and has_span:
            self._wrong("values", entry["values"], _EITHER)
        elif not ("values" in entry or has_span) or (has_span and kind in FILE_KINDS):
            self._reader.missing(
                "values / from, to", f"vary {self._number + 1}", self._number, "vary"
            )
        elif has_span and not ("from" in entry and "to" in entry):
            key = "to" if "from" in entry else "from"
            self._reader.missing(key, f"vary {self._number + 1}", self._number, "vary")
        if "step" in entry and is_read and step <= 0:
            self._wrong("step", entry["step"], _STEP)
        return low, high, step

    def _bound(self, key: str, is_time: bool) -> float:
        if is_time:
            return self._microseconds(self._entry.get(key, 0), key)
        return self._amount(key)

    def _nominal(self, kind: Kind, distribution: Distribution | None) -> Value | None:
        """Return the value of the unchanged run; ``None`` if the entry does not give it."""
        if "nominal" not in self._entry and distribution is not None:
            is_rounded = kind in TIME_KINDS or is_whole(kind, self._entry[kind])
            return round(distribution.center) if is_rounded else distribution.center
        if "nominal" not in self._entry:
            return None
        return self._value(kind, self._entry["nominal"], "nominal")

    def _values(self, kind: Kind) -> tuple[Value, ...]:
        values = self._entry.get("values", [])
        if not isinstance(values, list | tuple):
            self._wrong("values", values, LIST)
            return ()
        return tuple(self._value(kind, value, "values") for value in values)

    def _value(self, kind: Kind, value: Any, key: str) -> Value:
        """Return a value of a dimension as stored; 0 after a mistake."""
        if kind == "acknowledge" and isinstance(value, str) and not value[:1].isdigit():
            if value not in (NEVER, TWICE):
                self._wrong(key, value, _ANSWER)
            return value
        if kind in TIME_KINDS:
            return self._microseconds(value, key)
        if kind in FILE_KINDS:
            path = self._reader.existing(value, key, "vary", self._number)
            return "" if path is None else str(path)
        if kind == "noise" and not (is_number(value) and value == int(value)):
            self._wrong(key, value, WHOLE)
            return 0
        if isinstance(value, bool):
            return int(value)
        if not is_value(value) or ("over" in self._entry and isinstance(value, str)):
            self._wrong(key, value, NUMBER if "over" in self._entry else NUMBER_OR_TEXT)
            return 0
        found: Value = value
        return found

    def _microseconds(self, value: Any, key: str) -> int:
        """Return a time in microseconds; ticks are those of the machine."""
        time = self._reader.tried(key, "vary", self._number, read_time, value)
        if time is None:
            return 0
        return time.us(self._tick_us()) if time.is_in_ticks else time.us(1)


def _beside(kind: Kind) -> Text:
    return Text(f"left out beside {kind}", f"neben {kind} weggelassen")


def _name(kind: Kind, target: str, of: str) -> str:
    """Return the name of a dimension that the plan does not name."""
    if kind in ("plc_dies", "plc_returns"):
        return kind
    return f"{target} of {of}" if of else target


def is_whole(kind: Kind, target: str) -> bool:
    """Return whether a parameter of a list, or an entry of a load, takes whole numbers only."""
    if kind == "load_entry":
        return target.rpartition(".")[2] in ("seed", "priority", "cpu", "cpus")
    return kind == "parameter" and any(
        parameter.id == target and parameter.type.value.startswith(("UNS", "SGN", "BOOL"))
        for schema in SCHEMAS
        for parameter in schema.parameters
    )
