# SPDX-License-Identifier: MIT
"""The guided tour of the demo cell: six steps from a gate that stays shut to a changed past.

In: a shared session of the programs in the folder ``demo``. Out: a card that explains what to see,
and takes the session there.
"""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from functools import partial

from nicegui import ui

from nctakt.base.dataclass import dataclass
from nctakt.live.parts.commander import Commander
from nctakt.live.parts.naming import card
from nctakt.live.shared import PAGE
from nctakt.live.view import function_text
from nctakt.session.session import Session

#: The steps in their order: their words are ``tour_…`` of the page's texts.
_STEPS = ("cell", "run", "still", "why", "past", "change")

#: The condition whether somebody is standing at the gate, and its variable.
_CONDITION, _AREA = "$IF V.E.AREA_FREE", "V.E.AREA_FREE"

#: The function with which the program waits for the gate.
_WAITS_FOR = "M8"


@dataclass(frozen=True, slots=True)
class Hands:
    """Actions of the tour on the page: play, ask why in a line, show that line, or a list."""

    play: Callable[[], Awaitable[None]]
    ask_why: Callable[[int], Awaitable[None]]
    reveal: Callable[[int], None]
    choose_list: Callable[[str], None]


class Tour:
    """The tour of one browser; built where it is created."""

    def __init__(self, commander: Commander, hands: Hands) -> None:
        self._commander = commander
        self._shared = commander.shared
        self._texts = texts = commander.texts
        self._hands = hands
        self._file = commander.shared.channel.file
        self._step = 0
        self._is_busy = False
        with card(texts["tour"], "nc-flat nc-tour").props("data-testid=tour") as self._card:
            with ui.element("div").classes("nc-row"):
                self._title = ui.label().classes("nc-title col")
                self._back = self._button("tour_back", partial(self._go, -1))
                self._next = self._button("tour_next", partial(self._go, 1))
                self._next.props("color=primary autofocus").props(remove="flat")
                self._again = self._button("tour_again", self._begin_again)
                self._button("tour_end", lambda: self._card.set_visibility(False))
            self._text = ui.label().props("role=status data-testid=tour-text")
        self._show()

    def _button(self, name: str, act: Callable[[], object]) -> ui.button:
        button = ui.button(self._texts[name], on_click=act)
        return button.props(f"dense no-caps size=sm unelevated flat data-testid={name}")

    def _show(self, tick: int | None = 0) -> None:
        """Show the words of the step; ``tick``: that of the question, ``None`` if it is lost."""
        texts, name = self._texts, _STEPS[self._step]
        self._title.set_text(f"{self._step + 1}/{len(_STEPS)} {texts[f'tour_{name}_title']}")
        lost = texts["tour_lost"]
        words = {"tick": tick, "line": self._line()}
        self._text.set_text(lost if tick is None else texts[f"tour_{name}"].format(**words))
        self._back.set_enabled(self._step > 0)
        self._next.set_visibility(self._step + 1 < len(_STEPS))
        self._again.set_visibility(self._step + 1 == len(_STEPS) or tick is None)

    async def _go(self, steps: int) -> None:
        """Take the session to the next step, or the previous one, unless it is on its way."""
        if self._is_busy or not self._commander.may():
            return
        self._is_busy = True
        self._step = max(0, min(self._step + steps, len(_STEPS) - 1))
        name = _STEPS[self._step]
        found: list[int | None] = []
        try:
            is_there = await self._commander.attempt(lambda: found.append(self._go_to_step(name)))
        finally:
            self._is_busy = False
        self._show(found[0] if is_there else None)
        if is_there and found[0] is not None:
            await self._lend_a_hand(name)

    async def _lend_a_hand(self, name: str) -> None:
        """Execute the actions of a step on the page."""
        if name in ("run", "change"):
            await self._hands.play()
        if name == "why":
            self._hands.reveal(self._line())
            await self._hands.ask_why(self._line())
        if name == "change":
            self._hands.choose_list("branches")

    async def _begin_again(self) -> None:
        """Rerun the cell, as it was at the first step."""
        if self._commander.may() and await self._commander.attempt(self._shared.reopen):
            self._step = 0
            self._show()

    def _line(self) -> int:
        """Return the line of the question, 0 if it was removed."""
        lines = self._shared.description.texts.get(self._file, ())
        return next((number for number, line in enumerate(lines, 1) if _CONDITION in line), 0)

    def _go_to_step(self, name: str) -> int | None:
        """Take the session to a step; return the tick of the question, ``None`` if it is lost."""
        shared, file = self._shared, self._file
        if (shared.channel.number, shared.channel.file) != (1, file):
            shared.look_at(1, file)
        found: list[int | None] = []
        shared.do(lambda session: found.append(reach_step(session, file, self._line(), name)))
        return found[0]


def reach_step(session: Session, file: str, line: int, name: str) -> int | None:
    """Bring a session to a step; return the tick of the question, 0 before it has come up.

    ``None`` without a question, or if its answer was not the one that the tour describes.
    """
    session.pause()
    first = min(session.branches)
    session.go_to(session.branches[first], first)
    if name in ("cell", "run"):
        session.go_to(0)
        return 0
    if not any(function_text(entry) == _WAITS_FOR for _, entry in session.waiting()):
        session.run(until=_WAITS_FOR)
    events, _ = session.events(0, session.tick)
    fired = [
        (event.span.line, event.tick)
        for event in events
        if event.kind == "fired" and event.span is not None and event.span.file == file
    ]
    asked = [tick for at, tick in fired if at == line - 1]
    if not asked or any(at == line for at, _ in fired):
        return None
    if name == "past":
        session.go_to(asked[0] + 1)
    elif name == "change":
        session.go_to(asked[0])
        session.write({_AREA: 1}, PAGE)
    return asked[0]
