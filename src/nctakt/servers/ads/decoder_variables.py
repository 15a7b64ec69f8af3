# SPDX-License-Identifier: MIT
"""The variables of the decoder class: by name, by handle, with descriptions (AD-5).

In: group, offset and data of a request. Out: its answer. Variables of the machine come from the
latest values; V.P, V.L, V.S, V.CYC, V.G and V.A belong to the decoder's open programs, so the
session is asked; numbered zero offsets (V.G.NP) exist without a program. Structures are resolved
into their elements; an array of numbers or texts can be taken whole.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from struct import Struct, pack

from nctakt.base.dataclass import dataclass
from nctakt.base.failure import Failure, error_text
from nctakt.lists.declared.offsets import MAX_GROUPS
from nctakt.lists.declared.variables import SCALARS
from nctakt.lists.machine.external.variables import Node
from nctakt.nc.vocabulary.variables import strings
from nctakt.nc.vocabulary.variables.strings import encode
from nctakt.nc.vocabulary.variables.system_names import ROWS
from nctakt.run.access.machine_names import prefix_of
from nctakt.servers.ads.codes import AdsError, Error
from nctakt.servers.ads.data import NUMERIC, Item, Leaf, Readable
from nctakt.servers.ads.object_values import ZeroOffsets
from nctakt.servers.ads.objects import BASE, DECODER, LOGICAL, ZERO_OFFSET
from nctakt.servers.host import Host
from nctakt.servers.store import Scalar
from nctakt.session.decoders import DecoderState, DecoderVariable

#: The functions: offsets in the group of a channel, and of an axis.
COUNT, BY_INDEX, HANDLE, BY_HANDLE, BY_NAME, WRITE_HANDLE, WRITE_NAME = range(0x44, 0x4B)
DESCRIPTION = 0x4C
AXIS_HANDLE, AXIS_VALUE, AXIS_WRITE = 4, 5, 6
_ANSWERING = {COUNT, BY_INDEX, HANDLE, BY_HANDLE, BY_NAME, DESCRIPTION}
_WRITING = {WRITE_HANDLE, WRITE_NAME}
_OF_AXES = {AXIS_HANDLE: HANDLE, AXIS_VALUE: BY_NAME, AXIS_WRITE: WRITE_NAME}

#: The numbers of the types.
_TYPES = ("BOOLEAN", "SGN08", "UNS08", "SGN16", "UNS16", "SGN32", "UNS32", "REAL64", "STRING")

#: Bytes each way, and characters of a name, at most.
MAX_BYTES, MAX_NAME = 2048, 255

_AXIS_STEP = 0x10000
_NUMBER = Struct("<I")

#: Families that only programs have.
_OF_PROGRAMS = ("V.P.", "V.L.", "V.S.", "V.CYC.", "V.G.", "V.A.")


#: A zero offset of all axes, or of one.
_ZERO_OFFSET = re.compile(r"V\.G\.NP\[ ?(\d{1,9}) ?\]\.V(?:\.(\w+))?", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class Described:
    """A variable: its name as clients say it, the names in the session of its elements.

    ``count``: elements of an array, 0 for a single value.
    """

    name: str
    values: tuple[str, ...]
    type: str
    size_bytes: int
    is_writable: bool
    count: int = 0

    def description(self, handle: int) -> bytes:
        """Return handle, type, access, size, dimensions."""
        type_ = self.type if self.type in _TYPES else "STRING"
        own = (self.count,) if self.count else ()
        access = 2 if self.is_writable else 1
        numbers = (handle, _TYPES.index(type_) + 1, access, self.size_bytes, len(own), *own)
        return pack(f"<{len(numbers)}I", *numbers)

    def item(self, indices: tuple[int, ...]) -> Readable:
        """Return an element, or all of them without an index; raises ``AdsError`` (0x703)."""
        names = self.values
        if indices:
            if len(indices) > 1 or not self.count or indices[0] >= self.count:
                raise AdsError(Error.OFFSET, f"{self.name} has no element {indices}")
            names = names[indices[0] : indices[0] + 1]
        size = self.size_bytes
        leaves = [
            Leaf(name, self.type, at * size, size, self.is_writable)
            for at, name in enumerate(names)
        ]
        return Item(leaves, size * len(leaves))


class ZeroOffset(Described):
    """A zero offset of all axes of a channel, in units of 0.1 µm."""

    def item(self, indices: tuple[int, ...]) -> Readable:
        """Return that of an axis, or of all axes without an index; raises ``AdsError``."""
        return ZeroOffsets(super().item(indices).names)


class DecoderVariables:
    """The variables of all channels; a handle is the place in the list of its channel, from 1."""

    def __init__(self, host: Host) -> None:
        self._host = host
        self._machine = host.machine
        count = len(self._machine.channels)
        self._lists = [tuple(self._of_channel(index)) for index in range(count)]
        self._handles = [
            {one.name.upper(): handle for handle, one in enumerate(own, 1)} for own in self._lists
        ]

    def _of_channel(self, index: int) -> Iterator[Described]:
        channel = self._machine.channels[index]
        prefix = prefix_of(index) if len(self._machine.channels) > 1 else ""
        for family, variables in (
            ("E", channel.external_variables),
            ("CH", channel.channel_variables),
        ):
            for variable in variables:
                yield from _described(variable.node, f"V.{family}.{variable.name}", prefix)
        catalogue = self._host.catalogue
        for name, _ in catalogue.names.layout.tables[index].realtime():
            value = catalogue.find(f"{prefix}{name}")
            size = SCALARS[value.type].size_bytes
            yield Described(name, (value.name,), value.type, size, is_writable=False)
        for row in ROWS:
            if row.path.startswith("NP["):
                continue  # a numbered offset
            axes = [f".{axis.name}" for axis in channel.axes] if row.has_axis else [""]
            for axis in axes:
                name = f"V.{row.family}.{row.path}{axis}"
                size = SCALARS[row.type].size_bytes
                yield Described(name, (name,), row.type, size, is_writable=False)

    def _zero_offset(self, channel: int, group: int) -> ZeroOffset:
        """Return the zero offset of all axes; raises ``AdsError`` for an invalid number."""
        if group >= MAX_GROUPS:
            raise AdsError(Error.SYMBOL, f"there is no zero offset {group}")
        axes = [axis.name for axis in self._machine.channels[channel - 1].axes]
        prefix = prefix_of(channel - 1) if len(self._machine.channels) > 1 else ""
        name = f"V.G.NP[{group}].V"
        values = tuple(f"{prefix}{name}.{axis}" for axis in axes)
        return ZeroOffset(name, values, "SGN32", 4, is_writable=True, count=len(axes))

    # --- requests -------------------------------------------------------------------------------

    def _split(self, group: int, offset: int) -> tuple[int, int, int] | None:
        """Return channel, axis and function; ``None`` for another group."""
        channel = (group & ~LOGICAL) - BASE - DECODER
        if not group & LOGICAL:
            channel += 1
        if not 0 < channel <= len(self._lists):
            return None
        axis, function = divmod(offset, _AXIS_STEP)
        if axis:
            function = _OF_AXES.get(function, function)
        return channel, axis, function

    def answers(self, group: int, offset: int) -> bool:
        """Return whether this is a function that answers."""
        split = self._split(group, offset)
        return split is not None and split[2] in _ANSWERING

    def writes(self, group: int, offset: int) -> bool:
        """Return whether this is a function that writes."""
        split = self._split(group, offset)
        return split is not None and split[2] in _WRITING

    async def answer(self, group: int, offset: int, data: bytes) -> bytes:
        """Return the answer of a function; raises ``AdsError``."""
        split = self._split(group, offset)
        assert split is not None
        channel, axis, function = split
        if len(data) > MAX_BYTES:
            raise AdsError(Error.SIZE, f"{len(data)} bytes, more than {MAX_BYTES}")
        match function:
            case 0x44:
                return _NUMBER.pack(len(self._of_family(channel, _name(data)[0])))
            case 0x45:
                return self._by_index(channel, data)
            case 0x46:
                return _NUMBER.pack(self._handle(channel, self._full(channel, axis, data)[0]))
            case 0x47:
                one, indices, _ = self._of_handle(channel, data)
                if _is_of_program(one.name):
                    return await self._of_program(channel, one.name)
                return await self._read(one.item(indices))
            case 0x48:
                return await self._by_name(channel, self._full(channel, axis, data)[0])
        name, _ = self._full(channel, axis, data)
        handle = self._handle(channel, name)
        return self._known(channel, handle).description(handle)

    def decode(self, group: int, offset: int, data: bytes) -> dict[str, Scalar]:
        """Return the values that a function writes; raises ``AdsError``."""
        split = self._split(group, offset)
        assert split is not None
        channel, axis, function = split
        if len(data) > MAX_BYTES:
            raise AdsError(Error.SIZE, f"{len(data)} bytes, more than {MAX_BYTES}")
        if function == WRITE_HANDLE:
            one, indices, value = self._of_handle(channel, data)
            return _filled(one, indices).write(_fitting(one, value))
        name, value = self._full(channel, axis, data)
        one, indices = self._element(channel, name)
        return _filled(one, indices).write(_fitting(one, value))

    # --- finding --------------------------------------------------------------------------------

    def _of_family(self, channel: int, family: str) -> list[tuple[int, Described]]:
        """Return the variables of a family with their handles; of all for an empty text."""
        known = enumerate(self._lists[channel - 1], 1)
        prefix = f"{family.upper().rstrip('.')}."
        return [(handle, one) for handle, one in known if not family or one.name.startswith(prefix)]

    def _by_index(self, channel: int, data: bytes) -> bytes:
        if len(data) < _NUMBER.size:
            raise AdsError(Error.SIZE, "an index is 4 bytes")
        index = int(_NUMBER.unpack_from(data)[0])
        own = self._of_family(channel, _name(data[_NUMBER.size :])[0])
        if index >= len(own):
            raise AdsError(Error.OFFSET, f"there is no variable {index}")
        handle, one = own[index]
        return one.description(handle) + encode(one.name, len(one.name) + 1)

    def _full(self, channel: int, axis: int, data: bytes) -> tuple[str, bytes]:
        """Return the name in data, with the axis of the offset, and the rest."""
        name, rest = _name(data)
        if axis:
            axes = self._machine.channels[channel - 1].axes
            if axis > len(axes):
                raise AdsError(Error.OFFSET, f"there is no axis {axis}")
            name = f"{name}.{axes[axis - 1].name}"
        return name, rest

    def _known(self, channel: int, handle: int) -> Described:
        """Return the variable of a handle; raises ``AdsError``."""
        known = self._lists[channel - 1]
        if handle >= ZERO_OFFSET:
            return self._zero_offset(channel, handle - ZERO_OFFSET)
        if not 0 < handle <= len(known):
            raise AdsError(Error.SYMBOL, "an unknown handle")
        return known[handle - 1]

    def _handle(self, channel: int, name: str) -> int:
        match = _ZERO_OFFSET.fullmatch(name)
        if match is not None and not match[2]:
            return ZERO_OFFSET + int(match[1])
        handle = self._handles[channel - 1].get(name.upper())
        if handle is None:
            raise AdsError(Error.SYMBOL, f"no variable {name}")
        return handle

    def _of_handle(self, channel: int, data: bytes) -> tuple[Described, tuple[int, ...], bytes]:
        """Return the variable of a handle, the indices, and the rest."""
        head = Struct("<II")
        if len(data) < head.size:
            raise AdsError(Error.SIZE, "handle and number of indices are 8 bytes")
        handle, count = head.unpack_from(data)
        end = head.size + 4 * count
        if len(data) < end:
            raise AdsError(Error.SIZE, f"{count} indices are missing")
        known = self._known(channel, handle)
        indices = tuple(number for (number,) in _NUMBER.iter_unpack(data[head.size : end]))
        return known, indices, data[end:]

    def _element(self, channel: int, name: str) -> tuple[Described, tuple[int, ...]]:
        """Return the variable of a name, which may end with an index; raises ``AdsError``."""
        handles = self._handles[channel - 1]
        match = _ZERO_OFFSET.fullmatch(name)
        if match is not None:
            return self._element_of_offset(channel, int(match[1]), (match[2] or "").upper())
        if name.upper() in handles:
            return self._lists[channel - 1][handles[name.upper()] - 1], ()
        array, _, index = name.removesuffix("]").rpartition("[")
        if not name.endswith("]") or not index.strip().isdecimal() or len(index) > 9:
            raise AdsError(Error.SYMBOL, f"no variable {name}")
        return self._lists[channel - 1][self._handle(channel, array) - 1], (int(index),)

    def _element_of_offset(
        self, channel: int, group: int, axis: str
    ) -> tuple[Described, tuple[int, ...]]:
        """Return a zero offset, and the place of an axis in it; raises ``AdsError``."""
        names = [one.name.upper() for one in self._machine.channels[channel - 1].axes]
        if axis and axis not in names:
            raise AdsError(Error.SYMBOL, f"there is no axis {axis}")
        return self._zero_offset(channel, group), (names.index(axis),) if axis else ()

    # --- values ---------------------------------------------------------------------------------

    async def _by_name(self, channel: int, name: str) -> bytes:
        if _is_of_program(name):
            return await self._of_program(channel, name)
        one, indices = self._element(channel, name)
        return await self._read(one.item(indices))

    async def _read(self, item: Readable) -> bytes:
        if item.size_bytes > MAX_BYTES:
            raise AdsError(Error.SIZE, f"{item.size_bytes} bytes, more than {MAX_BYTES}")
        try:
            await self._host.store.subscribe(item.names, is_borrowing=True)
        except Failure as failure:
            raise AdsError(Error.NOT_READY, error_text(failure)) from failure
        return item.read(self._host.store.values)

    async def _of_program(self, channel: int, name: str) -> bytes:
        """Return a variable of the decoder's open programs."""
        try:
            states = await self._host.ask(self._host.session.decoders)
        except Failure as failure:
            raise AdsError(Error.NOT_READY, error_text(failure)) from failure
        own = [state for state in states if state.channel == channel]
        known = {one.name.upper(): one for state in own for one in _variables_of(state)}
        array, _, index = name.removesuffix("]").rpartition("[")
        found = known.get(name.upper())
        if found is not None:
            return b"".join(_packed(found, value) for value in found.values)
        found = known.get(array.upper())
        number = int(index) if index.isdecimal() and len(index) < 9 else -1
        if found is None or not name.endswith("]") or not 0 <= number < len(found.values):
            raise AdsError(Error.SYMBOL, f"no variable {name}")
        return _packed(found, found.values[number])


def _described(node: Node, path: str, prefix: str) -> Iterator[Described]:
    """Yield a variable of the lists, or the elements of a structure."""
    if not node.members:
        count = node.array_elements
        names = [f"{path}[{index}]" for index in range(count)] if count else [path]
        values = tuple(f"{prefix}{name}" for name in names)
        yield Described(path, values, node.type, node.size_bytes, is_writable=True, count=count)
        return
    for index in range(max(1, node.array_elements)):
        element = f"{path}[{index}]" if node.array_elements else path
        for member in node.members:
            yield from _described(member, f"{element}.{member.name}", prefix)


def _variables_of(state: DecoderState) -> Iterator[DecoderVariable]:
    yield from state.program
    yield from state.kept
    yield from state.cycle
    yield from state.system
    for frame in state.frames[-1:]:
        yield from frame.variables


def _packed(variable: DecoderVariable, value: float | str) -> bytes:
    """Return an element in bytes; a number without a value yet is 0."""
    if isinstance(value, str):
        return encode(value, len(value) + 1)
    if variable.type not in NUMERIC or variable.type == "REAL64":
        return pack("<d", value)
    return pack(f"<{NUMERIC[variable.type][0]}", 0 if math.isnan(value) else int(value))


def _is_of_program(name: str) -> bool:
    """Return whether a variable belongs to the decoder's open programs."""
    return name.upper().startswith(_OF_PROGRAMS) and _ZERO_OFFSET.fullmatch(name) is None


def _filled(one: Described, indices: tuple[int, ...]) -> Readable:
    """Return the target of a write; raises ``AdsError`` for a read-only one."""
    if not one.is_writable:
        raise AdsError(Error.ACCESS, f"{one.name} cannot be written")
    return one.item(indices)


def _fitting(one: Described, data: bytes) -> bytes:
    """Return the bytes of a text filled up with zeros."""
    return data if one.type in NUMERIC else data.ljust(one.size_bytes, b"\0")


def _name(data: bytes) -> tuple[str, bytes]:
    """Return the text before the first zero byte, and the rest."""
    text, _, rest = data.partition(b"\0")
    if len(text) > MAX_NAME:
        raise AdsError(Error.SIZE, f"a name of {len(text)} characters")
    return strings.decode(text).strip(), rest
