# SPDX-License-Identifier: MIT
"""Whatever an editor sends, each request gets one answer, and the next one is understood.

JSON-RPC 2.0, 4.2 and 5.1: notifications get no answer; what cannot be read is answered with the ID
null. None of the answers has a traceback, and none is an error of nctakt's own.
"""

from __future__ import annotations

import asyncio
import contextlib
import io
import json
import random
import threading
from pathlib import Path
from typing import Any

import pytest
from support.random_seeds import each_seed

pytest.importorskip("pygls", reason="the language server needs pygls (extra editor)")

from lsprotocol.types import ErrorCodes
from pygls.io_ import run_async

from nctakt.editor.display import presentation
from nctakt.editor.server import Server

INTERNAL = ErrorCodes.InternalError.value
TEXT = "%M\nP1 = V.E.COUNT\n[L] G01 X1 F100\n$GOTO [L]\nM30\n"

REQUESTS = (
    *("hover", "completion", "definition", "references", "documentHighlight", "prepareRename"),
    *("rename", "documentSymbol", "foldingRange", "selectionRange", "formatting"),
    *("rangeFormatting", "codeAction", "semanticTokens/full", "semanticTokens/range", "inlayHint"),
    *("codeLens", "documentLink", "signatureHelp", "noSuchRequest"),
)
#: Bodies that are no message; the codes of their answers.
BODIES: tuple[tuple[bytes, list[int]], ...] = (
    (b"{", [-32700]),
    (b'{"jsonrpc": "\xff"}', [-32700]),
    (b"[" * 100_000 + b"]" * 100_000, [-32700]),
    (b'{"jsonrpc": "2.0", "id": 1, "method": "shutdown", "params": 1%s}' % (b"0" * 5000), [-32700]),
    (b"[]", [-32600]),
    (b"null", [-32600]),
    (b"5", [-32600]),
    (b'"x"', [-32600]),
    (b"{}", [-32600]),
    (b'[{"jsonrpc": "2.0", "id": 9, "method": "shutdown"}]', [-32600]),
    (b'{"jsonrpc": "2.0", "id": 7, "method": 5}', [-32600]),
    (b'{"jsonrpc": "2.0", "id": 7, "method": "textDocument/hover", "params": {}}', [-32602]),
    (b'{"jsonrpc": "2.0", "id": {}, "method": "textDocument/hover", "params": {}}', [-32602]),
    (b'{"jsonrpc": "2.0", "id": 7, "method": "no/such", "params": {}}', [-32601]),
    (b'{"jsonrpc": "2.0", "method": "textDocument/didOpen", "params": {}}', []),
    (b'{"jsonrpc": "2.0", "method": "$/cancelRequest", "params": {}}', []),
    (b'{"jsonrpc": "2.0", "method": "no/such", "params": {}}', []),
    (b'{"jsonrpc": "2.0", "id": 99, "result": {}}', []),
)


class Reader:
    """Bytes as they come from an editor; at their end it waits until all is answered."""

    def __init__(self, data: bytes, settled: asyncio.Event) -> None:
        self._data, self._settled = io.BytesIO(data), settled

    async def readline(self) -> bytes:
        line = self._data.readline()
        if not line:
            with contextlib.suppress(TimeoutError):
                await asyncio.wait_for(self._settled.wait(), 20)
        return line

    async def readexactly(self, size: int) -> bytes:
        return self._data.read(size)


class Writer:
    """The answers; ``settled`` is set when there are this many."""

    def __init__(self, count: int, settled: asyncio.Event) -> None:
        self.answers: list[dict[str, Any]] = []
        self._count, self._settled = count, settled

    def write(self, data: bytes) -> None:
        message = json.loads(data.partition(b"\r\n\r\n")[2])
        if "method" not in message:
            self.answers.append(message)
            if len(self.answers) == self._count:
                self._settled.set()

    def close(self) -> None:
        """Close nothing."""


def framed(body: bytes) -> bytes:
    return b"Content-Length: %d\r\n\r\n" % len(body) + body


def message(**parts: object) -> bytes:
    return framed(json.dumps({"jsonrpc": "2.0", **parts}).encode())


async def answers(sent: bytes, uri: str, count: int) -> list[dict[str, Any]]:
    """The ``count`` answers to what is sent between the start of a server and a last request."""
    settled = asyncio.Event()
    server = Server("en")
    presentation.register(server)
    writer = Writer(count + 2, settled)
    server.protocol.set_writer(writer)
    begin = {"processId": None, "rootUri": None, "capabilities": {}}
    document = {"uri": uri, "languageId": "nctakt", "version": 0, "text": TEXT}
    where = {"textDocument": {"uri": uri}, "position": {"line": 2, "character": 5}}
    whole = (
        message(id="first", method="initialize", params=begin)
        + message(method="textDocument/didOpen", params={"textDocument": document})
        + sent
        + message(id="last", method="textDocument/hover", params=where)
    )
    reader = Reader(whole, settled)
    await run_async(
        threading.Event(), reader, server.protocol, error_handler=server.report_server_error
    )
    server.diagnosis.stop()
    assert "traceback" not in json.dumps(writer.answers)
    by_id = {str(one["id"]): one for one in writer.answers}
    assert "error" not in by_id["first"]
    assert "error" not in by_id["last"]
    return [one for one in writer.answers if one["id"] not in ("first", "last")]


@pytest.mark.parametrize(("body", "codes"), BODIES, ids=map(str, range(len(BODIES))))
def test_a_body_that_is_no_message_is_answered(
    body: bytes, codes: list[int], tmp_path: Path
) -> None:
    found = asyncio.run(answers(framed(body), (tmp_path / "a.nc").as_uri(), len(codes)))
    assert [one["error"]["code"] for one in found] == codes


def test_lines_that_are_no_header_are_passed_over(tmp_path: Path) -> None:
    sent = b"GET / HTTP/1.1\r\nContent-Length: -5\r\n\r\nContent-Length: x\r\n\r\n"
    assert asyncio.run(answers(sent, (tmp_path / "a.nc").as_uri(), 0)) == []


def anything(chance: random.Random, uri: str, depth: int = 0) -> Any:
    """A JSON value, often one that a message could have."""
    numbers = (0, 1, 2, 4, 5, 30, -1, 2**31 - 1, 2**31, 10**19, 1.5)
    texts = (uri, "", "A", "L", "file:///", "file:///dev/zero", "x:y", "\ud800", "a\u0000b", "$1")
    kind = chance.randrange(9 if depth < 3 else 6)
    if kind < 2:
        return chance.choice(numbers)
    if kind < 5:
        return chance.choice(texts)
    if kind == 5:
        return chance.choice((None, True, False))
    if kind == 6:
        return [anything(chance, uri, depth + 1) for _ in range(chance.randrange(3))]
    names = ("uri", "line", "character", "start", "end", "text", "version", "range", "position")
    return {name: anything(chance, uri, depth + 1) for name in chance.sample(names, 3)}


def parameters(chance: random.Random, uri: str) -> dict[str, Any]:
    """Parameters of any request, some of them replaced by anything."""

    def position() -> Any:
        return {"line": chance.randrange(8), "character": chance.randrange(30)}

    area = {"start": position(), "end": position()}
    whole: dict[str, Any] = {
        "textDocument": {"uri": uri},
        "position": position(),
        "positions": [position()],
        "range": area,
        "newName": chance.choice(("A", "", "7", "ü", "\ud800")),
        "context": {"includeDeclaration": True, "diagnostics": [], "triggerKind": 1},
        "options": {"tabSize": 2, "insertSpaces": True},
    }
    for name in chance.sample(list(whole), chance.randrange(3)):
        whole[name] = anything(chance, uri)
    return whole


@each_seed(12, 6)
def test_each_request_gets_one_answer(seed: int, tmp_path: Path) -> None:
    """Requests and changes with anything as parameters."""
    chance = random.Random(seed)
    uri = (tmp_path / "part.nc").as_uri()
    sent, awaited = b"", []
    for number in range(40):
        if chance.random() < 0.3:
            version = {"uri": uri, "version": chance.choice((number, anything(chance, uri)))}
            change = {"range": parameters(chance, uri)["range"], "text": anything(chance, uri)}
            changes = chance.choice(([change], [{"text": TEXT}], anything(chance, uri)))
            params = {"textDocument": version, "contentChanges": changes}
            sent += message(method="textDocument/didChange", params=params)
            continue
        awaited.append(number)
        method = f"textDocument/{chance.choice(REQUESTS)}"
        sent += message(id=number, method=method, params=parameters(chance, uri))
    found = asyncio.run(answers(sent, uri, len(awaited)))
    assert sorted(one["id"] for one in found) == awaited
    codes = [one["error"]["code"] for one in found if "error" in one]
    assert INTERNAL not in codes
