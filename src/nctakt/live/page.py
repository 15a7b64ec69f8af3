# SPDX-License-Identifier: MIT
"""The live page of one browser: its parts, and how they follow the session.

In: a ``SharedSession``, the programs' documents. Out: elements of NiceGUI. Their content comes from
``view`` and ``track``.
"""

from __future__ import annotations

import asyncio
import contextlib
import html
import json
from collections.abc import Awaitable, Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from nicegui import Client, context, ui

from nctakt.base.dataclass import dataclass, field
from nctakt.live import view
from nctakt.live.document import Document
from nctakt.live.drawings import Drawings
from nctakt.live.parts.commander import Commander
from nctakt.live.parts.functions import Functions
from nctakt.live.parts.keys import GROUPS, KEYS, label_of
from nctakt.live.parts.lists import NAMES, Lists
from nctakt.live.parts.naming import explained, named
from nctakt.live.parts.panel import Panel
from nctakt.live.parts.plc_pane import is_step
from nctakt.live.parts.program_card import ProgramCard
from nctakt.live.parts.tour import Hands, Tour
from nctakt.live.parts.variables import Variables
from nctakt.live.shared import SharedSession
from nctakt.live.texts import EDITOR_PHRASES, Texts
from nctakt.live.view import Snapshot
from nctakt.session.core import NEXT_BLOCK, NEXT_REACTION
from nctakt.session.session import Session

#: How often the page looks for something new, in seconds. While it plays, its fields are shown once
#: in this many looks, and less often at full speed, when nobody reads them all.
_LOOK_S = 0.05
_FIELDS_EVERY, _FAST_FIELDS_EVERY = 3, 8

#: Looks between two looks at the file on disk.
_DISK_EVERY = 40

#: Speeds: factor of the wall clock, ``None`` at full speed.
_SPEEDS: dict[str, float | None] = {
    "×0.01": 0.01,
    "×0.1": 0.1,
    "×0.5": 0.5,
    "×1": 1.0,
    "×10": 10.0,
    "×100": 100.0,
    "max": None,
}

_TRAVELS: dict[str, Callable[[Session], object]] = {
    "home": lambda session: session.go_to(0),
    "front": lambda session: session.go_to(session.branches[session.branch]),
    "back_reaction": lambda session: session.previous_reaction(),
    "back_block": lambda session: session.previous_block(),
    "back_stop": lambda session: session.back_to(),
    "back_tick": lambda session: session.back(1),
    "tick": lambda session: session.step(1),
}

_NEXT = {"block": NEXT_BLOCK, "reaction": NEXT_REACTION}

_FOLDER = Path(__file__).parent
_CSS = (_FOLDER / "page.css").read_text("utf-8")
_SCRIPTS = [(_FOLDER / name).read_text("utf-8") for name in ("page_program.js", "page_events.js")]

#: The first lines of a program, and characters of a line, that are shown while the page is built.
_OUTSET_LINES, _OUTSET_CHARACTERS = 60, 200


def _outset(lines: Sequence[str]) -> str:
    """Return what a browser shows until its scripts have built the page: how the program begins."""
    text = "\n".join(line[:_OUTSET_CHARACTERS] for line in lines[:_OUTSET_LINES])
    return (
        '<div class="nc-outset"><div class="nc-bar"><div class="nc-name">nctakt</div></div>'
        f"<pre>{html.escape(text)}</pre></div>"
    )


@dataclass(slots=True)
class _LatestLook:
    """What the browser showed at its latest look at the session, so that only news is sent.

    ``number``: that of the snapshot, ``count``: of the looks.
    """

    subject: tuple[object, ...]
    stopped_at: tuple[int, str]
    number: int = -1
    count: int = 0
    readings: dict[str, str] = field(default_factory=dict)
    bar: tuple[object, ...] = ()
    has_control: bool | None = None
    is_playing: bool = False


class Page:
    """The page of one browser."""

    def __init__(
        self,
        shared: SharedSession,
        documents: Mapping[int, list[Document]],
        texts: Texts,
        *,
        has_plc: bool,
        has_tour: bool = False,
    ) -> None:
        self._shared = shared
        self._texts = texts
        self._commander = Commander(shared, texts, context.client)
        self._latest = _LatestLook(self._subject_now(), shared.stopped_at)
        ui.add_css(_CSS)
        self._dark, self._is_dark = ui.dark_mode(None), False
        self._help = Help(texts)
        self._build(documents, [one.file for one in documents.get(1, ())], has_plc, has_tour)
        keys = json.dumps({name: key.is_everywhere for name, key in KEYS.items()})
        words = {
            "nothing": texts["nothing_known"],
            "none": texts["no_findings"],
            "phrases": EDITOR_PHRASES if texts.language == "de" else {},
        }
        for text in _SCRIPTS:
            script = text.replace("KEYS", keys).replace("EDITOR", str(self._program.editor_id))
            script = script.replace("PROGRAM_NAME", json.dumps(texts["program"]))
            script = script.replace("PROGRAM_WORDS", json.dumps(words))
            ui.add_body_html(f"<script>{script}</script>")
        ui.add_body_html(_outset(self._program.document.lines))
        ui.on("nctakt_key", self._key)
        ui.on("nctakt_dark", self._show_dark)
        self._show_fields(shared.snapshot)  # so that the browser need not build the page twice
        ui.timer(_LOOK_S, self._follow)
        self._follow_commands(context.client)

    def _follow_commands(self, client: Client) -> None:
        """Look as well as soon as a command has been carried out."""
        loop = asyncio.get_running_loop()

        def look() -> None:
            if client.has_socket_connection:
                with client:
                    self._follow()

        def watch() -> None:
            with contextlib.suppress(RuntimeError):  # the server has ended
                loop.call_soon_threadsafe(look)

        self._shared.watchers.add(watch)
        client.on_delete(lambda: self._shared.watchers.discard(watch))
        client.on_delete(self._lists.search.close)

    # --- layout ---------------------------------------------------------------------------------

    def _build(
        self,
        documents: Mapping[int, list[Document]],
        programs: Sequence[str],
        has_plc: bool,
        has_tour: bool,
    ) -> None:
        with ui.element("div").classes("nc-bar"):
            self._build_bar()
        with ui.element("div").classes("nc-body"):
            with ui.element("div").classes("nc-column nc-left"):
                if has_tour:
                    hands = Hands(self._play, self._ask_why, self._reveal, self._choose_list)
                    Tour(self._commander, hands)
                self._program = ProgramCard(
                    self._commander, documents, self._ask_why, self._show_findings, self._play
                )
                self._lists = Lists(self._commander, self._program.reveal)
            with ui.element("div").classes("nc-column nc-middle"):
                limits = self._program.document.checker.limits
                self._drawings = Drawings(self._commander, limits, self._follow)
            with ui.element("div").classes("nc-column nc-right"):
                self._panel = Panel(self._commander, programs, self._program.choose_program)
                self._functions = Functions(self._commander, has_plc=has_plc)
                self._variables = Variables(self._commander, self._program.document.checker)

    def _build_bar(self) -> None:
        texts = self._texts
        with ui.element("h1").classes("nc-name"):
            ui.label("nctakt")
        self._state = ui.label().classes("nc-state").props("data-testid=state role=status")
        for name, icon in (
            ("home", "first_page"),
            ("back_reaction", "bolt"),
            ("back_block", "skip_previous"),
            ("back_tick", "chevron_left"),
        ):
            self._button(name, icon)
        self._toggle = ui.button(icon="play_arrow", on_click=self._play_or_pause)
        self._toggle.props("dense unelevated color=primary data-testid=toggle")
        explained(self._toggle, texts["toggle"])
        for name, icon in (
            ("tick", "chevron_right"),
            ("block", "skip_next"),
            ("reaction", "bolt"),
            ("front", "last_page"),
        ):
            self._button(name, icon)
        self._speed = ui.select(list(_SPEEDS), value="×1", on_change=self._choose_speed)
        self._speed.props("dense options-dense outlined data-testid=speed").classes("nc-speed")
        explained(self._speed, texts["speed"])
        ui.label().classes("nc-number nc-soft nc-clock").props("data-testid=clock")
        ui.element("div").classes("col")
        self._control = ui.button(icon="edit", on_click=self._take_control)
        self._control.props("dense flat no-caps size=sm data-testid=control").classes("nc-control")
        dark = ui.button(icon="dark_mode", on_click=self._switch_dark)
        explained(dark.props("dense flat data-testid=dark"), texts["dark"])
        keys = ui.button(icon="keyboard", on_click=self._help.open)
        explained(keys.props("dense flat data-testid=help"), f"{texts['help']} (?)")

    def _button(self, name: str, icon: str) -> None:
        async def act() -> None:
            await self._transport(name)

        button = ui.button(icon=icon, on_click=act).props(f"dense flat data-testid={name}")
        explained(button, f"{self._texts[name]} ({label_of(name, self._texts.language)})")
        if name == "back_reaction":
            button.classes("nc-mirrored")

    # --- following ------------------------------------------------------------------------------

    def _subject_now(self) -> tuple[object, ...]:
        """Return the data that decides which signals and variables the page has."""
        shared = self._shared
        return shared.snapshot.serial, shared.channel.number, shared.channel.file

    def _follow(self) -> None:
        """Show new data, once the browser has drawn the previous."""
        if self._drawings.are_behind:
            return
        snapshot = self._shared.snapshot
        self._latest.count += 1
        subject = self._subject_now()
        if subject != self._latest.subject:
            self._latest.subject = subject
            self._drawings.show_session()
            self._variables.show_session()
        self._drawings.follow(self._new_readings(snapshot))
        is_first = self._latest.count == 1  # the fields are as the page was built
        if is_first or self._are_fields_later(snapshot):
            return
        if self._latest.count % _DISK_EVERY == 0:
            self._program.look_at_disk()
        self._show_fields(snapshot)

    def _are_fields_later(self, snapshot: Snapshot) -> bool:
        """Return whether the fields wait for a later look; a pause is drawn before them."""
        was_playing, self._latest.is_playing = self._latest.is_playing, snapshot.is_playing
        if not snapshot.is_playing:
            return was_playing
        every = _FAST_FIELDS_EVERY if self._shared.session.speed is None else _FIELDS_EVERY
        return self._latest.count % every > 0

    def _show_fields(self, snapshot: Snapshot) -> None:
        """Show everything but the drawings."""
        shared = self._shared
        self._program.follow()
        self._show_pen()
        self._show_bar(snapshot)
        self._lists.follow(self._program)
        if snapshot.number == self._latest.number:
            return
        self._latest.number = snapshot.number
        self._program.show(snapshot)
        self._panel.show(snapshot)
        self._functions.show(snapshot)
        self._variables.show(snapshot)
        self._lists.show(self._program)
        if shared.stopped_at != self._latest.stopped_at:
            self._latest.stopped_at = shared.stopped_at
            if shared.stopped_at[1]:
                ui.notify(self._texts["stopped"].format(stops=shared.stopped_at[1]), timeout=3000)

    def _new_readings(self, snapshot: Snapshot) -> dict[str, str]:
        """Return the readings that have changed."""
        channel, cycle_us = self._shared.channel, self._shared.description.cycle_time_us
        if any(
            f"{channel.prefix}{axis}.ACS.ACT_POS" not in snapshot.values for axis in channel.axes
        ):
            return {}  # of the channel before
        readings = view.readings(snapshot, channel.axes, channel.prefix, cycle_us, self._texts)
        new = {
            name: text for name, text in readings.items() if self._latest.readings.get(name) != text
        }
        self._latest.readings = readings
        return new

    def _show_bar(self, snapshot: Snapshot) -> None:
        name = "ended" if snapshot.run_state is not None else "standing"
        if snapshot.is_playing:
            name = "running"
        shown = self._texts[name]
        if snapshot.run_state not in (None, "ended") and not snapshot.is_playing:
            shown = f"{shown} ({snapshot.run_state})"
        if self._shared.busy and not snapshot.is_playing:
            shown = self._texts["working"]
        bar = (shown, name, snapshot.run_state, snapshot.is_playing)
        if bar != self._latest.bar:
            self._latest.bar = bar
            kind = "error" if snapshot.run_state == "error" else name
            self._state.set_text(shown)
            self._state.classes(replace=f"nc-state {kind}")
            self._toggle.props(f"icon={'pause' if snapshot.is_playing else 'play_arrow'}")

    def _show_pen(self) -> None:
        has_control = self._commander.has_control
        if has_control != self._latest.has_control:
            self._latest.has_control = has_control
            self._control.set_text("" if has_control else self._texts["take_control"])
            self._control.props(f"color={'positive' if has_control else 'warning'}")
            named(self._control, self._texts["in_control" if has_control else "take_control"])

    def _show_findings(self) -> None:
        self._lists.show_findings(self._program)
        self._program.show(self._shared.snapshot)

    # --- commands -------------------------------------------------------------------------------

    async def _ask_why(self, line: int) -> None:
        await self._lists.ask_why(line)

    async def _begin_condition(self) -> None:
        stop = await self._program.stop_of_cursor()
        self._lists.begin_stop(f"{stop} if " if stop else "")

    def _reveal(self, line: int) -> None:
        self._program.reveal(line)

    def _choose_list(self, name: str) -> None:
        self._lists.choose(name)

    async def _transport(self, name: str) -> None:
        if not self._commander.may():
            return
        shared = self._shared
        if name in _NEXT:
            await self._commander.attempt(lambda: shared.go_to_next(_NEXT[name]))
            return
        answers: list[object] = []
        if await self._commander.attempt(lambda: answers.append(shared.do(_TRAVELS[name]))):
            if answers == [None]:
                ui.notify(self._texts["never"])

    async def _play_or_pause(self) -> None:
        speed = _SPEEDS[self._speed.value]

        def toggle(session: Session) -> None:
            if session.is_playing:
                session.pause()
            else:
                session.play(speed)

        await self._commander.do(toggle)

    async def _play(self) -> None:
        speed = _SPEEDS[self._speed.value]
        await self._commander.do(lambda session: session.play(speed))

    async def _choose_speed(self, _: Any = None) -> None:
        if self._shared.snapshot.is_playing and self._commander.has_control:
            await self._play()

    def _change_speed(self, steps: int) -> None:
        names = list(_SPEEDS)
        index = names.index(self._speed.value) + steps
        self._speed.set_value(names[max(0, min(index, len(names) - 1))])

    def _take_control(self) -> None:
        self._commander.take_control()
        self._show_pen()

    def _switch_dark(self) -> None:
        """Be light or dark from now on, regardless of the system."""
        self._dark.set_value(not self._is_dark)

    def _show_dark(self, event: Any) -> None:
        """Take over whether the page is dark: as the system is, until the user chooses."""
        self._is_dark = isinstance(event.args, dict) and event.args.get("isDark") is True
        self._program.set_dark(self._is_dark)

    # --- keys -----------------------------------------------------------------------------------

    async def _key(self, event: Any) -> None:
        """Execute a key's command."""
        key = KEYS.get(str(event.args.get("key", "")) if isinstance(event.args, dict) else "")
        if key is None:
            return
        name = key.command
        if name in _TRAVELS or name in _NEXT:
            await self._transport(name)
        elif name in ("start", "reset"):
            await self._panel.press(name)
        elif name in ("hold", "single", "backward"):
            await self._panel.flip(name)
        elif name.startswith("tab_"):
            self._lists.choose(NAMES[int(key.key) - 1])
        elif name == "toggle_stop":
            await self._program.toggle_stop_at_cursor()
        elif name == "why":
            await self._lists.ask_why(*await self._program.place_of_cursor())
        elif name == "explain":
            self._program.plc.explain()
        elif is_step(name):
            await self._program.plc.step(name)
        elif (action := self._actions().get(name)) is not None:
            done = action()
            if isinstance(done, Awaitable):
                await done

    def _actions(self) -> dict[str, Callable[[], object]]:
        """Return the actions of further commands."""
        drawings = self._drawings
        return {
            "toggle": self._play_or_pause,
            "faster": lambda: self._change_speed(1),
            "slower": lambda: self._change_speed(-1),
            "override_up": lambda: self._panel.change_override(1),
            "override_down": lambda: self._panel.change_override(-1),
            "acknowledge": self._functions.acknowledge_first,
            "save": self._program.save,
            "condition": self._begin_condition,
            "plc_edit": self._program.plc.toggle_edit,
            "plc_next_file": self._program.show_next_file,
            "search_events": self._lists.search_events,
            "previous_match": lambda: self._lists.hop(is_back=True),
            "next_match": lambda: self._lists.hop(is_back=False),
            "search_variable": self._variables.focus_search,
            "scope_left": lambda: drawings.pan(-0.2),
            "scope_right": lambda: drawings.pan(0.2),
            "scope_in": lambda: drawings.zoom(0.6),
            "scope_out": lambda: drawings.zoom(1.6),
            "scope_fit": drawings.fit,
            "lanes_up": lambda: drawings.scroll_lanes(-1),
            "lanes_down": lambda: drawings.scroll_lanes(1),
            "filter_lanes": drawings.focus_filter,
            "scope_mark": drawings.mark,
            "turn_view": drawings.turn_view,
            "machine_axes": drawings.flip_axes,
            "take_control": self._take_control,
            "dark": self._switch_dark,
            "help": self._help.open,
        }


class Help:
    """The dialog with all keys, closed; its rows are built when it is opened first."""

    def __init__(self, texts: Texts) -> None:
        self._texts = texts
        self._is_built = False
        with ui.dialog().props("data-testid=help-dialog") as self._dialog:
            self._card = ui.element("div").classes("nc-card nc-help")
        named(self._dialog, texts["help"])

    def open(self) -> None:
        """Show all keys."""
        if not self._is_built:
            self._is_built = True
            with self._card:
                self._build()
        self._dialog.open()

    def _build(self) -> None:
        texts = self._texts
        index = 1 if texts.language == "de" else 0
        with ui.element("div").classes("nc-help-groups"):
            for heading, keys in GROUPS:
                with ui.element("div"):
                    ui.label(texts[heading]).classes("nc-title")
                    for key in keys:
                        with ui.element("div").classes("nc-row"):
                            ui.label(key.label[index]).classes("nc-keycap")
                            ui.label(texts[key.command]).classes("nc-soft")
        with ui.element("div").classes("nc-row"):
            ui.space()
            button = ui.button(texts["close"], on_click=self._dialog.close)
            button.props("dense flat no-caps size=sm")
