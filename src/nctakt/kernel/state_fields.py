# SPDX-License-Identifier: MIT
"""Which fields of the realtime part are its state: read from the ``.pxd`` files.

In: the C types of ``kernel/``. Out: for each class the fields that a copy of its objects has, and
the arrays whose memory is kept; and the source of the compiled module that copies them, which a
build writes. Imports nothing of nctakt, since a build runs it, too.

Numbers are state, all of them: it does no harm to copy one that never changes. A field that refers
to an object is state only if it is named here. The content of arrays is state unless it is written
before it is read again.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

#: Fields whose reference changes: arrays that grow or are exchanged, and the cycles that a cycle
#: manager has loaded.
REFERENCES = {
    "ArcLimits": ("max_a", "max_v"),
    "CommandQueue": ("rows",),
    "CycleManager": ("loaded", "root"),
    "CyclicTask": ("body",),
    "KinematicMaps": ("values",),
    "LoopBody": ("rows",),
    "PlcCalls": ("delays", "hli", "spindles", "whens"),
    "PostedValues": ("cells", "values", "words"),
    "Record": ("events", "probes", "rows", "signals"),
    "TransformedLimits": (
        "axis_a", "axis_j", "max_v", "rapid_v", "transformations",
    ),
    "When": ("others",),
}  # fmt: skip
#: Arrays of which nothing is read before it is written again. Of the path's history only the rows
#: of segments that have begun count, of the queue those that were ever written: ``Path.history``
#: and ``CommandQueue.used_rows`` have them.
UNREAD = {
    "CommandQueue": ("rows",),
    "Notes": ("numbers", "reals", "values"),
    "PathAxes": ("history_rows",),
    "PostedValues": ("slots",),
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
#: Not part of a snapshot: a shared image, the stops of the ticks, and a debugger's probes of a
#: PLC's statements.
LEFT_OUT = (
    "ImageBytes", "ImageTable", "InterfaceImage", "NumberBytes", "Probe", "RefusedValues",
    "SectionUnits", "Sought", "SoughtStatement", "SpindleUnits", "StatementCounter", "Watched",
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


#: The begin of the compiled module.
HEAD = """# Written by a build from the C types of the realtime part.
cimport cython
from cpython.buffer cimport PyBUF_WRITABLE, PyBuffer_Release, PyObject_GetBuffer
from libc.stdlib cimport free, malloc
from libc.string cimport memcpy
ctypedef int (*Copier)(object, object) except -1
ctypedef int (*Comparison)(object, object) except -1"""
#: Code of the compiled module that copies objects and keeps the content of arrays, in one block of
#: memory for all.
COPIES = """
cdef class ObjectCopies:
    cdef list live
    cdef list kept
    cdef Copier* copiers
    cdef Comparison* comparisons
    def __init__(self, list parts):
        cdef Py_ssize_t i
        if self.copiers:
            raise TypeError("the objects are given once")
        pairs = []
        for part in parts:
            kept = type(part).__new__(type(part))
            for cls in type(part).__mro__:
                if cls in COPIED:
                    pairs.append((part, kept, COPIED[cls], EXCHANGED.get(cls, 0)))
        self.live = [part for part, _, _, _ in pairs]
        self.kept = [kept for _, kept, _, _ in pairs]
        self.copiers = <Copier*>malloc((len(pairs) + 1) * sizeof(Copier))
        self.comparisons = <Comparison*>malloc((len(pairs) + 1) * sizeof(Comparison))
        if not self.copiers or not self.comparisons:
            raise MemoryError
        for i in range(len(pairs)):
            self.copiers[i] = _copiers[<Py_ssize_t>pairs[i][2]]
            self.comparisons[i] = _comparisons[<Py_ssize_t>pairs[i][3]]
        self.take()
    def __dealloc__(self):
        free(self.copiers)
        free(self.comparisons)
    def take(self):
        cdef Py_ssize_t i
        for i in range(len(self.live)):
            self.copiers[i](self.live[i], self.kept[i])
    def put_back(self):
        cdef Py_ssize_t i
        for i in range(len(self.live)):
            self.copiers[i](self.kept[i], self.live[i])
    def have_same_arrays(self):
        cdef Py_ssize_t i
        for i in range(len(self.live)):
            if not self.comparisons[i](self.live[i], self.kept[i]):
                return False
        return True

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
    """Return the source of the compiled module: ``COPIED``, ``ARRAYS``, ``EXCHANGED`` by class."""
    kept = [found for found in typed_classes(kernel) if found.copied or found.arrays]
    copied = [found for found in kept if found.copied]
    exchanged = [found for found in copied if found.exchanged]
    lines = [HEAD, *(f"from {found.module} cimport {found.name}" for found in kept)]
    for found in copied:
        lines += [f"cdef int copy_{found.name}(object one, object other) except -1:"]
        lines += [f"    source, target = <{found.name}>one, <{found.name}>other"]
        for name in found.copied:
            is_list = found.fields[name].kind == "list"
            value = f"list(source.{name})" if is_list else f"source.{name}"
            lines.append(f"    target.{name} = {value}")
    for found in kept:
        items = "".join(f"part.{name}, " for name in found.arrays)
        lines += [f"def arrays_of_{found.name}({found.name} part):", f"    return ({items})"]
    lines += ["cdef int has_same_arrays(object one, object other) except -1:", "    return 1"]
    for found in exchanged:
        same = " and ".join(f"&live.{name}[0] == &kept.{name}[0]" for name in found.exchanged)
        lines += ["@cython.boundscheck(False)"]
        lines += [f"cdef int has_same_arrays_{found.name}(object one, object other) except -1:"]
        lines += [f"    live, kept = <{found.name}>one, <{found.name}>other"]
        lines += [f"    return {same}"]
    arrays = "".join(f"{one.name}: arrays_of_{one.name}, " for one in kept if one.arrays)
    functions = [f"copy_{one.name}" for one in copied]
    comparisons = ["has_same_arrays", *(f"has_same_arrays_{one.name}" for one in exchanged)]
    lines += [f"ARRAYS = {{{arrays}}}"]
    for name, classes, first in (("COPIED", copied, 0), ("EXCHANGED", exchanged, 1)):
        numbers = "".join(f"{one.name}: {number}, " for number, one in enumerate(classes, first))
        lines += [f"{name} = {{{numbers}}}"]
    lines += [f"cdef Copier[{len(functions)}] _copiers"]
    lines += [f"_copiers[{number}] = {name}" for number, name in enumerate(functions)]
    lines += [f"cdef Comparison[{len(comparisons)}] _comparisons"]
    lines += [f"_comparisons[{number}] = {name}" for number, name in enumerate(comparisons)]
    return "\n".join([*lines, COPIES])
