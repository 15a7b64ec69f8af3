# SPDX-License-Identifier: MIT
"""``#CONTOUR MODE``, ``#HSC``, ``#SLOPE``, ``#VECTOR LIMIT``, ``#TURN``, ``#OVERRIDE`` …

In: checked commands. Out: changes of the modal state, and limits for the segments that come.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Generator, Iterable, Iterator, Sequence

from nctakt.base.diagnostics import Span
from nctakt.base.whole_numbers import is_whole
from nctakt.decoder.axis_limits import set_limits
from nctakt.decoder.blocks.block_decoder import BlockDecoder
from nctakt.decoder.blocks.frames.frame_commands import FrameCommands
from nctakt.decoder.state.path_limits import bend_of
from nctakt.decoder.state.queued.commands import Answer, Command
from nctakt.decoder.values.variables import Values
from nctakt.kernel import rows
from nctakt.messages.path.hsc import HSC_MODE_WHILE_ON, INVALID_HSC_VALUE
from nctakt.messages.path.motion import (
    CONTOUR_MODE_WHILE_ON,
    CONTOUR_SHARE_OUT_OF_RANGE,
    INVALID_CONTOUR_DEVIATION,
    INVALID_VECTOR_LIMIT,
    UNKNOWN_SLOPE,
)
from nctakt.nc import tree
from nctakt.nc.meaning.path import command_name, is_hsc_value, is_size, keywords
from nctakt.nc.vocabulary.path_keywords import (
    ACTIONS,
    CONTOUR_MODES,
    CONTOUR_SHARES,
    HSC_CURVES,
    HSC_MODES,
    SLOPES,
    VECTOR_BLOCKS,
    VECTOR_LIMITS,
)

#: Columns of the limits of ``#VECTOR LIMIT``; DEC shares that of ACC, TRANS_ACC has no effect.
_COLUMNS = {
    "VEL": rows.VECTOR_SPEED,
    "ACC": rows.VECTOR_ACCELERATION,
    "DEC": rows.VECTOR_ACCELERATION,
    "JERK": rows.VECTOR_JERK,
    "RADIAL_ACC": rows.RADIAL_ACCELERATION,
    "RADIAL_JERK": rows.RADIAL_JERK,
}
_SIZES = frozenset(name for names in CONTOUR_MODES.values() for name in names)


class PathSettings:
    """Decodes the settings of the path of one program."""

    def __init__(self, values: Values, blocks: BlockDecoder) -> None:
        self._values = values
        self._frame = FrameCommands(values)
        self._feed_rate = blocks.path.feed_rate
        self._threads = blocks.path.threads
        self._ramps = blocks.ramps
        self._weighting = blocks.weighting
        self._targets = blocks.targets
        self._environment = values.environment
        self._state = values.state
        self._decoders = self._table()

    def command(self, command: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Execute one of these commands."""
        yield from self._decoders[command.words[0].name](command, number)

    def _table(self) -> dict[str, Callable[[tree.HashCommand, int], Iterable[Command]]]:
        """Return the functions that decode commands, by their first words."""
        return {
            "CONTOUR": self._contour_mode,
            "CORNER": self._ramps.corner,
            "DYNAMIC": self._weighting.switch,
            "HSC": self._hsc,
            "OVERRIDE": self._override,
            "ROTATION": self._frame.rotation,
            "SCALE": self._end_scaling,
            "SET": self._old_slope,
            "SLOPE": self._slope,
            "TURN": self._turn,
            "VECTOR": self._vector_limit,
        }

    def _override(self, command: tree.HashCommand, number: int) -> Iterable[Command]:
        return self._feed_rate.override(keywords(command), number)

    def _end_scaling(self, command: tree.HashCommand, _number: int) -> Iterable[Command]:
        self._frame.end_scaling(command)
        return ()

    def _turn(self, command: tree.HashCommand, number: int) -> Iterable[Command]:
        return self._threads.settings(keywords(command), number)

    # --- contouring -----------------------------------------------------------------------------

    def _contour_mode(self, command: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Execute ``#CONTOUR MODE``."""
        path, limits = self._state.path, self._state.limits
        before = limits.rounded_part
        point: dict[int, float] = {}
        for keyword in keywords(command):
            if keyword.name in CONTOUR_MODES:
                self._change_mode(keyword)
            if keyword.name in ACTIONS:
                path.contour.action = keyword.name
            if keyword.value is None:
                continue
            value = yield from self._values.evaluate(keyword.value, number)
            if keyword.name in self._environment.axis_numbers:
                point[self._environment.axis_numbers[keyword.name]] = value
                continue
            if keyword.name in _SIZES:
                if not is_size(keyword.name, value, path.contour.mode):
                    self._values.fail(INVALID_CONTOUR_DEVIATION, keyword.value.span, value=value)
                path.contour.sizes[keyword.name] = value * self._state.length_unit_mm
                continue
            highest = CONTOUR_SHARES.get(keyword.name, math.inf)
            if keyword.name in CONTOUR_SHARES and not 0.0 <= value <= highest:
                self._values.fail(
                    CONTOUR_SHARE_OUT_OF_RANGE,
                    keyword.value.span,
                    word=keyword.name,
                    value=value,
                    highest=highest,
                )
            if keyword.name == "REMAIN_PART":
                limits.rounded_part = 0.5 - 0.005 * value
            elif keyword.name == "MAX_ANGLE":
                path.contour.max_bend = bend_of(value)
        if point:
            path.contour.point = self._targets.positions_of(point)
        yield from self._limit_bends(command.span, number, limits.rounded_part != before)
        switch = command.words[-1].name
        if switch in ("ON", "OFF"):
            path.contouring = switch == "ON"

    def _change_mode(self, keyword: tree.Keyword) -> None:
        """Change the mode of ``#CONTOUR MODE``, to DIST_SOFT and from it only without G261."""
        path, mode = self._state.path, keyword.name
        before = path.contour.mode
        if path.contouring and before != mode and "DIST_SOFT" in (before, mode):
            self._values.fail(CONTOUR_MODE_WHILE_ON, keyword.span, mode=mode, before=before)
        path.contour.mode = mode

    def _hsc(self, command: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Execute ``#HSC``."""
        hsc = self._state.path.hsc
        items = keywords(command)
        curve = _hsc_curve(items, hsc.curve)
        if hsc.is_on and curve != hsc.curve:
            self._values.fail(HSC_MODE_WHILE_ON, command.span)
        hsc.curve = curve
        for item in items:
            if item.value is None:
                continue
            value = yield from self._values.evaluate(item.value, number)
            if not is_hsc_value(item.name, value):
                self._values.fail(INVALID_HSC_VALUE, item.value.span, word=item.name, value=value)
            if item.name == "OPMODE":
                if hsc.is_on and value != hsc.mode:
                    self._values.fail(HSC_MODE_WHILE_ON, item.span)
                hsc.mode = int(value)
            elif item.name == "PATH_DEV":
                hsc.deviation_mm = value * self._state.length_unit_mm
            elif item.name == "MAX_ANGLE":
                hsc.max_angle_deg = value
            elif item.name == "CONTERROR":
                hsc.error_mm = value * self._state.length_unit_mm
        switch = command.words[-1].name
        if switch in ("ON", "OFF"):
            hsc.is_on = switch == "ON"
        listed = self._environment.parameters.hsc_deviation_mm
        self._state.path.hsc_deviation = hsc.deviation(listed) if hsc.is_on else 0.0
        yield from self._limit_bends(command.span, number)

    def _limit_bends(self, span: Span, number: int, has_changed: bool = False) -> Iterator[Command]:
        """Let ``#HSC``, else ``#CONTOUR MODE``, decide which corners are too sharp to round."""
        path, limits = self._state.path, self._state.limits
        max_bend = path.contour.max_bend
        if path.hsc.is_on:
            max_bend = path.hsc.max_bend(self._environment.parameters.hsc_angle_deg)
        if has_changed or max_bend != limits.max_bend:
            limits.max_bend = max_bend
            yield self._limits(span, number)

    # --- slope ----------------------------------------------------------------------------------

    def _slope(self, command: tree.HashCommand, _number: int) -> Iterable[Command]:
        """Execute ``#SLOPE``."""
        self._select_slope(self._named_slope(keywords(command)))
        return ()

    def _select_slope(self, kind: int) -> None:
        """Select a slope by its number; all but STEP limit the jerk."""
        self._state.path.limits_jerk = kind > 0

    def _named_slope(self, items: Sequence[tree.Keyword]) -> int:
        """Return the number of the slope that ``#SLOPE`` names, else that of the program start."""
        for keyword in items:
            if keyword.name == "TYPE":
                assert isinstance(keyword.value, tree.Name)
                return SLOPES.index(keyword.value.name)
        return self._environment.parameters.program_start.slope_profile

    def _old_slope(self, command: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Execute ``#SET SLOPE PROFIL``; without a number the slope of the program start."""
        kind = float(self._named_slope(()))
        for argument in command.arguments:
            assert isinstance(argument, tree.Bracket)
            first = argument.items[0]
            assert not isinstance(first, tree.Keyword)
            kind = yield from self._values.evaluate(first, number)
            if not is_whole(kind, 0, len(SLOPES) - 1):
                self._values.fail(UNKNOWN_SLOPE, first.span, value=kind, highest=len(SLOPES) - 1)
        self._select_slope(int(kind))

    # --- limits of the path ---------------------------------------------------------------------

    def _vector_limit(self, command: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Execute ``#VECTOR LIMIT ON`` or ``OFF``."""
        items = keywords(command)
        switches_on = command_name(command).startswith("VECTOR LIMIT ON")
        blocks = [item.name for item in items if item.name in VECTOR_BLOCKS] or VECTOR_BLOCKS
        named: dict[str, tree.Keyword | None] = {
            item.name: item for item in items if item.name in VECTOR_LIMITS
        }
        if not named:
            named = dict.fromkeys(self._environment.parameters.path_limits)
            if not switches_on:
                named = dict.fromkeys(VECTOR_LIMITS)
        limits = self._state.limits
        for name, keyword in named.items():
            value = 0.0
            if switches_on:
                value = yield from self._limit(name, keyword, command.span, number)
            for block in blocks:
                limits.vector[block][name] = value
        for block, columns in (("FEED", limits.feed), ("RAPID", limits.rapid)):
            columns[:] = [0.0] * rows.VECTOR_WIDTH
            for name, column in _COLUMNS.items():
                value = limits.vector[block].get(name, 0.0)
                if value > 0.0:
                    columns[column] = min(value, columns[column] or value)
        yield self._limits(command.span, number)

    def _limit(
        self, name: str, keyword: tree.Keyword | None, span: Span, number: int
    ) -> Generator[Command, Answer, float]:
        """Return a limit in mm/s, mm/s² or mm/s³; without a value that of the channel list."""
        parameters = self._environment.parameters
        if keyword is None or keyword.value is None:
            value = parameters.path_limits.get(name, 0.0)
        else:
            span = keyword.value.span
            value = yield from self._values.evaluate(keyword.value, number)
            if value <= 0.0:
                self._values.fail(INVALID_VECTOR_LIMIT, span, word=name, value=value)
        if name == "VEL":
            return value / 60.0
        if parameters.path_limits_per_s:
            return value
        return value / (60.0**3 if name.endswith("JERK") else 60.0**2)

    def _limits(self, span: Span, number: int) -> Command:
        """Return the command with all limits that the program has set."""
        source = self._environment.source_id(span)
        return set_limits(self._environment.axes, self._state.limits, source, number)


def _hsc_curve(items: Sequence[tree.Keyword], before: str) -> str:
    """Return the curve of ``#HSC`` that these keywords mean; ``""``: that of OPMODE."""
    named = {item.name for item in items}
    for curve in HSC_CURVES:
        if curve in named:
            return curve
    if named & set(HSC_MODES):
        return ""
    return (before or HSC_CURVES[0]) if named else before
