# SPDX-License-Identifier: MIT
"""Checks of the V.E variables of all channels together: their offsets and their memory.

In: the start-up list, the variables of each channel. Out: diagnostics only; no variable is removed.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.lists.declared.startup import StartupConfiguration
from nctakt.lists.format.values import Values
from nctakt.lists.machine.variables import VariablesConfiguration, VariableScope
from nctakt.lists.machine.variables_layout import overlaps, pack_of, place_variables, size_of
from nctakt.messages import Collector
from nctakt.messages.variables import EXTERNAL_VARIABLES_TOO_LARGE, VARIABLES_OVERLAP


def check_memory(
    startup: StartupConfiguration,
    lists: Sequence[VariablesConfiguration],
    values: Values,
    collector: Collector,
) -> None:
    """Report overlapping variables (P-EXTV-00011), and channels with too many (P-STUP-00037).

    ``values``: those of the start-up list.
    """
    pack = pack_of(startup.member_alignment)
    for variables in lists:
        if variables.checks_overlapping:
            _overlapping(variables, pack, collector)
    available = startup.external_variables_bytes
    for channel, variables in enumerate(lists if available else (), start=1):
        needed = sum(size_of(variable.node, pack) for variable in variables.external)
        if needed > available:
            numbers = {"channel": channel, "needed": needed, "available": available}
            values.report(collector, EXTERNAL_VARIABLES_TOO_LARGE, ("ext_var_max",), **numbers)


def _overlapping(variables: VariablesConfiguration, pack: int, collector: Collector) -> None:
    """Report variables of one scope that share bytes."""
    for scope in VariableScope:
        placed = place_variables([item for item in variables.external if item.scope is scope], pack)
        for first, other in overlaps(placed):
            name, earlier = other.variable.name, first.variable.name
            collector.report(VARIABLES_OVERLAP, None, name=name, other=earlier, offset=other.offset)
