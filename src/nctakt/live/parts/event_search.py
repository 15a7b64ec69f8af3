# SPDX-License-Identifier: MIT
"""The search above the list of events: its field, its buttons, what it has found.

In: a text, and what a person requests next. Out: the matches of a page as rows; the session goes to
the previous or the next match.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Sequence
from typing import Any

from nicegui import ui

from nctakt.base.failure import error_text
from nctakt.live.parts.commander import Commander
from nctakt.live.parts.naming import explained, named
from nctakt.live.searching import Search
from nctakt.live.view import MAX_SIGNALS, LogRow
from nctakt.results.trace.event_words import MAX_SOUGHT
from nctakt.results.trace.events import Event

#: Signals that are offered where their names contain the text.
_MAX_SIGNALS_OFFERED = 5

#: Rows above a match that the session has gone to.
_ABOVE = 20


class SearchBar:
    """The search of one browser.

    ``page``: how many rows the list has at most; ``renew`` is called when it looks for another
    text, or for nothing any more.
    """

    def __init__(self, commander: Commander, page: int, renew: Callable[[], None]) -> None:
        self._commander = commander
        self._renew = renew
        self._shared = commander.shared
        self._texts = commander.texts
        self._page = page
        self._search: Search | None = None
        self._skipped = self._newer = 0
        texts = self._texts
        with ui.element("div").classes("nc-row"):
            self._field = ui.input(placeholder=texts["search"], on_change=self._begin)
            self._field.props(
                f"dense outlined clearable maxlength={MAX_SOUGHT} data-testid=search-events"
            ).classes("col")
            self._field.on("keydown.enter.exact", lambda: self.hop(is_back=True))
            self._field.on("keydown.shift.enter", lambda: self.hop(is_back=False))
            named(self._field, texts["search_events"])
            with ui.element("div").classes("nc-matches") as self._buttons:
                self._button("previous_match", "navigate_before", lambda: self.hop(is_back=True))
                self._button("next_match", "navigate_next", lambda: self.hop(is_back=False))
                self._button("older_matches", "expand_more", self._show_older)
                self._button("newer_matches", "expand_less", self._show_newer)
        with ui.element("div").classes("nc-row"):
            self._state = ui.label().classes("nc-soft col").props("data-testid=search-state")
            self._announced = (
                ui.label().classes("nc-soft").props("data-testid=search-announced role=status")
            )
        for part in (self._buttons, self._state, self._announced):
            part.set_visibility(False)

    def _button(self, name: str, icon: str, act: Any) -> None:
        button = ui.button(icon=icon, on_click=act).props(f"flat dense size=sm data-testid={name}")
        explained(button, self._texts[name])

    @property
    def text(self) -> str:
        """The text searched for, empty if there is none."""
        return (self._field.value or "").strip()[:MAX_SOUGHT]

    def focus(self) -> None:
        """Let a person type what to look for."""
        self._field.run_method("focus")

    def close(self) -> None:
        """Search no more."""
        if self._search is not None:
            self._search.end_it()
            self._shared.searches.go_on()
        self._search = None

    # --- searching ------------------------------------------------------------------------------

    def _begin(self) -> None:
        """Search for the text in the branch that is shown, from its latest tick back."""
        self.close()
        self._skipped = self._newer = 0
        self._announce("")
        if self.text:
            self._search = Search(self._shared.session, self.text, self._texts.language)
            self._shared.searches.begin(self._search)
        for part in (self._buttons, self._state):
            part.set_visibility(bool(self.text))
        self._state.set_text("")
        self._renew()

    def _announce(self, text: str) -> None:
        self._announced.set_text(text)
        self._announced.set_visibility(bool(text))

    def _current(self) -> Search | None:
        """Return the search, restarted where another branch or another run is shown."""
        search, shared = self._search, self._shared
        if search is not None and (
            search.session is not shared.session or search.branch != shared.snapshot.branch
        ):
            self._begin()
        return self._search

    def shown(self) -> tuple[Sequence[Event], bool]:
        """Return the matches of the page, in their order, and whether it is all by now.

        The state of the search is shown next to its field.
        """
        search, texts = self._current(), self._texts
        if search is None:
            return (), True
        events, is_done, newer = search.events, search.is_done, search.newer
        self._skipped += newer - self._newer if self._skipped else 0
        self._newer = newer
        self._skipped = min(self._skipped, max(0, len(events) - 1))
        name = "matches_newest" if search.is_full or not search.is_newest else "matches"
        name = name if is_done else "matches_so_far"
        state = texts[name].format(count=len(events), tick=search.begin)
        if search.error is not None:
            state = error_text(search.error)
        if state != self._state.text:
            self._state.set_text(state)
        if is_done and not self._announced.text and search.error is None:
            self._announce(
                texts["found"].format(count=len(events)) if events else texts["none_found"]
            )
        end = len(events) - self._skipped
        return events[max(0, end - self._page) : end], is_done

    def signal_rows(self) -> list[LogRow]:
        """Return the signals whose names contain the text, and are not in the scope yet."""
        text, shared = self.text.casefold(), self._shared
        if not text:
            return []
        signals = shared.description.signals
        shown = {*shared.scope, *(f"CH1.{name}" for name in signals)}  # each by one name
        names = [name for name in signals if text in name.casefold() and name not in shown]
        word = self._texts["to_scope"]
        offered = names[:_MAX_SIGNALS_OFFERED]
        return [LogRow("signal", 0, f"{word}: {name}", signal=name) for name in offered]

    async def add_signal(self, name: str) -> None:
        """Show a signal in the scope, in place of the last one if there is no room."""
        shared = self._shared
        is_hidden = name in shared.description.signals and name not in shared.scope
        if is_hidden and self._commander.may():
            chosen = [*shared.scope[: MAX_SIGNALS - 1], name]
            await self._commander.attempt(lambda: shared.choose(chosen))

    # --- from match to match --------------------------------------------------------------------

    async def hop(self, *, is_back: bool) -> None:
        """Let the session go to the tick of the previous or the next match."""
        search, texts = self._current(), self._texts
        if search is None:
            self.focus()
            return
        if not self._commander.may():
            return
        answer = search.hop(self._shared.snapshot.shown_tick, is_back=is_back)
        self._shared.searches.go_on()
        self._announce(texts["working"])
        tick = await asyncio.wrap_future(answer)
        if search is not self._search:
            return
        if tick is None:
            self._announce(texts["no_earlier_match" if is_back else "no_later_match"])
        elif await self._commander.do(lambda session: session.go_to(tick + 1)):
            self._announce(texts["match_in_tick"].format(tick=tick))
            self._turn_to(search, tick)

    def _turn_to(self, search: Search, tick: int) -> None:
        """Let the page be one that has the matches in a tick."""
        later = sum(1 for one in search.events if one.tick > tick)
        if not self._skipped <= later < self._skipped + self._page:
            self._skipped = max(0, later - _ABOVE)

    def _show_older(self) -> None:
        """Show the page of older matches."""
        search = self._current()
        if search is None:
            return
        if self._skipped + self._page < len(search.events):
            self._skipped += self._page
        elif search.begin:
            self._turn(search, is_older=True)

    def _show_newer(self) -> None:
        """Show the page of newer matches, after the last one the newest."""
        search = self._current()
        if search is None:
            return
        if self._skipped:
            self._skipped = max(0, self._skipped - self._page)
        elif not search.is_newest:
            self._turn(search, is_older=False)

    def _turn(self, search: Search, *, is_older: bool) -> None:
        self._skipped = 0
        search.turn(is_older=is_older)
        self._shared.searches.go_on()
