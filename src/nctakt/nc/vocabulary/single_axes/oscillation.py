# SPDX-License-Identifier: MIT
"""Commands of programs for oscillating axes: ``X[OSC ON …]``, ``X[OSC OFF …]`` (SA-11 … SA-17).

In: the bracket of the tree. Out: an ``OscillationCommand``, and every mistake that can be found
without values. Checker and decoder read these commands through this module only.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import inf
from types import MappingProxyType

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span, Text
from nctakt.messages.axes.independent_axes import (
    AXIS_VALUE_INVALID,
    OSCILLATION_COUNT,
    OSCILLATION_SYNTAX,
    OSCILLATION_WITHOUT_SPEED,
    OSCILLATION_WITHOUT_STROKE,
)
from nctakt.nc.tree import BracketCommand, Expression, Number
from nctakt.nc.vocabulary.single_axes.axis_brackets import BracketReader
from nctakt.nc.vocabulary.single_axes.axis_commands import Finding

FLAGS = ("ON", "OFF", "INSTANT", "INCL_OFFSETS", "SHORT")
_SPEEDS = ("FEED", "FREQ", "TIME")
_REVERSALS, _CENTRE = ("1ST_POS", "2ND_POS"), ("ZERO_POS", "EXCUR")
_PAUSES = ("1ST_DELT", "2ND_DELT")
_COUNT = "NBR_OSC"
VALUES = (*_REVERSALS, *_CENTRE, *_PAUSES, *_SPEEDS, _COUNT)
#: The highest number of oscillations.
MAX_COUNT = 2**31 - 1

#: Reasons of message 902580.
_REASONS = MappingProxyType(
    {
        "switch": Text("either ON or OFF", "entweder ON oder OFF"),
        "positions": Text(
            "either 1ST_POS and 2ND_POS, or ZERO_POS and EXCUR",
            "entweder 1ST_POS und 2ND_POS oder ZERO_POS und EXCUR",
        ),
        "speeds": Text("only one of FEED, FREQ and TIME", "nur eines von FEED, FREQ und TIME"),
        "instant": Text(
            "INSTANT is a keyword of OSC OFF", "INSTANT ist ein Schlüsselwort von OSC OFF"
        ),
        "off": Text(
            "OSC OFF takes FEED or INSTANT, nothing else",
            "OSC OFF erwartet FEED oder INSTANT, sonst nichts",
        ),
    }
)


@dataclass(frozen=True, slots=True)
class OscillationCommand:
    """The content of a command: its values by keyword, and its keywords without a value."""

    axis: str
    span: Span
    values: Mapping[str, Expression]
    flags: frozenset[str]

    @property
    def is_on(self) -> bool:
        """Whether the axis begins to oscillate."""
        return "ON" in self.flags


def read_oscillation(command: BracketCommand) -> tuple[OscillationCommand, list[Finding]]:
    """Return the command and its mistakes."""
    reader = _Reader(command)
    reader.read()
    values = {name: reader.value(name) for name in VALUES}
    flags = frozenset(name for name in FLAGS if name in reader.keywords)
    parsed = {name: value for name, value in values.items() if value is not None}
    return OscillationCommand(command.name, command.span, parsed, flags), reader.findings


class _Reader(BracketReader):
    """Reads the keywords of one command."""

    syntax = OSCILLATION_SYNTAX
    flags = FLAGS
    values = VALUES

    def read(self) -> bool:
        """Note the keywords and their mistakes."""
        if not super().read():
            return False
        has = self.keywords.__contains__
        if has("ON") == has("OFF"):
            self.wrong(_REASONS["switch"])
        elif has("OFF"):
            self._check_end()
        else:
            self._check_begin()
        for name in self.keywords:
            value = self.value(name)
            if isinstance(value, Number):
                self._check_number(name, value)
        return not self.findings

    def _check_end(self) -> None:
        others = [name for name in self.keywords if name not in ("OFF", "FEED", "INSTANT")]
        if others or len(self.keywords) > 2:
            self.wrong(_REASONS["off"])

    def _check_begin(self) -> None:
        has = self.keywords.__contains__
        reversals, centre = [all(map(has, pair)) for pair in (_REVERSALS, _CENTRE)]
        words = sum(map(has, (*_REVERSALS, *_CENTRE)))
        if words != 2 or not (reversals or centre):
            self.wrong(_REASONS["positions"])
        speeds = sum(map(has, _SPEEDS))
        if speeds > 1:
            self.wrong(_REASONS["speeds"])
        if not speeds:
            self.find(OSCILLATION_WITHOUT_SPEED, self.bracket.span, axis=self.bracket.name)
        if has("INSTANT"):
            self.wrong(_REASONS["instant"])
        first, second = map(self.value, _REVERSALS)
        if not isinstance(first, Number) or not isinstance(second, Number):
            return
        if first.value == second.value:
            values = {"axis": self.bracket.name, "position": first.value}
            self.find(OSCILLATION_WITHOUT_STROKE, self.bracket.span, **values)

    def _check_number(self, name: str, number: Number) -> None:
        value, axis = number.value, self.bracket.name
        if name == _COUNT and not is_count(value):
            self.find(OSCILLATION_COUNT, number.span, axis=axis, value=value, highest=MAX_COUNT)
        elif name == "FEED" and value <= 0.0:
            self.find(OSCILLATION_WITHOUT_SPEED, number.span, axis=axis)
        elif not is_valid(name, value):
            self.find(AXIS_VALUE_INVALID, number.span, word=name, value=value, **self.named)


def is_count(value: float) -> bool:
    """Return whether NBR_OSC may have a value: a whole number from 1 on."""
    return 1.0 <= value <= MAX_COUNT and value == int(value)


def is_valid(name: str, value: float) -> bool:
    """Return whether a keyword may have a value: speeds and EXCUR above 0, waiting times not
    below.
    """
    if name in (*_SPEEDS, "EXCUR"):
        return 0.0 < value < inf
    return name not in _PAUSES or 0.0 <= value < inf
