# SPDX-License-Identifier: MIT
"""Changes of variables over time -> an FST file, the compressed form of VCD (pylibfst).

In: variables as for a VCD file. Out: the file, which GTKWave and Surfer read. The same changes give
the same bytes.
"""

from __future__ import annotations

import importlib.util
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from nctakt.base.failure import Failure
from nctakt.files.vcd import FIRST_VALUES, Value, VcdVariable, in_order, named
from nctakt.messages import diagnostic
from nctakt.messages.extras import install_command
from nctakt.messages.scheduling.schedule_results import LIBRARY_MISSING

#: The size of whole numbers in bits.
_INTEGER_BITS = 64


def check_fst() -> None:
    """Raise ``Failure`` (900634) where no FST file can be written."""
    if importlib.util.find_spec("pylibfst") is None:
        raise Failure(
            diagnostic(
                LIBRARY_MISSING,
                library="pylibfst",
                what="--fst",
                install=install_command("measure"),
            )
        )


def write_fst_file(
    path: Path, variables: Iterable[VcdVariable], *, exponent: int, begin: int
) -> None:
    """Write the variables from time ``begin`` on; the unit of times is 10^``exponent`` s.

    Raises ``OSError``.
    """
    from pylibfst import ffi, lib  # noqa: PLC0415 - only when needed

    writer = lib.fstWriterCreate(str(path).encode(), 1)
    if writer == ffi.NULL:
        raise OSError(0, "FST", str(path))
    try:
        lib.fstWriterSetTimescale(writer, exponent)
        lib.fstWriterSetDate(writer, b"")
        shown = sorted(named(variables), key=lambda one: one[0])
        handles = _declared(lib, ffi, writer, shown)
        put = _Writer(lib, ffi, writer)
        lib.fstWriterEmitTimeChange(writer, begin)
        for handle, (_, _, variable) in zip(handles, shown, strict=True):
            put.value(handle, variable.kind, FIRST_VALUES[variable.kind])
        latest = begin
        changes = [variable.changes for _, _, variable in shown]
        for time, number, value in in_order(changes):
            if time != latest:
                lib.fstWriterEmitTimeChange(writer, time)
                latest = time
            put.value(handles[number], shown[number][2].kind, value)
    finally:
        lib.fstWriterClose(writer)


def _declared(
    lib: Any, ffi: Any, writer: Any, shown: list[tuple[tuple[str, ...], str, VcdVariable]]
) -> list[int]:
    """Declare the variables in their scopes; return their handles."""
    kinds = {
        "wire": (lib.FST_VT_VCD_WIRE, 1),
        "truth": (lib.FST_VT_VCD_WIRE, 1),
        "text": (lib.FST_VT_GEN_STRING, 0),
        "integer": (lib.FST_VT_VCD_INTEGER, _INTEGER_BITS),
        "real": (lib.FST_VT_VCD_REAL, 8),
    }
    handles: list[int] = []
    open_scope: tuple[str, ...] = ()
    for scope, name, variable in shown:
        common = 0
        while common < min(len(scope), len(open_scope)) and scope[common] == open_scope[common]:
            common += 1
        for _ in open_scope[common:]:
            lib.fstWriterSetUpscope(writer)
        for part in scope[common:]:
            lib.fstWriterSetScope(writer, lib.FST_ST_VCD_MODULE, part.encode(), ffi.NULL)
        open_scope = scope
        kind, bits = kinds[variable.kind]
        implicit = lib.FST_VD_IMPLICIT
        handles.append(lib.fstWriterCreateVar(writer, kind, implicit, bits, name.encode(), 0))
    for _ in open_scope:
        lib.fstWriterSetUpscope(writer)
    return handles


class _Writer:
    """Writes values of each kind."""

    def __init__(self, lib: Any, ffi: Any, writer: Any) -> None:
        self._lib = lib
        self._ffi = ffi
        self._writer = writer
        self._number = ffi.new("double*")

    def value(self, handle: int, kind: str, value: Value) -> None:
        """Write a value at the present time."""
        lib, writer = self._lib, self._writer
        if kind == "text":
            text = str(value).encode()
            lib.fstWriterEmitVariableLengthValueChange(writer, handle, text, len(text))
        elif kind == "real":
            self._number[0] = float(value)
            lib.fstWriterEmitValueChange(writer, handle, self._number)
        elif kind == "integer":
            bits = format(int(value) & ((1 << _INTEGER_BITS) - 1), f"0{_INTEGER_BITS}b")
            lib.fstWriterEmitValueChange(writer, handle, self._ffi.from_buffer(bits.encode()))
        else:
            bit = self._ffi.from_buffer(str(value).encode())
            lib.fstWriterEmitValueChange(writer, handle, bit)
