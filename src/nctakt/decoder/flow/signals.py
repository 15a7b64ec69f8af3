# SPDX-License-Identifier: MIT
"""``#SIGNAL`` and ``#WAIT`` of the main program.

In: checked nodes. Out: commands with SYN; without it the signals are sent and awaited by the
decoder itself.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence

from nctakt.base.diagnostics import Span
from nctakt.base.whole_numbers import is_whole
from nctakt.decoder.state.queued.commands import (
    Answer,
    AwaitSignal,
    Command,
    DecoderSignal,
    NextTick,
    RemoveSignals,
    SendSignal,
)
from nctakt.decoder.values.variables import Values
from nctakt.kernel import codes
from nctakt.kernel.base import arithmetic
from nctakt.messages.programs.signals import (
    EMPTY_SIGNAL_RANGE,
    INVALID_SIGNAL_CHANNEL,
    INVALID_SIGNAL_COUNT,
    INVALID_SIGNAL_NUMBER,
    INVALID_SIGNAL_VALUE,
    SIGNAL_CHANNEL_MISSING,
    SIGNAL_OUT_OF_ORDER,
    SIGNAL_VALUE_NOT_SENT,
    TOO_MANY_SIGNALS,
)
from nctakt.nc import tree
from nctakt.nc.meaning.signals import (
    MAX_CHANNEL,
    MAX_SIGNAL,
    SIGNAL_VALUES,
    SignalCommand,
    axis_name,
    signal_command,
)

#: A number of a signal's value and the variable that takes it.
_Targets = list[tuple[int, tree.Variable | tree.Parameter]]

Decoded = Generator[Command, Answer]


class Signals:
    """Decodes these commands for one program.

    ``request``: requests positions when the path and the axes of these names are at rest.
    """

    def __init__(
        self,
        values: Values,
        request: Callable[[Sequence[str], Span, int], Decoded],
    ) -> None:
        self._values = values
        self._environment = values.environment
        self._signals = values.environment.signals
        self._request = request

    def command(self, command: tree.HashCommand, number: int) -> Decoded:
        """Execute ``#SIGNAL [READ|REMOVE]``, ``#WAIT``, ``#WAIT FOR``, ``#WAIT INDP``."""
        words = [word.name for word in command.words]
        if words == ["WAIT", "FOR"]:
            yield from self._condition(command, number)
        elif words[:2] == ["WAIT", "INDP"]:
            yield from self._axes(command, number)
        else:
            parsed = signal_command(command)
            receivers = yield from self._channels(parsed, number)
            match parsed.action:
                case "SIGNAL":
                    yield from self._send(parsed, receivers, number)
                case "SIGNAL REMOVE":
                    yield from self._remove(parsed, receivers, number)
                case _:
                    yield from self._take(parsed, receivers, number)

    def _condition(self, command: tree.HashCommand, number: int) -> Decoded:
        """Wait until the expression is true; it is evaluated again in each tick."""
        (condition,) = command.arguments
        assert isinstance(condition, tree.Expression)
        source = self._environment.source_id(command.span)
        while True:
            value = yield from self._values.evaluate(condition, number)
            if arithmetic.is_true(value):
                return
            yield NextTick(source, number)

    def _axes(self, command: tree.HashCommand, number: int) -> Decoded:
        """Wait until the path and axes in independent motion are at rest."""
        if command.arguments:
            (bracket,) = command.arguments
            assert isinstance(bracket, tree.Bracket)
            names = tuple(axis_name(item) for item in bracket.items)
        else:
            names = tuple(self._environment.axis_numbers)
        yield from self._request(names, command.span, number)

    # --- signals --------------------------------------------------------------------------------

    def _channels(self, parsed: SignalCommand, number: int) -> Generator[Command, Answer, int]:
        """Return the mask of the channels that CH names."""
        mask = 0
        for expression in parsed.channels:
            value = yield from self._values.evaluate(expression, number)
            if not is_whole(value, 1, MAX_CHANNEL):
                self._values.fail(
                    INVALID_SIGNAL_CHANNEL, expression.span, value=value, highest=MAX_CHANNEL
                )
            if value > self._signals.channel_count:
                count = self._signals.channel_count
                self._values.fail(
                    SIGNAL_CHANNEL_MISSING, expression.span, value=int(value), count=count
                )
            mask |= 1 << int(value)
        return mask

    def _signal(
        self, parsed: SignalCommand, number: int, keyword: str = "ID"
    ) -> Generator[Command, Answer, int]:
        """Return the number of the signal."""
        expression = parsed.numbers[keyword]
        value = yield from self._values.evaluate(expression, number)
        if not is_whole(value, 1, MAX_SIGNAL):
            self._values.fail(
                INVALID_SIGNAL_NUMBER, expression.span, value=value, highest=MAX_SIGNAL
            )
        return int(value)

    def _index(self, expression: tree.Expression, number: int) -> Generator[Command, Answer, int]:
        """Return the index of a value."""
        value = yield from self._values.evaluate(expression, number)
        highest = SIGNAL_VALUES - 1
        if not is_whole(value, 0, highest):
            self._values.fail(INVALID_SIGNAL_VALUE, expression.span, value=value, highest=highest)
        return int(value)

    def _send(self, parsed: SignalCommand, receivers: int, number: int) -> Decoded:
        signal = yield from self._signal(parsed, number)
        count = 1 if receivers else codes.ENDLESS_SIGNAL
        programmed = parsed.numbers.get("COUNT")
        if programmed is not None:
            value = yield from self._values.evaluate(programmed, number)
            if not is_whole(value, 1, MAX_SIGNAL):
                self._values.fail(
                    INVALID_SIGNAL_COUNT, programmed.span, value=value, highest=MAX_SIGNAL
                )
            count = int(value)
        mask, values = 0, [0.0] * SIGNAL_VALUES
        for expression, given in parsed.parameters:
            index = yield from self._index(expression, number)
            values[index] = yield from self._values.evaluate(given, number)
            mask |= 1 << index
        source = self._environment.source_id(parsed.span)
        if parsed.is_synchronous:
            yield SendSignal(source, number, signal, receivers, count, mask, tuple(values))
        elif not self._signals.send(source, signal, receivers, count, mask, values):
            self._values.fail(TOO_MANY_SIGNALS, parsed.span, count=codes.SIGNAL_CAPACITY)

    def _remove(self, parsed: SignalCommand, receivers: int, number: int) -> Decoded:
        is_range = "IDMAX" in parsed.numbers
        low = yield from self._signal(parsed, number, "ID" if "ID" in parsed.numbers else "IDMIN")
        high = low
        if is_range:
            high = yield from self._signal(parsed, number, "IDMAX")
            if high < low:
                self._values.fail(EMPTY_SIGNAL_RANGE, parsed.span, low=low, high=high)
        if parsed.is_synchronous:
            source = self._environment.source_id(parsed.span)
            yield RemoveSignals(source, number, low, high, receivers, is_range)
        else:
            self._signals.remove(low, high, receivers, is_range=is_range)

    def _take(self, parsed: SignalCommand, senders: int, number: int) -> Decoded:
        """Wait for a signal, or read one that is there; take its values."""
        signal = yield from self._signal(parsed, number)
        source = self._environment.source_id(parsed.span)
        if parsed.is_synchronous:
            yield AwaitSignal(source, number, signal, senders, parsed.overtakes)
            return
        targets: _Targets = []
        for expression, target in parsed.parameters:
            assert isinstance(target, tree.Variable | tree.Parameter)
            targets.append(((yield from self._index(expression, number)), target))
        if parsed.action == "SIGNAL READ":
            answer: Answer = self._signals.read(source, signal, senders)
            self._values.state.has_read_signal = bool(answer)
            if not answer:
                return
        else:
            answer = yield DecoderSignal(source, number, signal, senders, parsed.overtakes)
        assert isinstance(answer, tuple)
        mask, values = int(answer[0]), answer[1:]
        if mask < 0:
            self._values.fail(SIGNAL_OUT_OF_ORDER, parsed.span, id=int(values[0]))
        for index, target in targets:
            if not (mask >> index) & 1:
                self._values.fail(SIGNAL_VALUE_NOT_SENT, target.span, id=signal, index=index)
            yield from self._values.store(target, values[index], number)
