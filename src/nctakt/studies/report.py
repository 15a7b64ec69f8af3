# SPDX-License-Identifier: MIT
"""The report of a study: one HTML page with its pictures, without network and without scripts.

In: a plan and its rows. Out: the page: verdicts, a histogram of each measure, each measure over
each input, heat maps over pairs of inputs, the strip of an each-tick study, sensitivities, the
broken runs.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from html import escape
from typing import Any

from nctakt.base.version import __version__
from nctakt.studies import charts
from nctakt.studies.bench import HELD, REACTION, Row
from nctakt.studies.measures import as_text
from nctakt.studies.plan import Plan

#: Broken runs in the table of the report, pictures of one kind.
MAX_ROWS, MAX_PICTURES = 200, 24

#: Runs from which on sensitivities are estimated.
MIN_RUNS = 20

_STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; color: #1d2733; max-width: 1320px; margin: 2em auto;
  padding: 0 1em }
h1 { font-size: 1.5em } h2 { font-size: 1.15em; margin-top: 2em }
.charts { display: flex; flex-wrap: wrap; gap: 14px }
figure { margin: 0; padding: 8px; border: 1px solid #d8dee6; border-radius: 6px }
figcaption { font-size: 13px; color: #52606d }
svg text { font: 11px system-ui, sans-serif; fill: #333 }
table { border-collapse: collapse; font-size: 13px } td, th { padding: 3px 10px; text-align: left;
  border-bottom: 1px solid #e3e8ee } .broken { color: #c0392b } .held { color: #2f6f9f }
"""


def report(plan: Plan, rows: Sequence[Row]) -> str:
    """Return the page."""
    title = f"Study of {plan.program.name}"
    parts = [f"<h1>{escape(title)}</h1>", _verdicts(plan, rows)]
    for heading, pictures in (
        ("Each tick", _strips(plan, rows)),
        ("Measures", _histograms(plan, rows)),
        ("Measures over inputs", _scatters(plan, rows)),
        ("Pairs of inputs", _heat_maps(plan, rows)),
        ("Sensitivities", _tornadoes(plan, rows)),
    ):
        shown = list(itertools.islice(pictures, MAX_PICTURES))
        if shown:
            parts.append(f'<h2>{heading}</h2><div class="charts">{"".join(shown)}</div>')
    parts.append(_broken(plan, rows))
    return (
        f'<!doctype html><html lang="en"><head><meta charset="utf-8"><title>{escape(title)}</title>'
        f"<style>{_STYLE}</style></head><body>{''.join(parts)}"
        f"<p><small>nctakt {__version__}</small></p></body></html>\n"
    )


def _figure(picture: str, caption: str) -> str:
    return f"<figure>{picture}<figcaption>{escape(caption)}</figcaption></figure>"


def _verdicts(plan: Plan, rows: Sequence[Row]) -> str:
    held = sum(row["verdict"] == HELD for row in rows)
    expected = "".join(f"<li>{escape(one.text)}</li>" for one in plan.expectations)
    return (
        f'<p>{len(rows)} runs: <span class="held">{held} held</span>, '
        f'<span class="broken">{len(rows) - held} did not</span>.</p><ul>{expected}</ul>'
    )


def _names(plan: Plan, rows: Sequence[Row]) -> list[str]:
    """Return the measures, and the reaction time where there is one."""
    names = [measure.name for measure in plan.measures]
    return [*names, REACTION] if rows and REACTION in rows[0] else names


def _numbers(rows: Sequence[Row], *names: str) -> list[Row]:
    """Return the rows in which all these columns are finite numbers."""
    return [row for row in rows if all(_is_number(row.get(name)) for name in names)]


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and math.isfinite(value)


def _column(rows: Sequence[Row], name: str) -> list[float]:
    return [float(row[name] or 0.0) for row in rows]


def _held(rows: Sequence[Row]) -> list[bool]:
    return [row["verdict"] == HELD for row in rows]


def _strips(plan: Plan, rows: Sequence[Row]) -> Iterator[str]:
    for dimension in plan.dimensions:
        if dimension.is_each_tick and rows:
            name = f"{dimension.name} in s"
            picture = charts.strip(_column(rows, dimension.name), _held(rows), name)
            yield _figure(picture, "red: the expectations did not hold for an injection then")


def _histograms(plan: Plan, rows: Sequence[Row]) -> Iterator[str]:
    for name in _names(plan, rows):
        own = _numbers(rows, name)
        if own:
            missing = len(rows) - len(own)
            caption = f"{name}: {len(own)} runs" + (f", {missing} without" if missing else "")
            yield _figure(charts.histogram(_column(own, name), name), caption)


def _scatters(plan: Plan, rows: Sequence[Row]) -> Iterator[str]:
    for measure, dimension in itertools.product(_names(plan, rows), plan.dimensions):
        names = (dimension.name, measure)
        own = _numbers(rows, *names)
        if own:
            x, y = (_column(own, name) for name in names)
            yield _figure(charts.scatter(x, y, _held(own), names), f"{measure} over {names[0]}")


def _heat_maps(plan: Plan, rows: Sequence[Row]) -> Iterator[str]:
    pairs = itertools.combinations(plan.dimensions, 2)
    for (first, second), measure in itertools.product(list(pairs), _names(plan, rows)):
        names = (first.name, second.name, measure)
        own = _numbers(rows, *names)
        if own:
            x, y, values = (_column(own, name) for name in names)
            caption = f"mean of {measure} over {first.name} and {second.name}"
            yield _figure(charts.heat_map(x, y, values, names), caption)


def _tornadoes(plan: Plan, rows: Sequence[Row]) -> Iterator[str]:
    for measure in _names(plan, rows):
        names = [one.name for one in plan.dimensions]
        own = _numbers(rows, measure, *names)
        values = _column(own, measure)
        if len(own) < MIN_RUNS or min(values) == max(values):
            continue
        varied = [name for name in names if len(dict.fromkeys(_column(own, name))) > 1]
        shares, method = sensitivities([_column(own, name) for name in varied], values)
        picture = charts.bars(list(zip(varied, shares, strict=True)), method)
        yield _figure(picture, f"how much {measure} depends on each input")


def sensitivities(
    inputs: Sequence[Sequence[float]], values: Sequence[float]
) -> tuple[list[float], str]:
    """Return how much a measure depends on each input, 0 … 1, and the name of the method.

    By SALib the median of PAWN's distances of distributions; without SALib the amount of the rank
    correlation, which sees rising and falling dependence only.
    """
    try:
        import numpy  # noqa: PLC0415 - as SALib
        from SALib.analyze import pawn  # noqa: PLC0415 - an extra
    except ImportError:
        return [abs(_rank_correlation(own, values)) for own in inputs], "rank correlation"
    problem: dict[str, Any] = {
        "num_vars": len(inputs),
        "names": [str(number) for number in range(len(inputs))],
        "bounds": [[min(own), max(own)] for own in inputs],
    }
    with numpy.errstate(all="ignore"):
        found = pawn.analyze(problem, numpy.array(inputs).T, numpy.array(values), S=10, seed=0)
    shares = [float(share) for share in found["median"]]
    return [share if math.isfinite(share) else 0.0 for share in shares], "PAWN, median"


def _rank_correlation(x: Sequence[float], y: Sequence[float]) -> float:
    """Return Spearman's coefficient; equal values share their mean rank."""
    a, b = _ranks(x), _ranks(y)
    mean = (len(a) - 1) / 2
    covered = sum((p - mean) * (q - mean) for p, q in zip(a, b, strict=True))
    spread = sum((p - mean) ** 2 for p in a) * sum((q - mean) ** 2 for q in b)
    return covered / math.sqrt(spread) if spread else 0.0


def _ranks(values: Sequence[float]) -> list[float]:
    order = sorted(range(len(values)), key=lambda index: values[index])
    ranks = [0.0] * len(values)
    for _, group in itertools.groupby(enumerate(order), key=lambda item: values[item[1]]):
        own = list(group)
        for _, index in own:
            ranks[index] = sum(position for position, _ in own) / len(own)
    return ranks


def _broken(plan: Plan, rows: Sequence[Row]) -> str:
    """Return the table of the runs that did not hold."""
    own = [row for row in rows if row["verdict"] != HELD]
    if not own:
        return ""
    names = ["run", *(one.name for one in plan.dimensions), *_names(plan, rows), "broken"]
    head = "".join(f"<th>{escape(name)}</th>" for name in names)
    lines = "".join(
        "<tr>" + "".join(f"<td>{escape(as_text(row.get(name)))}</td>" for name in names) + "</tr>"
        for row in own[:MAX_ROWS]
    )
    rest = f"<p>… and {len(own) - MAX_ROWS} more</p>" if len(own) > MAX_ROWS else ""
    return f"<h2>Runs that did not hold</h2><table><tr>{head}</tr>{lines}</table>{rest}"
