# SPDX-License-Identifier: MIT
"""A client of ADS as fast as Python is, for measuring servers: bytes are prepared before."""

from __future__ import annotations

import json
import selectors
import signal
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from struct import pack, unpack_from
from typing import Self

from nctakt.servers.ads.codes import Command, Group
from nctakt.servers.ads.frames import REQUEST, Frame, FrameReader, read_net_id

PROGRAM = """\
#RT CYCLE [ID=1 SCOPE=GLOBAL]
  $IF EDGE V.E.TRIGGER > 0
    V.E.COUNT_POS = V.E.COUNT_POS + 1
  $ENDIF
#RT CYCLE END
$WHILE 1
G01 X100 F6000
G01 X0
$ENDWHILE
M30
"""


class Served:
    """``nctakt serve`` with a program that never ends, in its own process."""

    def __init__(self, *words: str) -> None:
        self._folder = tempfile.TemporaryDirectory()
        folder = Path(self._folder.name)
        (folder / "part.nc").write_text(PROGRAM, "utf-8")
        ready = folder / "ready.json"
        self._log = folder / "log.jsonl"
        command = [sys.executable, "-m", "nctakt", "serve", str(folder / "part.nc"), "--quiet"]
        self.process = subprocess.Popen(
            [*command, "--ads=127.0.0.1:0", f"--ready-file={ready}", f"--log={self._log}", *words],
            stdout=subprocess.DEVNULL,
        )
        while not ready.exists():
            time.sleep(0.01)
            if self.process.poll() is not None:
                raise RuntimeError("nctakt serve has ended")
        address, net_id = json.loads(ready.read_text("utf-8"))["addresses"]["ads"].split("/")
        host, _, port = address.rpartition(":")
        self.address = host, int(port)
        self.net_id = read_net_id(net_id) or b""

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        if self.process.poll() is None:
            self.end()
        self._folder.cleanup()

    def end(self) -> dict[str, object]:
        """End it; the last line of its log."""
        self.process.send_signal(signal.SIGTERM)
        self.process.wait()
        closed: dict[str, object] = json.loads(self._log.read_text("utf-8").splitlines()[-1])
        return closed


class AdsClient:
    """One connection."""

    def __init__(self, served: Served, number: int = 1) -> None:
        self._served = served
        self._own = bytes((10, 0, number // 250, number % 250, 1, 1))
        self.socket = socket.create_connection(served.address)
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._reader = FrameReader()
        self._frames: list[Frame] = []

    def frame(self, command: int, data: bytes, invoke: int = 1) -> bytes:
        """Return a request."""
        target, own = (self._served.net_id, 851), (self._own, 33000)
        return Frame(*target, *own, command, REQUEST, 0, invoke, data).encode()

    def next(self) -> Frame:
        """Return the next frame from the server."""
        while not self._frames:
            self._frames += self._reader.feed(self.socket.recv(1 << 18))
        return self._frames.pop(0)

    @property
    def has_frame(self) -> bool:
        """Whether a whole frame has come already."""
        return bool(self._frames)

    def ask(self, request: bytes) -> bytes:
        """Return the data of the answer to a request."""
        self.socket.sendall(request)
        while True:
            answer = self.next()
            if answer.command != Command.NOTIFICATION:
                if answer.error or unpack_from("<I", answer.data)[0]:
                    raise RuntimeError(answer)
                return answer.data

    def ask_raw(self, request: bytes) -> bytes:
        """Return the bytes of the answer to a request."""
        self.socket.sendall(request)
        return self.next().encode()

    def read_write(self, group: int, offset: int, size: int, data: bytes) -> bytes:
        """Return a read-write."""
        head = pack("<IIII", group, offset, size, len(data))
        return self.frame(Command.READ_WRITE, head + data)

    def symbol(self, name: str) -> tuple[int, int, int]:
        """Return group, offset and size of a symbol."""
        data = self.ask(self.read_write(Group.INFO_BY_NAME, 0, 12, name.encode() + b"\0"))
        group, offset, size = unpack_from("<III", data, 8)
        return group, offset, size

    def read(self, name: str) -> bytes:
        """Return the request that reads a symbol."""
        return self.frame(Command.READ, pack("<III", *self.symbol(name)))

    def notify(self, name: str, mode: int, cycle_units: int) -> None:
        """Let a symbol be sent."""
        data = pack("<IIIIII16x", *self.symbol(name), mode, 0, cycle_units)
        self.ask(self.frame(Command.ADD_NOTIFICATION, data))


def count_answers(clients: list[AdsClient], request: bytes, in_flight: int, span_s: float) -> int:
    """Return how many answers of equal length all clients get in a time."""
    size = len(clients[0].ask_raw(request))
    selector = selectors.DefaultSelector()
    waiting = {}
    for client in clients:
        selector.register(client.socket, selectors.EVENT_READ, client)
        client.socket.sendall(request * in_flight)
        waiting[client] = 0
    answers = 0
    end = time.perf_counter() + span_s
    while time.perf_counter() < end:
        for key, _ in selector.select():
            client = key.data
            got = waiting[client] + len(client.socket.recv(1 << 20))
            done, waiting[client] = divmod(got, size)
            answers += done
            if done:
                client.socket.sendall(request * done)
    return answers
