# SPDX-License-Identifier: MIT
"""The live page of one browser: its elements, and how they follow the session.

In: a ``SharedSession``, the program's ``Document``. Out: elements of NiceGUI. What they show comes
from ``view`` and ``charts``; whatever asks the session waits in a thread, never in the server's
loop.
"""

from __future__ import annotations

import asyncio
import json
from collections.abc import Callable
from typing import Any

from nicegui import context, run, ui

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.live import charts, view
from nctakt.live.document import Document
from nctakt.live.panel import Panel
from nctakt.live.shared import SharedSession
from nctakt.live.style import CSS, KEYS, SCRIPT
from nctakt.live.texts import Texts
from nctakt.live.view import LogRow, Snapshot
from nctakt.session.session import Session

#: How often the page looks for something new, and how long it waits for more typing, in seconds.
_LOOK_S = 0.1
_TYPING_S = 0.35

#: Speeds of the buttons: factor of the wall clock, ``None`` as fast as possible.
_SPEEDS = {"×0.1": 0.1, "×1": 1.0, "×10": 10.0, "max": None}

#: Looks between two drawings of the charts while the session plays.
_DRAW_EVERY = 3

#: Names of the path's curves.
_PATHS = ("feed", "rapid")

_COMMANDS: dict[str, Callable[[Session], object]] = {
    "home": lambda session: session.go_to(0),
    "back_reaction": lambda session: session.previous_reaction(),
    "back_block": lambda session: session.previous_block(),
    "back_tick": lambda session: session.back(1),
    "tick": lambda session: session.step(1),
    "block": lambda session: session.next_block(),
    "reaction": lambda session: session.next_reaction(),
}


class Page:
    """The page of one browser."""

    def __init__(self, shared: SharedSession, document: Document, texts: Texts) -> None:
        self._shared = shared
        self._document = document
        self._texts = texts
        self._client = context.client.id
        self._speed: float | None = 1.0
        self._shown = -1
        self._serial = -1
        self._drawn: tuple[object, ...] = ()
        self._looks = 0
        self._typed = 0
        self._findings: list[Diagnostic] = []
        self._lists: dict[str, tuple[LogRow, ...]] = {}
        ui.add_css(CSS)
        ui.add_body_html(SCRIPT.replace("KEYS", json.dumps(list(KEYS))))
        self._dark = ui.dark_mode(None)
        self._build()
        ui.on("nctakt_key", self._key)
        context.client.on_connect(self._arrive)
        context.client.on_disconnect(self._leave)
        ui.timer(_LOOK_S, self._follow)
        self._check_later()

    # --- layout ---------------------------------------------------------------------------------

    def _build(self) -> None:
        with ui.row().classes("nc-bar"):
            self._build_bar()
        with ui.element("div").classes("nc-body"):
            with ui.element("div").classes("nc-column"):
                self._build_program()
            with ui.element("div").classes("nc-column"):
                self._build_charts()
            with ui.element("div").classes("nc-column"):
                self._panel = Panel(self._shared, self._document, self._texts, self._do)

    def _build_bar(self) -> None:
        texts = self._texts
        ui.label("nctakt live").classes("text-weight-bold").style("white-space: nowrap")
        self._state = ui.label().classes("nc-state").props("data-testid=state")
        for name, icon in (
            ("home", "first_page"),
            ("back_reaction", "bolt"),
            ("back_block", "skip_previous"),
            ("back_tick", "chevron_left"),
        ):
            self._button(name, icon, back=True)
        self._toggle = (
            ui.button(icon="play_arrow", on_click=self._play_or_pause)
            .props("dense unelevated color=primary data-testid=toggle")
            .tooltip(texts["toggle"])
        )
        for name, icon in (
            ("tick", "chevron_right"),
            ("block", "skip_next"),
            ("reaction", "bolt"),
        ):
            self._button(name, icon)
        ui.toggle(list(_SPEEDS), value="×1", on_change=self._choose_speed).props(
            "dense unelevated no-caps size=sm data-testid=speed"
        ).tooltip(texts["speed"])
        self._clock = (
            ui.label()
            .classes("nc-number nc-soft")
            .style("white-space: nowrap")
            .props("data-testid=clock")
        )
        ui.space()
        self._pen = (
            ui.button(icon="edit", on_click=self._take_pen)
            .props("dense flat no-caps size=sm data-testid=pen")
            .style("white-space: nowrap")
        )
        ui.button(icon="dark_mode", on_click=self._switch_dark).props(
            "dense flat data-testid=dark"
        ).tooltip(texts["dark"])

    def _button(self, name: str, icon: str, *, back: bool = False) -> None:
        button = ui.button(icon=icon, on_click=lambda: self._transport(name)).props(
            f"dense flat data-testid={name}"
        )
        button.tooltip(self._texts[name])
        if name == "back_reaction":
            button.style("transform: scaleX(-1)")

    def _build_program(self) -> None:
        texts = self._texts
        with ui.element("div").classes("nc-card").style("flex: 1 1 0"):
            with ui.element("div").classes("nc-row"):
                ui.label(self._document.file).classes("nc-title").style("text-transform: none")
                self._edited = ui.label().classes("nc-soft")
                ui.space()
                ui.button(texts["save"], icon="save", on_click=self._save).props(
                    "dense flat no-caps size=sm data-testid=save"
                )
            self._editor = ui.codemirror(
                self._document.text, theme="basicLight", on_change=self._changed
            )
        with ui.element("div").classes("nc-card").style("height: 190px; flex: none"):
            with ui.tabs().props("dense align=left no-caps") as tabs:
                for name in ("findings", "messages", "events"):
                    ui.tab(name, texts[name]).props(f"data-testid=tab-{name}")
            with ui.tab_panels(tabs, value="findings").classes("nc-scroll bg-transparent"):
                self._list_of: dict[str, Any] = {}
                for name in ("findings", "messages", "events"):
                    with ui.tab_panel(name).classes("q-pa-none"):
                        self._list_of[name] = ui.element("div").props(f"data-testid={name}")

    def _build_charts(self) -> None:
        texts = self._texts
        with ui.element("div").classes("nc-card").style("flex: 3 1 0"):
            with ui.element("div").classes("nc-row"):
                ui.label(texts["scope"]).classes("nc-title")
                ui.label(texts["travel"]).classes("nc-soft")
                ui.space()
                self._signals = (
                    ui.select(
                        list(self._shared.units),
                        multiple=True,
                        value=list(self._shared.scope),
                        on_change=self._choose_signals,
                        with_input=True,
                    )
                    .props(
                        f"dense options-dense borderless max-values=12 "
                        f'display-value="{texts["signals"]}" data-testid=signals'
                    )
                    .style("width: 120px")
                )
            self._scope = (
                ui.echart({"series": []})
                .style("flex: 1 1 0; min-height: 0; height: auto; width: 100%")
                .props("data-testid=scope")
            )
            self._scope.on(
                "click",
                self._travel,
                js_handler=(
                    "(event) => { const chart = getElement("
                    f"{self._scope.id}).chart;"
                    "const box = chart.getDom().getBoundingClientRect();"
                    "const at = [event.clientX - box.left, event.clientY - box.top];"
                    "const count = (chart.getOption().grid || []).length;"
                    "for (let i = 0; i < count; i++) if (chart.containPixel({gridIndex: i}, at))"
                    " return emit(chart.convertFromPixel({xAxisIndex: i}, at[0])); }"
                ),
            )
        with ui.element("div").classes("nc-card").style("flex: 2 1 0"):
            ui.label(texts["path"]).classes("nc-title")
            self._path = (
                ui.echart({"series": []})
                .style("flex: 1 1 0; min-height: 0; height: auto; width: 100%")
                .props("data-testid=path")
            )

    # --- following ------------------------------------------------------------------------------

    def _follow(self) -> None:
        """Show what is new."""
        snapshot = self._shared.snapshot
        self._looks += 1
        self._show_pen()
        if snapshot.number == self._shown:
            return
        self._shown = snapshot.number
        if snapshot.serial != self._serial:
            self._serial = snapshot.serial
            self._signals.set_value(list(self._shared.scope))
        self._show_bar(snapshot)
        self._show_program(snapshot)
        self._panel.show(snapshot)
        if not snapshot.is_playing or self._looks % _DRAW_EVERY == 0:
            self._draw(snapshot)
        self._show_list("messages", list(self._shared.messages)[::-1])
        self._show_list("events", list(self._shared.events)[::-1])
        self._show_findings()

    def _show_bar(self, snapshot: Snapshot) -> None:
        texts = self._texts
        name = "ended" if snapshot.run_state is not None else "standing"
        if snapshot.is_playing:
            name = "running"
        shown = texts[name]
        if snapshot.run_state not in (None, "ended"):
            shown = f"{shown} ({snapshot.run_state})"
        if self._state.text != shown:
            self._state.set_text(shown)
            kind = "error" if snapshot.run_state == "error" else name
            self._state.classes(replace=f"nc-state {kind}")
            self._toggle.props(f"icon={'pause' if snapshot.is_playing else 'play_arrow'}")
        time_ms = snapshot.tick * self._shared.cycle_time_us / 1000
        self._clock.set_text(
            f"{texts['tick_number']} {snapshot.tick} · {time_ms:.3f} ms · "
            f"{texts['branch']} {snapshot.branch}"
        )

    def _show_program(self, snapshot: Snapshot) -> None:
        is_edited = self._editor.value != self._document.text
        self._edited.set_text(f"● {self._texts['edited']}" if is_edited else "")
        if is_edited:
            return
        marks = view.program_marks(self._shared.lines, self._document.file, snapshot, self._texts)
        if marks != list(self._editor.decorations):
            self._editor.decorations = marks

    def _draw(self, snapshot: Snapshot) -> None:
        shared = self._shared
        curves, marks = shared.curves, list(shared.marks)
        drawn = (id(curves), snapshot.tick, len(marks), tuple(shared.scope))
        if drawn == self._drawn or not curves.names:
            return
        self._drawn = drawn
        chosen = [name for name in shared.scope if name in curves.names]
        columns = [curves.columns[curves.names.index(name)] for name in chosen]
        scope = view.Curves(tuple(chosen), curves.ticks, columns)
        self._replace(
            self._scope,
            charts.scope_options(scope, shared.units, marks, snapshot.tick, shared.cycle_time_us),
        )
        if shared.plane and all(name in curves.names for name in shared.plane):
            tool = tuple(float(snapshot.values[name]) for name in shared.plane)
            options = charts.path_options(
                curves, (shared.plane[0], shared.plane[1]), marks, (tool[0], tool[1]), _PATHS
            )
            self._replace(self._path, options)

    @staticmethod
    def _replace(chart: ui.echart, options: dict[str, Any]) -> None:
        chart.options.clear()
        chart.options.update(options)
        chart.update()

    def _show_list(self, name: str, rows: list[LogRow]) -> None:
        shown = tuple(rows[:80])
        if self._lists.get(name) == shown:
            return
        self._lists[name] = shown
        holder = self._list_of[name]
        holder.clear()
        with holder:
            for row in shown:
                line = f"{self._texts['line']} {row.line}: " if row.line else ""
                with (
                    ui.element("div")
                    .classes(f"nc-finding {row.kind}")
                    .on("click", lambda row=row: self._reveal(row.line))
                ):
                    ui.label(f"{line}{row.text}")
                    if row.remedy:
                        ui.label(row.remedy).classes("nc-soft")
            if not shown and name == "findings":
                ui.label(self._texts["no_findings"]).classes("nc-soft")

    def _show_findings(self) -> None:
        known = set(map(str, self._findings))
        of_run = [one for one in self._shared.diagnostics if str(one) not in known]
        is_edited = self._editor.value != self._document.text
        found = self._findings if is_edited else [*self._findings, *of_run]
        self._show_list(
            "findings",
            view.finding_rows(found, self._document.file, self._texts.language),
        )

    def _reveal(self, line: int) -> None:
        if 1 <= line <= len((self._editor.value or "").split("\n")):
            self._editor.reveal_line(line)

    # --- the program ----------------------------------------------------------------------------

    def _changed(self) -> None:
        self._check_later()

    def _check_later(self) -> None:
        """Check the text once nobody has typed for a moment."""
        self._typed += 1
        ui.timer(_TYPING_S, lambda typed=self._typed: self._check(typed), once=True)

    async def _check(self, typed: int) -> None:
        if typed != self._typed:
            return
        text = self._editor.value or ""
        found = await run.io_bound(self._document.check, text)
        if typed == self._typed and found is not None:
            self._findings = found
            self._show_findings()
            self._show_program(self._shared.snapshot)

    async def _save(self) -> None:
        if not self._may():
            return
        text = self._editor.value or ""

        def save_and_run() -> None:
            if text != self._document.text:
                self._document.save(text)
            self._shared.reopen()

        if await self._try(save_and_run):
            ui.notify(self._texts["saved"], type="positive")

    # --- commands -------------------------------------------------------------------------------

    async def _transport(self, name: str) -> None:
        if not self._may():
            return
        answers: list[object] = []
        if await self._try(lambda: answers.append(self._shared.do(_COMMANDS[name]))):
            if answers == [None] and name.startswith("back"):
                ui.notify(self._texts["never"])

    async def _play_or_pause(self) -> None:
        speed = self._speed

        def toggle(session: Session) -> object:
            if session.is_playing:
                return session.pause()
            session.play(speed)
            return None

        await self._do(toggle)

    async def _choose_speed(self, event: Any) -> None:
        self._speed = _SPEEDS[event.value]
        speed = self._speed
        if self._shared.snapshot.is_playing:
            await self._do(lambda session: session.play(speed))

    async def _travel(self, event: Any) -> None:
        tick = round(float(event.args) * 1e6 / self._shared.cycle_time_us)
        reached = self._shared.snapshot.latest
        await self._do(lambda session: session.go_to(max(0, min(tick, reached))))

    def _choose_signals(self, event: Any) -> None:
        if self._may():
            self._shared.choose(list(event.value)[:12])

    async def _key(self, event: Any) -> None:
        key = str(event.args.get("key", ""))
        if key == "save":
            await self._save()
        elif KEYS.get(key) == "toggle":
            await self._play_or_pause()
        elif key in KEYS:
            await self._transport(KEYS[key])

    async def _do(self, command: Callable[[Session], object]) -> bool:
        """Let the session carry out a command; return whether it did."""
        return self._may() and await self._try(lambda: self._shared.do(command))

    async def _try(self, action: Callable[[], object]) -> bool:
        """Act in a thread; show why it is refused."""
        try:
            await asyncio.to_thread(action)
        except Failure as failure:
            language = self._texts.language
            for one in failure.diagnostics:
                ui.notify(
                    f"{one.id}: {one.text(language)} {one.remedy(language)}",
                    type="negative",
                    multi_line=True,
                    timeout=8000,
                )
            return False
        return True

    # --- the pen --------------------------------------------------------------------------------

    def _may(self) -> bool:
        """Return whether this browser may command; tell if not."""
        if self._shared.pen is None:
            self._shared.pen = self._client
        if self._shared.pen != self._client:
            ui.notify(self._texts["no_pen"], type="warning")
            return False
        return True

    def _take_pen(self) -> None:
        self._shared.pen = self._client
        self._show_pen()

    def _arrive(self) -> None:
        """Take the pen if nobody has it; who only fetches the page never gets so far."""
        if self._shared.pen is None:
            self._shared.pen = self._client

    def _leave(self) -> None:
        if self._shared.pen == self._client:
            self._shared.pen = None

    def _show_pen(self) -> None:
        own = self._shared.pen == self._client
        shown = "" if own else self._texts["take_pen"]
        if self._pen.text != shown or not self._pen.props.get("color"):
            self._pen.set_text(shown)
            self._pen.props(f"color={'positive' if own else 'warning'}")

    def _switch_dark(self) -> None:
        self._dark.set_value(not self._dark.value)
        self._editor.set_theme("vscodeDark" if self._dark.value else "basicLight")
