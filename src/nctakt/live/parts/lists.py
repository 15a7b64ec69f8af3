# SPDX-License-Identifier: MIT
"""The lists below the program: findings, messages, events, why, stops, branches, times.

In: rows. Out: tabs of NiceGUI; a click on a row shows its line.
"""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import PurePath
from typing import Any

from nicegui import background_tasks, ui
from nicegui.element import Element

from nctakt.base.failure import Failure, error_text
from nctakt.live import view
from nctakt.live.parts.branch_list import BranchList
from nctakt.live.parts.commander import Commander, Newest
from nctakt.live.parts.event_search import SearchBar
from nctakt.live.parts.explaining import Moment
from nctakt.live.parts.naming import card, explained, named
from nctakt.live.parts.program_card import ProgramCard
from nctakt.live.plc_view import places_in
from nctakt.live.run_log import MAX_LOG
from nctakt.live.time_account import TimesShown
from nctakt.live.view import LogRow, location_of
from nctakt.results.trace.events import Event
from nctakt.timing.table import TimeTable, TitledTables

NAMES = ("findings", "messages", "events", "why", "stops", "branches", "time")

#: Rows of a list that are shown: the newest.
_MAX_SHOWN = 80

#: The subject of a why-question: a line, and its file of the PLC, empty: the program shown.
Subject = tuple[int, str]

#: The lists of rows, and their refresh interval while the session plays, in seconds.
_ROWS, _DISTANCE_S = ("findings", "messages", "events"), 0.4


class RowsView(Element, component="rows.js"):
    """Rows of a list."""


class Lists:
    """The lists of one browser."""

    def __init__(self, commander: Commander, reveal: Callable[[int, str], None]) -> None:
        self._commander = commander
        self._shared = commander.shared
        self._texts = commander.texts
        self._reveal = reveal
        self._shown: dict[str, object] = {}
        self._matches_shown: object = None
        self._asked = Newest(self._answer)
        self._due_s = 0.0
        self._program: ProgramCard | None = None
        self._list_of: dict[str, Any] = {}
        self._why_of: tuple[Subject, Moment] | None = None
        with card(self._texts["lists"], "nc-lists"):
            with ui.tabs().props("dense align=left no-caps outside-arrows mobile-arrows") as tabs:
                for name in NAMES:
                    ui.tab(name, self._texts[name]).props(f"data-testid=tab-{name}")
            self._tabs = tabs
            tabs.on_value_change(self._turn)
            with ui.tab_panels(tabs, value="findings").classes("nc-scroll bg-transparent"):
                for name in NAMES:
                    with ui.tab_panel(name).classes("q-pa-none").props("tabindex=0"):
                        self._build(name)

    def _build(self, name: str) -> None:
        if name == "stops":
            with ui.element("div").classes("nc-row"):
                self._new = ui.input(placeholder=self._texts["new_stop"])
                self._new.props("dense outlined data-testid=new-stop").classes("col")
                named(self._new, self._texts["stops"])
                self._new.on("keydown.enter", self._add_stop)
                ui.button(self._texts["add"], on_click=self._add_stop).props(
                    "dense flat no-caps size=sm data-testid=add-stop"
                )
        if name == "events":
            self.search = SearchBar(self._commander, _MAX_SHOWN, self._turn)
        if name in _ROWS:
            view_of_rows = RowsView()
            view_of_rows.props["rows"] = []
            view_of_rows.props["word"] = self._texts["line"]
            view_of_rows.props["empty"] = self._texts[f"no_{name}"]
            view_of_rows.props["live"] = "off" if name == "events" else "polite"
            view_of_rows.on("line", self._clicked)
            view_of_rows.on("signal", self._chosen)
            self._list_of[name] = view_of_rows.props(f"data-testid={name}")
            return
        self._list_of[name] = ui.element("div").props(f"data-testid={name}")
        if name == "branches":
            with self._list_of[name]:
                self._branches = BranchList(self._commander)
        if name == "time":
            with self._list_of[name]:
                self._times = TimeTables(self._commander, self._reveal)
        if name == "why":
            with self._list_of[name]:
                self._earlier = ui.label(self._texts["earlier_answer"]).classes("nc-soft")
                self._earlier.set_visibility(False)
                self._why_places = ui.element("div").classes("nc-row nc-why-places")
                self._why = ui.label(self._texts["ask_why"]).classes("nc-why nc-soft")
                self._why.props("role=status")

    def _turn(self, _: Any = None) -> None:
        """Show the present state of another list."""
        self._due_s, self._matches_shown = 0.0, None
        if self._program is not None:
            self.show(self._program)

    def choose(self, name: str) -> None:
        """Show one of the lists."""
        self._tabs.set_value(name)

    # --- rows -----------------------------------------------------------------------------------

    def show(self, program: ProgramCard) -> None:
        """Show new rows in the open list."""
        self._program = program
        shared, log = self._shared, self._shared.log
        if shared.snapshot.is_playing and time.monotonic() < self._due_s:
            return
        self._due_s = time.monotonic() + _DISTANCE_S
        if self._tabs.value == "messages":
            messages = [view.message_row(one) for one in log.messages]
            self._show_rows("messages", self._newest(messages, len(messages) == MAX_LOG))
        elif self._tabs.value == "events" and not self.search.text:
            rows = self._event_rows(program, log.events)
            note = self._texts["begins"].format(tick=log.begin) if log.begin else ""
            is_partial = log.lacks_some or log.begin > 0
            self._show_rows("events", self._newest(rows, is_partial, log.left_out, note))
        self.show_findings(program)
        self._show_stops()
        self._renew_why()
        if self._tabs.value == "branches":
            self._branches.show()

    def _event_rows(self, program: ProgramCard, events: Sequence[Event]) -> list[LogRow]:
        file, plc = program.document.file, self._shared.session.description.plc_texts
        return [view.event_row(one, self._texts.language, file, plc) for one in events]

    def follow(self, program: ProgramCard) -> None:
        """Show by now what the past has been searched for, or what its time went into."""
        if self._tabs.value == "time":
            self._times.show(program.document.file)
        else:
            self._show_matches(program)

    def _show_matches(self, program: ProgramCard) -> None:
        """Show what the search has found by now, if it is open."""
        if self._tabs.value != "events" or not self.search.text:
            return
        tick = self._shared.snapshot.shown_tick
        events, is_done = self.search.shown()
        key = ([id(one) for one in events], is_done, tick, self._shared.scope)
        if key == self._matches_shown:
            return
        self._matches_shown = key
        rows = [
            replace(row, kind=f"{row.kind} current") if event.tick == tick else row
            for row, event in zip(self._event_rows(program, events), events, strict=True)
        ]
        self._show_rows("events", [*self.search.signal_rows(), *rows[::-1]])

    def _newest(
        self, rows: Sequence[LogRow], is_partial: bool, left_out: int = 0, note: str = ""
    ) -> list[LogRow]:
        """Return the newest rows, the last one first, and a note that older ones are not shown.

        ``is_partial``: their number is unknown. ``note``: the text if all these rows are
        shown, but there are more.
        """
        shown = list(rows[-_MAX_SHOWN:])[::-1]
        count = len(rows) - len(shown)
        if is_partial and (count or (left_out and not note)):
            note = self._texts["older_left_out"]
        elif count or (left_out and not note):
            note = self._texts["left_out"].format(count=count + left_out)
        return [*shown, LogRow("note", 0, note)] if note else shown

    def show_findings(self, program: ProgramCard) -> None:
        """Show findings of the texts, and those of the run, but not in a text that is changed."""
        plc, edit = self._shared.session.description.plc_texts, program.plc.edit
        found = {str(one): one for one in (*program.findings, *edit.findings)}
        for one in () if program.is_edited else self._shared.diagnostics:
            if not (edit.is_changed and one.span is not None and one.span.file in plc):
                found.setdefault(str(one), one)
        rows = view.finding_rows(
            list(found.values()), program.document.file, self._texts.language, plc
        )
        count = max(0, len(rows) - _MAX_SHOWN)
        note = [LogRow("note", 0, self._texts["further"].format(count=count))] if count else []
        self._show_rows("findings", [*rows[:_MAX_SHOWN], *note])

    def _show_rows(self, name: str, rows: Sequence[LogRow]) -> None:
        shown = tuple(rows)
        if self._shown.get(name) == shown or self._tabs.value != name:
            return
        self._shown[name] = shown
        cells = [
            [row.kind, row.line, row.text, row.remedy, row.file, row.outside, row.signal]
            for row in shown
        ]
        self._list_of[name].props["rows"] = cells
        self._list_of[name].update()

    def _clicked(self, event: Any) -> None:
        match event.args:
            case [int(line), str(file)] if line:
                self._reveal(line, file)

    async def _chosen(self, event: Any) -> None:
        if isinstance(event.args, str):
            await self.search.add_signal(event.args)

    async def hop(self, *, is_back: bool) -> None:
        """Go to the previous or the next match of the search in the events."""
        self.choose("events")
        await self.search.hop(is_back=is_back)

    def search_events(self) -> None:
        """Let a person type what to look for in the events."""
        self.choose("events")
        self.search.focus()

    # --- why ------------------------------------------------------------------------------------

    async def ask_why(self, line: int, file: str = "") -> None:
        """Show why the condition in a line has its truth; anybody may ask.

        ``file``: one of the PLC; then the writes of the statement in the line, and why.
        """
        self.choose("why")
        await self._asked.request((line, file))

    def _renew_why(self) -> None:
        """Update the answer to the tick shown, or mark it as that of an earlier one."""
        shared = self._shared
        if self._why_of is None or self._tabs.value != "why":
            return
        subject, moment = self._why_of
        is_earlier = moment != shared.moment
        if is_earlier and shared.explainer.knows(shared.moment):
            background_tasks.create(self._asked.request(subject))
        elif self._earlier.visible != is_earlier:
            self._earlier.set_visibility(is_earlier)

    async def _answer(self, subject: Subject) -> None:
        """Show the answer for a line."""
        texts, shared = self._texts, self._shared
        moment = shared.moment
        if not shared.snapshot.tick:
            self._set_why(texts["not_run"], (subject, moment))
            return
        if not shared.explainer.knows(moment):
            self._set_why(texts["explaining"], None)
        try:
            text = await asyncio.to_thread(shared.why, subject[0], texts.language, subject[1])
        except (Failure, RuntimeError) as error:
            text = "\n".join(
                f"{one.id}: {one.text(texts.language)}\n{one.remedy(texts.language)}"
                for one in getattr(error, "diagnostics", ())
            )
            text = text or error_text(error)
        self._why.classes(remove="nc-soft")
        self._set_why(text, (subject, moment))

    def _set_why(self, text: str, subject: tuple[Subject, Moment] | None) -> None:
        self._why_of = subject
        self._why.set_text(text)
        self._earlier.set_visibility(False)
        self._show_places(text)

    def _show_places(self, text: str) -> None:
        """Let a click lead to each line of the PLC that an answer names."""
        found = places_in(text, self._shared.session.description.plc_texts)
        self._why_places.clear()
        with self._why_places:
            for file, line in found:
                ui.button(
                    f"{PurePath(file).name}:{line}",
                    on_click=lambda file=file, line=line: self._reveal(line, file),
                ).props("dense flat no-caps size=sm data-testid=why-place")

    # --- stops ----------------------------------------------------------------------------------

    def _show_stops(self) -> None:
        stops = tuple(self._shared.stops)
        if self._shown.get("stops") == stops:
            return
        self._shown["stops"] = stops
        holder = self._list_of["stops"]
        holder.clear()
        with holder:
            for stop in stops:
                with ui.element("div").classes("nc-row nc-finding stop"):
                    ui.label(stop).classes("col ellipsis")
                    close = ui.button(
                        icon="close", on_click=lambda stop=stop: self._remove_stop(stop)
                    )
                    explained(close.props("dense flat size=xs"), f"{self._texts['remove']}: {stop}")
            if not stops:
                ui.label(self._texts["no_stops"]).classes("nc-soft")

    def begin_stop(self, text: str) -> None:
        """Let a person continue writing a stop."""
        self.choose("stops")
        self._new.set_value(text)
        ui.timer(0.2, lambda: self._new.run_method("focus"), once=True)  # once it is shown

    async def _add_stop(self) -> None:
        text = (self._new.value or "").strip()
        if not text or not self._commander.may():
            return
        stops = [*self._shared.stops, text]
        if await self._commander.attempt(lambda: self._shared.set_stops(stops)):
            self._new.set_value("")

    async def _remove_stop(self, stop: str) -> None:
        if self._commander.may():
            stops = [one for one in self._shared.stops if one != stop]
            await self._commander.attempt(lambda: self._shared.set_stops(stops))


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
