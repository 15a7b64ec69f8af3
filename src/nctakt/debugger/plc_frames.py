# SPDX-License-Identifier: MIT
"""The calls and variables of a PLC in Structured Text, as the protocol shows them.

In: a session within a cycle of its PLC, or after a tick. Out: frames by method and object, scopes
by the keywords of declarations, structures and arrays as trees; values that are set.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from nctakt.base.diagnostics import NOTHING, Language
from nctakt.base.failure import Failure
from nctakt.debugger.values import DEBUGGER, Values, read_value
from nctakt.messages import diagnostic
from nctakt.messages.plc_debugging import NOT_SET_FROM_OUTSIDE
from nctakt.plc.stepping.shown import PlcValue
from nctakt.session.session import Session

#: The number of the thread that is the PLC: between channels and realtime cycles.
PLC_THREAD = 1000

#: Keys of variables: a scope of a call, or the children of a path in it. A level is that of a call,
#: ``None`` after a tick.
SCOPE, BELOW = "plc scope", "plc below"


class PlcFrames:
    """The view of a session's PLC."""

    def __init__(self, session: Session, values: Values, language: Language) -> None:
        self._session = session
        self._values = values
        self._language: Language = language

    @property
    def is_there(self) -> bool:
        """Whether there is a PLC in Structured Text."""
        return bool(self._session.description.plc_lines)

    @property
    def thread(self) -> dict[str, Any]:
        """The PLC as a thread."""
        name = "SPS" if self._language == "de" else "PLC"
        return {"id": PLC_THREAD, "name": name}

    def frames(self) -> Sequence[tuple[str, Any]]:
        """Return name and place of each open call, the innermost first; none after a tick."""
        halted = self._session.statement
        found = []
        for one in () if halted is None else halted.frames:
            name = one.name if one.instance in ("", one.name) else f"{one.name} ({one.instance})"
            within = "" if one.within is None else f" [{one.within.get(self._language)}]"
            found.append((name + within, one.span))
        return found

    def scopes(self, level: int | None) -> list[str]:
        """Return the names of the scopes of a call."""
        return self._session.scopes(level)

    def variables(self, key: tuple[Any, ...], first: int, count: int) -> list[PlcValue]:
        """Return the variables of a scope, or the children of one; raises ``Failure``."""
        kind, level, name = key
        if kind == SCOPE:
            return self._session.of_scope(name, level, first, count)
        return self._session.below(name, level, first, count)

    def value(self, text: str, level: int | None) -> PlcValue:
        """Return a variable or an expression in a call; raises ``Failure``."""
        return self._session.value(text, level)

    def note_of(self, found: PlcValue) -> str:
        """Return the note after a value: its value in the next tick."""
        return self._values.note_of(found.settable, 1) if found.settable else ""

    def write(self, found: PlcValue, text: str) -> str:
        """Let a variable have another value from the next tick on; return it as text."""
        if not found.settable:
            reason = found.fixed or NOTHING
            raise Failure(diagnostic(NOT_SET_FROM_OUTSIDE, name=found.path, reason=reason))
        self._values.write_value(found.settable, _written(text), DEBUGGER)
        return text.strip()


def _written(text: str) -> float | bool | str:
    """Return the value of a text: a number, a truth, a text in quotes, an item, a literal."""
    text = text.strip()
    if len(text) > 1 and text[0] == text[-1] == "'":
        return text[1:-1]
    if text.lower() == "null":
        return 0
    try:
        return read_value(text)
    except Failure:
        if "#" in text or text.replace(".", "").replace("_", "").isalnum():
            return text
        raise
