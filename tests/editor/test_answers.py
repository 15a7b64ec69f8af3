# SPDX-License-Identifier: MIT
"""Answers of the language server: explanation, completion, names, outline, format, remedies."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from lsprotocol import types
from pygls.exceptions import JsonRpcException
from support.editor_client import Editor

pytestmark = pytest.mark.slow

Run = Callable[..., None]

PROGRAM = """\
%L PART
G00 X1
M17
%MAIN
#VAR
V.P.SIZE = 10
#ENDVAR
P1 = 200 (limit)
#RT CYCLE [ID=7 SCOPE=PROG]
  $IF EDGE V.RTA.ACS.ACT_POS.X > P1
    M100
  $ENDIF
#RT CYCLE END
[LOOP] G01 XV.P.SIZE F1000
LL PART
$IF P1 > 3 $GOTO [LOOP]
#RT CYCLE DELETE [ID=7]
M30
"""


def line_of(text: str) -> int:
    return next(n for n, line in enumerate(PROGRAM.split("\n")) if text in line)


def column(text: str, part: str) -> int:
    return PROGRAM.split("\n")[line_of(text)].index(part)


def places(found: Any) -> list[int]:
    return [place.range.start.line for place in found or ()]


def applied(text: str, edits: list[types.TextEdit]) -> str:
    """The text after edits of single lines, or of whole ends of lines."""
    lines = text.split("\n")
    for edit in sorted(
        edits, key=lambda e: (e.range.start.line, e.range.start.character), reverse=True
    ):
        start, end = edit.range.start, edit.range.end
        before = lines[start.line][: start.character]
        after = lines[end.line][end.character :] if end.line < len(lines) else ""
        lines[start.line : end.line + 1] = (before + edit.new_text + after).split("\n")
    return "\n".join(lines)


def test_hover_explains_words_and_the_programs_own_names(in_editor: Run) -> None:
    """What explain says, and where a name is defined; of a frozen value, what is read."""

    async def script(editor: Editor) -> None:
        uri = await editor.open("part.nc", PROGRAM)

        async def text(line: str, part: str) -> str:
            params = types.HoverParams(**editor.at(uri, line_of(line), column(line, part)))
            found = await editor.client.text_document_hover_async(params)
            return "" if found is None else found.contents.value

        assert "straight line with feed" in await text("[LOOP] G01", "G01")
        assert "V.RTA.ACS.ACT_POS" in await text("$IF EDGE", "V.RTA")
        assert "each time the condition becomes true" in await text("$IF EDGE", "EDGE")
        frozen = await text("$IF EDGE", "P1")
        assert "200, set in line 8" in frozen
        assert "line 8" in frozen
        assert "line 9" in await text("DELETE", "7")
        assert "line 1" in await text("LL PART", "PART")
        assert "V.P.SIZE = 10" in await text("XV.P.SIZE", "SIZE")
        assert "realtime cycle" in await text("#RT CYCLE [ID", "RT")
        editor.type(uri, 0, 0, 0, "; waits for gpCh[0]^.bahn_state.program_end_r\n")
        params = types.HoverParams(**editor.at(uri, 0, 40))
        found = await editor.client.text_document_hover_async(params)
        assert found is not None
        assert "No program runs" in found.contents.value

    in_editor(script)


def test_completion_offers_what_is_possible_at_the_cursor(in_editor: Run) -> None:
    """Words, paths of variables, keywords, IDs, labels, subprograms, files, parameters of lists."""

    async def script(editor: Editor) -> None:
        (editor.folder / "other.nc").write_text("M17\n")
        uri = await editor.open("part.nc", PROGRAM + "\n")
        end = PROGRAM.count("\n")

        async def labels(text: str) -> set[str]:
            editor.type(uri, end, 0, 0, text)
            params = types.CompletionParams(**editor.at(uri, end, len(text)))
            found = await editor.client.text_document_completion_async(params)
            editor.type(uri, end, 0, len(text), "")
            return {item.label for item in found.items}

        assert {"V.E.COUNT", "V.E.VALUE"} <= await labels("P1 = V.E.")
        assert "V.RTA.ACS.ACT_POS.X" in await labels("$IF V.RTA.ACS.")
        assert "V.P.SIZE" in await labels("V.P.")
        assert {"$IF", "$FOR", "$GOTO"} <= await labels("$")
        assert {"#RT CYCLE", "#RT CYCLE DELETE", "#MSG"} <= await labels("#R")
        assert {"ID", "SCOPE", "END_ACTION"} <= await labels("#RT CYCLE [")
        assert {"PROG", "GLOBAL", "BLOCK"} <= await labels("#RT CYCLE [SCOPE=")
        assert "7" in await labels("#RT CYCLE DELETE [ID=")
        assert "INDP" in await labels("X[")
        assert "[LOOP]" in await labels("$GOTO ")
        assert "PART" in await labels("LL ")
        assert "other.nc" in await labels("L ")
        assert {"G01", "M30", "X", "P1", "M100"} <= await labels("N10 ")
        assert {"SIN", "P1", "V.E.COUNT"} <= await labels("P1 = ")
        assert {"gpCh[0]^", "gpAx[0]^", "gpPform^"} <= await labels("; gpC")
        assert "override" in await labels('hli["gpCh[0]^.bahn_mc_control.')
        assert {"enable_w", "command_w"} <= await labels("gpAx[1]^.lr_mc_control.drive_on.")
        assert not await labels("gpCh[0]^.bahn_stat.")
        listed = await editor.open("sda_mds1.lis", "rt_cycles.enable 1\n")
        params = types.CompletionParams(**editor.at(listed, 1, 0))
        found = await editor.client.text_document_completion_async(params)
        assert any("P-CHAN-00425" in (item.detail or "") for item in found.items)

    in_editor(script)


def test_names_lead_to_definitions_and_uses_and_can_be_changed(in_editor: Run) -> None:
    """Cycle IDs, labels, subprograms, variables of the program, parameters, called files."""

    async def script(editor: Editor) -> None:
        (editor.folder / "other.nc").write_text("M17\n")
        text = PROGRAM.replace("LL PART", "LL PART\nL other.nc")
        uri = await editor.open("part.nc", text)
        lines = text.split("\n")

        def at(part: str, name: str) -> dict[str, Any]:
            line = next(n for n, one in enumerate(lines) if part in one)
            return editor.at(uri, line, lines[line].index(name))

        client = editor.client

        async def defined(part: str, name: str) -> Any:
            return await client.text_document_definition_async(
                types.DefinitionParams(**at(part, name))
            )

        assert places(await defined("DELETE", "7")) == [8]
        assert places(await defined("$GOTO", "LOOP")) == [13]
        assert places(await defined("LL PART", "PART")) == [0]
        assert places(await defined("XV.P.SIZE", "SIZE")) == [5]
        assert places(await defined("$IF EDGE", "P1")) == [7]
        (file,) = await defined("L other", "other")
        assert file.uri.endswith("/other.nc")
        used = await client.text_document_references_async(
            types.ReferenceParams(**at("P1 = 200", "P1"), context=types.ReferenceContext(True))
        )
        assert places(used) == [7, 9, 16]
        lit = await client.text_document_document_highlight_async(
            types.DocumentHighlightParams(**at("P1 = 200", "P1"))
        )
        assert [item.range.start.line for item in lit] == [7, 9, 16]
        edit = await client.text_document_rename_async(
            types.RenameParams(**at("XV.P.SIZE", "SIZE"), new_name="LENGTH")
        )
        new = applied(text, edit.changes[uri])
        assert "V.P.LENGTH = 10" in new
        assert "XV.P.LENGTH" in new
        edit = await client.text_document_rename_async(
            types.RenameParams(**at("DELETE", "7"), new_name="8")
        )
        assert applied(text, edit.changes[uri]).count("ID=8") == 2
        axis = await client.text_document_prepare_rename_async(
            types.PrepareRenameParams(**at("G00 X1", "X1"))
        )
        assert (axis.start.character, axis.end.character) == (4, 5)
        with pytest.raises(JsonRpcException, match="it belongs to the demo machine"):
            await client.text_document_rename_async(
                types.RenameParams(**at("G00 X1", "X1"), new_name="X7")
            )

    in_editor(script)


def test_outline_folds_and_selections(in_editor: Run) -> None:
    """Programs with their cycles, labels and variables; structures fold; selections grow."""

    async def script(editor: Editor) -> None:
        uri = await editor.open("part.nc", PROGRAM)
        document = types.TextDocumentIdentifier(uri)
        client = editor.client
        symbols = await client.text_document_document_symbol_async(
            types.DocumentSymbolParams(document)
        )
        assert [item.name for item in symbols] == ["PART", "MAIN"]
        assert [item.name for item in symbols[1].children] == ["V.P.SIZE", "#RT CYCLE 7", "LOOP"]
        found = await client.workspace_symbol_async(types.WorkspaceSymbolParams("cycle"))
        assert [item.name for item in found] == ["#RT CYCLE 7"]
        folds = await client.text_document_folding_range_async(types.FoldingRangeParams(document))
        assert (8, 12) in {(fold.start_line, fold.end_line) for fold in folds}
        assert (9, 11) in {(fold.start_line, fold.end_line) for fold in folds}
        (selection,) = await client.text_document_selection_range_async(
            types.SelectionRangeParams(document, [types.Position(10, 5)])
        )
        starts = []
        while selection is not None:
            starts.append((selection.range.start.line, selection.range.end.line))
            selection = selection.parent
        assert starts == [(10, 10), (10, 10), (9, 11), (9, 11), (8, 12), (0, 18)] or len(starts) > 4

    in_editor(script)


def test_formatting_keeps_comments_and_numbers(in_editor: Run) -> None:
    """The printer's form and indentation; a second time changes nothing."""
    text = (
        "%MAIN\nn10 g0 x1.500 y.5   ; go\n#rt cycle [id=1 scope=PROG]\n"
        "$if edge v.rta.acs.act_pos.x>200.0 ; far\nm100\n$elseif P1>3\nV.E.COUNT+=1\n$endif\n"
        "#rt cycle end\ng1 x10 (middle) y20\nx1,5\nM30\n"
    )
    wanted = (
        "%MAIN\nN10 G0 X1.500 Y.5   ; go\n#RT CYCLE [ID=1 SCOPE=PROG]\n"
        "  $IF EDGE V.RTA.ACS.ACT_POS.X > 200.0 ; far\n    M100\n  $ELSEIF P1 > 3\n"
        "    V.E.COUNT += 1\n  $ENDIF\n#RT CYCLE END\ng1 x10 (middle) y20\nx1,5\nM30\n"
    )

    async def script(editor: Editor) -> None:
        uri = await editor.open("part.nc", text)
        params = types.DocumentFormattingParams(
            types.TextDocumentIdentifier(uri), types.FormattingOptions(2, True)
        )
        edits = await editor.client.text_document_formatting_async(params)
        new = applied(text, edits)
        assert new == wanted or new.lower() == wanted.lower()
        other = await editor.open("other.nc", new)
        again = await editor.client.text_document_formatting_async(
            types.DocumentFormattingParams(
                types.TextDocumentIdentifier(other), types.FormattingOptions(2, True)
            )
        )
        assert not again
        part = await editor.client.text_document_range_formatting_async(
            types.DocumentRangeFormattingParams(
                types.TextDocumentIdentifier(uri),
                types.Range(types.Position(4, 0), types.Position(4, 3)),
                types.FormattingOptions(2, True),
            )
        )
        assert [edit.new_text for edit in part] == ["    M100"]

    in_editor(script)


def test_findings_have_remedies_that_can_be_applied(in_editor: Run) -> None:
    """The right word, the missing end, Vs. for the value of each tick, a comment to ignore."""
    cases = {
        "$IF P1 = 3\nM100\n$ENDIF\nM30\n": "$IF P1 == 3\nM100\n$ENDIF\nM30\n",
        "G01 X1,5 F100\nM30\n": "G01 X1.5 F100\nM30\n",
        "P1 = SIN[30\nM30\n": "P1 = SIN[30]\nM30\n",
        "$IF P1 > 3\n  M100\nG00 X1\nM30\n": "$IF P1 > 3\n  M100\n$ENDIF\nG00 X1\nM30\n",
        "#RT CYCLE [ID=1 SCOPE=PROG]\n  V.E.COUNT = 1\nG00 X1\nM30\n": (
            "#RT CYCLE [ID=1 SCOPE=PROG]\n  V.E.COUNT = 1\n#RT CYCLE END\nG00 X1\nM30\n"
        ),
        "V.E.COUNTT = 1\nM30\n": "V.E.COUNT = 1\nM30\n",
        "$IF P1 > 3 M100 $ENDIF\nM30\n": "$IF P1 > 3\n  M100\n$ENDIF\nM30\n",
        "$IF P1 > 3 THEN\n$ENDIF\nM30\n": "$IF P1 > 3 \n$ENDIF\nM30\n",
        "$IF P1 > 3 THEN M100 $ENDIF\nM30\n": "$IF P1 > 3 \n  M100\n$ENDIF\nM30\n",
        "$IF {P1 > 3}\n$ENDIF\nM30\n": "$IF P1 > 3\n$ENDIF\nM30\n",
        "$ELSIF\nM30\n": "$ELSEIF\nM30\n",
    }

    async def script(editor: Editor) -> None:
        for number, (text, wanted) in enumerate(cases.items()):
            uri = await editor.open(f"part{number}.nc", text)
            found = await _actions(editor, uri, text)
            preferred = next(item for item in found if item.is_preferred)
            assert applied(text, preferred.edit.changes[uri]) == wanted
        text = PROGRAM.replace("> P1\n", "> V.E.ASYNC\n").replace("EDGE ", "")
        uri = await editor.open("cycle.nc", text)
        found = await _actions(editor, uri, text)
        edits = {item.title: item.edit.changes[uri] for item in found}
        assert "> Vs.E.ASYNC" in applied(text, edits["Write Vs.E.ASYNC"])
        assert "M100 ; nctakt: ignore 900243 reason" in applied(text, edits["Ignore 900243 here"])

    in_editor(script)


async def _actions(editor: Editor, uri: str, text: str) -> list[Any]:
    everything = types.Range(types.Position(0, 0), types.Position(text.count("\n"), 0))
    return list(
        await editor.client.text_document_code_action_async(
            types.CodeActionParams(
                types.TextDocumentIdentifier(uri), everything, types.CodeActionContext([])
            )
        )
        or ()
    )
