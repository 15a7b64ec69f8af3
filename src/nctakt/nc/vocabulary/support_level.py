# SPDX-License-Identifier: MIT
"""The level of support of each known word, function, command and variable of the language.

In: names and numbers from the tree. Out: the ``Entry`` of the name, ``None`` if it is unknown.
``entries`` yields the whole table, for documentation.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from types import MappingProxyType

from nctakt.base.misspelling import nearest
from nctakt.lists.declared.technology_functions import TechnologyFunction
from nctakt.nc.tree import Variable
from nctakt.nc.vocabulary.commands import COMMANDS, CONTROLS, FORMS, VARIABLES
from nctakt.nc.vocabulary.entries import SIMULATED, Entry, Kind, Support
from nctakt.nc.vocabulary.function_rows import GFunction
from nctakt.nc.vocabulary.functions import G_FUNCTIONS, M_FUNCTIONS
from nctakt.nc.vocabulary.operators import FUNCTIONS
from nctakt.nc.vocabulary.words import TECHNOLOGY, WORDS

_FUNCTIONS = MappingProxyType(
    {
        function.name: Entry(Kind.FUNCTION, function.name, SIMULATED, function.meaning)
        for function in FUNCTIONS.values()
    }
)
_TABLES: tuple[Mapping[int, Entry] | Mapping[str, Entry], ...] = (
    G_FUNCTIONS,
    M_FUNCTIONS,
    TECHNOLOGY,
    WORDS,
    CONTROLS,
    COMMANDS,
    VARIABLES,
    _FUNCTIONS,
    FORMS,
)


def entries() -> Iterator[Entry]:
    """Yield the whole table, kind by kind."""
    for table in _TABLES:
        yield from table.values()


def g_function(number: float) -> GFunction | None:
    """Return the row of a G function."""
    return G_FUNCTIONS.get(int(number)) if number == int(number) else None


def m_function(number: int, functions: Mapping[int, TechnologyFunction]) -> Entry | None:
    """Return the entry of an M function; ``functions``: those of the channel list, by number.

    ``None`` where neither the controller nor the channel list defines it.
    """
    return M_FUNCTIONS.get(number) or h_function(number, functions)


def h_function(number: int, functions: Mapping[int, TechnologyFunction]) -> Entry | None:
    """Return the entry of an H function, by its synchronisation type in the channel list."""
    function = functions.get(number)
    if function is None:
        return None
    entry = TECHNOLOGY[function.synchronisation]
    return form("M110 X") if function.axis_name and entry.support is SIMULATED else entry


def word(name: str) -> Entry | None:
    """Return the entry of a word other than an axis, by its letter or name."""
    return WORDS.get(name)


def hash_command(words: Sequence[str]) -> Entry | None:
    """Return the entry of a ``#`` command by its words, without ``#``: the longest that fits."""
    for count in range(len(words), 0, -1):
        entry = COMMANDS.get("#" + " ".join(words[:count]))
        if entry is not None:
            return entry
    return COMMANDS["#MC_"] if words and words[0].startswith("MC_") else None


def variable_family(family: str) -> Entry | None:
    """Return the entry of a family of variables: ``E``, ``RTG``; ``P`` means V.P.NAME."""
    return VARIABLES.get(f"V.{family}")


def variable(written: Variable) -> Entry | None:
    """Return the entry of a variable that is refused by its first name, else of its family."""
    names = [part.name for part in written.parts[:1]]
    entry = VARIABLES.get(".".join(("V", written.family, *names)))
    if entry is not None and entry.support is Support.REFUSED:
        return entry
    return variable_family(written.family)


def expression_function(name: str) -> Entry | None:
    """Return the entry of a function of expressions."""
    return _FUNCTIONS.get(name)


def call_parameter() -> Entry:
    """Return the entry of ``@P1``."""
    return VARIABLES["@P"]


def form(example: str) -> Entry:
    """Return the entry of an unnamed form by its example."""
    return FORMS[example]


def nearest_hash(words: Sequence[str]) -> str:
    """Return the known ``#`` command most similar to these words; empty if there is none."""
    written = ["#" + " ".join(words[:count]) for count in range(min(len(words), 3), 0, -1)]
    return next(filter(None, (nearest(name, COMMANDS) for name in written)), "")


def nearest_family(family: str) -> str:
    """Return the known family of variables most similar to this one; empty if there is none."""
    return nearest(f"V.{family}", [name for name in VARIABLES if name.count(".") == 1])
