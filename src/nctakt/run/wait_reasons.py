# SPDX-License-Identifier: MIT
"""The reasons why a program waits when a run reaches its limit.

In: a channel of the realtime part (``kernel.tick.wait_reasons.WaitReasons.reason``). Out: a note
with the block, its line and the reason, or none if the program is at work.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from nctakt.base.diagnostics import Diagnostic, Text
from nctakt.base.source_ids import statement_span
from nctakt.hli.function_codes import function_name
from nctakt.messages import diagnostic
from nctakt.messages.command_line import WAITING_AT_RUN_LIMIT
from nctakt.run.assembly import AssembledMachine
from nctakt.run.deadlocks import awaited_text

if TYPE_CHECKING:
    from nctakt.run.channel_run import ChannelRun

#: The reasons by the words of the realtime part.
_REASONS = {
    "program start": Text("START of the selected program", "START des angewählten Programms"),
    "programmed stop": Text("START after M00 or M01", "START nach M00 oder M01"),
    "single block": Text("START in single block mode", "START im Einzelsatzbetrieb"),
    "reset": Text("RESET: the channel is in error state", "RESET: der Kanal ist im Fehlerzustand"),
    "forward": Text(
        "forward: backward motion is commanded",
        "Vorwärtsfahren: Rückwärtsfahren ist befohlen",
    ),
    "feed hold": Text("the end of the feed hold", "das Ende des Vorschubhalts"),
    "override": Text(
        "an override above 0: the operator's override is 0 %",
        "einen Override über 0: der Override des Bedieners ist 0 %",
    ),
    "cycle override": Text(
        "an override above 0: a realtime cycle sets V.RTG.OVERRIDE.VEL.CYCLE to 0 %",
        "einen Override über 0: ein Echtzeit-Zyklus setzt V.RTG.OVERRIDE.VEL.CYCLE auf 0 %",
    ),
    "spindle turns": Text(
        "spindle {name} to turn: feed per revolution (G95)",
        "die Drehung der Spindel {name}: Vorschub je Umdrehung (G95)",
    ),
    "spindle": Text(
        "speed or position of spindle {name}", "Drehzahl oder Position der Spindel {name}"
    ),
    "spindle acknowledged": Text(
        "the PLC's acknowledgement of the job of spindle {name}",
        "die Quittung der SPS für den Auftrag der Spindel {name}",
    ),
    "free place": Text(
        "a free slot in the HLI for {name}: the PLC has not acknowledged earlier functions",
        "einen freien Platz im HLI für {name}: die SPS hat frühere Funktionen nicht quittiert",
    ),
    "acknowledgement": Text(
        "the PLC's acknowledgement of {name}", "die Quittung der SPS für {name}"
    ),
    "condition": Text(
        "the condition of #WAIT FOR to be true", "eine wahre Bedingung von #WAIT FOR"
    ),
    "signal": Text("{name}", "{name}"),
    "exchange": Text("{name}", "{name}"),
    "axis": Text(
        "axis {name}, which moves independently", "Achse {name}, die sich unabhängig bewegt"
    ),
}


def wait_reasons(machine: AssembledMachine, channels: Sequence[ChannelRun]) -> list[Diagnostic]:
    """Return a note for each program that is waiting for something at the limit."""
    reasons = [
        wait_reason(machine, index)
        for index, channel in enumerate(channels)
        if channel.result is None
    ]
    return [reason for reason in reasons if reason is not None]


def wait_reason(machine: AssembledMachine, index: int) -> Diagnostic | None:
    """Return a note with the reason why a channel's program waits, ``None`` if it does not."""
    word, source, detail = machine.channels[index].waits.reason()
    if not word:
        return None
    span = machine.files.span(source)
    line = "" if span is None else machine.files.line_at(span)
    awaited = _awaited(machine, index, word, detail)
    return diagnostic(WAITING_AT_RUN_LIMIT, statement_span(span, line), line, awaited=awaited)


def awaited(machine: AssembledMachine, index: int) -> Text | None:
    """Return what a channel's program waits for, ``None`` if it is at work."""
    word, _, detail = machine.channels[index].waits.reason()
    return _awaited(machine, index, word, detail) if word else None


def _awaited(machine: AssembledMachine, index: int, word: str, detail: int) -> Text:
    text = _REASONS[word]
    is_of_channels = word in ("signal", "exchange")
    name = awaited_text(machine, index) if is_of_channels else _name(machine, word, detail)
    return Text(text.en.format(name=name.en), text.de.format(name=name.de))


def _name(machine: AssembledMachine, word: str, detail: int) -> Text:
    """Return the name of the spindle, axis or function that the program waits for."""
    if word.startswith("spindle"):
        name = machine.registry.spindle(detail)
    else:
        name = machine.registry.axis(detail) if word == "axis" else function_name(detail)
    return Text(name, name)
