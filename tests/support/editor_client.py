# SPDX-License-Identifier: MIT
"""A client of the language server, as an editor is one: another process, over its streams."""

from __future__ import annotations

import asyncio
import os
import sys
from collections.abc import Callable, Coroutine
from pathlib import Path
from typing import Any

import pytest

from support.insides import kill_server

pytest.importorskip("pygls", reason="the language server needs pygls (extra editor)")
pytest_lsp = pytest.importorskip("pytest_lsp", reason="its tests need pytest-lsp (extra test)")

from lsprotocol import types  # noqa: E402 - only with the libraries

import nctakt  # noqa: E402

ENVIRONMENT = {**os.environ, "PYTHONPATH": str(Path(nctakt.__file__).parents[1])}
COMMAND = [sys.executable, "-m", "nctakt", "lsp"]


class Editor:
    """A client with one server; ``folder``: its workspace."""

    def __init__(self, client: Any, folder: Path) -> None:
        self.client = client
        self.folder = folder
        self.version = 0

    async def open(self, name: str, text: str, *, is_saved: bool = True) -> str:
        """Open a document and wait for its findings; its URI."""
        path = self.folder / name
        if is_saved:
            path.write_text(text, "utf-8")
        uri = path.as_uri()
        ends = {".lis": "nctakt-list", ".st": "nctakt-st", ".TcPOU": "nctakt-st"}
        language = ends.get(path.suffix, "nctakt")
        self.client.text_document_did_open(
            types.DidOpenTextDocumentParams(types.TextDocumentItem(uri, language, 0, text))
        )
        await self.settled(uri, 0)
        return uri

    def type(
        self, uri: str, line: int, start: int, end: int, text: str, last: int | None = None
    ) -> None:
        """Replace characters of a line, or up to another line."""
        self.version += 1
        place = types.Range(
            types.Position(line, start), types.Position(line if last is None else last, end)
        )
        self.client.text_document_did_change(
            types.DidChangeTextDocumentParams(
                types.VersionedTextDocumentIdentifier(self.version, uri),
                [types.TextDocumentContentChangePartial(place, text)],
            )
        )

    async def settled(self, uri: str, version: int | None = None) -> list[types.Diagnostic]:
        """Return the findings of a version; the last one by default."""
        wanted = self.version if version is None else version
        while self.client.published.get(uri, -1) < wanted:
            self.client.arrived.clear()
            await asyncio.wait_for(self.client.arrived.wait(), 60)
        return list(self.client.diagnostics.get(uri, ()))

    @staticmethod
    def at(uri: str, line: int, character: int) -> dict[str, Any]:
        """Return the document and position of a request."""
        return {
            "text_document": types.TextDocumentIdentifier(uri),
            "position": types.Position(line, character),
        }


Script = Callable[[Editor], Coroutine[Any, Any, None]]


async def with_editor(
    script: Script, folder: Path, options: Any, encodings: list[types.PositionEncodingKind]
) -> None:
    client = pytest_lsp.LanguageClient()
    client.published = {}
    client.arrived = asyncio.Event()

    @client.feature(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
    def published(params: types.PublishDiagnosticsParams) -> None:
        client.diagnostics[params.uri] = params.diagnostics
        if params.version is not None:
            client.published[params.uri] = params.version
        client.arrived.set()

    await client.start_io(*COMMAND, cwd=folder, env=ENVIRONMENT)
    try:
        general = types.GeneralClientCapabilities(position_encodings=encodings)
        await client.initialize_session(
            types.InitializeParams(
                types.ClientCapabilities(general=general),
                process_id=os.getpid(),
                root_uri=folder.as_uri(),
                workspace_folders=[types.WorkspaceFolder(folder.as_uri(), "programs")],
                initialization_options=options,
            )
        )
        await asyncio.wait_for(script(Editor(client, folder)), 600)
        await client.shutdown_session()
    except BaseException:
        kill_server(client)
        raise
    finally:
        await client.stop()
