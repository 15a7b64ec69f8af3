# SPDX-License-Identifier: MIT
"""What the subcommands of ``nctakt schedule`` share: options, reading list and load, files.

In: words of the command line. Out: the list, the model, how long, pictures and traces, exit code.
"""

from __future__ import annotations

import contextlib
import functools
import json
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

import click

from nctakt import __version__
from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Language, Severity
from nctakt.base.failure import Failure
from nctakt.cli import EXIT_NC_ERROR, EXIT_RAN, EXIT_USAGE
from nctakt.cli.file_options import CONFINE_OPTION, file_access
from nctakt.cli.formats import diagnostics_as_json
from nctakt.cli.language import language_option
from nctakt.cli.selection import read_selection
from nctakt.cli.terminal import print_diagnostics
from nctakt.files.access import FileAccess
from nctakt.files.output import OutputFile
from nctakt.messages import Collector, diagnostic
from nctakt.messages.inputs import INVALID_TIME

if TYPE_CHECKING:
    from nctakt.lists.declared.rtconf import RtconfConfiguration
    from nctakt.lists.format.values import Values
    from nctakt.lists.machine.scheduling_profile import RtconfOptions
    from nctakt.schedule.load import Load
    from nctakt.schedule.model import Model
    from nctakt.schedule.results import Simulation

_DEFAULT_DURATION = "1s"
#: The most NC cycles that pictures and traces show when nobody says how many.
_MOST_DRAWN = 60

#: How a scheduling list is read; ``nctakt check`` has them, too.
RTCONF_OPTIONS = (
    click.option(
        "--os",
        "system",
        type=click.Choice(["rtx", "vxworks", "intime", "linux"]),
        default="rtx",
        help="Operating system of rtconf.lis [default: rtx].",
    ),
    click.option(
        "--convention",
        type=click.Choice(["auto", "table", "field"]),
        default="auto",
        help="Meaning of interrupt_source 1 and 2: what the line's comment says, 1 hardware and "
        "2 timer, or 1 timer and 2 hardware.",
    ),
    click.option(
        "--function",
        "functions",
        metavar="NAME",
        multiple=True,
        help="A function of your own in rtconf.lis.",
    ),
)
#: The end of the help of each command.
EXIT_CODES = """\b
Times are numbers with us, ms, s, min, h or ticks ('300 ticks'); a number
alone means seconds.
Exit codes: 0 all well, 1 the schedule has errors (or warnings with --strict),
2 the list has errors, or something cannot be used, 3 an error of nctakt's own.
"""


LIST_OPTIONS = (
    click.argument("file", metavar="RTCONF.LIS"),
    *RTCONF_OPTIONS,
    click.option(
        "--hal-timer",
        metavar="TIME",
        help="The period that RTX is set to; a number alone means µs.",
    ),
    click.option(
        "--winsmall",
        type=click.Choice(["slice", "off"]),
        default="slice",
        help="A windows_time below time_slice becomes time_slice, or is off.",
    ),
    click.option("--ignore-windows", is_flag=True, help="Guarantee no time to Windows."),
    click.option("--lenient", is_flag=True, help="Missing values are warnings, not errors."),
    click.option("--ignore", metavar="ID,...", multiple=True, help="Not these messages."),
    click.option("--strict", is_flag=True, help="Exit code 1 for warnings."),
    click.option(
        "--format",
        type=click.Choice(["text", "json"]),
        default="text",
        help="Tables and findings as text, or one object with both.",
    ),
    language_option("Language."),
    click.option("--quiet", is_flag=True, help="No notes."),
    CONFINE_OPTION,
)
MODEL_OPTIONS = (
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
    click.option("--duration", metavar="TIME", help="So long [default: 1s]."),
    click.option("--cycles", type=click.IntRange(min=1), metavar="N", help="So many NC cycles."),
)
OUTPUT_OPTIONS = (
    click.option("--histogram", is_flag=True, help="Percentiles and histograms of responses."),
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


def with_options(*options: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """All options at once, in their order."""

    def add(function: Any) -> Any:
        return functools.reduce(
            lambda decorated, option: option(decorated), reversed(options), function
        )

    return add


@dataclass(frozen=True, slots=True)
class ListRead:
    """A list that was read, and what was found in it; ``access`` has read it."""

    access: FileAccess
    options: RtconfOptions
    values: Values
    configuration: RtconfConfiguration
    data: bytes
    found: list[Diagnostic]


def guarded(function: Callable[[dict[str, Any]], int], words: dict[str, Any]) -> int:
    """``function``, and what cannot be used as diagnostics with exit code 2."""
    try:
        return function(words)
    except Failure as failure:
        print_diagnostics(failure.diagnostics, words["language"])
        return EXIT_USAGE


def read_list(words: dict[str, Any], access: FileAccess | None = None) -> ListRead:
    """Return the list that the words name, and what was found in it; raises ``Failure``.

    ``access``: the files of the command, where it has more than one list.
    """
    from nctakt.lists.machine.scheduling_profile import PROFILES, RtconfOptions  # noqa: PLC0415

    read_selection((), words["ignore"])  # a word that fits no message is told before all else
    options = RtconfOptions(
        PROFILES[words["system"]],
        words["convention"],
        words["functions"],
        words["winsmall"] == "off",
        words["ignore_windows"],
        _microseconds(words["hal_timer"]),
        words["lenient"],
    )
    access = access or file_access(words["confined"])
    data = access.read_bytes(Path(words["file"]), is_replaced=bool(words.get("fix")))
    return read_list_text(words["file"], data, access, options)


def _microseconds(text: str | None) -> int | None:
    """Return a time in µs; a number alone means µs, as in a list. Raises ``Failure``."""
    from nctakt.lists.format.times import read_time  # noqa: PLC0415 - not for the help

    if text is None:
        return None
    time = read_time(f"{text.strip()}us" if text.strip().isdigit() else text)
    if time.is_in_ticks:  # whose length this very period decides
        raise Failure(diagnostic(INVALID_TIME, text=text))
    return time.us(1)


def read_list_text(file: str, data: bytes, access: FileAccess, options: RtconfOptions) -> ListRead:
    """Return the list that ``data`` is, and what was found in it."""
    from nctakt.lists.machine.scheduling import read_rtconf  # noqa: PLC0415 - not for the help

    collector = Collector()
    values, configuration = read_rtconf(file, data, collector, options)
    return ListRead(access, options, values, configuration, data, collector.diagnostics)


def publish(
    words: dict[str, Any],
    listed: Sequence[Diagnostic],
    found: Sequence[Diagnostic],
    text: str,
    document: dict[str, object],
) -> int:
    """Print results and diagnostics in the format of the words; return the exit code.

    ``listed``: what was found in the list, ``found``: what was found later. ``document``: the
    results as ``text`` has them, for other programs.
    """
    selection = read_selection((), words["ignore"])
    listed = [finding for finding in listed if selection.takes(finding.id)]
    found = [finding for finding in found if selection.takes(finding.id)]
    lowest = Severity.WARNING if words["quiet"] else Severity.NOTE
    shown = [finding for finding in (*listed, *found) if finding.severity >= lowest]
    if words["format"] == "json":
        diagnostics = diagnostics_as_json(shown, words["file"], words["language"])
        whole = {"nctakt": __version__, **document, "diagnostics": diagnostics}
        click.echo(json.dumps(whole, indent=2))
    else:
        print_diagnostics(shown, words["language"])
        click.echo(text, nl=False)
    return _exit_code(listed, found, strict=words["strict"])


def _exit_code(listed: Sequence[Diagnostic], found: Sequence[Diagnostic], *, strict: bool) -> int:
    if any(finding.severity is Severity.ERROR for finding in listed):
        return EXIT_USAGE
    worst = max((finding.severity for finding in (*listed, *found)), default=Severity.NOTE)
    fails = worst is Severity.ERROR or (strict and worst is Severity.WARNING)
    return EXIT_NC_ERROR if fails else EXIT_RAN


def read_model_load(read: ListRead, words: dict[str, Any], collector: Collector) -> Load:
    """The load that the words name, else the assumed one; raises ``Failure``."""
    from nctakt.base.text import decode_text  # noqa: PLC0415
    from nctakt.schedule.load import ASSUMED, read_load  # noqa: PLC0415

    if words["load"] is None:
        return ASSUMED
    text = decode_text(read.access.read_bytes(Path(words["load"]))).text
    load = read_load(words["load"], text, collector)
    if collector.has_errors:
        raise Failure(*read.found, *collector.diagnostics)
    return load


def make_model(
    read: ListRead,
    load: Load,
    words: dict[str, Any],
    collector: Collector,
    configuration: RtconfConfiguration | None = None,
) -> Model:
    """Return the model; raises ``Failure`` when list or load leave nothing to schedule.

    ``configuration``: another one than that of the list.
    """
    from nctakt.schedule.assemble import assemble  # noqa: PLC0415
    from nctakt.schedule.model import Rules  # noqa: PLC0415
    from nctakt.schedule.open_schedule import PLACED  # noqa: PLC0415

    rules = Rules(words["overflow"], words["calls"], words["suspension"])
    profile = read.options.profile
    model = assemble(
        configuration or read.configuration,
        load,
        profile,
        collector,
        rules=rules,
        cpu_base=words["cpu_base"],
    )
    errors = [finding for finding in collector.diagnostics if finding.severity is Severity.ERROR]
    if any(finding.message not in PLACED for finding in errors) or not read.configuration.threads:
        raise Failure(*read.found, *collector.diagnostics)
    return model


def simulated_cycles(model: Model, words: dict[str, Any]) -> int:
    """Return the number of NC cycles to simulate."""
    from nctakt.lists.format.times import read_time  # noqa: PLC0415
    from nctakt.schedule.open_schedule import cycles_within  # noqa: PLC0415

    if words["cycles"] is not None:
        return int(words["cycles"])
    return cycles_within(model, read_time(words["duration"] or _DEFAULT_DURATION))


def drawn_cycles(model: Model, words: dict[str, Any]) -> int:
    """Return the number of NC cycles in pictures and traces."""
    from nctakt.schedule.simulate import hyperperiod  # noqa: PLC0415

    return words["drawn"] or min(hyperperiod(model), _MOST_DRAWN)


class Outputs:
    """The pictures and traces that the words name; also a context manager."""

    def __init__(self, read: ListRead, words: dict[str, Any]) -> None:
        from nctakt.schedule.draw import check_picture  # noqa: PLC0415 - not for the help
        from nctakt.schedule.traces import check_vcd  # noqa: PLC0415

        self._language: Language = words["language"]
        self._names = (words["file"], words["load"])
        self._stack = contextlib.ExitStack()
        if words["plot"] is not None:
            check_picture(words["plot"])
        if words["vcd"] is not None:
            check_vcd()
        with self._stack:
            self._files = {
                key: self._stack.enter_context(OutputFile(words[key], f"--{key}", read.access))
                for key in ("plot", "vcd", "perfetto", "csv")
                if words[key] is not None
            }
            self._stack = self._stack.pop_all()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._stack.close()

    def write(self, run: Simulation, report: str) -> None:
        """Write and close them; ``report``: the text beside a picture of HTML.

        Raises ``Failure``.
        """
        from nctakt.schedule.draw import write_picture  # noqa: PLC0415
        from nctakt.schedule.gantt import gantt, picture_title  # noqa: PLC0415
        from nctakt.schedule.traces import write_csv, write_perfetto, write_vcd  # noqa: PLC0415

        writers: dict[str, Callable[[Path], None]] = {
            "plot": lambda path: write_picture(
                gantt(run, picture_title(*self._names), self._language),
                path,
                self._language,
                report,
            ),
            "vcd": partial(write_vcd, run),
            "perfetto": partial(write_perfetto, run),
            "csv": partial(write_csv, run),
        }
        for key, file in self._files.items():
            file.fill(writers[key])
        self._stack.close()


def open_outputs(read: ListRead, words: dict[str, Any]) -> Outputs:
    """Open what the words name; what is not written is gone when the command ends.

    Raises ``Failure`` where one of the files cannot be made, before anything is simulated.
    """
    return click.get_current_context().with_resource(Outputs(read, words))
