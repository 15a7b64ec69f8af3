# SPDX-License-Identifier: MIT
"""Scope and path on the page: elements of NiceGUI around ``scope.js`` and ``path.js``.

In: the track of the shared session, requests of a person. Out: increments to the browser; travels,
stretches in detail.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from nicegui import ui
from nicegui.element import Element

from nctakt.base.dataclass import dataclass, field
from nctakt.base.failure import Failure
from nctakt.live import view
from nctakt.live.conditions import MAX_FILTER, Condition, fitting
from nctakt.live.parts.commander import Commander, Newest
from nctakt.live.parts.naming import card, explained, named
from nctakt.live.parts.saving import Saving
from nctakt.live.track import Seen

_HERE = Path(__file__).parent
_MODULES = {
    "nctakt-store": str(_HERE / "store"),
    "nctakt-drawing": str(_HERE.parent / "plots" / "drawing"),
}


#: Increments under way to a browser that has not drawn them yet; one more says whether the session
#: runs.
MAX_UNDER_WAY = 2

#: Sides from which the path can be seen.
_VIEWS = ("space", "top", "front", "side")

#: Colours of channels (page.css, path.js).
_CHANNEL_COLOURS = 4


class Scope(Element, component="scope.js", esm=_MODULES):
    """The scope; it takes the increments for all drawings of the page."""


class PathView(Element, component="path.js", esm=_MODULES):
    """The path of the tool."""


@dataclass(slots=True)
class _Sent:
    """What the browser has got: the latest content, whether the log, how many increments.

    ``drawn``: how many of these it has drawn.
    """

    content: dict[str, Any] = field(default_factory=dict)
    has_log: bool = False
    number: int = 0
    drawn: int = 0


class Drawings:
    """Scope and path of one browser.

    ``go_on`` is called when it has drawn everything under way while the session is stopped.
    """

    def __init__(
        self,
        commander: Commander,
        limits: Mapping[str, Sequence[float | None]],
        go_on: Callable[[], None],
    ) -> None:
        self._commander = commander
        self._limits = limits
        self._go_on = go_on
        self._shared = commander.shared
        self._texts = commander.texts
        self._seen: dict[str, Seen] = {}
        self._sent = _Sent()
        self._has_offered = False
        self._stretches = Newest(self._send_stretch)
        self._build_scope()
        self._build_path()

    # --- layout ---------------------------------------------------------------------------------

    def _build_scope(self) -> None:
        texts = self._texts
        with card(texts["scope"], "nc-scope"):
            with ui.element("div").classes("nc-row"):
                ui.label(texts["scope"]).classes("nc-title")
                with ui.element("div").classes("nc-hint"):
                    ui.label(texts["travel"]).classes("nc-soft").props("data-testid=scope-hint")
                for name, icon in (
                    ("zoom_out", "zoom_out"),
                    ("zoom_in", "zoom_in"),
                    ("scope_fit", "fit_screen"),
                ):
                    button = ui.button(icon=icon).props(f"flat dense size=sm data-testid={name}")
                    explained(button.on("click", js_handler=_ZOOMS[name]), texts[name])
                self._build_filter()
                Saving(self._commander)
                self._signals = (
                    ui.select(
                        list(self._shared.scope),
                        multiple=True,
                        value=list(self._shared.scope),
                        on_change=self._choose,
                        with_input=True,
                    )
                    .props(
                        f"dense options-dense borderless max-values={view.MAX_SIGNALS} "
                        f'display-value="{texts["signals"]}" data-testid=signals'
                    )
                    .classes("nc-signals")
                )
                self._signals.on("focus", self._offer_signals)
                named(self._signals, texts["signals"])
            self._scope = Scope().props("data-testid=scope")
            self._scope.props["words"] = {
                "line": texts["line"],
                "ticks": texts["delay"],
                "log": texts["logged"],
            }
            self._scope.props["name"] = texts["scope_name"]
            self._scope.on("travel", self._travel)
            self._scope.on("stretch", self._request_stretch)
            ui.on("nctakt_taken", self.note_drawn)
            self._scope.on("kept", self._restore_filter)

    def _build_filter(self) -> None:
        """Build the field that filters the conditions; it exists if there are several."""
        texts = self._texts
        self._filter = ui.input(placeholder=texts["filter_short"], on_change=self._keep_filter)
        self._filter.props(
            f"dense borderless clearable debounce=150 maxlength={MAX_FILTER} "
            "data-testid=lanes-filter"
        )
        explained(self._filter.classes("nc-filter"), texts["filter_lanes"])
        self._fitting = ui.label().classes("nc-soft nc-clock")
        self._fitting.props("data-testid=lanes-fitting role=status")

    def _build_path(self) -> None:
        texts = self._texts
        with card(texts["path"], "nc-path"):
            with ui.element("div").classes("nc-row"):
                ui.label(texts["path"]).classes("nc-title")
                with ui.element("div").classes("nc-keys"):
                    self._channels = ui.element("div").classes("nc-keys nc-channels")
                    for name in ("rapid_line", "fired_mark", "future_line"):
                        ui.label(texts[name]).classes(f"nc-key {name}")
                    self._future = ui.label().classes("nc-soft ellipsis")
                    self._future.props("data-testid=future role=status")
                self._axes = ui.switch(texts["machine_axes_short"], on_change=self._show_axes)
                self._axes.props("dense size=sm data-testid=machine-axes").classes("nc-choose")
                explained(self._axes, texts["machine_axes"])
                self._views = ui.button(icon="view_in_ar")
                explained(
                    self._views.props("flat dense size=sm data-testid=turn"), texts["turn_view"]
                )
                with self._views, ui.menu():
                    for name in _VIEWS:
                        item = ui.menu_item(texts[f"view_{name}"], partial(self._choose_view, name))
                        item.props(f"role=menuitem data-testid=view-{name}")
            self._path = PathView().props("data-testid=path")
            self._path.props["name"] = texts["path_name"]
            self._name_columns()
            self._path.on("travel", self._travel)

    # --- following ------------------------------------------------------------------------------

    @property
    def are_behind(self) -> bool:
        """Whether the browser has not yet drawn what was sent: it is busy, or asleep.

        Whether the session runs is sent nevertheless, once.
        """
        is_urgent = self._sent.content.get("isPlaying") is not self._shared.snapshot.is_playing
        return self._sent.number - self._sent.drawn >= MAX_UNDER_WAY + is_urgent

    def note_drawn(self, event: Any) -> None:
        """Take up to which increment a browser has drawn."""
        if isinstance(event.args, int) and self._sent.drawn < event.args <= self._sent.number:
            was_behind = self.are_behind
            self._sent.drawn = event.args
            if was_behind and not self._shared.snapshot.is_playing:
                self._go_on()

    def follow(self, texts: dict[str, str]) -> None:
        """Send new data; ``texts``: those of the readings that have changed."""
        shared, snapshot = self._shared, self._shared.snapshot
        track, shown = shared.track, shared.track.shown
        news: dict[str, Any] = {"texts": texts} if texts else {}
        now: dict[str, Any] = {
            "names": list(shown.signals),
            "units": list(shown.units),
            "booleans": [name in shared.description.booleans for name in shown.signals],
            "conditions": [one.line for one in shown.conditions],
            "lanesShown": self._lanes_shown(shown.conditions),
            "hidden": shown.hidden,
            "cycleUs": shared.description.cycle_time_us,
            "tick": snapshot.shown_tick,
            "latest": snapshot.latest - 1,
            "block": view.block_line(snapshot, shared.channel.number, shared.channel.file),
            "now": view.values_of(snapshot, shown.signals),
            "isPlaying": snapshot.is_playing,
            "bars": shared.explainer.bars(shared.moment, shared.channel.file),
        }
        if self._sent.drawn:  # first of all the present
            now["future"] = shared.ahead.shown(shared.future_subject)
        self._show_future(now.get("future"))
        for name, part in track.parts.items():
            found, self._seen[name] = part.news(self._seen.get(name, (0, 0)))
            if found is not None:
                news[name] = found
        if shown is not track.shown:
            self._seen.clear()  # it has changed meanwhile: all of it at the next look
            return
        if list(self._signals.value) != shared.scope:  # another browser has chosen
            self._show_signals()
        news |= {
            name: value for name, value in now.items() if self._sent.content.get(name) != value
        }
        self._sent.content = now
        if not self._sent.has_log:  # it never changes
            self._sent.has_log = True
            news["logged"] = shared.logged
        if news:
            self._sent.number += 1
            self._scope.run_method("take", news | {"number": self._sent.number})

    def _lanes_shown(self, conditions: Sequence[Condition]) -> list[int]:
        """Return the places of the conditions that fit the filter, and say how many they are."""
        request = str(self._filter.value or "")
        found = fitting(conditions, request)
        text = f"{len(found)}/{len(conditions)}" if request.strip() else ""
        if self._fitting.text != text:
            self._fitting.set_text(text)
        self._filter.set_visibility(len(conditions) > 1 or bool(request))
        return found

    def _show_future(self, future: dict[str, Any] | None) -> None:
        """Say why the predicted path ends there, or that there is none to show."""
        text = ""
        if future is not None:
            causes = future["causes"][self._texts.language]
            name = "error" if causes and future["reason"] == "over" else future["reason"]
            text = self._texts[f"future_{name}"].format(causes=causes)
        if self._future.text != text:
            self._future.set_text(text)

    def show_session(self) -> None:
        """Show the signals and axes of a session that is new."""
        self._show_signals()
        axes = list(self._shared.channel.path)
        if self._path.props["axes"] != axes:
            self._name_columns()
            self._path.update()

    def _offer_signals(self) -> None:
        """Offer all signals; before the first search, the browser has only those shown."""
        if not self._has_offered:
            self._has_offered = True
            self._show_signals()

    def _show_signals(self) -> None:
        """Show which signals are chosen; they come first, so that the others keep their places."""
        scope = self._shared.scope
        others = view.choosable(self._shared.description.signals) if self._has_offered else ()
        self._signals.set_options(list(dict.fromkeys((*scope, *others))), value=list(scope))

    def _name_columns(self) -> None:
        """Let the path know the columns of its positions, and the limits of its axes."""
        channel = self._shared.channel
        self._path.props["axes"] = list(channel.path)
        self._path.props["tip"] = list(channel.tip[:3])
        self._path.props["direction"] = list(channel.tip[3:])
        self._path.props["rapid"] = f"{channel.prefix}PATH.RAPID"
        self._path.props["channel"] = channel.number
        others = channel.others
        self._path.props["others"] = [
            {"channel": one.channel, "axes": one.axes, "rapid": one.rapid} for one in others
        ]
        self._name_channels([one.channel for one in others])
        self._path.props["limits"] = [self._limits.get(axis) for axis in channel.axes[:3]]
        self._axes.set_visibility(bool(channel.tip))

    def _name_channels(self, others: Sequence[int]) -> None:
        """Say in the legend which colour is which channel, where there are several."""
        chosen, texts = self._shared.channel.number, self._texts
        numbers = sorted((chosen, *others)) if others else []
        self._channels.clear()
        with self._channels:
            for number in numbers:
                key = ui.label(f"{texts['channel']} {number}").classes("nc-key channel_line")
                key.style(f"--nc-channel: var(--nc-channel-{(number - 1) % _CHANNEL_COLOURS})")
            if not numbers:
                ui.label(texts["feed_line"]).classes("nc-key feed_line")

    # --- requests ---------------------------------------------------------------------------------

    async def _travel(self, event: Any) -> None:
        """Show the state after a tick."""
        if isinstance(event.args, int | float):
            end = max(0, min(int(event.args) + 1, self._shared.snapshot.latest))
            await self._commander.do(lambda session: session.go_to(end))

    async def _request_stretch(self, event: Any) -> None:
        """Let a stretch of the past come in detail; anybody may look."""
        words = event.args
        if not isinstance(words, list) or len(words) != 2 or self._shared.snapshot.is_playing:
            return
        if all(isinstance(word, int | float) for word in words):
            first, end = (max(0, min(int(word), self._shared.snapshot.latest)) for word in words)
            if first < end:
                await self._stretches.request((first, end))

    async def _send_stretch(self, bounds: tuple[int, int]) -> None:
        try:
            detail = await asyncio.to_thread(self._shared.stretch, *bounds)
        except Failure:
            return  # the session has gone on or was closed; the coarse curves stay
        self._scope.run_method("take", {"detail": detail})

    async def _choose(self, event: Any) -> None:
        chosen = list(event.value)[: view.MAX_SIGNALS]
        if chosen != self._shared.scope and self._commander.may():
            await self._commander.attempt(lambda: self._shared.choose(chosen))

    def zoom(self, factor: float) -> None:
        """Zoom the scope."""
        self._scope.run_method("zoomBy", factor)

    def pan(self, share: float) -> None:
        """Scroll the scope by a share of its width."""
        self._scope.run_method("panBy", share)

    def scroll_lanes(self, rows: int) -> None:
        """Show further conditions, or those before."""
        self._scope.run_method("scrollLanes", rows)

    def focus_filter(self) -> None:
        """Let a person type which conditions they look for."""
        if self._filter.visible:
            self._filter.run_method("focus")

    def _keep_filter(self, event: Any) -> None:
        """Let the browser keep the filter for when the page is reloaded."""
        self._scope.run_method("keepFilter", str(event.value or ""))

    def _restore_filter(self, event: Any) -> None:
        if isinstance(event.args, str):
            self._filter.set_value(event.args[:MAX_FILTER])

    def mark(self) -> None:
        """Compare values with those of this tick from now on, or no more."""
        self._scope.run_method("mark")

    def fit(self) -> None:
        """Show all in the scope."""
        self._scope.run_method("fit")

    def turn_view(self) -> None:
        """Show the path from the next side."""
        self._path.run_method("turnView")

    def flip_axes(self) -> None:
        """Draw the path of the axes, or again that of the tip."""
        if self._axes.visible:
            self._axes.set_value(not self._axes.value)

    def _show_axes(self, event: Any) -> None:
        self._path.run_method("showAxes", bool(event.value))

    def _choose_view(self, name: str) -> None:
        self._path.run_method("showFrom", name)


_STEP = "() => { const { run, zoom } = globalThis.nctaktRun; zoom((run.from + run.to) / 2, %s); }"
_ZOOMS = {
    "zoom_in": "() => globalThis.nctaktRun.zoomIn()",
    "zoom_out": _STEP % "1.6",
    "scope_fit": "() => globalThis.nctaktRun.fit()",
}
