# SPDX-License-Identifier: MIT
"""The kinematic transformations in the values of a channel list.

In: checked values. Out: ``Transformations``. A universal kinematic whose definition is defective is
reported and cannot be selected.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping

from nctakt.base.diagnostics import Message
from nctakt.lists.format.parameter import with_indices
from nctakt.lists.format.values import Values
from nctakt.lists.machine.transformations.kinematics import (
    UNIVERSAL,
    Entry,
    Kinematic,
    Transformations,
)
from nctakt.lists.machine.transformations.universal_kinematic import (
    ENTRIES,
    PARAMETERS,
    DefinitionReader,
    UnusableKinematicError,
)
from nctakt.messages import Collector
from nctakt.messages.machines.kinematics import (
    KINEMATIC_GIVEN_TWICE,
    KINEMATIC_WITHOUT_ID,
    ORIENTATION_MODE_WITHOUT_EFFECT,
)

#: Where a kinematic is listed: short, and with its step.
_PREFIXES = ("trafo[]", "kin_step[].trafo[]")

#: P-CHAN-00177: the modes that act.
_ORIENTATION_MODES = ("ANGLE", "VECTOR_2DOF")


def transformations(values: Values, axis_count: int, collector: Collector) -> Transformations:
    """Return the transformations of a channel of ``axis_count`` axes."""
    steps = tuple(_step(values, step, axis_count, collector) for step in range(2))
    mode = values.text("ori.mode")
    if mode not in _ORIENTATION_MODES:
        values.report(collector, ORIENTATION_MODE_WITHOUT_EFFECT, ("ori.mode",), mode=mode)
    first = values.integer("default_id_of_kin_step[]", 0) or values.integer("kinematik_id")
    return Transformations(
        (first, values.integer("default_id_of_kin_step[]", 1)),
        steps,
        mode,
        values.integer("tool_ori_cs.axis"),
        values.integer("tool_ori_cs.mode"),
        values.integer("cax_face_id") == 2,
        values.integer("ori_rotation_angle"),
        values.integer("ori_wcs") != 0,
        values.flag("auto_enable_kin_trafo"),
        values.flag("auto_disable_kin_trafo"),
    )


def _elements(values: Values, step: int) -> Iterator[tuple[str, tuple[int, ...]]]:
    """Yield where the kinematics of a step are listed: prefix and indices."""
    short, long = _PREFIXES
    if step == 0:
        for index in values.indices(short):
            yield short, (index,)
    for index in values.indices(long, step):
        yield long, (step, index)


def _step(
    values: Values, step: int, axis_count: int, collector: Collector
) -> Mapping[int, Kinematic]:
    kinematics: dict[int, Kinematic] = {}
    seen: set[int] = set()
    for prefix, indices in _elements(values, step):
        element = _Element(values, prefix, indices, axis_count, collector)
        if element.id == 0:
            element.warn_at(KINEMATIC_WITHOUT_ID, "id")
        elif element.id in seen:
            element.warn_at(KINEMATIC_GIVEN_TWICE, "id", id=element.id)
        else:
            seen.add(element.id)
            kinematic = element.kinematic()
            if kinematic is not None:
                kinematics[element.id] = kinematic
    return kinematics


class _Element:
    """One kinematic of a list: ``trafo[j]``."""

    def __init__(
        self,
        values: Values,
        prefix: str,
        indices: tuple[int, ...],
        axis_count: int,
        collector: Collector,
    ) -> None:
        self.values = values
        self.prefix = prefix
        self.indices = indices
        self.axis_count = axis_count
        self.collector = collector
        self.id = values.integer(f"{prefix}.id", *indices)

    def kinematic(self) -> Kinematic | None:
        """Return the kinematic; ``None`` with a report if it is defective."""
        type_ = self.values.integer(f"{self.prefix}.type", *self.indices) or self.id
        pattern = f"{self.prefix}.param[]"
        parameters = {
            index: self.values.real(pattern, *self.indices, index)
            for index in self.values.indices(pattern, *self.indices)
        }
        pattern = f"{self.prefix}.base[]"
        base = {
            index: self.values.real(pattern, *self.indices, index)
            for index in self.values.indices(pattern, *self.indices)
        }
        if type_ != UNIVERSAL:
            return Kinematic(self.id, type_, parameters, base)
        entries = self.entries()
        reader = DefinitionReader(
            lambda entry: entries.get(entry, 0.0),
            self.axis_count,
            self.values.integer("ori_rotation_angle"),
        )
        try:
            universal = reader.read()
        except UnusableKinematicError as error:
            self.warn_at(error.message, error.name, *error.indices, id=self.id, **error.values)
            return None
        return Kinematic(self.id, type_, parameters, base, universal, entries)

    def entries(self) -> dict[Entry, float]:
        """Return the numbers of a universal kinematic that are not 0.

        ``param[]`` is the same memory; where both are given the name counts.
        """
        numbers = {entry: self.number("param[]", index) for index, entry in enumerate(PARAMETERS)}
        for name, sizes in ENTRIES.items():
            for indices in itertools.product(*map(range, sizes)):
                numbers[name, indices] = self.number(name, *indices) or numbers.get(
                    (name, indices), 0.0
                )
        return {entry: value for entry, value in numbers.items() if value != 0.0}

    # --- entries --------------------------------------------------------------------------------

    def number(self, name: str, *further: int) -> float:
        """Return a number of this kinematic."""
        return self.values.real(f"{self.prefix}.{name}", *self.indices, *further)

    def warn_at(self, message: Message, name: str, *further: int, **values: object) -> None:
        """Report a message at an entry of this kinematic."""
        pattern = f"{self.prefix}.{name}"
        at = (*self.indices, *further)
        key = with_indices(pattern, at)
        self.values.report(self.collector, message, (pattern, *at), key=key, **values)
