# SPDX-License-Identifier: MIT
"""A run and its plan for other programs, as JSON documents.

In: ``Plan``, ``Measurement``. Out: dictionaries of plain values, as in
``schedule.reports.documents``.
"""

from __future__ import annotations

from nctakt.schedule.model import ANY_CPU, NS_PER_US
from nctakt.schedule.real.measure import Measurement
from nctakt.schedule.real.plan import Plan
from nctakt.schedule.reports.documents import Document, schedule_document, simulation_document
from nctakt.schedule.simulation.results import Simulation


def plan_document(plan: Plan) -> Document:
    """Return the threads of a run with their priorities, processors and semaphores."""
    return {
        "schedule": schedule_document(plan.model),
        "is_fifo": plan.is_fifo,
        "threads": [
            {
                "key": planned.task.key,
                "name": planned.task.name,
                "class": planned.task.kind.value,
                "linux_cpu": None if planned.task.cpu == ANY_CPU else planned.task.cpu - 1,
                "fifo_priority": planned.priority if plan.is_fifo else None,
                "semaphore": planned.semaphore or None,
                "has_process": planned.has_process,
            }
            for planned in plan.tasks
        ],
    }


def run_document(measurement: Measurement, simulated: Simulation) -> Document:
    """Return a run, its punctuality, and the simulation for comparison."""
    names = [task.key for task in measurement.run.model.tasks]
    return {
        **simulation_document(measurement.run, {}),
        "simulated": simulation_document(simulated, {}),
        "latencies_us": {
            "timer": [time / NS_PER_US for time in measurement.timer],
            **{
                name: [time / NS_PER_US for time in times]
                for name, times in zip(names, measurement.wakes, strict=True)
            },
        },
    }
