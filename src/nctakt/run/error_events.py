# SPDX-License-Identifier: MIT
"""Errors that the realtime part has told as numbers -> diagnostics with their place."""

from __future__ import annotations

import re

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.source_ids import statement_span
from nctakt.kernel.cycles.expressions import OPERATIONS
from nctakt.lists.declared.variables import SCALARS
from nctakt.messages import diagnostic
from nctakt.nc.vocabulary.axis_commands import REFUSALS
from nctakt.run.assembly import AssembledMachine
from nctakt.trace.events import Event, number_text


def realtime_diagnostic(event: Event, machine: AssembledMachine) -> Diagnostic:
    """The diagnostic of an error or warning of a cycle, of the path or of the PLC's image.

    The values come from the context of the cycle at fault, which keeps them until the next tick.
    """
    number = int(event.text)
    index = max(event.channel - 1, 0)
    channel = machine.channels[index]
    context = channel.context
    a, b = context.fault_a, context.fault_b
    cycle = event.cycle
    values: dict[str, object]
    match number:
        case 50879:
            values = {"cycle": cycle, "operation": OPERATIONS.get(int(a), "=")}
        case 50892:
            name = machine.registry.variable(int(a))
            location = machine.assembled[index].names.resolve_text(name)
            assert isinstance(location, tuple)
            scalar = SCALARS[location[0].type]
            values = {
                "variable": name,
                "value": number_text(b),
                "low": scalar.low,
                "high": scalar.high,
            }
        case 50929:
            values = {"variable": _array(event, machine), "index": number_text(a), "count": int(b)}
        case 50942 | 50943:
            function = f"H{-int(a) - 1}" if a < 0 else f"M{int(a)}"
            values = {"function": function, "slots": int(b)}
        case 50854 | 50939:
            values = {"cycle": cycle, "steps": int(a), "limit": int(b)}
        case 50858 | 50900:
            values = {"id": int(channel.error_detail)}
        case 50855 | 50857:
            manager = channel.manager
            free = manager.memory_limit - manager.memory_used
            values = {"needed": int(channel.error_detail), "free": free}
        case 50877:
            values = {"count": channel.manager.capacity}
        case 50967:
            reason = REFUSALS[int(b)]
            values = {
                "axis": machine.registry.axis(int(a)),
                "reason_en": reason.en,
                "reason_de": reason.de,
            }
        case 50885 | 900420 | 900435 | 900446 | 900447:
            values = {"axis": machine.registry.axis(int(channel.error_detail))}
        case 900811:
            values = {"spindle": machine.registry.spindle(int(channel.error_detail))}
        case 900421:
            values = {"timer": int(a)}
        case 900346:
            values = {"variable": machine.registry.variable(machine.kernel.image.next_refused())}
        case 50935:
            values = {"spindle": machine.registry.spindle(int(a))}
        case 51028:
            values = {"cycle": cycle, "places": int(a)}
        case 900472 | 900819 | 900880 | 900890 | 50891:
            values = {}
        case 900460 | 900461 | 900470:
            values = {"value": number_text(a)}
        case 50966 | 900430 | 900431 | 900433 | 900810:
            values = {"axis": machine.registry.axis(int(a))}
        case 900432:
            axis = machine.configuration.axes[int(a)]
            values = {
                "axis": machine.registry.axis(int(a)),
                "target": number_text(b),
                "low": number_text(axis.software_limit_low),
                "high": number_text(axis.software_limit_high),
            }
        case 900434 | 900436:
            values = {"axis": machine.registry.axis(machine.single_axes.next_failed())}
        case _:
            raise AssertionError(number)
    line = "" if event.span is None else machine.files.line_at(event.span)
    return diagnostic(number, statement_span(event.span, line), line, **values)


def _array(event: Event, machine: AssembledMachine) -> str:
    """The array whose index stands at the place of the event."""
    assert event.span is not None
    before = machine.files.line_at(event.span)[: event.span.column - 1]
    found = re.search(r"[\w.\]\[]+(?=\[\s*$)", before)
    return found[0] if found else before.strip()
