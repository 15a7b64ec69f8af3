# SPDX-License-Identifier: MIT
"""The user's PLC on the other side of the interface image (HLI).

In: a user's Python file with one class that has a method ``cycle(self, hli)``. Out: an object whose
``cycle`` the controller calls after each tick; its answers count from the next tick on (RC-002).
Without one the controller acknowledges everything by itself. A mistake in the user's file is a
diagnostic with a traceback of the user's files only.
"""

from __future__ import annotations

import contextlib
import importlib.util
import sys
import traceback
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from importlib.abc import SourceLoader
from importlib.machinery import ModuleSpec
from pathlib import Path
from types import CodeType, ModuleType
from typing import TYPE_CHECKING, Protocol

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.messages import diagnostic
from nctakt.messages.plcs.plc import (
    PLC_CLASS_AMBIGUOUS,
    PLC_CLASS_MISSING,
    PLC_FAILED,
    PLC_LOAD_FAILED,
    UNKNOWN_PLC_NAME,
)
from nctakt.plc.error import PlcError
from nctakt.run.plcs.plc_view import AnyPlc, Declaration, WatchedPlc
from nctakt.run.plcs.realtime_plc import plc_object
from nctakt.st.files.suffixes import PLC_SUFFIXES

if TYPE_CHECKING:
    from nctakt.run.plcs.plc_view import PlcView


_OUR_FOLDER = Path(__file__).parent.parent


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
    """Return a PLC's file, from which PLCs are made one after another; raises as ``load_plc``."""
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
        """Return a new PLC, of a module of its own: nothing stays of those before."""
        path = self._path
        module, self._loaded = _load_module(path, self._loaded)
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
        except (Exception, SystemExit) as error:  # the user's code may raise what it likes
            raise _load_error(error, path) from error
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
        """Return what its class waits for."""
        return self._plc.declaration(hli) if isinstance(self._plc, WatchedPlc) else None

    def each_call(self) -> Callable[[PlcView], object]:
        """Return the user's method."""
        return self._cycle

    def failure(self, error: BaseException, hli: PlcView) -> PlcError:
        """Return a ``PlcError`` (900523) for an exception of the user's code.

        What was refused in no line of the user's has its own place.
        """
        reason, text = _reason_and_traceback(error, self._path)
        if not text and _refused(error):
            return PlcError(*map(self._as_named, _refused(error)))
        message = diagnostic(PLC_FAILED, tick=hli.tick, reason=reason, traceback=text)
        return PlcError(message, *_refused(error))

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


def _load_module(
    path: Path, loaded: tuple[ModuleSpec, CodeType] | None
) -> tuple[ModuleType, tuple[ModuleSpec, CodeType]]:
    """Return the user's file as a new module, and what it was made of: ``loaded`` the next time.

    While the module is loaded it can import files beside it.
    """
    name = f"nctakt_plc_{path.stem}"
    code = None
    if loaded is None:
        try:
            FileAccess().read_bytes(path)  # the import would read an endless file without end
        except Failure as failure:
            raise PlcError(*failure.diagnostics) from failure
        spec = importlib.util.spec_from_file_location(name, path)
    else:
        spec, code = loaded
    if spec is None or not isinstance(spec.loader, SourceLoader):  # not named .py
        raise PlcError(diagnostic(PLC_CLASS_MISSING, file=str(path)))
    module = importlib.util.module_from_spec(spec)
    before = sys.modules.get(name)
    sys.modules[name] = module  # data classes look their own module up
    try:
        with imports_beside(path):
            code = code or spec.loader.get_code(name)
            if code is None:
                raise ImportError(name)
            exec(code, module.__dict__)
    except (Exception, SystemExit) as error:  # the user's code may raise what it likes
        raise _load_error(error, path) from error
    finally:
        _restore(name, before)
    return module, (spec, code)


@contextlib.contextmanager
def imports_beside(path: Path) -> Iterator[None]:
    """Let a user's file import the files beside it while it is loaded."""
    folder = str(path.parent.resolve())
    sys.path.insert(0, folder)
    try:
        yield
    finally:
        sys.path.remove(folder)


def _restore(name: str, before: ModuleType | None) -> None:
    """Leave ``sys.modules`` as it was, so that two controllers can load files of one name."""
    if before is None:
        del sys.modules[name]
    else:
        sys.modules[name] = before


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


def _load_error(error: BaseException, path: Path) -> PlcError:
    reason, text = _reason_and_traceback(error, path)
    return PlcError(diagnostic(PLC_LOAD_FAILED, reason=reason, traceback=text), *_refused(error))


def _refused(error: BaseException) -> tuple[Diagnostic, ...]:
    """Return the diagnostics of a request of the PLC that nctakt has refused."""
    return error.diagnostics if isinstance(error, Failure) else ()


def _is_users(file: Path, plc: Path) -> bool:
    """Return whether a file is the PLC's or lies beside it, and so is the user's."""
    parents = file.absolute().parents
    installed = any(parent.name == "site-packages" for parent in parents)
    return plc.absolute().parent in parents and _OUR_FOLDER not in parents and not installed


def _reason_and_traceback(error: BaseException, path: Path) -> tuple[str, str]:
    """Return the exception on one line, and its traceback through the user's files."""
    frames = traceback.extract_tb(error.__traceback__)
    files = (str(path), str(path.absolute()))
    first = next((i for i, frame in enumerate(frames) if frame.filename in files), len(frames))
    shown = [frame for frame in frames[first:] if _is_users(Path(frame.filename), path)]
    # without the marks below a line: each version of Python puts others there
    lines = traceback.format_list(
        [traceback.FrameSummary(one.filename, one.lineno, one.name, line=one.line) for one in shown]
    )
    reason = traceback.format_exception_only(error)[-1].strip()
    if isinstance(error, SyntaxError):  # its position is in its text, not in a frame
        lines = traceback.format_exception_only(error)[:-1]
    if isinstance(error, Failure):  # a refused request
        reason = error.diagnostics[0].headline()
    return reason, "".join(lines).rstrip()
