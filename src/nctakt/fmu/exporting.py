# SPDX-License-Identifier: MIT
"""A machine with its program and PLC as an FMU, which other tools simulate along with their models.

In: the inputs of a run. Out: the archive: a description, the libraries of pythonfmu (FMI 2.0) or
pythonfmu3 (FMI 3.0), and the files that the run has read, in folders with the same relative places.
The result has been started once from there: it needs no other file.
"""

from __future__ import annotations

import hashlib
import importlib
import io
import json
import os
import sys
import tempfile
import zipfile
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nctakt.base.dataclass import dataclass
from nctakt.base.failure import Failure
from nctakt.fmu.cell import CONTENT, FILES, Cell
from nctakt.fmu.model_description import CellVariable, model_description
from nctakt.messages import diagnostic
from nctakt.messages.commands.studies import EXTRA_MISSING
from nctakt.messages.extras import install_command
from nctakt.messages.plcs.fmu import CELL_NOT_COMPLETE, NOT_AN_INPUT
from nctakt.plc.loading import input_file_of
from nctakt.project.imports import with_imports
from nctakt.run.plcs.realtime_plc import is_structured

if TYPE_CHECKING:
    from nctakt.run.realtime.assembly import AssembledMachine

#: The package with the libraries of each version, and their ending by the platform's folder.
_PACKAGES = {2: "pythonfmu", 3: "pythonfmu3"}

#: The import of the libraries: they look for this line to find the class.
_SCRIPT = '''\
"""The entry of an FMU of nctakt."""

from nctakt.fmu.slave import Fmi{version}Slave


class Cell(Fmi{version}Slave):
    """An instance."""


# The library of FMI 2.0 gives back a reference to this namespace that it never took, each time.
_HELD = (globals(), Cell) * 10_000
'''

#: The lists of built-in machines.
_BUILT_IN = Path(__file__).resolve().parent.parent / "machines"


@dataclass(frozen=True, slots=True)
class CellFiles:
    """The parts of a run in an FMU: ``words`` as on a tape, names relative to their folder."""

    words: Mapping[str, Any]
    plcs: tuple[str, ...]
    files: Mapping[str, bytes]
    has_lists: bool


def gather(words: Mapping[str, Any], plcs: Sequence[str], read: Sequence[Path]) -> CellFiles:
    """Return the files of a run in one folder; ``words``: those of its tape."""
    files = {Path(os.path.realpath(one)) for one in read}
    files.update(file for plc in plcs for file in _beside_plc(plc))
    stubs = with_imports(one for one in read if one.suffix == ".py")
    files.update(Path(os.path.realpath(one)) for one in stubs if one.suffix == ".py")
    files = {one for one in files if not one.is_relative_to(_BUILT_IN)}
    root = Path(os.path.commonpath([one.parent for one in files]))

    def name(path: str) -> str:
        return Path(os.path.realpath(path)).relative_to(root).as_posix()

    machine = words["machine"]
    folder = None if machine is None else Path(os.path.realpath(machine))
    has_lists = folder is not None and not folder.is_relative_to(_BUILT_IN)
    if folder is not None:
        machine = name(str(folder)) if has_lists else folder.name
    return CellFiles(
        {
            **words,
            "programs": [name(one) for one in words["programs"]],
            "others": [[number, name(one)] for number, one in words["others"]],
            "machine": machine,
        },
        tuple(map(name, plcs)),
        {name(str(one)): one.read_bytes() for one in sorted(files)},
        has_lists,
    )


def _beside_plc(plc: str) -> Iterator[Path]:
    """Yield the files of a PLC in Python: its file, its inputs, the modules next to it."""
    if is_structured(plc):
        return
    file = Path(os.path.realpath(plc))
    yield file
    inputs = input_file_of(plc)
    if inputs is not None:
        yield Path(os.path.realpath(inputs))
    for module in list(sys.modules.values()):
        beside = getattr(module, "__file__", None)
        if beside and Path(os.path.realpath(beside)).is_relative_to(file.parent):
            found = Path(os.path.realpath(beside))
            if found.suffix == ".py" and "site-packages" not in found.parts:
                yield found


def cell_variables(
    machine: AssembledMachine, inputs: Sequence[str] | None, outputs: Sequence[str] | None
) -> list[CellVariable]:
    """Return the variables: outputs, then inputs; raises ``Failure`` for unknown names.

    Without names the outputs are the signals of a trace, the inputs the operator's values.
    """
    signals, texts = machine.signals(), _texts(machine)
    if outputs is None:
        outputs = list(machine.default_signals())
    if inputs is None:
        inputs = [name for name, is_command in _panel(machine).items() if is_command]
    inputs = list(dict.fromkeys(inputs))
    outputs = [name for name in dict.fromkeys(outputs) if name not in inputs]
    found = []
    for name in (*outputs, *inputs):
        if name not in signals:
            raise Failure(machine.unknown_signal(name))
        signal = signals[name]
        start = None
        if name in inputs:
            try:
                machine.access.check(name, machine.cells[signal.cell])
            except Failure as failure:
                unsettable = diagnostic(NOT_AN_INPUT, name=name)
                raise Failure(unsettable, *failure.diagnostics) from failure
            start = machine.cells[signal.cell]
        found.append(CellVariable(name, signal.unit, texts.get(name, ""), signal.is_whole, start))
    return found


def _panel(machine: AssembledMachine) -> dict[str, bool]:
    """Return the operator's values of the channels, and whether each can be set."""
    return {
        f"{one.prefix}{name}" if index else name: value.is_command
        for index, one in enumerate(machine.assembled)
        for name, value in one.panel.items()
    }


def _texts(machine: AssembledMachine) -> dict[str, str]:
    """Return the meanings of the signals."""
    found: dict[str, str] = {}
    for index, (names, one) in enumerate(
        zip(machine.layout.tables, machine.assembled, strict=True)
    ):
        prefix = one.prefix if index else ""
        found.update((f"{prefix}{name}", row.meaning.en) for name, _, row in names.signals())
        found.update((f"{prefix}{name}", value.entry.meaning) for name, value in one.panel.items())
    return found


def build_cell(
    version: int,
    identifier: str,
    cell: CellFiles,
    variables: Sequence[CellVariable],
    cycle_time_us: int,
) -> bytes:
    """Return the FMU; raises ``Failure``.

    Without pythonfmu or pythonfmu3 (901311); if it does not start from its own files (902615).
    """
    content = {
        "words": cell.words,
        "plcs": cell.plcs,
        "has_lists": cell.has_lists,
        "variables": [one.name for one in variables],
    }
    digest = hashlib.sha256(json.dumps(content, sort_keys=True).encode())
    for name in sorted(cell.files):
        digest.update(name.encode() + b"\0" + hashlib.sha256(cell.files[name]).digest())
    token = digest.hexdigest()[:32]
    module = f"nctakt_cell_{version}_{token}"
    resources = {
        CONTENT: json.dumps({**content, "token": token}, indent=1, sort_keys=True).encode(),
        "slavemodule.txt": module.encode(),
        f"{module}.py": _SCRIPT.format(version=version).encode(),
        **{f"{FILES}/{name}": data for name, data in cell.files.items()},
    }
    _check_complete(resources)
    entries = {
        "modelDescription.xml": model_description(
            version, identifier, f"{{{token}}}", cycle_time_us / 1e6, variables
        ),
        **{f"binaries/{name}": data for name, data in _libraries(version, identifier)},
        **{f"resources/{name}": data for name, data in resources.items()},
    }
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in entries.items():
            archive.writestr(zipfile.ZipInfo(name), data, zipfile.ZIP_DEFLATED)
    return packed.getvalue()


def _libraries(version: int, identifier: str) -> Iterator[tuple[str, bytes]]:
    """Yield the libraries for each platform with their names in the archive."""
    name = _PACKAGES[version]
    try:
        package = importlib.import_module(name)
    except ImportError as error:
        raise Failure(
            diagnostic(EXTRA_MISSING, package=name, install=install_command("fmi"))
        ) from error
    folder = Path(str(package.__file__)).parent / "resources" / "binaries"
    for file in sorted(folder.rglob("*")):
        if file.is_file():
            yield f"{file.parent.name}/{identifier}{file.suffix}", file.read_bytes()


def _check_complete(resources: Mapping[str, bytes]) -> None:
    """Start the cell once from its own files; raises ``Failure`` (902615)."""
    with tempfile.TemporaryDirectory(prefix="nctakt-fmu-") as folder:
        for name, data in resources.items():
            path = Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(data)
        try:
            Cell(Path(folder)).close()
        except Failure as failure:
            raise Failure(diagnostic(CELL_NOT_COMPLETE), *failure.diagnostics) from failure
