# SPDX-License-Identifier: MIT
"""The live page as an endpoint of ``nctakt serve``: the operator's, in the browser.

In: the session that clients share, its programs. Out: the page's address until the servers end. The
page commands the session as any client does, and cannot restart it.
"""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Future

from nctakt.base.diagnostics import Language
from nctakt.base.failure import Failure
from nctakt.live.access.connections import MAX_CONNECTIONS
from nctakt.live.document import Checker, Document
from nctakt.live.server import Reports, Shown, end_page, serve, usable_port
from nctakt.live.shared import SharedSession
from nctakt.live.texts import Texts
from nctakt.messages import diagnostic
from nctakt.messages.connections.live import SESSION_IS_SHARED
from nctakt.session.session import Session


class PageEndpoint:
    """The page of a session at an address; ``programs``: by channel, at least one.

    ``reports`` are called from the page's own thread.
    """

    max_connections = MAX_CONNECTIONS

    def __init__(
        self,
        session: Session,
        programs: Mapping[int, Sequence[str]],
        checker: Checker,
        address: tuple[str, int],
        language: Language,
        *,
        acknowledges: bool,
        has_plc: bool,
        reports: Reports,
    ) -> None:
        self._session = session
        self._address = address
        self._language: Language = language
        self._acknowledges = acknowledges
        self._has_plc = has_plc
        self._reports = reports
        self._documents = {
            number: [Document(program, checker) for program in own]
            for number, own in programs.items()
            if own
        }
        self._announced_address: Future[str] = Future()
        self._shared: SharedSession | None = None
        self._thread: threading.Thread | None = None

    async def prepare(self) -> None:
        """Let the page share the session."""
        channel = next(iter(self._documents))
        file = self._documents[channel][0].file
        transformed = self._documents[channel][0].checker.transformed
        self._shared = await asyncio.to_thread(
            lambda: SharedSession(
                self._open_once(),
                file,
                acknowledges=self._acknowledges,
                channel=channel,
                transformed=transformed,
            )
        )

    async def open(self) -> str:
        """Show the page; return its address. Raises ``Failure`` (901161)."""
        address = self._address[0], usable_port(*self._address)
        self._thread = threading.Thread(
            target=self._serve, args=(self._shared, address), name="nctakt page", daemon=True
        )
        self._thread.start()
        return await asyncio.wrap_future(self._announced_address)

    def _open_once(self) -> Callable[[str | None, bool], Session]:
        """Return a function that gives the session once; then it raises ``Failure`` (901380)."""
        sessions = [self._session]

        def open_session(program: str | None, acknowledges: bool) -> Session:
            if not sessions:
                raise Failure(diagnostic(SESSION_IS_SHARED))
            return sessions.pop()

        return open_session

    def _serve(self, shared: SharedSession, address: tuple[str, int]) -> None:
        try:
            serve(
                shared,
                self._documents,
                Texts(self._language),
                address,
                shown=Shown(self._has_plc),
                announce=self._announced_address.set_result,
                reports=self._reports,
            )
        except BaseException as error:  # noqa: BLE001 - whoever opens the endpoint gets it
            if not self._announced_address.done():
                self._announced_address.set_exception(error)

    async def close(self) -> None:
        """Let the page end; the session stays."""
        end_page()
        if self._thread is not None:
            await asyncio.to_thread(self._thread.join, 3.0)
        if self._shared is not None:
            await asyncio.to_thread(self._shared.leave)
