# SPDX-License-Identifier: MIT
"""The server of the live page: its address, its guard, its end.

In: a shared session and its documents. Out: a page at an address until Ctrl-C. NiceGUI is imported
here and nowhere else outside the page. Browsers have places; pages without a browser are bounded,
too: a new one displaces the oldest of them.
"""

from __future__ import annotations

import asyncio
import contextlib
import gc
import logging
import os
import socket
import sys
from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Text
from nctakt.base.failure import Failure
from nctakt.live.access.guard import LOCAL, TOO_MANY, WORD, Access, Guard, Refused
from nctakt.live.document import Document
from nctakt.live.shared import SharedSession
from nctakt.live.texts import Texts
from nctakt.messages import diagnostic
from nctakt.messages.connections.live import (
    ADDRESS_NOT_USABLE,
    LIVE_LIBRARY_MISSING,
    MESSAGE_NOT_READABLE,
)
from nctakt.ports.token import new_token

if TYPE_CHECKING:
    from nicegui import Client
    from starlette.responses import Response

#: Bytes of a message of a browser: the longest is the text of the editor.
_MAX_MESSAGE = 16 * 1024 * 1024

#: Where addresses that mean all interfaces of a machine can be reached from itself.
_REACHABLE = {"0.0.0.0": "127.0.0.1", "::": "::1"}

#: How long a thread of the server may compute while the session's thread is due, in seconds.
_SWITCH_S = 0.001


#: The loggers of the libraries that read data from browsers.
_LOGGERS = ("asyncio", "engineio", "engineio.server", "nicegui", "socketio", "socketio.server")

#: Different reasons that are reported at most.
_MAX_REASONS = 20


#: Browsers that may look at the page at a time, and pages that may wait for theirs to connect.
MAX_BROWSERS, MAX_WAITING = 20, 20

_NOT_CONNECTED = Text("its browser did not connect", "sein Browser verband sich nicht")


def check_library() -> None:
    """Raise ``Failure`` (901160) where NiceGUI is not installed."""
    try:
        import nicegui  # noqa: F401, PLC0415 - only the page needs it
    except ImportError as error:
        raise Failure(diagnostic(LIVE_LIBRARY_MISSING)) from error


def usable_port(host: str, port: int) -> int:
    """Return the port, for 0 a free one; raises ``Failure`` (901161) if it is taken."""
    try:
        family = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0][0]
        with socket.socket(family, socket.SOCK_STREAM) as probe:
            probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            probe.bind((host, port))
            return int(probe.getsockname()[1])
    except (OSError, OverflowError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        found = diagnostic(ADDRESS_NOT_USABLE, host=host, port=port, reason=reason)
        raise Failure(found) from error


@dataclass(frozen=True, slots=True)
class Shown:
    """How the page is shown.

    ``has_tour``: with the tour of the demo cell. ``is_embedded``: an editor shows it in a panel.
    """

    has_plc: bool
    has_tour: bool = False
    opens_browser: bool = False
    is_embedded: bool = False


@dataclass(frozen=True, slots=True)
class Reports:
    """What the server calls: ``error`` for messages of browsers that cannot be understood.

    ``refused``: for requests and connections that were refused, with the client and the reason.
    """

    error: Callable[[Diagnostic], None]
    refused: Refused


def serve(
    shared: SharedSession,
    documents: Mapping[int, list[Document]],
    texts: Texts,
    address: tuple[str, int],
    *,
    shown: Shown,
    announce: Callable[[str], None],
    reports: Reports,
) -> None:
    """Serve the page until Ctrl-C; ``announce`` gets its address once."""
    from nicegui import Client, app, background_tasks, context, ui  # noqa: PLC0415 - only the page needs it

    from nctakt.live.access.compressing import Compression  # noqa: PLC0415 - as above
    from nctakt.live.access.connections import protocol  # noqa: PLC0415
    from nctakt.live.page import Page  # noqa: PLC0415

    (host, port), places = address, Places(Client.instances, reports.refused)
    access = Access(new_token(), host not in LOCAL, shown.is_embedded)
    word = f"?{WORD}={access.token}" if access.is_closed or shown.is_embedded else ""

    @ui.page("/", title="nctakt live")
    def show() -> None:
        places.let_wait(context.client)
        Page(shared, documents, texts, has_plc=shown.has_plc, has_tour=shown.has_tour)

    written = f"[{host}]" if ":" in host else host

    async def begin() -> None:
        gc.freeze()  # existing objects stay: this keeps garbage collection short
        background_tasks.create(_announce(f"http://{written}:{port}/{word}", host, port, announce))

    sys.setswitchinterval(_SWITCH_S)
    report_errors(reports.error)
    _guard(access, places, texts, reports.refused)
    app.on_startup(begin)
    ui.run(
        host=host,
        port=port,
        title="nctakt live",
        language="de" if texts.language == "de" else "en-US",
        reload=False,
        show=f"/{word}" if shown.opens_browser else False,
        show_welcome_message=False,
        uvicorn_logging_level="critical",
        http=protocol(reports.refused),
        ws_max_size=_MAX_MESSAGE,
        ws_per_message_deflate=False,  # a few bytes would become as many as a message may have
        tailwind=False,  # the page has its own styles: these would delay the first paint
        gzip_middleware_factory=Compression,
    )


def _guard(access: Access, places: Places, texts: Texts, refused: Refused) -> None:
    """Limit what browsers may send, and refuse those without access or place."""
    from nicegui import Client, app, core  # noqa: PLC0415 - only the page needs it

    from nctakt.live.access.sockets import Sockets  # noqa: PLC0415 - as above

    def refusal() -> str:
        return "" if places.make_room() else texts["too_many"].format(count=MAX_BROWSERS)

    def is_connected(page: str) -> bool | None:
        client = Client.instances.get(page)
        return None if client is None else client.has_socket_connection

    app.add_exception_handler(404, _not_found)
    app.config.socket_io_js_transports = ["websocket"]
    core.sio.eio.max_http_buffer_size = _MAX_MESSAGE
    app.add_middleware(Sockets, is_connected=is_connected, refused=refused)
    app.add_middleware(Guard, access=access, refusal=refusal, refused=refused)


async def _not_found(_: object, __: object) -> Response:
    """Answer with a line; the library would build a page, which costs as much as the real one."""
    from starlette.responses import PlainTextResponse  # noqa: PLC0415 - only the page needs it

    return PlainTextResponse("404: not found\n", 404)


async def _announce(url: str, host: str, port: int, announce: Callable[[str], None]) -> None:
    """Report the address once browsers can connect."""
    while True:
        with contextlib.suppress(OSError):
            _, writer = await asyncio.open_connection(_REACHABLE.get(host, host), port)
            writer.close()
            break
        await asyncio.sleep(0.01)
    announce(url)


def end_page() -> None:
    """Let ``serve``, which runs in another thread, return."""
    from nicegui import app  # noqa: PLC0415 - only the page needs it

    app.shutdown()


class _Reporter(logging.Handler):
    def __init__(self, report: Callable[[Diagnostic], None]) -> None:
        super().__init__(logging.ERROR)
        self._report = report
        self._reasons: set[str] = set()

    def emit(self, record: logging.LogRecord) -> None:
        """Report a record, unless its reason is known."""
        error = None if record.exc_info is None else record.exc_info[1]
        if error is None:
            reason = record.getMessage().splitlines()[0]
        else:
            reason = f"{type(error).__name__}: {error}".splitlines()[0]
        reason = reason[:120]
        if reason not in self._reasons and len(self._reasons) < _MAX_REASONS:
            self._reasons.add(reason)
            self._report(diagnostic(MESSAGE_NOT_READABLE, reason=reason))


def report_errors(report: Callable[[Diagnostic], None]) -> None:
    """Report errors of the libraries by ``report`` from now on."""
    if os.environ.get("NCTAKT_DEBUG"):
        return
    reporter = _Reporter(report)
    for name in _LOGGERS:
        logger = logging.getLogger(name)
        logger.handlers = [reporter]
        logger.propagate = False


class Places:
    """Who looks at the page; ``clients``: all pages that were fetched, by their IDs."""

    def __init__(self, clients: Mapping[str, Client], refused: Refused) -> None:
        self._clients = clients
        self._refused = refused
        self._taken: set[str] = set()

    def make_room(self) -> bool:
        """Return whether another page may be fetched."""
        if len(self._taken) >= MAX_BROWSERS:
            return False
        waiting = [one for one in self._clients.values() if one.id not in self._taken]
        if len(waiting) >= MAX_WAITING:
            oldest = min(waiting, key=lambda one: one.created)
            self._refused(oldest.ip, _NOT_CONNECTED)
            oldest.delete()
        return True

    def let_wait(self, client: Client) -> None:
        """Let a page wait for its browser, which takes a place once it connects."""
        client.on_connect(partial(self._take, client))
        client.on_delete(partial(self._leave, client.id))

    async def _take(self, client: Client) -> None:
        if client.id in self._taken:
            return  # it comes again
        if len(self._taken) < MAX_BROWSERS:
            self._taken.add(client.id)
            return
        self._refused(client.ip, TOO_MANY)
        client.run_javascript("location.reload()")  # it gets the reason
        client.delete()

    def _leave(self, name: str) -> None:
        """Return a place. A separate method: the library inspects each handler's signature."""
        self._taken.discard(name)
