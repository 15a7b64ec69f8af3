# SPDX-License-Identifier: MIT
"""Another block to continue from: a program restarts there, by block search.

In: a line of the first program of channel 1. Out: the target that the protocol shows, and a session
that is where the block has become current. A jump that a block search does not allow is an error,
and the present session stays.
"""

from __future__ import annotations

from typing import Any

from nctakt.base.diagnostics import Severity
from nctakt.base.failure import Failure
from nctakt.debugger.arguments import Arguments
from nctakt.debugger.debuggee import Debuggee
from nctakt.debugger.launch import Configuration
from nctakt.messages import diagnostic
from nctakt.messages.programs.block_search import START_BLOCK_NOT_REACHED
from nctakt.session.engine import StepResult
from nctakt.session.session import Session
from nctakt.session.stops import StopAt

#: Machine time in which the start block becomes current, else the session stays before it.
LONGEST_APPROACH = "10 min"


def start_block(debuggee: Debuggee, arguments: Arguments) -> dict[str, Any] | None:
    """Return the block that a line begins, as a target; ``None`` if a search cannot end there."""
    file = debuggee.sources.name_of(arguments.part("source"))
    first = next(iter(debuggee.session.description.texts), None)
    line = arguments.number("line")
    if file is None or file != first:
        return None
    location = debuggee.places(file).at_or_after(line)
    if location is None or location.kind != "block" or location.line != line:
        return None
    return {"id": line, "label": debuggee.sources.line(file, line), "line": line}


def search_block(
    debuggee: Debuggee, configuration: Configuration, line: int
) -> tuple[Session, StepResult]:
    """Return a session at the block of a line, and how it has come there; raises ``Failure``."""
    file = next(iter(debuggee.session.description.texts), "")
    session = configuration.at_line(line).open()
    try:
        done = session.run(LONGEST_APPROACH, until=[StopAt("block", file=file, line=line)])
        if not done.hits:
            found = [*session.description.diagnostics, *done.diagnostics]
            errors = [one for one in found if one.severity is Severity.ERROR]
            missing = diagnostic(START_BLOCK_NOT_REACHED, block=str(line))
            raise Failure(*(errors or [missing]))
    except BaseException:
        session.close()
        raise
    return session, done
