# SPDX-License-Identifier: MIT
"""The right side of the live page: positions, operator's panel, functions, variables.

In: snapshots. Out: elements of NiceGUI; what a person sets goes to the session as an input of the
page, which acts from the next tick on.
"""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from functools import partial
from typing import Any

from nicegui import ui

from nctakt.live import view
from nctakt.live.document import Document
from nctakt.live.shared import PAGE, SharedSession
from nctakt.live.texts import Texts
from nctakt.live.view import Entry, Snapshot, VariableRow
from nctakt.session.session import Session

#: Lets the session carry out a command; whether it did.
Doer = Callable[[Callable[[Session], object]], Awaitable[bool]]

#: Variables that are shown at once.
_MAX_VARIABLES = 14

#: Largest override of the slider in percent.
_MAX_OVERRIDE = 150


class Panel:
    """Positions, panel, waiting functions and variables of one browser."""

    def __init__(self, shared: SharedSession, document: Document, texts: Texts, do: Doer) -> None:
        self._shared = shared
        self._texts = texts
        self._do = do
        self._rows = view.variable_rows(document.types, shared.lines)
        self._fields: dict[str, Any] = {}
        self._busy: set[str] = set()
        self._waiting: tuple[object, ...] | None = None
        self._build_positions()
        self._build_operator()
        self._build_waiting()
        self._build_variables()

    # --- layout ---------------------------------------------------------------------------------

    def _build_positions(self) -> None:
        self._positions: dict[str, tuple[Any, Any]] = {}
        with ui.element("div").classes("nc-card").style("flex: none"):
            ui.label(self._texts["positions"]).classes("nc-title")
            for axis in self._shared.axes[:5]:
                with ui.element("div").classes("nc-row"):
                    ui.label(axis).classes("text-weight-bold").style("width: 22px")
                    shown = ui.label().classes("nc-number nc-position col text-right")
                    to_go = ui.label().classes("nc-number nc-soft text-right").style("width: 76px")
                    to_go.tooltip(self._texts["to_go"])
                    self._positions[axis] = (shown.props(f"data-testid=axis-{axis}"), to_go)
            with ui.element("div").classes("nc-row"):
                ui.label(self._texts["feed"]).classes("nc-soft col")
                self._speed = ui.label().classes("nc-number").props("data-testid=path-speed")
                ui.label("mm/min").classes("nc-soft")

    def _build_operator(self) -> None:
        texts = self._texts
        with ui.element("div").classes("nc-card").style("flex: none"):
            ui.label(texts["panel"]).classes("nc-title")
            with ui.element("div").classes("nc-row"):
                for name, color in (("start", "positive"), ("reset", "negative")):
                    ui.button(texts[name], on_click=partial(self._press, name.upper())).props(
                        f"dense unelevated size=sm color={color} data-testid={name}"
                    ).classes("col")
            with ui.element("div").classes("nc-row"):
                self._hold = self._switch("hold", "HLI.FEED_HOLD")
                self._single = self._switch("single", "HLI.SINGLE_BLOCK")
            with ui.element("div").classes("nc-row"):
                ui.label(texts["override"]).classes("nc-soft")
                self._override = ui.slider(min=0, max=_MAX_OVERRIDE, step=1, value=100).props(
                    "dense data-testid=override"
                )
                self._override.on("change", self._set_override)
                self._override.on("pan", self._pan_override)
                self._percent = (
                    ui.label()
                    .classes("nc-number")
                    .style("width: 52px; white-space: nowrap; text-align: right")
                )

    def _switch(self, word: str, name: str) -> Any:
        switch = ui.switch(self._texts[word]).props(f"dense size=sm data-testid={word}")
        switch.classes("col nc-soft")
        switch.on_value_change(lambda event: self._set(name, bool(event.value)))
        return switch

    def _build_waiting(self) -> None:
        texts = self._texts
        with ui.element("div").classes("nc-card").style("flex: none"):
            with ui.element("div").classes("nc-row"):
                ui.label(texts["waiting"]).classes("nc-title col")
            self._functions = ui.element("div").classes("nc-row").style("flex-wrap: wrap")
            self._functions.props("data-testid=waiting")

    def _build_variables(self) -> None:
        with ui.element("div").classes("nc-card").style("flex: 1 1 0"):
            with ui.element("div").classes("nc-row"):
                ui.label(self._texts["variables"]).classes("nc-title col")
                ui.input(placeholder=self._texts["search"], on_change=self._search).props(
                    "dense borderless clearable data-testid=search"
                ).style("width: 110px")
            self._variables = ui.element("div").classes("nc-scroll")
        self._show_variables("")

    def _search(self, event: Any) -> None:
        self._show_variables(event.value or "")

    def _show_variables(self, text: str) -> None:
        rows = [row for row in self._rows if text.upper() in row.name.upper()]
        self._fields.clear()
        self._busy.clear()
        self._variables.clear()
        with self._variables:
            for row in rows[:_MAX_VARIABLES]:
                with ui.element("div").classes("nc-row"):
                    ui.label(row.name.removeprefix("V.E.")).classes("nc-soft col ellipsis")
                    self._fields[row.name] = self._field(row)
        self._show_values(self._shared.snapshot)

    def _field(self, row: VariableRow) -> Any:
        test = f"data-testid=variable-{row.name}"
        if row.field == "switch":
            switch = ui.switch().props(f"dense size=sm {test}")
            switch.on_value_change(lambda event: self._set(row.name, bool(event.value)))
            return switch
        step = 1 if row.field == "integer" else "any"
        field = ui.number(step=1 if step == 1 else None).props(f"dense outlined {test}")
        field.style("width: 104px")
        field.on("focus", lambda: self._busy.add(row.name))
        field.on("blur", lambda: self._commit(row.name, field))
        field.on("keydown.enter", lambda: self._commit(row.name, field))
        return field

    # --- what is shown --------------------------------------------------------------------------

    def show(self, snapshot: Snapshot) -> None:
        """Show a snapshot."""
        values = snapshot.values
        for axis, (shown, to_go) in self._positions.items():
            shown.set_text(view.number(values[f"{axis}.ACS.ACT_POS"]))
            to_go.set_text(view.number(values.get(f"{axis}.PCS.DIST_TO_GO", 0.0)))
        speed = values.get("PATH.SPEED", 0.0)
        self._speed.set_text(f"{float(speed) * 60:.0f}")
        override = float(values.get("HLI.OVERRIDE", 100.0))
        if "HLI.OVERRIDE" not in self._busy:
            self._override.set_value(override)
        self._percent.set_text(f"{override:.0f} %")
        self._follow_switch(self._hold, values.get("HLI.FEED_HOLD", 0))
        self._follow_switch(self._single, values.get("HLI.SINGLE_BLOCK", 0))
        self._show_values(snapshot)
        self._show_waiting(snapshot)

    def _follow_switch(self, switch: Any, value: float | bool | str) -> None:
        if switch.value != bool(value):
            switch.set_value(bool(value))

    def _show_values(self, snapshot: Snapshot) -> None:
        for name, field in self._fields.items():
            value = snapshot.values.get(name)
            if value is None or name in self._busy:
                continue
            if isinstance(field, ui.switch):
                self._follow_switch(field, value)
            elif field.value != value:
                field.set_value(value)

    def _show_waiting(self, snapshot: Snapshot) -> None:
        key = tuple(snapshot.waiting)
        if key == self._waiting:
            return
        self._waiting = key
        self._functions.clear()
        with self._functions:
            for channel, entry in snapshot.waiting:
                ui.button(
                    f"{view.function_text(entry)} ✓",
                    on_click=partial(self._acknowledge, channel, entry),
                ).props("dense unelevated no-caps size=sm color=primary").tooltip(
                    self._texts["acknowledge"]
                )
            if not snapshot.waiting:
                ui.label(self._texts["none_waits"]).classes("nc-soft")

    # --- what is set ----------------------------------------------------------------------------

    async def _set(self, name: str, value: float | bool) -> None:
        """Write a value unless it is there already."""
        now = self._shared.snapshot.values.get(name)
        if now is None or float(now) == float(value):
            return
        await self._write(name, value)

    async def _write(self, name: str, value: float | bool) -> None:
        if await self._do(lambda session: session.write({name: value}, PAGE)):
            if not self._shared.snapshot.is_playing:
                ui.notify(f"{name} = {view.plain_number(value)}: {self._texts['next_tick']}")

    async def _press(self, key: str) -> None:
        await self._write(f"HLI.{key}", 1)

    async def _commit(self, name: str, field: Any) -> None:
        self._busy.discard(name)
        if field.value is not None:
            await self._set(name, float(field.value))

    def _pan_override(self, event: Any) -> None:
        (self._busy.add if event.args == "start" else self._busy.discard)("HLI.OVERRIDE")

    async def _set_override(self, event: Any) -> None:
        await self._set("HLI.OVERRIDE", float(event.args))

    async def _acknowledge(self, channel: int, entry: Entry) -> None:
        await self._do(lambda session: session.acknowledge(channel, entry, PAGE))
