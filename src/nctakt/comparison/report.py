# SPDX-License-Identifier: MIT
"""A comparison as text and as data."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from nctakt.base.diagnostics import Language, Span, Text
from nctakt.comparison.aligning_event import EventInLog
from nctakt.comparison.alignment import Alignment
from nctakt.comparison.comparison import Comparison, Running
from nctakt.comparison.deviations import Change, Deviation
from nctakt.results.summary import Table, plain_table

_HEADS = (
    Text("signal", "Signal"),
    Text("in the log", "im Log"),
    Text("samples", "Werte"),
    Text("greatest", "größte"),
    Text("at", "bei"),
    Text("mean", "Mittel"),
    Text("RMS", "RMS"),
    Text("99 %", "99 %"),
)
_TITLE = Text("{program} and {log}: log minus run", "{program} und {log}: Log minus Lauf")
_FOUND = Text(
    "the run begins {offset} s after the log's zero, {drift} (by {names}, correlation {quality})",
    "der Lauf beginnt {offset} s nach dem Nullpunkt des Logs, {drift} (über {names}, Korrelation "
    "{quality})",
)
_GIVEN = Text(
    "the run begins {offset} s after the log's zero, as given; {drift}",
    "der Lauf beginnt {offset} s nach dem Nullpunkt des Logs, wie angegeben; {drift}",
)
_BY_EVENT = Text(
    "the run begins {offset} s after the log's zero "
    "(by {event}: {time} s in the log, ± {apart} ms); {drift}",
    "der Lauf beginnt {offset} s nach dem Nullpunkt des Logs (über {event}: {time} s im "
    "Log, ± {apart} ms); {drift}",
)
_DRIFT = Text("drift {drift} ppm", "Drift {drift} ppm")
_DRIFT_GIVEN = Text("drift {drift} ppm as given", "Drift {drift} ppm wie angegeben")
_GAIN = Text(
    "the log is {gain} times the run, {bias} beside it",
    "das Log ist {gain}-mal der Lauf, um {bias} versetzt",
)
_OR_SLOWER = Text(
    "or slower than it: at a constant speed there is no way to tell",
    "oder langsamer als er: bei konstanter Geschwindigkeit ist das nicht zu unterscheiden",
)
_LEAVES = Text(
    "{signal} leaves its tolerance first at {time} s, with {count} of {samples} samples beyond",
    "{signal} verlässt seine Toleranz zuerst bei {time} s, {count} von {samples} Werten liegen "
    "außerhalb",
)
_FARTHEST = Text("{signal} deviates most at {time} s", "{signal} weicht bei {time} s am meisten ab")
_AT_BLOCK = Text("block in {file}:{line}", "Satz in {file}:{line}")
_REACTION = Text("{event} {since} ms before", "{event} {since} ms davor")
_LATER = Text(
    "from the block in {file}:{line} on ({time} s) the log is {jump} ms later than before",
    "vom Satz in {file}:{line} an ({time} s) ist das Log {jump} ms später als davor",
)
_EARLIER = Text(
    "from the block in {file}:{line} on ({time} s) the log is {jump} ms earlier than before",
    "vom Satz in {file}:{line} an ({time} s) ist das Log {jump} ms früher als davor",
)
_LATE = Text(
    "from the block in {file}:{line} on ({time} s) the log is late or early; by how much, and what "
    "comes after, the curves do not say",
    "vom Satz in {file}:{line} an ({time} s) ist die Aufzeichnung später oder früher; um wie viel "
    "und was danach kommt, sagen die Kurven nicht",
)
_MORE = Text(
    "later delays are not listed",
    "spätere Verzögerungen sind nicht aufgeführt",
)
_SUGGESTED = Text("suggested by its name", "nach dem Namen vorgeschlagen")
_CHANGES = {
    True: Text("the run becomes {value} there, the log", "dort wird der Lauf {value}, das Log"),
    False: Text("the log becomes {value} there, the run", "dort wird das Log {value}, der Lauf"),
}
_AFTERWARDS = Text("{later} ms later", "{later} ms später")
_NEVER = Text("never does afterwards", "danach nie")
_NOT_COMPARED = Text(
    "columns of the log without a signal: {columns}",
    "Spalten des Logs ohne Signal: {columns}",
)
#: Columns without a signal that are named.
_NAMED = 10
_WITHIN = Text("within the tolerances", "innerhalb der Toleranzen")
_BEYOND = Text("beyond the tolerances", "außerhalb der Toleranzen")


def comparison_text(comparison: Comparison, program: str, language: Language) -> str:
    """Return the comparison as text."""
    rows = tuple(_row(one, language) for one in comparison.deviations)
    heads = tuple(head.get(language) for head in _HEADS)
    title = _TITLE.get(language).format(program=program, log=comparison.log.file)
    lines = [title, *_alignment(comparison, language), "", *plain_table(Table(heads, rows)), ""]
    for one in comparison.deviations:
        lines += _remarks(comparison, one, language)
    lines += _delays(comparison, language)
    if any(one.pair.is_suggested for one in comparison.deviations):
        lines.append(f"* {_SUGGESTED.get(language)}")
    columns = not_compared(comparison)
    if columns:
        more = f" … ({len(columns)})" if len(columns) > _NAMED else ""
        named = ", ".join(columns[:_NAMED]) + more
        lines.append(_NOT_COMPARED.get(language).format(columns=named))
    lines.append((_WITHIN if comparison.is_within else _BEYOND).get(language))
    return "\n".join(lines) + "\n"


def _alignment(comparison: Comparison, language: Language) -> Iterator[str]:
    found = comparison.alignment
    offset = f"{found.offset_us / 1e6:z.6f}"
    words = _DRIFT if comparison.given.drift is None else _DRIFT_GIVEN
    drift = words.get(language).format(drift=f"{found.drift * 1e6:.2f}")
    event = comparison.given.event
    if event is not None:
        yield _BY_EVENT.get(language).format(
            offset=offset,
            event=event.event.text,
            time=f"{event.time_us / 1e6:.6f}",
            apart=f"{event.apart_us / 1e3:g}",
            drift=drift,
        )
    elif not comparison.aligned_by:
        yield _GIVEN.get(language).format(offset=offset, drift=drift)
    elif found.reason is None:
        yield _FOUND.get(language).format(
            offset=offset,
            drift=drift,
            names=comparison.aligned_by,
            quality=f"{found.quality:.3f}",
        )
        if found.is_scaled:
            scale = _GAIN.get(language).format(gain=f"{found.gain:.5f}", bias=f"{found.bias:.4g}")
            yield f"{scale}, {_OR_SLOWER.get(language)}" if comparison.delays.found else scale


def _row(one: Deviation, language: Language) -> tuple[str, ...]:
    unit = one.pair.signal.unit
    mark = "*" if one.pair.is_suggested else ""
    return (
        one.pair.signal.name,
        f"{one.pair.column.name}{mark}",
        str(one.samples),
        f"{one.greatest:.4g} {unit}".rstrip(),
        f"{one.greatest_us / 1e6:.6f} s",
        f"{one.mean:.3g}",
        f"{one.rms:.3g}",
        f"{one.percentile:.3g}",
    )


def _remarks(comparison: Comparison, one: Deviation, language: Language) -> Iterator[str]:
    if one.first_us is not None:
        yield _LEAVES.get(language).format(
            signal=one.pair.signal.name,
            time=f"{one.first_us / 1e6:.6f}",
            count=one.beyond,
            samples=one.samples,
        )
        yield from _where(comparison.running_at(one.first_us), language)
        yield from _changes(one, language)
    elif one.greatest:
        yield _FARTHEST.get(language).format(
            signal=one.pair.signal.name, time=f"{one.greatest_us / 1e6:.6f}"
        )
        yield from _where(comparison.running_at(one.greatest_us), language)
        yield from _changes(one, language)


def _changes(one: Deviation, language: Language) -> Iterator[str]:
    if one.change is not None:
        later_us = one.change.later_us
        when = _NEVER if later_us is None else _AFTERWARDS
        change = _CHANGES[one.change.is_run].get(language).format(value=f"{one.change.value:g}")
        yield f"  {change} {when.get(language).format(later=f'{(later_us or 0.0) / 1e3:g}')}"


def _delays(comparison: Comparison, language: Language) -> Iterator[str]:
    for one in comparison.delays.found:
        if one.block is not None:
            jump_us = one.jump_us
            text = _LATE if jump_us is None else _LATER if jump_us > 0.0 else _EARLIER
            yield text.get(language).format(
                file=one.block.file,
                line=one.block.line,
                time=f"{one.time_us / 1e6:.6f}",
                jump=f"{abs(jump_us or 0.0) / 1e3:.2f}",
            )
    if comparison.delays.is_cut:
        yield _MORE.get(language)


def _where(running: Running, language: Language) -> Iterator[str]:
    if running.block is not None:
        yield "  " + _AT_BLOCK.get(language).format(
            file=running.block.file, line=running.block.line
        )
    if running.reaction is not None:
        since = (running.time_us - running.reaction.time_us) / 1000.0
        yield "  " + _REACTION.get(language).format(event=running.reaction, since=f"{since:g}")


def not_compared(comparison: Comparison) -> list[str]:
    """Return the names of the columns of the log that belong to no signal, each once."""
    compared = {one.name for one in comparison.compared}
    return list(
        dict.fromkeys(one.name for one in comparison.log.columns if one.name not in compared)
    )


def comparison_document(comparison: Comparison) -> dict[str, Any]:
    """Return the comparison as data."""
    return {
        "log": comparison.log.file,
        "within": comparison.is_within,
        "alignment": _alignment_document(comparison.alignment),
        "event": _event_document(comparison.given.event),
        "signals": [_document(comparison, one) for one in comparison.deviations],
        "delays": [
            {
                "block": _span(one.block),
                "time_us": one.time_us,
                "jump_us": one.jump_us,
            }
            for one in comparison.delays.found
        ],
        "delays_cut": comparison.delays.is_cut,
        "not_compared": not_compared(comparison),
    }


def _alignment_document(found: Alignment) -> dict[str, Any]:
    return {
        "offset_us": found.offset_us,
        "drift": found.drift,
        "quality": found.quality,
        "gain": found.gain,
        "bias": found.bias,
        "is_known": found.reason is None,
    }


def _document(comparison: Comparison, one: Deviation) -> dict[str, Any]:
    at = one.greatest_us if one.first_us is None else one.first_us
    running = comparison.running_at(at)
    return {
        "signal": one.pair.signal.name,
        "column": one.pair.column.name,
        "unit": one.pair.signal.unit,
        "suggested": one.pair.is_suggested,
        "samples": one.samples,
        "greatest": one.greatest,
        "greatest_us": one.greatest_us,
        "mean": one.mean,
        "rms": one.rms,
        "percentile_99": one.percentile,
        "first_us": one.first_us,
        "beyond": one.beyond,
        "block": _span(running.block),
        "reaction": None if running.reaction is None else str(running.reaction),
        "change": _change_document(one.change),
    }


def _change_document(change: Change | None) -> dict[str, Any] | None:
    if change is None:
        return None
    side = "run" if change.is_run else "log"
    return {"side": side, "value": change.value, "later_us": change.later_us}


def _event_document(event: EventInLog | None) -> dict[str, Any] | None:
    if event is None:
        return None
    return {"text": event.event.text, "log_us": event.time_us, "apart_us": event.apart_us}


def _span(span: Span | None) -> dict[str, Any] | None:
    return None if span is None else {"file": span.file, "line": span.line}
