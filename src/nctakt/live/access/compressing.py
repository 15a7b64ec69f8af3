# SPDX-License-Identifier: MIT
"""Answers are compressed for browsers on other machines.

In: requests to the page. Out: the same for a browser on this machine, for which bytes cost less
than compressing them; compressed answers for others.
"""

from __future__ import annotations

from starlette.middleware.gzip import GZipMiddleware

from nctakt.live.access.guard import Application, Receive, Scope, Send

#: Bytes from which on an answer is compressed, and how hard: more work makes it hardly smaller.
_MIN_BYTES, _LEVEL = 500, 5


class Compression(GZipMiddleware):
    """Compresses answers, but not those for a browser of this machine."""

    def __init__(self, app: Application) -> None:
        super().__init__(app, _MIN_BYTES, _LEVEL)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request on."""
        host = str((scope.get("client") or ("",))[0])
        if host == "::1" or host.startswith(("127.", "::ffff:127.")):
            await self.app(scope, receive, send)
        else:
            await super().__call__(scope, receive, send)
