# SPDX-License-Identifier: MIT
"""Findings of a check of bodies, kept while their dependencies do not change.

In: units of a project as they are checked. Out: their findings, from the check or from before. The
trees of unchanged files stay, so that a unit is known by its node.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic
from nctakt.st.check.project import ProjectChecker
from nctakt.st.tree import Call, Declaration, Header, PouNode
from nctakt.st.types import Method, Pou


@dataclass(slots=True, eq=False)
class _Found:
    """Result of a unit's check: findings, and its calls, by their paths."""

    findings: list[Diagnostic]
    calls: list[tuple[str, Call]]

    @property
    def names_neighbours(self) -> bool:
        """Whether a finding suggests the nearest name: another may be nearer by now."""
        return any("nearest" in one.values for one in self.findings)


class UnitMemory:
    """The findings of units; ``poll`` may end a check by an exception."""

    def __init__(self) -> None:
        self.poll: Callable[[], None] = lambda: None
        self._units: dict[Header, _Found] = {}
        self._libraries: dict[str, list[Declaration]] = {}
        self._by_path: dict[str, Pou | Method] = {}

    def begin(self) -> None:
        """Begin a check: the units are others than before."""
        self._by_path.clear()

    def forget(self, nodes: Iterable[Declaration]) -> None:
        """Forget the units of declarations."""
        for node in nodes:
            for unit in units_of(node):
                self._units.pop(unit, None)

    def forget_neighbours(self) -> None:
        """Forget units with findings that suggest a name nearest to a name."""
        for node in [node for node, found in self._units.items() if found.names_neighbours]:
            del self._units[node]

    def check(self, node: Header, unit: Pou | Method, checker: ProjectChecker) -> None:
        """Check a unit, or repeat the findings of its last check."""
        diagnostics = checker.reporter.collector.diagnostics
        known = self._units.get(node)
        if known is not None:
            diagnostics += known.findings
            self._recall(known.calls, unit, checker)
            return
        self.poll()
        begun = len(diagnostics)
        checker.unit_inside(node, unit)
        calls = [(one.path, call) for one, call in checker.callers.get(unit, {}).items()]
        self._units[node] = _Found(diagnostics[begun:], calls)

    def _recall(
        self, calls: list[tuple[str, Call]], unit: Pou | Method, checker: ProjectChecker
    ) -> None:
        """Note whom a unit calls, among the units of this check."""
        if not calls:
            return
        if not self._by_path:
            self._by_path = {one.path: one for one in checker.resolver.nodes}
        for path, call in calls:
            target = self._by_path.get(path)
            if target is not None:
                checker.callers.setdefault(unit, {}).setdefault(target, call)

    def library(self, name: str, parse: Callable[[], list[Declaration]]) -> list[Declaration]:
        """Return the declarations of a known library, parsed once."""
        if name not in self._libraries:
            self._libraries[name] = parse()
        return self._libraries[name]


def units_of(node: Declaration) -> Iterator[Header]:
    """Yield the parts of an object that have their own variables or statements."""
    if isinstance(node, PouNode):
        yield node
        yield from node.methods
        for one in node.properties:
            yield from (accessor for accessor in (one.get, one.set) if accessor is not None)
