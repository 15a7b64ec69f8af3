# SPDX-License-Identifier: MIT
"""Structured Text in the language server, as an editor speaks with it, and in Neovim."""

from __future__ import annotations

import asyncio
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

pytest.importorskip("pygls", reason="the language server needs pygls (extra editor)")

from support.editor_client import ENVIRONMENT, Editor, types
from support.plc_text import pou_file

NEOVIM = shutil.which("nvim")

LIST = "VAR_GLOBAL\n    nLimit : INT; // parts\nEND_VAR\n"
MAIN = "PROGRAM MAIN\nVAR\n    n : INT;\nEND_VAR\nn := nLimit;\nEND_PROGRAM\n"
PROJECT = (
    '<Project xmlns="http://schemas.microsoft.com/developer/msbuild/2003"><ItemGroup>'
    '<Compile Include="MAIN.TcPOU" /><Compile Include="GVL.TcGVL" /></ItemGroup></Project>'
)


def test_a_folder_of_texts_is_checked_explained_and_renamed(
    in_editor: Callable[..., None], tmp_path: Path
) -> None:
    """A change of one file is felt in the other open one, without a request."""

    async def script(editor: Editor) -> None:
        lists = await editor.open("lists.st", LIST)
        main = await editor.open("main.st", MAIN)
        assert await editor.settled(main, 0) == []
        client = editor.client
        hover = await client.text_document_hover_async(types.HoverParams(**editor.at(main, 4, 7)))
        assert "VAR_GLOBAL nLimit : INT;" in hover.contents.value
        assert "parts" in hover.contents.value
        edit = await client.text_document_rename_async(
            types.RenameParams(new_name="nMost", **editor.at(main, 4, 7))
        )
        assert set(edit.changes) == {lists, main}
        editor.type(lists, 1, 4, 10, "nLeast")
        await editor.settled(lists)
        while not client.diagnostics.get(main):
            client.arrived.clear()
            await asyncio.wait_for(client.arrived.wait(), 60)
        (found,) = client.diagnostics[main]
        assert (found.range.start.line, found.range.start.character) == (4, 5)
        editor.type(main, 4, 0, 11, "n := nLeast + nLe")
        assert "nLe is not declared" in (await editor.settled(main))[0].message
        items = await client.text_document_completion_async(
            types.CompletionParams(**editor.at(main, 4, 17))
        )
        assert [one.label for one in items.items if one.label == "nLeast"] == ["nLeast"]
        symbols = await client.text_document_document_symbol_async(
            types.DocumentSymbolParams(types.TextDocumentIdentifier(main))
        )
        assert [one.name for one in symbols] == ["MAIN"]
        tokens = await client.text_document_semantic_tokens_full_async(
            types.SemanticTokensParams(types.TextDocumentIdentifier(main))
        )
        assert tokens.data

    in_editor(script)


def test_objects_of_a_project_in_xml(in_editor: Callable[..., None], tmp_path: Path) -> None:
    """The project's own list is read from its file; what it lacks is said at its place."""
    (tmp_path / "Cell.plcproj").write_text(PROJECT, "utf-8")
    (tmp_path / "GVL.TcGVL").write_text(
        '<TcPlcObject><GVL Name="GVL"><Declaration><![CDATA['
        "VAR_GLOBAL\n    nLimit : INT;\nEND_VAR]]></Declaration></GVL></TcPlcObject>",
        "utf-8",
    )
    text = pou_file(
        "MAIN", "PROGRAM MAIN\nVAR\n    n : INT;\nEND_VAR\n", "n := GVL.nLimit;\nm := 1;"
    )

    async def script(editor: Editor) -> None:
        uri = await editor.open("MAIN.TcPOU", text)
        (found,) = editor.client.diagnostics[uri]
        line = text[: text.index("m := 1")].count("\n")
        assert (found.range.start.line, found.range.start.character) == (line, 0)
        assert "m is not declared" in found.message
        place = text[: text.index("nLimit")].count("\n")
        column = len(text[: text.index("nLimit")].rpartition("\n")[2])
        (target,) = await editor.client.text_document_definition_async(
            types.DefinitionParams(**editor.at(uri, place, column))
        )
        assert target.uri == (tmp_path / "GVL.TcGVL").as_uri()
        assert target.range.start == types.Position(1, 4)
        editor.type(uri, line, 0, 1, "n")
        assert await editor.settled(uri) == []

    in_editor(script)


def test_a_text_without_a_file_is_checked(in_editor: Callable[..., None]) -> None:
    async def script(editor: Editor) -> None:
        uri = await editor.open("new.st", "PROGRAM MAIN\nx := 1;\nEND_PROGRAM\n", is_saved=False)
        (found,) = editor.client.diagnostics[uri]
        assert "x is not declared" in found.message

    in_editor(script)


def test_a_new_text_without_a_name_is_checked(in_editor: Callable[..., None]) -> None:
    """VS Code calls it ``untitled:Untitled-1``: only its language says what it is."""

    async def script(editor: Editor) -> None:
        uri = "untitled:Untitled-1"
        text = "PROGRAM MAIN\nVAR\n    n : INT;\nEND_VAR\nx := n;\nEND_PROGRAM\n"
        editor.client.text_document_did_open(
            types.DidOpenTextDocumentParams(types.TextDocumentItem(uri, "nctakt-st", 0, text))
        )
        (found,) = await editor.settled(uri, 0)
        assert "x is not declared" in found.message
        (target,) = await editor.client.text_document_definition_async(
            types.DefinitionParams(**editor.at(uri, 4, 5))
        )
        assert (target.uri, target.range.start) == (uri, types.Position(2, 4))

    in_editor(script)


@pytest.mark.slow
@pytest.mark.skipif(NEOVIM is None, reason="Neovim is not installed")
def test_neovim_shows_findings_and_formats(tmp_path: Path) -> None:
    program = tmp_path / "cell.st"
    program.write_text(MAIN.replace("nLimit", "m").replace("    n", "n"), "utf-8")
    script = Path(__file__).with_name("neovim.lua")
    done = subprocess.run(
        [str(NEOVIM), "--clean", "--headless", "-n", str(program), "-c", f"luafile {script}"],
        cwd=tmp_path,
        env={
            **ENVIRONMENT,
            "NCTAKT_LSP": f"{sys.executable} -m nctakt lsp",
            "XDG_STATE_HOME": str(tmp_path),
        },
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
        stdin=subprocess.DEVNULL,
    )
    assert "finding 4 5 m is not declared" in done.stdout, done.stderr
    assert "hover VAR n : INT;" in done.stdout, done.stderr
    assert program.read_text("utf-8") == MAIN.replace("nLimit", "n"), done.stderr
