# SPDX-License-Identifier: MIT
"""Who may see the live page: the address, the origin and the token of each request.

In: requests and WebSockets on their way to the page. Out: the same, or an answer 403. A page of
another site can reach neither: its origin is not the page's, and a name that points to this machine
(DNS rebinding) is not the page's host.
"""

from __future__ import annotations

import hmac
from collections.abc import Awaitable, Callable, MutableMapping
from http.cookies import CookieError, SimpleCookie
from typing import Any
from urllib.parse import parse_qs, urlsplit

Scope = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[MutableMapping[str, Any]]]
Send = Callable[[MutableMapping[str, Any]], Awaitable[None]]
Application = Callable[[Scope, Receive, Send], Awaitable[None]]

#: The name of the cookie that holds the token, and of the word in the address.
COOKIE, WORD = "nctakt_token", "token"

#: The names of this machine for itself.
LOCAL = ("127.0.0.1", "localhost", "::1")


_PLAIN = "text/plain; charset=utf-8"


class Guard:
    """Lets requests through that may see the page.

    ``token``: needed on other addresses than this machine's own; ``None``: not needed.
    ``refusal``: returns why no further browser can see the page now, empty if one can.
    """

    def __init__(
        self, application: Application, token: str | None, refusal: Callable[[], str]
    ) -> None:
        self._application = application
        self._token = token
        self._refusal = refusal

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
        if not is_admitted(headers, given, self._token):
            await _refuse(scope, send)
        elif given and self._token is not None and scope["type"] == "http":
            cookie = f"{COOKIE}={self._token}; Path=/; HttpOnly; SameSite=Strict"
            await _answer(send, 303, [("location", scope["path"]), ("set-cookie", cookie)])
        elif scope["type"] == "http" and scope["path"] == "/" and (reason := self._refusal()):
            await _answer(send, 503, [("content-type", _PLAIN)], f"{reason}\n".encode())
        else:
            await self._application(scope, receive, send)


def is_admitted(headers: dict[str, str], given: str, token: str | None) -> bool:
    """Return whether a request may pass: by host, origin, and token if there is one.

    ``given``: the token in its address.
    """
    host = headers.get("host", "")
    origin = headers.get("origin")
    if origin is not None and origin.partition("://")[2] != host:
        return False
    if token is None:
        return _name_of(host) in LOCAL
    return hmac.compare_digest((given or _cookie(headers)).encode(), token.encode())


def _name_of(host: str) -> str:
    try:
        return urlsplit(f"//{host}").hostname or ""
    except ValueError:
        return ""


def _cookie(headers: dict[str, str]) -> str:
    try:
        cookies = SimpleCookie(headers.get("cookie", ""))
    except CookieError:
        return ""
    return cookies[COOKIE].value if COOKIE in cookies else ""


async def _refuse(scope: Scope, send: Send) -> None:
    if scope["type"] == "websocket":
        await send({"type": "websocket.close", "code": 1008})
        return
    await _answer(send, 403, [("content-type", _PLAIN)], b"403: not admitted\n")


async def _answer(
    send: Send, status: int, headers: list[tuple[str, str]], body: bytes = b""
) -> None:
    encoded = [(name.encode(), value.encode()) for name, value in headers]
    encoded.append((b"content-length", str(len(body)).encode()))
    await send({"type": "http.response.start", "status": status, "headers": encoded})
    await send({"type": "http.response.body", "body": body})
