# SPDX-License-Identifier: MIT
"""The files and folders that comments of a program name: those that do not exist."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from nctakt.base.diagnostics import Diagnostic
from nctakt.files.access import FileAccess
from nctakt.lists.machine.files import machine_folder
from nctakt.messages import diagnostic
from nctakt.messages.commands.inputs import NAMED_FILE_MISSING
from nctakt.project.run_settings import DEFAULT_PLC
from nctakt.testing.expectations import Script


def missing_files(script: Script, folder: Path, access: FileAccess) -> Iterator[Diagnostic]:
    """Yield 902940 for each PLC, machine, program and log that does not exist.

    ``folder``: that of the program. Files that ``access`` does not admit are not opened.
    """
    named = [(one.kind, one.name, one.position) for one in script.givens if one.kind != "value"]
    logs = [one for one in script.expectations if one.kind == "log"]
    for kind, name, position in (*named, *(("log", one.file, one.position) for one in logs)):
        assert position is not None  # an expectation of a comment has one
        path = machine_folder(name, folder) if kind == "machine" else folder / name
        is_default = kind == "plc" and name == DEFAULT_PLC
        if not is_default and access.admits(path) and not path.exists():
            yield diagnostic(NAMED_FILE_MISSING, position.span, position.source_line, file=name)
