# SPDX-License-Identifier: MIT
"""Changes of variables over time -> a VCD file, as GTKWave reads it (pyvcd).

In: variables, each with its changes in the order of time. Out: the file. The same changes give the
same bytes.
"""

from __future__ import annotations

import heapq
import importlib.util
import itertools
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any, Literal

from nctakt.base.dataclass import dataclass
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.schedule_results import LIBRARY_MISSING

Value = int | float | str

#: pyvcd's name for each kind of variable, its size in bits, its first value.
_KINDS: dict[str, tuple[str, int | None, Value]] = {
    "wire": ("wire", 1, 0),
    "truth": ("wire", 1, "x"),
    "text": ("string", None, ""),
    "integer": ("integer", 64, 0),
    "real": ("real", None, 0.0),
}


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
        raise Failure(diagnostic(LIBRARY_MISSING, library="pyvcd", what="--vcd"))


def write_vcd_file(
    path: Path, variables: Iterable[VcdVariable], *, timescale: str, begin: int
) -> None:
    """Write the variables from time ``begin`` on; ``timescale``: the unit of times, ``1 ns``.

    Raises ``OSError``. Of variables with one name the later ones get a number.
    """
    from vcd import VCDWriter  # noqa: PLC0415 - pyvcd only when needed

    names: dict[tuple[tuple[str, ...], str], int] = {}
    changes: list[Iterator[tuple[int, int, Any, Value]]] = []
    with (
        path.open("w", encoding="utf-8", newline="\n") as file,
        VCDWriter(
            file, timescale=timescale, date="", init_timestamp=begin, check_values=False
        ) as writer,
    ):
        for number, variable in enumerate(variables):
            scope = tuple(map(identifier, variable.scope))
            name = identifier(variable.name)
            count = names[scope, name] = names.get((scope, name), 0) + 1
            kind, size, first = _KINDS[variable.kind]
            shown = name if count == 1 else f"{name}_{count}"
            target = writer.register_var(scope, shown, kind, size=size, init=first)
            changes.append(_numbered(variable.changes, number, target))
        for time, _, target, value in heapq.merge(*changes, key=lambda change: change[:2]):
            writer.change(target, time, value)


def _numbered(
    changes: Iterable[tuple[int, Value]], number: int, variable: Any
) -> Iterator[tuple[int, int, Any, Value]]:
    for time, value in changes:
        yield time, number, variable, value


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
