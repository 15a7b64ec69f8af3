# SPDX-License-Identifier: MIT
"""A user's Python file as a module, and its exceptions as shown to the user.

In: a file. Out: a new module each time, of which nothing stays in ``sys.modules``; for an exception
its reason and the traceback through the user's files.
"""

from __future__ import annotations

import contextlib
import importlib.util
import sys
import traceback
from collections.abc import Iterator
from importlib.abc import SourceLoader
from importlib.machinery import ModuleSpec
from pathlib import Path
from types import CodeType, ModuleType

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.messages import diagnostic
from nctakt.messages.plcs.plc import PLC_CLASS_MISSING, PLC_LOAD_FAILED
from nctakt.plc.error import PlcError

_OUR_FOLDER = Path(__file__).parent.parent.parent


def load_module(
    path: Path, loaded: tuple[ModuleSpec, CodeType] | None
) -> tuple[ModuleType, tuple[ModuleSpec, CodeType]]:
    """Return the user's file as a new module, and its source: ``loaded`` the next time.

    While the module is loaded it can import files next to it.
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
    sys.modules[name] = module  # data classes look up their module
    try:
        with imports_beside(path):
            code = code or spec.loader.get_code(name)
            if code is None:
                raise ImportError(name)
            exec(code, module.__dict__)
    except (Exception, SystemExit) as error:  # the user's code may raise anything
        raise load_error(error, path) from error
    finally:
        _restore(name, before)
    return module, (spec, code)


@contextlib.contextmanager
def imports_beside(path: Path) -> Iterator[None]:
    """Let a user's file import files next to it while it is loaded."""
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


def load_error(error: BaseException, path: Path) -> PlcError:
    reason, text = reason_and_traceback(error, path)
    return PlcError(diagnostic(PLC_LOAD_FAILED, reason=reason, traceback=text), *refused_in(error))


def refused_in(error: BaseException) -> tuple[Diagnostic, ...]:
    """Return the diagnostics of a request of the PLC that nctakt has refused."""
    return error.diagnostics if isinstance(error, Failure) else ()


def _is_users(file: Path, plc: Path) -> bool:
    """Return whether a file is the PLC's or next to it, and so is the user's."""
    parents = file.absolute().parents
    installed = any(parent.name == "site-packages" for parent in parents)
    return plc.absolute().parent in parents and _OUR_FOLDER not in parents and not installed


def reason_and_traceback(error: BaseException, path: Path) -> tuple[str, str]:
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
