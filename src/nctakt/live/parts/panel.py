# SPDX-License-Identifier: MIT
"""Positions and operator's panel of the shown channel.

In: snapshots. Out: elements of NiceGUI; a person's settings go to the session as inputs of the
page, which act from the next tick on.
"""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Sequence
from functools import partial
from typing import Any

from nicegui import ui

from nctakt.live.parts.commander import Commander
from nctakt.live.parts.naming import card, named
from nctakt.live.view import Snapshot

#: Largest override of the slider in percent, and a step by key.
_MAX_OVERRIDE, _STEP = 150, 5

#: Axes whose positions are shown.
_MAX_AXES = 6

#: Switches: their word, and the value of the HLI.
SWITCHES = {"hold": "FEED_HOLD", "single": "SINGLE_BLOCK", "backward": "BACKWARD_MOTION"}

#: Number of updates for which a switch shows a person's setting if no tick takes it over.
_PATIENCE = 40

_ALL = ""


class Panel:
    """Positions and operator's panel of one browser; ``programs``: those that may be chosen."""

    def __init__(
        self,
        commander: Commander,
        programs: Sequence[str],
        choose_program: Callable[[str | None], Awaitable[None]],
    ) -> None:
        self._commander = commander
        self._shared = commander.shared
        self._texts = commander.texts
        self._programs = programs
        self._choose_program = choose_program
        self._axes: list[str] = []
        self._is_panning = False
        self._switches: dict[str, Any] = {}
        self._requested: dict[str, tuple[bool, int]] = {}
        with card(self._texts["positions"], "nc-flat") as self._positions:
            pass
        self._build_positions()
        self._build_operator()

    # --- layout ---------------------------------------------------------------------------------

    def _build_positions(self) -> None:
        self._axes = list(self._shared.channel.axes[:_MAX_AXES])
        self._positions.clear()
        with self._positions:
            with ui.element("div").classes("nc-row"):
                ui.label(self._texts["positions"]).classes("nc-title col")
                ui.label(self._texts["to_go"]).classes("nc-soft")
            for axis in self._axes:
                with ui.element("div").classes("nc-row"):
                    ui.label(axis).classes("text-weight-bold nc-axis")
                    shown = ui.label().classes("nc-number nc-position col text-right")
                    shown.props(f"data-testid=axis-{axis}")
                    rest = ui.label().classes("nc-number nc-soft nc-rest")
                    rest.props(f"data-testid=rest-{axis}")
            with ui.element("div").classes("nc-row"):
                ui.label(self._texts["feed"]).classes("nc-soft col")
                ui.label().classes("nc-number").props("data-testid=path-speed")
                ui.label("mm/min").classes("nc-soft")

    def _build_operator(self) -> None:
        texts = self._texts
        with card(texts["panel"], "nc-flat"):
            with ui.element("div").classes("nc-row"):
                ui.label(texts["panel"]).classes("nc-title col")
                self._state = ui.label().classes("nc-soft ellipsis")
                self._state.props("data-testid=nc-state role=status")
            if len(self._programs) > 1:
                options = {_ALL: texts["all_programs"], **{name: name for name in self._programs}}
                with ui.element("div").classes("nc-row"):
                    ui.label(texts["program"]).classes("nc-soft")
                    choice = ui.select(options, value=_ALL, on_change=self._chosen)
                    choice.props("dense options-dense borderless data-testid=program")
                    named(choice.classes("col nc-choice"), texts["program"])
            with ui.element("div").classes("nc-row"):
                for name, color in (("start", "positive"), ("reset", "negative")):
                    button = ui.button(texts[name], on_click=partial(self.press, name))
                    button.props(f"dense unelevated size=sm color={color} data-testid={name}")
                    button.classes("col")
            with ui.element("div").classes("nc-switches"):
                for word in SWITCHES:
                    switch = ui.switch(texts[word]).props(f"dense size=sm data-testid={word}")
                    # Controls turned by a person; a value that is only shown commands nothing.
                    switch.on("update:model-value", partial(self._switched, word), [None])
                    self._switches[word] = switch
            self._switches["backward"].tooltip(texts["no_history"])
            with ui.element("div").classes("nc-row"):
                ui.label(texts["override"]).classes("nc-soft")
                self._override = ui.slider(min=0, max=_MAX_OVERRIDE, step=1, value=100)
                self._override.props("dense data-testid=override").classes("col")
                named(self._override, texts["override"])
                self._override.on("change", self._set_override)
                self._override.on("pan", self._pan)
                ui.label().classes("nc-number nc-percent").props("data-testid=percent")

    # --- display --------------------------------------------------------------------------------

    def show(self, snapshot: Snapshot) -> None:
        """Show the state of the panel; the numbers come with the drawings' increments."""
        if self._axes != list(self._shared.channel.axes[:_MAX_AXES]):
            self._build_positions()
        values = snapshot.values
        prefix = f"{self._shared.channel.prefix}HLI."
        for word, name in SWITCHES.items():
            value = bool(values.get(prefix + name, 0))
            if not self._awaits(word, value) and self._switches[word].value != value:
                self._switches[word].set_value(value)
        has_history = bool(values.get(f"{prefix}HISTORY_SIZE", 0))
        if self._switches["backward"].enabled != has_history:
            self._switches["backward"].set_enabled(has_history)
        override = float(values.get(f"{prefix}OVERRIDE", 100.0))
        if not self._is_panning and self._override.value != override:
            self._override.set_value(override)
        shown = ""
        if error := int(values.get(f"{prefix}ERROR", 0)):
            shown = f"{self._texts['machine_error']} {error}"
        elif values.get(f"{prefix}ARMED") or values.get(f"{prefix}PAUSED"):
            shown = self._texts["armed"]
        elif snapshot.awaited is not None:
            shown = f"{self._texts['waits']} {snapshot.awaited.get(self._texts.language)}"
        if self._state.text != shown:
            self._state.set_text(shown)

    # --- settings -------------------------------------------------------------------------------

    async def press(self, name: str) -> None:
        """Press START or RESET."""
        await self._commander.press(name.upper())

    async def flip(self, word: str) -> None:
        """Turn a switch."""
        if self._switches[word].enabled:
            await self._set(word, not self._switches[word].value)

    async def change_override(self, steps: int) -> None:
        """Change the override by steps of 5 %."""
        name = f"{self._shared.channel.prefix}HLI.OVERRIDE"
        now = float(self._shared.snapshot.values.get(name, 100.0))
        requested = max(0.0, min(_MAX_OVERRIDE, now + _STEP * steps))
        await self._commander.write(name, requested)

    async def _switched(self, word: str, event: Any) -> None:
        await self._set(word, bool(event.args))

    async def _set(self, word: str, value: bool) -> None:
        """Set a switch; until a tick has taken it over, it shows the person's setting."""
        self._requested[word] = (value, _PATIENCE)
        name = f"{self._shared.channel.prefix}HLI.{SWITCHES[word]}"
        if not await self._commander.write(name, value):
            self._requested.pop(word, None)

    def _awaits(self, word: str, value: bool) -> bool:
        """Return whether a switch waits for a tick that takes over its setting."""
        requested, looks = self._requested.get(word, (value, 0))
        if requested == value or looks == 0:
            self._requested.pop(word, None)
            return False
        self._requested[word] = (requested, looks - 1)
        return True

    def _pan(self, event: Any) -> None:
        self._is_panning = event.args == "start"

    async def _set_override(self, event: Any) -> None:
        if isinstance(event.args, int | float):
            await self._commander.write(
                f"{self._shared.channel.prefix}HLI.OVERRIDE", float(event.args)
            )

    async def _chosen(self, event: Any) -> None:
        await self._choose_program(str(event.value) or None)
