# SPDX-License-Identifier: MIT
"""What this version does with each word and command of the language that is known.

Three answers: *simulated*; *accepted*, which is checked and has no effect on positions here;
*refused*, which would change positions or timing in a way that is not modelled, so that it is an
error by name. In: names and numbers as the tree has them. Out: the ``Entry`` that answers, ``None``
for what nobody knows. ``entries`` gives the whole table, for documentation.
"""

from __future__ import annotations

import enum
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher, get_close_matches
from types import MappingProxyType

from nctakt.base.diagnostics import Text
from nctakt.lists.declared.technology_functions import TechnologyFunction
from nctakt.nc.vocabulary.commands import COMMANDS, CONTROLS, FORMS, VARIABLES
from nctakt.nc.vocabulary.functions_and_words import (
    G_FUNCTIONS,
    INSTEAD,
    M_FUNCTIONS,
    TECHNOLOGY,
    WORDS,
    Row,
)
from nctakt.nc.vocabulary.operators import FUNCTIONS


class Answer(enum.Enum):
    """What a program gets that uses it."""

    SIMULATED = "simulated"
    ACCEPTED = "accepted"
    REFUSED = "refused"


class Kind(enum.Enum):
    """Where it belongs."""

    G_FUNCTION = "G function"
    M_FUNCTION = "M function"
    TECHNOLOGY = "synchronisation of M and H functions"
    WORD = "word"
    CONTROL = "control word"
    COMMAND = "# command"
    VARIABLE = "variables"
    FUNCTION = "function of expressions"
    FORM = "form"


_NOTHING = Text("", "")


@dataclass(frozen=True, slots=True)
class Entry:
    """One row of the table; of one ``group`` only one G function may stand in a block.

    ``instead``: what takes the place of what is refused, empty where nothing does.
    """

    kind: Kind
    name: str
    answer: Answer
    meaning: Text
    group: str = ""
    instead: Text = _NOTHING


_CODES = {"S": Answer.SIMULATED, "A": Answer.ACCEPTED, "R": Answer.REFUSED}


def _table(kind: Kind, rows: Iterable[Row]) -> Mapping[str, Entry]:
    return MappingProxyType(
        {
            row.name: Entry(
                kind,
                row.name,
                _CODES[row.code],
                row.meaning,
                row.group,
                INSTEAD.get(row.name, _NOTHING),
            )
            for row in rows
        }
    )


_G = _table(Kind.G_FUNCTION, G_FUNCTIONS)
_M = _table(Kind.M_FUNCTION, M_FUNCTIONS)
_TECHNOLOGY = _table(Kind.TECHNOLOGY, TECHNOLOGY)
_WORDS = _table(Kind.WORD, WORDS)
_CONTROLS = _table(Kind.CONTROL, CONTROLS)
_COMMANDS = _table(Kind.COMMAND, COMMANDS)
_VARIABLES = _table(Kind.VARIABLE, VARIABLES)
_FORMS = _table(Kind.FORM, FORMS)
_FUNCTIONS = MappingProxyType(
    {
        function.name: Entry(
            Kind.FUNCTION,
            function.name,
            Answer.SIMULATED,
            function.meaning,
        )
        for function in FUNCTIONS.values()
    }
)
_TABLES = (
    _G,
    _M,
    _TECHNOLOGY,
    _WORDS,
    _CONTROLS,
    _COMMANDS,
    _VARIABLES,
    _FUNCTIONS,
    _FORMS,
)


def entries() -> Iterator[Entry]:
    """The whole table, kind by kind."""
    for table in _TABLES:
        yield from table.values()


def answer_g(number: float) -> Entry | None:
    """The answer to a G function."""
    return _G.get(f"G{int(number):02}") if number == int(number) else None


def answer_m(number: int, functions: Mapping[int, TechnologyFunction]) -> Entry | None:
    """The answer to an M function; ``functions``: those of the channel list, by number.

    ``None``: the channel list does not define it.
    """
    own = _M.get(f"M{number:02}")
    return own if own is not None else answer_h(number, functions)


def answer_h(number: int, functions: Mapping[int, TechnologyFunction]) -> Entry | None:
    """The answer to an H function, as ``answer_m``."""
    function = functions.get(number)
    if function is None:
        return None
    answer = _TECHNOLOGY[function.synchronisation]
    return form("M110 X") if function.axis_name and answer.answer is Answer.SIMULATED else answer


def answer_word(name: str) -> Entry | None:
    """The answer to the letter or name of a word that is no axis."""
    return _WORDS.get(name)


def answer_hash(words: Sequence[str]) -> Entry | None:
    """The answer to a ``#`` command by its words, without ``#``: the longest row that fits."""
    for count in range(len(words), 0, -1):
        entry = _COMMANDS.get("#" + " ".join(words[:count]))
        if entry is not None:
            return entry
    return _COMMANDS["#MC_"] if words[0].startswith("MC_") else None


def answer_family(family: str) -> Entry | None:
    """The answer to a family of variables: ``E``, ``RTG``; ``P`` is that of ``V.P.NAME``."""
    return _VARIABLES.get(f"V.{family}")


def answer_function(name: str) -> Entry | None:
    """The answer to a function of expressions."""
    return _FUNCTIONS.get(name)


def call_parameter() -> Entry:
    """The answer to ``@P1``."""
    return _VARIABLES["@P"]


def form(example: str) -> Entry:
    """The answer to what has no name of its own, by the example that stands for it."""
    return _FORMS[example]


def nearest_hash(words: Sequence[str]) -> str:
    """The known ``#`` command that is most like these words, empty if none is."""
    written = ["#" + " ".join(words[:count]) for count in range(min(len(words), 3), 0, -1)]
    found = [(near, one) for one in written for near in get_close_matches(one, _COMMANDS, 1)]
    if not found:
        return ""
    return max(found, key=lambda pair: SequenceMatcher(None, *pair).ratio())[0]


def nearest_family(family: str) -> str:
    """The known family of variables that is most like this one, empty if none is."""
    near = get_close_matches(f"V.{family}", [name for name in _VARIABLES if name[0] == "V"], 1)
    return near[0] if near else ""
