# SPDX-License-Identifier: MIT
"""Resolved types, variables and POUs: the meaning of names in a PLC program, and their layout.

All data are bytes (ST-001, ST-330). A type has ``size`` and ``align`` in bytes; a member has its
``offset`` from the begin of its structure or instance. Pointers, references and variables of
interface types are 64-bit numbers, null is 0. The checker makes these objects; the runtime reads
them. ``Type`` objects are compared by ``same_type``, not by identity.

A block's instance begins with eight bytes: the number of its type (``Pou.number``, from 1), by
which virtual calls find their method. Then come the members of its base, its own members, and the
VAR_INST of its methods. A frame (function, method, VAR_TEMP of a body) begins at 0 and is aligned
to 8.
"""

from __future__ import annotations

import enum
import math
from collections.abc import Iterator

from nctakt.base.dataclass import dataclass, field

#: Bytes of a pointer, reference or variable of an interface type; of the head of an instance.
POINTER_SIZE = 8
#: The largest alignment of a member (ST-330).
MAX_ALIGN = 8
#: Length of a STRING whose declaration names none.
DEFAULT_LENGTH = 80


# --- positions, and values -----------------------------------------------------------------------


@dataclass(slots=True, eq=False)
class Node:
    """A part of the text; ``start`` and ``end`` are positions of ``Sources`` (``sources.py``)."""

    start: int
    end: int


#: A constant: BOOL, whole numbers (TIME in ms, LTIME in ns, dates as stored), reals; the bytes of a
#: STRING without the closing 0 (of a WSTRING in UTF-16, little-endian).
Value = bool | int | float | bytes


@dataclass(slots=True, eq=False)
class Expression(Node):
    """A node with a value; ``type`` is set by the checker, ``None`` after a mistake.

    ``value``: the value if it is constant. Whole numbers and reals of a constant fit ``type``.
    """

    type: Type | None = field(default=None, kw_only=True)
    value: Value | None = field(default=None, kw_only=True)


@dataclass(slots=True, eq=False)
class Statement(Node):
    """A statement of a body."""


# --- types ---------------------------------------------------------------------------------------


class Family(enum.Enum):
    """Kinds of elementary types."""

    BOOL = "BOOL"
    BITS = "BITS"  # BYTE, WORD, DWORD, LWORD: unsigned
    UNSIGNED = "UNSIGNED"
    SIGNED = "SIGNED"
    REAL = "REAL"
    DURATION = "DURATION"  # TIME in ms, LTIME in ns
    DATE = "DATE"  # DATE and DT in s since 1970-01-01, TOD in ms


@dataclass(slots=True, eq=False)
class Type:
    """A type; ``name`` as messages show it."""

    name: str
    size: int
    align: int


@dataclass(slots=True, eq=False)
class Elementary(Type):
    """An elementary type with its range; of a subrange, ``low`` and ``high`` are narrower.

    ``bit``: a BIT member of a structure, whose ``Variable.bit`` names the bit of its byte.
    """

    family: Family
    low: int = 0
    high: int = 0
    is_subrange: bool = False
    is_bit: bool = False

    @property
    def is_signed(self) -> bool:
        """Whether a load extends the sign."""
        return self.family is Family.SIGNED


@dataclass(slots=True, eq=False)
class StringType(Type):
    """STRING(length) or WSTRING(length): size is length + 1 units of 1 or 2 bytes."""

    length: int
    is_wide: bool = False


@dataclass(slots=True, eq=False)
class EnumType(Type):
    """An enumeration; loads and stores are those of ``base``."""

    base: Elementary
    values: dict[str, EnumValue] = field(default_factory=dict)  # by the name in lower case
    initial: int = 0
    is_strict: bool = False
    is_qualified_only: bool = False
    has_text: bool = False  # to_string: TO_STRING gives the name


@dataclass(slots=True, eq=False)
class EnumValue:
    """A value of an enumeration."""

    name: str
    number: int
    type: EnumType


@dataclass(slots=True, eq=False)
class ArrayType(Type):
    """An array: bounds of each dimension, row-major; ``bounds`` is empty for ARRAY[*].

    ARRAY[*] (``dimensions`` stars) is only the type of a VAR_IN_OUT: there the slot holds the
    address of the data, then low and high bound of each dimension as DINT.
    """

    element: Type
    bounds: tuple[tuple[int, int], ...]
    dimensions: int

    @property
    def is_open(self) -> bool:
        """Whether it is ARRAY[*]."""
        return not self.bounds

    @property
    def innermost(self) -> Type:
        """The type of the elements, of an array of arrays that of the innermost one."""
        element = self.element
        return element.innermost if isinstance(element, ArrayType) else element

    @property
    def element_count(self) -> int:
        """The number of elements, of an array of arrays that of all innermost ones."""
        count = math.prod(max(high - low + 1, 0) for low, high in self.bounds)
        element = self.element
        return count * (element.element_count if isinstance(element, ArrayType) else 1)


@dataclass(slots=True, eq=False)
class StructType(Type):
    """A structure or union; ``members`` has those of ``base`` first, in order of their offsets."""

    base: StructType | None = None
    members: dict[str, Variable] = field(default_factory=dict)  # by the name in lower case
    is_union: bool = False
    #: A structure of the interface between CNC and PLC, or of a library: it has no source here.
    is_native: bool = False


@dataclass(slots=True, eq=False)
class PointerType(Type):
    """POINTER TO target; PVOID without a target."""

    target: Type | None


@dataclass(slots=True, eq=False)
class ReferenceType(Type):
    """REFERENCE TO target."""

    target: Type


@dataclass(slots=True, eq=False)
class InterfaceType(Type):
    """An interface; a variable of it holds the address of an instance, or 0."""

    bases: list[InterfaceType] = field(default_factory=list)
    methods: dict[str, Method] = field(default_factory=dict)
    properties: dict[str, Property] = field(default_factory=dict)


@dataclass(slots=True, eq=False)
class AnyType(Type):
    """ANY, ANY_NUM … of a VAR_INPUT: TypeClass, pValue and diSize, as ``form`` has them."""

    form: StructType


@dataclass(slots=True, eq=False)
class BlockType(Type):
    """A function block or program as a type: the layout of its instances."""

    pou: Pou


def same_type(first: Type | None, second: Type | None) -> bool:
    """Return whether two types are the same: declared types by identity, others by structure."""
    if first is second or first is None or second is None:
        return first is second
    if type(first) is not type(second):
        return False
    match first, second:
        case PointerType(), PointerType():
            return same_type(first.target, second.target)
        case ReferenceType(), ReferenceType():
            return same_type(first.target, second.target)
        case (ArrayType(), ArrayType()):
            return (first.bounds, first.dimensions) == (
                second.bounds,
                second.dimensions,
            ) and same_type(first.element, second.element)
        case (StringType(), StringType()):
            return (first.length, first.is_wide) == (second.length, second.is_wide)
        case (Elementary(), Elementary()):
            return (first.family, first.size, first.is_bit) == (
                second.family,
                second.size,
                second.is_bit,
            )
    return False


# --- variables -----------------------------------------------------------------------------------


class Storage(enum.Enum):
    """Where a variable is, and from where its ``offset`` counts."""

    GLOBAL = "global"  # from the begin of the data area: VAR_GLOBAL, VAR_STAT
    INSTANCE = "instance"  # from the begin of the instance (THIS): VAR, inputs, outputs, VAR_INST
    FRAME = "frame"  # from the begin of the call's frame: all of functions and methods, VAR_TEMP
    MEMBER = "member"  # from the begin of the structure


class Section(enum.Enum):
    """The keyword of a variable's declaration."""

    VAR = "VAR"
    INPUT = "VAR_INPUT"
    OUTPUT = "VAR_OUTPUT"
    IN_OUT = "VAR_IN_OUT"  # its eight bytes hold the address of the argument
    TEMP = "VAR_TEMP"
    STAT = "VAR_STAT"
    INST = "VAR_INST"
    GLOBAL = "VAR_GLOBAL"
    EXTERNAL = "VAR_EXTERNAL"
    MEMBER = "STRUCT"
    RESULT = "result"  # of a function, method or Get; the value of a property in Set


@dataclass(slots=True, eq=False)
class Variable:
    """A variable, parameter or member of a structure.

    ``initial``: its expression, ``None`` for that of its type. ``arguments``: those of FB_init,
    ``(name or "", expression)``, one group for all instances or one for each element of an array.
    ``value``: the value of a scalar constant. ``bit``: the number of a BIT member in its byte, else
    −1. ``address``: ``%I*`` …, or "". ``start``: the position of its name. ``owner``: the POU,
    method, list or structure, as messages show it. ``attributes``: by name in lower case.
    """

    name: str
    type: Type
    section: Section
    storage: Storage
    offset: int = 0
    initial: Expression | None = None
    arguments: list[list[tuple[str, Expression]]] = field(default_factory=list)
    value: Value | None = None
    bit: int = -1
    address: str = ""
    start: int = 0
    owner: str = ""
    is_constant: bool = False
    is_retain: bool = False
    is_persistent: bool = False
    attributes: dict[str, str] = field(default_factory=dict)


# --- POUs ----------------------------------------------------------------------------------------


class Access(enum.Enum):
    """Who may use a member."""

    PUBLIC = "PUBLIC"
    PRIVATE = "PRIVATE"
    PROTECTED = "PROTECTED"
    INTERNAL = "INTERNAL"


@dataclass(slots=True, eq=False)
class Callable:
    """A callable: a function, a method, an accessor of a property, a body, an action.

    ``inputs``, ``outputs``, ``in_outs`` are in order of declaration (those of a base first);
    ``parameters`` has all of them in that order, for positional arguments. ``frame_size`` includes
    ``result`` and all variables with ``Storage.FRAME``. ``is_native``: it has no body here; the
    runtime knows it by ``path``. ``body`` is empty then.
    """

    name: str
    path: str  # "MAIN", "FB_Pump.Cycle", "FB_Pump.Name.Get", "FB_Pump.Start" (action)
    result: Variable | None = None
    variables: dict[str, Variable] = field(default_factory=dict)  # its own, by lower-case name
    parameters: list[Variable] = field(default_factory=list)
    frame_size: int = 0
    body: list[Statement] = field(default_factory=list)
    is_native: bool = False
    start: int = 0

    @property
    def inputs(self) -> list[Variable]:
        """The VAR_INPUT."""
        return [one for one in self.parameters if one.section is Section.INPUT]

    @property
    def outputs(self) -> list[Variable]:
        """The VAR_OUTPUT."""
        return [one for one in self.parameters if one.section is Section.OUTPUT]

    @property
    def in_outs(self) -> list[Variable]:
        """The VAR_IN_OUT."""
        return [one for one in self.parameters if one.section is Section.IN_OUT]


@dataclass(slots=True, eq=False)
class Method(Callable):
    """A method, action (no parameters) or accessor; ``owner`` is ``None`` in an interface.

    A call not by SUPER^ uses the method of this name of the instance's type (``Pou.find_method``).
    """

    owner: Pou | None = None
    access: Access = Access.PUBLIC
    is_abstract: bool = False
    is_final: bool = False
    is_action: bool = False
    attributes: dict[str, str] = field(default_factory=dict)


@dataclass(slots=True, eq=False)
class Property:
    """A property: its accessors are methods named ``Name.Get`` and ``Name.Set``."""

    name: str
    type: Type
    get: Method | None = None
    set: Method | None = None
    owner: Pou | None = None
    access: Access = Access.PUBLIC
    start: int = 0


class Kind(enum.Enum):
    """The kind of a POU."""

    PROGRAM = "PROGRAM"
    FUNCTION_BLOCK = "FUNCTION_BLOCK"
    FUNCTION = "FUNCTION"


@dataclass(slots=True, eq=False)
class Pou(Callable):
    """A program, function block or function.

    ``number`` counts blocks and programs from 1: the head of their instances. ``type`` is the
    layout of the instance (``None`` for functions); ``instance`` the offset of a program's only
    instance in the data area. ``methods`` has actions, too; accessors are in ``properties``.
    ``members`` has all variables of the instance: those of the bases first.
    """

    kind: Kind = Kind.PROGRAM
    number: int = 0
    type: BlockType | None = None
    instance: int = 0
    base: Pou | None = None
    interfaces: list[InterfaceType] = field(default_factory=list)
    members: dict[str, Variable] = field(default_factory=dict)
    methods: dict[str, Method] = field(default_factory=dict)
    properties: dict[str, Property] = field(default_factory=dict)
    access: Access = Access.PUBLIC
    is_abstract: bool = False
    is_final: bool = False
    library: str = ""  # the name of the library, "" for the project's own
    #: The implementation is graphical (ST-104) or has errors: it must not run.
    is_refused: bool = False
    attributes: dict[str, str] = field(default_factory=dict)

    def bases(self) -> Iterator[Pou]:
        """Yield itself and its bases, the nearest first."""
        pou: Pou | None = self
        while pou is not None:
            yield pou
            pou = pou.base

    def find_method(self, name: str) -> Method | None:
        """Return the method or action of a lower-case name, its own or that of the nearest base."""
        for pou in self.bases():
            if name in pou.methods:
                return pou.methods[name]
        return None

    def find_property(self, name: str) -> Property | None:
        """Return the property of a lower-case name, its own or that of the nearest base."""
        for pou in self.bases():
            if name in pou.properties:
                return pou.properties[name]
        return None
