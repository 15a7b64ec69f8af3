# SPDX-License-Identifier: MIT
"""The command ``nctakt lsp``: over TCP, and without its library."""

from __future__ import annotations

import asyncio
import gc
import socket
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest
from lsprotocol import types
from pygls.exceptions import JsonRpcException
from pygls.lsp.client import LanguageClient
from support.editor_client import COMMAND, ENVIRONMENT

from nctakt.cli import EXIT_USAGE, main

pytestmark = pytest.mark.slow


@pytest.fixture
def at_port(tmp_path: Path) -> Iterator[tuple[subprocess.Popen[str], int, str]]:
    """A server at a free port: its process, the port, its token."""
    words = [*COMMAND, "--tcp", "0"]
    with subprocess.Popen(
        words, cwd=tmp_path, env=ENVIRONMENT, stdout=subprocess.PIPE, text=True
    ) as server:
        try:
            assert server.stdout is not None
            port = int(server.stdout.readline().rpartition(":")[2])
            yield server, port, server.stdout.readline().split()[1]
        finally:
            server.kill()


async def initialized(port: int, options: dict[str, str]) -> types.InitializeResult:
    """What a client is answered that begins and ends as editors do."""
    client = LanguageClient("test", "1")
    await client.start_tcp("127.0.0.1", port)
    params = types.InitializeParams(types.ClientCapabilities(), initialization_options=options)
    try:
        result = await client.initialize_async(params)
        await client.shutdown_async(None)
        client.exit(None)
    finally:
        await client.stop()
    return result


def test_an_editor_can_come_over_tcp_with_the_token(
    at_port: tuple[subprocess.Popen[str], int, str],
) -> None:
    """The server waits at its port, refuses others, answers, and ends with its editor."""
    server, port, token = at_port
    for options, number in (({}, "901921"), ({"token": token[1:]}, "901922")):
        with pytest.raises(JsonRpcException, match=number):
            asyncio.run(asyncio.wait_for(initialized(port, options), 60))
    result = asyncio.run(asyncio.wait_for(initialized(port, {"token": token}), 60))
    assert result.server_info is not None
    assert result.server_info.name == "nctakt"
    assert server.wait(60) == 0


BODY = (
    '{"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": {"capabilities": {},'
    ' "initializationOptions": {"token": "TOKEN"}}}'
)


@pytest.mark.parametrize(
    "begin",
    [
        "POST / HTTP/1.1\r\nHost: localhost\r\nContent-Type: text/plain\r\n",
        'Content-Length: 46\r\n\r\n{"jsonrpc": "2.0", "method": "initialized"}   ',
    ],
    ids=["the form of a web page", "another message first"],
)
def test_what_does_not_begin_with_the_token_is_not_read(
    at_port: tuple[subprocess.Popen[str], int, str], begin: str
) -> None:
    """A page in a browser sends its header first: the message in its body, too, is not obeyed."""
    _, port, token = at_port
    body = BODY.replace("TOKEN", token)
    with socket.create_connection(("127.0.0.1", port), timeout=60) as page:
        page.sendall(f"{begin}Content-Length: {len(body)}\r\n\r\n{body}".encode())
        with page.makefile("rb") as answers:
            try:
                said = answers.read()
            except ConnectionResetError:
                said = b""
    assert b"capabilities" not in said
    result = asyncio.run(asyncio.wait_for(initialized(port, {"token": token}), 60))
    assert result.server_info is not None


def test_a_port_that_is_taken_is_reported(capsys: pytest.CaptureFixture[str]) -> None:
    """901920."""
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        assert main(["lsp", "--tcp", str(port)]) == EXIT_USAGE
    assert "error 901920: " in capsys.readouterr().err


def test_the_missing_library_is_reported(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Without pygls the command says what to install."""
    monkeypatch.setitem(__import__("sys").modules, "pygls", None)
    assert main(["lsp"]) == EXIT_USAGE
    assert "pip install" in capsys.readouterr().err
    assert gc.isenabled()
