# SPDX-License-Identifier: MIT
"""Expressions of the controller's language that are evaluated after a tick.

In: a text such as ``V.RTA.ACS.ACT_POS.X > 400``, a machine. Out: the node that the realtime part
evaluates, in mm and degrees.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NoReturn

from nctakt.base.failure import Failure
from nctakt.decoder.cycles.watching import read_condition
from nctakt.messages import diagnostic
from nctakt.messages.connections.session import NOT_A_STOP
from nctakt.messages.machines.folders import UNKNOWN_CHANNEL

if TYPE_CHECKING:
    from nctakt.kernel.cycles.expressions import Expression
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
