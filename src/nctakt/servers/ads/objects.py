# SPDX-License-Identifier: MIT
"""CNC objects: values of the controller's tasks that describe themselves (AD-4).

In: group and offset. Out: ``Item`` for value, name, type, length, unit and right of an element. A
client that knows nothing can walk all instances: element 0 is the number of elements, and its name
that of the instance. Element numbers are nctakt's own; no complete public list of them exists.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from struct import calcsize, pack

from nctakt.base.dataclass import dataclass
from nctakt.nc.vocabulary import strings
from nctakt.run.machine_names import prefix_of
from nctakt.servers.ads.codes import AdsError, Error
from nctakt.servers.ads.data import NUMERIC, Fixed, Readable, Scaled
from nctakt.servers.catalogue import Catalogue, Value

#: The first group of objects, and what logical addressing adds.
BASE, LOGICAL = 0x20300, 0x100000

#: What the classes add to the group.
POSITION_CONTROL, INTERPOLATION, DECODER, HLD, PREPARATION, SPINDLE = range(0, 0x6000, 0x1000)

#: What the attributes add.
VALUE, NAME, TYPE, LENGTH, UNIT, WRITABLE, ADDRESS = range(0, 0x700, 0x100)

#: The groups of the COM task: channels, from 1 on; axes of the machine, from 1 on.
COM_CHANNELS, COM_AXES = 0x120100, 0x120200

#: Axes in the offset of an element: of objects, of the COM task.
_AXIS_STEP, _COM_AXIS_STEP = 0x10000, 0x1000

#: Units of the session -> units of lists, and the factor between them.
_LIST_UNITS = {
    "mm": ("0.1 um", 10_000.0),
    "mm/s": ("um/s", 1000.0),
    "°": ("0.0001 deg", 10_000.0),
    "1/min": ("rpm", 1.0),
}

#: Signals of a channel and of an axis by class, in the order of their elements from 1 on.
_OF_CHANNEL: Mapping[int, Sequence[str]] = {
    INTERPOLATION: (
        "PATH.SPEED",
        "PATH.DIST_TO_GO",
        "OVERRIDE.VEL.TOTAL",
        "PATH.RAPID",
        "CYCLES.ACTIVE",
    ),
    DECODER: ("BLOCK",),
    PREPARATION: ("HLI.HISTORY", "HLI.HISTORY_SIZE", "HLI.RETRACE", "HLI.INSIDE_RT_LOOP"),
}
_OF_AXIS: Mapping[int, Sequence[str]] = {
    POSITION_CONTROL: ("ACS.ACT_POS", "ACS.CUR_POS"),
    INTERPOLATION: (
        "IPO.ACT_POS",
        "IPO.CMD_POS",
        "IPO.DIST_TO_GO",
        "OVERRIDE.VEL.TOTAL",
        "STATE",
    ),
    HLD: (
        "ACS.ACT_POS",
        "ACS.CUR_POS",
        "ACS.CMD_POS",
        "MCS.ACT_POS",
        "PCS.ACT_POS",
        "MCS.DIST_TO_GO",
        "OVERRIDE.VEL.TOTAL",
        "STATE",
    ),
}


@dataclass(frozen=True, slots=True)
class Element:
    """An element: the value of the session that it shows, or its own number.

    ``name``: without the axis or channel.
    """

    name: str
    value: Value | None = None
    number: int = 0

    @property
    def unit(self) -> tuple[str, float]:
        """Its unit in lists, and the factor from that of the session."""
        unit = "" if self.value is None else self.value.unit
        return _LIST_UNITS.get(unit, (unit, 1.0))

    @property
    def type(self) -> str:
        """Its type: lengths and angles are integers in the units of lists."""
        if self.value is None:
            return "UNS32"
        return "SGN32" if self.value.unit in _LIST_UNITS else self.value.type

    def item(self) -> Readable:
        """Return its value in bytes."""
        if self.value is None:
            return Fixed(pack("<I", self.number))
        return Scaled(self.value.name, self.type, self.unit[1], self.value.is_writable)

    def attribute(self, attribute: int) -> Readable:
        """Return one of its attributes."""
        size = pack("<I", _size_of(self.type))
        is_writable = self.value is not None and self.value.is_writable
        match attribute:
            case 0x000:
                return self.item()
            case 0x100:
                return Fixed(_text(self.name))
            case 0x200:
                return Fixed(_text(self.type))
            case 0x300:
                return Fixed(size)
            case 0x400:
                return Fixed(_text(self.unit[0]))
            case 0x500:
                return Fixed(pack("<I", is_writable))
        raise AdsError(Error.GROUP, f"an unknown attribute {attribute:#x}")


def _size_of(type_: str) -> int:
    return calcsize(f"<{NUMERIC[type_][0]}")


def _text(text: str) -> bytes:
    return strings.encode(text, len(text) + 1)


class Objects:
    """The objects of a machine, by class and instance: elements of the channel, then of axes."""

    def __init__(self, catalogue: Catalogue) -> None:
        self._catalogue = catalogue
        tables = catalogue.names.layout.tables
        machine = catalogue.names.configuration
        count = len(tables)
        self._prefixes = [prefix_of(index) if count > 1 else "" for index in range(count)]
        self._axes = [[axis.name for axis in channel.axes] for channel in machine.channels]
        every = [
            f"{prefix}{axis}"
            for prefix, own in zip(self._prefixes, self._axes, strict=True)
            for axis in own
        ]
        self._instances: dict[tuple[int, int], list[list[Element]]] = {
            (POSITION_CONTROL, 0): [
                self._instance("position control", []),
                *(self._axis(name, _OF_AXIS[POSITION_CONTROL]) for name in every),
            ]
        }
        for index, prefix in enumerate(self._prefixes):
            number = index + 1
            own = [f"{prefix}{axis}" for axis in self._axes[index]]
            for class_, title in (
                (INTERPOLATION, "interpolation"),
                (DECODER, "decoder"),
                (PREPARATION, "path preparation"),
            ):
                elements = [self._value(prefix, name) for name in _OF_CHANNEL[class_]]
                axes = [self._axis(name, _OF_AXIS[class_]) for name in own if class_ in _OF_AXIS]
                self._instances[class_, number] = [
                    self._instance(f"{title} {number}", elements),
                    *axes,
                ]
            panel = [self._value(prefix, name) for name in catalogue.names.panels[index]]
            shown = every if index == 0 else own
            self._instances[HLD, number] = [
                self._instance(f"channel {number}", panel),
                *(self._axis(name, _OF_AXIS[HLD]) for name in shown),
            ]
        spindles = [
            f"{prefix}{name}"
            for prefix, table in zip(self._prefixes, tables, strict=True)
            for name in table.spindles
        ]
        for number, name in enumerate(spindles):
            values = [self._value(f"{name}.", path) for path in ("SPEED", "POSITION")]
            self._instances[SPINDLE, number] = [self._instance(name, values)]

    def _value(self, prefix: str, name: str) -> Element:
        return Element(name, self._catalogue.find(f"{prefix}{name}"))

    def _axis(self, name: str, paths: Sequence[str]) -> list[Element]:
        return self._instance(name, [self._value(f"{name}.", path) for path in paths])

    def _instance(self, name: str, elements: Sequence[Element]) -> list[Element]:
        return [Element(name, None, len(elements)), *elements]

    # --- finding --------------------------------------------------------------------------------

    def has_group(self, group: int) -> bool:
        """Return whether this is the group of an object or of the COM task."""
        plain = group & ~LOGICAL
        is_object = BASE <= plain < BASE + 0x6000 and group in (plain, plain | LOGICAL)
        return is_object or COM_CHANNELS <= group < COM_AXES + 0x100

    def attribute_of(self, group: int) -> int:
        """Return the attribute that a group of objects asks for."""
        return ((group & ~LOGICAL) - BASE) & 0xF00

    def item(self, group: int, offset: int) -> Readable:
        """Return an element or one of its attributes; raises ``AdsError`` (0x702, 0x703)."""
        if COM_CHANNELS <= group < COM_AXES + 0x100:
            return self._com_element(group, offset).item()
        class_, attribute, instance = self._split(group)
        return self._element(class_, instance, offset).attribute(attribute)

    def address(self, group: int, offset: int, channel: int, axis: int) -> tuple[int, int]:
        """Return group and offset of an element for a channel and an axis; 0, 0 without it."""
        class_, attribute, _ = self._split(group)
        if attribute != ADDRESS:
            raise AdsError(Error.GROUP, f"{group:#x} is not the attribute of an address")
        element = offset % _AXIS_STEP
        target = axis * _AXIS_STEP + element
        try:
            self._element(class_, channel, target)
        except AdsError:
            return 0, 0
        return BASE + LOGICAL + class_ + channel, target

    def _split(self, group: int) -> tuple[int, int, int]:
        """Return class, attribute and instance of a group; raises ``AdsError`` (0x702)."""
        is_logical = bool(group & LOGICAL)
        rest = (group & ~LOGICAL) - BASE
        class_, attribute, instance = rest & 0xF000, rest & 0xF00, rest & 0xFF
        if class_ not in (POSITION_CONTROL, SPINDLE) and not is_logical:
            instance += 1  # an index counts from 0, a channel's number from 1
        if attribute > ADDRESS or (class_, instance) not in self._instances:
            raise AdsError(Error.GROUP, f"no object in group {group:#x}")
        return class_, attribute, instance

    def _element(self, class_: int, instance: int, offset: int) -> Element:
        axis, number = divmod(offset, _AXIS_STEP)
        return self._of(self._instances.get((class_, instance), []), axis, number)

    def _com_element(self, group: int, offset: int) -> Element:
        axis, number = divmod(offset, _COM_AXIS_STEP)
        if group > COM_AXES:
            return self._of(self._instances[HLD, 1], group - COM_AXES, offset)
        channel = self._instances.get((HLD, group - COM_CHANNELS))
        if channel is None:
            raise AdsError(Error.GROUP, f"no object in group {group:#x}")
        own = len(self._axes[group - COM_CHANNELS - 1])
        return self._of(channel[: own + 1], axis, number)

    def _of(self, instance: list[list[Element]], axis: int, number: int) -> Element:
        if axis >= len(instance) or number >= len(instance[axis]):
            raise AdsError(Error.OFFSET, f"no element {number} of axis {axis}")
        return instance[axis][number]

    def groups(self) -> Iterator[int]:
        """Yield the groups of all instances, in logical addressing."""
        for class_, instance in sorted(self._instances):
            yield BASE + LOGICAL + class_ + instance
