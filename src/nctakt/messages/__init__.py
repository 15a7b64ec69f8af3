# SPDX-License-Identifier: MIT
"""The catalogue: each message that nctakt can give, once.

The controller's own number is used where it is known; what the controller does not number has one
of ours, from 900000 on. One module per stage declares them:

====================  ==============================================================================
``lists``             lists: their text, their entries, their values (900000 … 900029)
``schedule``          the scheduling list rtconf.lis (900030 … 900059)
``scheduling``        scheduling: profiles, load, simulation, analysis (900600 … 900649)
``scheduling_run``    a schedule that runs for real (900680 … 900699)
``machine``           the machine folder and its parameters (900060 … 900079, 900086, 900885)
``variables``         the variables lists: V.E and V.CH (900080 … 900085, 900087 … 900099, 900814)
``nc_text``           NC text: lexer and parser (900100 … 900199)
``checked_blocks``    checked program: words and commands (900200 … 900212, 900229 … 900234)
``checked_values``    checked program: variables and expressions (900213 … 900221, 900227 … 900228)
``checked_cycles``    checked program: control statements and realtime cycles (900222 … 900226)
``lints``             checked program: what is likely meant otherwise (900235 … 900259, 900270)
``checked_axes``      checked program: single-axis commands (900260 … 900269)
``decoder``           the decoder, while it evaluates (900300 … 900339)
``memory``            texts, wholes and the packed image of V.E (900340 … 900359)
``realtime``          the realtime part (900400 … 900499)
``user_errors``       ``#ERROR`` (900280 … 900281, 900460 … 900469)
``run.scheduled_run``              feeds, overrides of the program (60131, 900819, 900835 … 900839)
``run.spindle_setup``          spindles (900282, 900470 … 900479)
``outside``           command line, files, PLC, stimuli (900500 … 900549, 900570 … 900579, 900816 …)
``checking``          the command ``nctakt check`` (900580 … 900599, 900815)
``scheduled_runs``    a controller that a schedule gives its time (900730 … 900739)
``plc``               the PLC's side: partners in other processes, scripts (900650 … 900679)
``folders``           how lists name each other, tools, offsets (900740 … 900769, 900818)
``offsets``           offsets between programmed and axis positions (900770 … 900799)
``systems``           coordinate systems of programs (900840 … 900846)
``tools``             tools in programs, compensation (900865 … 900879, 900950 … 900969)
``backward``          backward motion and what works with its history (900880 … 900899)
``fixed_stops``       moving to a fixed stop
``diagnosis``         the lines of the cycles' diagnosis data (900456 … 900458, 900550 … 900569)
``coverage``          branch coverage of realtime cycles (900800 … 900809)
``unreached``         numbers of the controller that no program of nctakt reaches
====================  ==============================================================================

A number of the controller stands where the stage that reports it has its own.
"""

from __future__ import annotations

from nctakt.base.diagnostics import Diagnostic, Severity, Span
from nctakt.messages import (
    backward,
    checked_axes,
    checked_blocks,
    checked_cycles,
    checked_values,
    checking,
    coverage,
    decoder,
    diagnosis,
    fixed_stops,
    folders,
    lints,
    lists,
    machine,
    memory,
    motion,
    nc_text,
    offsets,
    outside,
    pace,
    plc,
    realtime,
    schedule,
    scheduled_runs,
    scheduling,
    scheduling_run,
    spindles,
    systems,
    tools,
    unreached,
    user_errors,
    variables,
)
from nctakt.messages.catalogue import Catalogue

__all__ = ["CATALOGUE", "Catalogue", "Collector", "diagnostic"]

CATALOGUE = Catalogue()
for _stage in (
    lists,
    schedule,
    scheduling,
    scheduling_run,
    scheduled_runs,
    machine,
    folders,
    variables,
    nc_text,
    checked_blocks,
    checked_values,
    checked_cycles,
    checked_axes,
    lints,
    offsets,
    systems,
    tools,
    decoder,
    motion,
    pace,
    memory,
    realtime,
    backward,
    fixed_stops,
    user_errors,
    spindles,
    outside,
    plc,
    checking,
    diagnosis,
    coverage,
    unreached,
):
    CATALOGUE.include(_stage.MESSAGES)


class Collector:
    """Gathers diagnostics of one run over some text, in the order of their discovery."""

    def __init__(self) -> None:
        self.diagnostics: list[Diagnostic] = []

    def report(
        self, number: int, span: Span | None, source_line: str = "", **values: object
    ) -> Diagnostic:
        """Add the message ``number`` at ``span``."""
        found = diagnostic(number, span, source_line, **values)
        self.diagnostics.append(found)
        return found

    @property
    def has_errors(self) -> bool:
        """Whether anything worse than a warning was reported."""
        return any(found.severity is Severity.ERROR for found in self.diagnostics)


def diagnostic(
    number: int, span: Span | None = None, source_line: str = "", **values: object
) -> Diagnostic:
    """Make the diagnostic of message ``number``; each parameter of the message needs a value."""
    message = CATALOGUE[number]
    assert values.keys() == message.parameters.keys(), (number, tuple(values))
    return Diagnostic(message, span, values, source_line)
