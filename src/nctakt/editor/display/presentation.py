# SPDX-License-Identifier: MIT
"""The requests for the display around a text: colours, hints, lenses, links, signatures.

In: requests of an editor. Out: answers of ``colours.py`` and ``hints.py``; the counts of a run,
which another process makes for the command ``nctakt.count``.
"""

from __future__ import annotations

import asyncio
import os
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any

from lsprotocol import types

from nctakt.base.diagnostics import Text
from nctakt.base.python_process import python_command, python_environment
from nctakt.editor.display.legend import LEGEND

if TYPE_CHECKING:
    from nctakt.editor.server import Server

#: The machine time after which a counted run ends.
_COUNTED_TIME = "60s"

_NOTHING_RAN = Text(
    "No branch of a realtime cycle was counted: the program has none, or it did not run.",
    "Kein Zweig eines Echtzeit-Zyklus gezählt: das Programm hat keinen, oder es lief nicht.",
)


def register(server: Server) -> None:
    """Register the requests."""
    _register_colours(server)
    _register_hints(server)
    _register_counts(server)


def _register_colours(server: Server) -> None:
    """Register the colours of words."""
    feature = server.feature

    @feature(types.TEXT_DOCUMENT_SEMANTIC_TOKENS_FULL, LEGEND)
    def on_tokens(params: types.SemanticTokensParams) -> types.SemanticTokens | None:
        return _tokens(server, params.text_document.uri, None)

    @feature(types.TEXT_DOCUMENT_SEMANTIC_TOKENS_RANGE, LEGEND)
    def on_range(params: types.SemanticTokensRangeParams) -> types.SemanticTokens | None:
        return _tokens(server, params.text_document.uri, params.range)


def _register_hints(server: Server) -> None:
    """Register hints in lines, links and signatures."""
    feature = server.feature

    @feature(types.TEXT_DOCUMENT_INLAY_HINT)
    async def on_hints(params: types.InlayHintParams) -> list[types.InlayHint]:
        from nctakt.editor.display.hints import inlay_hints  # noqa: PLC0415 - when it is asked for

        document = server.document(params.text_document.uri)
        if document is None or not document.is_program:
            return []
        found = await server.diagnosis.settled(document)
        names = server.work.machine_of(document).machine.names
        lines = range(params.range.start.line, params.range.end.line + 1)
        return inlay_hints(document, found, names, lines, server.language)

    @feature(types.TEXT_DOCUMENT_DOCUMENT_LINK)
    def on_links(params: types.DocumentLinkParams) -> list[types.DocumentLink]:
        from nctakt.editor.display.hints import document_links  # noqa: PLC0415 - when it is asked for

        document = server.document(params.text_document.uri)
        if document is None or document.is_structured:
            return []
        return list(document_links(document, server.work.machine_of(document)))

    @feature(
        types.TEXT_DOCUMENT_SIGNATURE_HELP,
        types.SignatureHelpOptions(trigger_characters=["[", "(", ",", " "]),
    )
    def on_signature(params: types.SignatureHelpParams) -> types.SignatureHelp | None:
        from nctakt.editor.display.hints import signature_help  # noqa: PLC0415 - when it is asked for

        document = server.document(params.text_document.uri)
        if document is not None and document.is_structured:
            return server.structured.signature(document, params.position)
        if document is None or document.is_list:
            return None
        line = document.line(params.position.line)
        return signature_help(line[: document.index(params.position)], server.language)


def _register_counts(server: Server) -> None:
    """Register the command that counts how often branches ran, and the lenses that show it."""
    feature = server.feature
    counts: dict[str, dict[int, int]] = {}

    @feature(types.TEXT_DOCUMENT_CODE_LENS)
    def on_lenses(params: types.CodeLensParams) -> list[types.CodeLens]:
        from nctakt.editor.display.hints import code_lenses  # noqa: PLC0415 - when it is asked for

        document = server.document(params.text_document.uri)
        if document is None or not document.is_program or document.path is None:
            return []  # a text without a file cannot be run
        return code_lenses(document, counts.get(document.uri), server.language)

    @server.command("nctakt.count")
    async def count(uri: str, *_: Any) -> int:
        """Run a saved program and show how often its branches ran; the number of branches."""
        document = server.document(uri)
        if document is None or document.path is None:
            return 0
        counts[uri] = await _counted(document.path)
        if not counts[uri]:
            text = _NOTHING_RAN.get(server.language)
            server.window_show_message(types.ShowMessageParams(types.MessageType.Warning, text))
        server.workspace_code_lens_refresh(None)
        return len(counts[uri])


def _tokens(server: Server, uri: str, area: types.Range | None) -> types.SemanticTokens | None:
    from nctakt.editor.display.colours import semantic_tokens  # noqa: PLC0415 - when it is asked for

    document = server.document(uri)
    if document is None or document.is_list:
        return None
    first = 0 if area is None else area.start.line
    last = len(document.lines) if area is None else min(len(document.lines), area.end.line + 1)
    if document.is_structured:
        return types.SemanticTokens(server.structured.tokens(document, first, last))
    names = server.work.machine_of(document).machine.names
    return types.SemanticTokens(semantic_tokens(document, names, first, last))


async def _counted(path: Path) -> dict[int, int]:
    """Return how often the body of each branch ran, by its line."""
    from nctakt.base.failure import Failure  # noqa: PLC0415 - when it is asked for
    from nctakt.results.coverage_files import from_json  # noqa: PLC0415

    number, name = tempfile.mkstemp(suffix=".json")
    os.close(number)
    data = Path(name)
    try:
        words = ("coverage", str(path), "--until", _COUNTED_TIME, "--data", name)
        process = await asyncio.create_subprocess_exec(
            *python_command("nctakt", *words),
            cwd=path.parent,
            env=python_environment(),
            stdin=asyncio.subprocess.DEVNULL,
            stdout=asyncio.subprocess.DEVNULL,
            stderr=asyncio.subprocess.DEVNULL,
        )
        try:
            await process.wait()
        finally:
            if process.returncode is None:  # the server ends
                process.kill()
        coverage = from_json(name, data.read_text("ascii"))
    except Failure:
        return {}
    finally:
        data.unlink(missing_ok=True)
    return {
        branch.line: branch.bodies
        for cycle in coverage.cycles
        if Path(path.parent, cycle.file).resolve() == path.resolve()
        for branch in cycle.branches
    }
