# SPDX-License-Identifier: MIT
"""``nctakt schedule compare``: two scheduling lists in comparison.

In: two lists, one load or one for each, options for the rules. Out: differences, improvements and
deteriorations (standard output), a picture of both, and the exit code as of a simulation.
"""

from __future__ import annotations

from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.cli.common.help import described, option
from nctakt.cli.schedules.schedule_options import (
    EXIT_CODES,
    LIST_OPTIONS,
    MODEL_OPTIONS,
    NOTE,
    guarded,
    make_model,
    publish,
    read_list,
    read_model_load,
    simulated_cycles,
    with_options,
)
from nctakt.messages import Collector

if TYPE_CHECKING:
    from nctakt.base.diagnostics import Diagnostic
    from nctakt.cli.schedules.schedule_options import ListRead
    from nctakt.files.access import FileAccess
    from nctakt.files.output import OutputFile
    from nctakt.schedule.analysis.compare import Side
    from nctakt.schedule.model import Model


@described(
    "compare",
    summary=Text(
        "Compare two lists with the same load.", "Zwei Listen mit derselben Last vergleichen."
    ),
    text=Text(
        "Compare two lists: responses, overflows and Windows' time, with the same load.",
        "Zwei Listen vergleichen: Antwortzeiten, Überläufe und die Zeit von Windows, mit "
        "derselben Last.",
    ),
    codes=EXIT_CODES,
    notes=NOTE,
    examples=("nctakt schedule compare rtconf.lis other.lis --load load.toml",),
)
@click.argument("file", metavar="A.LIS")
@click.argument("second", metavar="B.LIS")
@with_options(*LIST_OPTIONS[1:], *MODEL_OPTIONS)
@option(
    "--load-b",
    metavar="FILE.toml",
    text=Text("The load for B [default: that of A].", "Die Last für B [Vorgabe: die von A]."),
)
@option(
    "--plot",
    metavar="FILE",
    text=Text(
        "Draw both schedules: .html, .svg or .png.",
        "Beide Ablaufpläne zeichnen: .html, .svg, .png.",
    ),
    group="files",
)
@option(
    "--drawn",
    type=click.IntRange(min=1, max=100_000),
    metavar="N",
    text=Text("NC cycles in pictures.", "NC-Takte in Bildern."),
    group="files",
)
def compare(**words: Any) -> int:
    """Compare two lists with the same load."""
    return guarded(_compare, words)


@dataclass(frozen=True, slots=True)
class _Input:
    """A list with its model; ``diagnostics``: those after the reading of the list."""

    words: dict[str, Any]
    read: ListRead
    model: Model
    diagnostics: list[Diagnostic]


def _compare(words: dict[str, Any]) -> int:
    from nctakt.cli.common.file_options import file_access  # noqa: PLC0415 - not for the help
    from nctakt.schedule.analysis.compare import compare as compare_sides  # noqa: PLC0415
    from nctakt.schedule.reports.compare_report import (  # noqa: PLC0415
        comparison_document,
        comparison_report,
    )

    access = file_access(words["confined"])
    others = words | {"file": words["second"], "load": words["load_b"] or words["load"]}
    inputs = [_read(item, access) for item in (words, others)]
    with ExitStack() as stack:
        picture = _open_picture(words["plot"], access)
        if picture is not None:
            stack.enter_context(picture)
        first, second = (_side(item) for item in inputs)
        comparison = compare_sides(first, second)
        text = comparison_report(comparison, first, second, words["language"])
        document = comparison_document(comparison, first, second)
        listed = [item for side_input in inputs for item in side_input.read.diagnostics]
        findings = [item for side_input in inputs for item in side_input.diagnostics]
        code = publish(words, listed, findings, text, document)
        if picture is not None:
            _draw(picture, inputs, (first, second), text)
    return code


def _read(words: dict[str, Any], access: FileAccess) -> _Input:
    """Read a list and its load."""
    read = read_list(words, access)
    collector = Collector()
    load = read_model_load(read, words, collector)
    model = make_model(read, load, words, collector)
    return _Input(words, read, model, collector.diagnostics)


def _side(side_input: _Input) -> Side:
    """Analyse and simulate one list; with ``--drawn`` at least this many NC cycles."""
    from nctakt.schedule.analysis.analyse import analyse  # noqa: PLC0415
    from nctakt.schedule.analysis.compare import Side  # noqa: PLC0415
    from nctakt.schedule.analysis.self_check import check_bounds  # noqa: PLC0415
    from nctakt.schedule.simulation.simulate import simulate  # noqa: PLC0415

    words = side_input.words
    cycles = max(simulated_cycles(side_input.model, words), words["drawn"] or 0)
    run = simulate(side_input.model, cycles, record=0)
    analysis = analyse(side_input.model)
    check_bounds(analysis, run)
    return Side(Path(words["file"]).name, side_input.read.configuration, analysis, run)


def _open_picture(path: str | None, access: FileAccess) -> OutputFile | None:
    """Open the file of the picture, ``None`` without the option; raises ``Failure``."""
    from nctakt.files.output import OutputFile  # noqa: PLC0415
    from nctakt.schedule.pictures.draw import check_picture  # noqa: PLC0415

    if path is None:
        return None
    check_picture(path)
    return OutputFile(path, "--plot", access)


def _draw(picture: OutputFile, inputs: list[_Input], sides: tuple[Side, Side], report: str) -> None:
    """Draw both schedules below each other, the same NC cycles of both."""
    from nctakt.schedule.pictures.draw import write_picture  # noqa: PLC0415
    from nctakt.schedule.pictures.drawn_cycles import record_again, shown_together  # noqa: PLC0415
    from nctakt.schedule.pictures.gantt import below_each_other, gantt, picture_title  # noqa: PLC0415

    words = inputs[0].words
    drawn = words["drawn"]
    shown = range(drawn) if drawn else shown_together([side.run for side in sides])
    language = words["language"]
    figure = below_each_other(
        [
            gantt(
                record_again(side.run, shown),
                picture_title(side_input.words["file"], side_input.words["load"]),
                language,
            )
            for side, side_input in zip(sides, inputs, strict=True)
        ]
    )
    picture.fill(lambda path: write_picture(figure, path, language, report))
