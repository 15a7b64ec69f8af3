# SPDX-License-Identifier: MIT
"""The demo machine's channel for tests of the checker, and ways to change its list."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache

from nctakt.base.diagnostics import Diagnostic, Severity
from nctakt.lists.declared.technology_functions import TechnologyFunction
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.messages import Collector
from nctakt.nc.check.blocks import Role
from nctakt.nc.inspection import inspect
from nctakt.nc.source import Source
from nctakt.nc.vocabulary.variable_table import ChannelNames, Layout, NameTable


@dataclass(frozen=True, slots=True)
class Channel:
    """What ``check`` needs of a channel beside the program."""

    names: NameTable
    parameters: ChannelParameters


@cache
def _machine() -> Machine:
    return load_machine(None)


def passes(lines: Sequence[str]) -> bool:
    """Whether a program has no error on the demo machine as it is."""
    found = findings(tuple(lines), _machine().channels[0].parameters)
    return all(one.severity is not Severity.ERROR for one in found)


@cache
def demo_channel() -> Channel:
    """The demo machine's channel with functions of axes; Y may not be moved on its own."""
    machine = _machine()
    channel = machine.channels[0]
    axes = tuple((axis.name, axis.index) for axis in channel.axes)
    linear = frozenset(number for _, number in axes if machine.axes[number].is_linear)
    modulo = frozenset(number for _, number in axes if machine.axes[number].is_modulo)
    single = frozenset(number for name, number in axes if name != "Y")
    names = ChannelNames(
        axes,
        linear,
        channel.external_variables,
        channel.channel_variables,
        tuple(spindle.name for spindle in channel.parameters.spindles),
        modulo,
        single,
        {number: machine.axes[number].reachable for _, number in axes},
    )
    of_axis = TechnologyFunction(200, "MOS", (), 0.0, "X")
    parameters = replace(
        channel.parameters,
        m_functions={**channel.parameters.m_functions, 200: of_axis},
        h_functions={**channel.parameters.h_functions, 200: of_axis},
    )
    return Channel(Layout([names], len(machine.axes)).tables[0], parameters)


def findings(
    lines: tuple[str, ...],
    parameters: ChannelParameters | None = None,
    file: str = "p.nc",
    role: Role = "main",
) -> list[Diagnostic]:
    """The diagnostics of parser and checker, each in the order of the text."""
    channel = demo_channel()
    collector = Collector()
    source = Source(file, lines)
    inspect(source, channel.names, parameters or channel.parameters, collector, role=role)
    return collector.diagnostics
