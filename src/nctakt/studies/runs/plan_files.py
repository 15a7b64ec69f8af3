# SPDX-License-Identifier: MIT
"""All files that the runs of a plan depend on.

In: a plan. Out: program and files it calls, lists, schedule, series, PLC with its inputs, measures,
and the user's modules that PLC and measures import.
"""

from __future__ import annotations

from pathlib import Path

from nctakt.base.dataclass import dataclass
from nctakt.files.access import FileAccess
from nctakt.plc.loading import input_file_of
from nctakt.run.plcs.realtime_plc import is_structured
from nctakt.studies.measuring.python_measure import PythonMeasure
from nctakt.studies.plans.plan import Plan
from nctakt.studies.plans.user_modules import UserModules
from nctakt.studies.runs.schedule_runner import runner_of


@dataclass(frozen=True, slots=True)
class PlanFiles:
    """``files``: without those of ``modules``; ``shown``: their names in messages."""

    files: tuple[Path, ...]
    modules: UserModules
    shown: tuple[str, ...]


def files_of(plan: Plan) -> PlanFiles:
    """Return the files of a plan; raises ``Failure`` for a plan that cannot be used."""
    access = FileAccess()
    runner_of(plan, access).check()
    files = [*access.read_files, *plan.files]
    functions = [one.node for one in plan.measures if isinstance(one.node, PythonMeasure)]
    sources = [one.file for one in functions if one.function is None]
    sources += [one for one in access.read_files if one.suffix == ".py"]
    for plc in plan.plcs:
        if is_structured(plc):
            files.append(plc)
            continue
        sources.append(plc)
        inputs = input_file_of(plc)
        files += [] if inputs is None else [inputs]
    modules = UserModules()
    modules.trace(sources)
    for one in functions:
        if one.function is not None:
            modules.add(one.function.__module__.partition(".")[0])
    shown: dict[Path, str] = {}
    for path in files:
        shown.setdefault(path.resolve(), path.as_posix())
    return PlanFiles(tuple(shown), modules, tuple(shown.values()))
