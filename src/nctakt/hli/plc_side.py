# SPDX-License-Identifier: MIT
"""The PLC's side of a channel in another process: the HLI by names.

In: an image. Out: the names that a scripted PLC has, too (``run/plcs/plc_view.py``), so that one
class with ``cycle(self, hli)`` works there and here. Writes count from the next tick on (RC-002).
"""

from __future__ import annotations

from nctakt.base.diagnostics import NOTHING
from nctakt.base.failure import Failure
from nctakt.base.misspelling import nearest
from nctakt.hli.checked_values import characters_of, command_number, number_of, split_channel
from nctakt.hli.function_codes import LETTERS
from nctakt.hli.image_access import TEXT_TYPES, ImageAccess
from nctakt.hli.layout import (
    AXIS,
    CHANNEL,
    COMMAND,
    HEADER,
    LAMPS,
    PANEL,
    PREFIX,
    SPINDLE,
    SPINDLE_COMMAND,
    SPINDLE_OVERRIDE,
    UNIT,
    Entry,
    Structure,
    spindle_value_name,
)
from nctakt.hli.operator_panel import OperatorPanel
from nctakt.hli.places import size_of, unit_offset
from nctakt.hli.plc_entries import (
    AXIS_NAMES,
    CHANNEL_NAMES,
    NamedValues,
    SpindleEntry,
    TechnologyEntry,
)
from nctakt.hli.variable_names import NamedVariable
from nctakt.kernel.cells import POS_RT
from nctakt.kernel.plc.technology_slots import SLOT_COUNT
from nctakt.lists.declared.technology_functions import SYNCHRONISATIONS
from nctakt.lists.format import arguments
from nctakt.messages import diagnostic
from nctakt.messages.commands.inputs import VALUE_NOT_OF_TYPE
from nctakt.messages.machines.folders import UNKNOWN_CHANNEL
from nctakt.messages.plcs.hli_connection import (
    HLI_HAS_NO_NAME,
    HLI_INDEX_OUTSIDE,
    UNKNOWN_HLI_SPINDLE,
)
from nctakt.messages.plcs.plc import UNKNOWN_PLC_AXIS

_COMMANDS = {PREFIX + entry.name.upper(): entry for entry in PANEL}
_SHOWN = {PREFIX + entry.name.upper(): entry for entry in LAMPS}
#: M19: 0 the shorter way, 1 forward, 2 back.
_DIRECTIONS = (0, 1, -1)
#: The sense of turning after a job: M4 turns backward, after M5 and M19 a spindle is at rest.
_SENSES = {3: 1.0, 4: -1.0}
_FAMILY = "V.E."
_MAX_DIGITS = 9


class PlcSide(OperatorPanel):
    """The PLC's side of one channel; ``of_channel(2)`` is that of the second one.

    ``axes`` and ``spindles`` are the names of the machine's, ``variables`` those of its V.E
    variables, arrays without an index.
    """

    def __init__(self, access: ImageAccess, index: int = 0) -> None:
        self._access = access
        self._index = index
        self._command = access.offset(COMMAND, index)
        self._channel = access.offset(CHANNEL, index)
        self.variables = tuple(access.variables)
        self.axes = self._names_of("axes", AXIS)
        self.spindles = self._names_of("spindles", SPINDLE)
        self._logical = {
            int(access.number(structure, access.offset(structure, i), "logical")): name
            for structure, names in ((AXIS, self.axes), (SPINDLE, self.spindles))
            for i, name in enumerate(names)
        }
        channels = [
            int(access.number(SPINDLE, access.offset(SPINDLE, i), "channel"))
            for i in range(len(self.spindles))
        ]
        self._overrides = {
            spindle_value_name(name): i
            for i, name in enumerate(self.spindles)
            if channels[i] == index + 1
        }
        #: The speed after the job of each spindle that was acknowledged last, in rev/min.
        self._speeds: dict[int, float] = {}

    def _names_of(self, count: str, structure: Structure) -> tuple[str, ...]:
        """Return the names of all axes or spindles."""
        access = self._access
        offsets = (access.offset(structure, i) for i in range(int(access.number(HEADER, 0, count))))
        return tuple(access.text(structure, offset, "name") for offset in offsets)

    def __repr__(self) -> str:
        name = type(self).__name__
        return f"<{name} of {self._access.name}, channel {self._index + 1}, after tick {self.tick}>"

    def of_channel(self, number: int) -> PlcSide:
        """Return the PLC's side of a channel, from 1; raises ``Failure`` if there is none."""
        count = self.channel_count
        if not 0 < number <= count:
            raise Failure(diagnostic(UNKNOWN_CHANNEL, channel=number, count=count))
        return PlcSide(self._access, number - 1)

    @property
    def channel_count(self) -> int:
        """The number of channels of the machine."""
        return int(self._access.number(HEADER, 0, "channels"))

    @property
    def tick(self) -> int:
        """The number of the latest tick, -1 before the first one."""
        return int(self._access.number(HEADER, 0, "tick")) - 1

    @property
    def time_us(self) -> int:
        """The time at which the latest tick began, in microseconds."""
        return self.tick * self.cycle_time_us

    @property
    def cycle_time_us(self) -> int:
        """The length of a tick in microseconds."""
        return int(self._access.number(HEADER, 0, "cycle_time_us"))

    def channel(self) -> NamedValues:
        """Return the channel by the names of ``hli_channel``: ``path_speed``, ``block`` …"""
        return self._values(CHANNEL, self._channel, CHANNEL_NAMES)

    def axis(self, name: str) -> NamedValues:
        """Return an axis by the names of ``hli_axis``: ``command``, ``target``, ``state`` …"""
        if name not in self.axes:
            near, known = nearest(str(name), self.axes) or NOTHING, ", ".join(self.axes)
            raise Failure(diagnostic(UNKNOWN_PLC_AXIS, name=name, nearest=near, known=known))
        return self._values(AXIS, self._access.offset(AXIS, self.axes.index(name)), AXIS_NAMES)

    def spindle(self, name: str) -> NamedValues:
        """Return a spindle by the names of ``hli_spindle``: ``speed``, ``position`` …"""
        if name not in self.spindles:
            near, known = nearest(str(name), self.spindles) or NOTHING, ", ".join(self.spindles)
            raise Failure(diagnostic(UNKNOWN_HLI_SPINDLE, name=name, nearest=near, known=known))
        first = self._access.offset(SPINDLE, self.spindles.index(name))
        names = tuple(entry.name for entry in SPINDLE.entries if entry.type != "STRING")
        return self._values(SPINDLE, first, names)

    def _values(self, structure: Structure, first: int, names: tuple[str, ...]) -> NamedValues:
        access = self._access
        return access.consistent(
            lambda: NamedValues({name: access.number(structure, first, name) for name in names})
        )

    # --- M, H and T functions -------------------------------------------------------------------

    def functions(self) -> list[TechnologyEntry]:
        """Return the waiting functions, those of the main program first, in their order."""
        return self._access.consistent(
            lambda: [entry for name in CHANNEL.units for entry in self._waiting(name)]
        )

    def acknowledge(self, entry: TechnologyEntry) -> bool:
        """Acknowledge a function; return False, without effect, if it no longer waits.

        Raises ``ValueError`` for an entry that is not one of ``functions``.
        """
        section = "realtime" if entry.is_realtime else "program"
        if not 0 <= entry.slot < SLOT_COUNT:
            raise ValueError(f"{entry.name} has no slot {entry.slot}")
        if entry.serial == 0 or self._serial(section, entry.slot) != entry.serial:
            return False
        self._access.put_number(COMMAND, self._command, f"ack_{section}", entry.serial, entry.slot)
        return True

    def _unit(self, section: str, slot: int) -> int:
        """Return the offset of a slot."""
        return self._channel + unit_offset(CHANNEL, section) + slot * size_of(UNIT)

    def _serial(self, section: str, slot: int) -> int:
        return int(self._access.number(UNIT, self._unit(section, slot), "serial"))

    def _waiting(self, section: str) -> list[TechnologyEntry]:
        """Return the functions of a section, the oldest first."""
        slots = [slot for slot in range(SLOT_COUNT) if self._serial(section, slot)]
        found = [self._function(section, slot) for slot in slots]
        return sorted(found, key=lambda entry: entry.stamp)

    def _function(self, section: str, slot: int) -> TechnologyEntry:
        first = self._unit(section, slot)
        access = self._access
        number = {entry.name: int(access.number(UNIT, first, entry.name)) for entry in UNIT.entries}
        return TechnologyEntry(
            LETTERS[number["letter"] - 1],
            number["number"],
            number["sequence"],
            number["time_us"],
            number["identifier"] == POS_RT,
            float(number["duration_us"]),
            self._logical.get(number["axis"], ""),
            slot,
            number["value"],
            number["serial"],
            _synchronisation(number["synchronisation"]),
        )

    # --- jobs of spindles -----------------------------------------------------------------------

    def spindle_jobs(self) -> list[SpindleEntry]:
        """Return the channel's jobs of spindles that the PLC turns, in the order of its list.

        ``speed_before`` is that of the job that ``acknowledge_spindle`` has acknowledged before.
        """
        return self._access.consistent(self._spindle_jobs)

    def acknowledge_spindle(self, job: SpindleEntry) -> bool:
        """Acknowledge a job as done; return False, without effect, if it no longer waits.

        Raises ``ValueError`` for a job that is not one of ``spindle_jobs``.
        """
        if not 0 <= job.index < len(self.spindles):
            raise ValueError(f"there is no spindle with index {job.index}")
        first = self._access.offset(SPINDLE, job.index)
        if job.serial == 0 or int(self._access.number(SPINDLE, first, "job")) != job.serial:
            return False
        self._speeds[job.index] = job.speed * _SENSES.get(job.function, 0.0)
        answer = self._access.offset(SPINDLE_COMMAND, job.index)
        self._access.put_number(SPINDLE_COMMAND, answer, "ack_job", job.serial)
        return True

    def _spindle_jobs(self) -> list[SpindleEntry]:
        access, found = self._access, []
        for index, name in enumerate(self.spindles):
            first = access.offset(SPINDLE, index)
            number = {
                entry.name: access.number(SPINDLE, first, entry.name)
                for entry in SPINDLE.entries
                if entry.type != "STRING"
            }
            if number["job"] and int(number["channel"]) == self._index + 1:
                found.append(
                    SpindleEntry(
                        name,
                        int(number["function"]),
                        number["job_speed"],
                        number["job_position"],
                        _DIRECTIONS[int(number["direction"])],
                        int(number["job_time_us"]),
                        self._speeds.get(index, 0.0),
                        index,
                        int(number["job"]),
                    )
                )
        return found

    def acknowledge_all(self) -> None:
        """Acknowledge all waiting functions and spindle jobs of the channel."""
        for job in self.spindle_jobs():
            self.acknowledge_spindle(job)
        for entry in self.functions():
            self.acknowledge(entry)

    # --- values by name -------------------------------------------------------------------------

    def read(self, name: str) -> float | bool | str:
        """Return a value of the HLI or a V.E variable; raises ``Failure`` for an unknown name.

        ``CH2.V.E.SPEED`` is one of the second channel.
        """
        number, path = self._divided(arguments.text("name", name))
        if number != self._index + 1:
            return self.of_channel(number).read(path)
        access, upper = self._access, path.upper()
        if upper in _COMMANDS:
            entry = _COMMANDS[upper]
            return _shown(entry, access.number(COMMAND, self._command, entry.name))
        if upper in _SHOWN:
            entry = _SHOWN[upper]
            return _shown(entry, access.number(CHANNEL, self._channel, entry.name))
        if upper in self._overrides:
            offset = access.offset(SPINDLE_COMMAND, self._overrides[upper])
            return float(access.number(SPINDLE_COMMAND, offset, SPINDLE_OVERRIDE.name))
        variable, offset = self._variable(path)
        if variable.type in TEXT_TYPES:
            return access.text_at(offset, variable.size_bytes)
        value = access.number_at(variable.type, offset)
        return value != 0.0 if variable.type == "BOOLEAN" else float(value)

    def write(self, name: str, value: float | bool | str) -> None:
        """Write a value of the HLI or a V.E variable; raises ``Failure`` for a wrong one."""
        number, path = self._divided(arguments.text("name", name))
        arguments.number_or_text(name, value)
        if number != self._index + 1:
            self.of_channel(number).write(path, value)
            return
        upper = path.upper()
        entry = _COMMANDS.get(upper, _SHOWN.get(upper))
        if entry is not None:
            checked = command_number(upper, entry, value)
            self._access.put_number(COMMAND, self._command, entry.name, checked)
            return
        if upper in self._overrides:
            checked = command_number(upper, SPINDLE_OVERRIDE, value)
            offset = self._access.offset(SPINDLE_COMMAND, self._overrides[upper])
            self._access.put_number(SPINDLE_COMMAND, offset, SPINDLE_OVERRIDE.name, checked)
            return
        variable, offset = self._variable(path)
        if isinstance(value, str) != (variable.type in TEXT_TYPES):
            raise Failure(diagnostic(VALUE_NOT_OF_TYPE, name=path, type=variable.type, value=value))
        if isinstance(value, str):
            data = characters_of(path, variable.type, variable.size_bytes, value)
            self._access.put_bytes(offset, data)
        else:
            checked = number_of(path, variable.type, float(value))
            self._access.put_number_at(variable.type, offset, checked)

    def _divided(self, name: str) -> tuple[int, str]:
        """Return the number of the channel that a name is for, and the name without it."""
        prefix, number, path = split_channel(name)
        return number if prefix else self._index + 1, path.strip()

    def _variable(self, path: str) -> tuple[NamedVariable, int]:
        """Return a V.E variable and its offset in the image; GLOBAL ones have no channel."""
        known = self._access.variables
        array, index = _without_index(path)
        for prefix in (f"CH{self._index + 1}.", ""):
            for text, element in ((path, -1), (array, index)):
                variable = known.get(_family_in_capitals(prefix, text))
                if variable is None or (variable.count > 0) != (element >= 0):
                    continue
                if element >= max(1, variable.count):
                    raise Failure(diagnostic(HLI_INDEX_OUTSIDE, name=path, last=variable.count - 1))
                first = int(self._access.number(HEADER, 0, "ve_offset")) + variable.offset
                return variable, first + max(0, element) * variable.size_bytes
        names = [*_COMMANDS, *_SHOWN, *known]
        near = nearest(path, names) or nearest(array, names) or NOTHING
        raise Failure(diagnostic(HLI_HAS_NO_NAME, hli=self._access.name, name=path, nearest=near))


def _shown(entry: Entry, number: float) -> float | bool:
    """Return a value of the panel as Python's type."""
    return number != 0.0 if entry.type == "BOOLEAN" else float(number)


def _without_index(path: str) -> tuple[str, int]:
    """Divide ``V.E.LIST[3]`` into the array and the index; -1 without one."""
    array, bracket, index = path.rpartition("[")
    digits = index.rstrip("] ").strip()
    if not bracket or not digits.isdecimal() or len(digits) > _MAX_DIGITS:
        return path, -1
    return array, int(digits)


def _family_in_capitals(prefix: str, path: str) -> str:
    """Return the name with ``V.E.`` in capitals, as it may be written either way."""
    if path[: len(_FAMILY)].upper() == _FAMILY:
        path = _FAMILY + path[len(_FAMILY) :]
    return prefix + path


def _synchronisation(bits: int) -> str:
    """Return the type of these bits without its modifiers."""
    for name, value in SYNCHRONISATIONS.items():
        if value and bits & value:
            return name
    return "NO_SYNCH"
