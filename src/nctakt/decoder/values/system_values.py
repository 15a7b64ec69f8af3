# SPDX-License-Identifier: MIT
"""The values of V.G and V.A: positions, offsets, feed and units of the program.

In: a ``SystemVariable`` of the kinds ``axis`` and ``channel``. Out: its value in the program's
units, or commands if a zero offset is assigned. Changes of the list of zero offsets remain for
later programs until the next start-up.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from nctakt.base.diagnostics import NOTHING
from nctakt.decoder.state.commands import SetOffset
from nctakt.decoder.state.environment import DecoderEnvironment
from nctakt.decoder.state.modal_state import ModalState
from nctakt.decoder.state.tools import Fail
from nctakt.kernel import codes
from nctakt.kernel.base import arithmetic
from nctakt.lists.declared.kinematics import MAX_PARAMETERS
from nctakt.lists.declared.offsets import MAX_GROUPS
from nctakt.lists.machine.kinematics import Kinematic
from nctakt.messages.checked_values import INDEX_OUT_OF_RANGE
from nctakt.messages.offsets import UNKNOWN_ZERO_OFFSET
from nctakt.messages.transformations import UNKNOWN_KINEMATIC
from nctakt.nc.tree import Expression, Variable
from nctakt.nc.vocabulary.functions import FEED_PER_REVOLUTION, FEED_SHARE, INVERSE_TIME_FEED
from nctakt.nc.vocabulary.resolution import path_text
from nctakt.nc.vocabulary.system_names import ROWS, SystemRow
from nctakt.nc.vocabulary.system_variables import SystemVariable
from nctakt.nc.vocabulary.variable_table import Location

Index = Callable[[Expression], float]


class SystemValues:
    """The values of one program; ``index`` evaluates an index."""

    def __init__(
        self, environment: DecoderEnvironment, state: ModalState, fail: Fail, index: Index
    ) -> None:
        self._environment = environment
        self._state = state
        self._fail = fail
        self._index = index

    # --- reading --------------------------------------------------------------------------------

    def read(self, variable: Variable, system: SystemVariable) -> float:
        """Return the current value."""
        if system.kind == "channel":
            return self._of_channel(system.subject)
        if system.kind == "kinematic":
            kinematic, index = self._kinematic(variable, system)
            return kinematic.parameters.get(index, 0.0)
        axis = self._axis_index(variable, system)
        value = self._of_axis(system.subject, axis)
        if value is None:
            groups = self._environment.offsets.zero_groups
            value = groups.get(self._group(variable, system), {}).get(axis, 0.0)
        return self._in_units(value, axis)

    def present(self) -> Iterator[tuple[SystemRow, str, float]]:
        """Yield each variable with its axis, if it has one, and its value; no numbered offsets."""
        for row in ROWS:
            if not row.has_axis:
                yield row, "", self._of_channel(row.path)
                continue
            for axis, index in self._environment.axis_numbers.items():
                value = self._of_axis(row.path, index)
                if value is not None:
                    yield row, axis, self._in_units(value, index)

    def _in_units(self, value: float, axis: int) -> float:
        """Return a value of an axis in the program's unit."""
        is_linear = self._environment.axes[axis].is_linear
        return value / self._state.length_unit_mm if is_linear else value

    def cell(self, variable: Variable, system: SystemVariable) -> int:
        """Return the cell of an axis' actual position."""
        return self._cell(self._axis_index(variable, system))

    def _of_axis(self, subject: str, index: int) -> float | None:
        """Return the value of an axis in mm or degrees; ``None`` for one of a numbered offset."""
        axis = self._environment.axes[index]
        offsets = self._environment.offsets
        match subject:
            case "ABS":
                return offsets.inside(self._state.positions)[index]
            case "PROG" | "MENT":
                return offsets.inside(self._state.positions)[index] - offsets.total(index)
            case "ACT_POS":
                measured = [self._measured(other) for other in range(len(self._environment.axes))]
                return offsets.inside(measured)[index] - offsets.total(index)
            case "ACS.ABS":
                return self._measured(index)
            case "+SWE" | "+SWE_MDS":
                return axis.software_limit_high
            case "-SWE" | "-SWE_MDS":
                return axis.software_limit_low
            case "BZP":
                return offsets.value(index, codes.ADD_ZERO_OFFSET)
            case "PZV":
                return offsets.value(index, codes.CLAMP_OFFSET)
            case "MODULO_VALUE":
                return axis.modulo_range
            case "NP_AKT.V":
                return offsets.value(index, codes.ZERO_OFFSET)
        return None

    def _of_channel(self, subject: str) -> float:
        state = self._state
        unit = self._environment.parameters.program_start.feed_unit_mm_min
        match subject:
            case "MASS_MM":
                return float(state.inch)
            case "FEEDRATE_MODE":
                return float(state.feed.feed_mode)
            case "FEEDRATE_SCALE":
                return unit
            case "SIGNAL_READ":
                return float(state.has_read_signal)
            case "NP_DEFAULT":
                return float(self._environment.offsets.default_group)
            case "FEEDRATE" if state.feed.feed_mode == INVERSE_TIME_FEED:
                return state.feed.time_s
            case "FEEDRATE" if state.feed.feed_mode == FEED_PER_REVOLUTION:
                return state.feed.per_revolution_mm / state.length_unit_mm
            case "FEEDRATE" if state.feed.feed_mode == FEED_SHARE:
                return state.feed.share_pct
            case "FEEDRATE":
                per_minute = state.length_unit_mm if state.inch else unit
                return state.feed_mm_s * 60.0 / per_minute
        return 0.0  # MASS_360: angles are degrees

    def _measured(self, axis: int) -> float:
        """Return the actual position of an axis in mm or degrees."""
        return self._environment.cells[self._cell(axis)]

    def _cell(self, axis: int) -> int:
        name = list(self._environment.axis_numbers)[axis]
        location = self._environment.names.resolve("RTA", [("ACS", 0), ("CUR_POS", 0), (name, 0)])
        assert isinstance(location, Location)
        return location.cell

    def _axis_index(self, variable: Variable, system: SystemVariable) -> int:
        """Return the index of the axis in the channel."""
        if system.element is None:
            return self._environment.axis_numbers[system.axis]
        return self._element(variable, system.element, len(self._environment.axes))

    def _group(self, variable: Variable, system: SystemVariable) -> int:
        assert system.number is not None
        return self._element(variable, system.number, MAX_GROUPS)

    def _kinematic(self, variable: Variable, system: SystemVariable) -> tuple[Kinematic, int]:
        """Return the kinematic and the index of V.G.KIN[9].PARAM[0]."""
        assert system.number is not None
        assert system.element is not None
        kinematics = self._environment.offsets.transformation.kinematics
        id_ = int(self._index(system.number))
        kinematic = kinematics.find(0, id_)
        if kinematic is None:
            known = ", ".join(map(str, sorted(kinematics.transformations.steps[0]))) or NOTHING
            self._fail(UNKNOWN_KINEMATIC, system.number.span, id=id_, known=known)
        return kinematic, self._element(variable, system.element, MAX_PARAMETERS)

    def _element(self, variable: Variable, index: Expression, count: int) -> int:
        number = int(self._index(index))
        if not 0 <= number < count:
            name = path_text(variable)
            self._fail(INDEX_OUT_OF_RANGE, index.span, variable=name, index=number, count=count)
        return number

    # --- writing --------------------------------------------------------------------------------

    def write(
        self, variable: Variable, system: SystemVariable, value: float, source: int, number: int
    ) -> Iterator[SetOffset]:
        """Assign a zero offset, active or in the list, the default group, or of a kinematic."""
        offsets = self._environment.offsets
        if system.kind == "kinematic":
            kinematic, index = self._kinematic(variable, system)
            offsets.transformation.kinematics.set_parameter(kinematic, index, value)
            return
        if system.kind == "channel":
            group = arithmetic.round_half_even(value)
            if not 0 <= group < MAX_GROUPS:
                self._fail(UNKNOWN_ZERO_OFFSET, variable.span, group=value, highest=MAX_GROUPS - 1)
            offsets.default_group = int(group)
            return
        axis = self._axis_index(variable, system)
        if self._environment.axes[axis].is_linear:
            value *= self._state.length_unit_mm
        if system.subject == "NP_AKT.V":
            yield from offsets.set_zero(axis, value, source, number)
        else:
            offsets.zero_groups.setdefault(self._group(variable, system), {})[axis] = value
