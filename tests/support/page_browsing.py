# SPDX-License-Identifier: MIT
"""A browser without a window: it fetches the page, and speaks with it as a browser does."""

from __future__ import annotations

import contextlib
import html
import itertools
import json
import re
import threading
import time
import urllib.request
from collections.abc import Callable, Iterator
from typing import Any

#: Where the page's WebSocket is.
SOCKET = "/_nicegui_ws/socket.io/?EIO=4&transport=websocket"

#: How long the page may take for anything, in seconds.
PATIENCE_S = 60.0

_numbers = itertools.count(1000)


class SocketBrowser:
    """A page that is looked at, at an address. ``state``: the last state sent to its drawings.

    ``notes``: notifications that it has shown. ``is_gone``: the page has closed its connection.
    It says what it has drawn, as a page does that is looked at.
    """

    def __init__(self, address: str) -> None:
        from websockets.sync import client  # noqa: PLC0415 - tests without it are skipped

        with urllib.request.urlopen(address, timeout=PATIENCE_S) as answer:
            text = answer.read().decode("utf-8")
        self.id = _found(r"['\"]client_id['\"]: ['\"]([-0-9a-f]+)", text)
        elements = _found(r"parseElements\(String\.raw`(.*?)`\)", text)
        self._elements: dict[str, Any] = json.loads(html.unescape(elements))
        number = next(_numbers)
        words = f"client_id={self.id}&tab_id={number}&document_id={number}&next_message_id=0"
        url = address.replace("http", "ws").rstrip("/") + SOCKET
        self.link = client.connect(
            f"{url}&{words}&implicit_handshake=true", open_timeout=PATIENCE_S, max_size=None
        )
        self.link.recv(timeout=PATIENCE_S)
        self.link.send("40")
        assert str(self.link.recv(timeout=PATIENCE_S)).startswith("40")
        self.state: dict[str, Any] = {}
        self.notes: list[str] = []
        self.is_gone = False
        threading.Thread(target=self._listen, daemon=True).start()

    def __enter__(self) -> SocketBrowser:
        return self

    def __exit__(self, *_: object) -> None:
        self.link.close()

    def _listen(self) -> None:
        with contextlib.suppress(Exception):  # it may end in the midst of a message
            for message in self.link:
                if message == "2":
                    self.link.send("3")
                elif isinstance(message, str) and message.startswith("42"):
                    self._take(*json.loads(message[2:]))
        self.is_gone = True

    def _take(self, name: str, words: dict[str, Any]) -> None:
        if name == "update":
            self._elements |= {number: one for number, one in words.items() if one}
        elif name == "notify":
            self.notes.append(words["message"])
        elif name == "run_javascript":
            found = re.search(r'runMethod\(\d+, ?"take", ?(\[.*\])', words["code"], re.DOTALL)
            if found is not None:
                news = json.JSONDecoder().raw_decode(found[1])[0][0]
                self.state |= news
                if "number" in news:
                    self.send("nctakt_taken", news["number"])

    # --- what it sends --------------------------------------------------------------------------

    def listeners(self) -> Iterator[tuple[int, str, str, str]]:
        """What the page listens to: element, its name in tests, kind of the event, listener."""
        for number, element in list(self._elements.items()):
            for event in element.get("events") or () if isinstance(element, dict) else ():
                name = str((element.get("props") or {}).get("data-testid"))
                yield int(number), name, event["type"], event["listener_id"]

    def fire(self, element: int, listener: str, *arguments: str) -> None:
        """Send an event; ``arguments``: JSON."""
        words = {"client_id": self.id, "id": element, "listener_id": listener}
        self.link.send("42" + json.dumps(["event", {**words, "args": arguments}]))

    def send(self, kind: str, argument: Any, name: str | None = None) -> None:
        """Send an event of a kind; ``name``: that of its element in tests."""
        element, listener = next(
            (number, listener)
            for number, own, of_kind, listener in self.listeners()
            if of_kind == kind and name in (None, own)
        )
        self.fire(element, listener, json.dumps(argument))

    def press(self, key: str) -> None:
        """Press a key."""
        self.send("nctakt_key", {"key": key})

    def until(self, is_so: Callable[[dict[str, Any]], bool]) -> float:
        """Wait until the page shows something; return how long it took, in seconds."""
        begin_s = time.monotonic()
        while not is_so(self.state):
            assert time.monotonic() < begin_s + PATIENCE_S, (self.state, self.notes)
            time.sleep(0.01)
        return time.monotonic() - begin_s


def _found(pattern: str, text: str) -> str:
    found = re.search(pattern, text, re.DOTALL)
    assert found is not None
    return found[1]
