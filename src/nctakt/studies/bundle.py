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
from nctakt.studies.dimension import Dimension
from nctakt.studies.plan import Plan
from nctakt.studies.python_measure import PythonMeasure
from nctakt.studies.schedule_bench import bench_of


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
        machine = None if plan.machine is None else _below(folder, plan.machine)
        if self.built_in:
            machine = DEMO_FOLDER.parent / self.built_in
        return replace(
            plan,
            program=_below(folder, plan.program) if plan.text is None else plan.program,
            machine=machine,
            plc=None if plan.plc is None else _below(folder, plan.plc),
            rtconf=None if plan.rtconf is None else _below(folder, plan.rtconf),
            load=None if plan.load is None else _below(folder, plan.load),
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
    """Return a dimension, values that are files with their paths in a folder."""
    if not dimension.has_files:
        return dimension
    values = tuple(str(_below(folder, Path(str(value)))) for value in dimension.values)
    return replace(dimension, values=values)


def bundle(plan: Plan) -> Bundle:
    """Return a plan with its files: program and what it calls, lists, PLC, series, measures."""
    access = FileAccess()
    bench_of(plan, access).check()
    machine = None
    if not plan.is_schedule:
        machine = (plan.machine or machine_of(plan.program, access).path).resolve()
    own = DEMO_FOLDER.parent.resolve()
    built_in = machine.name if machine is not None and machine.is_relative_to(own) else ""
    files = list(access.read_files)
    files += plan.files
    contents = {
        str(path.resolve()): path.read_bytes()
        for path in files
        if not path.resolve().is_relative_to(own)
    }
    return Bundle(replace(plan, machine=machine), tuple(sorted(contents.items())), built_in)
