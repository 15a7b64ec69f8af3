# SPDX-License-Identifier: MIT
"""Whatever comes over a WebSocket of the page: the run continues, and others are served.

Messages of chance (malformed, of wrong types, enormous, deep, of another session, in any order),
floods, and connections that never become a browser's.
"""

from __future__ import annotations

import contextlib
import json
import random
import time
import urllib.error
import urllib.request
import zlib
from collections.abc import Iterator
from importlib.util import find_spec
from typing import Any

import pytest
from support.page_browsing import SOCKET, SocketBrowser
from support.page_driving import served
from support.random_seeds import each_seed

if find_spec("nicegui") is None:  # its import takes long, and only the page's process needs it
    pytest.skip("the live page needs NiceGUI", allow_module_level=True)
client = pytest.importorskip("websockets.sync.client", reason="strangers need websockets")

pytestmark = pytest.mark.slow

PART = """#RT CYCLE [ID=1 SCOPE=PROG]
  $IF V.E.CONDITION == 0
    V.E.CONDITION = 1
  $ELSE
    V.E.CONDITION = 0
  $ENDIF
#RT CYCLE END
G04 X2
M100
G04 X5
M30
"""

#: Messages of one seed.
MESSAGES = 150

#: Arguments of events, as JSON or not.
ARGUMENTS = [
    *map(
        json.dumps,
        (
            *(
                None,
                True,
                0,
                -1,
                2**63,
                1e308,
                0.5,
                "",
                "x",
                "\x1b[31m",
                "\n",
                "9 part.nc",
                "start",
            ),
            *([], [1], [0, 1], [0, 1000], ["a", "b"], [None, None], [[], []], list(range(5000))),
            *({}, {"line": 3, "what": "stop"}, {"line": 2**70, "what": "stop"}, {"line": 2}),
            *({"line": True}, {"line": 1.5}, {"key": None}, {"key": []}, {"value": -5, "label": 1}),
            *({"changes": [5]}, {"sections": [[0, "x"]]}, {"a": {"b": [{}]}}, "y" * 300_000),
        ),
    ),
    *("1e999", "NaN", "garbage", "", "[" * 100_000, "[" * 400 + "]" * 400),
]

#: Messages that are no events, or none of this page; ``OWN`` and ``OTHER``: IDs of pages.
FRAMES: list[str | bytes] = [
    *(
        "",
        "garbage",
        "1x",
        "2probe",
        "5",
        "6",
        "9" * 1000,
        "40/other",
        "42",
        "42[",
        "42[5]",
        "42{}",
    ),
    *('42["event",{}]', '42["handshake",5]', '42["javascript_response",{}]', '42["disconnect"]'),
    *('42["unknown",1]', '42/other,["event"]', "42" + "[" * 100_000, "42[" + "1," * 50_000 + "1]"),
    '42["ack",{"client_id":"OWN","next_message_id":"x"}]',
    '42["ack",{"client_id":"OWN","next_message_id":99999999}]',
    '42["log",{"client_id":"OWN","level":"error","message":""}]',
    '42["log",{"client_id":"OWN","level":"error","message":"\\u001b[31mred\\nTraceback"}]',
    '42["log",{"client_id":"OWN","level":5,"message":[]}]',
    '42["event",{"client_id":"OTHER","id":1,"listener_id":"q","args":[]}]',
    '42["event",{"client_id":"OWN","id":[],"listener_id":{},"args":{}}]',
    '42["handshake",{"client_id":"OTHER","tab_id":1,"document_id":1}]',
    '451-["event",{"_placeholder":true,"num":0}]',
    *(b"", b"\x00\xff" * 5000, b"\x04" * 10),
]

KEYS = [" ", ".", ",", "b", "B", "r", "R", "C", "Home", "End", "+", "s", "h", "Z", "l", "F9", "F8"]


@pytest.fixture(scope="module")
def address(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """A page that all tests share; at its end nothing that came is shown as a traceback."""
    folder = tmp_path_factory.mktemp("page")
    path, errors = folder / "part.nc", folder / "errors.txt"
    path.write_text(PART, "utf-8")
    with served(str(path), errors=errors) as page:
        yield page
    reported = errors.read_text("utf-8")
    assert "Traceback (most" not in reported
    assert "internal error" not in reported
    assert "\x1b" not in reported


def again(address: str) -> SocketBrowser:
    """A browser, once there is room for it."""
    while True:
        try:
            return SocketBrowser(address)
        except urllib.error.HTTPError as error:
            error.close()
        time.sleep(0.2)


def say_anything(chance: random.Random, speaker: SocketBrowser, other: str) -> None:
    """Send one message of chance."""
    kind = chance.random()
    with contextlib.suppress(Exception):  # the page may have hung up
        if kind < 0.6:
            # What is saved would be another program: it may have no first tick.
            element, _, _, listener = chance.choice(
                [one for one in speaker.listeners() if one[1] != "save"]
            )
            arguments = chance.choices(ARGUMENTS, k=chance.choice([0, 1, 1, 1, 1, 2]))
            speaker.fire(element, listener, *arguments)
        elif kind < 0.8:
            speaker.press(chance.choice(KEYS))
        else:
            frame = chance.choice(FRAMES)
            if isinstance(frame, str):
                frame = frame.replace("OWN", speaker.id).replace("OTHER", other)
            speaker.link.send(frame)


@each_seed(1, 1)
def test_messages_of_chance(seed: int, address: str) -> None:
    """Afterwards a tick is a tick, for who looked on all the time and for who comes now."""
    chance = random.Random(seed)
    with again(address) as other:
        speaker = again(address)
        speaker.press("p")
        for _ in range(MESSAGES):
            if speaker.is_gone:
                speaker = again(address)
                speaker.press("p")
            say_anything(chance, speaker, other.id)
        speaker.link.close()
        with again(address) as later:
            later.press("p")
            for looking in (later, other):
                looking.until(lambda state: "tick" in state)
            time.sleep(1.0)  # what was said last may still be on its way
            if later.state["isPlaying"]:
                later.press(" ")
            assert_obeyed(later, other)


def assert_obeyed(*browsers: SocketBrowser) -> float:
    """Go back and a tick forward by the first; all see it. Return how long it took, in seconds."""
    browsers[0].press("Home")
    took_s = sum(
        one.until(lambda state: state.get("isPlaying") is False and state.get("tick") == -1)
        for one in browsers
    )
    browsers[0].press(".")
    took_s += sum(one.until(lambda state: state["tick"] == 0) for one in browsers)
    assert not any(one.is_gone for one in browsers)
    return took_s


@pytest.mark.parametrize(("kind", "argument"), [("travel", 700), ("nctakt_key", {"key": "."})])
def test_a_flood_delays_no_one(kind: str, argument: Any, address: str) -> None:
    """One browser sends a thousand commands; another one takes control, and is obeyed."""
    with again(address) as other, again(address) as flooding:
        flooding.press("p")
        flooding.until(lambda state: "tick" in state)
        with contextlib.suppress(Exception):  # the page may hang up: it hears no more pongs
            for _ in range(1000):
                flooding.send(kind, argument)
        other.press("p")
        assert assert_obeyed(other) < 30


def endless(kind: str) -> tuple[bytes, bytes]:
    """Frames that a WebSocket may begin with, and what comes after them again and again."""
    frames = pytest.importorskip("websockets.frames")
    begin = frames.Frame(frames.Opcode.TEXT, b"42[", fin=False).serialize(mask=True)
    piece = frames.Frame(frames.Opcode.CONT, b"", fin=False).serialize(mask=True)
    if kind == "empty pieces":
        return begin, 20_000 * piece
    if kind == "pieces":
        return begin, frames.Frame(frames.Opcode.CONT, bytes(65_536), fin=False).serialize(
            mask=True
        )
    if kind == "pings":
        return b"", 2000 * frames.Frame(frames.Opcode.PING, bytes(125)).serialize(mask=True)
    if kind == "a length":
        return b"\x81\xff" + (1 << 62).to_bytes(8, "big") + bytes(4), bytes(65_536)
    assert kind == "packed"
    packer = zlib.compressobj(9, zlib.DEFLATED, -12)
    text = packer.compress(b"x" * 15_000_000) + packer.flush(zlib.Z_SYNC_FLUSH)
    packed = frames.Frame(frames.Opcode.TEXT, text[:-4]).serialize(mask=True)
    return b"", b"\xc1" + packed[1:]


@pytest.mark.parametrize("kind", ["empty pieces", "pieces", "pings", "a length", "packed"])
def test_frames_without_an_end(kind: str, address: str) -> None:
    """They end, and nobody else waits: before, 4 MB of empty pieces stopped the page for minutes.

    Nothing that is packed is unpacked, since 15 KB would become 15 MB.
    """
    begin, again_and_again = endless(kind)
    with again(address) as other, again(address) as speaker:
        other.until(lambda state: "tick" in state)
        with contextlib.suppress(OSError):
            speaker.link.socket.sendall(begin)
            while not speaker.is_gone:
                speaker.link.socket.sendall(again_and_again)
        other.press("p")
        assert assert_obeyed(other) < 30
        assert speaker.is_gone


def test_connections_that_become_no_browser(address: str) -> None:
    """They answer pings and say nothing: they end, and keep no browser out."""
    url = address.replace("http", "ws").rstrip("/") + SOCKET
    with contextlib.ExitStack() as crowd:
        links: list[Any] = []
        for _ in range(60):
            with contextlib.suppress(Exception):
                links.append(crowd.enter_context(client.connect(url, open_timeout=60)))
        assert len(links) < 60
        with again(address) as browser:
            browser.until(lambda state: "tick" in state)
            for link in links:
                assert is_ended(link)
            assert not browser.is_gone


def is_ended(link: Any) -> bool:
    """Whether a connection ends that answers each ping."""
    ends_s = time.monotonic() + 60
    while time.monotonic() < ends_s:
        try:
            if link.recv(timeout=60) == "2":
                link.send("3")
        except Exception:  # noqa: BLE001 - the library has several for a connection that is closed
            return True
    return False


def test_what_stands_for_a_websocket(address: str) -> None:
    """Requests in its stead leave no memory, and neither do pages that do not exist."""
    for path in ("no_such_page", "_nicegui_ws/socket.io/?EIO=4&transport=polling"):
        with pytest.raises(urllib.error.HTTPError, match=r"40[34]") as refused:
            urllib.request.urlopen(address + path, timeout=60)
        with refused.value as answer:
            assert len(answer.read()) < 100


@pytest.mark.nightly
def test_a_long_text_comes_in(address: str) -> None:
    """Two megabytes that a person pastes: the connection stays."""
    with again(address) as browser:
        length = len(PART) - 1
        change = {"sections": [length, -1, 0, 2_000_000], "inserted": [[], ["x" * 2_000_000]]}
        browser.press("p")
        browser.send("update:value", change, "editor")
        assert_obeyed(browser)
