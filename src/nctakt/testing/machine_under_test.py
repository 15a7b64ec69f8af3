# SPDX-License-Identifier: MIT
"""The machine that a test of pytest runs on, and the notes on machines that nobody named."""

from __future__ import annotations

from pathlib import Path

import pytest

from nctakt.files.access import FileAccess
from nctakt.lists.machine.files import machine_folder
from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.project.machine_choice import machine_of, machine_of_environment

#: Under it a process of pytest keeps the notes on the machines of its tests.
REPORTED_MACHINES = pytest.StashKey[dict[str, None]]()


def configured_machine(config: pytest.Config, test: Path) -> Machine:
    """Return the machine of a test or an NC file.

    That of ``NCTAKT_MACHINE``, of ``nctakt_machine`` (relative to the root of the tests), else the
    one on which ``nctakt run`` runs a program there.
    """
    name = config.getini("nctakt_machine")
    if name and machine_of_environment() is None:
        return load_machine(machine_folder(name, config.rootpath))
    choice = machine_of(test, FileAccess())
    note = choice.note()
    if note is not None:
        config.stash.setdefault(REPORTED_MACHINES, {})[note.text()] = None
    return load_machine(choice.path)
