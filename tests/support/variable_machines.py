# SPDX-License-Identifier: MIT
"""Machines like the demo machine, with other variables."""

from __future__ import annotations

import shutil
from pathlib import Path

from nctakt.lists.machine.machine import Machine, load_machine

DEMO = load_machine(None).folder

#: A structure in a structure, an array of it, and everything that a C compiler pads.
NESTED = """
struct[0].name OUTER
struct[0].element[0].name FLAG
struct[0].element[0].type BOOLEAN
struct[0].element[1].name REAL
struct[0].element[1].type REAL64
struct[0].element[2].name SHORT
struct[0].element[2].type SGN16
struct[0].element[3].name INNER
struct[0].element[3].type INNER
struct[0].element[3].array_elements 2
struct[0].element[4].name LAST
struct[0].element[4].type UNS08
struct[1].name INNER
struct[1].element[0].name LONG
struct[1].element[0].type UNS32
struct[1].element[1].name BYTES
struct[1].element[1].type UNS08
struct[1].element[1].array_elements 3
struct[1].element[2].name TEXT
struct[1].element[2].type VSTRING
struct[1].element[2].size 5
struct[1].element[3].name WORD
struct[1].element[3].type UNS16
number_used_variables 3
var[0].name FIRST
var[0].type BOOLEAN
var[1].name OUTERS
var[1].type OUTER
var[1].array_elements 2
var[2].name BEHIND
var[2].type REAL64
"""


def folder_with(tmp_path: Path, variables: str, **startup: object) -> Path:
    """The demo machine's lists with another variables list and entries of the start-up list."""
    folder = tmp_path / "machine"
    shutil.copytree(DEMO, folder)
    (folder / "ext_var1.lis").write_text(f"{variables}\nEnde\n", "utf-8")
    list_ = folder / "hochlauf.lis"
    lines = list_.read_text("utf-8").splitlines()
    kept = [line for line in lines if line.split() and line.split()[0] not in (*startup, "Ende")]
    kept += [f"{key} {value}" for key, value in startup.items()]
    list_.write_text("\n".join([*kept, "Ende", ""]), "utf-8")
    return folder


def machine_with(tmp_path: Path, variables: str, alignment: int = 8) -> Machine:
    """Such a machine, whose lists have no mistakes."""
    folder = folder_with(tmp_path, variables, ext_var_struct_member_alignment=alignment)
    machine = load_machine(folder)
    assert machine.diagnostics == (), machine.diagnostics
    return machine
