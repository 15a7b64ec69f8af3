# SPDX-License-Identifier: MIT
"""Who may see the live page: address, origin, fetch metadata and token of each request.

In: requests and WebSockets to the page. Out: the same, or an answer 403. A page of another site can
reach neither: its origin is not the page's, browsers mark requests caused by another site
(Sec-Fetch-Site), and a name that points to this machine (DNS rebinding) is not the page's host.
Nobody may show the page in a frame, except an editor for which it was started.
"""

from __future__ import annotations

import hmac
from collections.abc import Awaitable, Callable, MutableMapping
from http.cookies import CookieError, SimpleCookie
from typing import Any
from urllib.parse import parse_qs, urlsplit

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text

Scope = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[MutableMapping[str, Any]]]
Send = Callable[[MutableMapping[str, Any]], Awaitable[None]]
Application = Callable[[Scope, Receive, Send], Awaitable[None]]

#: Takes the address of a browser, and why a request or a connection of it was refused.
Refused = Callable[[str, Text], None]

#: The name of the cookie that holds the token, and of the word in the address.
COOKIE, WORD = "nctakt_token", "token"

#: The names of this machine for itself.
LOCAL = ("127.0.0.1", "localhost", "::1")

#: How browsers mark requests not caused by another site, and those for a frame.
_OWN_SITE, _FRAMES = ("same-origin", "none"), ("embed", "fencedframe", "frame", "iframe", "object")

#: How browsers request the page itself; other requests are for a picture, a script …
_PAGES = ("document", "empty", *_FRAMES)

#: Where editors show pages: in panels, which have addresses that no site can have.
_PANELS = "vscode-webview: vscode-file:"

_ORIGIN = Text("its origin is another site", "seine Herkunft ist eine andere Website")
_NO_TOKEN = Text("it has no token", "es hat kein Token")
_HOST = Text("it is for another host", "es gilt einem anderen Rechner")
_SITE = Text("another site has caused it", "eine andere Website hat es ausgelöst")
_FRAME = Text("it is for a frame", "es gilt einem Rahmen")
_NO_PAGE = Text("it does not want a page", "es will keine Seite")
TOO_MANY = Text("too many browsers", "zu viele Browser")

_PLAIN, _HTML = "text/plain; charset=utf-8", "text/html; charset=utf-8"

#: Result of following a link of another site: the page comes when a person asks for it.
_LINK = b'<!doctype html><title>nctakt live</title><p><a href="/">nctakt live</a>\n'


@dataclass(frozen=True, slots=True)
class Access:
    """Who may see the page.

    ``token``: each request needs it if ``is_closed``: on other addresses than this machine's own.
    ``is_embedded``: an editor that has the token shows the page in a panel.
    """

    token: str
    is_closed: bool
    is_embedded: bool

    def why_refused(self, headers: MutableMapping[str, str], path: str, given: str) -> Text | None:
        """Return why a request may not pass, if it may not; ``given``: the token in its address."""
        host, origin = headers.get("host", ""), headers.get("origin")
        if origin is not None and origin.partition("://")[2] != host:
            return _ORIGIN
        has_token = self.is_token(given)
        if self.is_closed and not has_token and not self.is_token(_cookie(headers)):
            return _NO_TOKEN
        if not self.is_closed and _name_of(host) not in LOCAL:
            return _HOST
        if headers.get("sec-fetch-site", "none") not in _OWN_SITE and not has_token:
            return _SITE
        target = headers.get("sec-fetch-dest", "document")
        if target in _FRAMES and not (has_token and self.is_embedded):
            return _FRAME
        if path == "/" and target not in _PAGES:
            return _NO_PAGE
        return None

    def is_token(self, given: str) -> bool:
        """Return whether a text is the token."""
        return hmac.compare_digest(given.encode("utf-8", "replace"), self.token.encode())

    def headers(self) -> list[tuple[bytes, bytes]]:
        """Return the headers of each answer: no other site may use the page."""
        found = {
            "content-security-policy": "frame-ancestors 'none'",
            "cross-origin-resource-policy": "same-origin",
            "referrer-policy": "no-referrer",
            "x-content-type-options": "nosniff",
            "x-frame-options": "DENY",
        }
        if self.is_embedded:
            found["content-security-policy"] = f"frame-ancestors {_PANELS}"
            del found["x-frame-options"]
        return [(name.encode(), value.encode()) for name, value in found.items()]


class Guard:
    """Lets requests through that may see the page.

    ``refusal``: returns why no further browser can see the page now, empty if one can. ``refused``:
    receives refused requests.
    """

    def __init__(
        self,
        application: Application,
        access: Access,
        refusal: Callable[[], str],
        refused: Refused,
    ) -> None:
        self._application = application
        self._access = access
        self._refusal = refusal
        self._refused = refused
        self._headers = access.headers()

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request on, or refuse it."""
        if scope["type"] not in ("http", "websocket"):
            await self._application(scope, receive, send)
            return
        headers = {
            name.decode("latin-1").lower(): value.decode("latin-1")
            for name, value in scope["headers"]
        }
        given = parse_qs(scope.get("query_string", b"").decode("latin-1")).get(WORD, [""])[0]
        is_http, path = scope["type"] == "http", scope["path"]
        respond = self._responding(send)
        if reason := self._access.why_refused(headers, path, given):
            self._report(scope, reason)
            await (_refuse(respond, headers) if is_http else _close(send))
        elif is_http and self._access.is_token(given) and not _is_for_frame(headers):
            cookie = f"{COOKIE}={given}; Path=/; HttpOnly; SameSite=Strict"
            await _answer(respond, 303, [("location", path), ("set-cookie", cookie)])
        elif is_http and path == "/" and (words := self._refusal()):
            self._report(scope, TOO_MANY)
            await _answer(respond, 503, [("content-type", _PLAIN)], f"{words}\n".encode())
        else:
            await self._application(scope, receive, respond)

    def _report(self, scope: Scope, reason: Text) -> None:
        self._refused(str((scope.get("client") or ("",))[0]), reason)

    def _responding(self, send: Send) -> Send:
        """Return ``send``, which adds the headers that each answer has."""

        async def respond(message: MutableMapping[str, Any]) -> None:
            if message["type"] == "http.response.start":
                message = {**message, "headers": [*message.get("headers", ()), *self._headers]}
            await send(message)

        return respond


def _is_for_frame(headers: MutableMapping[str, str]) -> bool:
    return headers.get("sec-fetch-dest") in _FRAMES


def _name_of(host: str) -> str:
    try:
        return urlsplit(f"//{host}").hostname or ""
    except ValueError:
        return ""


def _cookie(headers: MutableMapping[str, str]) -> str:
    try:
        cookies = SimpleCookie(headers.get("cookie", ""))
    except CookieError:
        return ""
    return cookies[COOKIE].value if COOKIE in cookies else ""


async def _close(send: Send) -> None:
    await send({"type": "websocket.close", "code": 1008})


async def _refuse(send: Send, headers: MutableMapping[str, str]) -> None:
    """Answer 403; a person who has followed a link of another site gets a link to the page."""
    is_link = headers.get("sec-fetch-mode") == "navigate" and not _is_for_frame(headers)
    kind, body = (_HTML, _LINK) if is_link else (_PLAIN, b"403: not admitted\n")
    await _answer(send, 403, [("content-type", kind)], body)


async def _answer(
    send: Send, status: int, headers: list[tuple[str, str]], body: bytes = b""
) -> None:
    encoded = [(name.encode(), value.encode()) for name, value in headers]
    encoded.append((b"content-length", str(len(body)).encode()))
    await send({"type": "http.response.start", "status": status, "headers": encoded})
    await send({"type": "http.response.body", "body": body})
