# SPDX-License-Identifier: MIT
"""The table of the interface: every element as the controller names it, with type and place.

In: the tables below ``hli/elements``, one row per element. Out: ``find`` for a path such as
``gpCh[0]^.bahn_state.program_end_r``, ``structure`` for a type with the offsets of its members,
``search`` and ``Element.leaves``. Names in Python, symbols of ADS, Structured Text, the reference
and ``nctakt explain`` come from here.

Structures are laid out as a PLC does it (ST-330): a member at a multiple of its size, of 8 bytes at
most, a structure at that of its largest member and filled up to it. The columns of
``interface.tsv``:

=============  ===================================================================================
``path``       from ``gpPform``, ``gpCh``, ``gpAx``, ``gpVECh`` or ``gpVEGlob`` on; ``[]`` counts
               channels or axes from 0, ``[0..11]`` elements of an array
``type``       elementary type, or a structure of ``structures.tsv``
``by``         who writes it: ``PLC``, ``CNC``, ``both``
``range``      numbers, a group of ``constants.tsv``, or what it needs
``handshake``  how a command is taken: by ``level``, by its ``edge``, with a ``semaphore`` …
``sure``       empty: named by a public source; ``inferred``: place or type was not seen; ``ours``:
               no source names it, the name is nctakt's own
``tie``        what it has to do with a run: ``Tie``; empty: known, without effect here
``en, de``     its meaning
=============  ===================================================================================

The members of a structure have the same columns. ``aliases.tsv``: names of the older generation,
whose indices count from 1.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Mapping
from functools import cache, lru_cache
from pathlib import Path

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import NOTHING, Text
from nctakt.base.failure import Failure
from nctakt.base.misspelling import nearest
from nctakt.messages import diagnostic
from nctakt.messages.plcs.hli_table import (
    COUNTED_FROM_ONE,
    INDEX_OUTSIDE_ARRAY,
    NO_INDEX_TAKEN,
    UNKNOWN_HLI_PATH,
)

_FOLDER = Path(__file__).parent / "elements"

#: Prefix of a path in PLC programs.
LIST_NAME = "HLI_Global_Variables."

#: Bytes of the elementary types.
ELEMENTARY: Mapping[str, int] = {
    "BOOL": 1,
    "BYTE": 1,
    "USINT": 1,
    "INT": 2,
    "UINT": 2,
    "WORD": 2,
    "DINT": 4,
    "UDINT": 4,
    "LREAL": 8,
}

#: The roots of paths, with their structures; empty: the V.E variables, which each machine declares.
ROOTS: Mapping[str, str] = {
    "gpPform": "HIGH_LEVEL_INTERFACE_PFORM",
    "gpCh": "HIGH_LEVEL_INTERFACE_CH",
    "gpAx": "HIGH_LEVEL_INTERFACE_AX",
    "gpVECh": "",
    "gpVEGlob": "",
}

#: Roots that are one pointer; the others have one for each channel or axis.
SINGLE_ROOTS = ("gpPform", "gpVEGlob")

_MAX_ALIGNMENT = 8
_STRING = re.compile(r"STRING\((\d+)\)")
_ARRAY = re.compile(r"ARRAY\[(\d+)\.\.(\d+)\] OF (.+)")
_SEGMENT = re.compile(r"(\w+)((?:\[[^\]]*\])*)(\^?)")
#: A dot between two names, and not within an index.
_DOT = re.compile(r"\.(?![^\[]*\])")
#: Number of paths whose elements are cached: all of the image, and those of PLCs and clients.
_KEPT_PATHS = 4096
_INDEXED_NAME = re.compile(r"(\w+)\[(\d+)\.\.(\d+)\]")
_TIE = re.compile(
    r"(?P<spindle>spindle )?(?:(?P<kind>acts|shows|fact|unserved) )?(?P<name>[A-Za-z_.][\w.]*)"
    r"(?: (?P<sign>==|!=|\*) (?P<number>-?\d+)| (?P<mapping>\{.*\}))?"
)

ACTS, SHOWS, KNOWN = "acts", "shows", "known"
#: Elements with their own state machine, which the session does not provide as values: technology
#: units, the operation mode manager, the error record, presence and releases of axes.
MANAGED = ("FUNCTIONS", "MODE", "ERROR", "PRESENT", "RELEASE")
#: The kind of tie of a value that the CNC shows on the machine, and nctakt does not have.
UNSERVED = "unserved"


@dataclass(frozen=True, slots=True)
class Tie:
    """The relation of an element to a run.

    ``kind``: ``acts``: what is written becomes the session's value ``name`` (``HLI.OVERRIDE``);
    ``shows``: it shows that value; ``fact``: it is a fact about the machine, such as ``logical``;
    ``unserved``: nctakt does not have the value, and 0 would be a false one.
    ``factor``: how many of its units one of the session's value is; ``equal``, ``unequal``: it is
    TRUE where the value is that number, or is not; ``numbers``: its number for each of the value.
    ``for_spindles``: it holds for the axes of spindles, and nothing for others.
    """

    kind: str
    name: str
    factor: int = 1
    equal: int | None = None
    unequal: int | None = None
    numbers: Mapping[int, int] | None = None
    for_spindles: bool = False

    def shown(self, value: float) -> float:
        """Return the number that shows a value of the session."""
        if self.equal is not None:
            return float(value == self.equal)
        if self.unequal is not None:
            return float(value != self.unequal)
        if self.numbers is not None:
            return float(self.numbers.get(int(value), 0))
        return value * self.factor

    def commanded(self, number: float) -> float:
        """Return the value of the session for a written number."""
        return number / self.factor

    def takes(self, number: float) -> bool:
        """Return whether a number is one that may be commanded."""
        return self.kind != ACTS or self.numbers is None or number in self.numbers.values()

    @property
    def taken(self) -> str:
        """The numbers that may be commanded, as a text; empty: all."""
        return ", ".join(map(str, (self.numbers or {}).values()))


@dataclass(frozen=True, slots=True)
class Row:
    """A row of the table: an element, or a member of a structure; see the module."""

    name: str
    type: str
    by: str
    unit: str
    range: str
    handshake: str
    sure: str
    tie: Tie | None
    meaning: Text


@dataclass(frozen=True, slots=True)
class DataType:
    """A type: elementary (also a text), an array of ``base`` from index ``low``, or a structure."""

    name: str
    size_bytes: int
    alignment: int
    base: DataType | None = None
    low: int = 0
    count: int = 0
    members: tuple[Member, ...] = ()

    @property
    def is_elementary(self) -> bool:
        """Whether it is a number or a text."""
        return self.base is None and not self.members

    @property
    def is_text(self) -> bool:
        """Whether it is a character string."""
        return self.name.startswith("STRING")

    @property
    def is_bytes(self) -> bool:
        """Whether it is an array of bytes, which has no parts."""
        return self.base is not None and self.base.name == "BYTE"

    def find(self, name: str) -> Member | None:
        """Return the member of this name, in any case; ``None`` without one."""
        lower = name.lower()
        return next((member for member in self.members if member.name.lower() == lower), None)


@dataclass(frozen=True, slots=True)
class Member:
    """A member of a structure; ``row``: its row of the table, ``None`` for an inner part."""

    name: str
    type: DataType
    offset: int
    row: Row | None = None


@dataclass(frozen=True, slots=True)
class Element:
    """An element at its place: ``offset`` from the pointer ``root[index]`` on, in bytes.

    ``indices``: those of arrays on the way. ``row``: that of the element or of the unit around it,
    ``inner``: that of the member of a structure, if it is one.
    """

    path: str
    root: str
    index: int
    offset: int
    type: DataType
    indices: tuple[int, ...]
    row: Row | None
    inner: Row | None = None

    @property
    def pattern(self) -> str:
        """The path without the numbers of channels, axes and elements."""
        return re.sub(r"\[\d+\]", "[]", self.path)

    @property
    def tie(self) -> Tie | None:
        """Its relation to a run: that of the member, else that of the unit around it."""
        for row in (self.inner, self.row):
            if row is not None and row.tie is not None:
                return row.tie
        return None

    @property
    def said(self) -> Row | None:
        """The row that says most about it."""
        return self.inner or self.row

    @property
    def name(self) -> str:
        """The last name of its path, without an index."""
        return self.path.rpartition(".")[2].partition("[")[0]

    @property
    def is_enable(self) -> bool:
        """Whether it is the switch of a control unit."""
        return self.name == "enable_w"

    @property
    def by(self) -> str:
        """Who writes it: ``PLC``, ``CNC``, ``both``."""
        return "both" if self.said is None else self.said.by

    @property
    def unit(self) -> str:
        """Its unit."""
        if self.inner is not None:
            is_value = self.row is not None and not self.inner.unit and not self.is_enable
            return self.row.unit if is_value and self.row is not None else self.inner.unit
        return "" if self.row is None else self.row.unit

    @property
    def effect(self) -> str:
        """``ACTS``, ``SHOWS`` or ``KNOWN``; of a structure what the most of its parts do."""
        if self.type.is_elementary or self.type.is_bytes:
            if self.tie is None or self.tie.kind == UNSERVED:
                return KNOWN
            return ACTS if self.tie.kind == ACTS and self.by != "CNC" else SHOWS
        effects = {leaf.effect for leaf in self.leaves()}
        return next(effect for effect in (ACTS, SHOWS, KNOWN) if effect in effects)

    def leaves(self) -> Iterator[Element]:
        """Yield the numbers, texts and arrays of bytes in it, in the order of their bytes."""
        if self.type.is_elementary or self.type.is_bytes:
            yield self
            return
        if self.type.base is not None:
            size = self.type.base.size_bytes
            for i in range(self.type.count):
                index = self.type.low + i
                yield from Element(
                    f"{self.path}[{index}]",
                    self.root,
                    self.index,
                    self.offset + i * size,
                    self.type.base,
                    (*self.indices, index),
                    self.row,
                    self.inner,
                ).leaves()
            return
        for member in self.type.members:
            yield from self.member(member).leaves()

    def member(self, member: Member) -> Element:
        """Return a member of a structure at its place."""
        row, inner = self.row, self.inner
        if row is None:
            row = member.row
        elif member.row is not None:
            inner = member.row
        return Element(
            f"{self.path}.{member.name}",
            self.root,
            self.index,
            self.offset + member.offset,
            member.type,
            self.indices,
            row,
            inner,
        )


@dataclass(frozen=True, slots=True)
class Constant:
    """A constant of the PLC's library; ``value``: ``None`` where no source has it."""

    group: str
    name: str
    value: int | None
    meaning: Text


@dataclass(frozen=True, slots=True)
class Block:
    """A function block of the PLC's library with its pins, each name and type."""

    name: str
    in_out: tuple[tuple[str, str], ...]
    inputs: tuple[tuple[str, str], ...]
    outputs: tuple[tuple[str, str], ...]
    meaning: Text


# --- reading ------------------------------------------------------------------------------------


def _lines(name: str) -> Iterator[dict[str, str]]:
    """Yield the rows of a table by the names of their columns."""
    lines = (_FOLDER / name).read_text("utf-8").splitlines()
    heading = lines[1].split("\t")
    for line in lines[2:]:
        yield dict(zip(heading, line.split("\t"), strict=True))


def _row(name: str, line: Mapping[str, str]) -> Row:
    return Row(
        name,
        line["type"],
        line["by"],
        line["unit"],
        line["range"],
        line.get("handshake", ""),
        line["sure"],
        read_tie(line["tie"]) if line["tie"] else None,
        Text(line["en"], line["de"]),
    )


def read_tie(text: str) -> Tie:
    """Return the tie of a text; raises ``ValueError`` for another text."""
    match = _TIE.fullmatch(text)
    if match is None:
        raise ValueError(text)
    number, sign = int(match["number"] or 1), match["sign"]
    return Tie(
        match["kind"] or SHOWS,
        match["name"],
        number if sign == "*" else 1,
        number if sign == "==" else None,
        number if sign == "!=" else None,
        ast.literal_eval(match["mapping"]) if match["mapping"] else None,
        bool(match["spindle"]),
    )


@cache
def rows() -> Mapping[str, Row]:
    """Return the elements of the interface by their paths, in the order of the table."""
    return {line["path"]: _row(line["path"], line) for line in _lines("interface.tsv")}


@cache
def _declared_structures() -> Mapping[str, Mapping[str, Row]]:
    found: dict[str, dict[str, Row]] = {}
    for line in _lines("structures.tsv"):
        found.setdefault(line["structure"], {})[line["member"]] = _row(line["member"], line)
    return found


@cache
def aliases() -> Mapping[str, str]:
    """Return the names of the older generation -> the paths of the same elements."""
    return {line["older"]: line["path"] for line in _lines("aliases.tsv")}


@cache
def constants() -> Mapping[str, Constant]:
    """Return the constants of the PLC's library by their names."""
    return {
        line["name"]: Constant(
            line["group"],
            line["name"],
            int(line["value"]) if line["value"] else None,
            Text(line["en"], line["de"]),
        )
        for line in _lines("constants.tsv")
    }


@cache
def blocks() -> Mapping[str, Block]:
    """Return the function blocks of the PLC's library by their names."""

    def pins(text: str) -> tuple[tuple[str, str], ...]:
        pairs = (pin.split(" ") for pin in text.split(", ") if pin)
        return tuple((name, type_) for name, type_ in pairs)

    return {
        line["block"]: Block(
            line["block"],
            pins(line["in_out"]),
            pins(line["in"]),
            pins(line["out"]),
            Text(line["en"], line["de"]),
        )
        for line in _lines("blocks.tsv")
    }


# --- types --------------------------------------------------------------------------------------


@cache
def type_of(name: str) -> DataType:
    """Return an elementary type, an array or a structure; raises ``KeyError``."""
    if name in ELEMENTARY:
        return DataType(name, ELEMENTARY[name], ELEMENTARY[name])
    if match := _STRING.fullmatch(name):
        return DataType(name, int(match[1]) + 1, 1)
    if match := _ARRAY.fullmatch(name):
        return _array(type_of(match[3]), int(match[1]), int(match[2]))
    return structure(name)


@cache
def structure(name: str) -> DataType:
    """Return a structure by its name; raises ``KeyError`` for an unknown one."""
    if name in ROOTS.values():
        return _root(next(root for root, other in ROOTS.items() if other == name))
    members = _declared_structures()[name]
    return _structure(name, [(row.name, type_of(row.type), row) for row in members.values()])


def structures() -> Iterator[DataType]:
    """Yield all structures: those of the pointers, their parts, those that the table declares."""
    seen: dict[str, DataType] = {}

    def note(type_: DataType) -> None:
        if type_.base is not None:
            note(type_.base)
        for member in type_.members:
            note(member.type)
        if type_.members:
            seen.setdefault(type_.name, type_)

    for name in (*filter(None, ROOTS.values()), *_declared_structures()):
        note(structure(name))
    yield from seen.values()


def _array(base: DataType, low: int, high: int) -> DataType:
    count = high - low + 1
    name = f"ARRAY[{low}..{high}] OF {base.name}"
    return DataType(name, count * base.size_bytes, base.alignment, base, low, count)


def _structure(name: str, parts: list[tuple[str, DataType, Row | None]]) -> DataType:
    members = []
    end, alignment = 0, 1
    for part, type_, row in parts:
        step = min(type_.alignment, _MAX_ALIGNMENT)
        offset = -(-end // step) * step
        members.append(Member(part, type_, offset, row))
        end = offset + type_.size_bytes
        alignment = max(alignment, step)
    size = -(-end // alignment) * alignment
    return DataType(name, size, alignment, members=tuple(members))


def _root(root: str) -> DataType:
    """Return the structure that a pointer leads to."""
    paths = [
        (_DOT.split(path.partition("^.")[2]), row)
        for path, row in rows().items()
        if path.partition("^")[0].partition("[")[0] == root
    ]
    return _part(ROOTS[root], paths)


def _part(name: str, paths: list[tuple[list[str], Row]]) -> DataType:
    """Return the structure of paths that begin at the same place."""
    groups: dict[str, list[tuple[list[str], Row]]] = {}
    for segments, row in paths:
        groups.setdefault(segments[0], []).append((segments[1:], row))
    parts: list[tuple[str, DataType, Row | None]] = []
    for segment, inner in groups.items():
        match = _INDEXED_NAME.fullmatch(segment)
        plain = match[1] if match else segment
        said = None if inner[0][0] else inner[0][1]
        short = name.replace("HIGH_LEVEL_INTERFACE", "HLI")
        type_ = _part(f"{short}_{plain.upper()}", inner) if said is None else type_of(said.type)
        if match:
            type_ = _array(type_, int(match[2]), int(match[3]))
        parts.append((plain, type_, said))
    return _structure(name, parts)


# --- finding ------------------------------------------------------------------------------------


@cache
def root(name: str, index: int = 0) -> Element:
    """Return the target of a pointer: all of a channel, an axis or the platform.

    Raises ``KeyError`` for a name that is not in ``ROOTS``.
    """
    path = f"{name}^" if name in SINGLE_ROOTS else f"{name}[{index}]^"
    if ROOTS[name]:
        return Element(path, name, index, 0, structure(ROOTS[name]), (), None)
    row = rows()[path.replace(f"[{index}]", "[]")]  # V.E, as single numbers
    return Element(path, name, index, 0, type_of(row.type), (), row)


@lru_cache(_KEPT_PATHS)
def find(path: str) -> Element:
    """Return the element of a path, in any case, with or without ``HLI_Global_Variables.``.

    Names of the older generation are found, too. Missing indices are the first ones: as in
    ``gpCh^.head.plc_present_w``. Raises ``Failure`` for an unknown path (902100), with the nearest
    one, and for an index that the array does not have (902101, 902102, 902854).
    """
    return _find(_modern(_plain(path), path), path)


def _plain(path: str) -> str:
    text = "".join(path.split())
    return text[len(LIST_NAME) :] if text.lower().startswith(LIST_NAME.lower()) else text


def _modern(text: str, asked: str) -> str:
    """Return a path of the older generation as the present one; any other unchanged."""
    bare = re.sub(r"\[[^\]]*\]", "[]", text).lower()
    for older, path in aliases().items():
        low = older.lower()
        if bare != low and not bare.startswith((f"{low}.", f"{low}[")):
            continue
        first = 0 if older.startswith("gp") else 1  # the older generation counts from 1
        numbers = iter(re.findall(r"\[(\d+)\]", text))
        count = len(re.findall(r"\[\]", older))
        given = [int(number) - first for number, _ in zip(numbers, range(count), strict=False)]
        if any(number < 0 for number in given):
            raise Failure(diagnostic(COUNTED_FROM_ONE, path=asked))
        present = path
        for number in given:
            present = present.replace("[]", f"[{number}]", 1)
        rest = bare[len(low) :]
        return present + (text[-len(rest) :] if rest else "")
    return text


def _find(text: str, asked: str) -> Element:
    segments = _DOT.split(text)
    match = _SEGMENT.fullmatch(segments[0])
    by_lower = {name.lower(): name for name in ROOTS}
    if match is None or match[1].lower() not in by_lower:
        raise _unknown(asked, segments[0], list(ROOTS))
    name, numbers = by_lower[match[1].lower()], _numbers(match[2], asked)
    if len(numbers) > (name not in SINGLE_ROOTS):
        raise Failure(diagnostic(NO_INDEX_TAKEN, path=asked, name=name))
    found = root(name, numbers[0] if numbers else 0)
    for segment in segments[1:]:
        found = _step(found, segment, asked)
    return found


def _step(found: Element, segment: str, asked: str) -> Element:
    match = _SEGMENT.fullmatch(segment)
    if found.type.base is not None:
        found = _element_at(found, found.type.low, asked)
    member = None if match is None else found.type.find(match[1])
    if match is None or member is None:
        raise _unknown(asked, segment, [other.name for other in found.type.members], found)
    found = found.member(member)
    for number in _numbers(match[2], asked):
        found = _element_at(found, number, asked)
    return found


def _numbers(text: str, asked: str) -> list[int]:
    numbers = re.findall(r"\[([^\]]*)\]", text)
    wrong = [number for number in numbers if number and not number.isdecimal()]
    if wrong:
        raise Failure(diagnostic(UNKNOWN_HLI_PATH, path=asked, part=wrong[0], nearest=NOTHING))
    return [int(number) for number in numbers if number]


def _element_at(found: Element, index: int, asked: str) -> Element:
    """Return an element of an array; raises ``Failure``."""
    type_ = found.type
    if type_.base is None:
        raise Failure(diagnostic(NO_INDEX_TAKEN, path=asked, name=found.name))
    if not type_.low <= index < type_.low + type_.count:
        high = type_.low + type_.count - 1
        raise Failure(
            diagnostic(INDEX_OUTSIDE_ARRAY, path=asked, index=index, low=type_.low, high=high)
        )
    return Element(
        f"{found.path}[{index}]",
        found.root,
        found.index,
        found.offset + (index - type_.low) * type_.base.size_bytes,
        type_.base,
        (*found.indices, index),
        found.row,
        found.inner,
    )


def _unknown(asked: str, part: str, names: list[str], found: Element | None = None) -> Failure:
    plain = part.partition("[")[0].rstrip("^")
    near = nearest(plain, names)
    if near and found is not None:
        near = f"{found.path}.{near}"
    if not near:
        others = [path for path in patterns() if path.rpartition(".")[2].lower() == plain.lower()]
        near = others[0] if len(others) == 1 else nearest(_bare(asked), patterns())
    return Failure(diagnostic(UNKNOWN_HLI_PATH, path=asked, part=part, nearest=near or NOTHING))


def _bare(path: str) -> str:
    return re.sub(r"\[[^\]]*\]", "[]", _plain(path))


@cache
def patterns() -> Mapping[str, Element]:
    """Return all elements, structures and their members by their paths without numbers."""
    found: dict[str, Element] = {}

    def note(element: Element) -> None:
        base = element.type.base
        if base is not None:
            first = element.type.low
            note(
                Element(
                    f"{element.path}[{first}]",
                    element.root,
                    element.index,
                    element.offset,
                    base,
                    (*element.indices, first),
                    element.row,
                    element.inner,
                )
            )
            return
        found.setdefault(element.pattern, element)
        for member in element.type.members:
            note(element.member(member))

    for name in ROOTS:
        note(root(name))
    return found


def search(text: str) -> list[Element]:
    """Return the elements whose path has these letters in it, in any case."""
    phrase = _bare(text).lower()
    return [element for path, element in patterns().items() if phrase in path.lower()]


def continuations(text: str) -> list[Element]:
    """Return completions after the last dot of a partial path; none for an unknown one.

    Without a dot: the names of the pointers.
    """
    head, dot, _ = _plain(text).rpartition(".")
    if not dot:
        return [root(name) for name in ROOTS]
    try:
        found = find(head)
    except Failure:
        return []
    while found.type.base is not None:
        found = _element_at(found, found.type.low, head)
    return [found.member(member) for member in found.type.members]
