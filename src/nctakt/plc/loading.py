# SPDX-License-Identifier: MIT
"""The user's PLC on the other side of the interface image (HLI).

In: a user's Python file with one class that has a method ``cycle(self, hli)``. Out: an object whose
``cycle`` the controller calls after each tick; its answers count from the next tick on (RC-002).
Without a PLC the controller acknowledges everything automatically. A mistake in the user's file is
a diagnostic with a traceback of the user's files only.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from importlib.machinery import ModuleSpec
from pathlib import Path
from types import CodeType, ModuleType
from typing import TYPE_CHECKING, Protocol

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.plcs.plc import (
    PLC_CLASS_AMBIGUOUS,
    PLC_CLASS_MISSING,
    PLC_FAILED,
    UNKNOWN_PLC_NAME,
)
from nctakt.plc.error import PlcError
from nctakt.plc.python.user_modules import (
    load_error,
    load_module,
    reason_and_traceback,
    refused_in,
)
from nctakt.run.plcs.plc_view import AnyPlc, Declaration, WatchedPlc
from nctakt.run.plcs.realtime_plc import plc_object
from nctakt.st.files.suffixes import PLC_SUFFIXES

if TYPE_CHECKING:
    from nctakt.run.plcs.plc_view import PlcView


def load_plc(path: str | Path) -> AnyPlc:
    """Return the PLC of a file: Structured Text, or an object of its one class with ``cycle``.

    Classes whose names begin with an underscore, and base classes of others, do not count. Raises
    ``PlcError``: no such file (900500), a folder (900501), not readable (900503), no class
    (900520), several classes (900521), an exception in the file (900522).
    """
    return plc_file(path).plc()


def load_plcs(paths: Sequence[str | Path]) -> AnyPlc | None:
    """Return the PLCs of files as one, in this order; ``None`` without files.

    Raises as ``load_plc``, and for a second PLC in Python (902761).
    """
    return plc_object([load_plc(path) for path in paths])


class AnyPlcFile(Protocol):
    """A PLC's file for any number of PLCs."""

    def plc(self) -> AnyPlc:
        """Return a new PLC; raises as ``load_plc``."""


def plc_file(path: str | Path) -> AnyPlcFile:
    """Return a PLC's file, from which PLCs are made in turn; raises as ``load_plc``."""
    if Path(path).suffix.lower() in PLC_SUFFIXES:
        from nctakt.plc.structured_text import StructuredFile  # noqa: PLC0415 - rare

        return StructuredFile(path)
    return PlcFile(path)


class PlcFile:
    """A PLC's file, read and inspected once, for any number of PLCs; raises as ``load_plc``."""

    def __init__(self, path: str | Path) -> None:
        self._path = Path(path)
        self._loaded: tuple[ModuleSpec, CodeType] | None = None
        self._kind: type[AnyPlc] | None = None

    def plc(self) -> _LoadedPlc:
        """Return a new PLC, of a separate module: nothing is left of earlier ones."""
        path = self._path
        module, self._loaded = load_module(path, self._loaded)
        candidates = _candidates(module)
        if not candidates:
            raise PlcError(diagnostic(PLC_CLASS_MISSING, file=str(path)), *_misspelt(module))
        if len(candidates) > 1:
            names = ", ".join(candidate.__name__ for candidate in candidates)
            raise PlcError(diagnostic(PLC_CLASS_AMBIGUOUS, file=str(path), names=names))
        (kind,) = candidates
        if self._kind is None:
            # A run without PLC needs none.
            from nctakt.plc.inspection import inspect_plc  # noqa: PLC0415

            slips = inspect_plc(path, kind)
            if slips:
                raise PlcError(*slips)
        elif vars(self._kind).get("_is_checked", False):
            kind._is_checked = True  # type: ignore[attr-defined] # it is made of the same code
        self._kind = kind
        try:
            plc = kind()
        except (Exception, SystemExit) as error:  # the user's code may raise anything
            raise load_error(error, path) from error
        return _LoadedPlc(plc, path)


def input_file_of(path: str | Path) -> Path | None:
    """Return the file of the inputs of a PLC's file, ``None`` without; raises as ``load_plc``."""
    from nctakt.plc.script import input_file  # noqa: PLC0415 - a PLC need not derive from ours

    return input_file(PlcFile(path).plc()._plc)


class _LoadedPlc(WatchedPlc):
    """A PLC from a file; its exceptions become a ``PlcError`` (900523)."""

    def __init__(self, plc: AnyPlc, path: Path) -> None:
        self._plc = plc
        self._cycle = plc.cycle
        self._path = path

    def begin_run(self, hli: PlcView) -> None:
        """Raise ``PlcError`` if the PLC waits for names that the machine does not have."""
        if isinstance(self._plc, WatchedPlc):
            try:
                self._plc.begin_run(hli)
            except Failure as failure:
                raise PlcError(*map(self._as_named, failure.diagnostics)) from failure

    def notes(self) -> list[Diagnostic]:
        """Return the notes of its class, with the file's name as the user wrote it."""
        if not isinstance(self._plc, WatchedPlc):
            return []
        return [self._as_named(message) for message in self._plc.notes()]

    def declaration(self, hli: PlcView) -> Declaration | None:
        """Return the events that its class waits for."""
        return self._plc.declaration(hli) if isinstance(self._plc, WatchedPlc) else None

    def each_call(self) -> Callable[[PlcView], object]:
        """Return the user's method."""
        return self._cycle

    def failure(self, error: BaseException, hli: PlcView) -> PlcError:
        """Return a ``PlcError`` (900523) for an exception of the user's code.

        A refusal outside the user's lines has its own place.
        """
        reason, text = reason_and_traceback(error, self._path)
        if not text and refused_in(error):
            return PlcError(*map(self._as_named, refused_in(error)))
        message = diagnostic(PLC_FAILED, tick=hli.tick, reason=reason, traceback=text)
        return PlcError(message, *refused_in(error))

    def unused_handlers(self, hli: PlcView) -> list[Diagnostic]:
        """Return the diagnostics of its class, with the file's name as the user wrote it."""
        if not isinstance(self._plc, WatchedPlc):
            return []
        return [self._as_named(message) for message in self._plc.unused_handlers(hli)]

    def _as_named(self, message: Diagnostic) -> Diagnostic:
        """Return the diagnostic with the file's name as the user wrote it."""
        if message.span is None or message.span.file != str(self._path.absolute()):
            return message
        return replace(message, span=replace(message.span, file=str(self._path)))

    def cycle(self, hli: PlcView) -> None:
        """Run the user's PLC once."""
        try:
            self._cycle(hli)
        except (Exception, SystemExit) as error:  # the user's code may raise what it likes
            raise self.failure(error, hli) from error


def _candidates(module: ModuleType) -> list[type[AnyPlc]]:
    classes = [
        value
        for name, value in vars(module).items()
        if isinstance(value, type)
        and value.__module__ == module.__name__
        and not name.startswith("_")
        and callable(getattr(value, "cycle", None))
    ]
    unique = list(dict.fromkeys(classes))
    return [
        candidate
        for candidate in unique
        if not any(other is not candidate and issubclass(other, candidate) for other in unique)
    ]


def _misspelt(module: ModuleType) -> Iterator[Diagnostic]:
    """Yield an error for each class of the file with a method whose name is nearly ``cycle``."""
    from nctakt.plc.inspection import nearest_member  # noqa: PLC0415 - only a mistake needs it

    for name, kind in vars(module).items():
        if isinstance(kind, type) and kind.__module__ == module.__name__:
            near = nearest_member(kind)
            if near:
                yield diagnostic(UNKNOWN_PLC_NAME, owner=name, name="cycle", nearest=near)
