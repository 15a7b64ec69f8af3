# SPDX-License-Identifier: MIT
"""Checks documents during typing: after a pause, in parallel with requests, cancelled by a change.

In: changed documents. Out: findings of the present text; those of an older text are never
published.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

from nctakt.base.diagnostics import Diagnostic
from nctakt.editor.document import Document
from nctakt.editor.workspace import Workspace

#: The pause after a keystroke before a check begins, in seconds.
PAUSE_S = 0.02

Publish = Callable[[Document, list[Diagnostic]], None]


class Cancelled(Exception):
    """Ends a check whose text has changed."""


class Diagnosis:
    """The checks of all documents, one at a time; ``findings``: the last published ones by URI."""

    def __init__(self, workspace: Workspace, publish: Publish) -> None:
        self._workspace = workspace
        self._publish = publish
        self._pool = ThreadPoolExecutor(1, "check")
        self._waiting: dict[str, asyncio.Task[None]] = {}
        self.findings: dict[str, list[Diagnostic]] = {}

    def warm_up(self) -> None:
        """Load the modules of the answers and the built-in machine before they are needed."""
        self._pool.submit(self._workspace.warm_up)

    def changed(self, document: Document, *, pause: bool = True) -> None:
        """Check a document after a pause, in place of a check that waits or runs."""
        before = self._waiting.pop(document.uri, None)
        if before is not None:
            before.cancel()
        delay = PAUSE_S if pause else 0.0
        task = asyncio.get_running_loop().create_task(
            self._check(document, document.version, delay)
        )
        self._waiting[document.uri] = task

    def closed(self, uri: str) -> None:
        """Forget a document."""
        task = self._waiting.pop(uri, None)
        if task is not None:
            task.cancel()
        self.findings.pop(uri, None)

    async def settled(self, document: Document) -> list[Diagnostic]:
        """Return the findings of a document once the check of its text has ended."""
        task = self._waiting.get(document.uri)
        while task is not None and not task.done():
            await asyncio.wait([task])
            task = self._waiting.get(document.uri)
        return self.findings.get(document.uri, [])

    def stop(self) -> None:
        """Cancel all checks."""
        for task in self._waiting.values():
            task.cancel()
        self._waiting.clear()
        self._pool.shutdown(wait=False, cancel_futures=True)

    async def _check(self, document: Document, version: int, delay: float) -> None:
        await asyncio.sleep(delay)

        def poll() -> None:
            if document.version != version or document.uri not in self._workspace.documents:
                raise Cancelled

        def check() -> list[Diagnostic] | None:
            try:
                poll()
                return self._workspace.check(document, poll)
            except Cancelled:
                return None

        found = await asyncio.get_running_loop().run_in_executor(self._pool, check)
        if found is None or document.version != version:
            return
        if self._workspace.documents.get(document.uri) is document:
            self.findings[document.uri] = found
            self._publish(document, found)
            if document.is_structured:
                self._pool.submit(self._workspace.plc.tidy)
