# SPDX-License-Identifier: MIT
"""Variables of a PLC as a statement sees them: paths -> places in its memory, and back.

In: a path such as ``aTools[2].pNext^.nLife`` and the call in which it is asked. Out: address and
type. Each address is checked before it is read; references to nothing are refused by name.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.base.failure import Failure
from nctakt.kernel.st import kinds
from nctakt.kernel.st.context import PlcContext
from nctakt.messages import diagnostic
from nctakt.messages.plc_debugging import REFERS_TO_NOTHING, UNKNOWN_PLC_VARIABLE
from nctakt.messages.plcs.plc_code import NO_PART
from nctakt.st.program import Program
from nctakt.st.types import (
    ArrayType,
    BlockType,
    Callable,
    Elementary,
    InterfaceType,
    Kind,
    PointerType,
    Pou,
    ReferenceType,
    Section,
    Storage,
    StructType,
    Type,
    Variable,
    same_type,
)
from nctakt.translation.layout import kind_of
from nctakt.translation.project import numbered

_PART = re.compile(r"\s*(?:\.?\s*(\w+)|\[([^\[\]]*)\]|(\^))")
_PATH = re.compile(r"\s*[A-Za-z_]\w*(?:\s*\.\s*\w+|\s*\[[\w\s.,-]*\]|\s*\^)*\s*", re.ASCII)
_NUMBER = re.compile(r"\s*-?\d+\s*")
_THIS = "this"


@dataclass(frozen=True, slots=True)
class Place:
    """Where a value lies; ``bit`` of a whole number, or -1; ``is_of_call``: in a call's frame."""

    path: str
    address: int
    type: Type
    bit: int = -1
    is_of_call: bool = False


@dataclass(frozen=True, slots=True)
class Call:
    """An open call: the callee, whose variables it sees, and their addresses."""

    called: Callable
    pou: Pou | None
    frame: int
    instance: int


class Places:
    """The places of a program's variables in one memory."""

    def __init__(self, program: Program, context: PlcContext) -> None:
        self.program = program
        self.context = context
        blocks = [one for one in program.pous.values() if one.type is not None]
        numbers = numbered(blocks)
        self._blocks = {numbers[id(one)]: one for one in blocks}

    def find(self, path: str, call: Call | None) -> Place | None:
        """Return the location of a path in a call, or of a global one; ``None`` for no path.

        Raises ``Failure`` for an unknown name, and if the path leads through null.
        """
        if _PATH.fullmatch(path) is None:
            return None
        found: Place | None = None
        scope: dict[str, Variable] | None = None
        for match in _PART.finditer(path):
            name, indices, _ = match.groups()
            if found is None and scope is None:
                found, scope = self._first(name, call)
            elif scope is not None and name:
                variable = scope.get(name.lower())
                if variable is None:
                    raise self._unknown(path)
                found, scope = self._global(path[: match.end()], variable), None
            elif found is not None:
                whole, found = found, self._part(found, name, indices, call, path)
                if found is None and not (name and _has_members(whole.type)):
                    part, kind = path[: match.start()].strip(), whole.type.name
                    raise Failure(diagnostic(NO_PART, name=path.strip(), part=part, type=kind))
            if found is None and scope is None:
                raise self._unknown(path)
        return None if found is None else replace(found, path=path.strip())

    def _unknown(self, path: str) -> Failure:
        return Failure(diagnostic(UNKNOWN_PLC_VARIABLE, name=path.strip()))

    def _part(
        self, found: Place, name: str | None, indices: str | None, call: Call | None, path: str
    ) -> Place | None:
        """Return a member, an element, or the target of a pointer."""
        if indices is not None:
            numbers = [self._index(one, call) for one in indices.split(",")]
            return None if None in numbers else self.element(found, [n or 0 for n in numbers])
        if name is None:
            return self.pointed(found)
        if name.isdigit() and isinstance(found.type, Elementary):
            bit = int(name)
            return replace(found, bit=bit) if bit < 8 * found.type.size else None
        found = self.referred(found)
        if isinstance(found.type, InterfaceType):
            found = self.instance(found)
        return next((one for key, one in self.members(found) if key.lower() == name.lower()), None)

    def _index(self, text: str, call: Call | None) -> int | None:
        if _NUMBER.fullmatch(text):
            return int(text)
        location = self.find(text, call)
        return None if location is None else self.number(location)

    def number(self, location: Place) -> int | None:
        """Return the whole number at a location."""
        location = self.referred(location)
        kind = kind_of(location.type)
        if kind is None or kind >= kinds.F32:
            return None
        data = self.context.peek(location.address, location.type.size)
        whole = int.from_bytes(data, "little", signed=kinds.I8 <= kind <= kinds.I64)
        return whole if location.bit < 0 else whole >> location.bit & 1

    # --- where names begin

    def _first(
        self, name: str, call: Call | None
    ) -> tuple[Place | None, dict[str, Variable] | None]:
        key = name.lower()
        if call is not None:
            for owner, variable in self.seen(call):
                if variable.name.lower() == key:
                    return self.placed(owner, variable, call), None
            if key == _THIS and call.pou is not None and call.pou.type is not None:
                this = PointerType("THIS", 8, 8, call.pou.type)
                return Place(name, call.instance, this), None
        pou = self.program.pous.get(key)
        if pou is not None and pou.kind is Kind.PROGRAM and pou.type is not None:
            return Place(name, kinds.NULL_BYTES + pou.instance, pou.type), None
        for group in self.program.lists:
            if group.name and group.name.lower() == key:
                return None, group.variables
        for group in self.program.lists:
            if key in group.variables:
                return self._global(name, group.variables[key]), None
        return None, None

    def seen(self, call: Call) -> Iterator[tuple[str, Variable]]:
        """Yield the variables that a call sees: its own, then those of its instance."""
        if call.called.result is not None:
            yield "", call.called.result
        for variable in call.called.variables.values():
            yield "", variable
        if call.pou is not None:
            own = {id(one) for one in call.called.variables.values()}
            for variable in call.pou.members.values():
                if id(variable) not in own:
                    yield "THIS^.", variable

    def placed(self, prefix: str, variable: Variable, call: Call) -> Place | None:
        """Return the location of a variable that a call sees."""
        path = f"{prefix}{variable.name}"
        if variable.storage is Storage.GLOBAL:
            return self._global(path, variable)
        is_of_call = variable.storage is Storage.FRAME
        base = call.frame if is_of_call else call.instance
        location = Place(path, base + variable.offset, variable.type, variable.bit, is_of_call)
        return self._handed_over(location, variable)

    def _global(self, path: str, variable: Variable) -> Place | None:
        if variable.storage is not Storage.GLOBAL:
            return None
        return Place(path, kinds.NULL_BYTES + variable.offset, variable.type)

    def _handed_over(self, location: Place, variable: Variable) -> Place:
        """Return the target of a VAR_IN_OUT, which holds its address."""
        if variable.section is not Section.IN_OUT:
            return location
        address = self._word(location.address)
        sought = variable.type
        if isinstance(sought, ArrayType) and sought.is_open:
            data = self.context.peek(location.address + 8, 8 * sought.dimensions)
            words = [
                int.from_bytes(data[i : i + 4], "little", signed=True)
                for i in range(0, len(data), 4)
            ]
            bounds = tuple(zip(words[::2], words[1::2], strict=True))
            size = sought.element.size
            for low, high in bounds:
                size *= max(high - low + 1, 0)
            name, align, element = sought.name, sought.align, sought.element
            sought = ArrayType(name, size, align, element, bounds, len(bounds))
        return replace(location, address=self._checked(location, address, sought), type=sought)

    # --- parts

    def members(self, found: Place) -> Iterator[tuple[str, Place]]:
        """Yield the members of a structure or an instance by name."""
        if isinstance(found.type, BlockType):
            members = found.type.pou.members
        elif isinstance(found.type, StructType):
            members = found.type.members
        else:
            return
        for one in members.values():
            path = f"{found.path}.{one.name}"
            if one.storage is Storage.GLOBAL:
                location = self._global(path, one)
            else:
                at = found.address + one.offset
                location = Place(path, at, one.type, one.bit, found.is_of_call)
                if one.section is Section.IN_OUT and not self._word(at):
                    location = replace(location, type=PointerType(one.type.name, 8, 8, None))
                else:
                    location = self._handed_over(location, one)
            if location is not None:
                yield one.name, location

    def element(self, found: Place, indices: list[int]) -> Place | None:
        """Return an element of an array, or of a pointer's target."""
        found = self.referred(found)
        sought = found.type
        if isinstance(sought, PointerType) and sought.target is not None and len(indices) == 1:
            first = self.pointed(found)
            address = first.address + indices[0] * sought.target.size
            return replace(first, address=self._checked(found, address, sought.target))
        if not isinstance(sought, ArrayType) or len(indices) != len(sought.bounds):
            return None
        number = 0
        for index, (low, high) in zip(indices, sought.bounds, strict=True):
            if not low <= index <= high:
                return None
            number = number * (high - low + 1) + index - low
        path = f"{found.path}[{','.join(map(str, indices))}]"
        address = found.address + number * sought.element.size
        return replace(found, path=path, address=address, type=sought.element)

    def pointed(self, found: Place) -> Place:
        """Return the target of a pointer; raises ``Failure`` if it points to nothing."""
        sought = self.referred(found).type
        if not isinstance(sought, PointerType) or sought.target is None:
            raise self._unknown(f"{found.path}^")
        is_this = sought.name == "THIS"
        address = found.address if is_this else self._word(self.referred(found).address)
        at = self._checked(found, address, sought.target)
        return Place(f"{found.path}^", at, sought.target)

    def referred(self, found: Place) -> Place:
        """Return the target of a reference; anything else unchanged."""
        if not isinstance(found.type, ReferenceType):
            return found
        target = found.type.target
        address = self._checked(found, self._word(found.address), target)
        return replace(found, address=address, type=target, is_of_call=False)

    def instance(self, found: Place) -> Place:
        """Return the instance that a variable of an interface means."""
        address = self._checked(found, self._word(found.address), found.type)
        pou = self._blocks.get(self._word(address))
        if pou is None or pou.type is None:
            raise Failure(diagnostic(REFERS_TO_NOTHING, name=found.path))
        return replace(found, address=address, type=pou.type, is_of_call=False)

    def _word(self, address: int) -> int:
        return int.from_bytes(self.context.peek(address, 8), "little")

    def _checked(self, found: Place, address: int, sought: Type) -> int:
        """Return an address of the memory; raises ``Failure`` for another one (ST-315)."""
        if not kinds.NULL_BYTES <= address <= self.context.end - max(sought.size, 1):
            raise Failure(diagnostic(REFERS_TO_NOTHING, name=found.path))
        return address

    # --- back

    def path_of(self, address: int, sought: Type, bit: int = -1) -> str | None:
        """Return the global path of the variable at an address, ``None`` if there is none."""
        for path, location in self.roots():
            found = self._within(replace(location, path=path), address, sought, bit)
            if found is not None:
                return found
        return None

    def roots(self) -> Iterator[tuple[str, Place]]:
        """Yield programs and global variables by their paths."""
        for pou in self.program.pous.values():
            if pou.kind is Kind.PROGRAM and pou.type is not None:
                yield pou.name, Place(pou.name, kinds.NULL_BYTES + pou.instance, pou.type)
        for group in self.program.lists:
            prefix = f"{group.name}." if group.name else ""
            for one in group.variables.values():
                location = self._global(f"{prefix}{one.name}", one)
                if location is not None:
                    yield location.path, location

    def _within(self, found: Place, address: int, sought: Type, bit: int) -> str | None:
        if not found.address <= address < found.address + max(found.type.size, 1):
            return None
        if address == found.address and bit == found.bit and is_type(found.type, sought):
            return found.path
        if isinstance(found.type, ArrayType) and found.type.element.size:
            number, indices = (address - found.address) // found.type.element.size, []
            for low, high in reversed(found.type.bounds):
                number, index = divmod(number, high - low + 1)
                indices.append(index + low)
            element = self.element(found, indices[::-1])
            return None if element is None else self._within(element, address, sought, bit)
        for variable in _parts(found.type):
            at = found.address + variable.offset
            path = f"{found.path}.{variable.name}"
            location = Place(path, at, variable.type, variable.bit)
            inner = self._within(location, address, sought, bit)
            if inner is not None:
                return inner
        return None


def _has_members(sought: Type) -> bool:
    return isinstance(sought, BlockType | StructType | InterfaceType | ReferenceType)


def is_type(found: Type, sought: Type) -> bool:
    """Return whether a variable of a type may be used as another: a block as its bases."""
    if isinstance(found, BlockType) and isinstance(sought, BlockType):
        return sought.pou in found.pou.bases()
    return same_type(found, sought)


def _parts(sought: Type) -> list[Variable]:
    """Return the variables that lie in an instance or a structure."""
    members: dict[str, Variable] = {}
    if isinstance(sought, BlockType):
        members = sought.pou.members
    elif isinstance(sought, StructType):
        members = sought.members
    return [
        one
        for one in members.values()
        if one.section is not Section.IN_OUT and one.storage is not Storage.GLOBAL
    ]
