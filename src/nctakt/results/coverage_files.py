# SPDX-License-Identifier: MIT
"""Branch coverage in files: JSON, which nctakt reads again, and LCOV for other tools.

In: ``Coverage``. Out: texts of files, the same for the same coverage; or the reverse. The JSON keys
are the fields of the classes in ``coverage.py``; ``ran`` and ``state`` are for readers and are not
read back.
"""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Callable, Iterator
from typing import Any, TypeVar, cast

from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.commands.coverage import INVALID_COVERAGE_DATA
from nctakt.results.coverage import (
    COVERAGE_WORDS,
    WITHOUT_CONDITION,
    BranchCounts,
    ConditionCounts,
    Coverage,
    CoverageWord,
    CycleCounts,
    NearestMiss,
)

#: Version of the file format; no other version is read.
FORM = 1

_FORM_KEY = "nctakt-coverage"
_T = TypeVar("_T")


# --- JSON ----------------------------------------------------------------------------------------


def as_json(coverage: Coverage) -> str:
    """Return the whole coverage as JSON in ASCII."""
    document = {
        _FORM_KEY: FORM,
        "runs": coverage.runs,
        "branches": coverage.branches,
        "ran": coverage.ran,
        "cycles": [_cycle_out(cycle) for cycle in coverage.cycles],
    }
    return json.dumps(document, indent=1) + "\n"


def _cycle_out(cycle: CycleCounts) -> dict[str, object]:
    document = dataclasses.asdict(cycle)
    for branch, written in zip(cycle.branches, document["branches"], strict=True):
        written["state"] = cycle.state(branch)
    return document


def from_json(file: str, text: str) -> Coverage:
    """Return the coverage in a text of ``as_json``; empty text: none yet; ``Failure`` (900801)."""
    if not text.strip():
        return Coverage()
    try:
        document = json.loads(text)
        if document[_FORM_KEY] != FORM:
            raise ValueError(_FORM_KEY)
        return Coverage(_each(document["cycles"], _cycle_in), _count(document["runs"]))
    except (ValueError, ArithmeticError, LookupError, TypeError, RecursionError) as error:
        raise Failure(diagnostic(INVALID_COVERAGE_DATA, file=file)) from error


def _cycle_in(read: Any) -> CycleCounts:
    cycle = CycleCounts(
        _text(read["file"]),
        _count(read["line"]),
        _text(read["name"]),
        _text(read["scope"]),
        _each(read["source"], _text),
        _each(read["outside"], _count),
        _count(read["instances"]),
        _count(read["runs"]),
        _each(read["branches"], _branch_in),
    )
    for index, branch in enumerate(cycle.branches):  # an outer branch comes before its inner ones
        if branch.outer is not None and branch.outer >= index:
            raise ValueError(branch.outer)
    return cycle


def _branch_in(read: Any) -> BranchCounts:
    (word,) = (word for word in COVERAGE_WORDS if word == read["word"])
    return BranchCounts(
        _count(read["line"]),
        _count(read["column"]),
        _text(read["text"]),
        cast("CoverageWord", word),
        _text(read["frequency"]),
        None if read["outer"] is None else _count(read["outer"]),
        _each(read["lines"], _count),
        _count(read["evaluated"]),
        _count(read["bodies"]),
        _condition_in(read["condition"]),
        _each(read["parts"], _condition_in),
    )


def _condition_in(read: Any) -> ConditionCounts:
    return ConditionCounts(
        _text(read["text"]),
        _text(read["operator"]),
        _count(read["true"]),
        _count(read["false"]),
        _miss_in(read["nearest"]),
        _miss_in(read.get("nearest_to_false")),  # absent in files of earlier versions
    )


def _miss_in(read: Any) -> NearestMiss | None:
    return None if read is None else NearestMiss(*(float(read[key]) for key in _MISS))


_MISS = ("left", "right", "distance")


def _each(read: object, item_in: Callable[[Any], _T]) -> tuple[_T, ...]:
    if not isinstance(read, list):
        raise TypeError(read)
    return tuple(item_in(item) for item in read)


def _text(read: object) -> str:
    if not isinstance(read, str):
        raise TypeError(read)
    return read


def _count(read: object) -> int:
    if not isinstance(read, int) or read < 0:
        raise TypeError(read)
    return read


# --- LCOV ----------------------------------------------------------------------------------------


def as_lcov(coverage: Coverage) -> str:
    """Return a tracefile for ``genhtml`` and code hosts.

    A line's count is the number of ticks in which it ran, of Structured Text how often it ran. Each
    condition has two branches, true and false, each label of CASE one; an ``$ELSE`` has none.
    """
    lines: list[str] = []
    for file in dict.fromkeys(cycle.file for cycle in coverage.cycles):
        cycles = [cycle for cycle in coverage.cycles if cycle.file == file]
        lines += ["TN:", f"SF:{file}"]
        branches = [branch for cycle in cycles for branch in _lcov_branches(cycle)]
        lines += [f"BRDA:{line},0,{number},{count}" for line, number, count in branches]
        ran = sum(count not in ("-", "0") for _, _, count in branches)
        lines += [f"BRF:{len(branches)}", f"BRH:{ran}"]
        counts = sorted(count for cycle in cycles for count in _line_counts(cycle).items())
        lines += [f"DA:{line},{count}" for line, count in counts]
        hit = sum(count > 0 for _, count in counts)
        lines += [f"LF:{len(counts)}", f"LH:{hit}", "end_of_record"]
    return "".join(f"{line}\n" for line in lines)


def _lcov_branches(cycle: CycleCounts) -> Iterator[tuple[int, int, str]]:
    """Yield the line, the branch's number in it, and its count (``-``: its line never ran)."""
    numbers: dict[int, int] = {}
    for branch in cycle.branches:
        if branch.word in ("$ELSE", "ELSE", "FOR"):
            continue
        false = () if branch.word in WITHOUT_CONDITION else (branch.condition.false,)
        for count in (branch.bodies, *false):
            number = numbers.get(branch.line, 0)
            numbers[branch.line] = number + 1
            yield branch.line, number, str(count) if branch.evaluated or branch.bodies else "-"


def _line_counts(cycle: CycleCounts) -> dict[int, int]:
    """Return the count of each line; of a line with a condition how often it was reached."""
    counts = dict.fromkeys(cycle.outside, cycle.runs)
    for branch in cycle.branches:
        counts |= dict.fromkeys(branch.lines, branch.bodies)
        counts[branch.line] = max(branch.evaluated, branch.bodies)
    return counts
