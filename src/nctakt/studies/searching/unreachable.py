# SPDX-License-Identifier: MIT
"""Branches of realtime cycles that no values of a plan can reach, proven by interval arithmetic.

In: a runner. Out: for each such branch the variables that decide, and from where to where they are.
A V.E variable has bounds where only the plan gives it values: no PLC, no simulation model, no
statement of a program writes it. Everything else may have any value.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import fields, is_dataclass

from nctakt.nc import tree
from nctakt.nc.check.cycles.branches import BranchOutline, accesses_in, branch_outlines
from nctakt.nc.outline import ProgramText, bodies_of
from nctakt.run.controller import Controller
from nctakt.run.program_loader import LoadedProgram
from nctakt.studies.plans.dimension import Dimension
from nctakt.studies.plans.inputs import RunInputs
from nctakt.studies.plans.plan import Plan
from nctakt.studies.runs.study_runner import StudyRunner
from nctakt.studies.searching.branch_distance import BranchKey
from nctakt.studies.searching.intervals import Interval, VariableName, can_be, name_of, narrowed

#: For each branch the variables that decide, and their bounds.
Proofs = dict[BranchKey, tuple[tuple[str, Interval], ...]]

#: Run options that let nothing else write a variable.
_HARMLESS = {"ticks", "skip", "from_line", "from_block", "limit_fails", "blocks", "stays"}

#: A V.E variable without indices, of any channel.
_EXTERNAL = re.compile(r"(?:CH\d+\.)?V\.E\.(\w+(?:\.\w+)*)", re.IGNORECASE)

#: How often the conditions around a branch narrow the bounds.
_ROUNDS = 3


def unreachable(runner: StudyRunner) -> Proofs:
    """Return the branches that no values of the plan reach, as far as that can be proven."""
    bounds = _bounds(runner)
    if not bounds:
        return {}
    controller = Controller(runner.machine, None, runner.access)
    program = runner.program_of(RunInputs(), controller)
    if not isinstance(program, LoadedProgram) or not all(map(_is_known, program.texts)):
        return {}
    for text in program.texts:
        for variable in _written_in(text):
            bounds = {name: one for name, one in bounds.items() if not _may_be(variable, name)}
    proofs: Proofs = {}
    for text in program.texts:
        for cycle in text.cycles:
            outlines = branch_outlines(cycle)
            for index in range(len(outlines)):
                decisive = _proof(outlines, index, bounds)
                if decisive is not None:
                    proofs[cycle.span.file, cycle.span.line, index] = decisive
    return proofs


# --- bounds of the variables ---------------------------------------------------------------------


def _bounds(runner: StudyRunner) -> dict[VariableName, Interval]:
    """Return the bounds of the V.E variables that a plan varies or sets."""
    plan = runner.plan
    is_open = bool(plan.plcs) or not {name for name, _ in plan.further} <= _HARMLESS
    texts = ("program_variable", "series")
    if is_open or any(one.kind in texts for one in plan.dimensions):
        return {}
    controller = Controller(runner.machine, None, runner.access)
    bounds: dict[VariableName, Interval] = {}
    unknown = set()
    for target, values in _given(plan):
        match = _EXTERNAL.fullmatch(target)
        if match is None:
            continue
        name = ("E", *match[1].upper().split("."))
        numbers = [value for value in values if not isinstance(value, str)]
        start = controller.read(f"V.E.{match[1]}")
        if len(numbers) < len(values) or isinstance(start, str):
            unknown.add(name)
            continue
        # A whole number, or one of fewer digits, is rounded when it is written.
        own = Interval(math.floor(min(*numbers, start)), math.ceil(max(*numbers, start)))
        bounds[name] = own.hull(bounds.get(name, own))
    return {name: own for name, own in bounds.items() if name not in unknown}


def _given(plan: Plan) -> Iterator[tuple[str, list[float | str]]]:
    """Yield each variable of a plan with the least and the greatest values that it gets."""
    for name, value in plan.assignments:
        yield name, [value]
    for _, name, value in plan.stimuli:
        yield name, [value]
    for dimension in plan.dimensions:
        if dimension.kind in ("variable", "time_of", "noise"):
            yield dimension.target, _values(dimension)


def _values(dimension: Dimension) -> list[float | str]:
    rest: list[float | str] = [dimension.rest, *([dimension.nominal or 0.0])]
    match dimension.kind:
        case "time_of":
            return [*rest, dimension.amount]
        case "noise":
            span = abs(float(dimension.amount))
            return [float(dimension.rest) - span, float(dimension.rest) + span]
    return [*rest, *(dimension.values or (dimension.low, dimension.high))]


# --- writes of programs ---------------------------------------------------------------------------


def _is_known(text: ProgramText) -> bool:
    """Return whether everything that a program runs can be seen in it."""
    unseen = tree.MacroDefinition | tree.StringWord
    return not any(
        isinstance(node, unseen)
        or (isinstance(node, tree.SubprogramCall) and not isinstance(node.name, tree.StringLiteral))
        for statement in _statements(text)
        for node in _nodes(statement)
    )


def _statements(text: ProgramText) -> Iterator[tree.Statement]:
    for section in (text.main, *text.subprograms.values()):
        yield from text.statements(section)


def _nodes(item: object) -> Iterator[tree.Node]:
    """Yield a node and all nodes in it."""
    if isinstance(item, tuple):
        for one in item:
            yield from _nodes(one)
    elif isinstance(item, tree.Node | tree.Head) and is_dataclass(item):
        if isinstance(item, tree.Node):
            yield item
        for field in fields(item):
            yield from _nodes(getattr(item, field.name))


def _written_in(text: ProgramText) -> Iterator[tree.Variable]:
    for statement in _statements(text):
        yield from _written(statement)


def _written(statement: tree.Statement) -> Iterator[tree.Variable]:
    """Yield each variable that a statement may write: all of it but those known to be read."""
    match statement:
        case tree.RealtimeCycle():
            bodies: Iterator[tuple[tree.Statement, ...]] = iter((statement.body,))
        case _:
            bodies = bodies_of(statement)
    for body in bodies:
        for inner in body:
            yield from _written(inner)
    match statement:
        case tree.Assignment():
            yield from _variables(statement.target)
        case tree.For():
            yield from _variables(statement.variable)
        case tree.If() | tree.While() | tree.Do() | tree.Repeat() | tree.Switch():
            pass
        case tree.RealtimeCycle() | tree.RealtimeLoop():
            pass
        case tree.Block():
            words = (tree.Word, tree.AxisWord)
            yield from _variables(tuple(w for w in statement.words if not isinstance(w, words)))
        case _:
            yield from _variables(statement)


def _variables(item: object) -> Iterator[tree.Variable]:
    return (node for node in _nodes(item) if isinstance(node, tree.Variable))


def _may_be(variable: tree.Variable, name: VariableName) -> bool:
    """Return whether a written variable is the named one, or contains it."""
    written = (variable.family.upper(), *(part.name.upper() for part in variable.parts))
    return name[: len(written)] == written


# --- one branch -----------------------------------------------------------------------------------


def _proof(
    outlines: list[BranchOutline], index: int, bounds: dict[VariableName, Interval]
) -> tuple[tuple[str, Interval], ...] | None:
    """Return the variables that keep a branch from running with their bounds; ``None``: it may."""
    conditions = list(_conditions(outlines, index))
    narrow = bounds
    for _ in range(_ROUNDS):
        for condition, truth in conditions:
            narrow = narrowed(condition, truth, narrow)
    is_possible = not any(own.is_empty for own in narrow.values()) and all(
        can_be(condition, truth, narrow) for condition, truth in conditions
    )
    if is_possible:
        return None
    accesses = (access for condition, _ in conditions for access in accesses_in(condition))
    names = (name_of(access) for access in accesses if isinstance(access, tree.Variable))
    read = dict.fromkeys(name for name in names if name in bounds)
    return tuple(("V." + ".".join(name), bounds[name]) for name in read if name is not None)


def _conditions(
    outlines: list[BranchOutline], index: int
) -> Iterator[tuple[tree.Expression, bool]]:
    """Yield conditions that must be true or false in the tick in which a branch runs.

    The body of ``$IF ALWAYS`` keeps running when its condition is no longer true.
    """
    number: int | None = index
    while number is not None:
        outline = outlines[number]
        if outline.condition is not None and (outline.frequency != "ALWAYS" or number == index):
            yield outline.condition, True
        for earlier in outline.earlier:
            condition = outlines[earlier].condition
            if condition is not None:
                yield condition, False
        number = outline.outer
