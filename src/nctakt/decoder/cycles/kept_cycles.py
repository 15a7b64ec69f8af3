# SPDX-License-Identifier: MIT
"""Cycles that have been built for one run, and are run again in the next as if built anew.

In: a definition, and its place in a run. Out: the built cycle, which is kept where its tree depends
on its statement alone, and found again where the same statement is defined in the same place.
"""

from __future__ import annotations

from typing import cast

from nctakt.base.dataclass import dataclass
from nctakt.decoder.cycles.builder import CycleBuilder, CycleDefinition
from nctakt.decoder.values.variables import Values
from nctakt.nc import tree


@dataclass(frozen=True, slots=True)
class CyclePlace:
    """Where in a run a cycle is defined: its serial number, the first of its probes, its names."""

    serial: int
    first_probe: int
    identity: int
    scope: str


def built_cycle(values: Values, statement: tree.RealtimeCycle, at: CyclePlace) -> CycleDefinition:
    """Return the cycle of a definition: a kept one if building it would give the same."""
    environment, state = values.environment, values.state
    kept = environment.kept_cycles
    key = (
        id(statement), id(environment.names), environment.source_id(statement.span),
        at.serial, at.first_probe, at.identity, at.scope,
        state.length_unit_mm, state.inch,
    )  # fmt: skip
    found = None if kept is None else kept.find(key)
    if isinstance(found, tuple):
        return cast("CycleDefinition", found[0])
    builder = CycleBuilder(values, at.first_probe)
    built = builder.build(statement, at.serial, at.identity, at.scope)
    if kept is not None and builder.is_repeatable:
        # The definition holds its statement; the names, which the key has as well, are next to it.
        kept.keep(key, (built, environment.names), built.cycle)
    return built
