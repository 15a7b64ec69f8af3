# SPDX-License-Identifier: MIT
"""The channel and the program that a page shows: which signals are drawn and read."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.live import view
from nctakt.live.conditions import conditions_of
from nctakt.live.view import VariableRow
from nctakt.session.setup import Description

#: Paths of other channels that are drawn.
_MAX_OTHERS = 7


@dataclass(frozen=True, slots=True)
class OtherPath:
    """Signals of a channel other than the one shown: X, Y, Z, ``None`` without such an axis."""

    channel: int
    axes: tuple[str | None, ...]
    rapid: str


class ShownChannel:
    """A channel with one of its programs, as long as nothing else is shown.

    ``number``: the channel's; ``prefix``: that of its signals; ``path``: the present positions of
    its first three axes; ``tip``: the positions of the tool's tip and the tool's direction, empty
    where no transformation can be; ``others``: paths of further channels, drawn along with it.
    ``drawn``: all signals of these. ``file``: the program's, with its ``lines``.
    """

    def __init__(
        self, description: Description, number: int, file: str, *, is_transformed: bool
    ) -> None:
        self._units = description.signals
        self.number, self.file = number, file
        self.lines: Sequence[str] = list(description.texts.get(file, ()))
        self.conditions = tuple(conditions_of(self.lines))
        self.prefix = _prefix_of(number)
        self.axes = view.axes_of(self._units, self.prefix)
        first = self.axes[:3]
        self.path = tuple(f"{self.prefix}{axis}.ACS.ACT_POS" for axis in first)
        self.tip: tuple[str, ...] = ()
        if is_transformed and len(first) == 3:
            tip = (f"{self.prefix}{axis}.MCS.ACT_POS" for axis in first)
            self.tip = (*tip, *(f"{self.prefix}TOOL.DIRECTION.{letter}" for letter in "XYZ"))
        numbers = range(1, description.channel_count + 1)
        self.others = _paths_of((one for one in numbers if one != number), self._units)
        others = (name for one in self.others for name in (*one.axes, one.rapid) if name)
        self.drawn = (*self.path, *self.tip, f"{self.prefix}PATH.RAPID", *others)
        self._rows: tuple[object, list[VariableRow]] | None = None

    def first_signals(self, logged: Iterable[str]) -> list[str]:
        """Return what the scope shows at first: signals of a log, then those of the program."""
        found = view.first_signals(self._units, self.lines, self.prefix)
        return list(dict.fromkeys((*logged, *found)))[: view.MAX_SIGNALS]

    def read_signals(self, shown: Iterable[str]) -> list[str]:
        """Return the signals that are read at each look, among them those that are shown."""
        prefix = self.prefix
        own = [prefix + name for name in view.PANEL if prefix + name in self._units]
        for axis in self.axes:
            own += [f"{prefix}{axis}.ACS.ACT_POS", f"{prefix}{axis}.PCS.DIST_TO_GO"]
        return list(dict.fromkeys([*own, *shown, *view.variables_read(self._units, prefix)]))

    def variable_rows(self, types: Sequence[tuple[str, str]]) -> list[VariableRow]:
        """Return the V.E variables, those of the program first: read once for all browsers."""
        known = self._rows
        if known is None or known[0] is not types:
            self._rows = known = types, view.variable_rows(types, self.lines)
        return known[1]


def _prefix_of(number: int) -> str:
    """Return the prefix of a channel's signals."""
    return "" if number == 1 else f"CH{number}."


def _paths_of(numbers: Iterable[int], units: Mapping[str, str]) -> tuple[OtherPath, ...]:
    """Return the paths of channels whose axes can be drawn, of the first of them."""
    found: list[OtherPath] = []
    for number in numbers:
        prefix = _prefix_of(number)
        placed = view.placed_axes(view.axes_of(units, prefix))
        if any(placed):
            axes = tuple(axis and f"{prefix}{axis}.ACS.ACT_POS" for axis in placed)
            found.append(OtherPath(number, axes, f"{prefix}PATH.RAPID"))
    return tuple(found[:_MAX_OTHERS])
