# SPDX-License-Identifier: MIT
"""The V.E variables of all channels as a whole: their places, and the memory that they take.

In: the start-up list, the variables of each channel. Out: diagnostics only; no variable is left
out.
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
    """Tell variables that overlap (P-EXTV-00011), and channels with too many (P-STUP-00037).

    ``values``: those of the start-up list.
    """
    pack = pack_of(startup.member_alignment)
    for variables in lists:
        if variables.checks_overlapping:
            _overlapping(variables, pack, collector)
    available = startup.external_variables_bytes
    for channel, variables in enumerate(lists if available else (), start=1):
        needed = sum(size_of(one.node, pack) for one in variables.external)
        if needed > available:
            numbers = {"channel": channel, "needed": needed, "available": available}
            values.report(collector, EXTERNAL_VARIABLES_TOO_LARGE, ("ext_var_max",), **numbers)


def _overlapping(variables: VariablesConfiguration, pack: int, collector: Collector) -> None:
    """Tell variables of one scope that share bytes."""
    for scope in VariableScope:
        placed = place_variables([one for one in variables.external if one.scope is scope], pack)
        for one, other in overlaps(placed):
            name, earlier = other.variable.name, one.variable.name
            collector.report(VARIABLES_OVERLAP, None, name=name, other=earlier, offset=other.offset)
