# SPDX-License-Identifier: MIT
"""The server itself: requests of an editor -> answers of the other modules.

In: messages of the Language Server Protocol, from ``entrance``. Out: answers, and findings after
each change. Documents are kept here and not by pygls, which would copy a long text at each
keystroke. The modules of the answers are loaded during the first check, so that the editor need not
wait for them at the start.
"""

from __future__ import annotations

import asyncio
import contextlib
import sys
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO, cast

from lsprotocol import types
from pygls.exceptions import JsonRpcException
from pygls.lsp.server import LanguageServer
from pygls.protocol import LanguageServerProtocol, lsp_method

from nctakt.base.diagnostics import Diagnostic, Language, Severity
from nctakt.base.failure import Failure
from nctakt.base.version import __version__
from nctakt.editor.diagnosis import Diagnosis
from nctakt.editor.document import Document, name_of, path_of, split_text
from nctakt.editor.incoming import Incoming
from nctakt.editor.malformed import Refused, TolerantProtocol, unreadable
from nctakt.editor.workspace import Workspace

if TYPE_CHECKING:
    from nctakt.editor.calls import CallHierarchy
    from nctakt.editor.structured_text.answers import StructuredAnswers

#: Seconds between two switches of threads: a check must not hold up an answer.
_SWITCH_S = 0.001

_SEVERITIES = {
    Severity.ERROR: types.DiagnosticSeverity.Error,
    Severity.WARNING: types.DiagnosticSeverity.Warning,
    Severity.NOTE: types.DiagnosticSeverity.Information,
}


class _Protocol(TolerantProtocol):
    """Leaves the texts of documents to the server."""

    @lsp_method(types.TEXT_DOCUMENT_DID_OPEN)
    def lsp_text_document__did_open(self, params: types.DidOpenTextDocumentParams) -> None:
        """Open a document."""
        _server(self).opened(params)

    @lsp_method(types.TEXT_DOCUMENT_DID_CHANGE)
    def lsp_text_document__did_change(self, params: types.DidChangeTextDocumentParams) -> None:
        """Change a document."""
        _server(self).changed(params)

    @lsp_method(types.TEXT_DOCUMENT_DID_CLOSE)
    def lsp_text_document__did_close(self, params: types.DidCloseTextDocumentParams) -> None:
        """Close a document."""
        _server(self).closed(params.text_document.uri)


def _server(protocol: LanguageServerProtocol) -> Server:
    server = protocol._server
    assert isinstance(server, Server)
    return server


class Server(LanguageServer):
    """The language server: its documents, their checks, the language of its texts."""

    def __init__(self, language: Language = "en") -> None:
        super().__init__("nctakt", __version__, protocol_cls=_Protocol)
        self.language: Language = language
        self.work = Workspace()
        self.diagnosis = Diagnosis(self.work, self._publish)
        self.reference = ""
        self._incoming: Incoming | None = None
        self._structured: StructuredAnswers | None = None
        sys.setswitchinterval(_SWITCH_S)
        register(self)

    def report_server_error(self, error: Exception, source: Any) -> None:
        """Answer a body that cannot be read; show other errors that no request waits for."""
        if source is JsonRpcException:
            assert isinstance(self.protocol, TolerantProtocol)
            self.protocol.answer(None, unreadable(error))
        else:
            super().report_server_error(error, source)

    def begin(self, params: types.InitializeParams) -> None:
        """Take the options of the editor: ``language``, ``reference`` (where codes lead)."""
        options = params.initialization_options
        if isinstance(options, dict):
            if options.get("language") in ("en", "de"):
                self.language = options["language"]
            self.reference = str(options.get("reference") or "")

    def serve(self, incoming: Incoming, outgoing: BinaryIO) -> None:
        """Serve an editor until it goes, or a signal ends it."""
        self._incoming = incoming
        self.start_io(cast("BinaryIO", incoming), outgoing)

    def shutdown(self) -> None:
        """End; the editor no longer waits for answers."""
        if self._incoming is not None:
            self._incoming.end()
        super().shutdown()  # type: ignore[no-untyped-call]

    # --- documents -------------------------------------------------------------------------------

    def opened(self, params: types.DidOpenTextDocumentParams) -> None:
        """Add a document and check it."""
        item = params.text_document
        self.work.encoding = self.workspace.position_encoding or self.work.encoding
        path = path_of(item.uri)
        document = Document(
            item.uri,
            path,
            name_of(item.uri, self.folders, item.language_id),
            item.language_id,
            item.version,
            split_text(item.text),
            self.work.encoding,
        )
        self.work.open(document)
        if document.is_structured:
            self.work.plc.forget()  # it may belong to the projects of others
        self.diagnosis.changed(document, pause=False)

    def changed(self, params: types.DidChangeTextDocumentParams) -> None:
        """Change a document and check it; with it others that may depend on it.

        A list changes the programs of its machine, an object of a PLC those of its project.
        """
        document = self.work.documents.get(params.text_document.uri)
        if document is None:
            return
        for event in params.content_changes:
            document.change(event)
        document.version = params.text_document.version
        self.diagnosis.changed(document)
        if document.is_list:
            self.recheck(document)
        elif document.is_structured:
            for other in self.work.plc.documents_beside(document):
                self.diagnosis.changed(other)

    def recheck(self, changed: Document | None = None) -> None:
        """Check the other programs again: a list or a file has changed."""
        for other in self.work.documents.values():
            if other is not changed and other.is_program:
                self.diagnosis.changed(other)

    def recheck_structured(self) -> None:
        """Find the projects of PLCs again, and check their open documents."""
        self.work.plc.forget()
        for other in self.work.documents.values():
            if other.is_structured:
                self.diagnosis.changed(other)

    def closed(self, uri: str) -> None:
        """Remove a document and its findings."""
        self.work.close(uri)
        self.diagnosis.closed(uri)
        self.text_document_publish_diagnostics(types.PublishDiagnosticsParams(uri, []))

    @property
    def has_snippets(self) -> bool:
        """Whether the editor can fill in the gaps of a completed text."""
        capabilities = self.client_capabilities.text_document
        completion = None if capabilities is None else capabilities.completion
        item = None if completion is None else completion.completion_item
        return item is not None and bool(item.snippet_support)

    @property
    def folders(self) -> list[Path]:
        """The existing folders of the editor."""
        paths = (path_of(folder.uri) for folder in self.workspace.folders.values())
        return [path for path in paths if path is not None and path.is_dir()]

    @property
    def structured(self) -> StructuredAnswers:
        """The answers about Structured Text."""
        if self._structured is None:
            from nctakt.editor.structured_text.answers import StructuredAnswers  # noqa: PLC0415 - when it is asked for

            self._structured = StructuredAnswers(self.work.plc)
        return self._structured

    def document(self, uri: str) -> Document | None:
        """Return an open document."""
        return self.work.documents.get(uri)

    # --- findings --------------------------------------------------------------------------------

    def _publish(self, document: Document, found: Sequence[Diagnostic]) -> None:
        shown = [self.shown(document, item) for item in found]
        self.text_document_publish_diagnostics(
            types.PublishDiagnosticsParams(document.uri, shown, document.version)
        )

    def shown(self, document: Document, item: Diagnostic) -> types.Diagnostic:
        """Return a finding as editors show it: number, area, text, remedy, related place."""
        remedy = item.remedy(self.language)
        text = item.text(self.language)
        href = f"{self.reference}{item.id}" if self.reference else ""
        return types.Diagnostic(
            document.range_of(item.span),
            f"{text}\n{remedy}" if remedy else text,
            _SEVERITIES[item.severity],
            item.id,
            types.CodeDescription(href) if href else None,
            "nctakt",
            related_information=self._related(document, item),
        )

    def _related(
        self, document: Document, item: Diagnostic
    ) -> list[types.DiagnosticRelatedInformation] | None:
        line = item.values.get("line")
        if not isinstance(line, int) or not 1 <= line <= len(document.lines):
            return None
        area = types.Location(document.uri, document.whole_lines(line - 1, line - 1))
        text = document.line(line - 1).strip()
        return [types.DiagnosticRelatedInformation(area, text)]


def register(server: Server) -> None:
    """Register the requests that the server answers."""
    _register_lifecycle(server)
    _register_help(server)
    _register_navigation(server)
    _register_calls(server)
    _register_renaming(server)
    _register_structure(server)
    _register_edits(server)


def _register_lifecycle(server: Server) -> None:
    """Register start and end of the server, and changes of saved files."""
    feature = server.feature

    @feature(types.INITIALIZE)
    def initialize(params: types.InitializeParams) -> None:
        if isinstance(params, types.InitializeParams):
            server.begin(params)

    @feature(types.INITIALIZED)
    def initialized(_: types.InitializedParams) -> None:
        server.diagnosis.warm_up()

    @feature(types.SHUTDOWN)
    def shutdown(*_: Any) -> None:
        server.diagnosis.stop()

    @feature(types.TEXT_DOCUMENT_DID_SAVE)
    @feature(types.WORKSPACE_DID_CHANGE_WATCHED_FILES)
    def saved(_: Any) -> None:
        server.recheck()
        server.recheck_structured()


def _register_help(server: Server) -> None:
    """Register requests that explain and complete words."""
    feature = server.feature

    @feature(types.TEXT_DOCUMENT_HOVER)
    def on_hover(params: types.HoverParams) -> types.Hover | None:
        from nctakt.editor.display.hover import hover  # noqa: PLC0415 - when it is asked for

        document = server.document(params.text_document.uri)
        if document is None:
            return None
        if document.is_structured:
            return server.structured.hover(document, params.position, server.language)
        machine = server.work.machine_of(document).machine
        found = server.diagnosis.findings.get(document.uri, [])
        return hover(document, params.position, machine, found, server.language)

    @feature(
        types.TEXT_DOCUMENT_COMPLETION,
        types.CompletionOptions(trigger_characters=[".", "$", "#", "[", "=", " "]),
    )
    def on_completion(params: types.CompletionParams) -> types.CompletionList | None:
        from nctakt.editor.completing.completion import complete  # noqa: PLC0415 - when it is asked for

        document = server.document(params.text_document.uri)
        if document is None:
            return None
        if document.is_structured:
            found = server.structured.complete(document, params.position)
            return types.CompletionList(is_incomplete=False, items=found)
        machine = server.work.machine_of(document).machine
        items = complete(
            document,
            params.position,
            machine,
            server.language,
            has_snippets=server.has_snippets,
        )
        return types.CompletionList(is_incomplete=False, items=items)


def _register_navigation(server: Server) -> None:
    """Register requests that find the places of a name."""
    feature = server.feature

    @feature(types.TEXT_DOCUMENT_DEFINITION)
    def on_definition(params: types.DefinitionParams) -> list[types.Location]:
        from nctakt.editor.navigation import definition  # noqa: PLC0415 - when it is asked for

        document = server.document(params.text_document.uri)
        if document is None:
            return []
        if document.is_structured:
            return server.structured.definition(document, params.position)
        return definition(document, params.position, server.work.machine_of(document))

    @feature(types.TEXT_DOCUMENT_REFERENCES)
    def on_references(params: types.ReferenceParams) -> list[types.Location]:
        from nctakt.editor.navigation import references  # noqa: PLC0415 - when it is asked for

        document = server.document(params.text_document.uri)
        if document is None:
            return []
        if document.is_structured:
            has_definition = params.context.include_declaration
            return server.structured.references(
                document, params.position, with_definition=has_definition
            )
        return references(
            document,
            params.position,
            server.work.machine_of(document),
            lambda: server.work.programs_beside(document, server.folders),
            with_definition=params.context.include_declaration,
        )

    @feature(types.TEXT_DOCUMENT_DOCUMENT_HIGHLIGHT)
    def on_highlight(params: types.DocumentHighlightParams) -> list[types.DocumentHighlight]:
        from nctakt.editor.navigation import highlights  # noqa: PLC0415 - when it is asked for

        document = server.document(params.text_document.uri)
        if document is None:
            return []
        if document.is_structured:
            found = server.structured.highlights(document, params.position)
        else:
            found = highlights(document, params.position, server.work.machine_of(document))
        return [types.DocumentHighlight(area) for area in found]


def _register_calls(server: Server) -> None:
    """Register requests for callers and calls of a program."""
    feature = server.feature

    def hierarchy(uri: str) -> CallHierarchy | None:
        from nctakt.editor.calls import CallHierarchy  # noqa: PLC0415 - when it is asked for

        path = path_of(uri)
        document = server.document(uri)
        if document is None and path is not None:
            document = server.work.document_of(path)
        if document is None:
            return None
        near = document
        return CallHierarchy(
            server.work,
            server.work.machine_of(document),
            lambda: server.work.programs_beside(near, server.folders),
        )

    @feature(types.TEXT_DOCUMENT_PREPARE_CALL_HIERARCHY)
    def on_prepare(params: types.CallHierarchyPrepareParams) -> list[types.CallHierarchyItem]:
        document = server.document(params.text_document.uri)
        calls = hierarchy(params.text_document.uri)
        if document is None or calls is None or not document.is_program:
            return []
        return calls.prepare(document, params.position)

    @feature(types.CALL_HIERARCHY_INCOMING_CALLS)
    def on_incoming(
        params: types.CallHierarchyIncomingCallsParams,
    ) -> list[types.CallHierarchyIncomingCall]:
        calls = hierarchy(params.item.uri)
        return [] if calls is None else calls.incoming(params.item)

    @feature(types.CALL_HIERARCHY_OUTGOING_CALLS)
    def on_outgoing(
        params: types.CallHierarchyOutgoingCallsParams,
    ) -> list[types.CallHierarchyOutgoingCall]:
        calls = hierarchy(params.item.uri)
        return [] if calls is None else calls.outgoing(params.item)


def _register_renaming(server: Server) -> None:
    """Register the change of a name at all its places."""
    feature = server.feature

    @feature(types.TEXT_DOCUMENT_PREPARE_RENAME)
    def on_prepare_rename(params: types.PrepareRenameParams) -> types.Range | None:
        from nctakt.editor.navigation import can_rename, found_at, renamed_part  # noqa: PLC0415 - when it is asked for
        from nctakt.editor.structured_text.renaming import part_at  # noqa: PLC0415 - the same

        document = server.document(params.text_document.uri)
        if document is None:
            return None
        if document.is_structured:
            with refusing(server):
                return server.structured.renamed_range(document, params.position)
        item = found_at(document, params.position, server.work.machine_of(document))
        if item is None and not document.is_list:
            part = part_at(document, params.position)
            return None if part is None else part.range
        if item is None or not can_rename(item.symbol):
            return None
        return document.range(item.line, *renamed_part(document, item))

    @feature(types.TEXT_DOCUMENT_RENAME, types.RenameOptions(prepare_provider=True))
    def on_rename(params: types.RenameParams) -> types.WorkspaceEdit | None:
        from nctakt.editor.navigation import rename  # noqa: PLC0415 - when it is asked for
        from nctakt.editor.structured_text.renaming import part_at  # noqa: PLC0415 - the same

        document = server.document(params.text_document.uri)
        if document is None:
            return None
        position, new = params.position, params.new_name

        def programs() -> Iterable[Document]:
            return server.work.programs(server.folders)

        with refusing(server):
            if document.is_structured:
                return server.structured.rename(document, position, new, programs)
            part = None if document.is_list else part_at(document, position)
            if part is not None:
                edit = server.structured.rename_from_program(document, part, new, programs)
                if edit is not None:
                    return edit
            return rename(
                document,
                position,
                new,
                server.work.machine_of(document),
                lambda: server.work.programs_beside(document, server.folders),
            )


def _register_structure(server: Server) -> None:
    """Register requests for the structure of texts."""
    feature = server.feature

    @feature(types.TEXT_DOCUMENT_DOCUMENT_SYMBOL)
    def on_symbols(params: types.DocumentSymbolParams) -> list[types.DocumentSymbol]:
        from nctakt.editor.display.outline import document_symbols  # noqa: PLC0415 - when it is asked for

        document = server.document(params.text_document.uri)
        if document is not None and document.is_structured:
            return server.structured.symbols(document)
        return [] if document is None else document_symbols(document)

    @feature(types.WORKSPACE_SYMBOL)
    def on_workspace_symbols(
        params: types.WorkspaceSymbolParams,
    ) -> list[types.WorkspaceSymbol]:
        from nctakt.editor.display.outline import document_symbols  # noqa: PLC0415 - when it is asked for

        found = []
        query = params.query.casefold()
        for document in server.work.programs(server.folders):
            for symbol in _flat(document_symbols(document)):
                if query in symbol.name.casefold():
                    area = types.Location(document.uri, symbol.selection_range)
                    found.append(types.WorkspaceSymbol(area, symbol.name, symbol.kind))
        return found

    @feature(types.TEXT_DOCUMENT_FOLDING_RANGE)
    def on_folding(params: types.FoldingRangeParams) -> list[types.FoldingRange]:
        from nctakt.editor.display.outline import folding_ranges  # noqa: PLC0415 - when it is asked for

        document = server.document(params.text_document.uri)
        if document is not None and document.is_structured:
            return server.structured.folds(document)
        return [] if document is None else folding_ranges(document)

    @feature(types.TEXT_DOCUMENT_SELECTION_RANGE)
    def on_selection(params: types.SelectionRangeParams) -> list[types.SelectionRange] | None:
        from nctakt.editor.display.outline import selection_range  # noqa: PLC0415 - when it is asked for

        document = server.document(params.text_document.uri)
        if document is None:
            return None
        return [selection_range(document, position) for position in params.positions]


def _register_edits(server: Server) -> None:
    """Register requests that change a text: its format, remedies of findings."""
    feature = server.feature

    @feature(types.TEXT_DOCUMENT_FORMATTING)
    def on_formatting(params: types.DocumentFormattingParams) -> list[types.TextEdit] | None:
        document = server.document(params.text_document.uri)
        return None if document is None else _edits(server, document, 0, len(document.lines))

    @feature(types.TEXT_DOCUMENT_RANGE_FORMATTING)
    def on_range(params: types.DocumentRangeFormattingParams) -> list[types.TextEdit] | None:
        document = server.document(params.text_document.uri)
        if document is None:
            return None
        last = min(params.range.end.line + (params.range.end.character > 0), len(document.lines))
        first = params.range.start.line
        return _edits(server, document, first, max(last, first + 1))

    @feature(
        types.TEXT_DOCUMENT_CODE_ACTION,
        types.CodeActionOptions(code_action_kinds=[types.CodeActionKind.QuickFix]),
    )
    async def on_action(params: types.CodeActionParams) -> list[types.CodeAction]:
        from nctakt.editor.edits.remedies import actions  # noqa: PLC0415 - when it is asked for

        document = server.document(params.text_document.uri)
        if document is None:
            return []
        found = await server.diagnosis.settled(document)
        chosen = []
        for item in found:
            shown = server.shown(document, item)
            if shown.range.start.line <= params.range.end.line and (
                params.range.start.line <= shown.range.end.line
            ):
                chosen.append((item, shown))
        if document.is_structured:
            return await asyncio.to_thread(
                server.structured.actions, document, chosen, server.language
            )
        return actions(document, chosen, server.work.machine_of(document), server.language)


@contextlib.contextmanager
def refusing(server: Server) -> Iterator[None]:
    """Answer a ``Failure`` as a request that is refused, with its reasons."""
    try:
        yield
    except Failure as failure:
        reasons = (item.text(server.language) for item in failure.diagnostics)
        raise Refused(" ".join(reasons)) from failure


def _edits(server: Server, document: Document, first: int, last: int) -> list[types.TextEdit]:
    from nctakt.editor.formatting import format_lines  # noqa: PLC0415 - when it is asked for

    if document.is_structured:
        return server.structured.format(document, first, last)
    if document.is_list:
        from nctakt.editor.list_lines import format_list  # noqa: PLC0415 - when it is asked for

        new = format_list(document.lines, first, last)
    else:
        new = format_lines(document.lines, first, last)
    return [
        types.TextEdit(document.whole_lines(number, number), line)
        for number, line in enumerate(new, first)
        if line != document.line(number)
    ]


def _flat(symbols: Sequence[types.DocumentSymbol]) -> list[types.DocumentSymbol]:
    flat: list[types.DocumentSymbol] = []
    for symbol in symbols:
        flat += [symbol, *_flat(symbol.children or ())]
    return flat
