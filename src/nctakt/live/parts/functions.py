# SPDX-License-Identifier: MIT
"""Functions and spindle jobs that wait for the PLC, and who acknowledges them.

In: snapshots. Out: a button for each; acknowledgements by hand or after a delay, as inputs.
"""

from __future__ import annotations

from functools import partial
from typing import Any

from nicegui import ui

from nctakt.live import view
from nctakt.live.parts.commander import Commander
from nctakt.live.parts.naming import card, explained, named
from nctakt.live.shared import PAGE
from nctakt.live.view import Entry, Snapshot

#: The delay that is offered first, in ticks.
_FIRST_DELAY = 100

_CNC, _HAND, _AUTOMATIC = "by_cnc", "by_hand", "automatic"


class Functions:
    """The waiting functions of one browser; ``has_plc``: a user's PLC acknowledges them."""

    def __init__(self, commander: Commander, *, has_plc: bool) -> None:
        self._commander = commander
        self._shared = commander.shared
        self._texts = commander.texts
        self._shown: tuple[object, ...] | None = None
        texts = self._texts
        with card(texts["waiting"], "nc-flat"):
            ui.label(texts["waiting"]).classes("nc-title")
            if not has_plc:
                with ui.element("div").classes("nc-row"):
                    self._mode = ui.select(
                        {name: texts[name] for name in (_CNC, _HAND, _AUTOMATIC)},
                        value=self._present_mode(),
                        on_change=self._choose,
                    )
                    self._mode.props("dense options-dense borderless data-testid=acknowledging")
                    named(self._mode.classes("col"), texts["acknowledging"])
                    self._delay = ui.number(value=_FIRST_DELAY, min=1, step=1, format="%d")
                    self._delay.props("dense outlined data-testid=delay").classes("nc-delay")
                    self._delay.on("blur", self._choose).on("keydown.enter", self._choose)
                    explained(self._delay, texts["delay_help"])
                    self._unit = ui.label(texts["delay"]).classes("nc-soft")
                self._show_delay()
            self._has_plc = has_plc
            self._list = ui.element("div").classes("nc-waiting")
            self._list.props("data-testid=waiting role=status")

    def _present_mode(self) -> str:
        delay = self._shared.delay
        return _HAND if delay is None else _AUTOMATIC if delay else _CNC

    def _show_delay(self) -> None:
        is_automatic = self._mode.value == _AUTOMATIC
        self._delay.set_visibility(is_automatic)
        self._unit.set_visibility(is_automatic)

    # --- display --------------------------------------------------------------------------------

    def show(self, snapshot: Snapshot) -> None:
        """Show waiting functions."""
        if not self._has_plc and self._mode.value != self._present_mode():
            self._mode.set_value(self._present_mode())
            self._show_delay()
        key = tuple(snapshot.waiting)
        if key == self._shown:
            return
        self._shown = key
        self._list.clear()
        with self._list:
            for channel, entry in snapshot.waiting:
                number = f"{channel}: " if self._shared.description.channel_count > 1 else ""
                ui.button(
                    f"{number}{view.function_text(entry)} ✓",
                    on_click=partial(self._acknowledge, channel, entry),
                ).props("dense unelevated no-caps size=sm color=primary").tooltip(
                    self._texts["acknowledge"]
                )
            if not snapshot.waiting:
                ui.label(self._texts["none_waits"]).classes("nc-soft")

    # --- actions --------------------------------------------------------------------------------

    async def acknowledge_first(self) -> None:
        """Acknowledge the first waiting function."""
        for channel, entry in self._shared.snapshot.waiting[:1]:
            await self._acknowledge(channel, entry)

    async def _acknowledge(self, channel: int, entry: Entry) -> None:
        await self._commander.do(lambda session: session.acknowledge(channel, entry, PAGE))

    async def _choose(self, _: Any) -> None:
        requested = {_CNC: 0, _HAND: None, _AUTOMATIC: max(1, int(self._delay.value or 1))}
        delay = requested[str(self._mode.value)]
        self._show_delay()
        if delay == self._shared.delay:
            return
        if not self._commander.may():
            self._mode.set_value(self._present_mode())
            return
        await self._commander.attempt(lambda: self._shared.acknowledge_after(delay))
