# SPDX-License-Identifier: MIT
"""The words on a tape: the options of the run that it holds, as those of ``nctakt run``.

In: a tape. Out: its words, of the right types; a tape may come from anywhere. The table of run
options says which of them a tape keeps.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, cast

from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.commands.tape import INVALID_TAPE
from nctakt.run.access.tape import Tape
from nctakt.run.options import OPTIONS, RUN_OPTIONS, RunKeywords
from nctakt.run.plcs.realtime_plc import is_structured

#: The options that a tape keeps; the words of each have its name for commands.
KEPT = tuple(option for option in OPTIONS if "tape" in option.front_ends)
_READ = tuple(option for option in KEPT if option in RUN_OPTIONS)

#: The words that every tape has; later options have their default on older tapes.
_FIRST = (
    "programs", "others", "machine", "root", "assignments", "ticks", "until", "after", "skip",
    "wait_for_start", "blocks", "stays", "rtconf", "load", "system", "confined",
)  # fmt: skip

#: Fits none of the options.
_NOTHING_GIVEN = object()


def words_of(tape: Tape, name: str) -> dict[str, Any]:
    """Return the words of the tape in the file ``name``, with tuples for lists.

    An interrupted run has as many ``ticks`` as it ran. Raises ``Failure`` (901070) for words that
    do not belong to a run.
    """
    words = {}
    for option in KEPT:
        key = option.word
        missing = _NOTHING_GIVEN if key in _FIRST else option.kind.to_words(option.default)
        value = tape.words.get(key, missing)
        if value is _NOTHING_GIVEN or not option.kind.has_form_of_words(value):
            raise Failure(diagnostic(INVALID_TAPE, reason=f"{name}: {key}"))
        words[key] = _immutable(value)
    if tape.state not in ("ended", "error", "limit", "reset"):
        words["ticks"] = tape.ticks
    return words


def words_of_run(options: RunKeywords, **others: Any) -> dict[str, Any]:
    """Return the words of a run; ``others``: those that are no options of ``Controller.run``."""
    given = cast("Mapping[str, Any]", options)
    return {
        option.word: option.kind.to_words(given.get(option.name, option.default))
        if option in _READ
        else others.get(option.word)
        for option in KEPT
    }


def plcs_of(tape: Tape) -> tuple[str, ...]:
    """Return the files of the PLCs that run again with a tape: those in Structured Text."""
    word = tape.words.get("plc")
    files = word if isinstance(word, list) else [word]
    return tuple(file for file in files if isinstance(file, str) and is_structured(file))


def word_of_plcs(files: Sequence[str]) -> str | list[str] | None:
    """Return the word for the PLCs of a run that run again with its tape."""
    again = [file for file in files if is_structured(file)]
    return again if len(again) > 1 else next(iter(again), None)


def options_of_words(words: Mapping[str, Any]) -> RunKeywords:
    """Return the options of ``Controller.run`` that the words of a tape say.

    Raises ``Failure`` for words that cannot be read.
    """
    options = {option.name: option.kind.from_words(words[option.word]) for option in _READ}
    return cast("RunKeywords", options)


def _immutable(value: Any) -> Any:
    return tuple(map(_immutable, value)) if isinstance(value, list) else value
