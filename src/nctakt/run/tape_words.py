# SPDX-License-Identifier: MIT
"""The words on a tape: the options of the run that it holds, as those of ``nctakt run``.

In: a tape. Out: its words, of the right types; a tape may come from anywhere.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.tape import INVALID_TAPE
from nctakt.run.tape import Tape


def _is_number_or_none(value: object) -> bool:
    return value is None or (isinstance(value, int) and not isinstance(value, bool))


#: The options of a run that a tape keeps, and whether their value fits.
WORDS: Mapping[str, Callable[[Any], bool]] = {
    "programs": lambda value: _is_list_of(value, str),
    "others": lambda value: (
        isinstance(value, list) and all(_is_list_of(one, str) and len(one) == 2 for one in value)
    ),
    "machine": lambda value: isinstance(value, str | None),
    "root": lambda value: isinstance(value, str | None),
    "assignments": lambda value: _is_list_of(value, str),
    "ticks": lambda value: isinstance(value, int | None) and not isinstance(value, bool),
    "until": lambda value: isinstance(value, str | None),
    "after": lambda value: isinstance(value, str),
    "skip": lambda value: isinstance(value, str),
    "wait_for_start": lambda value: isinstance(value, bool),
    "blocks": lambda value: isinstance(value, bool),
    "stays": lambda value: isinstance(value, bool),
    "rtconf": lambda value: isinstance(value, str | None),
    "load": lambda value: isinstance(value, str | None),
    "system": lambda value: isinstance(value, str | None),
    "confined": lambda value: _is_list_of(value, str),
    "from_line": _is_number_or_none,
    "from_block": _is_number_or_none,
}

#: Options that older tapes do not have.
_LATER = {"from_line": None, "from_block": None}

#: Fits none of the options.
_NOTHING_GIVEN = object()


def _is_list_of(value: object, kind: type) -> bool:
    return isinstance(value, list) and all(isinstance(one, kind) for one in value)


def words_of(tape: Tape, name: str) -> dict[str, Any]:
    """Return the words of the tape in the file ``name``, with tuples for lists.

    A run that was broken off has as many ``ticks`` as it ran. Raises ``Failure`` (901070) for words
    that are none of a run.
    """
    for key, fits in WORDS.items():
        if not fits(tape.words.get(key, _LATER.get(key, _NOTHING_GIVEN))):
            raise Failure(diagnostic(INVALID_TAPE, reason=f"{name}: {key}"))
    words = {key: _immutable(tape.words.get(key, _LATER.get(key))) for key in WORDS}
    if tape.state not in ("ended", "error", "limit", "reset"):
        words["ticks"] = tape.ticks
    return words


def _immutable(value: Any) -> Any:
    return tuple(map(_immutable, value)) if isinstance(value, list) else value
