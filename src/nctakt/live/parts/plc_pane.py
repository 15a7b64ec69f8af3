# SPDX-License-Identifier: MIT
"""The files of the PLC on the page: lines, stops, values of the tick, steps by statements.

In: snapshots, the session's description. Out: a pane in the place of the program's editor; commands
that step into, over and out of calls, forward and back.
"""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Mapping, Sequence
from typing import Any

from nicegui import run, ui
from nicegui.element import Element

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.live.parts.commander import Commander, Newest
from nctakt.live.parts.keys import label_of
from nctakt.live.parts.naming import explained, named
from nctakt.live.parts.plc_edit import PlcEdit
from nctakt.live.parts.plc_tree import PlcTree, TreeRequest
from nctakt.live.plc_view import PlcText, WordPlace, file_names, statement_stop, statement_stops
from nctakt.live.view import Snapshot
from nctakt.session.cursor import Step
from nctakt.session.session import Session
from nctakt.session.statements import PlcPlace

#: The action of each command, and its icon.
_STEPS: dict[str, tuple[Step, bool, str]] = {
    "plc_into": ("into", False, "subdirectory_arrow_right"),
    "plc_over": ("over", False, "redo"),
    "plc_out": ("out", False, "north_west"),
    "plc_back_into": ("into", True, "subdirectory_arrow_left"),
    "plc_back_over": ("over", True, "undo"),
    "plc_back_out": ("out", True, "south_west"),
}

#: Rows before the first look of the browser.
_FIRST_ROWS = 60


class PlcLines(Element, component="plc_lines.js"):
    """The lines of a file of the PLC."""


@dataclass(frozen=True, slots=True)
class _Request:
    """What values are requested for: a state of the session, rows of a file, a call or instance."""

    number: int
    file: str
    first: int
    last: int
    level: int
    instance: str


class PlcPane:
    """The files of the PLC for one browser; ``is_shown``: one of them is.

    ``on_files`` is called when the set of files has changed, ``on_typed`` when one is edited,
    ``on_findings`` when that has been checked.
    """

    def __init__(
        self,
        commander: Commander,
        on_files: Callable[[], None],
        on_typed: Callable[[], None],
        on_findings: Callable[[], None],
    ) -> None:
        self._commander = commander
        self._shared = commander.shared
        self._texts = commander.texts
        self._on_files = on_files
        self._on_typed = on_typed
        self._on_findings = on_findings
        self._serial = -1
        self._names: dict[str, str] = {}
        self._text: PlcText | None = None
        self._rows = (0, _FIRST_ROWS)
        self._cursor = 0
        self._level = 0
        self._instances: list[str] = []
        self._shown_place: tuple[int, int] | None = None
        self._values = Newest(self._send_values)
        self._questions = Newest(self._answer)
        self._last_request: _Request | None = None
        self._tree: PlcTree
        self.edit: PlcEdit
        self._build()

    @property
    def is_shown(self) -> bool:
        """Whether a file of the PLC is shown."""
        return self._text is not None

    @property
    def file(self) -> str:
        """The file that is shown."""
        return "" if self._text is None else self._text.file

    @property
    def has_files(self) -> bool:
        """Whether there is a PLC in Structured Text."""
        return bool(self._names)

    # --- layout ---------------------------------------------------------------------------------

    def _build(self) -> None:
        texts = self._texts
        with ui.element("div").classes("nc-plc") as self._pane:
            with ui.element("div").classes("nc-row nc-plc-bar"):
                for name, (_, _, icon) in _STEPS.items():
                    button = ui.button(icon=icon, on_click=self._stepper(name))
                    button.props(f"dense flat size=sm data-testid={name}")
                    explained(button, f"{texts[name]} ({label_of(name, texts.language)})")
                button = ui.button(icon="edit_note", on_click=self.toggle_edit)
                button.props("dense flat size=sm data-testid=plc_edit")
                explained(button, f"{texts['plc_edit']} ({label_of('plc_edit', texts.language)})")
                self._calls = self._select("plc_calls", self._choose_call)
                self._instance = self._select("plc_instance", self._choose_instance)
            self._standing = ui.label().classes("nc-soft nc-plc-standing")
            self._standing.props("role=status data-testid=plc-standing")
            self._lines = PlcLines().classes("nc-plc-box")
            self._lines.props["rows"] = []
            self._lines.props["marks"], self._lines.props["beside"] = {}, {}
            self._lines.on("view", self._look)
            self._lines.on("cursor", self._put_cursor)
            self._lines.on("stop", self._click_number)
            self._lines.on("explain", self._ask)
            self._lines.on("enter", lambda _: self._tree.focus())
            self._tree = PlcTree(self._shared, texts)
            self.edit = PlcEdit(texts, self._on_typed, self._find, self._on_findings)
        self._pane.set_visibility(False)

    def _select(self, name: str, choose: Callable[[Any], object]) -> Any:
        select = ui.select([], on_change=choose).classes("nc-plc-choice")
        select.props(f"dense options-dense borderless data-testid={name}")
        named(select, self._texts[name])
        select.set_visibility(False)
        return select

    def _stepper(self, name: str) -> Callable[[], Awaitable[None]]:
        async def step() -> None:
            await self.step(name)

        return step

    # --- files ----------------------------------------------------------------------------------

    def choices(self) -> dict[str, str]:
        """Return the files by their keys among the choices of the program."""
        return {f"plc {file}": name for file, name in self._names.items()}

    def choose(self, key: str) -> bool:
        """Show the file of a key, or none; return whether the key names a file."""
        file = key.removeprefix("plc ")
        is_file = key.startswith("plc ") and file in self._names
        if file != self.file or not is_file:
            self._close_edit()
        if not is_file:
            self._text = None
        elif file != self.file:
            self._open(file)
        self._pane.set_visibility(is_file)
        return is_file

    def _open(self, file: str) -> None:
        own = self._shared.session.description
        lines: Mapping[str, Sequence[int]] = own.plc_lines
        language = self._texts.language
        self._text = PlcText(file, own.plc_texts[file], lines.get(file, ()), language)
        self._cursor, self._instances, self._last_request = 0, [], None
        self._lines.props["rows"] = self._text.rows()
        self._lines.props["name"] = f"{self._texts['plc_file']} {self._names[file]}"
        self._lines.props["beside"] = {}
        self._instance.set_visibility(False)
        self._lines.update()
        ui.timer(0, self._find_instances, once=True)
        self.show(self._shared.snapshot)

    # --- changes --------------------------------------------------------------------------------

    def toggle_edit(self) -> None:
        """Open the text of the cursor's row for editing, or show the lines again."""
        if self.edit.is_open:
            self._close_edit()
            return
        text = self._text
        if text is None or not self._commander.may():
            return
        lines = self._shared.session.description.plc_texts[text.file]
        if not self.edit.open(text.file, list(lines), text.text_at(self._cursor)):
            ui.notify(self._texts["plc_not_edited"], type="warning")
            return
        self._lines.set_visibility(False)
        self._on_typed()

    def _close_edit(self) -> None:
        was_open = self.edit.is_open
        self.edit.close()
        self._lines.set_visibility(True)
        self._on_typed()
        if was_open:
            self._on_findings()

    def _find(self, file: str, lines: Sequence[str]) -> list[Diagnostic]:
        return self._shared.plc_words.found(file, lines)

    async def save(self, run_it: Callable[[], None]) -> bool:
        """Save the text that is changed and run again; return whether both are done."""

        def save_and_run() -> None:
            self.edit.write()
            run_it()

        is_done = await self._commander.attempt(save_and_run)
        if is_done:
            self._close_edit()
        return is_done

    async def _find_instances(self) -> None:
        """Let a person choose an instance of a block, at first the first one."""
        file = self.file
        try:
            found = await run.io_bound(self._shared.session.plc_instances, file)
        except (Failure, RuntimeError):
            return  # the session has ended meanwhile
        if file != self.file or not found:
            return
        self._instances = found
        self._instance.set_options(found, value=found[0])
        self.show(self._shared.snapshot)

    def reveal(self, line: int) -> None:
        """Show a line of the file."""
        if self.edit.reveal(self.file, line):
            return
        index = -1 if self._text is None else self._text.index_of(line)
        if index >= 0:
            self._cursor = index
            self._lines.run_method("show", index)

    # --- display --------------------------------------------------------------------------------

    def arrived(self, snapshot: Snapshot) -> tuple[str, int] | None:
        """Return file and line of a statement before which the session has stopped.

        ``None`` unless it has done so since the last call.
        """
        halt = snapshot.statement
        stopped_at = None if halt is None else (halt.tick, halt.number)
        is_new = stopped_at is not None and stopped_at != self._shown_place
        self._shown_place = stopped_at
        if halt is None or not is_new:
            return None
        self._level = 0
        self._calls.set_options(_named(halt), value=0)
        span = halt.frames[0].span if halt.frames else None
        return None if span is None else (span.file, span.line)

    def show(self, snapshot: Snapshot) -> None:
        """Show stops, and the position of the session; request the values of the tick."""
        if snapshot.serial != self._serial:
            self._renew(snapshot.serial)
        if self._text is None:
            return
        halt = snapshot.statement
        self._calls.set_visibility(halt is not None and len(halt.frames) > 1)
        self._instance.set_visibility(halt is None and bool(self._instances))
        self._standing.set_text(self._standing_text(halt))
        self._standing.set_visibility(halt is not None)
        marks = {str(row): own for row, own in self._text.marks(halt, self._shared.stops).items()}
        if marks != self._lines.props["marks"]:
            self._lines.props["marks"] = marks
            self._lines.update()
        self._request(snapshot)

    def _renew(self, serial: int) -> None:
        """Take the files of another session."""
        self._serial = serial
        own = self._shared.session.description.plc_texts
        shown, self._text = self.file, None
        self._names = {
            file: name
            for file, name in file_names(list(own)).items()
            if file.lower().rpartition(".")[2] != "tctto"
        }
        if shown in self._names:
            self._open(shown)
        self._on_files()

    def _standing_text(self, halt: PlcPlace | None) -> str:
        if halt is None:
            return ""
        if halt.fault is not None:
            return f"{halt.fault.id}: {halt.fault.text(self._texts.language)}"
        within = halt.frames[0].within if halt.frames else None
        text = self._texts["plc_standing"].format(tick=halt.tick)
        return text if within is None else f"{text}: {within.get(self._texts.language)}"

    def _request(self, snapshot: Snapshot) -> None:
        first, last = self._rows
        instance = self._instance.value or ""
        request = _Request(snapshot.number, self.file, first, last, self._level, str(instance))
        if request != self._last_request:
            self._last_request = request
            ui.timer(0, lambda: self._values.request(request), once=True)
        self._show_tree(snapshot)

    def _show_tree(self, snapshot: Snapshot) -> None:
        """Show the variables named in the cursor's line."""
        line, paths = (0, ()) if self._text is None else self._text.named_at(self._cursor)
        instance = str(self._instance.value or "")
        self._tree.show(TreeRequest(snapshot.number, self.file, line, paths, self._level, instance))

    async def _send_values(self, request: _Request) -> None:
        text = self._text
        if text is None or text.file != request.file:
            return
        named_lines = text.named(request.first, request.last)
        try:
            values = await run.io_bound(
                self._shared.session.texts_beside,
                request.file,
                named_lines,
                request.level,
                request.instance,
            )
        except (Failure, RuntimeError):
            return  # the session has ended meanwhile, or was restarted
        beside = {str(row): one for row, one in text.beside(named_lines, values or []).items()}
        if text is self._text and beside != self._lines.props["beside"]:
            self._lines.props["beside"] = beside
            self._lines.update()

    # --- actions of a person --------------------------------------------------------------------

    def _look(self, event: Any) -> None:
        """Take the rows that a browser has in view."""
        rows = event.args
        if isinstance(rows, list) and len(rows) == 2 and all(isinstance(one, int) for one in rows):
            self._rows = rows[0], min(rows[1], rows[0] + 4 * _FIRST_ROWS)
            if self._text is not None:
                self._request(self._shared.snapshot)

    def _put_cursor(self, event: Any) -> None:
        if isinstance(event.args, int):
            self._cursor = event.args
            self._show_tree(self._shared.snapshot)

    def explain(self) -> None:
        """Explain the names in the cursor's row."""
        self._lines.run_method("explain")

    async def _ask(self, event: Any) -> None:
        """Explain the word in a row that is at a column, or all of the row."""
        if not isinstance(event.args, list) or len(event.args) != 2 or self._text is None:
            return
        index, column = event.args
        if isinstance(index, int) and isinstance(column, int):
            words = self._text.words_at(index, column if column >= 0 else None)
            await self._questions.request((self._text, index, words, column < 0))

    async def _answer(self, asked: tuple[PlcText, int, list[WordPlace], bool]) -> None:
        text, index, words, is_by_key = asked
        explained = self._shared.plc_words.explained
        found = await run.io_bound(explained, text.file, words, self._texts.language)
        html = self._texts["nothing_known"] if is_by_key and found is None else ""
        if text is self._text:
            self._lines.run_method("showTip", index, html if found is None else found)

    async def _click_number(self, event: Any) -> None:
        if isinstance(event.args, int):
            self._cursor = event.args
            await self.toggle_stop()

    def _choose_call(self, event: Any) -> None:
        if isinstance(event.value, int) and event.value != self._level:
            self._level = event.value
            self.show(self._shared.snapshot)

    def _choose_instance(self, _: Any) -> None:
        self.show(self._shared.snapshot)

    @property
    def line_of_cursor(self) -> int:
        """The line of the file of the statement in the cursor's row, or the next one; 0 without."""
        return 0 if self._text is None else self._text.statement_at(self._cursor)

    @property
    def stop_of_cursor(self) -> str:
        """The stop at the statement of the cursor; empty without."""
        line = self.line_of_cursor
        return statement_stop(self._names[self.file], line) if line else ""

    async def toggle_stop(self) -> None:
        """Set a stop at the statement of the cursor's row, or take those there away."""
        shared, file = self._shared, self.file
        line = self.line_of_cursor
        if not line:
            ui.notify(self._texts["plc_no_statement"])
            return
        if not self._commander.may():
            return
        kept = [stop for stop in shared.stops if line not in statement_stops([stop], file)]
        if len(kept) == len(shared.stops):
            kept.append(self.stop_of_cursor)
        await self._commander.attempt(lambda: shared.set_stops(kept))

    async def step(self, name: str) -> None:
        """Go to the statement that a command means."""
        kind, is_back, _ = _STEPS[name]
        if not self._commander.may():
            return
        answers: list[object] = []

        def go(session: Session) -> PlcPlace | None:
            return session.step_statement_back(kind) if is_back else session.step_statement(kind)

        if await self._commander.attempt(lambda: answers.append(self._shared.do(go))):
            if answers == [None]:
                ui.notify(self._texts["plc_none_before" if is_back else "plc_none_after"])


def _named(halt: PlcPlace) -> dict[int, str]:
    """Return the open calls of a place by their levels, with their instances."""
    return {
        level: one.name if one.instance in ("", one.name) else f"{one.name} ({one.instance})"
        for level, one in enumerate(halt.frames)
    }


def is_step(name: str) -> bool:
    """Return whether a command steps by statements."""
    return name in _STEPS
