# SPDX-License-Identifier: MIT
"""Changes of variables over time -> a VCD file, as GTKWave reads it (pyvcd).

In: variables, each with its changes in the order of time. Out: the file. The same changes give the
same bytes.
"""

from __future__ import annotations

import codecs
import heapq
import importlib.util
import itertools
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Literal

from nctakt.base.dataclass import dataclass
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.extras import install_command
from nctakt.messages.scheduling.schedule_results import LIBRARY_MISSING

Value = int | float | str

#: pyvcd's name for each kind of variable, its size in bits.
_KINDS: dict[str, tuple[str, int | None]] = {
    "wire": ("wire", 1),
    "truth": ("wire", 1),
    "text": ("string", None),
    "integer": ("integer", 64),
    "real": ("real", None),
}

#: The first value of each kind.
FIRST_VALUES: dict[str, Value] = {"wire": 0, "truth": "x", "text": "", "integer": 0, "real": 0.0}

_ESCAPES = "nctakt.vcd"


def _escaped(error: UnicodeError) -> tuple[str, int]:
    """Return what a file has for characters outside ASCII: their bytes."""
    assert isinstance(error, UnicodeEncodeError)
    data = error.object[error.start : error.end].encode("utf-8", "replace")
    return "".join(f"\\x{byte:02x}" for byte in data), error.end


codecs.register_error(_ESCAPES, _escaped)


@dataclass(frozen=True, slots=True)
class VcdVariable:
    """A variable: its scopes from the outermost to the innermost, its name, its changes.

    ``changes``: time and value, in the order of time. A wire is low at first, a truth unknown.
    """

    scope: tuple[str, ...]
    name: str
    kind: Literal["wire", "truth", "text", "integer", "real"]
    changes: Iterable[tuple[int, Value]]


def check_vcd() -> None:
    """Raise ``Failure`` (900634) where no VCD file can be written."""
    if importlib.util.find_spec("vcd") is None:
        raise Failure(
            diagnostic(
                LIBRARY_MISSING, library="pyvcd", what="--vcd", install=install_command("plot")
            )
        )


def write_vcd_file(
    path: Path, variables: Iterable[VcdVariable], *, timescale: str, begin: int
) -> None:
    """Write the variables from time ``begin`` on; ``timescale``: the unit of times, ``1 ns``.

    Raises ``OSError``.
    """
    from vcd import VCDWriter  # noqa: PLC0415 - pyvcd only when needed

    with (
        path.open("w", encoding="ascii", errors=_ESCAPES, newline="\n") as file,
        VCDWriter(
            file, timescale=timescale, date="", init_timestamp=begin, check_values=False
        ) as writer,
    ):
        targets, changes = [], []
        for scope, shown, variable in named(variables):
            kind, size = _KINDS[variable.kind]
            first = FIRST_VALUES[variable.kind]
            targets.append(writer.register_var(scope, shown, kind, size=size, init=first))
            changes.append(variable.changes)
        for time, number, value in in_order(changes):
            writer.change(targets[number], time, value)


def named(variables: Iterable[VcdVariable]) -> Iterator[tuple[tuple[str, ...], str, VcdVariable]]:
    """Yield variables with their scopes and names; of equal ones the later ones get a number."""
    names: dict[tuple[tuple[str, ...], str], int] = {}
    for variable in variables:
        scope = tuple(map(identifier, variable.scope))
        name = identifier(variable.name)
        count = names[scope, name] = names.get((scope, name), 0) + 1
        yield scope, name if count == 1 else f"{name}_{count}", variable


def in_order(
    changes: Sequence[Iterable[tuple[int, Value]]],
) -> Iterator[tuple[int, int, Value]]:
    """Yield the changes of all variables in the order of time: time, number of variable, value."""
    numbered = [_numbered(one, number) for number, one in enumerate(changes)]
    return heapq.merge(*numbered, key=lambda change: change[:2])


def _numbered(
    changes: Iterable[tuple[int, Value]], number: int
) -> Iterator[tuple[int, int, Value]]:
    for time, value in changes:
        yield time, number, value


def identifier(name: str) -> str:
    """Return a name without the characters that end one in a VCD file."""
    return "".join(
        character if character.isprintable() and not character.isspace() else "_"
        for character in name
    )


def levels(times: Sequence[tuple[int, int]]) -> Iterator[tuple[int, Value]]:
    """Yield the changes of a wire that is high from each begin to its end."""
    for begin, end in times:
        yield begin, 1
        yield end, 0


def truths(
    known: Iterable[tuple[int, int]], times: Sequence[tuple[int, int]]
) -> Iterator[tuple[int, Value]]:
    """Yield the changes of a truth: high in ``times``, else low where it is ``known``, else x."""
    steps: list[tuple[int, int, int]] = []
    for weight, spans in ((1, merged([*known, *times])), (2, times)):
        for begin, end in spans:
            steps += ((begin, 1, weight), (end, 0, -weight))
    shown, weights = "x", 0
    for time, group in itertools.groupby(sorted(steps), key=lambda step: step[0]):
        weights += sum(weight for _, _, weight in group)
        value = "1" if weights > 1 else "0" if weights else "x"
        if value != shown:
            yield time, value
        shown = value


def apart(times: Iterable[tuple[int, int]], gap: int) -> list[tuple[int, int]]:
    """Return times that touch with a gap between them, so that it can be seen."""
    shown: list[tuple[int, int]] = []
    for begin, end in times:
        touches = bool(shown) and shown[-1][1] == begin and end - begin > gap
        shown.append((begin + gap if touches else begin, end))
    return shown


def merged(times: Iterable[tuple[int, int]]) -> list[tuple[int, int]]:
    """Return times that overlap or touch as one, empty ones left out."""
    joined: list[tuple[int, int]] = []
    for begin, end in sorted(times):
        if joined and begin <= joined[-1][1]:
            joined[-1] = (joined[-1][0], max(end, joined[-1][1]))
        elif end > begin:
            joined.append((begin, end))
    return joined
