# SPDX-License-Identifier: MIT
"""Findings of the language server: those of a check, after each change, with their remedies."""

from __future__ import annotations

import random
from collections.abc import Callable
from pathlib import Path

import pytest
from lsprotocol import types
from support.editor_client import Editor
from support.random_seeds import FIRST, MANY

from nctakt.checking.check import check_files
from nctakt.cli import main
from nctakt.lists.machine.machine import load_machine
from nctakt.run.program_loader import NcText
from nctakt.run.realtime.assembly import AssembledMachine

pytestmark = pytest.mark.slow

Run = Callable[..., None]

#: Random edits; ``NCTAKT_SEEDS=100000`` makes as many.
EDITS = 4_000

PROGRAM = """\
%MAIN
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF V.RTA.ACS.ACT_POS.X > 5
    M100
  $ENDIF
#RT CYCLE END
N10: G01 X10 F1000
$GOTO N10
M30
"""


def fresh(text: str) -> list[tuple[int, int, int]]:
    """Line, column and number of what a check finds in a text."""
    result = check_files([NcText("t.nc", text)], AssembledMachine(load_machine(None)), for_all=True)
    return sorted(
        (span.line - 1, span.column - 1, item.diagnostic.id)
        for item in result.findings
        if (span := item.diagnostic.span) is not None
    )


def shown(found: list[types.Diagnostic]) -> list[tuple[int, int, int]]:
    return sorted(
        (item.range.start.line, item.range.start.character, int(item.code or 0)) for item in found
    )


def test_findings_are_those_of_a_check_after_each_change(in_editor: Run) -> None:
    """A change is checked, one that comes before the check has ended as well."""

    async def script(editor: Editor) -> None:
        uri = await editor.open("part.nc", PROGRAM)
        assert shown(await editor.settled(uri, 0)) == fresh(PROGRAM)
        editor.type(uri, 6, 11, 11, ",5")
        found = await editor.settled(uri)
        assert shown(found) == fresh(PROGRAM.replace("X10", "X1,50"))
        editor.type(uri, 6, 11, 13, "")
        editor.type(uri, 3, 4, 8, "M200")
        assert shown(await editor.settled(uri)) == fresh(PROGRAM.replace("M100", "M200"))

    in_editor(script)


def test_a_finding_has_number_remedy_severity_and_related_place(in_editor: Run) -> None:
    """Its number leads to the reference where the editor says where that is."""

    async def script(editor: Editor) -> None:
        text = "N10: G00 X1\nN10: G00 X2\n$GOTO N10\nP1++\nM30\n"
        uri = await editor.open("part.nc", text)
        found = await editor.settled(uri, 0)
        slip = next(item for item in found if item.range.start.line == 3)
        assert slip.source == "nctakt"
        assert slip.severity is types.DiagnosticSeverity.Error
        assert "P1 += 1" in slip.message
        assert slip.code_description is not None
        assert slip.code_description.href == f"nctakt:{slip.code}"

    in_editor(script, {"reference": "nctakt:"})


def test_texts_are_german_where_the_editor_asks_for_it(in_editor: Run) -> None:
    """The option ``language`` of the editor counts."""

    async def script(editor: Editor) -> None:
        uri = await editor.open("part.nc", "P1++\nM30\n")
        found = await editor.settled(uri, 0)
        assert "schreiben" in found[0].message

    in_editor(script, {"language": "de"})


@pytest.mark.nightly
def test_positions_count_as_the_editor_does(in_editor: Run) -> None:
    """A letter beyond the first 65,536 counts twice in UTF-16, once in UTF-32."""
    text = "(😀) P1++\nM30\n"

    for kind, column in (
        (types.PositionEncodingKind.Utf16, 5),
        (types.PositionEncodingKind.Utf32, 4),
        (types.PositionEncodingKind.Utf8, 7),
    ):

        async def script(editor: Editor, column: int = column) -> None:
            uri = await editor.open("part.nc", text)
            (found,) = await editor.settled(uri, 0)
            assert found.range.start.character == column

        in_editor(script, None, [kind])


def test_a_called_file_counts_as_it_is_in_the_editor(in_editor: Run) -> None:
    """A program that calls a file sees the text that is open, not the one on disk."""

    async def script(editor: Editor) -> None:
        (editor.folder / "sub.nc").write_text("G00 X1\nM17\n")
        uri = await editor.open("part.nc", "L sub.nc\nL other.nc\nM30\n")
        assert shown(await editor.settled(uri, 0)) == [(1, 0, 20369)]

    in_editor(script)


def test_a_list_is_checked_and_changes_its_programs(in_editor: Run, tmp_path: Path) -> None:
    """A variable that is written into the open list is known in the program at once."""

    async def script(editor: Editor) -> None:
        assert main(["new", str(tmp_path / "cell")]) == 0
        folder = next((tmp_path / "cell").rglob("hochlauf.lis")).parent
        lists = [
            p for p in sorted(folder.iterdir()) if "var" in p.name and "extv" in p.name.lower()
        ]
        editor.folder = folder
        uri = await editor.open("part.nc", "V.E.BRAND_NEW = 1\nM30\n")
        assert [item.code for item in await editor.settled(uri, 0)] == [20196]
        result = await editor.client.text_document_code_action_async(
            types.CodeActionParams(
                types.TextDocumentIdentifier(uri),
                types.Range(types.Position(0, 0), types.Position(0, 1)),
                types.CodeActionContext([]),
            )
        )
        add = next(item for item in result if "BRAND_NEW in" in item.title or "Add" in item.title)
        ((list_uri, edits),) = add.edit.changes.items()
        path = Path(list_uri.removeprefix("file://"))
        lines = path.read_text("utf-8").split("\n")
        for edit in sorted(edits, key=lambda e: e.range.start.line, reverse=True):
            line = lines[edit.range.start.line]
            start, end = edit.range.start.character, edit.range.end.character
            lines[edit.range.start.line] = line[:start] + edit.new_text + line[end:]
        await editor.open(path.name, "\n".join(lines), is_saved=False)
        editor.type(uri, 1, 3, 3, " ")
        assert [item.code for item in await editor.settled(uri)] == [], lists

    in_editor(script)


@pytest.mark.nightly
def test_random_edits_leave_the_findings_of_a_fresh_check(in_editor: Run) -> None:
    """After any edits, most of which cancel the check before, the findings are a fresh check's."""
    pieces = ["X", "1,5", "\n", "$IF P1 == 3\n", "$ENDIF\n", "#RT CYCLE END\n", "]", ";", "(", "++"]
    chance = random.Random(7 + FIRST)

    async def script(editor: Editor) -> None:
        uri = await editor.open("part.nc", PROGRAM)
        text = PROGRAM
        for round_number in range(1, int(MANY or EDITS) + 1):
            lines = text.split("\n")
            line = chance.randrange(len(lines))
            start = chance.randrange(len(lines[line]) + 1)
            end = min(len(lines[line]), start + chance.choice((0, 0, 1, 3)))
            new = chance.choice(pieces) if chance.random() < 0.6 else ""
            if len(lines) > 40:
                end, new = len(lines[line]), ""
            editor.type(uri, line, start, end, new)
            lines[line] = lines[line][:start] + new + lines[line][end:]
            text = "\n".join(lines)
            if round_number % 100 == 0:
                assert shown(await editor.settled(uri)) == fresh(text), text

    in_editor(script)
