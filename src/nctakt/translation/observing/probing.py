# SPDX-License-Identifier: MIT
"""The statements of a PLC program at which a debugger can stop.

In: a checked program. Out: the lines of its own statements; while somebody debugs, the probes that
wrap them. Code of libraries counts as part of the statement that calls it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from nctakt.kernel.st.observing.probes import Probe, StatementCounter
from nctakt.kernel.st.steps import Step
from nctakt.st.program import Program
from nctakt.st.types import Statement
from nctakt.translation.observing.noting import bodies_of
from nctakt.translation.observing.units import own_units


class Probes:
    """The probes of a translation, by where their statements begin."""

    def __init__(self, program: Program) -> None:
        self.counter = StatementCounter()
        self.units = {id(called) for called, _ in own_units(program)}
        self.by_source: dict[int, list[Probe]] = {}

    def probed(self, step: Step, written: Statement) -> Step:
        """Return a statement with a probe before it."""
        probe = Probe(step, written.start, self.counter)
        self.by_source.setdefault(written.start, []).append(probe)
        return probe


def statement_lines(program: Program) -> dict[str, dict[int, int]]:
    """Return, by file and line, the first of the project's statements that begins there."""
    found: dict[str, dict[int, int]] = {}
    for called, _ in own_units(program):
        for statement in _all_of(called.body):
            piece = program.sources.piece_of(statement.start)
            if piece is not None:
                lines = found.setdefault(piece.file, {})
                line = piece.locate(statement.start)[0]
                lines[line] = min(statement.start, lines.get(line, statement.start))
    return found


def _all_of(body: Sequence[Statement]) -> Iterator[Statement]:
    for one in body:
        yield one
        for inner in bodies_of(one):
            yield from _all_of(inner)
