# SPDX-License-Identifier: MIT
"""A plan with the files that it needs, for a machine that does not have them.

In: a plan. Out: ``Bundle``, which can be sent; ``unpack`` writes its files to a folder and returns
the plan with the paths there. Built-in machines are part of nctakt and stay where they are.
"""

from __future__ import annotations

import hashlib
from dataclasses import replace
from pathlib import Path

from nctakt.base.dataclass import dataclass
from nctakt.files.access import FileAccess
from nctakt.lists.machine.files import DEMO_FOLDER
from nctakt.project.machine_choice import machine_of
from nctakt.studies.bench import Bench
from nctakt.studies.dimension import Dimension
from nctakt.studies.plan import Plan
from nctakt.studies.python_measure import PythonMeasure


@dataclass(frozen=True, slots=True)
class Bundle:
    """``files``: absolute path -> content; ``built_in``: the name of a built-in machine, if any."""

    plan: Plan
    files: tuple[tuple[str, bytes], ...]
    built_in: str

    @property
    def key(self) -> str:
        """Digits that change with the plan and the files."""
        text = repr((self.plan, self.files))
        return hashlib.sha256(text.encode()).hexdigest()[:16]

    def unpack(self, folder: Path) -> Plan:
        """Write the files below a folder; return the plan with their paths there."""
        for name, content in self.files:
            path = _below(folder, Path(name))
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
        plan = self.plan
        if self.built_in:
            machine = DEMO_FOLDER.parent / self.built_in
        else:
            assert plan.machine is not None
            machine = _below(folder, plan.machine)
        return replace(
            plan,
            program=_below(folder, plan.program) if plan.text is None else plan.program,
            machine=machine,
            plc=None if plan.plc is None else _below(folder, plan.plc),
            dimensions=tuple(_moved(one, folder) for one in plan.dimensions),
            measures=tuple(
                replace(one, node=replace(one.node, file=_below(folder, one.node.file)))
                if isinstance(one.node, PythonMeasure)
                else one
                for one in plan.measures
            ),
        )


def _below(folder: Path, path: Path) -> Path:
    absolute = path.resolve()
    return folder / absolute.relative_to(absolute.anchor)


def _moved(dimension: Dimension, folder: Path) -> Dimension:
    """Return a dimension whose values are the files of series, with their paths in a folder."""
    if dimension.kind != "series":
        return dimension
    values = tuple(str(_below(folder, Path(str(value)))) for value in dimension.values)
    return replace(dimension, values=values)


def bundle(plan: Plan) -> Bundle:
    """Return a plan with its files: program and what it calls, lists, PLC, series, measures."""
    access = FileAccess()
    machine = plan.machine or machine_of(plan.program, access).path
    Bench(plan, access).check()
    built_in = machine.resolve().is_relative_to(DEMO_FOLDER.parent.resolve())
    files = list(access.read_files)
    files += [] if plan.plc is None else [plan.plc]
    files += [Path(str(v)) for one in plan.dimensions if one.kind == "series" for v in one.values]
    files += [one.node.file for one in plan.measures if isinstance(one.node, PythonMeasure)]
    contents = {
        str(path.resolve()): path.read_bytes()
        for path in files
        if not path.resolve().is_relative_to(DEMO_FOLDER.parent.resolve())
    }
    return Bundle(
        replace(plan, machine=machine.resolve()),
        tuple(sorted(contents.items())),
        machine.name if built_in else "",
    )
