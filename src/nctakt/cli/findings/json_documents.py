# SPDX-License-Identifier: MIT
"""Results as one JSON object for scripts, written on standard output by ``--format json``.

In: results in dataclasses. Out: objects with the names of the fields as keys, the same in every
language; texts and values are in the language of the command. The text is ASCII for any terminal.
Diagnostics are those of ``nctakt check``.
"""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from typing import TYPE_CHECKING

from nctakt.base.diagnostics import Language, Span, Text
from nctakt.base.version import __version__
from nctakt.cli.findings.formats import diagnostics_as_json

if TYPE_CHECKING:
    from nctakt.results.run import Run

#: The fields of a run in its document, in this order.
_RUN_FIELDS = ("programs", "state", "first_tick", "ticks", "cycle_time_us")
_RESULT_FIELDS = (
    "messages",
    "cycles",
    "outputs",
    "motions",
    "spindle_jobs",
    "starved",
    "overflows",
)


def plain(value: object, language: Language) -> object:
    """Return a value for JSON: dataclasses become objects, spans short ones."""
    if isinstance(value, Text):
        return value.get(language)
    if isinstance(value, Span):
        return {"file": value.file, "line": value.line, "column": value.column}
    if is_dataclass(value) and not isinstance(value, type):
        return {item.name: plain(getattr(value, item.name), language) for item in fields(value)}
    if isinstance(value, Mapping):
        return {str(key): plain(item, language) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [plain(item, language) for item in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value if isinstance(value, bool | int | float | str | None) else str(value)


def run_document(run: Run, language: Language, **further: object) -> dict[str, object]:
    """Return the document of a run, with ``further`` results before the diagnostics."""
    results = {name: plain(getattr(run, name), language) for name in _RESULT_FIELDS}
    return {
        "nctakt": __version__,
        **{name: plain(getattr(run, name), language) for name in _RUN_FIELDS},
        "time_us": run.virtual_time_us,
        **results,
        **{name: plain(value, language) for name, value in further.items()},
        "diagnostics": diagnostics_as_json(run.diagnostics, "", language),
    }


def as_json(document: Mapping[str, object]) -> str:
    """Return the text of a document with a final line end."""
    return json.dumps(document, indent=2) + "\n"
