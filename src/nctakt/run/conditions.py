# SPDX-License-Identifier: MIT
"""Expressions of the controller's language that are evaluated after a tick.

In: a text such as ``V.RTA.ACS.ACT_POS.X > 400``, a machine. Out: the node that the realtime part
evaluates, in mm and degrees.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NoReturn

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.decoder.cycles.builder import CycleBuilder
from nctakt.decoder.state.environment import DecoderEnvironment
from nctakt.decoder.state.modal_state import state_at_program_start
from nctakt.decoder.values.fusing import Operand
from nctakt.decoder.values.variables import Values
from nctakt.kernel.cycles.expressions import Expression
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.messages import Collector, diagnostic
from nctakt.messages.connections.session import NOT_A_STOP, NOT_IN_THE_TICK
from nctakt.messages.machines.folders import UNKNOWN_CHANNEL
from nctakt.nc import tree
from nctakt.nc.inspection import inspect
from nctakt.nc.parse.printer import format_expression
from nctakt.nc.source import Source
from nctakt.nc.vocabulary.variables.system_variables import is_decoder_data

if TYPE_CHECKING:
    from nctakt.run.realtime.assembly import AssembledMachine


#: The column of a condition's text in the spans of its mistakes, from 0.
CONDITION_COLUMN = 5


def read_expression(machine: AssembledMachine, text: str, channel: int = 1) -> Expression:
    """Return the expression of a text about a channel, from 1; raises ``Failure``."""
    channels = machine.assembled
    if not 0 < channel <= len(channels):
        raise Failure(diagnostic(UNKNOWN_CHANNEL, channel=channel, count=len(channels)))
    environment = machine.environment(_no_subprogram, _ignore, frozenset(), channel - 1, False)
    return read_condition(text, environment, channels[channel - 1].parameters)


def _no_subprogram(name: str, *_: object) -> NoReturn:
    """Refuse to call: a condition has no program."""
    raise Failure(diagnostic(NOT_A_STOP, text=name))


def _ignore(_: object) -> None:
    """Do nothing: a condition that is read gives no notices."""


# --- the text of an expression --------------------------------------------------------------------


#: The line of the cycle around a text in which the text is, from 1.
_LINE_OF_TEXT = 2


def read_condition(
    text: str, environment: DecoderEnvironment, parameters: ChannelParameters
) -> Expression:
    """Return the expression of a text; raises ``Failure`` with all its mistakes.

    It is read as the condition of a realtime cycle, in mm and degrees.
    """
    lines = ["#RT CYCLE [SCOPE=PROG]", f"$IF {text}", "$ENDIF", "#RT CYCLE END", "M30"]
    collector = Collector()
    read = inspect(Source("condition", lines), environment.names, parameters, collector)
    errors = [found for found in collector.diagnostics if found.severity.name == "ERROR"]
    if errors:  # those of the lines around the text are caused by the mistake in it
        raise Failure(*([found for found in errors if _is_in_text(found)] or errors))
    (cycle,) = read.cycles
    condition = cycle.body[0]
    if not isinstance(condition, tree.If) or len(cycle.body) > 1:
        raise Failure(*collector.diagnostics)
    state = state_at_program_start(parameters.program_start, [0.0] * len(environment.axes))
    return _LiveBuilder(Values(environment, state), 0).expression(condition.condition)


def _is_in_text(found: Diagnostic) -> bool:
    return found.span is not None and found.span.line == _LINE_OF_TEXT


class _LiveBuilder(CycleBuilder):
    """Builds expressions in which no variable is frozen."""

    def expression(self, expression: tree.Expression) -> Expression:
        """Return the node of an expression."""
        return self._builder.build(expression).node

    def _leaf(self, node: tree.Variable | tree.Parameter) -> Operand:
        if isinstance(node, tree.Parameter) or is_decoder_data(node):
            raise Failure(diagnostic(NOT_IN_THE_TICK, name=format_expression(node)))
        return self._load(node)
