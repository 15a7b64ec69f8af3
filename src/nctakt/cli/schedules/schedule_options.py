# SPDX-License-Identifier: MIT
"""The common part of the subcommands of ``nctakt schedule``: options, list and load, files.

In: options of the command line. Out: the list, the model, the duration, pictures and traces, the
exit code.
"""

from __future__ import annotations

import contextlib
import functools
import json
from collections.abc import Callable, Iterable, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

import click

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Language, Severity, Text
from nctakt.base.failure import Failure
from nctakt.base.version import __version__
from nctakt.cli import EXIT_NC_ERROR, EXIT_RAN, EXIT_USAGE
from nctakt.cli.common.file_options import file_access
from nctakt.cli.common.help import option
from nctakt.cli.common.options import (
    FORMAT_OPTION,
    IGNORE_OPTION,
    STRICT_OPTION,
    language_option,
    table_option,
)
from nctakt.cli.common.terminal import print_diagnostics
from nctakt.cli.findings.formats import diagnostics_as_json
from nctakt.cli.findings.selection import read_selection
from nctakt.files.access import FileAccess
from nctakt.files.output import OutputFile
from nctakt.messages import Collector, diagnostic
from nctakt.messages.commands.inputs import INVALID_TIME
from nctakt.messages.scheduling.rtconf import PROGRAM_AS_SCHEDULING_LIST
from nctakt.run.options import BY_NAME

if TYPE_CHECKING:
    from nctakt.lists.declared.rtconf import RtconfConfiguration
    from nctakt.lists.format.values import Values
    from nctakt.lists.machine.schedules.scheduling_profile import RtconfOptions
    from nctakt.schedule.load import Load
    from nctakt.schedule.model import Model
    from nctakt.schedule.simulation.results import Simulation

_DEFAULT_DURATION = "1s"

#: Options for reading a scheduling list, also of ``nctakt check``.
RTCONF_OPTIONS = (
    option(
        "--os",
        "system",
        type=click.Choice(["rtx", "vxworks", "intime", "linux"]),
        default="rtx",
        text=Text(
            "Operating system of rtconf.lis [default: rtx].",
            "Betriebssystem von rtconf.lis [Vorgabe: rtx].",
        ),
    ),
    option(
        "--convention",
        type=click.Choice(["auto", "table", "field"]),
        default="auto",
        text=Text(
            "Meaning of interrupt_source 1 and 2: what the line's comment says, 1 hardware and "
            "2 timer, or 1 timer and 2 hardware.",
            "Bedeutung von interrupt_source 1 und 2: was der Kommentar der Zeile sagt, 1 "
            "Hardware und 2 Timer, oder 1 Timer und 2 Hardware.",
        ),
    ),
    option(
        "--function",
        "functions",
        metavar="NAME",
        multiple=True,
        text=Text("Your own function in rtconf.lis.", "Eine eigene Funktion in rtconf.lis."),
    ),
)
#: The exit codes of each command, and its note.
EXIT_CODES = (
    Text("no errors", "keine Fehler"),
    Text(
        "the schedule has errors (or warnings with --strict)",
        "der Ablaufplan hat Fehler (oder mit --strict Warnungen)",
    ),
)
NOTE = Text(
    "Times are numbers with us, ms, s, min, h or ticks ('300 ticks'); a plain number means "
    "seconds. A list with errors is unusable input.",
    "Zeiten sind Zahlen mit us, ms, s, min, h oder ticks ('300 ticks'); eine Zahl allein "
    "bedeutet Sekunden. Eine Liste mit Fehlern ist eine unbrauchbare Eingabe.",
)


LIST_OPTIONS = (
    click.argument("file", metavar="RTCONF.LIS"),
    *RTCONF_OPTIONS,
    option(
        "--hal-timer",
        metavar="TIME",
        text=Text(
            "The timer period of RTX; a plain number means µs.",
            "Die Timerperiode von RTX; eine Zahl allein bedeutet µs.",
        ),
    ),
    option(
        "--winsmall",
        type=click.Choice(["slice", "off"]),
        default="slice",
        text=Text(
            "A windows_time below time_slice becomes time_slice, or is off.",
            "Eine windows_time unter time_slice wird time_slice oder ist aus.",
        ),
    ),
    option(
        "--ignore-windows",
        is_flag=True,
        text=Text("Guarantee no time to Windows.", "Windows keine Zeit zusichern."),
    ),
    option(
        "--lenient",
        is_flag=True,
        text=Text(
            "Missing values are warnings, not errors.",
            "Fehlende Werte sind Warnungen, keine Fehler.",
        ),
    ),
    IGNORE_OPTION,
    STRICT_OPTION,
    FORMAT_OPTION,
    language_option(),
    table_option(BY_NAME["quiet"]),
    table_option(BY_NAME["confine"]),
)
MODEL_OPTIONS = (
    option(
        "--load",
        metavar="FILE.toml",
        text=Text("Execution times and interrupts.", "Ausführungszeiten und Interrupts."),
    ),
    option(
        "--overflow",
        type=click.Choice(["skip", "pend", "queue"]),
        default="skip",
        text=Text(
            "Activations of a busy thread: lost, one remembered, all remembered.",
            "Aktivierungen eines beschäftigten Threads: verloren, eine gemerkt, alle gemerkt.",
        ),
    ),
    option(
        "--calls",
        type=click.Choice(["block", "interleave"]),
        default="block",
        text=Text(
            "Functions of a thread one after another, or in turn.",
            "Funktionen eines Threads nacheinander oder abwechselnd.",
        ),
    ),
    option(
        "--suspend",
        "suspension",
        type=click.Choice(["ticks", "elapsed"]),
        default="ticks",
        text=Text(
            "Suspend by counted timer interrupts, or by the time since the NC interrupt.",
            "Suspendieren nach gezählten Timer-Interrupts oder nach der Zeit seit dem "
            "NC-Interrupt.",
        ),
    ),
    option(
        "--cpu-base",
        type=click.IntRange(0, 1),
        metavar="N",
        default=1,
        text=Text("Number of the first CPU.", "Nummer der ersten CPU."),
    ),
    option(
        "--duration", metavar="TIME", text=Text("Duration [default: 1s].", "Dauer [Vorgabe: 1s].")
    ),
    option(
        "--cycles",
        type=click.IntRange(min=1),
        metavar="N",
        text=Text("Number of NC cycles.", "Anzahl der NC-Takte."),
    ),
)
OUTPUT_OPTIONS = (
    option(
        "--histogram",
        is_flag=True,
        text=Text(
            "Percentiles and histograms of responses.",
            "Perzentile und Histogramme der Antwortzeiten.",
        ),
        group="files",
    ),
    option(
        "--plot",
        metavar="FILE",
        text=Text(
            "Draw the schedule: .html, .svg or .png.",
            "Den Ablaufplan zeichnen: .html, .svg oder .png.",
        ),
        group="files",
    ),
    option(
        "--vcd",
        metavar="FILE",
        text=Text(
            "Write the threads for GTKWave (.vcd).",
            "Die Threads für GTKWave schreiben (.vcd).",
        ),
        group="files",
    ),
    option(
        "--perfetto",
        metavar="FILE",
        text=Text(
            "Write the same for Perfetto (.json).",
            "Dasselbe für Perfetto schreiben (.json).",
        ),
        group="files",
    ),
    option(
        "--csv",
        metavar="FILE",
        text=Text("Write all events as a table.", "Alle Ereignisse als Tabelle schreiben."),
        group="files",
    ),
    option(
        "--drawn",
        type=click.IntRange(min=1, max=100_000),
        metavar="N",
        text=Text(
            "NC cycles in pictures and traces [default: up to the first repetition, or around "
            "the first overflow; at most 60].",
            "NC-Takte in Bildern und Aufzeichnungen [Vorgabe: bis zur ersten Wiederholung oder "
            "um den ersten Überlauf; höchstens 60].",
        ),
        group="files",
    ),
)


def with_options(*options: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """Return all options at once, in their order."""

    def add(function: Any) -> Any:
        return functools.reduce(
            lambda decorated, option: option(decorated), reversed(options), function
        )

    return add


@dataclass(frozen=True, slots=True)
class ListRead:
    """A list and its diagnostics; ``access`` has read it."""

    access: FileAccess
    options: RtconfOptions
    values: Values
    configuration: RtconfConfiguration
    data: bytes
    diagnostics: list[Diagnostic]


def guarded(function: Callable[[dict[str, Any]], int], words: dict[str, Any]) -> int:
    """Return the exit code of ``function``; a ``Failure`` is reported with exit code 2."""
    try:
        return function(words)
    except Failure as failure:
        print_diagnostics(_shown(failure.diagnostics, words), words["language"])
        return EXIT_USAGE


def _shown(findings: Iterable[Diagnostic], words: dict[str, Any]) -> list[Diagnostic]:
    """Return the findings without notes where ``--quiet`` is given."""
    lowest = Severity.WARNING if words["quiet"] else Severity.NOTE
    return [finding for finding in findings if finding.severity >= lowest]


def read_list(words: dict[str, Any], access: FileAccess | None = None) -> ListRead:
    """Return the list of the options with its diagnostics; raises ``Failure``.

    ``access``: the files of the command, if it has more than one list.
    """
    from nctakt.checking.inputs import PROGRAM_SUFFIXES  # noqa: PLC0415 - not for the help
    from nctakt.lists.machine.schedules.scheduling_profile import PROFILES, RtconfOptions  # noqa: PLC0415

    read_selection((), words["ignore"])  # a word without a message is reported first
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
    if Path(words["file"]).suffix.lower() in PROGRAM_SUFFIXES:
        raise Failure(diagnostic(PROGRAM_AS_SCHEDULING_LIST, file=words["file"]))
    return read_list_text(words["file"], data, access, options)


def _microseconds(text: str | None) -> int | None:
    """Return a time in µs; a plain number means µs, as in a list. Raises ``Failure``."""
    from nctakt.lists.format.times import read_time  # noqa: PLC0415 - not for the help

    if text is None:
        return None
    time = read_time(f"{text.strip()}us" if text.strip().isdigit() else text)
    if time.is_in_ticks:  # their length depends on this very period
        raise Failure(diagnostic(INVALID_TIME, text=text))
    return time.us(1)


def read_list_text(file: str, data: bytes, access: FileAccess, options: RtconfOptions) -> ListRead:
    """Return the list in ``data`` with its diagnostics."""
    from nctakt.lists.machine.schedules.scheduling import read_rtconf  # noqa: PLC0415 - not for the help

    collector = Collector()
    values, configuration = read_rtconf(file, data, collector, options)
    return ListRead(access, options, values, configuration, data, collector.diagnostics)


def publish(
    words: dict[str, Any],
    listed: Sequence[Diagnostic],
    further: Sequence[Diagnostic],
    text: str,
    document: dict[str, object],
) -> int:
    """Print results and diagnostics in the format of the options; return the exit code.

    ``listed``: the diagnostics of the list, ``further``: later ones. ``document``: the results in
    ``text`` for other programs.
    """
    selection = read_selection((), words["ignore"])
    listed = [finding for finding in listed if selection.includes(finding)]
    further = [finding for finding in further if selection.includes(finding)]
    shown = _shown((*listed, *further), words)
    if words["form"] == "json":
        diagnostics = diagnostics_as_json(shown, words["file"], words["language"])
        result = {"nctakt": __version__, **document, "diagnostics": diagnostics}
        click.echo(json.dumps(result, indent=2))
    else:
        print_diagnostics(shown, words["language"])
        click.echo(text, nl=False)
    return _exit_code(listed, further, strict=words["strict"])


def _exit_code(listed: Sequence[Diagnostic], further: Sequence[Diagnostic], *, strict: bool) -> int:
    if any(finding.severity is Severity.ERROR for finding in listed):
        return EXIT_USAGE
    worst = max((finding.severity for finding in (*listed, *further)), default=Severity.NOTE)
    fails = worst is Severity.ERROR or (strict and worst is Severity.WARNING)
    return EXIT_NC_ERROR if fails else EXIT_RAN


def read_model_load(read: ListRead, words: dict[str, Any], collector: Collector) -> Load:
    """Return the load of the options, else the assumed one; raises ``Failure``."""
    from nctakt.base.text import decode_text  # noqa: PLC0415
    from nctakt.schedule.load import ASSUMED, read_load  # noqa: PLC0415

    if words["load"] is None:
        return ASSUMED
    text = decode_text(read.access.read_bytes(Path(words["load"]))).text
    load = read_load(words["load"], text, collector)
    if collector.has_errors:
        raise Failure(*read.diagnostics, *collector.diagnostics)
    return load


def make_model(
    read: ListRead,
    load: Load,
    words: dict[str, Any],
    collector: Collector,
    configuration: RtconfConfiguration | None = None,
) -> Model:
    """Return the model; raises ``Failure`` if list or load leave nothing to schedule.

    ``configuration``: to use instead of that of the list.
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
        raise Failure(*read.diagnostics, *collector.diagnostics)
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
    from nctakt.schedule.pictures.drawn_cycles import MAX_DRAWN  # noqa: PLC0415
    from nctakt.schedule.simulation.simulate import hyperperiod  # noqa: PLC0415

    return words["drawn"] or min(hyperperiod(model), MAX_DRAWN)


class Outputs:
    """The pictures and traces of the options; also a context manager."""

    def __init__(self, read: ListRead, words: dict[str, Any]) -> None:
        from nctakt.files.vcd import check_vcd  # noqa: PLC0415
        from nctakt.schedule.pictures.draw import check_picture  # noqa: PLC0415 - not for the help

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
        """Write and close them; ``report``: the text next to a picture in HTML.

        Raises ``Failure``.
        """
        from nctakt.schedule.pictures.draw import write_picture  # noqa: PLC0415
        from nctakt.schedule.pictures.gantt import gantt, picture_title  # noqa: PLC0415
        from nctakt.schedule.pictures.traces import write_csv, write_perfetto, write_vcd  # noqa: PLC0415

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
    """Open the files of the options; unwritten ones are removed at the end of the command.

    Raises ``Failure`` if a file cannot be created, before the simulation begins.
    """
    return click.get_current_context().with_resource(Outputs(read, words))
