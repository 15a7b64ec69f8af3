# SPDX-License-Identifier: MIT
"""Callables declared by a checked program: its own functions, methods and bodies."""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.st.program import Program
from nctakt.st.types import Callable, Kind, Method, Pou


def methods_of(pou: Pou) -> Iterator[Method]:
    """Yield the methods, actions and accessors that a block declares itself."""
    yield from pou.methods.values()
    for one in pou.properties.values():
        yield from (method for method in (one.get, one.set) if method is not None)


def own_units(program: Program) -> Iterator[tuple[Callable, str]]:
    """Yield the callables declared by the project itself, with their keywords."""
    for pou in program.pous.values():
        if pou.library or pou.is_refused:
            continue
        if pou.body:
            yield pou, pou.kind.value
        if pou.kind is not Kind.FUNCTION:
            for method in methods_of(pou):
                if method.body:
                    yield method, _title(pou, method)


def _title(pou: Pou, method: Method) -> str:
    if method.is_action:
        return "ACTION"
    accessors = [part for one in pou.properties.values() for part in (one.get, one.set)]
    return "PROPERTY" if method in accessors else "METHOD"
