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
from nctakt.nc.vocabulary.variables.variable_table import ChannelNames, Layout, NameTable


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
def demo_channel(rotary: tuple[str, ...] = ()) -> Channel:
    """The demo machine's channel with functions of axes; Y may not be moved on its own.

    ``rotary``: names of modulo axes that it has beside those of the machine.
    """
    machine = _machine()
    channel = machine.channels[0]
    axes = tuple((axis.name, axis.index) for axis in channel.axes)
    added = tuple((name, len(machine.axes) + i) for i, name in enumerate(rotary))
    linear = frozenset(number for _, number in axes if machine.axes[number].is_linear)
    modulo = frozenset(number for _, number in axes if machine.axes[number].is_modulo)
    single = frozenset(number for name, number in axes if name != "Y")
    names = ChannelNames(
        axes + added,
        linear,
        channel.external_variables,
        channel.channel_variables,
        tuple(spindle.name for spindle in channel.parameters.spindles),
        modulo.union(number for _, number in added),
        single,
        {number: machine.axes[number].reachable for _, number in axes},
        {spindle.logical_number: 4 for spindle in channel.parameters.spindles if spindle.is_main},
    )
    of_axis = TechnologyFunction(200, "MOS", (), 0.0, "X")
    further = tuple(replace(channel.parameters.axes[0], name=name) for name in rotary)
    parameters = replace(
        channel.parameters,
        axes=channel.parameters.axes + further,
        m_functions={**channel.parameters.m_functions, 200: of_axis},
        h_functions={**channel.parameters.h_functions, 200: of_axis},
    )
    return Channel(Layout([names], len(machine.axes) + len(added)).tables[0], parameters)


def findings(
    lines: tuple[str, ...],
    parameters: ChannelParameters | None = None,
    file: str = "p.nc",
    role: Role = "main",
    rotary: tuple[str, ...] = (),
) -> list[Diagnostic]:
    """The diagnostics of parser and checker, each in the order of the text."""
    channel = demo_channel(rotary)
    collector = Collector()
    source = Source(file, lines)
    inspect(source, channel.names, parameters or channel.parameters, collector, role=role)
    return collector.diagnostics
