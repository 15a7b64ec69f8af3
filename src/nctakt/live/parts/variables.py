# SPDX-License-Identifier: MIT
"""V.E variables as switches, fields and sliders by their types.

In: the machine's variables, snapshots. Out: fields that follow the session and write to it.
"""

from __future__ import annotations

from functools import partial
from typing import Any

from nicegui import ui

from nctakt.live.document import Checker
from nctakt.live.parts.commander import Commander
from nctakt.live.parts.naming import card, named
from nctakt.live.view import Snapshot, VariableRow

#: Variables that are shown at once, and how many of the program's have a slider.
_MAX_SHOWN, _MAX_SLIDERS = 24, 8

#: How often a slider that is moved writes, in seconds.
_SLIDING_S = 0.1


class Variables:
    """The V.E variables of one browser."""

    def __init__(self, commander: Commander, checker: Checker) -> None:
        self._commander = commander
        self._shared = commander.shared
        self._texts = commander.texts
        self._types = checker.types
        self._rows = self._shared.channel.variable_rows(self._types)
        self._fields: dict[str, Any] = {}
        self._sliders: dict[str, Any] = {}
        self._busy: set[str] = set()
        with card(self._texts["variables"], "nc-variables"):
            with ui.element("div").classes("nc-row"):
                ui.label(self._texts["variables"]).classes("nc-title col")
                self._search = ui.input(
                    placeholder=self._texts["search"],
                    on_change=lambda event: self._show_rows(event.value or ""),
                )
                self._search.props("dense borderless clearable data-testid=search")
                named(self._search.classes("nc-search"), self._texts["search_variable"])
            self._list = ui.element("div").classes("nc-scroll").props("tabindex=0")
            named(self._list.props("role=group"), self._texts["variables"])
        self._show_rows("")

    def show_session(self) -> None:
        """Show the variables that a new program names first."""
        self._rows = self._shared.channel.variable_rows(self._types)
        self._show_rows(self._search.value or "")

    def focus_search(self) -> None:
        """Let a person type the name of a variable."""
        self._search.run_method("focus")

    # --- rows -----------------------------------------------------------------------------------

    def _show_rows(self, text: str) -> None:
        rows = [row for row in self._rows if text.upper() in row.name.upper()]
        for known in (self._fields, self._sliders, self._busy):
            known.clear()
        self._list.clear()
        with self._list:
            for row in rows[:_MAX_SHOWN]:
                with ui.element("div").classes("nc-row nc-variable"):
                    label = ui.label(row.name.removeprefix("V.E.")).classes("nc-soft col ellipsis")
                    label.tooltip(row.name)
                    self._fields[row.name] = self._field(row)
                if row.is_named and row.field != "switch" and len(self._sliders) < _MAX_SLIDERS:
                    self._sliders[row.name] = self._slider(row)
            if not rows:
                missing = self._texts["no_variable" if self._rows else "no_variables"]
                ui.label(missing).classes("nc-soft")
            elif len(rows) > _MAX_SHOWN:
                more = self._texts["more_variables"].format(count=len(rows) - _MAX_SHOWN)
                ui.label(more).classes("nc-soft")
        self.show(self._shared.snapshot)

    def _field(self, row: VariableRow) -> Any:
        test = f"data-testid=variable-{row.name}"
        if row.field == "switch":
            switch = named(ui.switch().props(f"dense size=sm {test}"), row.name)
            # Controls turned by a person; a value that is only shown is not written.
            switch.on("update:model-value", partial(self._turn, row.name), [None])
            return switch
        field = ui.number(step=1 if row.field == "integer" else None)
        named(field.props(f"dense outlined {test}").classes("nc-field"), row.name)
        field.on("focus", lambda: self._busy.add(row.name))
        field.on("blur", partial(self._commit, row.name, field))
        field.on("keydown.enter", partial(self._commit, row.name, field))
        return field

    def _slider(self, row: VariableRow) -> Any:
        step = 1 if row.field == "integer" else (row.high - row.low) / 200
        slider = ui.slider(min=row.low, max=row.high, step=step).props(
            f"dense data-testid=slider-{row.name}"
        )
        named(slider.classes("nc-slider"), row.name)
        slider.on("pan", partial(self._pan, row.name))
        slider.on(
            "update:model-value",
            partial(self._slide, row.name),
            throttle=_SLIDING_S,
            leading_events=True,
        )
        return slider

    # --- display --------------------------------------------------------------------------------

    def show(self, snapshot: Snapshot) -> None:
        """Show the values of a tick; fields that a person is in stay."""
        for name, field in self._fields.items():
            value = snapshot.values.get(self._shared.channel.prefix + name)
            if value is None or name in self._busy:
                continue
            if isinstance(field, ui.switch):
                value = bool(value)
            if field.value != value:
                field.set_value(value)
            slider = self._sliders.get(name)
            if slider is not None and slider.value != value:
                self._widen(slider, float(value))
                slider.set_value(value)

    def _widen(self, slider: Any, value: float) -> None:
        """Let a slider reach a value that is outside of its range."""
        if value > slider.props["max"]:
            slider.props["max"] = 2 * value
        elif value < slider.props["min"]:
            slider.props["min"] = 2 * value

    # --- settings -------------------------------------------------------------------------------

    async def _write(self, name: str, value: float | bool) -> None:
        await self._commander.write(self._shared.channel.prefix + name, value)

    async def _turn(self, name: str, event: Any) -> None:
        await self._write(name, bool(event.args))

    async def _commit(self, name: str, field: Any, _: Any = None) -> None:
        """Write the content of a field, unless a person has only visited it."""
        self._busy.discard(name)
        now = self._shared.snapshot.values.get(self._shared.channel.prefix + name)
        if field.value is not None and float(field.value) != now:
            await self._write(name, float(field.value))

    def _pan(self, name: str, event: Any) -> None:
        (self._busy.add if event.args == "start" else self._busy.discard)(name)

    async def _slide(self, name: str, event: Any) -> None:
        if isinstance(event.args, int | float):
            await self._write(name, float(event.args))
