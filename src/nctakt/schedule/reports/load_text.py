# SPDX-License-Identifier: MIT
"""Learnt execution times as the text of a load file.

In: ``LearntTimes``, the model they belong to, how they are to be written. Out: TOML in µs that
``load`` reads; after each entry the number of calls and their mean.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Literal

from nctakt.schedule.analysis.findings import us
from nctakt.schedule.learn import LearntTimes
from nctakt.schedule.model import Model
from nctakt.schedule.reports.report import rounded_mean

#: The range of the times, all of them in turn, or the longest one.
TimesForm = Literal["uniform", "list", "longest"]
#: If there are more times than this, only the first are written.
MAX_LISTED = 1000


def load_text(model: Model, learnt: LearntTimes, form: TimesForm, source: str) -> str:
    """Return the load file; ``source``: the name of the recording."""
    lines = [f"# Learnt from {json.dumps(source, ensure_ascii=False)}, in microseconds"]
    if learnt.calls:
        lines += ["", "[functions]"]
    callers: dict[str, list[int]] = {}
    for i, name in learnt.calls:
        callers.setdefault(name, []).append(i)
    for (i, name), times in learnt.calls.items():
        key = name
        if len(callers[name]) > 1:
            # Several threads call it: each of them has its own times.
            key = _entry(model, i, name)
        lines.append(_line(key, times, form))
    for name, times in learnt.external.items():
        lines += ["", f"[external.{_key(name)}]", _line("time", times, form)]
    return "\n".join(lines) + "\n"


def _entry(model: Model, i: int, name: str) -> str:
    call = next(call for call in model.tasks[i].calls if call.function == name)
    return f"{model.tasks[i].key}.function[{call.index}]"


def _line(key: str, times: Sequence[int], form: TimesForm) -> str:
    mean = us(rounded_mean(sum(times), len(times)))
    return f"{_key(key)} = {_value(times, form)} # calls: {len(times)}, mean {mean}"


def _value(times: Sequence[int], form: TimesForm) -> str:
    minimum, longest = min(times), max(times)
    if minimum == longest or form == "longest":
        return us(longest)
    if form == "uniform":
        return f"{{ uniform = [{us(minimum)}, {us(longest)}] }}"
    return f"[{', '.join(us(time) for time in times[:MAX_LISTED])}]"


def _key(name: str) -> str:
    """Return a key of TOML, in quotation marks where it must be."""
    is_bare = name.isascii() and name.replace("_", "").replace("-", "").isalnum()
    return name if is_bare else json.dumps(name, ensure_ascii=False)
