# SPDX-License-Identifier: MIT
"""Variables named in the cursor's line of a PLC file, as a tree below the lines.

In: a file, a line with the paths that it names, a call or instance. Out: rows that a person unfolds
and folds; they follow the tick of the session.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from nicegui import run, ui
from nicegui.element import Element

from nctakt.base.dataclass import dataclass
from nctakt.base.failure import Failure
from nctakt.live.parts.commander import Newest
from nctakt.live.shared import SharedSession
from nctakt.live.texts import Texts

#: Paths that stay unfolded at most.
_MAX_OPENED = 500


class PlcBranches(Element, component="plc_tree.js"):
    """The rows of the tree."""


@dataclass(frozen=True, slots=True)
class TreeRequest:
    """Request for a tree: a state of the session, a line of a file, a call or instance."""

    number: int
    file: str
    line: int
    paths: tuple[str, ...]
    level: int
    instance: str


class PlcTree:
    """The tree of one browser; it is shown if a line names a variable with parts."""

    def __init__(self, shared: SharedSession, texts: Texts) -> None:
        self._shared = shared
        self._opened: dict[str, dict[str, None]] = {}
        self._request: TreeRequest | None = None
        self._looks = Newest(self._look)
        self._branches = PlcBranches()
        self._branches.props["rows"], self._branches.props["name"] = [], texts["plc_tree"]
        self._branches.on("fold", self._fold)

    def show(self, request: TreeRequest) -> None:
        """Show the variables named in a line, if they are not shown yet."""
        if request != self._request:
            self._request = request
            self._later(request)

    def focus(self) -> None:
        """Let the keys move in the tree."""
        self._branches.run_method("focus")

    def _later(self, request: TreeRequest) -> None:
        ui.timer(0, lambda: self._looks.request(request), once=True)

    def _fold(self, event: Any) -> None:
        """Expand or collapse the part below a path."""
        if self._request is None or not isinstance(event.args, str):
            return
        opened = self._opened.setdefault(self._request.file, {})
        if event.args in opened:
            del opened[event.args]
        elif len(opened) < _MAX_OPENED:
            opened[event.args] = None
        self._later(self._request)

    async def _look(self, request: TreeRequest) -> None:
        opened = self._opened.get(request.file, {})
        look: Callable[..., Any] = self._shared.session.tree_beside
        line = (request.line, request.paths)
        try:
            found = await run.io_bound(
                look, request.file, line, tuple(opened), request.level, request.instance
            )
        except (Failure, RuntimeError):
            return  # the session has ended meanwhile, or was restarted
        if request != self._request:
            return
        found = found or []
        rows = [
            {
                "depth": depth,
                "name": value.name,
                "path": value.path,
                "type": value.type,
                "text": value.text,
                "count": value.count,
                "isOpen": value.path in opened,
            }
            for depth, value in found
        ]
        if not any(value.count for _, value in found):
            rows = []
        if rows != self._branches.props["rows"]:
            self._branches.props["rows"] = rows
            self._branches.update()
