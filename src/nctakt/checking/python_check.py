# SPDX-License-Identifier: MIT
"""``nctakt.check``: programs, lists and folders checked from Python, without a run."""

from __future__ import annotations

from pathlib import Path

from nctakt.base.diagnostics import Diagnostic
from nctakt.checking.check import check_files
from nctakt.files.access import FileAccess
from nctakt.lists.format import arguments
from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.run.program_loader import NcText
from nctakt.run.realtime.assembly import AssembledMachine


def check(
    *inputs: str | Path | NcText, machine: Machine | str | Path | None = None
) -> list[Diagnostic]:
    """Return all findings in programs, lists and folders, by file, line and column.

    ``machine``: the machine of all programs; without one each is checked for the machine in whose
    folder it lies, else for the demo machine. A file that cannot be read is a finding, too. Raises
    ``Failure`` if no machine results, and for anything that is no input (901186).

    >>> [found.id for found in check(NcText("part.nc", "G01 XX"))]
    [20797]
    """
    access = FileAccess()
    loaded = machine if isinstance(machine, Machine) else load_machine(machine, access=access)
    assembled = AssembledMachine(loaded, access, has_history=False)
    named = [
        item if isinstance(item, NcText) else arguments.path("inputs", item) for item in inputs
    ]
    result = check_files(named, assembled, for_all=machine is not None)
    return [finding.diagnostic for finding in result.findings]
