# SPDX-License-Identifier: MIT
"""Simulation and analysis for other programs, as JSON has them.

In: the data that ``report`` shows as tables. Out: dictionaries of plain values; times in µs,
``None`` where there is none. Keys are the same in every language.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from nctakt.schedule.analysis.analyse import Analysis
from nctakt.schedule.analysis.margins import Margins
from nctakt.schedule.effective_table import EffectiveRow
from nctakt.schedule.model import NS_PER_US, Model, Task
from nctakt.schedule.reports.report import rounded_mean
from nctakt.schedule.simulation.responses import PERCENTILES_PER_MILLE
from nctakt.schedule.simulation.results import Simulation, TaskNumbers, WindowsNumbers

#: The most bars of a histogram.
_MAX_BARS = 100

Document = dict[str, object]


def effective_document(rows: Sequence[EffectiveRow]) -> Document:
    """Return the list as written and as effective."""
    return {
        "parameters": [
            {
                "id": row.id,
                "name": row.key,
                "line": row.line or None,
                "raw": row.raw or None,
                "effective": row.effective,
                "unit": row.unit,
                "reason": row.reason,
            }
            for row in rows
        ]
    }


def simulation_document(run: Simulation, worst_phases: Mapping[int, Simulation]) -> Document:
    """Return the numbers of a simulation, or of a run."""
    document: Document = {"schedule": schedule_document(run.model), **_numbers(run)}
    if worst_phases:
        document["worst_phases"] = [
            {"phase_us": _us(phase), **_numbers(other)} for phase, other in worst_phases.items()
        ]
    return document


def analysis_document(analysis: Analysis, margins: Margins, run: Simulation) -> Document:
    """Return the bounds, next to the responses of a simulation, and the margins."""
    tasks = zip(analysis.model.tasks, analysis.tasks, run.tasks, strict=True)
    return {
        "schedule": schedule_document(analysis.model),
        "threads": [
            {
                **_names(task),
                "demand_us": _us(bound.demand),
                "period_us": _us(bound.period),
                "response_bound_us": _us(bound.response),
                "is_exact": bound.is_exact,
                "response_simulated_us": _us(numbers.response_max),
                "slack_us": _us(bound.slack),
                "can_overflow": bound.can_overflow,
                "worst_phase_us": _us(analysis.phases.get(i)),
            }
            for i, (task, bound, numbers) in enumerate(tasks)
        ],
        "cpus": [
            {
                "cpu": cpu.cpu,
                "demand_pct": round(100 * cpu.demand, 3),
                "supply_pct": round(100 * cpu.suspendable_supply, 3),
                "reaches_windows": cpu.reaches_windows,
            }
            for cpu in analysis.cpus
        ],
        "margins": _margins(margins),
    }


def _margins(margins: Margins) -> Document:
    return {
        "functions": [
            {
                "function": margin.function,
                "present_us": _us(margin.present),
                "limit_us": _us(margin.limit),
                "change_us": _us(margin.change),
            }
            for margin in margins.functions
        ],
        "factors": [{"cpu": margin.cpu, "factor": margin.factor} for margin in margins.factors],
        "windows_time_us": _us(margins.windows_time),
        "cycle_time_us": _us(margins.cycle_time),
    }


def schedule_document(model: Model) -> Document:
    """Return the times of the list and the rules that were chosen."""
    return {
        "interrupt": model.source.value,
        "cycle_time_us": _us(model.cycle),
        "time_slice_us": _us(model.slice),
        "windows_time_us": _us(model.windows),
        "phase_us": _us(model.train.phase) if model.train.is_phase_known else None,
        "overflow": model.rules.overflow,
        "calls": model.rules.calls,
        "suspension": model.rules.suspension,
        "seed": model.seed,
    }


def _numbers(run: Simulation) -> Document:
    return {
        "cycles": run.cycles,
        "duration_us": _us(run.duration),
        "repeats_after": run.repeats_after,
        "threads": [
            {**_names(task), **_thread(run, task, numbers)}
            for task, numbers in zip(run.model.tasks, run.tasks, strict=True)
        ],
        "windows": [_windows(run, windows) for windows in run.windows],
    }


def _names(task: Task) -> Document:
    return {
        "key": task.key,
        "name": task.name,
        "class": task.kind.value,
        "cpu": task.cpu or None,
    }


def _thread(run: Simulation, task: Task, numbers: TaskNumbers) -> Document:
    mean = rounded_mean(numbers.response_sum, numbers.completed) if numbers.completed else None
    return {
        "period_us": _us(task.every * run.model.train.distance),
        "due": numbers.due,
        "completed": numbers.completed,
        "load_pct": round(100 * numbers.busy / run.duration, 3),
        "response_min_us": _us(numbers.response_min),
        "response_mean_us": _us(mean),
        "response_max_us": _us(numbers.response_max),
        "percentiles_us": {
            f"{share / 10:g}": _us(numbers.responses.percentile(share))
            for share in PERCENTILES_PER_MILLE
        },
        "histogram_us": [
            [_us(low), _us(high), count] for low, high, count in numbers.responses.bars(_MAX_BARS)
        ],
        "overflows": numbers.overflows,
        "lost": numbers.lost,
        "suspensions": numbers.suspensions,
    }


def _windows(run: Simulation, windows: WindowsNumbers) -> Document:
    names = [task.name for task in run.model.tasks]
    return {
        "cpu": windows.cpu or None,
        "share_pct": round(100 * windows.total / run.duration, 3),
        "min_us": _us(windows.minimum),
        "mean_us": _us(rounded_mean(windows.total, run.cycles)),
        "max_us": _us(windows.maximum),
        "cycles_below": windows.violated,
        "late_suspensions": windows.late,
        "culprits": {
            name: count for name, count in zip(names, windows.culprits, strict=True) if count
        },
    }


def _us(time: int | None) -> float | None:
    return None if time is None else time / NS_PER_US
