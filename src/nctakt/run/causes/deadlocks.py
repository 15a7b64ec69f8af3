# SPDX-License-Identifier: MIT
"""Programs that wait for each other: who for whom, since when, and what would release them.

In: the channels of a machine, and the signals and axes that its programs send and give
(``SignalUse``, ``AxisUse``). Out: diagnostics: a warning for a signal that no program sends, before
the first tick; an error for each channel that waits forever. Axes are in ``axis_waits.py``.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from nctakt.base.diagnostics import Diagnostic, Span, Text
from nctakt.base.source_ids import statement_span
from nctakt.messages import diagnostic
from nctakt.messages.programs.signals import DEADLOCK, SIGNAL_NEVER_SENT
from nctakt.nc.outline import SignalUse
from nctakt.results.trace.events import channels_of
from nctakt.run.causes.axis_waits import awaited_axes, axes_freed_by, seconds_text
from nctakt.run.program_loader import LoadedProgram
from nctakt.run.realtime.assembly import AssembledMachine

_UNSENT = Text(
    "No program of this run sends it: check number and CH of #WAIT and #SIGNAL.",
    "Kein Programm dieses Laufs sendet es: Nummer und CH von #WAIT und #SIGNAL prüfen.",
)
_SENT_BY_WAITING = Text(
    "Line {line} of {file} in channel {channel} would free it, but channel {channel} waits, too.",
    "Zeile {line} von {file} in Kanal {channel} würde ihn befreien, doch Kanal {channel} wartet "
    "auch.",
)
_SENT_BY_ENDED = Text(
    "Line {line} of {file} in channel {channel} sends it, but that program does not run any more.",
    "Zeile {line} von {file} in Kanal {channel} sendet es, doch dieses Programm läuft nicht mehr.",
)
_BROADCAST = Text("a broadcast of signal {id}", "das Broadcast-Signal {id}")
_ADDRESSED = Text("signal {id} of channel {channels}", "Signal {id} von Kanal {channels}")
_TO_ALL = Text("as a broadcast", "als Broadcast")
_TO_ONE = Text(
    "from channel {sender} to channel {receiver}", "von Kanal {sender} an Kanal {receiver}"
)


def awaited_text(machine: AssembledMachine, index: int) -> Text:
    """Return the signal that a channel waits for, and its missing senders; since when."""
    signals = machine.channels[index].signals
    number, senders, _, since = signals.awaited()
    if not number:
        return awaited_axes(machine, index)
    if senders:
        named = ", ".join(map(str, _missing(machine, index)))
        text = _ADDRESSED
    else:
        named, text = "", _BROADCAST
    values = {"id": number, "channels": named}
    time_us = since * machine.configuration.cycle_time_us
    return Text(
        f"{text.en.format(**values)} (since {seconds_text(time_us)})",
        f"{text.de.format(**values)} (seit {seconds_text(time_us)})",
    )


def _missing(machine: AssembledMachine, index: int) -> list[int]:
    """Return the channels whose signal has not come yet."""
    signals = machine.channels[index].signals
    number, senders, _, _ = signals.awaited()
    arrived = {
        sender
        for identity, sender, receiver, _ in signals.board.open_signals()
        if identity == number and receiver == index + 1
    }
    return [channel for channel in channels_of(senders) if channel not in arrived]


def deadlock(machine: AssembledMachine, programs: Sequence[LoadedProgram]) -> list[Diagnostic]:
    """Return an error for each channel that waits for a signal that none can send any more."""
    found = []
    for index, channel in enumerate(machine.channels):
        number, senders, source, since = channel.signals.awaited()
        if not number:
            source, since = channel.exchange.awaited_since()
            if not channel.exchange.missing():
                continue
        if not channel.panel.is_running:
            continue
        span = machine.files.span(source)
        line = "" if span is None else machine.files.line_at(span)
        awaited = awaited_text(machine, index)
        found.append(
            diagnostic(
                DEADLOCK,
                statement_span(span, line),
                line,
                channel=index + 1,
                since=seconds_text(since * machine.configuration.cycle_time_us),
                awaited=Text(awaited.en.rpartition(" (")[0], awaited.de.rpartition(" (")[0]),
                freed_by=_freed_by(machine, programs, index, number, bool(senders))
                if number
                else axes_freed_by(machine, programs, index),
            )
        )
    return found


def _freed_by(
    machine: AssembledMachine,
    programs: Sequence[LoadedProgram],
    index: int,
    number: int,
    is_addressed: bool,
) -> Text:
    """Return the line that sends the signal, or that there is none."""
    missing = _missing(machine, index) if is_addressed else None
    for channel, use in _uses(programs):
        if use.is_wait or (missing is not None and channel not in missing):
            continue
        if _sends(use, number, index + 1 if is_addressed else 0):
            is_waiting = machine.channels[channel - 1].panel.is_running
            text = _SENT_BY_WAITING if is_waiting else _SENT_BY_ENDED
            values = {"line": use.span.line, "file": use.span.file, "channel": channel}
            return Text(text.en.format(**values), text.de.format(**values))
    return _UNSENT


def _uses(programs: Sequence[LoadedProgram]) -> Iterator[tuple[int, SignalUse]]:
    """Yield the signals that the programs send and await, with the number of the channel."""
    for program in programs:
        for text in program.texts:
            for use in text.signals:
                yield program.channel + 1, use


def _sends(use: SignalUse, number: int, receiver: int) -> bool:
    """Return whether a ``#SIGNAL`` may send this; ``receiver`` 0: a broadcast."""
    if use.number not in (None, number):
        return False
    return use.channels is None or (receiver in use.channels if receiver else not use.channels)


def never_sent(machine: AssembledMachine, programs: Sequence[LoadedProgram]) -> list[Diagnostic]:
    """Return a warning for each ``#WAIT`` whose signal no program of the run sends."""
    uses = list(_uses(programs))
    open_signals = [
        (number, sender, receiver)
        for number, sender, receiver, _ in machine.kernel.signals.open_signals()
    ]
    found = []
    for channel, use in uses:
        if not use.is_wait or use.number is None or use.channels is None:
            continue
        for sender in use.channels or (0,):
            receiver = channel if sender else 0
            is_sent = any(
                not other.is_wait and sender in (0, own) and _sends(other, use.number, receiver)
                for own, other in uses
            )
            is_open = any(
                number == use.number and to == receiver and (not sender or sender == own)
                for number, own, to in open_signals
            )
            if not (is_sent or is_open):
                found.append(_unsent(use, use.number, sender, channel))
    return found


def _unsent(use: SignalUse, number: int, sender: int, receiver: int) -> Diagnostic:
    text = _TO_ONE if sender else _TO_ALL
    values = {"sender": sender, "receiver": receiver}
    route = Text(text.en.format(**values), text.de.format(**values))
    span: Span = use.span
    return diagnostic(SIGNAL_NEVER_SENT, span, use.line, id=number, sender=route)
