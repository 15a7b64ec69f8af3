# SPDX-License-Identifier: MIT
"""Connections of browsers: a limit, and a time for requests and answers; the others continue."""

import asyncio
import contextlib
import random
from collections import Counter
from collections.abc import Awaitable, Callable
from typing import Any

import pytest
from support.random_seeds import each_seed

uvicorn = pytest.importorskip("uvicorn", reason="the live page needs NiceGUI")

from nctakt.live.access import connections  # noqa: E402 - after the library that it needs

GET = b"GET / HTTP/1.1\r\nHost: a\r\n\r\n"

#: How long the machine may take for anything, in seconds.
PATIENCE_S = 60.0


async def application(scope: Any, receive: Any, send: Any) -> None:
    """Answer each request; ``/large`` with more than a connection takes by itself."""
    body = b"x" * (20_000_000 if scope["path"] == "/large" else 2)
    length = str(len(body)).encode()
    while (await receive()).get("more_body"):
        pass
    await send(
        {"type": "http.response.start", "status": 200, "headers": [(b"content-length", length)]}
    )
    await send({"type": "http.response.body", "body": body})


class Served:
    """The application with the page's connections; ``refused``: how often, by reasons."""

    def __init__(self) -> None:
        self.refused: Counter[str] = Counter()
        self._writers: list[asyncio.StreamWriter] = []

    async def __aenter__(self) -> "Served":
        config = uvicorn.Config(
            application,
            port=0,
            lifespan="off",
            log_level="critical",
            http=connections.protocol(lambda _, reason: self.refused.update([reason.en])),
        )
        self._server = uvicorn.Server(config)
        self._server.capture_signals = contextlib.nullcontext  # those of the tests stay
        self._task = asyncio.create_task(self._server.serve())
        while not self._server.started:
            await asyncio.sleep(0.01)
        self.port = self._server.servers[0].sockets[0].getsockname()[1]
        return self

    async def __aexit__(self, *_: object) -> None:
        for writer in self._writers:
            writer.transport.abort()
            with contextlib.suppress(OSError):
                await writer.wait_closed()
        self._server.should_exit = True
        await asyncio.wait_for(self._task, PATIENCE_S)

    async def open(self, *words: bytes) -> asyncio.StreamReader:
        """A connection that has sent something."""
        reader, self.writer = await asyncio.open_connection("127.0.0.1", self.port)
        self._writers.append(self.writer)
        for word in words:
            self.writer.write(word)
        return reader

    async def answers(self) -> bool:
        """Whether a browser that comes now gets its answer."""
        reader = await self.open(GET)
        with contextlib.suppress(OSError, asyncio.IncompleteReadError):
            return b"200 OK" in await asyncio.wait_for(reader.readline(), PATIENCE_S)
        return False


def run(part: Callable[[Served], Awaitable[None]]) -> None:
    """Run a test with connections that are served."""

    async def act() -> None:
        async with Served() as served:
            await part(served)

    asyncio.run(act())


async def until_closed(reader: asyncio.StreamReader) -> None:
    """Wait for the end of a connection."""
    with contextlib.suppress(OSError):
        while await asyncio.wait_for(reader.read(65_536), PATIENCE_S):
            pass


@pytest.mark.parametrize(
    "words",
    [
        (),
        (b"GET / HTTP/1.1\r\n", b"X: 1\r\n"),  # a header that never ends
        (b"POST / HTTP/1.1\r\nHost: a\r\nContent-Length: 9\r\n\r\n", b"123"),  # a body
    ],
)
def test_a_request_that_does_not_end(words: tuple[bytes, ...], monkeypatch: Any) -> None:
    """Its connection is closed after 5 s (here less), and counted; others continue."""
    monkeypatch.setattr(connections, "REQUEST_S", 0.3)

    async def part(served: Served) -> None:
        await until_closed(await served.open(*words))
        assert served.refused == {"its request did not come to an end": 1}
        assert await served.answers()

    run(part)


def test_a_second_request_that_does_not_end(monkeypatch: Any) -> None:
    """A connection that has had an answer has no more time for the next request."""
    monkeypatch.setattr(connections, "REQUEST_S", 0.3)

    async def part(served: Served) -> None:
        reader = await served.open(GET)
        await asyncio.wait_for(reader.readuntil(b"\r\n\r\nxx"), PATIENCE_S)
        served.writer.write(b"GET / HT")
        await until_closed(reader)
        assert served.refused == {"its request did not come to an end": 1}

    run(part)


def test_an_answer_that_nobody_takes(monkeypatch: Any) -> None:
    """Its connection is closed after 60 s (here less)."""
    monkeypatch.setattr(connections, "ANSWER_S", 0.3)

    async def part(served: Served) -> None:
        await served.open(b"GET /large HTTP/1.1\r\nHost: a\r\n\r\n")
        while not served.refused:
            await asyncio.sleep(0.05)
        assert served.refused == {"it did not take its answer": 1}

    run(part)


def test_more_connections_than_there_may_be(monkeypatch: Any) -> None:
    """A further one is closed at once; once others have gone there is room."""
    monkeypatch.setattr(connections, "MAX_CONNECTIONS", 5)
    monkeypatch.setattr(connections, "REQUEST_S", 1.0)

    async def part(served: Served) -> None:
        idle = [await served.open() for _ in range(5)]
        while not await served.answers():
            await asyncio.sleep(0.05)
        assert served.refused["too many connections"] >= 1
        # There is room once the first of them has gone, on a busy machine before the others have.
        for reader in idle:
            await until_closed(reader)
        assert served.refused["its request did not come to an end"] == len(idle)

    run(part)


@each_seed(20, 20)
def test_frames_are_counted_however_they_come(seed: int) -> None:
    """Frames of all lengths, masked or not, in parts of any size; then one more than may be."""
    chance, later_s = random.Random(seed), 1e9
    count = connections.FrameCount()
    sizes = [chance.choice((0, 1, 125, 126, 300, 65_535, 65_536)) for _ in range(60)]
    whole = b"".join(frame(size, is_masked=chance.random() < 0.8) for size in sizes)
    while whole:
        size = chance.choice((1, 2, 7, 5000, 200_000))
        assert count.take(whole[:size], later_s)
        whole = whole[size:]
    allowed = int(connections.FRAME_BURST) - len(sizes)
    assert count.take(frame(0) * allowed, later_s)
    assert not count.take(frame(0), later_s)
    rest_s = later_s + 10 / connections.FRAME_RATE
    assert count.take(frame(0) * 8, rest_s)
    assert not count.take(frame(0) * 8, rest_s)


def frame(size: int, *, is_masked: bool = True) -> bytes:
    """A frame of a WebSocket."""
    if size < 126:
        head = bytes((0x80, 0x80 * is_masked + size))
    elif size < 65_536:
        head = bytes((0x80, 0x80 * is_masked + 126)) + size.to_bytes(2, "big")
    else:
        head = bytes((0x80, 0x80 * is_masked + 127)) + size.to_bytes(8, "big")
    return head + bytes(4 * is_masked + size)
