# SPDX-License-Identifier: MIT
"""RETAIN and PERSISTENT variables of a PLC from one run to the next (ST-406).

A file holds them by their paths as JSON, ``{"MAIN.nParts": 41}``. Paths are resolved when it is
read, so that a variable keeps its value when others come and go.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.messages import diagnostic
from nctakt.messages.plcs.plc_code import NO_PLC_THAT_RETAINS, RETAINED_SKIPPED, RETAINED_UNREADABLE
from nctakt.plc.structured_text import StructuredPlc
from nctakt.run.plcs.plc_view import AnyPlc
from nctakt.run.plcs.realtime_plc import NamedGroup, parts_of

Values = Mapping[str, float | str]


def structured_plcs(plc: AnyPlc | None) -> list[StructuredPlc]:
    """Return the PLCs in Structured Text among those of a controller."""
    return [one for one in parts_of(plc)[0] if isinstance(one, StructuredPlc)]


def plcs_that_retain(plc: AnyPlc | None) -> list[StructuredPlc]:
    """Return the PLCs in Structured Text; raises ``Failure`` (902501) if there is none."""
    found = structured_plcs(plc)
    if not found:
        raise Failure(diagnostic(NO_PLC_THAT_RETAINS))
    return found


def read_retained(
    path: str | Path, plcs: list[StructuredPlc], access: FileAccess
) -> tuple[Values, list[Diagnostic]]:
    """Return the retained values of a file, and warnings (902503) for those that no PLC has.

    Nothing is retained if there is no file yet. Raises ``Failure`` (902502) for a file of another
    kind.
    """
    if not Path(path).exists():
        return {}, []
    try:
        content = json.loads(access.read_bytes(Path(path), is_replaced=True))
    except (ValueError, RecursionError) as error:
        raise Failure(diagnostic(RETAINED_UNREADABLE, file=str(path), reason=str(error))) from error
    if not isinstance(content, dict) or not all(map(_is_value, content.values())):
        reason = "{path: value, …}"
        raise Failure(diagnostic(RETAINED_UNREADABLE, file=str(path), reason=reason))
    group = _group(plcs)
    kept = {name.lower() for name, _, _ in _retained_names(plcs)}
    values, warnings = {}, []
    for name, value in content.items():
        if name.lower() in kept and _fits(group, name, value):
            values[name] = value
        else:
            warnings.append(diagnostic(RETAINED_SKIPPED, name=name, file=str(path)))
    return values, warnings


def retained_text(plcs: Sequence[StructuredPlc]) -> str:
    """Return the values of the retained variables of PLCs as the text of a file."""
    return json.dumps(dict(_retained(plcs)), indent=1, ensure_ascii=False) + "\n"


def _retained(plcs: Sequence[StructuredPlc]) -> Iterator[tuple[str, float | bool | str]]:
    for name, plc, path in _retained_names(plcs):
        value = plc.read(path)
        if isinstance(value, str) or math.isfinite(value):
            yield name, value


def _group(plcs: Sequence[StructuredPlc]) -> NamedGroup:
    return NamedGroup(plcs, [plc.name for plc in plcs])


def _retained_names(plcs: Sequence[StructuredPlc]) -> Iterator[tuple[str, StructuredPlc, str]]:
    """Yield the name of each retained variable in the file, its PLC, and its path there."""
    group = _group(plcs)
    for number, plc in enumerate(plcs):
        for path in plc.retained_paths():
            yield group.path(number, path), plc, path


def _is_value(value: object) -> bool:
    return isinstance(value, str | int) or (isinstance(value, float) and math.isfinite(value))


def _fits(group: NamedGroup, name: str, value: float | str) -> bool:
    try:
        group.check(name, value)
    except Failure:
        return False
    return True
