# SPDX-License-Identifier: MIT
"""What an editor sends: lines and bodies, within bounds, and an end for whoever waits."""

from __future__ import annotations

import os
import threading
import time

import pytest

from nctakt.editor import incoming as incoming_module
from nctakt.editor.incoming import MAX_LINE, Incoming


def of_pipe(first: bytes = b"") -> tuple[Incoming, int]:
    """An editor at a pipe, and the end that it writes to."""
    reading, writing = os.pipe()
    return Incoming(lambda size: os.read(reading, size), first), writing


def test_lines_and_bodies_come_as_they_were_sent() -> None:
    """In whatever pieces; what came before is first, and nothing comes after the end."""
    editor, writing = of_pipe(b"Content-Length: 4\r\n\r")
    os.write(writing, b"\nab")
    assert [editor.readline(), editor.readline()] == [b"Content-Length: 4\r\n", b"\r\n"]
    threading.Timer(0.05, os.write, (writing, b"cdnext")).start()
    assert editor.read(4) == b"abcd"
    assert editor.read(2) == b"ne"
    os.close(writing)
    assert editor.readline() == b"xt"
    assert [editor.readline(), editor.read(5)] == [b"", b""]


def test_a_long_line_comes_in_pieces_and_a_long_message_is_passed_over(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Its replacement is not a message; the next one is found."""
    monkeypatch.setattr(incoming_module, "MAX_MESSAGE", 1000)
    sent = b"x" * 3000 + b"\n" + b"y" * 200_000 + b"next\n"
    editor, writing = of_pipe()
    threading.Thread(target=os.write, args=(writing, sent)).start()
    assert [len(editor.readline()) for _ in range(3)] == [MAX_LINE, MAX_LINE, 953]
    assert editor.read(200_000) == b"null"
    assert editor.readline() == b"next\n"
    os.close(writing)


def test_a_large_body_is_read_whole() -> None:
    """More than may wait."""
    body = os.urandom(5_000_000)
    editor, writing = of_pipe()

    def send() -> None:
        with os.fdopen(writing, "wb") as file:
            file.write(body)

    threading.Thread(target=send).start()
    assert editor.read(len(body)) == body
    assert editor.readline() == b""


def test_whoever_waits_can_be_ended() -> None:
    """Though the editor says nothing, and does not go."""
    editor, writing = of_pipe()
    threading.Timer(0.05, editor.end).start()
    begin_s = time.monotonic()
    assert editor.read(10) == b""
    assert time.monotonic() - begin_s < 10
    os.close(writing)
