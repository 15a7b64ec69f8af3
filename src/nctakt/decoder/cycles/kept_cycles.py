# SPDX-License-Identifier: MIT
"""Cycles that have been built for one run, and run again in the next one as if built anew.

In: a definition whose tree depends on its statement alone. Out: the same definition, with its state
put back, where the same statement is defined again in the same place of a run. Only one run at a
time may have them.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable
from typing import Any

from nctakt.base.dataclass import dataclass
from nctakt.base.held_objects import held_objects
from nctakt.decoder.cycles.builder import CycleBuilder, CycleDefinition
from nctakt.decoder.values.variables import Values
from nctakt.kernel.state import control
from nctakt.nc import tree

#: Cycles that are kept; then all are forgotten.
MAX_KEPT = 64

#: What copies, from, to.
Copy = tuple[Callable[..., None], Any, Any]


@dataclass(frozen=True, slots=True)
class CyclePlace:
    """Where in a run a cycle is defined: its serial number, the first of its probes, its names."""

    serial: int
    first_probe: int
    identity: int
    scope: str


class KeptCycles:
    """Built cycles by what their trees depend on."""

    def __init__(self) -> None:
        self._kept: dict[Hashable, tuple[CycleDefinition, list[Copy]]] = {}

    def find(self, key: Hashable) -> CycleDefinition | None:
        """Return the cycle of this key as it was when it was kept; ``None`` if there is none."""
        kept = self._kept.get(key)
        if kept is None:
            return None
        definition, copies = kept
        for copy, source, target in copies:
            copy(source, target)
        return definition

    def keep(self, key: Hashable, definition: CycleDefinition) -> None:
        """Keep a cycle that has not run yet; what the key names by its identity is kept alive."""
        if len(self._kept) == MAX_KEPT:
            self._kept.clear()
        copies: list[Copy] = []
        for part in held_objects(definition.cycle, "nctakt.kernel."):
            kept = type(part).__new__(type(part))
            for cls in type(part).__mro__:
                if cls in control.COPIERS:
                    control.COPIERS[cls](part, kept)
                    copies.append((control.COPIERS[cls], kept, part))
        self._kept[key] = definition, copies


def built_cycle(
    values: Values, statement: tree.RealtimeCycle, place: CyclePlace
) -> CycleDefinition:
    """Return the cycle of a definition: a kept one if it would be built just so."""
    environment, state = values.environment, values.state
    kept = environment.kept_cycles
    key = (
        id(statement), id(environment.names), environment.source_id(statement.span),
        place.serial, place.first_probe, place.identity, place.scope,
        state.length_unit_mm, state.inch,
    )  # fmt: skip
    found = None if kept is None else kept.find(key)
    if found is not None:
        return found
    builder = CycleBuilder(values, place.first_probe)
    built = builder.build(statement, place.serial, place.identity, place.scope)
    if kept is not None and builder.is_repeatable:
        kept.keep(key, built)
    return built
