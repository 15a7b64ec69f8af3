# SPDX-License-Identifier: MIT
"""The tab that shows where the time of a branch went.

In: a shared session. Out: the tables of ``nctakt time``; a click on a block shows its line.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from nicegui import ui
from nicegui.element import Element

from nctakt.base.failure import Failure, error_text
from nctakt.live.parts.commander import Commander
from nctakt.live.time_account import TimesShown
from nctakt.live.view import location_of
from nctakt.timing.table import TimeTable, TitledTables


class TablesView(Element, component="times.js"):
    """Tables of times."""


class TimeTables:
    """The tables of one browser; built where it is created."""

    def __init__(self, commander: Commander, reveal: Callable[[int, str], None]) -> None:
        self._shared = commander.shared
        self._texts = commander.texts
        self._shown: object = None
        self._state = ui.label().classes("nc-soft").props("role=status data-testid=time-state")
        self._tables = TablesView().props("data-testid=times")
        self._tables.props["channels"] = []
        self._tables.on("line", lambda event: self._reveal(event, reveal))

    def _reveal(self, event: Any, reveal: Callable[[int, str], None]) -> None:
        if isinstance(event.args, int):
            reveal(event.args, "")

    def show(self, file: str) -> None:
        """Show the newest tables; ``file``: the program whose lines can be shown."""
        try:
            times = self._shared.times(self._texts.language)
        except Failure as failure:
            self._state.set_text(error_text(failure))
            return
        state = self._state_of(times)
        if self._state.text != state:
            self._state.set_text(state)
        if self._shown != (id(times.tables), file):
            self._shown = id(times.tables), file
            self._tables.props["channels"] = self._cells(times.tables, file)
            self._tables.update()

    def _state_of(self, times: TimesShown) -> str:
        if times.error is not None:
            return error_text(times.error)
        if not times.latest:
            return self._texts["not_run"]
        name = "times" if times.tick >= times.latest else "times_so_far"
        return self._texts[name].format(tick=times.tick, latest=times.latest)

    def _cells(self, channels: TitledTables, file: str) -> list[Any]:

        def cells(table: TimeTable) -> list[Any]:
            return [table.heads, table.rows, [location_of(one, file, ())[0] for one in table.spans]]

        return [[title, list(map(cells, tables))] for title, tables in channels]
