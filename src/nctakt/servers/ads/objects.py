# SPDX-License-Identifier: MIT
"""CNC objects: values of the controller's tasks by their numbers and names (AD-4).

In: group and offset. Out: the items that can be read and written there, and the list of all
objects. Public numbers, types and lengths are in ``objects.tsv`` and are kept; further elements are
nctakt's, from a round number on. Element 0 of a class is the highest of its numbers, its name that
of the instance; a number without an element is 0x703, one that is refused for a reason, too.

==========  ========================================================================================
``class``   where the group is: ``channel``, ``channel_axis``, ``platform``, ``axis`` at the COM
            task; ``ipo``, ``ipo_axis``, ``hld``, ``position_axis`` in the classes of AD-4
``number``  of the element, hexadecimal
``type``    as the controller names it; a text with its bytes
``tie``     ``shows``: as in the table of the interface; ``at PATH``: an element of the interface;
            ``ask UNIT``: what the HMI asks a control unit for; ``press UNIT``: its key, whatever
            is written; ``job``: a program that is selected and started; ``kept KEY``: no effect,
            read back under the same key; ``state_view``: what is asked of the session; ``fact``,
            ``const``
``refused`` why there is no value, for those without a tie
==========  ========================================================================================
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cache
from pathlib import Path
from struct import calcsize, pack

from nctakt.base.dataclass import dataclass
from nctakt.base.version import __version__
from nctakt.hli.interface_memory import AXIS_TYPES, AreaShape
from nctakt.hli.table import read_tie
from nctakt.lists.declared.offsets import MAX_GROUPS
from nctakt.lists.machine.machine import Machine
from nctakt.nc.vocabulary.variables import strings
from nctakt.run.access.machine_names import prefix_of
from nctakt.servers.ads.codes import AdsError, Error
from nctakt.servers.ads.data import NUMERIC, Fixed, Readable, Scaled
from nctakt.servers.ads.object_values import (
    Asked,
    Job,
    Kept,
    Pressed,
    Shown,
    Ticks,
    Viewed,
    ZeroOffsets,
    number_bytes,
)
from nctakt.servers.catalogue import Catalogue, Value

#: The first group of objects, and the offset of logical addressing.
BASE, LOGICAL = 0x20300, 0x100000

#: Offsets of the classes in the group.
POSITION_CONTROL, INTERPOLATION, DECODER, HLD, PREPARATION, SPINDLE = range(0, 0x6000, 0x1000)

#: Offsets of the attributes.
VALUE, NAME, TYPE, LENGTH, UNIT, WRITABLE, ADDRESS = range(0, 0x700, 0x100)

#: The groups of the COM task, without the offset of logical addressing: channels, axes, the list.
COM_CHANNELS, COM_AXES, LISTS = 0x20100, 0x20200, 0x130100

#: Axes in the offset of an element.
_AXIS_STEP = 0x10000

#: Numbers of a channel's and of the machine's own elements count from here.
_OWN = {INTERPOLATION: 0x200, DECODER: 0x100, HLD: 0x100, PREPARATION: 1, SPINDLE: 1}
_OWN_AXIS = {POSITION_CONTROL: 0x300, INTERPOLATION: 0x100, HLD: 0x100}
#: The highest number that element 0 counts.
_HIGHEST = 0xFFF

_RECORD_BYTES = 84
_NAME_BYTES = 32

#: The bounds that no machine passes: axes, spindles, channels.
_BOUNDS = {"axes_max": 32, "spindles_max": 6, "channels_max": 12}

#: Where the zero offsets begin in the decoder class: the handle of V.G.NP[0].V.
ZERO_OFFSET = 0x4000

#: Units of the session -> units of lists, and the factor between them.
_LIST_UNITS = {
    "mm": ("0.1 um", 10_000.0),
    "mm/s": ("um/s", 1000.0),
    "°": ("0.0001 deg", 10_000.0),
    "1/min": ("rpm", 1.0),
}

#: Names of types in the list of objects.
_LISTED_TYPES = {
    "BOOLEAN": "BOOL",
    "UNS08": "BYTE",
    "SGN08": "SINT",
    "UNS16": "WORD",
    "SGN16": "INT",
    "UNS32": "DWORD",
    "SGN32": "DINT",
    "REAL64": "LREAL",
}

#: Signals of a channel and of an axis that have no public number, by class.
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

_TITLES = {
    POSITION_CONTROL: "position control",
    INTERPOLATION: "interpolation",
    DECODER: "decoder",
    HLD: "channel",
    PREPARATION: "path preparation",
    SPINDLE: "spindle",
}


@dataclass(frozen=True, slots=True)
class Row:
    """A line of ``objects.tsv``."""

    class_: str
    number: int
    name: str
    type: str
    access: str
    unit: str
    tie: str
    refused: str


@cache
def object_rows() -> tuple[Row, ...]:
    """Return the objects that have public numbers or names, in the order of the table."""
    lines = (Path(__file__).parent / "objects.tsv").read_text("utf-8").splitlines()[2:]
    found = []
    for line in lines:
        class_, number, *rest = line.split("\t")
        found.append(Row(class_, int(number, 16), *rest))
    return tuple(found)


@dataclass(frozen=True, slots=True)
class Element:
    """An element: its name, type, unit, and its item; ``refused``: why there is none."""

    name: str
    type: str
    unit: str
    is_writable: bool
    value: Readable
    refused: str = ""

    def item(self) -> Readable:
        """Return the item; raises ``AdsError`` (0x703) if it is refused."""
        if self.refused:
            raise AdsError(Error.OFFSET, f"{self.name}: {self.refused}")
        return self.value

    def attribute(self, attribute: int) -> Readable:
        """Return one of its attributes; raises ``AdsError``."""
        match attribute:
            case 0x000:
                return self.item()
            case 0x100:
                return Fixed(_text(self.name))
            case 0x200:
                return Fixed(_text(self.type))
            case 0x300:
                return Fixed(pack("<I", self.value.size_bytes))
            case 0x400:
                return Fixed(_text(self.unit))
            case 0x500:
                return Fixed(pack("<I", self.is_writable))
        raise AdsError(Error.GROUP, f"an unknown attribute {attribute:#x}")


def _text(text: str) -> bytes:
    return strings.encode(text, len(text) + 1)


def size_of(type_: str) -> int:
    """Return the bytes of a type of ``objects.tsv``."""
    name, _, size = type_.partition(" ")
    return int(size or 1) if name in ("STRING", "BYTES") else calcsize(f"<{_format(name)}")


def _format(type_: str) -> str:
    return "q" if type_ == "SGN64" else NUMERIC[type_][0]


#: The elements of an instance: of itself (0) and of its axes, by their numbers.
_Instance = dict[int, dict[int, Element]]


class Objects:
    """The objects of a machine; ``areas``: its interface."""

    def __init__(self, catalogue: Catalogue, areas: Mapping[str, Sequence[AreaShape]]) -> None:
        self._catalogue = catalogue
        self._machine = catalogue.names.configuration
        self._channels, self._machine_areas = areas["gpCh"], areas
        count = len(self._machine.channels)
        self._prefixes = [prefix_of(index) if count > 1 else "" for index in range(count)]
        self._instances: dict[tuple[int, int], _Instance] = {}
        self._com: dict[int, _Instance] = {}
        self._axes: _Instance = {}
        self._add_machine()
        for index in range(count):
            self._add_channel(index)
        self._add_spindles()
        self._lists: dict[int, list[bytes]] = {}

    # --- content --------------------------------------------------------------------------------

    def _add_machine(self) -> None:
        """Add the platform, the axes of the machine and position control."""
        self._com[0] = {0: self._rows("platform", self._machine_areas["gpPform"][0], 0)}
        position: _Instance = {0: {}}
        for index, axis in enumerate(self._machine.axes):
            area = self._machine_areas["gpAx"][index]
            self._axes[index + 1] = self._rows("axis", area, index)
            elements = self._rows("position_axis", area, index)
            elements |= self._signals(f"{self._owner(axis.name)}{axis.name}.", POSITION_CONTROL)
            position[index + 1] = {**elements, 0: _count(axis.name, elements)}
        position[0][0] = _count("position control", position[0])
        self._instances[POSITION_CONTROL, 0] = position

    def _owner(self, axis: str) -> str:
        """Return the prefix of the channel that has an axis; empty for one without."""
        for prefix, channel in zip(self._prefixes, self._machine.channels, strict=True):
            if any(one.name == axis for one in channel.axes):
                return prefix
        return ""

    def _add_channel(self, index: int) -> None:
        number, prefix, area = index + 1, self._prefixes[index], self._channels[index]
        axes = self._machine.channels[index].axes
        com: _Instance = {0: self._rows("channel", area, index)}
        for at, axis in enumerate(axes, 1):
            com[at] = self._rows("channel_axis", area, axis.index, axis.name)
        self._com[number] = com
        for class_ in (INTERPOLATION, DECODER, HLD, PREPARATION):
            table = {INTERPOLATION: "ipo", HLD: "hld"}.get(class_, "")
            elements = self._rows(table, area, index) if table else {}
            names = _OF_CHANNEL.get(class_) or _panel_names(self._catalogue.names.panels[index])
            for offset, name in enumerate(names):
                elements[_OWN[class_] + offset] = self._value(prefix, name)
            if class_ == DECODER:
                elements |= dict(_zero_offsets(prefix, [axis.name for axis in axes]))
            instance: _Instance = {
                0: {**elements, 0: _count(f"{_TITLES[class_]} {number}", elements)}
            }
            for at, axis in enumerate(axes if class_ in _OF_AXIS else (), 1):
                inner = (
                    self._rows("ipo_axis", area, axis.index, axis.name) if table == "ipo" else {}
                )
                inner |= self._signals(f"{prefix}{axis.name}.", class_)
                instance[at] = {**inner, 0: _count(f"{prefix}{axis.name}", inner)}
            self._instances[class_, number] = instance

    def _add_spindles(self) -> None:
        number = 0
        for prefix, table in zip(self._prefixes, self._catalogue.names.layout.tables, strict=True):
            for name in table.spindles:
                elements = {
                    _OWN[SPINDLE] + at: self._value(f"{prefix}{name}.", path)
                    for at, path in enumerate(("SPEED", "POSITION"))
                }
                head = _count(f"{prefix}{name}", elements)
                self._instances[SPINDLE, number] = {0: {**elements, 0: head}}
                number += 1

    def _signals(self, prefix: str, class_: int) -> dict[int, Element]:
        """Return the elements of an axis that have no public number."""
        return {
            _OWN_AXIS[class_] + at: self._value(prefix, path)
            for at, path in enumerate(_OF_AXIS[class_])
            if f"{prefix}{path}" in self._catalogue
        }

    def _value(self, prefix: str, name: str) -> Element:
        """Return an element that shows a value of the session in the units of lists."""
        value: Value = self._catalogue.find(f"{prefix}{name}")
        unit, factor = _LIST_UNITS.get(value.unit, (value.unit, 1.0))
        type_ = "SGN32" if value.unit in _LIST_UNITS else value.type
        scaled = Scaled(value.name, type_, factor, value.is_writable)
        return Element(name, type_, unit, value.is_writable, scaled)

    def _rows(self, class_: str, area: AreaShape, index: int, axis: str = "") -> dict[int, Element]:
        """Return the elements of a class with public numbers; ``index``: of its channel or axis."""
        found = {}
        for row in object_rows():
            if row.class_ == class_:
                value = self._readable(row, area, index, axis)
                refused = row.refused or ("" if value else "a spindle has no such signal")
                found[row.number] = Element(
                    row.name,
                    row.type.partition(" ")[0],
                    row.unit,
                    "w" in row.access and not refused,
                    value or Fixed(bytes(size_of(row.type))),
                    refused,
                )
        return found

    def _readable(self, row: Row, area: AreaShape, index: int, axis: str) -> Readable | None:
        """Return the item of a row, ``None`` for a signal that the axis does not have."""
        kind, _, word = row.tie.partition(" ")
        size, type_ = size_of(row.type), row.type.partition(" ")[0]
        match kind:
            case "shows":
                tie = read_tie(row.tie)
                name = f"{area.prefix}{axis}.{tie.name}" if axis else area.named(tie.name)
                return Shown(name, type_, tie.shown) if name else None
            case "at":
                return Asked(area, word, type_, is_unit=False)
            case "ask":
                return Asked(area, word, type_, is_unit=True)
            case "press":
                return Pressed(area, word, type_, is_unit=True)
            case "job":
                return Job(area, size)
            case "kept":
                key = (
                    f"{area.name}{axis}{word}"
                    if row.class_ != "position_axis"
                    else area.name + word
                )
                return Kept(key, size, row.access != "r")
            case "state_view":
                return Viewed(word, area.index + 1, type_)
            case "fact":
                return self._fact(word, row.type, index)
            case "const":
                return Fixed(number_bytes(type_, float(word)))
        return Fixed(bytes(size))

    def _fact(self, word: str, type_: str, index: int) -> Readable:
        """Return a fact about the machine, a channel or an axis."""
        machine = self._machine
        name = type_.partition(" ")[0]
        if word == "tick":
            return Ticks()
        if word in ("name", "version"):
            text = __version__ if word == "version" else machine.axes[index].name
            return Fixed(strings.encode(text[: size_of(type_) - 1], size_of(type_)))
        facts: Mapping[str, Callable[[], float]] = {
            "cycle_time": lambda: machine.cycle_time_us,
            "axes": lambda: _axis_count(machine, index, is_channel=name == "UNS16"),
            "channels": lambda: len(machine.channels),
            "type": lambda: AXIS_TYPES[machine.axes[index].type],
            "mode": lambda: machine.axes[index].mode,
            "logical": lambda: machine.axes[index].logical_number,
            "channel": lambda: self._channel_of(index),
        }
        number = _BOUNDS[word] if word in _BOUNDS else facts[word]()
        return Fixed(number_bytes(name, number))

    def _channel_of(self, axis: int) -> int:
        """Return the channel that an axis begins with; 0: none."""
        for number, channel in enumerate(self._machine.channels, 1):
            if any(one.index == axis for one in channel.axes):
                return number
        return 0

    # --- finding --------------------------------------------------------------------------------

    def has_group(self, group: int) -> bool:
        """Return whether this is the group of an object, of the COM task or of a list."""
        plain = group & ~LOGICAL
        if group not in (plain, plain | LOGICAL):
            return False
        is_class = BASE <= plain < BASE + 0x6000
        is_list = LISTS <= group <= LISTS + len(self._channels)
        return is_class or is_list or COM_CHANNELS <= plain < COM_AXES + 0x100

    def attribute_of(self, group: int) -> int:
        """Return the attribute that a group of objects asks for."""
        plain = group & ~LOGICAL
        return (plain - BASE) & 0xF00 if plain >= BASE and not self._is_list(group) else VALUE

    def _is_list(self, group: int) -> bool:
        return LISTS <= group < LISTS + 0x100

    def item(self, group: int, offset: int, size: int = 0) -> Readable:
        """Return an element, one of its attributes, or a part of the list.

        ``size``: how many bytes are wanted. Raises ``AdsError`` (0x702, 0x703).
        """
        if self._is_list(group):
            return self._list(group - LISTS, offset, size)
        plain = group & ~LOGICAL
        if plain < BASE:
            return self._com_element(plain, offset, is_logical=group != plain).item()
        class_, attribute, instance = self._split(group)
        return self._element(class_, instance, offset, group != plain).attribute(attribute)

    def address(self, group: int, offset: int, channel: int, axis: int) -> tuple[int, int]:
        """Return group and offset of an element for a channel and an axis; 0, 0 without it."""
        class_, attribute, _ = self._split(group)
        if attribute != ADDRESS:
            raise AdsError(Error.GROUP, f"{group:#x} is not the attribute of an address")
        element = offset % _AXIS_STEP
        target = axis * _AXIS_STEP + element
        try:
            self._element(class_, channel, target, True)
        except AdsError:
            return 0, 0
        return BASE + LOGICAL + class_ + channel, target

    def _split(self, group: int) -> tuple[int, int, int]:
        """Return class, attribute and instance of a group; raises ``AdsError`` (0x702)."""
        rest = (group & ~LOGICAL) - BASE
        class_, attribute, instance = rest & 0xF000, rest & 0xF00, rest & 0xFF
        if attribute == ADDRESS and not instance and (class_, 1) in self._instances:
            instance = 1  # the requested address is in the data
        if attribute > ADDRESS or (class_, instance) not in self._instances:
            raise AdsError(Error.GROUP, f"no object in group {group:#x}")
        return class_, attribute, instance

    def _element(self, class_: int, instance: int, offset: int, is_logical: bool) -> Element:
        axis, number = divmod(offset, _AXIS_STEP)
        if class_ == POSITION_CONTROL:
            axis = self._index_of(axis, is_logical)
        return _of(self._instances.get((class_, instance), {}), axis, number)

    def _index_of(self, axis: int, is_logical: bool) -> int:
        """Return the index, from 1, of an axis of the machine by its number in an offset."""
        if not is_logical or not axis:
            return axis
        numbers = [one.logical_number for one in self._machine.axes]
        return numbers.index(axis) + 1 if axis in numbers else len(numbers) + 1

    def _com_element(self, plain: int, offset: int, *, is_logical: bool) -> Element:
        axis, number = divmod(offset, _AXIS_STEP)
        if plain >= COM_AXES:
            axis = axis or plain - COM_AXES  # some clients add the axis to the group
            return _of(self._axes, self._index_of(axis, is_logical), number)
        channel = self._com.get(plain - COM_CHANNELS)
        if channel is None:
            raise AdsError(Error.GROUP, f"no object in group {plain:#x}")
        if not axis and number not in channel[0] and number in self._com[0][0]:
            return self._com[0][0][number]  # data of the platform are in each channel's group
        return _of(channel, axis, number)

    def groups(self) -> Iterator[int]:
        """Yield the groups of all instances of the classes, in logical addressing."""
        for class_, instance in sorted(self._instances):
            yield BASE + LOGICAL + class_ + instance

    # --- the list -------------------------------------------------------------------------------

    def _list(self, channel: int, offset: int, size: int) -> Readable:
        """Return the number of objects, or their records from one on; 0: all channels."""
        records = self._lists.get(channel)
        if records is None:
            records = self._lists[channel] = [
                _record(at, *found) for at, found in enumerate(self._listed(channel), 1)
            ]
        if offset == 0:
            return Fixed(pack("<I", len(records)))
        if offset > len(records):
            raise AdsError(Error.OFFSET, f"the list has {len(records)} objects")
        count = max(1, size // _RECORD_BYTES)
        return Fixed(b"".join(records[offset - 1 : offset - 1 + count]))

    def _listed(self, channel: int) -> Iterator[tuple[int, int, str, Element]]:
        """Yield group, offset, name and element of each object; equal names get their channel."""
        com = LOGICAL + COM_CHANNELS
        numbers = [channel] if channel else range(1, len(self._channels) + 1)
        if channel in (0, 1):
            yield from _shown(com, 0, "", self._com[0][0])
            for axis, elements in self._axes.items():
                logical = self._machine.axes[axis - 1].logical_number
                yield from _shown(LOGICAL + COM_AXES, logical, f"ac_{logical}_", elements)
        for number in numbers:
            first = "" if channel or number == 1 else f"ch{number}_"
            for axis, elements in self._com[number].items():
                yield from _shown(
                    com + number, axis, f"{first}a{axis}_" if axis else first, elements
                )


def _shown(
    group: int, axis: int, prefix: str, elements: Mapping[int, Element]
) -> Iterator[tuple[int, int, str, Element]]:
    for number, element in elements.items():
        if not element.refused:
            yield group, axis * _AXIS_STEP + number, f"{prefix}{element.name}", element


def _record(at: int, group: int, offset: int, name: str, element: Element) -> bytes:
    head = pack("<IIHHII", at, element.value.size_bytes, element.is_writable, 0, group, offset)
    texts = (name, _LISTED_TYPES.get(element.type, element.type))
    return head + b"".join(strings.encode(one[: _NAME_BYTES - 1], _NAME_BYTES) for one in texts)


def _panel_names(panel: Iterable[str]) -> list[str]:
    """Return the operator's values in the order of their numbers: later ones come last."""
    return sorted(panel, key=lambda name: name.startswith("HLI.SEARCH_"))


def _zero_offsets(prefix: str, axes: Sequence[str]) -> Iterator[tuple[int, Element]]:
    """Yield the zero offsets of a channel by their numbers, which are their handles."""
    for group in range(MAX_GROUPS):
        name = f"V.G.NP[{group}].V"
        value = ZeroOffsets([f"{prefix}{name}.{axis}" for axis in axes])
        yield ZERO_OFFSET + group, Element(name, "SGN32", "0.1 um", True, value)


def _count(name: str, elements: Mapping[int, Element]) -> Element:
    """Return element 0: the highest number of an instance, whose name is that of the instance."""
    highest = max((number for number in elements if number <= _HIGHEST), default=0)
    return Element(name, "UNS32", "", False, Fixed(pack("<I", highest)))


def _of(instance: _Instance, axis: int, number: int) -> Element:
    try:
        return instance[axis][number]
    except KeyError:
        raise AdsError(Error.OFFSET, f"no element {number:#x} of axis {axis}") from None


def _axis_count(machine: Machine, index: int, *, is_channel: bool) -> int:
    return len(machine.channels[index].axes) if is_channel else len(machine.axes)
