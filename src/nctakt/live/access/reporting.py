# SPDX-License-Identifier: MIT
"""Errors in the server get one line each, each reason once; no traceback reaches a user.

In: records of the libraries' loggers. Out: diagnostics. With NCTAKT_DEBUG the libraries speak for
themselves.
"""

from __future__ import annotations

import logging
import os
from collections.abc import Callable

from nctakt.base.diagnostics import Diagnostic
from nctakt.messages import diagnostic
from nctakt.messages.connections.live import MESSAGE_NOT_READABLE

#: The loggers of the libraries that read data from browsers.
_LOGGERS = ("asyncio", "engineio", "engineio.server", "nicegui", "socketio", "socketio.server")

#: Different reasons that are reported at most.
_MAX_REASONS = 20


class _Reporter(logging.Handler):
    def __init__(self, report: Callable[[Diagnostic], None]) -> None:
        super().__init__(logging.ERROR)
        self._report = report
        self._reasons: set[str] = set()

    def emit(self, record: logging.LogRecord) -> None:
        """Report a record, unless its reason is known."""
        error = None if record.exc_info is None else record.exc_info[1]
        if error is None:
            reason = record.getMessage().splitlines()[0]
        else:
            reason = f"{type(error).__name__}: {error}".splitlines()[0]
        reason = reason[:120]
        if reason not in self._reasons and len(self._reasons) < _MAX_REASONS:
            self._reasons.add(reason)
            self._report(diagnostic(MESSAGE_NOT_READABLE, reason=reason))


def report_errors(report: Callable[[Diagnostic], None]) -> None:
    """Report errors of the libraries by ``report`` from now on."""
    if os.environ.get("NCTAKT_DEBUG"):
        return
    reporter = _Reporter(report)
    for name in _LOGGERS:
        logger = logging.getLogger(name)
        logger.handlers = [reporter]
        logger.propagate = False
