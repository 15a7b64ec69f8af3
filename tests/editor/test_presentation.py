# SPDX-License-Identifier: MIT
"""What the language server shows around a text: colours by time, hints, lenses, links, forms."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from lsprotocol import types
from support.editor_client import Editor

from nctakt.editor.display.legend import MODIFIERS, TYPES

pytestmark = pytest.mark.slow

Run = Callable[..., None]

PROGRAM = """\
P1 = 200
#RT CYCLE [ID=7 SCOPE=PROG]
  $IF EDGE V.RTA.ACS.ACT_POS.X > P1
    V.E.COUNT = V.E.ASYNC
  $ENDIF
#RT CYCLE END
V.E.ASYNC = 2 (why)
L other.nc
G01 X300 F10000
M30
"""


def decoded(data: list[int], text: str) -> list[tuple[str, str, tuple[str, ...]]]:
    """The text, type and modifiers of each token."""
    lines = text.split("\n")
    line = start = 0
    items = []
    for ahead, before, length, kind, bits in zip(*[iter(data)] * 5, strict=True):
        start = before if ahead else start + before
        line += ahead
        modifiers = tuple(name for bit, name in enumerate(MODIFIERS) if bits >> bit & 1)
        items.append((lines[line][start : start + length], TYPES[kind], modifiers))
    return items


def test_colours_tell_when_a_value_is_read(in_editor: Run) -> None:
    """Each tick, ahead of time, or frozen when the cycle was defined."""

    async def script(editor: Editor) -> None:
        uri = await editor.open("part.nc", PROGRAM)
        document = types.TextDocumentIdentifier(uri)
        found = await editor.client.text_document_semantic_tokens_full_async(
            types.SemanticTokensParams(document)
        )
        items = decoded(found.data, PROGRAM)
        assert ("V.RTA.ACS.ACT_POS.X", "variable", ("realtime",)) in items
        assert ("P1", "parameter", ("frozen",)) in items
        assert ("P1", "parameter", ("decoder",)) in items
        assert ("V.E.ASYNC", "variable", ("frozen",)) in items
        assert ("V.E.ASYNC", "variable", ("decoder",)) in items
        assert ("(why)", "comment", ()) in items
        part = await editor.client.text_document_semantic_tokens_range_async(
            types.SemanticTokensRangeParams(
                document, types.Range(types.Position(2, 0), types.Position(2, 9))
            )
        )
        assert decoded(part.data, PROGRAM)[0] == ("$IF", "keyword", ())

    in_editor(script)


def test_hints_links_lenses_and_forms(in_editor: Run) -> None:
    """Frozen values and cost; files of calls; commands and counts; forms of brackets."""

    async def script(editor: Editor) -> None:
        (editor.folder / "other.nc").write_text("M17\n")
        uri = await editor.open("part.nc", PROGRAM)
        document = types.TextDocumentIdentifier(uri)
        client = editor.client
        everything = types.Range(types.Position(0, 0), types.Position(10, 0))
        hints = await client.text_document_inlay_hint_async(
            types.InlayHintParams(document, everything)
        )
        labels = {(hint.position.line, hint.label) for hint in hints}
        assert labels >= {(1, "≤ 6 instructions"), (2, " = 200")}
        (link,) = await client.text_document_document_link_async(types.DocumentLinkParams(document))
        assert link.target.endswith("/other.nc")
        lenses = await client.text_document_code_lens_async(types.CodeLensParams(document))
        assert [lens.command.title for lens in lenses] == [
            "Run",
            "Debug",
            "Open live page",
            "Count branches",
            "Why?",
        ]
        count = await client.workspace_execute_command_async(
            types.ExecuteCommandParams("nctakt.count", arguments=[uri])
        )
        assert count == 1
        lenses = await client.text_document_code_lens_async(types.CodeLensParams(document))
        assert lenses[-1].command.title == "ran 1 times in the last run"
        assert lenses[-1].range.start.line == 2

        async def form(text: str) -> str:
            editor.type(uri, 10, 0, 0, text)
            params = types.SignatureHelpParams(**editor.at(uri, 10, len(text)))
            found = await client.text_document_signature_help_async(params)
            editor.type(uri, 10, 0, len(text), "")
            return "" if found is None else found.signatures[0].label

        assert await form("P1 = ATAN[") == "ATAN[value 1]"
        assert (await form("#RT CYCLE [ID=1 ")).startswith("#RT CYCLE [ID=n SCOPE=")
        assert "INDP" in await form("X[")
        assert "FEED_FACT" in await form("#OVERRIDE [")
        assert await form("P1 = 5") == ""

    in_editor(script)
