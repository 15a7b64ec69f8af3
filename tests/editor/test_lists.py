# SPDX-License-Identifier: MIT
"""Requests in lists, and for the names that lists give: axes, V.E and V.CH variables."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from lsprotocol import types
from support.editor_client import Editor

from nctakt.cli import main

pytestmark = pytest.mark.slow

Run = Callable[..., None]

PROGRAM = """\
G01 X10 Y=5 F100
V.CH.NEW = 1
V.E.COUNT = V.E.COUNT + 1
$IF V.RTA.ACS.ACT_POS.X > 1
$ENDIF
M30
"""


def shown(found: Any) -> list[tuple[str, int, int]]:
    return sorted(
        (Path(item.uri).name, item.range.start.line, item.range.start.character)
        for item in found or ()
    )


def changed(edit: types.WorkspaceEdit) -> dict[str, list[tuple[int, int, str]]]:
    assert edit.changes is not None
    return {
        Path(uri).name: [
            (item.range.start.line, item.range.start.character, item.new_text) for item in edits
        ]
        for uri, edits in edit.changes.items()
    }


def place_of(lines: list[str], part: str, name: str) -> tuple[int, int]:
    line = next(number for number, text in enumerate(lines) if part in text)
    return line, lines[line].index(name)


def test_names_of_the_machine_lead_to_its_lists_and_all_its_programs(
    in_editor: Run, tmp_path: Path
) -> None:
    """Axes and variables: definition, uses, a new name, from a program and from the list."""

    async def script(editor: Editor) -> None:
        assert main(["new", str(tmp_path / "cell")]) == 0
        editor.folder = tmp_path / "cell"
        (editor.folder / "two.nc").write_text("X5 (Ä)\nV.E.COUNT = 2\nM30\n", "latin-1")
        uri = await editor.open("part.nc", PROGRAM)
        client = editor.client
        channel = (editor.folder / "sda_mds1.lis").read_text("utf-8")
        axis = place_of(channel.split("\n"), "achse[0].bezeichnung", " X")
        variables = (editor.folder / "ext_var1.lis").read_text("utf-8").split("\n")
        count = next(
            (number, text.rindex(" COUNT"))
            for number, text in enumerate(variables)
            if text.rstrip().endswith(" COUNT")
        )
        everywhere = [
            ("part.nc", 0, 4),
            ("part.nc", 3, 22),
            ("sda_mds1.lis", axis[0], axis[1] + 1),
            ("two.nc", 0, 0),
        ]

        async def used(at: dict[str, Any]) -> list[tuple[str, int, int]]:
            return shown(
                await client.text_document_references_async(
                    types.ReferenceParams(**at, context=types.ReferenceContext(True))
                )
            )

        assert await used(editor.at(uri, 0, 4)) == everywhere
        found = await client.text_document_definition_async(
            types.DefinitionParams(**editor.at(uri, 3, 22))
        )
        assert shown(found) == [everywhere[2]]
        edit = await client.text_document_rename_async(
            types.RenameParams(**editor.at(uri, 3, 22), new_name="X1")
        )
        assert changed(edit) == {
            "sda_mds1.lis": [(axis[0], axis[1] + 1, "X1")],
            "part.nc": [(0, 4, "X1="), (3, 22, "X1")],
            "two.nc": [(0, 0, "X1=")],
        }
        edit = await client.text_document_rename_async(
            types.RenameParams(**editor.at(uri, 2, 5), new_name="PARTS")
        )
        assert changed(edit) == {
            "ext_var1.lis": [(count[0], count[1] + 1, "PARTS")],
            "part.nc": [(2, 4, "PARTS"), (2, 16, "PARTS")],
            "two.nc": [(1, 4, "PARTS")],
        }
        list_uri = await editor.open("sda_mds1.lis", channel)
        assert await used(editor.at(list_uri, axis[0], axis[1] + 1)) == everywhere
        actions = await client.text_document_code_action_async(
            types.CodeActionParams(
                types.TextDocumentIdentifier(uri),
                types.Range(types.Position(1, 0), types.Position(1, 1)),
                types.CodeActionContext([]),
            )
        )
        (add,) = [item for item in actions if "V.CH.NEW in" in item.title or "Add" in item.title]
        ((_, start, text),) = changed(add.edit)["ext_var1.lis"]
        assert start > 0
        assert text.startswith("\nvch[")
        assert text.split("\n")[1].endswith(" NEW")
        assert not text.endswith("\n")

    in_editor(script)


def test_a_list_folds_is_put_in_columns_and_its_values_are_completed(in_editor: Run) -> None:
    """Values stay as they are written; a second time changes nothing."""
    text = (
        "# variables\nnumber_used_variables 1\nvar[0].name  A ( mine\nvar[0].scope GLOBAL\n"
        "var[0].access_rights R\nEnde\nrest   of it"
    )

    async def script(editor: Editor) -> None:
        uri = await editor.open("ext_var9.lis", text)
        document = types.TextDocumentIdentifier(uri)
        client = editor.client

        async def values(line: int, column: int) -> list[str]:
            found = await client.text_document_completion_async(
                types.CompletionParams(**editor.at(uri, line, column))
            )
            return [item.label for item in found.items]

        assert "READ_ONLY" in await values(4, 22)
        assert set(await values(3, 13)) == {"CHANNEL", "GLOBAL"}
        folds = await client.text_document_folding_range_async(types.FoldingRangeParams(document))
        assert (2, 4) in {(fold.start_line, fold.end_line) for fold in folds}
        options = types.FormattingOptions(2, True)
        edits = await client.text_document_formatting_async(
            types.DocumentFormattingParams(document, options)
        )
        assert [edit.new_text for edit in edits] == [
            f"{'number_used_variables':39} 1",
            f"{'var[0].name':39} A ( mine",
            f"{'var[0].scope':39} GLOBAL",
            f"{'var[0].access_rights':39} R",
        ]
        other = await editor.open(
            "ext_var8.lis", "\n".join(edit.new_text for edit in edits) + "\nEnde\n"
        )
        again = await client.text_document_formatting_async(
            types.DocumentFormattingParams(types.TextDocumentIdentifier(other), options)
        )
        assert not again

    in_editor(script)
