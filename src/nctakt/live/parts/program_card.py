# SPDX-License-Identifier: MIT
"""The program on the page: the editor with its marks, stops, and findings while typing.

In: documents, snapshots. Out: an editor whose lines show the state of the session; texts that are
saved and rerun.
"""

from __future__ import annotations

import json
from collections.abc import Awaitable, Callable, Mapping, Sequence
from typing import Any

from nicegui import background_tasks, run, ui

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Severity
from nctakt.live import view
from nctakt.live.document import Document
from nctakt.live.parts.commander import Commander, Newest
from nctakt.live.parts.naming import card, explained, named
from nctakt.live.parts.plc_pane import PlcPane
from nctakt.live.syntax import Syntax
from nctakt.live.view import Snapshot
from nctakt.live.words import TextCursor, completed, explained_word, line_found

#: How long the page waits for more typing, in seconds.
_TYPING_S = 0.35

#: Where the cursor is in the editor: its line.
_LINE_OF_CURSOR = (
    "const view = getElement(ID).editor; return view.state.doc.lineAt(view.state.selection.main."
    "head).number"
)


@dataclass(frozen=True, slots=True)
class _Change:
    """A text that replaces another in the editor.

    ``begin``: the text of the file from which ``new`` was changed.
    """

    document: Document
    begin: str
    old: str
    new: str


@dataclass(frozen=True, slots=True)
class _Question:
    """A browser's question about a place: ``complete`` or ``explain``."""

    what: str
    number: int
    cursor: TextCursor
    text: str


#: Lines around the running block of a long program that a browser gets with it, on each side; so
#: many of them have to be there already if it gets none: about as many as it shows.
_AROUND, _NEAR = 80, 30


class ProgramCard:
    """The editor of one browser; ``findings``: of the present text, without notes.

    Typed text is kept: another text replaces it only if the browser confirms that it is the text
    known to the server, and unsaved text comes back with its program. For a long program the
    browser has only the lines in view; the text of the editor's element is empty then.
    """

    def __init__(
        self,
        commander: Commander,
        documents: Mapping[int, list[Document]],
        ask_why: Callable[[int], Any],
        on_findings: Callable[[], None],
        play: Callable[[], Awaitable[None]],
    ) -> None:
        self._commander = commander
        self._shared = commander.shared
        self._texts = commander.texts
        self._documents = documents
        self._ask_why = ask_why
        self._on_findings = on_findings
        self._play = play
        self._change: _Change | None = None
        self._drafts: dict[str, tuple[str, str]] = {}
        self._typed = 0
        self._checks = Newest(self._check)
        self._colours = Newest(self._send_lines)
        self._following = Newest(self._send_block)
        self._sent = range(0)
        self._searches = Newest(self._go_to)
        self._questions = {name: Newest(self._answer) for name in ("complete", "explain")}
        self._marks: list[dict[str, Any]] | None = None
        self._found: list[Diagnostic] = []
        self.findings: list[Diagnostic] = []
        self._checked: tuple[str, Sequence[str]] | None = None
        self._split: tuple[str, list[str]] = ("", [""])
        self._is_ready = False
        self._edition = self._line = 0
        self.document = self._shown_document()
        self._is_long = self.document.is_long
        self._begin = self.document.text
        self._syntax = Syntax(self.document.checker.synchronous)
        self._build()
        self._check_later()

    def _shown_document(self) -> Document:
        own = self._documents[self._shared.channel.number]
        return next((one for one in own if one.file == self._shared.channel.file), own[0])

    # --- layout ---------------------------------------------------------------------------------

    def _build(self) -> None:
        texts = self._texts
        with card(texts["program"], "nc-program"):
            with ui.element("div").classes("nc-row"):
                self._choice = (
                    ui.select({}, on_change=self._choose)
                    .props("dense options-dense borderless data-testid=file")
                    .classes("nc-file")
                )
                named(self._choice, texts["program"])
                self._edited = ui.label().classes("nc-soft").props("role=status")
                self._load = ui.button(texts["load"], icon="sync_problem", on_click=self._read)
                self._load.props("dense flat no-caps size=sm color=warning data-testid=load")
                self._load.set_visibility(False)
                ui.space()
                save = ui.button(texts["save_short"], icon="save", on_click=self.save)
                save.props("dense flat no-caps size=sm data-testid=save").tooltip(texts["save"])
            self._build_search()
            self._editor = ui.codemirror(
                _in_editor(self.document),
                theme="basicLight",
                line_wrapping=True,
                on_change=self._changed,
            ).props("data-testid=editor")
            self.plc = PlcPane(
                self._commander, self._show_choices, self._show_edited, self._on_findings
            )
            self._show_length()
            ui.on("nctakt_line", self._click)
            ui.on("nctakt_lines", self._request_lines)
            ui.on("nctakt_ask", self._ask)
            ui.on("nctakt_ready", self._be_ready)
            ui.on("nctakt_uncopied", lambda _: ui.notify(texts["uncopied"], type="warning"))

    def _build_search(self) -> None:
        """Build the field that finds lines of a long program, which says that it is one."""
        texts = self._texts
        self._search = ui.element("div").classes("nc-row")
        with self._search:
            self._length = ui.label().classes("nc-soft nc-length").props("role=status")
            self._length.props("data-testid=length")
            self._sought = ui.input(placeholder=texts["find_short"]).classes("nc-find")
            self._sought.props("dense outlined clearable maxlength=200 data-testid=find")
            explained(self._sought, texts["find"])
            self._sought.on("keydown.enter", self._find)

    def _show_length(self) -> None:
        count = f"{len(self.document.lines):,}"
        if self._texts.language == "de":
            count = count.replace(",", ".")
        is_shown = self._is_long and not self.plc.is_shown
        self._length.set_text(self._texts["long"].format(count=count) if is_shown else "")
        self._search.set_visibility(is_shown)

    def _choices(self) -> dict[str, str]:
        many = len(self._documents) > 1
        word = self._texts["channel"]
        programs = {
            f"{channel} {document.file}": (f"{word} {channel}: " if many else "") + document.file
            for channel, own in self._documents.items()
            for document in own
        }
        return programs | self.plc.choices()

    def _key(self) -> str:
        if self.plc.is_shown:
            return f"plc {self.plc.file}"
        return f"{self._shared.channel.number} {self.document.file}"

    def _show_choices(self) -> None:
        """Let a person choose among the programs and the files of the PLC that there are now."""
        self._choice.set_options(self._choices(), value=self._key())

    @property
    def editor_id(self) -> int:
        """The number of the editor's element."""
        return self._editor.id

    # --- display --------------------------------------------------------------------------------

    @property
    def text(self) -> str:
        """The text that the browser shows."""
        return self._begin if self._is_long else self._value

    @property
    def _value(self) -> str:
        return self._editor.value or ""

    @property
    def _lines(self) -> list[str]:
        """The lines of the browser's text; the same list as long as the text is the same."""
        text = self.text
        if text is self.document.text:
            return self.document.lines
        if text is not self._split[0]:
            self._split = text, text.split("\n")
        return self._split[1]

    @property
    def is_edited(self) -> bool:
        """Whether the editor's text differs from the saved one."""
        return self.text != self.document.text

    def show(self, snapshot: Snapshot) -> None:
        """Show the blocks, conditions and stops of a tick, and the PLC's position."""
        arrived = self.plc.arrived(snapshot)
        if arrived is not None:
            self.reveal(arrived[1], arrived[0])
        self.plc.show(snapshot)
        self._show_edited()
        shared, file = self._shared, self.document.file
        marks = []
        if self._checked is not None:
            lines, language = self._checked[1], self._texts.language
            marks += view.finding_marks(lines, file, self.findings, language)
        if not self.is_edited:
            stops = view.stop_lines(shared.stops, file)
            marks += view.program_marks(shared.channel.lines, file, snapshot, self._texts, stops)
        if marks != self._marks and self._is_ready and (self.is_checked or not self.is_edited):
            self._marks = marks
            if self._is_long:
                background_tasks.create(self._following.request(marks))
            else:
                self._run(f"mark({json.dumps(marks)})")

    def _show_edited(self) -> None:
        """Show whether there is unsaved text."""
        is_edited = self.is_edited and not self._is_long
        if self.plc.is_shown:
            is_edited = self.plc.edit.is_changed
        self._edited.set_text(f"● {self._texts['edited']}" if is_edited else "")

    def _run(self, call: str) -> None:
        """Let the browser's editor do something."""
        self._editor.client.run_javascript(f"nctaktEditor.{call}")

    def _be_ready(self, event: Any) -> None:
        """Start showing: the browser's editor exists, with earlier unsaved text."""
        self._is_ready, self._marks = True, None
        words = event.args if isinstance(event.args, dict) else {}
        drafts = words.get("drafts")
        for draft in drafts if isinstance(drafts, list) else ():
            self._take_draft(draft)
        begin, text = self._drafts.get(self.document.file, (self._begin, self._value))
        if text == self._value:
            self._own()
        else:
            self._replace(_Change(self.document, begin, self._value, text))
        self.show(self._shared.snapshot)

    def _take_draft(self, draft: object) -> None:
        """Accept a changed and unsaved text, if it belongs to a program here."""
        if not isinstance(draft, list) or not all(isinstance(one, str) for one in draft):
            return
        for document in (one for own in self._documents.values() for one in own):
            if len(draft) == 3 and document.file == draft[0] and not document.is_long:
                if draft[2] != document.text:
                    self._drafts[document.file] = draft[1], draft[2]

    def _own(self) -> None:
        """Tell the browser which text of which file its text is based on."""
        if not self._is_long:
            self._run(f"own({json.dumps(self.document.file)}, {json.dumps(self._begin)})")

    @property
    def is_checked(self) -> bool:
        """Whether the findings are those of the editor's present text."""
        return self._checked is not None and self._checked[0] == self.text

    def follow(self) -> None:
        """Show the chosen program, as last saved unless it is changed here."""
        if not self._is_ready:
            return
        shown = self._shown_document()
        is_outdated = self._begin != self.document.text and self.text == self._begin
        if shown is not self.document:
            begin, text = self._drafts.get(shown.file, (shown.text, _in_editor(shown)))
            self._replace(_Change(shown, begin, self._value, text))
        elif is_outdated:
            self._replace(_Change(shown, shown.text, self._value, _in_editor(shown)))

    def _replace(self, change: _Change) -> None:
        """Give the editor another text; if the user types meanwhile, at the next look."""
        if change == self._change:
            return  # the browser has been asked
        self._change = change
        if change.new == change.old:
            self._take_over()
            return
        self._run(f"replace({json.dumps(change.old)}, {json.dumps(change.new)})")

    def _changed(self) -> None:
        """Take over typed text, or a text that has replaced another."""
        if self._change is not None and self._value == self._change.new:
            self._take_over()
        self._change = None
        self._check_later()

    def _take_over(self) -> None:
        """Continue with the editor's present text."""
        change, self._change = self._change, None
        assert change is not None
        self._drafts.pop(change.document.file, None)
        is_other = change.document is not self.document
        if is_other and not self._is_long and change.old != self._begin:
            self._drafts[self.document.file] = self._begin, change.old
        self.document, self._begin = change.document, change.begin
        self._is_long = self.document.is_long and not change.new
        self._marks, self._found, self.findings, self._checked = None, [], [], None
        self._edition += 1
        self._sent = range(0)
        self._line = 0
        self._choice.set_value(self._key())
        self._show_length()
        self._own()
        background_tasks.create(self._colours.request((1, 1)))
        self.show(self._shared.snapshot)

    @property
    def _is_replaced(self) -> bool:
        """Whether the file on disk differs from the one that this browser shows or changes."""
        return self._begin != self.document.text or self.document.is_replaced

    def look_at_disk(self) -> None:
        """Report when the file on disk, or the PLC's, differs from what this browser shows."""
        is_replaced = self._is_replaced
        is_plc = self._shared.plc_files.are_replaced
        self._load.set_visibility(is_replaced or is_plc)
        if is_replaced or is_plc:
            name = "gone" if self.document.is_gone else "on_disk"
            self._edited.set_text(self._texts[name if is_replaced else "plc_on_disk"])

    def set_dark(self, is_dark: bool) -> None:
        """Use dark or light colours."""
        # not as a property of the element: with it the browser gets the text that the server knows
        self._editor.run_method("setTheme", "vscodeDark" if is_dark else "basicLight")
        self.plc.edit.set_dark(is_dark)

    def reveal(self, line: int, file: str = "") -> None:
        """Scroll to a line, of a file of the PLC or of the program."""
        key = f"plc {file}" if file else f"{self._shared.channel.number} {self.document.file}"
        if key != self._choice.value and key in self._choice.options:
            self._show_plc(key)
            self._choice.set_value(key)
        if file:
            self.plc.reveal(line)
        elif 1 <= line <= len(self._lines):
            self._editor.reveal_line(line)

    # --- lines ----------------------------------------------------------------------------------

    async def line_of_cursor(self) -> int:
        """Return the line of the cursor in the editor."""
        code = _LINE_OF_CURSOR.replace("ID", str(self._editor.id))
        return int(await ui.run_javascript(code, timeout=5.0))

    async def _click(self, event: Any) -> None:
        """A click on a line number sets a stop, a click next to a condition asks why."""
        words = event.args if isinstance(event.args, dict) else {}
        line = words.get("line")
        if not isinstance(line, int):
            return
        if words.get("what") == "stop":
            await self.toggle_stop(line)
        else:
            await self._ask_why(line)

    async def _request_lines(self, event: Any) -> None:
        """Send the lines that a browser has in view, with their colours."""
        words = event.args if isinstance(event.args, dict) else {}
        first, last = words.get("first"), words.get("last")
        if isinstance(first, int) and isinstance(last, int):
            await self._colours.request((first, last))

    async def _send_lines(self, bounds: tuple[int, int]) -> None:
        edition, lines = self._edition, self._lines
        count = len(lines) if self._is_long else 0
        shown = await run.io_bound(self._syntax.shown, lines, *bounds)
        if shown is not None and edition == self._edition:
            self._run(f"show(...{json.dumps([edition, count, max(bounds[0], 1), shown])})")

    async def _send_block(self, marks: list[dict[str, Any]]) -> None:
        """Send marks of a long program with the lines around its block, unless they are there.

        A block that runs fast has gone before the browser could ask for its lines.
        """
        edition = self._edition
        block = next((one["line"] for one in marks if one["class"] == "nc-block"), 0)
        first, shown = max(block - _AROUND, 1), None
        sent = self._sent
        if block and not sent.start <= max(block - _NEAR, 1) <= block + _NEAR < sent.stop:
            self._sent = range(first, block + _AROUND + 1)
            shown = await run.io_bound(self._syntax.shown, self._lines, first, block + _AROUND)
        if edition == self._edition:
            self._run(f"mark(...{json.dumps([marks, block, first, shown or []])})")

    # --- words ----------------------------------------------------------------------------------

    async def _ask(self, event: Any) -> None:
        """Answer a browser's question about a place."""
        words = event.args if isinstance(event.args, dict) else {}
        what, text = words.get("what"), words.get("text")
        if what not in self._questions or not isinstance(text, str):
            return
        numbers = [words.get(name) for name in ("number", "line", "column")]
        number, line, column = (one if isinstance(one, int) else -1 for one in numbers)
        if line > 0 and column >= 0:
            cursor = TextCursor(self.document.file, self._lines, line, column)
            await self._questions[what].request(_Question(what, number, cursor, text))

    async def _answer(self, asked: _Question) -> None:
        cursor, machine = asked.cursor, self.document.checker.machine
        language, lines = self._texts.language, cursor.lines
        found: object = None
        if cursor.line <= len(lines) and lines[cursor.line - 1] == asked.text:
            # if there is another text by now, nothing is known
            if asked.what == "complete":
                found = await run.io_bound(completed, cursor, machine, language)
            else:
                of_check = self._found if self.is_checked else []
                found = await run.io_bound(explained_word, cursor, machine, of_check, language)
        words = json.dumps([asked.what, asked.number, found])
        self._run(f"answer(...{words})")

    async def _find(self, _: Any) -> None:
        """Go to the line that is searched for."""
        request = (self._sought.value or "").strip()
        if request:
            await self._searches.request(request)

    async def _go_to(self, request: str) -> None:
        line = await run.io_bound(line_found, self._lines, request, self._line)
        if line:
            self._line = line
            self._run(f"go({line})")
        else:
            with self._editor.client:
                ui.notify(self._texts["not_found"].format(request=request), type="warning")

    def _show_plc(self, key: str) -> bool:
        """Show a file of the PLC in the editor's place, or not; return whether the key is one's."""
        is_plc = self.plc.choose(key)
        self._editor.set_visibility(not is_plc)
        self._show_length()
        return is_plc

    def show_next_file(self) -> None:
        """Show the next of the choices."""
        keys = list(self._choice.options)
        index = keys.index(self._choice.value) if self._choice.value in keys else -1
        self._choice.set_value(keys[(index + 1) % len(keys)])

    async def toggle_stop_at_cursor(self) -> None:
        """Set a stop where the cursor is, or take those there away."""
        if self.plc.is_shown:
            await self.plc.toggle_stop()
        else:
            await self.toggle_stop(await self.line_of_cursor())

    async def place_of_cursor(self) -> tuple[int, str]:
        """Return the line of the cursor, and its file if that belongs to the PLC."""
        if self.plc.is_shown:
            return self.plc.line_of_cursor, self.plc.file
        return await self.line_of_cursor(), ""

    async def stop_of_cursor(self) -> str:
        """Return the stop that a person means by the line of the cursor; empty: none."""
        if self.plc.is_shown:
            return self.plc.stop_of_cursor
        line = await self.line_of_cursor()
        lines, file = self._shared.channel.lines, self.document.file
        return view.stop_for(file, line, lines[line - 1]) if 1 <= line <= len(lines) else ""

    async def toggle_stop(self, line: int) -> None:
        """Set a stop in a line, or take those in it away."""
        shared, file = self._shared, self.document.file
        if not self._commander.may() or not 1 <= line <= len(shared.channel.lines):
            return
        kept = [stop for stop in shared.stops if line not in view.stop_lines([stop], file)]
        if len(kept) == len(shared.stops):
            kept.append(view.stop_for(file, line, shared.channel.lines[line - 1]))
        await self._commander.attempt(lambda: shared.set_stops(kept))

    # --- text -----------------------------------------------------------------------------------

    def _check_later(self) -> None:
        """Check the text after a short pause in typing."""
        self._typed += 1
        ui.timer(_TYPING_S, lambda typed=self._typed: self._checks.request(typed), once=True)

    async def _check(self, typed: int) -> None:
        if typed != self._typed:
            return
        text, lines = self.text, self._lines
        found = await run.io_bound(self.document.check, text)
        if typed == self._typed and found is not None:
            self._found, self._checked = found, (text, lines)
            self.findings = [one for one in found if one.severity > Severity.NOTE]
            self._on_findings()

    async def save(self) -> None:
        """Save the text and run the programs again."""
        if not self._commander.may():
            return
        if self.plc.edit.is_open:
            if await self.plc.save(lambda: self._shared.reopen(self._shared.program)):
                ui.notify(self._texts["saved"], type="positive", timeout=2000)
                await self._play()
            return
        text = self.text

        def save_and_run() -> None:
            if text != self.document.text:
                self.document.save(text, self._begin)
            self._begin = text  # from which further changes begin
            self._shared.reopen(self._shared.program)

        is_done = await self._commander.attempt(save_and_run)
        if self._begin is text:  # it is in the file, also where it does not run
            self._own()
        if is_done:
            self._marks = None
            ui.notify(self._texts["saved"], type="positive", timeout=2000)
            await self._play()

    async def _read(self) -> None:
        """Show the file from disk, and run it; if a PLC was saved, run the text here."""
        if not self._is_replaced:
            if await self._commander.attempt(lambda: self._shared.reopen(self._shared.program)):
                self.look_at_disk()
        elif self._commander.may():

            def read_and_run() -> None:
                self.document.read()
                self._shared.reopen(self._shared.program)

            if await self._commander.attempt(read_and_run):
                own, text = self.document, self.document.text
                self._replace(_Change(own, text, self._value, _in_editor(own)))

    async def _choose(self, event: Any) -> None:
        """Show another program, of this channel or another."""
        is_plc = self._show_plc(str(event.value))
        channel, _, file = str(event.value).partition(" ")
        if is_plc or event.value == f"{self._shared.channel.number} {self._shared.channel.file}":
            return
        if not self._commander.may():
            self._choice.set_value(self._key())
            return
        await self._commander.attempt(lambda: self._shared.look_at(int(channel), file))
        self._check_later()

    async def choose_program(self, file: str | None) -> None:
        """Run only one of the programs from the start, or all of them."""
        if not self._commander.may():
            return

        def run_it() -> None:
            self._shared.reopen(file)
            if file is not None:
                self._shared.look_at(1, file)

        await self._commander.attempt(run_it)


def _in_editor(document: Document) -> str:
    """Return the text that the editor's element has of a document."""
    return "" if document.is_long else document.text
