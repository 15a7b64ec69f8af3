# SPDX-License-Identifier: MIT
"""The options of commands: those of the table of run options, and further ones of several commands.

In: the table (``run/options.py``) and the name of a command. Out: decorators that add its options,
the words of a run among the words of a command.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import fields
from typing import Any, TypeVar

import click

from nctakt.base.diagnostics import Text
from nctakt.cli.common.help import locale_language, option
from nctakt.project.trust import trusting
from nctakt.run.option_kinds import (
    Assignments,
    ChannelPrograms,
    Flag,
    Folders,
    Instances,
    Kind,
    Moment,
    Programs,
    SkipLevels,
    Stimuli,
    Whole,
    Words,
)
from nctakt.run.options import BY_NAME, READ_NAMES, RunOption, accepted_by

_Command = TypeVar("_Command", bound=Callable[..., Any])
_Record = TypeVar("_Record")

#: The options whose words become options of ``Controller.run``; ``signals`` need a file.
READ_OPTIONS = tuple(BY_NAME[name] for name in (*READ_NAMES, "blocks", "stays"))


def take_words(words: dict[str, Any], record: type[_Record]) -> _Record:
    """Take those words of a command that are fields of a dataclass; return them as one."""
    names = [field.name for field in fields(record) if field.name in words]  # type: ignore[arg-type]
    return record(**{name: words.pop(name) for name in names})


def _attributes(kind: Kind) -> dict[str, Any]:
    """Return how click reads the words of a kind."""
    match kind:
        case Whole():
            return {"type": click.IntRange(min=kind.minimum)}
        case Flag():
            return {"is_flag": True}
        case Words() if kind.choices:
            return {"type": click.Choice(kind.choices)}
        case Folders():
            return {"multiple": True, "type": click.Path(exists=True, file_okay=False)}
        case Assignments() | Instances():
            return {"multiple": True}
        case ChannelPrograms() | Stimuli():
            return {"multiple": True, "nargs": 2}
        case Moment() if not kind.is_optional:
            return {"default": "0"}
        case SkipLevels():
            return {"default": ""}
    return {}


def table_option(row: RunOption) -> Callable[[_Command], _Command]:
    """Return the decorator of an option of the table."""
    if isinstance(row.kind, Programs):
        return click.argument(row.word, metavar=f"{row.kind.metavar}...", nargs=-1)
    attributes = _attributes(row.kind)
    if "is_flag" not in attributes and not getattr(row.kind, "choices", ()):
        attributes["metavar"] = row.metavar or row.kind.metavar
    return option(row.option, row.word, text=row.help, group=row.group, **attributes)


def table_options(command: str) -> Callable[[_Command], _Command]:
    """Return a decorator with all options of the table that a command accepts."""

    def decorate(function: _Command) -> _Command:
        for row in reversed(accepted_by(command)):
            function = table_option(row)(function)
        return function

    return decorate


def language_option() -> Callable[[_Command], _Command]:
    """Return ``--lang`` for a command that no project concerns."""
    text = Text(
        "Language of texts and messages [default: the locale's, de or en].",
        "Sprache der Texte und Meldungen [Vorgabe: die der Umgebung, de oder en].",
    )
    return option(
        "--lang",
        "language",
        text=text,
        group="general",
        type=click.Choice(["en", "de"]),
        default=locale_language,
    )


def split_words(words: Mapping[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return the words of ``READ_OPTIONS`` by the options' names, and the other words.

    An option that the command does not have has its default.
    """
    others = dict(words)
    read = {row.name: others.pop(row.word, row.kind.to_words(row.default)) for row in READ_OPTIONS}
    return read, others


def _trust(context: click.Context, _parameter: click.Parameter, is_given: bool) -> None:
    """Trust all projects until the command has ended."""
    if is_given:
        context.with_resource(trusting())


TRUST_OPTION = option(
    "--trust",
    is_flag=True,
    expose_value=False,
    callback=_trust,
    group="machine",
    text=Text(
        "Run the code of the project, no matter who can write it.",
        "Code des Projekts ausführen, wer immer ihn schreiben darf.",
    ),
)
ISOLATE_OPTION = option(
    "--isolate",
    "isolates",
    is_flag=True,
    group="machine",
    text=Text(
        "Run the FMU in a process of its own: one that crashes or hangs ends the run only.",
        "Die FMU in einem eigenen Prozess ausführen: stürzt oder hängt sie, endet nur der Lauf.",
    ),
)
RETAIN_OPTION = option(
    "--retain",
    metavar="FILE",
    group="machine",
    text=Text(
        "Keep RETAIN and PERSISTENT variables of the PLC from run to run.",
        "RETAIN- und PERSISTENT-Variablen der SPS von Lauf zu Lauf behalten.",
    ),
)
WATCH_OPTION = option(
    "--watch",
    is_flag=True,
    group="general",
    text=Text(
        "Do it again whenever a file changes; Ctrl-C ends it.",
        "Bei jeder Änderung einer Datei wiederholen; Strg-C beendet es.",
    ),
)
MODE_OPTION = option(
    "--compiled/--plain",
    default=None,
    group="general",
    text=Text(
        "Run the realtime part compiled or as plain Python [default: compiled if it is built].",
        "Den Echtzeit-Teil übersetzt oder als reines Python ausführen [Vorgabe: übersetzt, "
        "falls vorhanden].",
    ),
)
FORMAT_OPTION = option(
    "--format",
    "form",
    type=click.Choice(["text", "json"]),
    default="text",
    group="files",
    text=Text(
        "Text, or all results as one JSON object [default: text].",
        "Text, oder alle Ergebnisse als ein JSON-Objekt [Vorgabe: text].",
    ),
)
IGNORE_OPTION = option(
    "--ignore",
    metavar="ID,...",
    multiple=True,
    text=Text("Do not report these messages.", "Diese Meldungen nicht ausgeben."),
)
STRICT_OPTION = option(
    "--strict",
    is_flag=True,
    text=Text("Exit code 1 for warnings, too.", "Rückgabewert 1 auch bei Warnungen."),
)
PACE_OPTION = option(
    "--pace",
    type=click.Choice(["slice", "tick"]),
    default="slice",
    text=Text(
        "On the wall clock: 10 ms of ticks together, or each at its own time [default: slice].",
        "Auf der Uhr: die Takte von 10 ms zusammen, oder jeder zu seiner Zeit [Vorgabe: slice].",
    ),
)

_FILE_OPTIONS = (
    option(
        "--trace",
        metavar="FILE",
        group="files",
        text=Text(
            "Record each tick: .csv, .jsonl, .parquet or .mf4.",
            "Jeden Takt aufzeichnen: .csv, .jsonl, .parquet oder .mf4.",
        ),
    ),
    option(
        "--plot",
        metavar="FILE",
        group="files",
        text=Text(
            "Draw the run: .html (interactive), .svg or .png.",
            "Den Lauf zeichnen: .html (interaktiv), .svg oder .png.",
        ),
    ),
    option(
        "--vcd",
        metavar="FILE",
        group="files",
        text=Text(
            "Write signals and cycles for GTKWave (.vcd).",
            "Signale und Zyklen für GTKWave schreiben (.vcd).",
        ),
    ),
    option(
        "--fst",
        metavar="FILE",
        group="files",
        text=Text(
            "Write the same, compressed, for GTKWave and Surfer (.fst).",
            "Dasselbe komprimiert für GTKWave und Surfer schreiben (.fst).",
        ),
    ),
    option(
        "--perfetto",
        metavar="FILE",
        group="files",
        text=Text(
            "Write the same for Perfetto (.json).", "Dasselbe für Perfetto schreiben (.json)."
        ),
    ),
    option(
        "--diagnosis",
        metavar="FILE",
        group="files",
        text=Text(
            "Write the realtime cycles' diagnosis data.",
            "Die Diagnosedaten der Echtzeit-Zyklen schreiben.",
        ),
    ),
    option(
        "--messages",
        metavar="FILE",
        group="files",
        text=Text(
            "Write the programs' messages to a file as well.",
            "Die Meldungen der Programme auch in eine Datei schreiben.",
        ),
    ),
    option(
        "--error-log",
        metavar="FILE",
        group="files",
        text=Text(
            "Write the user errors (#ERROR) to a file.",
            "Die Anwenderfehler (#ERROR) in eine Datei schreiben.",
        ),
    ),
)


def with_file_options(command: _Command) -> _Command:
    """Add the options of the files that a run and a replay write."""
    for one in reversed(_FILE_OPTIONS):
        command = one(command)
    return command
