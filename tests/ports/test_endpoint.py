# SPDX-License-Identifier: MIT
"""A port with a token: who comes in, and what those cost who do not."""

from __future__ import annotations

import socket
import stat
import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest

from nctakt import Failure
from nctakt.ports import endpoint as endpoint_module
from nctakt.ports.endpoint import VISIT_BYTES, Endpoint, Visitor
from nctakt.ports.token import known_token, new_token


def echo(visitor: Visitor) -> None:
    """Serve a client that sends its token in a line, ``-`` for none, then lines to repeat."""
    first = visitor.reading.readline().decode().strip()
    try:
        visitor.enter(None if first.startswith("-") else first, "echo", is_open=first == "-open")
    except Failure as failure:
        visitor.writing.write(f"{failure.diagnostics[0].id}\n".encode())
        visitor.writing.flush()
        return
    visitor.writing.write(b"in\n")
    visitor.writing.flush()
    while line := visitor.reading.readline():
        visitor.writing.write(line)
        visitor.writing.flush()


@pytest.fixture
def endpoint(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Endpoint]:
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path))
    monkeypatch.setattr(endpoint_module, "_LOOK_S", 0.02)
    own = Endpoint("echo", "127.0.0.1", 0, max_guests=4)
    threading.Thread(target=own.serve, args=(echo,), daemon=True).start()
    yield own
    own.close()


def connected(endpoint: Endpoint, first: str = "") -> socket.socket:
    """A client that has sent its first line, if there is one."""
    client = socket.create_connection(("127.0.0.1", endpoint.port), timeout=60)
    client.sendall(first.encode())
    return client


def answer(client: socket.socket) -> bytes:
    """What comes next; nothing where the endpoint has hung up."""
    try:
        return client.recv(100)
    except ConnectionResetError:
        return b""


def test_only_the_token_opens(endpoint: Endpoint) -> None:
    """901921 without one, 901922 with another one; the endpoint hangs up after both."""
    for first, expected in (("-\n", b"901921\n"), (f"{endpoint.token[:-1]}\n", b"901922\n")):
        with connected(endpoint, first) as client:
            assert answer(client) == expected
            assert answer(client) == b""
    with connected(endpoint, f"{endpoint.token}\nhello\n") as client:
        with client.makefile("rb") as lines:
            assert [lines.readline(), lines.readline()] == [b"in\n", b"hello\n"]


def test_a_token_is_the_value_of_an_option_everywhere() -> None:
    """It never begins with a hyphen, as one in 64 did; a double click selects all of it."""
    tokens = {new_token() for _ in range(1000)}
    assert len(tokens) == 1000
    assert all(len(token) == 48 and set(token) <= set("0123456789abcdef") for token in tokens)


def test_the_file_of_the_token_is_of_its_user_alone(endpoint: Endpoint, tmp_path: Path) -> None:
    """Mode 600 in a folder of mode 700, until the endpoint is closed."""
    file = tmp_path / "nctakt" / f"echo-{endpoint.port}.token"
    assert stat.S_IMODE(file.stat().st_mode) == 0o600
    assert stat.S_IMODE(file.parent.stat().st_mode) == 0o700
    assert file.read_text("ascii").strip() == endpoint.token == known_token("echo", endpoint.port)
    assert endpoint.lines() == [f"127.0.0.1:{endpoint.port}", f"token {endpoint.token} ({file})"]
    endpoint.close()
    assert not file.exists()
    assert known_token("echo", endpoint.port) is None


def test_a_folder_that_others_reach_holds_no_token(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """901924; the token is printed, and nothing is read from there."""
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path))
    (tmp_path / "nctakt").mkdir(mode=0o755)
    endpoint = Endpoint("echo", "127.0.0.1", 0, max_guests=1)
    assert endpoint.warning is not None
    assert endpoint.warning.id == 901924
    assert list((tmp_path / "nctakt").iterdir()) == []
    assert endpoint.lines()[1] == f"token {endpoint.token}"
    (tmp_path / "nctakt" / f"echo-{endpoint.port}.token").write_text("planted\n", "ascii")
    assert known_token("echo", endpoint.port) is None
    endpoint.close()


def test_guests_are_bounded_those_without_a_token_to_half(endpoint: Endpoint) -> None:
    """901923; a place is free again once a guest has gone."""
    with ExitStack() as guests:
        for first, expected in (
            ("-open\n", b"in\n"),
            ("-open\n", b"in\n"),
            ("-open\n", b"901923\n"),
            (f"{endpoint.token}\n", b"in\n"),
            (f"{endpoint.token}\n", b"in\n"),
            (f"{endpoint.token}\n", b"901923\n"),
        ):
            assert answer(guests.enter_context(connected(endpoint, first))) == expected
    for _ in range(200):
        with connected(endpoint, f"{endpoint.token}\n") as client:
            if answer(client) == b"in\n":
                break
        time.sleep(0.02)
    else:
        pytest.fail("no place became free")


def test_a_visitor_has_some_seconds_and_some_bytes(
    endpoint: Endpoint, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Slow headers, and messages without end; a guest has as much of both as it wants."""
    with connected(endpoint, f"{endpoint.token}\n") as guest, guest.makefile("rb") as lines:
        assert lines.readline() == b"in\n"
        monkeypatch.setattr(endpoint_module, "VISIT_S", 0.1)
        with connected(endpoint, "slow") as slow:
            assert answer(slow) == b""
        with connected(endpoint) as loud:
            with pytest.raises(OSError):
                for _ in range(1000):
                    loud.sendall(b"x" * 65536)
        long_line = b"y" * (2 * VISIT_BYTES) + b"\n"
        threading.Thread(target=guest.sendall, args=(long_line,)).start()
        assert lines.readline() == long_line


def test_silent_visitors_keep_nobody_out(
    endpoint: Endpoint, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The oldest is sent away for a new one, unless it has just come."""
    monkeypatch.setattr(endpoint_module, "MAX_VISITORS", 2)
    monkeypatch.setattr(endpoint_module, "GRACE_S", 0.0)
    with (
        connected(endpoint) as first,
        connected(endpoint),
        connected(endpoint, f"{endpoint.token}\n") as last,
    ):
        assert answer(first) == b""
        assert answer(last) == b"in\n"
        monkeypatch.setattr(endpoint_module, "GRACE_S", 60.0)
        with connected(endpoint), connected(endpoint) as late:
            assert answer(late) == b""


def test_an_address_that_is_taken_is_reported(endpoint: Endpoint) -> None:
    """901920, for a name that nobody knows, too."""
    for host, port in (("127.0.0.1", endpoint.port), ("no.such.host.invalid", 0)):
        with pytest.raises(Failure, match="901920"):
            Endpoint("echo", host, port, max_guests=1)
