# SPDX-License-Identifier: MIT
"""Which fields of the realtime part are its state: read from the ``.pxd`` files.

In: the C types of ``kernel/``. Out: for each class the fields that a copy of its objects has, and
the arrays whose memory is kept; and the source of the compiled module that copies them, which a
build writes. Imports nothing of nctakt, since a build runs it, too.

Numbers are state, all of them: to copy one that never changes is not wrong. A field that refers to
something is state only where it is named here. The content of arrays is state unless it is written
before it is read again.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

#: Fields that refer to something else later than at first: arrays that grow or are exchanged, and
#: what a cycle manager has loaded.
REFERENCES = {
    "ArcLimits": ("max_a", "max_v"),
    "CommandQueue": ("rows",),
    "CycleManager": ("loaded", "root"),
    "CyclicTask": ("body",),
    "Kernel": ("input_cells", "input_values", "input_words"),
    "KinematicMaps": ("values",),
    "LoopBody": ("rows",),
    "PlcCalls": ("delays", "hli", "spindles", "whens"),
    "Record": ("events", "probes", "rows", "signals"),
    "TransformedLimits": (
        "axis_a", "axis_j", "max_v", "rapid_v", "transformations",
    ),
    "When": ("others",),
}  # fmt: skip
#: Arrays of which nothing is read before it is written again. Of the path's history only the rows
#: of segments that have begun count: ``Path.history`` has them.
UNREAD = {
    "Kernel": ("input_slots",),
    "Notes": ("numbers", "reals", "values"),
    "PathAxes": ("history_rows",),
    "Record": ("events", "probes", "rows"),
}
#: Where expressions and statements of cycles are: they do not change, except these.
TREES = ("nctakt.kernel.cycles.", "nctakt.kernel.st.")
CHANGING_IN_TREES = (
    "AxisReleases", "ChannelRecords", "CncInterface", "Combination", "Condition", "Connection",
    "Context", "ControlUnits", "Counted", "CycleManager", "CyclicTask", "FeedMemory", "IfAlways",
    "IfEdge", "IfOnce", "Notes", "PlcContext", "PlcSide", "PlcTasks", "Reaction",
    "RealtimeCycle", "SectionSource", "SpindleSource", "UnitBanks",
)  # fmt: skip
#: What no snapshot is taken of: a shared image, what stops the ticks, and what a debugger wants of
#: a PLC's statements.
LEFT_OUT = (
    "InterfaceImage", "Probe", "SectionUnits", "Sought", "SoughtStatement", "SpindleUnits",
    "StatementCounter", "Watched",
)  # fmt: skip
LEFT_OUT_MODULE = "nctakt.kernel.tick.stops"

#: C types of fields that hold a number.
NUMBERS = ("Py_ssize_t", "bint", "double", "int", "long long")
#: A line of a ``.pxd`` that declares fields.
_FIELD = re.compile(
    r"    cdef (?P<access>readonly |public |)(?P<kind>[\w.\[\]: ]+?) (?P<names>\w+(?:, \w+)*)"
)


class FieldType(NamedTuple):
    """The C type of a field, and whether Python may assign it."""

    kind: str
    is_public: bool


class TypedClass(NamedTuple):
    """A class of the realtime part with the fields that its ``.pxd`` declares."""

    module: str
    name: str
    #: Module and name of the class that it derives from.
    base: tuple[str, str] | None
    fields: dict[str, FieldType]

    @property
    def is_kept(self) -> bool:
        """Whether a snapshot has state of this class."""
        if self.name in LEFT_OUT or self.module == LEFT_OUT_MODULE:
            return False
        return not self.module.startswith(TREES) or self.name in CHANGING_IN_TREES

    @property
    def copied(self) -> list[str]:
        """Return the fields that a copy has, in the order of their declaration."""
        references = REFERENCES.get(self.name, ())
        return [
            name
            for name, found in self.fields.items()
            if self.is_kept and (found.kind in NUMBERS or name in references)
        ]

    @property
    def arrays(self) -> list[str]:
        """Return the fields that hold an array whose content is kept."""
        unread = UNREAD.get(self.name, ())
        return [
            name
            for name, found in self.fields.items()
            if self.is_kept and found.kind.endswith("[::1]") and name not in unread
        ]

    @property
    def exchanged(self) -> list[str]:
        """Return the arrays of these that others may take the place of."""
        return [name for name in self.arrays if name in REFERENCES.get(self.name, ())]


#: What keeps the content of arrays, in the compiled module: one block of memory for all of them.
ARRAY_COPIES = """
from cpython.buffer cimport PyBUF_WRITABLE, PyBuffer_Release, PyObject_GetBuffer
from libc.stdlib cimport free, malloc
from libc.string cimport memcpy

cdef class ArrayCopies:
    cdef Py_buffer* live
    cdef char* kept
    cdef Py_ssize_t count
    def __init__(self, list arrays):
        cdef Py_ssize_t size = 0
        if self.live:
            raise TypeError("the arrays are given once")
        self.live = <Py_buffer*>malloc((len(arrays) + 1) * sizeof(Py_buffer))
        if not self.live:
            raise MemoryError
        for array in arrays:
            PyObject_GetBuffer(array, &self.live[self.count], PyBUF_WRITABLE)
            size += self.live[self.count].len
            self.count += 1
        self.kept = <char*>malloc(size + 1)
        if not self.kept:
            raise MemoryError
        self.take()
    def __dealloc__(self):
        for i in range(self.count):
            PyBuffer_Release(&self.live[i])
        free(self.live)
        free(self.kept)
    def take(self):
        cdef char* kept = self.kept
        cdef Py_ssize_t i
        for i in range(self.count):
            memcpy(kept, self.live[i].buf, self.live[i].len)
            kept += self.live[i].len
    def put_back(self):
        cdef char* kept = self.kept
        cdef Py_ssize_t i
        for i in range(self.count):
            memcpy(self.live[i].buf, kept, self.live[i].len)
            kept += self.live[i].len
"""


def typed_classes(kernel: Path) -> Iterator[TypedClass]:
    """Yield the classes that the ``.pxd`` files of the folder ``kernel`` declare, by module."""
    for file in sorted(kernel.rglob("*.pxd")):
        module = ".".join(file.relative_to(kernel.parent.parent).with_suffix("").parts)
        origins: dict[str, str] = {}
        found: TypedClass | None = None
        for line in file.read_text("utf-8").splitlines():
            words = line.split()
            if line.startswith("from") and "cimport" in words:
                origins |= dict.fromkeys("".join(words[3:]).split(","), words[1])
            elif line.startswith("cdef class"):
                if found is not None:
                    yield found
                name, _, base = line.removeprefix("cdef class ").rstrip("):").partition("(")
                origin = (origins.get(base, module), base) if base else None
                found = TypedClass(module, name, origin, {})
            elif found is not None and (match := _FIELD.fullmatch(line)) is not None:
                for name in match["names"].split(", "):
                    found.fields[name] = FieldType(match["kind"], match["access"] == "public ")
        if found is not None:
            yield found


def compiled_source(kernel: Path) -> str:
    """Return the source of the compiled module: ``COPIERS``, ``ARRAYS``, ``SAME`` by class."""
    kept = [found for found in typed_classes(kernel) if found.copied or found.arrays]
    lines = ["# Written by a build from the C types of the realtime part."]
    lines += ["cimport cython"]
    lines += [f"from {found.module} cimport {found.name}" for found in kept]
    for found in kept:
        lines += [f"def copy_{found.name}({found.name} source, {found.name} target):", "    pass"]
        for name in found.copied:
            is_list = found.fields[name].kind == "list"
            value = f"list(source.{name})" if is_list else f"source.{name}"
            lines.append(f"    target.{name} = {value}")
        items = "".join(f"part.{name}, " for name in found.arrays)
        lines += [f"def arrays_of_{found.name}({found.name} part):", f"    return ({items})"]
        if found.exchanged:
            same = " and ".join(f"&one.{name}[0] == &other.{name}[0]" for name in found.exchanged)
            lines += ["@cython.boundscheck(False)"]
            lines += [f"def same_{found.name}({found.name} one, {found.name} other):"]
            lines += [f"    return {same}"]
    copiers = "".join(f"{one.name}: copy_{one.name}, " for one in kept if one.copied)
    arrays = "".join(f"{one.name}: arrays_of_{one.name}, " for one in kept if one.arrays)
    same = "".join(f"{one.name}: same_{one.name}, " for one in kept if one.exchanged)
    lines += [f"COPIERS = {{{copiers}}}", f"ARRAYS = {{{arrays}}}", f"SAME = {{{same}}}"]
    lines += [ARRAY_COPIES]
    return "\n".join(lines)
