# SPDX-License-Identifier: MIT
"""The commands of one browser: permission, execution in a thread, reasons for refusal.

In: actions of a person. Out: commands to the session, notes on the page. Requests to the session
wait in a thread, never in the server's loop.
"""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from typing import Generic, TypeVar

from nicegui import Client, ui

from nctakt.base.failure import Failure, error_text
from nctakt.live.shared import PAGE, SharedSession
from nctakt.live.texts import Texts
from nctakt.live.view import plain_number
from nctakt.session.session import Session

Request = TypeVar("Request")

#: Maximum number of commands of one browser under way; those of a person are over before the next.
_MAX_UNDER_WAY = 8


class Newest(Generic[Request]):
    """Executes requests one by one; of those that come meanwhile only the newest."""

    def __init__(self, fulfil: Callable[[Request], Awaitable[None]]) -> None:
        self._fulfil = fulfil
        self._requests: list[Request] = []
        self._is_busy = False

    async def request(self, request: Request) -> None:
        """Make a request; return once it is fulfilled, or another call takes care of it."""
        self._requests = [request]
        if self._is_busy:
            return
        self._is_busy = True
        try:
            while self._requests:
                await self._fulfil(self._requests.pop())
        finally:
            self._is_busy = False


class Commander:
    """One browser's commands to the session."""

    def __init__(self, shared: SharedSession, texts: Texts, client: Client) -> None:
        self.shared = shared
        self.texts = texts
        self._client = client
        self._writing = asyncio.Lock()
        self._under_way = 0
        self._is_hurry_reported = False
        client.on_connect(self._arrive)
        client.on_disconnect(self._leave)

    # --- commands -------------------------------------------------------------------------------

    async def do(self, command: Callable[[Session], object]) -> bool:
        """Let the session carry out a command; return whether it did."""
        return self.may() and await self.attempt(lambda: self.shared.do(command))

    async def attempt(self, action: Callable[[], object]) -> bool:
        """Act in a thread; show why it is refused."""
        return await self._be_bounded(lambda: asyncio.to_thread(action))

    async def _be_bounded(self, act: Callable[[], Awaitable[object]]) -> bool:
        """Act, unless too much is under way; show why not, and return whether it acted."""
        if self._under_way >= _MAX_UNDER_WAY:
            if not self._is_hurry_reported:
                self._is_hurry_reported = True
                with self._client:
                    ui.notify(self.texts["too_fast"], type="warning")
            return False
        self._under_way += 1
        try:
            await act()
        except (Failure, RuntimeError, ValueError) as error:
            with self._client:
                self.refuse(error)
            return False
        finally:
            self._under_way -= 1
            self._is_hurry_reported &= self._under_way > 0
        return True

    def refuse(self, error: Exception) -> None:
        """Show why something is refused."""
        language = self.texts.language
        reasons = [error_text(error)]
        if isinstance(error, Failure):
            reasons = [
                f"{one.id}: {one.text(language)} {one.remedy(language)}"
                for one in error.diagnostics
            ]
        for reason in reasons[:3]:
            ui.notify(reason, type="negative", multi_line=True, timeout=8000, close_button=True)

    async def write(self, name: str, value: float | bool) -> bool:
        """Write a value, after those that this browser has written before; return whether."""

        async def act() -> None:
            async with self._writing:
                await asyncio.to_thread(self.shared.do, write_it)

        def write_it(session: Session) -> None:
            session.write({name: value}, PAGE)

        is_done = self.may() and await self._be_bounded(act)
        if is_done and not self.shared.snapshot.is_playing:
            note = f"{name} = {plain_number(value)}: {self.texts['next_tick']}"
            with self._client:
                ui.notify(note, timeout=2500)
        return is_done

    async def press(self, key: str) -> None:
        """Press a key of the operator's panel of the shown channel."""
        await self.write(f"{self.shared.channel.prefix}HLI.{key}", 1)

    # --- control --------------------------------------------------------------------------------

    @property
    def has_control(self) -> bool:
        """Whether this browser commands."""
        return self.shared.in_control == self._client.id

    def may(self) -> bool:
        """Return whether this browser may command; say so if not."""
        if self.shared.in_control is None:
            self.shared.in_control = self._client.id
        if not self.has_control:
            with self._client:
                ui.notify(self.texts["not_in_control"], type="warning")
            return False
        return True

    def take_control(self) -> None:
        """Command from now on."""
        self.shared.in_control = self._client.id

    def _arrive(self) -> None:
        """Take control if no browser has it; this is called only by one that opens the page."""
        if self.shared.in_control is None:
            self.shared.in_control = self._client.id

    def _leave(self) -> None:
        if self.has_control:
            self.shared.in_control = None
