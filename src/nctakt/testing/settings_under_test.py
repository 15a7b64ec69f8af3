# SPDX-License-Identifier: MIT
"""The settings of a pytest test, and the notes on machines that were chosen by default."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from nctakt.files.access import FileAccess
from nctakt.lists.machine.files import machine_folder
from nctakt.project.machine_choice import machine_of_environment
from nctakt.project.run_settings import Named, RunSettings, run_settings
from nctakt.testing.language import language_of_tests

#: Under it a process of pytest keeps the notes on the machines of its tests.
REPORTED_MACHINES = pytest.StashKey[dict[str, None]]()


def machine_of_configuration(config: pytest.Config) -> Path | None:
    """Return the machine of ``nctakt_machine``; ``None`` without it, and with NCTAKT_MACHINE."""
    entry = config.getini("nctakt_machine")
    if not entry or machine_of_environment() is not None:
        return None
    return machine_folder(entry, config.rootpath)


def settings_of_test(config: pytest.Config, test: Path, named: Named | None = None) -> RunSettings:
    """Return the settings of a test or an NC file besides those that it names itself.

    They are those with which ``nctakt run`` runs a program there; between ``NCTAKT_MACHINE`` and
    the machine of the project comes ``nctakt_machine`` (relative to the root of the tests). Raises
    ``Failure`` as ``run_settings``.
    """
    named = replace(named or Named(), fmu_use="run")
    if named.machine is None:
        named = replace(named, machine=machine_of_configuration(config))
    settings = run_settings([test], FileAccess(), named)
    note = settings.machine_note
    if note is not None:
        config.stash.setdefault(REPORTED_MACHINES, {})[note.text(language_of_tests())] = None
    return settings
