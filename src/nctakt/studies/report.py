# SPDX-License-Identifier: MIT
"""The report of a study: one HTML page with its pictures, without network and without scripts.

In: a plan and its rows. Out: the page in English or German: verdicts, a histogram of each measure,
each measure over each input, heat maps over pairs of inputs, the strip of an each-tick study,
sensitivities, the failed runs with the commands that show them.
"""

from __future__ import annotations

import base64
import itertools
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from html import escape
from typing import Any

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Language
from nctakt.base.version import __version__
from nctakt.messages import diagnostic
from nctakt.messages.commands.studies import DIMENSION_WITHOUT_EFFECT, NO_EFFECT_SHOWN
from nctakt.studies import charts
from nctakt.studies.measuring.measures import as_text
from nctakt.studies.plans.plan import Plan
from nctakt.studies.plans.units import REACTION
from nctakt.studies.plans.verdicts import limits_of, share_text
from nctakt.studies.runs.each_tick import Nominal
from nctakt.studies.runs.effects import without_effect
from nctakt.studies.runs.study_runner import PASSED, Row

#: Failed runs in the table of the report, pictures of one kind.
MAX_ROWS, MAX_PICTURES = 200, 24

#: Runs of which the page has a picture each.
MAX_DRAWN_RUNS = 6

#: The same in a notebook.
MAX_SHOWN_ROWS, MAX_SHOWN_PICTURES = 10, 6

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
  border-bottom: 1px solid #e3e8ee } .failed { color: #c0392b } code { font-size: 12px }
.passed { color: #2f6f9f } img { max-width: 600px }
"""


#: Maximum number of runs used for pictures; if there are more, an even selection.
MAX_RUNS = 100_000

_TEXTS = {
    "en": {
        "title": "Study of {}", "each_tick": "Each tick", "measures": "Measures",
        "scatters": "Measures over inputs", "pairs": "Pairs of inputs",
        "sensitivities": "Sensitivities", "runs": "runs",
        "passed": "{} passed", "failed": "{} failed",
        "in_unit": "{} in {}",
        "strip": "red: the run with an injection then failed; above: lines",
        "without": "{} without", "over": "{} over {}", "mean": "mean of {} over {} and {}",
        "depends": "how much {} depends on each input", "table": "Failed runs",
        "more": "… and {} more", "sample": "Pictures of {} of the runs, evenly spread.",
        "run": "run", "reason": "not met", "command": "shown by",
        "verdict_map": "passed (blue) and failed (red) over {} and {}",
        "verdict_maps": "Passed and failed over two inputs",
        "no_pictures": "No pictures of runs: the extra plot is not installed.",
        "extremes": "Least and greatest values", "least": "least {}", "greatest": "greatest {}",
        "which": "which", "verdict": "verdict", "plan": "Plan",
        "PAWN, median": "PAWN, median", "rank correlation": "rank correlation",
    },
    "de": {
        "title": "Studie von {}", "each_tick": "Jeder Takt", "measures": "Messgrößen",
        "scatters": "Messgrößen über Eingängen", "pairs": "Paare von Eingängen",
        "sensitivities": "Empfindlichkeiten", "runs": "Läufe", "passed": "{} bestanden",
        "failed": "{} nicht bestanden",
        "strip": "rot: der Lauf mit einem Eingriff dann nicht bestanden; darüber: Zeilen",
        "in_unit": "{} in {}", "without": "{} ohne", "over": "{} über {}",
        "mean": "Mittelwert von {} über {} und {}",
        "depends": "wie stark {} von jedem Eingang abhängt", "table": "Nicht bestandene Läufe",
        "more": "… und {} weitere", "sample": "Bilder aus {} der Läufe, gleichmäßig verteilt.",
        "run": "Lauf", "reason": "nicht erfüllt", "command": "zu sehen mit",
        "verdict_map": "bestanden (blau) und nicht (rot) über {} und {}",
        "verdict_maps": "Bestanden und nicht bestanden über zwei Eingängen",
        "no_pictures": "Keine Bilder von Läufen: das Extra plot ist nicht installiert.",
        "extremes": "Kleinste und größte Werte", "least": "kleinstes {}",
        "greatest": "größtes {}", "which": "welches", "verdict": "Urteil", "plan": "Plan",
        "PAWN, median": "PAWN, Median", "rank correlation": "Rangkorrelation",
    },
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class ShownRuns:
    """What a page says of single runs, by their numbers.

    ``command`` shows a run; ``picture`` returns a PNG file, ``None`` if there can be none;
    ``repeated``: dimensions of which another value changed nothing in so many repeated runs.
    """

    command: Callable[[int], str] | None = None
    picture: Callable[[int], bytes | None] | None = None
    repeated: Sequence[tuple[str, int]] = ()


def report(
    plan: Plan,
    rows: Sequence[Row],
    units: Mapping[str, str],
    language: Language,
    shown: ShownRuns,
    nominal: Nominal | None,
) -> str:
    """Return the page; ``units``: those of the columns; ``shown``: what it says of single runs.

    ``nominal``: the unchanged run of an each-tick study, whose blocks the strip has.
    """
    return _Report(plan, rows, units, language, nominal).page(shown)


def extreme_runs(plan: Plan, rows: Sequence[Row]) -> list[int]:
    """Return the runs with the least and the greatest value of each measure, each once."""
    found = _Report(plan, rows, {}, "en", None).extremes()
    return list(dict.fromkeys(int(row["run"] or 0) for _, row in found))


def shown_result(
    plan: Plan, rows: Sequence[Row], units: Mapping[str, str], nominal: Nominal | None = None
) -> str:
    """Return a short report as part of a page: a notebook shows it for a result."""
    return _Report(plan, rows, units, "en", nominal).part()


def _figure(picture: str, caption: str) -> str:
    return f"<figure>{picture}<figcaption>{escape(caption)}</figcaption></figure>"


class _Report:
    """Makes the parts of a page; few of many rows are in memory."""

    def __init__(
        self,
        plan: Plan,
        rows: Sequence[Row],
        units: Mapping[str, str],
        language: Language,
        nominal: Nominal | None,
    ) -> None:
        self._plan = plan
        self._units = units
        self._blocks: list[tuple[float, str]] = []
        if nominal is not None:
            length_us = nominal.cycle_time_us
            self._blocks = [(tick * length_us / 1e6, str(line)) for tick, line, _ in nominal.blocks]
        self._dead = without_effect(plan, rows)
        self._texts = _TEXTS[language]
        self._language = language
        self._count = len(rows)
        self._held = 0
        self._broken: list[Row] = []
        self._rows: list[Row] = []
        names = [measure.name for measure in plan.measures]
        extremes: dict[tuple[str, str], Row] = {}
        step = -(-len(rows) // MAX_RUNS)
        for number, row in enumerate(rows):
            _note_extremes(extremes, (*names, REACTION), row)
            is_held = row["verdict"] == PASSED
            self._held += is_held
            if not is_held and len(self._broken) < MAX_ROWS:
                self._broken.append(row)
            if number % step == 0:
                self._rows.append(row)
        self._extreme_rows = extremes
        has_reaction = self._rows and REACTION in self._rows[0]
        self._names = [*names, REACTION] if has_reaction else names

    def _text(self, key: str, *words: object) -> str:
        return self._texts[key].format(*words)

    def page(self, shown: ShownRuns) -> str:
        """Return the page."""
        title = self._text("title", self._plan.program.name)
        parts = [f"<h1>{escape(title)}</h1>", self._verdicts(shown.repeated)]
        for key, pictures in (
            ("each_tick", self._strips()),
            ("measures", self._histograms()),
            ("scatters", self._scatters()),
            ("verdict_maps", self._verdict_maps()),
            ("pairs", self._heat_maps()),
            ("sensitivities", self._tornadoes()),
        ):
            drawn = list(itertools.islice(pictures, MAX_PICTURES))
            if drawn:
                heading = self._text(key)
                parts.append(f'<h2>{heading}</h2><div class="charts">{"".join(drawn)}</div>')
        parts += [self._extremes(shown), self._table(shown.command), self._source()]
        head = f'<meta charset="utf-8"><title>{escape(title)}</title><style>{_STYLE}</style>'
        return (
            f'<!doctype html><html lang="{self._language}"><head>{head}</head>'
            f"<body>{''.join(parts)}<p><small>nctakt {__version__}</small></p></body></html>\n"
        )

    def part(self) -> str:
        """Return verdicts, the first pictures and rows, without the style of a page."""
        pictures = itertools.islice(self._histograms(), MAX_SHOWN_PICTURES)
        del self._broken[MAX_SHOWN_ROWS:]
        charts_ = f'<div style="display: flex; flex-wrap: wrap">{"".join(pictures)}</div>'
        return self._verdicts() + charts_ + self._extremes(ShownRuns()) + self._table(None)

    def _verdicts(self, repeated: Sequence[tuple[str, int]] = ()) -> str:
        expected = "".join(f"<li>{escape(one.text)}</li>" for one in self._plan.expectations)
        held = self._text("passed", self._held)
        if self._count:
            held += f", {share_text(self._held, self._count)}"
        broken = self._text("failed", self._count - self._held)
        dead = [diagnostic(DIMENSION_WITHOUT_EFFECT, name=name) for name in self._dead]
        dead += [diagnostic(NO_EFFECT_SHOWN, name=name, count=count) for name, count in repeated]
        warnings = "".join(f"<p>{escape(one.text(self._language))}</p>" for one in dead)
        rest = ""
        if len(self._rows) < self._count:
            rest = f"<p>{self._text('sample', len(self._rows))}</p>"
        return (
            f"<p>{self._count} {self._text('runs')}: "
            f'<span class="passed">{held}</span>, <span class="failed">{broken}</span>.</p>'
            f"<ul>{expected}</ul>{rest}{warnings}"
        )

    def _source(self) -> str:
        """Return the text of the plan's file."""
        if not self._plan.source:
            return ""
        return f"<h2>{self._text('plan')}</h2><pre>{escape(self._plan.source)}</pre>"

    def _numbers(self, *names: str) -> list[Row]:
        """Return the rows in which all these columns are finite numbers."""
        return [row for row in self._rows if all(_is_number(row.get(name)) for name in names)]

    def _strips(self) -> Iterator[str]:
        for dimension in self._plan.dimensions:
            rows = self._numbers(dimension.name)
            if dimension.is_each_tick and rows:
                name = self._label(dimension.name)
                picture = charts.strip(
                    _column(rows, dimension.name), _held(rows), name, self._blocks
                )
                yield _figure(picture, self._text("strip"))

    def _histograms(self) -> Iterator[str]:
        for name in self._names:
            rows = self._numbers(name)
            if rows:
                missing = len(self._rows) - len(rows)
                caption = f"{name}: {len(rows)} {self._text('runs')}"
                caption += f", {self._text('without', missing)}" if missing else ""
                limits = limits_of(self._plan, name)
                values = _column(rows, name)
                picture = charts.histogram(values, self._label(name), self._text("runs"), limits)
                yield _figure(picture, caption)

    def _scatters(self) -> Iterator[str]:
        for measure, dimension in itertools.product(self._names, self._plan.dimensions):
            names = (dimension.name, measure)
            rows = self._numbers(*names)
            if rows:
                x, y = (_column(rows, name) for name in names)
                caption = self._text("over", measure, names[0])
                labels = (self._label(dimension.name), self._label(measure))
                yield _figure(charts.scatter(x, y, _held(rows), labels), caption)

    def _label(self, name: str) -> str:
        """Return the name of a column with its unit."""
        unit = self._units.get(name)
        return name if unit is None else self._text("in_unit", name, unit)

    def _verdict_maps(self) -> Iterator[str]:
        for first, second in itertools.combinations(self._plan.dimensions, 2):
            rows = self._numbers(first.name, second.name)
            if rows and self._plan.expectations:
                x, y = (_column(rows, one.name) for one in (first, second))
                names = (self._label(first.name), self._label(second.name))
                caption = self._text("verdict_map", first.name, second.name)
                yield _figure(charts.verdict_map(x, y, _held(rows), names), caption)

    def _heat_maps(self) -> Iterator[str]:
        pairs = list(itertools.combinations(self._plan.dimensions, 2))
        for (first, second), measure in itertools.product(pairs, self._names):
            names = (first.name, second.name, measure)
            rows = self._numbers(*names)
            if rows:
                x, y, values = (_column(rows, name) for name in names)
                caption = self._text("mean", measure, first.name, second.name)
                labels = (self._label(names[0]), self._label(names[1]), self._label(measure))
                yield _figure(charts.heat_map(x, y, values, labels), caption)

    def _tornadoes(self) -> Iterator[str]:
        for measure in self._names:
            names = [one.name for one in self._plan.dimensions]
            rows = self._numbers(measure, *names)
            values = _column(rows, measure)
            if len(rows) < MIN_RUNS or min(values) == max(values):
                continue
            varied = [name for name in names if len(dict.fromkeys(_column(rows, name))) > 1]
            shares, method = sensitivities([_column(rows, name) for name in varied], values)
            pairs = list(zip(varied, shares, strict=True))
            picture = charts.bars(pairs, self._text(method))
            yield _figure(picture, self._text("depends", measure))

    def extremes(self) -> list[tuple[str, Row]]:
        """Return the runs with the least and the greatest value of each measure, with words."""
        return [
            (self._text(key, name), self._extreme_rows[key, name])
            for name in self._names
            for key in ("least", "greatest")
            if (key, name) in self._extreme_rows
        ]

    def _extremes(self, shown: ShownRuns) -> str:
        """Return the table of these runs, and their pictures."""
        rows = self.extremes()
        if not rows:
            return ""
        pictures = "" if shown.picture is None else self._pictures(rows, shown.picture)
        return self._rows_of("extremes", rows, "verdict", shown.command, pictures)

    def _pictures(
        self, rows: Sequence[tuple[str, Row]], picture: Callable[[int], bytes | None]
    ) -> str:
        """Return a picture of each of these runs, up to a number of them."""
        words: dict[int, list[str]] = {}
        for word, row in rows:
            words.setdefault(int(row["run"] or 0), []).append(word)
        figures = []
        for number in itertools.islice(words, MAX_DRAWN_RUNS):
            data = picture(number)
            if data is None:
                return f"<p>{self._text('no_pictures')}</p>"
            caption = f"{self._text('run')} {number}: {', '.join(words[number])}"
            source = f"data:image/png;base64,{base64.b64encode(data).decode()}"
            image = f'<img alt="{escape(caption)}" src="{source}">'
            figures.append(_figure(image, caption))
        return f'<div class="charts">{"".join(figures)}</div>'

    def _table(self, command: Callable[[int], str] | None) -> str:
        """Return the table of the runs that did not hold."""
        if not self._broken:
            return ""
        left = self._count - self._held - len(self._broken)
        rest = f"<p>{self._text('more', left)}</p>" if left else ""
        return self._rows_of("table", [("", row) for row in self._broken], "broken", command, rest)

    def _rows_of(
        self,
        heading: str,
        rows: Sequence[tuple[str, Row]],
        last: str,
        command: Callable[[int], str] | None,
        rest: str,
    ) -> str:
        """Return a table of runs; ``last``: its last column, each row with a word before it."""
        names = [*(one.name for one in self._plan.dimensions), *self._names]
        has_words = any(word for word, _ in rows)
        heads = [self._text("which")] if has_words else []
        heads += [self._text("run"), *names]
        heads.append(self._text("reason" if last == "broken" else last))
        heads += [] if command is None else [self._text("command")]
        lines = []
        for word, row in rows:
            cells = [word] if has_words else []
            cells += [as_text(row.get(name)) for name in ("run", *names, last)]
            texts = [f"<td>{escape(cell)}</td>" for cell in cells]
            if command is not None:
                texts.append(f"<td><code>{escape(command(int(row['run'] or 0)))}</code></td>")
            lines.append(f"<tr>{''.join(texts)}</tr>")
        head = "".join(f"<th>{escape(name)}</th>" for name in heads)
        table = f"<table><tr>{head}</tr>{''.join(lines)}</table>"
        return f"<h2>{self._text(heading)}</h2>{table}{rest}"


def _note_extremes(extremes: dict[tuple[str, str], Row], names: Sequence[str], row: Row) -> None:
    """Note a row that has the least or the greatest value of a column so far."""
    for name in names:
        value = row.get(name)
        if not _is_number(value):
            continue
        for key, sign in (("least", -1.0), ("greatest", 1.0)):
            known = extremes.get((key, name))
            if known is None or sign * float(value or 0.0) > sign * float(known[name] or 0.0):
                extremes[key, name] = row


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and math.isfinite(value)


def _column(rows: Sequence[Row], name: str) -> list[float]:
    return [float(row[name] or 0.0) for row in rows]


def _held(rows: Sequence[Row]) -> list[bool]:
    return [row["verdict"] == PASSED for row in rows]


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
        return [abs(_rank_correlation(column, values)) for column in inputs], "rank correlation"
    problem: dict[str, Any] = {
        "num_vars": len(inputs),
        "names": [str(number) for number in range(len(inputs))],
        "bounds": [[min(column), max(column)] for column in inputs],
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
        equal = list(group)
        for _, index in equal:
            ranks[index] = sum(position for position, _ in equal) / len(equal)
    return ranks
