# SPDX-License-Identifier: MIT
"""The words of a block -> commands: G, F, axis words, M and H functions.

Order within a block: modal G functions and F take effect, then functions that come before the
motion, the motion, functions that come after it, the program's end.
"""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import dataclass, field

from nctakt.decoder.commands import Answer, Command, Dwell
from nctakt.decoder.preparation import prepare
from nctakt.decoder.technology import Issued, TechnologyOutputs, process_ticks
from nctakt.decoder.values import Values
from nctakt.diagnostics import Span
from nctakt.kernel import arithmetic
from nctakt.lists.technology import TechnologyFunction
from nctakt.nc import syntax

#: The G function whose X, or whose own value, is a time.
DWELL = 4

#: M functions that end the main program.
PROGRAM_ENDS = (2, 30)


@dataclass(slots=True)
class _Content:
    """A block's words sorted by what they do."""

    axes: list[tuple[syntax.AxisWord, float]] = field(default_factory=list)
    functions: list[Issued] = field(default_factory=list)
    dwell_s: float | None = None
    ends_program: bool = False


class Words:
    """Decodes the blocks of one program."""

    def __init__(self, values: Values) -> None:
        self._values = values
        self._surroundings = values.surroundings
        self._state = values.state
        self.technology = TechnologyOutputs()

    def block(self, block: syntax.Block, number: int) -> Generator[Command, Answer, bool]:
        """The commands of a block; true when it ends the program."""
        content = yield from self._sort(block, number)
        source = self._surroundings.place(block.span)
        yield from self.technology.before(content.functions, number)
        yield from self._motion(content, source, number)
        if content.dwell_s is not None:
            yield from self.dwell(content.dwell_s, block.span, number)
        yield from self.technology.behind(content.functions, number)
        return content.ends_program

    def _sort(self, block: syntax.Block, number: int) -> Generator[Command, Answer, _Content]:
        """Evaluate the words; G and F act at once, in whatever order they stand."""
        content = _Content()
        numbers = [
            round(word.value.value)
            for word in block.words
            if isinstance(word, syntax.Word)
            and word.name == "G"
            and isinstance(word.value, syntax.Number)
        ]
        for function in numbers:
            self._modal(function)
        for word in block.words:
            if isinstance(word, syntax.AxisWord):
                if word.value is not None:
                    value = yield from self._values.evaluate(word.value, number)
                    content.axes.append((word, value))
                continue
            assert isinstance(word, syntax.Word), word
            if word.name == "G":
                if word.additional is not None:
                    content.dwell_s = yield from self._values.evaluate(word.additional, number)
                continue
            assert word.value is not None, word
            value = yield from self._values.evaluate(word.value, number)
            self._word(word, value, content)
        if DWELL in numbers and content.axes:
            content.dwell_s = content.axes.pop()[1]
        return content

    def _modal(self, function: int) -> None:
        state = self._state
        if function in (0, 1):
            state.rapid = function == 0
        elif function in (70, 71):
            state.inch = function == 70
        elif function in (90, 91):
            state.absolute = function == 90

    def _word(self, word: syntax.Word, value: float, content: _Content) -> None:
        if word.name == "F":
            self._state.feed_mm_s = self._feed(value)
            return
        number = int(arithmetic.round_half_even(value))
        if word.name == "M" and number in PROGRAM_ENDS:
            content.ends_program = True
            return
        parameters = self._surroundings.parameters
        table = parameters.m_functions if word.name == "M" else parameters.h_functions
        if number in table:
            content.functions.append(self._issued(word, number, table[number]))

    def _issued(self, word: syntax.Word, number: int, function: TechnologyFunction) -> Issued:
        return Issued(
            self._surroundings.place(word.span),
            number if word.name == "M" else -number - 1,
            function.synchronisation,
            process_ticks(function, self._surroundings.cycle_time_us),
        )

    def _feed(self, value: float) -> float:
        """F in mm/s; in inch per minute under G70, whatever P-CHAN-00108 says."""
        if self._state.inch:
            return value * self._state.length_unit_mm / 60.0
        return value * self._surroundings.parameters.program_start.feed_unit_mm_min / 60.0

    def _motion(self, content: _Content, source: int, number: int) -> Generator[Command, Answer]:
        """The path to the programmed position."""
        if not content.axes:
            return
        start = self._state.positions
        target = list(start)
        for word, value in content.axes:
            self._set_target(target, word, value)
        feed = None if self._state.rapid else self._state.feed_mm_s
        segment = prepare(source, number, start, target, self._surroundings.limits, feed)
        self._state.positions = target
        if segment is None:
            return
        if feed is not None and feed <= 0.0:
            self._values.fail(20008, content.axes[0][0].span)
        if feed is not None:
            yield from self.technology.before_feed(number)
        yield segment

    def _set_target(self, target: list[float], word: syntax.AxisWord, value: float) -> None:
        index = self._surroundings.axis_numbers[word.name]
        axis = self._surroundings.axes[index]
        if axis.is_linear:
            value *= self._state.length_unit_mm
        position = value if self._state.absolute else target[index] + value
        low, high = axis.software_limit_low, axis.software_limit_high
        if not axis.is_modulo and not low <= position <= high:
            self._values.fail(
                900306, word.span, axis=word.name, position=position, low=low, high=high
            )
        target[index] = position

    def dwell(self, seconds: float, span: Span, number: int) -> Generator[Command, Answer]:
        """Standing still; ``ceil(d / T)`` ticks (RC-005)."""
        if seconds < 0.0:
            self._values.fail(900305, span, seconds=seconds)
        ticks = seconds * 1e6 / self._surroundings.cycle_time_us
        count = int(arithmetic.ceiling(ticks - 1e-6))
        if count > 0:
            yield Dwell(self._surroundings.place(span), number, count)
