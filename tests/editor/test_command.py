# SPDX-License-Identifier: MIT
"""The command ``nctakt lsp``: over TCP, and without its library."""

from __future__ import annotations

import asyncio
import gc
import socket
import subprocess
from pathlib import Path

import pytest
from editor.client import COMMAND, ENVIRONMENT
from lsprotocol import types
from pygls.lsp.client import LanguageClient

from nctakt.cli import EXIT_USAGE, main

pytestmark = pytest.mark.slow


def test_an_editor_can_come_over_tcp(tmp_path: Path) -> None:
    """The server waits at its port, answers, and ends with its editor."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    server = subprocess.Popen([*COMMAND, "--tcp", str(port)], cwd=tmp_path, env=ENVIRONMENT)

    async def script() -> None:
        client = LanguageClient("test", "1")
        for _ in range(600):
            try:
                await client.start_tcp("127.0.0.1", port)
                break
            except OSError:
                await asyncio.sleep(0.05)
        params = types.InitializeParams(types.ClientCapabilities())
        result = await client.initialize_async(params)
        assert result.server_info is not None
        assert result.server_info.name == "nctakt"
        await client.shutdown_async(None)
        client.exit(None)
        await client.stop()

    try:
        asyncio.run(asyncio.wait_for(script(), 60))
        server.wait(30)
    finally:
        server.kill()
        server.wait()


def test_the_missing_library_is_told(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Without pygls the command says what to install."""
    monkeypatch.setitem(__import__("sys").modules, "pygls", None)
    assert main(["lsp"]) == EXIT_USAGE
    assert "pip install" in capsys.readouterr().err
    assert gc.isenabled()
