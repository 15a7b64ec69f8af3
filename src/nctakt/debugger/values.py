# SPDX-License-Identifier: MIT
"""Values of expressions and variables at the tick of a session, as a debugger shows them.

In: names and expressions of the controller's language, of a channel. Out: texts; ``Failure`` for
unknown names. Those of the decoder (V.P, V.L, V.S, V.CYC, P1 …) are those known to it at this tick,
ahead of the path.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping, Sequence

from nctakt.base.diagnostics import Text
from nctakt.base.failure import Failure
from nctakt.debugger.names import pieces_of
from nctakt.hli.checked_values import number_of
from nctakt.lists.declared.variables import SCALARS
from nctakt.messages import diagnostic
from nctakt.messages.connections.debugger import DECODER_VARIABLE, NO_VALUE, UNREADABLE_VALUE_TEXT
from nctakt.results.trace.events import value_text
from nctakt.session.decoders import DecoderState, DecoderVariable
from nctakt.session.session import Session
from nctakt.session.setup import Inventory

#: Where the debugger's inputs come from, on the tape.
DEBUGGER = "debugger"

Value = float | bool | str

_NOT_IN_THE_DECODER = Text(
    "the decoder, which is ahead of the path, does not know this name",
    "der Dekoder, der der Bahn voraus ist, kennt diesen Namen nicht",
)

_DECODER = re.compile(r"(?:V\.(?:P|L|S|CYC)\.|@?P\d+$)", re.IGNORECASE)
_PARAMETER = re.compile(r"(?P<argument>@?)P(?P<number>\d{1,9})", re.IGNORECASE)
_TEXT = re.compile(r'"(?P<text>[^"]*)"')


def shown_value(value: Value | None) -> str:
    """Return a value in the controller's language; ``None``: no such value now."""
    if value is None:
        return "–"
    if isinstance(value, bool):
        return "TRUE" if value else "FALSE"
    if isinstance(value, float) and math.isnan(value):
        return "–"
    return value_text(value)


def read_value(text: str) -> Value:
    """Return the value of a text: a number, TRUE, FALSE, a text in quotes (901239)."""
    text = text.strip()
    quoted = _TEXT.fullmatch(text)
    if quoted is not None:
        return quoted["text"]
    if text.upper() in ("TRUE", "FALSE"):
        return text.upper() == "TRUE"
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise Failure(diagnostic(UNREADABLE_VALUE_TEXT, text=text))
    return number


class Values:
    """The values of a session; ``inventory``: names available to its programs."""

    def __init__(self, session: Session, inventory: Inventory) -> None:
        self._session = session
        self.inventory = inventory
        self._pending: dict[str, tuple[int, Value]] = {}

    def prefixed(self, name: str, channel: int) -> str:
        """Return a name with its channel, unless that is the first one."""
        return name if channel == 1 else f"CH{channel}.{name}"

    def read(self, names: Sequence[str], channel: int) -> list[Value]:
        """Return the values of signals and variables by their full names."""
        if not names:
            return []
        return self._session.read(*(self.prefixed(name, channel) for name in names))

    def note_of(self, name: str, channel: int) -> str:
        """Return the note after a value: its value in the next tick."""
        tick, value = self._pending.get(self.prefixed(name, channel), (-1, 0.0))
        return f" → {shown_value(value)}" if tick == self._session.tick else ""

    def write(self, name: str, text: str, channel: int) -> Value:
        """Let a variable or a value of the HLI have another value from the next tick on."""
        if _DECODER.match(name):
            raise Failure(diagnostic(DECODER_VARIABLE, name=name))
        value = self._stored(name, read_value(text), channel)
        self.write_value(self.prefixed(name, channel), value, DEBUGGER)
        return value

    def _stored(self, name: str, value: Value, channel: int) -> Value:
        """Return a value as the type of a variable makes it: 3.5 is 4 in a whole number."""
        type_ = self.inventory.variables.get(channel, {}).get(name, "")
        if isinstance(value, str) or type_ not in SCALARS:
            return value
        return number_of(name, type_, float(value))

    def write_value(self, name: str, value: Value, source: str) -> None:
        """Let a variable by its full name have a value from the next tick on."""
        self._session.write({name: value}, source=source)
        self._pending[name] = self._session.tick, value

    def evaluate(self, text: str, channel: int) -> str:
        """Return the value of a name or an expression of the controller's language.

        Raises ``Failure`` for mistakes in it, and where it has none now (901926).
        """
        text = text.strip()
        if _DECODER.match(text):
            value = self._of_decoder(text, channel)
            if value is None:
                raise Failure(diagnostic(NO_VALUE, text=text, reason=_NOT_IN_THE_DECODER))
            return shown_value(value)
        known = self.inventory.variables.get(channel, {})
        if text in known or text in self._session.description.signals:
            (value,) = self.read([text], channel)
            return shown_value(value) + self.note_of(text, channel)
        number = self._session.evaluate(text, channel)
        if math.isnan(number):
            reason = self._session.undefined(text, channel)
            if reason is not None:
                raise Failure(diagnostic(NO_VALUE, text=text, reason=reason))
        return shown_value(number)

    def _of_decoder(self, name: str, channel: int) -> Value | None:
        for decoder in self._session.decoders():
            if decoder.channel == channel:
                return value_in(decoder, name)
        return None


def value_in(decoder: DecoderState, name: str) -> Value | None:
    """Return a value that a decoder knows, ``None`` for one that it does not."""
    parameter = _PARAMETER.fullmatch(name)
    if parameter is not None:
        number = int(parameter["number"])
        return _argument(decoder, number) if parameter["argument"] else _number(decoder, number)
    groups: Iterable[Sequence[DecoderVariable]] = (
        *(frame.variables for frame in decoder.frames[::-1]),
        decoder.program,
        decoder.kept,
        decoder.cycle,
    )
    asked = name.upper()
    for variable in (variable for group in groups for variable in group):
        own = variable.name.upper()
        if asked == own and not variable.dimensions:
            return variable.values[0]
        if asked.startswith(f"{own}["):
            return _element(variable, pieces_of(asked[len(own) :]))
    return None


def _number(decoder: DecoderState, number: int) -> Value | None:
    return decoder.parameters.get(number)


def _argument(decoder: DecoderState, number: int) -> Value | None:
    arguments: Mapping[int, Value] = {}
    for frame in decoder.frames:
        arguments = frame.arguments or arguments
    return arguments.get(number)


def _element(variable: DecoderVariable, indices: Sequence[str]) -> Value | None:
    """Return an element of an array, ``None`` outside and where it is not shown."""
    if len(indices) != len(variable.dimensions):
        return None
    position = 0
    for index, count in zip(indices, variable.dimensions, strict=True):
        number = index.strip("[] ")
        if not number.isdecimal() or int(number) >= count:
            return None
        position = position * count + int(number)
    return variable.values[position] if position < len(variable.values) else None


def elements_of(variable: DecoderVariable) -> list[tuple[str, Value]]:
    """Return the elements of an array that are shown, each with its indices."""
    found: list[tuple[str, Value]] = []
    for position, value in enumerate(variable.values):
        indices: list[str] = []
        rest = position
        for count in reversed(variable.dimensions):
            rest, index = divmod(rest, count)
            indices.append(f"[{index}]")
        found.append(("".join(reversed(indices)), value))
    return found
