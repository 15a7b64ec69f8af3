# SPDX-License-Identifier: MIT
"""Checks of the V.E variables of all channels together: their offsets and their memory.

In: the start-up list, the variables of each channel. Out: the variables that can exist; each that
shares bytes with an earlier one or lies outside the memory is reported and left out, as the
controller does.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nctakt.lists.declared.startup import StartupConfiguration
from nctakt.lists.format.values import Values
from nctakt.lists.machine.external.variables import VariablesConfiguration, VariableScope
from nctakt.lists.machine.external.variables_layout import (
    overlaps,
    pack_of,
    place_variables,
    size_of,
)
from nctakt.messages import Collector
from nctakt.messages.machines.variables import (
    EXTERNAL_VARIABLES_TOO_LARGE,
    VARIABLE_OUTSIDE_MEMORY,
    VARIABLES_OVERLAP,
)


def possible_variables(
    startup: StartupConfiguration,
    lists: Sequence[VariablesConfiguration],
    collector: Collector,
) -> tuple[VariablesConfiguration, ...]:
    """Leave out variables that overlap (P-EXTV-00011) or are outside the memory (P-STUP-00037)."""
    pack = pack_of(startup.member_alignment)
    available = startup.external_variables_bytes
    return tuple(_possible(variables, pack, available, collector) for variables in lists)


def _possible(
    variables: VariablesConfiguration, pack: int, available: int, collector: Collector
) -> VariablesConfiguration:
    dropped: set[str] = set()
    for scope in VariableScope:
        placed = place_variables([one for one in variables.external if one.scope is scope], pack)
        inside = []
        for one in placed:
            if available and one.variable.byte_offset >= 0 and one.end > available:
                dropped.add(one.variable.name)
                collector.report(
                    VARIABLE_OUTSIDE_MEMORY,
                    None,
                    name=one.variable.name,
                    scope=scope.value,
                    end=one.end,
                    available=available,
                )
            else:
                inside.append(one)
        for one, other in overlaps(inside) if variables.checks_overlapping else ():
            name, earlier = other.variable.name, one.variable.name
            dropped.add(name)
            collector.report(VARIABLES_OVERLAP, None, name=name, other=earlier, offset=other.offset)
    kept = tuple(one for one in variables.external if one.name not in dropped)
    return replace(variables, external=kept) if dropped else variables


def check_memory(
    startup: StartupConfiguration,
    lists: Sequence[VariablesConfiguration],
    values: Values,
    collector: Collector,
) -> None:
    """Report channels with too many variables; ``values``: those of the start-up list."""
    pack = pack_of(startup.member_alignment)
    available = startup.external_variables_bytes
    for channel, variables in enumerate(lists if available else (), start=1):
        needed = sum(size_of(variable.node, pack) for variable in variables.external)
        if needed > available:
            numbers = {"channel": channel, "needed": needed, "available": available}
            values.report(collector, EXTERNAL_VARIABLES_TOO_LARGE, ("ext_var_max",), **numbers)
