# SPDX-License-Identifier: MIT
"""``nctakt schedule``: show, simulate and analyse a scheduling list (rtconf.lis).

In: the list, maybe a load, choices of the rules. Out: tables (standard output), diagnostics
(standard error), pictures and traces (files), and the exit code: 0 all well, 1 the schedule has
errors (overflows that are to be reported, processors that do not exist) or, with ``--strict``,
there were warnings; 2 the list has errors, or input cannot be used.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nctakt.cli import EXIT_NC_ERROR, EXIT_RAN, EXIT_USAGE
from nctakt.cli.terminal import print_diagnostics
from nctakt.diagnostics import Diagnostic, Language, Severity
from nctakt.failure import Failure
from nctakt.messages import Collector, diagnostic

if TYPE_CHECKING:
    from nctakt.lists.rtconf import RtconfConfiguration
    from nctakt.lists.rtconf_profile import RtconfOptions
    from nctakt.schedule.model import Model
    from nctakt.schedule.results import Simulation

_EPILOG = """\b
Times are numbers with us, ms, s or min; a number alone means seconds.
Exit codes: 0 all well, 1 the schedule has errors (or warnings with --strict),
2 the list has errors, or something cannot be used.

\b
  nctakt schedule show rtconf.lis
  nctakt schedule simulate rtconf.lis --load load.toml --plot schedule.svg
  nctakt schedule analyse rtconf.lis --load load.toml
"""
#: The most NC cycles that pictures and traces show when nobody says how many.
_MOST_DRAWN = 60
_DEFAULT_DURATION = "1s"

_LIST_OPTIONS = (
    click.argument("file", metavar="RTCONF.LIS"),
    click.option(
        "--os",
        "system",
        type=click.Choice(["rtx", "vxworks", "intime", "linux"]),
        default="rtx",
        help="Whose priorities the list has [default: rtx].",
    ),
    click.option(
        "--convention",
        type=click.Choice(["auto", "table", "field"]),
        default="auto",
        help="Meaning of interrupt_source 1 and 2: what the line's comment says, 1 hardware and "
        "2 timer, or 1 timer and 2 hardware.",
    ),
    click.option("--hal-timer", type=int, metavar="US", help="The period that RTX is set to."),
    click.option("--function", "functions", multiple=True, help="A function of your own."),
    click.option(
        "--winsmall",
        type=click.Choice(["slice", "off"]),
        default="slice",
        help="A windows_time below time_slice becomes time_slice, or is off.",
    ),
    click.option("--ignore-windows", is_flag=True, help="Guarantee no time to Windows."),
    click.option("--lenient", is_flag=True, help="Missing values are warnings, not errors."),
    click.option("--strict", is_flag=True, help="Exit code 1 for warnings."),
    click.option(
        "--lang", "language", type=click.Choice(["en", "de"]), default="en", help="Language."
    ),
    click.option("--quiet", is_flag=True, help="No notes."),
)
_MODEL_OPTIONS = (
    click.option("--load", metavar="FILE.toml", help="Execution times and interrupts."),
    click.option(
        "--overflow",
        type=click.Choice(["skip", "pend", "queue"]),
        default="skip",
        help="Activations that find their thread busy: lost, one remembered, all remembered.",
    ),
    click.option(
        "--calls",
        type=click.Choice(["block", "interleave"]),
        default="block",
        help="Functions of a thread one after another, or in turn.",
    ),
    click.option(
        "--suspend",
        "suspension",
        type=click.Choice(["ticks", "elapsed"]),
        default="ticks",
        help="Suspend by counted timer interrupts, or by the time since the NC interrupt.",
    ),
    click.option(
        "--cpu-base", type=click.IntRange(0, 1), default=1, help="Number of the first CPU."
    ),
    click.option("--duration", metavar="TIME", help="Simulate so long [default: 1s]."),
    click.option("--cycles", type=click.IntRange(min=1), metavar="N", help="Simulate N cycles."),
)
_OUTPUT_OPTIONS = (
    click.option("--plot", metavar="FILE", help="Draw the schedule (.svg, .png, .html)."),
    click.option("--vcd", metavar="FILE", help="Write an oscilloscope trace for GTKWave."),
    click.option("--perfetto", metavar="FILE", help="Write a trace for ui.perfetto.dev (JSON)."),
    click.option("--csv", metavar="FILE", help="Write all events as a table."),
    click.option(
        "--drawn",
        type=click.IntRange(min=1, max=100_000),
        metavar="N",
        help="NC cycles in pictures and traces [default: one hyperperiod, at most 60].",
    ),
)


def _with(*options: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """All options at once, in their order."""

    def add(function: Any) -> Any:
        return functools.reduce(lambda found, option: option(found), reversed(options), function)

    return add


@dataclass(frozen=True, slots=True)
class _List:
    """A list that was read, and what was found in it."""

    options: RtconfOptions
    configuration: RtconfConfiguration
    data: bytes
    found: list[Diagnostic]


@click.group("schedule", epilog=_EPILOG, short_help="Show, simulate, analyse rtconf.lis.")
def command() -> None:
    """What a scheduling list (rtconf.lis) means, without a machine."""


@command.command("show", short_help="The list as it stands and as it counts.")
@_with(*_LIST_OPTIONS)
def show(**words: Any) -> int:
    """Check a list; show each parameter raw and effective, with the reason."""
    return _guarded(_show, words)


@command.command("simulate", short_help="The schedule in virtual time.")
@_with(*_LIST_OPTIONS, *_MODEL_OPTIONS, *_OUTPUT_OPTIONS)
def simulate(**words: Any) -> int:
    """Simulate the schedule; tables per thread and of Windows, pictures, traces."""
    return _guarded(_simulate, words)


@command.command("analyse", short_help="Response times in closed form, and limits.")
@_with(*_LIST_OPTIONS, *_MODEL_OPTIONS)
def analyse(**words: Any) -> int:
    """Response times without simulation, load against supply, and how much more would fit."""
    return _guarded(_analyse, words)


def _guarded(function: Callable[[dict[str, Any]], int], words: dict[str, Any]) -> int:
    """``function``, and what cannot be used as diagnostics with exit code 2."""
    try:
        return function(words)
    except Failure as failure:
        print_diagnostics(failure.diagnostics, words["language"])
        return EXIT_USAGE


def _read(path: str) -> bytes:
    if not Path(path).exists():
        raise Failure(diagnostic(900500, file=path))
    if Path(path).is_dir():
        raise Failure(diagnostic(900501, file=path))
    try:
        return Path(path).read_bytes()
    except OSError as error:
        reason = error.strerror or str(error)
        raise Failure(diagnostic(900503, file=path, reason=reason)) from error


def _read_list(words: dict[str, Any]) -> _List:
    from nctakt.lists.rtconf_effective import load_rtconf  # noqa: PLC0415 - not for the help
    from nctakt.lists.rtconf_profile import PROFILES, RtconfOptions  # noqa: PLC0415

    options = RtconfOptions(
        PROFILES[words["system"]],
        words["convention"],
        words["functions"],
        words["winsmall"] == "off",
        words["ignore_windows"],
        words["hal_timer"],
        words["lenient"],
    )
    data = _read(words["file"])
    collector = Collector()
    configuration = load_rtconf(words["file"], data, collector, options)
    return _List(options, configuration, data, collector.diagnostics)


def _tell(found: list[Diagnostic], words: dict[str, Any]) -> None:
    lowest = Severity.WARNING if words["quiet"] else Severity.NOTE
    print_diagnostics(found, words["language"], lowest)


def _code(listed: list[Diagnostic], found: list[Diagnostic], words: dict[str, Any]) -> int:
    """The exit code for what was found in the list, and for what was found later."""
    if any(one.severity is Severity.ERROR for one in listed):
        return EXIT_USAGE
    worst = max((one.severity for one in (*listed, *found)), default=Severity.NOTE)
    fails = worst is Severity.ERROR or (words["strict"] and worst is Severity.WARNING)
    return EXIT_NC_ERROR if fails else EXIT_RAN


def _show(words: dict[str, Any]) -> int:
    from nctakt.schedule.effective_table import effective_rows  # noqa: PLC0415
    from nctakt.schedule.report import effective_report  # noqa: PLC0415

    read = _read_list(words)
    _tell(read.found, words)
    language: Language = words["language"]
    rows = effective_rows(words["file"], read.data, read.configuration, read.found, language)
    click.echo(effective_report(rows, language))
    return _code(read.found, [], words)


def _make_model(read: _List, words: dict[str, Any], collector: Collector) -> Model:
    """The model; raises ``Failure`` when list or load leave nothing to schedule."""
    from nctakt.schedule.assemble import assemble  # noqa: PLC0415
    from nctakt.schedule.load import ASSUMED, read_load  # noqa: PLC0415
    from nctakt.schedule.model import Rules  # noqa: PLC0415
    from nctakt.text import decode_text  # noqa: PLC0415

    load = ASSUMED
    if words["load"] is not None:
        text = decode_text(_read(words["load"])).text
        load = read_load(words["load"], text, collector)
        if collector.has_errors:
            raise Failure(*read.found, *collector.diagnostics)
    rules = Rules(words["overflow"], words["calls"], words["suspension"])
    profile = read.options.profile
    model = assemble(
        read.configuration, load, profile, collector, rules=rules, cpu_base=words["cpu_base"]
    )
    placed = (1000180, 1000181)
    errors = [one for one in collector.diagnostics if one.severity is Severity.ERROR]
    if any(one.id not in placed for one in errors) or not read.configuration.threads:
        raise Failure(*read.found, *collector.diagnostics)
    return model


def _cycles(model: Model, words: dict[str, Any]) -> int:
    """How many NC cycles are simulated."""
    from nctakt.schedule.model import NS_PER_US  # noqa: PLC0415
    from nctakt.stimuli import parse_time  # noqa: PLC0415

    if words["cycles"] is not None:
        return int(words["cycles"])
    duration = parse_time(words["duration"] or _DEFAULT_DURATION)
    return max(1, duration * NS_PER_US // model.train.distance)


def _simulate(words: dict[str, Any]) -> int:
    from nctakt.schedule.findings import simulation_findings  # noqa: PLC0415
    from nctakt.schedule.report import simulation_report  # noqa: PLC0415
    from nctakt.schedule.simulate import hyperperiod  # noqa: PLC0415
    from nctakt.schedule.simulate import simulate as run_model  # noqa: PLC0415

    read = _read_list(words)
    collector = Collector()
    model = _make_model(read, words, collector)
    cycles = _cycles(model, words)
    drawn = words["drawn"] or min(hyperperiod(model), _MOST_DRAWN)
    _check_outputs(words)
    run = run_model(model, max(cycles, drawn) if words["drawn"] else cycles, record=drawn)
    found = [*collector.diagnostics, *simulation_findings(run)]
    _tell([*read.found, *found], words)
    click.echo(simulation_report(run, words["language"]), nl=False)
    _write_outputs(run, words)
    return _code(read.found, found, words)


def _analyse(words: dict[str, Any]) -> int:
    from nctakt.schedule.analyse import analyse as analyse_model  # noqa: PLC0415
    from nctakt.schedule.answers import find_answers  # noqa: PLC0415
    from nctakt.schedule.findings import analysis_findings  # noqa: PLC0415
    from nctakt.schedule.report import analysis_report  # noqa: PLC0415
    from nctakt.schedule.simulate import simulate as run_model  # noqa: PLC0415

    read = _read_list(words)
    collector = Collector()
    model = _make_model(read, words, collector)
    analysis = analyse_model(model)
    run = run_model(model, _cycles(model, words), record=0)
    found = [*collector.diagnostics, *analysis_findings(analysis)]
    _tell([*read.found, *found], words)
    text = analysis_report(analysis, find_answers(model), run, words["language"])
    click.echo(text, nl=False)
    return _code(read.found, found, words)


def _check_outputs(words: dict[str, Any]) -> None:
    """Whether all files can be made, before anything is simulated; raises ``Failure``."""
    from nctakt.schedule.draw import check_picture  # noqa: PLC0415
    from nctakt.schedule.traces import check_vcd  # noqa: PLC0415

    if words["plot"] is not None:
        check_picture(words["plot"])
    if words["vcd"] is not None:
        check_vcd()


def _write_outputs(run: Simulation, words: dict[str, Any]) -> None:
    from nctakt.schedule.draw import write_picture  # noqa: PLC0415
    from nctakt.schedule.traces import write_csv, write_perfetto, write_vcd  # noqa: PLC0415

    try:
        if words["plot"] is not None:
            write_picture(run, Path(words["plot"]), words["language"])
        for key, write in (("vcd", write_vcd), ("perfetto", write_perfetto), ("csv", write_csv)):
            if words[key] is not None:
                write(run, Path(words[key]))
    except OSError as error:
        name = str(error.filename or words["file"])
        reason = error.strerror or str(error)
        raise Failure(diagnostic(900507, file=name, reason=reason)) from error
