# SPDX-License-Identifier: MIT
"""The values of V.G and V.A: positions, offsets, feed and units of the program.

In: a ``SystemVariable`` of the kinds ``axis`` and ``channel``. Out: its value in the program's
units, or commands if a zero offset is assigned. Changes of the list of zero offsets remain for
later programs until the next start-up.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

from nctakt.base.diagnostics import NOTHING, Span
from nctakt.decoder.state.axis_places import AxisNotInChannelError
from nctakt.decoder.state.environment import DecoderEnvironment
from nctakt.decoder.state.modal_state import Measured, ModalState
from nctakt.decoder.state.queued.commands import SetOffset
from nctakt.decoder.state.tools import Fail
from nctakt.kernel import codes
from nctakt.kernel.base import arithmetic
from nctakt.lists.declared.offsets import MAX_GROUPS
from nctakt.lists.machine.transformations.kinematics import MAX_PARAMETERS, UNIVERSAL, Kinematic
from nctakt.lists.machine.transformations.universal_kinematic import (
    BASE,
    ENTRIES,
    MAX_BASE,
    PARAMETER,
    entry_of,
)
from nctakt.messages.path.transformations import (
    NOT_OF_KINEMATIC,
    PARAMETER_NOT_PUBLIC,
    UNKNOWN_KINEMATIC,
)
from nctakt.messages.programs.checked_values import INDEX_OUT_OF_RANGE
from nctakt.messages.programs.offsets import UNKNOWN_ZERO_OFFSET
from nctakt.nc.tree import Expression, Variable
from nctakt.nc.vocabulary.functions import FEED_PER_REVOLUTION, FEED_SHARE, INVERSE_TIME_FEED
from nctakt.nc.vocabulary.variables.resolution import path_text
from nctakt.nc.vocabulary.variables.system_names import BY_PATH, ROWS, SystemRow
from nctakt.nc.vocabulary.variables.system_variables import SystemVariable
from nctakt.nc.vocabulary.variables.variable_table import Location

Index = Callable[[Expression], float]

#: Values of axes that are neither lengths nor angles.
_WITHOUT_UNIT = ("MODE", "MERF", "RERF")
#: Kinds of the offsets that are values of an axis.
_OFFSETS = {
    "SOFFS": codes.MANUAL_OFFSET,
    "BZP": codes.ADD_ZERO_OFFSET,
    "PZV": codes.CLAMP_OFFSET,
    "MEIN": codes.MEASURE_OFFSET,
    "NP_AKT.V": codes.ZERO_OFFSET,
}
#: Fields of ``Measured`` that are values of an axis.
_MEASURED = {
    "MESS": "value",
    "MOFFS": "deviation",
    "MEAS.ACS.VALUE": "acs_value",
    "MEAS.PCS.VALUE": "pcs_value",
    "MERF": "has_touched",
}


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
            if system.element is not None:
                count = BY_PATH["G", system.subject].elements
                element = self._element(variable, system.element, count)
                return self._of_arc(element)
            return self._of_channel(system.subject)
        if system.kind == "kinematic":
            kinematic = self._kinematic(system)
            indices = self._indices_of_kinematic(variable, system)
            entry = entry_of(kinematic, system.subject, indices)
            if entry is not None:
                self._check_entry(kinematic, system, variable.span)
                return kinematic.entries.get(entry, 0.0)
            numbers = kinematic.base if system.subject == BASE else kinematic.parameters
            return numbers.get(indices[0], 0.0)
        axis = self._axis_index(variable, system)
        value = self._of_axis(system.subject, axis)
        if value is None:
            groups = self._environment.offsets.zero_groups
            value = groups.get(self._group(variable, system), {}).get(axis, 0.0)
        return value if system.subject in _WITHOUT_UNIT else self._in_units(value, axis)

    def present(self) -> Iterator[tuple[SystemRow, str, float]]:
        """Yield each variable with its axis, if it has one, and its value; no numbered offsets."""
        for row in ROWS:
            if row.elements:
                continue
            if not row.has_axis:
                yield row, "", self._of_channel(row.path)
                continue
            for axis, index in self._environment.axis_numbers.items():
                if self._environment.places.is_free(index):
                    continue
                value = self._of_axis(row.path, index)
                if value is not None:
                    if row.path not in _WITHOUT_UNIT:
                        value = self._in_units(value, index)
                    yield row, axis, value

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
        axis_name = list(self._environment.axis_numbers)[index]
        match subject:
            case "ABS":
                return self._position(index)
            case "MENT":
                position = self._position(index) - offsets.total(index)
                return -position if index in self._state.frame.mirrored else position
            case "PROG":
                return self._position(index) - offsets.total(index)
            case "ACT_POS":
                measured = [self._measured(other) for other in range(len(self._environment.axes))]
                return offsets.inside(measured)[index] - offsets.total(index)
            case "ACS.ABS":
                return self._measured(index)
            case "+SWE":
                return self._state.software_limits.of(axis, index)[1]
            case "-SWE":
                return self._state.software_limits.of(axis, index)[0]
            case "REF":
                return self._reference(axis_name) or 0.0
            case "RERF":
                return float(self._reference(axis_name) is not None)
            case "+SWE_MDS":
                return axis.software_limit_high
            case "-SWE_MDS":
                return axis.software_limit_low
            case "MODE":
                return float(axis.mode)
            case "SELECTED_CS.TRANS":
                return offsets.systems.shift[index]
            case "MODULO_VALUE":
                return axis.modulo_range
            case "WCS":
                return self._state.wcs.get(index, 0.0)
            case "MCS":
                return self._state.mcs.get(index, 0.0)
        if subject in _OFFSETS:
            return offsets.value(index, _OFFSETS[subject])
        if subject in _MEASURED:
            return float(getattr(self._measured_by_probe(index), _MEASURED[subject]))
        return None

    def _position(self, index: int) -> float:
        """Return where an axis is at the end of the block before, in the active system."""
        positions = self._state.couplings.positions(self._state.positions)
        return self._environment.offsets.inside(positions)[index]

    def _of_channel(self, subject: str) -> float:
        state = self._state
        unit = self._environment.parameters.program_start.feed_unit_mm_min
        match subject:
            case "AX_LINK.NR":
                return float(self._environment.controller_data.couplings.last)
            case "AX_LINK.ACTIVE":
                return float(bool(state.couplings.groups))
            case "MEAS_TYPE":
                listed = self._environment.parameters.measuring.type
                return float(state.measuring.type or listed)
            case "BLOCK_NR" | "SATZ_NR":
                return float(state.block_number)
            case "PROG_NR":
                name = Path(state.call_stack.frames[0].text.source.file).stem.lstrip("%O")
                return float(name) if name.isdecimal() else 0.0
            case "I" | "J" | "K":
                arc = state.path.last_arc
                return 0.0 if arc is None else arc.word(subject) / state.length_unit_mm
            case "R":
                arc = state.path.last_arc
                return 0.0 if arc is None else arc.radius / state.length_unit_mm
            case "ROT_ACTIVE":
                return float(state.frame.is_turned)
            case "ROT_ANGLE":
                return state.frame.angle_deg
            case "ROT_CENTER1" | "ROT_CENTER2":
                return state.frame.centre[int(subject[-1]) - 1] / state.length_unit_mm
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

    def _of_arc(self, index: int) -> float:
        """Return how far the centre of the last arc was moved, in the program's unit."""
        arc = self._state.path.last_arc
        return 0.0 if arc is None else arc.correction[index] / self._state.length_unit_mm

    def _measured_by_probe(self, axis: int) -> Measured:
        return self._state.measuring.measured.get(axis, Measured())

    def _reference(self, name: str) -> float | None:
        """Return the position of an axis at its reference point, ``None`` if it is not homed."""
        axis = self._environment.names.axis(name)
        assert axis is not None
        return self._environment.controller_data.references.reference_of(axis.number)

    def _measured(self, axis: int) -> float:
        """Return the actual position of an axis in mm or degrees."""
        return self._environment.cells[self._cell(axis)]

    def _cell(self, axis: int) -> int:
        name = list(self._environment.axis_numbers)[axis]
        if self._environment.places.is_free(axis):
            raise AxisNotInChannelError(name)
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

    def _kinematic(self, system: SystemVariable) -> Kinematic:
        """Return the kinematic of V.G.KIN[9].PARAM[0]."""
        assert system.number is not None
        kinematics = self._environment.offsets.transformation.kinematics
        id_ = int(self._index(system.number))
        kinematic = kinematics.find(0, id_)
        if kinematic is None:
            known = ", ".join(map(str, sorted(kinematics.transformations.steps[0]))) or NOTHING
            self._fail(UNKNOWN_KINEMATIC, system.number.span, id=id_, known=known)
        return kinematic

    def _indices_of_kinematic(self, variable: Variable, system: SystemVariable) -> tuple[int, ...]:
        """Return the indices after that of the kinematic."""
        sizes = ENTRIES.get(system.subject, (MAX_BASE,))
        if system.subject == PARAMETER:
            sizes = (MAX_PARAMETERS,)
        return tuple(
            self._element(variable, index, count)
            for index, count in zip(system.further, sizes, strict=True)
        )

    def _check_entry(self, kinematic: Kinematic, system: SystemVariable, span: Span) -> None:
        """Raise ``DecodeError`` for a name of type 91 at a kinematic of another type."""
        if kinematic.type != UNIVERSAL:
            name = system.subject.upper()
            self._fail(NOT_OF_KINEMATIC, span, name=name, id=kinematic.id, type=kinematic.type)

    def _write_kinematic(self, variable: Variable, system: SystemVariable, value: float) -> None:
        """Assign a number of a kinematic."""
        kinematics = self._environment.offsets.transformation.kinematics
        kinematic = self._kinematic(system)
        indices = self._indices_of_kinematic(variable, system)
        entry = entry_of(kinematic, system.subject, indices)
        if entry is not None:
            self._check_entry(kinematic, system, variable.span)
            kinematics.set_entry(kinematic, entry, value)
        elif system.subject == BASE:
            kinematics.set_base(kinematic, indices[0], value)
        elif kinematic.type == UNIVERSAL:
            self._fail(PARAMETER_NOT_PUBLIC, variable.span, index=indices[0], id=kinematic.id)
        else:
            kinematics.set_parameter(kinematic, indices[0], value)

    def _element(self, variable: Variable, index: Expression, count: int) -> int:
        number = int(self._index(index))
        if not 0 <= number < count:
            name = path_text(variable)
            self._fail(INDEX_OUT_OF_RANGE, index.span, variable=name, index=number, count=count)
        return number

    def copy_offset(
        self, target: Variable, value: Variable, source: int, number: int
    ) -> Iterator[SetOffset]:
        """Copy a zero offset of all axes: ``V.G.NP[12].ALL = V.G.NP_AKT.ALL``."""
        offsets = self._environment.offsets
        axes = range(len(self._environment.axes))
        if value.parts[0].indices:
            listed = offsets.zero_groups.get(self._whole_group(value), {})
            values = {axis: listed.get(axis, 0.0) for axis in axes}
        else:
            values = {axis: offsets.value(axis, codes.ZERO_OFFSET) for axis in axes}
        if target.parts[0].indices:
            offsets.zero_groups[self._whole_group(target)] = values
            return
        for axis, shift in values.items():
            yield from offsets.set_zero(axis, shift, source, number)

    def _whole_group(self, variable: Variable) -> int:
        return self._element(variable, variable.parts[0].indices[0], MAX_GROUPS)

    # --- writing --------------------------------------------------------------------------------

    def write(
        self, variable: Variable, system: SystemVariable, value: float, source: int, number: int
    ) -> Iterator[SetOffset]:
        """Assign a zero offset, the default group, a kinematic's parameter, or a position."""
        offsets = self._environment.offsets
        if system.kind == "kinematic":
            self._write_kinematic(variable, system, value)
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
        if system.subject == "WCS":
            self._state.wcs[axis] = value
        elif system.subject == "MCS":
            self._state.mcs[axis] = value
        elif system.subject == "NP_AKT.V":
            yield from offsets.set_zero(axis, value, source, number)
        else:
            offsets.zero_groups.setdefault(self._group(variable, system), {})[axis] = value
