# SPDX-License-Identifier: MIT
"""Parts of a comparison that can be sent to others: deviations of log and run, nothing private.

In: a comparison that keeps its overlaid samples, the programs of its run, the words of its options.
Out: files by name: the samples of the log, the programs and lists without names and texts, and a
summary. The run is repeated from these files alone, to find out whether they suffice. Of the lists
only entries with an effect stay, under neutral names; axes, spindles and functions keep theirs,
since programs are written with them.
"""

from __future__ import annotations

import json
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Language, Text
from nctakt.base.failure import Failure
from nctakt.base.text import decode_text, split_lines
from nctakt.base.version import __version__
from nctakt.comparison.columns import Column, stretches
from nctakt.comparison.comparison import Comparison
from nctakt.comparison.deviations import Overlaid
from nctakt.comparison.recorded import RecordedColumns
from nctakt.comparison.report import comparison_document
from nctakt.comparison.sharing.neutral_names import NeutralNames
from nctakt.files.access import FileAccess
from nctakt.lists.all_parameters import SCHEMA_BY_KIND
from nctakt.lists.declared.variables import SCALARS
from nctakt.lists.format.parameter import Effect, ValueType
from nctakt.lists.machine.files import ListSearch
from nctakt.lists.machine.machine import Machine
from nctakt.lists.writing.list_items import Comment, Item, read_items
from nctakt.lists.writing.list_writer import ascii_text
from nctakt.messages import diagnostic
from nctakt.messages.commands.comparison import (
    LOG_TOO_LONG_TO_SHARE,
    SHARE_DIFFERS,
    SHARE_DOES_NOT_RUN,
)
from nctakt.run.access.stimuli import Stimulus, read_stimulus
from nctakt.run.controller import Controller, NcText
from nctakt.run.options import BY_NAME

if TYPE_CHECKING:
    from nctakt.run.options import RunKeywords

#: The files of a folder.
LOG, FACTS, MACHINE = "log.csv", "facts.json", "machine"
#: Most samples of all signals together.
_MAX_SAMPLES = 1_000_000
#: Values that differ by less are equal: the neutral run never adds in another order.
_EQUAL = 1e-9
#: Options whose words hold names of variables.
_ASSIGNMENTS = ("set", "at")

_TITLE = Text("What {folder} holds:", "Was {folder} enthält:")
_CONTENTS: Mapping[str, Text] = {
    LOG: Text("{count} samples of the log", "{count} Werte des Logs"),
    FACTS: Text("deviations, delays and options", "Abweichungen, Verzögerungen und Optionen"),
    ".nc": Text(
        "a program: motions and commands, no comments, no texts",
        "ein Programm: Bewegungen und Befehle, keine Kommentare, keine Texte",
    ),
    ".lis": Text(
        "a list: entries that have an effect, no comments",
        "eine Liste: Einträge mit Wirkung, keine Kommentare",
    ),
}
_NAMES = Text(
    "{count} names are replaced by NAME1 …; positions and numbers of the program stay",
    "{count} Namen sind durch NAME1 … ersetzt; Positionen und Zahlen des Programms bleiben",
)
_ALIKE = Text(
    "these files run like the program: every value is the same in each tick",
    "diese Dateien laufen wie das Programm: Jeder Wert ist in jedem Takt derselbe",
)


@dataclass(frozen=True, slots=True)
class Share:
    """Files by name; numbers of samples and replaced names; parts of the run not reproduced."""

    files: Mapping[str, str]
    samples: int
    names: int
    findings: Sequence[Diagnostic]


@dataclass(frozen=True, slots=True)
class SharedRun:
    """The inputs of the run: programs by channel, its options, and these as words."""

    machine: Machine
    channels: Mapping[int, Sequence[Path | NcText]]
    options: RunKeywords
    words: Mapping[str, Any]


def share_of(comparison: Comparison, ran: SharedRun, access: FileAccess) -> Share:
    """Return what can be sent; raises ``Failure`` for files and a log that is too long (902742)."""
    samples = sum(one.samples for one in comparison.deviations)
    if samples > _MAX_SAMPLES:
        raise Failure(diagnostic(LOG_TOO_LONG_TO_SHARE, count=samples, limit=_MAX_SAMPLES))
    texts = _programs(comparison, ran, access)
    given = {name: f"part{number}.nc" for number, name in enumerate(texts, start=1)}
    names = NeutralNames(given, _kept(ran.machine))
    lists = neutral_lists(ran.machine, names, access)
    files = {f"{MACHINE}/{name}": text for name, text in lists.items()}
    for name, lines in texts.items():
        files[given[name]] = "".join(f"{line}\n" for line in names.lines(lines))
    files[LOG] = _log_text(comparison, names)
    channels = {
        number: [given[_name(one)] for one in programs] for number, programs in ran.channels.items()
    }
    findings = _difference(comparison, ran, files, channels, names)
    facts = {
        "nctakt": __version__,
        "channels": channels,
        "words": list(_words(ran.words, names)),
        "runs_alike": not findings,
        "comparison": _facts(comparison_document(comparison), given, names),
    }
    files[FACTS] = json.dumps(facts, indent=1, ensure_ascii=False) + "\n"
    return Share(dict(sorted(files.items())), samples, names.count, findings)


def _kept(machine: Machine) -> Iterator[str]:
    for channel in machine.channels:
        parameters = channel.parameters
        yield from (axis.name for axis in parameters.axes)
        yield from (spindle.name for spindle in parameters.spindles)


def _name(program: Path | NcText) -> str:
    return program.name if isinstance(program, NcText) else str(program)


def _programs(
    comparison: Comparison, ran: SharedRun, access: FileAccess
) -> dict[str, Sequence[str]]:
    """Return the lines of the programs that ran, by their files, those of the request first."""
    requested = [one for programs in ran.channels.values() for one in programs]
    found: dict[str, Sequence[str]] = {}
    for one in requested:
        if isinstance(one, NcText):
            found[one.name] = split_lines(one.text)
        else:
            found[str(one)] = split_lines(decode_text(access.read_bytes(one)).text)
    for event in comparison.blocks:
        if event.span is not None and event.span.file not in found:
            data = access.read_bytes(Path(event.span.file))
            found[event.span.file] = split_lines(decode_text(data).text)
    return found


def _log_text(comparison: Comparison, names: NeutralNames) -> str:
    """Return the log at the run's times; a signal without a sample at a time has an empty cell."""
    heads = ["time_us"]
    columns: list[Overlaid] = []
    for one in comparison.deviations:
        assert one.overlaid is not None
        unit = f" [{one.pair.signal.unit}]" if one.pair.signal.unit else ""
        heads.append(f"{names.text(one.pair.signal.name)}{unit}")
        columns.append(one.overlaid)
    times = numpy.unique(numpy.concatenate([one.times for one in columns]))
    rows = [[repr(time)] for time in times.tolist()]
    for column in columns:
        cells = [""] * len(rows)
        numbers = numpy.searchsorted(times, column.times)
        for number, value in zip(numbers.tolist(), column.values.tolist(), strict=True):
            cells[number] = repr(value)
        for row, cell in zip(rows, cells, strict=True):
            row.append(cell)
    return "".join(";".join(row) + "\n" for row in (heads, *rows))


def _facts(
    document: dict[str, Any], given: Mapping[str, str], names: NeutralNames
) -> dict[str, Any]:
    """Return the document of a comparison without private parts."""
    signals = []
    for one in document["signals"]:
        name = names.text(one["signal"])
        signals.append(
            {
                **one,
                "signal": name,
                "column": name,
                "block": _neutral_block(one["block"], given),
                "reaction": one["reaction"] is not None,
            }
        )
    delays = [{**one, "block": _neutral_block(one["block"], given)} for one in document["delays"]]
    return {**document, "log": LOG, "signals": signals, "delays": delays}


def _neutral_block(block: dict[str, Any] | None, given: Mapping[str, str]) -> dict[str, Any] | None:
    return None if block is None else {**block, "file": given.get(block["file"], "")}


def _words(words: Mapping[str, Any], names: NeutralNames) -> Iterator[str]:
    """Yield the options that differ from their defaults as words of the command."""
    for name, word in words.items():
        row = BY_NAME[name]
        if not word or word == row.default or str(word) == "0":
            continue
        for one in word if name in _ASSIGNMENTS else (word,):
            yield row.option
            if isinstance(one, tuple):
                yield from (one[0], names.text(one[1]))
            elif name in _ASSIGNMENTS:
                yield names.text(one)
            elif one is not True:
                yield str(one)


def _neutral_stimulus(given: Stimulus | tuple[Any, ...], names: NeutralNames) -> Stimulus:
    one = read_stimulus(given)
    return Stimulus(one.time, names.text(one.name), one.value)


def _difference(
    comparison: Comparison,
    ran: SharedRun,
    files: Mapping[str, str],
    channels: Mapping[int, Sequence[str]],
    names: NeutralNames,
) -> list[Diagnostic]:
    """Run the files alone; return the differences from the run of the user."""
    signals = {
        one.pair.signal.name: names.text(one.pair.signal.name) for one in comparison.deviations
    }
    given = {name: list(channels[name]) for name in channels}
    with tempfile.TemporaryDirectory() as name_of_folder:
        folder = Path(name_of_folder)
        for name, text in files.items():
            path = folder / name
            path.parent.mkdir(exist_ok=True)
            path.write_text(text, "utf-8")
        programs = {number: [folder / name for name in own] for number, own in given.items()}
        options: RunKeywords = {
            **ran.options,
            "set": {names.text(name): one for name, one in (ran.options["set"] or {}).items()},
            "at": [_neutral_stimulus(one, names) for one in ran.options["at"]],
            "signals": tuple(signals.values()),
            "sinks": [recorded := RecordedColumns()],
            "memory_trace": False,
        }
        try:
            controller = Controller(folder / MACHINE)
            run = controller.run(*programs.pop(1, ()), channels=programs, **options)
        except Failure as failure:
            return [diagnostic(SHARE_DOES_NOT_RUN, number=failure.diagnostics[0].number)]
    if run.errors and not comparison.run.errors:
        return [diagnostic(SHARE_DOES_NOT_RUN, number=run.errors[0].number)]
    for name, neutral in signals.items():
        tick = _first_difference(comparison.recorded[name], recorded[neutral])
        if tick is not None:
            time = tick * comparison.recorded.cycle_time_us / 1e6
            return [diagnostic(SHARE_DIFFERS, signal=name, time=f"{time:.6f}")]
    return []


def _first_difference(ours: Column, theirs: Column) -> int | None:
    """Return the first tick in which two columns differ, ``None`` for none."""
    size = min(len(ours), len(theirs))
    for part in stretches(size):
        differs = numpy.flatnonzero(~(numpy.abs(ours[part] - theirs[part]) <= _EQUAL))
        if len(differs):
            return int(part.start) + int(differs[0])
    return None if len(ours) == len(theirs) else size


def share_lines(share: Share, folder: str, language: Language) -> Iterator[str]:
    """Yield the content of the folder, file by file."""
    yield _TITLE.get(language).format(folder=folder)
    width = max(map(len, share.files))
    for name, text in share.files.items():
        content = _CONTENTS.get(name) or _CONTENTS[Path(name).suffix]
        size = len(text.encode())
        said = content.get(language).format(count=share.samples)
        yield f"  {name:{width}}  {size:>9,} bytes  {said}"
    yield _NAMES.get(language).format(count=share.names)
    if not share.findings:
        yield _ALIKE.get(language)


# --- the lists ------------------------------------------------------------------------------------


#: The name of the start-up list, by which a folder is a machine.
_STARTUP = "hochlauf.lis"
#: Texts that stay: names of axes, of spindles, of the controller's functions.
_KEPT = frozenset(
    (
        "kopf.log_achs_name",
        "gruppe[].achse[].bezeichnung",
        "spindel[].bezeichnung",
        "main_spindle_name",
        "default_ax_name_of_spindle",
        "m_default_outp_ax_name[]",
        "h_default_outp_ax_name[]",
        "thread[].function[].name",
    )
)
#: Prefixes of the patterns of the user's names and types.
_OWN = ("var[", "vch[", "struct[", "coordinate_system.", "thread[")
_PROGRAM = "_prog_file"


def neutral_lists(machine: Machine, names: NeutralNames, access: FileAccess) -> dict[str, str]:
    """Return the lists by their neutral names; raises ``Failure`` if one cannot be read."""
    startup = machine.lists[0][1]
    search = ListSearch(startup, access, startup.parent)
    files: dict[Path, str] = {}
    for kind, path in machine.lists:
        number = len(files) + 1
        files.setdefault(path.resolve(), f"{kind}{number}.lis" if files else _STARTUP)
    found: dict[str, str] = {}
    for kind, path in machine.lists:
        name = files[path.resolve()]
        if name not in found:
            items = read_items(access.read_bytes(path), SCHEMA_BY_KIND[kind])
            listed = files if kind == "startup" else {}
            kept = _neutral(items, listed, search, names)
            lines = ascii_text(kept, "en").splitlines()
            found[name] = "".join(f"{line.partition('(')[0].rstrip()}\n" for line in lines)
    return found


def _neutral(
    items: list[Comment | Item],
    files: Mapping[Path, str],
    search: ListSearch,
    names: NeutralNames,
) -> Iterator[Item]:
    for item in items:
        parameter = item.parameter if isinstance(item, Item) else None
        if parameter is None or parameter.effect is not Effect.USED:
            continue
        assert isinstance(item, Item)
        value: str | None = item.value
        if parameter.type is ValueType.STRING and item.value:
            file = search.find(item.value) if files else None
            value = None if file is None else files.get(file.resolve())
            if value is None:
                value = _text(parameter.pattern, item.value, names)
        if value is not None:
            yield replace(item, value=value, comment="")


def _text(pattern: str, value: str, names: NeutralNames) -> str | None:
    """Return the neutral text of a parameter; ``None`` if it is left out."""
    if pattern in _KEPT or value.upper() in SCALARS:
        return value
    if pattern.startswith(_OWN):
        return names.name(value)
    return names.file(value) if _PROGRAM in pattern else None
