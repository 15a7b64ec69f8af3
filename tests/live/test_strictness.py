# SPDX-License-Identifier: MIT
"""What the live page does with what it should not get: strangers, garbage, crowds, floods."""

import contextlib
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest
from support.page_browsing import SOCKET, SocketBrowser
from support.page_driving import BROWSER, chromium, opened, served

from nctakt import NcText, Session
from nctakt.live import track
from nctakt.live.run_log import MAX_LOG
from nctakt.live.shared import SharedSession

if find_spec("nicegui") is None:  # its import takes long, and only the page's process needs it
    pytest.skip("the live page needs NiceGUI", allow_module_level=True)
client = pytest.importorskip("websockets.sync.client", reason="strangers need websockets")
InvalidStatus = pytest.importorskip("websockets.exceptions").InvalidStatus

pytestmark = pytest.mark.slow

#: What a browser says of a picture that a page of another site wants.
WEBSITE = {"Sec-Fetch-Site": "cross-site", "Sec-Fetch-Mode": "no-cors", "Sec-Fetch-Dest": "image"}

GARBAGE: list[str | bytes] = [
    "garbage",
    "42[",
    '42["event",{}]',
    '42["event",{"client_id":"x","id":1,"listener_id":"y","args":[]}]',
    '42["handshake",5]',
    '42["javascript_response",{}]',
    "9" * 100_000,
    b"\x00\xff" * 1000,
]

TURNING = """#RT CYCLE [ID=1 SCOPE=PROG]
  $IF V.E.CONDITION == 0
    V.E.CONDITION = 1
  $ELSE
    V.E.CONDITION = 0
  $ENDIF
#RT CYCLE END
G04 X100000
M30
"""


@contextlib.contextmanager
def connected(address: str, **options: Any) -> Iterator[Any]:
    """A WebSocket of the page, greeted."""
    url = address.replace("http", "ws").rstrip("/") + SOCKET
    with client.connect(url, open_timeout=60, **options) as link:
        link.recv(timeout=60)
        link.send("40")
        link.recv(timeout=60)
        yield link


def status_of(address: str, **headers: str) -> tuple[int, str]:
    """What an address answers: its status, the begin of its text."""
    request = urllib.request.Request(address, headers=headers)
    try:
        with urllib.request.urlopen(request, timeout=60) as answer:
            return answer.status, answer.read(200).decode("utf-8", "replace")
    except urllib.error.HTTPError as error:
        with error:
            return error.code, error.read(200).decode("utf-8", "replace")


def program(folder: Path) -> str:
    """A program that goes on for long."""
    path = folder / "part.nc"
    path.write_text(TURNING, "utf-8")
    return str(path)


def test_strangers_garbage_and_files(tmp_path: Path) -> None:
    """Another site's socket is refused, garbage is dropped and reported once, files stay unseen."""
    errors = tmp_path / "errors.txt"
    (tmp_path / "secret.txt").write_text("secret", "utf-8")
    with served(program(tmp_path), errors=errors) as address:
        with (
            pytest.raises(Exception, match=r"403|1008"),
            connected(address, origin="https://elsewhere.example"),
        ):
            pass
        for words in GARBAGE * 2:
            with connected(address) as link, contextlib.suppress(Exception):
                link.send(words)
                link.recv(timeout=0.2)
        for path in ("../secret.txt", "%2e%2e/secret.txt", "secret.txt", "_nicegui/../secret.txt"):
            assert "secret" not in status_of(address + path)[1]
        assert status_of(address)[0] == 200
    reported = errors.read_text("utf-8")
    assert "Traceback" not in reported
    assert reported.count("JSONDecodeError") == 1
    assert "901317" in reported


@pytest.mark.nightly
def test_a_crowd_is_reported(tmp_path: Path) -> None:
    """The twenty-first browser gets a sentence; who only fetches the page takes no place."""
    errors = tmp_path / "errors.txt"
    with served(program(tmp_path), "--lang", "de", errors=errors) as address:
        for _ in range(25):
            assert status_of(address, **WEBSITE)[0] == 403
            assert status_of(address)[0] == 200
        with contextlib.ExitStack() as crowd:
            count, status = 0, 200
            while status != 503:  # on a busy machine the page loses some, and takes others
                crowd.enter_context(SocketBrowser(address))
                count += 1
                assert count < 60
                status, text = status_of(address)
            assert count >= 20
            assert text.startswith("503: zu viele Browser")
        ends = time.monotonic() + 60
        while status_of(address)[0] != 200:  # a place is free some seconds after its browser went
            assert time.monotonic() < ends
            time.sleep(0.2)
    reported = errors.read_text("utf-8")
    assert "902040" in reported
    assert "25 × eine andere Website" in reported


def test_a_website_gets_nothing(tmp_path: Path) -> None:
    """Neither in a frame nor as a picture; a link of one leads to a link of the page's own."""
    with served(program(tmp_path)) as address:
        request = urllib.request.Request(address)
        with urllib.request.urlopen(request, timeout=60) as answer:
            assert answer.headers["content-security-policy"] == "frame-ancestors 'none'"
            assert answer.headers["x-frame-options"] == "DENY"
        frame = {**WEBSITE, "Sec-Fetch-Dest": "iframe", "Sec-Fetch-Mode": "navigate"}
        assert status_of(address, **frame) == (403, "403: not admitted\n")
        link = {**WEBSITE, "Sec-Fetch-Dest": "document", "Sec-Fetch-Mode": "navigate"}
        status, text = status_of(address, **link)
        assert (status, '<a href="/">' in text) == (403, True)


@pytest.mark.nightly
@pytest.mark.parametrize("mark", [pytest.param(None, marks=BROWSER)])
def test_a_hundred_connections_do_not_stop_the_tick(tmp_path: Path, mark: None) -> None:
    """The page goes on, also for a browser that comes after the one that closed in mid-run.

    Connections beyond those that may say nothing are refused.
    """
    with served(program(tmp_path)) as address, chromium() as browser:
        page = opened(browser, address)
        page.get_by_test_id("toggle").click()
        page.wait_for_function("nctaktRun.run.tick > 100")
        with contextlib.ExitStack() as crowd:
            for number in range(100):
                with contextlib.suppress(InvalidStatus):
                    link = crowd.enter_context(connected(address))
                    link.send(f'42["event",{{"client_id":"{number}"}}]')
            before = page.evaluate("nctaktRun.run.tick")
            page.wait_for_function(f"nctaktRun.run.tick > {before} + 500")
        page.close()
        later = opened(browser, address)
        later.wait_for_function(f"nctaktRun.run.tick > {before} + 500")
        later.get_by_test_id("toggle").click()
        later.wait_for_function("!nctaktRun.run.isPlaying")


@pytest.mark.nightly
def test_a_flood_of_events_is_bounded() -> None:
    """More than a million events a second: lists stay short, what is left out is reported."""

    def opener(chosen: str | None, acknowledges: bool) -> Session:
        return Session(NcText("part.nc", TURNING), acknowledges=acknowledges, until="1 h")

    shared = SharedSession(opener, "part.nc", acknowledges=True)
    try:
        shared.do(lambda session: session.play())
        ends = time.monotonic() + 120
        while shared.snapshot.tick < 200_000 and time.monotonic() < ends:
            time.sleep(0.05)
        shared.do(lambda session: session.pause())
        assert shared.session.tick >= 200_000
        assert shared.log.left_out > 0
        assert len(shared.log.events) == MAX_LOG
        assert 0 < len(shared.track.marks) <= track.MAX_MARKS
        assert shared.session.step(1).tick == shared.session.tick
    finally:
        shared.close()


def test_a_taken_port_ends_the_command(tmp_path: Path) -> None:
    """With exit code 2, number and remedy, and without a traceback."""
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = str(taken.getsockname()[1])
        done = subprocess.run(
            [sys.executable, "-m", "nctakt", "live", program(tmp_path), "--port", port],
            capture_output=True,
            encoding="utf-8",
            timeout=120,
            check=False,
        )
    assert done.returncode == 2
    assert "901161" in done.stderr
    assert "--port 0" in done.stderr
    assert "Traceback" not in done.stderr


def test_a_program_from_standard_input_is_refused() -> None:
    """901318."""
    done = subprocess.run(
        [sys.executable, "-m", "nctakt", "live", "-", "--port", "0"],
        input="M30\n",
        capture_output=True,
        encoding="utf-8",
        timeout=120,
        check=False,
    )
    assert done.returncode == 2
    assert "901318" in done.stderr
