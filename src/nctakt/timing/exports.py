# SPDX-License-Identifier: MIT
"""Where the time went, as files for other tools: CSV, and speedscope for a flame graph."""

from __future__ import annotations

import csv
import io
import json

from nctakt.base.diagnostics import Language
from nctakt.base.version import __version__
from nctakt.timing.entries import Purpose, TimeAccount
from nctakt.timing.words import KINDS, PHASES, limit_text

_SCHEMA = "https://www.speedscope.app/file-format-schema.json"

CSV_HEADS = (
    "channel",
    "program",
    "file",
    "line",
    "block",
    "tool",
    "kind",
    "phase",
    "cause",
    "detail",
    "ticks",
    "time_us",
)


def as_csv(account: TimeAccount, language: Language) -> str:
    """Return a line for each purpose, in the order in which they first appear."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(CSV_HEADS)
    for one, ticks in account.by(lambda purpose: purpose).items():
        span = one.span
        location = ("", "") if span is None else (span.file, span.line)
        writer.writerow(
            (
                one.channel,
                " > ".join(one.calls),
                *location,
                one.number or "",
                one.tool or "",
                one.kind,
                one.phase,
                one.limit.cause,
                one.limit.detail.get(language),
                ticks,
                account.us(ticks),
            )
        )
    return text.getvalue()


def as_speedscope(account: TimeAccount, language: Language) -> str:
    """Return a profile for each channel: programs, block, kind, cause, from the outside inwards."""
    frames: list[dict[str, object]] = []
    numbers: dict[tuple[str, str, int], int] = {}

    def frame(name: str, file: str = "", line: int = 0) -> int:
        key = name, file, line
        if key not in numbers:
            numbers[key] = len(frames)
            location = {"file": file, "line": line} if file else {}
            frames.append({"name": name, **location})
        return numbers[key]

    def stack(one: Purpose) -> list[int]:
        found = [frame(name) for name in one.calls]
        if one.span is not None:
            text = f"{one.span.line}: {account.lines[one.span]}"
            found.append(frame(text, one.span.file, one.span.line))
        words = [KINDS[one.kind].get(language)]
        if one.phase != "standing":
            words.append(PHASES[one.phase].get(language))
        found.append(frame(", ".join(words)))
        cause = limit_text(one.limit, language)
        return [*found, frame(cause)] if cause else found

    profiles = []
    for channel in range(1, account.channels + 1):
        own = [one for one in account.stretches if one.purpose.channel == channel]
        profiles.append(
            {
                "type": "sampled",
                "name": f"CH{channel}",
                "unit": "microseconds",
                "startValue": 0,
                "endValue": account.run.virtual_time_us,
                "samples": [stack(one.purpose) for one in own],
                "weights": [account.us(one.ticks) for one in own],
            }
        )
    document = {
        "$schema": _SCHEMA,
        "exporter": f"nctakt {__version__}",
        "name": ", ".join(account.run.programs),
        "shared": {"frames": frames},
        "profiles": profiles,
    }
    return json.dumps(document, ensure_ascii=False) + "\n"
